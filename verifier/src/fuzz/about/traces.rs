//! The rules of a trace, step by step and member by member.
//!
//! A rule is charged at the first place where an answer differs. So what holds a plant or latches a governor is the
//! rule of a mode, and what such a frame still says is that of its members.

use std::collections::{BTreeMap, HashMap, HashSet};

use ncp_spec::wire::{self, Kind};

use super::About;
use crate::fuzz::tree::{Tree, double, doubles, integer, items, members, string};
use crate::json::Json;

/// The members of a frame that a HOLD or an ESTOP takes over from the command.
const TAKEN_OVER: [&str; 4] = ["seq", "t", "frame_id", "ttl_ms"];
/// Commands after a latch from which on it is its age that counts.
const OLD: usize = 3;

impl About {
    /// The steps of a trace: that which most steps have is that of any. The rule of the last one.
    pub(super) fn trace(&mut self, steps: &[Option<&str>]) -> Option<String> {
        let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
        for rule in steps.iter().copied().flatten() {
            *counts.entry(rule).or_default() += 1;
        }
        let most = counts.iter().max_by_key(|(_, count)| **count).map(|(rule, _)| *rule)?;
        self.put("/steps/*", most);
        for (nth, rule) in steps.iter().enumerate().filter_map(|(nth, rule)| rule.map(|rule| (nth, rule))) {
            if rule != most {
                self.put(&format!("/steps/{nth}"), rule);
            }
        }
        steps.iter().rev().find_map(|rule| rule.map(str::to_owned))
    }

    /// The members of the frames of a governor: those of frames that move otherwise than those of frames that do not.
    pub(super) fn governor(&mut self, args: &Tree, expect: &Tree, steps: &[Option<&str>]) {
        let asked = items(args.get("steps"));
        let answers = items(expect.get("value").and_then(|value| value.get("steps")));
        let still = |answer: &Tree| match answer.get("frame").and_then(|frame| frame.get("mode")) {
            Some(Json::String(mode)) => Some(mode != "active"),
            _ => None,
        };
        for member in TAKEN_OVER {
            self.put(&format!("/steps/*/frame/{member}"), "NCP-SAFE-070");
        }
        self.put("/steps/*/frame/channels", "NCP-SAFE-071");
        self.put("/steps/*/frame/horizon", "NCP-SAFE-074");
        let is_limited = double(args.get("limits").and_then(|limits| limits.get("max_speed_mps"))) > Some(0.0);
        for (nth, answer) in answers.iter().enumerate().filter(|(_, answer)| still(answer) == Some(false)) {
            let rule = steps.get(nth).copied().flatten().unwrap_or("NCP-SAFE-021");
            self.put(&format!("/steps/{nth}/frame/channels"), rule);
            let given = asked
                .get(nth)
                .and_then(|step| step.get("command"))
                .map_or(0, |command| items(command.get("horizon")).len());
            let left = items(answer.get("frame").and_then(|frame| frame.get("horizon"))).len();
            let of_horizon = match (left < given, is_limited) {
                (true, _) => rule,
                (false, true) if given > 0 => "NCP-SAFE-066",
                _ => "NCP-SAFE-021",
            };
            self.put(&format!("/steps/{nth}/frame/horizon"), of_horizon);
        }
    }

    /// What a loop sends: why it holds.
    pub(super) fn control_loop(&mut self, args: &Tree, expect: &Tree) {
        let answers = items(expect.get("value").and_then(|value| value.get("steps")));
        let timeout_ms =
            double(args.get("limits").and_then(|limits| limits.get("command_timeout_ms"))).unwrap_or(500.0);
        let radius = double(args.get("limits").and_then(|limits| limits.get("geofence_radius_m"))).filter(|r| *r > 0.0);
        let (mut newest, mut told, mut stale): (Option<(i64, f64)>, Option<f64>, bool) = (None, None, false);
        let (mut position, mut gap, mut is_latched) = (0.0_f64, 0, false);
        for (nth, step) in items(args.get("steps")).iter().enumerate() {
            let now = double(step.get("now_s")).unwrap_or(f64::NAN);
            match string(step, "op") {
                Some("sensor") => {
                    let Some(sensor) = step.get("sensor") else { continue };
                    let seq = integer(sensor.get("seq")).unwrap_or(0);
                    let time = double(sensor.get("t")).unwrap_or(0.0);
                    stale =
                        newest.is_some_and(|(last, at)| if seq == 0 || last == 0 { time <= at } else { seq <= last });
                    if stale {
                        continue;
                    }
                    gap = gap.max(newest.map_or(0, |(last, _)| seq.saturating_sub(last)));
                    (newest, told) = (Some((seq, time)), Some(now));
                    let pose = sensor.get("channels").and_then(|channels| channels.get("pose_position"));
                    position = doubles(pose.and_then(|pose| pose.get("data"))).iter().fold(0.0, |sum, x| x.hypot(sum));
                }
                Some("reset") => (newest, told, stale, gap, is_latched) = (None, None, false, 0, false),
                Some("tick") => {
                    let mode = answers.get(nth).and_then(|answer| answer.get("command")?.get("mode")?.as_str());
                    let rule = match (mode, told) {
                        (Some("estop"), _) if is_latched => "NCP-SAFE-005",
                        (Some("estop"), _) => {
                            is_latched = true;
                            if radius.is_some_and(|radius| position > radius) { "NCP-SAFE-043" } else { "NCP-CTRL-016" }
                        }
                        (Some("hold"), None) => "NCP-SAFE-030",
                        (Some("hold"), Some(told)) if now < told => "NCP-SAFE-035",
                        (Some("hold"), Some(told)) if (now - told) * 1000.0 > timeout_ms => match stale {
                            true => "NCP-CTRL-012",
                            false => "NCP-SAFE-033",
                        },
                        (Some("active"), _) if gap > 1 => "NCP-CTRL-016",
                        _ => continue,
                    };
                    self.put(&format!("/steps/{nth}/command/mode"), rule);
                }
                _ => {}
            }
        }
    }

