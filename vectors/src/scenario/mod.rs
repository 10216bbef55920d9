//! Scenario text: the tables of cases in `scenarios/<area>/<name>.txt`, a row a case.
//!
//! A file is a list of groups. A group begins with `[name]`, goes on with what its rows share, a `key: value` a line,
//! and after an empty line has its rows. A row is a line of cells with two spaces or more between them: its name, which
//! ends the case's path, and the cells that `columns` names. Lines that are indented belong to the row above them and
//! are its body, what happens in the case; the cell `event` is a body that stands in the row itself. A line that
//! begins with `#` is a comment.
//!
//! | key | meaning |
//! |---|---|
//! | `columns` | the cells behind a row's name; `rules title` if it is not given |
//! | `path` | the path of a case; `<group>/{row}` if it is not given |
//! | `event` | the body of each row that has none of its own |
//! | `rules`, `flags`, `title`, `why` | as in a case; `rules` and `flags` with commas between, `title` unless a cell |
//! | `each x` | a list of values with commas between: all rows for the first value, then all for the second |
//! | `with x` | the same, but each row for all values before the next row |
//!
//! A value of a list may have a name before it, as in `none=0`, and parts, as in `down=5:4`. `{x}` stands for the
//! value of
//! `x`, `{x.name}` for its name, `{x.first}` for its first part; `{row}` for a row's name and `{cell}` for one of its
//! cells; `{x:spaced}` has spaces for the hyphens, and `{{` is a brace, `{hyphen}` a hyphen, `{x:a}` and `{x:an}` are
//! `x` with its article. `{version}` is the wire
//! version, `{older}` and `{newer}` are the minors
//! beside it, `{major}` and `{minor}` its parts, `{minor-wraps-at-8}` the minor and 2^8; `{hash}` is the contract
//! hash. A row, a rule or a flag that ends in `@value` is for that value alone, a row also in `@one/other`.
//!
//! What a body says is the affair of the code that makes the group's cases, as the README of the crate shows; most are
//! [`Step`]s with semicolons between.

mod format;

use std::collections::VecDeque;

use ncp_text::{CONTRACT_HASH, WIRE_VERSION};

use crate::case::{Case, Role};
use crate::roles::a;
pub use format::formatted;

/// What is wrong with a line of scenario text.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("vectors/scenarios/{file}.txt:{line}: {fault}")]
pub struct ScenarioError {
    /// The file, such as `resilience/buffer`.
    pub file: &'static str,
    /// The line, from 1.
    pub line: usize,
    /// What is wrong with it.
    pub fault: Fault,
}

/// What can be wrong with a line.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Fault {
    /// A row or a key stands before the first group.
    #[error("there is no group yet; it begins with `[name]`")]
    NoGroup,
    /// A line above the rows has another form.
    #[error("`{0}` is no `key: value`, and rows begin behind an empty line")]
    NoKey(String),
    /// A key that no group has.
    #[error("`{0}` is no key of a group")]
    UnknownKey(String),
    /// A row has another number of cells than its group.
    #[error("the row has {found} cells, and its group has the columns name {columns}")]
    Cells {
        /// How many there are.
        found: usize,
        /// What they should be.
        columns: String,
    },
    /// A body without a row above it.
    #[error("there is no row above this body")]
    NoRow,
    /// A placeholder of something that is not there.
    #[error("`{{{0}}}` stands for nothing here")]
    Placeholder(String),
    /// A row lacks a cell, a body or a key of its group.
    #[error("the row has no {0}")]
    Missing(&'static str),
    /// A word that has no meaning where it stands.
    #[error("`{word}` is no {wanted}")]
    Word {
        /// The word.
        word: String,
        /// What should stand there.
        wanted: &'static str,
    },
    /// The code asks for another group than the next one.
    #[error("the group `{wanted}` should stand here")]
    Group {
        /// The group that the code makes next.
        wanted: &'static str,
    },
    /// A group that no code makes cases of.
    #[error("nothing makes cases of this group")]
    Unused,
}

/// A scenario file.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Source {
    /// Its path below `scenarios/`, without the ending.
    pub(crate) file: &'static str,
    pub(crate) text: &'static str,
}

/// The scenario file of that path.
macro_rules! source {
    ($file:literal) => {
        $crate::scenario::Source {
            file: $file,
            text: include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/scenarios/", $file, ".txt")),
        }
    };
}
pub(crate) use source;

/// Where something stands.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    file: &'static str,
    line: usize,
}

