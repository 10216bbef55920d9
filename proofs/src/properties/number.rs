//! The numbers on which production runs the kernel: that `f64` and `i64` compute what their names say.

use crate::kernel::Kernel;
use crate::prover::Prover;

/// Doubles of every kind: both zeros, small and large ones, halves, the edges of the range, what is none.
const DOUBLES: [f64; 24] = [
    0.0,
    -0.0,
    0.5,
    -0.5,
    1.0,
    -1.0,
    1.5,
    1.75,
    2.0,
    3.0,
    -4.0,
    5.0,
    1000.0,
    60_000.0,
    0.1,
    1e200,
    -1e-200,
    5e-324,
    f64::MIN_POSITIVE,
    f64::MAX,
    f64::MIN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
];
const SEQS: [i64; 7] = [0, 1, 2, -1, i64::MAX, i64::MIN, i64::MAX - 1];

fn double<P: Prover>(p: &mut P, name: &str) -> f64 {
    let nth = p.choice(name, DOUBLES.len());
    DOUBLES.get(nth).copied().unwrap_or_default()
}

fn seq<P: Prover>(p: &mut P, name: &str) -> i64 {
    let nth = p.choice(name, SEQS.len());
    SEQS.get(nth).copied().unwrap_or_default()
}

/// Every operation gives, on every pair of the doubles and of the seqs above, what its name says.
pub fn operations<K: Kernel, P: Prover>(p: &mut P) {
    let numbers = K::numbers();
    if p.boolean("seqs") {
        let (a, b) = (seq(p, "a"), seq(p, "b"));
        for (name, is, says) in [
            ("a < b for seqs", (numbers.seq_lt)(a, b), b > a),
            ("a = 0 for a seq", (numbers.seq_is_zero)(a), matches!(a, 0)),
        ] {
            let right = p.truth(is == says);
            p.check(name, right);
            p.explain(&|| format!("a = {a}, b = {b}: the text says {says}, the kernel {is}"));
        }
        return;
    }
    let (a, b) = (double(p, "a"), double(p, "b"));
    for (name, is, says) in [
        ("a + b", (numbers.add)(a, b), a + b),
        ("a − b", (numbers.sub)(a, b), a - b),
        ("a · b", (numbers.mul)(a, b), a * b),
        ("a / b", (numbers.div)(a, b), a / b),
        ("√a", (numbers.sqrt)(a), f64::sqrt(a)),
        ("|a|", (numbers.abs)(a), f64::copysign(a, 1.0)),
        ("1 where a < b, else 2", (numbers.select_lt)(a, b, 1.0, 2.0), if b > a { 1.0 } else { 2.0 }),
        ("the constant a", (numbers.constant)(a), a),
    ] {
        let same = is.to_bits() == says.to_bits() || (is.is_nan() && says.is_nan());
        let right = p.truth(same);
        p.check(name, right);
        p.explain(&|| format!("a = {a:?}, b = {b:?}: the text says {says:?}, the kernel {is:?}"));
    }
    for (name, is, says) in [
        ("a < b", (numbers.lt)(a, b), b > a),
        ("a ≤ b", (numbers.le)(a, b), b >= a),
        ("a is finite", (numbers.is_finite)(a), (f64::MIN..=f64::MAX).contains(&a)),
    ] {
        let right = p.truth(is == says);
        p.check(name, right);
        p.explain(&|| format!("a = {a:?}, b = {b:?}: the text says {says}, the kernel {is}"));
    }
    let most = p.choice("most", 5);
    let is = (numbers.floor_index)(a, most);
    // As many whole numbers from 1 to `most` are not above it.
    let mut says = 0;
    let mut whole = 1.0;
    while says < most && whole <= a {
        says += 1;
        whole += 1.0;
    }
    let right = p.truth(is == says);
    p.check("⌊a⌋, at most that many", right);
    p.explain(&|| format!("a = {a:?}, at most {most}: the text says {says}, the kernel {is}"));
}
