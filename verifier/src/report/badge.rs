//! A badge for a page: as SVG, and as what shields.io reads.

use serde_json::json;

use super::model::{Exit, Report, State};
use crate::verdict::Conclusion;

/// What a badge says.
struct Badge {
    label: String,
    message: String,
    colour: Colour,
}

#[derive(Clone, Copy)]
enum Colour {
    Good,
    Known,
    Bad,
    Unknown,
}

impl Colour {
    /// By the name that shields.io has for it, and as SVG writes it.
    fn names(self) -> (&'static str, &'static str) {
        match self {
            Self::Good => ("brightgreen", "#2e7d32"),
            Self::Known => ("yellow", "#8a6100"),
            Self::Bad => ("red", "#b3261e"),
            Self::Unknown => ("lightgrey", "#5f6368"),
        }
    }
}

/// Renders a report as an SVG badge.
#[must_use]
pub(super) fn badge(report: &Report) -> String {
    let Badge { label, message, colour } = Badge::of(report);
    let (left, right) = (width(&label), width(&message));
    let (all, middle, fill) = (left + right, left + right / 2, colour.names().1);
    let (label, message, half) = (escape(&label), escape(&message), left / 2);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{all}\" height=\"20\" role=\"img\" \
         aria-label=\"{label}: {message}\">\n<title>{label}: {message}</title>\n\
         <clipPath id=\"r\"><rect width=\"{all}\" height=\"20\" rx=\"3\"/></clipPath>\n\
         <g clip-path=\"url(#r)\"><rect width=\"{left}\" height=\"20\" fill=\"#444\"/>\
         <rect x=\"{left}\" width=\"{right}\" height=\"20\" fill=\"{fill}\"/></g>\n\
         <g fill=\"#fff\" text-anchor=\"middle\" font-family=\"Verdana,DejaVu Sans,sans-serif\" font-size=\"11\">\n\
         <text x=\"{half}\" y=\"14\">{label}</text><text x=\"{middle}\" y=\"14\">{message}</text>\n</g>\n</svg>\n"
    )
}

/// Renders a report as the JSON of a shields.io endpoint.
#[must_use]
pub(super) fn shields(report: &Report) -> String {
    let Badge { label, message, colour } = Badge::of(report);
    let is_error = matches!(colour, Colour::Bad);
    let (colour, _) = colour.names();
    let json = json!({"schemaVersion": 1, "label": label, "message": message, "color": colour, "isError": is_error});
    format!("{json}\n")
}

impl Badge {
    /// What the exit code and the verdicts come down to, in two words.
    fn of(report: &Report) -> Self {
        let checked: Vec<_> = report.peers.iter().filter(|peer| peer.state == State::Checked).collect();
        let are = |conclusion| checked.iter().filter(|peer| peer.conclusion == Some(conclusion)).count();
        let (bad, known) = (are(Conclusion::NotConformant), are(Conclusion::AsExpected));
        let part = if report.asked.partial { " in part" } else { "" };
        let (message, colour) = match report.exit() {
            _ if checked.is_empty() => ("not checked".to_owned(), Colour::Unknown),
            Exit::Conformant if known == 0 => (format!("conformant{part}"), Colour::Good),
            Exit::Conformant => (format!("as expected{part}"), Colour::Known),
            Exit::NotConformant if checked.len() > 1 => {
                (format!("{bad} of {} not conformant", checked.len()), Colour::Bad)
            }
            Exit::NotConformant => ("not conformant".to_owned(), Colour::Bad),
            Exit::Interrupted => ("interrupted".to_owned(), Colour::Unknown),
            Exit::NotStarted | Exit::Usage | Exit::Harness => ("not started".to_owned(), Colour::Unknown),
        };
        Self { label: format!("NCP {} {}", report.wire_version, report.asked.level), message, colour }
    }
}

/// About how many pixels a text takes, with a margin.
fn width(text: &str) -> usize {
    text.chars().count() * 7 + 12
}

/// A text within XML.
pub(super) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c => out.push(c),
        }
    }
    out
}
