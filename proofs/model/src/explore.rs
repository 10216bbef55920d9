//! Runs the checker on one protocol, and on its broken variants.

use std::collections::BTreeMap;
use std::fmt::Debug;
use std::hash::Hash;
use std::time::Instant;

use serde::Serialize;
use serde_json::{Value, json};
use stateright::{Checker, Expectation, HasDiscoveries, Model};

/// What is claimed of a protocol, beside the formula that its model has under the same name.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Claim {
    /// The name of the `always` property.
    pub(crate) name: &'static str,
    /// The rules that it serves.
    pub(crate) rules: &'static [&'static str],
    /// What it says, in words.
    pub(crate) sentence: &'static str,
    /// What it says, formally.
    pub(crate) formal: &'static str,
}

/// A broken variant: its defect, its name, what is broken, and the claim that it must refute.
pub(crate) type Variant<D> = (D, &'static str, &'static str, &'static str);

/// A protocol that can be checked, whole or with a defect.
pub(crate) trait Protocol: Sized {
    /// What is broken in a variant.
    type Defect: Copy + Debug + 'static;
    /// Its model: the states, and the events that happen in them.
    type Model: Model<
            State: Clone + Debug + Hash + PartialEq + Send + Sync + 'static,
            Action: Clone + Debug + PartialEq + Send + Sync + 'static,
        > + Send
        + Sync
        + 'static;

    /// The name that begins the ids of its properties.
    const FAMILY: &'static str;
    /// What it is checked for.
    const CLAIMS: &'static [Claim];
    /// The broken variants, each with an id, what is broken, and the claim that it must refute.
    const BROKEN: &'static [Variant<Self::Defect>];

    /// The models over the real code; small ones for a test.
    fn models(small: bool) -> Vec<Self::Model>;
    /// The model over a broken variant of it.
    fn broken(defect: Self::Defect) -> Self::Model;
    /// The bounds of the model, in words.
    fn bounds(small: bool) -> String;
    /// A path run natively by the real code and by a broken variant, and as a vector.
    fn replay(defect: Self::Defect, path: &[<Self::Model as Model>::Action]) -> Replay;
}

/// A counterexample, run natively.
#[derive(Debug, Serialize)]
pub(crate) struct Replay {
    /// What happens, step by step.
    pub(crate) steps: Vec<String>,
    /// What the broken variant answers, step by step.
    pub(crate) broken: Value,
    /// What the real code answers.
    pub(crate) real: Value,
    /// The steps as a case of the vectors, with what the real code answers.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) vector: Option<Value>,
}

impl Replay {
    /// Runs a path by a broken variant and by the real code, whose answers the vector may need.
    pub(crate) fn new<D, E: Debug>(
        path: &[E],
        defect: D,
        run: impl Fn(Option<D>) -> Value,
        vector: impl FnOnce(&Value) -> Option<Value>,
    ) -> Self {
        let real = run(None);
        Self { steps: steps(path), broken: run(Some(defect)), vector: vector(&real), real }
    }
}

/// The events of a path, one by one.
fn steps<E: Debug>(path: &[E]) -> Vec<String> {
    path.iter().map(|event| format!("{event:?}")).collect()
}

/// One claim, checked.
#[derive(Debug, Serialize)]
pub(crate) struct Checked {
    pub(crate) id: String,
    pub(crate) family: &'static str,
    pub(crate) rules: &'static [&'static str],
    pub(crate) sentence: &'static str,
    pub(crate) formal: &'static str,
    pub(crate) bounds: String,
    pub(crate) assumptions: Vec<&'static str>,
    pub(crate) result: &'static str,
    pub(crate) states: usize,
    pub(crate) depth: usize,
    pub(crate) seconds: f64,
    pub(crate) evidence: Value,
}

/// One broken variant, checked.
#[derive(Debug, Serialize)]
pub(crate) struct Broken {
    pub(crate) id: String,
    pub(crate) property: String,
    pub(crate) about: &'static str,
    pub(crate) refuted: bool,
    pub(crate) counterexample: Option<Replay>,
}

