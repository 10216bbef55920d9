//! Which keys a key expression covers.
//!
//! The table below was written by hand from section 3.4; a test holds it against Zenoh's own
//! `zenoh-keyexpr`.

use crate::case::Role::Observer;
use crate::case::{Case, File};
use crate::json::object;

pub(super) fn file() -> File {
    let mut cases = Vec::new();
    for Pattern { rule, pattern, covers, others, hidden } in PATTERNS {
        let covered = covers.iter().map(|key| (key, true, *rule));
        let others = others.iter().map(|key| (key, false, *rule));
        let hidden = hidden.iter().map(|key| (key, false, "NCP-KEY-034"));
        cases.extend(covered.chain(others).chain(hidden).map(|(key, matches, rule)| {
            let flag = match rule {
                "NCP-KEY-034" | "NCP-KEY-035" => "hidden-segment",
                "NCP-KEY-030" => "literal-patterns",
                "NCP-KEY-033" => "partial-wildcards",
                _ => "wildcards",
            };
            let verb = if matches { "covers" } else { "does not cover" };
            Case::new(format!("{}/{}", slug(pattern), slug(key)), &[rule], &[Observer])
                .title(format!("`{pattern}` {verb} `{key}`."))
                .flags(&[flag])
                .call("key.match", object! { "pattern" => *pattern, "key" => *key })
                .gives(object! { "matches" => matches })
                .because(why(rule))
        }));
    }
    let invalid = INVALID.iter().map(|(what, pattern, key)| {
        Case::new(format!("invalid/{what}"), &["NCP-KEY-036"], &[Observer])
            .title(format!("Whether `{pattern}` covers `{key}` should be answered with an error."))
            .flags(&["invalid-expressions"])
            .call("key.match", object! { "pattern" => *pattern, "key" => *key })
            .rejects("key")
            .because("One of the two is not a valid key expression.")
    });
    cases.extend(invalid);
    let about = "Which keys a key expression covers, wildcard by wildcard, and the chunks that wildcards do not see.";
    File::new("keys", "matching", about, cases)
}

fn why(rule: &str) -> &'static str {
    match rule {
        "NCP-KEY-030" => {
            "Without wildcards a pattern covers the equal key and no other; no character but `*` and `$*` is special."
        }
        "NCP-KEY-031" => "`*` stands for exactly one chunk.",
        "NCP-KEY-032" => "`**` stands for any number of chunks, also none.",
        "NCP-KEY-033" => "`$*` stands for any run of characters within its chunk, also none.",
        "NCP-KEY-034" => "No wildcard sees a chunk that begins with `@`.",
        _ => "A chunk that begins with `@` covers the equal chunk, and only that.",
    }
}

/// An expression as a part of an id.
fn slug(expression: &str) -> String {
    let mut out = String::new();
    for c in expression.chars() {
        match c {
            'a'..='z' | '0'..='9' | '.' | '_' => out.push(c),
            'A'..='Z' => {
                out.push_str("cap-");
                out.push(c.to_ascii_lowercase());
            }
            '/' => out.push('-'),
            '*' => out.push_str("star"),
            '$' => out.push_str("dollar"),
            '@' => out.push_str("at"),
            c => out.push_str(&format!("u{:x}", u32::from(c))),
        }
    }
    out
}

/// A pattern and the rule that it shows, keys that it covers, and keys that it does not.
struct Pattern {
    rule: &'static str,
    pattern: &'static str,
    covers: &'static [&'static str],
    others: &'static [&'static str],
    /// Keys that it would cover if wildcards saw the chunks that begin with `@`.
    hidden: &'static [&'static str],
}

const fn pattern(
    rule: &'static str,
    pattern: &'static str,
    covers: &'static [&'static str],
    others: &'static [&'static str],
    hidden: &'static [&'static str],
) -> Pattern {
    Pattern { rule, pattern, covers, others, hidden }
}

