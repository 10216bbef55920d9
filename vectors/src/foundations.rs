//! On which cases a case rests: without them it shows nothing of its own rule.
//!
//! A frame that no decoder accepts says nothing of its fields, and a governor that takes every sensor for stale says
//! nothing of its fence. So the plainest cases come first, and what is built on them rests on them.

use std::collections::BTreeSet;

use regex::Regex;
use serde::Deserialize;

use crate::case::{Case, File};
use crate::json::Json;

/// What else cases rest on, group by group: `foundations.toml`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Foundations {
    foundation: Vec<Foundation>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Foundation {
    /// For those who read the file.
    #[serde(rename = "why")]
    _why: String,
    lines: Vec<Line>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Line {
    /// How the ids begin of the cases that it fits.
    #[serde(deserialize_with = "beginning")]
    ids: Regex,
    /// How the ids begin of those that it fits not.
    #[serde(default, deserialize_with = "some_beginning")]
    but: Option<Regex>,
    /// The ids of the cases beneath, with `${1}` for the first group of `ids`.
    on: Vec<String>,
}

impl Line {
    fn beneath(&self, id: &str) -> Vec<String> {
        let expand = |groups: &regex::Captures<'_>| {
            let ids = self.on.iter().map(|on| {
                let mut id = String::new();
                groups.expand(on, &mut id);
                id
            });
            ids.collect()
        };
        let is_left_out = self.but.as_ref().is_some_and(|but| but.is_match(id));
        self.ids.captures(id).filter(|_| !is_left_out).as_ref().map(expand).unwrap_or_default()
    }
}

fn further() -> Result<Vec<Line>, toml::de::Error> {
    let file: Foundations = toml::from_str(include_str!("../foundations.toml"))?;
    Ok(file.foundation.into_iter().flat_map(|group| group.lines).collect())
}

fn beginning<'de, D: serde::Deserializer<'de>>(deserializer: D) -> Result<Regex, D::Error> {
    let pattern = String::deserialize(deserializer)?;
    Regex::new(&format!("^(?:{pattern})")).map_err(serde::de::Error::custom)
}

fn some_beginning<'de, D: serde::Deserializer<'de>>(deserializer: D) -> Result<Option<Regex>, D::Error> {
    beginning(deserializer).map(Some)
}

