//! Runs the checker on one protocol, and on its broken variants.

use std::collections::BTreeMap;
use std::fmt::Debug;
use std::hash::Hash;
use std::time::Instant;

use ncp_proofs::report::{Answer, Broken, Found, Shown, Verdict, Words, owned};
use ncp_text::WIRE_VERSION;
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
    /// What it says, formally. `{version}` stands for the version of the text, here and in what is broken.
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
#[derive(Debug)]
pub(crate) struct Replay {
    /// What happens, step by step.
    steps: Vec<String>,
    /// What the broken variant answers, step by step.
    broken: Value,
    /// What the real code answers.
    real: Value,
    /// The steps as a case of the vectors, with what the real code answers.
    vector: Option<Value>,
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

    fn shown(self) -> Found {
        let Self { steps, broken, real, vector } = self;
        Found { vector, ..Found::new(Shown::Path { steps, broken, real }) }
    }
}

/// A case of the vectors.
#[expect(clippy::needless_pass_by_value, reason = "each is made for this")]
pub(crate) fn case(role: &str, call: &str, args: Value, expect: Value) -> Value {
    json!({"roles": [role], "call": call, "args": args, "expect": expect})
}

/// That an answer has at least these parts.
#[expect(clippy::needless_pass_by_value, reason = "it is made for this")]
pub(crate) fn pattern(value: Value) -> Value {
    json!({"relation": "pattern", "value": value})
}

/// The events of a path, one by one.
fn steps<E: Debug>(path: &[E]) -> Vec<String> {
    path.iter().map(|event| format!("{event:?}")).collect()
}

/// Checks all claims of a protocol.
pub(crate) fn check<P: Protocol>(small: bool) -> Vec<Answer> {
    let runs: Vec<Run> = P::models(small).into_iter().map(run::<P>).collect();
    let complete = runs.iter().all(|run| run.complete);
    let seconds: f64 = runs.iter().map(|run| run.seconds).sum();
    let checked = |claim: &Claim| {
        let steps = runs.iter().find_map(|run| run.violated.get(claim.name));
        let verdict = match steps {
            Some(_) => Verdict::Refuted,
            None if complete => Verdict::Proved,
            None => Verdict::NotRun,
        };
        let path = |steps: &Vec<String>| Shown::Path { steps: steps.clone(), broken: Value::Null, real: Value::Null };
        Answer {
            words: Some(Words {
                family: P::FAMILY.to_owned(),
                rules: owned(claim.rules),
                sentence: claim.sentence.to_owned(),
                statement: claim.formal.replace("{version}", WIRE_VERSION),
                bounds: P::bounds(small),
                assumptions: owned(&["no two states of an exploration share a 64-bit fingerprint"]),
            }),
            states: Some(runs.iter().map(|run| run.states).sum()),
            counterexample: steps.map(path).map(Found::new),
            seconds: Some(seconds),
            ..Answer::new(&id::<P>(claim.name), verdict)
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
        // The path alone is the checker's word; the replay has to show the difference too.
        let replay = path.map(|path| P::replay(defect, &path)).filter(|replay| replay.real != replay.broken);
        Broken {
            id: format!("{}/{name}", P::FAMILY),
            property: id::<P>(claim),
            family: P::FAMILY.to_owned(),
            about: about.replace("{version}", WIRE_VERSION),
            file: None,
            from: None,
            to: None,
            missed: replay.is_none().then(|| "no counterexample".to_owned()),
            counterexample: replay.map(Replay::shown),
        }
    };
    P::BROKEN.iter().map(refute).collect()
}

/// What one exploration found.
struct Run {
    states: u64,
    seconds: f64,
    /// Whether it saw every state, and every witness that a claim is not empty.
    complete: bool,
    /// The claims that do not hold, each with a path to where.
    violated: BTreeMap<&'static str, Vec<String>>,
}

fn run<P: Protocol>(model: P::Model) -> Run {
    let start = Instant::now();
    let threads = std::thread::available_parallelism().map_or(1, Into::into);
    let checker = model.checker().threads(threads).spawn_bfs().join();
    let mut found = checker.discoveries();
    let mut unseen = vec![];
    let mut violated = BTreeMap::new();
    for property in checker.model().properties() {
        let path = found.remove(property.name);
        match (property.expectation, path) {
            (Expectation::Sometimes, None) => unseen.push(property.name),
            (Expectation::Sometimes, Some(_)) | (_, None) => {}
            (_, Some(path)) => {
                violated.insert(property.name, steps(&path.into_actions()));
            }
        }
    }
    let (states, seconds) = (checker.unique_state_count() as u64, start.elapsed().as_secs_f64());
    let (transitions, depth) = (checker.state_count(), checker.max_depth());
    println!("{}: {states} states, {transitions} transitions, depth {depth}, {seconds:.1} s", P::FAMILY);
    for witness in &unseen {
        println!("{}: never seen: {witness}", P::FAMILY);
    }
    // A claim that nothing could break says nothing: every witness has to be there.
    Run { states, seconds, complete: checker.is_done() && unseen.is_empty(), violated }
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
