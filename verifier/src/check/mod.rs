//! Judging one answer.
//!
//! An answer is compared with its case's expectation by the relation that the case states, and what differs is
//! named by path. What a frame or a block *means* is asked of [`ncp_spec`]; no rule is written a second time here.

mod columns;
mod compare;
mod frame;
mod pattern;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use ncp_spec::ErrorCode;

use compare::{Relation, compare};

use crate::json::Json;
use crate::peer::{Answer, excerpt};
use crate::suite::{Case, Expect};

/// How many differences are kept; one is enough to fail.
const KEPT: usize = 10;
/// How many characters of a value are shown.
const SHOWN: usize = 120;

/// What an answer is worth.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Judgement {
    /// It is right. A refusal may have another reason than the text suggests, which is noted.
    Pass {
        /// What is worth knowing although it is right.
        note: Option<String>,
    },
    /// It is wrong.
    Fail(Differences),
    /// The peer has no such function, or cannot do a step of a trace.
    Unsupported {
        /// Where that step is, as a JSON pointer; none: the whole call.
        step: Option<String>,
    },
}

/// What differs between an answer and its expectation.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Differences {
    /// The first ones.
    pub first: Vec<Difference>,
    /// How many more there are.
    pub more: usize,
    /// Where the answer first differs, as a JSON pointer: of several allowed forms, into the nearest.
    pub place: String,
    /// What the answer is there.
    pub manner: Manner,
}

impl Differences {
    /// Whether the answer first differs by a member that it has and should not have.
    #[must_use]
    pub fn is_of_an_extra_member(&self) -> bool {
        let is_extra = |first: &&Difference| first.at == self.place && first.expected.is_none() && first.got.is_some();
        self.manner == Manner::Value && !self.place.is_empty() && self.first.first().filter(is_extra).is_some()
    }
}

/// What an answer is where it first differs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Manner {
    /// Another value, or none.
    #[default]
    Value,
    /// An error where a result is asked for.
    Refusal,
    /// The same members in another order.
    Order,
    /// The error `internal`, which says that the peer crashed.
    Crash,
}

impl Manner {
    fn of_error(code: &str) -> Self {
        if code == ErrorCode::Internal.as_str() { Self::Crash } else { Self::Refusal }
    }
}

/// One difference.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Difference {
    /// Where, as a JSON pointer into what is compared; empty for the whole.
    pub at: String,
    /// What was expected there; `None`: that nothing is there.
    pub expected: Option<String>,
    /// What was there; `None`: nothing.
    pub got: Option<String>,
    /// What else there is to say.
    pub hint: Option<String>,
}

/// Judges an answer.
#[must_use]
pub fn judge(case: &Case, answer: &Answer<'_>) -> Judgement {
    judge_by(&case.expect, answer)
}