const PATTERNS: &[Pattern] = &[
    pattern(
        "NCP-KEY-030",
        "ncp/rpc",
        &["ncp/rpc"],
        &["ncp", "rpc", "ncp/rpc/x", "x/ncp/rpc", "ncp/RPC", "ncp/rp", "ncp/rpcs", "ncp/session/rpc"],
        &[],
    ),
    pattern(
        "NCP-KEY-030",
        "ncp/session/uav3/sensor",
        &["ncp/session/uav3/sensor"],
        &["ncp/session/uav3/sensor/front", "ncp/session/uav3", "ncp/session/uav33/sensor", "ncp/session/Uav3/sensor"],
        &[],
    ),
    pattern("NCP-KEY-030", "ncp/caf\u{e9}", &["ncp/caf\u{e9}"], &["ncp/cafe\u{301}", "ncp/cafe"], &[]),
    pattern("NCP-KEY-030", "a.b/c", &["a.b/c"], &["axb/c", "ab/c"], &[]),
    pattern("NCP-KEY-030", "a+b/(c)/[d]/e|f^", &["a+b/(c)/[d]/e|f^"], &["aab/(c)/[d]/e|f^", "a+b/c/d/e"], &[]),
    pattern("NCP-KEY-030", "a\\d/b", &["a\\d/b"], &["a1/b", "ad/b"], &[]),
    pattern("NCP-KEY-030", "%2A/a", &["%2A/a"], &["b/a"], &[]),
    pattern("NCP-KEY-031", "*", &["ncp", "a", "a.b", "\u{1f681}"], &["ncp/rpc"], &["@ncp"]),
    pattern("NCP-KEY-031", "*/*", &["ncp/rpc", "a/a"], &["ncp", "a/b/c"], &["@a/b", "a/@b"]),
    pattern(
        "NCP-KEY-031",
        "ncp/*",
        &["ncp/rpc", "ncp/ncp", "ncp/a@b"],
        &["ncp", "ncp/a/b", "engram/rpc"],
        &["ncp/@rpc"],
    ),
    pattern("NCP-KEY-031", "*/rpc", &["ncp/rpc", "rpc/rpc"], &["rpc", "a/ncp/rpc", "ncp/rpcs"], &[]),
    pattern(
        "NCP-KEY-031",
        "ncp/session/*/sensor",
        &[
            "ncp/session/a/sensor",
            "ncp/session/uav-3.b/sensor",
            "ncp/session/\u{e9}/sensor",
            "ncp/session/sensor/sensor",
        ],
        &["ncp/session/sensor", "ncp/session/a/b/sensor", "ncp/session/a/command", "ncp/session/a/sensor/front"],
        &["ncp/session/@a/sensor"],
    ),
    pattern("NCP-KEY-031", "ncp/session/*", &["ncp/session/a"], &["ncp/session", "ncp/session/a/sensor"], &[]),
    pattern("NCP-KEY-031", "ncp/*/*/sensor", &["ncp/session/a/sensor"], &["ncp/a/sensor", "ncp/a/b/c/sensor"], &[]),
    pattern("NCP-KEY-032", "**", &["ncp", "ncp/rpc", "a/b/c/d/e/f/g/h"], &[], &["@ncp", "ncp/@rpc", "@a/b"]),
    pattern(
        "NCP-KEY-032",
        "ncp/**",
        &["ncp", "ncp/rpc", "ncp/session/a/sensor/front", "ncp/a@b/c"],
        &["ncpx", "ncpx/a", "engram/ncp", "rpc"],
        &["ncp/@a", "ncp/a/@b", "ncp/@a/b"],
    ),
    pattern(
        "NCP-KEY-032",
        "**/sensor",
        &["sensor", "a/sensor", "ncp/session/a/sensor", "sensor/sensor"],
        &["sensor/front", "ncp/sensors", "ncp"],
        &["@a/sensor"],
    ),
    pattern(
        "NCP-KEY-032",
        "ncp/**/sensor",
        &["ncp/sensor", "ncp/session/a/sensor", "ncp/sensor/sensor"],
        &["ncp", "sensor", "ncp/session/a/sensor/front", "ncp/sensors"],
        &["ncp/@a/sensor"],
    ),
    pattern(
        "NCP-KEY-032",
        "ncp/session/**",
        &["ncp/session", "ncp/session/a", "ncp/session/a/sensor/front"],
        &["ncp", "ncp/rpc", "ncp/sessions/a", "engram/ncp/session/a"],
        &["ncp/session/@a/sensor"],
    ),
    pattern(
        "NCP-KEY-032",
        "ncp/session/a/sensor/**",
        &["ncp/session/a/sensor", "ncp/session/a/sensor/front", "ncp/session/a/sensor/front/left"],
        &[
            "ncp/session/a/command",
            "ncp/session/a",
            "ncp/session/ab/sensor",
            "ncp/session/a/sensors",
            "ncp/session/a/command/sensor",
        ],
        &["ncp/session/a/sensor/@front"],
    ),
    pattern(
        "NCP-KEY-032",
        "ncp/session/a/command/**",
        &["ncp/session/a/command", "ncp/session/a/command/gimbal"],
        &["ncp/session/a/sensor", "ncp/session/b/command"],
        &[],
    ),
    pattern(
        "NCP-KEY-032",
        "ncp/session/a/**",
        &["ncp/session/a", "ncp/session/a/observation", "ncp/session/a/command/gimbal"],
        &["ncp/session/b", "ncp/session", "ncp/session/aa"],
        &[],
    ),
    pattern(
        "NCP-KEY-032",
        "engram/ncp/session/**",
        &["engram/ncp/session", "engram/ncp/session/a/sensor"],
        &["ncp/session/a", "engram/session/a", "engram/ncp/rpc"],
        &[],
    ),
    pattern(
        "NCP-KEY-032",
        "ncp/**/sensor/**",
        &["ncp/sensor", "ncp/session/a/sensor/x", "ncp/a/sensor/sensor/b"],
        &["ncp", "ncp/session/a", "session/a/sensor"],
        &[],
    ),
    pattern(
        "NCP-KEY-032",
        "**/a/**/b",
        &["a/b", "x/a/b", "a/x/b", "a/b/a/b", "a/a/b/b"],
        &["b/a", "a", "b", "a/b/c"],
        &[],
    ),
    pattern(
        "NCP-KEY-032",
        "**/a/b/**/c",
        &["a/b/c", "a/a/b/c", "a/b/a/b/c", "a/x/a/b/x/c"],
        &["a/x/b/c", "a/b", "b/c"],
        &[],
    ),
    pattern("NCP-KEY-032", "a/**/b/**/c", &["a/b/c", "a/b/b/c", "a/x/b/y/c"], &["a/c", "a/b", "a/c/b", "a/x/c"], &[]),
    pattern("NCP-KEY-032", "*/**", &["a", "a/b", "a/b/c"], &[], &["@a", "@a/b", "a/@b"]),
    pattern(
        "NCP-KEY-032",
        "ncp/session/*/**",
        &["ncp/session/a", "ncp/session/a/sensor", "ncp/session/a/sensor/front"],
        &["ncp/a/b"],
        &[],
    ),
    pattern("NCP-KEY-031", "ncp/session/*/**", &[], &["ncp/session"], &[]),
    pattern("NCP-KEY-032", "ncp/*/**/sensor", &["ncp/a/sensor", "ncp/a/b/c/sensor"], &["ncp/a"], &[]),
    pattern("NCP-KEY-031", "ncp/*/**/sensor", &[], &["ncp/sensor"], &[]),
    pattern("NCP-KEY-032", "**/sensor/*", &["sensor/front", "a/b/sensor/front"], &["a/b"], &["a/sensor/@front"]),
    pattern("NCP-KEY-031", "**/sensor/*", &[], &["a/sensor", "a/sensor/front/left"], &[]),
    pattern(
        "NCP-KEY-033",
        "ncp/session/uav$*/sensor",
        &["ncp/session/uav/sensor", "ncp/session/uav3/sensor", "ncp/session/uav-33/sensor"],
        &["ncp/session/ua/sensor", "ncp/session/xuav/sensor", "ncp/session/uav/3/sensor"],
        &[],
    ),
    pattern(
        "NCP-KEY-033",
        "ncp/session/$*3/sensor",
        &["ncp/session/3/sensor", "ncp/session/uav3/sensor", "ncp/session/33/sensor"],
        &["ncp/session/uav3x/sensor", "ncp/session/uav/sensor", "ncp/session/a/3/sensor"],
        &[],
    ),
    pattern("NCP-KEY-033", "u$*3", &["u3", "uav3", "u33"], &["u", "3", "u3x", "xu3", "u/3"], &[]),
    pattern("NCP-KEY-033", "a$*a", &["aa", "aba", "aaa"], &["a", "ab"], &[]),
    pattern("NCP-KEY-033", "ab$*ba", &["abba", "abxba"], &["aba", "ab"], &[]),
    pattern("NCP-KEY-033", "a$*b$*c", &["abc", "axbyc", "abcbc", "abbcc"], &["acb", "ab", "abcd", "a/b/c"], &[]),
    pattern("NCP-KEY-033", "$*av$*", &["av", "uav", "avx", "uav3"], &["ua", "a", "uv", "ua/v"], &[]),
    pattern("NCP-KEY-033", "a$*/**", &["a", "ab", "ab/c"], &["b", "ba/c"], &[]),
    pattern("NCP-KEY-033", "a/b$*", &["a/b", "a/bc"], &["a/b/c", "a/bc/d", "a"], &[]),
    pattern("NCP-KEY-033", "\u{e9}$*", &["\u{e9}", "\u{e9}a", "\u{e9}\u{1f681}"], &["e", "e\u{301}"], &[]),
    pattern("NCP-KEY-033", "ncp/$*x", &["ncp/x", "ncp/a@x"], &[], &["ncp/@x", "ncp/@ax"]),
    pattern("NCP-KEY-035", "@a", &["@a"], &["@b", "a", "@"], &[]),
    pattern("NCP-KEY-035", "@a/*", &["@a/b"], &["@b/b", "a/b"], &["@a/@b"]),
    pattern("NCP-KEY-035", "@a/**", &["@a", "@a/b", "@a/b/c"], &["@b/b"], &["@a/@b"]),
    pattern("NCP-KEY-035", "ncp/@a/**", &["ncp/@a", "ncp/@a/b"], &["ncp/a", "ncp/b/@a"], &[]),
    pattern("NCP-KEY-035", "**/@a", &["@a", "b/@a", "b/c/@a"], &["b/@b", "b"], &["@b/@a"]),
    pattern("NCP-KEY-035", "**/@a/**", &["@a", "b/@a/c"], &["b/@b/c"], &["@b/@a/c"]),
    pattern("NCP-KEY-035", "ncp/*/@a", &["ncp/b/@a"], &["ncp/b/@b"], &["ncp/@b/@a"]),
    pattern("NCP-KEY-031", "ncp/*/@a", &[], &["ncp/@a"], &[]),
];

