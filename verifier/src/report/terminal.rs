//! A report on a terminal, or in a pipe.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use ncp_text::catalogue::Level;

use super::layout::{Style, wrap};
use super::model::{
    CaseReport, CrashLogReport, ExcuseReport, LevelReport, PeerReport, Report, RoleReport, State, TallyReport,
};
use crate::diagnosis::Suspect;
use crate::verdict::{self, Conclusion, Status};

/// How many failing cases a peer are shown in full, unless all are asked for.
const IN_FULL: usize = 8;
/// How many characters of what went over the wire are shown, unless all is asked for.
const WIRE_CHARS: usize = 320;
/// How many ids are listed where the cases themselves are not shown.
const LISTED: usize = 5;
/// The widest that a peer's name is in the table.
const NAME_CHARS: usize = 16;

/// How much to show.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Detail {
    /// The table, and the first failing cases in full.
    Normal,
    /// Everything.
    Verbose,
}

/// Renders a report for people: a table of peers, roles and levels, then what failed, rule by rule.
///
/// Why a peer could not be started is said when it happens; the table holds the first line of it.
#[must_use]
pub fn terminal(report: &Report, style: Style, detail: Detail) -> String {
    let mut page = Page { report, style, detail, out: String::new() };
    page.head();
    page.table();
    for peer in &report.peers {
        page.peer(peer);
    }
    page.verdict();
    page.out
}

struct Page<'r> {
    report: &'r Report,
    style: Style,
    detail: Detail,
    out: String,
}

