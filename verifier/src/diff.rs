//! Two results of one peer, such as those of two releases, compared case by case.
//!
//! [`compare`] reads two result files and finds what is fixed, what newly fails, and what fails in another way. A case
//! that was [inconclusive](crate::verdict::Ruling::Inconclusive) and now fails by its own rule is *unmasked*: it shows
//! a failure that was there before, and is no regression.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

/// The format of result files that is understood.
const FORMAT: u32 = 1;

/// What differs between two results.
#[derive(Debug, Serialize)]
pub struct Comparison {
    /// Whether the two results draw on the same cases.
    pub same_corpus: bool,
    /// The peers that are in both, in the order of the newer result.
    pub peers: Vec<PeerComparison>,
    /// The peers that only the older result has.
    pub only_in_old: Vec<String>,
    /// The peers that only the newer result has.
    pub only_in_new: Vec<String>,
    /// Whether a peer has a [regression](PeerComparison::regressions), or is no longer checked.
    pub regression: bool,
    /// The sentences of the rules.
    #[serde(skip)]
    pub sentences: HashMap<String, String>,
}

/// What differs about one peer.
#[derive(Debug, Serialize)]
pub struct PeerComparison {
    /// Its name.
    pub name: String,
    /// The older result.
    pub old: Side,
    /// The newer one.
    pub new: Side,
    /// Cases that did not pass and now do, each with the rule that it was charged to.
    pub fixed: Vec<Change>,
    /// Cases that newly fail, or no longer are inconclusive but fail.
    pub newly_failing: Vec<Change>,
    /// Cases that fail in another way than before.
    pub changed: Vec<Change>,
    /// How many cases fail as before.
    pub failing_as_before: usize,
    /// How many cases pass as before.
    pub passing_as_before: usize,
    /// How many cases only the older result has.
    pub only_in_old: usize,
    /// How many cases only the newer result has.
    pub only_in_new: usize,
    /// How many of these fail.
    pub failing_only_in_new: usize,
}

/// What one result says of the peer as a whole.
#[derive(Debug, Serialize)]
pub struct Side {
    /// The implementation's own version.
    pub version: Option<String>,
    /// The verdict; none: it was not checked.
    pub conclusion: Option<String>,
}

/// A case about which the results differ.
#[derive(Debug, PartialEq, Eq, Serialize)]
pub struct Change {
    /// The case.
    pub case: String,
    /// The rule that is or was broken: that of the newer result, unless the case passes there.
    pub rule: String,
    /// What became of it in the older result.
    pub old: String,
    /// What becomes of it in the newer one.
    pub new: String,
    /// Whether the case was inconclusive before, so that its failure is not new but newly seen.
    pub unmasked: bool,
}

/// Why two results cannot be compared.
#[derive(Debug, thiserror::Error)]
pub enum DiffError {
    /// A file cannot be read.
    #[error("{}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the operating system said.
        source: std::io::Error,
    },
    /// A file is no result.
    #[error("{}: this is no result of ncp-verify: {source}", path.display())]
    Form {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        source: serde_json::Error,
    },
    /// A file is a result of another format.
    #[error("{}: its format is {format}, and this program understands {FORMAT}", path.display())]
    Format {
        /// The file.
        path: PathBuf,
        /// Its format.
        format: u32,
    },
    /// The results have no peer in common.
    #[error("the two results have no peer in common: {old} and {new}")]
    Strangers {
        /// The peers of the older result.
        old: String,
        /// The peers of the newer one.
        new: String,
    },
}

/// Compares two result files.
///
/// # Errors
/// [`DiffError`] if one of them cannot be read, or if they have no peer in common.
pub fn compare(old: &Path, new: &Path) -> Result<Comparison, DiffError> {
    let (old, new) = (read(old)?, read(new)?);
    let names = |file: &ResultFile| file.peers.iter().map(|peer| peer.name.clone()).collect::<Vec<_>>();
    let (old_names, new_names) = (names(&old), names(&new));
    // A peer that is the only one of its result is meant, whatever its name.
    let alone = old.peers.len() == 1 && new.peers.len() == 1;
    let mut peers = Vec::new();
    let mut lost = false;
    for peer in &new.peers {
        if let Some(before) = old.peers.iter().find(|before| alone || before.name == peer.name) {
            lost |= before.conclusion.is_some() && peer.conclusion.is_none();
            peers.push(PeerComparison::new(before, peer));
        }
    }
    if peers.is_empty() {
        return Err(DiffError::Strangers { old: old_names.join(", "), new: new_names.join(", ") });
    }
    let only = |these: &[String], those: &[String]| match alone {
        true => Vec::new(),
        false => these.iter().filter(|name| !those.contains(name)).cloned().collect(),
    };
    Ok(Comparison {
        same_corpus: old.corpus.sha256 == new.corpus.sha256,
        regression: lost || peers.iter().any(|peer| peer.regressions() > 0),
        peers,
        only_in_old: only(&old_names, &new_names),
        only_in_new: only(&new_names, &old_names),
        sentences: old.rules.into_iter().chain(new.rules).map(|rule| (rule.id, rule.sentence)).collect(),
    })
}

