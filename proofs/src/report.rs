//! The report as data: what each engine found out, and what keeps all of it from being shown.
//!
//! An engine that is a program of its own leaves an [`Engine`] as JSON, and the report is one [`Report`].

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value, json};
use thiserror::Error;

use crate::counterexample::{Counterexample, Drawn};
pub use crate::engines::Verdict;
use crate::engines::{Outcome, bounds};
use crate::harness::Harness;
use crate::properties::{Family, PROPERTIES};
use crate::sabotage::Sabotaged;
use crate::vector;

/// Where the report is written, from the root of the project.
pub const FILE: &str = "reports/full/proofs.json";
/// The file of the evidence that holds the counterexamples as a file of vectors.
pub const VECTORS: &str = "vectors.json";
/// The form of the report.
pub const FORMAT: u32 = 3;
/// Engines whose proofs cover all inputs within the bounds that they state.
pub const EXHAUSTIVE: [&str; 7] = ["symbolic", "enumeration", "machine", "model", "readers", "path", "kani"];
/// The families of what reads untrusted bytes, which is proved beside the kernel.
const READERS: [&str; 3] = ["bulk", "version", "keys"];
/// The families of the safety path around the kernel. Of the loop much is tried on listed numbers only.
const PATH: [&str; 5] = ["estop", "governor", "link", "loop", "liveness"];
/// How many broken kernels of a family an engine has to refute that covers the family.
const ENOUGH: usize = 5;

/// All of it.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// [`FORMAT`].
    pub format: u32,
    /// The digest over all sources.
    pub digest: String,
    /// The digests of the sources of each artefact, by its name.
    pub digests: BTreeMap<String, String>,
    /// What is claimed of the kernel.
    pub properties: Vec<Claim>,
    /// What each engine found out.
    pub engines: Vec<Engine>,
    /// What differs from one run to the next.
    pub run: Run,
    /// What keeps it from being shown; empty when all is.
    pub problems: Vec<String>,
}

/// Every counterexample to a planted defect that a call of the peer protocol shows, as a file of vectors with a case a
/// line.
#[must_use]
pub fn vectors(report: &Report) -> String {
    let mut cases = Vec::new();
    for engine in &report.engines {
        for broken in &engine.broken {
            let Some(vector) = broken.counterexample.as_ref().and_then(|found| found.vector.as_ref()) else { continue };
            let id = broken.id.replace(['_', '/'], "-");
            let case = json!({
                "id": format!("proofs/report/{}/{id}", engine.name),
                "title": "What refutes it.",
                "requirements": ["NCP-VER-001"],
                "flags": [],
                "roles": vector["roles"],
                "call": vector["call"],
                "args": vector["args"],
                "expect": vector["expect"],
                "why": "The report of the proofs says so.",
            });
            cases.push(format!("  {case}"));
        }
    }
    let about = "The counterexamples of the proofs.";
    format!(
        "{{\"format\":1,\"area\":\"proofs\",\"name\":\"report\",\"about\":{about:?},\"notes\":{{}},\n\
         \"cases\":[\n{}\n]}}\n",
        cases.join(",\n")
    )
}

/// A claim about the kernel, which several engines are held against.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Claim {
    /// Its name: family and subject.
    pub id: String,
    /// What it says.
    #[serde(flatten)]
    pub words: Words,
}

/// What a claim says.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Words {
    /// What it is about.
    pub family: String,
    /// The rules for which it is evidence.
    pub rules: Vec<String>,
    /// The claim in words.
    pub sentence: String,
    /// The claim in symbols.
    pub statement: String,
    /// The bounds within which it is claimed.
    pub bounds: String,
    /// What is assumed.
    pub assumptions: Vec<String>,
}

/// What an engine found out.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Engine {
    /// Its name.
    pub name: String,
    /// The version of what it stands on.
    #[serde(default)]
    pub version: String,
    /// What it does, in a sentence.
    #[serde(default)]
    pub about: String,
    /// Whether it was not run here.
    #[serde(default, skip_serializing_if = "is_false")]
    pub not_run: bool,
    /// Its word on each claim.
    #[serde(default, alias = "claims")]
    pub results: Vec<Answer>,
    /// Its word on each broken copy.
    #[serde(default)]
    pub broken: Vec<Broken>,
    /// How many claims with a known answer it was held against before it was believed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub controls: Option<u64>,
    /// Its sabotaged copies, where its run was held against them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub sabotaged: Vec<Sabotaged>,
    /// What it trusts.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub trusted: Vec<String>,
    /// What it does not show.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub not_proved: Vec<String>,
    /// The digest of the library whose machine code was explored.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub library_sha256: Option<String>,
}

