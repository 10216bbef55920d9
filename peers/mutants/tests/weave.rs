//! Weaving: where switches come to stand, and what is refused.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

#[path = "../build/weave.rs"]
mod weave;

use weave::{Site, weave};

fn site(number: usize, name: &'static str, code: &'static str, with: &'static str) -> Site<'static> {
    Site { number, name, after: None, code, with }
}

#[test]
fn the_code_becomes_a_switch_and_the_rest_stays() {
    let woven = weave("fn f() { a < b; }", &[site(7, "at-the-limit", "a < b", "a <= b")]).unwrap();
    assert_eq!(woven, "fn f() { (if mutant!(7) { a <= b } else { a < b }); }");
}

#[test]
fn mutants_of_one_place_and_within_each_other_are_told_apart() {
    let sites = [
        site(0, "never", "x && y < 1", "false"),
        site(1, "at-the-limit", "y < 1", "y <= 1"),
        site(2, "always", "x && y < 1", "true"),
    ];
    let woven = weave("x && y < 1", &sites).unwrap();
    assert_eq!(
        woven,
        "(if mutant!(0) { false } else if mutant!(2) { true } else { x && (if mutant!(1) { y <= 1 } else { y < 1 }) })"
    );
}

#[test]
fn code_that_stands_twice_is_found_behind_its_anchor() {
    let second = Site { after: Some("two("), ..site(3, "second", "a", "b") };
    let woven = weave("one(a) two(a)", &[second]).unwrap();
    assert_eq!(woven, "one(a) two((if mutant!(3) { b } else { a }))");
}

#[test]
fn code_that_is_missing_is_refused_with_the_mutant_named() {
    let error = weave("a <= b", &[site(0, "stale", "a < b", "false")]).unwrap_err();
    assert_eq!(error.to_string(), "the mutant stale: its `code` does not stand there: a < b");
    let behind = Site { after: Some("a <= b"), ..site(0, "stale", "a", "b") };
    let error = weave("a <= b", &[behind]).unwrap_err();
    assert_eq!(error.to_string(), "the mutant stale: its `code` does not stand there: a");
}

#[test]
fn code_or_an_anchor_that_is_repeated_is_refused_with_the_mutant_named() {
    let error = weave("a; a;", &[site(0, "ambiguous", "a", "b")]).unwrap_err();
    assert_eq!(error.to_string(), "the mutant ambiguous: its `code` stands there more than once: a");
    let anchored = Site { after: Some("x"), ..site(0, "ambiguous", "a", "b") };
    let error = weave("x x a", &[anchored]).unwrap_err();
    assert_eq!(error.to_string(), "the mutant ambiguous: its `after` stands there more than once: x");
}

#[test]
fn places_that_overlap_are_refused_with_both_mutants_named() {
    let sites = [site(0, "left", "a + b", "0"), site(1, "right", "b + c", "0")];
    let error = weave("a + b + c", &sites).unwrap_err().to_string();
    assert!(error.contains("left and right"), "{error}");
}

#[test]
fn unit_tests_are_left_out_and_no_place_for_mutants() {
    let text = "fn f() {}\n\n#[cfg(test)]\nmod tests {\n    fn f() {}\n}\n";
    assert_eq!(weave(text, &[]).unwrap(), "fn f() {}\n");
    assert!(weave(text, &[site(0, "once", "fn f()", "fn g()")]).is_ok());
}
