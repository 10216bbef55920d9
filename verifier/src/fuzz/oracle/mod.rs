//! What a peer has to answer: the specification's own answer, and around it every freedom that the text leaves.
//!
//! The specification runs in this process, through the adapter of the Rust peer. Its answer becomes an expectation in
//! the form of the vector files, by the relation that the cases of the call use. So what a disagreement is judged by is
//! what `--save` writes. Where the text leaves the answer open, nothing is asked for: [`Verdict::Open`] says why.
//!
//! - `frames`, `plain`, `bulk`, `plant`, `safety`, `control`, `codec`, `session`: the freedoms of the calls of an area.
//! - `open`: what the text leaves open of a frame as it arrives.
//! - `exact`: whether doubles tell what real numbers would.

mod bulk;
mod codec;
mod control;
mod exact;
mod frames;
mod open;
mod plain;
mod plant;
mod safety;
mod session;

use ncp_peer_rust::Answer;

pub(crate) use frames::bytes as frame_bytes;

use super::draw::LARGEST;
use super::generate::Input;
use super::tree::{Tree, integer, items, list, num, object, own, text};
use crate::json::{Json, Number};
use crate::peer::{self, Call};

/// How far off a computed number may be, relatively, as in the corpus.
pub(crate) const TOLERANCE: f64 = 1e-9;

/// What is asked of an answer.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Verdict {
    /// Nothing, since the text leaves it open, or the question is none of the protocol.
    Open(&'static str),
    /// This, in the form of the vector files.
    Expect(Tree),
}

/// The answer of the specification.
pub(crate) fn specification(call: Call, args: &str) -> Answer {
    ncp_peer_rust::ask(call.as_str(), args)
}

/// What the text asks of the answer to an input, which the specification answers so. What a peer said tells which of
/// the text's choices it made, where these are too many to be listed.
pub(crate) fn expectation(input: &Input, spec: &Answer, said: Option<&peer::Answer<'_>>) -> Verdict {
    let result = match spec {
        Answer::Unsupported => return Verdict::Open("the specification has no such call"),
        Answer::Error { code, .. } if code == "internal" => return Verdict::Open("the protocol has no such question"),
        Answer::Error { code, .. } => Err(code.as_ref()),
        Answer::Result(result) => match Json::parse(result) {
            Ok(result) => Ok(own(&result)),
            Err(_) => return Verdict::Open("the specification answers no JSON"),
        },
    };
    let result = result.as_ref().map_err(|code| *code);
    // An object of sections 7 to 10 is refused for its configuration, and for nothing else.
    let has_steps = concerns_objects(input.call);
    if has_steps && result.is_err_and(|code| code != "value") {
        return Verdict::Open("the arguments are none of the protocol");
    }
    if has_foreign_seq(&input.args) {
        return Verdict::Open("a seq is beyond the integers of the wire");
    }
    let args = &input.args;
    match input.call {
        Call::Describe => Verdict::Open("it is no question of the text"),
        Call::Decode => frames::decode(args, result),
        Call::Encode => frames::encode(args, result),
        Call::ReplyCheck => frames::reply(args, result),
        Call::VersionCheck | Call::ContractStatus | Call::ContractVerify | Call::Negotiate => {
            plain::version(args, result)
        }
        Call::KeyBuild => plain::key_build(args, result),
        Call::KeyMatch => plain::key_match(args, result),
        Call::PlaneQos => by_result(result),
        Call::HorizonMaxLen => plain::horizon(args, result),
        Call::BulkDecode | Call::ObservationUnpack => bulk::decode(input.call, args, result),
        Call::BulkEncode => bulk::encode(args, result),
        Call::ObservationPack => bulk::pack(result),
        Call::WatchdogRun => plant::watchdog(args, result),
        Call::BufferRun => plant::buffer(args, result),
        Call::LinkRun => plant::link(args, result),
        Call::GovernorRun => safety::governor(args, result),
        Call::ReflexStep => control::reflex(args, result),
        Call::LoopRun => control::control_loop(args, result),
        Call::CodecEncode => codec::encode(args, result),
        Call::CodecDecode => codec::decode(args, result),
        Call::SessionRun => session::run(args, result, said),
    }
}