/// An engine's word on a claim.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Answer {
    /// The claim's name.
    pub property: String,
    /// What it says, where it is the engine's own.
    #[serde(flatten)]
    pub words: Option<Words>,
    /// How it ended.
    pub verdict: Verdict,
    /// What is to be said of that.
    #[serde(default)]
    pub detail: String,
    /// Paths explored.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub paths: Option<u64>,
    /// States, or inputs, explored.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub states: Option<u64>,
    /// Checks that are not true by evaluation, on all paths.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub raised: Option<u64>,
    /// Obligations that a solver answered.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub obligations: Option<u64>,
    /// Obligations that hold with every operation and comparison of doubles uninterpreted.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub without_arithmetic: Option<u64>,
    /// Checks that were true on their path without a solver.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub true_by_evaluation: Option<u64>,
    /// Runs of the harness on numbers.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub runs: Option<u64>,
    /// The checks that were reached.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub reached: Vec<String>,
    /// The files that were left, within the evidence.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub evidence: Vec<String>,
    /// The function whose machine code was explored.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub function: Option<String>,
    /// What refutes it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub counterexample: Option<Found>,
    /// How long it took, in seconds; the report keeps it in its [`Run`].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seconds: Option<f64>,
    /// Obligations that a second solver answered alike; the report keeps it in its [`Run`].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cross_checked: Option<u64>,
}

/// An engine's word on a copy with a defect.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Broken {
    /// The defect's name.
    pub id: String,
    /// The property that has to refute it.
    pub property: String,
    /// The family of that.
    pub family: String,
    /// The defect, in a sentence.
    pub about: String,
    /// The file that it changes, where the copy is one of the shared kernel.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// What stands there.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub from: Option<String>,
    /// What stands there instead.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub to: Option<String>,
    /// What refutes it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub counterexample: Option<Found>,
    /// Why it is not refuted.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub missed: Option<String>,
}

/// A counterexample as it is shown.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Found {
    /// What happens.
    #[serde(flatten)]
    pub shown: Shown,
    /// What the code answers and what the text says, where the check compares the two.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub compared: Option<String>,
    /// It as a case of a vector.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vector: Option<Value>,
    /// Why it is no vector.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub no_vector: Option<String>,
    /// Where its inputs come from.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub found_by: Option<String>,
}

/// What happens in a counterexample.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Shown {
    /// A check fails on inputs.
    Inputs {
        /// The check.
        check: String,
        /// The inputs in the order in which they are drawn, by name, numbers spelled as in the vectors.
        inputs: Vec<(String, Value)>,
    },
    /// A function answers wrongly.
    Call {
        /// The function.
        function: String,
        /// Its inputs, by name.
        inputs: Map<String, Value>,
        /// What the broken one leaves, by name.
        #[serde(default, skip_serializing_if = "Map::is_empty")]
        broken: Map<String, Value>,
        /// What the kernel leaves.
        #[serde(default, skip_serializing_if = "Map::is_empty")]
        kernel: Map<String, Value>,
    },
    /// Events lead to where a claim does not hold.
    Path {
        /// The events.
        steps: Vec<String>,
        /// What the broken variant answers, step by step.
        #[serde(default)]
        broken: Value,
        /// What the real code answers.
        #[serde(default)]
        real: Value,
    },
}

/// What differs from run to run, by engine and property.
pub type Run = BTreeMap<String, BTreeMap<String, Timing>>;

/// How an engine fared with a property this time.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Timing {
    /// How long it took, in whole seconds.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seconds: Option<u64>,
    /// Obligations that the second solver answered within its limit.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cross_checked: Option<u64>,
}

impl Report {
    /// The engine of this name.
    #[must_use]
    pub fn engine(&self, name: &str) -> Option<&Engine> {
        self.engines.iter().find(|engine| engine.name == name)
    }
}

impl Answer {
    /// An answer that says no more than how it ended.
    #[must_use]
    pub fn new(property: &str, verdict: Verdict) -> Self {
        Self {
            property: property.to_owned(),
            words: None,
            verdict,
            detail: String::new(),
            paths: None,
            states: None,
            raised: None,
            obligations: None,
            without_arithmetic: None,
            true_by_evaluation: None,
            runs: None,
            reached: Vec::new(),
            evidence: Vec::new(),
            function: None,
            counterexample: None,
            seconds: None,
            cross_checked: None,
        }
    }