/// What the cases rest on whose id begins so: the first line that fits. `{kind}` is the kind of the frame.
const BENEATH: &[(&str, &[&str])] = &[
    // Numbers and strings of a frame are read from what the peer writes.
    ("wire/encode_{kind}/plain", &[]),
    ("wire/encode_{kind}/string", &["wire/encode_{kind}/plain"]),
    ("wire/encode_{kind}/seq/zero", &["wire/encode_{kind}/plain"]),
    ("wire/encode_link_status/last_seq/zero", &["wire/encode_{kind}/plain"]),
    ("wire/encode_session_opened/resolved/zero", &["wire/encode_{kind}/plain"]),
    ("wire/encode_open_session/sim/seed/zero", &["wire/encode_{kind}/plain"]),
    ("wire/encode_capabilities/sensor_channels/size/zero", &["wire/encode_{kind}/plain"]),
    ("wire/encode_{kind}/explicit", &["wire/encode_{kind}/plain", "wire/encode_{kind}/seq/zero"]),
    ("wire/encode_{kind}/horizon/plain-maps", &["wire/encode_{kind}/plain"]),
    ("wire/encode_{kind}/horizon/", &["wire/encode_{kind}/explicit", "wire/encode_{kind}/horizon/plain-maps"]),
    ("wire/encode_", &["wire/encode_{kind}/explicit"]),
    ("version/guard/lenient/", &[]),
    ("version/contract/", &[]),
    ("version/negotiate/", &["version/guard/strict/own", "version/guard/strict/older-minor", MAJOR, THIRD]),
    ("wire/reply/", &["version/guard/strict/own", MAJOR, THIRD]),
    ("strict/frames/", &["version/guard/strict/own", MAJOR, THIRD]),
    ("strict/replies/", &["version/guard/strict/own", MAJOR, THIRD]),
    ("strict/server/", &["version/guard/strict/own", MAJOR, THIRD, UNKNOWN]),
    ("keys/build/{key}/realm-named", &["keys/build/{key}/realm"]),
    ("keys/build/{key}/realm", &["keys/build/{key}/realm"]),
    ("keys/build/{key}/default-realm-named", &["keys/build/{key}/realm-named"]),
    ("keys/build/{key}/", &["keys/build/{key}/realm"]),
    ("keys/segments/{key}/name/accepted", &["keys/build/{key}/realm-named"]),
    ("keys/segments/{key}/session/accepted", &["keys/build/{key}/realm"]),
    ("keys/realms/{key}/realm/accepted", &["keys/build/{key}/realm"]),
    ("keys/matching/ncp-rpc/ncp-rpc-x", &[]),
    ("keys/matching/ncp-rpc/", &[]),
    ("keys/matching/ncp-starstar/ncp", &["keys/matching/ncp-rpc/ncp-rpc-x"]),
    ("keys/matching/", &["keys/matching/ncp-starstar/ncp"]),
    ("bulk/values/i32-plain", &[]),
    ("bulk/values/f64-plain", &["bulk/values/i32-plain"]),
    ("bulk/values/i32-extremes", &["bulk/values/i32-plain"]),
    ("bulk/values/unaligned/f32-at-33", &["bulk/values/f64-plain"]),
    ("bulk/overlap/apart/touching", &["bulk/values/f64-plain"]),
    ("bulk/values/layout/gap", &["bulk/values/unaligned/f32-at-33", "bulk/overlap/apart/touching"]),
    ("bulk/", &["bulk/values/i32-extremes", "bulk/values/layout/gap-before-data"]),
    (STALE, &[]),
    (PASSES, &[STALE]),
    ("safety/stale/", &[STALE]),
    ("safety/gates/order/", &[PASSES, BY_LINK, BY_COMMAND, BY_FENCE]),
    ("safety/gates/latched-by-link/active", &[PASSES]),
    ("safety/gates/latched-by-link/", &[BY_LINK, "safety/gates/order/latched-by-link_and_hold"]),
    ("safety/gates/latched-by-command/active", &[PASSES]),
    ("safety/gates/latched-by-command/", &[BY_COMMAND, "safety/gates/order/latched-by-command_and_hold"]),
    ("safety/gates/latched-by-fence/active", &[PASSES]),
    ("safety/gates/latched-by-fence/", &[BY_FENCE, "safety/gates/order/latched-by-fence_and_hold"]),
    ("safety/gates/outside/hold", &[PASSES, "safety/gates/order/outside_and_hold"]),
    ("safety/gates/outside/init", &[PASSES, "safety/gates/order/outside_and_init"]),
    ("safety/latch/sequence/", &[PASSES, BY_LINK, BY_COMMAND, BY_FENCE]),
    ("safety/fence/on/3-4-0/octant-0", &[PASSES]),
    ("safety/projection/", &[PASSES, "safety/fence/on/3-4-0/octant-0"]),
    (CLAMPS, &[PASSES]),
    ("safety/speed/vector/", &[PASSES, CLAMPS]),
    ("safety/speed/horizon/clamped-0010", &[PASSES, CLAMPS]),
    ("safety/speed/", &[PASSES, CLAMPS, "safety/speed/horizon/clamped-0010"]),
    ("safety/binding/", &[PASSES, CLAMPS]),
    ("safety/", &[PASSES]),
    ("resilience/buffer/mode/moves", &[]),
    ("resilience/buffer/senders-clock/0.0", &["resilience/buffer/mode/moves"]),
    ("resilience/buffer/drop/duplicate/deadline", &[RECEIPT]),
    ("resilience/buffer/", &[RECEIPT, REFRESHES]),
    ("resilience/buffer_modes/", &[RECEIPT, REFRESHES]),
    ("resilience/estop/sequence/stale-estop", &[RECEIPT]),
    ("resilience/estop/", &[RECEIPT, "resilience/estop/sequence/stale-estop"]),
    ("resilience/horizon/", &[RECEIPT]),
    ("strict/plant/followed/one", &[RECEIPT]),
    ("strict/plant/", &[RECEIPT, "strict/plant/followed/one"]),
    ("resilience/watchdog/ttl-250/from-0/half", &[]),
    ("resilience/watchdog/", &["resilience/watchdog/ttl-250/from-0/half"]),
    ("resilience/liveness/", &["resilience/watchdog/ttl-250/from-0/half"]),
    ("resilience/link/last-seq/", &[]),
    ("resilience/link/count/one-gap", &[]),
    ("resilience/link/count/restart", &["resilience/link/count/one-gap"]),
    ("resilience/link/rate/0110", &["resilience/link/count/one-gap"]),
    ("resilience/link/burst/gap-20", &["resilience/link/count/one-gap"]),
    ("resilience/link/", &["resilience/link/count/restart", "resilience/link/rate/0110", BURST]),
    ("session/life/advance/1", &["wire/encode_session_opened/plain", "wire/encode_observation_frame/plain"]),
    ("session/life/chunk/5", &["wire/encode_session_opened/plain", "wire/encode_observation_frame/plain"]),
    (UNKNOWN, &[]),
    ("session/life/life/close-unknown", &[]),
    ("session/life/refused/", &[ADVANCE, UNKNOWN, "session/life/life/close-unknown"]),
    ("session/life/life/", &[ADVANCE, "session/life/chunk/5", UNKNOWN, "session/life/life/close-unknown"]),
    ("session/reference/cadence/1-by-1", &[ADVANCE, "session/life/chunk/5"]),
    ("session/reference/", &[ADVANCE, "session/life/chunk/5", "session/reference/cadence/1-by-1"]),
    ("session/", &[ADVANCE, "session/life/chunk/5"]),
    ("control/loop/newest/older", &["control/loop/newest/by-seq/2-1-3"]),
    ("control/loop/newest/unstamped-older", &["control/loop/newest/by-t/2-1-3"]),
    ("control/loop/newest/unstamped-again", &["control/loop/newest/by-t/2-1-3"]),
    ("control/loop/newest/restarted", &["control/loop/newest/by-seq/2-1-3"]),
    ("control/loop/link/shuffled", &["control/loop/newest/by-seq/2-1-3", "resilience/link/count/late"]),
    ("control/loop/gate/stale", &["safety/gates/stale-sensor/active"]),
    ("control/loop/gate/clock-backward", &["safety/gates/clock-backward/active"]),
    ("control/loop/gate/outside", &["safety/gates/outside/active", "safety/fence/outside/3-4-0/octant-0", BY_FENCE]),
    ("control/loop/gate/config-fault", &["safety/gates/config-fault/active"]),
    ("control/loop/gate/speed-clamp", &[CLAMPS]),
    ("control/loop/ttl/look-ahead", &["safety/gates/leaves-fence/active"]),
    ("control/loop/link/burst", &[BY_LINK, BURST]),
    ("control/loop/status/mode/stopped-by-burst", &["control/loop/link/burst"]),
    ("control/loop/status/mode/stopped", &["control/loop/gate/outside"]),
    ("control/loop/status/mode/held-clock", &["control/loop/gate/clock-backward"]),
    ("control/loop/status/mode/held-limits", &["control/loop/gate/config-fault"]),
    ("control/loop/status/mode/held", &["control/loop/gate/stale"]),
    ("control/loop/status/mode/waiting", &["control/loop/newest/no-frame"]),
    ("control/loop/status/safety/stopped-by-burst", &["control/loop/link/burst"]),
    ("control/loop/status/safety/stopped", &["control/loop/gate/outside"]),
    ("control/loop/status/safety/held-clock", &["control/loop/gate/clock-backward"]),
    ("control/loop/status/safety/held-limits", &["control/loop/gate/config-fault"]),
    ("control/loop/status/safety/held", &["control/loop/gate/stale"]),
];