/// Checks all claims of a protocol.
pub(crate) fn check<P: Protocol>(small: bool) -> Vec<Checked> {
    let runs: Vec<Run> = P::models(small).into_iter().map(run::<P>).collect();
    let complete = runs.iter().all(|run| run.complete);
    let seconds: f64 = runs.iter().map(|run| run.seconds).sum();
    let checked = |claim: &Claim| {
        let counterexample = runs.iter().find_map(|run| run.violated.get(claim.name));
        Checked {
            id: id::<P>(claim.name),
            family: P::FAMILY,
            rules: claim.rules,
            sentence: claim.sentence,
            formal: claim.formal,
            bounds: P::bounds(small),
            assumptions: vec!["no two states of an exploration share a 64-bit fingerprint"],
            result: match counterexample {
                Some(_) => "refuted",
                None if complete => "proved",
                None => "not run",
            },
            states: runs.iter().map(|run| run.states).sum(),
            depth: runs.iter().map(|run| run.depth).max().unwrap_or(0),
            seconds: (seconds * 100.0).round() / 100.0,
            evidence: json!({
                "explorations": runs.iter().map(|run| &run.evidence).collect::<Vec<_>>(),
                "counterexample": counterexample,
            }),
        }
    };
    P::CLAIMS.iter().map(checked).collect()
}

/// Checks that every broken variant of a protocol is refuted by the claim that it is made for.
pub(crate) fn refute<P: Protocol>() -> Vec<Broken> {
    let refute = |&(defect, name, about, claim): &Variant<P::Defect>| {
        let wanted = HasDiscoveries::AllOf(std::iter::once(claim).collect());
        let checker = P::broken(defect).checker().finish_when(wanted);
        let checker = checker.spawn_bfs().join();
        let path = checker.discovery(claim).map(stateright::Path::into_actions);
        let path = path.map(|path| shortened(&P::broken(defect), claim, path));
        let counterexample = path.map(|path| P::replay(defect, &path));
        // The path alone is the checker's word; the replay has to show the difference too.
        let differs = |replay: &Replay| replay.real != replay.broken;
        Broken {
            id: format!("{}/{name}", P::FAMILY),
            property: id::<P>(claim),
            about,
            refuted: counterexample.as_ref().is_some_and(differs),
            counterexample,
        }
    };
    P::BROKEN.iter().map(refute).collect()
}

/// What one exploration found.
struct Run {
    states: usize,
    depth: usize,
    seconds: f64,
    /// Whether it saw every state, and every witness that a claim is not empty.
    complete: bool,
    /// The claims that do not hold, each with a path to where.
    violated: BTreeMap<&'static str, Vec<String>>,
    evidence: Value,
}

fn run<P: Protocol>(model: P::Model) -> Run {
    let start = Instant::now();
    let threads = std::thread::available_parallelism().map_or(1, Into::into);
    let checker = model.checker().threads(threads).spawn_bfs().join();
    let mut found = checker.discoveries();
    let mut witnesses = vec![];
    let mut violated = BTreeMap::new();
    for property in checker.model().properties() {
        let path = found.remove(property.name);
        if property.expectation == Expectation::Sometimes {
            witnesses.push(json!({"name": property.name, "seen": path.is_some()}));
        } else if let Some(path) = path {
            violated.insert(property.name, steps(&path.into_actions()));
        }
    }
    // A claim that nothing could break says nothing: every witness has to be there.
    let complete = checker.is_done() && witnesses.iter().all(|witness| witness["seen"] == true);
    Run {
        states: checker.unique_state_count(),
        depth: checker.max_depth(),
        seconds: start.elapsed().as_secs_f64(),
        complete,
        violated,
        evidence: json!({
            "states": checker.unique_state_count(),
            "transitions": checker.state_count(),
            "depth": checker.max_depth(),
            "complete": checker.is_done(),
            "witnesses": witnesses,
        }),
    }
}

/// The path without the events that the violation does not need.
fn shortened<M>(model: &M, claim: &'static str, mut path: Vec<M::Action>) -> Vec<M::Action>
where
    M: Model,
    M::Action: Clone + PartialEq,
{
    let mut at = 0;
    while at < path.len() {
        let mut shorter = path.clone();
        shorter.remove(at);
        if violates(model, claim, &shorter) {
            path = shorter;
            at = 0;
        } else {
            at += 1;
        }
    }
    path
}

/// Whether the events can happen in this order, and lead to where the claim does not hold.
fn violates<M>(model: &M, claim: &'static str, path: &[M::Action]) -> bool
where
    M: Model,
    M::Action: Clone + PartialEq,
{
    let holds = model.property(claim).condition;
    model.init_states().into_iter().any(|mut state| {
        for event in path {
            let mut enabled = vec![];
            model.actions(&state, &mut enabled);
            if !enabled.contains(event) {
                return false;
            }
            match model.next_state(&state, event.clone()) {
                Some(next) => state = next,
                None => return false,
            }
        }
        !holds(model, &state)
    })
}

fn id<P: Protocol>(claim: &str) -> String {
    format!("model/{}/{}", P::FAMILY, claim.replace(' ', "-"))
}
