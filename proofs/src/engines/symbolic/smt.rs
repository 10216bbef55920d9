//! Obligations as SMT-LIB 2.

use std::collections::BTreeSet;
use std::fmt::Write;

use crate::provers::terms::{Guide, Node, node};

/// The variables of a script.
#[derive(Debug, Default)]
pub(super) struct Variables {
    pub(super) doubles: BTreeSet<u32>,
    pub(super) seqs: BTreeSet<u32>,
}

/// A question to a solver: that a check is false, where these decisions were taken.
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Question {
    pub(super) check: &'static str,
    pub(super) formula: u32,
    pub(super) literals: Vec<(u32, bool)>,
}

/// The atoms of a formula: what the kernel can have decided of it.
pub(super) fn atoms(formula: u32) -> BTreeSet<u32> {
    let (mut found, mut rest) = (BTreeSet::new(), vec![formula]);
    while let Some(formula) = rest.pop() {
        match node(formula) {
            Node::Not(a) => rest.push(a),
            Node::And(a, b) => rest.extend([a, b]),
            _ => {
                found.insert(formula);
            }
        }
    }
    found
}

/// How many terms a formula is made of.
pub(super) fn size(formula: u32) -> usize {
    let mut used = BTreeSet::new();
    reach(formula, &mut used);
    used.len()
}

/// A script with one `check-sat` a question, each to be answered with `unsat`. With `values`, the values
/// of all variables are asked for too; with `inputs`, the variables are these.
pub(super) fn script(
    title: &str,
    questions: &[&Question],
    values: bool,
    inputs: Option<&Guide>,
) -> (String, Variables) {
    let mut text = String::new();
    for line in title.lines() {
        let _ = writeln!(text, "; {line}");
    }
    text.push_str("(set-logic QF_BVFP)\n");
    let variables = write(&mut text, questions, Arithmetic::Doubles, inputs);
    let doubles = variables.doubles.iter().map(|nth| format!("x{nth}"));
    let seqs = variables.seqs.iter().map(|nth| format!("q{nth}"));
    let all: Vec<String> = doubles.chain(seqs).collect();
    let wanted = if values && !all.is_empty() { format!("(get-value ({}))\n", all.join(" ")) } else { String::new() };
    ask(&mut text, questions, Arithmetic::Doubles, &wanted);
    (text, variables)
}

/// The same of doubles of which nothing is known but which are the same: each operation and each comparison is an
/// unknown function. Whatever is `unsat` so is `unsat` of doubles.
pub(super) fn uninterpreted(questions: &[&Question]) -> String {
    let mut text = "(set-logic QF_UFBV)\n(define-sort D () (_ BitVec 64))\n".to_owned();
    for (name, inputs, output) in FUNCTIONS {
        let _ = writeln!(text, "(declare-fun {name} ({inputs}) {output})");
    }
    write(&mut text, questions, Arithmetic::Unknown, None);
    ask(&mut text, questions, Arithmetic::Unknown, "");
    text
}

/// The operations and comparisons of doubles, as functions of which nothing is known.
const FUNCTIONS: [(&str, &str, &str); 9] = [
    ("add", "D D", "D"),
    ("sub", "D D", "D"),
    ("mul", "D D", "D"),
    ("div", "D D", "D"),
    ("root", "D", "D"),
    ("size", "D", "D"),
    ("below", "D D", "Bool"),
    ("within", "D D", "Bool"),
    ("finite", "D", "Bool"),
];

/// What a script says of doubles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Arithmetic {
    /// What IEEE 754 does.
    Doubles,
    /// Nothing.
    Unknown,
}

/// Writes the terms of some questions.
fn write(text: &mut String, questions: &[&Question], arithmetic: Arithmetic, inputs: Option<&Guide>) -> Variables {
    let mut variables = Variables::default();
    let mut used = BTreeSet::new();
    for question in questions {
        reach(question.formula, &mut used);
        for (formula, _) in &question.literals {
            reach(*formula, &mut used);
        }
    }
    let sort = if arithmetic == Arithmetic::Doubles { "Float64" } else { "D" };
    // A node is made after the nodes that it is made of.
    for term in used {
        let what = node(term);
        let _ = match what {
            Node::Variable(nth) => {
                variables.doubles.insert(nth);
                match inputs.and_then(|inputs| inputs.scalars.get(nth as usize)) {
                    Some(value) => {
                        writeln!(text, "(define-fun x{nth} () {sort} {})", arithmetic.double(value.to_bits()))
                    }
                    None => writeln!(text, "(declare-const x{nth} {sort})"),
                }
            }
            Node::SeqVariable(nth) => {
                variables.seqs.insert(nth);
                match inputs.and_then(|inputs| inputs.seqs.get(nth as usize)) {
                    Some(value) => writeln!(text, "(define-fun q{nth} () (_ BitVec 64) #b{value:064b})"),
                    None => writeln!(text, "(declare-const q{nth} (_ BitVec 64))"),
                }
            }
            Node::Double(_) | Node::True | Node::Not(_) => Ok(()),
            _ => {
                let sort = if is_double(what) { sort } else { "Bool" };
                writeln!(text, "(define-fun t{term} () {sort} {})", arithmetic.body(what))
            }
        };
    }
    variables
}

