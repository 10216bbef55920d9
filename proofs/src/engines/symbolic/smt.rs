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

/// What the variables of a script may be.
#[derive(Debug, Clone, Copy)]
pub(super) enum Inputs<'g> {
    /// Whatever there is.
    Any,
    /// Doubles with few digits: a search among them comes to an end soon. `unsat` says nothing of others.
    Round,
    /// These.
    Given(&'g Guide),
}

impl<'g> Inputs<'g> {
    const fn given(self) -> Option<&'g Guide> {
        match self {
            Self::Given(guide) => Some(guide),
            Self::Any | Self::Round => None,
        }
    }
}

/// A script with one `check-sat` a question, each to be answered with `unsat`. With `values`, the values
/// of all variables are asked for too.
pub(super) fn script(title: &str, questions: &[&Question], values: bool, inputs: Inputs<'_>) -> (String, Variables) {
    let mut text = String::new();
    for line in title.lines() {
        let _ = writeln!(text, "; {line}");
    }
    text.push_str("(set-logic QF_BVFP)\n");
    let variables = write(&mut text, questions, Arithmetic::Doubles, inputs.given());
    if matches!(inputs, Inputs::Round) {
        for nth in &variables.doubles {
            let _ = writeln!(
                text,
                "(declare-const s{nth} (_ BitVec 1))(declare-const e{nth} (_ BitVec 11))(declare-const f{nth} (_ \
                 BitVec {ROUND}))\n(assert (= x{nth} (fp s{nth} e{nth} (concat f{nth} (_ bv0 {})))))",
                52 - ROUND
            );
        }
    }
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

/// The digits behind the first of a double with few of them, in bits.
const ROUND: usize = 6;

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

#[cfg(test)]
mod tests {
    use ncp_kernel::{Scalar, Seq};

    use super::*;
    use crate::prover::Prover;
    use crate::provers::terms::{self, Symbolic};

    /// A question for each kind of term.
    fn every_kind(p: &mut Symbolic) {
        let (x, y, q, r) = (p.scalar("x"), p.scalar("y"), p.seq("q"), p.seq("r"));
        let made = x.add(y).sub(x).mul(y).div(x).sqrt().abs();
        let less = p.lt(made, y);
        let chosen = p.select(less, x, made);
        let parts = [p.le(chosen, p_one()), p.finite(x), p.same(x, y), p.seq_lt(q, r), p.seq_same(q, r), p.seq_zero(q)];
        let whole = p.all(&parts);
        let _ = y.lt(x) || q.is_zero() || r.lt(q);
        p.check("every kind", whole);
    }

    fn p_one() -> terms::SymbolicScalar {
        terms::SymbolicScalar::constant(-1.5)
    }

    fn questions() -> Vec<Question> {
        terms::clear();
        let path = terms::run(6, every_kind);
        let question = |&(check, formula)| Question { check, formula, literals: path.literals.clone() };
        path.checks.iter().map(question).collect()
    }

    fn lines(text: &str) -> Vec<&str> {
        text.lines().collect()
    }

    #[test]
    fn a_script_says_each_kind_of_term_in_smt_lib() {
        let questions = questions();
        let (text, variables) =
            script("a title\nof two lines", &questions.iter().collect::<Vec<_>>(), true, Inputs::Any);
        assert_eq!((variables.doubles.len(), variables.seqs.len()), (2, 2));
        let wanted = "\
; a title
; of two lines
(set-logic QF_BVFP)
(declare-const x0 Float64)
(declare-const x1 Float64)
(declare-const q0 (_ BitVec 64))
(declare-const q1 (_ BitVec 64))
(define-fun t4 () Float64 (fp.add RNE x0 x1))
(define-fun t5 () Float64 (fp.sub RNE t4 x0))
(define-fun t6 () Float64 (fp.mul RNE t5 x1))
(define-fun t7 () Float64 (fp.div RNE t6 x0))
(define-fun t8 () Float64 (fp.sqrt RNE t7))
(define-fun t9 () Float64 (fp.abs t8))
(define-fun t10 () Bool (fp.lt t9 x1))
(define-fun t11 () Float64 (ite t10 x0 t9))
(define-fun t13 () Bool (fp.leq t11 (fp #b1 #b01111111111 #b1000000000000000000000000000000000000000000000000000)))
(define-fun t14 () Bool (not (or (fp.isNaN x0) (fp.isInfinite x0))))
(define-fun t15 () Bool (= x0 x1))
(define-fun t16 () Bool (bvslt q0 q1))
(define-fun t17 () Bool (= q0 q1))
(define-fun t18 () Bool (= q0 (_ bv0 64)))";
        assert_eq!(lines(&text)[..wanted.lines().count()], lines(wanted)[..]);
        assert!(text.contains("(push 1) ; every kind\n(assert "), "{text}");
        assert!(text.ends_with("\n(check-sat)\n(get-value (x0 x1 q0 q1))\n(pop 1)\n"), "{text}");
    }

    #[test]
    fn without_arithmetic_each_operation_and_comparison_of_doubles_is_an_unknown_function() {
        let questions = questions();
        let text = uninterpreted(&questions.iter().collect::<Vec<_>>());
        assert!(!text.contains("fp"), "{text}");
        for term in ["(add x0 x1)", "(sub t4 x0)", "(mul t5 x1)", "(div t6 x0)", "(root t7)", "(size t8)"] {
            assert!(text.contains(&format!(" () D {term})\n")), "{term}");
        }
        for formula in ["(below t9 x1)", "(finite x0)", "(= x0 x1)", "(bvslt q0 q1)", "(= q0 (_ bv0 64))"] {
            assert!(text.contains(&format!(" () Bool {formula})\n")), "{formula}");
        }
        assert!(text.contains(&format!("(within t11 #b{:064b})", (-1.5_f64).to_bits())), "{text}");
    }

    #[test]
    fn a_question_denies_the_check_under_the_decisions_of_its_path() {
        let mut questions = questions();
        questions[0].literals[0].1 = false;
        let (text, _) = script("", &questions.iter().collect::<Vec<_>>(), false, Inputs::Any);
        let decided = questions[0].literals[0].0;
        let claim = Arithmetic::Doubles.name(questions[0].formula);
        assert!(text.contains(&format!("(assert (not t{decided}))")), "{text}");
        assert!(text.contains(&format!("(assert (not {claim}))\n(check-sat)\n(pop 1)\n")), "{text}");
    }

    #[test]
    fn doubles_with_few_digits_have_no_others() {
        let questions = questions();
        let (text, _) = script("", &questions.iter().collect::<Vec<_>>(), false, Inputs::Round);
        for nth in [0, 1] {
            let wanted = format!("(assert (= x{nth} (fp s{nth} e{nth} (concat f{nth} (_ bv0 46)))))");
            assert!(text.contains(&wanted), "{text}");
        }
        assert!(text.contains("(declare-const f1 (_ BitVec 6))"), "{text}");
    }

    #[test]
    fn inputs_stand_for_the_variables() {
        let questions = questions();
        let inputs = Guide { scalars: vec![f64::NAN, -0.0], seqs: vec![-1, 5], ..Guide::default() };
        let (text, _) = script("", &questions.iter().collect::<Vec<_>>(), false, Inputs::Given(&inputs));
        assert!(text.contains("(define-fun x0 () Float64 (_ NaN 11 53))\n"), "{text}");
        assert!(text.contains(&format!("(define-fun x1 () Float64 (fp #b1 #b{:011b} #b{:052b}))\n", 0, 0)), "{text}");
        assert!(text.contains(&format!("(define-fun q0 () (_ BitVec 64) #b{})\n", "1".repeat(64))), "{text}");
    }
}