impl Page<'_> {
    fn line(&mut self, text: &str) {
        self.out.push_str(text);
        self.out.push('\n');
    }

    /// A paragraph, indented and broken to the width.
    fn paragraph(&mut self, indent: usize, text: &str) {
        let space = " ".repeat(indent);
        let wrapped = wrap(text, self.style.width, &space, &space);
        self.line(&wrapped);
    }

    /// A paragraph after a short word, the lines after the first aligned with it.
    fn item(&mut self, indent: usize, word: &str, text: &str) {
        let first = format!("{}{word} ", " ".repeat(indent));
        let rest = " ".repeat(first.chars().count());
        let wrapped = wrap(text, self.style.width, &first, &rest);
        self.line(&wrapped);
    }

    fn head(&mut self) {
        let Report { asked, wire_version, .. } = self.report;
        let cases = plural(asked.cases, "case");
        let files = plural(asked.files, "file");
        self.paragraph(0, &format!("NCP {wire_version}, level {}: {cases} in {files}", asked.level));
        if asked.partial {
            let filters = asked.filters.join(", ");
            self.paragraph(0, &format!("only those that fit {filters}: a part of the cases shows no conformance"));
        }
        self.line("");
    }

    fn table(&mut self) {
        let mut levels: Vec<Level> = Vec::new();
        for level in self.report.peers.iter().flat_map(|peer| &peer.roles).flat_map(|role| &role.levels) {
            if !levels.contains(&level.level) {
                levels.push(level.level);
            }
        }
        let name_width =
            self.report.peers.iter().map(|peer| peer.name.chars().count()).max().unwrap_or(0).clamp(4, NAME_CHARS);
        let cells: Vec<usize> = levels
            .iter()
            .map(|level| {
                let found =
                    |role: &RoleReport| role.levels.iter().find(|l| l.level == *level).map(|l| cell(l).chars().count());
                self.report
                    .peers
                    .iter()
                    .flat_map(|peer| &peer.roles)
                    .filter_map(found)
                    .max()
                    .unwrap_or(0)
                    .max(level.as_str().len())
            })
            .collect();
        let one_line =
            name_width + 2 + ROLE_WIDTH + cells.iter().map(|width| width + 2).sum::<usize>() <= self.style.width;
        if one_line && !levels.is_empty() {
            let mut head = format!("{:name_width$}  {:ROLE_WIDTH$}", "peer", "role");
            for (level, width) in levels.iter().zip(&cells) {
                let _ = write!(head, "  {:width$}", level.as_str());
            }
            let head = self.style.bold(head.trim_end());
            self.line(&head);
        }
        for peer in &self.report.peers {
            let name: String = peer.name.chars().take(NAME_CHARS).collect();
            match peer.state {
                State::Checked => {
                    let mut shown = name.as_str();
                    for role in &peer.roles {
                        self.row(shown, name_width, role, one_line.then_some((&levels, &cells)));
                        shown = "";
                    }
                    if peer.roles.is_empty() {
                        let why = self.style.red("✗ no role was judged");
                        self.line(&format!("{name:name_width$}  {why}"));
                    }
                }
                State::Skipped => {
                    let word = format!("{name:name_width$}  SKIPPED");
                    self.unchecked(&word, peer.reason.as_deref().unwrap_or_default(), Style::yellow);
                }
                State::NotStarted => {
                    let word = format!("{name:name_width$}  NOT STARTED");
                    let reason = peer.reason.as_deref().unwrap_or_default();
                    self.unchecked(&word, reason.lines().next().unwrap_or_default(), Style::red);
                }
            }
        }
        self.line("");
    }

    fn unchecked(&mut self, word: &str, reason: &str, paint: fn(Style, &str) -> String) {
        let rest = " ".repeat(word.chars().count() + 1);
        for line in wrap(reason, self.style.width, &format!("{word} "), &rest).lines() {
            let painted = paint(self.style, line);
            self.line(&painted);
        }
    }

    fn row(&mut self, name: &str, name_width: usize, role: &RoleReport, table: Option<(&Vec<Level>, &Vec<usize>)>) {
        let head = format!("{name:name_width$}  {:ROLE_WIDTH$}", role.role.as_str());
        let Some((levels, widths)) = table else {
            // Too narrow for all levels side by side: one below the other.
            for (i, level) in role.levels.iter().enumerate() {
                let shown = if i == 0 { head.clone() } else { " ".repeat(head.chars().count()) };
                let painted = self.painted(level, 0);
                self.line(&format!("{shown}  {:6}  {painted}", level.level.as_str()));
            }
            return;
        };
        let mut line = head;
        for (level, width) in levels.iter().zip(widths) {
            line.push_str("  ");
            match role.levels.iter().find(|l| l.level == *level) {
                Some(level) => line.push_str(&self.painted(level, *width)),
                None => line.push_str(&format!("{:width$}", "-")),
            }
        }
        let line = line.trim_end().to_owned();
        self.line(&line);
    }

    fn painted(&self, level: &LevelReport, width: usize) -> String {
        let text = cell(level);
        let pad = " ".repeat(width.saturating_sub(text.chars().count()));
        let painted = match (level.conformant, level.as_expected) {
            (true, _) => self.style.green(&text),
            (false, true) => self.style.yellow(&text),
            (false, false) => self.style.red(&text),
        };
        painted + &pad
    }

    fn peer(&mut self, peer: &PeerReport) {
        let start = self.out.len();
        if peer.state != State::Checked {
            return;
        }
        let title = match &peer.description {
            Some(about) => {
                let own = if about.name == peer.name { String::new() } else { format!("{}: ", peer.name) };
                format!("{own}{} {} ({})", shown(&about.name), shown(&about.version), shown(&about.language))
            }
            None => peer.name.clone(),
        };
        let title = self.style.bold(&title);
        self.line(&title);
        let body = self.out.len();
        self.failures(peer);
        self.unsupported(peer);
        self.expected(peer);
        self.not_run(peer);
        self.advice(peer);
        self.run_notes(peer);
        if self.out.len() == body {
            // Nothing to say but what the table says.
            self.out.truncate(start);
        } else {
            self.line("");
        }
    }

    /// The failing cases but the unsupported ones, rule by rule.
    fn failures(&mut self, peer: &PeerReport) {
        let failing: usize = peer.broken.iter().map(|suspect| suspect.cases.len()).sum();
        if failing == 0 {
            return;
        }
        let verb = if failing == 1 { "fails" } else { "fail" };
        let total = plural(peer.totals.total, "case");
        let count = self.style.red(&format!("{failing} of {total} {verb}"));
        self.line(&format!("  {count}"));
        let limit = if self.detail == Detail::Verbose { usize::MAX } else { IN_FULL };
        let shown = shares(peer.broken.iter().map(|suspect| suspect.cases.len()), limit);
        let in_full: usize = shown.iter().sum();
        let mut rest: Vec<String> = Vec::new();
        for (Suspect { rule, cases }, shown) in peer.broken.iter().zip(shown) {
            if shown > 0 {
                self.line("");
                self.rule(rule, cases.len());
                for case in cases.iter().take(shown).filter_map(|place| peer.cases.get(*place)) {
                    self.case(case);
                }
            }
            if cases.len() > shown {
                rest.push(format!("{rule} ({})", cases.len() - shown));
            }
        }
        if !rest.is_empty() {
            self.line("");
            let more = failing - in_full;
            self.paragraph(2, &format!("and {more} more (--verbose shows them), for: {}", rest.join(", ")));
        }
    }

    fn rule(&mut self, id: &str, cases: usize) {
        let Some(rule) = self.report.rules.iter().find(|rule| rule.id == id) else {
            return self.line(&format!("  {id}"));
        };
        let title = self.style.bold(id);
        let place = self.style.dim(&format!("{}, {}, {}", rule.keyword.as_str(), rule.place, plural(cases, "case")));
        self.line(&format!("  {title} {place}"));
        self.paragraph(2, &rule.sentence);
    }

    fn case(&mut self, case: &CaseReport) {
        let mark = self.style.red("✗");
        self.line(&format!("    {mark} {} [{}]", case.id, case.outcome.as_str()));
        self.paragraph(6, &case.title);
        if case.rules.len() > 1 {
            self.item(6, "also about", &case.rules[1..].join(", "));
        }
        if let Some(what) = &case.what {
            self.item(6, "it", what);
        }
        for difference in &case.differences {
            self.paragraph(6, &difference.text);
        }
        if case.more_differences > 0 {
            self.paragraph(6, &format!("and {} more", plural(case.more_differences, "difference")));
        }
        if let (Some(_), Some(expected)) = (&case.what, &case.expected) {
            self.item(6, "expected", expected);
        }
        if let Some(request) = &case.request {
            self.wire("sent", request);
        }
        if let Some(answer) = &case.answer {
            self.wire("got ", answer);
        }
        if let Some(note) = &case.note {
            self.item(6, "note", note);
        }
        for line in case.log.iter().flat_map(|log| log.lines()) {
            let line = self.style.dim(&format!("| {line}"));
            self.line(&format!("      {line}"));
        }
    }

    fn wire(&mut self, word: &str, text: &str) {
        let most = if self.detail == Detail::Verbose { usize::MAX } else { WIRE_CHARS };
        let cut = text.char_indices().nth(most).map(|(at, _)| at);
        match cut {
            Some(at) => self.item(6, word, &format!("{}…", &text[..at])),
            None => self.item(6, word, text),
        }
    }

    /// The unsupported cases, call by call. Which rules they cite says little: the calls are what is lacking.
    fn unsupported(&mut self, peer: &PeerReport) {
        let mut calls: BTreeMap<&str, u64> = BTreeMap::new();
        for case in peer.cases.iter().filter(|case| is_unsupported(case)) {
            *calls.entry(case.call.as_str()).or_default() += 1;
        }
        if calls.is_empty() {
            return;
        }
        let total = thousands(calls.values().sum());
        let all = plural(peer.totals.total, "case");
        let title = format!("{total} of {all} are unsupported in roles that were judged");
        for line in wrap(&title, self.style.width, "  ", "  ").lines() {
            let painted = self.style.red(line);
            self.line(&painted);
        }
        let list: Vec<String> = calls.iter().map(|(call, count)| format!("{call} ({})", thousands(*count))).collect();
        self.paragraph(4, &list.join(", "));
    }

    /// The expected failures: what each entry excuses, and what is untrue about it.
    fn expected(&mut self, peer: &PeerReport) {
        let excused = peer.totals.expected_failures;
        if excused > 0 {
            let title = self.style.yellow(&format!("{} as expected", plural_verb(excused, "case fails", "cases fail")));
            self.line(&format!("  {title}"));
        }
        for excuse in peer.expected_failures.iter().filter(|excuse| excuse.cases > 0) {
            let reason = if excuse.reason.trim().is_empty() { "no reason is given" } else { &excuse.reason };
            self.item(4, &format!("{:>5}", thousands(excuse.cases as u64)), &format!("{}: {reason}", excuse.entry));
            if let Some(written) = excuse.written.filter(|_| excuse.too_broad) {
                let text = format!("it excused {} when it was written: it is too broad", plural(written, "case"));
                self.said(&text, 10, Style::yellow);
            }
        }
        for untrue in peer.expected_failures.iter().flat_map(ExcuseReport::untrue) {
            self.said(&untrue, 2, Style::red);
        }
    }

    /// A paragraph in a colour.
    fn said(&mut self, text: &str, indent: usize, paint: fn(Style, &str) -> String) {
        let space = " ".repeat(indent);
        for line in wrap(text, self.style.width, &space, &space).lines() {
            let painted = paint(self.style, line);
            self.line(&painted);
        }
    }

    fn not_run(&mut self, peer: &PeerReport) {
        let missed: Vec<&CaseReport> = peer.cases.iter().filter(|case| case.status == Status::NotRun).collect();
        if let Some(first) = missed.first() {
            let why = first.what.as_deref().unwrap_or_default();
            let title = self.style.red(&format!("{} not run", plural_verb(missed.len(), "case was", "cases were")));
            self.line(&format!("  {title}"));
            for (i, line) in why.lines().enumerate() {
                self.paragraph(if i == 0 { 4 } else { 6 }, line);
            }
        }
    }

    fn advice(&mut self, peer: &PeerReport) {
        let differing: usize = peer.advised.iter().map(|suspect| suspect.cases.len()).sum();
        if differing == 0 {
            return;
        }
        let title =
            format!("{} from a SHOULD, which fails nobody", plural_verb(differing, "case differs", "cases differ"));
        let title = self.style.yellow(&title);
        self.line(&format!("  {title}"));
        for Suspect { rule, cases } in &peer.advised {
            let cases = || cases.iter().filter_map(|place| peer.cases.get(*place));
            let sentence =
                self.report.rules.iter().find(|r| r.id == *rule).map(|r| r.sentence.clone()).unwrap_or_default();
            self.item(4, rule, &sentence);
            if self.detail == Detail::Verbose {
                for case in cases() {
                    self.case(case);
                }
            } else {
                let ids: Vec<&str> = cases().map(|case| case.id.as_str()).collect();
                self.ids(&ids);
            }
        }
    }

    fn ids(&mut self, ids: &[&str]) {
        let most = if self.detail == Detail::Verbose { usize::MAX } else { LISTED };
        for id in ids.iter().take(most) {
            self.line(&format!("      {id}"));
        }
        if ids.len() > most {
            self.line(&format!("      and {} more", ids.len() - most));
        }
    }

    fn run_notes(&mut self, peer: &PeerReport) {
        let Some(run) = &peer.run else { return };
        for note in &run.notes {
            self.item(2, "note:", note);
        }
        let noted: Vec<&CaseReport> =
            peer.cases.iter().filter(|case| case.note.is_some() && case.status == Status::Passed).collect();
        if self.detail == Detail::Verbose {
            for case in &noted {
                self.paragraph(2, &format!("note: {}: {}", case.id, case.note.as_deref().unwrap_or_default()));
            }
        }
        if run.faults > 0 {
            let times = plural(run.faults as usize, "time");
            let mut text = format!("its process ended out of turn {times}, and was started anew");
            if let Some(CrashLogReport { case, .. }) = &run.crash_log {
                text.push_str(&format!("; the whole log of {case} is in the result, at `crash_log`"));
            }
            self.item(2, "note:", &text);
        }
        if let Some(rate) = run.rate.as_ref().filter(|_| self.report.asked.repeat > 1 || self.detail == Detail::Verbose)
        {
            let count = plural_u64(rate.answers, "case");
            let a_second = thousands(rate.per_second as u64);
            let text = format!("{count} of up to 64 KiB in {:.2} s: {a_second} a second", rate.elapsed_s);
            self.item(2, "rate:", &text);
        }
    }

    fn verdict(&mut self) {
        let count = |states: &dyn Fn(&PeerReport) -> bool| self.report.peers.iter().filter(|peer| states(peer)).count();
        let checked = count(&|peer| peer.state == State::Checked);
        let conformant = count(&|peer| peer.conclusion == Some(Conclusion::Conformant));
        let as_expected = count(&|peer| peer.conclusion == Some(Conclusion::AsExpected));
        let skipped = count(&|peer| peer.state == State::Skipped);
        let not_started = count(&|peer| peer.state == State::NotStarted);
        let asked = self.report.asked.level;
        let is_judged_at_it = |peer: &&PeerReport| {
            let mut levels = peer.roles.iter().flat_map(|role| &role.levels);
            levels.any(|level| level.level == asked)
        };
        let peers = self.report.peers.iter();
        let checked_ones = peers.filter(|peer| peer.state == State::Checked);
        let judged = checked_ones.filter(is_judged_at_it).count();
        // Peers that are held to different levels have none in common to name.
        let level = if judged == checked || judged == 0 {
            format!("at level {asked}")
        } else {
            "at the level that each claims".to_owned()
        };
        let mut parts = vec![match (checked, conformant) {
            (0, _) => "no peer was checked".to_owned(),
            (1, 1) => format!("the peer conforms {level}"),
            (1, 0) => format!("the peer does not conform {level}"),
            (2, 2) => format!("both peers conform {level}"),
            (all, some) if all == some => format!("all {all} peers conform {level}"),
            (all, some) => format!("{some} of {all} peers conform {level}"),
        }];
        if as_expected > 0 {
            parts.push(format!("{as_expected} exactly as its expected failures say"));
        }
        if not_started > 0 {
            parts.push(format!("{not_started} could not be started"));
        }
        if skipped > 0 {
            parts.push(format!("{skipped} skipped and so not shown to conform"));
        }
        if self.report.asked.partial {
            parts.push("of all cases only a part was run".to_owned());
        }
        if self.report.interrupted {
            parts.push("the run was interrupted".to_owned());
        }
        let text = parts.join("; ");
        let good = self.report.exit_code == 0;
        for line in wrap(&text, self.style.width, "", "").lines() {
            let painted = if good { self.style.green(line) } else { self.style.red(line) };
            self.line(&painted);
        }
    }
}

