//! What encoders write: order, defaults, nulls, numbers, enums, maps, strings.

use super::WRITE;
use super::numbers::of_every_size;
use super::place::{Ground, put};
use crate::case::Role::{self, Server};
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::model::{CONTRACT_HASH, WIRE_VERSION, explicit, explicit_message, full, meaning, minimal};
use crate::roles::{a, writers};
use crate::template::Text;
use crate::trace::num;
use ncp_text::tables::{Default, Message, Shape, Unknown, tables};

/// A file a kind.
pub(super) fn files() -> Vec<File> {
    let kinds = tables().messages.iter().filter_map(|message| Some((message.kind.as_deref()?, message)));
    kinds
        .map(|(kind, message)| {
            let encoder = Encoder { kind, message };
            let cases = if kind == "error" { error_frames() } else { encoder.cases() };
            let about = format!("What an encoder writes for {}.", a(kind).to_lowercase());
            File::new("wire", format!("encode_{kind}"), about, cases)
        })
        .collect()
}

struct Encoder {
    kind: &'static str,
    message: &'static Message,
}

impl Encoder {
    fn cases(&self) -> Vec<Case> {
        let mut cases = self.shapes();
        cases.extend(self.programs());
        cases.extend(self.leaves());
        cases.extend(self.special());
        cases.extend(self.zeros());
        cases.extend(self.refused_ids());
        cases.extend(self.large());
        cases.extend(self.wide());
        cases.extend(self.long());
        cases
    }

    /// Strings that are long in one way of counting and short of the limit in bytes of UTF-8, which is what a receiver
    /// counts.
    fn long(&self) -> Vec<Case> {
        let Some(field) = self.free_string() else { return Vec::new() };
        // What a program says, how it stands in a frame, how often, and what it is in words.
        let table = [
            ("two-bytes", "\u{e9}", "\u{e9}", 450_000, "characters of two bytes"),
            ("four-bytes", "\u{1f681}", "\u{1f681}", 250_000, "characters of four bytes"),
            ("quotes", "\"", "\\\"", 500_000, "quotes"),
            ("controls", "\u{1}", "\\u0001", 170_000, "control characters"),
        ];
        let of_kind = table.into_iter().filter(|(what, ..)| *what == "two-bytes" || self.kind == "sensor_frame");
        let case = |(what, said, written, times, says): (&str, &str, &str, usize, &str)| {
            let repeated = object! { "$repeat" => said, "times" => Json::literal(times.to_string()) };
            let frame = explicit(self.kind).with(field, LONG.into()).text();
            let (before, after) = frame.split_once(LONG).unwrap_or((&frame, ""));
            let text = Text::concat([before.into(), Text::repeat(written, times), after.into()]);
            self.case(&format!("long/{what}"), &["NCP-WIRE-093"])
                .title(format!("{} whose `{field}` is {times} {says} is written whole.", a(self.kind)))
                .flags(&["low-limits"])
                .encode(self.kind, self.fields(explicit(self.kind)).with(field, repeated))
                .means(text)
                .because("The frame is within 1 MiB, and an encoder writes every message that a receiver has to read.")
        };
        of_kind.map(case).collect()
    }

