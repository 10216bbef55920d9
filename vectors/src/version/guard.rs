//! The version guard, strict and not.

use crate::case::{Case, File, Role};
use crate::json::object;

pub(super) fn file() -> File {
    let mut cases = Vec::new();
    for Version { name, text, rules, is } in VERSIONS {
        for strict in [true, false] {
            let how = if strict { "strict" } else { "lenient" };
            let mut rules = rules.to_vec();
            let (answer, why) = match (is, strict) {
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
                let decides = usize::from(strict && *is == Is::Other);
                rules = rules.get(decides).into_iter().copied().collect();
            } else {
                // A guard that compares wrongly fails both ways, one that ignores how it was asked
                // fails one: so each of the two rules comes first somewhere.
                match (is, strict) {
                    (Is::Compatible, true) => rules.insert(0, "NCP-VER-008"),
                    (Is::Compatible, false) => rules.push("NCP-VER-008"),
                    (Is::Other, true) => rules.insert(0, "NCP-VER-006"),
                    (Is::Other, false) if rules.contains(&"NCP-VER-004") => {
                        rules.insert(0, "NCP-VER-007");
                    }
                    (Is::Other, false) => rules.push("NCP-VER-007"),
                    (Is::Malformed, _) => {}
                }
            }
            let verb = if rules.first() == Some(&"NCP-VER-009") { "should answer" } else { "answers" };
            let case = Case::new(format!("{how}/{name}"), &rules, &Role::ALL)
                .title(format!(
                    "A {how} version guard {verb} {} with {answer}.",
                    crate::json::Json::string(*text).text()
                ))
                .flags(&[match is {
                    Is::Malformed => "lenient-versions",
                    _ if advisory => "version-overflow",
                    _ => "version-arithmetic",
                }])
                .call("version.check", object! { "version" => *text, "strict" => strict })
                .because(why);
            cases.push(match answer {
                "an error" => case.rejects("version"),
                answer => case.gives(object! { "compatible" => answer == "true" }),
            });
        }
    }
    let about = "The version guard of wire 0.5: versions that are compatible, others, and texts that are no version.";
    File::new("version", "guard", about, cases)
}

struct Version {
    name: &'static str,
    text: &'static str,
    rules: &'static [&'static str],
    is: Is,
}

#[derive(PartialEq, Eq)]
enum Is {
    Compatible,
    Other,
    Malformed,
}

const fn other(name: &'static str, text: &'static str, rules: &'static [&'static str]) -> Version {
    Version { name, text, rules, is: Is::Other }
}

const fn malformed(name: &'static str, text: &'static str) -> Version {
    Version { name, text, rules: &["NCP-VER-001"], is: Is::Malformed }
}

