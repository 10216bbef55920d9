//! The one-token changes of a source file: its tokens, and what may stand in the place of each.
//!
//! | token | what may stand there |
//! |---|---|
//! | operator | the others of its kind: comparison, logic, arithmetic, assignment, range |
//! | method of a number, of an option | the others of its kind: `lt`, `le`; `add`, `sub`; `is_some`, `is_none`; … |
//! | literal | 0, one more, one less, the double, the negative |
//! | `!`, `return`, `*`, `-`, `?` | nothing |
//! | the beginning of a condition | a `!` before it |
//! | `break`, `true`, `Ok`, `Some` … | `continue`, `false`, `Err`, `None` … |
//! | name of a local, a field, a method, a function, a variant | another one of the same kind in the same |
//! | | function, file or type |
//!
//! Most of the last do not compile; these are found out by the compiler. Left alone are comments, attributes, imports
//! and types: they decide nothing.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::str::FromStr;

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};

/// A change of one token.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Change {
    /// Where it begins in the text, in bytes.
    pub(crate) start: usize,
    /// What stands there.
    pub(crate) from: String,
    /// What is to stand there.
    pub(crate) to: String,
}

impl Change {
    /// The text with it.
    pub(crate) fn of(&self, text: &str) -> String {
        let mut text = text.to_owned();
        text.replace_range(self.start..self.start + self.from.len(), &self.to);
        text
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Word,
    Literal,
    Sign,
    Open,
    Close,
}

#[derive(Debug, Clone)]
struct Token {
    kind: Kind,
    text: String,
    range: Range<usize>,
    /// Which function it belongs to; 0 outside of all.
    function: usize,
}

/// Signs of several characters.
const JOINT: [&str; 19] =
    ["..=", "=>", "->", "::", "&&", "||", "==", "!=", "<=", ">=", "+=", "-=", "*=", "/=", "|=", "&=", "^=", "..", "<<"];

/// Tokens of which one may stand for another.
const KINDS: &[&[&str]] = &[
    &["&&", "||"],
    &["==", "!=", "<", "<=", ">", ">="],
    &["+", "-", "*", "/"],
    &["+=", "-=", "*=", "/="],
    &["|=", "&=", "^="],
    &["..", "..="],
    &["lt", "le"],
    &["add", "sub", "mul", "div"],
    &["min", "max"],
    &["sqrt", "abs", "cbrt"],
    &["floor", "ceil", "round", "trunc"],
    &["is_finite", "is_infinite", "is_nan"],
    &["is_some", "is_none"],
    &["is_ok", "is_err"],
    &["is_some_and", "is_none_or"],
    &["break", "continue"],
    &["true", "false"],
    &["Some", "None"],
    &["Ok", "Err"],
    &["EPSILON", "MIN_POSITIVE", "MAX"],
    &["NAN", "INFINITY", "MAX"],
    &["while", "if"],
    &["last", "first"],
];

/// Words that are no names of this file's.
const WORDS: [&str; 43] = [
    "as", "break", "const", "continue", "crate", "dyn", "else", "enum", "expect", "false", "fn", "for", "if", "impl",
    "in", "let", "loop", "match", "mod", "mut", "pub", "ref", "return", "self", "static", "struct", "super", "trait",
    "true", "type", "use", "where", "while", "bool", "usize", "f64", "i64", "u64", "str", "Self", "Option", "Result",
    "matches",
];

/// Variants of types that other files declare.
const VARIANTS: [(&str, &[&str]); 1] = [("Mode", &["Init", "Active", "Hold", "Estop"])];

/// The variants of each enum in a file.
pub(crate) fn variants(text: &str) -> BTreeMap<String, BTreeSet<String>> {
    let mut variants: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for (name, words) in VARIANTS {
        let words = words.iter().map(|word| (*word).to_owned());
        variants.insert(name.to_owned(), words.collect());
    }
    let tokens = tokens(text);
    let mut of: Option<(String, usize)> = None;
    let mut depth = 0_usize;
    for (nth, token) in tokens.iter().enumerate() {
        match token.kind {
            Kind::Open => depth += 1,
            Kind::Close => depth = depth.saturating_sub(1),
            Kind::Word => {
                let before = nth.checked_sub(1).and_then(|nth| tokens.get(nth));
                if before.is_some_and(|before| before.text == "enum") {
                    of = Some((token.text.clone(), depth + 1));
                } else if let Some((name, at)) = &of
                    && depth == *at
                    && before.is_some_and(|before| matches!(&*before.text, "{" | ","))
                {
                    let words = variants.entry(name.clone()).or_default();
                    words.insert(token.text.clone());
                } else if matches!(&*token.text, "struct" | "trait" | "impl" | "fn") && depth == 0 {
                    of = None;
                }
            }
            Kind::Literal | Kind::Sign => {}
        }
    }
    variants
}

/// All changes of one token that the grammar knows, in the order of the text.
pub(crate) fn changes(text: &str, variants: &BTreeMap<String, BTreeSet<String>>) -> Vec<Change> {
    let tokens = tokens(text);
    let names = Names::of(&tokens);
    let mut changes = BTreeSet::new();
    for (nth, token) in tokens.iter().enumerate() {
        let mut add = |to: &str| {
            if to != token.text {
                changes.insert(Change { start: token.range.start, from: token.text.clone(), to: to.to_owned() });
            }
        };
        for kind in KINDS.iter().filter(|kind| kind.contains(&&*token.text)) {
            kind.iter().for_each(|to| add(to));
        }
        if matches!(&*token.text, "!" | "return" | "*" | "-" | "?") {
            add("");
        }
        if token.kind == Kind::Literal {
            numbers(&token.text).iter().for_each(|to| add(to));
        }
        if token.kind == Kind::Word {
            for to in names.others(&tokens, nth, variants) {
                add(&to);
            }
        }
        if begins_condition(&tokens, nth) {
            changes.insert(Change { start: token.range.start, from: String::new(), to: "!".to_owned() });
        }
    }
    changes.into_iter().collect()
}

/// Other numbers in the place of a number.
fn numbers(text: &str) -> Vec<String> {
    let plain = text.replace('_', "");
    if let Ok(number) = plain.parse::<u64>() {
        let mut others = vec![0, number + 1, number * 2];
        others.extend(number.checked_sub(1));
        others.sort_unstable();
        others.dedup();
        return others.iter().map(u64::to_string).collect();
    }
    match plain.parse::<f64>() {
        Ok(number) => {
            let mut others = vec![0.0, number + 1.0, number - 1.0, number * 2.0];
            if number > 0.0 {
                others.push(-number);
            }
            others.sort_by(f64::total_cmp);
            others.dedup();
            let others = others.into_iter().filter(|other| other.to_bits() != number.to_bits());
            others.map(|other| format!("{other:?}")).collect()
        }
        Err(_) => Vec::new(),
    }
}

/// Whether a condition may begin here, so that a `!` may stand before it.
fn begins_condition(tokens: &[Token], nth: usize) -> bool {
    let is_term = tokens.get(nth).is_some_and(|token| {
        token.kind == Kind::Word && (!WORDS.contains(&&*token.text) || matches!(&*token.text, "self" | "matches"))
            || token.kind == Kind::Open && token.text == "("
    });
    let before = nth.checked_sub(1).and_then(|nth| tokens.get(nth));
    is_term
        && before.is_some_and(|before| {
            matches!(
                &*before.text,
                "if" | "while" | "return" | "&&" | "||" | "|=" | "=" | "=>" | "|" | "(" | "{" | "}" | ";" | ","
            )
        })
}

/// What a name is a name of.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
enum Role {
    Local(usize),
    Field,
    Method,
    Function,
    Constant,
    Variant(String),
}

/// The names of a file, by what they are names of.
struct Names(BTreeMap<Role, BTreeSet<String>>);

impl Names {
    fn of(tokens: &[Token]) -> Self {
        let mut names: BTreeMap<Role, BTreeSet<String>> = BTreeMap::new();
        for (nth, token) in tokens.iter().enumerate() {
            if let Some(role) = role(tokens, nth) {
                names.entry(role).or_default().insert(token.text.clone());
            }
        }
        Self(names)
    }