/// Pairs of which one is no key expression.
const INVALID: &[(&str, &str, &str)] = &[
    ("empty-pattern", "", "ncp"),
    ("pattern-slash-first", "/ncp", "ncp"),
    ("pattern-slash-last", "ncp/", "ncp"),
    ("pattern-slash-twice", "ncp//rpc", "ncp/rpc"),
    ("pattern-star-after-letter", "ncp/a*", "ncp/ab"),
    ("pattern-star-before-letter", "ncp/*a", "ncp/ba"),
    ("pattern-double-star-after-letter", "ncp/a**", "ncp/ab"),
    ("pattern-double-star-before-letter", "**a", "ba"),
    ("pattern-three-stars", "***", "ncp"),
    ("pattern-dollar-alone", "ncp/a$", "ncp/a"),
    ("pattern-dollar-letter", "ncp/$a", "ncp/a"),
    ("pattern-hash", "ncp/#", "ncp/a"),
    ("pattern-question-mark", "ncp/a?c", "ncp/abc"),
    ("empty-key", "**", ""),
    ("key-slash-first", "**", "/ncp"),
    ("key-slash-last", "ncp/**", "ncp/"),
    ("key-slash-twice", "ncp/**", "ncp//rpc"),
    ("key-hash", "ncp/*", "ncp/a#"),
    ("key-question-mark", "ncp/*", "ncp/a?"),
];

#[cfg(test)]
mod tests {
    use super::*;
    use zenoh_keyexpr::keyexpr;

    #[test]
    fn zenoh_covers_the_same_keys() {
        for Pattern { pattern, covers, others, hidden, .. } in PATTERNS {
            let expression = keyexpr::new(*pattern).unwrap();
            let covered = |key: &str| expression.intersects(keyexpr::new(key).unwrap());
            for key in *covers {
                assert!(covered(key), "{pattern} {key}");
            }
            for key in others.iter().chain(*hidden) {
                assert!(!covered(key), "{pattern} {key}");
            }
        }
    }

    #[test]
    fn zenoh_finds_the_same_expressions_invalid() {
        for (what, pattern, key) in INVALID {
            assert!(keyexpr::new(*pattern).is_err() || keyexpr::new(*key).is_err(), "{what}");
        }
    }
}
