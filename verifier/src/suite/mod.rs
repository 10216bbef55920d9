//! The suite: the frozen cases, tied to the rules that they test.
//!
//! A [`Suite`] is read from vector files, either those that are built into the program or those of a folder.
//! Reading is strict: an unknown member, a rule that the text does not have, or an id that stands twice is a
//! [`SuiteError`] that names file and case, never a case that silently tests nothing.

mod case;
mod file;
mod filter;
mod flags;
mod packed;
mod pattern;
mod template;

#[cfg(test)]
pub(crate) use case::Text;
pub use case::{By, Case, Expect, Need};
pub use filter::{Pattern, Selection};
pub use flags::{Finding, Flag};
pub use pattern::{PatternError, Shape};
pub use template::{Template, TemplateError};

use std::borrow::Cow;
use std::collections::{BTreeMap, HashMap};
use std::panic::resume_unwind;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

use ncp_text::catalogue::{Catalogue, CatalogueError, Level, Requirement, Role};
use ncp_text::{CONTRACT_HASH, WIRE_VERSION};
use sha2::{Digest as _, Sha256};

use crate::peer::{Call, Description};
use case::Parts;
use packed::Packed;

/// The id of the case of `describe`.
pub(crate) const DESCRIBE: &str = "describe";
/// What the ids of the cases of the deep set begin with.
pub const DEEP: &str = "deep/";
/// Stands for the file of a case that no file holds.
const BUILT_IN: &str = "built in";

include!(concat!(env!("OUT_DIR"), "/embedded.rs"));

/// All cases, with the rules that they cite.
#[derive(Debug)]
pub struct Suite {
    cases: Vec<Case>,
    /// Citing first the contract hash, and first the wire version.
    describe: [Case; 2],
    requirements: Vec<Arc<Requirement>>,
    notes: BTreeMap<String, Vec<String>>,
    digest: String,
    files: usize,
}

/// Why the suite cannot be used. Ends in exit code 4, since no peer is to blame.
#[derive(Debug, thiserror::Error)]
pub enum SuiteError {
    /// The normative text itself is faulty.
    #[error("the normative text: {0}")]
    Catalogue(#[from] CatalogueError),
    /// A folder or a file cannot be read.
    #[error("{}: {source}", path.display())]
    Read {
        /// The folder or the file.
        path: PathBuf,
        /// What the operating system said.
        source: std::io::Error,
    },
    /// A file is not a vector file.
    #[error("{file}: {message}")]
    File {
        /// The file.
        file: String,
        /// What is wrong.
        message: String,
    },
    /// A case is wrong.
    #[error("{file}: the case {id}: {message}")]
    Case {
        /// The file.
        file: String,
        /// The case, or its number if it has no id.
        id: String,
        /// What is wrong.
        message: String,
    },
    /// There is not one case.
    #[error("there is no vector file in {0}")]
    Empty(String),
}

impl Suite {
    /// The suite that is built into the program.
    ///
    /// # Errors
    /// [`SuiteError`] if one of its files is faulty.
    pub fn embedded() -> Result<Self, SuiteError> {
        Self::read(EMBEDDED.iter(), Packed::unpack, "the program")
    }

    /// The suite that is built into the program, and besides it the deep set: cases that a search chose, whose ids
    /// begin with `deep/`.
    ///
    /// # Errors
    /// [`SuiteError`] if one of its files is faulty.
    pub fn with_deep() -> Result<Self, SuiteError> {
        Self::read(EMBEDDED.iter().chain(EMBEDDED_DEEP), Packed::unpack, "the program")
    }

    /// The deep set alone, that is built into the program.
    ///
    /// # Errors
    /// [`SuiteError`] if one of its files is faulty, or there is none.
    pub fn deep() -> Result<Self, SuiteError> {
        Self::read(EMBEDDED_DEEP.iter(), Packed::unpack, "the program")
    }

    /// The suite of a folder: every `<folder>/<area>/<name>.json`.
    ///
    /// # Errors
    /// [`SuiteError`] if the folder cannot be read or one of its files is faulty.
    pub fn load(folder: &Path) -> Result<Self, SuiteError> {
        let mut files = Vec::new();
        for area in entries(folder)?.into_iter().filter(|path| path.is_dir()) {
            for file in entries(&area)?.into_iter().filter(|path| path.extension().is_some_and(|e| e == "json")) {
                let text =
                    std::fs::read_to_string(&file).map_err(|source| SuiteError::Read { path: file.clone(), source })?;
                let name = file.strip_prefix(folder).unwrap_or(&file).to_string_lossy().replace('\\', "/");
                files.push((name, text));
            }
        }
        Self::read(files.iter(), |(name, text)| Ok((name.as_str(), text.into())), &folder.to_string_lossy())
    }

