//! A case and a file of cases, as they are written.

use std::collections::BTreeMap;

use crate::flags;
use crate::json::{Json, object};
use crate::runs;
use crate::template::Text;

/// A part that a peer plays; a case is asked of the peers that claim one of its roles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Role {
    /// Opens sessions, reads sensors, sends commands.
    Commander,
    /// Sends sensors, obeys commands.
    Body,
    /// Answers control RPC.
    Server,
    /// Reads.
    Observer,
}

impl Role {
    /// All four.
    pub(crate) const ALL: [Self; 4] = [Self::Commander, Self::Body, Self::Server, Self::Observer];

    /// By the name that the files write.
    pub(crate) fn parse(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|role| role.as_str() == name)
    }

    /// As the files write it.
    pub(crate) const fn as_str(self) -> &'static str {
        match self {
            Self::Commander => "commander",
            Self::Body => "body",
            Self::Server => "server",
            Self::Observer => "observer",
        }
    }
}

/// The rules by which something moves, as long as nothing keeps it from doing so.
const MOVES: [&str; 4] = ["NCP-SAFE-021", "NCP-RES-003", "NCP-RES-013", "NCP-RES-026"];

/// What a case may need that not every peer of a role has.
pub(crate) const REFERENCE_NETWORKS: &str = "reference_networks";

/// One question to a peer, with the answer that the text demands.
#[derive(Debug, Clone)]
pub(crate) struct Case {
    /// What follows `area/name/` in the id.
    pub(crate) path: String,
    pub(crate) title: String,
    pub(crate) requirements: Vec<&'static str>,
    pub(crate) flags: Vec<&'static str>,
    pub(crate) roles: Vec<Role>,
    pub(crate) needs: Option<&'static str>,
    pub(crate) call: &'static str,
    pub(crate) args: Json,
    pub(crate) expect: Json,
    /// By which rules parts of the answer are judged that another than the first decides: by JSON pointer, or for a
    /// `crash` or a `refusal`.
    pub(crate) by: BTreeMap<String, &'static str>,
    /// The ids of cases without which this one shows nothing of its own rule.
    pub(crate) rests_on: Vec<String>,
    pub(crate) why: String,
}

