//! The freedoms of the rate codec.

use std::collections::{BTreeMap, HashSet};

use super::{Outcome, Verdict, any, exactly, fits, fits_or_refused, num, range, reject};
use crate::fuzz::tree::{Tree, double, doubles, integer, items, list, map, members, object, set, string, text};
use crate::json::Json;

/// How far off a result may be, relatively to the greater end of its range, CODEC-013.
const ROUNDING: f64 = 1e-12;
/// Beyond this, the plain formula leaves the doubles on the way.
const HUGE: f64 = 1e300;
/// Below this, it loses digits on the way.
const TINY: f64 = 1e-290;

struct Mapping {
    channel: String,
    component: i64,
    population: String,
    value: [f64; 2],
    rate: [f64; 2],
}

/// The mappings of one side but those that are ignored, which are as if they were not there (NCP-CODEC-008).
fn heeded(args: &Tree, side: &str) -> Option<Vec<Mapping>> {
    Some(mappings(args, side)?.into_iter().filter(|mapping| mapping.component < 4096).collect())
}

/// The mappings of one side.
fn mappings(args: &Tree, side: &str) -> Option<Vec<Mapping>> {
    let codec = args.get("codec")?;
    if codec.as_str() == Some("uav") {
        let uav = |channel: &str, names: [&str; 3], end: f64| {
            (0..3)
                .zip(names)
                .map(|(component, population)| Mapping {
                    channel: channel.to_owned(),
                    component,
                    population: population.to_owned(),
                    value: [-end, end],
                    rate: [0.0, 200.0],
                })
                .collect()
        };
        return Some(if side == "encoders" {
            uav("pose_error", ["err_x", "err_y", "err_z"], 2.0)
        } else {
            uav("velocity_setpoint", ["vel_x", "vel_y", "vel_z"], 1.5)
        });
    }
    let read = |mapping: &Tree| {
        let ends = |name: &str, default: [f64; 2]| match doubles(mapping.get(name)).as_slice() {
            [from, to] => [*from, *to],
            _ => default,
        };
        Some(Mapping {
            channel: string(mapping, "channel")?.to_owned(),
            component: integer(mapping.get("component"))?,
            population: string(mapping, "population")?.to_owned(),
            value: ends("value_range", [-1.0, 1.0]),
            rate: ends("rate_range", [0.0, 200.0]),
        })
    };
    items(codec.get(side)).iter().map(read).collect()
}

/// What may come of the map of a number, which is `mapped` by the specification. The ends of its target are finite.
fn mapped(x: Option<f64>, from: [f64; 2], to: [f64; 2], mapped: f64) -> Tree {
    let middle = f64::midpoint(to[0], to[1]);
    let slack = ROUNDING * to[0].abs().max(to[1].abs()) + TINY;
    let about = |value: f64| range(value - slack, value + slack);
    let usable = x.is_some_and(f64::is_finite) && from.iter().all(|end| end.is_finite()) && from[0] != from[1];
    if !usable {
        return about(middle);
    }
    let all = [x.unwrap_or(0.0), from[0], from[1], to[0], to[1]];
    let span = (from[1] - from[0]).abs();
    if all.iter().any(|value| value.abs() > HUGE) || span < TINY {
        // Where a step leaves the doubles, by how much the result is off is open; the clamp holds.
        return range(to[0], to[1]);
    }
    let mut choices = vec![about(mapped)];
    if from[0] > from[1] {
        choices.push(about(middle));
    }
    any(choices)
}

/// Whether JSON can hold every number of the arguments.
fn is_writable(tree: &Tree) -> bool {
    match tree {
        Json::String(word) => !matches!(word.as_ref(), "NaN" | "Infinity" | "-Infinity"),
        Json::Array(items) => items.iter().all(is_writable),
        Json::Object(members) => members.iter().all(|(_, value)| is_writable(value)),
        _ => true,
    }
}

fn judged(args: &Tree, pattern: Tree) -> Verdict {
    if is_writable(args) { fits(pattern) } else { fits_or_refused(pattern) }
}

/// Whether every mapping can be told from the others.
fn are_apart(encoders: &[Mapping], decoders: &[Mapping]) -> bool {
    let (mut populations, mut places) = (HashSet::new(), HashSet::new());
    encoders.iter().all(|mapping| populations.insert(&mapping.population))
        && decoders.iter().all(|mapping| places.insert((&mapping.channel, mapping.component)))
}

/// Ranges that a program best refuses when the codec is built.
fn has_strange_target(mappings: &[Mapping], encoders: bool) -> bool {
    mappings.iter().any(|mapping| {
        let target = if encoders { mapping.rate } else { mapping.value };
        !target.iter().all(|end| end.is_finite())
    })
}

