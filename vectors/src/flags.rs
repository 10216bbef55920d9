//! The bug classes and the audited findings that cases are flagged with, as `flags.toml` and `findings.toml` list them.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use serde::Deserialize;

/// A bug class.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Flag {
    description: String,
    /// What it belongs to, and what comes of it: for those who read the file or ask the verifier.
    #[serde(rename = "class")]
    _class: String,
    #[serde(rename = "effect")]
    _effect: String,
    /// First rules of cases that are flagged so if they name no flag.
    #[serde(default)]
    usual: Vec<String>,
    /// Areas and files of such cases.
    #[serde(default)]
    files: Vec<String>,
}

/// An audited finding; the verifier shows the rest of it.
#[derive(Debug, Deserialize)]
struct Finding {
    title: String,
    #[serde(default)]
    usual: Vec<String>,
}

static FLAGS: LazyLock<BTreeMap<String, Flag>> =
    LazyLock::new(|| toml::from_str(include_str!("../flags.toml")).unwrap_or_default());
static FINDINGS: LazyLock<BTreeMap<String, Finding>> =
    LazyLock::new(|| toml::from_str(include_str!("../findings.toml")).unwrap_or_default());

/// What a flag says: the bug class that its cases catch, in one sentence.
pub(crate) fn note(flag: &str) -> String {
    match FINDINGS.get(flag) {
        Some(finding) => format!("Audited finding {flag}: {}", finding.title),
        None => FLAGS.get(flag).map_or_else(String::new, |flag| flag.description.clone()),
    }
}

/// The bug class of a case that names none: what breaks the rule that it is about, or else what a failure of the file's
/// cases comes from.
pub(crate) fn usual(area: &str, name: &str, rule: &str) -> Option<&'static str> {
    let is_of = |items: &[String], wanted: &str| items.iter().any(|item| item == wanted);
    let finding = FINDINGS.iter().find(|(_, finding)| is_of(&finding.usual, rule)).map(|(id, _)| id);
    let of = |wanted: &dyn Fn(&Flag) -> bool| FLAGS.iter().find(|(_, flag)| wanted(flag)).map(|(name, _)| name);
    let of_rule = finding.or_else(|| of(&|flag| is_of(&flag.usual, rule)));
    let of_file = || of(&|flag| is_of(&flag.files, &format!("{area}/{name}")));
    let of_area = || of(&|flag| is_of(&flag.files, area));
    of_rule.or_else(of_file).or_else(of_area).map(String::as_str)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_files_are_read_and_every_note_is_a_sentence() {
        assert!(toml::from_str::<BTreeMap<String, Flag>>(include_str!("../flags.toml")).is_ok());
        assert!(FLAGS.len() > 150 && FINDINGS.len() == 35);
        assert!(FLAGS.keys().chain(FINDINGS.keys()).all(|flag| note(flag).ends_with('.')));
    }
}
