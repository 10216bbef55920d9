//! A run as it goes on, on disk, so that one that was killed is taken up where it ended.
//!
//! The [`Journal`] is a file beside the result, of one JSON object a line: first what the run is, then for each peer
//! how it described itself and what became of its cases. What was judged is in the file before more is read from the
//! peer, so that a `kill -9` loses at most the cases in flight. A journal of another run is never taken up.

use std::collections::{BTreeSet, HashMap};
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use serde::{Deserialize, Serialize};

use crate::peer::Description;
use crate::report::{Asked, DescriptionReport, StoredRun};
use crate::run::{CaseRun, Event, Listener, keep_worst};

/// The format of the file.
const FORMAT: u32 = 1;

/// What a run is: only the same run is taken up again.
#[derive(Debug, Clone, Serialize)]
pub struct Head<'h> {
    /// The SHA-256 of the list of vectors.
    pub corpus: &'h str,
    /// What was asked for.
    pub asked: &'h Asked,
    /// Where each peer comes from.
    pub peers: Vec<&'h str>,
    /// The cases of an earlier result that are run again, by peer.
    pub only: Vec<(String, BTreeSet<String>)>,
}

/// The file.
#[derive(Debug)]
pub struct Journal {
    path: PathBuf,
    file: Mutex<Open>,
}

#[derive(Debug)]
struct Open {
    /// None after an error.
    file: Option<File>,
    /// What is still to be written.
    lines: Vec<u8>,
}

/// What a journal holds of a peer.
#[derive(Debug, Clone, Default)]
pub struct Kept {
    /// How it described itself; none: it was not started.
    pub description: Option<Description>,
    /// What became of its cases.
    pub cases: HashMap<String, CaseRun>,
    /// Whether an answer opened a session.
    pub opened: bool,
}

/// Writes what becomes of one peer's cases, and passes each event on.
#[derive(Debug)]
pub struct Recorder<'j, L> {
    journal: &'j Journal,
    peer: usize,
    next: &'j L,
}

/// Why a journal cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum JournalError {
    /// It cannot be read or written.
    #[error("{}: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What the operating system said.
        source: io::Error,
    },
    /// It is that of another run.
    #[error(
        "{} is the journal of another run: of other vectors, peers or options; without --resume a run begins anew",
        path.display()
    )]
    Other {
        /// The file.
        path: PathBuf,
    },
    /// A line of it is not one that a run writes.
    #[error("{}, line {line}: {source}", path.display())]
    Line {
        /// The file.
        path: PathBuf,
        /// Which, from 1.
        line: usize,
        /// What is wrong.
        source: serde_json::Error,
    },
}

/// The first line.
#[derive(Serialize)]
struct First<'h> {
    journal: u32,
    version: &'static str,
    #[serde(flatten)]
    head: &'h Head<'h>,
}

/// Each other line.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Line {
    peer: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    description: Option<DescriptionReport>,
    #[serde(skip_serializing_if = "Option::is_none")]
    case: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    run: Option<StoredRun>,
    #[serde(default, skip_serializing_if = "is_false")]
    opened: bool,
}

impl Journal {
    /// Where the journal of a run is whose result goes into this file.
    #[must_use]
    pub fn beside(result: &Path) -> PathBuf {
        let mut name = result.as_os_str().to_owned();
        name.push(".journal");
        name.into()
    }