    /// Messages that are large and that every receiver has to read, however their numbers are spelled.
    fn large(&self) -> Vec<Case> {
        // A member, the values that lead there from it, what is repeated, how often, and what it is in words.
        let number = || Json::literal("0.125");
        let value = |name: &str| explicit_message(name);
        let data = |items: Json| object! { "a" => value("ChannelValue").with("data", items) };
        let values = |items: Json| object! { "a" => value("Observation").with("values", items) };
        let itself = |items: Json| items;
        let targets = |items: Json| object! { "targets" => items };
        let step = || object! { "a" => value("ChannelValue") };
        type Around<'a> = &'a dyn Fn(Json) -> Json;
        let table: [(&str, &str, Around<'_>, Json, usize, &str); 5] = [
            ("observation_frame", "records", &values, number(), 300_000, "numbers in a record"),
            ("sensor_frame", "channels", &data, number(), 30_000, "numbers in a channel"),
            ("command_frame", "horizon", &itself, step(), 4_096, "steps of a horizon"),
            ("open_session", "record", &targets, value("RecordTarget"), 2_000, "record targets"),
            ("capabilities", "sensor_channels", &itself, value("ChannelSpec"), 2_000, "channels"),
        ];
        let of_kind = table.into_iter().filter(|(kind, ..)| *kind == self.kind);
        of_kind
            .map(|(kind, member, around, item, times, says)| {
                let items = object! { "$item" => item.clone(), "times" => Json::literal(times.to_string()) };
                let ground = self.fields(explicit(kind));
                let frame = explicit(kind).with(member, around(Json::literal(LONG))).text();
                let (before, after) = frame.split_once(LONG).unwrap_or((&frame, ""));
                let item = item.text();
                let text = Text::concat([
                    format!("{before}[").into(),
                    Text::repeat(format!("{item},"), times - 1),
                    format!("{item}]{after}").into(),
                ]);
                self.case(&format!("large/{member}-{times}"), &[WRITE, "NCP-WIRE-081"])
                    .title(format!("{} with {times} {says} is written with all of them.", a(kind)))
                    .flags(&["low-limits"])
                    .encode(kind, ground.with(member, around(Json::Array(vec![items]))))
                    .means(text)
                    .because("An encoder writes every message that a receiver has to read.")
            })
            .collect()
    }

    /// Long arrays of which one item is of another size or spelling than all before it.
    fn wide(&self) -> Vec<Case> {
        if self.kind == "capabilities" {
            return vec![self.many_strings()];
        }
        if self.kind != "observation_frame" {
            return Vec::new();
        }
        let table = [
            ("senders-wide-last", "senders", "3", "1099511627776", "senders of which the last has more than 32 bits"),
            ("senders-least-last", "senders", "0", "-9007199254740991", "senders of which the last is the least"),
            ("values-tiny-last", "values", "0.125", "5e-324", "values of which the last is the least of all doubles"),
            (
                "times-huge-last",
                "times",
                "1.0",
                "1.7976931348623157e308",
                "times of which the last is the greatest double",
            ),
        ];
        let case = |(what, member, item, last, says): (&str, &str, &str, &str, &str)| {
            let times = 2_048;
            let around = |items: Json| object! { "a" => explicit_message("Observation").with(member, items) };
            let frame = explicit(self.kind).with("records", around(Json::literal(LONG))).text();
            let (before, after) = frame.split_once(LONG).unwrap_or((&frame, ""));
            let text = Text::concat([
                format!("{before}[").into(),
                Text::repeat(format!("{item},"), times),
                format!("{last}]{after}").into(),
            ]);
            let items = object! { "$item" => Json::literal(item), "times" => Json::literal(times.to_string()) };
            let items = Json::Array(vec![items, Json::literal(last)]);
            let rule = if member == "senders" { "NCP-WIRE-085" } else { "NCP-WIRE-084" };
            self.case(&format!("large/{what}"), &[rule, WRITE])
                .title(format!("{} with {} {says} is written with all of them.", a(self.kind), times + 1))
                .flags(&["low-limits"])
                .encode(self.kind, self.fields(explicit(self.kind)).with("records", around(items)))
                .means(text)
                .because("How one item of an array is written does not depend on another, nor on how many there are.")
        };
        let mut cases: Vec<Case> = table.map(case).into();
        cases.push(self.long_train());
        cases
    }

    /// As many spikes as fill more than 16 bits, and the pins behind them.
    fn long_train(&self) -> Case {
        let times = 70_000;
        let spike = object! { "times" => Json::literal(LONG), "senders" => Json::literal(SHORT) };
        let record = spike
            .members()
            .iter()
            .fold(explicit_message("Observation"), |record, (name, value)| record.with(name, value.clone()));
        let frame = explicit(self.kind).with("records", object! { "a" => record.clone() });
        let frame = meaning(self.kind, &frame).text();
        let (before, rest) = frame.split_once(LONG).unwrap_or((&frame, ""));
        let (between, after) = rest.split_once(SHORT).unwrap_or((rest, ""));
        let list = |item: &str| [Text::repeat(format!("{item},"), times - 1), item.into()];
        let parts = [vec![format!("{before}[").into()], list("0.5").into(), vec![format!("]{between}[").into()]];
        let text = Text::concat(
            parts.into_iter().flatten().chain(list("7")).chain([format!("]{after}").into()]).collect::<Vec<_>>(),
        );
        let items = |item: &str| {
            Json::Array(vec![object! { "$item" => Json::literal(item), "times" => Json::literal(times.to_string()) }])
        };
        let record = record.with("times", items("0.5")).with("senders", items("7"));
        let fields = self.fields(explicit(self.kind)).with("records", object! { "a" => record });
        self.case("large/spikes", &[WRITE, "NCP-WIRE-081", "NCP-PROV-007"])
            .by("/is_simulation_output", "NCP-PROV-007")
            .by("/calibrated_posterior", "NCP-PROV-007")
            .title(format!("{} with {times} spikes is written with all of them, and with its pins.", a(self.kind)))
            .flags(&["low-limits"])
            .encode(self.kind, fields)
            .writes(text)
            .by("order", "NCP-WIRE-080")
            .because("An encoder writes every field of every message, however long it is.")
    }

    /// More strings of an enum than a byte counts.
    fn many_strings(&self) -> Case {
        let kinds = || (0..300).map(|nth| object! { "kind" => format!("k{nth}") }).collect::<Json>();
        self.case("large/kinds-of-channels", &["NCP-WIRE-087", WRITE])
            .title("A `capabilities` frame with 300 channels of as many kinds is written with the kind of each.")
            .flags(&["lost-fields"])
            .encode(self.kind, self.fields(explicit(self.kind)).with("sensor_channels", kinds()))
            .shows(object! { "text" => object! { "$json" => object! { "sensor_channels" => kinds() } } })
            .because("A string of an enum is written as it is, however many others there are.")
    }

    /// Only what must be set, everything, everything but what is optional.
    fn shapes(&self) -> Vec<Case> {
        let mut cases = Vec::new();
        let required = self.fields(minimal(self.kind));
        // `mode` and `contract_hash` have cases of their own: what a program gets for them is not
        // in the tables.
        let required = self.with_program_defaults(required);
        let nulls = self.has_optional().then_some("NCP-WIRE-082");
        let rules = |first: &[&'static str]| first.iter().copied().chain(nulls).collect::<Vec<_>>();
        let explicit_fields = self.fields(explicit(self.kind));
        if explicit_fields != required {
            cases.push(
                self.writes("explicit", &rules(&["NCP-WIRE-081"]), &explicit_fields)
                    .title(format!("{} whose fields are set to their defaults has every one of them.", a(self.kind)))
                    .flags(&["omitted-fields"])
                    .because("Every field of the table is written, also one that has its default."),
            );
        }
        cases.push(
            self.writes("defaults", &rules(&["NCP-WIRE-090", "NCP-WIRE-081"]), &required)
                .title(format!(
                    "{} that a program builds from what it must name has every other field, at its default.",
                    a(self.kind)
                ))
                .flags(&["omitted-fields"])
                .because("Every field of the table is written, in its order, an unset optional one as null."),
        );
        cases.push(
            self.says("default-values", &["NCP-WIRE-090"], &required)
                .title(format!(
                    "{} that a program builds from what it must name means the defaults in every other field.",
                    a(self.kind)
                ))
                .flags(&["wrong-defaults"])
                .because("What a program does not name has the default of the table."),
        );
        let all = self.fields(full(self.kind));
        cases.push(
            self.writes("everything", &["NCP-WIRE-080", "NCP-WIRE-081"], &reversed(all.clone()))
                .title(format!(
                    "{} whose fields are all set, from the last to the first, is written in the order of the table.",
                    a(self.kind)
                ))
                .flags(&["field-order"])
                .because(
                    "The order is the table's, at every level, and not the one in which a program sets the fields.",
                ),
        );
        // A null `contract_hash` may be read as one that was not named, so it stays set.
        let unset = without_optional(self.message, all.clone(), true);
        if unset != all {
            cases.push(
                self.writes("optional-unset", &["NCP-WIRE-082"], &unset)
                    .title(format!(
                        "{} whose optional fields are unset, at every level, has a null for each.",
                        a(self.kind)
                    ))
                    .flags(&["omitted-nulls"])
                    .because("An unset optional field is written, as null."),
            );
        }
        cases.push(
            self.says("plain", &["NCP-WIRE-092", WRITE], &explicit_fields)
                .by("within", WRITE)
                .by("/ncp_version", "NCP-WIRE-090")
                .title(format!("{} of plain ASCII is written without a byte order mark before it.", a(self.kind)))
                .flags(&["byte-order-mark"])
                .because("An encoder writes UTF-8 without a byte order mark; with one, no receiver reads the frame."),
        );
        let control = "\"\\/\u{8}\u{c}\n\r\t\u{0}\u{1}\u{b}\u{f}\u{10}\u{1f}\u{7f}\u{80}\u{e9}\
                       \u{2028}\u{2029}\u{feff}\u{ffff}\u{1f681}";
        if let Some(field) = self.free_string() {
            cases.push(
                self.says(
                    "string",
                    &[WRITE, "NCP-WIRE-092"],
                    &self.fields(explicit(self.kind)).with(field, Json::string(control)),
                )
                .title(format!(
                    "{} whose `{field}` holds quotes, control characters and characters of every \
                                    width is written as JSON that says the same.",
                    a(self.kind)
                ))
                .flags(&["string-escapes"])
                .because(
                    "The field is written, in UTF-8, and JSON has an escape for what may not stand in a \
                              string.",
                ),
            );
            // Line ends of every sort, what only looks like an escape, white space at the ends, noncharacters.
            let odd = " a\r\nb\n\rc\r\r\nd\\r\\ne\\u000a\\\\f\"\\\"g\t\t\u{b}\u{85}h\u{fdd0}\u{fffe}\u{fffd}\
                       \u{1ffff}\u{10ffff} \r\n";
            cases.push(
                self.says(
                    "string-of-lines",
                    &[WRITE, "NCP-WIRE-092"],
                    &self.fields(explicit(self.kind)).with(field, Json::string(odd)),
                )
                .title(format!(
                    "{} whose `{field}` holds line ends, backslashes and noncharacters is written as JSON that says \
                     the same.",
                    a(self.kind)
                ))
                .flags(&["string-escapes"])
                .because("A string is written as it is: no character of it is left out, and none is another."),
            );
            let long = || Text::repeat("n", 65_537);
            let fields = self.fields(explicit(self.kind)).with(field, long().json());
            let frame = meaning(self.kind, &self.fields(explicit(self.kind)).with(field, LONG.into())).text();
            let (before, after) = frame.split_once(LONG).unwrap_or((&frame, ""));
            cases.push(
                self.case("long-string", &[WRITE, "NCP-WIRE-061"])
                    .title(format!(
                        "{} whose `{field}` has 65,537 characters is written with all of them.",
                        a(self.kind)
                    ))
                    .flags(&["low-limits"])
                    .encode(self.kind, fields)
                    .means(Text::concat([before.into(), long(), after.into()]))
                    .because("The field is written; nothing but the bytes of the frame limits a string."),
            );
            // Behind a letter or two, so that no border of a buffer is always one of a character.
            let wide = match self.kind {
                "sensor_frame" => WIDE,
                "command_frame" => &WIDE[..1],
                _ => &[],
            };
            for (name, character, times, says) in wide {
                let firsts = if self.kind == "sensor_frame" { &["n", "nn"][..] } else { &["n"] };
                for first in firsts.iter().copied() {
                    let long = || Text::concat([first.into(), Text::repeat(*character, *times)]);
                    let fields = self.fields(explicit(self.kind)).with(field, long().json());
                    cases.push(
                        self.case(&format!("long-string/{name}-behind-{}", first.len()), &[WRITE, "NCP-WIRE-092"])
                            .title(format!(
                                "{} whose `{field}` has `{first}` and {times} characters of {says} is written with all \
                                 of them.",
                                a(self.kind)
                            ))
                            .flags(&["string-escapes"])
                            .encode(self.kind, fields)
                            .means(Text::concat([before.into(), long(), after.into()]))
                            .because(
                                "A string is written as it is: no character of it is left out, and none is another.",
                            ),
                    );
                }
            }
        }
        cases
    }

    /// What a program gets that the tables do not give.
    fn programs(&self) -> Vec<Case> {
        let mut cases = Vec::new();
        if self.kind == "command_frame" {
            let fields = self.fields(explicit(self.kind)).without("mode");
            let expected = meaning(self.kind, &fields.clone().with("mode", "active".into()));
            cases.push(
                self.case("mode", &["NCP-WIRE-088"])
                    .title("A `command_frame` that a program builds without naming a mode is `active`.")
                    .flags(&["program-defaults"])
                    .encode(self.kind, fields)
                    .means(expected.text())
                    .because("A program that builds a command means it; only a receiver reads `hold` into silence."),
            );
        }
        if self.message.field("contract_hash").is_some() {
            let named = self.fields(explicit(self.kind));
            let fields = named.clone().without("contract_hash");
            let expected = meaning(self.kind, &named);
            cases.push(
                self.case("contract-hash", &["NCP-WIRE-089", "NCP-VER-020"])
                    .title(format!(
                        "{} that a program builds without naming a contract hash has that of its build.",
                        a(self.kind)
                    ))
                    .flags(&["program-defaults"])
                    .encode(self.kind, fields)
                    .means(expected.text())
                    .because(format!("A build of wire {WIRE_VERSION} has the contract hash of wire {WIRE_VERSION}.")),
            );
        }
        cases
    }

    /// Every number, integer, enum and map of the kind, wherever it stands.
    fn leaves(&self) -> Vec<Case> {
        let mut leaves = Vec::new();
        collect(self.message, &mut Vec::new(), &mut leaves);
        let integers: Vec<String> =
            leaves.iter().filter(|leaf| leaf.shape == Shape::Integer).map(Leaf::place).collect();
        leaves.iter().flat_map(|leaf| self.leaf(leaf, &integers)).collect()
    }

    /// The cases of a leaf; the integers of the kind are at these places.
    fn leaf(&self, leaf: &Leaf, integers: &[String]) -> Vec<Case> {
        // What is judged by its value stands among written-out defaults, so that the case does not
        // depend on what a peer fills in. What is judged by its spelling stands in a full message,
        // so that it does not depend on how a peer writes what is unset.
        let among_defaults =
            |value: Json| self.fields(put(self.message, explicit(self.kind), &leaf.path, value, Ground::Explicit));
        let in_full = |value: Json| {
            let path: Vec<&str> = leaf.path.iter().map(String::as_str).collect();
            self.fields(full(self.kind)).edit(&path, |_| value)
        };
        let name = leaf.name();
        let shown = leaf.shown();
        let roles = writers(self.kind);
        let mut cases = Vec::new();
        match &leaf.shape {
            Shape::Number => {
                for (what, value) in [("nan", "NaN"), ("infinity", "Infinity"), ("minus-infinity", "-Infinity")] {
                    cases.push(
                        Case::new(format!("{name}/{what}"), &["NCP-WIRE-086"], roles)
                            .title(format!("{} whose `{shown}` is {value} is refused.", a(self.kind)))
                            .flags(&["non-finite-numbers"])
                            .encode(self.kind, among_defaults(Json::string(value)))
                            .rejects("non_finite")
                            .because("JSON has no such number, and null would say something else."),
                    );
                }
                for (what, literal) in leaf.doubles() {
                    // "-0" is how the peer protocol names the negative zero.
                    let value = if *literal == "-0.0" { Json::string("-0") } else { Json::literal(*literal) };
                    let expected = meaning(self.kind, &among_defaults(Json::literal(*literal)));
                    cases.push(
                        Case::new(format!("{name}/{what}"), &["NCP-WIRE-084", "NCP-WIRE-015"], roles)
                            .title(format!(
                                "{} whose `{shown}` is {literal} is written so that it reads back.",
                                a(self.kind)
                            ))
                            .flags(&["lossy-doubles"])
                            .encode(self.kind, among_defaults(value))
                            .means(expected.text())
                            .because("Whatever the digits, the nearest double of them has the same bits."),
                    );
                }
                if let Some(("0", array)) = leaf.path.split_last().map(|(last, array)| (last.as_str(), array)) {
                    let largest = ["1.7976931348623157e308"; 2].map(Json::literal).into_iter().collect();
                    let fields = self.fields(put(self.message, explicit(self.kind), array, largest, Ground::Explicit));
                    let expected = meaning(self.kind, &fields);
                    cases.push(
                        Case::new(format!("{name}/two-largest"), &["NCP-WIRE-084", "NCP-WIRE-015"], roles)
                            .title(format!(
                                "{} with the largest double twice in `{}` is written so that it reads back.",
                                a(self.kind),
                                array.join(".")
                            ))
                            .flags(&["lossy-doubles"])
                            .by("refusal", "NCP-WIRE-093")
                            .encode(self.kind, fields)
                            .means(expected.text())
                            .because("Each number is finite, whatever their sum."),
                    );
                }
                let many = || of_every_size().into_iter().map(num);
                let all = leaf.path.split_last().and_then(|(last, within)| match last.as_str() {
                    "0" => Some((within, many().collect())),
                    "a" => {
                        let entries = (0..).map(|nth: usize| format!("k{nth}")).zip(many());
                        Some((within, Json::Object(entries.collect())))
                    }
                    _ => None,
                });
                if let Some((within, all)) = all {
                    let fields = self.fields(put(self.message, explicit(self.kind), within, all, Ground::Explicit));
                    let expected = meaning(self.kind, &fields);
                    cases.push(
                        Case::new(format!("{name}/of-every-size"), &["NCP-WIRE-084", "NCP-WIRE-015"], roles)
                            .title(format!(
                                "{} with 234 doubles of full precision in `{}`, of every size from a millionth to \
                                 10^13, is written so that they read back.",
                                a(self.kind),
                                within.join(".")
                            ))
                            .flags(&["lossy-doubles"])
                            .encode(self.kind, fields)
                            .means(expected.text())
                            .because("Whatever the digits, the nearest double of them has the same bits."),
                    );
                }
            }
            Shape::Integer => {
                for (what, literal) in
                    [("largest", "9007199254740991"), ("smallest", "-9007199254740991"), ("zero", "0")]
                {
                    let case = self.at(&name, what, &["NCP-WIRE-085"], &in_full(Json::literal(literal)));
                    let case = match what {
                        "zero" => integers.iter().fold(case.by("within", "NCP-WIRE-081"), Case::by_own),
                        _ => case,
                    };
                    cases.push(
                        case.title(format!("{} whose `{shown}` is {literal} has it as a plain integer.", a(self.kind)))
                            .flags(&["integer-spelling"])
                            .because("No string, no fraction, no exponent, and no digit lost."),
                    );
                }
                for (what, literal) in [("two-to-53", "9007199254740992"), ("minus-two-to-53", "-9007199254740992")] {
                    cases.push(
                        Case::new(format!("{name}/{what}"), &["NCP-WIRE-091"], roles)
                            .title(format!("{} whose `{shown}` is {literal} should be refused.", a(self.kind)))
                            .flags(&["integer-spelling"])
                            .encode(self.kind, in_full(Json::literal(literal)))
                            .rejects("value")
                            .because("No receiver would accept the frame."),
                    );
                }
            }
            Shape::Enum(enumeration) => {
                let strings = tables().enumeration(enumeration).map_or(&[][..], |known| &known.strings);
                for string in strings {
                    let fields = among_defaults(Json::string(string));
                    // What a program gets without naming it is in the case of the defaults.
                    if fields == self.fields(explicit(self.kind)) && enumeration != "Mode" {
                        continue;
                    }
                    cases.push(
                        self.says(&format!("{name}/{}", string.to_lowercase()), &["NCP-WIRE-087"], &fields)
                            .title(format!("{} whose `{shown}` is `{string}` has that wire string.", a(self.kind)))
                            .flags(&["enum-constants"])
                            .because(format!("`{string}` is a wire string of {enumeration}.")),
                    );
                }
                // What a receiver would not keep, no sender may send: it refuses, or writes a mode that moves nothing.
                let unknown = tables().enumeration(enumeration).map(|known| &known.unknown);
                let written = match unknown {
                    Some(Unknown::ReadsAs(other)) => vec![other.as_str()],
                    Some(Unknown::Rejected) => strings.iter().map(String::as_str).collect(),
                    _ => Vec::new(),
                };
                if !written.is_empty() {
                    let any = object! { "$any" => written.into_iter().collect::<Json>() };
                    let path: Vec<&str> = leaf.path.iter().map(String::as_str).collect();
                    let frame = path.iter().rev().fold(any, |inner, name| object! { *name => inner });
                    cases.push(
                        Case::new(format!("{name}/novel"), &["NCP-WIRE-087"], roles)
                            .title(format!(
                                "{} whose `{shown}` is set to `novel_value` is refused, or written with a wire string.",
                                a(self.kind)
                            ))
                            .flags(&["enum-constants"])
                            .encode(self.kind, among_defaults(Json::string("novel_value")))
                            .shows_or_refuses(object! { "text" => object! { "$json" => frame } })
                            .because(format!("`novel_value` is no wire string of {enumeration}.")),
                    );
                }
            }
            Shape::Map(value) => {
                let sample = leaf.sample.members().first().map(|(_, value)| value.clone()).unwrap_or(Json::Null);
                for (what, keys, says) in ORDERS {
                    let entries = keys.iter().map(|key| ((*key).to_owned(), sample.clone())).collect();
                    cases.push(
                        self.at(&name, &format!("order-of-{what}"), &["NCP-WIRE-083"], &in_full(Json::Object(entries)))
                            .title(format!(
                                "{} has the entries of `{shown}` sorted by the code points of their \
                                            keys: {says}.",
                                a(self.kind)
                            ))
                            .flags(&["map-order"])
                            .because(
                                "Code points decide: not the order of insertion, not UTF-16 units, not letter \
                                      case, not numbers.",
                            ),
                    );
                }
                // One map is enough.
                if name == "resolved" {
                    let entries = NULS.iter().map(|key| ((*key).to_owned(), sample.clone())).collect();
                    cases.push(
                        self.at(&name, "order-of-nuls", &["NCP-WIRE-083"], &in_full(Json::Object(entries)))
                            .title(format!(
                                "{} has the entries of `{shown}` sorted by the code points of their keys, also behind \
                                 U+0000.",
                                a(self.kind)
                            ))
                            .flags(&["map-order"])
                            .because("U+0000 is a code point like every other: it ends no key, and is less than each."),
                    );
                }
                if name == "resolved" || name == "channels" && self.kind == "sensor_frame" {
                    // Alike in just so many letters, and the later one first.
                    let lengths = [7, 8, 15, 16, 31, 32, 63, 64, 127, 128, 255, 256];
                    let keys = lengths.iter().rev().flat_map(|length| ["b", "a"].map(|end| "k".repeat(*length) + end));
                    let entries = keys.map(|key| (key, sample.clone())).collect();
                    cases.push(
                        self.at(&name, "order-of-alike", &["NCP-WIRE-083"], &in_full(Json::Object(entries)))
                            .title(format!(
                                "{} has the entries of `{shown}` sorted by the code points of their keys, of which \
                                 many agree in up to 256.",
                                a(self.kind)
                            ))
                            .flags(&["map-order"])
                            .because("Code points decide, also those far behind."),
                    );
                }
                let is_message = matches!(**value, Shape::Message(_));
                let most = many(self.kind);
                let entry = |nth: usize| {
                    let value = if is_message { Json::object() } else { sample.clone() };
                    (format!("{:x}", nth * STRIDE % most), value)
                };
                let entries = (0..most).map(entry).collect();
                // A tick of a horizon is a map of channels as well.
                let is_another = name == "horizon";
                cases.extend((!is_another).then(|| {
                    self.at(&name, "order-of-many", &["NCP-WIRE-083"], &in_full(Json::Object(entries)))
                        .title(format!(
                            "{} has the entries of `{shown}` sorted by the code points of their keys, also {most} of \
                             them.",
                            a(self.kind)
                        ))
                        .flags(&["map-order"])
                        .because("A map is sorted however many entries it has; a frame may have 4,096.")
                }));
                if is_message {
                    cases.push(
                        self.at(
                            &name,
                            "defaults-within",
                            &["NCP-WIRE-090", "NCP-WIRE-081", "NCP-WIRE-082"],
                            &in_full(object! { "a" => Json::object() }),
                        )
                        .title(format!(
                            "{} with an entry of `{shown}` of which nothing is set has every field of it.",
                            a(self.kind)
                        ))
                        .flags(&["omitted-fields"])
                        .because("The rules for encoders hold at every level."),
                    );
                }
            }
            _ => {}
        }
        cases
    }

    /// What concerns one kind alone.
    /// Channels whose data are the same to who compares them as numbers.
    fn zeros(&self) -> Option<Case> {
        let with = |minus: Json| self.fields(explicit(self.kind)).with("channels", zeros_of_both_signs(&minus));
        matches!(self.kind, "sensor_frame" | "command_frame").then(|| {
            self.case("zeros-of-both-signs", &["NCP-WIRE-084", "NCP-WIRE-015"])
                .title(format!(
                    "{} whose channels have zeros of both signs is written so that it reads back.",
                    a(self.kind)
                ))
                .flags(&["lossy-doubles"])
                .encode(self.kind, with(Json::string("-0")))
                .means(meaning(self.kind, &with(Json::literal("-0.0"))).text())
                .because("Whatever the digits, the nearest double of them has the same bits.")
        })
    }

    fn special(&self) -> Vec<Case> {
        let mut cases = Vec::new();
        match self.kind {
            "command_frame" => {
                let step = |x: &str| {
                    object! { "v" => object! { "data" =>
                    [x].into_iter().map(Json::literal).collect::<Json>(), "unit" => "m/s" } }
                };
                let steps = Json::Array(vec![step("1.0"), step("0.5"), Json::object()]);
                let fields = self
                    .fields(explicit(self.kind))
                    .with("horizon", steps)
                    .with("horizon_dt_ms", Json::literal("20.0"));
                cases.push(
                    self.says("horizon/plain-maps", &["NCP-WIRE-051"], &fields)
                        .title(
                            "A `command_frame` has its horizon as an array of plain channel maps, an empty one \
                                included.",
                        )
                        .flags(&["proto-json-names"])
                        .because("The member that wraps a map in the proto does not travel."),
                );
                let sample = || step("1.0").members().first().map_or(Json::Null, |(_, value)| value.clone());
                let of = |names: &str| Json::Object(names.chars().map(|name| (name.to_string(), sample())).collect());
                let fields = fields.with("horizon", ["b", "cab", "ba", "dabc", "", "ca"].map(of).into_iter().collect());
                cases.push(
                    self.writes("horizon/orders", &["NCP-WIRE-083"], &fields)
                        .title(
                            "A `command_frame` has the channels of each step of its horizon sorted by the code points \
                             of their names, though no two steps have the same channels.",
                        )
                        .flags(&["map-order"])
                        .because("Each step is a map of its own."),
                );
            }
            "observation_frame" => {
                cases.push(
                    self.writes(
                        "pins",
                        &["NCP-PROV-007", "NCP-PROV-008"],
                        &without_pins(self.fields(explicit(self.kind))),
                    )
                    .title("An `observation_frame` that a program builds carries both pins, at their values.")
                    .flags(&["unchecked-pins"])
                    .because("Both pins stand on every `observation_frame`."),
                );
                cases.extend(self.other_pins(&explicit(self.kind), &[]));
            }
            "session_opened" => {
                let provenance = without_pins(explicit_message("SimProvenance"));
                let fields = self.fields(explicit(self.kind)).with("provenance", provenance);
                cases.push(
                    self.writes("pins", &["NCP-PROV-007", "NCP-PROV-008"], &fields)
                        .title(
                            "A `session_opened` with a provenance of which no pin is set carries both pins, at \
                                their values.",
                        )
                        .flags(&["unchecked-pins"])
                        .because("Both pins stand in every `provenance`."),
                );
                let whole = explicit(self.kind).with("provenance", explicit_message("SimProvenance"));
                cases.extend(self.other_pins(&whole, &["provenance"]));
            }
            "open_session" => {
                let fields = self
                    .with_program_defaults(self.fields(minimal(self.kind)))
                    .with("record", object! { "targets" => Json::Array(vec![Json::object()]) })
                    .with("stimulus", object! { "targets" => Json::Array(vec![Json::object()]) })
                    .with("bindings", Json::Array(vec![Json::object(), object! { "entity" => Json::object() }]))
                    .with("sim", Json::object());
                cases.push(
                    self.writes("defaults-within", &["NCP-WIRE-090", "NCP-WIRE-081", "NCP-WIRE-082"], &fields)
                        .title(
                            "An `open_session` with targets, bindings and a configuration of which nothing is \
                                set has every field of them.",
                        )
                        .flags(&["omitted-fields"])
                        .because("The rules for encoders hold at every level."),
                );
            }
            "capabilities" => {
                let fields = self
                    .fields(minimal(self.kind))
                    .with("sensor_channels", Json::Array(vec![Json::object()]))
                    .with("safety", Json::object());
                cases.push(
                    self.writes("defaults-within", &["NCP-WIRE-090", "NCP-WIRE-081", "NCP-WIRE-082"], &fields)
                        .title(
                            "A `capabilities` frame with a channel and limits of which nothing is set has every \
                                field of them.",
                        )
                        .flags(&["omitted-fields"])
                        .because("The rules for encoders hold at every level."),
                );
            }
            _ => {}
        }
        cases
    }

    /// Pins that a program sets to another than their pinned value: the encoder refuses, or writes what is pinned.
    fn other_pins(&self, frame: &Json, within: &[&str]) -> Vec<Case> {
        const PINS: [(&str, bool); 2] = [("calibrated_posterior", false), ("is_simulation_output", true)];
        let member = |pin: &str| within.iter().copied().chain([pin]).collect::<Vec<_>>().join(".");
        let of = |name: &str, frame: &Json, set: &[(&str, bool)], words: String| {
            let fields = set.iter().fold(self.fields(frame.clone()), |fields, (pin, pinned)| {
                let path: Vec<&str> = within.iter().copied().chain([*pin]).collect();
                fields.edit(&path, |_| Json::Bool(!pinned))
            });
            let pins = Json::Object(PINS.map(|(pin, pinned)| (pin.to_owned(), Json::Bool(pinned))).into());
            let written = within.iter().rev().fold(pins, |inner, name| object! { *name => inner });
            self.case(&format!("pins/{name}"), &["NCP-PROV-008"])
                .title(format!("{} {words} is refused, or written with its pins at their values.", a(self.kind)))
                .flags(&["unchecked-pins"])
                .encode(self.kind, fields)
                .shows_or_refuses(object! { "text" => object! { "$json" => written } })
                .because("An encoder does not write a pin with another than its pinned value.")
        };
        let one = |(pin, pinned): (&str, bool)| {
            let words = format!("whose `{}` is set to {}", member(pin), !pinned);
            of(&format!("{pin}-flipped"), frame, &[(pin, pinned)], words)
        };
        let mut cases: Vec<Case> = PINS.map(one).into();
        let both = "whose pins are both set to what they are not";
        cases.push(of("both-flipped", frame, &PINS, both.to_owned()));
        // A `session_opened` of that kind is a refusal.
        let words = format!("{both}, and all other fields to another than their default,");
        cases.push(of("both-flipped-among-all", &full(self.kind), &PINS, words));
        cases
    }

    /// Session ids that no receiver would take.
    fn refused_ids(&self) -> Vec<Case> {
        let is_required = self.message.field("session_id").is_some_and(|field| field.default == Default::Required);
        if !is_required {
            return Vec::new();
        }
        [("empty", ""), ("slash", "a/b"), ("star", "*"), ("at", "@a")]
            .into_iter()
            .map(|(what, session)| {
                let fields = self.fields(minimal(self.kind)).with("session_id", session.into());
                self.case(&format!("session_id/{what}"), &["NCP-WIRE-091"])
                    .title(format!("{} of the session `{session}` should be refused.", a(self.kind)))
                    .flags(&["unchecked-session-id"])
                    .encode(self.kind, fields)
                    .rejects("value")
                    .because("No receiver would accept the frame.")
            })
            .collect()
    }

    fn at(&self, name: &str, what: &str, rules: &[&'static str], fields: &Json) -> Case {
        self.writes(&format!("{name}/{what}"), rules, fields)
    }

    fn writes(&self, what: &str, rules: &[&'static str], fields: &Json) -> Case {
        let case = self.case(what, rules).encode(self.kind, fields.clone()).writes(meaning(self.kind, fields).text());
        let case = case.by("extra", "NCP-WIRE-081");
        if rules.contains(&"NCP-WIRE-083") {
            return case;
        }
        let fields = meaning(self.kind, fields);
        let absent = fields.members().iter().filter(|(_, value)| *value == Json::Null);
        let case = case.by("/ncp_version", "NCP-WIRE-090").by("order", "NCP-WIRE-080");
        absent.fold(case, |case, (name, _)| case.by(format!("/{name}"), "NCP-WIRE-082"))
    }

    /// Judged by what it says, however it is spelled.
    fn says(&self, what: &str, rules: &[&'static str], fields: &Json) -> Case {
        self.case(what, rules).encode(self.kind, fields.clone()).means(meaning(self.kind, fields).text())
    }

    fn case(&self, what: &str, rules: &[&'static str]) -> Case {
        Case::new(what, rules, writers(self.kind))
    }

    fn fields(&self, frame: Json) -> Json {
        fields(self.message, frame)
    }

    fn with_program_defaults(&self, fields: Json) -> Json {
        let fields = match self.message.field("contract_hash") {
            Some(_) => fields.with("contract_hash", CONTRACT_HASH.into()),
            None => fields,
        };
        if self.kind == "command_frame" { fields.with("mode", "hold".into()) } else { fields }
    }

    fn has_optional(&self) -> bool {
        self.message.fields.iter().any(|field| field.optional && field.name != "contract_hash")
    }

    /// A string field whose value means nothing to the wire.
    fn free_string(&self) -> Option<&'static str> {
        const FREE: [&str; 5] = ["frame_id", "note", "backend", "controller_id", "error"];
        self.message.fields.iter().map(|field| field.name.as_str()).find(|name| FREE.contains(name))
    }
}

/// What `encode` takes: a frame without `kind`, also within its stimulus frame, and with the version left to the
/// implementation.
pub(super) fn fields(message: &Message, frame: Json) -> Json {
    let frame = frame.without("kind").without("ncp_version");
    if message.field("stimulus").is_some_and(|field| field.shape == Shape::Message("StimulusFrame".to_owned())) {
        return frame.edit(&["stimulus"], |stimulus| stimulus.without("kind").without("ncp_version"));
    }
    frame
}

/// Error frames, whose table has no defaults.
fn error_frames() -> Vec<Case> {
    let roles: &[Role] = &[Server];
    vec![
        Case::new("without-session", &["NCP-WIRE-102"], roles)
            .title("An error frame without a session has the members `kind` and `error`.")
            .flags(&["field-order"])
            .encode("error", object! { "error" => "no such session" })
            .means(object! { "kind" => "error", "error" => "no such session" }.text())
            .because("No other member than `session_id` may stand beside them."),
        Case::new("with-session", &["NCP-WIRE-102"], roles)
            .title("An error frame of a session has the members `kind`, `error` and `session_id`.")
            .flags(&["field-order"])
            .encode("error", object! { "error" => "no such model", "session_id" => "s1" })
            .writes(object! { "kind" => "error", "error" => "no such model", "session_id" => "s1" }.text())
            .by("order", "NCP-WIRE-080")
            .because("The members of the table, and no others."),
        Case::new("with-empty-session", &[WRITE, "NCP-WIRE-102"], roles)
            .title("An error frame whose `session_id` is the empty string has it.")
            .flags(&["lost-fields"])
            .encode("error", object! { "error" => "no such model", "session_id" => "" })
            .means(object! { "kind" => "error", "error" => "no such model", "session_id" => "" }.text())
            .because("The empty string is a value, and no absence of one."),
        Case::new("string", &[WRITE, "NCP-WIRE-102"], roles)
            .title("An error frame whose text holds quotes and control characters is JSON that says the same.")
            .flags(&["string-escapes"])
            .encode("error", object! { "error" => "\"\\\n\0\u{1f}\u{e9}\u{1f681}" })
            .means(object! { "kind" => "error", "error" => "\"\\\n\0\u{1f}\u{e9}\u{1f681}" }.text())
            .because("JSON has an escape for what may not stand in a string."),
        Case::new("long-string", &[WRITE, "NCP-WIRE-102"], roles)
            .title("An error frame whose text has 40,000 characters of four bytes is written with all of them.")
            .flags(&["string-escapes"])
            .encode("error", object! { "error" => Text::concat(["n".into(), Text::repeat("\u{1f600}", 40_000)]) })
            .means(Text::concat([
                "{\"kind\":\"error\",\"error\":\"n".into(),
                Text::repeat("\u{1f600}", 40_000),
                "\"}".into(),
            ]))
            .because("A string is written as it is: no character of it is left out, and none is another."),
    ]
}

/// A value of a kind that is probed by itself.
struct Leaf {
    /// Members, indices and map keys that lead to it in a full frame.
    path: Vec<String>,
    shape: Shape,
    /// What stands there in a full frame.
    sample: Json,
}

impl Leaf {
    /// Where it stands in a full frame, as a JSON pointer.
    fn place(&self) -> String {
        format!("/{}", self.path.join("/"))
    }

    /// The part of a case's id.
    fn name(&self) -> String {
        let parts = self.path.iter().map(String::as_str).filter(|part| !matches!(*part, "0" | "a"));
        parts.collect::<Vec<_>>().join("/")
    }

    /// Doubles to write: all of them within channel data, two elsewhere.
    fn doubles(&self) -> &'static [(&'static str, &'static str)] {
        if self.path.iter().any(|part| part == "data") { DOUBLES } else { &DOUBLES[..2] }
    }

    fn shown(&self) -> String {
        let mut out = String::new();
        for part in &self.path {
            match part.as_str() {
                "0" => out.push_str("[0]"),
                part => {
                    out.push_str(if out.is_empty() { "" } else { "." });
                    out.push_str(part);
                }
            }
        }
        out
    }
}

/// Every number, integer, enum and map below a message, as a full frame has them.
/// Channels of one zero and of two, in each order of their signs.
pub(super) fn zeros_of_both_signs(minus: &Json) -> Json {
    let plus = Json::literal("0.0");
    let channel = |data: &[&Json]| object! { "data" => data.iter().copied().cloned().collect::<Json>() };
    object! {
        "a" => channel(&[&plus]), "b" => channel(&[minus]), "c" => channel(&[&plus]), "d" => channel(&[&plus, minus]),
        "e" => channel(&[minus, &plus]), "f" => channel(&[minus, minus]), "g" => channel(&[&plus, &plus]),
    }
}

fn collect(message: &Message, path: &mut Vec<String>, leaves: &mut Vec<Leaf>) {
    for field in &message.fields {
        if matches!(field.default, Default::Kind) {
            continue;
        }
        path.push(field.name.clone());
        collect_shape(&field.shape, &crate::model::sample(message, field), path, leaves);
        path.pop();
    }
}

fn collect_shape(shape: &Shape, sample: &Json, path: &mut Vec<String>, leaves: &mut Vec<Leaf>) {
    match shape {
        Shape::Number | Shape::Integer | Shape::Enum(_) | Shape::Map(_) => {
            leaves.push(Leaf { path: path.clone(), shape: shape.clone(), sample: sample.clone() });
        }
        Shape::Message(name) => {
            if let Some(message) = tables().message(name) {
                collect(message, path, leaves);
            }
        }
        _ => {}
    }
    let (step, inner, within) = match (shape, sample) {
        (Shape::List(inner), Json::Array(items)) => ("0", inner, items.first()),
        (Shape::Map(inner), sample) => ("a", inner, sample.get("a")),
        _ => return,
    };
    path.push(step.to_owned());
    collect_shape(inner, within.unwrap_or(&Json::Null), path, leaves);
    path.pop();
}

/// The message with its pins left out.
fn without_pins(message: Json) -> Json {
    message.without("calibrated_posterior").without("is_simulation_output")
}

/// The members of an object from the last to the first, at every level.
pub(super) fn reversed(value: Json) -> Json {
    match value {
        Json::Object(members) => {
            Json::Object(members.into_iter().rev().map(|(name, value)| (name, reversed(value))).collect())
        }
        Json::Array(items) => items.into_iter().map(reversed).collect(),
        scalar => scalar,
    }
}

/// The message with its optional fields left out, at every level.
fn without_optional(message: &Message, object: Json, is_frame: bool) -> Json {
    message.fields.iter().fold(object, |object, field| {
        if field.optional && !(is_frame && field.name == "contract_hash") {
            return object.without(&field.name);
        }
        object.edit(&[&field.name], |value| without_optional_in(&field.shape, value))
    })
}

fn without_optional_in(shape: &Shape, value: Json) -> Json {
    match (shape, value) {
        (Shape::Message(name), value) => match tables().message(name) {
            Some(message) => without_optional(message, value, false),
            None => value,
        },
        (Shape::List(item), Json::Array(items)) => {
            items.into_iter().map(|value| without_optional_in(item, value)).collect()
        }
        (Shape::Map(inner), Json::Object(members)) => {
            let members = members.into_iter().map(|(key, value)| (key, without_optional_in(inner, value)));
            Json::Object(members.collect())
        }
        (_, value) => value,
    }
}

/// Doubles that a careless writer changes.
const DOUBLES: &[(&str, &str)] = &[
    ("negative-zero", "-0.0"),
    ("seventeen-digits", "0.30000000000000004"),
    ("smallest", "5e-324"),
    ("largest-subnormal", "2.225073858507201e-308"),
    ("largest", "1.7976931348623157e308"),
    ("ten-to-23", "1e23"),
    ("two-to-53", "9007199254740992.0"),
    ("a-third", "0.3333333333333333"),
    ("beside-a-thousandth", "1234.5670000000002"),
];

/// Characters of several bytes, and so many of them that no usual buffer holds them.
const WIDE: &[(&str, &str, usize, &str)] =
    &[("pairs", "\u{1f600}", 40_000, "four bytes"), ("three-bytes", "\u{20ac}", 40_000, "three bytes")];

/// Stands for a string that is written as a template.
const LONG: &str = "%LONG%";

/// Stands for another one.
const SHORT: &str = "%SHORT%";

/// How many entries a large map of that kind has: as many as it may have where an entry is small, and fewer elsewhere,
/// since they have to be written out.
fn many(kind: &str) -> usize {
    match kind {
        "session_opened" => 4096,
        "open_session" => 129,
        "command_frame" => 257,
        _ => 65,
    }
}

/// In what order a program inserts the entries of a large map: every so many. It has no divisor in common with any of
/// the numbers above.
const STRIDE: usize = 1877;

/// Keys of a map as a program inserts them, and what the case shows.
const ORDERS: &[(&str, &[&str], &str)] = &[
    ("letters", &["b", "a", "B", "_"], "capitals before `_` before small letters"),
    ("astral", &["\u{1f600}", "\u{ff5e}", "z"], "U+FF5E before U+1F600"),
    ("digits", &["9", "10", "1", "2"], "`10` before `2`"),
    ("escapes", &["a]", "aB", "a\"", "a\n", "a\\"], "a line feed, a quote, `B`, a backslash, a bracket"),
];

/// Keys of a map with U+0000 in them, as a program inserts them.
const NULS: [&str; 7] = ["a\0b", "a\u{1}", "a", "a\0", "\0", "a\0\0", "a\0a"];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_command_frame_has_its_numbers_integers_enums_and_maps_probed() {
        let mut leaves = Vec::new();
        collect(tables().kind("command_frame").unwrap(), &mut Vec::new(), &mut leaves);
        let shown: Vec<_> = leaves.iter().map(Leaf::shown).collect();
        assert_eq!(
            shown,
            [
                "seq",
                "t",
                "mode",
                "ttl_ms",
                "channels",
                "channels.a.data[0]",
                "horizon[0]",
                "horizon[0].a.data[0]",
                "horizon_dt_ms"
            ]
        );
    }
}
