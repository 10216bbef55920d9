//! Doubles as terms: the link monitor's source with this type where it says `f64`, for all doubles at once.
//!
//! The build script puts `Number` in the place of `f64`, `Number::of(0.5)` in that of a literal, and `.number()` in
//! that of a cast; all else of the source stays. Terms, paths and solvers are those of the symbolic engine.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::path::Path;

use ncp_kernel::Scalar;
use ncp_proofs::engines::Outcome;
use ncp_proofs::engines::Patience;
use ncp_proofs::engines::symbolic::{self, Solvers};
use ncp_proofs::harness::Harness;
use ncp_proofs::kernel::Production;
use ncp_proofs::properties::{Family, Property};
use ncp_proofs::prover::Prover;
use ncp_proofs::provers::native::{Native, Source};
use ncp_proofs::provers::terms::Symbolic;
use ncp_proofs::vector::Calls;

/// A double of the symbolic engine.
pub type Term = <Symbolic as Prover>::S;

/// A double as a term, or a constant of the source.
#[derive(Debug, Clone, Copy)]
pub enum Number {
    /// What stands in the source.
    Constant(f64),
    /// What is computed.
    Term(Term),
}

impl Number {
    /// A literal.
    #[must_use]
    pub const fn of(value: f64) -> Self {
        Self::Constant(value)
    }
    /// As a term.
    #[must_use]
    pub fn term(self) -> Term {
        match self {
            Self::Constant(value) => Term::constant(value),
            Self::Term(term) => term,
        }
    }
    /// As of a double.
    #[must_use]
    pub fn is_finite(self) -> bool {
        Scalar::is_finite(self.term())
    }
    /// As std says; that it has bounds is checked where it is called.
    #[must_use]
    pub fn clamp(self, least: Self, most: Self) -> Self {
        let raised = if self < least { least } else { self };
        if raised > most { most } else { raised }
    }
    /// As of a double.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        if self < other { other } else { self }
    }
    /// As of a double.
    #[must_use]
    pub fn is_nan(self) -> bool {
        self.partial_cmp(&self).is_none()
    }
}

/// A count as a number.
pub trait Count {
    /// As `as f64` says.
    fn number(self) -> Number;
}

impl Count for u64 {
    #[expect(clippy::cast_precision_loss, reason = "that is the cast")]
    fn number(self) -> Number {
        Number::of(self as f64)
    }
}

impl PartialEq for Number {
    fn eq(&self, other: &Self) -> bool {
        self <= other && other <= self
    }
}

impl PartialOrd for Number {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        match (self <= other, other <= self) {
            (true, true) => Some(Ordering::Equal),
            (true, false) => Some(Ordering::Less),
            (false, true) => Some(Ordering::Greater),
            (false, false) => None,
        }
    }
    fn lt(&self, other: &Self) -> bool {
        self.term().lt(other.term())
    }
    fn le(&self, other: &Self) -> bool {
        self.term().le(other.term())
    }
    fn gt(&self, other: &Self) -> bool {
        other.term().lt(self.term())
    }
    fn ge(&self, other: &Self) -> bool {
        other.term().le(self.term())
    }
}

macro_rules! operation {
    ($($trait:ident $name:ident),*) => {
        $(impl $trait for Number {
            type Output = Self;
            fn $name(self, other: Self) -> Self {
                Self::Term(Scalar::$name(self.term(), other.term()))
            }
        })*
    };
}
operation!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Number {
    type Output = Self;
    /// −x is −0 − x, also for both zeros.
    fn neg(self) -> Self {
        Self::of(-0.0) - self
    }
}

/// A link monitor whose numbers are of some kind.
pub trait Detector<S> {
    /// A new one.
    fn new(ref_loss: S, threshold: S) -> Self;
    /// One whose numbers are these, and that has seen nothing.
    fn of(ref_loss: S, threshold: S, cusum: S) -> Self;
    /// Its numbers.
    fn numbers(&self) -> [S; 3];
    /// A slot that adds so much.
    fn slot(&mut self, by: S);
    /// A frame arrives.
    fn on_frame(&mut self, seq: i64);
    /// Whether losses bunch up.
    fn burst(&self) -> bool;
}

const INVARIANT: &str = "0 ≤ S ≤ 2·threshold";
const STAYS: &str = "the configuration stays";