    /// The family of its claim: its own word, or the first part of the property.
    #[must_use]
    pub fn family(&self) -> &str {
        match &self.words {
            Some(words) => &words.family,
            None => self.property.split('/').next().unwrap_or_default(),
        }
    }

    /// Whether the claim holds, in all cases within the bounds.
    #[must_use]
    pub fn is_proved(&self) -> bool {
        self.verdict == Verdict::Proved
    }
}

impl Broken {
    /// Whether there is a counterexample.
    #[must_use]
    pub const fn is_refuted(&self) -> bool {
        self.counterexample.is_some()
    }
}

impl Found {
    /// One of which no more is known.
    #[must_use]
    pub const fn new(shown: Shown) -> Self {
        Self { shown, compared: None, vector: None, no_vector: None, found_by: None }
    }

    /// The check that fails.
    #[must_use]
    pub fn check(&self) -> &str {
        match &self.shown {
            Shown::Inputs { check, .. } => check,
            Shown::Call { .. } | Shown::Path { .. } => "",
        }
    }
}

/// The claims about the kernel.
#[must_use]
pub fn properties() -> Vec<Claim> {
    let claim = |p: &crate::properties::Property| Claim {
        id: p.id.to_owned(),
        words: Words {
            family: p.family.as_str().to_owned(),
            rules: owned(p.rules),
            sentence: p.sentence.to_owned(),
            statement: p.statement.to_owned(),
            bounds: bounds::of(p.id).words.unwrap_or(p.bounds).to_owned(),
            assumptions: owned(p.assumptions),
        },
    };
    PROPERTIES.iter().map(claim).collect()
}

/// Words of a table, as a report has them.
#[must_use]
pub fn owned(words: &[&str]) -> Vec<String> {
    words.iter().map(|word| (*word).to_owned()).collect()
}

/// One result of an engine.
#[must_use]
pub fn outcome(property: &str, harness: &Harness, outcome: &Outcome) -> Answer {
    let found = outcome.counterexample.as_ref();
    Answer {
        detail: outcome.detail.clone(),
        paths: Some(outcome.paths),
        raised: Some(outcome.raised),
        obligations: Some(outcome.obligations),
        without_arithmetic: Some(outcome.without_arithmetic),
        true_by_evaluation: Some(outcome.by_evaluation),
        cross_checked: Some(outcome.cross_checked),
        runs: Some(outcome.runs),
        reached: outcome.reached.iter().map(|check| (*check).to_owned()).collect(),
        evidence: outcome.evidence.clone(),
        seconds: Some(outcome.seconds),
        counterexample: found.map(|found| counterexample(property, harness, found)),
        ..Answer::new(property, outcome.verdict)
    }
}

/// A counterexample: the check that fails and the inputs; as a case of a vector too, where a call of the peer protocol
/// shows it.
#[must_use]
pub fn counterexample(property: &str, harness: &Harness, found: &Counterexample) -> Found {
    let inputs = found.inputs.iter().map(|(name, drawn)| {
        let value = match *drawn {
            Drawn::Scalar(x) => vector::number(x),
            Drawn::Seq(seq) => json!(seq),
            Drawn::Choice(way) => json!(way),
        };
        (name.clone(), value)
    });
    let mut whole = Found::new(Shown::Inputs { check: found.check.clone(), inputs: inputs.collect() });
    match vector::try_case(property, &harness.calls, found) {
        Ok(case) => whole.vector = Some(case),
        Err(why) => whole.no_vector = Some(why.as_str().to_owned()),
    }
    whole
}

/// The results of an engine that another program has run, from the file that it left; without a file it was not run.
///
/// # Errors
/// The file has another form.
pub fn elsewhere(head: Engine, file: &Path) -> Result<Engine, FormError> {
    let Ok(text) = fs::read_to_string(file) else {
        return Ok(Engine { not_run: true, ..head });
    };
    let left = serde_json::from_str::<Engine>(&text);
    let left = left.map_err(|source| FormError { path: file.to_owned(), source })?;
    let version = if left.version.is_empty() { head.version } else { left.version };
    Ok(Engine { name: head.name, about: head.about, version, ..left })
}

/// What a program left is no [`Engine`].
#[derive(Debug, Error)]
#[error("{}: {source}", path.display())]
pub struct FormError {
    path: PathBuf,
    source: serde_json::Error,
}