const MAJOR: &str = "version/guard/lenient/next-major";
const THIRD: &str = "version/guard/strict/three-parts";
const STALE: &str = "safety/stale/age/500-ms/from-0-s/half";
const PASSES: &str = "safety/gates/nothing/active";
const BY_LINK: &str = "safety/gates/latched-by-link/active";
const BY_COMMAND: &str = "safety/gates/latched-by-command/active";
const BY_FENCE: &str = "safety/gates/latched-by-fence/active";
const CLAMPS: &str = "safety/speed/vector/3-4-0/above";
const RECEIPT: &str = "resilience/buffer/senders-clock/0.0";
const REFRESHES: &str = "resilience/buffer/drop/duplicate/deadline";
const BURST: &str = "resilience/link/burst/gap-20";
const ADVANCE: &str = "session/life/advance/1";
const UNKNOWN: &str = "session/life/life/step-before-open";

/// The kinds whose cases of decoding rest on cases of encoding.
const EXPLICIT: &str = "wire/{kind}/explicit";
const OWN: &str = "wire/kinds/{kind}/version/own";
const ABSENT: &str = "wire/{kind}/ncp_version/absent";
const PLAIN: &str = "wire/encode_{kind}/plain";

/// Lets every case rest on what lies beneath it.
///
/// # Errors
/// `foundations.toml` is not in order.
pub(crate) fn lay(files: Vec<File>) -> Result<Vec<File>, toml::de::Error> {
    let further = further()?;
    let ids: BTreeSet<String> = files.iter().flat_map(File::ids).collect();
    let found = |mut file: File| {
        let prefix = file.prefix();
        file.cases = file.cases.into_iter().map(|case| founded(case, &prefix, &ids, &further)).collect();
        file
    };
    Ok(files.into_iter().map(found).collect())
}