/// The widest role's name.
const ROLE_WIDTH: usize = 9;

/// A role at a level: whether it conforms, and how many of the deciding cases pass.
fn cell(level: &LevelReport) -> String {
    let TallyReport { total, passed, advice, .. } = level.cases;
    let mark = match (level.conformant, level.as_expected) {
        (true, _) => '✓',
        (false, true) => '~',
        (false, false) => '✗',
    };
    if total == 0 {
        return format!("{mark} none of its own");
    }
    format!("{mark} {}/{}", thousands(passed as u64), thousands((total - advice) as u64))
}

/// How many of each group are shown when `room` are shown in all: one of each in turn, those that come first first.
fn shares(sizes: impl Iterator<Item = usize>, room: usize) -> Vec<usize> {
    let sizes: Vec<usize> = sizes.collect();
    let mut room = room.min(sizes.iter().sum());
    let mut shares = vec![0; sizes.len()];
    while room > 0 {
        for (share, size) in shares.iter_mut().zip(&sizes) {
            if *share < *size && room > 0 {
                *share += 1;
                room -= 1;
            }
        }
    }
    shares
}

/// Whether a case was answered by `unsupported`, and not expected to be.
fn is_unsupported(case: &CaseReport) -> bool {
    verdict::is_unsupported(case.outcome, case.status)
}