impl Case {
    /// A case that still lacks its question and its answer. `rules[0]` is the one that decides.
    pub(crate) fn new(path: impl Into<String>, rules: &[&'static str], roles: &[Role]) -> Self {
        let mut roles = roles.to_vec();
        roles.sort_unstable();
        roles.dedup();
        Self {
            path: path.into(),
            title: String::new(),
            requirements: rules.to_vec(),
            flags: Vec::new(),
            roles,
            needs: None,
            call: "",
            args: Json::object(),
            expect: Json::object(),
            by: BTreeMap::new(),
            rests_on: Vec::new(),
            why: String::new(),
        }
    }

    /// What the case shows, as a sentence.
    pub(crate) fn title(mut self, title: impl Into<String>) -> Self {
        self.title = with_short_doubles(&title.into());
        self
    }

    /// From which sentence of the text the expectation follows.
    pub(crate) fn because(mut self, why: impl Into<String>) -> Self {
        self.why = why.into();
        self
    }

    /// The bug classes that the case catches.
    pub(crate) fn flags(mut self, flags: &[&'static str]) -> Self {
        for flag in flags {
            if !self.flags.contains(flag) {
                self.flags.push(flag);
            }
        }
        self
    }

    /// A further rule that the case is about.
    pub(crate) fn about(mut self, rule: &'static str) -> Self {
        if !self.requirements.contains(&rule) {
            self.requirements.push(rule);
        }
        self
    }

    /// What a peer has to claim, beside a role, to be asked.
    pub(crate) fn needs(mut self, need: &'static str) -> Self {
        self.needs = Some(need);
        self
    }

    /// The call and its arguments.
    pub(crate) fn call(mut self, call: &'static str, args: Json) -> Self {
        self.call = call;
        self.args = args;
        self
    }

    /// `decode` of a text.
    pub(crate) fn decode(self, kind: &str, text: impl Into<Text>) -> Self {
        self.call("decode", object! { "kind" => kind, "text" => text.into() })
    }

    /// `decode` of bytes that need not be UTF-8.
    pub(crate) fn decode_bytes(self, kind: &str, bytes: &[u8]) -> Self {
        self.call("decode", object! { "kind" => kind, "base64" => Text::base64_of(bytes) })
    }

    /// `encode` of fields.
    pub(crate) fn encode(self, kind: &str, fields: Json) -> Self {
        self.call("encode", object! { "kind" => kind, "fields" => fields })
    }

    /// Any error but a crash.
    pub(crate) fn rejects(self, code: &str) -> Self {
        self.expect(object! { "reject" => code })
    }

    /// Any result.
    pub(crate) fn accepts(self) -> Self {
        self.expect(object! { "accept" => true })
    }

    /// A result that equals this as JSON.
    pub(crate) fn gives(self, value: Json) -> Self {
        self.expect(object! { "relation" => "json", "value" => value })
    }

    /// The same message, however it is spelled.
    pub(crate) fn means(self, text: impl Into<Text>) -> Self {
        self.expect(object! { "relation" => "message", "text" => text.into() })
    }

    /// The same message, apart from what stands at these JSON pointers.
    pub(crate) fn means_but_for(self, text: impl Into<Text>, ignore: &[&str]) -> Self {
        let ignore: Json = ignore.iter().copied().collect();
        self.expect(object! { "relation" => "message", "text" => text.into(), "ignore" => ignore })
    }

    /// The same message, however it is spelled, or a refusal.
    pub(crate) fn means_or_rejects(self, text: impl Into<Text>) -> Self {
        self.means(text).or_rejects()
    }

    /// What is expected already, or a refusal.
    pub(crate) fn or_rejects(mut self) -> Self {
        self.expect = self.expect.and("or_reject", Json::Bool(true));
        self
    }

    /// The same message, spelled by the rules for encoders.
    pub(crate) fn writes(self, text: impl Into<Text>) -> Self {
        self.expect(object! { "relation" => "encoding", "text" => text.into() })
    }

    /// Exactly these bytes.
    pub(crate) fn gives_bytes(self, bytes: &[u8]) -> Self {
        self.expect(object! { "relation" => "bytes", "base64" => Text::base64_of(bytes) })
    }

    /// Any valid block of exactly these columns.
    pub(crate) fn gives_columns(self, columns: Json) -> Self {
        self.expect(object! { "relation" => "columns", "columns" => columns })
    }

    /// What of the answer another rule decides than the first: at a JSON pointer and below, a `crash`, a `refusal`, …
    pub(crate) fn by(mut self, place: impl Into<String>, rule: &'static str) -> Self {
        if self.requirements.first() != Some(&rule) {
            self.by.insert(place.into(), rule);
        }
        self
    }

    /// What of the answer the first rule decides all the same, within what another decides.
    pub(crate) fn by_own(mut self, place: impl Into<String>) -> Self {
        if let Some(own) = self.requirements.first() {
            self.by.insert(place.into(), own);
        }
        self
    }

    /// The rules that decide the steps of a trace. Where none of them is the rule that the case is about, the model
    /// cannot tell what shows it: then it is the last step, and every other at which something simply moves.
    pub(crate) fn decided_by(self, steps: &[Option<&'static str>]) -> Self {
        let own = self.requirements.first().copied();
        if steps.contains(&own) {
            return self.decided_throughout_by(steps);
        }
        let last = steps.iter().rposition(Option::is_some).unwrap_or_default();
        let moves = |rule: &Option<&str>| rule.is_some_and(|rule| MOVES.contains(&rule));
        let steps = steps.iter().take(last).map(|rule| rule.filter(|_| !moves(rule)));
        self.decided_throughout_by(&steps.collect::<Vec<_>>())
    }

    /// The same of a trace that is about all of its steps.
    pub(crate) fn decided_throughout_by(mut self, steps: &[Option<&'static str>]) -> Self {
        for (step, rule) in steps.iter().enumerate() {
            if let Some(rule) = rule {
                self = self.by(format!("/steps/{step}"), rule);
            }
        }
        self
    }

    /// A trace that is about all from this step on.
    pub(crate) fn about_from(mut self, step: usize) -> Self {
        self.by.retain(|place, _| {
            place.split('/').nth(2).and_then(|at| at.parse().ok()).is_none_or(|at: usize| at < step)
        });
        self
    }

    /// A case without which this one shows nothing of its own rule.
    pub(crate) fn rests_on(mut self, id: impl Into<String>) -> Self {
        self.rests_on.push(id.into());
        self
    }

    fn expect(mut self, expect: Json) -> Self {
        self.expect = expect;
        self
    }

    fn json(self, prefix: &str) -> Json {
        let mut json = object! {
            "id" => format!("{prefix}/{}", self.path),
            "title" => self.title,
            "requirements" => self.requirements.into_iter().collect::<Json>(),
            "flags" => self.flags.into_iter().collect::<Json>(),
            "roles" => self.roles.into_iter().map(Role::as_str).collect::<Json>(),
        };
        if let Some(need) = self.needs {
            json = json.and("needs", [need].into_iter().collect::<Json>());
        }
        let args = runs::of_arguments(self.args, &LISTS_WITH_RUNS);
        let is_pattern = self.expect.get("relation").and_then(Json::as_str) == Some("pattern");
        let expect = if is_pattern { runs::of_pattern(self.expect) } else { self.expect };
        json = json.and("call", self.call.into()).and("args", args).and("expect", expect);
        if !self.by.is_empty() {
            let by = runs::of_places(self.by).into_iter();
            json = json.and("by", Json::Object(by.map(|(at, rule)| (at, rule.into())).collect()));
        }
        if !self.rests_on.is_empty() {
            json = json.and("rests_on", Json::Array(self.rests_on.into_iter().map(Json::from).collect()));
        }
        json.and("why", self.why.into())
    }
}

/// The lists of arguments that are written as what repeats itself, once, and how often.
const LISTS_WITH_RUNS: [&str; 9] =
    ["horizon", "data", "steps", "requests", "sensor_channels", "command_channels", "encoders", "decoders", "columns"];

/// The text with an exponent in each double that is written out in more than [`FIGURES`] figures, as
/// `Display` does with the largest and the smallest.
fn with_short_doubles(text: &str) -> String {
    let is_figure = |c: char| c.is_ascii_digit() || c == '.';
    let mut short = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find(is_figure) {
        let (before, figures) = rest.split_at(start);
        let end = figures.find(|c| !is_figure(c)).unwrap_or(figures.len());
        let number = figures[..end].trim_end_matches('.');
        short.push_str(before);
        match number.parse::<f64>() {
            Ok(double) if number.len() > FIGURES && double.to_string() == number => {
                short.push_str(&format!("{double:?}"));
            }
            _ => short.push_str(number),
        }
        short.push_str(&figures[number.len()..end]);
        rest = &figures[end..];
    }
    short + rest
}

/// More figures than a case spells on purpose.
const FIGURES: usize = 40;

/// The cases of one file.
#[derive(Debug, Clone)]
pub(crate) struct File {
    pub(crate) area: &'static str,
    pub(crate) name: String,
    pub(crate) about: String,
    pub(crate) cases: Vec<Case>,
}

impl File {
    pub(crate) fn new(area: &'static str, name: impl Into<String>, about: impl Into<String>, cases: Vec<Case>) -> Self {
        let (mut cases, name) = (cases, name.into());
        for case in cases.iter_mut().filter(|case| case.flags.is_empty()) {
            let rule = case.requirements.first().copied().unwrap_or_default();
            case.flags.extend(flags::usual(area, &name, rule));
        }
        Self { area, name, about: about.into(), cases }
    }

    /// What the ids of its cases begin with.
    pub(crate) fn prefix(&self) -> String {
        format!("{}/{}", self.area, self.name)
    }

    /// The ids of its cases.
    pub(crate) fn ids(&self) -> Vec<String> {
        self.cases.iter().map(|case| format!("{}/{}", self.prefix(), case.path)).collect()
    }

    /// The path below `vectors/`, and the text.
    pub(crate) fn render(self) -> (String, String) {
        let prefix = self.prefix();
        let mut used: Vec<&str> = self.cases.iter().flat_map(|case| case.flags.clone()).collect();
        used.sort_unstable();
        used.dedup();
        let notes = used.iter().map(|flag| ((*flag).to_owned(), Json::from(flags::note(flag))));
        let file = object! {
            "format" => Json::literal("1"),
            "area" => self.area,
            "name" => self.name,
            "about" => self.about,
            "notes" => Json::Object(notes.collect()),
            "cases" => self.cases.into_iter().map(|case| case.json(&prefix)).collect::<Json>(),
        };
        (format!("{prefix}.json"), file.pretty())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_title_has_no_double_of_hundreds_of_figures() {
        let text = format!("From {} to -{} and {}.", 5e-324, 1e308, f64::MAX);
        assert_eq!(with_short_doubles(&text), "From 5e-324 to -1e308 and 1.7976931348623157e308.");
    }

    #[test]
    fn a_title_keeps_every_other_number_as_it_is_spelled() {
        for text in
            ["0.5, 0.05. 1.5e3 and ...", "0.18446744073709551616 is 100000000000000000000000000000.", "after 60.0625 s"]
        {
            assert_eq!(with_short_doubles(text), text);
        }
    }
}