impl Place {
    /// The error of this place.
    pub(crate) fn fault(self, fault: Fault) -> ScenarioError {
        ScenarioError { file: self.file, line: self.line, fault }
    }

    /// The error of a word of this place.
    pub(crate) fn wants(self, wanted: &'static str, word: &str) -> ScenarioError {
        self.fault(Fault::Word { word: word.to_owned(), wanted })
    }
}

/// The groups of a file that are still to be made cases of.
#[derive(Debug)]
pub(crate) struct Scenarios {
    groups: VecDeque<Group>,
    end: Place,
}

impl Scenarios {
    /// Reads a file.
    pub(crate) fn read(source: Source) -> Result<Self, ScenarioError> {
        let mut groups: VecDeque<Group> = VecDeque::new();
        let mut is_header = false;
        let mut place = Place { file: source.file, line: 0 };
        for (line, text) in (1..).zip(source.text.lines()) {
            place.line = line;
            if text.starts_with('#') {
                continue;
            }
            if let Some(name) = text.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
                groups.push_back(Group::new(name, place));
                is_header = true;
                continue;
            }
            if text.is_empty() {
                is_header = false;
                continue;
            }
            let group = groups.back_mut().ok_or(place.fault(Fault::NoGroup))?;
            if is_header {
                group.key(text, place)?;
            } else {
                group.row(text, place)?;
            }
        }
        Ok(Self { groups, end: place })
    }

    /// The rows of the next group, which has to have that name, once for each of its values.
    pub(crate) fn rows(&mut self, name: &'static str) -> Result<Vec<Row>, ScenarioError> {
        let group = self.groups.pop_front().ok_or(self.end.fault(Fault::Group { wanted: name }))?;
        if group.name != name {
            return Err(group.place.fault(Fault::Group { wanted: name }));
        }
        group.expanded()
    }

    /// The cases of the next group, each made of its row.
    pub(crate) fn cases(
        &mut self,
        name: &'static str,
        make: impl Fn(&Row) -> Result<Case, ScenarioError>,
    ) -> Result<Vec<Case>, ScenarioError> {
        self.rows(name)?.iter().map(make).collect()
    }

    /// The cases of all groups that are left.
    pub(crate) fn rest(
        mut self,
        make: impl Fn(&Row) -> Result<Case, ScenarioError>,
    ) -> Result<Vec<Case>, ScenarioError> {
        let groups = std::mem::take(&mut self.groups);
        let rows = groups.into_iter().map(Group::expanded).collect::<Result<Vec<_>, _>>()?;
        rows.iter().flatten().map(make).collect()
    }

    /// Makes sure that no group is left.
    pub(crate) fn end(mut self) -> Result<(), ScenarioError> {
        self.groups.pop_front().map_or(Ok(()), |group| Err(group.place.fault(Fault::Unused)))
    }
}

/// A group as it is written.
#[derive(Debug)]
struct Group {
    name: &'static str,
    place: Place,
    columns: Vec<&'static str>,
    path: Option<&'static str>,
    rules: Vec<&'static str>,
    flags: Vec<&'static str>,
    title: &'static str,
    why: &'static str,
    event: &'static str,
    each: Vec<Variable>,
    with: Vec<Variable>,
    rows: Vec<RawRow>,
}

