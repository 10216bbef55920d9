//! Which roles read and which write a frame of a kind.

use crate::case::Role::{self, Body, Commander, Observer, Server};

/// The roles that read frames of a kind.
pub(crate) fn readers(kind: &str) -> &'static [Role] {
    match kind {
        "open_session" | "step_request" | "run_request" | "close_session" | "stimulus_frame" => &[Server],
        "session_opened" | "session_closed" | "error" => &[Commander],
        "observation_frame" | "sensor_frame" | "link_status" => &[Commander, Observer],
        "command_frame" => &[Body, Observer],
        "control_status" => &[Observer],
        "capabilities" => &[Commander, Body, Observer],
        _ => &[],
    }
}

/// The roles that write frames of a kind.
pub(crate) fn writers(kind: &str) -> &'static [Role] {
    match kind {
        "command_frame" | "control_status" | "open_session" | "step_request" | "run_request" | "close_session"
        | "stimulus_frame" => &[Commander],
        "sensor_frame" | "link_status" => &[Body],
        "capabilities" => &[Commander, Body],
        "session_opened" | "observation_frame" | "session_closed" | "error" => &[Server],
        _ => &[],
    }
}

/// Kinds of which each role reads at least one: where the kind does not matter, a case is made for
/// each of these.
pub(crate) const ANY: [&str; 3] = ["sensor_frame", "command_frame", "close_session"];

/// `A` or `An`, and the kind or message.
pub(crate) fn a(kind: &str) -> String {
    let is_vowel = |c: char| "aeiouAEIOU".contains(c);
    let article = if kind.starts_with(is_vowel) { "An" } else { "A" };
    format!("{article} `{kind}`")
}
