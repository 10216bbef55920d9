//! What a client accepts as a reply (chapter 4.1).

use thiserror::Error;

use crate::ErrorCode;
use crate::version::{VersionError, check_version};
use crate::wire::{DecodeError, Kind, Message, decode_any, decode_any_strict};

/// Checks the reply to a request, and gives it decoded.
///
/// ```
/// use ncp_spec::reply::{ReplyError, check_reply};
/// use ncp_spec::wire::{CloseSession, Message};
///
/// let request = Message::from(CloseSession { session_id: "uav3".into(), ..Default::default() });
/// assert!(check_reply(&request, br#"{"kind":"session_closed","session_id":"uav3"}"#).is_ok());
///
/// let refused = check_reply(&request, br#"{"kind":"error","error":"no such session"}"#);
/// assert_eq!(refused.unwrap_err().to_string(), "the server reports: no such session");
/// ```
///
/// # Errors
///
/// [`ReplyError`] when the reply is not one to this request, or reports a failure.
pub fn check_reply(request: &Message, reply: &[u8]) -> Result<Message, ReplyError> {
    check(request, || decode_any(reply))
}

/// [`check_reply`] by the strict profile (chapter 12.1): the reply has a version, an error frame
/// aside. `[NCP-STRICT-002]`
///
/// # Errors
///
/// As [`check_reply`], and when the profile rejects the reply.
pub fn check_reply_strict(request: &Message, reply: &[u8]) -> Result<Message, ReplyError> {
    check(request, || decode_any_strict(reply))
}

fn check(request: &Message, decode: impl FnOnce() -> Result<Message, DecodeError>) -> Result<Message, ReplyError> {
    let (expected, asked) = expectation(request).ok_or(ReplyError::NotARequest(request.kind()))?;
    let reply = decode()?; // [NCP-SESS-006]
    let (version, session, failure) = match &reply {
        Message::Error(frame) => {
            return Err(ReplyError::Reported(Some(frame.error.to_string()))); // [NCP-SESS-005]
        }
        Message::SessionOpened(m) => {
            (&m.ncp_version, &m.session_id, (!m.ok).then(|| m.error.as_deref().map(str::to_owned)))
        }
        Message::SessionClosed(m) => (&m.ncp_version, &m.session_id, (!m.ok).then_some(None)),
        Message::ObservationFrame(m) => (&m.ncp_version, &m.session_id, None),
        other => {
            return Err(ReplyError::Kind { expected, found: other.kind() });
        }
    };
    if reply.kind() != expected {
        return Err(ReplyError::Kind { expected, found: reply.kind() }); // [NCP-SESS-001]
    }
    check_version(version, true)?; // [NCP-SESS-003]
    if session != asked {
        return Err(ReplyError::Session { asked: asked.to_owned(), found: session.to_string() }); // [NCP-SESS-002]
    }
    match failure {
        Some(reported) => Err(ReplyError::Reported(reported)), // [NCP-SESS-004]
        None => Ok(reply),                                     // [NCP-SESS-007]
    }
}