    /// Every case, in the order of the files.
    #[must_use]
    pub fn cases(&self) -> &[Case] {
        &self.cases
    }

    /// The case that every run begins with: what the peer says about itself. No file holds it.
    /// It cites first the rule that the description breaks.
    #[must_use]
    pub fn describe(&self, description: &Description) -> &Case {
        let [hash_first, version_first] = &self.describe;
        let breaks_hash = description.contract_hash != CONTRACT_HASH;
        if breaks_hash || description.wire_version == WIRE_VERSION { hash_first } else { version_first }
    }

    /// Every case, with the one that no file holds before the others.
    pub fn with_describe(&self) -> impl Iterator<Item = &Case> {
        let [describe, _] = &self.describe;
        std::iter::once(describe).chain(&self.cases)
    }

    /// Every rule of the text, in its order, tested or not.
    #[must_use]
    pub fn requirements(&self) -> &[Arc<Requirement>] {
        &self.requirements
    }

    /// What a flag means: the bug class that it catches, in the words of the files that use it.
    #[must_use]
    pub fn notes(&self, flag: &str) -> &[String] {
        self.notes.get(flag).map_or(&[], Vec::as_slice)
    }

    /// Every flag.
    pub fn flags(&self) -> impl Iterator<Item = &str> {
        self.notes.keys().map(String::as_str)
    }

    /// How many files there are.
    #[must_use]
    pub fn files(&self) -> usize {
        self.files
    }

    /// The [`digest`](Self::digest) of the suite that is built into the program, without unpacking it.
    #[must_use]
    pub fn embedded_digest() -> String {
        hex(&Sha256::digest(include_str!("../../../vectors/MANIFEST.sha256")))
    }

    /// The SHA-256 of the list of the files' SHA-256: that of `vectors/MANIFEST.sha256`.
    #[must_use]
    pub fn digest(&self) -> &str {
        &self.digest
    }

    /// The highest level that has a case.
    #[must_use]
    pub fn highest_level(&self) -> Level {
        self.cases.iter().map(|case| case.level).max().unwrap_or(Level::Wire)
    }

    /// The case of this id.
    #[must_use]
    pub fn case(&self, id: &str) -> Option<&Case> {
        self.with_describe().find(|case| case.id == id)
    }

    /// The rule of this id.
    #[must_use]
    pub fn requirement(&self, id: &str) -> Option<&Arc<Requirement>> {
        self.requirements.iter().find(|rule| rule.id == id)
    }

    /// Reads files side by side: `text` makes of each its name and its text, so that few unpacked texts are held.
    fn read<'f, F: Send>(
        files: impl Iterator<Item = F> + Send,
        text: impl Fn(F) -> Result<(&'f str, Cow<'f, str>), SuiteError> + Sync,
        place: &str,
    ) -> Result<Self, SuiteError> {
        let catalogue = Catalogue::load()?;
        let requirements: Vec<_> = catalogue.iter().cloned().map(Arc::new).collect();
        let rules: HashMap<&str, &Arc<Requirement>> =
            requirements.iter().map(|rule| (rule.id.as_str(), rule)).collect();
        let mut cases = Vec::new();
        let mut notes: BTreeMap<String, Vec<String>> = BTreeMap::new();
        let mut manifest = String::new();
        let mut count = 0;
        let read = |file: F| {
            let (name, text) = text(file)?;
            let line = format!("{}  corpus/{name}\n", hex(&Sha256::digest(text.as_bytes())));
            Ok::<_, SuiteError>((file::read(name, &text, &rules)?, line))
        };
        for read in side_by_side(files, read) {
            let (file, line) = read?;
            for (flag, note) in file.notes {
                let known = notes.entry(flag).or_default();
                if !known.contains(&note) {
                    known.push(note);
                }
            }
            cases.extend(file.cases);
            manifest.push_str(&line);
            count += 1;
        }
        if cases.is_empty() {
            return Err(SuiteError::Empty(place.to_owned()));
        }
        foundations(&cases)?;
        let digest = hex(&Sha256::digest(&manifest));
        let describe =
            [describe(&rules, ["NCP-VER-020", "NCP-VER-021"])?, describe(&rules, ["NCP-VER-021", "NCP-VER-020"])?];
        Ok(Self { cases, describe, requirements, notes, digest, files: count })
    }
}

/// What `work` makes of each item, in their order; as many items at a time as there are cores.
fn side_by_side<T, R: Send>(items: impl Iterator<Item = T> + Send, work: impl Fn(T) -> R + Sync) -> Vec<R> {
    let items = Mutex::new(items.enumerate());
    let take = || items.lock().unwrap_or_else(PoisonError::into_inner).next();
    let worker = || std::iter::from_fn(take).map(|(place, item)| (place, work(item))).collect::<Vec<_>>();
    let cores = thread::available_parallelism().map_or(1, usize::from);
    let mut done: Vec<(usize, R)> = thread::scope(|scope| {
        let workers: Vec<_> = (0..cores).map(|_| scope.spawn(worker)).collect();
        let done = workers.into_iter().map(|worker| worker.join().unwrap_or_else(|panic| resume_unwind(panic)));
        done.flatten().collect()
    });
    done.sort_by_key(|(place, _)| *place);
    done.into_iter().map(|(_, made)| made).collect()
}

