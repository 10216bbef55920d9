//! The changes that change no behaviour, and why: `proofs/equivalent.toml`.

use std::collections::BTreeMap;
use std::fs;

use ncp_defects::place;
use serde::Deserialize;
use xtask::project::Project;

use super::{Mutant, MutateError};

pub(super) const EXPLAINED: &str = "proofs/equivalent.toml";

/// Why a change that nobody refutes leaves the behaviour as it is.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Explained {
    /// The file, from the root of the repository.
    file: String,
    /// Code around the token, white space and trailing commas aside.
    text: String,
    /// Where in the text the token begins, in characters, from 1 on.
    column: usize,
    from: String,
    to: String,
    pub(super) reason: String,
    /// Where in the file that is, in bytes: once for every place of the text.
    #[serde(skip)]
    places: Vec<usize>,
}

/// Reads them, and finds their places.
///
/// # Errors
/// The file cannot be read, is not of the form, or gives no reason.
pub(super) fn read(project: &Project, sources: &BTreeMap<String, String>) -> Result<Vec<Explained>, MutateError> {
    #[derive(Deserialize)]
    #[serde(deny_unknown_fields)]
    struct File {
        change: Vec<Explained>,
    }

    let path = project.path(EXPLAINED);
    let text = fs::read_to_string(&path).map_err(|source| MutateError::File { path: path.clone(), source })?;
    let wrong = |source| MutateError::Explained { path: path.clone(), source: Box::new(source) };
    let file: File = toml::from_str(&text).map_err(wrong)?;
    let mut changes = file.change;
    for change in &mut changes {
        if change.reason.is_empty() {
            return Err(MutateError::NoReason { path, text: change.text.clone() });
        }
        let source = sources.get(&change.file).map_or("", String::as_str);
        let offset = change.text.chars().take(change.column.saturating_sub(1)).map(char::len_utf8).sum();
        change.places = place::places_of(source, &change.text, offset);
    }
    Ok(changes)
}

impl Explained {
    /// Whether it is about this change.
    pub(super) fn is_of(&self, mutant: &Mutant) -> bool {
        self.file == mutant.file
            && self.places.contains(&mutant.change.start)
            && self.from == mutant.change.from
            && self.to == mutant.change.to
    }
}

/// The explanations that are about no change of the kernel as it is, a line each.
pub(super) fn stale(explained: &[Explained], mutants: &[Mutant]) -> Vec<String> {
    let is_stale = |entry: &&Explained| !mutants.iter().any(|mutant| entry.is_of(mutant));
    let lines = explained.iter().filter(is_stale).map(|entry| {
        let Explained { file, text, from, to, .. } = entry;
        format!("{EXPLAINED}: {file} has no change of {from:?} to {to:?} in {text:?}")
    });
    lines.collect()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::super::{mutants, sources};
    use super::*;

    #[test]
    fn every_explanation_is_of_a_change_that_there_is() {
        let project = Project::at(Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap());
        let sources = sources(&project).unwrap();
        let explained = read(&project, &sources).unwrap();
        assert_eq!(stale(&explained, &mutants(&sources)), Vec::<String>::new());
    }

    #[test]
    fn a_formatter_makes_no_explanation_stale_and_a_change_of_the_code_does() {
        let mutants = |text: &str| {
            let sources = [("a.rs".to_owned(), text.to_owned()), (super::super::VOCABULARY.to_owned(), String::new())];
            mutants(&BTreeMap::from(sources))
        };
        let explained = |source: &str| Explained {
            file: "a.rs".to_owned(),
            text: "if a < b {".to_owned(),
            column: 6,
            from: "<".to_owned(),
            to: "!=".to_owned(),
            reason: "It is.".to_owned(),
            places: place::places_of(source, "if a < b {", 5),
        };
        let source = "fn f() {\n    if a\n        < b\n    {\n        c();\n    }\n}\n";
        assert!(stale(&[explained(source)], &mutants(source)).is_empty());
        let changed = source.replace("< b", "< c");
        assert_eq!(stale(&[explained(&changed)], &mutants(&changed)).len(), 1);
    }
}