/// Why a reply is not accepted.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ReplyError {
    /// The message that was given as the request is none.
    #[error("{0} is not a request")]
    NotARequest(Kind),
    /// `NCP-SESS-006`.
    #[error("the reply is rejected: {0}")]
    Rejected(#[from] DecodeError),
    /// `NCP-SESS-001`.
    #[error("expected {expected}, found {found}")]
    Kind {
        /// The kind that answers the request.
        expected: Kind,
        /// The kind of the reply.
        found: Kind,
    },
    /// `NCP-SESS-002`.
    #[error("asked about session {asked:?}, the reply is about {found:?}")]
    Session {
        /// The request's session.
        asked: String,
        /// The reply's.
        found: String,
    },
    /// `NCP-SESS-003`.
    #[error(transparent)]
    Version(#[from] VersionError),
    /// The server reports a failure, with its text if it gave one (`NCP-SESS-004`, `NCP-SESS-005`).
    #[error("the server reports: {}", .0.as_deref().unwrap_or("a failure, without saying which"))]
    Reported(Option<String>),
}

impl ReplyError {
    /// The reason in one word.
    #[must_use]
    pub const fn code(&self) -> ErrorCode {
        match self {
            Self::Rejected(error) => error.code(),
            Self::Version(error) => error.code(),
            Self::NotARequest(_) | Self::Kind { .. } | Self::Session { .. } | Self::Reported(_) => ErrorCode::Reply,
        }
    }
}

/// The kind that answers a request, and the session that it is about.
fn expectation(request: &Message) -> Option<(Kind, &str)> {
    match request {
        Message::OpenSession(m) => Some((Kind::SessionOpened, &m.session_id)),
        Message::StepRequest(m) => Some((Kind::ObservationFrame, &m.session_id)),
        Message::RunRequest(m) => Some((Kind::ObservationFrame, &m.session_id)),
        Message::CloseSession(m) => Some((Kind::SessionClosed, &m.session_id)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wire::{CloseSession, OpenSession, RunRequest, SensorFrame, StepRequest};

    fn requests() -> [(Message, &'static str); 4] {
        let session_id = || "s1".into();
        [
            (OpenSession { session_id: session_id(), ..Default::default() }.into(), "session_opened"),
            (StepRequest { session_id: session_id(), ..Default::default() }.into(), "observation_frame"),
            (RunRequest { session_id: session_id(), ..Default::default() }.into(), "observation_frame"),
            (CloseSession { session_id: session_id(), ..Default::default() }.into(), "session_closed"),
        ]
    }

    fn check(request: &Message, reply: &str) -> Result<Message, ReplyError> {
        check_reply(request, reply.as_bytes())
    }

    #[test]
    fn each_request_accepts_the_kind_that_answers_it_and_no_other() {
        for (request, answer) in requests() {
            for kind in Kind::ALL.into_iter().filter(|kind| *kind != Kind::Error) {
                let reply = format!(
                    r#"{{"kind":"{kind}","session_id":"s1","controller_id":"c","network":{{}},"duration_ms":1}}"#
                );
                let checked = check(&request, &reply);
                if kind.as_str() == answer {
                    assert_eq!(checked.unwrap().kind(), kind);
                } else {
                    assert!(matches!(checked, Err(ReplyError::Kind { found, .. }) if found == kind));
                }
            }
        }
    }

    #[test]
    fn a_reply_about_another_session_or_of_another_version_is_rejected() {
        for (request, kind) in requests() {
            let other = check(&request, &format!(r#"{{"kind":"{kind}","session_id":"s2"}}"#));
            assert!(matches!(other, Err(ReplyError::Session { .. })), "{other:?}");
            for version in ["0.4", "1.0", "", "x"] {
                let reply = format!(r#"{{"kind":"{kind}","session_id":"s1","ncp_version":"{version}"}}"#);
                assert_eq!(check(&request, &reply).unwrap_err().code(), ErrorCode::Version);
            }
        }
    }

    #[test]
    fn a_failure_is_an_error_with_the_servers_words() {
        let [(open, _), .., (close, _)] = requests();
        let refused = r#"{"kind":"session_opened","session_id":"s1","ok":false,"error":"no NEST"}"#;
        assert_eq!(check(&open, refused), Err(ReplyError::Reported(Some("no NEST".into()))));
        let silent = r#"{"kind":"session_closed","session_id":"s1","ok":false}"#;
        assert_eq!(check(&close, silent), Err(ReplyError::Reported(None)));
        for (request, _) in requests() {
            for frame in [
                r#"{"kind":"error","error":"busy"}"#,
                r#"{"kind":"error","error":"busy","session_id":"s1"}"#,
                r#"{"kind":"error","error":"busy","session_id":"s2"}"#,
            ] {
                assert_eq!(check(&request, frame), Err(ReplyError::Reported(Some("busy".into()))));
            }
        }
    }

    #[test]
    fn a_reply_that_cannot_be_decoded_is_rejected_for_its_own_reason() {
        let [(open, _), (step, _), ..] = requests();
        assert_eq!(check(&open, "[]").unwrap_err().code(), ErrorCode::Malformed);
        assert_eq!(check(&open, r#"{"session_id":"s1"}"#).unwrap_err().code(), ErrorCode::Kind);
        let calibrated = r#"{"kind":"observation_frame","session_id":"s1","calibrated_posterior":true}"#;
        assert_eq!(check(&step, calibrated).unwrap_err().code(), ErrorCode::Provenance);
    }

    #[test]
    fn only_a_request_has_a_reply() {
        let sensor = Message::from(SensorFrame::default());
        let reply = check(&sensor, r#"{"kind":"session_closed","session_id":"s1"}"#);
        assert_eq!(reply, Err(ReplyError::NotARequest(Kind::SensorFrame)));
    }
}
