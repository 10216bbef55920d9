//! Requests to a server: sessions of the reference networks, side by side, and what is no request.

use std::collections::BTreeMap;

use ncp_text::WIRE_VERSION;

use super::corrupt::corrupted;
use super::frames::segment;
use super::plain::hash;
use super::{Draw, Menu, Tree, steps};
use crate::fuzz::tree::{double, int, items, list, literal, map, members, object, set, spelled, string, text};
use crate::json::Json;

/// What a trace has of sessions.
struct Script {
    ids: Vec<String>,
    /// The step, ms.
    dt: f64,
    cadences: Vec<f64>,
    /// The ports of stimuli, of which one may have the name of a recorded port.
    inputs: [&'static str; 2],
}

fn open(script: &Script, id: &str, draw: &mut Draw<'_>) -> Tree {
    let rate = draw.chance(30);
    // Many are recorded, by ids in any order, and a few of them are driven.
    let few = !rate && draw.chance(12);
    let neurons = match draw.below(200) {
        _ if few => draw.size(9, 300),
        0..=19 => draw.size(5, 300),
        // Ids of one digit and of two.
        22..=41 => draw.size(9, 24),
        20 | 21 => draw.size(300, 70_000),
        _ => draw.size(1, 4),
    };
    let mut params = Vec::new();
    let known: &[(&str, [f64; 4])] = if rate {
        // So large that the sum over neurons overflows, though none of them does.
        let mu = if draw.chance(20) { draw.one(&[8e307, -8e307]) } else { 0.5 };
        &[("tau", [10.0, 20.0, 5.0, 100.0]), ("mu", [0.0, 25.0, -10.0, mu])]
    } else {
        &[
            ("C_m", [250.0, 100.0, draw.one(&[500.0, 500.0, 0.001]), 1.0]),
            ("tau_m", [10.0, 20.0, 5.0, draw.one(&[50.0, 1000.0, 20_000.0])]),
            ("E_L", [-70.0, -65.0, 0.0, draw.one(&[-60.0, -55.0, -50.0])]),
            ("V_th", [-55.0, -50.0, 20.0, -45.0]),
            ("V_reset", [-70.0, -75.0, -80.0, -72.0]),
            ("t_ref", [2.0, 0.0, draw.one(&[5.0, 0.7, 2.3, 2.55, 1.6, 1.25]), draw.one(&[10.0, 40.0, 300.0])]),
            // Against the drift from a rest above the threshold, as well.
            ("I_e", [0.0, 400.0, draw.one(&[500.0, -200.0, -900.0]), draw.one(&[1000.0, 1000.0, 1e290, 1e308])]),
        ]
    };
    // Of one value under different names, in one session or in two.
    let same = draw.chance(10).then_some(20.0);
    let may_be = |name: &str| ["C_m", "tau_m", "t_ref", "tau", "mu", "I_e"].contains(&name);
    for (name, values) in known {
        if let Some(value) = same.filter(|_| may_be(name)) {
            if draw.chance(40) {
                params.push(((*name).to_owned(), spelled(value)));
            }
        } else if draw.chance(30) {
            params.push(((*name).to_owned(), spelled(draw.one(values))));
        }
    }
    let sizes = match draw.below(10) {
        0..=1 => vec![("pop", neurons), ("other", 2)],
        2 => vec![("other", 2), ("pop", neurons)],
        3 => vec![("po", 2), ("pop", neurons), ("other", 2)],
        4 if draw.chance(50) => vec![("none", 0), ("pop", neurons)],
        _ => vec![("pop", neurons)],
    };
    let size_of: Vec<(&str, usize)> = sizes.clone();
    let targets: Vec<&str> = sizes.iter().map(|(name, _)| *name).collect();
    // Of neurons of which some are driven, some spike.
    let all = draw.one(&[60, 60, 10]);
    let ids = |neurons: usize, may_be_all: bool, draw: &mut Draw<'_>| {
        let most = if draw.chance(10) { 80 } else { 8 };
        if few && !may_be_all {
            let mut all: Vec<usize> = (1..=neurons).collect();
            (0..all.len()).for_each(|at| all.swap(at, draw.below(neurons)));
            return list(all.into_iter().map(|id| int(i64::try_from(id).unwrap_or(1))).collect());
        }
        let count = match neurons {
            0 => 0,
            _ if few => draw.size(2, 6),
            _ if may_be_all && draw.chance(all) => 0,
            _ => draw.size(1, neurons.min(most)),
        };
        // Once: what a neuron that is named twice gives, nobody says.
        let mut ids: Vec<usize> =
            (0..count).map(|_| if draw.chance(20) { neurons } else { 1 + draw.below(neurons) }).collect();
        if count > 1 && draw.chance(30) {
            // In whose order numbers and their spellings differ.
            ids.extend([2, 9, 10, 11].iter().filter(|id| **id <= neurons));
        }
        ids.sort_unstable();
        ids.dedup();
        match draw.below(4) {
            0 => ids.reverse(),
            // A range at its ends alone.
            2 if neurons > 4 && draw.chance(40) => {
                let count = draw.size(4, neurons.min(most));
                let first = 1 + draw.below(neurons - count + 1);
                ids = (first..first + count).collect();
                (1..count - 1).for_each(|at| ids.swap(at, 1 + draw.below(count - 2)));
            }
            1 => {
                let middle = draw.below(ids.len() + 1);
                ids.rotate_left(middle);
            }
            _ => {}
        }
        list(ids.into_iter().map(|id| int(i64::try_from(id).unwrap_or(1))).collect())
    };
    let ports = draw.size(0, 3);
    let records = (0..ports).map(|nth| {
        let target = draw.one(&targets);
        let of = size_of.iter().find(|(name, _)| *name == target).map_or(1, |(_, size)| *size);
        let observable = if rate {
            "rate"
        } else if few {
            "spikes"
        } else {
            draw.one(&["V_m", "V_m", "spikes"])
        };
        object([
            ("port", text(format!("r{nth}"))),
            ("target", text(target)),
            ("observable", text(observable)),
            // The samples of many neurons fill more than a line.
            ("ids", ids(of, !few && (of <= 2000 || observable == "spikes" && draw.chance(50)), draw)),
            ("cadence_ms", spelled(draw.one(&script.cadences))),
        ])
    });
    let records: Vec<Tree> = records.collect();
    let kind = if rate { "rate_inject" } else { "current_pA" };
    let stimuli = script.inputs.into_iter().map(|port| {
        let target = draw.one(&targets);
        let of = size_of.iter().find(|(name, _)| *name == target).map_or(1, |(_, size)| *size);
        object([("port", text(port)), ("target", text(target)), ("kind", text(kind)), ("ids", ids(of, true, draw))])
    });
    let stimuli: Vec<Tree> = stimuli.collect();
    let chunk = match draw.below(40) {
        0 => draw.one(&[0.0, -1.0, -0.25]) * script.dt,
        _ => time(script.dt, 40, draw),
    };
    let sizes = sizes.into_iter().map(|(name, size)| (name.to_owned(), int(i64::try_from(size).unwrap_or(1))));
    let hash = draw.chance(8).then(|| hash(draw)).flatten();
    let mut open = object([
        ("ncp_version", text(WIRE_VERSION)),
        ("kind", text("open_session")),
        ("session_id", text(id)),
        (
            "network",
            object([
                ("kind", text("builtin")),
                ("ref", text(if rate { "ncp.reference.rate" } else { "ncp.reference.lif" })),
                ("population_sizes", map(sizes.collect())),
                ("params", map(params)),
            ]),
        ),
        ("record", object([("targets", list(records))])),
        ("stimulus", object([("targets", list(stimuli))])),
        ("sim", object([("dt_ms", spelled(script.dt)), ("chunk_ms", spelled(chunk))])),
    ]);
    // Whatever it is, it refuses nothing.
    if let Some(hash) = hash {
        set(&mut open, "contract_hash", text(hash));
    }
    open
}

