//! The lines of the peer protocol, `peers/PROTOCOL.md` sections 1, 3 and 4.

use crate::json::{Json, JsonError};

/// The longest request that is ever sent, in bytes.
pub const MAX_REQUEST_BYTES: usize = 160 << 20;

macro_rules! calls {
    ($($(#[$doc:meta])* $variant:ident = $name:literal),+ $(,)?) => {
        /// A call of the peer protocol.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Call { $($(#[$doc])* $variant),+ }

        impl Call {
            /// Every call, in the order of PROTOCOL.md.
            pub const ALL: &[Self] = &[$(Self::$variant),+];

            /// The name that travels.
            #[must_use]
            pub fn as_str(self) -> &'static str {
                match self { $(Self::$variant => $name),+ }
            }
        }
    };
}

calls! {
    /// Who are you?
    Describe = "describe",
    /// Reads a frame and writes what was read.
    Decode = "decode",
    /// Builds a message and writes it.
    Encode = "encode",
    /// The version guard.
    VersionCheck = "version.check",
    /// Compares a contract hash.
    ContractStatus = "contract.status",
    /// Insists on a contract hash.
    ContractVerify = "contract.verify",
    /// The version guard, then the contract status.
    Negotiate = "negotiate",
    /// Builds a key.
    KeyBuild = "key.build",
    /// Matches a key expression against a key.
    KeyMatch = "key.match",
    /// The transport settings of a plane.
    PlaneQos = "plane.qos",
    /// Reads a BulkBlock.
    BulkDecode = "bulk.decode",
    /// Writes a BulkBlock.
    BulkEncode = "bulk.encode",
    /// Packs an observation into a BulkBlock.
    ObservationPack = "observation.pack",
    /// Reads an observation from a BulkBlock.
    ObservationUnpack = "observation.unpack",
    /// What a client does with a reply.
    ReplyCheck = "reply.check",
    /// A trace of the safety governor.
    GovernorRun = "governor.run",
    /// A trace of the command watchdog.
    WatchdogRun = "watchdog.run",
    /// A trace of the action buffer.
    BufferRun = "buffer.run",
    /// The longest horizon.
    HorizonMaxLen = "horizon.max_len",
    /// A trace of the link monitor.
    LinkRun = "link.run",
    /// Sensor channels to rates.
    CodecEncode = "codec.encode",
    /// Rates to a command.
    CodecDecode = "codec.decode",
    /// One step of the reflex controller.
    ReflexStep = "reflex.step",
    /// A trace of the control loop.
    LoopRun = "loop.run",
    /// Requests to a server, in order.
    SessionRun = "session.run",
}

impl Call {
    /// The call of this name.
    #[must_use]
    pub fn parse(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|call| call.as_str() == name)
    }
}

/// One line of a peer, taken apart.
#[derive(Debug, Clone, PartialEq)]
pub struct Reply<'a> {
    /// The request that it answers.
    pub id: u64,
    /// What it says.
    pub answer: Answer<'a>,
}

/// What a peer says to a request.
#[derive(Debug, Clone, PartialEq)]
pub enum Answer<'a> {
    /// It did it.
    Result(Json<'a>),
    /// It refused.
    Error {
        /// The reason, from the list in PROTOCOL.md.
        code: String,
        /// The reason, for people.
        message: String,
    },
    /// It has no such function.
    Unsupported,
}

/// Why a line is no answer.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ReplyFault {
    /// Not UTF-8.
    #[error("the line is not UTF-8")]
    Utf8,
    /// Not JSON, or an object in it has a member twice.
    #[error("the line is not JSON: {0}")]
    Json(#[from] JsonError),
    /// Not an object with an `id`.
    #[error("the line is no answer: it has no integer `id`")]
    NoId,
    /// The `id` is there, the rest is not right.
    #[error("{why}")]
    Shape {
        /// The request that it answers.
        id: u64,
        /// What is wrong.
        why: &'static str,
    },
}

