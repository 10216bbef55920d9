//! The symbolic scalar, the paths that its comparisons fork, and the formulas of checks.
//!
//! A comparison of two terms asks the *path*. A decision that the path has not taken yet is taken as true
//! and noted; when the run is over, the last decision that can still be taken otherwise is, and the
//! harness runs again from its beginning with those decisions. So every combination of answers is run,
//! whether or not numbers exist that give it: the solver is asked about that, nobody else.

use std::cell::RefCell;
use std::collections::{BTreeSet, HashMap};
use std::panic::resume_unwind;

use ncp_kernel::{Scalar, Seq};

use crate::prover::{INDICES, Prover};

/// More operations on one path than these are no end of it.
const MOST_STEPS: u64 = 1_000_000;

/// A node of the graph of terms; terms are numbers of nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Node {
    Double(u64),
    Variable(u32),
    Add(u32, u32),
    Sub(u32, u32),
    Mul(u32, u32),
    Div(u32, u32),
    Sqrt(u32),
    Abs(u32),
    Select(u32, u32, u32),
    SeqVariable(u32),
    True,
    Lt(u32, u32),
    Le(u32, u32),
    Finite(u32),
    Same(u32, u32),
    SeqLt(u32, u32),
    SeqSame(u32, u32),
    SeqZero(u32),
    Not(u32),
    And(u32, u32),
}

/// A decision of a path: which of how many ways.
#[derive(Debug, Clone, Copy)]
struct Fork {
    way: usize,
    ways: usize,
}

/// What a path has decided, in order: what tells it from all others.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Decision {
    /// The answer to a comparison.
    Answer(u32, bool),
    /// Which of how many ways the harness goes on, at its `nth` choice.
    Way { nth: u16, way: u16, ways: u16 },
}

/// The graph of terms, and the path at work.
#[derive(Debug, Default)]
pub(crate) struct World {
    nodes: Vec<Node>,
    numbers: HashMap<Node, u32>,
    forks: Vec<Fork>,
    at: usize,
    literals: Vec<(u32, bool)>,
    decisions: Vec<Decision>,
    decided: HashMap<u32, bool>,
    choices: Vec<usize>,
    steps: u64,
    variables: u32,
    seqs: u32,
    assumed: Option<u32>,
    is_dead: bool,
    checks: Vec<(&'static str, u32)>,
    by_evaluation: u64,
    reached: BTreeSet<&'static str>,
    guide: Option<Guide>,
    /// The variable that stands for the number [`INDEX`].
    index: Option<u32>,
}

/// An index that stands for any: the number that the kernel makes of it is a variable. A power of two far above all
/// that is counted, and a little more.
const INDEX: usize = (1 << 40) + 12_345;

/// Inputs that decide which path is run.
#[derive(Debug, Clone, Default)]
pub(crate) struct Guide {
    pub(crate) scalars: Vec<f64>,
    pub(crate) seqs: Vec<i64>,
    pub(crate) choices: Vec<usize>,
    /// What terms are for them, as far as it was asked.
    pub(crate) known: RefCell<HashMap<u32, Concrete>>,
}

/// What a term is for given inputs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Concrete {
    Double(f64),
    Seq(i64),
    Truth(bool),
}

