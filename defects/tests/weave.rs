//! Weaving: where switches come to stand, and what is refused.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use ncp_defects::Edit;
use ncp_defects::weave::{self, Site, WeaveError};

fn edit(after: Option<&str>, code: &str, with: &str) -> Edit {
    let (after, code, with) = (after.map(str::to_owned), code.to_owned(), with.to_owned());
    Edit { file: String::new(), after, code, with, always: false }
}

/// Weaves edits of these numbers and names.
fn weave(text: &str, edits: &[(usize, &str, Edit)]) -> Result<String, WeaveError> {
    let sites: Vec<_> = edits.iter().map(|(number, name, edit)| Site { number: *number, name, edit }).collect();
    weave::weave(text, "switch", &sites)
}

fn site<'n>(number: usize, name: &'n str, code: &str, with: &str) -> (usize, &'n str, Edit) {
    (number, name, edit(None, code, with))
}

#[test]
fn the_code_becomes_a_switch_and_the_rest_stays() {
    let woven = weave("fn f() { a < b; }", &[site(7, "at-the-limit", "a < b", "a <= b")]).unwrap();
    assert_eq!(woven, "fn f() { (if switch(7) { a <= b } else { a < b }); }");
}

#[test]
fn defects_of_one_place_and_within_each_other_are_told_apart() {
    let sites = [
        site(0, "never", "x && y < 1", "false"),
        site(1, "at-the-limit", "y < 1", "y <= 1"),
        site(2, "always", "x && y < 1", "true"),
    ];
    let woven = weave("x && y < 1", &sites).unwrap();
    assert_eq!(
        woven,
        "(if switch(0) { false } else if switch(2) { true } else { x && (if switch(1) { y <= 1 } else { y < 1 }) })"
    );
}

#[test]
fn what_is_always_made_has_no_switch_and_stands_once_for_all_that_make_it() {
    let field = |number, name, with| {
        let (number, name, edit) = site(number, name, "stop: bool", with);
        (number, name, Edit { always: true, ..edit })
    };
    let counts = "stop: bool, count: u8";
    let woven = weave("struct G { stop: bool }", &[field(0, "ninth", counts), field(1, "tenth", counts)]).unwrap();
    assert_eq!(woven, "struct G { stop: bool, count: u8 }");
    for other in [field(1, "tenth", "stop: bool, tens: u8"), site(1, "tenth", "stop: bool", counts)] {
        let error = weave("struct G { stop: bool }", &[field(0, "ninth", counts), other]).unwrap_err();
        assert!(matches!(error, WeaveError::Overlap { .. }), "{error}");
    }
    let within = site(1, "tenth", "bool", "u8");
    assert!(weave("struct G { stop: bool }", &[field(0, "ninth", counts), within]).is_err());
}

#[test]
fn code_that_stands_twice_is_found_behind_its_anchor() {
    let second = (3, "second", edit(Some("two("), "a", "b"));
    let woven = weave("one(a) two(a)", &[second]).unwrap();
    assert_eq!(woven, "one(a) two((if switch(3) { b } else { a }))");
}

#[test]
fn code_that_is_missing_is_refused_with_the_defect_named() {
    let error = weave("a <= b", &[site(0, "stale", "a < b", "false")]).unwrap_err();
    assert_eq!(error.to_string(), "stale: its `code` does not stand there: a < b");
    let behind = (0, "stale", edit(Some("a <= b"), "a", "b"));
    let error = weave("a <= b", &[behind]).unwrap_err();
    assert_eq!(error.to_string(), "stale: its `code` does not stand there: a");
}

#[test]
fn code_or_an_anchor_that_is_repeated_is_refused_with_the_defect_named() {
    let error = weave("a; a;", &[site(0, "ambiguous", "a", "b")]).unwrap_err();
    assert_eq!(error.to_string(), "ambiguous: its `code` stands there more than once: a");
    let anchored = (0, "ambiguous", edit(Some("x"), "a", "b"));
    let error = weave("x x a", &[anchored]).unwrap_err();
    assert_eq!(error.to_string(), "ambiguous: its `after` stands there more than once: x");
}

#[test]
fn places_that_overlap_are_refused_with_both_defects_named() {
    let sites = [site(0, "left", "a + b", "0"), site(1, "right", "b + c", "0")];
    let error = weave("a + b + c", &sites).unwrap_err().to_string();
    assert!(error.contains("left and right"), "{error}");
}

#[test]
fn unit_tests_are_left_out_and_no_place_for_defects() {
    let text = "fn f() {}\n\n#[cfg(test)]\nmod tests {\n    fn f() {}\n}\n";
    assert_eq!(weave(text, &[]).unwrap(), "fn f() {}\n");
    assert!(weave(text, &[site(0, "once", "fn f()", "fn g()")]).is_ok());
}
