//! Controls: claims of which it is known what an engine has to say, with which it is tried before it is believed.
//!
//! The true ones need arithmetic, an assumption, or each way of a comparison; the false ones fail on inputs that only a
//! search finds. An engine that leaves paths out, reads its answers wrongly, or asks something else than what runs,
//! gives itself away here.

use std::fs;
use std::path::Path;

use ncp_kernel::Scalar;
use thiserror::Error;

use super::{Limits, Origin, Solvers, prove, refute};
use crate::engines::outcome::{Outcome, Patience, Verdict};
use crate::harness::Harness;
use crate::kernel::Production;
use crate::properties::{Family, Property};
use crate::prover::Prover;
use crate::provers::native::{Native, Source};
use crate::provers::terms::Symbolic;
use crate::vector::Calls;

/// The engine says something else of controls than what is true.
#[derive(Debug, Error)]
#[error("the symbolic engine is at fault, by {} of its {held} controls. {}", faults.len(), lines(faults))]
pub struct AtFault {
    held: usize,
    faults: Vec<Fault>,
}

/// It does of one of them.
#[derive(Debug, Error)]
#[error("{control}: {shows} (\"{claim}\" has to be: {wanted}; is: {said}).")]
struct Fault {
    control: &'static str,
    claim: &'static str,
    wanted: String,
    said: String,
    shows: &'static str,
}

fn lines(faults: &[Fault]) -> String {
    faults.iter().map(Fault::to_string).collect::<Vec<_>>().join(" ")
}

/// A claim, and what is known of it.
struct Control {
    id: &'static str,
    claim: &'static str,
    harness: Harness,
    wanted: Wanted,
    /// What is wrong with an engine that says something else.
    shows: &'static str,
}

/// What an engine has to say of a control.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Wanted {
    /// It holds, on so many paths, with so many obligations, of which so many hold without arithmetic.
    Proved { paths: u64, obligations: u64, without_arithmetic: u64 },
    /// Its own search finds a counterexample, and doubles confirm it.
    Refuted,
    /// It is not decided within no steps.
    Undecided,
    /// The model fails on terms only.
    NotReplayed,
    /// It holds on terms, and fails on doubles.
    OnlyNumbers,
}

/// Holds the engine against all controls; its files go into `folder`.
///
/// # Errors
/// The controls of which the engine says something else.
pub fn hold(solvers: &Solvers, folder: &Path) -> Result<usize, AtFault> {
    let all = all();
    let faults: Vec<Fault> = all.iter().filter_map(|control| hold_one(control, solvers, folder).err()).collect();
    if faults.is_empty() { Ok(all.len()) } else { Err(AtFault { held: all.len(), faults }) }
}

fn hold_one(control: &Control, solvers: &Solvers, folder: &Path) -> Result<(), Fault> {
    let fault = |said: String| {
        let Control { id, claim, wanted, shows, .. } = *control;
        Fault { control: id, claim, wanted: wanted.to_string(), said, shows }
    };
    let property = control.property();
    // What an earlier run may have left: an answer to something else.
    let stale = ["001.smt2", "002.smt2"].map(|name| folder.join(control.id).join(name));
    let planted = stale.iter().try_for_each(|file| {
        fs::create_dir_all(folder.join(control.id))?;
        fs::write(file, STALE)
    });
    planted.map_err(|error| fault(error.to_string()))?;
    let limits = if control.wanted == Wanted::Undecided { NO_STEPS } else { solvers.limits };
    let solvers = Solvers {
        bin: solvers.bin.clone(),
        script: solvers.script.clone(),
        patience: Patience::default(),
        limits,
        known: None,
    };
    let outcome = prove(&property, &control.harness, &solvers, folder);
    let is_stale = |file| fs::read_to_string(file).is_ok_and(|text| text == STALE);
    if stale.iter().any(is_stale) {
        return Err(fault("what an earlier run had left as evidence stands there still".to_owned()));
    }
    if !control.wanted.fits(&outcome) {
        return Err(fault(said(&outcome)));
    }
    let draft = folder.join("draft.smt2");
    let searched = refute(&property, &control.harness, &solvers, &draft);
    let said = match (control.wanted, searched) {
        (Wanted::Refuted, Ok(Some((_, Origin::Model))))
        | (Wanted::Proved { .. }, Ok(None))
        | (Wanted::NotReplayed, Err(super::Stop::NotReplayed(_)))
        | (Wanted::OnlyNumbers, Err(super::Stop::OnlyNumbers))
        | (Wanted::Undecided, _) => return Ok(()),
        (_, Ok(Some((_, origin)))) => format!("refuted by {}", origin.as_str()),
        (_, Ok(None)) => "that a search finds no counterexample".to_owned(),
        (_, Err(why)) => why.to_string(),
    };
    Err(fault(said))
}