impl PeerComparison {
    /// How many cases passed and no longer do.
    #[must_use]
    pub fn regressions(&self) -> usize {
        self.newly_failing.len() - self.unmasked()
    }

    /// How many of the newly failing cases were inconclusive before.
    #[must_use]
    pub fn unmasked(&self) -> usize {
        self.newly_failing.iter().filter(|change| change.unmasked).count()
    }

    fn new(old: &PeerResult, new: &PeerResult) -> Self {
        let side = |peer: &PeerResult| Side {
            version: peer.description.as_ref().map(|about| about.version.clone()),
            conclusion: peer.conclusion.clone(),
        };
        let mut comparison = Self {
            name: new.name.clone(),
            old: side(old),
            new: side(new),
            fixed: Vec::new(),
            newly_failing: Vec::new(),
            changed: Vec::new(),
            failing_as_before: 0,
            passing_as_before: 0,
            only_in_old: 0,
            only_in_new: 0,
            failing_only_in_new: 0,
        };
        let mut before: HashMap<&str, &CaseResult> = old.cases.iter().map(|case| (case.id.as_str(), case)).collect();
        for case in &new.cases {
            match before.remove(case.id.as_str()) {
                Some(known) => comparison.take(known, case),
                None => {
                    comparison.only_in_new += 1;
                    comparison.failing_only_in_new += usize::from(!case.passes());
                }
            }
        }
        comparison.only_in_old = before.len();
        comparison
    }

    /// Takes one case that both results have.
    fn take(&mut self, old: &CaseResult, new: &CaseResult) {
        let unmasked = old.ruling.as_deref() == Some("inconclusive") && new.ruling.as_deref() == Some("failed");
        let change = |of: &CaseResult| Change {
            case: new.id.clone(),
            rule: of.rule().to_owned(),
            old: old.in_words(),
            new: new.in_words(),
            unmasked: unmasked && !old.passes(),
        };
        match (old.passes(), new.passes()) {
            (true, true) => self.passing_as_before += 1,
            (false, true) => self.fixed.push(change(old)),
            (true, false) => self.newly_failing.push(change(new)),
            (false, false) if unmasked => self.newly_failing.push(change(new)),
            (false, false) if old.way() != new.way() => self.changed.push(change(new)),
            (false, false) => self.failing_as_before += 1,
        }
    }
}

fn read(path: &Path) -> Result<ResultFile, DiffError> {
    let text = std::fs::read_to_string(path).map_err(|source| DiffError::Read { path: path.to_owned(), source })?;
    let file: ResultFile =
        serde_json::from_str(&text).map_err(|source| DiffError::Form { path: path.to_owned(), source })?;
    if file.format != FORMAT {
        return Err(DiffError::Format { path: path.to_owned(), format: file.format });
    }
    Ok(file)
}

/// What is read of a result file.
#[derive(Deserialize)]
struct ResultFile {
    format: u32,
    corpus: CorpusResult,
    rules: Vec<RuleResult>,
    peers: Vec<PeerResult>,
}

#[derive(Deserialize)]
struct CorpusResult {
    sha256: String,
}

#[derive(Deserialize)]
struct RuleResult {
    id: String,
    sentence: String,
}

#[derive(Deserialize)]
struct PeerResult {
    name: String,
    description: Option<DescriptionResult>,
    conclusion: Option<String>,
    cases: Vec<CaseResult>,
}

#[derive(Deserialize)]
struct DescriptionResult {
    version: String,
}

#[derive(Deserialize)]
struct CaseResult {
    id: String,
    rules: Vec<String>,
    outcome: String,
    status: String,
    ruling: Option<String>,
    charged: Option<String>,
    #[serde(default)]
    differences: Vec<DifferenceResult>,
    what: Option<String>,
}

#[derive(PartialEq, Deserialize)]
struct DifferenceResult {
    text: String,
}

impl CaseResult {
    /// Whether it passed, or differs from nothing but a SHOULD.
    fn passes(&self) -> bool {
        matches!(self.status.as_str(), "passed" | "unexpected pass" | "advice")
    }

    /// The rule that it is charged to, or else is about.
    fn rule(&self) -> &str {
        self.charged.as_deref().or(self.rules.first().map(String::as_str)).unwrap_or_default()
    }

    /// How it fails.
    fn way(&self) -> (&str, &str, &[DifferenceResult], Option<&str>) {
        (&self.outcome, self.rule(), &self.differences, self.what.as_deref())
    }

