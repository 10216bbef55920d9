//! Every spelling of a number, in fields that between them every role reads.

use super::place::Place;
use super::{fields, numbers};
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::model::{explicit, explicit_message, minimal};
use crate::roles::{a, readers};
use crate::template::Text;
use crate::trace::num;

pub(super) fn file() -> File {
    let mut cases = Vec::new();
    for (kind, message, member, field) in FIELDS {
        let nested = Place::nested().into_iter();
        let place = Place::frames()
            .chain(nested)
            .find(|place| place.kind == *kind && place.message.name == *message && place.member(field) == *member);
        if let Some(place) = place {
            let under = |mut case: Case| {
                if !place.is_nested() {
                    case.path = format!("{kind}/{}", case.path);
                }
                case
            };
            cases.extend(fields::spellings(&place, field).into_iter().map(under));
        }
    }
    cases.extend(beside_white_space());
    cases.extend(beside_its_like());
    cases.extend(late_items());
    cases.extend(equal_items());
    cases.extend(long_spellings());
    cases.extend([15, 16, 17, 19].map(of_every_power));
    cases.push(of_every_length());
    let about = "Numbers in every spelling: rounding, subnormals, signed zeros, overflow, and integers that are none.";
    File::new("wire", "numbers", about, cases)
}

/// A negative zero beside each kind of white space: no integer, and a number with its sign.
fn beside_white_space() -> Vec<Case> {
    let spaces = [("space", " "), ("tab", "\t"), ("line-feed", "\n"), ("carriage-return", "\r"), ("lines", "\r\n\t ")];
    let case = |(side, (name, space)): (&str, (&str, &str))| {
        let spelled = |member: &str, value: &str| {
            let frame = minimal(SENSOR).text();
            let (front, back) = if side == "behind" { (space, "") } else { ("", space) };
            format!("{},\"{member}\":{front}{value}{back}}}", frame.strip_suffix('}').unwrap_or(&frame))
        };
        let shown = name.replace('-', " ");
        let integer = Case::new(format!("{SENSOR}/{side}/{name}/integer"), &["NCP-WIRE-010"], readers(SENSOR))
            .title(format!("A `{SENSOR}` whose `seq` is -0 {side} a {shown} is rejected."))
            .flags(&["lenient-integers"])
            .decode(SENSOR, spelled("seq", "-0"))
            .rejects("type")
            .because("It is not spelled `0` or `-?[1-9][0-9]*`, whatever stands beside it.");
        let number = |field: &str, value: &str, is: Json| {
            let path = if field == "t" { "number" } else { "item" };
            Case::new(format!("{SENSOR}/{side}/{name}/{path}"), &["NCP-WIRE-015", "NCP-WIRE-012"], readers(SENSOR))
                .title(format!("A `{SENSOR}` whose `{field}` has -0 {side} a {shown} is read as the negative zero."))
                .flags(&["signed-zero"])
                .decode(SENSOR, spelled(field, value))
                .means(explicit(SENSOR).with(field, is).text())
                .because("A number is the nearest double, its sign included, whatever stands beside it.")
        };
        let item = match side {
            "behind" => format!("{{\"a\":{{\"data\":[1,{space}-0]}}}}"),
            _ => format!("{{\"a\":{{\"data\":[-0{space},1]}}}}"),
        };
        let data = if side == "behind" { "[1.0,-0.0]" } else { "[-0.0,1.0]" };
        let channel = explicit_message("ChannelValue").with("data", Json::literal(data));
        let channels = Json::object().and("a", channel);
        [integer, number("t", "-0", Json::literal("-0.0")), number("channels", &item, channels)]
    };
    ["behind", "before"].into_iter().flat_map(|side| spaces.map(|space| (side, space))).flat_map(case).collect()
}

/// Two channels that are equal but for the sign of a zero.
fn beside_its_like() -> [Case; 2] {
    [("positive-first", "[0.0,1.0]", "[-0.0,1.0]"), ("negative-first", "[-0.0,1.0]", "[0.0,1.0]")].map(
        |(name, first, second)| {
            let channel = |data| explicit_message("ChannelValue").with("data", Json::literal(data));
            let channels = Json::object().and("a", channel(first)).and("b", channel(second));
            let frame = minimal(SENSOR).text();
            let front = frame.strip_suffix('}').unwrap_or(&frame);
            let text = format!("{front},\"channels\":{{\"a\":{{\"data\":{first}}},\"b\":{{\"data\":{second}}}}}}}");
            Case::new(format!("{SENSOR}/beside-its-like/{name}"), &["NCP-WIRE-015"], readers(SENSOR))
                .title("Of two channels that are equal but for the sign of a zero each keeps its own.")
                .flags(&["signed-zero"])
                .decode(SENSOR, text)
                .means(explicit(SENSOR).with("channels", channels).text())
                .because("The two zeros are equal as numbers, and not as what was sent.")
        },
    )
}

