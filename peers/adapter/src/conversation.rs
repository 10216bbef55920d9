//! The conversation: requests in, answers out, a line each.

use std::borrow::Cow;
use std::io::{self, BufRead, BufReader, BufWriter, Read, Write};
use std::panic::{self, AssertUnwindSafe};

use serde::{Deserialize, Serialize};

use crate::error::CallError;
use crate::json::{self, Raw};
use crate::peer::{self, Peer};
use crate::reply::Reply;

/// As much as a pipe holds, in bytes: a larger buffer would never be filled by one read.
const BUFFER: usize = 64 << 10;

/// Holds the conversation on standard input and output: the whole of an adapter's `main`.
///
/// # Errors
/// As [`hold`].
pub fn serve(peer: &impl Peer) -> io::Result<()> {
    let input = BufReader::with_capacity(BUFFER, io::stdin().lock());
    hold(peer, input, BufWriter::with_capacity(BUFFER, io::stdout().lock()))
}

/// Answers every request of `input` on `output`, in order, until the input ends.
///
/// The answers are sent on when no further complete request waits, so a verifier that
/// sends many requests at once costs few writes, and one that waits for an answer gets it.
/// A line that is not a request has no id to answer to: it is reported on standard
/// error, and the conversation goes on.
///
/// # Errors
/// Input that cannot be read, or output that cannot be written.
pub fn hold(peer: &impl Peer, mut input: BufReader<impl Read>, mut output: impl Write) -> io::Result<()> {
    let mut line = Vec::new();
    loop {
        if !input.buffer().contains(&b'\n') {
            output.flush()?;
        }
        line.clear();
        if input.read_until(b'\n', &mut line)? == 0 {
            return output.flush();
        }
        match request(&line) {
            Ok(Request { id, call, args }) => {
                let outcome = guarded(|| peer::answer(peer, &call, args));
                write_answer(&mut output, id, &outcome)?;
            }
            Err(_) if line.trim_ascii().is_empty() => {}
            Err(error) => eprintln!("not a request: {error:?}"),
        }
    }
}

/// An answer to a call.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Answer {
    /// The call was carried out.
    Result(
        /// The object `result`, as JSON text.
        String,
    ),
    /// The implementation refused, or it panicked: then the code is `internal`.
    Error {
        /// Why.
        code: Cow<'static, str>,
        /// Why, in words.
        message: String,
    },
    /// The peer does not support the call.
    Unsupported,
}

/// Answers one call in this process, as the program would; `args` is the JSON text of its arguments.
#[must_use]
pub fn ask(peer: &impl Peer, call: &str, args: &str) -> Answer {
    let outcome = guarded(|| {
        let args = json::read(args).map_err(CallError::misfit)?;
        let reply = peer::answer(peer, call, args)?;
        json::write(&reply).map_err(CallError::internal)
    });
    match outcome {
        Ok(result) => Answer::Result(result),
        Err(CallError::Refused { code, message }) => Answer::Error { code, message },
        Err(CallError::Unsupported) => Answer::Unsupported,
    }
}

/// The envelope of a request. What the call needs of `args` is parsed by the call.
#[derive(Deserialize)]
struct Request<'a> {
    #[serde(borrow)]
    id: Raw<'a>,
    #[serde(borrow)]
    call: Cow<'a, str>,
    #[serde(borrow)]
    args: Raw<'a>,
}

/// Carries out one call, and turns a panic into the answer `internal`.
///
/// An implementation must not panic whatever it is given. If it does, the panic is an answer to the
/// request that caused it, with its message, and the requests behind it are spared.
fn guarded<T>(call: impl FnOnce() -> Result<T, CallError>) -> Result<T, CallError> {
    // Nothing that a panic leaves half done is seen again: every call starts from its arguments alone.
    panic::catch_unwind(AssertUnwindSafe(call)).unwrap_or_else(|payload| {
        let text = payload.downcast_ref::<&str>().copied();
        let text = text.or_else(|| payload.downcast_ref::<String>().map(String::as_str));
        Err(CallError::internal(format_args!("panic: {}", text.unwrap_or("without a message"))))
    })
}

/// Reads the envelope of a line.
fn request(line: &[u8]) -> Result<Request<'_>, CallError> {
    json::read(std::str::from_utf8(line).map_err(CallError::internal)?).map_err(CallError::internal)
}

/// The id goes back as it came, digit for digit.
fn write_answer(output: &mut impl Write, id: Raw<'_>, outcome: &Result<Reply<'_>, CallError>) -> io::Result<()> {
    #[derive(Serialize)]
    struct Error<'a> {
        code: &'a str,
        message: &'a str,
    }

    let (member, value) = match outcome {
        Ok(reply) => ("result", json::write(reply)),
        Err(CallError::Refused { code, message }) => ("error", json::write(&Error { code, message })),
        Err(CallError::Unsupported) => ("unsupported", json::write(&true)),
    };
    writeln!(output, "{{\"id\":{id},\"{member}\":{}}}", value.map_err(io::Error::other)?)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]
mod tests {
    use super::*;
    use crate::reply::Description;

    struct Nobody;

    impl Peer for Nobody {
        type Error = CallError;

        fn describe(&self) -> Result<Description<'_>, CallError> {
            Err(CallError::Unsupported)
        }
    }

    /// A writer that notes what had been written whenever it is flushed.
    #[derive(Default)]
    struct Flushes {
        written: usize,
        flushed: Vec<usize>,
    }

    impl Write for &mut Flushes {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            self.written += bytes.iter().filter(|byte| **byte == b'\n').count();
            Ok(bytes.len())
        }

        fn flush(&mut self) -> io::Result<()> {
            self.flushed.push(self.written);
            Ok(())
        }
    }

    #[test]
    fn a_panic_in_a_call_is_answered_as_internal() {
        for (call, said) in [
            (guarded::<()>(|| panic!("boom")), "panic: boom"),
            (guarded(|| panic!("boom {}", 7)), "panic: boom 7"),
            (guarded(|| panic::panic_any(7)), "panic: without a message"),
        ] {
            assert_eq!(call, Err(CallError::internal(said)));
        }
    }

    #[test]
    fn answers_are_sent_on_once_for_all_requests_that_wait() {
        let requests = "{\"id\":1,\"call\":\"nonsense\",\"args\":{}}\n".repeat(100);
        let mut output = Flushes::default();
        hold(&Nobody, BufReader::with_capacity(1 << 16, requests.as_bytes()), &mut output).unwrap();
        assert_eq!(output.flushed, [0, 100, 100]);
    }

    #[test]
    fn a_half_request_does_not_hold_back_the_answer_before_it() {
        let input = "{\"id\":1,\"call\":\"nonsense\",\"args\":{}}\n{\"id\":2,";
        let mut output = Flushes::default();
        hold(&Nobody, BufReader::new(input.as_bytes()), &mut output).unwrap();
        assert!(output.flushed.contains(&1));
    }

    #[test]
    fn an_id_goes_back_as_it_came() {
        let mut output = Vec::new();
        hold(
            &Nobody,
            BufReader::new(&b"{\"id\":18446744073709551616,\"call\":\"decode\",\"args\":{}}\n"[..]),
            &mut output,
        )
        .unwrap();
        assert!(output.starts_with(b"{\"id\":18446744073709551616,\"error\":"));
    }
}