    fn in_words(&self) -> String {
        match self.ruling.as_deref() {
            Some("inconclusive") => format!("{}, waits for {}", self.outcome, self.rule()),
            _ => self.outcome.clone(),
        }
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::*;

    const OWN: &str = "NCP-SAFE-008";
    const OTHER: &str = "NCP-SAFE-004";

    fn case(id: &str, outcome: &str, ruling: &str, charged: Option<&str>) -> Value {
        let status = if outcome == "pass" { "passed" } else { "failed" };
        json!({"id": id, "rules": [OWN], "outcome": outcome, "status": status, "ruling": ruling, "charged": charged})
    }

    fn passed(id: &str) -> Value {
        case(id, "pass", "passed", None)
    }

    fn failed(id: &str) -> Value {
        case(id, "fail", "failed", Some(OWN))
    }

    fn waiting(id: &str) -> Value {
        case(id, "fail", "inconclusive", Some(OTHER))
    }

    fn file(folder: &Path, name: &str, peers: &[(&str, &[Value])]) -> PathBuf {
        let peer = |(name, cases): &(&str, &[Value])| json!({"name": name, "description": {"version": "1"}, "conclusion": "not conformant", "cases": cases});
        let peers: Vec<Value> = peers.iter().map(peer).collect();
        let rules = json!([{"id": OWN, "sentence": "A governor MUST."}]);
        let path = folder.join(name);
        let text = json!({"format": 1, "corpus": {"sha256": "s"}, "rules": rules, "peers": peers}).to_string();
        std::fs::write(&path, text).unwrap();
        path
    }

    fn compared(old: &[Value], new: &[Value]) -> Comparison {
        let folder = tempfile::tempdir().unwrap();
        compare(&file(folder.path(), "o", &[("a", old)]), &file(folder.path(), "n", &[("b", new)])).unwrap()
    }

    #[test]
    fn each_case_is_fixed_newly_failing_changed_or_as_before() {
        let old =
            [passed("p"), passed("r"), failed("f"), failed("c"), failed("s"), waiting("u"), passed("w"), failed("o")];
        let crash = case("c", "crash", "failed", Some(OWN));
        let new = [passed("p"), failed("r"), passed("f"), crash, failed("s"), failed("u"), waiting("w"), failed("n")];
        let comparison = compared(&old, &new);
        let peer = &comparison.peers[0];
        let ids = |changes: &[Change]| changes.iter().map(|change| change.case.clone()).collect::<Vec<_>>();
        assert_eq!((ids(&peer.fixed), ids(&peer.changed)), (vec!["f".to_owned()], vec!["c".to_owned()]));
        assert_eq!(ids(&peer.newly_failing), ["r", "u", "w"]);
        assert_eq!((peer.unmasked(), peer.regressions(), comparison.regression), (1, 2, true));
        assert_eq!(
            (peer.newly_failing[2].rule.as_str(), peer.newly_failing[2].new.as_str()),
            (OTHER, "fail, waits for NCP-SAFE-004")
        );
        assert_eq!((peer.passing_as_before, peer.failing_as_before), (1, 1));
        assert_eq!((peer.only_in_old, peer.only_in_new, peer.failing_only_in_new), (1, 1, 1));
    }

    #[test]
    fn what_was_hidden_before_is_no_regression() {
        assert!(!compared(&[waiting("u")], &[failed("u")]).regression);
        assert!(!compared(&[failed("u")], &[waiting("u")]).regression);
        assert!(compared(&[passed("u")], &[case("u", "not run", "not run", None)]).regression);
    }

    #[test]
    fn peers_are_paired_by_their_names_unless_each_result_has_one() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path();
        let none: &[Value] = &[];
        let (two, other) = (file(path, "2", &[("a", none), ("b", none)]), file(path, "o", &[("b", none), ("c", none)]));
        let comparison = compare(&two, &other).unwrap();
        assert_eq!(comparison.peers.iter().map(|peer| peer.name.as_str()).collect::<Vec<_>>(), ["b"]);
        assert_eq!(
            (&comparison.only_in_old[..], &comparison.only_in_new[..]),
            (&["a".to_owned()][..], &["c".to_owned()][..])
        );
        let strangers = compare(&two, &file(path, "s", &[("x", none)])).unwrap_err().to_string();
        assert_eq!(strangers, "the two results have no peer in common: a, b and x");
    }

    #[test]
    fn a_file_that_is_no_result_is_refused_by_name() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("x");
        let good = file(folder.path(), "good", &[]);
        assert!(compare(&path, &good).unwrap_err().to_string().contains("x: "));
        std::fs::write(&path, "{}").unwrap();
        assert!(compare(&path, &good).unwrap_err().to_string().contains("x: this is no result of ncp-verify"));
        let text = std::fs::read_to_string(&good).unwrap().replace("\"format\":1", "\"format\":2");
        std::fs::write(&path, text).unwrap();
        assert!(compare(&path, &good).unwrap_err().to_string().contains("its format is 2"));
    }
}
