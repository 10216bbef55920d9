//! Whether doubles tell what real numbers would.
//!
//! The text speaks of real numbers where it compares an age with a limit. Where a correct program may round another
//! way, no answer can be asked for.

use std::cmp::Ordering;

/// How *now* − *then*, in milliseconds, compares with a limit; none where a rounding may decide.
pub(super) fn age(now_s: f64, then_s: f64, limit_ms: f64) -> Option<Ordering> {
    let age = now_s - then_s;
    let ms = age * 1000.0;
    if !ms.is_finite() || !limit_ms.is_finite() {
        return None;
    }
    // A program that multiplies both times first rounds twice where none has to: that is its fault.
    let exact = is_difference(now_s, then_s, age) && is_product(age, 1000.0);
    let slack = 1e-12 * (now_s.abs().max(then_s.abs()) * 1000.0) + 1e-12 * limit_ms.abs();
    if exact || (ms - limit_ms).abs() > slack { ms.partial_cmp(&limit_ms) } else { None }
}

/// Whether a double is exactly the difference of two others.
fn is_difference(a: f64, b: f64, difference: f64) -> bool {
    let back = difference - a;
    (a - (difference - back)) + (-b - back) == 0.0
}

/// Whether the product of two doubles is a double.
fn is_product(a: f64, b: f64) -> bool {
    let product = a * b;
    // What underflows is no product, and its rest would not be seen.
    let is_seen = a == 0.0 || b == 0.0 || product.abs() > 1e-290;
    product.is_finite() && a.mul_add(b, -product) == 0.0 && is_seen
}

/// Whether the sum of two doubles is a double.
fn is_sum(a: f64, b: f64) -> bool {
    is_difference(a, -b, a + b)
}

/// The length of a vector, also where its squares leave the doubles.
pub(super) fn norm(data: &[f64]) -> f64 {
    let largest = data.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    if largest == 0.0 || !largest.is_finite() {
        return largest;
    }
    // Powers of two scale without a rounding.
    let scale = 2_f64.powi(-(largest.log2().floor().clamp(-1000.0, 1000.0) as i32));
    data.iter().map(|x| (x * scale) * (x * scale)).sum::<f64>().sqrt() / scale
}

/// Whether a length compares with a limit beyond every rounding: it is that of one component, it and its squares are
/// doubles, or it is far from the limit.
pub(super) fn is_settled(data: &[f64], limit: f64) -> bool {
    if !data.iter().all(|x| x.is_finite()) {
        return true;
    }
    let length = norm(data);
    if data.iter().filter(|x| **x != 0.0).count() <= 1 || (length - limit).abs() > 1e-12 * limit.abs().max(length) {
        return true;
    }
    let mut sum = 0.0;
    for x in data {
        if !is_product(*x, *x) || !is_sum(sum, x * x) {
            return false;
        }
        sum += x * x;
    }
    let root = sum.sqrt();
    is_product(root, root) && root * root == sum && is_product(limit, limit)
}

/// ⌊a / b⌋ of real numbers, for positive ones: the one or two numbers that a correct program may take for it.
pub(super) fn floors(a: f64, b: f64) -> Vec<f64> {
    let quotient = a / b;
    let floor = quotient.floor();
    // Whether the real quotient is a whole number, or below the double.
    let rest = quotient.mul_add(-b, a);
    if quotient != floor || rest == 0.0 {
        let near = (quotient - quotient.round()).abs() <= quotient.abs() * 1e-15;
        return if near && rest != 0.0 { vec![floor, quotient.round()] } else { vec![floor] };
    }
    vec![floor, floor - 1.0]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_age_at_its_limit_is_settled_where_doubles_are_exact() {
        assert_eq!(age(10.5, 10.25, 250.0), Some(Ordering::Equal));
        // Both times as milliseconds would be further apart.
        assert_eq!(age(2.51, 2.01, 500.0), Some(Ordering::Equal));
        assert_eq!(age(10.5625, 10.25, 250.0), Some(Ordering::Greater));
        assert_eq!(age(0.35, 0.1, 250.0), None);
        assert_eq!(age(0.36, 0.1, 250.0), Some(Ordering::Greater));
        assert_eq!(age(f64::NAN, 0.1, 250.0), None);
    }

    #[test]
    fn a_length_at_its_limit_is_settled_where_its_squares_are_exact() {
        assert!(is_settled(&[3.0, 4.0, 0.0], 5.0));
        assert!(is_settled(&[0.0, 5.0_f64.next_up(), 0.0], 5.0));
        assert!(!is_settled(&[0.3, 0.4, 0.0], 0.5));
        assert!(is_settled(&[0.3, 0.4, 0.0], 0.6));
        assert!(!is_settled(&[3e-210, 4e-210, 0.0], 5e-210));
        // The norm is no double, and rounds to the limit.
        let little = 2_f64.powi(-26);
        assert!(!is_settled(&[1.0, little, 0.0], 1.0));
        assert!((norm(&[3e-200, 4e-200, 0.0]) - 5e-200).abs() < 1e-210);
        assert!((norm(&[3e200, 4e200, 0.0]) - 5e200).abs() < 1e190);
    }

    #[test]
    fn a_quotient_that_rounds_to_a_whole_number_has_two_floors() {
        assert_eq!(floors(7.0, 2.0), [3.0]);
        assert_eq!(floors(6.0, 2.0), [3.0]);
        assert!(floors(1.0, 0.1).len() <= 2);
    }
}
