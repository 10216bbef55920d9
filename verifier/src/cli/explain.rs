//! `ncp-verify explain`.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::sync::Arc;

use ncp_text::catalogue::Requirement;
use ncp_text::citations::{FunctionRole, RustFile, cited};
use ncp_text::exclusions::Exclusions;
use walkdir::WalkDir;

use super::workspace::Workspace;
use super::{CliError, print};
use crate::peer::excerpt;
use crate::report::{Exit, Style, wrap};
use crate::suite::{Case, Expect, Finding, Flag, Suite};

/// How many characters of an input are shown.
const SHOWN: usize = 800;
/// How many characters of a large input are shown, which its file says how to make.
const SHOWN_OF_LARGE: usize = 200;
/// How many ids are suggested for one that is not known.
const SUGGESTED: usize = 3;
/// How alike an id has to be to be suggested, from 0 to 1.
const ALIKE: f64 = 0.75;
/// Where the source tree cites rules: what stands there, the folder, and how the names of its files end.
const CITING: [(&str, &str, &str); 11] = [
    ("Code", "spec/kernel/src", "rs"),
    ("Code", "spec/src", "rs"),
    ("Code", "proto/src", "rs"),
    ("Code", "peers/python-pure/ncp_pure", "py"),
    ("Code", "peers/typescript/src", "ts"),
    ("Tests", "spec/tests", "rs"),
    ("Tests", "proto/tests", "rs"),
    ("Fuzz targets", "fuzz/bodies/src", "rs"),
    ("Proofs", "proofs", "rs"),
    ("Proofs", "proofs/machine", "py"),
    ("Planted defects", "defects", "toml"),
];
/// The live scenarios.
const LIVE: &str = "live/scenarios.toml";
/// What is said where an expectation leaves a refusal open.
const OR_REJECT: &str = "an error will do as well, unless its code is `internal`";

/// Explains a case, a rule or a flag: its text, its cases and, in a source tree, its code.
pub(super) fn explain(suite: &Suite, id: &str, style: Style) -> Result<Exit, CliError> {
    let mut page = Page { style, out: String::new() };
    let rule = suite.requirements().iter().find(|rule| rule.id.eq_ignore_ascii_case(id));
    let flag = suite.flags().find(|flag| flag.eq_ignore_ascii_case(id));
    if let Some(case) = suite.case(id) {
        page.case(case, suite);
        page.evidence(case.requirements.iter().map(|rule| rule.id.as_str()));
    } else if let Some(rule) = rule {
        page.rule(rule);
        page.evidence([rule.id.as_str()].into_iter());
        page.citing(suite, |case| case.requirements.iter().any(|cited| cited.id == rule.id));
    } else if let Some(flag) = flag {
        let flagged = |case: &Case| case.flags.iter().any(|known| known == flag);
        page.flag(flag, suite);
        let cited = |rule: &&Arc<Requirement>| {
            let cites = |case: &Case| case.requirements.iter().any(|cited| cited.id == rule.id);
            suite.cases().iter().any(|case| flagged(case) && cites(case))
        };
        page.rules(suite.requirements().iter().filter(cited));
        page.citing(suite, flagged);
    } else if let Some((id, finding)) = Finding::of(id) {
        page.finding(id, finding);
        page.paragraph(2, &format!("No case is flagged with this finding. {}", unseen(id).unwrap_or_default()));
        page.rules(suite.requirements().iter().filter(|rule| finding.rules.contains(&rule.id)));
    } else {
        return Err(CliError::Usage(unknown(suite, id)));
    }
    print(&page.out)?;
    Ok(Exit::Conformant)
}

/// Why no case shows a finding, as the source tree says: nothing can, or a live scenario does.
fn unseen(id: &str) -> Option<String> {
    let root = Workspace::here()?.root;
    let text = fs::read_to_string(root.join(Exclusions::FILE)).ok()?;
    match Exclusions::parse(&text).ok()?.findings.remove(id) {
        Some(excluded) => Some(excluded.why),
        None => Some(format!("Live scenarios are: see {LIVE}.")),
    }
}

/// Where the source tree cites one of these rules: by what stands there, each place once.
fn citing(root: &Path, rules: &[&str]) -> BTreeMap<&'static str, Vec<String>> {
    let mut places: BTreeMap<&str, Vec<String>> = BTreeMap::new();
    for (what, folder, extension) in CITING {
        let entries = WalkDir::new(root.join(folder)).sort_by_file_name().into_iter().filter_map(Result::ok);
        for entry in entries.filter(|entry| entry.path().extension().is_some_and(|own| own == extension)) {
            let Ok(text) = fs::read_to_string(entry.path()) else { continue };
            let file = entry.path().strip_prefix(root).unwrap_or(entry.path()).to_string_lossy().replace('\\', "/");
            let about = |id: &str| rules.contains(&id);
            let mut add = |what, line: usize, name: &str| {
                let known = places.entry(what).or_default();
                let place = format!("  {file}:{line} {name}").trim_end().to_owned();
                if !known.contains(&place) {
                    known.push(place);
                }
            };
            let loose = if extension == "rs" {
                let RustFile { functions, elsewhere } = RustFile::read(&text);
                for function in functions.iter().filter(|function| function.cites.iter().any(|one| about(&one.id))) {
                    let what = match function.role {
                        FunctionRole::Code => what,
                        FunctionRole::Test => "Tests",
                        FunctionRole::Property => "Properties",
                    };
                    add(what, function.line, &function.name);
                }
                elsewhere
            } else {
                cited(&text)
            };
            for citation in loose.iter().filter(|citation| about(&citation.id)) {
                add(what, citation.line, table_entry(&text, extension, citation.line));
            }
        }
    }
    places
}

