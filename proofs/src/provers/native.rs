//! The prover on doubles: for replays, for the stand-in of Kani's API, for enumeration, and for Kani itself.

use std::collections::BTreeMap;
use std::sync::mpsc::Sender;

use crate::counterexample::Drawn;
use crate::prover::Prover;

/// Where the inputs of a native run come from.
pub trait Draw {
    /// A double.
    fn scalar(&mut self) -> f64;
    /// A seq.
    fn seq(&mut self) -> i64;
    /// One of 0, 1, … `count` − 1.
    fn choice(&mut self, count: usize) -> usize;
    /// How long a sequence of at most `most` events is.
    fn length(&self, most: usize) -> usize {
        most
    }
    /// What Kani is told of an assumption.
    fn assume(&mut self, _condition: bool) {}
    /// What Kani is told of a check.
    fn check(&mut self, _name: &'static str, _condition: bool) {}
}

/// A run of a harness on doubles.
#[derive(Debug, Default)]
pub struct Native<D> {
    /// Where the inputs come from.
    pub draw: D,
    /// How often each check was reached.
    pub reached: BTreeMap<&'static str, u64>,
    /// The first check that failed.
    pub failed: Option<&'static str>,
    /// What the kernel answered there, and what the text says, where the check compares the two.
    pub compared: Option<String>,
    /// What was drawn, by name, in order.
    pub drawn: Vec<(String, Drawn)>,
    /// Whether `drawn` is kept.
    pub keep: bool,
    /// Who is told of each input at once.
    pub told: Option<Sender<(String, Drawn)>>,
    is_void: bool,
}

impl<D: Draw> Native<D> {
    /// A run on the inputs of `draw`.
    pub fn new(draw: D) -> Self {
        Self {
            draw,
            reached: BTreeMap::new(),
            failed: None,
            compared: None,
            drawn: Vec::new(),
            keep: false,
            told: None,
            is_void: false,
        }
    }

    /// Ready for the next run, which counts on.
    pub fn again(&mut self) {
        self.is_void = false;
        self.drawn.clear();
    }

    fn note(&mut self, name: &str, drawn: Drawn) {
        if self.keep {
            self.drawn.push((name.to_owned(), drawn));
        }
        if let Some(told) = &self.told {
            told.send((name.to_owned(), drawn)).ok();
        }
    }
}

impl<D: Draw> Prover for Native<D> {
    type S = f64;
    type Q = i64;
    type B = bool;