/// A time of at most so many steps: as a rule a whole number of them, else one between them, half-way, near half-way,
/// or of few digits.
fn time(dt: f64, most: i64, draw: &mut Draw<'_>) -> f64 {
    let steps = draw.range(1, most) as f64;
    match draw.below(16) {
        0 => dt * (steps - 0.5),
        1 => (dt * (steps - 0.5)).next_down(),
        2 => dt * (steps - draw.one(&[0.25, 0.4, 0.499, 0.501, 0.9])),
        3 => (dt * steps * 10.0).round().max(1.0) / 10.0 + draw.one(&[0.0, 0.05, 0.25]),
        _ => dt * steps,
    }
}

fn request(kind: &str, id: &str) -> Tree {
    object([("ncp_version", text(WIRE_VERSION)), ("kind", text(kind)), ("session_id", text(id))])
}

/// A value for a port, if any.
fn stimulus(request: &mut Tree, inputs: [&str; 2], draw: &mut Draw<'_>) {
    if draw.chance(4) {
        // Nothing for any port.
        set(request, "stimulus", object([("t", spelled(1.0))]));
        return;
    }
    if draw.chance(40) {
        let port = draw.one(&[inputs[0], inputs[0], inputs[1]]);
        let value = if draw.chance(3) { draw.one(&[1e290, 1e308, -1e308]) } else { draw.range(-20, 40) as f64 * 50.0 };
        let value = spelled(value);
        let mut stimulus = object([("values", object([(port, object([("data", list(vec![value]))]))]))]);
        if draw.chance(15) {
            // On the clock of the sender, which says nothing to a server.
            set(&mut stimulus, "t", spelled(draw.range(-3, 9) as f64));
        }
        set(request, "stimulus", stimulus);
    }
}

