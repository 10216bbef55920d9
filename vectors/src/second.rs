//! The models as a second source of what was drawn at random: what a trace has to answer, and the rule of each answer.
//!
//! The models know what scenario text can say. What they do not know, such as a frame that is malformed, they have no
//! word on.

use std::collections::BTreeSet;

use crate::command::{Channel, Command};
use crate::json::Json;
use crate::resilience::{Event, buffer, watchdog};
use crate::safety::{Capabilities, Limits, Sensor, Spec, Step, Trace};

/// What a model says of a trace.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Second {
    /// What has to come back, as a vector file writes a pattern; none, where the model does not know a name that comes
    /// back.
    pub pattern: Option<String>,
    /// For each step the rule that decides it, if one does.
    pub rules: Vec<Option<&'static str>>,
}

/// What the model of a call says of its arguments, a JSON text as `peers/PROTOCOL.md` defines it; none, where there is
/// no model, or it does not know such arguments.
#[must_use]
pub fn second(call: &str, args: &str) -> Option<Second> {
    let args = Json::read(args);
    let of = |(_, pattern, rules): crate::resilience::Run| Second { pattern: Some(pattern.text()), rules };
    match call {
        "governor.run" => {
            let trace = governor(&args)?;
            // The commands of the model are all of one frame.
            let is_known = items(args.get("steps")?)?.iter().all(|step| {
                step.get("command").is_none_or(|fields| fields.get("frame_id").and_then(Json::as_str) == Some("world"))
            });
            Some(Second { pattern: is_known.then(|| trace.pattern().text()), rules: trace.rules() })
        }
        "buffer.run" => {
            let strict = matches!(args.get("strict"), Some(Json::Bool(true)));
            Some(of(buffer(&plant(&args, from_frame)?, strict)))
        }
        "watchdog.run" => Some(of(watchdog(&plant(&args, from_fields)?))),
        _ => None,
    }
}

fn plant(args: &Json, command: fn(&Json) -> Option<Command>) -> Option<Vec<Event>> {
    let event = |step: &Json| {
        let now = || double(step.get("now_s")?);
        Some(match step.get("op")?.as_str()? {
            "command" => Event::Command(command(step)?, now()?),
            "active" | "should_hold" => Event::Ask(now()?),
            "reset" => Event::Reset,
            _ => return None,
        })
    };
    items(args.get("steps")?)?.iter().map(event).collect()
}

/// The command of a step of a watchdog, which says its seq and its ttl only.
fn from_fields(step: &Json) -> Option<Command> {
    let ttl = double(step.get("ttl_ms")?)?;
    Some(Command { seq: step.get("seq").and_then(integer), ttl, ..Command::of(Vec::new()) })
}

/// The command of a frame, if it has the members of one and nothing else, once each and of their types, and no more
/// bytes than a plant has to read.
fn from_frame(step: &Json) -> Option<Command> {
    let text = step.get("text")?.as_str().filter(|text| text.len() <= 1 << 20)?;
    let frame = Json::read(text);
    let Json::Object(members) = &frame else { return None };
    if repeats(&frame) {
        return None;
    }
    let known = |name: &str| {
        ["kind", "ncp_version", "seq", "t", "frame_id", "mode", "ttl_ms", "channels", "horizon", "horizon_dt_ms"]
            .contains(&name)
    };
    if !members.iter().all(|(name, _)| known(name)) || frame.get("kind")?.as_str()? != "command_frame" {
        return None;
    }
    let mode = frame.get("mode")?.as_str()?;
    let version = match frame.get("ncp_version") {
        Some(version) => Some(version.as_str()?.to_owned()),
        None => None,
    };
    frame.get("frame_id").map_or(Some(""), Json::as_str)?;
    frame.get("t").map_or(Some(0.0), spelled)?;
    let is_mode = ["init", "active", "hold", "estop"].contains(&mode);
    is_mode.then_some(())?;
    Some(Command { version, ..command(&frame, spelled)? })
}

/// Whether a member of it repeats, at any depth.
fn repeats(json: &Json) -> bool {
    match json {
        Json::Object(members) => {
            let names: BTreeSet<&str> = members.iter().map(|(name, _)| name.as_str()).collect();
            names.len() < members.len() || members.iter().any(|(_, value)| repeats(value))
        }
        Json::Array(items) => items.iter().any(repeats),
        _ => false,
    }
}

/// The command of these members.
fn command(fields: &Json, double: fn(&Json) -> Option<f64>) -> Option<Command> {
    let horizon = fields.get("horizon").map_or(Some(&[][..]), items)?;
    Some(Command {
        seq: Some(integer(fields.get("seq")?)?),
        t: fields.get("t").map_or(Some(0.0), double)?,
        mode: Some(fields.get("mode")?.as_str()?.to_owned()),
        ttl: double(fields.get("ttl_ms")?)?,
        horizon: horizon.iter().map(|tick| channels(tick, double)).collect::<Option<_>>()?,
        dt: match fields.get("horizon_dt_ms") {
            None | Some(Json::Null) => None,
            Some(dt) => Some(double(dt)?),
        },
        ..Command::of(channels(fields.get("channels")?, double)?)
    })
}

fn channels(tick: &Json, double: fn(&Json) -> Option<f64>) -> Option<Vec<Channel>> {
    let Json::Object(members) = tick else { return None };
    let channel = |(name, sample): &(String, Json)| {
        let data = items(sample.get("data")?)?.iter().map(double).collect::<Option<_>>()?;
        let unit = match sample.get("unit") {
            None | Some(Json::Null) => None,
            Some(unit) => Some(unit.as_str()?.to_owned()),
        };
        Some(Channel { name: name.clone(), data, unit })
    };
    members.iter().map(channel).collect()
}