/// What a peer says about itself, made harmless.
fn shown(text: &str) -> String {
    crate::peer::excerpt(text.as_bytes(), 40)
}

pub(super) fn plural(count: usize, word: &str) -> String {
    plural_u64(count as u64, word)
}

fn plural_u64(count: u64, word: &str) -> String {
    format!("{} {word}{}", thousands(count), if count == 1 { "" } else { "s" })
}

pub(super) fn plural_verb(count: usize, one: &str, many: &str) -> String {
    format!("{} {}", thousands(count as u64), if count == 1 { one } else { many })
}

/// A number with a comma between thousands.
pub(super) fn thousands(number: u64) -> String {
    let digits = number.to_string();
    let mut out = String::with_capacity(digits.len() + 3);
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            out.push(',');
        }
        out.push(digit);
    }
    out
}

#[cfg(test)]
mod tests {
    use ncp_text::catalogue::Role;

    use super::super::model::{Asked, Corpus, Exit, Tool};
    use super::*;

    #[test]
    fn every_rule_shows_a_case_before_one_shows_two() {
        assert_eq!(shares([69, 3, 1].into_iter(), 8), [4, 3, 1]);
        assert_eq!(shares([2, 0, 9, 9, 9].into_iter(), 3), [1, 0, 1, 1, 0]);
        assert_eq!(shares([2, 1].into_iter(), usize::MAX), [2, 1]);
        assert!(shares([].into_iter(), 8).is_empty());
    }

