//! What cites the rules: a line of any text, and the functions of a Rust source file.
//!
//! A Rust file is taken apart by tokens, so that functions within `proptest!` and `macro_rules!` are
//! found as well as others; citations stand in comments, and are read from the lines.

use std::ops::RangeInclusive;

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

use crate::catalogue::is_id;

/// A function.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Function {
    /// Its name.
    pub name: String,
    /// The line of its `fn`, from 1.
    pub line: usize,
    /// What it is for.
    pub role: FunctionRole,
    /// Whether it is `pub`, without a restriction.
    pub public: bool,
    /// The rules that it cites, from the end of what stands before it to its own end.
    pub cites: Vec<Citation>,
    /// Whether the comments of what it stands in, an `impl`, a module or a macro, cite a rule.
    pub within_citing: bool,
}

/// What a function is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum FunctionRole {
    /// It is part of the program.
    Code,
    /// It is a test.
    Test,
    /// It is a test over random input.
    Property,
}

/// A rule that is named at a line.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Citation {
    /// The id of the rule.
    pub id: String,
    /// The line, from 1.
    pub line: usize,
}

/// A source file, taken apart.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct RustFile {
    /// Its functions in their order; those within another function belong to that one.
    pub functions: Vec<Function>,
    /// What is cited outside of functions, and not in tests: by constants, types and modules.
    pub elsewhere: Vec<Citation>,
}

impl RustFile {
    /// Takes a file apart. One that is not Rust has no functions, and cites as plain text does.
    #[must_use]
    pub fn read(text: &str) -> Self {
        let lines: Vec<&str> = text.lines().collect();
        let mut walk = Walk { lines: &lines, file: Self::default(), tests: Vec::new() };
        if let Ok(tokens) = text.parse::<TokenStream>() {
            let module = module_comment(&lines);
            let scope = Scope { citing: !cited_in(&lines, module).is_empty(), ..Scope::default() };
            walk.stream(tokens, 1, scope);
        }
        let Walk { mut file, tests, .. } = walk;
        file.elsewhere = cited_in(&lines, 1..=lines.len());
        let functions = &file.functions;
        file.elsewhere.retain(|citation| {
            let taken = |function: &Function| function.cites.contains(citation);
            !functions.iter().any(taken) && !tests.iter().any(|test| test.contains(&citation.line))
        });
        file
    }
}

/// Every rule that a text names, whatever its language.
#[must_use]
pub fn cited(text: &str) -> Vec<Citation> {
    let lines: Vec<&str> = text.lines().collect();
    cited_in(&lines, 1..=lines.len())
}

/// What a walk knows of the place where it is.
#[derive(Debug, Clone, Copy, Default)]
struct Scope {
    citing: bool,
    proptest: bool,
    test: bool,
}

struct Walk<'a> {
    lines: &'a [&'a str],
    file: RustFile,
    /// The lines of modules that are only built for tests.
    tests: Vec<RangeInclusive<usize>>,
}

impl Walk<'_> {
    /// Walks over the items of a file, a module, an `impl` or a macro. `first` is the line on which
    /// they begin.
    fn stream(&mut self, tokens: TokenStream, first: usize, scope: Scope) {
        let mut item = Item::at(first);
        let mut tokens = tokens.into_iter().peekable();
        while let Some(token) = tokens.next() {
            match token {
                TokenTree::Ident(word) if word == "fn" => {
                    if let Some(TokenTree::Ident(name)) = tokens.peek() {
                        item.function = Some((name.to_string(), word.span().start().line));
                    }
                }
                TokenTree::Ident(word) if word == "pub" => {
                    let restricted = matches!(tokens.peek(), Some(TokenTree::Group(group))
                        if group.delimiter() == Delimiter::Parenthesis);
                    item.public |= !restricted;
                }
                TokenTree::Ident(word) if word == "proptest" => item.proptest = true,
                TokenTree::Group(group) if group.delimiter() == Delimiter::Bracket => {
                    item.test |= is_test(&group);
                }
                TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => {
                    let end = group.span_close().end().line;
                    self.braces(&group, &item, scope);
                    item = Item::at(end + 1);
                }
                TokenTree::Punct(mark) if mark.as_char() == ';' => {
                    item = Item::at(mark.span().end().line + 1);
                }
                // The arm of a macro ends where the next one begins.
                TokenTree::Punct(mark) if mark.as_char() == ',' && item.function.is_none() => {
                    item.first = mark.span().end().line + 1;
                }
                _ => {}
            }
        }
    }

    fn braces(&mut self, group: &Group, item: &Item, scope: Scope) {
        let open = group.span_open().start().line;
        let close = group.span_close().end().line;
        if let Some((name, line)) = &item.function {
            let role = match (item.test, scope.proptest) {
                (true, true) => FunctionRole::Property,
                (true, false) => FunctionRole::Test,
                (false, _) if scope.test => return,
                (false, _) => FunctionRole::Code,
            };
            self.file.functions.push(Function {
                name: name.clone(),
                line: *line,
                role,
                public: item.public && !scope.test,
                cites: cited_in(self.lines, item.first..=close),
                within_citing: scope.citing,
            });
            return;
        }
        if item.test {
            self.tests.push(item.first..=close);
        }
        let scope = Scope {
            citing: scope.citing || !cited_in(self.lines, item.first..=open).is_empty(),
            proptest: scope.proptest || item.proptest,
            test: scope.test || item.test,
        };
        self.stream(group.stream(), open, scope);
    }
}

