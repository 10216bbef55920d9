//! The catalogue of rules, parsed from the normative text.
//!
//! A rule is one list item:
//!
//! ```text
//! - **[NCP-WIRE-007]** A receiver MUST reject a frame that … *(wire; all)*
//! ```
//!
//! Its lines after the first are indented by two spaces. The parser is strict: whatever looks like
//! a rule is one, or is an error with its file and line.

use std::collections::HashMap;
use std::fmt;

use thiserror::Error;

use crate::chapters::{CHAPTERS, Chapter};

/// Every rule of the text, in the text's order.
#[derive(Debug, Clone)]
pub struct Catalogue {
    requirements: Vec<Requirement>,
}

impl Catalogue {
    /// The rules of the text that this crate was built with.
    ///
    /// # Errors
    ///
    /// [`CatalogueError`] when the text is faulty; a test of this crate makes sure that it is not.
    pub fn load() -> Result<Self, CatalogueError> {
        Self::parse(&CHAPTERS)
    }

    /// The rules of some chapters.
    ///
    /// # Errors
    ///
    /// The first line that is a faulty rule, or repeats the id of another.
    pub fn parse(chapters: &[Chapter<'_>]) -> Result<Self, CatalogueError> {
        let mut requirements = Vec::<Requirement>::new();
        let mut seen = HashMap::<String, usize>::new();
        for chapter in chapters {
            for requirement in chapter.requirements()? {
                if let Some(&first) = seen.get(&requirement.id) {
                    let line = requirement.line;
                    let first = requirements.get(first).map(Requirement::place).unwrap_or_default();
                    return Err(chapter.fault(line, RuleProblem::RepeatedId { first }));
                }
                seen.insert(requirement.id.clone(), requirements.len());
                requirements.push(requirement);
            }
        }
        Ok(Self { requirements })
    }

    /// The rule of that id, such as `NCP-WIRE-007`.
    #[must_use]
    pub fn get(&self, id: &str) -> Option<&Requirement> {
        self.requirements.iter().find(|requirement| requirement.id == id)
    }

    /// All rules, in the text's order.
    #[must_use]
    pub fn requirements(&self) -> &[Requirement] {
        &self.requirements
    }

    /// All rules, in the text's order.
    pub fn iter(&self) -> std::slice::Iter<'_, Requirement> {
        self.requirements.iter()
    }
}

impl<'a> IntoIterator for &'a Catalogue {
    type Item = &'a Requirement;
    type IntoIter = std::slice::Iter<'a, Requirement>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

/// One rule.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Requirement {
    /// The id, such as `NCP-WIRE-007`.
    pub id: String,
    /// The sentence, in Markdown, white space folded.
    pub sentence: String,
    /// The first keyword of the sentence.
    pub keyword: Keyword,
    /// The level that it belongs to.
    pub level: Level,
    /// The roles that it binds, in the order of [`Role::ALL`]; never empty.
    pub roles: Vec<Role>,
    /// Eight hexadecimal digits that identify the sentence: those of its FNV-1a hash.
    pub digest: String,
    /// The chapter's file.
    pub file: &'static str,
    /// The heading under which it stands.
    pub section: String,
    /// The line of the file on which it begins, from 1.
    pub line: usize,
}

impl Requirement {
    /// The area: `WIRE` of `NCP-WIRE-007`.
    #[must_use]
    pub fn area(&self) -> &str {
        self.id.split('-').nth(1).unwrap_or_default()
    }

    /// Whether it binds a role.
    #[must_use]
    pub fn binds(&self, role: Role) -> bool {
        self.roles.contains(&role)
    }

    /// File and line, as an editor opens them.
    #[must_use]
    pub fn place(&self) -> String {
        format!("{}:{}", self.file, self.line)
    }
}

impl fmt::Display for Requirement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "[{}] {} ({}; ", self.id, self.sentence, self.level)?;
        if self.roles == Role::ALL {
            return f.write_str("all)");
        }
        for (nth, role) in self.roles.iter().enumerate() {
            write!(f, "{}{role}", if nth == 0 { "" } else { ", " })?;
        }
        f.write_str(")")
    }
}

/// A word of RFC 2119.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Keyword {
    /// Binding.
    Must,
    /// Binding.
    MustNot,
    /// Advice.
    Should,
    /// Advice.
    ShouldNot,
    /// Leave.
    May,
}

impl Keyword {
    /// All keywords.
    pub const ALL: [Self; 5] = [Self::Must, Self::MustNot, Self::Should, Self::ShouldNot, Self::May];