/// For all doubles: the invariant in every slot, and what a configuration becomes.
fn detector<M: Detector<P::S>, P: Prover>(p: &mut P) {
    let zero = p.number(0.0);
    let (r, t, s) = (p.scalar("ref_loss"), p.scalar("threshold"), p.scalar("S"));
    if p.boolean("a new one") {
        // [NCP-RES-051] [NCP-RES-052]
        let [ref_loss, threshold, cusum] = M::new(r, t).numbers();
        let (most, usual, five) = (p.number(0.99), p.number(0.05), p.number(5.0));
        let says = {
            let (below, above, is_number) = (p.lt(r, zero), p.lt(most, r), p.finite(r));
            let clamped = p.select(above, most, r);
            let clamped = p.select(below, zero, clamped);
            p.select(is_number, clamped, usual)
        };
        let is_said = equal(p, ref_loss, says);
        p.check("ref_loss is clamped, or 0.05", is_said);
        let (is_number, is_positive) = (p.finite(t), p.lt(zero, t));
        let usable = p.and(is_number, is_positive);
        let says = p.select(usable, t, five);
        let is_said = equal(p, threshold, says);
        p.check("the threshold, or 5", is_said);
        let is_zero = equal(p, cusum, zero);
        p.check("nothing was seen", is_zero);
        return;
    }
    // Any state that a configuration and the invariant allow.
    let (most_loss, is_number, is_positive) = (p.number(0.99), p.finite(t), p.lt(zero, t));
    let (at_least, at_most) = (p.le(zero, r), p.le(r, most_loss));
    let configured = p.all(&[at_least, at_most, is_number, is_positive]);
    p.assume(configured);
    let twice = t.add(t);
    let invariant = within(p, s, twice);
    p.assume(invariant);
    let has_bounds = p.le(zero, twice);
    p.check("the clamp has bounds", has_bounds);

    let mut monitor = M::of(r, t, s);
    let is_burst = monitor.burst();
    let says = p.lt(t, s);
    p.exactly("a burst exactly above the threshold", is_burst, says);
    let is_loss = p.boolean("a seq is missing");
    let by = if is_loss { p.number(1.0).sub(r) } else { p.number(-0.0).sub(r) };
    monitor.slot(by);
    let [ref_loss, threshold, cusum] = monitor.numbers();
    let kept = within(p, cusum, twice);
    p.check(INVARIANT, kept);
    let (same_r, same_t) = (p.same(ref_loss, r), p.same(threshold, t));
    let stays = p.and(same_r, same_t);
    p.check(STAYS, stays);
    if is_loss {
        let rises = p.le(s, cusum);
        p.check("a missing seq lowers S never", rises);
    } else {
        let falls = p.le(cusum, s);
        p.check("a delivery raises S never", falls);
    }
    // The first frame of a stream is one delivery, by the public way.
    let mut monitor = M::of(r, t, s);
    monitor.on_frame(7);
    let [_, _, cusum] = monitor.numbers();
    let (kept, falls) = (within(p, cusum, twice), p.le(cusum, s));
    let both = p.and(kept, falls);
    p.check("a frame that arrives keeps the invariant and raises S never", both);
}

fn within<P: Prover>(p: &mut P, s: P::S, twice: P::S) -> P::B {
    let zero = p.number(0.0);
    let (at_least, at_most) = (p.le(zero, s), p.le(s, twice));
    p.and(at_least, at_most)
}

/// Equal as numbers; none is NaN.
fn equal<P: Prover>(p: &mut P, a: P::S, b: P::S) -> P::B {
    let (there, back) = (p.le(a, b), p.le(b, a));
    p.and(there, back)
}

/// The harness on the source with terms in it, and on the source as it is.
#[must_use]
pub fn harness<T: Detector<Term>, D: Detector<f64>>() -> Harness {
    Harness {
        symbolic: detector::<T, Symbolic>,
        native: detector::<D, Native<Source>>,
        calls: Calls::of::<Production>(),
    }
}

/// What the symbolic engine says.
const PROPERTY: Property = Property {
    id: "link/detector",
    family: Family::Number,
    rules: &[],
    sentence: "",
    statement: "0 ≤ S ≤ 2·threshold in every slot",
    bounds: "",
    assumptions: &[],
};

/// Decides the harness for all doubles; leaves its obligations in `.tools/path-evidence`, in a folder of the subject.
/// None where there is no solver.
#[must_use]
pub fn prove(root: &Path, subject: &str, harness: &Harness) -> Option<Outcome> {
    let solvers = Solvers {
        bin: root.join(".tools/proofs-venv").join(if cfg!(windows) { "Scripts" } else { "bin" }),
        script: root.join("proofs/evidence/solve.py"),
        patience: Patience::default(),
        limits: symbolic::Limits::default(),
        known: None,
    };
    let evidence = root.join(".tools/path-evidence").join(subject);
    solvers.bin.is_dir().then(|| symbolic::prove(&PROPERTY, harness, &solvers, &evidence))
}
