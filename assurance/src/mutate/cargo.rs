//! What cargo prints with `--message-format json`, a line each: the members that are asked for.

use std::path::PathBuf;

use serde::Deserialize;

/// A line of cargo's.
#[derive(Debug, Deserialize)]
pub(super) struct Line {
    /// What was built, in a line about that.
    target: Option<Target>,
    /// Where the program is that was built.
    executable: Option<PathBuf>,
    /// What the compiler says, in a line about that.
    pub(super) message: Option<Diagnostic>,
}

#[derive(Debug, Deserialize)]
struct Target {
    name: String,
}

/// What the compiler says.
#[derive(Debug, Deserialize)]
pub(super) struct Diagnostic {
    level: String,
    #[serde(default)]
    message: String,
    /// As it would stand in a terminal.
    #[serde(default)]
    pub(super) rendered: Option<String>,
    #[serde(default)]
    spans: Vec<Span>,
}

#[derive(Debug, Deserialize)]
struct Span {
    file_name: String,
    #[serde(default)]
    is_primary: bool,
    /// The macro whose expansion it stands in.
    expansion: Option<Expansion>,
}

#[derive(Debug, Deserialize)]
struct Expansion {
    span: Box<Span>,
}

/// The lines of an output; what is not one of cargo's is left out.
pub(super) fn lines(output: &[u8]) -> Vec<Line> {
    String::from_utf8_lossy(output).lines().filter_map(|line| serde_json::from_str(line).ok()).collect()
}

/// Where the program of this name was built.
pub(super) fn program(lines: &[Line], name: &str) -> Option<PathBuf> {
    let is_it = |line: &&Line| line.target.as_ref().is_some_and(|target| target.name == name);
    lines.iter().filter(is_it).find_map(|line| line.executable.clone())
}

/// The errors of the compiler.
pub(super) fn errors(lines: &[Line]) -> impl Iterator<Item = &Diagnostic> {
    lines.iter().filter_map(|line| line.message.as_ref()).filter(|message| message.level == "error")
}

impl Diagnostic {
    /// What it says, in a line.
    pub(super) fn said(&self) -> &str {
        &self.message
    }

    /// The files of its primary places, and of the macros in whose expansion these stand. Its notes may name others,
    /// too: traits that have a method of that name, say.
    pub(super) fn files(&self) -> impl Iterator<Item = &str> {
        let primary = self.spans.iter().filter(|span| span.is_primary);
        primary.flat_map(|span| {
            let spans = std::iter::successors(Some(span), |span| span.outer());
            spans.map(|span| span.file_name.as_str())
        })
    }
}

impl Span {
    /// The macro's place, for one in an expansion.
    fn outer(&self) -> Option<&Self> {
        Some(&self.expansion.as_ref()?.span)
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn an_error_of_the_compiler_is_in_the_files_of_its_primary_place_and_not_in_those_of_its_notes() {
        let span = |file: &str, is_primary: bool| json!({ "file_name": file, "is_primary": is_primary });
        let mut expanded = span("kernel.rs", true);
        expanded["expansion"] = json!({ "span": span("m_00018/glue.rs", false), "macro_decl_name": "kernel!" });
        let spans = [span("m_00017/a.rs", true), span("m_00016/a.rs", false), expanded];
        let children = json!([{ "spans": [span("m_00015/a.rs", true)] }]);
        let message = json!({ "level": "error", "spans": spans, "children": children });
        let output = json!({ "reason": "compiler-message", "message": message, "target": {"name": "x"} }).to_string();
        let lines = lines(format!("noise\n{output}\n").as_bytes());
        let files: Vec<&str> = errors(&lines).flat_map(Diagnostic::files).collect();
        assert_eq!(files, ["m_00017/a.rs", "kernel.rs", "m_00018/glue.rs"]);
    }

    #[test]
    fn a_program_is_found_by_its_name() {
        let line = |name: &str| json!({ "target": {"name": name}, "executable": format!("/t/{name}") }).to_string();
        let lines = lines(format!("{}\n{}", line("other"), line("ncp-verify")).as_bytes());
        assert_eq!(program(&lines, "ncp-verify"), Some(PathBuf::from("/t/ncp-verify")));
        assert_eq!(program(&lines, "none"), None);
    }
}
