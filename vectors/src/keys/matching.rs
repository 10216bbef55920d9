//! Which keys a key expression covers.
//!
//! A test holds the tables against Zenoh's own `zenoh-keyexpr`.

use crate::case::Role::Observer;
use crate::case::{Case, File};
use crate::json::object;
use crate::scenario::{Row, ScenarioError, Scenarios, source};

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
    let about = "Which keys a key expression covers, wildcard by wildcard, and the chunks that wildcards do not see.";
    Ok(File::new("keys", "matching", about, cases))
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
    fn zenoh_finds_the_same_expressions_invalid() {
        let mut text = Scenarios::read(source!("keys/matching")).unwrap();
        patterns(&mut text).unwrap();
        for row in text.rows("invalid").unwrap() {
            let [pattern, key] = ["pattern", "key"].map(|column| row.cell(column).unwrap());
            assert!(keyexpr::new(pattern).is_err() || keyexpr::new(key).is_err(), "{}", row.name);
        }
    }
}
