//! Every field of every message: absent, null, of each type, at its bounds.

use super::place::{Ground, Place};
use super::{READ, numbers};
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::model::{self, default_of, is_pin};
use crate::roles::{a, readers};
use crate::scenario::full_width;
use crate::template::Text;
use ncp_text::tables::{Default, Enum, Field, Shape, Unknown, tables};

/// A file for each kind and for each message that stands within others.
pub(super) fn files() -> Vec<File> {
    let frames = Place::frames().map(|place| {
        let kind = place.kind;
        let about = format!("The fields of `{kind}`, one by one.");
        File::new("wire", kind, about, cases_at(&place))
    });
    let nested = tables().messages.iter().filter(|message| message.kind.is_none()).map(|message| {
        let cases = Place::nested().into_iter().filter(|place| place.message == message && !place.is_twin());
        let about = format!("The fields of `{}`, wherever it stands within a frame.", message.name);
        File::new("wire", snake(&message.name), about, cases.flat_map(|p| cases_at(&p)).collect())
    });
    frames.chain(nested).collect()
}

/// The file that the cases of a message at a place are in.
pub(super) fn file_of(place: &Place) -> String {
    match (place.is_nested(), &place.message.kind) {
        (false, _) => place.kind.to_owned(),
        (true, Some(_)) => "stimulus_in_request".to_owned(),
        (true, None) => snake(&place.message.name),
    }
}

/// The cases of one message at one place.
pub(super) fn cases_at(place: &Place) -> Vec<Case> {
    // What a stimulus frame takes from its request has its own file.
    let in_request = place.is_nested() && place.message.kind.is_some();
    let mut cases = Vec::new();
    if !in_request {
        cases.push(whole(place, Ground::Minimal));
        // A message whose defaults are those of the frame around it says nothing that the frame
        // does not say by itself.
        let around = Place::frames().chain(Place::nested()).filter(|other| other.surrounds(place));
        let adds = around.into_iter().all(|other| explicit_at(&other) != explicit_at(place));
        if place.kind != "error" && adds {
            cases.push(whole(place, Ground::Explicit));
        }
    }
    for field in &place.message.fields {
        let probe = Probe { place, field };
        let is_inherited = in_request && matches!(field.name.as_str(), "ncp_version" | "kind" | "session_id");
        if !is_pin(&field.name) && !is_inherited {
            cases.extend(probe.cases());
        }
    }
    cases
}

/// The cases of one number or integer field alone, with every spelling.
pub(super) fn spellings(place: &Place, field: &str) -> Vec<Case> {
    let Some(field) = place.message.field(field) else {
        return Vec::new();
    };
    let probe = Probe { place, field };
    match probe.scalar() {
        Shape::Number => probe.doubles(numbers::more_doubles(), numbers::more_infinite()),
        Shape::Integer => probe.integers(true),
        _ => Vec::new(),
    }
}

/// `CommandFrame` as `command_frame`.
fn snake(name: &str) -> String {
    let mut out = String::new();
    for (nth, c) in name.char_indices() {
        if nth > 0 && c.is_ascii_uppercase() {
            out.push('_');
        }
        out.push(c.to_ascii_lowercase());
    }
    out
}

/// A frame whose message writes out its defaults.
fn explicit_at(place: &Place) -> Json {
    place.frame(Ground::Explicit, place.alone(Ground::Explicit))
}

/// The message that says nothing, and the one that says all that it need not.
fn whole(place: &Place, ground: Ground) -> Case {
    let message = place.alone(ground);
    // On explicit ground the frame around the message says all, so only the message is probed.
    let frame = match ground {
        Ground::Minimal if place.is_nested() => place.frame(Ground::Explicit, message),
        _ => place.frame(ground, message),
    };
    let name = &place.message.name;
    let (what, title, why) = match ground {
        Ground::Minimal => (
            "minimal",
            "that says only what it must is read with its defaults",
            format!("Each field of the table of {name} that is absent is read as its default."),
        ),
        Ground::Explicit => (
            "explicit",
            "that writes out its defaults, and leaves out what is optional, is read as it says",
            format!("Each field has the type that the table of {name} gives, or is optional and absent."),
        ),
    };
    let title = if place.is_nested() {
        let member = place.member("");
        format!("{} at `{member}` of a `{}` {title}.", a(name), place.kind)
    } else {
        format!("{} {title}.", a(name))
    };
    let rules: &[_] = match (ground, place.is_nested()) {
        (Ground::Minimal, false) if place.kind == "error" => &["NCP-WIRE-100"],
        (Ground::Minimal, false) => &["NCP-WIRE-023"],
        (Ground::Minimal, true) => &["NCP-WIRE-023", "NCP-WIRE-050"],
        (Ground::Explicit, false) => &[READ],
        (Ground::Explicit, true) => &[READ, "NCP-WIRE-050"],
    };
    Case::new(format!("{}{what}", place.label()), rules, readers(place.kind))
        .title(title)
        .flags(&[if ground == Ground::Minimal { "wrong-defaults" } else { "over-strict" }])
        .decode(place.kind, frame.text())
        .means(place.meaning(&frame))
        .because(why)
}