/// A file of evidence that says nothing of any control.
const STALE: &str = "(set-logic QF_BV)\n(push 1)\n(assert false)\n(check-sat)\n(pop 1)\n";
const NO_STEPS: Limits = Limits { proof: 0, search: 0, cross: 0 };

impl Control {
    const fn property(&self) -> Property {
        Property {
            id: self.id,
            family: Family::Number,
            rules: &[],
            sentence: self.claim,
            statement: self.claim,
            bounds: "",
            assumptions: &[],
        }
    }
}

impl Wanted {
    fn fits(self, outcome: &Outcome) -> bool {
        match self {
            Self::Proved { paths, obligations, without_arithmetic } => {
                outcome.verdict == Verdict::Proved
                    && outcome.paths == paths
                    && (outcome.obligations, outcome.without_arithmetic) == (obligations, without_arithmetic)
            }
            Self::OnlyNumbers => outcome.verdict == Verdict::Proved,
            Self::Refuted => outcome.verdict == Verdict::Refuted,
            Self::Undecided => outcome.detail == super::Stop::Unknown.to_string(),
            Self::NotReplayed => outcome.detail == super::Stop::NotReplayed("no x").to_string(),
        }
    }
}

impl std::fmt::Display for Wanted {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Proved { paths, obligations, without_arithmetic } => {
                write!(
                    f,
                    "proved ({paths} paths, {obligations} obligations, {without_arithmetic} of them without arithmetic)"
                )
            }
            Self::Refuted => f.write_str("refuted, by its own search"),
            Self::Undecided => write!(f, "{}", super::Stop::Unknown),
            Self::NotReplayed => write!(f, "{}", super::Stop::NotReplayed("no x")),
            Self::OnlyNumbers => write!(f, "{}", super::Stop::OnlyNumbers),
        }
    }
}

fn said(outcome: &Outcome) -> String {
    let Outcome { paths, obligations, without_arithmetic, detail, .. } = outcome;
    match outcome.verdict {
        Verdict::Proved => {
            Wanted::Proved { paths: *paths, obligations: *obligations, without_arithmetic: *without_arithmetic }
                .to_string()
        }
        Verdict::Failed => detail.clone(),
        verdict => verdict.as_str().to_owned(),
    }
}

/// A harness of this module, for terms and for doubles.
macro_rules! harness {
    ($symbolic:ident, $native:ident) => {
        Harness { symbolic: $symbolic::<Symbolic>, native: $native::<Native<Source>>, calls: Calls::of::<Production>() }
    };
    ($both:ident) => {
        harness!($both, $both)
    };
}

