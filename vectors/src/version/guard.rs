//! The version guard, strict and not.

use ncp_text::WIRE_VERSION;

use crate::case::{Case, File, Role};
use crate::json::{Json, object};
use crate::scenario::{Row, ScenarioError, Scenarios, parts, source};
use crate::template::Text;

/// What a text is to the guard.
#[derive(PartialEq, Eq)]
enum Is {
    Compatible,
    Other,
    Malformed,
}

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut text = Scenarios::read(source!("version/guard"))?;
    let mut cases = Vec::new();
    for row in text.rows("versions")? {
        let is = match row.cell("is")? {
            "own" => Is::Compatible,
            "other" => Is::Other,
            _ => Is::Malformed,
        };
        let (name, version) = (row.name, Json::read(&row.text("sent")?));
        for strict in [true, false] {
            let how = if strict { "strict" } else { "lenient" };
            let mut rules = row.rules.clone();
            let (answer, why) = match (&is, strict) {
                (Is::Compatible, _) => ("true", "The version is one's own, by value."),
                (Is::Other, false) => {
                    ("false", "A well-formed version that is not compatible is `false`, not an error.")
                }
                (Is::Other, true) => ("an error", "A strict guard answers what is not compatible with an error."),
                (Is::Malformed, _) => {
                    ("an error", "It is not one or two unsigned integers of ASCII digits with one dot between.")
                }
            };
            // A guard that does not compare by value may answer large numbers with an error, which
            // is what a strict one has to do anyway: only there the binding rule decides.
            let advisory = rules.first() == Some(&"NCP-VER-009");
            if advisory {
                let decides = usize::from(strict && is == Is::Other);
                rules = rules.get(decides).into_iter().copied().collect();
            } else {
                // A guard that compares wrongly fails both ways, one that ignores how it was asked
                // fails one: so each of the two rules comes first somewhere.
                match (&is, strict) {
                    (Is::Compatible, true) => rules.insert(0, "NCP-VER-008"),
                    (Is::Compatible, false) => rules.push("NCP-VER-008"),
                    (Is::Other, true) => rules.insert(0, "NCP-VER-006"),
                    (Is::Other, false) if rules.contains(&"NCP-VER-004") => {
                        rules = vec!["NCP-VER-004", "NCP-VER-007"];
                    }
                    (Is::Other, false) => rules.push("NCP-VER-007"),
                    (Is::Malformed, _) => {}
                }
            }
            let verb = if rules.first() == Some(&"NCP-VER-009") { "should answer" } else { "answers" };
            let case = Case::new(format!("{how}/{name}"), &rules, &Role::ALL)
                .title(format!("A {how} version guard {verb} {} with {answer}.", version.text()))
                .flags(&[match is {
                    Is::Malformed => "lenient-versions",
                    _ if advisory => "version-overflow",
                    _ => "version-arithmetic",
                }])
                .call("version.check", object! { "version" => version.clone(), "strict" => strict })
                .because(why);
            cases.push(match answer {
                "an error" => case.rejects("version"),
                "false" => case.by("refusal", "NCP-VER-007").gives(object! { "compatible" => false }),
                _ => case.gives(object! { "compatible" => true }),
            });
        }
    }
    cases.extend(far());
    cases.extend(cut());
    cases.extend(spoilt());
    let about = format!(
        "The version guard of wire {WIRE_VERSION}: versions that are compatible, others, and texts that are no version."
    );
    text.end()?;
    Ok(File::new("version", "guard", about, cases))
}

/// Texts that are no version, as the names of their rows: what a guard sees on whichever road it is asked.
pub(crate) const MALFORMED: [&str; 5] =
    ["nul-last", "full-width-digits", "nul-hides-the-rest", "arabic-indic-digits", "underscore"];

/// The texts of these rows, by name, as JSON strings.
pub(crate) fn malformed(names: &[&str]) -> Result<Vec<(&'static str, Json)>, ScenarioError> {
    let rows = Scenarios::read(source!("version/guard"))?.rows("versions")?;
    let read = |row: &Row| Ok((row.name, Json::read(&row.text("sent")?)));
    rows.iter().filter(|row| names.contains(&row.name)).map(read).collect()
}