/// What one path left.
#[derive(Debug)]
pub(crate) struct Path {
    /// The decisions on comparisons.
    pub(crate) literals: Vec<(u32, bool)>,
    /// All decisions, but for those after which no check counts.
    pub(crate) decisions: Vec<Decision>,
    /// The checks that are not true by evaluation alone.
    pub(crate) checks: Vec<(&'static str, u32)>,
    /// The choices, for a replay.
    pub(crate) choices: Vec<usize>,
    /// How many checks were true by evaluation alone: their answers were constants.
    pub(crate) by_evaluation: u64,
    /// The names of all checks on it.
    pub(crate) reached: BTreeSet<&'static str>,
}

thread_local! {
    static WORLD: RefCell<World> = RefCell::new(World::default());
}

fn with<T>(f: impl FnOnce(&mut World) -> T) -> T {
    WORLD.with(|world| f(&mut world.borrow_mut()))
}

/// Begins anew, without terms and paths.
pub(crate) fn clear() {
    with(|world| *world = World::default());
}

/// The node of a term.
pub(crate) fn node(term: u32) -> Node {
    with(|world| world.node(term))
}

/// Runs a harness once, on the path that comes next.
pub(crate) fn run(length: usize, harness: fn(&mut Symbolic)) -> Path {
    with(World::begin);
    harness(&mut Symbolic { length });
    with(|world| Path {
        literals: std::mem::take(&mut world.literals),
        decisions: std::mem::take(&mut world.decisions),
        checks: std::mem::take(&mut world.checks),
        choices: std::mem::take(&mut world.choices),
        by_evaluation: world.by_evaluation,
        reached: std::mem::take(&mut world.reached),
    })
}

/// Runs a harness once, on the path that these inputs take; and the checks on it that they break.
pub(crate) fn run_guided(length: usize, harness: fn(&mut Symbolic), guide: Guide) -> (Path, Vec<(&'static str, u32)>) {
    with(|world| world.guide = Some(guide));
    let path = run(length, harness);
    let broken = with(|world| {
        let is_broken = |(_, check): &&(_, u32)| world.concrete(*check) == Concrete::Truth(false);
        let broken = path.checks.iter().filter(is_broken).copied().collect();
        world.guide = None;
        broken
    });
    (path, broken)
}

/// Turns the last decision that can be turned; false when all paths are done.
pub(crate) fn turn() -> bool {
    with(|world| {
        // What was not asked for again does not count.
        world.forks.truncate(world.at);
        while let Some(fork) = world.forks.pop() {
            if fork.way + 1 < fork.ways {
                world.forks.push(Fork { way: fork.way + 1, ..fork });
                return true;
            }
        }
        false
    })
}

impl World {
    fn begin(&mut self) {
        self.at = 0;
        self.literals.clear();
        self.decisions.clear();
        self.decided.clear();
        self.choices.clear();
        self.checks.clear();
        self.reached.clear();
        (self.steps, self.variables, self.seqs, self.by_evaluation) = (0, 0, 0, 0);
        (self.assumed, self.is_dead) = (None, false);
        self.index = None;
    }

    fn node(&self, term: u32) -> Node {
        self.nodes.get(term as usize).copied().unwrap_or(Node::True)
    }

    #[expect(clippy::cast_possible_truncation, reason = "far fewer than 2³² terms fit memory")]
    fn term(&mut self, node: Node) -> u32 {
        self.steps += 1;
        if self.steps > MOST_STEPS {
            resume_unwind(Box::new(format!("no end after {MOST_STEPS} operations on one path")));
        }
        if let Some(number) = self.numbers.get(&node) {
            return *number;
        }
        let number = self.nodes.len() as u32;
        self.nodes.push(node);
        self.numbers.insert(node, number);
        number
    }

    fn double(&self, term: u32) -> Option<f64> {
        match self.node(term) {
            Node::Double(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    fn constant(&mut self, value: f64) -> u32 {
        #[expect(clippy::cast_precision_loss)]
        if let Some(index) = self.index
            && value.to_bits() == (INDEX as f64).to_bits()
        {
            return index;
        }
        // Of bits and not of doubles, where a compiler may take one NaN for another.
        let bits = if value.is_nan() { f64::NAN.to_bits() } else { value.to_bits() };
        self.term(Node::Double(bits))
    }

    fn binary(&mut self, node: Node, a: u32, b: u32, f: fn(f64, f64) -> f64) -> u32 {
        match (self.double(a), self.double(b)) {
            (Some(a), Some(b)) => self.constant(f(a, b)),
            _ => self.term(node),
        }
    }

    fn truth(&mut self, value: bool) -> u32 {
        let yes = self.term(Node::True);
        if value { yes } else { self.term(Node::Not(yes)) }
    }

    /// What a formula is without regard to the path.
    fn value(&self, formula: u32) -> Option<bool> {
        match self.node(formula) {
            Node::True => Some(true),
            Node::Not(a) => self.value(a).map(|a| !a),
            _ => None,
        }
    }

    fn not(&mut self, a: u32) -> u32 {
        match self.node(a) {
            Node::Not(inner) => inner,
            _ => self.term(Node::Not(a)),
        }
    }

    fn and(&mut self, a: u32, b: u32) -> u32 {
        match (self.value(a), self.value(b)) {
            (Some(false), _) | (_, Some(false)) => self.truth(false),
            (Some(true), _) => b,
            (_, Some(true)) => a,
            _ if a == b => a,
            _ => self.term(Node::And(a.min(b), a.max(b))),
        }
    }

    fn lt(&mut self, a: u32, b: u32) -> u32 {
        match (self.double(a), self.double(b)) {
            (Some(a), Some(b)) => self.truth(a < b),
            _ => self.term(Node::Lt(a, b)),
        }
    }

    fn le(&mut self, a: u32, b: u32) -> u32 {
        match (self.double(a), self.double(b)) {
            (Some(a), Some(b)) => self.truth(a <= b),
            _ => self.term(Node::Le(a, b)),
        }
    }

    fn finite(&mut self, a: u32) -> u32 {
        match self.double(a) {
            Some(a) => self.truth(a.is_finite()),
            None => self.term(Node::Finite(a)),
        }
    }

    fn select(&mut self, condition: u32, a: u32, b: u32) -> u32 {
        match self.known(condition) {
            // What the path has decided stands in its condition too.
            Some(true) => a,
            Some(false) => b,
            None => self.term(Node::Select(condition, a, b)),
        }
    }

    /// What the path has decided of a formula, or what follows from that at once.
    fn known(&self, formula: u32) -> Option<bool> {
        if let Some(known) = self.decided.get(&formula) {
            return Some(*known);
        }
        match self.node(formula) {
            Node::True => Some(true),
            Node::Not(a) => self.known(a).map(|a| !a),
            Node::And(a, b) => match (self.known(a), self.known(b)) {
                (Some(false), _) | (_, Some(false)) => Some(false),
                (Some(true), Some(true)) => Some(true),
                _ => None,
            },
            // a < b excludes b < a and b ≤ a, and entails a ≤ b; NaNs or not.
            Node::Lt(a, b) => {
                let is = |node| self.is(node);
                (is(Node::Lt(b, a)) == Some(true)
                    || is(Node::Le(b, a)) == Some(true)
                    || is(Node::Le(a, b)) == Some(false))
                .then_some(false)
            }
            Node::Le(a, b) => {
                if self.is(Node::Lt(a, b)) == Some(true) {
                    Some(true)
                } else {
                    (self.is(Node::Lt(b, a)) == Some(true)).then_some(false)
                }
            }
            _ => None,
        }
    }

    fn is(&self, node: Node) -> Option<bool> {
        self.decided.get(self.numbers.get(&node)?).copied()
    }

    fn fork(&mut self, ways: usize) -> usize {
        if self.is_dead {
            return 0;
        }
        let at = self.at;
        self.at += 1;
        if let Some(guide) = &self.guide {
            let nth = self.choices.len();
            return guide.choices.get(nth).copied().unwrap_or_default();
        }
        if let Some(fork) = self.forks.get(at) {
            return fork.way;
        }
        self.forks.push(Fork { way: 0, ways });
        0
    }

    fn note(&mut self, decision: Decision) {
        if !self.is_dead {
            self.decisions.push(decision);
        }
    }

    /// The term's value for the inputs of the guide.
    fn concrete(&self, term: u32) -> Concrete {
        let known = self.guide.as_ref().map(|guide| &guide.known);
        if let Some(known) = known.and_then(|known| known.borrow().get(&term).copied()) {
            return known;
        }
        let value = self.evaluate(term);
        if let Some(known) = known {
            known.borrow_mut().insert(term, value);
        }
        value
    }

    fn evaluate(&self, term: u32) -> Concrete {
        let double = |term| match self.concrete(term) {
            Concrete::Double(value) => value,
            _ => f64::NAN,
        };
        let seq = |term| match self.concrete(term) {
            Concrete::Seq(value) => value,
            _ => 0,
        };
        let truth = |term| self.concrete(term) == Concrete::Truth(true);
        let nth = |nth: u32| nth as usize;
        let guide = self.guide.as_ref();
        match self.node(term) {
            Node::Double(bits) => Concrete::Double(f64::from_bits(bits)),
            Node::Variable(number) => {
                Concrete::Double(guide.and_then(|guide| guide.scalars.get(nth(number)).copied()).unwrap_or_default())
            }
            Node::SeqVariable(number) => {
                Concrete::Seq(guide.and_then(|guide| guide.seqs.get(nth(number)).copied()).unwrap_or_default())
            }
            Node::Add(a, b) => Concrete::Double(double(a) + double(b)),
            Node::Sub(a, b) => Concrete::Double(double(a) - double(b)),
            Node::Mul(a, b) => Concrete::Double(double(a) * double(b)),
            Node::Div(a, b) => Concrete::Double(double(a) / double(b)),
            Node::Sqrt(a) => Concrete::Double(double(a).sqrt()),
            Node::Abs(a) => Concrete::Double(double(a).abs()),
            Node::Select(c, a, b) => Concrete::Double(double(if truth(c) { a } else { b })),
            Node::True => Concrete::Truth(true),
            Node::Lt(a, b) => Concrete::Truth(double(a) < double(b)),
            Node::Le(a, b) => Concrete::Truth(double(a) <= double(b)),
            Node::Finite(a) => Concrete::Truth(double(a).is_finite()),
            Node::Same(a, b) => {
                let (a, b) = (double(a), double(b));
                Concrete::Truth(a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan()))
            }
            Node::SeqLt(a, b) => Concrete::Truth(seq(a) < seq(b)),
            Node::SeqSame(a, b) => Concrete::Truth(seq(a) == seq(b)),
            Node::SeqZero(a) => Concrete::Truth(seq(a) == 0),
            Node::Not(a) => Concrete::Truth(!truth(a)),
            Node::And(a, b) => Concrete::Truth(truth(a) && truth(b)),
        }
    }

    fn decide(&mut self, formula: u32) -> bool {
        if let Some(known) = self.known(formula) {
            return known;
        }
        let answer = match self.guide {
            Some(_) => self.concrete(formula) == Concrete::Truth(true),
            None => self.fork(2) == 0,
        };
        self.literals.push((formula, answer));
        self.note(Decision::Answer(formula, answer));
        self.decided.insert(formula, answer);
        answer
    }
}

/// A double of the kernel as a term.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SymbolicScalar(u32);

/// A seq of the kernel as a term.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SymbolicSeq(u32);

impl Scalar for SymbolicScalar {
    fn constant(value: f64) -> Self {
        Self(with(|world| world.constant(value)))
    }
    fn add(self, other: Self) -> Self {
        let (a, b) = (self.0, other.0);
        Self(with(|world| world.binary(Node::Add(a, b), a, b, |a, b| a + b)))
    }
    fn sub(self, other: Self) -> Self {
        let (a, b) = (self.0, other.0);
        Self(with(|world| world.binary(Node::Sub(a, b), a, b, |a, b| a - b)))
    }
    fn mul(self, other: Self) -> Self {
        let (a, b) = (self.0, other.0);
        Self(with(|world| world.binary(Node::Mul(a, b), a, b, |a, b| a * b)))
    }
    fn div(self, other: Self) -> Self {
        let (a, b) = (self.0, other.0);
        Self(with(|world| world.binary(Node::Div(a, b), a, b, |a, b| a / b)))
    }
    fn sqrt(self) -> Self {
        Self(with(|world| match world.double(self.0) {
            Some(value) => world.constant(value.sqrt()),
            None => world.term(Node::Sqrt(self.0)),
        }))
    }
    fn abs(self) -> Self {
        Self(with(|world| match world.double(self.0) {
            Some(value) => world.constant(value.abs()),
            None => world.term(Node::Abs(self.0)),
        }))
    }
    fn select_lt(self, other: Self, then: Self, otherwise: Self) -> Self {
        Self(with(|world| {
            let formula = world.lt(self.0, other.0);
            world.select(formula, then.0, otherwise.0)
        }))
    }
    fn lt(self, other: Self) -> bool {
        with(|world| {
            let formula = world.lt(self.0, other.0);
            world.decide(formula)
        })
    }
    fn le(self, other: Self) -> bool {
        with(|world| {
            let formula = world.le(self.0, other.0);
            world.decide(formula)
        })
    }
    fn is_finite(self) -> bool {
        with(|world| {
            let formula = world.finite(self.0);
            world.decide(formula)
        })
    }
    fn floor_index(self, most: usize) -> usize {
        if !Self::constant(0.0).le(self) {
            return 0;
        }
        #[expect(clippy::cast_precision_loss)]
        let is_below = |index: usize| self.lt(Self::constant(index as f64 + 1.0));
        (0..most).find(|index| is_below(*index)).unwrap_or(most)
    }
}

impl Seq for SymbolicSeq {
    fn is_zero(self) -> bool {
        with(|world| {
            let formula = world.term(Node::SeqZero(self.0));
            world.decide(formula)
        })
    }
    fn lt(self, other: Self) -> bool {
        with(|world| {
            let formula = world.term(Node::SeqLt(self.0, other.0));
            world.decide(formula)
        })
    }
}

/// The prover whose numbers are terms.
#[derive(Debug)]
pub struct Symbolic {
    /// The longest sequence of events.
    pub(crate) length: usize,
}

impl Prover for Symbolic {
    type S = SymbolicScalar;
    type Q = SymbolicSeq;
    type B = u32;

    fn scalar(&mut self, _name: &str) -> SymbolicScalar {
        SymbolicScalar(with(|world| {
            world.variables += 1;
            world.term(Node::Variable(world.variables - 1))
        }))
    }
    fn seq(&mut self, _name: &str) -> SymbolicSeq {
        SymbolicSeq(with(|world| {
            world.seqs += 1;
            world.term(Node::SeqVariable(world.seqs - 1))
        }))
    }
    fn choice(&mut self, _name: &str, count: usize) -> usize {
        with(|world| {
            let way = world.fork(count);
            let short = |number| u16::try_from(number).unwrap_or(u16::MAX);
            let (nth, which, ways) = (short(world.choices.len()), short(way), short(count));
            world.note(Decision::Way { nth, way: which, ways });
            world.choices.push(way);
            way
        })
    }
    fn index(&mut self, name: &str) -> usize {
        let SymbolicScalar(variable) = self.scalar(name);
        with(|world| {
            // A replay takes the last of those that others take; inputs that guide the run have one of them.
            let nth = world.choices.len();
            let guided = world.guide.as_ref().map(|guide| guide.choices.get(nth).copied().unwrap_or_default());
            world.choices.push(guided.unwrap_or(INDICES.len() - 1));
            if guided.is_none() {
                world.index = Some(variable);
            }
            guided.map_or(INDEX, |nth| INDICES.get(nth).copied().unwrap_or_default())
        })
    }
    fn length(&self, most: usize) -> usize {
        most.min(self.length)
    }
    fn assume(&mut self, condition: u32) {
        with(|world| {
            world.assumed = Some(match world.assumed {
                Some(before) => world.and(before, condition),
                None => condition,
            });
            world.is_dead |= world.known(condition) == Some(false);
        });
    }
    fn never(&mut self, name: &'static str) {
        let no = self.truth(false);
        self.check(name, no);
        with(|world| world.reached.remove(name));
    }
    fn check(&mut self, name: &'static str, condition: u32) {
        let condition = match with(|world| world.assumed) {
            Some(assumed) => self.implies(assumed, condition),
            None => condition,
        };
        with(|world| {
            if world.is_dead {
                return;
            }
            world.reached.insert(name);
            if world.value(condition) == Some(true) {
                world.by_evaluation += 1;
            } else {
                world.checks.push((name, condition));
            }
        });
    }
    fn truth(&mut self, value: bool) -> u32 {
        with(|world| world.truth(value))
    }
    fn not(&mut self, a: u32) -> u32 {
        with(|world| world.not(a))
    }
    fn and(&mut self, a: u32, b: u32) -> u32 {
        with(|world| world.and(a, b))
    }
    fn lt(&mut self, a: SymbolicScalar, b: SymbolicScalar) -> u32 {
        with(|world| world.lt(a.0, b.0))
    }
    fn le(&mut self, a: SymbolicScalar, b: SymbolicScalar) -> u32 {
        with(|world| world.le(a.0, b.0))
    }
    fn finite(&mut self, a: SymbolicScalar) -> u32 {
        with(|world| world.finite(a.0))
    }
    fn same(&mut self, a: SymbolicScalar, b: SymbolicScalar) -> u32 {
        with(|world| match (world.double(a.0), world.double(b.0)) {
            // NaN has one spelling among constants.
            (Some(a), Some(b)) => world.truth(a.to_bits() == b.to_bits()),
            _ if a == b => world.truth(true),
            _ => world.term(Node::Same(a.0, b.0)),
        })
    }
    fn seq_lt(&mut self, a: SymbolicSeq, b: SymbolicSeq) -> u32 {
        with(|world| world.term(Node::SeqLt(a.0, b.0)))
    }
    fn seq_same(&mut self, a: SymbolicSeq, b: SymbolicSeq) -> u32 {
        with(|world| if a == b { world.truth(true) } else { world.term(Node::SeqSame(a.0, b.0)) })
    }
    fn seq_zero(&mut self, a: SymbolicSeq) -> u32 {
        with(|world| world.term(Node::SeqZero(a.0)))
    }
    fn select(&mut self, condition: u32, a: SymbolicScalar, b: SymbolicScalar) -> SymbolicScalar {
        SymbolicScalar(with(|world| world.select(condition, a.0, b.0)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The decisions and the checks of all paths.
    fn all(harness: fn(&mut Symbolic)) -> Vec<Path> {
        clear();
        let mut paths = vec![run(6, harness)];
        while turn() {
            paths.push(run(6, harness));
        }
        paths
    }

    #[test]
    fn every_answer_and_every_way_is_explored_once() {
        let paths = all(|p| {
            let (a, b) = (p.scalar("a"), p.scalar("b"));
            if p.choice("way", 3) == 1 {
                return;
            }
            let _ = a.lt(b) && a.is_finite();
        });
        let answers = |path: &Path| path.literals.iter().map(|(_, answer)| *answer).collect::<Vec<_>>();
        let found: Vec<_> = paths.iter().map(|path| (path.choices[0], answers(path))).collect();
        let both = |way| [(way, vec![true, true]), (way, vec![true, false]), (way, vec![false])];
        assert_eq!(found, [&both(0)[..], &[(1, Vec::new())], &both(2)].concat());
    }

    #[test]
    fn what_follows_from_a_decision_is_no_decision() {
        let paths = all(|p| {
            let (a, b) = (p.scalar("a"), p.scalar("b"));
            if a.lt(b) {
                assert!(a.lt(b) && a.le(b) && !b.lt(a) && !b.le(a));
            }
        });
        assert_eq!(paths.len(), 2);
    }

    #[test]
    fn what_is_not_less_may_be_no_number() {
        let paths = all(|p| {
            let (a, b) = (p.scalar("a"), p.scalar("b"));
            let _ = !a.lt(b) && b.le(a);
        });
        assert_eq!(paths.len(), 3);
    }

    #[test]
    fn where_an_assumption_cannot_hold_nothing_is_decided_or_checked() {
        let paths = all(|p| {
            let (a, b) = (p.scalar("a"), p.scalar("b"));
            let less = a.lt(b);
            let says = p.truth(less);
            p.assume(says);
            let _ = p.choice("way", 5);
            let no = p.truth(false);
            p.check("never", no);
        });
        // Five ways where a < b, and one path that ends where it is not.
        assert_eq!(paths.iter().map(|path| path.checks.len()).collect::<Vec<_>>(), [1, 1, 1, 1, 1, 0]);
        assert_eq!(paths[5].decisions.len(), 1);
    }

    #[test]
    fn a_check_holds_where_the_assumptions_do() {
        let paths = all(|p| {
            let (a, b) = (p.scalar("a"), p.scalar("b"));
            for condition in [p.finite(a), p.finite(b)] {
                p.assume(condition);
            }
            let finite = p.finite(a);
            p.check("finite", finite);
        });
        let [(_, formula)] = paths[0].checks[..] else { panic!("{:?}", paths[0].checks) };
        // ¬((a finite ∧ b finite) ∧ ¬(a finite))
        let Node::Not(both) = node(formula) else { panic!("{:?}", node(formula)) };
        assert!(matches!(node(both), Node::And(..)), "{:?}", node(both));
    }

    #[test]
    fn a_path_without_an_end_is_ended() {
        let run = || {
            all(|p| {
                loop {
                    let _ = p.number(1.0).add(p.number(2.0));
                }
            })
        };
        let said = std::panic::catch_unwind(run).unwrap_err();
        assert!(said.downcast_ref::<String>().unwrap().starts_with("no end"));
    }

    #[test]
    fn every_nan_is_one_constant() {
        clear();
        let nan = [f64::NAN, -f64::NAN, f64::sqrt(std::hint::black_box(-1.0)), f64::from_bits(0x7ff0_0000_0000_0001)];
        let terms = nan.map(SymbolicScalar::constant);
        assert_eq!(terms, [terms[0]; 4]);
        assert_eq!(terms[0], SymbolicScalar::constant(-1.0).sqrt());
    }
}