impl<'a> Reply<'a> {
    /// Takes one line apart.
    ///
    /// # Errors
    /// [`ReplyFault`] if the line is no answer by section 1 of PROTOCOL.md.
    pub fn parse(line: &'a [u8]) -> Result<Self, ReplyFault> {
        let text = std::str::from_utf8(line).map_err(|_| ReplyFault::Utf8)?;
        let Json::Object(members) = Json::parse(text)? else {
            return Err(ReplyFault::NoId);
        };
        let (mut id, mut result, mut error, mut unsupported) = (None, None, None, None);
        for (name, value) in members {
            match name.as_ref() {
                "id" => id = Some(value),
                "result" => result = Some(value),
                "error" => error = Some(value),
                "unsupported" => unsupported = Some(value),
                _ => {}
            }
        }
        let Some(Json::Number(spelling)) = id else {
            return Err(ReplyFault::NoId);
        };
        let id = spelling.parse().map_err(|_| ReplyFault::NoId)?;
        let wrong = |why| Err(ReplyFault::Shape { id, why });
        let answer = match (result, error, unsupported) {
            (Some(result), None, None) => Answer::Result(result),
            (None, Some(error), None) => match error.get("code").and_then(Json::as_str) {
                Some(code) => Answer::Error {
                    code: code.to_owned(),
                    message: error.get("message").and_then(Json::as_str).unwrap_or_default().to_owned(),
                },
                None => return wrong("the answer's `error` has no string `code`"),
            },
            (None, None, Some(Json::Bool(true))) => Answer::Unsupported,
            (None, None, Some(_)) => return wrong("the answer's `unsupported` is not `true`"),
            (None, None, None) => {
                return wrong("the answer has none of `result`, `error` and `unsupported`");
            }
            _ => {
                return wrong("the answer has more than one of `result`, `error` and `unsupported`");
            }
        };
        Ok(Self { id, answer })
    }
}

/// Appends one request line. `body` is the rest of the object after its `id`: `"call":…,"args":…}`.
pub fn write_request(out: &mut Vec<u8>, id: u64, body: &str) {
    put_request(out, id, |out| out.extend_from_slice(body.as_bytes()));
}

/// As [`write_request`], with what appends the body.
pub(crate) fn put_request(out: &mut Vec<u8>, id: u64, body: impl FnOnce(&mut Vec<u8>)) {
    out.extend_from_slice(b"{\"id\":");
    out.extend_from_slice(id.to_string().as_bytes());
    out.push(b',');
    body(out);
    out.push(b'\n');
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_three_forms_of_an_answer_are_read() {
        let reply = Reply::parse(br#"{"id":7,"result":{"compatible":false}}"#).unwrap();
        assert_eq!(reply.id, 7);
        assert!(matches!(reply.answer, Answer::Result(result) if result.get("compatible") == Some(&Json::Bool(false))));
        let reply = Reply::parse(b"{\"error\":{\"code\":\"type\",\"message\":\"m\"},\"id\":0}\r").unwrap();
        assert_eq!(reply.answer, Answer::Error { code: "type".into(), message: "m".into() });
        assert_eq!(Reply::parse(br#"{"id":1,"unsupported":true}"#).unwrap().answer, Answer::Unsupported);
    }

    #[test]
    fn a_line_that_is_no_answer_says_what_it_lacks() {
        let fault = |line: &str| Reply::parse(line.as_bytes()).unwrap_err().to_string();
        assert_eq!(fault("hello"), "the line is not JSON: expected a JSON value at byte 0");
        assert_eq!(fault("[1]"), "the line is no answer: it has no integer `id`");
        assert_eq!(fault(r#"{"id":"1","result":{}}"#), "the line is no answer: it has no integer `id`");
        assert_eq!(fault(r#"{"id":-1,"result":{}}"#), "the line is no answer: it has no integer `id`");
        assert_eq!(fault(r#"{"id":1}"#), "the answer has none of `result`, `error` and `unsupported`");
        assert_eq!(
            fault(r#"{"id":1,"result":{},"unsupported":true}"#),
            "the answer has more than one of `result`, `error` and `unsupported`"
        );
        assert_eq!(fault(r#"{"id":1,"unsupported":false}"#), "the answer's `unsupported` is not `true`");
        assert_eq!(fault(r#"{"id":1,"error":"no"}"#), "the answer's `error` has no string `code`");
        assert!(fault(r#"{"id":1,"id":2,"result":{}}"#).contains("stands twice"));
        assert_eq!(Reply::parse(&[0xff, 0xfe]).unwrap_err(), ReplyFault::Utf8);
    }

    #[test]
    fn every_call_is_found_by_its_name() {
        for call in Call::ALL {
            assert_eq!(Call::parse(call.as_str()), Some(*call));
        }
        assert_eq!(Call::parse("decode "), None);
    }

    proptest! {
        #[test]
        fn no_line_makes_the_reader_panic(line in prop::collection::vec(any::<u8>(), 0..200)) {
            let _ = Reply::parse(&line);
        }
    }
}