/// Takes out of the results what differs from one run to the next: how long it took, and how much the second solver
/// answered within its limit. Of engines that were not run again, it is that of `before`.
pub fn take_run(engines: &mut [Engine], before: &Run) -> Run {
    let mut run = Run::new();
    for engine in engines {
        let mine = run.entry(engine.name.clone()).or_default();
        for result in &mut engine.results {
            let taken =
                Timing { seconds: result.seconds.take().map(whole), cross_checked: result.cross_checked.take() };
            let old = || before.get(&engine.name)?.get(&result.property).copied();
            let taken = if taken == Timing::default() { old().unwrap_or_default() } else { taken };
            mine.insert(result.property.clone(), taken);
        }
    }
    run
}

/// What is wrong with a report: everything that keeps it from saying that the kernel is proved.
#[must_use]
pub fn problems(report: &Report) -> Vec<String> {
    let engines = &report.engines;
    let exhaustive = || engines.iter().filter(|engine| EXHAUSTIVE.contains(&&*engine.name));
    let mut problems = Vec::new();

    for engine in engines {
        for result in &engine.results {
            if !matches!(result.verdict, Verdict::Proved | Verdict::Tried) {
                let (verdict, detail) = (result.verdict.as_str(), &result.detail);
                problems.push(format!("{}: {} is {verdict} {detail}", engine.name, result.property));
            }
        }
    }
    for Claim { id, .. } in &report.properties {
        let proves = |engine: &Engine| engine.results.iter().any(|r| r.property == *id && r.is_proved());
        if !exhaustive().any(proves) {
            problems.push(format!("{id}: no exhaustive engine proves it"));
        }
        // [vacuity] What the symbolic engine checks on some path, numbers have to reach, and the other way round.
        let reached = |is_symbolic: bool| -> BTreeSet<&str> {
            let engines = engines.iter().filter(|engine| (engine.name == "symbolic") == is_symbolic);
            let results = engines.flat_map(|engine| &engine.results).filter(|result| result.property == *id);
            results.flat_map(|result| &result.reached).map(String::as_str).collect()
        };
        let (by_terms, by_numbers) = (reached(true), reached(false));
        if by_terms.is_empty() {
            problems.push(format!("{id}: no check is reached"));
        }
        for check in by_terms.difference(&by_numbers) {
            problems.push(format!("{id}: no numbers reach the check {check:?}"));
        }
        for check in by_numbers.difference(&by_terms) {
            problems.push(format!("{id}: no path on terms reaches the check {check:?}"));
        }
    }
    for engine in engines {
        for missed in engine.sabotaged.iter().filter(|sabotaged| sabotaged.noticed.is_none()) {
            problems.push(format!("{}: sabotaged by {}, its run does not notice", engine.name, missed.id));
        }
    }
    let proves = |engine: &&Engine, family: &str| engine.results.iter().any(|r| r.family() == family && r.is_proved());
    let broken_of = |engine: &Engine, family: &str| {
        let mine = engine.broken.iter().filter(|broken| broken.family == family);
        let (refuted, missed): (Vec<_>, Vec<_>) = mine.partition(|broken| broken.is_refuted());
        (refuted.len(), missed.len())
    };
    for family in Family::ALL.map(Family::as_str) {
        if exhaustive().filter(|engine| proves(engine, family)).count() < 2 {
            problems.push(format!("{family}: not proved by two exhaustive engines"));
        }
        for engine in engines {
            let (refuted, missed) = broken_of(engine, family);
            if refuted + missed > 0 && refuted < ENOUGH {
                problems.push(format!("{}: refutes only {refuted} broken kernels of {family}", engine.name));
            }
        }
    }
    for family in READERS.into_iter().chain(PATH) {
        if !exhaustive().any(|engine| proves(&engine, family)) {
            problems.push(format!("{family}: no exhaustive engine proves it"));
        }
    }
    // A family of an engine's own has broken code that only this engine can refute.
    for engine in exhaustive() {
        let families: BTreeSet<&str> = engine.results.iter().map(Answer::family).collect();
        let is_shared = |family: &str| Family::ALL.iter().any(|known| known.as_str() == family);
        for family in families.into_iter().filter(|family| !is_shared(family)) {
            let (refuted, _) = broken_of(engine, family);
            if refuted < ENOUGH {
                problems.push(format!("{}: refutes only {refuted} broken ones of {family}", engine.name));
            }
        }
    }
    // A defect names the engines that have to refute it, or all that know its property have to.
    for engine in exhaustive() {
        for broken in engine.broken.iter().filter(|broken| !broken.is_refuted()) {
            let why = broken.missed.as_deref().unwrap_or_default();
            problems.push(format!("{}: {} does not refute it: {why}", broken.id, engine.name));
        }
    }
    let all = engines.iter().flat_map(|engine| &engine.broken);
    let asked: BTreeSet<(&str, &str)> = all.map(|broken| (&*broken.id, &*broken.property)).collect();
    for (id, property) in asked {
        let refutes = |broken: &Broken| broken.id == id && broken.property == property && broken.is_refuted();
        if !exhaustive().any(|engine| engine.broken.iter().any(refutes)) {
            problems.push(format!("{id}: no exhaustive engine refutes it by {property}"));
        }
    }
    problems
}