    /// The frames of a link that came before, which change nothing, and those that come late.
    pub(super) fn link(&mut self, args: &Tree) {
        let (mut seen, mut newest) = (HashSet::new(), i64::MIN);
        for (nth, step) in items(args.get("steps")).iter().enumerate() {
            let Some(seq) = integer(step.get("seq")) else { continue };
            let rule = match (seen.insert(seq), seq < newest) {
                (false, _) => "NCP-RES-042",
                (true, true) => "NCP-RES-041",
                _ => {
                    newest = newest.max(seq);
                    continue;
                }
            };
            for member in ["received", "lost"] {
                self.put(&format!("/steps/{nth}/{member}"), rule);
            }
        }
    }

    /// The replies of a server. The rule of the last one.
    pub(super) fn session(&mut self, args: &Tree) -> String {
        let mut open: HashMap<String, Session> = HashMap::new();
        let mut head = "NCP-SESS-020";
        let frames: Vec<Option<Json<'_>>> =
            items(args.get("requests")).iter().map(|request| Json::parse(request.as_str()?).ok()).collect();
        let twins = twins(&frames);
        let verbs = items(args.get("verbs"));
        let general = [
            ("sim_time_ms", "NCP-SESS-033"),
            ("records/*/unit", "NCP-SESS-056"),
            ("records/*/senders", "NCP-SESS-052"),
            ("records/*/times", "NCP-SESS-053"),
            ("session_id", "NCP-SESS-027"),
            ("seq", "NCP-SESS-034"),
        ];
        for (nth, (request, frame)) in items(args.get("requests")).iter().zip(&frames).enumerate() {
            let bytes = request.as_str().unwrap_or_default().as_bytes();
            let of = |name: &str| frame.as_ref().and_then(|frame| string(frame, name)).unwrap_or_default();
            let (kind, id) = (of("kind"), of("session_id"));
            let is_read = Kind::parse(kind).is_some_and(|kind| wire::decode(kind, bytes).is_ok());
            let is_asked_otherwise = verbs.get(nth).and_then(Json::as_str).is_some_and(|verb| verb != kind);
            let rule = match (kind, frame) {
                _ if !is_read => "NCP-SESS-021",
                _ if is_asked_otherwise => "NCP-STRICT-007",
                ("open_session", Some(frame)) => {
                    let session = Session::of(frame);
                    let rule = session.dynamics;
                    open.entry(id.to_owned()).or_insert(session);
                    rule
                }
                ("step_request" | "run_request", Some(frame)) => match open.get_mut(id) {
                    Some(session) => {
                        for (member, rule) in general {
                            self.put(&format!("/replies/*/{member}"), rule);
                        }
                        self.observation(nth, frame, session, twins.contains(id))
                    }
                    None if twins.contains(id) => "NCP-SESS-035",
                    None => "NCP-SESS-026",
                },
                ("close_session", _) => match open.remove(id) {
                    Some(_) => "NCP-SESS-028",
                    None => "NCP-SESS-029",
                },
                _ => "NCP-SESS-022",
            };
            self.put(&format!("/replies/{nth}"), rule);
            head = rule;
        }
        head.to_owned()
    }