/// All controls, the simplest first.
fn all() -> Vec<Control> {
    let control = |id, claim, harness, wanted, shows| Control { id, claim, harness, wanted, shows };
    let proved = |paths, obligations, without_arithmetic| Wanted::Proved { paths, obligations, without_arithmetic };
    let asked = OPERATIONS as u64 * PAIRS.len() as u64;
    vec![
        control(
            "control/sum",
            "Some x has x ⊕ 0.1 = −123.456, and this says that none has.",
            harness!(sum),
            Wanted::Refuted,
            "its questions have no models, or it cannot read them",
        ),
        control(
            "control/two",
            "Two inputs need not be the same, and this says that they are.",
            harness!(two),
            Wanted::Refuted,
            "it has one unknown for two inputs",
        ),
        control(
            "control/constants",
            "What is computed of constants is what doubles give.",
            harness!(constants),
            proved(PAIRS.len() as u64, 0, 0),
            "it computes with constants otherwise than doubles do",
        ),
        control(
            "control/operations",
            "Each operation and each comparison gives what doubles give, on a list of pairs.",
            harness!(operations),
            Wanted::Proved { paths: PAIRS.len() as u64, obligations: asked, without_arithmetic: SAME },
            "the solver is asked of other operations than those that run",
        ),
        control(
            "control/ordered",
            "x ⊖ y ≤ 0 where x and y are finite and x ≤ y.",
            harness!(ordered),
            proved(1, 1, 0),
            "an assumption is lost, or a question is no question",
        ),
        control(
            "control/assumed",
            "Some positive x has x ⊕ 0.1 = 123.456, and this says that none has.",
            harness!(assumed),
            Wanted::Refuted,
            "its assumptions leave no inputs",
        ),
        control(
            "control/size",
            "0 ≤ x or 0 ≤ 0 ⊖ x, as x is not below 0 or is, unless it is no number.",
            harness!(size),
            proved(2, 2, 0),
            "the decisions of a path do not stand in its questions",
        ),
        control(
            "control/decided",
            "What a path has decided holds on it.",
            harness!(decided),
            proved(2, 2, 2),
            "the decisions of a path do not stand in its questions",
        ),
        control(
            "control/no-number",
            "Where a < b is not so, b ≤ a need not be: with a NaN. This says that it is.",
            harness!(no_number),
            Wanted::Refuted,
            "it forgets what is no number",
        ),
        control(
            "control/first-way",
            "The first way of three fails where x is below 0 and is −123.456 with 0.1 less.",
            harness!(first_way),
            Wanted::Refuted,
            "it leaves paths out",
        ),
        control(
            "control/last-way",
            "The last way of three fails where x is not below 0 and is 123.456 with 0.1 less.",
            harness!(last_way),
            Wanted::Refuted,
            "it leaves paths out",
        ),
        control(
            "control/first-check",
            "The first of three checks on a path fails.",
            harness!(first_check),
            Wanted::Refuted,
            "it leaves checks out",
        ),
        control(
            "control/last-check",
            "The last of three checks on a path fails.",
            harness!(last_check),
            Wanted::Refuted,
            "it leaves checks out",
        ),
        control(
            "control/seqs",
            "A seq may be below 0, and this says that none is.",
            harness!(seqs),
            Wanted::Refuted,
            "it compares seqs as what they are not",
        ),
        control(
            "control/undecided",
            "x ⊗ y is not 123.456, which cannot be decided in no steps.",
            harness!(undecided),
            Wanted::Undecided,
            "it takes what is unknown for an answer",
        ),
        control(
            "control/other-doubles",
            "On terms a check fails that does not on doubles.",
            harness!(sum, nothing),
            Wanted::NotReplayed,
            "it believes a model that was not replayed",
        ),
        control(
            "control/other-terms",
            "On doubles a check fails that does not on terms.",
            harness!(sure, unsure),
            Wanted::OnlyNumbers,
            "it refutes by samples what its own search does not refute",
        ),
    ]
}

/// x ⊕ 0.1 ≠ `sum`
fn never_gives<P: Prover>(p: &mut P, x: P::S, sum: f64) -> P::B {
    let (tenth, sum) = (p.number(0.1), p.number(sum));
    let same = p.same(x.add(tenth), sum);
    p.not(same)
}

fn sum<P: Prover>(p: &mut P) {
    let x = p.scalar("x");
    let says = never_gives(p, x, -123.456);
    p.check("no x", says);
}

fn nothing<P: Prover>(p: &mut P) {
    let x = p.scalar("x");
    let same = p.same(x, x);
    p.check("no x", same);
}