const VERSIONS: &[Version] = &[
    Version { name: "own", text: "0.5", rules: &["NCP-VER-003", "NCP-VER-021"], is: Is::Compatible },
    other("older-minor", "0.4", &["NCP-VER-003"]),
    other("newer-minor", "0.6", &["NCP-VER-003"]),
    other("minor-of-two-digits", "0.50", &["NCP-VER-003"]),
    other("minor-that-begins-alike", "0.51", &["NCP-VER-003"]),
    other("minor-that-ends-alike", "0.15", &["NCP-VER-003"]),
    other("minor-zero", "0.0", &["NCP-VER-003"]),
    other("swapped", "5.0", &["NCP-VER-004"]),
    other("next-major", "1.0", &["NCP-VER-004"]),
    other("next-major-own-minor", "1.5", &["NCP-VER-004"]),
    other("major-of-two-digits", "10.5", &["NCP-VER-004"]),
    other("no-minor", "0", &["NCP-VER-002", "NCP-VER-003"]),
    other("no-minor-next-major", "1", &["NCP-VER-002", "NCP-VER-004"]),
    other("no-minor-five", "5", &["NCP-VER-002", "NCP-VER-004"]),
    other("large", "4294967295.4294967295", &["NCP-VER-009", "NCP-VER-004"]),
    Version { name: "leading-zero-minor", text: "0.05", rules: &["NCP-VER-009"], is: Is::Compatible },
    Version { name: "leading-zeros", text: "000.0005", rules: &["NCP-VER-009"], is: Is::Compatible },
    Version { name: "leading-zero-major", text: "00.5", rules: &["NCP-VER-009"], is: Is::Compatible },
    other("minor-wraps-at-2-to-8", "0.261", &["NCP-VER-009", "NCP-VER-003"]),
    other("minor-wraps-at-2-to-16", "0.65541", &["NCP-VER-009", "NCP-VER-003"]),
    other("minor-wraps-at-2-to-32", "0.4294967301", &["NCP-VER-009", "NCP-VER-003"]),
    other("minor-wraps-at-2-to-64", "0.18446744073709551621", &["NCP-VER-009", "NCP-VER-003"]),
    other("major-wraps-at-2-to-32", "4294967296.5", &["NCP-VER-009", "NCP-VER-004"]),
    other("major-wraps-at-2-to-64", "18446744073709551616.5", &["NCP-VER-009", "NCP-VER-004"]),
    other("minor-rounds-as-a-double", "0.5000000000000000000000000000000000000001", &["NCP-VER-009", "NCP-VER-003"]),
    malformed("empty", ""),
    malformed("dot", "."),
    malformed("empty-minor", "0."),
    malformed("empty-major", ".5"),
    malformed("three-parts", "0.5.0"),
    malformed("three-parts-next", "0.5.1"),
    malformed("empty-third-part", "0.5."),
    malformed("two-dots", "0..5"),
    malformed("dot-first", ".0.5"),
    malformed("letter-v", "v0.5"),
    malformed("letter-v-capital", "V0.5"),
    malformed("suffix", "0.5-rc1"),
    malformed("suffix-letter", "0.5a"),
    malformed("build", "0.5+build"),
    malformed("word", "latest"),
    malformed("wildcard", "0.*"),
    malformed("wildcard-x", "0.x"),
    malformed("range", ">=0.5"),
    malformed("caret", "^0.5"),
    malformed("plus-major", "+0.5"),
    malformed("plus-minor", "0.+5"),
    malformed("minus-major", "-0.5"),
    malformed("minus-minor", "0.-5"),
    malformed("space-first", " 0.5"),
    malformed("space-last", "0.5 "),
    malformed("space-before-dot", "0 .5"),
    malformed("space-after-dot", "0. 5"),
    malformed("space-alone", " "),
    malformed("tab-first", "\t0.5"),
    malformed("line-feed-last", "0.5\n"),
    malformed("carriage-return-last", "0.5\r"),
    malformed("line-feed-first", "\n0.5"),
    malformed("no-break-space-last", "0.5\u{a0}"),
    malformed("nul-last", "0.5\0"),
    malformed("nul-before-dot", "0\0.5"),
    malformed("nul-hides-the-rest", "0.5\0.9"),
    malformed("byte-order-mark", "\u{feff}0.5"),
    malformed("underscore", "0.0_5"),
    malformed("underscore-in-major", "0_0.5"),
    malformed("underscore-last", "0.5_"),
    malformed("exponent", "0.5e0"),
    malformed("exponent-without-dot", "5e0"),
    malformed("hexadecimal", "0x0.0x5"),
    malformed("hexadecimal-digit", "0.a"),
    malformed("octal", "0.0o5"),
    malformed("comma", "0,5"),
    malformed("colon", "0:5"),
    malformed("full-width-digits", "\u{ff10}.\u{ff15}"),
    malformed("full-width-dot", "0\u{ff0e}5"),
    malformed("arabic-indic-digits", "\u{660}.\u{665}"),
    malformed("devanagari-digits", "\u{966}.\u{96b}"),
    malformed("superscript-digit", "0.\u{2075}"),
    malformed("mathematical-digits", "\u{1d7ce}.\u{1d7d3}"),
    malformed("ideographic-full-stop", "0\u{3002}5"),
    malformed("quoted", "\"0.5\""),
    malformed("infinity", "Infinity"),
    malformed("nan", "NaN"),
];