/// The request without a version, with another, or with a stimulus frame that has one.
fn of_other_version(mut request: Tree, draw: &mut Draw<'_>) -> Tree {
    let version = draw.one(&["0.4", "1.0", "x", WIRE_VERSION]);
    if let Some(mut stimulus) = request.get("stimulus").cloned().filter(|_| draw.chance(60)) {
        set(&mut stimulus, "ncp_version", text(version));
        set(&mut request, "stimulus", stimulus);
    }
    match draw.below(3) {
        0 => set(&mut request, "ncp_version", text(version)),
        1 => {
            if let crate::json::Json::Object(members) = &mut request {
                members.retain(|(name, _)| name != "ncp_version");
            }
        }
        _ => {}
    }
    request
}

/// The arguments of `session.run`.
pub(super) fn run(menu: &Menu, draw: &mut Draw<'_>) -> Tree {
    let most = if draw.chance(6) { draw.size(4, 300) } else { 4 };
    let mut ids: Vec<String> = (0..draw.size(1, most)).map(|_| segment(draw)).collect();
    if most > 4 {
        ids = (0..ids.len()).map(|nth| format!("{}{nth}", draw.one(&['a', 'b', 'z']))).collect();
    }
    if draw.chance(30) {
        // Equal but for the end, the case, or how they are composed.
        let id = ids[0].clone();
        let long = "x".repeat(draw.size(8, 255));
        let both = [format!("{long}0"), format!("{long}1")];
        ids.extend([id.to_uppercase(), format!("{id}0"), "é".to_owned(), "e\u{301}".to_owned()]);
        ids.extend([format!("{id}\u{3000}"), draw.nearly(&id), draw.nearly(&id)]);
        ids.extend(both);
        ids.retain(|id| id.len() <= 256);
    }
    let dt = draw.one(&[1.0, 0.5, 0.25, 0.125, 2.0, 0.1, 0.3]);
    let cadences = (0..3)
        .map(|_| if draw.chance(70) { dt * draw.one(&[1.0, 1.0, 2.0, 5.0, 10.0, 7.0]) } else { time(dt, 8, draw) });
    let cadences = cadences.collect();
    let inputs = draw.one(&[["in", "in2"], ["in", "in2"], ["in", "in2"], ["r0", "in2"]]);
    let script = Script { ids, dt, cadences, inputs };
    let most = if draw.chance(8) { 600 } else { 40 };
    // All that have an id are opened, and the first of them is asked behind them.
    let count = steps(draw, most).min(most).max(if script.ids.len() > 20 { script.ids.len() + 4 } else { 0 });
    let is_strict = menu.strict && draw.chance(20);
    let versions = draw.one(&[0, 0, 10, 30]);
    let has_verbs = is_strict && draw.chance(50);
    let (odd, closes) = (draw.one(&[0, 0, 10, 30]), draw.one(&[3, 10, 30]));
    // Sessions that fail again and again, and go on all the same.
    let failing = draw.one(&[0, 0, 0, 0, 0, 40, 95]);
    let mut requests = Vec::new();
    let mut kinds = Vec::new();
    let mut open_now = std::collections::HashSet::new();
    // What is long shows little that what is short does not; so a few are long, and the time goes into many.
    let mut left = match draw.below(40) {
        0 => BEARABLE,
        1..=2 => 5e4,
        3..=8 => 1e4,
        _ => 2e3,
    };
    let mut weights: BTreeMap<String, f64> = BTreeMap::new();
    let (mut opened, again): (Option<Tree>, u64) = (None, draw.one(&[0, 0, 40, 100]));
    for nth in 0..count {
        let among = if nth >= script.ids.len() && draw.chance(20) { 1 } else { script.ids.len() };
        let id = script.ids[draw.below(among)].clone();
        let kind = match draw.below(100) {
            // What a second opening of a session does is advice, so it is rare, but at the key of another request.
            0..=9 if !open_now.contains(&id) || draw.chance(if has_verbs { 60 } else { 3 }) => "open_session",
            _ if nth < script.ids.len() => "open_session",
            roll if roll < 10 + usize::try_from(closes).unwrap_or(0) => "close_session",
            roll if roll < 75 => "step_request",
            _ => "run_request",
        };
        let id = if kind == "open_session" && nth < script.ids.len() { script.ids[nth].clone() } else { id };
        match kind {
            "open_session" => drop(open_now.insert(id.clone())),
            "close_session" => drop(open_now.remove(&id)),
            _ => {}
        }
        let time = match draw.below(20) {
            _ if draw.chance(failing) => -script.dt,
            0 => script.dt * draw.one(&[-1.0, -1.0, 0.0, 0.0, 0.25, -0.25]),
            1 if draw.chance(15) => script.dt * draw.size(2000, 80_000) as f64,
            1 => script.dt * draw.range(50, 2000) as f64,
            _ => time(script.dt, 30, draw),
        };
        let weight = weights.get(&id).copied().unwrap_or(1.0);
        let time = if time / script.dt * weight > left { self::time(script.dt, 3, draw) } else { time };
        left -= (time / script.dt * weight).max(0.0);
        let frame = match kind {
            "open_session" => {
                // As another was opened, that may be closed by now.
                let mut frame = match &opened {
                    Some(frame) if draw.chance(again) => frame.clone(),
                    _ => open(&script, &id, draw),
                };
                set(&mut frame, "session_id", text(id.clone()));
                opened = Some(frame.clone());
                weights.insert(id.clone(), weight_of(&frame));
                frame
            }
            "step_request" => {
                let mut step = request(kind, &id);
                if draw.chance(60) {
                    set(&mut step, "advance_ms", spelled(time));
                }
                stimulus(&mut step, script.inputs, draw);
                step
            }
            "run_request" => {
                let mut run = request(kind, &id);
                set(&mut run, "duration_ms", spelled(time));
                stimulus(&mut run, script.inputs, draw);
                run
            }
            _ => request(kind, &id),
        };
        let frame = if draw.chance(versions) { of_other_version(frame, draw) } else { frame };
        let written = if draw.chance(odd) {
            match draw.below(6) {
                // What every request has, in another type: a server that looks at the rest alone would do it.
                4 => {
                    let mut frame = frame;
                    let (name, value) =
                        (draw.pick(&["ncp_version", "session_id"]), draw.pick(&["null", "5", "[]", "{}"]));
                    set(&mut frame, name, literal(value));
                    frame.to_string()
                }
                // An id that is none, the longest of which may not fit where it is echoed.
                5 => {
                    let mut frame = frame;
                    let long = draw.size(257, 2000);
                    let ids = ["", ".", "..", "a/b", "a*", "@a", "a b", "a\n", "\u{7f}"];
                    let id = if draw.chance(40) { draw.letters(long) } else { draw.pick(&ids).to_owned() };
                    set(&mut frame, "session_id", text(id));
                    frame.to_string()
                }
                0 => draw.pick(&["", "{}", "[]", "null", "\u{feff}", "{\"kind\":\"sensor_frame\"}", "x"]).to_owned(),
                1 => {
                    let mut frame = frame;
                    set(&mut frame, "seq", literal("1"));
                    set(&mut frame, "kind", text(draw.pick(&["session_opened", "sensor_frame", "error", "novel"])));
                    frame.to_string()
                }
                _ => String::from_utf8_lossy(&corrupted(&frame, draw)).into_owned(),
            }
        } else {
            frame.to_string()
        };
        requests.push(text(written));
        kinds.push(kind);
    }
    let mut args = object([("requests", list(requests))]);
    if is_strict {
        set(&mut args, "strict", crate::json::Json::Bool(true));
        if has_verbs {
            let right = draw.one(&[85, 85, 40]);
            let verbs = kinds.iter().map(|kind| {
                let other = draw.one(&[
                    "open_session",
                    "step_request",
                    "run_request",
                    "close_session",
                    "session_opened",
                    "observation_frame",
                    "command_frame",
                ]);
                text(if draw.chance(right) { kind } else { other })
            });
            set(&mut args, "verbs", list(verbs.collect()));
        }
    }
    args
}