/// A bad item behind many good ones: every item of an array has its type.
fn late_items() -> Vec<Case> {
    let numbers = [
        ("boolean", "true", "NCP-WIRE-020", "type"),
        ("string", "\"1\"", "NCP-WIRE-020", "type"),
        ("null", "null", "NCP-WIRE-021", "type"),
        ("infinite", "1e309", "NCP-WIRE-013", "malformed"),
    ];
    let integers = [
        ("boolean", "true", "NCP-WIRE-020", "type"),
        ("fraction", "1.0", "NCP-WIRE-010", "type"),
        ("negative-zero", "-0", "NCP-WIRE-010", "type"),
        ("too-large", "9007199254740992", "NCP-WIRE-011", "value"),
    ];
    let fields = [
        (SENSOR, "channels.a.data", r#"{"kind":"sensor_frame","channels":{"a":{"data":["#, "]}}}", "0.5", numbers),
        (
            "open_session",
            "record.targets[0].ids",
            r#"{"kind":"open_session","session_id":"s1","network":{},"record":{"targets":[{"ids":["#,
            "]}]}}",
            "1",
            integers,
        ),
    ];
    let mut cases = Vec::new();
    for (kind, member, before, after, good, bad) in fields {
        for count in [1_400, 70_000] {
            for (name, item, rule, code) in bad {
                let text = Text::concat([
                    before.into(),
                    Text::repeat(format!("{good},"), count),
                    format!("{item}{after}").into(),
                ]);
                cases.push(
                    Case::new(format!("{kind}/late/{name}-behind-{count}"), &[rule, "NCP-WIRE-050"], readers(kind))
                        .title(format!(
                            "{} whose `{member}` has {item} behind {count} good items is rejected.",
                            a(kind)
                        ))
                        .flags(&["unchecked-types"])
                        .decode(kind, text)
                        .rejects(code)
                        .because("The rules of fields hold for every item of an array, the last as the first."),
                );
            }
        }
    }
    cases
}

/// Items side by side that some languages hold for equal: each is read by itself.
fn equal_items() -> Vec<Case> {
    let step = |item: &str| format!(r#"{{"a":{{"data":[{item}]}}}}"#);
    let horizon = |items: &[&str]| {
        let steps: Vec<String> = items.iter().map(|item| step(item)).collect();
        format!(r#"{{"kind":"command_frame","horizon_dt_ms":10.0,"horizon":[{}]}}"#, steps.join(","))
    };
    let data =
        |items: &[&str]| format!(r#"{{"kind":"command_frame","channels":{{"a":{{"data":[{}]}}}}}}"#, items.join(","));
    let targets = |items: &[&str]| {
        let targets: Vec<String> = items.iter().map(|item| format!(r#"{{"port":"p","ids":[{item}]}}"#)).collect();
        let targets = targets.join(",");
        format!(r#"{{"kind":"open_session","session_id":"s1","network":{{}},"record":{{"targets":[{targets}]}}}}"#)
    };
    let command = "command_frame";
    let rejected = [
        ("step-of-true", command, horizon(&["1", "true"]), "NCP-WIRE-020"),
        ("step-of-false", command, horizon(&["0.0", "false"]), "NCP-WIRE-020"),
        ("step-of-a-string", command, horizon(&["1", "\"1\""]), "NCP-WIRE-020"),
        ("item-true", command, data(&["1", "1.0", "true"]), "NCP-WIRE-020"),
        ("item-false", command, data(&["0", "-0.0", "false"]), "NCP-WIRE-020"),
        ("id-with-a-point", "open_session", targets(&["1", "1.0"]), "NCP-WIRE-010"),
        ("id-true", "open_session", targets(&["1", "true"]), "NCP-WIRE-020"),
        ("id-negative-zero", "open_session", targets(&["0", "-0"]), "NCP-WIRE-010"),
    ];
    let mut cases: Vec<Case> = rejected
        .into_iter()
        .map(|(name, kind, text, rule)| {
            Case::new(format!("{kind}/equal/{name}"), &[rule, "NCP-WIRE-050"], readers(kind))
                .title(format!(
                    "{} with an item of another type behind one of equal value is rejected ({name}).",
                    a(kind)
                ))
                .flags(&["unchecked-types"])
                .decode(kind, text)
                .rejects("type")
                .because("Each item is read by the rules of its field; what another is makes it no better.")
        })
        .collect();
    let zero = |sign: &str| format!(r#"{{"a":{{"data":[{sign}0.0],"unit":"m"}}}}"#);
    let steps = Json::read(&format!("[{},{},{}]", zero(""), zero("-"), zero("")));
    let items = Json::read(r#"{"a":{"data":[0.0,-0.0,0.0],"unit":"m"}}"#);
    for (name, member, value) in [("steps", "horizon", steps), ("items", "channels", items)] {
        let text = explicit(command).with("horizon_dt_ms", Json::literal("10.0")).with(member, value).text();
        cases.push(
            Case::new(format!("{command}/equal/signed-{name}"), &["NCP-WIRE-015"], readers(command))
                .title(format!("A `{command}` with zeros of both signs side by side keeps each ({name})."))
                .flags(&["signed-zero"])
                .decode(command, text.clone())
                .means(text)
                .because("A double survives decoding and encoding bit for bit, the sign of a zero included."),
        );
    }
    cases
}

/// Numbers of thousands of characters, as templates: what is written before them, what is repeated, and what is written
/// behind them.
fn long_spellings() -> Vec<Case> {
    let read = [
        ("halfway-and-a-bit", "9007199254740993.", "1", "9007199254740994.0"),
        ("halfway", "9007199254740993.", "0", "9007199254740992.0"),
        ("exponent", "1e", "1", "10.0"),
        ("exponent-negative", "5E-", "1", "0.5"),
    ];
    let rejected = [
        ("overflow-by-zeros", "1", "0", ""),
        ("overflow-by-zeros-negative", "-1", "0", ""),
        ("overflow-by-exponent", "1e", "0", "309"),
    ];
    // The number stands in the place of the mark.
    let frames = |ground: fn(&str) -> Json| {
        let number = || Json::literal(MARK);
        let channel = match ground(SENSOR).get("t") {
            Some(_) => explicit_message("ChannelValue"),
            None => Json::object(),
        };
        let channel = channel.with("data", Json::Array(vec![number()]));
        [
            ("t", ground(SENSOR).with("t", number())),
            ("data", ground(SENSOR).with("channels", object! { "a" => channel })),
        ]
    };
    let spell = |frame: &Json, before: &str, repeated: &str, times: usize, behind: &str| {
        let frame = frame.text();
        let (front, back) = frame.split_once(MARK).unwrap_or((&frame, ""));
        Text::concat([
            format!("{front}{before}").into(),
            Text::repeat(repeated, times),
            format!("{behind}{back}").into(),
        ])
    };
    let mut cases = Vec::new();
    for times in [1_500, 5_000, 70_000] {
        // A length for the one field, and others for the other.
        let fields = |ground| frames(ground).into_iter().filter(|(field, _)| (*field == "t") != (times == 5_000));
        for (field, frame) in fields(explicit) {
            for (name, before, last, is) in
                read.into_iter().filter(|(name, ..)| field == "t" || !name.contains("negative"))
            {
                cases.push(
                    Case::new(format!("{SENSOR}/long/{field}/{name}-of-{times}"), &["NCP-WIRE-012"], readers(SENSOR))
                        .title(format!(
                            "A `{SENSOR}` whose `{field}` is {before} with {times} zeros and {last} behind is {is}."
                        ))
                        .flags(&["many-digits"])
                        .decode(SENSOR, spell(&frame, before, "0", times, last))
                        .means(frame.text().replace(MARK, is))
                        .because("A number is the nearest double, ties to even, however many digits it has."),
                );
            }
        }
        for (field, frame) in fields(minimal).filter(|_| times > 1_500) {
            for (name, before, repeated, behind) in rejected.into_iter().take(if field == "t" { 3 } else { 1 }) {
                cases.push(
                    Case::new(format!("{SENSOR}/long/{field}/{name}-of-{times}"), &["NCP-WIRE-013"], readers(SENSOR))
                        .title(format!(
                            "A `{SENSOR}` whose `{field}` is {before} and {times} times {repeated}{} is rejected.",
                            if behind.is_empty() { String::new() } else { format!(" and {behind}") }
                        ))
                        .flags(&["overflow"])
                        .decode(SENSOR, spell(&frame, before, repeated, times, behind))
                        .rejects("malformed")
                        .because("The nearest double of these digits is infinite, however many there are."),
                );
            }
        }
    }
    for (kind, times) in [(SENSOR, 5_000)] {
        let frame = minimal(kind).with("seq", Json::literal(MARK));
        for (name, before) in [("positive", "1"), ("negative", "-9")] {
            cases.push(
                Case::new(format!("{kind}/long/seq/{name}-of-{times}"), &["NCP-WIRE-011"], readers(kind))
                    .title(format!("{} whose `seq` is {before} and {times} zeros is rejected.", a(kind)))
                    .flags(&["integer-precision"])
                    .decode(kind, spell(&frame, before, "0", times, ""))
                    .rejects("value")
                    .because("It lies beyond 9007199254740991 either way."),
            );
        }
        let ignored = minimal(kind).and("novel", Json::literal(MARK));
        cases.push(
            Case::new(format!("{kind}/long/unknown/overflow-of-{times}"), &["NCP-WIRE-014"], readers(kind))
                .title(format!("{} with an unknown member of 1 and {times} zeros should be rejected.", a(kind)))
                .flags(&["overflow"])
                .decode(kind, spell(&ignored, "1", "0", times, ""))
                .rejects("malformed")
                .because("The nearest double is infinite, also where nobody looks."),
        );
    }
    cases
}

/// Numbers of so many digits with every fourth power of ten, of which most come out as a neighbour where the digits
/// are read as a double and then multiplied or divided by that of the power.
fn of_every_power(digits: u32) -> Case {
    let mut state = u64::from(digits);
    let least = 10_u64.pow(digits - 1);
    let mut number_of = |power: i32| {
        // Knuth's multiplier; the high bits are the good ones.
        let candidates = std::iter::repeat_with(|| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            least + (state >> 1) % (9 * least)
        });
        let written = |digits: u64| format!("{digits}e{power}");
        let is_changed = |digits: &u64| {
            let by = (0..power.unsigned_abs()).fold(1.0, |power, _| power * 10.0);
            let twice = if power < 0 { *digits as f64 / by } else { *digits as f64 * by };
            written(*digits).parse() != Ok(twice)
        };
        let mut candidates = candidates.take(60).peekable();
        let first = candidates.peek().copied().unwrap_or(least);
        written(candidates.find(is_changed).unwrap_or(first))
    };
    let first = i32::try_from(digits % 4).unwrap_or_default() - 300;
    let spelled: Vec<String> = (first..=285).step_by(4).map(&mut number_of).collect();
    let nearest = spelled.iter().filter_map(|spelled| spelled.parse().ok());
    Case::new(format!("{SENSOR}/of-every-power/{digits}-digits"), &["NCP-WIRE-012"], readers(SENSOR))
        .title(format!(
            "Numbers of {digits} digits with powers of ten from -300 to 285 are read as the doubles nearest to them."
        ))
        .flags(&["rounding"])
        .decode(SENSOR, with_data(spelled.iter().map(|spelled| Json::literal(spelled.as_str())).collect()).text())
        .means(with_data(nearest.map(num).collect()).text())
        .because("A number is the nearest double, and is rounded once, whatever its digits and its power.")
}

/// A number of each length with each exponent at which a reader is tempted to round twice.
fn of_every_length() -> Case {
    let all = numbers::of_every_length();
    let count = all.len();
    let (spelled, nearest): (Vec<Json>, Vec<Json>) =
        all.into_iter().map(|(spelled, nearest)| (Json::literal(spelled), num(nearest))).unzip();
    Case::new(format!("{SENSOR}/of-every-length"), &["NCP-WIRE-012"], readers(SENSOR))
        .title(format!("{count} numbers of 1 to 18 digits and an exponent are read as the doubles nearest to them."))
        .flags(&["rounding"])
        .decode(SENSOR, with_data(spelled).text())
        .means(with_data(nearest).text())
        .because("A number is the nearest double, and is rounded once, whatever its digits and its power.")
}

/// A sensor frame with a channel of that data.
fn with_data(numbers: Vec<Json>) -> Json {
    let channel = explicit_message("ChannelValue").with("data", Json::Array(numbers));
    explicit(SENSOR).with("channels", object! { "a" => channel })
}

/// Stands for a number that is written as a template.
const MARK: &str = "%NUMBER%";

const SENSOR: &str = "sensor_frame";

/// Kind, message, the member as a reader finds it, and the field's own name.
const FIELDS: &[(&str, &str, &str, &str)] = &[
    ("sensor_frame", "ChannelValue", "channels.a.data", "data"),
    ("command_frame", "CommandFrame", "ttl_ms", "ttl_ms"),
    ("run_request", "RunRequest", "duration_ms", "duration_ms"),
    ("sensor_frame", "SensorFrame", "seq", "seq"),
    ("command_frame", "CommandFrame", "seq", "seq"),
    ("open_session", "SimConfig", "sim.seed", "seed"),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_listed_field_is_found() {
        let cases = file().cases;
        for (kind, _, _, field) in FIELDS {
            let is_here = |case: &&Case| case.path.starts_with(kind) && case.path.split('/').any(|part| part == *field);
            assert!(cases.iter().any(|case| is_here(&case)), "{kind} {field}");
        }
    }
}
