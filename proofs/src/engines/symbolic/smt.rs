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
    let mut variables = Variables::default();
    let mut used = BTreeSet::new();
    for question in questions {
        reach(question.formula, &mut used);
        for (formula, _) in &question.literals {
            reach(*formula, &mut used);
        }
    }
    for line in title.lines() {
        let _ = writeln!(text, "; {line}");
    }
    text.push_str("(set-logic QF_BVFP)\n");
    // A node is made after the nodes that it is made of.
    for term in used {
        let what = node(term);
        match what {
            Node::Variable(nth) => {
                variables.doubles.insert(nth);
                let _ = match inputs.and_then(|inputs| inputs.scalars.get(nth as usize)) {
                    Some(value) => {
                        let value = double(value.to_bits());
                        writeln!(text, "(define-fun x{nth} () Float64 {value})")
                    }
                    None => writeln!(text, "(declare-const x{nth} Float64)"),
                };
            }
            Node::SeqVariable(nth) => {
                variables.seqs.insert(nth);
                let _ = match inputs.and_then(|inputs| inputs.seqs.get(nth as usize)) {
                    Some(value) => {
                        writeln!(text, "(define-fun q{nth} () (_ BitVec 64) #b{value:064b})")
                    }
                    None => writeln!(text, "(declare-const q{nth} (_ BitVec 64))"),
                };
            }
            Node::Double(_) | Node::True | Node::Not(_) => {}
            _ => {
                let sort = if is_double(what) { "Float64" } else { "Bool" };
                let _ = writeln!(text, "(define-fun t{term} () {sort} {})", body(what));
            }
        }
    }
    for question in questions {
        let _ = writeln!(text, "(push 1) ; {}", question.check);
        for (formula, answer) in &question.literals {
            let name = name(*formula);
            let _ = if *answer { write!(text, "(assert {name})") } else { write!(text, "(assert (not {name}))") };
        }
        let _ = writeln!(text, "(assert (not {}))\n(check-sat)", name(question.formula));
        if values {
            let doubles = variables.doubles.iter().map(|nth| format!("x{nth}"));
            let seqs = variables.seqs.iter().map(|nth| format!("q{nth}"));
            let all: Vec<String> = doubles.chain(seqs).collect();
            if !all.is_empty() {
                let _ = writeln!(text, "(get-value ({}))", all.join(" "));
            }
        }
        text.push_str("(pop 1)\n");
    }
    (text, variables)
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

fn name(term: u32) -> String {
    match node(term) {
        Node::Variable(nth) => format!("x{nth}"),
        Node::SeqVariable(nth) => format!("q{nth}"),
        Node::Double(bits) => double(bits),
        Node::True => "true".to_owned(),
        Node::Not(a) => format!("(not {})", name(a)),
        _ => format!("t{term}"),
    }
}

fn body(what: Node) -> String {
    let two = |op: &str, a, b| format!("({op} {} {})", name(a), name(b));
    match what {
        Node::Add(a, b) => two("fp.add RNE", a, b),
        Node::Sub(a, b) => two("fp.sub RNE", a, b),
        Node::Mul(a, b) => two("fp.mul RNE", a, b),
        Node::Div(a, b) => two("fp.div RNE", a, b),
        Node::Sqrt(a) => format!("(fp.sqrt RNE {})", name(a)),
        Node::Abs(a) => format!("(fp.abs {})", name(a)),
        Node::Select(c, a, b) => format!("(ite {} {} {})", name(c), name(a), name(b)),
        Node::Lt(a, b) => two("fp.lt", a, b),
        Node::Le(a, b) => two("fp.leq", a, b),
        Node::Finite(a) => {
            let a = name(a);
            format!("(not (or (fp.isNaN {a}) (fp.isInfinite {a})))")
        }
        Node::Same(a, b) | Node::SeqSame(a, b) => two("=", a, b),
        Node::SeqLt(a, b) => two("bvslt", a, b),
        Node::SeqZero(a) => format!("(= {} (_ bv0 64))", name(a)),
        Node::And(a, b) => two("and", a, b),
        Node::Not(a) => format!("(not {})", name(a)),
        Node::Double(bits) => double(bits),
        Node::Variable(nth) => format!("x{nth}"),
        Node::SeqVariable(nth) => format!("q{nth}"),
        Node::True => "true".to_owned(),
    }
}

fn double(bits: u64) -> String {
    if f64::from_bits(bits).is_nan() {
        return "(_ NaN 11 53)".to_owned();
    }
    format!("(fp #b{:01b} #b{:011b} #b{:052b})", bits >> 63, bits >> 52 & 0x7ff, bits & 0xf_ffff_ffff_ffff)
}
