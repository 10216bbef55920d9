//! Which keys a key expression covers.
//!
//! A test holds the tables against Zenoh's own `zenoh-keyexpr`.

use crate::case::Role::Observer;
use crate::case::{Case, File};
use crate::json::object;
use crate::scenario::{Row, ScenarioError, Scenarios, source};
use crate::template::Text;

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut text = Scenarios::read(source!("keys/matching"))?;
    let mut cases = Vec::new();
    for Pattern { rule, pattern, covers, others, hidden } in patterns(&mut text)? {
        let covered = covers.iter().map(|key| (key, true, rule));
        let others = others.iter().map(|key| (key, false, rule));
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
                .call("key.match", object! { "pattern" => pattern, "key" => *key })
                .gives(object! { "matches" => matches })
                .because(why(rule))
        }));
    }
    cases.extend(text.rest(invalid)?);
    cases.extend(large().iter().map(Large::case));
    cases.extend(controls());
    cases.extend(hidden());
    cases.extend(weightless());
    cases.extend(clusters());
    let about = "Which keys a key expression covers, wildcard by wildcard, and the chunks that wildcards do not see.";
    Ok(File::new("keys", "matching", about, cases))
}

/// Characters that are as good as any other, but end or break a line where an expression is made a regular one.
fn controls() -> Vec<Case> {
    let characters = [("line-feed", '\n'), ("carriage-return", '\r'), ("nul", '\0'), ("line-separator", '\u{2028}')];
    let table: [(&str, &'static str, &str, &str, bool); 14] = [
        ("equal", "NCP-KEY-030", "ncp/a%", "ncp/a%", true),
        ("one-more-at-the-end", "NCP-KEY-030", "ncp/a", "ncp/a%", false),
        ("one-less-at-the-end", "NCP-KEY-030", "ncp/a%", "ncp/a", false),
        ("one-more-within", "NCP-KEY-030", "ncp/a/b", "ncp/a%/b", false),
        ("alone-for-one", "NCP-KEY-031", "ncp/*/b", "ncp/%/b", true),
        ("within-one", "NCP-KEY-031", "*/b", "a%c/b", true),
        ("behind-one", "NCP-KEY-031", "*/b", "a/b%", false),
        ("within-any", "NCP-KEY-032", "ncp/**", "ncp/a%/b%c", true),
        ("behind-any", "NCP-KEY-032", "**/b", "a/b%", false),
        ("in-a-run", "NCP-KEY-033", "ncp/a$*b", "ncp/a%b", true),
        ("at-the-end-of-a-run", "NCP-KEY-033", "ncp/a$*", "ncp/a%", true),
        ("behind-a-run", "NCP-KEY-033", "ncp/$*3", "ncp/uav3%", false),
        ("behind-a-run-within", "NCP-KEY-033", "ncp/$*3/sensor", "ncp/uav3%/sensor", false),
        ("before-a-run", "NCP-KEY-033", "ncp/3$*", "ncp/%3a", false),
    ];
    let mut cases = Vec::new();
    for (word, character) in characters {
        for (name, rule, pattern, key, matches) in table {
            let spelled = |expression: &str| expression.replace('%', &character.to_string());
            let verb = if matches { "covers" } else { "does not cover" };
            cases.push(
                Case::new(format!("control/{word}/{name}"), &[rule], &[Observer])
                    .title(format!(
                        "`{pattern}` {verb} `{key}`, where % is a character that is not printed ({}).",
                        word.replace('-', " ")
                    ))
                    .flags(&[match rule {
                        "NCP-KEY-030" => "literal-patterns",
                        "NCP-KEY-033" => "partial-wildcards",
                        _ => "wildcards",
                    }])
                    .call("key.match", object! { "pattern" => spelled(pattern), "key" => spelled(key) })
                    .gives(object! { "matches" => matches })
                    .because("Matching takes a chunk of any length and of any other characters as it is."),
            );
        }
    }
    cases
}

/// Chunks of a pattern that begin with `@` and hold what is a wildcard elsewhere: they cover the equal chunk alone,
/// which no key has.
const HIDDEN: [(&str, &str, &[&str]); 5] = [
    ("run-behind", "@a$*", &["@a", "@ab"]),
    ("run-alone", "@$*", &["@a"]),
    ("run-before", "@$*a", &["@ba"]),
    ("within", "x/@$*/y", &["x/@a/y"]),
    ("behind-any", "**/@a$*", &["b/@ab"]),
];

fn hidden() -> Vec<Case> {
    let case = |name: &str, pattern: &str, key: &str| {
        Case::new(format!("hidden/{name}/{}", slug(key)), &["NCP-KEY-035"], &[Observer])
            .title(format!("`{pattern}` does not cover `{key}`."))
            .flags(&["hidden-segment"])
            .call("key.match", object! { "pattern" => pattern, "key" => key })
            .gives(object! { "matches" => false })
            .because("A chunk that begins with `@` has no wildcards: it covers the equal chunk alone.")
    };
    HIDDEN.into_iter().flat_map(|(name, pattern, keys)| keys.iter().map(move |key| case(name, pattern, key))).collect()
}

/// Chunks that begin with a character without weight, which a comparison by a language's customs passes over, and
/// go on with `@`.
fn weightless() -> Vec<Case> {
    let characters = [("soft-hyphen", '\u{ad}'), ("zero-width-joiner", '\u{200d}'), ("word-joiner", '\u{2060}')];
    let patterns =
        [("one", "NCP-KEY-031", "ncp/*"), ("any", "NCP-KEY-032", "ncp/**"), ("run", "NCP-KEY-033", "ncp/$*a")];
    let case = |(word, character): (&str, char), (name, rule, pattern): (&str, &'static str, &str)| {
        Case::new(format!("weightless/{word}/{name}"), &[rule], &[Observer])
            .title(format!("`{pattern}` covers a chunk that begins with a {} and then an @.", word.replace('-', " ")))
            .flags(&["hidden-segment"])
            .call("key.match", object! { "pattern" => pattern, "key" => format!("ncp/{character}@a") })
            .gives(object! { "matches" => true })
            .because("The chunk does not begin with `@`: keys are compared character by character.")
    };
    characters.into_iter().flat_map(|character| patterns.map(|pattern| case(character, pattern))).collect()
}

/// Runs that begin or end within what is seen as one character.
const CLUSTERS: [(&str, &str, &str); 6] = [
    ("accent-behind", "ncp/e$*", "ncp/e\u{301}x"),
    ("accent-last", "ncp/$*\u{301}", "ncp/e\u{301}"),
    ("accent-between", "ncp/a$*\u{301}$*b", "ncp/ae\u{301}b"),
    ("joined", "ncp/\u{1f469}$*", "ncp/\u{1f469}\u{200d}\u{1f680}"),
    ("flag", "ncp/$*\u{1f1ea}", "ncp/\u{1f1e9}\u{1f1ea}"),
    ("syllable", "ncp/\u{1100}$*", "ncp/\u{1100}\u{1161}\u{11a8}"),
];

fn clusters() -> [Case; 6] {
    CLUSTERS.map(|(name, pattern, key)| {
        Case::new(format!("cluster/{name}"), &["NCP-KEY-033"], &[Observer])
            .title(format!("`{pattern}` covers `{key}`, though the run is a part of what is seen as one character."))
            .flags(&["partial-wildcards"])
            .call("key.match", object! { "pattern" => pattern, "key" => key })
            .gives(object! { "matches" => true })
            .because("A `$*` covers any run of characters, and a character is a code point.")
    })
}

/// A pattern and a key of which one is large.
struct Large {
    name: &'static str,
    rule: &'static str,
    pattern: Text,
    key: Text,
    matches: bool,
    says: &'static str,
}

impl Large {
    fn case(&self) -> Case {
        let verb = if self.matches { "covers" } else { "does not cover" };
        Case::new(format!("large/{}", self.name), &[self.rule], &[Observer])
            .title(format!("{} {verb} the key.", self.says))
            .flags(&[if self.rule == "NCP-KEY-033" { "partial-wildcards" } else { "wildcards" }])
            .call("key.match", object! { "pattern" => self.pattern.json(), "key" => self.key.json() })
            .gives(object! { "matches" => self.matches })
            .because(why(self.rule))
    }
}

fn large() -> Vec<Large> {
    let chunks = |count: usize, last: &str| Text::concat(["ncp/".into(), Text::repeat("a/", count), last.into()]);
    let chunk = |count: usize, last: &str| Text::concat(["ncp/x".into(), Text::repeat("a", count), last.into()]);
    let row = |name, rule, pattern: Text, key, matches, says| Large { name, rule, pattern, key, matches, says };
    let (any, one, run) = ("NCP-KEY-032", "NCP-KEY-031", "NCP-KEY-033");
    // Twenty chunks that differ, as many `**` before them, and so many others before each in a key.
    let twenty = |before: &str, last: &str| {
        let chunks: String = ('a'..='t').map(|letter| format!("{before}{letter}/")).collect();
        Text::from(chunks + last)
    };
    // Ends of one letter, which may not share any of the key's.
    let chunk_of = |letters: usize| Text::concat(["ncp/".into(), Text::repeat("a", letters)]);
    let ends = |first: usize, last: usize| {
        Text::concat(["ncp/".into(), Text::repeat("a", first), "$*".into(), Text::repeat("a", last)])
    };
    // Letters that differ, with a wildcard between them.
    let letters = |between: &str, last: &str| {
        Text::from(('a'..='t').fold(String::new(), |all, c| all + between + &c.to_string()) + last)
    };
    vec![
        row("many-any", any, twenty("**/", "z"), twenty("", "z"), true, "A pattern of twenty `**` for no chunk each"),
        row("many-any-not", any, twenty("**/", "z"), twenty("", "y"), false, "A pattern of twenty `**` of another end"),
        row("many-runs", run, letters("$*", "z"), letters("", "z"), true, "A pattern of twenty `$*` for nothing each"),
        row(
            "many-runs-not",
            run,
            letters("$*", "z"),
            letters("", "y"),
            false,
            "A pattern of twenty `$*` of another end",
        ),
        row(
            "any-of-300",
            any,
            "ncp/**/z".into(),
            chunks(300, "z"),
            true,
            "A `**` before a last chunk behind 300 others",
        ),
        row("any-of-1025", any, "ncp/**/z".into(), chunks(1025, "z"), true, "A `**` before a last chunk behind 1,025"),
        row("any-of-1025-not", any, "ncp/**/z".into(), chunks(1025, "y"), false, "A `**` before another last chunk"),
        row("any-twice", any, "ncp/**/b/**/z".into(), chunks(300, "b/z"), true, "A `**` on both sides of a late chunk"),
        row(
            "ones",
            one,
            Text::concat(["ncp/".into(), Text::repeat("*/", 300), "z".into()]),
            chunks(300, "z"),
            true,
            "A pattern of 300 `*`",
        ),
        row(
            "ones-too-many",
            one,
            Text::concat(["ncp/".into(), Text::repeat("*/", 301), "z".into()]),
            chunks(300, "z"),
            false,
            "A pattern of a `*` more than the key has chunks",
        ),
        row("run-of-300", run, "ncp/x$*z".into(), chunk(300, "z"), true, "A `$*` in a chunk of 300 characters"),
        row("run-of-65537", run, "ncp/x$*z".into(), chunk(65_537, "z"), true, "A `$*` in a chunk of 65,537 characters"),
        row("run-of-65537-not", run, "ncp/x$*z".into(), chunk(65_537, "y"), false, "A `$*` before another last letter"),
        row(
            "between-runs-of-300",
            run,
            Text::concat(["ncp/x$*".into(), Text::repeat("a", 300), "b$*z".into()]),
            chunk(300, "bz"),
            true,
            "A pattern of 301 letters between two `$*`",
        ),
        row(
            "between-runs-of-300-not",
            run,
            Text::concat(["ncp/x$*".into(), Text::repeat("a", 300), "b$*z".into()]),
            chunk(300, "cz"),
            false,
            "A pattern of 301 letters between two `$*`, the last of which the key has otherwise,",
        ),
        row(
            "between-runs-of-70-not",
            run,
            Text::concat(["ncp/x$*b".into(), Text::repeat("a", 70), "$*z".into()]),
            Text::concat(["ncp/xb".into(), Text::repeat("a", 69), "cz".into()]),
            false,
            "A pattern of 71 letters between two `$*`, the last of which the key has otherwise,",
        ),
        row(
            "runs",
            run,
            Text::concat(["ncp/x".into(), Text::repeat("$*aa", 6), "$*z".into()]),
            chunk(12, "z"),
            true,
            "A pattern of six runs of two letters in a chunk that has just as many",
        ),
        row(
            "runs-too-many",
            run,
            Text::concat(["ncp/x".into(), Text::repeat("$*aa", 6), "$*z".into()]),
            chunk(11, "z"),
            false,
            "A pattern of six runs of two letters in a chunk that has a letter less",
        ),
        row("ends-of-255", run, ends(127, 128), chunk_of(254), false, "A `$*` between ends of 255 characters"),
        row("ends-of-256", run, ends(128, 128), chunk_of(200), false, "A `$*` between ends of 256 characters"),
        row("ends-of-256-whole", run, ends(128, 128), chunk_of(256), true, "A `$*` between ends of 256 characters"),
        row("ends-of-300", run, ends(200, 100), chunk_of(299), false, "A `$*` between ends of 300 characters"),
        row("ends-of-512", run, ends(256, 256), chunk_of(256), false, "A `$*` between ends of 512 characters"),
        row("ends-of-65536", run, ends(32_768, 32_768), chunk_of(32_769), false, "A `$*` between ends of 65,536"),
        row("equal-of-300", "NCP-KEY-030", chunk(300, "b"), chunk(300, "b"), true, "An equal chunk of 302 characters"),
        row("last-of-256", "NCP-KEY-030", chunk(254, "b"), chunk(254, "c"), false, "A chunk that differs in its 256th"),
        row("last-of-300", "NCP-KEY-030", chunk(298, "b"), chunk(298, "c"), false, "A chunk that differs in its 300th"),
        row(
            "last-of-4097",
            "NCP-KEY-030",
            chunk(4095, "b"),
            chunk(4095, "c"),
            false,
            "A chunk that differs at its end",
        ),
    ]
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
    covers: Vec<&'static str>,
    others: Vec<&'static str>,
    /// Keys that it would cover if wildcards saw the chunks that begin with `@`.
    hidden: Vec<&'static str>,
}

fn patterns(text: &mut Scenarios) -> Result<Vec<Pattern>, ScenarioError> {
    let pattern = |row: &Row| {
        let keys = |column| Ok(row.cell(column)?.split_whitespace().collect());
        Ok(Pattern {
            rule: row.name,
            pattern: row.cell("pattern")?,
            covers: keys("covers")?,
            others: keys("others")?,
            hidden: keys("hidden")?,
        })
    };
    text.rows("patterns")?.iter().map(pattern).collect()
}

fn invalid(row: &Row) -> Result<Case, ScenarioError> {
    let args = object! { "pattern" => row.cell("pattern")?, "key" => row.cell("key")? };
    Ok(row.case(&[Observer]).call("key.match", args).rejects("key"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use zenoh_keyexpr::keyexpr;

    #[test]
    fn zenoh_covers_the_same_keys() {
        let mut text = Scenarios::read(source!("keys/matching")).unwrap();
        for Pattern { pattern, covers, others, hidden, .. } in patterns(&mut text).unwrap() {
            let expression = keyexpr::new(pattern).unwrap();
            let covered = |key: &str| expression.intersects(keyexpr::new(key).unwrap());
            for key in covers {
                assert!(covered(key), "{pattern} {key}");
            }
            for key in others.iter().chain(&hidden) {
                assert!(!covered(key), "{pattern} {key}");
            }
        }
    }

    #[test]
    fn zenoh_covers_no_key_by_a_hidden_chunk_with_a_wildcard() {
        for (name, pattern, keys) in HIDDEN {
            let expression = keyexpr::new(pattern).unwrap();
            for key in keys {
                assert!(!expression.intersects(keyexpr::new(*key).unwrap()), "{name} {key}");
            }
        }
    }

    #[test]
    fn zenoh_covers_a_run_within_a_cluster() {
        for (name, pattern, key) in CLUSTERS {
            assert!(keyexpr::new(pattern).unwrap().intersects(keyexpr::new(key).unwrap()), "{name}");
        }
    }

    #[test]
    fn zenoh_covers_the_same_large_keys() {
        for Large { name, pattern, key, matches, .. } in large() {
            let (pattern, key) = (pattern.expanded(), key.expanded());
            let covers = keyexpr::new(&pattern).unwrap().intersects(keyexpr::new(&key).unwrap());
            assert_eq!(covers, matches, "{name}");
        }
    }

    #[test]
    fn zenoh_finds_the_same_expressions_invalid() {
        let mut text = Scenarios::read(source!("keys/matching")).unwrap();
        patterns(&mut text).unwrap();
        for row in text.rows("invalid").unwrap() {
            let [pattern, key] = ["pattern", "key"].map(|column| row.cell(column).unwrap());
            assert!(keyexpr::new(pattern).is_err() || keyexpr::new(key).is_err(), "{}", row.name);
        }
    }
}
