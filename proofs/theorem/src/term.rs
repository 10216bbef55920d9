//! Numbers that record what the kernel does with them, and the exploration of each path through it.
//!
//! A comparison has no answer of its own: an oracle gives it one, and the run is repeated until each comparison has
//! been answered both ways. The same comparison has the same answer within a run. What comes of it is a tree: the
//! kernel's conditions in its nodes, what it answers in its leaves.

use std::cell::RefCell;
use std::collections::HashMap;
use std::fmt;

use ncp_kernel::{Scalar, Seq};

/// A number, by the operations that lead to it.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Term(usize);

/// A seq: one of the names that a run gives.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Name(Term);

/// What a function does: its conditions, and on each path its answer, both as Coq.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Tree {
    /// An answer.
    Leaf(String),
    /// A condition, what follows where it holds, and what where it fails.
    Node(String, Box<Self>, Box<Self>),
}

impl Tree {
    /// How many paths it has.
    #[must_use]
    pub fn paths(&self) -> usize {
        match self {
            Self::Leaf(_) => 1,
            Self::Node(_, yes, no) => yes.paths() + no.paths(),
        }
    }
}

impl fmt::Display for Tree {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Leaf(answer) => write!(f, "{answer}"),
            Self::Node(condition, yes, no) => write!(f, "if {condition} then {yes}\nelse {no}"),
        }
    }
}

/// All paths of a run from the first condition on.
pub fn explore(run: &dyn Fn() -> String) -> Tree {
    grow(run, &mut Vec::new())
}

/// All paths of a run after its first `skip` conditions, which hold.
pub fn explore_after(skip: usize, run: &dyn Fn() -> String) -> Tree {
    grow(run, &mut vec![true; skip])
}

/// How many conditions the path has on which all of them hold, before `condition` is asked.
pub fn asked_before(condition: &str, run: &dyn Fn() -> String) -> usize {
    record(&[], run);
    let is_it = |asked: &Question| asked.terms.is_empty() && asked.operation == condition;
    RUN.with_borrow(|all| all.asked.iter().position(is_it).unwrap_or(all.asked.len()))
}

/// A number or a seq that is not known.
pub fn variable(name: &str) -> Term {
    intern(Node::Leaf(name.to_owned()))
}

impl Name {
    /// A seq that is not known.
    pub fn new(name: &str) -> Self {
        Self(variable(name))
    }
}

/// A condition that is not known.
pub fn unknown(name: &str) -> bool {
    ask(name.to_owned(), Vec::new())
}

/// Lets the kernel come into a state: `answer` answers a comparison of these numbers, which belongs to no path.
pub fn quietly<T>(answer: fn(&str, &[String]) -> bool, setup: impl FnOnce() -> T) -> T {
    RUN.with_borrow_mut(|run| run.quiet = Some(answer));
    let made = setup();
    RUN.with_borrow_mut(|run| run.quiet = None);
    made
}

/// From here on, each operation is shown, and no word that the model has for several.
pub fn in_full() {
    RUN.with_borrow_mut(|run| run.in_full = true);
}

/// From here on, these conditions hold, and belong to no path.
pub fn presume(conditions: &[&str]) {
    RUN.with_borrow_mut(|run| run.presumed = conditions.iter().map(|&condition| condition.to_owned()).collect());
}

/// From here on, the last three computed numbers that were tested for being finite are shown by these names.
pub fn name_last_tested(names: [&str; 3]) {
    let Some(tested) = last_tested() else { return };
    RUN.with_borrow_mut(|run| run.named = tested.into_iter().zip(names.map(str::to_owned)).collect());
}

/// The three computed numbers of which it was asked last whether they are finite, if there are three.
pub fn last_tested() -> Option<[Term; 3]> {
    RUN.with_borrow(|run| run.tested.last_chunk().copied())
}

/// One run of the kernel.
#[derive(Default)]
struct Run {
    nodes: Vec<Node>,
    known: HashMap<Node, Term>,
    script: Vec<bool>,
    asked: Vec<Question>,
    answers: HashMap<Question, bool>,
    tested: Vec<Term>,
    named: HashMap<Term, String>,
    presumed: Vec<String>,
    quiet: Option<fn(&str, &[String]) -> bool>,
    in_full: bool,
}