fn two<P: Prover>(p: &mut P) {
    let (x, y) = (p.scalar("x"), p.scalar("y"));
    let same = p.same(x, y);
    p.check("the same", same);
}

/// Both zeros, what rounds, the edges of the range, what is no number.
const PAIRS: [(f64, f64); 18] = [
    (0.0, -0.0),
    (-0.0, -0.0),
    (0.1, 0.2),
    (1.0, 3.0),
    (-1.0, 3.0),
    (2.0, -0.5),
    (-3.5, -3.5),
    (1e16, 1.0),
    (1e16, -1.5),
    (f64::MAX, f64::MAX),
    (f64::MAX, -f64::MAX),
    (5e-324, 0.5),
    (-5e-324, 5e-324),
    (1.0, 0.0),
    (f64::INFINITY, f64::NEG_INFINITY),
    (f64::NEG_INFINITY, 1.0),
    (f64::NAN, 1.0),
    (f64::NAN, f64::NAN),
];
/// The checks of [`compare`].
const OPERATIONS: usize = 14;
/// Those that hold of whatever is the same: "x is y" of each pair, and the choice between the four that are the same.
const SAME: u64 = PAIRS.len() as u64 + 4;

/// The operations of a prover on x and y, which are the doubles a and b.
fn compare<P: Prover>(p: &mut P, x: P::S, y: P::S, (a, b): (f64, f64)) {
    let (less, other) = (p.lt(x, y), p.lt(y, x));
    let least = p.select(less, x, y);
    for (name, is, says) in [
        ("x + y", x.add(y), a + b),
        ("x − y", x.sub(y), a - b),
        ("x · y", x.mul(y), a * b),
        ("x / y", x.div(y), a / b),
        ("√x", x.sqrt(), a.sqrt()),
        ("|x|", x.abs(), a.abs()),
        ("x if x < y, else y", least, if a < b { a } else { b }),
    ] {
        let says = p.number(says);
        let same = p.same(is, says);
        p.check(name, same);
    }
    let both_ways = p.and(less, other);
    let is_not = p.not(less);
    for (name, is, says) in [
        ("x < y", less, a < b),
        ("x ≤ y", p.le(x, y), a <= b),
        ("x is finite", p.finite(x), a.is_finite()),
        ("y is finite", p.finite(y), b.is_finite()),
        ("x is y", p.same(x, y), a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())),
        ("x < y and y < x", both_ways, false),
        ("not x < y", is_not, !matches!(a.partial_cmp(&b), Some(std::cmp::Ordering::Less))),
    ] {
        let says = p.truth(says);
        let same = p.iff(is, says);
        p.check(name, same);
    }
}

fn pair<P: Prover>(p: &mut P) -> (f64, f64) {
    let nth = p.choice("pair", PAIRS.len());
    PAIRS.get(nth).copied().unwrap_or_default()
}

fn operations<P: Prover>(p: &mut P) {
    let (a, b) = pair(p);
    let (x, y) = (p.scalar("x"), p.scalar("y"));
    for (input, value) in [(x, a), (y, b)] {
        let value = p.number(value);
        let is = p.same(input, value);
        p.assume(is);
    }
    compare(p, x, y, (a, b));
}

fn constants<P: Prover>(p: &mut P) {
    let (a, b) = pair(p);
    let (x, y) = (p.number(a), p.number(b));
    compare(p, x, y, (a, b));
}

fn ordered<P: Prover>(p: &mut P) {
    let (x, y, zero) = (p.scalar("x"), p.scalar("y"), p.number(0.0));
    let (x_finite, y_finite, in_order) = (p.finite(x), p.finite(y), p.le(x, y));
    for condition in [x_finite, y_finite, in_order] {
        p.assume(condition);
    }
    let below = p.le(x.sub(y), zero);
    p.check("the difference is not above 0", below);
}

fn assumed<P: Prover>(p: &mut P) {
    let (x, zero) = (p.scalar("x"), p.number(0.0));
    let (positive, finite) = (p.lt(zero, x), p.finite(x));
    p.assume(positive);
    p.assume(finite);
    let says = never_gives(p, x, 123.456);
    p.check("no x", says);
}

