//! How the command talks: colours and widths, and how it is interrupted.

use std::io::{self, IsTerminal as _};

use ncp_verifier::report::Style;
use ncp_verifier::run::Stop;

/// How wide a line is where nothing says so.
const WIDTH: usize = 100;

/// How to write to stdout and to stderr.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Styles {
    pub(crate) out: Style,
    pub(crate) error: Style,
}

impl Styles {
    /// As the terminals, NO_COLOR and COLUMNS want it.
    pub(crate) fn detect() -> Self {
        let plain = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
        let width = std::env::var("COLUMNS").ok().and_then(|columns| columns.parse().ok()).unwrap_or(WIDTH);
        let style = |terminal: bool| Style { colour: terminal && !plain, width: width.clamp(40, 160) };
        Self { out: style(io::stdout().is_terminal()), error: style(io::stderr().is_terminal()) }
    }
}

/// What Ctrl-C and a request to terminate set; the second time, they end the program at once.
///
/// # Errors
/// The signals cannot be handled.
pub(crate) fn stop() -> io::Result<Stop> {
    let stop = Stop::default();
    for signal in [signal_hook::consts::SIGINT, signal_hook::consts::SIGTERM] {
        signal_hook::flag::register_conditional_shutdown(signal, 130, stop.flag())?;
        signal_hook::flag::register(signal, stop.flag())?;
    }
    Ok(stop)
}

/// A number of things, in words.
pub(crate) fn counted(count: usize, thing: &str) -> String {
    format!("{count} {thing}{}", if count == 1 { "" } else { "s" })
}
