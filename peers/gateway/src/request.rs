//! A request as the gateway forwards it, and what answers it.

use ncp_spec::wire::{Kind, MAX_FRAME_BYTES, Message, Text, decode_any};

use crate::failure::{Failure, Refusal};

/// A request that was read and found sound, written anew as one line.
#[derive(Debug, Clone)]
pub(crate) struct Request {
    kind: Kind,
    session: Text,
    line: Vec<u8>,
}

impl Request {
    /// Reads a request.
    ///
    /// # Errors
    /// It is no request that could be served.
    pub(crate) fn read(bytes: &[u8]) -> Result<Self, Refusal> {
        let alone = |failure| Refusal { session: None, failure };
        if bytes.len() > MAX_FRAME_BYTES {
            return Err(alone(Failure::RequestTooLong { len: bytes.len(), limit: MAX_FRAME_BYTES }));
        }
        let message = decode_any(bytes).map_err(|error| alone(error.into()))?; // [NCP-SESS-021]
        let kind = message.kind();
        let session = match message {
            Message::OpenSession(request) => request.session_id,
            Message::StepRequest(request) => request.session_id,
            Message::RunRequest(request) => request.session_id,
            Message::CloseSession(request) => request.session_id,
            _ => return Err(alone(Failure::NotARequest(kind))), // [NCP-SESS-022]
        };
        match one_line(bytes) {
            Ok(line) => Ok(Self { kind, session, line }),
            Err(error) => Err(Refusal { session: Some(session), failure: Failure::Unwritable(error.to_string()) }),
        }
    }

    /// The session that it names.
    pub(crate) const fn session(&self) -> &Text {
        &self.session
    }

    /// Its one line, with the line feed. `[NCP-TRANS-003]`
    pub(crate) fn line(&self) -> &[u8] {
        &self.line
    }

    /// A failure that costs this request.
    pub(crate) fn refusal(&self, failure: Failure) -> Refusal {
        Refusal { session: Some(self.session.clone()), failure }
    }

    /// Whether a reply is one to this request, and if so, whether it is an error frame. That it reports a failure, or
    /// is of another version, the client has to see. `[NCP-SESS-001] [NCP-SESS-002]`
    ///
    /// # Errors
    /// It is no frame, or answers something else.
    pub(crate) fn is_failed_by(&self, reply: &[u8]) -> Result<bool, Failure> {
        let reply = decode_any(reply).map_err(Failure::ReplyRejected)?; // [NCP-TRANS-005]
        let (answers, session) = match &reply {
            Message::SessionOpened(reply) => (self.kind == Kind::OpenSession, Some(&reply.session_id)),
            Message::ObservationFrame(reply) => {
                (matches!(self.kind, Kind::StepRequest | Kind::RunRequest), Some(&reply.session_id))
            }
            Message::SessionClosed(reply) => (self.kind == Kind::CloseSession, Some(&reply.session_id)),
            Message::Error(reply) => (true, reply.session_id.as_ref()),
            _ => (false, None),
        };
        let misfit = |found| Err(Failure::Misfit { asked: self.kind, found });
        match session {
            _ if !answers => misfit(reply.kind().to_string()),
            Some(session) if *session != self.session => misfit(format!("about the session {session:?}")),
            _ => Ok(matches!(reply, Message::Error(_))),
        }
    }
}

/// The same document without the white space between its tokens, and a line feed: what was read as JSON has no other
/// line feed. Every member stays, in its order, and every number as the double that it is. `[NCP-TRANS-004]`
fn one_line(bytes: &[u8]) -> Result<Vec<u8>, serde_json::Error> {
    let document: serde_json::Value = serde_json::from_slice(bytes)?;
    let mut line = serde_json::to_vec(&document)?;
    line.push(b'\n');
    Ok(line)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(bytes: &str) -> Request {
        Request::read(bytes.as_bytes()).unwrap()
    }

    /// `[NCP-TRANS-003] [NCP-TRANS-004]`
    #[test]
    fn a_request_is_one_line_whatever_its_white_space_and_loses_nothing() {
        let request = read(
            "{\r\n\"kind\":\n\"step_request\",\t\"session_id\" : \"s\",\n\
             \"x\": [1,\n0.1, -0.0, 1e300, \"a\\nb\u{2028}\"]\n}\n",
        );
        let line = "{\"kind\":\"step_request\",\"session_id\":\"s\",\"x\":[1,0.1,-0.0,1e+300,\"a\\nb\u{2028}\"]}\n";
        assert_eq!(String::from_utf8_lossy(request.line()), line);
        assert_eq!(request.session(), "s");
    }

    /// `[NCP-SESS-021] [NCP-SESS-022]`
    #[test]
    fn what_is_no_single_request_is_refused() {
        let two = concat!(
            r#"{"kind":"close_session","session_id":"s"}"#,
            "\n",
            r#"{"kind":"close_session","session_id":"t"}"#
        );
        for bytes in
            ["", "\n", "[]", "{}", "no frame", two, r#"{"kind":"step_request","session_id":"a","session_id":"b"}"#]
        {
            let refused = Request::read(bytes.as_bytes()).unwrap_err();
            assert_eq!(refused.failure.cause(), "request_rejected", "{bytes}");
        }
        let refused = Request::read(br#"{"kind":"sensor_frame"}"#).unwrap_err();
        assert_eq!(refused.failure, Failure::NotARequest(Kind::SensorFrame));
        let long = vec![b' '; MAX_FRAME_BYTES + 1];
        assert_eq!(Request::read(&long).unwrap_err().failure.cause(), "request_too_long");
    }

    #[test]
    fn only_the_reply_to_the_request_fits_it() {
        let step = read(r#"{"kind":"step_request","session_id":"s"}"#);
        assert_eq!(step.is_failed_by(br#"{"kind":"observation_frame","session_id":"s"}"#), Ok(false));
        assert_eq!(step.is_failed_by(br#"{"kind":"error","error":"no"}"#), Ok(true));
        for (reply, cause) in [
            (r#"{"kind":"observation_frame","session_id":"t"}"#, "misfit"),
            (r#"{"kind":"session_closed","session_id":"s"}"#, "misfit"),
            (r#"{"kind":"step_request","session_id":"s"}"#, "misfit"),
            (r#"{"kind":"error","error":"no","session_id":"t"}"#, "misfit"),
            (r#"{"kind":"observation_frame","session_id":"#, "reply_rejected"),
            (r#"{"kind":"observation_frame","session_id":"s","calibrated_posterior":true}"#, "reply_rejected"),
        ] {
            assert_eq!(step.is_failed_by(reply.as_bytes()).unwrap_err().cause(), cause, "{reply}");
        }
    }
}