/// Whether a step has a seq that no frame may have, so that an API need not take it. `// [NCP-WIRE-011]`
fn has_foreign_seq(args: &Tree) -> bool {
    let seqs = items(args.get("steps")).iter().filter_map(|step| integer(step.get("seq")));
    seqs.into_iter().any(|seq| seq.unsigned_abs() > LARGEST.unsigned_abs())
}

fn concerns_objects(call: Call) -> bool {
    matches!(
        call,
        Call::GovernorRun
            | Call::WatchdogRun
            | Call::BufferRun
            | Call::LinkRun
            | Call::CodecEncode
            | Call::CodecDecode
            | Call::ReflexStep
            | Call::LoopRun
            | Call::SessionRun
    )
}

/// What the specification answered: a result, or the code of a refusal.
type Outcome<'o> = Result<&'o Tree, &'o str>;

/// An error, whatever its code.
fn reject(code: &str) -> Verdict {
    Verdict::Expect(object([("reject", text(code))]))
}

/// Any result.
fn accept() -> Verdict {
    Verdict::Expect(object([("accept", Json::Bool(true))]))
}

/// A result that equals this as JSON.
fn equal(value: Tree) -> Verdict {
    Verdict::Expect(object([("relation", text("json")), ("value", value)]))
}

/// A result that fits this pattern, in which ranges say how far off a number may be.
fn fits(pattern: Tree) -> Verdict {
    Verdict::Expect(object([("relation", text("pattern")), ("value", pattern)]))
}

/// The same, or a refusal of the whole.
fn fits_or_refused(pattern: Tree) -> Verdict {
    let mut expect = object([("relation", text("pattern")), ("value", pattern)]);
    super::tree::set(&mut expect, "or_reject", Json::Bool(true));
    Verdict::Expect(expect)
}

/// A result equal to the specification's, or a refusal where it refuses.
fn by_result(result: Outcome<'_>) -> Verdict {
    match result {
        Ok(result) => equal(result.clone()),
        Err(code) => reject(code),
    }
}

/// One of these patterns; the pattern itself when there is one.
fn any(mut patterns: Vec<Tree>) -> Tree {
    patterns.dedup();
    if patterns.len() == 1 {
        return patterns.remove(0);
    }
    object([("$any", list(patterns))])
}

/// Exactly these members.
fn exactly(members: Tree) -> Tree {
    object([("$exact", members)])
}

/// A step that is refused.
fn refused() -> Tree {
    object([("$error", Json::Bool(true))])
}

/// Whatever is there, or nothing.
fn free() -> Tree {
    object([])
}

/// A number from one to another.
fn range(low: f64, high: f64) -> Tree {
    if low == high { num(low) } else { object([("$range", list(vec![num(low.min(high)), num(low.max(high))]))]) }
}

/// A number that may be off by the tolerance, relatively, and by `slack`.
fn near(value: f64, slack: f64) -> Tree {
    if !value.is_finite() {
        return num(value);
    }
    let off = value.abs() * TOLERANCE + slack.abs();
    range(value - off, value + off)
}

/// The results of a trace.
fn steps(entries: Vec<Tree>) -> Tree {
    object([("steps", list(entries))])
}

/// Whether two answers say the same, so surely that no expectation has to be asked. What the messages of errors say,
/// and the order of members outside of frames, is nobody's affair.
pub(crate) fn agree(call: Call, spec: &Answer, said: &peer::Answer<'_>) -> bool {
    match (spec, said) {
        (Answer::Error { .. }, peer::Answer::Error { code, .. }) => code != "internal",
        (Answer::Result(expected), peer::Answer::Result(got)) => {
            let Ok(expected) = Json::parse(expected) else { return false };
            match call {
                Call::Decode | Call::Encode => {
                    let text = |json: &Json<'_>| json.get("text").and_then(Json::as_str).map(str::to_owned);
                    let (Some(expected), Some(got)) = (text(&expected), text(got)) else { return false };
                    let same = if call == Call::Encode { Same::Encoding } else { Same::Values };
                    match (Json::parse(&expected), Json::parse(&got)) {
                        (Ok(expected), Ok(got)) => same.holds(&expected, &got),
                        _ => false,
                    }
                }
                Call::ReplyCheck => true,
                Call::GovernorRun | Call::LoopRun | Call::CodecEncode | Call::CodecDecode | Call::ReflexStep => {
                    Same::Near(1e-12).holds(&expected, got)
                }
                Call::LinkRun => Same::Near(1e-15).holds(&expected, got),
                _ => Same::Values.holds(&expected, got),
            }
        }
        _ => false,
    }
}