fn judge_by(expect: &Expect, answer: &Answer<'_>) -> Judgement {
    let mut differences = Differences::default();
    match (answer, expect) {
        (Answer::Unsupported, _) => return Judgement::Unsupported { step: None },
        (Answer::Error { code, message }, Expect::Reject(suggested)) => {
            if code == ErrorCode::Internal.as_str() {
                differences.manner = Manner::Crash;
                let got = format!("the error `internal`, {}", excerpt(message.as_bytes(), SHOWN));
                differences.whole("a refusal", got, Some("a crash is no refusal"));
            } else {
                return Judgement::Pass { note: other_reason(code, *suggested) };
            }
        }
        (
            Answer::Error { code, .. },
            Expect::Pattern { or_reject: true, .. } | Expect::Message { or_reject: true, .. },
        ) if code != ErrorCode::Internal.as_str() => {}
        (Answer::Error { code, message }, expect) => {
            differences.manner = Manner::of_error(code);
            let got = format!("the error `{}`, {}", excerpt(code.as_bytes(), 20), excerpt(message.as_bytes(), SHOWN));
            differences.whole(&in_words(expect), got, None);
        }
        (Answer::Result(result), Expect::Reject(suggested)) => {
            differences.whole(
                &format!("an error, such as `{suggested}`"),
                format!("the result {}", short(result)),
                None,
            );
        }
        (Answer::Result(_), Expect::Accept) => {}
        (Answer::Result(result), Expect::Json(expected)) => {
            let expected = expected.expand();
            // It was read when the suite was.
            if let Ok(expected) = Json::parse(&expected) {
                compare(Relation::Values, &expected, &listed(&expected, result))
                    .iter()
                    .for_each(|found| found.note(&mut differences));
            }
        }
        (Answer::Result(result), Expect::Message { text, ignore, .. }) => {
            if let Some(got) = member(result, "text", &mut differences) {
                frame::same_message(&text.get(), got, ignore, &mut differences);
            }
        }
        (Answer::Result(result), Expect::Encoding(text)) => {
            if let Some(got) = member(result, "text", &mut differences) {
                frame::same_encoding(&text.get(), got, &mut differences);
            }
        }
        (Answer::Result(result), Expect::Bytes(expected)) => {
            if let Some(got) = block(result, &mut differences) {
                columns::same_bytes(expected, &got, &mut differences);
            }
        }
        (Answer::Result(result), Expect::Columns(expected)) => {
            if let Some(got) = block(result, &mut differences) {
                columns::same_columns(&expected.expand(), &got, &mut differences);
            }
        }
        (Answer::Result(result), Expect::Pattern { shape, tolerance, .. }) => {
            pattern::fits(shape, *tolerance, result, &mut differences);
        }
    }
    match (answer, differences.is_empty()) {
        (Answer::Result(result), _) if let Some(step) = lacking(result, &differences) => {
            Judgement::Unsupported { step: Some(step) }
        }
        (_, true) => Judgement::Pass { note: None },
        (_, false) => Judgement::Fail(differences),
    }
}

/// The first step of a trace that the peer cannot do, unless an earlier one is wrong: what comes behind rests on it.
fn lacking(result: &Json<'_>, differences: &Differences) -> Option<String> {
    let Some(Json::Array(steps)) = result.get("steps") else {
        return None;
    };
    let lacking = steps.iter().position(|step| step.get("unsupported") == Some(&Json::Bool(true)))?;
    let mut tokens = differences.place.split('/').skip(1);
    let wrong = match (tokens.next(), tokens.next()) {
        (Some("steps"), Some(step)) => step.parse::<usize>().ok(),
        _ => None,
    };
    wrong.is_none_or(|wrong| lacking <= wrong).then(|| format!("/steps/{lacking}"))
}

/// What an expectation asks for, in words.
#[must_use]
pub fn in_words(expect: &Expect) -> String {
    match expect {
        Expect::Reject(code) => format!("an error, such as `{code}`"),
        Expect::Accept => "any result".to_owned(),
        Expect::Json(value) => format!("the result {}", excerpt(value.expand().as_bytes(), SHOWN)),
        Expect::Message { text, or_reject, .. } => {
            let message = excerpt(text.get().as_bytes(), SHOWN);
            let or_reject = if *or_reject { ", or an error" } else { "" };
            format!("the message {message}{or_reject}")
        }
        Expect::Encoding(text) => format!("the frame {}", excerpt(text.get().as_bytes(), SHOWN)),
        Expect::Bytes(bytes) => format!("a block of exactly {} bytes", bytes.len()),
        Expect::Columns(columns) => format!("a block with the columns {}", excerpt(columns.expand().as_bytes(), SHOWN)),
        Expect::Pattern { shape, or_reject, .. } => {
            let shape = excerpt(shape.to_string().as_bytes(), SHOWN);
            let or_reject = if *or_reject { ", or an error" } else { "" };
            format!("a result like {shape}{or_reject}")
        }
    }
}

