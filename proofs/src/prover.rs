//! What a harness asks of an engine: inputs, assumptions, checks, and the logic in which they are said.

use ncp_kernel::{Scalar, Seq};

/// Small indices, those at which a narrower integer would turn, and the last of the longest horizon.
pub const INDICES: [usize; 16] = [0, 1, 2, 3, 7, 8, 9, 15, 16, 64, 255, 256, 257, 1_000, 4_095, 4_096];

/// An engine as a harness sees it.
///
/// A harness draws its inputs from the engine, calls the kernel with them, and says by
/// [`check`](Self::check) what has to hold of the answers. Conditions of checks are formulas of type
/// [`B`](Self::B) and not `bool`, so that a symbolic engine can hand them to a solver as they are.
pub trait Prover {
    /// A number of the kernel.
    type S: Scalar;
    /// A seq of the kernel.
    type Q: Seq;
    /// A formula.
    type B: Copy;

    /// Any double at all: NaN, infinities, subnormals and both zeros included.
    fn scalar(&mut self, name: &str) -> Self::S;
    /// Any seq of 64 bits.
    fn seq(&mut self, name: &str) -> Self::Q;
    /// One of 0, 1, … `count` − 1.
    fn choice(&mut self, name: &str, count: usize) -> usize;
    /// Any index of a tick. An engine on terms takes every double for the number that the kernel makes of it; the
    /// others take some of [`INDICES`]. A harness asks for it after all numbers.
    fn index(&mut self, name: &str) -> usize {
        let nth = self.choice(name, INDICES.len());
        INDICES.get(nth).copied().unwrap_or_default()
    }
    /// How long a sequence of at most `most` events this engine explores.
    fn length(&self, most: usize) -> usize;

    /// Leaves all cases aside in which the condition does not hold.
    fn assume(&mut self, condition: Self::B);
    /// Says what has to hold, under a name.
    fn check(&mut self, name: &'static str, condition: Self::B);

    /// Says that the kernel never comes here; the one check that need not be reached.
    fn never(&mut self, name: &'static str) {
        let no = self.truth(false);
        self.check(name, no);
    }

    /// What is to be said of the check before, should it have failed.
    fn explain(&mut self, _what: &dyn Fn() -> String) {}

    /// A formula that is true or false.
    fn truth(&mut self, value: bool) -> Self::B;
    /// ¬a
    fn not(&mut self, a: Self::B) -> Self::B;
    /// a ∧ b
    fn and(&mut self, a: Self::B, b: Self::B) -> Self::B;
    /// a < b; false with a NaN.
    fn lt(&mut self, a: Self::S, b: Self::S) -> Self::B;
    /// a ≤ b; false with a NaN.
    fn le(&mut self, a: Self::S, b: Self::S) -> Self::B;
    /// Neither infinite nor NaN.
    fn finite(&mut self, a: Self::S) -> Self::B;
    /// The same double: one NaN, and two zeros.
    fn same(&mut self, a: Self::S, b: Self::S) -> Self::B;
    /// a < b
    fn seq_lt(&mut self, a: Self::Q, b: Self::Q) -> Self::B;
    /// a = b
    fn seq_same(&mut self, a: Self::Q, b: Self::Q) -> Self::B;
    /// a = 0
    fn seq_zero(&mut self, a: Self::Q) -> Self::B;
    /// a if the condition holds, else b.
    fn select(&mut self, condition: Self::B, a: Self::S, b: Self::S) -> Self::S;

    /// Yes or no.
    fn boolean(&mut self, name: &str) -> bool {
        self.choice(name, 2) == 1
    }
    /// A double that is there or not.
    fn optional(&mut self, name: &str) -> Option<Self::S> {
        self.boolean(name).then(|| self.scalar(name))
    }
    /// Three doubles.
    fn vector(&mut self, name: &str) -> [Self::S; 3] {
        [0, 1, 2].map(|axis| self.scalar(&format!("{name}_{axis}")))
    }
    /// The number itself.
    fn number(&mut self, value: f64) -> Self::S {
        Self::S::constant(value)
    }
    /// a ∨ b
    fn or(&mut self, a: Self::B, b: Self::B) -> Self::B {
        let (a, b) = (self.not(a), self.not(b));
        let neither = self.and(a, b);
        self.not(neither)
    }
    /// a → b
    fn implies(&mut self, a: Self::B, b: Self::B) -> Self::B {
        let not_a = self.not(a);
        self.or(not_a, b)
    }
    /// a ↔ b
    fn iff(&mut self, a: Self::B, b: Self::B) -> Self::B {
        let there = self.implies(a, b);
        let back = self.implies(b, a);
        self.and(there, back)
    }
    /// What the kernel answered ↔ what the text says.
    fn exactly(&mut self, name: &'static str, answer: bool, says: Self::B) {
        let answer = self.truth(answer);
        let same = self.iff(answer, says);
        self.check(name, same);
    }
    /// All of them.
    fn all(&mut self, parts: &[Self::B]) -> Self::B {
        let mut whole = self.truth(true);
        for part in parts {
            whole = self.and(whole, *part);
        }
        whole
    }
}