/// When two values are the same beyond doubt.
#[derive(Clone, Copy)]
enum Same {
    /// By value, the sign of a zero included; null is absent.
    Values,
    /// The same members in the same order, integers spelled alike.
    Encoding,
    /// By value, but for so much, relatively.
    Near(f64),
}

impl Same {
    fn holds(self, expected: &Json<'_>, got: &Json<'_>) -> bool {
        match (expected, got) {
            (Json::Object(a), Json::Object(b)) => self.members(a, b),
            (Json::Array(a), Json::Array(b)) => a.len() == b.len() && a.iter().zip(b).all(|(a, b)| self.holds(a, b)),
            (Json::String(a), Json::String(b)) if a == b => true,
            (Json::Number(a), Json::Number(b)) if a == b => true,
            _ => match (Number::of(expected), Number::of(got), self) {
                (Some(a), Some(b), Self::Near(most)) => {
                    let (a, b) = (a.as_double(), b.as_double());
                    a == b || a.is_nan() && b.is_nan() || (a - b).abs() <= most * a.abs().min(b.abs())
                }
                (Some(a), Some(b), Self::Values) => a.is_met_by(b),
                (Some(a), Some(b), Self::Encoding) => {
                    let integer = |json: &Json<'_>| matches!(json, Json::Number(n) if crate::json::is_integer(n));
                    a.is_met_by(b) && integer(expected) == integer(got)
                }
                _ => expected == got,
            },
        }
    }

    fn members(self, a: &[Member<'_>], b: &[Member<'_>]) -> bool {
        if matches!(self, Self::Encoding) {
            return a.len() == b.len() && a.iter().zip(b).all(|((n, a), (m, b))| n == m && self.holds(a, b));
        }
        let refused = |members: &[Member<'_>]| {
            let code = members.iter().find(|(name, _)| name == "error").and_then(|(_, error)| error.get("code"));
            code.and_then(Json::as_str).is_some_and(|code| code != "internal")
        };
        if refused(a) && refused(b) {
            return true;
        }
        let find = |members: &[Member<'_>], name: &str, place: usize| -> Option<usize> {
            if members.get(place).is_some_and(|(known, _)| known == name) {
                return Some(place);
            }
            members.iter().position(|(known, _)| known == name)
        };
        let within = |a: &[Member<'_>], b: &[Member<'_>], compare: bool| {
            a.iter().enumerate().all(|(place, (name, value))| match find(b, name, place) {
                Some(at) => !compare || self.holds(value, &b[at].1),
                None => *value == Json::Null,
            })
        };
        within(a, b, true) && within(b, a, false)
    }
}

type Member<'j> = (std::borrow::Cow<'j, str>, Json<'j>);

#[cfg(test)]
mod tests {
    use super::*;

    fn same(how: Same, a: &str, b: &str) -> bool {
        how.holds(&Json::parse(a).unwrap(), &Json::parse(b).unwrap())
    }