/// What stands for several values: its name, and the values with their names.
type Variable = (&'static str, Vec<(&'static str, &'static str)>);

#[derive(Debug)]
struct RawRow {
    place: Place,
    name: &'static str,
    only: Option<&'static str>,
    cells: Vec<&'static str>,
    body: String,
}

impl Group {
    fn new(name: &'static str, place: Place) -> Self {
        Self {
            name,
            place,
            columns: vec!["rules", "title"],
            path: None,
            rules: Vec::new(),
            flags: Vec::new(),
            title: "{title}",
            why: "",
            event: "",
            each: Vec::new(),
            with: Vec::new(),
            rows: Vec::new(),
        }
    }

    fn key(&mut self, line: &'static str, place: Place) -> Result<(), ScenarioError> {
        let (key, value) = line.split_once(':').ok_or_else(|| place.fault(Fault::NoKey(line.to_owned())))?;
        let value = value.trim();
        match key.split_once(' ').unwrap_or((key, "")) {
            ("columns", "") => self.columns = value.split_whitespace().collect(),
            ("path", "") => self.path = Some(value),
            ("rules", "") => self.rules = list(value),
            ("flags", "") => self.flags = list(value),
            ("title", "") => self.title = value,
            ("why", "") => self.why = value,
            ("event", "") => self.event = value,
            ("each", name) => self.each.push((name, named(value))),
            ("with", name) => self.with.push((name, named(value))),
            _ => return Err(place.fault(Fault::UnknownKey(key.to_owned()))),
        }
        Ok(())
    }

    fn row(&mut self, line: &'static str, place: Place) -> Result<(), ScenarioError> {
        if line.starts_with(' ') {
            let body = &mut self.rows.last_mut().ok_or(place.fault(Fault::NoRow))?.body;
            if !body.is_empty() {
                body.push(' ');
            }
            body.push_str(line.trim());
            return Ok(());
        }
        let mut cells = cells(line);
        let name = cells.next().unwrap_or_default();
        let (name, only) = name.split_once('@').map_or((name, None), |(name, only)| (name, Some(only)));
        let cells: Vec<_> = cells.collect();
        if cells.len() != self.columns.len() {
            let columns = self.columns.join(" ");
            return Err(place.fault(Fault::Cells { found: cells.len() + 1, columns }));
        }
        self.rows.push(RawRow { place, name, only, cells, body: String::new() });
        Ok(())
    }

    fn expanded(self) -> Result<Vec<Row>, ScenarioError> {
        let mut rows = Vec::new();
        for outer in products(&self.each) {
            for row in &self.rows {
                for inner in products(&self.with) {
                    let values = [&outer[..], &inner[..]].concat();
                    if row.only.is_none_or(|only| only.split('/').any(|only| has(&values, only))) {
                        rows.push(self.expand(row, values)?);
                    }
                }
            }
        }
        Ok(rows)
    }

    fn expand(&self, row: &RawRow, values: Vec<Value>) -> Result<Row, ScenarioError> {
        let cells: Vec<_> = self.columns.iter().copied().zip(row.cells.iter().copied()).collect();
        let cell = |name: &str| cells.iter().find(|(known, _)| *known == name).map(|(_, text)| *text);
        let mut row = Row {
            place: row.place,
            name: row.name,
            path: String::new(),
            rules: meant(cell("rules").map_or(self.rules.clone(), list), &values),
            flags: meant(cell("flags").map_or(self.flags.clone(), list), &values),
            title: String::new(),
            why: String::new(),
            body: row.body.clone(),
            cells,
            values,
        };
        row.path = match self.path {
            Some(path) => row.fill(path)?,
            None => format!("{}/{}", self.name, row.name),
        };
        if !(self.title == "{title}" && row.cell("title").is_err()) {
            row.title = row.fill(self.title)?;
        }
        row.why = row.fill(row.cell("why").unwrap_or(self.why))?;
        let body = if row.body.is_empty() { row.cell("event").unwrap_or(self.event) } else { &row.body };
        row.body = row.fill(body)?;
        Ok(row)
    }
}

/// The values of some variables in one case: their names, the values' names, and the values.
type Value = (&'static str, &'static str, &'static str);

/// Every combination of the values of some variables, the last one changing first.
fn products(variables: &[Variable]) -> Vec<Vec<Value>> {
    let mut all = vec![Vec::new()];
    for (variable, values) in variables {
        all = all
            .iter()
            .flat_map(|before: &Vec<Value>| {
                values.iter().map(|(name, value)| [&before[..], &[(*variable, *name, *value)]].concat())
            })
            .collect();
    }
    all
}

/// Whether one of the values is that one, by its name or itself.
fn has(values: &[Value], wanted: &str) -> bool {
    values.iter().any(|(_, name, value)| *name == wanted || *value == wanted)
}

/// The items of a list without those that are for other values.
fn meant(items: Vec<&'static str>, values: &[Value]) -> Vec<&'static str> {
    let is_meant = |item: &'static str| match item.split_once('@') {
        Some((item, only)) => has(values, only).then_some(item),
        None => Some(item),
    };
    items.into_iter().filter_map(is_meant).collect()
}

/// The cells of a row: between them stand two spaces or more, and a hyphen alone is an empty one.
fn cells(line: &'static str) -> impl Iterator<Item = &'static str> {
    line.split("  ").map(str::trim).filter(|cell| !cell.is_empty()).map(|cell| if cell == "-" { "" } else { cell })
}

/// What has commas between; a hyphen alone is nothing.
fn list(text: &'static str) -> Vec<&'static str> {
    text.split(',').map(str::trim).filter(|item| !item.is_empty() && *item != "-").collect()
}

/// Values with their names before them, or with themselves for names.
fn named(text: &'static str) -> Vec<(&'static str, &'static str)> {
    list(text).into_iter().map(|item| item.split_once('=').unwrap_or((item, item))).collect()
}

/// A row for one combination of its group's values.
#[derive(Debug, Clone)]
pub(crate) struct Row {
    pub(crate) place: Place,
    /// Its name, the last part of most paths.
    pub(crate) name: &'static str,
    pub(crate) path: String,
    pub(crate) rules: Vec<&'static str>,
    pub(crate) flags: Vec<&'static str>,
    pub(crate) title: String,
    pub(crate) why: String,
    /// What is indented below the row, on one line.
    pub(crate) body: String,
    cells: Vec<(&'static str, &'static str)>,
    values: Vec<Value>,
}

impl Row {
    /// The case that the row describes, which still lacks its question and its answer.
    pub(crate) fn case(&self, roles: &[Role]) -> Case {
        Case::new(&self.path, &self.rules, roles).title(&self.title).flags(&self.flags).because(&self.why)
    }

    /// A cell, as it is written.
    pub(crate) fn cell(&self, column: &'static str) -> Result<&'static str, ScenarioError> {
        let cell = self.cells.iter().find(|(known, _)| *known == column);
        cell.map(|(_, text)| *text).ok_or(self.place.fault(Fault::Missing(column)))
    }

    /// The kind of frame that the row is about, which its group gives as a cell or for each of several.
    pub(crate) fn kind(&self) -> Result<&'static str, ScenarioError> {
        let value = self.values.iter().find(|(name, ..)| *name == "kind").map(|(.., value)| *value);
        value.map_or_else(|| self.cell("kind"), Ok)
    }

    /// The roles that its cell names.
    pub(crate) fn roles(&self) -> Result<Vec<Role>, ScenarioError> {
        let role = |name: &str| Role::parse(name).ok_or_else(|| self.place.wants("role", name));
        list(self.cell("roles")?).into_iter().map(role).collect()
    }

    /// A cell with its placeholders filled in.
    pub(crate) fn text(&self, column: &'static str) -> Result<String, ScenarioError> {
        self.fill(self.cell(column)?)
    }

    /// What happens, step by step.
    pub(crate) fn steps(&self) -> Vec<Step> {
        steps(&self.body, self.place)
    }

    /// The steps of a cell.
    pub(crate) fn steps_of(&self, column: &'static str) -> Result<Vec<Step>, ScenarioError> {
        Ok(steps(&self.text(column)?, self.place))
    }

    /// The text with what its placeholders stand for.
    pub(crate) fn fill(&self, text: &str) -> Result<String, ScenarioError> {
        self.filled(text, 0)
    }

    /// The text, which so many placeholders within each other have led to.
    fn filled(&self, text: &str, depth: usize) -> Result<String, ScenarioError> {
        let mut out = String::new();
        let mut rest = text;
        while let Some((before, inside)) = rest.split_once('{') {
            out.push_str(before);
            if let Some(after) = inside.strip_prefix('{') {
                out.push('{');
                rest = after;
                continue;
            }
            let is_word = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || matches!(c, '-' | '.' | ':');
            match inside.split_once('}') {
                Some((word, after))
                    if word.starts_with(|c: char| c.is_ascii_lowercase()) && word.chars().all(is_word) =>
                {
                    out.push_str(&self.stands_for(word, depth + 1)?);
                    rest = after;
                }
                _ => {
                    out.push('{');
                    rest = inside;
                }
            }
        }
        Ok(out + rest)
    }

    fn stands_for(&self, word: &str, depth: usize) -> Result<String, ScenarioError> {
        const DEEPEST: usize = 8;
        if depth > DEEPEST {
            return Err(self.place.fault(Fault::Placeholder(word.to_owned())));
        }
        if let Some(word) = word.strip_suffix(":spaced") {
            return Ok(self.stands_for(word, depth)?.replace('-', " "));
        }
        if let Some(word) = word.strip_suffix(":an") {
            return Ok(a(&self.stands_for(word, depth)?).replacen('A', "a", 1));
        }
        if let Some(word) = word.strip_suffix(":a") {
            return Ok(a(&self.stands_for(word, depth)?));
        }
        let (name, part) = word.split_once('.').unwrap_or((word, "value"));
        if let Some((_, of_value, value)) = self.values.iter().find(|(known, ..)| *known == name) {
            let parts = || value.split(':');
            let value = match part {
                "name" => of_value,
                "first" => parts().next().unwrap_or_default(),
                "second" => parts().nth(1).unwrap_or_default(),
                "third" => parts().nth(2).unwrap_or_default(),
                _ => value,
            };
            return self.filled(value, depth);
        }
        if let Some((_, cell)) = self.cells.iter().find(|(known, _)| *known == word) {
            return self.filled(cell, depth);
        }
        Ok(match word {
            "row" => self.name.to_owned(),
            "version" => WIRE_VERSION.to_owned(),
            "older" => beside(-1),
            "newer" => beside(1),
            "hyphen" => "-".to_owned(),
            "major" => parts(WIRE_VERSION).0.to_owned(),
            "minor" => parts(WIRE_VERSION).1.to_owned(),
            "hash" => CONTRACT_HASH.to_owned(),
            "hash-in-capitals" => CONTRACT_HASH.to_uppercase(),
            _ => {
                let wrapped = word.strip_prefix("minor-wraps-at-").and_then(|bits| bits.parse::<u32>().ok());
                let minor = parts(WIRE_VERSION).1.parse::<u128>().ok();
                let wrapped = wrapped.zip(minor).map(|(bits, minor)| (minor + (1 << bits)).to_string());
                wrapped.ok_or(self.place.fault(Fault::Placeholder(word.to_owned())))?
            }
        })
    }
}

/// The version whose minor is that much greater than one's own.
pub(crate) fn beside(by: i64) -> String {
    let (major, minor) = parts(WIRE_VERSION);
    format!("{major}.{}", minor.parse::<i64>().unwrap_or_default() + by)
}

/// A text of ASCII in full-width letters, which some readers take for the same.
pub(crate) fn full_width(text: &str) -> String {
    text.chars().map(|c| char::from_u32(u32::from(c) + 0xfee0).unwrap_or(c)).collect()
}

/// The major and the minor of a version.
pub(crate) fn parts(version: &str) -> (&str, &str) {
    version.split_once('.').unwrap_or((version, "0"))
}

fn steps(text: &str, place: Place) -> Vec<Step> {
    let steps = text.split(';').map(str::trim).filter(|step| !step.is_empty());
    steps.map(|step| Step { place, words: step.split_whitespace().map(str::to_owned).collect() }).collect()
}

/// A step of a body: words, of which those with an equals sign are settings.
#[derive(Debug, Clone)]
pub(crate) struct Step {
    pub(crate) place: Place,
    words: Vec<String>,
}

impl Step {
    /// The first word.
    pub(crate) fn verb(&self) -> &str {
        self.words.first().map_or("", String::as_str)
    }

    /// The word of that number behind the first.
    pub(crate) fn word(&self, nth: usize, wanted: &'static str) -> Result<&str, ScenarioError> {
        let word = self.words.get(nth + 1).map(String::as_str);
        word.ok_or(self.place.wants(wanted, &self.words.join(" ")))
    }

    /// The words behind the first.
    pub(crate) fn words(&self) -> impl Iterator<Item = &str> {
        self.words.iter().skip(1).map(String::as_str)
    }

    /// How often it happens, and the steps of a round: `x9` before a step repeats it, `x9 one & other` both by turns.
    pub(crate) fn repeated(self) -> (usize, Vec<Self>) {
        let Some(times) = self.verb().strip_prefix('x').and_then(|times| times.parse().ok()) else {
            return (1, vec![self]);
        };
        let round = self.tail();
        let steps = round.words.split(|word| word == "&");
        (times, steps.map(|words| Self { place: self.place, words: words.to_vec() }).collect())
    }

    /// The steps that it stands for: `go 1..60` is one for each number, as is every first word behind a verb that is a
    /// range.
    pub(crate) fn counted(self) -> Result<Vec<Self>, ScenarioError> {
        let range = self.words.get(1).and_then(|word| word.split_once(".."));
        let Some((first, last)) = range.map(|(first, last)| (first.to_owned(), last.to_owned())) else {
            return Ok(vec![self]);
        };
        let (first, last) = (self.place.integer(&first)?, self.place.integer(&last)?);
        let numbered = |number: i64| {
            let words = self.words.iter().enumerate();
            let words = words.map(|(nth, word)| if nth == 1 { number.to_string() } else { word.clone() });
            Self { place: self.place, words: words.collect() }
        };
        Ok((first..=last).map(numbered).collect())
    }

    /// The step up to a bar, and what stands behind it.
    pub(crate) fn halves(&self) -> (Self, String) {
        let bar = self.words.iter().position(|word| word == "|").unwrap_or(self.words.len());
        let (before, behind) = self.words.split_at(bar);
        (Self { place: self.place, words: before.to_vec() }, behind.get(1..).unwrap_or_default().join(" "))
    }

    /// The step without its first word.
    pub(crate) fn tail(&self) -> Self {
        Self { place: self.place, words: self.words.get(1..).unwrap_or_default().to_vec() }
    }
}

impl Place {
    /// A double by its digits, or one of `nan`, `inf`, `-inf` and `max`.
    pub(crate) fn double(self, word: &str) -> Result<f64, ScenarioError> {
        match word {
            "max" => Ok(f64::MAX),
            "-max" => Ok(-f64::MAX),
            _ => word.parse().map_err(|_| self.wants("number", word)),
        }
    }

    /// Doubles with commas between.
    pub(crate) fn doubles(self, word: &str) -> Result<Vec<f64>, ScenarioError> {
        word.split(',').filter(|item| !item.is_empty()).map(|item| self.double(item)).collect()
    }

    /// An integer.
    pub(crate) fn integer(self, word: &str) -> Result<i64, ScenarioError> {
        match word {
            "max" => Ok(9_007_199_254_740_991),
            "-max" => Ok(-9_007_199_254_740_991),
            _ => word.parse().map_err(|_| self.wants("integer", word)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const fn source(text: &'static str) -> Source {
        Source { file: "area/name", text }
    }

    /// What is said about the text.
    fn complaint(text: &'static str) -> String {
        let read = Scenarios::read(source(text));
        let rows = read.and_then(|mut scenarios| scenarios.rows("g").and_then(|rows| scenarios.end().map(|()| rows)));
        rows.map_or_else(|error| error.to_string(), |rows| format!("{rows:?}"))
    }

    #[test]
    fn a_row_is_a_case_for_each_value_and_has_what_its_group_says() {
        let text = "[g]\ncolumns: rules words\npath: {mode.name}/{row}\ntitle: {mode} is {words} in {version}.\n\
                    each mode: hold, none=-\nflags: f, g@none\nevent: {mode} 5\n\none  R-1,R-2  so\ntwo@none  R-1  -\n";
        let rows = Scenarios::read(source(text)).unwrap().rows("g").unwrap();
        let paths: Vec<_> = rows.iter().map(|row| row.path.as_str()).collect();
        assert_eq!(paths, ["hold/one", "none/one", "none/two"]);
        assert_eq!(rows[0].title, format!("hold is so in {WIRE_VERSION}."));
        assert_eq!((&rows[0].flags[..], &rows[1].flags[..]), (&["f"][..], &["f", "g"][..]));
        assert_eq!((rows[0].body.as_str(), rows[0].rules.len()), ("hold 5", 2));
    }

    #[test]
    fn every_fault_is_named_with_its_file_and_line() {
        let at = |line: usize, fault: &str| format!("vectors/scenarios/area/name.txt:{line}: {fault}");
        let table = [
            ("one  R  T\n", 1, "there is no group yet; it begins with `[name]`"),
            ("[g]\none  R  T\n", 2, "`one  R  T` is no `key: value`, and rows begin behind an empty line"),
            ("[g]\nwhat: x\n", 2, "`what` is no key of a group"),
            ("[g]\n\none  R\n", 3, "the row has 2 cells, and its group has the columns name rules title"),
            ("[g]\n\n    ask\n", 3, "there is no row above this body"),
            ("[g]\n\none  R  {nothing}\n", 3, "`{nothing}` stands for nothing here"),
            ("[g]\nwhy: {why}\ncolumns: why\n\none  {why}\n", 5, "`{why}` stands for nothing here"),
            ("[h]\n\none  R  T\n", 1, "the group `g` should stand here"),
            ("[g]\n\n[h]\n", 3, "nothing makes cases of this group"),
        ];
        for (text, line, fault) in table {
            assert_eq!(complaint(text), at(line, fault));
        }
    }

    #[test]
    fn a_version_beside_ones_own_differs_by_its_minor() {
        assert_eq!(beside(0), WIRE_VERSION);
        assert_ne!(beside(1), beside(-1));
    }
}