/// Writes the questions, each with what is wanted beside the answer.
fn ask(text: &mut String, questions: &[&Question], arithmetic: Arithmetic, wanted: &str) {
    for question in questions {
        let _ = writeln!(text, "(push 1) ; {}", question.check);
        for (formula, answer) in &question.literals {
            let name = arithmetic.name(*formula);
            let _ = if *answer { write!(text, "(assert {name})") } else { write!(text, "(assert (not {name}))") };
        }
        let claim = arithmetic.name(question.formula);
        let _ = writeln!(text, "(assert (not {claim}))\n(check-sat)\n{wanted}(pop 1)");
    }
}

fn reach(term: u32, used: &mut BTreeSet<u32>) {
    if !used.insert(term) {
        return;
    }
    match node(term) {
        Node::Double(_) | Node::Variable(_) | Node::SeqVariable(_) | Node::True => {}
        Node::Sqrt(a) | Node::Abs(a) | Node::Finite(a) | Node::SeqZero(a) | Node::Not(a) => {
            reach(a, used);
        }
        Node::Add(a, b)
        | Node::Sub(a, b)
        | Node::Mul(a, b)
        | Node::Div(a, b)
        | Node::Lt(a, b)
        | Node::Le(a, b)
        | Node::Same(a, b)
        | Node::SeqLt(a, b)
        | Node::SeqSame(a, b)
        | Node::And(a, b) => {
            reach(a, used);
            reach(b, used);
        }
        Node::Select(c, a, b) => {
            reach(c, used);
            reach(a, used);
            reach(b, used);
        }
    }
}

fn is_double(what: Node) -> bool {
    matches!(
        what,
        Node::Add(..) | Node::Sub(..) | Node::Mul(..) | Node::Div(..) | Node::Sqrt(_) | Node::Abs(_) | Node::Select(..)
    )
}

impl Arithmetic {
    fn name(self, term: u32) -> String {
        match node(term) {
            Node::Variable(nth) => format!("x{nth}"),
            Node::SeqVariable(nth) => format!("q{nth}"),
            Node::Double(bits) => self.double(bits),
            Node::True => "true".to_owned(),
            Node::Not(a) => format!("(not {})", self.name(a)),
            _ => format!("t{term}"),
        }
    }

    fn body(self, what: Node) -> String {
        let two = |op: &str, a, b| format!("({op} {} {})", self.name(a), self.name(b));
        let one = |op: &str, a| format!("({op} {})", self.name(a));
        match (self, what) {
            (Self::Doubles, Node::Add(a, b)) => two("fp.add RNE", a, b),
            (Self::Doubles, Node::Sub(a, b)) => two("fp.sub RNE", a, b),
            (Self::Doubles, Node::Mul(a, b)) => two("fp.mul RNE", a, b),
            (Self::Doubles, Node::Div(a, b)) => two("fp.div RNE", a, b),
            (Self::Doubles, Node::Sqrt(a)) => one("fp.sqrt RNE", a),
            (Self::Doubles, Node::Abs(a)) => one("fp.abs", a),
            (Self::Doubles, Node::Lt(a, b)) => two("fp.lt", a, b),
            (Self::Doubles, Node::Le(a, b)) => two("fp.leq", a, b),
            (Self::Doubles, Node::Finite(a)) => {
                let a = self.name(a);
                format!("(not (or (fp.isNaN {a}) (fp.isInfinite {a})))")
            }
            (Self::Unknown, Node::Add(a, b)) => two("add", a, b),
            (Self::Unknown, Node::Sub(a, b)) => two("sub", a, b),
            (Self::Unknown, Node::Mul(a, b)) => two("mul", a, b),
            (Self::Unknown, Node::Div(a, b)) => two("div", a, b),
            (Self::Unknown, Node::Sqrt(a)) => one("root", a),
            (Self::Unknown, Node::Abs(a)) => one("size", a),
            (Self::Unknown, Node::Lt(a, b)) => two("below", a, b),
            (Self::Unknown, Node::Le(a, b)) => two("within", a, b),
            (Self::Unknown, Node::Finite(a)) => one("finite", a),
            (_, Node::Select(c, a, b)) => format!("(ite {} {} {})", self.name(c), self.name(a), self.name(b)),
            (_, Node::Same(a, b) | Node::SeqSame(a, b)) => two("=", a, b),
            (_, Node::SeqLt(a, b)) => two("bvslt", a, b),
            (_, Node::SeqZero(a)) => format!("(= {} (_ bv0 64))", self.name(a)),
            (_, Node::And(a, b)) => two("and", a, b),
            (_, Node::Not(a)) => one("not", a),
            (_, Node::Double(bits)) => self.double(bits),
            (_, Node::Variable(nth)) => format!("x{nth}"),
            (_, Node::SeqVariable(nth)) => format!("q{nth}"),
            (_, Node::True) => "true".to_owned(),
        }
    }

    fn double(self, bits: u64) -> String {
        match self {
            Self::Unknown => format!("#b{bits:064b}"),
            Self::Doubles if f64::from_bits(bits).is_nan() => "(_ NaN 11 53)".to_owned(),
            Self::Doubles => {
                format!("(fp #b{:01b} #b{:011b} #b{:052b})", bits >> 63, bits >> 52 & 0x7ff, bits & 0xf_ffff_ffff_ffff)
            }
        }
    }
}