    fn level(level: Level, passed: usize, failed: usize, conformant: bool) -> LevelReport {
        let cases = TallyReport { total: passed + failed + 2, passed, failed, advice: 2, ..TallyReport::default() };
        LevelReport { level, conformant, as_expected: conformant, cases }
    }

    fn report() -> Report {
        let role = |role, levels| RoleReport { role, claimed: true, levels };
        let skipped = "not on PATH: cmake, and without it nothing of this peer can be built or run".to_owned();
        let mut checked =
            PeerReport::unchecked("gateway".into(), "peers/gateway".into(), State::Checked, String::new());
        checked.conclusion = Some(Conclusion::NotConformant);
        checked.roles = vec![
            role(
                Role::Commander,
                vec![
                    level(Level::Wire, 2600, 0, true),
                    level(Level::Safety, 411, 1, false),
                    level(Level::Strict, 20, 0, false),
                ],
            ),
            role(Role::Observer, vec![level(Level::Wire, 900, 0, true)]),
        ];
        Report {
            format: 1,
            tool: Tool { name: "ncp-verify", version: "0" },
            started: String::new(),
            elapsed_s: 1.0,
            wire_version: "7.1",
            contract_hash: "",
            corpus: Corpus { files: 90, cases: 7000, sha256: String::new() },
            asked: Asked {
                level: Level::Strict,
                roles: Vec::new(),
                filters: Vec::new(),
                files: 80,
                cases: 6100,
                repeat: 1,
                partial: false,
            },
            interrupted: false,
            rules: Vec::new(),
            peers: vec![checked, PeerReport::unchecked("cpp".into(), "peers/cpp".into(), State::Skipped, skipped)],
            exit_code: Exit::NotConformant.code(),
        }
    }