    fn scalar(&mut self, name: &str) -> f64 {
        let value = self.draw.scalar();
        self.note(name, Drawn::Scalar(value));
        value
    }
    fn seq(&mut self, name: &str) -> i64 {
        let value = self.draw.seq();
        self.note(name, Drawn::Seq(value));
        value
    }
    fn choice(&mut self, name: &str, count: usize) -> usize {
        let value = self.draw.choice(count);
        self.note(name, Drawn::Choice(value));
        value
    }
    fn length(&self, most: usize) -> usize {
        self.draw.length(most)
    }
    fn assume(&mut self, condition: bool) {
        self.draw.assume(condition);
        self.is_void |= !condition;
    }
    fn check(&mut self, name: &'static str, condition: bool) {
        if self.is_void {
            return;
        }
        self.draw.check(name, condition);
        *self.reached.entry(name).or_default() += 1;
        if self.failed.is_some() && self.compared.is_none() {
            // The check that failed was not explained, and this is another one.
            self.compared = Some(String::new());
        }
        if !condition && self.failed.is_none() {
            self.failed = Some(name);
        }
    }
    fn never(&mut self, name: &'static str) {
        self.check(name, false);
        self.reached.remove(name);
    }
    fn exactly(&mut self, name: &'static str, answer: bool, says: bool) {
        self.check(name, answer == says);
        let word = |is| if is { "yes" } else { "no" };
        let (answer, says) = (word(answer), word(says));
        self.explain(&|| format!("the text says {says}, the kernel {answer}"));
    }
    fn explain(&mut self, what: &dyn Fn() -> String) {
        if self.failed.is_some() && self.compared.is_none() {
            self.compared = Some(what());
        }
    }
    fn truth(&mut self, value: bool) -> bool {
        value
    }
    fn not(&mut self, a: bool) -> bool {
        !a
    }
    fn and(&mut self, a: bool, b: bool) -> bool {
        a && b
    }
    fn lt(&mut self, a: f64, b: f64) -> bool {
        a < b
    }
    fn le(&mut self, a: f64, b: f64) -> bool {
        a <= b
    }
    fn finite(&mut self, a: f64) -> bool {
        a.is_finite()
    }
    fn same(&mut self, a: f64, b: f64) -> bool {
        a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
    }
    fn seq_lt(&mut self, a: i64, b: i64) -> bool {
        a < b
    }
    fn seq_same(&mut self, a: i64, b: i64) -> bool {
        a == b
    }
    fn seq_zero(&mut self, a: i64) -> bool {
        a == 0
    }
    fn select(&mut self, condition: bool, a: f64, b: f64) -> f64 {
        if condition { a } else { b }
    }
}

/// Draws given values, in order; zeros when there are no more.
#[derive(Debug, Clone, Default)]
pub struct Replay {
    /// The doubles.
    pub scalars: std::collections::VecDeque<f64>,
    /// The seqs.
    pub seqs: std::collections::VecDeque<i64>,
    /// The choices.
    pub choices: std::collections::VecDeque<usize>,
    /// How long sequences are.
    pub length: usize,
}

impl Draw for Replay {
    fn scalar(&mut self) -> f64 {
        self.scalars.pop_front().unwrap_or(0.0)
    }
    fn seq(&mut self) -> i64 {
        self.seqs.pop_front().unwrap_or(0)
    }
    fn choice(&mut self, _count: usize) -> usize {
        self.choices.pop_front().unwrap_or(0)
    }
    fn length(&self, most: usize) -> usize {
        most.min(self.length)
    }
}

/// Draws edges and random values, the same ones in every run of the program.
#[derive(Debug, Clone)]
pub struct Sample {
    state: u64,
    length: usize,
    /// The double before, whose relatives show what a comparison does at its edge.
    last: f64,
    /// Whether all doubles are small and round: of many that have to fit together, hardly any do otherwise.
    is_tame: bool,
}

const EDGES: [f64; 26] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    2.0,
    3.0,
    5.0,
    100.0,
    250.0,
    500.0,
    1000.0,
    59_999.999,
    60_000.0,
    60_000.001,
    1e9,
    -1e9,
    f64::MAX,
    f64::MIN,
    f64::MIN_POSITIVE,
    5e-324,
    1e-160,
    1e160,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
];
const SEQS: [i64; 8] = [0, 1, 2, -1, 7, i64::MAX, i64::MIN, i64::MAX - 1];

impl Sample {
    /// A source of values from a seed, and of sequences of at most this length.
    #[must_use]
    pub const fn new(seed: u64, length: usize) -> Self {
        Self { state: seed, length, last: 1.0, is_tame: seed % 2 == 1 }
    }