    /// As the text writes it.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Must => "MUST",
            Self::MustNot => "MUST NOT",
            Self::Should => "SHOULD",
            Self::ShouldNot => "SHOULD NOT",
            Self::May => "MAY",
        }
    }

    /// Whether a peer that differs does not conform: `MUST` and `MUST NOT`.
    #[must_use]
    pub const fn is_binding(self) -> bool {
        matches!(self, Self::Must | Self::MustNot)
    }

    /// The first keyword of a sentence.
    fn first_of(sentence: &str) -> Option<Self> {
        let words = sentence.split(|c: char| !c.is_alphanumeric());
        let mut words = words.filter(|word| !word.is_empty()).peekable();
        while let Some(word) = words.next() {
            match (word, words.peek() == Some(&"NOT")) {
                ("MUST", false) => return Some(Self::Must),
                ("MUST", true) => return Some(Self::MustNot),
                ("SHOULD", false) => return Some(Self::Should),
                ("SHOULD", true) => return Some(Self::ShouldNot),
                ("MAY", _) => return Some(Self::May),
                _ => {}
            }
        }
        None
    }
}

impl fmt::Display for Keyword {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

/// A level of conformance; each includes those below.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Level {
    /// Reads and writes what every peer of the wire does, and rejects what is malformed.
    Wire,
    /// Fails closed.
    Safety,
    /// Keeps the rules that change the wire.
    Strict,
}

impl Level {
    /// All levels, from the lowest.
    pub const ALL: [Self; 3] = [Self::Wire, Self::Safety, Self::Strict];

    /// As the text writes it.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Wire => "wire",
            Self::Safety => "safety",
            Self::Strict => "strict",
        }
    }

    /// The level of that name.
    #[must_use]
    pub fn parse(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|level| level.as_str() == name)
    }
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

/// A part that a peer plays.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Role {
    /// Opens sessions, reads sensors, sends commands.
    Commander,
    /// Sends sensors, obeys commands, fails safe.
    Body,
    /// Answers control RPC, runs the simulation, publishes observations.
    Server,
    /// Reads; never writes to the action plane.
    Observer,
}

impl Role {
    /// All roles.
    pub const ALL: [Self; 4] = [Self::Commander, Self::Body, Self::Server, Self::Observer];

    /// As the text writes it.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Commander => "commander",
            Self::Body => "body",
            Self::Server => "server",
            Self::Observer => "observer",
        }
    }

    /// The role of that name.
    #[must_use]
    pub fn parse(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|role| role.as_str() == name)
    }
}

impl fmt::Display for Role {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

/// A rule of the text that cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{file}:{line}: {problem}")]
pub struct CatalogueError {
    /// The chapter's file.
    pub file: &'static str,
    /// The line on which the rule begins, from 1.
    pub line: usize,
    /// What is wrong.
    pub problem: RuleProblem,
}

/// What is wrong with a rule.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum RuleProblem {
    /// A bold id stands elsewhere than at the beginning of a list item.
    #[error("a rule is a list item that begins with `- **[NCP-AREA-nnn]** `")]
    NotAListItem,
    /// The id is not of the form `NCP-AREA-nnn`.
    #[error("`{0}` is not of the form NCP-AREA-nnn")]
    Id(String),
    /// The same id stands elsewhere.
    #[error("the same id is at {first}")]
    RepeatedId {
        /// Where.
        first: String,
    },
    /// The rule does not end in level and roles.
    #[error("a rule ends in `*(level; roles)*`")]
    NoTag,
    /// The level is not one of the three.
    #[error("`{0}` is not a level: wire, safety or strict")]
    Level(String),
    /// A role is not one of the four, is repeated, or stands beside `all`.
    #[error("`{0}` is not `all` or a list of different roles: commander, body, server, observer")]
    Roles(String),
    /// The sentence is empty, or does not end in a full stop.
    #[error("a rule is one sentence with a full stop at its end")]
    NotASentence,
    /// The sentence has no keyword.
    #[error("the sentence has none of MUST, MUST NOT, SHOULD, SHOULD NOT, MAY")]
    NoKeyword,
}

impl Chapter<'_> {
    fn requirements(&self) -> Result<Vec<Requirement>, CatalogueError> {
        let mut requirements = Vec::new();
        let mut section = String::new();
        let mut in_fence = false;
        let mut lines = (1..).zip(self.text.lines()).peekable();
        while let Some((number, line)) = lines.next() {
            if line.trim_start().starts_with("```") {
                in_fence = !in_fence;
            }
            if in_fence || line.starts_with('>') {
                continue;
            }
            if line.starts_with('#') {
                section = line.trim_start_matches('#').trim().to_owned();
            }
            if !line.contains("**[") {
                continue;
            }
            let mut item = line.to_owned();
            while let Some((_, continuation)) = lines.next_if(|(_, next)| next.starts_with("  ")) {
                item.push(' ');
                item.push_str(continuation);
            }
            let rule = parse_rule(&item).map_err(|problem| self.fault(number, problem))?;
            requirements.push(Requirement { file: self.file, section: section.clone(), line: number, ..rule });
        }
        Ok(requirements)
    }

    fn fault(&self, line: usize, problem: RuleProblem) -> CatalogueError {
        CatalogueError { file: self.file, line, problem }
    }
}