pub(super) fn encode(args: &Tree, result: Outcome<'_>) -> Verdict {
    let (Some(encoders), Some(decoders)) = (heeded(args, "encoders"), heeded(args, "decoders")) else {
        return Verdict::Open("the codec is none");
    };
    if !are_apart(&encoders, &decoders) {
        return Verdict::Open("two mappings for one place");
    }
    if has_strange_target(&encoders, true) || has_strange_target(&decoders, false) {
        return Verdict::Open("a target range that is not finite");
    }
    let result = match result {
        Ok(result) => result,
        Err(code) => return reject(code),
    };
    let channels = args.get("sensor").and_then(|sensor| sensor.get("channels"));
    let mut rates = Vec::new();
    for mapping in &encoders {
        let data = doubles(channels.and_then(|channels| channels.get(&mapping.channel)).and_then(|c| c.get("data")));
        let x = usize::try_from(mapping.component).ok().and_then(|component| data.get(component)).copied();
        let by_spec = double(result.get("rates").and_then(|rates| rates.get(&mapping.population))).unwrap_or(f64::NAN);
        rates.push((mapping.population.clone(), mapped(x, mapping.value, mapping.rate, by_spec)));
    }
    // The golden cases let a population that only an ignored mapping names rest at the middle.
    let has_ignored = mappings(args, "encoders").is_some_and(|all| all.len() > encoders.len());
    judged(args, object([("rates", if has_ignored { map(rates) } else { exactly(map(rates)) })]))
}

pub(super) fn decode(args: &Tree, result: Outcome<'_>) -> Verdict {
    let (Some(encoders), Some(decoders)) = (heeded(args, "encoders"), heeded(args, "decoders")) else {
        return Verdict::Open("the codec is none");
    };
    if !are_apart(&encoders, &decoders) {
        return Verdict::Open("two mappings for one place");
    }
    if has_strange_target(&encoders, true) || has_strange_target(&decoders, false) {
        return Verdict::Open("a target range that is not finite");
    }
    let result = match result {
        Ok(result) => result,
        Err(code) => return reject(code),
    };
    let answered = result.get("command").and_then(|command| command.get("channels"));
    let mut channels: BTreeMap<&str, BTreeMap<usize, Tree>> = BTreeMap::new();
    for mapping in &decoders {
        let component = usize::try_from(mapping.component).unwrap_or_default();
        let of = answered.and_then(|channels| channels.get(&mapping.channel)).and_then(|channel| channel.get("data"));
        let by_spec = doubles(of).get(component).copied().unwrap_or(f64::NAN);
        let rate = double(args.get("rates").and_then(|rates| rates.get(&mapping.population)));
        let value = mapped(rate, mapping.rate, mapping.value, by_spec);
        channels.entry(&mapping.channel).or_default().insert(component, value);
    }
    let channel = |(name, data): (&str, BTreeMap<usize, Tree>)| {
        let width = data.keys().last().map_or(0, |last| last + 1);
        let data = (0..width).map(|at| data.get(&at).cloned().unwrap_or_else(|| num(0.0))).collect();
        (name.to_owned(), object([("data", list(data))]))
    };
    let channels = map(channels.into_iter().map(channel).collect());
    let mut command = object([("channels", exactly(channels))]);
    for (name, value) in members(Some(args)) {
        if matches!(name.as_ref(), "t" | "seq" | "frame_id" | "mode") {
            set(&mut command, name, crate::fuzz::tree::own(value));
        }
    }
    if string(args, "frame_id").is_none() {
        set(&mut command, "frame_id", text("world"));
    }
    judged(args, object([("command", command)]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fuzz::Input;
    use crate::fuzz::oracle::{expectation, specification};
    use crate::fuzz::tree::own;
    use crate::peer::Call;

    #[test]
    fn of_a_map_whose_steps_leave_the_doubles_the_clamp_is_asked_for_and_of_the_others_all() {
        let mapping = |name: &str, ends: &str| {
            let place = format!(r#""channel":"{name}","component":0,"population":"{name}""#);
            format!(r#"{{{place},"value_range":{ends},"rate_range":[3.0,7.0]}}"#)
        };
        let mappings = [mapping("a", "[-1.7e308,1.7e308]"), mapping("b", "[0.0,1.0]")].join(",");
        let sensor = r#"{"seq":1,"channels":{"a":{"data":[0.5]},"b":{"data":[0.5]}}}"#;
        let written = format!(r#"{{"codec":{{"encoders":[{mappings}],"decoders":[]}},"sensor":{sensor}}}"#);
        let args = Json::parse(&written).map(|args| own(&args)).unwrap();
        let call = Call::CodecEncode;
        let Verdict::Expect(expect) = expectation(&Input { call, args }, &specification(call, &written), None) else {
            panic!("one map that is open leaves the others as they are");
        };
        let expect = expect.to_string();
        assert!(expect.contains(r#""a":{"$range":[3.0,7.0]}"#) && expect.contains("[4.99999999999"), "{expect}");
    }
}