impl Differences {
    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.first.is_empty()
    }

    /// How many there are.
    fn count(&self) -> usize {
        self.first.len() + self.more
    }

    fn push(&mut self, difference: Difference) {
        if self.is_empty() {
            self.place.clone_from(&difference.at);
        }
        if self.first.len() < KEPT {
            self.first.push(difference);
        } else {
            self.more += 1;
        }
    }

    fn whole(&mut self, expected: &str, got: String, hint: Option<&str>) {
        self.push(Difference {
            at: String::new(),
            expected: Some(expected.to_owned()),
            got: Some(got),
            hint: hint.map(str::to_owned),
        });
    }
}

impl std::fmt::Display for Difference {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if !self.at.is_empty() {
            write!(f, "{}: ", excerpt(self.at.as_bytes(), SHOWN))?;
        }
        let expected = self.expected.as_deref().unwrap_or("nothing there");
        let got = self.got.as_deref().unwrap_or("nothing");
        write!(f, "expected {expected}, got {got}")?;
        self.hint.as_ref().map_or(Ok(()), |hint| write!(f, " ({hint})"))
    }
}

/// The members of a result that are expected; what else a peer tells is not looked at (PROTOCOL.md, section 1).
fn listed<'a>(expected: &Json<'_>, result: &Json<'a>) -> Json<'a> {
    match (expected, result) {
        (Json::Object(_), Json::Object(members)) => {
            Json::Object(members.iter().filter(|(name, _)| expected.get(name).is_some()).cloned().collect())
        }
        _ => result.clone(),
    }
}

/// A value as it is shown.
fn short(value: &Json<'_>) -> String {
    excerpt(value.to_string().as_bytes(), SHOWN)
}

/// A refusal for another reason than the text suggests. It is no fault, since one input can be wrong in two ways.
fn other_reason(code: &str, suggested: ErrorCode) -> Option<String> {
    match ErrorCode::parse(code) {
        Some(known) if known == suggested || known == ErrorCode::Invalid => None,
        Some(known) => Some(format!("refused as `{known}`; the text suggests `{suggested}`")),
        None => Some(format!("refused as `{}`, which PROTOCOL.md does not list", excerpt(code.as_bytes(), 20))),
    }
}

/// A string member of the result, or a difference.
fn member<'r>(result: &'r Json<'_>, name: &str, differences: &mut Differences) -> Option<&'r str> {
    let got = result.get(name);
    let text = got.and_then(Json::as_str);
    if text.is_none() {
        differences.push(Difference {
            at: format!("/{name}"),
            expected: Some("a string".to_owned()),
            got: got.map(short),
            hint: Some(format!("the result needs the member `{name}`")),
        });
    }
    text
}