/// The name of the entry of a table that a line belongs to; other files have none.
fn table_entry<'t>(text: &'t str, extension: &str, line: usize) -> &'t str {
    let names = text.lines().take(line).filter_map(|line| line.strip_prefix("name = \""));
    names.last().filter(|_| extension == "toml").map_or("", |name| name.trim_end_matches('"'))
}

struct Page {
    style: Style,
    out: String,
}

impl Page {
    fn line(&mut self, text: &str) {
        self.out.push_str(text);
        self.out.push('\n');
    }

    fn paragraph(&mut self, indent: usize, text: &str) {
        let space = " ".repeat(indent);
        let wrapped = wrap(text, self.style.width, &space, &space);
        self.line(&wrapped);
    }

    fn heading(&mut self, text: &str) {
        let text = self.style.bold(text);
        self.line("");
        self.line(&text);
    }

    fn case(&mut self, case: &Case, suite: &Suite) {
        let title = self.style.bold(&case.id);
        self.line(&title);
        self.paragraph(0, &case.title);
        let roles: Vec<&str> = case.roles.iter().map(|role| role.as_str()).collect();
        let weight = if case.binding { "decides the verdict" } else { "is advice" };
        self.paragraph(0, &format!("level {}, for {}, {weight}; {}", case.level, roles.join(", "), case.file));
        for need in &case.needs {
            let words = format!("asked only of a peer that claims {}", need.in_words());
            self.paragraph(0, &words);
        }
        self.heading(if case.requirements.len() == 1 { "Rule" } else { "Rules" });
        for rule in &case.requirements {
            self.rule(rule);
        }
        self.heading("Input");
        let shown = if case.is_large() { SHOWN_OF_LARGE } else { SHOWN };
        self.paragraph(2, &excerpt(format!("{{\"id\":1,{}", case.body()).as_bytes(), shown));
        if let Some(made) = case.made_of() {
            self.paragraph(2, &format!("made of {}", excerpt(made.as_bytes(), SHOWN)));
        }
        self.heading("Expected");
        for line in expectation(&case.expect) {
            self.paragraph(2, &line);
        }
        self.heading("Why");
        self.paragraph(2, &case.why);
        if !case.flags.is_empty() {
            self.heading(if case.flags.len() == 1 { "Flag" } else { "Flags" });
            for flag in &case.flags {
                self.flag(flag, suite);
            }
        }
    }

    fn rule(&mut self, rule: &Requirement) {
        let roles = if rule.roles.len() == 4 {
            "all".to_owned()
        } else {
            rule.roles.iter().map(|role| role.as_str()).collect::<Vec<_>>().join(", ")
        };
        let id = self.style.bold(&rule.id);
        self.line(&format!("  {id} {}, level {}, {roles}", rule.keyword, rule.level));
        self.paragraph(2, &rule.sentence);
        let place = format!("spec/text/{}, {}", rule.place(), rule.section);
        let place = self.style.dim(&wrap(&place, self.style.width, "  ", "  "));
        self.line(&place);
    }

    fn flag(&mut self, flag: &str, suite: &Suite) {
        if let Some((id, finding)) = Finding::of(flag) {
            return self.finding(id, finding);
        }
        let shown = self.style.bold(flag);
        let class = |flag: &Flag| format!(", a bug of the class \u{ab}{}\u{bb}", flag.class);
        let class = Flag::of(flag).map_or_else(String::new, class);
        self.line(&format!("  {shown}{class}"));
        for note in suite.notes(flag) {
            self.paragraph(2, note);
        }
        if let Some(flag) = Flag::of(flag) {
            self.paragraph(2, &format!("Effect: {}", flag.effect));
        }
    }

    fn finding(&mut self, id: &str, finding: &Finding) {
        let shown = self.style.bold(id);
        let breaks = if finding.wire_breaking { ", mended by the strict profile alone" } else { "" };
        self.line(&format!("  {shown}, an audited finding, severity {}{breaks}", finding.severity));
        let title = finding.title.chars().take(1).flat_map(char::to_uppercase).chain(finding.title.chars().skip(1));
        self.paragraph(2, &title.collect::<String>());
        self.paragraph(2, &format!("Required: {}.", finding.required));
    }