    /// Begins a journal.
    ///
    /// # Errors
    /// [`JournalError::File`].
    pub fn begin(path: &Path, head: &Head<'_>) -> Result<Self, JournalError> {
        let fault = |source| JournalError::File { path: path.to_owned(), source };
        if let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty()) {
            fs::create_dir_all(folder).map_err(fault)?;
        }
        // Another run that still writes to the file of this name goes on with its own.
        let fresh = path.with_extension(format!("journal-{}", std::process::id()));
        let mut file = File::create(&fresh).map_err(fault)?;
        file.write_all(first_line(head).as_bytes()).and_then(|()| fs::rename(&fresh, path)).map_err(fault)?;
        Ok(Self::of(path, file))
    }

    /// Takes a journal up again, with what it holds of each peer; begins one where there is none.
    ///
    /// # Errors
    /// [`JournalError`] if it is not the journal of this run.
    pub fn resume(path: &Path, head: &Head<'_>) -> Result<(Self, Vec<Kept>), JournalError> {
        let fault = |source| JournalError::File { path: path.to_owned(), source };
        let mut kept = vec![Kept::default(); head.peers.len()];
        let bytes = match fs::read(path) {
            Ok(bytes) => bytes,
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok((Self::begin(path, head)?, kept)),
            Err(error) => return Err(fault(error)),
        };
        let other = || JournalError::Other { path: path.to_owned() };
        // A line that was being written when the run was killed has no end, and goes.
        let whole = bytes.iter().rposition(|byte| *byte == b'\n').map_or(0, |end| end + 1);
        let mut lines = bytes.get(..whole).unwrap_or_default().split_inclusive(|byte| *byte == b'\n');
        if lines.next() != Some(first_line(head).as_bytes()) {
            return Err(other());
        }
        for (number, line) in lines.enumerate() {
            let line: Line = serde_json::from_slice(line).map_err(|source| JournalError::Line {
                path: path.to_owned(),
                line: number + 2,
                source,
            })?;
            let kept = kept.get_mut(line.peer).ok_or_else(other)?;
            kept.opened |= line.opened;
            kept.description = line.description.as_ref().map(Description::from).or(kept.description.take());
            if let (Some(case), Some(run)) = (line.case, line.run) {
                let mut worst = kept.cases.remove(&case);
                keep_worst(&mut worst, run.into());
                kept.cases.extend(worst.map(|worst| (case, worst)));
            }
        }
        let file = OpenOptions::new().append(true).open(path).map_err(fault)?;
        file.set_len(whole as u64).map_err(fault)?;
        Ok((Self::of(path, file), kept))
    }

    /// Notes how a peer describes itself, and listens to its run from now on.
    pub fn record<'j, L: Listener>(&'j self, peer: usize, about: &Description, next: &'j L) -> Recorder<'j, L> {
        let description = Some(DescriptionReport::from(about));
        self.put(&Line { peer, description, case: None, run: None, opened: false });
        self.flush();
        Recorder { journal: self, peer, next }
    }

    /// Takes the file away: the run is at its end.
    pub fn remove(self) {
        // What is left behind is taken up by nobody: a run that begins writes it anew.
        let _ = fs::remove_file(&self.path);
    }

    fn of(path: &Path, file: File) -> Self {
        Self { path: path.to_owned(), file: Mutex::new(Open { file: Some(file), lines: Vec::new() }) }
    }

    fn put(&self, line: &Line) {
        let mut open = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        let before = open.lines.len();
        match serde_json::to_writer(&mut open.lines, line) {
            Ok(()) => open.lines.push(b'\n'),
            Err(_) => open.lines.truncate(before),
        }
    }

    fn flush(&self) {
        let mut open = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        let lines = std::mem::take(&mut open.lines);
        let Some(file) = &mut open.file else { return };
        if let Err(error) = file.write_all(&lines) {
            // The run is worth more than its journal.
            eprintln!("{}: {error}; the run goes on, and cannot be resumed", self.path.display());
            open.file = None;
        }
    }
}

impl<L: Listener> Listener for Recorder<'_, L> {
    fn on(&self, event: Event<'_>) {
        let line = Line { peer: self.peer, description: None, case: None, run: None, opened: false };
        match event {
            Event::Recorded { case, run } => {
                self.journal.put(&Line { case: Some(case.to_owned()), run: Some(run.into()), ..line });
                // No answers follow that would have it written.
                if run.outcome.kind().is_fault() {
                    self.journal.flush();
                }
            }
            Event::Opened => self.journal.put(&Line { opened: true, ..line }),
            Event::Judged { .. } => self.journal.flush(),
            Event::Fault { .. } | Event::GivenUp { .. } => {}
        }
        self.next.on(event);
    }
}