/// The block of the result, or a difference.
fn block(result: &Json<'_>, differences: &mut Differences) -> Option<Vec<u8>> {
    let text = member(result, "block", differences)?;
    match STANDARD.decode(text) {
        Ok(bytes) => Some(bytes),
        Err(error) => {
            differences.push(Difference {
                at: "/block".to_owned(),
                expected: Some("base64".to_owned()),
                got: Some(excerpt(text.as_bytes(), SHOWN)),
                hint: Some(error.to_string()),
            });
            None
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::suite::{Shape, Template, Text};

    fn pattern(or_reject: bool) -> Expect {
        Expect::Pattern { shape: Shape::parse(r#"{"hold":true}"#).unwrap(), tolerance: 0.0, or_reject }
    }

    fn passes(expect: &Expect, answer: &Answer<'_>) -> bool {
        matches!(judge_by(expect, answer), Judgement::Pass { .. })
    }

    #[test]
    fn a_pattern_may_allow_a_refusal_but_never_a_crash() {
        let error = |code: &str| Answer::Error { code: code.to_owned(), message: String::new() };
        assert!(passes(&pattern(true), &error("value")));
        assert!(!passes(&pattern(true), &error("internal")));
        assert!(!passes(&pattern(false), &error("value")));
        for (result, right) in [(r#"{"hold":true}"#, true), (r#"{"hold":false}"#, false)] {
            let result = Answer::Result(Json::parse(result).unwrap());
            assert_eq!(passes(&pattern(true), &result), right);
            assert_eq!(passes(&pattern(false), &result), right);
        }
        assert_eq!(judge_by(&pattern(true), &Answer::Unsupported), Judgement::Unsupported { step: None });
    }

    #[test]
    fn a_trace_is_judged_up_to_the_step_that_the_peer_cannot_do() {
        let shape = Shape::parse(r#"{"steps":[{},{"hold":true},{},{"hold":false}]}"#).unwrap();
        let expect = Expect::Pattern { shape, tolerance: 0.0, or_reject: false };
        let judged = |steps: &str| {
            let result = format!("{{\"steps\":[{steps}]}}");
            judge_by(&expect, &Answer::Result(Json::parse(&result).unwrap()))
        };
        let lacks = |step: &str| Judgement::Unsupported { step: Some(step.to_owned()) };
        assert_eq!(judged(r#"{},{"hold":true},{},{"hold":false}"#), Judgement::Pass { note: None });
        assert_eq!(judged(r#"{},{"hold":true},{"unsupported":true},{"hold":true}"#), lacks("/steps/2"));
        assert_eq!(judged(r#"{},{"hold":true},{"unsupported":true},{"hold":false}"#), lacks("/steps/2"));
        assert_eq!(judged(r#"{},{"unsupported":true},{"unsupported":true},{"hold":true}"#), lacks("/steps/1"));
        // What is wrong before it is wrong, and what is no such claim is an answer like others.
        for wrong in [
            r#"{},{"hold":false},{"unsupported":true},{"hold":false}"#,
            r#"{},{"unsupported":false},{},{"hold":false}"#,
            r#"{},{"hold":true},{},{"hold":true}"#,
        ] {
            assert!(matches!(judged(wrong), Judgement::Fail(_)), "{wrong}");
        }
    }

    #[test]
    fn a_message_may_allow_a_refusal_but_never_a_crash_nor_another_message() {
        let frame = r#""{\"kind\":\"error\",\"error\":\"no\"}""#;
        let message = |or_reject| Expect::Message {
            text: Text::new(Template::new(frame).unwrap()),
            ignore: Vec::new(),
            or_reject,
        };
        let (strict, lenient) = (message(false), message(true));
        let error = |code: &str| Answer::Error { code: code.to_owned(), message: String::new() };
        assert!(passes(&lenient, &error("version")));
        assert!(!passes(&lenient, &error("internal")));
        assert!(!passes(&strict, &error("version")));
        for (text, right) in [("no", true), ("yes", false)] {
            let result = format!(r#"{{"text":"{{\"kind\":\"error\",\"error\":\"{text}\"}}"}}"#);
            let result = Answer::Result(Json::parse(&result).unwrap());
            assert_eq!(passes(&lenient, &result), right);
            assert_eq!(passes(&strict, &result), right);
        }
        assert!(in_words(&lenient).ends_with(", or an error"));
        assert!(!in_words(&strict).ends_with(", or an error"));
    }

    #[test]
    fn what_a_result_tells_beyond_what_is_listed_is_not_looked_at() {
        let compatible = Expect::Json(Template::new(r#"{"compatible":true}"#).unwrap());
        let answers = [
            (r#"{"compatible":true}"#, true),
            (r#"{"compatible":true,"major":0,"why":{"minor":[5]}}"#, true),
            (r#"{"why":null,"compatible":true}"#, true),
            (r#"{"compatible":false,"why":"older"}"#, false),
            (r#"{"Compatible":true}"#, false),
            (r#"{"result":{"compatible":true}}"#, false),
            ("{}", false),
            ("true", false),
        ];
        for (result, right) in answers {
            let answer = Answer::Result(Json::parse(result).unwrap());
            assert_eq!(passes(&compatible, &answer), right, "{result}");
        }
    }

    #[test]
    fn a_pattern_is_put_into_words() {
        assert_eq!(in_words(&pattern(false)), r#"a result like {"hold":true}"#);
        assert_eq!(in_words(&pattern(true)), r#"a result like {"hold":true}, or an error"#);
    }
}