    /// Some rules, and where they are carried out and tested.
    fn rules<'r>(&mut self, rules: impl Iterator<Item = &'r Arc<Requirement>>) {
        let rules: Vec<_> = rules.collect();
        if rules.is_empty() {
            return;
        }
        self.heading("Rules");
        for rule in &rules {
            self.rule(rule);
        }
        self.evidence(rules.iter().map(|rule| rule.id.as_str()));
    }

    /// Where the source tree cites rules.
    fn evidence<'r>(&mut self, rules: impl Iterator<Item = &'r str>) {
        let Some(workspace) = Workspace::here() else {
            self.heading("Code");
            self.paragraph(2, "is shown within the source tree of the suite");
            return;
        };
        for (what, places) in citing(&workspace.root, &rules.collect::<Vec<_>>()) {
            self.heading(what);
            places.iter().for_each(|place| self.line(place));
        }
    }

    fn citing(&mut self, suite: &Suite, cites: impl Fn(&Case) -> bool) {
        let cases: Vec<&Case> = suite.with_describe().filter(|case| cites(case)).collect();
        self.heading(&match cases.len() {
            0 => "No case".to_owned(),
            1 => "1 case".to_owned(),
            many => format!("{many} cases"),
        });
        for case in cases {
            self.line(&format!("  {}", case.id));
            let title = self.style.dim(&wrap(&case.title, self.style.width, "    ", "    "));
            self.line(&title);
        }
    }
}

/// An expectation with how it is compared.
fn expectation(expect: &Expect) -> Vec<String> {
    let text = |text: &str| excerpt(text.as_bytes(), SHOWN);
    match expect {
        Expect::Reject(code) => {
            vec![format!("an error; the text suggests the code `{code}`, and any but `internal` will do")]
        }
        Expect::Accept => vec!["a result, whatever it holds".to_owned()],
        Expect::Json(value) => vec!["a result that is equal as a JSON value:".to_owned(), text(&value.expand())],
        Expect::Message { text: frame, ignore, or_reject } => {
            let mut lines = vec![
                "a result whose `text` is this message; the order of members, the spelling of numbers, null for \
                 absent and members left out that have their default do not count:"
                    .to_owned(),
                text(&frame.get()),
            ];
            if !ignore.is_empty() {
                lines.push(format!("what stands at {} does not count", ignore.join(", ")));
            }
            if *or_reject {
                lines.push(OR_REJECT.to_owned());
            }
            lines
        }
        Expect::Encoding(frame) => vec![
            "a result whose `text` has these members in this order, unset optionals null, integers spelled as \
             integers, doubles equal bit by bit; white space is free:"
                .to_owned(),
            text(&frame.get()),
        ],
        Expect::Bytes(bytes) => {
            let hex: Vec<String> = bytes.iter().take(256).map(|byte| format!("{byte:02x}")).collect();
            let more = if bytes.len() > 256 { " …" } else { "" };
            vec![format!("a result whose `block` is exactly these {} bytes:", bytes.len()), hex.join(" ") + more]
        }
        Expect::Columns(columns) => {
            let words = "a result whose `block` is a valid block that holds exactly these columns:";
            vec![words.to_owned(), text(&columns.expand())]
        }
        Expect::Pattern { shape, tolerance, or_reject } => {
            let mut lines = vec![
                "a result that has this shape; members of objects that it does not name are free, and null is as \
                 good as absent:"
                    .to_owned(),
                text(&shape.to_string()),
            ];
            if *tolerance > 0.0 {
                lines.push(format!("numbers may be off by {tolerance:e}, relatively, or by that much below 1"));
            }
            if *or_reject {
                lines.push(OR_REJECT.to_owned());
            }
            lines
        }
    }
}

/// What to say about an id that is not known.
fn unknown(suite: &Suite, id: &str) -> String {
    let lower = id.to_ascii_lowercase();
    let ids = suite.cases().iter().map(|case| case.id.as_str());
    let all = ids.chain(suite.requirements().iter().map(|rule| rule.id.as_str())).chain(suite.flags());
    let likeness = |known: &str| {
        let known = known.to_ascii_lowercase();
        let part = if lower.len() >= 3 && known.contains(&lower) { 0.2 } else { 0.0 };
        strsim::normalized_damerau_levenshtein(&known, &lower).max(strsim::jaro_winkler(&known, &lower) - 0.1) + part
    };
    let mut scored: Vec<(f64, &str)> =
        all.map(|known| (likeness(known), known)).filter(|(score, _)| *score >= ALIKE).collect();
    scored.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(b.1)));
    let nearest: Vec<&str> = scored.iter().take(SUGGESTED).map(|(_, known)| *known).collect();
    let head = format!("there is no case, rule or flag `{}`", excerpt(id.as_bytes(), 100));
    if nearest.is_empty() {
        return format!("{head}; ncp-verify list shows all");
    }
    format!("{head}; do you mean one of these?\n  {}", nearest.join("\n  "))
}