/// Versions of more digits than some languages take for an integer.
fn far() -> [Case; 2] {
    const ZEROS: usize = 5_000;
    let (major, minor) = parts(WIRE_VERSION);
    let zeros = || Text::repeat("0", ZEROS);
    let far = |part: &str, rules: [&'static str; 2], version: Text| {
        Case::new(format!("strict/{part}-behind-{ZEROS}-zeros"), &rules, &Role::ALL)
            .title(format!("A strict version guard answers a {part} that differs before {ZEROS} zeros with an error."))
            .flags(&["version-overflow"])
            .call("version.check", object! { "version" => version, "strict" => true })
            .rejects("version")
            .because("A strict guard answers what is not compatible with an error, however long it is.")
    };
    let of_minor = Text::concat([format!("{major}.1").into(), zeros(), minor.into()]);
    let of_major = Text::concat(["1".into(), zeros(), WIRE_VERSION.into()]);
    [far("minor", ["NCP-VER-006", "NCP-VER-003"], of_minor), far("major", ["NCP-VER-006", "NCP-VER-004"], of_major)]
}

/// Versions that are one's own up to so many digits of a part, and another with the next.
fn cut() -> Vec<Case> {
    const WIDTHS: [usize; 13] = [8, 10, 15, 16, 19, 20, 31, 32, 63, 64, 127, 255, 256];
    let (major, minor) = parts(WIRE_VERSION);
    let one = |width: usize, part: &str, rule: &'static str, version: String| {
        Case::new(format!("strict/{part}-other-behind-{width}-digits"), &["NCP-VER-006", rule], &Role::ALL)
            .title(format!("A strict version guard answers a {part} that differs behind {width} digits with an error."))
            .flags(&["version-overflow"])
            .call("version.check", object! { "version" => version, "strict" => true })
            .rejects("version")
            .because("A strict guard answers what is not compatible with an error, however long it is.")
    };
    let both = |width: usize| {
        let zeros = |least: &str| "0".repeat(width.saturating_sub(least.len()));
        let of_minor = format!("{major}.{}{minor}0", zeros(minor));
        let of_major = format!("{}{major}1.{minor}", zeros(major));
        [one(width, "minor", "NCP-VER-003", of_minor), one(width, "major", "NCP-VER-004", of_major)]
    };
    WIDTHS.into_iter().flat_map(both).collect()
}

/// Texts whose first so many characters are a version.
fn spoilt() -> Vec<Case> {
    const WIDTHS: [usize; 8] = [15, 16, 31, 32, 63, 64, 128, 255];
    let (major, minor) = parts(WIRE_VERSION);
    let one = |width: usize, (what, says, tail): (&str, &str, &str), strict: bool| {
        let how = if strict { "strict" } else { "lenient" };
        let zeros = "0".repeat(width.saturating_sub(major.len() + 1 + minor.len()));
        let version = format!("{major}.{zeros}{minor}{tail}");
        Case::new(format!("{how}/spoilt-behind-{width}-characters/{what}"), &["NCP-VER-001"], &Role::ALL)
            .title(format!(
                "A {how} version guard answers a version with {says} behind {width} characters with an error."
            ))
            .flags(&["version-overflow"])
            .call("version.check", object! { "version" => version, "strict" => strict })
            .rejects("version")
            .because("It is not one or two unsigned integers of ASCII digits with one dot between, all of it.")
    };
    let tails = [("letter", "a letter", "x"), ("third-part", "a third part", ".5")];
    let of = |width| tails.into_iter().flat_map(move |tail| [(width, tail, true), (width, tail, false)]);
    WIDTHS.into_iter().flat_map(of).map(|(width, tail, strict)| one(width, tail, strict)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_of_a_malformed_version_is_the_name_of_a_row() {
        assert_eq!(malformed(&MALFORMED).unwrap().len(), MALFORMED.len());
    }
}