/// Sees to it that an id stands once, and that a case rests on cases of the suite, and in the end on those that rest on
/// none.
fn foundations(cases: &[Case]) -> Result<(), SuiteError> {
    let fault =
        |case: &Case, message: String| SuiteError::Case { file: case.file.to_string(), id: case.id.clone(), message };
    // Whether a case is known to stand on firm ground.
    let mut laid: HashMap<&str, bool> = HashMap::with_capacity(cases.len());
    let mut waiting: Vec<&Case> = Vec::new();
    for case in cases {
        if laid.insert(&case.id, case.rests_on.is_empty()).is_some() {
            return Err(fault(case, "its id stands twice".to_owned()));
        }
        waiting.extend((!case.rests_on.is_empty()).then_some(case));
    }
    for case in &waiting {
        if let Some(id) = case.rests_on.iter().find(|id| !laid.contains_key(id.as_str())) {
            return Err(fault(case, format!("it rests on {id}, which the suite does not have")));
        }
    }
    while !waiting.is_empty() {
        let count = waiting.len();
        let is_laid = |case: &Case| case.rests_on.iter().all(|id| laid.get(id.as_str()) == Some(&true));
        let (ready, rest): (Vec<&Case>, Vec<&Case>) = waiting.into_iter().partition(|case| is_laid(case));
        laid.extend(ready.iter().map(|case| (case.id.as_str(), true)));
        if let Some(case) = rest.first()
            && rest.len() == count
        {
            return Err(fault(case, "it rests on itself, by way of the cases on which it rests".to_owned()));
        }
        waiting = rest;
    }
    Ok(())
}

