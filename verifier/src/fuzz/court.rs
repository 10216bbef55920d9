//! Judging a disagreement exactly as `ncp-verify run --vectors` would: as a case in a vector file, by the same reader
//! and the same judge.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

use ncp_text::catalogue::Role;

use super::tree::{Tree, list, object, set, text};
use crate::check::{self, Judgement};
use crate::json::Json;
use crate::peer::{Answer, Call, Reply, ReplyFault};
use crate::suite::{Suite, SuiteError};

/// The area and the name of the file.
pub(crate) const AREA: &str = "fuzz";
const NAME: &str = "found";

/// A question, what is asked of its answer, and the rule and the role by which the case is one.
#[derive(Debug, Clone)]
pub(crate) struct Question<'q> {
    pub(crate) call: Call,
    pub(crate) args: &'q Tree,
    pub(crate) expect: &'q Tree,
    pub(crate) rules: Vec<String>,
    pub(crate) role: Role,
}

/// What cannot be judged.
#[derive(Debug, thiserror::Error)]
pub enum CourtError {
    /// The folder for the file cannot be written.
    #[error("{}: {source}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// What the operating system said.
        source: std::io::Error,
    },
    /// The file is none.
    #[error("what was found makes no case: {0}")]
    Suite(#[from] SuiteError),
}

/// A folder with a vector file of the cases at hand.
#[derive(Debug)]
pub(crate) struct Court {
    folder: PathBuf,
}

impl Court {
    /// A folder of its own.
    ///
    /// # Errors
    /// It cannot be made.
    pub(crate) fn open() -> Result<Self, CourtError> {
        static NEXT: AtomicU64 = AtomicU64::new(0);
        let name = format!("ncp-fuzz-{}-{}", std::process::id(), NEXT.fetch_add(1, Ordering::Relaxed));
        let folder = std::env::temp_dir().join(name);
        let area = folder.join(AREA);
        std::fs::create_dir_all(&area).map_err(|source| CourtError::Write { path: area, source })?;
        Ok(Self { folder })
    }