/// What is wrong with the word of one engine: claims that it does not prove, and, of an exhaustive one, defects that it
/// does not refute. What others found out about the same claims does not count.
#[must_use]
pub fn problems_of(engine: &Engine) -> Vec<String> {
    let Engine { name, results, broken, .. } = engine;
    let open = results.iter().filter(|result| !matches!(result.verdict, Verdict::Proved | Verdict::Tried));
    let open =
        open.map(|result| format!("{name}: {} is {} {}", result.property, result.verdict.as_str(), result.detail));
    let missed = broken.iter().filter(|broken| EXHAUSTIVE.contains(&name.as_str()) && !broken.is_refuted());
    open.chain(missed.map(|broken| format!("{name}: {} is not refuted by {}", broken.id, broken.property))).collect()
}

/// Whole seconds.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn whole(seconds: f64) -> u64 {
    seconds.round() as u64
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde asks for a reference")]
const fn is_false(value: &bool) -> bool {
    !*value
}

#[cfg(test)]
mod tests {
    use super::*;

    fn broken(family: &str, nth: usize, is_refuted: bool) -> Broken {
        let found = Found::new(Shown::Inputs { check: "a".to_owned(), inputs: Vec::new() });
        Broken {
            id: format!("{family}-{nth}"),
            property: format!("{family}/p"),
            family: family.to_owned(),
            about: String::new(),
            file: None,
            from: None,
            to: None,
            counterexample: is_refuted.then_some(found),
            missed: (!is_refuted).then(|| "no counterexample".to_owned()),
        }
    }

    /// An engine with a property and enough broken ones of each family.
    fn engine(name: &str, families: &[&str], verdict: Verdict, is_refuted: bool, reached: &[&str]) -> Engine {
        let answer = |family: &&str| Answer { reached: owned(reached), ..Answer::new(&format!("{family}/p"), verdict) };
        let bent = |family: &&str| (0..ENOUGH).map(|nth| broken(family, nth, is_refuted)).collect::<Vec<_>>();
        Engine {
            name: name.to_owned(),
            results: families.iter().map(answer).collect(),
            broken: families.iter().flat_map(bent).collect(),
            ..Engine::default()
        }
    }

    fn report(verdict: Verdict, is_refuted: bool, reached: &[&str]) -> Report {
        let families = Family::ALL.map(Family::as_str);
        let mut properties = properties();
        properties.truncate(families.len());
        for (claim, family) in properties.iter_mut().zip(families) {
            claim.id = format!("{family}/p");
        }
        let engines = vec![
            engine("symbolic", &families, verdict, is_refuted, &["a"]),
            engine("enumeration", &families, verdict, is_refuted, reached),
            engine("readers", &READERS, verdict, is_refuted, &[]),
            engine("path", &PATH, verdict, is_refuted, &[]),
        ];
        Report { properties, engines, ..Report::default() }
    }

    #[test]
    fn a_report_is_good_only_when_all_is_proved_refuted_and_reached() {
        assert_eq!(problems(&report(Verdict::Proved, true, &["a"])), [""; 0]);
        let shows = |report: &Report, what: &str| problems(report).iter().any(|p| p.contains(what));
        assert!(shows(&report(Verdict::Failed, true, &["a"]), "no exhaustive engine proves it"));
        assert!(shows(&report(Verdict::Tried, true, &["a"]), "not proved by two"));
        assert!(shows(&report(Verdict::NotRun, true, &["a"]), "is not run"));
        let missed = report(Verdict::Proved, false, &["a"]);
        assert!(shows(&missed, "no exhaustive engine refutes it"));
        assert!(shows(&missed, "refutes only 0 broken kernels of clamp"));
        assert!(shows(&missed, "readers: refutes only 0 broken ones of bulk"));
        let mut without_readers = report(Verdict::Proved, true, &["a"]);
        without_readers.engines[2] = Engine { name: "readers".to_owned(), not_run: true, ..Engine::default() };
        assert!(shows(&without_readers, "version: no exhaustive engine proves it"));
        assert!(shows(&report(Verdict::Proved, true, &[]), "no numbers reach the check \"a\""));
        assert!(shows(&report(Verdict::Proved, true, &["a", "b"]), "no path on terms reaches the check \"b\""));
    }