fn first_line(head: &Head<'_>) -> String {
    let first = First { journal: FORMAT, version: env!("CARGO_PKG_VERSION"), head };
    serde_json::to_string(&first).unwrap_or_default() + "\n"
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
fn is_false(value: &bool) -> bool {
    !value
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::{Difference, Differences, Manner};
    use crate::run::{Deaf, Outcome, OutcomeKind};
    use crate::suite::Suite;
    use ncp_text::catalogue::Level;

    fn asked() -> Asked {
        Asked {
            deep: 0,
            level: Level::Wire,
            roles: Vec::new(),
            filters: Vec::new(),
            files: 1,
            cases: 1,
            repeat: 1,
            partial: false,
            shard: None,
            rerun: false,
        }
    }

    fn description() -> Description {
        Description {
            name: "n".to_owned(),
            version: "1".to_owned(),
            language: "C".to_owned(),
            wire_version: "v".to_owned(),
            contract_hash: "h".to_owned(),
            roles: vec!["body".to_owned()],
            reference_networks: true,
        }
    }

    fn head(asked: &Asked) -> Head<'_> {
        Head { corpus: "c", asked, peers: vec!["a", "b"], only: Vec::new() }
    }

    fn run(outcome: Outcome) -> CaseRun {
        CaseRun { outcome, answer: Some("{}".to_owned()), note: None }
    }

    #[test]
    fn what_was_recorded_is_there_after_an_end_at_any_byte_and_the_worst_of_a_case_counts() {
        let folder = tempfile::tempdir().unwrap();
        let (path, asked) = (folder.path().join("sub/result.json.journal"), asked());
        let (journal, kept) = Journal::resume(&path, &head(&asked)).unwrap();
        assert!(kept.iter().all(|kept| kept.cases.is_empty() && kept.description.is_none()));
        let recorder = journal.record(1, &description(), &Deaf);
        let first = Difference { at: "/a".into(), expected: Some("1".into()), got: None, hint: Some("h".into()) };
        let differences = Differences { first: vec![first], more: 2, place: "/a".into(), manner: Manner::Order };
        let runs = [
            ("pass", run(Outcome::Pass)),
            ("fail", run(Outcome::Fail(differences))),
            ("lacks", run(Outcome::Unsupported { step: Some("/steps/1".into()) })),
            ("dies", run(Outcome::Crash { what: "died".into(), log: "log".into() })),
        ];
        for (case, run) in &runs {
            recorder.on(Event::Recorded { case, run });
        }
        recorder.on(Event::Opened);
        recorder
            .on(Event::Recorded { case: "pass", run: &run(Outcome::Timeout { what: "t".into(), log: String::new() }) });
        recorder.on(Event::Recorded { case: "dies", run: &run(Outcome::Pass) });
        recorder.on(Event::Judged { answers: 1, wrong: 0 });
        let (_, kept) = Journal::resume(&path, &head(&asked)).unwrap();
        assert_eq!((&kept[1].description, kept[1].opened, kept[0].cases.len()), (&Some(description()), true, 0));
        for (case, run) in &runs[1..] {
            assert_eq!(kept[1].cases.get(*case), Some(run));
        }
        assert_eq!(kept[1].cases["pass"].outcome.kind(), OutcomeKind::Timeout);
        let bytes = fs::read(&path).unwrap();
        let head_line = bytes.iter().position(|byte| *byte == b'\n').unwrap() + 1;
        for end in head_line..bytes.len() {
            fs::write(&path, &bytes[..end]).unwrap();
            let (journal, kept) = Journal::resume(&path, &head(&asked)).unwrap();
            let lines = bytes[..end].iter().filter(|byte| **byte == b'\n').count();
            assert_eq!(kept[1].cases.len(), lines.saturating_sub(2).min(4));
            // What comes after is not lost behind the rest of a line.
            journal.record(0, &description(), &Deaf);
            assert!(Journal::resume(&path, &head(&asked)).unwrap().1[0].description.is_some());
        }
    }

    #[test]
    fn a_journal_of_another_run_is_not_taken_up() {
        let folder = tempfile::tempdir().unwrap();
        let (path, asked) = (folder.path().join("j"), asked());
        Journal::begin(&path, &head(&asked)).unwrap();
        let other = Asked { level: Level::Safety, ..asked.clone() };
        assert!(matches!(Journal::resume(&path, &head(&other)), Err(JournalError::Other { .. })));
        let other = Head { corpus: "d", ..head(&asked) };
        assert!(matches!(Journal::resume(&path, &other), Err(JournalError::Other { .. })));
        let mut text = fs::read_to_string(&path).unwrap();
        text.push_str("{\"peer\":0}\nnonsense\n");
        fs::write(&path, &text).unwrap();
        assert!(matches!(Journal::resume(&path, &head(&asked)), Err(JournalError::Line { line: 3, .. })));
        fs::write(&path, text.replace("nonsense", "{\"peer\":2}")).unwrap();
        assert!(matches!(Journal::resume(&path, &head(&asked)), Err(JournalError::Other { .. })));
        Journal::begin(&path, &head(&asked)).unwrap().remove();
        assert!(!path.exists());
    }

    #[test]
    fn every_way_to_end_is_read_as_it_was_written() {
        let suite = Suite::embedded().unwrap();
        let case = &suite.cases()[0];
        let crash = |log: &str| Outcome::Crash { what: "w".into(), log: log.into() };
        let all = [
            Outcome::Pass,
            Outcome::Fail(Differences::default()),
            Outcome::Unsupported { step: None },
            crash(""),
            crash("l"),
            Outcome::Protocol { what: "w".into(), log: "l".into() },
            Outcome::NotRun { why: "w".into() },
        ];
        for outcome in all {
            let before = CaseRun { outcome, answer: None, note: Some(case.id.clone()) };
            let text = serde_json::to_string(&StoredRun::from(&before)).unwrap();
            assert_eq!(CaseRun::from(serde_json::from_str::<StoredRun>(&text).unwrap()), before);
        }
    }
}