/// What a step of the session costs that is opened so, in neurons and samples.
fn weight_of(frame: &Json<'_>) -> f64 {
    let sizes = members(frame.get("network").and_then(|network| network.get("population_sizes")));
    let neurons: f64 = sizes.iter().filter_map(|(_, size)| double(Some(size))).map(|size| size.max(0.0)).sum();
    let ports = items(frame.get("record").and_then(|record| record.get("targets"))).len();
    // A sample is more than a step: it is written out.
    neurons.max(1.0) * (1.0 + ports as f64)
}

/// Whether the requests of a trace ask for no more than a slow server does in a second, all together: what takes longer
/// looks like a hang, and a reply of a million samples is longer than a line may be.
pub(super) fn is_bearable(args: &Tree) -> bool {
    let mut dts: BTreeMap<String, (f64, f64, f64)> = BTreeMap::new();
    let mut work = 0.0;
    for request in items(args.get("requests")) {
        let Some(frame) = request.as_str().and_then(|written| Json::parse(written).ok()) else { continue };
        let id = string(&frame, "session_id").unwrap_or_default();
        if string(&frame, "kind") == Some("open_session") {
            let time = |name, default| {
                double(frame.get("sim").and_then(|sim| sim.get(name)).filter(|t| !t.is_null())).unwrap_or(default)
            };
            dts.insert(id.to_owned(), (time("dt_ms", 0.1), time("chunk_ms", 10.0), weight_of(&frame)));
            continue;
        }
        let Some((dt, chunk, weight)) = dts.get(id) else { continue };
        let time = ["advance_ms", "duration_ms"].into_iter().find_map(|name| double(frame.get(name)));
        let steps = time.unwrap_or(*chunk) / dt;
        // What is endless is refused at once. What only takes too long a server may refuse or do, as it likes.
        if steps > 0.0 && steps.is_finite() {
            work += steps * weight;
        }
    }
    work <= BEARABLE
}