#[derive(Clone, PartialEq, Eq, Hash)]
enum Node {
    Leaf(String),
    Operation(&'static str, Vec<Term>),
}

#[derive(Clone, PartialEq, Eq, Hash)]
struct Question {
    operation: String,
    terms: Vec<Term>,
}

thread_local! {
    static RUN: RefCell<Run> = RefCell::default();
}

fn grow(run: &dyn Fn() -> String, path: &mut Vec<bool>) -> Tree {
    let answer = record(path, run);
    let question = RUN.with_borrow(|run| run.asked.get(path.len()).map(|question| run.show_question(question)));
    let Some(question) = question else { return Tree::Leaf(answer) };
    let mut branch = |holds| {
        path.push(holds);
        let tree = grow(run, path);
        path.pop();
        Box::new(tree)
    };
    let (yes, no) = (branch(true), branch(false));
    Tree::Node(question, yes, no)
}

/// Runs the kernel along a path, on which all later conditions hold.
fn record(script: &[bool], run: &dyn Fn() -> String) -> String {
    RUN.with_borrow_mut(|all| *all = Run { script: script.to_vec(), ..Run::default() });
    run()
}

fn intern(node: Node) -> Term {
    RUN.with_borrow_mut(|run| {
        if let Some(term) = run.known.get(&node) {
            return *term;
        }
        let term = Term(run.nodes.len());
        run.nodes.push(node.clone());
        run.known.insert(node, term);
        term
    })
}

fn ask(operation: String, terms: Vec<Term>) -> bool {
    RUN.with_borrow_mut(|run| {
        if let Some(answer) = run.quiet {
            let shown: Vec<String> = terms.iter().map(|term| run.show(*term)).collect();
            return answer(&operation, &shown);
        }
        let question = Question { operation, terms };
        if !run.presumed.is_empty() && run.presumed.contains(&run.show_question(&question)) {
            return true;
        }
        if let Some(answer) = run.answers.get(&question) {
            return *answer;
        }
        let answer = run.script.get(run.asked.len()).copied().unwrap_or(true);
        run.asked.push(question.clone());
        run.answers.insert(question, answer);
        answer
    })
}

impl Run {
    fn show(&self, term: Term) -> String {
        if let Some(name) = self.named.get(&term) {
            return name.clone();
        }
        if !self.in_full
            && let Some((word, [x, y, z])) = self.word(term)
        {
            return format!("({word} ({}, {}, {}))", self.show(x), self.show(y), self.show(z));
        }
        match self.nodes.get(term.0) {
            Some(Node::Leaf(name)) => name.clone(),
            Some(Node::Operation(name, terms)) => format!("({name}{})", self.show_all(terms)),
            None => "lost".to_owned(), // A term of another run: no Coq of that name.
        }
    }

    /// A sum of three squares and the scale of a norm by the model's words for them, so that what is shown of a norm in
    /// a norm stays short. The export of the norm itself shows them in full: there Coq sees what the words stand for.
    fn word(&self, term: Term) -> Option<(&'static str, [Term; 3])> {
        let operands = |term: Term, operation: &str| match self.nodes.get(term.0) {
            Some(Node::Operation(name, terms)) if *name == operation => Some(terms.as_slice()),
            _ => None,
        };
        let is =
            |term: Term, value: f64| matches!(self.nodes.get(term.0), Some(Node::Leaf(name)) if *name == dyadic(value));
        let sum = |term| match operands(term, "add") {
            Some([a, b]) => Some((*a, *b)),
            _ => None,
        };
        let squared = |term| match operands(term, "mul") {
            Some([a, b]) if a == b => Some(*a),
            _ => None,
        };
        let squares = |term| {
            let (rest, z) = sum(term)?;
            let (rest, y) = sum(rest)?;
            let (zero, x) = sum(rest)?;
            Some([squared(x)?, squared(y)?, squared(z)?]).filter(|_| is(zero, 0.0))
        };
        if let Some(of) = squares(term) {
            return Some(("squares", of));
        }
        let [of, small, up, rest] = operands(term, "select_lt")? else { return None };
        let [again, large, one, down] = operands(*rest, "select_lt")? else { return None };
        let power = |exponent| 2.0_f64.powi(exponent);
        let bounds = is(*small, power(-900)) && is(*large, power(1000)) && of == again;
        let scales = is(*up, power(600)) && is(*one, 1.0) && is(*down, power(-600));
        Some(("scale", squares(*of)?)).filter(|_| bounds && scales)
    }

    fn show_all(&self, terms: &[Term]) -> String {
        terms.iter().map(|term| format!(" {}", self.show(*term))).collect()
    }

    fn show_question(&self, question: &Question) -> String {
        format!("{}{}", question.operation, self.show_all(&question.terms))
    }
}

impl fmt::Display for Term {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&RUN.with_borrow(|run| run.show(*self)))
    }
}