    #[test]
    fn a_sabotaged_engine_whose_run_does_not_notice_is_a_problem() {
        let mut report = report(Verdict::Proved, true, &["a"]);
        let mut sabotaged = Sabotaged { id: "deaf".to_owned(), about: String::new(), noticed: Some("so".to_owned()) };
        report.engines[0].sabotaged.push(sabotaged.clone());
        assert_eq!(problems(&report), [""; 0]);
        sabotaged.noticed = None;
        report.engines[0].sabotaged.push(sabotaged);
        assert_eq!(problems(&report), ["symbolic: sabotaged by deaf, its run does not notice"]);
    }

    #[test]
    fn a_defect_that_one_of_its_engines_misses_is_a_problem_whoever_else_refutes_it() {
        let mut report = report(Verdict::Proved, true, &["a"]);
        report.engines[1].broken.push(broken("clamp", 0, false));
        assert_eq!(problems(&report), ["clamp-0: enumeration does not refute it: no counterexample"]);
    }

    #[test]
    fn one_engine_answers_for_its_own_claims_and_defects_only() {
        let mut engine = engine("symbolic", &["clamp"], Verdict::Proved, true, &["a"]);
        assert_eq!(problems_of(&engine), [""; 0]);
        engine.broken.push(broken("latch", 7, false));
        engine.results.push(Answer::new("latch/p", Verdict::Failed));
        assert_eq!(
            problems_of(&engine),
            ["symbolic: latch/p is failed ", "symbolic: latch-7 is not refuted by latch/p"]
        );
    }

    #[test]
    fn a_defect_has_to_be_refuted_by_each_of_its_properties() {
        let mut report = report(Verdict::Proved, true, &["a"]);
        let other = Broken { property: "clamp/other".to_owned(), ..broken("clamp", 0, false) };
        report.engines[0].broken.push(other);
        let wanted = "clamp-0: no exhaustive engine refutes it by clamp/other";
        assert!(problems(&report).iter().any(|problem| problem == wanted));
    }

    #[test]
    fn what_differs_from_run_to_run_stands_apart_and_outlives_a_run_of_other_engines() {
        let left = Answer::new("clamp/bound", Verdict::Proved);
        let result = Answer { seconds: Some(6.7), cross_checked: Some(3), ..left.clone() };
        let mut engines = [Engine { name: "symbolic".to_owned(), results: vec![result], ..Engine::default() }];
        let run = take_run(&mut engines, &Run::new());
        assert_eq!(run["symbolic"]["clamp/bound"], Timing { seconds: Some(7), cross_checked: Some(3) });
        assert_eq!(engines[0].results, [left]);
        assert_eq!(take_run(&mut engines, &run), run);
    }

    #[test]
    fn an_engine_that_left_no_file_is_not_run_here() {
        let head = Engine { name: "kani".to_owned(), ..Engine::default() };
        let engine = elsewhere(head, Path::new("no such file")).unwrap();
        assert!(engine.not_run && engine.results.is_empty());
    }

    #[test]
    fn a_file_of_another_form_is_refused() {
        let manifest = Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.toml");
        assert!(elsewhere(Engine::default(), &manifest).is_err());
    }

    #[test]
    fn each_kind_of_counterexample_is_read_as_it_was_written() {
        let call =
            json!({ "function": "f", "inputs": { "x": "1.0" }, "broken": { "answer": 1 }, "kernel": { "answer": 0 } });
        let path = json!({ "steps": ["Reset"], "broken": [{}], "real": [{}], "vector": { "call": "buffer.run" } });
        let inputs = json!({ "check": "c", "inputs": [["x", 1.0]], "no_vector": "why" });
        for written in [call, path, inputs] {
            let found: Found = serde_json::from_value(written.clone()).unwrap();
            assert_eq!(serde_json::to_value(&found).unwrap(), written);
        }
    }
}