/// The case of `describe`.
fn describe(rules: &HashMap<&str, &Arc<Requirement>>, cited: [&str; 2]) -> Result<Case, SuiteError> {
    let fault = |message: String| SuiteError::Case { file: BUILT_IN.to_owned(), id: DESCRIBE.to_owned(), message };
    let cited = cited.map(|id| {
        rules.get(id).map(|rule| Arc::clone(rule)).ok_or_else(|| fault(format!("the text has no rule {id}")))
    });
    let expected = format!(r#"{{"wire_version":"{WIRE_VERSION}","contract_hash":"{CONTRACT_HASH}"}}"#);
    let template = |raw: &str| Template::new(raw).map_err(|error| fault(error.to_string()));
    Ok(Case::new(Parts {
        id: DESCRIBE.to_owned(),
        title: format!(
            "The peer states the wire version and the contract hash of {WIRE_VERSION}, and claims known roles."
        ),
        requirements: cited.into_iter().collect::<Result<_, _>>()?,
        flags: Vec::new(),
        roles: Role::ALL.to_vec(),
        needs: Vec::new(),
        call: Call::Describe,
        args: template("{}")?,
        expect: Expect::Json(template(&expected)?),
        by: By::default(),
        rests_on: Vec::new(),
        why: "Both values stand in chapter 2 of the text; the roles are those of PROTOCOL.md.".to_owned(),
        file: BUILT_IN.into(),
    }))
}

fn entries(folder: &Path) -> Result<Vec<PathBuf>, SuiteError> {
    let read = |source| SuiteError::Read { path: folder.to_owned(), source };
    let mut paths = std::fs::read_dir(folder)
        .map_err(read)?
        .map(|entry| entry.map(|entry| entry.path()))
        .collect::<Result<Vec<_>, _>>()
        .map_err(read)?;
    paths.sort();
    Ok(paths)
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
pub(crate) mod testing {
    //! Cases for the tests of other rooms.

    use super::*;
    use crate::peer::ExpectedFailure;
    use crate::verdict::Baseline;

    /// A case of `decode` that cites these rules.
    pub(crate) fn case(id: &str, rules: &[&str], roles: &[Role]) -> Case {
        decode(id, rules, roles, r#"{"kind":"command_frame","text":"{}"}"#)
    }

    /// The same about one rule, with a frame of so many bytes.
    pub(crate) fn large(id: &str, rule: &str, bytes: usize) -> Case {
        let args = format!(r#"{{"kind":"command_frame","text":{{"$repeat":" ","times":{bytes}}}}}"#);
        decode(id, &[rule], &[Role::Body], &args)
    }

    fn decode(id: &str, rules: &[&str], roles: &[Role], args: &str) -> Case {
        let catalogue = Catalogue::load().unwrap();
        Case::new(Parts {
            id: id.to_owned(),
            title: "A title.".to_owned(),
            requirements: rules.iter().map(|rule| Arc::new(catalogue.get(rule).unwrap().clone())).collect(),
            flags: Vec::new(),
            roles: roles.to_vec(),
            needs: Vec::new(),
            call: Call::Decode,
            args: Template::new(args).unwrap(),
            by: By::default(),
            rests_on: Vec::new(),
            expect: Expect::Accept,
            why: "Why.".to_owned(),
            file: "test.json".into(),
        })
    }

    /// Expected failures, `("case" or "requirement", id)`.
    pub(crate) fn baseline(entries: &[(&str, &str)]) -> Baseline {
        let entry = |(what, id): &(&str, &str)| {
            let known = ExpectedFailure { reason: "known".to_owned(), ..ExpectedFailure::default() };
            let id = Some((*id).to_owned());
            match *what {
                "case" => ExpectedFailure { case: id, ..known },
                _ => ExpectedFailure { requirement: id, ..known },
            }
        };
        Baseline::unchecked(entries.iter().map(entry).collect(), "")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn suite(files: &[(&str, &str)]) -> Result<Suite, SuiteError> {
        Suite::read(files.iter(), |(name, text)| Ok((*name, (*text).into())), "the test")
    }

    fn file(name: &str, ids: &[&str]) -> String {
        let case = |id: &&str| {
            format!(
                r#"{{"id":"{id}","title":"T.","requirements":["NCP-WIRE-010","NCP-WIRE-008"],"flags":["f"],
                "roles":["body"],"call":"decode","args":{{"kind":"command_frame","text":"{{}}"}},
                "expect":{{"reject":"type"}},"why":"W."}}"#
            )
        };
        let cases: Vec<String> = ids.iter().map(case).collect();
        format!(
            "{{\"format\":1,\"area\":\"wire\",\"name\":\"{name}\",\"about\":\"A.\",\
             \"notes\":{{\"f\":\"Catches {name}.\"}},\"cases\":[{}]}}",
            cases.join(",")
        )
    }

    #[test]
    fn the_embedded_suite_is_without_fault() {
        let suite = Suite::embedded().unwrap_or_else(|fault| panic!("{fault}"));
        assert!(suite.cases().len() >= 1200, "{}", suite.cases().len());
        assert_eq!(suite.digest(), Suite::embedded_digest());
    }

    #[test]
    fn cases_find_their_rules_and_flags_their_notes() {
        let (a, b) = (file("a", &["wire/a/x"]), file("b", &["wire/b/x"]));
        let suite = suite(&[("wire/a.json", &a), ("wire/b.json", &b)]).unwrap();
        let case = suite.case("wire/b/x").unwrap();
        assert_eq!(case.requirements[0].id, "NCP-WIRE-010");
        assert!(case.binding);
        assert_eq!(suite.notes("f"), ["Catches a.", "Catches b."]);
        assert_eq!(suite.files(), 2);
        assert_eq!(suite.highest_level(), Level::Wire);
    }

    #[test]
    fn an_id_that_stands_twice_is_an_error_that_names_it() {
        let twice = file("a", &["wire/a/x", "wire/a/x"]);
        let error = suite(&[("wire/a.json", &twice)]).unwrap_err().to_string();
        assert_eq!(error, "wire/a.json: the case wire/a/x: its id stands twice");
    }

    #[test]
    fn a_case_rests_on_a_case_of_the_suite_and_never_on_itself() {
        let resting =
            |on: &str| file("a", &["wire/a/x"]).replace(r#""why":"#, &format!(r#""rests_on":["{on}"],"why":"#));
        for (on, message) in [
            ("wire/a/y", "it rests on wire/a/y, which the suite does not have"),
            ("wire/a/x", "it rests on itself, by way of the cases on which it rests"),
        ] {
            let error = suite(&[("wire/a.json", &resting(on))]).unwrap_err().to_string();
            assert_eq!(error, format!("wire/a.json: the case wire/a/x: {message}"));
        }
    }

    #[test]
    fn the_digest_changes_with_one_character_of_one_file() {
        let (a, b) = (file("a", &["wire/a/x"]), file("a", &["wire/a/x"]).replace("W.", "V."));
        let digest = |text: &str| suite(&[("wire/a.json", text)]).unwrap().digest().to_owned();
        assert_eq!(digest(&a), digest(&a));
        assert_ne!(digest(&a), digest(&b));
        let line = format!("{}  corpus/wire/a.json\n", hex(&Sha256::digest(&a)));
        assert_eq!(digest(&a), hex(&Sha256::digest(line)));
    }

    #[test]
    fn a_suite_without_cases_is_an_error() {
        assert!(matches!(suite(&[]), Err(SuiteError::Empty(place)) if place == "the test"));
    }
}