/// A field of a message at a place.
struct Probe<'a> {
    place: &'a Place,
    field: &'a Field,
}

impl Probe<'_> {
    fn cases(&self) -> Vec<Case> {
        let mut cases = vec![self.null()];
        // What is optional is left out of every explicit message anyway. The hash is not: there
        // absence means something. A message without its only field is the minimal one.
        let without = self.place.alone(Ground::Explicit).without(&self.field.name);
        let is_minimal = self.place.is_nested() && without == self.place.alone(Ground::Minimal);
        if (!self.field.optional || self.field.name == "contract_hash") && !is_minimal {
            cases.push(self.absent());
        }
        // A kind and a session are there anyway, and every string of an enum has its own case.
        let is_known = matches!(self.field.name.as_str(), "kind" | "session_id")
            && matches!(self.field.default, Default::Kind | Default::Required);
        if !is_known && !matches!(self.field.shape, Shape::Enum(_)) {
            cases.push(self.value());
        }
        cases.extend(self.wrong_types());
        cases.extend(self.wrong_elements());
        match self.scalar() {
            Shape::Number => {
                cases.extend(self.doubles(numbers::few_doubles(), numbers::few_infinite()));
            }
            Shape::Integer => cases.extend(self.integers(false)),
            Shape::Enum(name) => {
                if let Some(known) = tables().enumeration(name) {
                    cases.extend(self.strings(known));
                }
            }
            _ => {}
        }
        cases
    }

    fn absent(&self) -> Case {
        let Field { name, default, .. } = self.field;
        let error_text = self.is_error_text();
        let rejected = |rule, code: &str| {
            let message = self.place.alone(Ground::Minimal).without(name);
            let frame = self.place.frame(Ground::Minimal, message);
            self.case("absent", &[rule])
                .title(format!("{} without `{}` is rejected.", a(self.place.kind), self.member()))
                .flags(&["unchecked-required"])
                .decode(self.place.kind, frame.text())
                .rejects(code)
                .because(format!("{} demands `{name}`.", self.table()))
        };
        match default {
            Default::Kind => rejected("NCP-WIRE-028", "kind"),
            Default::Required if error_text => rejected("NCP-WIRE-101", "missing"),
            Default::Required => rejected("NCP-WIRE-027", "missing"),
            _ => {
                let (rule, flag) = match (self.place.kind, name.as_str()) {
                    ("command_frame", "mode") => ("NCP-WIRE-024", "absent-mode-moves"),
                    (_, "contract_hash") => ("NCP-WIRE-025", "filled-in-contract-hash"),
                    ("error", _) => ("NCP-WIRE-100", "over-strict"),
                    (_, "ncp_version") => ("NCP-WIRE-032", "over-strict"),
                    _ => ("NCP-WIRE-023", "wrong-defaults"),
                };
                let frame = self.frame(Ground::Explicit, None);
                let rules: &[_] = match rule {
                    "NCP-WIRE-032" => &[rule, "NCP-WIRE-033"],
                    rule => &[rule],
                };
                self.case("absent", rules)
                    .title(format!("{} without `{}` is read with its default.", a(self.place.kind), self.member()))
                    .flags(&[flag])
                    .decode(self.place.kind, frame.text())
                    .means(self.place.meaning(&frame))
                    .because(match rule {
                        "NCP-WIRE-024" => "A receiver that finds no mode must not move.".to_owned(),
                        "NCP-WIRE-025" => {
                            "A hash that the sender left out says `not advertised`; one's own would say `match`."
                                .to_owned()
                        }
                        _ => format!("{} gives the default.", self.table()),
                    })
            }
        }
    }

    fn null(&self) -> Case {
        let member = self.member();
        let kind = self.place.kind;
        if self.field.optional {
            let frame = self.frame(Ground::Explicit, Some(Json::Null));
            let rules: &[_] = if kind == "error" { &["NCP-WIRE-022", "NCP-WIRE-100"] } else { &["NCP-WIRE-022"] };
            return self
                .case("null", rules)
                .title(format!("{} whose `{member}` is null is read as one without it.", a(kind)))
                .flags(&["null-optional"])
                .decode(kind, frame.text())
                .means(self.place.meaning(&frame))
                .because(format!("{} gives a type that ends in `|null`.", self.table()));
        }
        let rules: &[_] = if self.is_error_text() { &["NCP-WIRE-101", "NCP-WIRE-021"] } else { &["NCP-WIRE-021"] };
        self.case("null", rules)
            .title(format!("{} whose `{member}` is null is rejected.", a(kind)))
            .flags(&["null-as-default"])
            .decode(kind, self.frame(Ground::Minimal, Some(Json::Null)).text())
            .rejects("type")
            .because(format!("{} gives a type without `|null`, so null is no way to leave it out.", self.table()))
    }

    fn value(&self) -> Case {
        let value = model::sample(self.place.message, self.field);
        if self.field.name == "ncp_version" {
            return self
                .accept("value", READ, value, "lost-fields", "is set")
                .or_rejects()
                .title(format!(
                    "{} whose `{}` is set is rejected, or read as it says.",
                    a(self.place.kind),
                    self.member()
                ))
                .because("A decoder may judge the version, but not change it.");
        }
        let rule = match (&self.field.shape, self.field.name.as_str()) {
            (Shape::Number, _) => "NCP-WIRE-012",
            (Shape::Enum(_), _) => "NCP-WIRE-040",
            (Shape::Message(_), _) => "NCP-WIRE-050",
            (Shape::List(item), _) if matches!(**item, Shape::Number | Shape::Integer) => "NCP-WIRE-069",
            (Shape::List(_) | Shape::Map(_), _) => "NCP-WIRE-068",
            _ => READ,
        };
        self.accept("value", rule, value, "lost-fields", "is set")
            .because(format!("The value has the type that {} gives.", self.table_within()))
    }

    /// Each JSON type that the field does not have.
    fn wrong_types(&self) -> Vec<Case> {
        let name = &self.field.name;
        let one = Json::literal("1");
        let text = match &self.field.shape {
            Shape::Boolean => {
                Json::string(if default_of(self.field) == Some(Json::Bool(true)) { "true" } else { "false" })
            }
            Shape::Integer | Shape::Number => Json::string("1"),
            _ => Json::string("x"),
        };
        let list = match &self.field.shape {
            Shape::Integer | Shape::Number => Json::Array(vec![one.clone()]),
            _ => Json::Array(Vec::new()),
        };
        let shape = &self.field.shape;
        let textual = matches!(shape, Shape::String | Shape::Enum(_));
        let numeric = matches!(shape, Shape::Integer | Shape::Number);
        let flag = match shape {
            Shape::Integer | Shape::Number => "stringly-numbers",
            Shape::Boolean => "truthy-booleans",
            Shape::Enum(_) => "enum-constants",
            Shape::Message(_) => "positional-structs",
            _ => "unchecked-types",
        };
        let table = [
            ("string", text, textual),
            ("number", one, numeric),
            ("boolean", Json::Bool(true), *shape == Shape::Boolean),
            ("array", list, matches!(shape, Shape::List(_))),
            ("object", Json::object(), matches!(shape, Shape::Map(_) | Shape::Message(_))),
        ];
        let wrong = table.into_iter().filter(|(.., fits)| !fits);
        wrong
            .map(|(what, value, _)| {
                let rules: &[_] =
                    if self.is_error_text() { &["NCP-WIRE-101", "NCP-WIRE-020"] } else { &["NCP-WIRE-020"] };
                let article = if what.starts_with(['a', 'o']) { "an" } else { "a" };
                self.case(&format!("wrong-type-{what}"), rules)
                    .title(format!("{} whose `{}` is {article} {what} is rejected.", a(self.place.kind), self.member()))
                    .flags(&[flag])
                    .decode(self.place.kind, self.frame(Ground::Minimal, Some(value)).text())
                    .rejects("type")
                    .because(format!("{} gives `{name}` the type {}.", self.table(), spell(shape)))
            })
            .collect()
    }

    /// Each JSON type that a list's items or a map's values do not have.
    fn wrong_elements(&self) -> Vec<Case> {
        let (Shape::List(element) | Shape::Map(element)) = &self.field.shape else {
            return Vec::new();
        };
        let textual = matches!(**element, Shape::String);
        let numeric = matches!(**element, Shape::Number | Shape::Integer);
        let table = [
            ("null", Json::Null, false),
            ("string", Json::string("1"), textual),
            ("number", Json::literal("1"), numeric),
            ("boolean", Json::Bool(true), false),
            ("array", Json::Array(if numeric { vec![Json::literal("1")] } else { Vec::new() }), false),
            ("object", Json::object(), matches!(**element, Shape::Message(_) | Shape::Map(_))),
        ];
        let flag = match **element {
            Shape::Message(_) => "positional-structs",
            _ if numeric => "stringly-numbers",
            _ => "unchecked-types",
        };
        let wrong = table.into_iter().filter(|(.., fits)| !fits);
        wrong
            .map(|(what, value, _)| {
                let (rule, flag) = match what {
                    "null" => ("NCP-WIRE-021", "null-as-default"),
                    _ => ("NCP-WIRE-020", flag),
                };
                let value = within(&self.field.shape, value);
                let rules = [rule, "NCP-WIRE-050"];
                let article = match what {
                    "null" => "",
                    "array" | "object" => "an ",
                    _ => "a ",
                };
                self.case(&format!("element-{what}"), &rules)
                    .title(format!(
                        "{} whose `{}` holds {article}{what} is rejected.",
                        a(self.place.kind),
                        self.member()
                    ))
                    .flags(&[flag])
                    .decode(self.place.kind, self.frame(Ground::Minimal, Some(value)).text())
                    .rejects("type")
                    .because(format!(
                        "What it holds has the type {}, and the rules of fields hold for it too.",
                        spell(element)
                    ))
            })
            .collect()
    }

    fn doubles(&self, spellings: Vec<numbers::Double>, infinite: Vec<(&'static str, String)>) -> Vec<Case> {
        let mut cases: Vec<Case> = spellings
            .into_iter()
            .map(|double| {
                let value = within(&self.field.shape, Json::literal(&double.literal));
                let frame = self.frame(Ground::Explicit, Some(value));
                let is = self.frame(Ground::Explicit, Some(within(&self.field.shape, Json::literal(double.is))));
                let case = self.case(&format!("double-{}", double.name), &[double.rule]);
                let path = case.path.strip_suffix(&format!("/double-{}", double.name)).unwrap_or_default();
                let (kind, path) = (self.place.kind, path.rsplit_once(self.place.kind).map_or(path, |(_, path)| path));
                let written = format!("wire/encode_{kind}/{}/seventeen-digits", path.trim_start_matches('/'));
                // The answer is a frame that the peer writes: it shows what was read if all digits are written.
                let case = match double.is_long() {
                    true => case.rests_on(written),
                    false => case,
                };
                case.title(format!(
                    "{} whose `{}` is spelled {} is read as {}.",
                    a(self.place.kind),
                    self.member(),
                    shorten(&double.literal),
                    double.is
                ))
                .flags(&[double.flag])
                .decode(self.place.kind, Text::folded(&frame.text()))
                .means(self.place.meaning(&is))
                .because("A number is the nearest double, ties to even, whatever its spelling.")
            })
            .collect();
        cases.extend(infinite.into_iter().map(|(name, digits)| {
            let value = within(&self.field.shape, Json::literal(&digits));
            self.case(&format!("double-{name}"), &["NCP-WIRE-013"])
                .title(format!("{} whose `{}` is {} is rejected.", a(self.place.kind), self.member(), shorten(&digits)))
                .flags(&["overflow"])
                .decode(self.place.kind, Text::folded(&self.frame(Ground::Minimal, Some(value)).text()))
                .rejects("malformed")
                .because("The nearest double of these digits is infinite.")
        }));
        cases
    }

    fn integers(&self, more: bool) -> Vec<Case> {
        let spread = |few: &'static [numbers::Integer], rest: &'static [numbers::Integer]| {
            if more { rest.iter() } else { few.iter() }
        };
        let mut cases = Vec::new();
        for (name, digits) in spread(&numbers::INTEGERS, &numbers::MORE_INTEGERS) {
            let value = within(&self.field.shape, Json::literal(*digits));
            if default_of(self.field).as_ref() == Some(&value) {
                continue;
            }
            let flag = if name.ends_with("est") { "integer-precision" } else { "lost-fields" };
            cases.push(
                self.accept(&format!("integer-{name}"), READ, value, flag, &format!("is {digits}"))
                    .because("It is spelled as an integer and lies within the bound."),
            );
        }
        let misspelled = spread(&numbers::MISSPELLED, &numbers::MORE_MISSPELLED);
        let beyond = spread(&numbers::BEYOND, &numbers::MORE_BEYOND);
        let wrong = misspelled
            .map(|integer| {
                (integer, "NCP-WIRE-010", "type", "lenient-integers", "It is not spelled `0` or `-?[1-9][0-9]*`.")
            })
            .chain(beyond.map(|integer| {
                (integer, "NCP-WIRE-011", "value", "integer-precision", "It lies beyond 9007199254740991 either way.")
            }));
        for ((name, digits), rule, code, flag, why) in wrong {
            let value = within(&self.field.shape, Json::literal(*digits));
            cases.push(
                self.case(&format!("integer-{name}"), &[rule])
                    .title(format!("{} whose `{}` is {digits} is rejected.", a(self.place.kind), self.member()))
                    .flags(&[flag])
                    .decode(self.place.kind, self.frame(Ground::Minimal, Some(value)).text())
                    .rejects(code)
                    .because(why),
            );
        }
        cases
    }

    /// Every wire string of an enum, and strings that are none.
    fn strings(&self, known: &Enum) -> Vec<Case> {
        // The default is what every explicit frame has; of a mode it is worth a case.
        let is_default = |string: &str| default_of(self.field) == Some(Json::string(string));
        let other = |string: &&String| known.name == "Mode" || !is_default(string);
        let mut cases: Vec<Case> = known
            .strings
            .iter()
            .filter(other)
            .map(|string| {
                let says = format!("is `{string}`");
                self.accept(
                    &format!("enum-{}", string.to_lowercase()),
                    "NCP-WIRE-040",
                    Json::string(string),
                    "enum-constants",
                    &says,
                )
                .because(format!("`{string}` stands in the row of {} in section 1.4.", known.name))
            })
            .collect();
        // Near misses of `active` are the ones that matter: they must not move a plant.
        let is_active = |string: &&String| *string == "active";
        let first = known.strings.iter().find(is_active).or(known.strings.first());
        let first = first.cloned().unwrap_or_default();
        let other_case = if known.name == "Observable" { "v_m".to_owned() } else { capital(&first) };
        let strings = [
            ("novel", "novel_value".to_owned()),
            // Each constant of the proto is its wire string in capitals.
            ("constant", first.to_uppercase()),
            ("other-case", other_case),
            ("space", format!("{first} ")),
            ("space-before", format!(" {first}")),
            ("line-feed", format!("{first}\n")),
            ("nul", format!("{first}\0")),
            ("empty", String::new()),
            ("full-width", full_width(&first)),
            ("soft-hyphen", first.replacen('t', "\u{ad}t", 1)),
            ("sentinel", "unknown".to_owned()),
        ];
        // A mode moves a plant, so it gets all of them.
        let kept = known.unknown == Unknown::Kept;
        let few = ["novel", "constant", "space", "line-feed", "sentinel"];
        for (what, string) in strings.into_iter().filter(|(what, _)| !kept || few.contains(what)) {
            let value = Json::string(&string);
            let says = match string.as_str() {
                "" => "is the empty string".to_owned(),
                // A line feed and U+0000 are shown as their escapes.
                string => {
                    format!("is `{}`, which is no wire string,", string.replace('\n', "\\n").replace('\0', "\\0"))
                }
            };
            let id = format!("unknown-{what}");
            cases.push(match &known.unknown {
                Unknown::Kept => self
                    .accept_as(
                        &id,
                        &["NCP-WIRE-043", "NCP-WIRE-042", "NCP-WIRE-045"],
                        value.clone(),
                        "invented-sentinel",
                        &says,
                        "keeps it",
                    )
                    .because(format!("{} is descriptive: what it does not list is kept as it is.", known.name)),
                Unknown::ReadsAs(other) => self
                    .accept_as(
                        &id,
                        &["NCP-WIRE-041"],
                        value.clone(),
                        "unknown-mode-moves",
                        &says,
                        &format!("reads as `{other}`"),
                    )
                    .because("Only the exact letters are a mode, and a mode that is none must not move anything."),
                Unknown::Rejected => self
                    .case(&id, &["NCP-WIRE-044"])
                    .title(format!("{} whose `{}` {says} is rejected.", a(self.place.kind), self.member()))
                    .flags(&["lenient-sim-mode"])
                    .decode(self.place.kind, self.frame(Ground::Minimal, Some(value.clone())).text())
                    .rejects("value")
                    .because(format!("{} has no reading for another string.", known.name)),
            });
            if kept && what == "novel" {
                let frame = self.frame(Ground::Explicit, Some(value));
                cases.push(
                    self.case("unknown-accepted", &["NCP-WIRE-042"])
                        .title(format!(
                            "{} whose `{}` {says} is not rejected for it.",
                            a(self.place.kind),
                            self.member()
                        ))
                        .flags(&["closed-enums"])
                        .decode(self.place.kind, frame.text())
                        .accepts()
                        .because(format!("{} is descriptive, so a later value must not cost the frame.", known.name)),
                );
            }
        }
        cases
    }

    /// A case with the field at that value, read as the text says.
    fn accept(&self, what: &str, rule: &'static str, value: Json, flag: &'static str, says: &str) -> Case {
        self.accept_as(what, &[rule], value, flag, says, "is read as it says")
    }

    fn accept_as(
        &self,
        what: &str,
        rules: &[&'static str],
        value: Json,
        flag: &'static str,
        says: &str,
        reads: &str,
    ) -> Case {
        let frame = self.frame(Ground::Explicit, Some(value));
        self.case(what, rules)
            .title(format!("{} whose `{}` {says} {reads}.", a(self.place.kind), self.member()))
            .flags(&[flag])
            .decode(self.place.kind, frame.text())
            .means(self.place.meaning(&frame))
    }

    fn case(&self, what: &str, rules: &[&'static str]) -> Case {
        let mut rules = rules.to_vec();
        if self.place.is_nested() && !rules.contains(&"NCP-WIRE-050") {
            rules.push("NCP-WIRE-050");
        }
        let path = format!("{}{}/{what}", self.place.label(), self.field.name);
        Case::new(path, &rules, readers(self.place.kind))
    }

    /// A frame with the field at that value, or without it.
    fn frame(&self, ground: Ground, value: Option<Json>) -> Json {
        let message = self.place.alone(ground);
        let name = &self.field.name;
        self.place.frame(
            ground,
            match value {
                Some(value) => message.with(name, value),
                None => message.without(name),
            },
        )
    }

    fn member(&self) -> String {
        self.place.member(&self.field.name)
    }

    fn table(&self) -> String {
        if self.place.kind == "error" {
            return "The table of the RPC error frame".to_owned();
        }
        format!("The table of {}", self.place.message.name)
    }

    fn table_within(&self) -> String {
        self.table().replacen("The", "the", 1)
    }

    fn is_error_text(&self) -> bool {
        self.place.kind == "error" && self.field.name == "error"
    }

    /// The shape of the field, or of what it holds.
    fn scalar(&self) -> &Shape {
        match &self.field.shape {
            Shape::List(element) | Shape::Map(element) => element,
            shape => shape,
        }
    }
}

/// The value itself, or a list or map that holds it alone.
fn within(shape: &Shape, value: Json) -> Json {
    match shape {
        Shape::List(_) => Json::Array(vec![value]),
        Shape::Map(_) => object! { "a" => value },
        _ => value,
    }
}

/// A type as the tables spell it.
fn spell(shape: &Shape) -> String {
    match shape {
        Shape::String => "string".to_owned(),
        Shape::Boolean => "boolean".to_owned(),
        Shape::Integer => "integer".to_owned(),
        Shape::Number => "number".to_owned(),
        Shape::Enum(name) | Shape::Message(name) => name.clone(),
        Shape::List(item) => format!("[{}]", spell(item)),
        Shape::Map(value) => format!("{{string: {}}}", spell(value)),
    }
}

fn capital(string: &str) -> String {
    let mut chars = string.chars();
    chars.next().map_or_else(String::new, |c| c.to_uppercase().chain(chars).collect())
}

/// Long digits as a reader wants them in a title.
fn shorten(digits: &str) -> String {
    const SHOWN: usize = 40;
    if digits.len() <= SHOWN {
        return digits.to_owned();
    }
    format!("{}\u{2026} ({} characters)", &digits[..16], digits.len())
}