    /// The members of the answer to a step or a run of an open session.
    fn observation(&mut self, nth: usize, frame: &Json<'_>, session: &mut Session, has_twin: bool) -> &'static str {
        let values = frame.get("stimulus").and_then(|stimulus| stimulus.get("values"));
        session.is_stimulated |= !members(values).is_empty();
        let rule = match session.is_stimulated {
            _ if has_twin => "NCP-SESS-035",
            true if session.is_selective => "NCP-SESS-055",
            true => "NCP-SESS-054",
            false => session.dynamics,
        };
        let time = ["advance_ms", "duration_ms"].iter().all(|name| !matches!(frame.get(name), Some(Json::Number(_))));
        let place = |member: &str| format!("/replies/{nth}/{member}");
        self.put(&place("sim_time_ms"), if time { "NCP-SESS-031" } else { "NCP-SESS-033" });
        self.put(&place("records/*"), "NCP-SESS-038");
        self.put(&place("records/*/values"), rule);
        for (member, of) in [("times", "NCP-SESS-053"), ("senders", "NCP-SESS-052"), ("unit", "NCP-SESS-056")] {
            self.put(&place(&format!("records/*/{member}")), of);
        }
        // When a neuron fires is what the network does, and not when it is sampled.
        for port in &session.spikes {
            self.put(&place(&format!("records/{port}/times")), rule);
            self.put(&place(&format!("records/{port}/senders")), rule);
        }
        if rule == session.dynamics { rule } else { "NCP-SESS-027" }
    }
}

/// What is known of an open session.
struct Session {
    /// The rule of its network.
    dynamics: &'static str,
    /// The ports that record spikes, of plain names.
    spikes: Vec<String>,
    /// Whether its stimuli name neurons, or there are several populations.
    is_selective: bool,
    /// Whether a value came for one of its stimuli.
    is_stimulated: bool,
}

impl Session {
    fn of(frame: &Json<'_>) -> Self {
        let network = frame.get("network");
        let is_rate = network.and_then(|network| string(network, "ref")) == Some("ncp.reference.rate");
        let targets = |name: &str| frame.get(name).and_then(|part| part.get("targets")).cloned();
        let is_plain = |port: &&str| port.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_');
        let records = targets("record");
        let spikes = items(records.as_ref()).iter().filter(|target| string(target, "observable") == Some("spikes"));
        let several = members(network.and_then(|network| network.get("population_sizes"))).len() > 1;
        let named = items(targets("stimulus").as_ref()).iter().any(|target| !items(target.get("ids")).is_empty());
        Self {
            dynamics: if is_rate { "NCP-SESS-051" } else { "NCP-SESS-050" },
            spikes: spikes.filter_map(|target| string(target, "port")).filter(is_plain).map(str::to_owned).collect(),
            is_selective: several || named,
            is_stimulated: false,
        }
    }
}

/// The ids of sessions that are nearly those of others: equal at their beginning, but for their case, or when composed.
fn twins(frames: &[Option<Json<'_>>]) -> HashSet<String> {
    let ids: HashSet<&str> =
        frames.iter().filter_map(|frame| string(frame.as_ref()?, "session_id")).filter(|id| !id.is_empty()).collect();
    let mut by_look: BTreeMap<String, Vec<&str>> = BTreeMap::new();
    for id in ids {
        let letters = |id: &str| id.chars().filter(char::is_ascii_alphanumeric).collect::<String>().to_lowercase();
        by_look.entry(letters(id).chars().take(8).collect()).or_default().push(id);
    }
    by_look.into_values().filter(|alike| alike.len() > 1).flatten().map(str::to_owned).collect()
}

/// Of the steps of a buffer, those that a latch, a mode or a length of ticks decides which the model does not know.
pub(super) fn buffer(args: &Tree, steps: &mut Vec<Option<&str>>) {
    let asked = items(args.get("steps"));
    let is_modelled = !steps.is_empty();
    steps.resize(asked.len(), None);
    let (mut latched, mut rule, mut behind): (Option<&str>, Option<&str>, usize) = (None, None, 0);
    for (step, known) in asked.iter().zip(steps.iter_mut()) {
        match string(step, "op") {
            Some("reset") => (latched, rule) = (None, None),
            Some("command") => {
                behind += 1;
                let frame = crate::fuzz::oracle::frame_bytes(step);
                let parsed = std::str::from_utf8(&frame).ok().and_then(|text| Json::parse(text).ok());
                let mode = parsed.as_ref().and_then(|frame| string(frame, "mode"));
                let is_read = wire::decode(Kind::CommandFrame, &frame).is_ok();
                let of = |name: &str| parsed.as_ref().and_then(|frame| frame.get(name));
                rule = match mode {
                    Some("active") if is_read && !items(of("horizon")).is_empty() => {
                        let dt = double(of("horizon_dt_ms"));
                        dt.is_none_or(|dt| !dt.is_finite() || dt <= 0.0).then_some("NCP-RES-027")
                    }
                    Some("init" | "hold" | "estop" | "active") | None => None,
                    Some(_) => is_read.then_some("NCP-WIRE-041"),
                };
                let hides = parsed.is_none() && String::from_utf8_lossy(&frame).contains("estop");
                if latched.is_none() && (mode == Some("estop") || hides) {
                    (latched, behind) = (Some(if is_read { "NCP-RES-021" } else { "NCP-RES-022" }), 0);
                }
            }
            _ => {
                let latch = latched.map(|latch| if behind > OLD { "NCP-RES-025" } else { latch });
                if let Some(own) = latch.filter(|_| !is_modelled || *known == Some("NCP-RES-025")).or(rule) {
                    *known = Some(own);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fuzz::tree::own;

    fn json(text: &str) -> Tree {
        own(&Json::parse(text).unwrap())
    }

    fn rule<'a>(about: &'a About, place: &str) -> Option<&'a str> {
        about.by.get(place).map(String::as_str)
    }

    #[test]
    fn what_a_held_frame_still_says_is_another_rule_than_what_holds_it() {
        let args = json(
            r#"{"limits":{"max_speed_mps":1.0},"steps":[
            {"op":"govern","command":{"mode":"hold"}},
            {"op":"govern","command":{"mode":"active","horizon":[{},{}]}}]}"#,
        );
        let frames = r#"[{"frame":{"mode":"hold"}},{"frame":{"mode":"active","horizon":[{},{}]}}]"#;
        let expect = json(&format!(r#"{{"value":{{"steps":{frames}}}}}"#));
        let mut about = About::default();
        about.governor(&args, &expect, &[Some("NCP-SAFE-002"), Some("NCP-SAFE-060")]);
        assert_eq!(rule(&about, "/steps/*/frame/channels"), Some("NCP-SAFE-071"));
        assert_eq!(rule(&about, "/steps/1/frame/channels"), Some("NCP-SAFE-060"));
        assert_eq!(rule(&about, "/steps/1/frame/horizon"), Some("NCP-SAFE-066"));
        assert_eq!(rule(&about, "/steps/0/frame/channels"), None);
    }

    #[test]
    fn a_loop_holds_for_the_age_of_its_sensor_and_not_for_one_that_is_not_newer() {
        let sensor = |seq: u8, now: f64| {
            format!(r#"{{"op":"sensor","sensor":{{"seq":{seq},"channels":{{}}}},"now_s":{now:?}}}"#)
        };
        let tick = |now: f64| format!(r#"{{"op":"tick","now_s":{now:?}}}"#);
        let (held, none) = (r#"{"command":{"mode":"hold"}}"#, "{}");
        let steps = [tick(0.0), sensor(2, 1.0), tick(1.6), sensor(1, 1.7), tick(1.8)].join(",");
        let args = json(&format!(r#"{{"limits":{{"command_timeout_ms":500.0}},"steps":[{steps}]}}"#));
        let answers = [held, none, held, none, held].join(",");
        let mut about = About::default();
        about.control_loop(&args, &json(&format!(r#"{{"value":{{"steps":[{answers}]}}}}"#)));
        let of = |nth: usize| rule(&about, &format!("/steps/{nth}/command/mode"));
        assert_eq!([of(0), of(2), of(4)], ["NCP-SAFE-030", "NCP-SAFE-033", "NCP-CTRL-012"].map(Some));
    }

    #[test]
    fn sessions_of_nearly_equal_ids_are_about_being_kept_apart() {
        let of = |id: &str| Some(json(&format!(r#"{{"session_id":"{id}"}}"#)));
        let alike = twins(&[of("uav-front-left"), of("UAV-front-lean"), of("other"), None]);
        assert_eq!(alike.len(), 2);
        assert!(!alike.contains("other"));
    }

    #[test]
    fn an_estop_in_a_malformed_frame_is_the_rule_of_what_follows_until_it_is_old() {
        let frame = |text: &str| format!(r#"{{"op":"command","text":{},"now_s":1.0}}"#, crate::fuzz::tree::text(text));
        let ask = r#"{"op":"active","now_s":1.0}"#.to_owned();
        let hidden = r#"{"kind":"command_frame","mode":"estop","seq":"x"}"#;
        let unknown = r#"{"ncp_version":"0.5","kind":"command_frame","mode":"drift"}"#;
        let steps = [vec![frame(unknown), ask.clone(), frame(hidden), ask.clone()], vec![frame(unknown); 4], vec![ask]];
        let args = json(&format!(r#"{{"steps":[{}]}}"#, steps.concat().join(",")));
        let mut rules = Vec::new();
        buffer(&args, &mut rules);
        assert_eq!([rules[1], rules[3], rules[8]], ["NCP-WIRE-041", "NCP-RES-022", "NCP-RES-025"].map(Some));
    }
}