/// So many neurons and samples times steps.
const BEARABLE: f64 = 400_000.0;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fuzz::generate::tests::whole_menu;
    use crate::fuzz::harvest::Harvest;
    use crate::fuzz::tree::items;

    #[test]
    fn a_trace_that_asks_for_more_than_a_slow_server_bears_is_not_asked() {
        let trace = |advance: &str| {
            let network = r#""network":{"population_sizes":{"p":2}},"sim":{"dt_ms":1.0}"#;
            let open = format!(r#"{{"kind":"open_session","session_id":"a",{network}}}"#);
            let step = format!(r#"{{"kind":"step_request","session_id":"a","advance_ms":{advance}}}"#);
            object([("requests", list(vec![text(open), text(step)]))])
        };
        assert!(is_bearable(&trace("10.0")) && is_bearable(&trace("1e400")));
        assert!(!is_bearable(&trace("1000000.0")) && !is_bearable(&trace("1e9")));
    }

    #[test]
    fn a_strict_server_is_asked_with_stimuli_by_requests_of_other_versions_and_a_crowd_is_opened_whole() {
        let (menu, harvest) = (whole_menu(), Harvest::default());
        let (mut stimulated, mut largest) = (0, 0);
        for number in 0..600 {
            let args = run(&menu, &mut Draw::new(3, number, &harvest));
            let requests: Vec<&str> =
                items(args.get("requests")).iter().filter_map(|request| request.as_str()).collect();
            let own = format!("{{\"ncp_version\":\"{WIRE_VERSION}\"");
            let is_other = |request: &&&str| request.contains("\"stimulus\":{") && !request.starts_with(&own);
            if args.get("strict").is_some() {
                stimulated += requests.iter().filter(is_other).count();
            }
            largest = largest.max(requests.iter().take_while(|request| request.contains("open_session")).count());
        }
        assert!(stimulated > 20 && largest > 30, "{stimulated} {largest}");
    }

    #[test]
    fn a_session_that_is_open_is_opened_again_at_the_key_of_another_request() {
        let (menu, harvest) = (whole_menu(), Harvest::default());
        let is_found = |number: &u64| {
            let args = run(&menu, &mut Draw::new(3, *number, &harvest));
            let requests = items(args.get("requests")).iter();
            let parsed = requests.map(|request| request.as_str().and_then(|written| Json::parse(written).ok()));
            let mut open = std::collections::HashSet::new();
            // Behind the first of each session, which may share their ids.
            let mut is_behind = false;
            parsed.zip(items(args.get("verbs"))).any(|(request, verb)| {
                let of = |name: &str| request.as_ref().and_then(|request| string(request, name)).map(str::to_owned);
                let (kind, id) = (of("kind"), of("session_id"));
                match kind.as_deref() {
                    Some("open_session") => {
                        let is_new = open.insert(id);
                        !is_new && is_behind && verb.as_str() != Some("open_session")
                    }
                    kind => {
                        is_behind = true;
                        if kind == Some("close_session") {
                            open.remove(&id);
                        }
                        false
                    }
                }
            })
        };
        let found = (0..1500).filter(is_found).count();
        assert!(found > 8, "{found}");
    }

    #[test]
    fn many_neurons_are_recorded_in_any_order_of_which_a_few_are_driven() {
        let (menu, harvest) = (whole_menu(), Harvest::default());
        let count = |targets: Option<&Json<'_>>, is_found: &dyn Fn(&[Json<'_>]) -> bool| {
            let targets = items(targets.and_then(|targets| targets.get("targets"))).iter();
            targets.filter(|target| is_found(items(target.get("ids")))).count()
        };
        let is_turned =
            |ids: &[Json<'_>]| ids.len() > 16 && !ids.is_sorted_by_key(|id| double(Some(id)).map(f64::to_bits));
        let mut found = 0;
        for number in 0..1500 {
            let args = run(&menu, &mut Draw::new(3, number, &harvest));
            for request in items(args.get("requests")).iter().filter_map(|request| request.as_str()) {
                let Ok(open) = Json::parse(request) else { continue };
                let (many, few) =
                    (count(open.get("record"), &is_turned), count(open.get("stimulus"), &|ids| ids.len() > 1));
                found += usize::from(many > 0 && few > 0);
            }
        }
        assert!(found > 30, "{found}");
    }

    #[test]
    fn a_population_may_be_empty_a_stimulus_may_have_a_time_and_a_rate_may_be_near_the_largest() {
        let (menu, harvest) = (whole_menu(), Harvest::default());
        let mut found = [0; 3];
        for number in 0..1500 {
            let args = run(&menu, &mut Draw::new(3, number, &harvest)).to_string();
            let says = |what: &str| usize::from(args.contains(what));
            let said = [says("\\\"none\\\":0"), says("\\\"t\\\":"), says("8e307")];
            for (all, one) in found.iter_mut().zip(said) {
                *all += one;
            }
        }
        assert!(found.iter().all(|found| *found > 10), "{found:?}");
    }
}