    fn others(&self, tokens: &[Token], nth: usize, variants: &BTreeMap<String, BTreeSet<String>>) -> BTreeSet<String> {
        let Some(role) = role(tokens, nth) else {
            return BTreeSet::new();
        };
        let mut others = self.0.get(&role).cloned().unwrap_or_default();
        if let Role::Variant(of) = &role {
            others.extend(variants.get(of).into_iter().flatten().cloned());
        }
        others
    }
}

fn role(tokens: &[Token], nth: usize) -> Option<Role> {
    let token = tokens.get(nth)?;
    if token.kind != Kind::Word || WORDS.contains(&&*token.text) {
        return None;
    }
    let text = |at: Option<usize>| at.and_then(|at| tokens.get(at)).map_or("", |token| &*token.text);
    let (before, after) = (text(nth.checked_sub(1)), text(Some(nth + 1)));
    let is_small = token.text.starts_with(|c: char| c.is_ascii_lowercase() || c == '_');
    let is_capital = token.text.len() > 1 && !token.text.contains(|c: char| c.is_ascii_lowercase());
    match (before, after) {
        ("fn" | "struct" | "enum" | "trait" | "impl" | "mod" | "'", _) | (_, "::" | "!") => None,
        (".", "(") => Some(Role::Method),
        (".", _) => Some(Role::Field),
        ("::", _) if !is_small => Some(Role::Variant(text(nth.checked_sub(2)).to_owned())),
        ("::", _) => None,
        (_, "(") if is_small => Some(Role::Function),
        _ if is_small && token.function > 0 => Some(Role::Local(token.function)),
        _ if is_capital => Some(Role::Constant),
        _ => None,
    }
}

/// The tokens of a file, without comments, attributes and imports; none for a text that has no tokens.
fn tokens(text: &str) -> Vec<Token> {
    let mut tokens = Vec::new();
    if let Ok(stream) = TokenStream::from_str(text) {
        flatten(stream, &mut tokens, &mut 0);
    }
    tokens
}

fn flatten(stream: TokenStream, tokens: &mut Vec<Token>, function: &mut usize) {
    let trees: Vec<TokenTree> = stream.into_iter().collect();
    let sign = |at: usize| match trees.get(at) {
        Some(TokenTree::Punct(sign)) => Some(sign.as_char()),
        _ => None,
    };
    let is_group = |at: usize| matches!(trees.get(at), Some(TokenTree::Group(_)));
    let mut at = 0;
    while let Some(tree) = trees.get(at) {
        let range = tree.span().byte_range();
        let mut push = |kind, text: String, range| {
            tokens.push(Token { kind, text, range, function: *function });
        };
        at += 1;
        match tree {
            // An attribute, or a comment that is one.
            TokenTree::Punct(first) if first.as_char() == '#' && is_group(at) => at += 1,
            TokenTree::Punct(first) if first.as_char() == '#' && sign(at) == Some('!') && is_group(at + 1) => {
                at += 2;
            }
            TokenTree::Punct(first) => {
                let (mut text, mut range) = (first.as_char().to_string(), range);
                let mut last = first;
                while last.spacing() == Spacing::Joint
                    && let Some(TokenTree::Punct(next)) = trees.get(at)
                    && JOINT.contains(&&*format!("{text}{}", next.as_char()))
                {
                    text.push(next.as_char());
                    range.end = next.span().byte_range().end;
                    (last, at) = (next, at + 1);
                }
                push(Kind::Sign, text, range);
            }
            TokenTree::Ident(word) if *word == "use" => {
                while at < trees.len() && sign(at) != Some(';') {
                    at += 1;
                }
            }
            TokenTree::Ident(word) => {
                if *word == "fn" {
                    *function += 1;
                }
                tokens.push(Token { kind: Kind::Word, text: word.to_string(), range, function: *function });
            }
            TokenTree::Literal(literal) => push(Kind::Literal, literal.to_string(), range),
            TokenTree::Group(group) => {
                let (open, close) = match group.delimiter() {
                    Delimiter::Parenthesis => ("(", ")"),
                    Delimiter::Brace => ("{", "}"),
                    Delimiter::Bracket => ("[", "]"),
                    Delimiter::None => ("", ""),
                };
                push(Kind::Open, open.to_owned(), group.span_open().byte_range());
                flatten(group.stream(), tokens, function);
                tokens.push(Token {
                    kind: Kind::Close,
                    text: close.to_owned(),
                    range: group.span_close().byte_range(),
                    function: *function,
                });
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all(text: &str) -> Vec<String> {
        let changes = changes(text, &variants("enum Reason { Estop, Other(u8) }"));
        changes.iter().map(|change| change.of(text)).collect()
    }

    #[test]
    fn operators_methods_literals_and_conditions_are_changed_one_at_a_time() {
        let all = all("fn f(a: S, b: S) -> bool { if a.lt(b) && self.k <= 8 { return true; } a.le(b) }");
        for wanted in [
            "fn f(a: S, b: S) -> bool { if a.le(b) && self.k <= 8 { return true; } a.le(b) }",
            "fn f(a: S, b: S) -> bool { if a.lt(b) || self.k <= 8 { return true; } a.le(b) }",
            "fn f(a: S, b: S) -> bool { if a.lt(b) && self.k < 8 { return true; } a.le(b) }",
            "fn f(a: S, b: S) -> bool { if a.lt(b) && self.k <= 9 { return true; } a.le(b) }",
            "fn f(a: S, b: S) -> bool { if !a.lt(b) && self.k <= 8 { return true; } a.le(b) }",
            "fn f(a: S, b: S) -> bool { if a.lt(b) && !self.k <= 8 { return true; } a.le(b) }",
            "fn f(a: S, b: S) -> bool { if b.lt(b) && self.k <= 8 { return true; } a.le(b) }",
            "fn f(a: S, b: S) -> bool { if a.lt(b) && self.k <= 8 { return false; } a.le(b) }",
            "fn f(a: S, b: S) -> bool { if a.lt(b) && self.k <= 8 {  true; } a.le(b) }",
        ] {
            assert!(all.iter().any(|text| text == wanted), "{wanted}: {all:#?}");
        }
    }

    #[test]
    fn comments_attributes_and_imports_are_left_alone() {
        let text = "//! a < b\nuse super::{a, b};\n#[cfg(a < 1)]\n/// a && b\nfn f() {} // 1 < 2\n";
        assert_eq!(all(text), Vec::<String>::new());
    }

    #[test]
    fn a_variant_gives_way_to_all_others_of_its_type() {
        let all = all("fn f() { Reason::Estop }");
        assert_eq!(all, ["fn f() { !Reason::Estop }", "fn f() { Reason::Other }"]);
    }
}