    #[test]
    fn what_agrees_beyond_doubt_is_told_from_what_has_to_be_judged() {
        assert!(same(Same::Values, r#"{"a":5,"b":null}"#, r#"{"a":5.0}"#));
        assert!(same(Same::Values, r#"["NaN","-0"]"#, r#"["NaN",-0.0]"#));
        assert!(!same(Same::Values, r#"{"a":0.0}"#, r#"{"a":-0.0}"#));
        assert!(!same(Same::Values, r#"{"a":1}"#, r#"{"a":1,"b":2}"#));
        assert!(!same(Same::Encoding, r#"{"a":1,"b":2}"#, r#"{"b":2,"a":1}"#));
        assert!(!same(Same::Encoding, r#"{"a":1}"#, r#"{"a":1.0}"#));
        assert!(same(Same::Near(1e-12), "[1.0]", "[1.0000000000000002]"));
        assert!(!same(Same::Near(1e-12), "[1e-300]", "[2e-300]"));
        let refusal = r#"{"error":{"code":"type","message":"a"}}"#;
        assert!(same(Same::Values, refusal, r#"{"error":{"code":"value","message":"b"}}"#));
        assert!(!same(Same::Values, refusal, r#"{"error":{"code":"internal","message":"b"}}"#));
    }

    #[test]
    fn a_seq_that_no_frame_may_have_is_none_that_a_peer_is_asked_for() {
        let ask = |seq: &str| {
            let step = format!(r#"{{"op":"command","now_s":1.0,"ttl_ms":200.0,"seq":{seq}}}"#);
            expected(Call::WatchdogRun, &format!(r#"{{"steps":[{step},{{"op":"should_hold","now_s":1.1}}]}}"#))
        };
        for seq in ["9007199254740991", "-9007199254740991"] {
            assert!(matches!(ask(seq), Verdict::Expect(_)), "{seq}");
        }
        for seq in ["9007199254740992", "-9007199254740992"] {
            assert!(matches!(ask(seq), Verdict::Open(_)), "{seq}");
        }
    }

    fn expected(call: Call, args: &str) -> Verdict {
        let args = own(&Json::parse(args).unwrap());
        let spec = specification(call, &args.to_string());
        expectation(&Input { call, args }, &spec, None)
    }

    #[test]
    fn whether_a_governor_is_stopped_that_a_rounding_decided_stays_open_until_a_burst() {
        let govern = |x: f64, y: f64| {
            let command = r#"{"seq":1,"t":1.0,"frame_id":"w","mode":"active","ttl_ms":50.0,"channels":{}}"#;
            let pose = format!(r#"{{"pose_position":{{"data":[{x:?},{y:?},0.0],"unit":"m"}}}}"#);
            let sensor = format!(r#"{{"seq":1,"t":1.0,"channels":{pose}}}"#);
            let times = r#""now_s":1.0,"last_sensor_s":1.0"#;
            format!(r#"{{"op":"govern","command":{command},"sensor":{sensor},{times}}}"#)
        };
        let run = |burst: bool| {
            // Half an ulp outside of the fence, which a norm of doubles does not show.
            let near = govern(30.299999999999997, 40.400000000000006);
            let link = format!(r#"{{"op":"note_link","burst":{burst}}}"#);
            let limits =
                r#"{"max_speed_mps":null,"max_tilt_rad":null,"geofence_radius_m":50.5,"command_timeout_ms":500.0}"#;
            let steps = [near, link, govern(1.0, 1.0)].join(",");
            let args = format!(r#"{{"limits":{limits},"capabilities":null,"steps":[{steps}]}}"#);
            let Verdict::Expect(expect) = expected(Call::GovernorRun, &args) else { panic!() };
            expect.to_string()
        };
        assert!(!run(false).contains("estop"), "{}", run(false));
        assert!(run(true).contains("estop"), "{}", run(true));
    }

    #[test]
    fn a_velocity_whose_subnormal_length_rounds_to_the_limit_may_be_scaled() {
        let command = r#"{"channels":{"velocity_setpoint":{"data":[0.0,5e-324,5e-324]}}}"#;
        let step = format!(r#"{{"op":"govern","command":{command},"now_s":1.0,"last_sensor_s":1.0}}"#);
        let args = format!(r#"{{"limits":{{"max_speed_mps":5e-324}},"steps":[{step}]}}"#);
        let Verdict::Expect(expect) = expected(Call::GovernorRun, &args) else { panic!() };
        assert!(!expect.to_string().contains("5e-324,5e-324"), "{}", expect.to_string());
    }

    #[test]
    fn only_a_strict_server_is_asked_at_which_key_a_request_comes() {
        let run = |strict: bool| {
            let version = ncp_text::WIRE_VERSION;
            let frame = format!(r#"{{"ncp_version":"{version}","kind":"close_session","session_id":"a"}}"#);
            let request = crate::fuzz::tree::text(frame);
            expected(
                Call::SessionRun,
                &format!(r#"{{"requests":[{request}],"strict":{strict},"verbs":["step_request"]}}"#),
            )
        };
        assert!(matches!(run(false), Verdict::Open(_)));
        assert!(matches!(run(true), Verdict::Expect(_)));
    }
}