fn size<P: Prover>(p: &mut P) {
    let (x, zero) = (p.scalar("x"), p.number(0.0));
    let size = if x.lt(zero) { zero.sub(x) } else { x };
    let (good, number) = (p.le(zero, size), p.le(x, x));
    let says = p.implies(number, good);
    p.check("not below 0", says);
}

fn decided<P: Prover>(p: &mut P) {
    let (x, y) = (p.scalar("x"), p.scalar("y"));
    let answer = x.lt(y);
    let says = p.lt(x, y);
    p.exactly("as it was decided", answer, says);
}

fn no_number<P: Prover>(p: &mut P) {
    let (a, b) = (p.scalar("a"), p.scalar("b"));
    let right = a.lt(b) || b.le(a);
    let right = p.truth(right);
    p.check("one or the other", right);
}

/// Fails on one way of three, and on one side of 0.
fn ways<P: Prover>(p: &mut P, bad: usize, is_below: bool) {
    let way = p.choice("way", 3);
    let (x, zero) = (p.scalar("x"), p.number(0.0));
    let says = if x.lt(zero) == is_below && way == bad {
        never_gives(p, x, if is_below { -123.456 } else { 123.456 })
    } else {
        p.truth(true)
    };
    p.check("no x", says);
}

fn first_way<P: Prover>(p: &mut P) {
    ways(p, 0, true);
}

fn last_way<P: Prover>(p: &mut P) {
    ways(p, 2, false);
}

/// Fails in one of three checks.
fn checks<P: Prover>(p: &mut P, bad: &'static str) {
    let x = p.scalar("x");
    for name in ["first", "second", "last"] {
        let finite = p.finite(x);
        let says = if name == bad { never_gives(p, x, 123.456) } else { p.implies(finite, finite) };
        p.check(name, says);
    }
}

fn first_check<P: Prover>(p: &mut P) {
    checks(p, "first");
}

fn last_check<P: Prover>(p: &mut P) {
    checks(p, "last");
}

fn seqs<P: Prover>(p: &mut P) {
    let (seq, zero) = (p.seq("seq"), p.seq("zero"));
    let is_zero = p.seq_zero(zero);
    p.assume(is_zero);
    let below = p.seq_lt(seq, zero);
    let says = p.not(below);
    p.check("not below 0", says);
}

fn undecided<P: Prover>(p: &mut P) {
    let (x, y, product) = (p.scalar("x"), p.scalar("y"), p.number(123.456));
    let same = p.same(x.mul(y), product);
    let says = p.not(same);
    p.check("no x and y", says);
}

fn sure<P: Prover>(p: &mut P) {
    let x = p.scalar("x");
    let finite = p.finite(x);
    let says = p.or(finite, finite);
    let says = p.implies(finite, says);
    p.check("what is so", says);
}

fn unsure<P: Prover>(p: &mut P) {
    let x = p.scalar("x");
    let finite = p.finite(x);
    p.check("what is so", finite);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::provers::terms::{self, Guide};

    #[test]
    fn what_is_computed_of_constants_is_what_doubles_give() {
        for (nth, pair) in PAIRS.into_iter().enumerate() {
            let (path, broken) =
                terms::run_guided(6, constants::<Symbolic>, Guide { choices: vec![nth], ..Guide::default() });
            assert!(broken.is_empty() && path.checks.is_empty(), "{pair:?}: {broken:?}");
        }
    }

    #[test]
    fn every_true_control_holds_on_doubles_and_every_false_one_is_beyond_samples() {
        for control in all() {
            let outcome = crate::engines::standin::run(&control.harness, 20_000, 6);
            let fails = matches!(control.wanted, Wanted::OnlyNumbers)
                || ["control/two", "control/no-number", "control/seqs"].contains(&control.id);
            assert_eq!(outcome.verdict == Verdict::Refuted, fails, "{}", control.id);
        }
    }
}