impl fmt::Debug for Term {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl fmt::Debug for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// A double as m · 2^e: a whole number as it is, and any other with an odd m.
fn dyadic(value: f64) -> String {
    if value.is_nan() {
        return "not_a_number".to_owned();
    }
    if !value.is_finite() || (value == 0.0 && value.is_sign_negative()) {
        return "no_such_constant".to_owned();
    }
    if value.fract() == 0.0 && value.abs() < 2.0_f64.powi(53) {
        return format!("(dyadic ({value:.0}) (0))");
    }
    let (bits, sign) = (value.to_bits(), if value < 0.0 { "-" } else { "" });
    let (biased, fraction) = ((bits >> 52) & 0x7FF, bits & ((1 << 52) - 1));
    let (mantissa, exponent) =
        if biased == 0 { (fraction, -1074) } else { (fraction | (1 << 52), biased.cast_signed() - 1075) };
    let twos = mantissa.trailing_zeros();
    format!("(dyadic ({sign}{}) ({}))", mantissa >> twos, exponent + i64::from(twos))
}

fn operation(name: &'static str, terms: &[Term]) -> Term {
    intern(Node::Operation(name, terms.to_vec()))
}

impl Scalar for Term {
    fn constant(value: f64) -> Self {
        variable(&dyadic(value))
    }
    fn add(self, other: Self) -> Self {
        operation("add", &[self, other])
    }
    fn sub(self, other: Self) -> Self {
        operation("sub", &[self, other])
    }
    fn mul(self, other: Self) -> Self {
        operation("mul", &[self, other])
    }
    fn div(self, other: Self) -> Self {
        operation("div", &[self, other])
    }
    fn sqrt(self) -> Self {
        operation("root", &[self])
    }
    fn abs(self) -> Self {
        operation("abs", &[self])
    }
    fn select_lt(self, other: Self, then: Self, otherwise: Self) -> Self {
        operation("select_lt", &[self, other, then, otherwise])
    }
    fn lt(self, other: Self) -> bool {
        ask("lt".to_owned(), vec![self, other])
    }
    fn le(self, other: Self) -> bool {
        ask("le".to_owned(), vec![self, other])
    }
    fn is_finite(self) -> bool {
        RUN.with_borrow_mut(|run| {
            if let Some(Node::Operation(..)) = run.nodes.get(self.0) {
                run.tested.push(self);
            }
        });
        ask("finite".to_owned(), vec![self])
    }
    fn floor_index(self, most: usize) -> usize {
        (0..most).find(|index| ask(format!("index_is {index} {most}"), vec![self])).unwrap_or(most)
    }
}

impl Seq for Name {
    fn is_zero(self) -> bool {
        ask("seq_zero".to_owned(), vec![self.0])
    }
    fn lt(self, other: Self) -> bool {
        ask("seq_lt".to_owned(), vec![self.0, other.0])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_constant_is_written_exactly() {
        assert_eq!(dyadic(0.0), "(dyadic (0) (0))");
        assert_eq!(dyadic(1000.0), "(dyadic (1000) (0))");
        assert_eq!(dyadic(-3.0), "(dyadic (-3) (0))");
        assert_eq!(dyadic(4096.0), "(dyadic (4096) (0))");
        assert_eq!(dyadic(0.75), "(dyadic (3) (-2))");
        assert_eq!(dyadic(1.0 - 11.0 * f64::EPSILON / 2.0), "(dyadic (9007199254740981) (-53))");
        assert_eq!(dyadic(f64::NAN), "not_a_number");
        assert_eq!(dyadic(-0.0), "no_such_constant");
        assert_eq!(dyadic(f64::INFINITY), "no_such_constant");
    }

    #[test]
    fn a_comparison_is_answered_both_ways_and_the_same_one_the_same_way() {
        let run = || {
            let (a, b) = (variable("a"), variable("b"));
            format!("{} {} {}", Scalar::lt(a, b), Scalar::lt(a, b), Scalar::lt(b, a))
        };
        let tree = explore(&run);
        assert_eq!(tree.paths(), 4);
        let leaf = |text: &str| Box::new(Tree::Leaf(text.to_owned()));
        let branch = |yes, no| Box::new(Tree::Node("lt b a".to_owned(), leaf(yes), leaf(no)));
        let (yes, no) = (branch("true true true", "true true false"), branch("false false true", "false false false"));
        assert_eq!(tree, Tree::Node("lt a b".to_owned(), yes, no));
    }

    #[test]
    fn a_norm_is_shown_by_the_words_of_the_model() {
        let norm = || ncp_kernel::norm(&["x", "y", "z"].map(variable));
        let shown = explore(&|| format!("{} {}", norm().length, norm().scale)).to_string();
        let scaled = ["x", "y", "z"].map(|x| format!("(mul {x} (scale (x, y, z)))")).join(", ");
        assert_eq!(shown, format!("(root (squares ({scaled}))) (scale (x, y, z))"));
        let other = || variable("x").mul(variable("x")).add(variable("y").mul(variable("z")));
        assert_eq!(explore(&|| other().to_string()).to_string(), "(add (mul x x) (mul y z))");
        let full = explore(&|| {
            in_full();
            norm().scale.to_string()
        });
        assert!(full.to_string().starts_with("(select_lt (add (add (add (dyadic (0) (0)) (mul x x)) (mul y y))"));
    }

    #[test]
    fn an_index_is_each_that_is_possible() {
        let tree = explore(&|| variable("a").floor_index(2).to_string());
        assert_eq!(tree.to_string(), "if index_is 0 2 a then 0\nelse if index_is 1 2 a then 1\nelse 2");
    }
}