/// An item whose end has not come yet.
#[derive(Debug, Default)]
struct Item {
    /// The line after the end of the item before it.
    first: usize,
    function: Option<(String, usize)>,
    public: bool,
    proptest: bool,
    /// It is a test, or is only built for tests.
    test: bool,
}

impl Item {
    fn at(first: usize) -> Self {
        Self { first, ..Self::default() }
    }
}

/// Whether an attribute is `test`, or `cfg(test)`, or some other path that ends in `test`.
fn is_test(attribute: &Group) -> bool {
    let mut words = attribute.stream().into_iter();
    match (words.next(), words.next()) {
        (Some(TokenTree::Ident(word)), None) => word == "test",
        (Some(TokenTree::Ident(word)), Some(TokenTree::Group(condition))) => {
            word == "cfg"
                && condition
                    .stream()
                    .into_iter()
                    .next()
                    .is_some_and(|first| matches!(first, TokenTree::Ident(word) if word == "test"))
        }
        _ => false,
    }
}

/// The lines of the comment with which a file begins.
fn module_comment(lines: &[&str]) -> RangeInclusive<usize> {
    1..=lines.iter().take_while(|line| line.starts_with("//!")).count()
}

/// What lines name in brackets, from 1.
fn cited_in(lines: &[&str], range: RangeInclusive<usize>) -> Vec<Citation> {
    let (first, last) = (*range.start(), *range.end());
    let mut found = Vec::new();
    for (line, text) in (1..).zip(lines).take(last).skip(first.saturating_sub(1)) {
        let mut rest = *text;
        while let Some(at) = rest.find("NCP-") {
            let tail = rest.get(at..).unwrap_or_default();
            let end =
                tail.find(|c: char| !(c.is_ascii_uppercase() || c.is_ascii_digit() || c == '-')).unwrap_or(tail.len());
            let (id, after) = tail.split_at(end);
            if is_id(id) {
                found.push(Citation { id: id.to_owned(), line });
            }
            rest = after;
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn functions(text: &str) -> Vec<(String, FunctionRole, bool, Vec<String>, bool)> {
        let file = RustFile::read(text);
        let seen = file.functions.into_iter();
        seen.map(|function| {
            let cites = function.cites.into_iter().map(|citation| citation.id);
            (function.name, function.role, function.public, cites.collect(), function.within_citing)
        })
        .collect()
    }

    #[test]
    fn a_function_cites_what_stands_in_its_comments_and_its_body() {
        let text = "\
//! A module.

const X: u8 = 1; // [NCP-A-001]
// [NCP-A-002]
/// Does it. `[NCP-A-003]`
#[must_use]
pub const fn does(self) -> u8 {
    if true { 1 } else { 2 } // [NCP-A-004]
}
pub(crate) fn other() {}
";
        let cites = ["NCP-A-002", "NCP-A-003", "NCP-A-004"].map(str::to_owned);
        assert_eq!(
            functions(text),
            [
                ("does".into(), FunctionRole::Code, true, cites.to_vec(), false),
                ("other".into(), FunctionRole::Code, false, vec![], false),
            ]
        );
        let elsewhere = RustFile::read(text).elsewhere;
        assert_eq!(elsewhere, [Citation { id: "NCP-A-001".into(), line: 3 }]);
    }

    #[test]
    fn functions_of_macros_and_properties_are_found() {
        let text = "\
macro_rules! make { ($x:ident) => {
    /// [NCP-A-001]
    impl $x { pub fn made() {} }
}; }
proptest! {
    #![proptest_config(Config { cases: 4, ..Config::default() })]

    /// [NCP-A-002]
    #[test]
    fn it_holds(x in 0..3, y in any::<u8>()) { prop_assert!(true); }

    #[test]
    fn that_too(x in 0..3) {}
}
";
        let property = |name: &str, cites: &[&str]| {
            (
                name.to_owned(),
                FunctionRole::Property,
                false,
                cites.iter().map(|id| (*id).to_owned()).collect::<Vec<_>>(),
                false,
            )
        };
        assert_eq!(
            functions(text),
            [
                ("made".into(), FunctionRole::Code, true, vec![], true),
                property("it_holds", &["NCP-A-002"]),
                property("that_too", &[]),
            ]
        );
    }

    #[test]
    fn what_tests_cite_is_not_the_codes() {
        let text = "\
/// [NCP-A-001]
pub struct S;

#[cfg(test)]
mod tests {
    // [NCP-A-002]
    fn helper() {}

    /// [NCP-A-003]
    #[test]
    fn it_does() {}
}
";
        assert_eq!(
            functions(text),
            [("it_does".to_owned(), FunctionRole::Test, false, vec!["NCP-A-003".to_owned()], false)]
        );
        let file = RustFile::read(text);
        assert_eq!(file.elsewhere.len(), 1);
    }

    #[test]
    fn only_whole_ids_count() {
        let ids: Vec<_> = cited("NCP-A-01 NCP-AB-012x [NCP-C-003] NCP-D-0045 NCP-e-001 xNCP-F-006")
            .into_iter()
            .map(|citation| citation.id)
            .collect();
        assert_eq!(ids, ["NCP-AB-012", "NCP-C-003", "NCP-F-006"]);
    }
}
