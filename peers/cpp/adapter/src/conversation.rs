//! The conversation: requests in, answers out, a line each.

use std::borrow::Cow;
use std::io::{self, BufRead as _, BufReader, Read, Write};

use serde::Deserialize;
use serde_json::value::RawValue;

use crate::calls::{CallError, Peer};

/// Answers every request of `input` on `output`, in order, until the input ends. Answers are sent on
/// when no further complete request waits.
///
/// # Errors
/// Input that cannot be read, or output that cannot be written.
pub(crate) fn hold(peer: &Peer<'_>, mut input: BufReader<impl Read>, mut output: impl Write) -> io::Result<()> {
    let mut line = Vec::new();
    loop {
        if !input.buffer().contains(&b'\n') {
            output.flush()?;
        }
        line.clear();
        if input.read_until(b'\n', &mut line)? == 0 {
            return output.flush();
        }
        match serde_json::from_slice::<Request<'_>>(&line) {
            Ok(Request { id, call, args }) => {
                let answer = match peer.answer(&call, args) {
                    Ok(result) => serde_json::json!({ "result": result }),
                    Err(CallError::Refused { code, message }) => {
                        serde_json::json!({ "error": { "code": code, "message": message } })
                    }
                    Err(CallError::Unsupported) => serde_json::json!({ "unsupported": true }),
                };
                // The id goes back as it came, digit for digit.
                let answer = answer.to_string();
                writeln!(output, "{{\"id\":{id},{}", answer.get(1..).unwrap_or("}"))?;
            }
            Err(_) if line.trim_ascii().is_empty() => {}
            Err(error) => eprintln!("ncp-peer-cpp-adapter: not a request: {error}"),
        }
    }
}

/// The envelope of a request. What the call needs of `args` is parsed by the call.
#[derive(Deserialize)]
struct Request<'a> {
    #[serde(borrow)]
    id: &'a RawValue,
    #[serde(borrow)]
    call: Cow<'a, str>,
    #[serde(borrow)]
    args: &'a RawValue,
}