    #[test]
    fn levels_stand_side_by_side_where_there_is_room() {
        let text = terminal(&report(), Style { colour: false, width: 80 }, Detail::Normal);
        insta::assert_snapshot!(text, @"
        NCP 7.1, level strict: 6,100 cases in 80 files

        peer     role       wire           safety     strict
        gateway  commander  ✓ 2,600/2,600  ✗ 411/412  ✗ 20/20
                 observer   ✓ 900/900      -          -
        cpp      SKIPPED not on PATH: cmake, and without it nothing of this peer can be
                         built or run

        the peer does not conform at level strict; 1 skipped and so not shown to conform
        ");
    }

    #[test]
    fn levels_stand_below_each_other_where_there_is_none() {
        let text = terminal(&report(), Style { colour: false, width: 44 }, Detail::Normal);
        insta::assert_snapshot!(text, @"
        NCP 7.1, level strict: 6,100 cases in 80
        files

        gateway  commander  wire    ✓ 2,600/2,600
                            safety  ✗ 411/412
                            strict  ✗ 20/20
                 observer   wire    ✓ 900/900
        cpp      SKIPPED not on PATH: cmake, and
                         without it nothing of this
                         peer can be built or run

        the peer does not conform at level strict; 1
        skipped and so not shown to conform
        ");
    }

    #[test]
    fn numbers_have_a_comma_between_thousands() {
        let written = [0, 7, 999, 1000, 12_345, 1_234_567].map(thousands);
        assert_eq!(written, ["0", "7", "999", "1,000", "12,345", "1,234,567"]);
    }
}