/// Parses one list item; file, section and line are for the caller to fill in.
fn parse_rule(item: &str) -> Result<Requirement, RuleProblem> {
    let folded = item.split_whitespace().collect::<Vec<_>>().join(" ");
    let rule = folded.strip_prefix("- **[").filter(|_| item.starts_with("- "));
    let (id, rest) = rule.and_then(|r| r.split_once("]** ")).ok_or(RuleProblem::NotAListItem)?;
    if rest.contains("**[") {
        return Err(RuleProblem::NotAListItem);
    }
    if !is_id(id) {
        return Err(RuleProblem::Id(id.to_owned()));
    }
    let untagged = rest.strip_suffix(")*").and_then(|r| r.rsplit_once(" *("));
    let (sentence, tag) = untagged.ok_or(RuleProblem::NoTag)?;
    let (level, roles) = tag.split_once("; ").ok_or(RuleProblem::NoTag)?;
    let level = Level::parse(level).ok_or_else(|| RuleProblem::Level(level.to_owned()))?;
    let roles = parse_roles(roles).ok_or_else(|| RuleProblem::Roles(roles.to_owned()))?;
    if sentence.len() < 2 || !sentence.ends_with('.') {
        return Err(RuleProblem::NotASentence);
    }
    let keyword = Keyword::first_of(sentence).ok_or(RuleProblem::NoKeyword)?;
    Ok(Requirement {
        id: id.to_owned(),
        sentence: sentence.to_owned(),
        keyword,
        level,
        roles,
        digest: digest(sentence),
        file: "",
        section: String::new(),
        line: 0,
    })
}

/// Whether a text has the form of a rule's id: `NCP-AREA-nnn`.
#[must_use]
pub fn is_id(id: &str) -> bool {
    let mut parts = id.split('-');
    let mut next = || parts.next().unwrap_or_default();
    let (ncp, area, number) = (next(), next(), next());
    ncp == "NCP"
        && !area.is_empty()
        && area.bytes().all(|b| b.is_ascii_uppercase())
        && number.len() == 3
        && number.bytes().all(|b| b.is_ascii_digit())
        && parts.next().is_none()
}

fn parse_roles(list: &str) -> Option<Vec<Role>> {
    if list == "all" {
        return Some(Role::ALL.to_vec());
    }
    let mut roles = list.split(", ").map(Role::parse).collect::<Option<Vec<_>>>()?;
    let stated = roles.len();
    roles.sort_unstable();
    roles.dedup();
    (roles.len() == stated).then_some(roles)
}