fn governor(args: &Json) -> Option<Trace> {
    let limits = args.get("limits")?;
    let limit = |name: &str| match limits.get(name) {
        None | Some(Json::Null) => Some(None),
        Some(value) => double(value).map(Some),
    };
    let limits = Limits {
        speed: limit("max_speed_mps")?,
        fence: limit("geofence_radius_m")?,
        timeout: limit("command_timeout_ms")??,
        tilt: limit("max_tilt_rad")?,
    };
    let capabilities = match args.get("capabilities") {
        None | Some(Json::Null) => None,
        Some(declared) => Some(Capabilities {
            sensors: specs(declared.get("sensor_channels")?)?,
            commands: specs(declared.get("command_channels")?)?,
        }),
    };
    let steps = items(args.get("steps")?)?.iter().map(step).collect::<Option<_>>()?;
    Some(Trace { limits, capabilities, steps })
}

fn specs(list: &Json) -> Option<Vec<Spec>> {
    let spec = |spec: &Json| {
        let kind = spec.get("kind")?.as_str()?;
        Some(Spec {
            name: spec.get("name")?.as_str()?.to_owned(),
            kind: ["scalar", "vec3", "quat", "array"].into_iter().find(|known| *known == kind)?,
            unit: spec.get("unit").and_then(Json::as_str).map(str::to_owned),
            size: spec.get("size").and_then(integer),
            optional: spec.get("optional").map(|optional| *optional == Json::Bool(true)),
        })
    };
    items(list)?.iter().map(spec).collect()
}

fn step(step: &Json) -> Option<Step> {
    Some(match step.get("op")?.as_str()? {
        "note_link" => Step::Link(*step.get("burst")? == Json::Bool(true)),
        "reset" => Step::Reset,
        "govern" => {
            let last = match step.get("last_sensor_s")? {
                Json::Null => None,
                last => Some(double(last)?),
            };
            let sensor = match step.get("sensor")? {
                Json::Null => None,
                sensor => Some(Sensor {
                    seq: sensor.get("seq").and_then(integer).unwrap_or_default(),
                    t: double(sensor.get("t")?)?,
                    channels: channels(sensor.get("channels")?, double)?,
                }),
            };
            Step::Govern {
                command: command(step.get("command")?, double)?,
                now: double(step.get("now_s")?)?,
                sensor,
                last,
            }
        }
        _ => return None,
    })
}

fn items(json: &Json) -> Option<&[Json]> {
    match json {
        Json::Array(items) => Some(items),
        _ => None,
    }
}

/// An integer as a frame spells it, and no larger than one may be: a frame with another is rejected, and no model knows
/// what then becomes of the command before it.
fn integer(json: &Json) -> Option<i64> {
    const LARGEST: u64 = (1 << 53) - 1;
    let Json::Literal(spelled) = json else { return None };
    spelled.parse().ok().filter(|value: &i64| value.unsigned_abs() <= LARGEST && value.to_string() == *spelled)
}

/// A double as a frame spells it.
fn spelled(json: &Json) -> Option<f64> {
    match json {
        Json::Literal(spelled) => spelled.parse().ok().filter(|value: &f64| value.is_finite()),
        _ => None,
    }
}

/// A double as a call gives it: a number, or one of the four strings for those that JSON lacks or loses.
fn double(json: &Json) -> Option<f64> {
    match json.as_str() {
        Some("NaN") => Some(f64::NAN),
        Some("Infinity") => Some(f64::INFINITY),
        Some("-Infinity") => Some(f64::NEG_INFINITY),
        Some("-0") => Some(-0.0),
        Some(_) => None,
        None => spelled(json),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::json::object;

    #[test]
    fn the_models_say_of_a_written_trace_what_its_row_says() {
        let files = crate::on_disk::corpus();
        let mut asked = 0;
        for (_, text) in files.iter().filter(|(path, _)| ["safety/", "resilience/"].iter().any(|a| path.starts_with(a)))
        {
            let file = Json::read(text);
            for case in items(file.get("cases").unwrap()).unwrap() {
                let (call, args) = (case.get("call").unwrap().as_str().unwrap(), case.get("args").unwrap().text());
                if let Some(second) = second(call, &args) {
                    let Some(pattern) = second.pattern else { continue };
                    let steps = Json::read(&pattern);
                    let traces =
                        if steps.get("$any").is_some() { items(steps.get("$any").unwrap()).unwrap() } else { &[] };
                    let first = traces.first().unwrap_or(&steps);
                    assert_eq!(items(first.get("steps").unwrap()).unwrap().len(), second.rules.len());
                    asked += 1;
                }
            }
        }
        assert!(asked > 500, "{asked}");
    }

    #[test]
    fn the_model_says_nothing_of_a_frame_that_is_longer_than_a_plant_has_to_read() {
        let run = |bytes: usize| {
            let members = r#""kind":"command_frame","mode":"active","seq":1,"t":1.0,"frame_id":"w","ttl_ms":250.0"#;
            let frame = format!(r#"{{{members},"channels":{{}},"horizon":[]}}"#);
            let text = format!("{frame}{}", " ".repeat(bytes - frame.len()));
            let step = object! { "op" => "command", "text" => text, "now_s" => crate::trace::num(1.0) };
            let args = object! { "strict" => false, "steps" => Json::Array(vec![step]) };
            second("buffer.run", &args.text()).is_some()
        };
        assert!(run(1 << 20));
        assert!(!run((1 << 20) + 1));
    }
}