fn founded(mut case: Case, prefix: &str, ids: &BTreeSet<String>, further: &[Line]) -> Case {
    let id = format!("{prefix}/{}", case.path);
    let args = case.args.clone();
    let word = |name: &str| args.get(name).and_then(Json::as_str).unwrap_or_default().to_owned();
    // A client decodes the reply.
    let text = if case.call == "reply.check" { word("reply") } else { word("text") };
    let of_reply = || Json::read(&text).get("kind").and_then(Json::as_str).unwrap_or_default().to_owned();
    let (kind, key) = (if case.call == "reply.check" { of_reply() } else { word("kind") }, word("key"));
    let named = |pattern: &str| pattern.replace("{kind}", &kind).replace("{key}", &key);
    let line = BENEATH.iter().find(|(begins, _)| id.starts_with(&named(begins)));
    let mut beneath: Vec<String> = line.into_iter().flat_map(|(_, on)| *on).map(|on| named(on)).collect();
    if matches!(case.call, "decode" | "reply.check") && case.expect.get("reject").is_none() {
        beneath.extend(if id == named(OWN) {
            vec![named(PLAIN)]
        } else if id == named(EXPLICIT) {
            vec![named(OWN)]
        } else if id == named(ABSENT) || text.contains("ncp_version") || text.is_empty() {
            vec![named(EXPLICIT)]
        } else {
            vec![named(ABSENT)]
        });
    }
    if let Some(lenient) = id.strip_prefix("version/guard/strict/") {
        beneath.push(format!("version/guard/lenient/{lenient}"));
    }
    if let Some(hash) = id.strip_prefix("version/contract/verify/") {
        beneath.push(format!("version/contract/status/{hash}"));
    }
    if case.requirements.first() == Some(&"NCP-WIRE-043") {
        case = case.by("refusal", "NCP-WIRE-042");
    }
    // Refused for its version, which is not there: that it is not read as the default is no matter then.
    if case.requirements.first() == Some(&"NCP-WIRE-032") && case.call == "decode" {
        case = case.by("refusal", "NCP-WIRE-033");
    }
    // A segment that is refused is not changed.
    if case.requirements.first() == Some(&"NCP-KEY-007") {
        case = case.by("refusal", "NCP-KEY-020");
    }
    // A block that is refused is refused for how it lies: nothing else is wrong with it, unless it is long.
    if matches!(case.call, "bulk.decode" | "observation.unpack")
        && id.starts_with("bulk/values/")
        && !id.contains("layout")
        && !id.contains("long")
    {
        case = case.by("refusal", "NCP-BULK-018");
    }
    if case.call == "reply.check" {
        let request = Json::read(&word("request"));
        let kind = request.get("kind").and_then(Json::as_str).unwrap_or_default();
        beneath.push(ABSENT.replace("{kind}", kind));
    }
    if id == named(OWN) {
        case = case.by("within", "NCP-WIRE-034");
    }
    beneath.extend(further.iter().flat_map(|line| line.beneath(&id)));
    for on in beneath {
        if on != id && ids.contains(&on) && !case.rests_on.contains(&on) {
            case = case.rests_on(on);
        }
    }
    case
}

#[cfg(test)]
mod tests {
    use serde_json::Value;

    use super::{BENEATH, further};

    fn ids() -> Vec<String> {
        let files = crate::on_disk::corpus().into_iter();
        let cases = files.flat_map(|(_, text)| match serde_json::from_str::<Value>(&text).unwrap()["cases"].take() {
            Value::Array(cases) => cases,
            other => panic!("{other} is no list of cases"),
        });
        cases.map(|case| case["id"].as_str().unwrap().to_owned()).collect()
    }

    #[test]
    fn each_line_of_the_file_fits_a_case_and_each_of_its_foundations_is_laid_beneath_one() {
        let ids = ids();
        let wrong = further().unwrap().into_iter().flat_map(|line| {
            let laid: Vec<Vec<String>> = ids.iter().map(|id| line.beneath(id)).filter(|on| !on.is_empty()).collect();
            let is_laid = |place: usize| laid.iter().any(|laid| ids.contains(&laid[place]));
            let absent = line.on.iter().enumerate().filter(|(place, _)| !is_laid(*place));
            absent.map(|(_, on)| format!("{}: {on}", line.ids)).collect::<Vec<_>>()
        });
        let wrong: Vec<String> = wrong.collect();
        assert!(wrong.is_empty(), "no case, or none beneath:\n{}", wrong.join("\n"));
    }

    #[test]
    fn each_line_fits_a_case_and_rests_on_cases_that_there_are() {
        let ids = ids();
        // What stands in braces is the kind or the key of the case.
        let plain = |id: &&str| !id.contains('{');
        for (begins, on) in BENEATH {
            if plain(begins) {
                assert!(ids.iter().any(|id| id.starts_with(begins)), "{begins} fits no case");
            }
            for id in on.iter().copied().filter(|id| plain(id)) {
                assert!(ids.iter().any(|other| other == id), "there is no case {id}");
            }
        }
    }
}