/// The first digits of the sentence's FNV-1a hash, 64 bits.
fn digest(sentence: &str) -> String {
    const OFFSET_BASIS: u64 = 0xcbf2_9ce4_8422_2325;
    const PRIME: u64 = 0x0000_0100_0000_01b3;
    let hash = sentence.bytes().fold(OFFSET_BASIS, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(PRIME));
    let hash = format!("{hash:016x}");
    hash.chars().take(8).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &'static str) -> Result<Catalogue, CatalogueError> {
        Catalogue::parse(&[Chapter { file: "x.md", text }])
    }

    fn fault(text: &'static str) -> (usize, RuleProblem) {
        let error = parse(text).unwrap_err();
        assert_eq!(error.file, "x.md");
        (error.line, error.problem)
    }

    #[test]
    fn the_text_is_without_fault_and_every_chapter_is_listed() {
        let catalogue = Catalogue::load().unwrap_or_else(|fault| panic!("{fault}"));
        assert!(catalogue.requirements().len() > 100);
        let folder = env!("CARGO_MANIFEST_DIR");
        let mut files: Vec<_> = std::fs::read_dir(folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .filter(|name| name.ends_with(".md") && name != "README.md")
            .collect();
        files.sort();
        assert_eq!(files, CHAPTERS.map(|chapter| chapter.file));
    }

    #[test]
    fn a_rule_is_parsed_into_its_parts() {
        let catalogue = parse(
            "# 9. Test\n\n## 9.1 Part\n\ntext\n\n\
             - **[NCP-TEST-012]** A peer\n  SHOULD NOT  do `x`.\n  *(safety; server, commander)*\n- other\n",
        )
        .unwrap();
        let [rule] = catalogue.requirements() else { panic!("{catalogue:?}") };
        assert_eq!(rule.id, "NCP-TEST-012");
        assert_eq!(rule.sentence, "A peer SHOULD NOT do `x`.");
        assert_eq!(rule.keyword, Keyword::ShouldNot);
        assert_eq!(rule.level, Level::Safety);
        assert_eq!(rule.roles, [Role::Commander, Role::Server]);
        assert_eq!((rule.file, rule.section.as_str(), rule.line), ("x.md", "9.1 Part", 7));
        assert_eq!(rule.area(), "TEST");
        assert!(rule.binds(Role::Server) && !rule.binds(Role::Body));
        assert!(catalogue.get("NCP-TEST-012").is_some() && catalogue.get("NCP-TEST-013").is_none());
        assert_eq!(rule.to_string(), "[NCP-TEST-012] A peer SHOULD NOT do `x`. (safety; commander, server)");
    }

    #[test]
    fn the_keyword_is_the_first_one_of_the_sentence() {
        for (sentence, keyword) in [
            ("A peer MUST do x.", Some(Keyword::Must)),
            ("A peer MUST NOT do x.", Some(Keyword::MustNot)),
            ("When a peer MAY, it MUST.", Some(Keyword::May)),
            ("It SHOULD, and MUST NOT.", Some(Keyword::Should)),
            ("A peer SHOULD NOT.", Some(Keyword::ShouldNot)),
            ("MUSTARD and NOTHING and MAYBE.", None),
            ("a peer must do x.", None),
        ] {
            assert_eq!(Keyword::first_of(sentence), keyword, "{sentence}");
        }
    }

    #[test]
    fn white_space_does_not_change_the_digest_and_words_do() {
        let digest_of = |text| parse(text).unwrap().requirements()[0].digest.clone();
        let one = digest_of("- **[NCP-A-001]** A peer MUST do x. *(wire; all)*");
        assert_eq!(one, digest_of("- **[NCP-A-002]** A peer\n  MUST  do x. *(strict; body)*"));
        assert_ne!(one, digest_of("- **[NCP-A-001]** A peer MUST do y. *(wire; all)*"));
        assert!(one.len() == 8 && one.bytes().all(|b| b.is_ascii_hexdigit()));
    }

    #[test]
    fn a_faulty_rule_is_named_with_its_line() {
        use RuleProblem::*;
        assert_eq!(fault("\n- **[NCP-A-1]** A MUST. *(wire; all)*"), (2, Id("NCP-A-1".into())));
        assert_eq!(fault("- **[ncp-a-001]** A MUST. *(wire; all)*"), (1, Id("ncp-a-001".into())));
        assert_eq!(fault("- **[NCP-A-001]** A MUST."), (1, NoTag));
        assert_eq!(fault("- **[NCP-A-001]** A MUST. *(wire)*"), (1, NoTag));
        assert_eq!(fault("- **[NCP-A-001]** A MUST. *(wired; all)*"), (1, Level("wired".into())));
        for roles in ["", "pilot", "body, body", "all, body"] {
            let rule = format!("- **[NCP-A-001]** A MUST. *(wire; {roles})*");
            assert!(matches!(parse_rule(&rule), Err(Roles(_) | NoTag)), "{roles}");
        }
        assert_eq!(fault("- **[NCP-A-001]** A peer does. *(wire; all)*"), (1, NoKeyword));
        assert_eq!(fault("- **[NCP-A-001]** A peer MUST *(wire; all)*"), (1, NotASentence));
        assert_eq!(fault("  - **[NCP-A-001]** A MUST. *(wire; all)*"), (1, NotAListItem));
        assert_eq!(fault("**[NCP-A-001]** A MUST. *(wire; all)*"), (1, NotAListItem));
        assert_eq!(fault("- **[NCP-A-001** A MUST. *(wire; all)*"), (1, NotAListItem));
        assert_eq!(fault("- **[NCP-A-001]** A MUST. - **[NCP-A-002]** B MUST. *(wire; all)*"), (1, NotAListItem));
    }

    #[test]
    fn an_id_stands_once_in_the_whole_text() {
        let rule = "- **[NCP-A-001]** A MUST. *(wire; all)*\n";
        let error = Catalogue::parse(&[Chapter { file: "a.md", text: rule }, Chapter { file: "b.md", text: rule }])
            .unwrap_err();
        assert_eq!(error.to_string(), "b.md:1: the same id is at a.md:1");
    }

    #[test]
    fn quoted_and_fenced_examples_are_no_rules() {
        let catalogue = parse("> **[NCP-AREA-nnn]** A MUST …\n\n```\n- **[NCP-X-1]** y\n```\n").unwrap();
        assert!(catalogue.requirements().is_empty());
    }
}