    /// Judges the answers to questions, each a line of a peer.
    ///
    /// # Errors
    /// The cases cannot be written or read.
    pub(crate) fn judge(&self, asked: &[(Question<'_>, &[u8])]) -> Result<Vec<Judgement>, CourtError> {
        if asked.is_empty() {
            return Ok(Vec::new());
        }
        let cases = asked
            .iter()
            .enumerate()
            .map(|(nth, (question, _))| case(question, &nth.to_string(), "It was found.", "By the text."));
        let file = file(NAME, "What is judged.", cases.collect());
        let path = self.folder.join(AREA).join(format!("{NAME}.json"));
        std::fs::write(&path, file).map_err(|source| CourtError::Write { path, source })?;
        let suite = Suite::load(&self.folder)?;
        let judge = |(case, (_, line)): (&_, &(Question<'_>, &[u8]))| match Reply::parse(line) {
            Ok(reply) => check::judge(case, &reply.answer),
            Err(ReplyFault::Shape { .. }) => check::judge(case, &faulty()),
            Err(_) => check::judge(case, &faulty()),
        };
        Ok(suite.cases().iter().zip(asked).map(judge).collect())
    }

    /// The same, but for questions of which no file can hold the expectation: these have no judgement.
    ///
    /// # Errors
    /// The cases cannot be written.
    pub(crate) fn judge_each(&self, asked: &[(Question<'_>, &[u8])]) -> Result<Vec<Option<Judgement>>, CourtError> {
        match self.judge(asked) {
            Ok(judgements) => Ok(judgements.into_iter().map(Some).collect()),
            Err(CourtError::Suite(_)) => {
                let alone = |one| match self.judge(std::slice::from_ref(one)) {
                    Ok(judgements) => Ok(judgements.into_iter().next()),
                    Err(CourtError::Suite(_)) => Ok(None),
                    Err(error) => Err(error),
                };
                asked.iter().map(alone).collect()
            }
            Err(error) => Err(error),
        }
    }
}

impl Drop for Court {
    fn drop(&mut self) {
        // What is left in a folder for what is temporary does no harm.
        let _ = std::fs::remove_dir_all(&self.folder);
    }
}

/// The line in which the specification would answer, were it a peer.
pub(crate) fn line(answer: &ncp_peer_rust::Answer) -> Option<String> {
    use ncp_peer_rust::Answer;
    match answer {
        Answer::Result(result) => Some(format!("{{\"id\":1,\"result\":{result}}}")),
        Answer::Error { code, message } => {
            let error = object([("code", text(code.to_string())), ("message", text(message.to_string()))]);
            Some(format!("{{\"id\":1,\"error\":{error}}}"))
        }
        Answer::Unsupported => None,
    }
}

/// An answer that is none is as good as a crash.
fn faulty() -> Answer<'static> {
    Answer::Error { code: "internal".to_owned(), message: "the answer is none".to_owned() }
}

/// A case as a vector file holds it.
pub(crate) fn case(question: &Question<'_>, path: &str, title: &str, why: &str) -> Tree {
    let mut case = object([
        ("id", text(format!("{AREA}/{NAME}/{path}"))),
        ("title", text(title)),
        ("requirements", list(question.rules.iter().map(text).collect())),
        ("flags", list(Vec::new())),
        ("roles", list(vec![text(question.role.as_str())])),
        ("call", text(question.call.as_str())),
        ("args", question.args.clone()),
        ("expect", question.expect.clone()),
        ("why", text(why)),
    ]);
    if question.call == Call::SessionRun {
        set(&mut case, "needs", list(vec![text("reference_networks")]));
    }
    case
}

/// A vector file of these cases.
pub(crate) fn file(name: &str, about: &str, cases: Vec<Tree>) -> String {
    file_of(AREA, name, about, cases)
}

/// A vector file of these cases, of an area.
pub(crate) fn file_of(area: &str, name: &str, about: &str, cases: Vec<Tree>) -> String {
    let file = object([
        ("format", super::tree::int(1)),
        ("area", text(area)),
        ("name", text(name)),
        ("about", text(about)),
        ("notes", object([])),
        ("cases", list(cases)),
    ]);
    pretty(&file)
}

/// JSON with a line for each member of the upper levels.
fn pretty(tree: &Tree) -> String {
    fn write(tree: &Json<'_>, depth: usize, out: &mut String) {
        let indent = "  ".repeat(depth);
        match tree {
            Json::Object(members) if depth < 3 && !members.is_empty() => {
                out.push_str("{\n");
                for (nth, (name, value)) in members.iter().enumerate() {
                    out.push_str(&format!("{indent}  "));
                    crate::json::write_string(name, out);
                    out.push_str(": ");
                    write(value, depth + 1, out);
                    out.push_str(if nth + 1 < members.len() { ",\n" } else { "\n" });
                }
                out.push_str(&format!("{indent}}}"));
            }
            Json::Array(items) if depth < 2 && !items.is_empty() => {
                out.push_str("[\n");
                for (nth, item) in items.iter().enumerate() {
                    out.push_str(&format!("{indent}  "));
                    write(item, depth + 1, out);
                    out.push_str(if nth + 1 < items.len() { ",\n" } else { "\n" });
                }
                out.push_str(&format!("{indent}]"));
            }
            other => out.push_str(&other.to_string()),
        }
    }
    let mut out = String::new();
    write(tree, 0, &mut out);
    out.push('\n');
    out
}

/// Writes the cases that were found into a folder that `run --vectors` reads.
///
/// # Errors
/// The file cannot be written.
pub(crate) fn save(folder: &Path, name: &str, about: &str, cases: Vec<Tree>) -> Result<PathBuf, CourtError> {
    let path = folder.join(AREA).join(format!("{name}.json"));
    let written =
        std::fs::create_dir_all(folder.join(AREA)).and_then(|()| std::fs::write(&path, file(name, about, cases)));
    written.map_err(|source| CourtError::Write { path: path.clone(), source })?;
    Ok(path)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fuzz::tree::int;

    #[test]
    fn a_question_whose_expectation_no_file_holds_has_no_judgement_and_leaves_the_others_theirs() {
        let court = Court::open().unwrap();
        let args = object([("version", text("0.5")), ("strict", Json::Bool(false))]);
        let expected =
            |compatible| object([("relation", text("json")), ("value", object([("compatible", compatible)]))]);
        let short = expected(Json::Bool(true));
        let times = |item| list(vec![object([("$item", item), ("times", int(9999))])]);
        let long = expected(times(times(int(1))));
        let rules = vec!["NCP-VER-001".to_owned()];
        let question = |expect| Question {
            call: Call::VersionCheck,
            args: &args,
            expect,
            rules: rules.clone(),
            role: Role::Commander,
        };
        let line: &[u8] = br#"{"id":1,"result":{"compatible":true}}"#;
        let judged = court.judge_each(&[(question(&short), line), (question(&long), line)]).unwrap();
        assert!(matches!(judged[..], [Some(Judgement::Pass { .. }), None]), "{judged:?}");
        assert!(court.judge(&[(question(&long), line)]).is_err());
    }
}