    /// SplitMix64.
    fn next(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    #[expect(clippy::cast_possible_truncation)]
    fn below(&mut self, count: usize) -> usize {
        (self.next() % count.max(1) as u64) as usize
    }

    /// A number from 0 to 1.
    #[expect(clippy::cast_precision_loss)]
    fn fraction(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A place or speed of a few units, or a time of a few seconds.
    #[expect(clippy::cast_precision_loss)]
    fn tame(&mut self) -> f64 {
        let small = self.below(9) as f64 - 4.0;
        match self.below(4) {
            0 => small.abs() * 250.0,
            1 => small / 4.0,
            _ => small,
        }
    }

    /// A number that has to do with the one before.
    fn relative(&mut self) -> f64 {
        let last = self.last;
        match self.below(7) {
            0 => last,
            1 => -last,
            2 => last.next_up(),
            3 => last.next_down(),
            4 => last * 2.0,
            5 => last / 1000.0,
            _ => last * 1000.0,
        }
    }
}

impl Draw for Sample {
    #[expect(clippy::cast_precision_loss)]
    fn scalar(&mut self) -> f64 {
        if self.is_tame {
            return self.tame();
        }
        self.last = match self.below(12) {
            0..4 => {
                let nth = self.below(EDGES.len());
                EDGES.get(nth).copied().unwrap_or_default()
            }
            4 => f64::from_bits(self.next()),
            5 => self.below(5) as f64,
            // Times that meet: quarters of a second, and as many milliseconds.
            6 => self.below(5) as f64 / 4.0,
            7 => self.below(5) as f64 * 250.0,
            8 => self.relative(),
            // Whose squares are about to overflow, or to vanish.
            9 if self.below(4) == 0 => self.fraction() * 2e-154,
            9 => self.fraction() * 1.5e154,
            _ => self.fraction() * 8.0 - 2.0,
        };
        self.last
    }
    fn seq(&mut self) -> i64 {
        match self.below(3) {
            0 => {
                let nth = self.below(SEQS.len());
                SEQS.get(nth).copied().unwrap_or_default()
            }
            1 => i64::try_from(self.below(4)).unwrap_or_default(),
            _ => self.next().cast_signed(),
        }
    }
    fn choice(&mut self, count: usize) -> usize {
        if self.is_tame && count == 2 {
            // Where all is well, what may be there mostly is.
            return usize::from(self.below(8) > 0);
        }
        self.below(count)
    }
    fn length(&self, most: usize) -> usize {
        most.min(self.length)
    }
}

/// Draws every combination of a finite set of values, one after the other.
#[derive(Debug, Clone)]
pub struct Enumerate {
    scalars: &'static [f64],
    seqs: &'static [i64],
    length: usize,
    digits: Vec<(usize, usize)>,
    at: usize,
}

impl Enumerate {
    /// All combinations of these values, in sequences of at most this length.
    #[must_use]
    pub const fn new(scalars: &'static [f64], seqs: &'static [i64], length: usize) -> Self {
        Self { scalars, seqs, length, digits: Vec::new(), at: 0 }
    }

    /// Begins the combination at hand anew.
    pub fn restart(&mut self) {
        self.at = 0;
    }

    /// Goes on to the next combination; false after the last.
    pub fn advance(&mut self) -> bool {
        self.digits.truncate(self.at);
        self.at = 0;
        while let Some((digit, count)) = self.digits.pop() {
            if digit + 1 < count {
                self.digits.push((digit + 1, count));
                return true;
            }
        }
        false
    }

    fn digit(&mut self, count: usize) -> usize {
        let at = self.at;
        self.at += 1;
        if let Some((digit, _)) = self.digits.get(at) {
            return *digit;
        }
        self.digits.push((0, count));
        0
    }
}

impl Draw for Enumerate {
    fn scalar(&mut self) -> f64 {
        let nth = self.digit(self.scalars.len());
        self.scalars.get(nth).copied().unwrap_or_default()
    }
    fn seq(&mut self) -> i64 {
        let nth = self.digit(self.seqs.len());
        self.seqs.get(nth).copied().unwrap_or_default()
    }
    fn choice(&mut self, count: usize) -> usize {
        self.digit(count)
    }
    fn length(&self, most: usize) -> usize {
        most.min(self.length)
    }
}

/// Any of the sources of inputs, so that a harness is compiled once for all of them.
#[derive(Debug, Clone)]
pub enum Source {
    /// Edges and random values.
    Sample(Sample),
    /// Every combination of some values.
    Enumerate(Enumerate),
    /// Given values.
    Replay(Replay),
}

impl Draw for Source {
    fn scalar(&mut self) -> f64 {
        match self {
            Self::Sample(draw) => draw.scalar(),
            Self::Enumerate(draw) => draw.scalar(),
            Self::Replay(draw) => draw.scalar(),
        }
    }
    fn seq(&mut self) -> i64 {
        match self {
            Self::Sample(draw) => draw.seq(),
            Self::Enumerate(draw) => draw.seq(),
            Self::Replay(draw) => draw.seq(),
        }
    }
    fn choice(&mut self, count: usize) -> usize {
        match self {
            Self::Sample(draw) => draw.choice(count),
            Self::Enumerate(draw) => draw.choice(count),
            Self::Replay(draw) => draw.choice(count),
        }
    }
    fn length(&self, most: usize) -> usize {
        match self {
            Self::Sample(draw) => draw.length(most),
            Self::Enumerate(draw) => draw.length(most),
            Self::Replay(draw) => draw.length(most),
        }
    }
}

impl Source {
    /// Begins the combination at hand anew.
    pub fn restart(&mut self) {
        if let Self::Enumerate(draw) = self {
            draw.restart();
        }
    }

    /// Goes on to the next combination; false after the last.
    pub fn advance(&mut self) -> bool {
        match self {
            Self::Enumerate(draw) => draw.advance(),
            Self::Sample(_) | Self::Replay(_) => false,
        }
    }
}
