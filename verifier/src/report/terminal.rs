//! A report on a terminal, or in a pipe.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use ncp_text::catalogue::Level;

use super::exchange;
use super::layout::{Style, cut, wrap};
use super::model::{
    CaseReport, CrashLogReport, DefectReport, ExcuseReport, LevelReport, PeerReport, Report, RoleReport, State,
    TallyReport,
};
use crate::diagnosis::Suspect;
use crate::severity::Severity;
use crate::verdict::{self, Conclusion, Status};

/// How many characters of what went over the wire are shown, unless all is asked for.
const WIRE_CHARS: usize = 320;
/// How much of a sentence has to fit beside the id of a case; else that has a line of its own.
const SENTENCE_CHARS: usize = 40;
/// The widest that a peer's name is in the table.
const NAME_CHARS: usize = 16;

/// How much to show.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Detail {
    /// How many failing cases a peer are shown with what went over the wire, one a rule before a second.
    pub examples: usize,
    /// Whether nothing is cut short, and every note is told.
    pub verbose: bool,
}

impl Detail {
    /// One example a peer.
    pub const NORMAL: Self = Self { examples: 1, verbose: false };
    /// Everything.
    pub const VERBOSE: Self = Self { examples: usize::MAX, verbose: true };
}

/// Renders a report for people: a table of peers, roles and levels; then, peer by peer, what the run is worth, the
/// known defects that explain it, the broken rules, a line each, an example, what is not implemented, and what differs
/// from advice.
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

/// Renders one case of a report as a page shows its examples: the rule that it is charged to, with its sentence, what
/// was expected, and what went over the wire.
#[must_use]
pub fn example(report: &Report, case: &CaseReport, style: Style, detail: Detail) -> String {
    let mut page = Page { report, style, detail, out: String::new() };
    page.sentence(case.rule());
    page.case(case);
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
        let deep = if asked.deep > 0 { format!(", {} of the deep set", asked.deep) } else { String::new() };
        self.paragraph(0, &format!("NCP {wire_version}, level {}: {cases} in {files}{deep}", asked.level));
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
        self.worth(peer);
        let body = self.out.len();
        self.counts(peer);
        self.defects(peer);
        self.rules(peer);
        self.examples(peer);
        self.unsupported(peer);
        self.expected(peer);
        self.advice(peer);
        self.run_notes(peer);
        self.legend(peer);
        if self.out.len() == body && peer.totals.not_run == 0 {
            // Nothing to say but what the table says.
            self.out.truncate(start);
        } else {
            self.line("");
        }
    }

    /// What the run is worth: whether every case was run, and if not, how to go on.
    fn worth(&mut self, peer: &PeerReport) {
        let TallyReport { total, not_run, .. } = peer.totals;
        let total = plural(total, "case");
        if not_run == 0 {
            let part = if self.report.asked.partial { ", a part of all" } else { "" };
            return self.said(&format!("complete: {total} run, `describe` among them{part}"), 2, Style::dim);
        }
        let missed = peer.cases.iter().find(|case| case.status == Status::NotRun);
        let why = missed.and_then(|case| case.what.as_deref()).unwrap_or_default();
        let mut lines = why.lines();
        let first = lines.next().unwrap_or_default();
        let head = format!("incomplete: {} of {total} not run, since {first}", thousands(not_run as u64));
        self.said(&head, 2, Style::red);
        for line in lines {
            self.paragraph(6, line);
        }
        let go_on = if self.report.interrupted {
            "To go on, run it again to its end."
        } else {
            "To go on, mend that first, leave the guilty cases out by --role or --filter, or raise --max-restarts."
        };
        self.paragraph(4, go_on);
    }

    /// What becomes of the cases, in numbers that add up to all of them.
    fn counts(&mut self, peer: &PeerReport) {
        let TallyReport { total, passed, failed, advice, expected_failures, not_run } = peer.totals;
        if passed == total {
            return;
        }
        let lacking =
            |status: Status| peer.cases.iter().filter(|case| is_unsupported(case) && case.status == status).count();
        let (must, should) = (lacking(Status::Failed), lacking(Status::Advice));
        let waiting = peer.cases.iter().filter(|case| case.status == Status::Failed && case.waits()).count();
        let counted = [
            (passed, "passing"),
            (failed - must - waiting, "failing by the rule that is meant"),
            (waiting, "waiting for another rule, which fails first"),
            (must + should, "not implemented"),
            (expected_failures, "failing as expected"),
            (advice - should, "differing from a SHOULD"),
            (not_run, "not run"),
        ];
        let parts: Vec<String> = counted
            .into_iter()
            .filter(|(count, _)| *count > 0)
            .map(|(count, what)| format!("{} {what}", thousands(count as u64)))
            .collect();
        self.paragraph(2, &format!("{}: {}", plural(total, "case"), parts.join(", ")));
    }

    /// The known defects that explain the failing cases, and what none explains.
    fn defects(&mut self, peer: &PeerReport) {
        let Some(diagnosis) = &peer.diagnosis else {
            return;
        };
        let explained: usize = diagnosis.defects.iter().map(|found| found.explained.len()).sum();
        let failing = explained + diagnosis.unexplained.len();
        if failing == 0 {
            return;
        }
        if diagnosis.defects.is_empty() {
            self.line("");
            let failing = plural_verb(failing, "failing case", "failing cases");
            return self.paragraph(2, &format!("no known defect explains the {failing}"));
        }
        let defects = plural_verb(diagnosis.defects.len(), "known defect explains", "known defects explain");
        self.line("");
        self.said(
            &format!("{defects} {} of {}", thousands(explained as u64), plural(failing, "failing case")),
            2,
            Style::red,
        );
        for DefectReport { defect, words, severity, explained, passing, shortest } in &diagnosis.defects {
            self.item(4, "•", words);
            let mut how = format!("{defect} {}; explains {}", severity.in_words(), plural(explained.len(), "case"));
            if *passing > 0 {
                how.push_str(&format!(
                    ", though {} it would fail",
                    plural_verb(*passing, "case passes that", "cases pass that")
                ));
            }
            self.paragraph(6, &format!("{how}; the shortest is {shortest}"));
        }
        if let Some(first) = diagnosis.unexplained.first() {
            let count = plural_verb(diagnosis.unexplained.len(), "case is", "cases are");
            self.paragraph(4, &format!("{count} explained by none of them, such as {first}"));
        }
    }

    /// The broken rules but those of unsupported cases, the most severe first, a line each.
    fn rules(&mut self, peer: &PeerReport) {
        if peer.broken.is_empty() {
            return;
        }
        self.line("");
        let count = self.style.red(&plural_verb(peer.broken.len(), "rule is broken", "rules are broken"));
        self.line(&format!("  {count}"));
        for severity in Severity::ALL {
            let of_it: Vec<&Suspect> = peer.broken.iter().filter(|rule| Severity::of(&rule.rule) == severity).collect();
            if of_it.is_empty() {
                continue;
            }
            let title = self.style.bold(severity.in_words());
            self.line(&format!("  {title}"));
            for suspect in of_it {
                self.rule(peer, suspect);
            }
        }
    }

    /// One rule: its id, its level, how many of its cases fail, its sentence, and one case.
    fn rule(&mut self, peer: &PeerReport, Suspect { rule: id, cases }: &Suspect) {
        let failing = || cases.iter().filter_map(|place| peer.cases.get(*place));
        let own = failing().filter(|case| !case.waits()).count();
        let rule = self.report.rules.iter().find(|rule| rule.id == *id);
        let (level, all) = rule.map_or(("", own), |rule| (rule.level.as_str(), rule.cases));
        let sentence = rule.map_or("", |rule| rule.sentence.as_str());
        let of = format!("{}/{}", thousands(own as u64), thousands(all as u64));
        let waiting = match cases.len() - own {
            0 => String::new(),
            count => format!("+{}", thousands(count as u64)),
        };
        let waiting_width = if peer.cases.iter().any(CaseReport::waits) { 5 } else { 0 };
        let head = format!("    {id:13} {level:6} {of:>7}{waiting:>waiting_width$}  ");
        let example = failing().next().map_or("", |case| case.id.as_str());
        let room = self.style.width.saturating_sub(head.chars().count());
        let beside = room.saturating_sub(self.longest_example(peer) + 2);
        if beside >= SENTENCE_CHARS {
            return self.line(&format!("{head}{:beside$}  {example}", cut(sentence, beside)));
        }
        self.line(&format!("{head}{}", cut(sentence, room)));
        let example = self.style.dim(example);
        self.line(&format!("        {example}"));
    }

    /// The length of the longest id of those that stand beside the rules.
    fn longest_example(&self, peer: &PeerReport) -> usize {
        let shown = peer.broken.iter().chain(&peer.advised).filter_map(|suspect| suspect.cases.first());
        shown.filter_map(|place| peer.cases.get(*place)).map(|case| case.id.chars().count()).max().unwrap_or_default()
    }

    /// Failing cases with what went over the wire: of each rule one before a second, the most severe rule first.
    fn examples(&mut self, peer: &PeerReport) {
        let mut broken: Vec<&Suspect> = peer.broken.iter().collect();
        broken.sort_by_key(|suspect| Severity::of(&suspect.rule));
        let shown = shares(broken.iter().map(|suspect| suspect.cases.len()), self.detail.examples);
        for (suspect, shown) in broken.into_iter().zip(shown).filter(|(_, shown)| *shown > 0) {
            self.line("");
            self.sentence(&suspect.rule);
            for case in suspect.cases.iter().take(shown).filter_map(|place| peer.cases.get(*place)) {
                self.case(case);
            }
        }
    }

    fn sentence(&mut self, id: &str) {
        let Some(rule) = self.report.rules.iter().find(|rule| rule.id == id) else {
            return self.line(&format!("  {id}"));
        };
        let title = self.style.bold(id);
        let place = self.style.dim(&format!("{}, {}", rule.keyword.as_str(), rule.place));
        self.line(&format!("  {title} {place}"));
        self.paragraph(2, &rule.sentence);
    }

    /// What the numbers count, and where to read on.
    fn legend(&mut self, peer: &PeerReport) {
        let worst = peer.broken.iter().min_by_key(|suspect| Severity::of(&suspect.rule));
        let Some(first) = worst.or(peer.advised.first()) else {
            return;
        };
        self.line("");
        let text = "n/m: of the m cases about a rule n fail; +k: so many cases about other rules wait for it, since \
                    it is broken before they come to their own. In the table: binding cases that pass, of all \
                    binding ones.";
        self.said(text, 2, Style::dim);
        let example = peer.cases.get(first.cases.first().copied().unwrap_or_default()).map_or("", |case| &case.id);
        let text = format!(
            "More: ncp-verify explain {} or {example}; --examples N shows N failing cases, --verbose all of them.",
            first.rule
        );
        self.said(&text, 2, Style::dim);
    }

    fn case(&mut self, case: &CaseReport) {
        let mark = self.style.red("✗");
        self.line(&format!("    {mark} {} [{}]", case.id, case.outcome.as_str()));
        self.paragraph(6, &case.title);
        match (&case.charged, case.rules.first()) {
            (Some(rule), Some(own)) if case.waits() => {
                self.paragraph(6, &format!("inconclusive for {own}: waits for {rule}"));
            }
            _ if case.rules.len() > 1 => self.item(6, "also about", &case.rules[1..].join(", ")),
            _ => {}
        }
        if let Some(what) = &case.what {
            self.item(6, "it", what);
        }
        // What differs later in a trace mostly follows from what differs first.
        let is_trace = case.differences.first().is_some_and(|first| exchange::is_of_a_trace(&first.at));
        let most = if is_trace && !self.detail.verbose { 1 } else { usize::MAX };
        for difference in case.differences.iter().take(most) {
            self.paragraph(6, &difference.text);
        }
        let more = case.more_differences + case.differences.len().saturating_sub(most);
        if more > 0 {
            self.paragraph(6, &format!("and {} more", plural(more, "difference")));
        }
        if let (Some(_), Some(expected)) = (&case.what, &case.expected) {
            self.item(6, "expected", expected);
        }
        self.exchange(case);
        if let Some(note) = &case.note {
            self.item(6, "note", note);
        }
        for line in case.log.iter().flat_map(|log| log.lines()) {
            let line = self.style.dim(&format!("| {line}"));
            self.line(&format!("      {line}"));
        }
    }

    /// What went over the wire: of a trace its steps, of a block its directory, else the lines themselves.
    fn exchange(&mut self, case: &CaseReport) {
        if !self.detail.verbose
            && let Some(steps) = exchange::steps(case, self.style.width.saturating_sub(6))
        {
            for step in steps {
                self.line(&format!("      {step}"));
            }
            return;
        }
        let block = exchange::block(case);
        for (word, text) in [("sent", &case.request), ("got", &case.answer)] {
            match (&block, text) {
                (Some((which, lines)), Some(_)) if *which == word && !self.detail.verbose => {
                    for (nth, line) in lines.iter().enumerate() {
                        self.item(6, if nth == 0 { word } else { "    " }, line);
                    }
                }
                (_, Some(text)) => self.wire(&format!("{word:4}"), text),
                _ => {}
            }
        }
    }

    fn wire(&mut self, word: &str, text: &str) {
        let most = if self.detail.verbose { usize::MAX } else { WIRE_CHARS };
        let cut = text.char_indices().nth(most).map(|(at, _)| at);
        match cut {
            Some(at) => self.item(6, word, &format!("{}…", &text[..at])),
            None => self.item(6, word, text),
        }
    }

    /// What is not implemented at all, or in part, call by call: the rules that such cases cite say little.
    fn unsupported(&mut self, peer: &PeerReport) {
        let mut calls: BTreeMap<&str, (u64, u64)> = BTreeMap::new();
        for case in &peer.cases {
            let (lacking, all) = calls.entry(case.call.as_str()).or_default();
            *lacking += u64::from(is_unsupported(case));
            *all += 1;
        }
        let list = |whole: bool| {
            let fits = |(_, (lacking, all)): &(_, (u64, u64))| *lacking > 0 && (lacking == all) == whole;
            let of = |lacking: u64, all: u64| match whole {
                true => plural_u64(lacking, "case"),
                false => format!("{} of {}", thousands(lacking), plural_u64(all, "case")),
            };
            let named = calls.iter().map(|(call, counts)| (*call, *counts)).filter(fits);
            named.map(|(call, (lacking, all))| format!("{call} ({})", of(lacking, all))).collect::<Vec<_>>()
        };
        for (what, named) in [("not implemented at all", list(true)), ("not implemented in part", list(false))] {
            if !named.is_empty() {
                self.line("");
                self.said(&format!("{what}: {}", named.join(", ")), 2, Style::yellow);
            }
        }
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

    /// What differs from advice, a line a rule.
    fn advice(&mut self, peer: &PeerReport) {
        if peer.advised.is_empty() {
            return;
        }
        self.line("");
        let differing = peer.advised.iter().map(|suspect| suspect.cases.len()).sum();
        let title =
            format!("{} from a SHOULD, which fails nobody", plural_verb(differing, "case differs", "cases differ"));
        self.said(&title, 2, Style::yellow);
        for suspect in &peer.advised {
            self.rule(peer, suspect);
            if self.detail.verbose {
                for case in suspect.cases.iter().filter_map(|place| peer.cases.get(*place)) {
                    self.case(case);
                }
            }
        }
    }

    fn run_notes(&mut self, peer: &PeerReport) {
        let Some(run) = &peer.run else { return };
        if run.faults > 0 || !run.notes.is_empty() {
            self.line("");
        }
        for note in &run.notes {
            self.item(2, "note:", note);
        }
        let noted: Vec<&CaseReport> =
            peer.cases.iter().filter(|case| case.note.is_some() && case.status == Status::Passed).collect();
        if self.detail.verbose {
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
        if let Some(rate) = run.rate.as_ref().filter(|_| self.report.asked.repeat > 1 || self.detail.verbose) {
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

/// A role at a level: whether it conforms, and how many of the binding cases pass.
fn cell(level: &LevelReport) -> String {
    let mark = match (level.conformant, level.as_expected) {
        (true, _) => '✓',
        (false, true) => '~',
        (false, false) => '✗',
    };
    if level.cases.total == 0 {
        return format!("{mark} none of its own");
    }
    format!("{mark} {}/{}", thousands(level.binding_passed as u64), thousands(level.binding as u64))
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

    use super::super::model::{Asked, Corpus, DiagnosisReport, Exit, Tool};
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
        let (binding, binding_passed) = (passed + failed, passed);
        LevelReport { level, conformant, as_expected: conformant, cases, binding, binding_passed }
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
            tool: Tool { name: "ncp-verify".into(), version: "0".into() },
            started: String::new(),
            elapsed_s: 1.0,
            wire_version: "7.1".into(),
            contract_hash: String::new(),
            corpus: Corpus { files: 90, cases: 7000, sha256: String::new() },
            asked: Asked {
                deep: 0,
                level: Level::Strict,
                roles: Vec::new(),
                filters: Vec::new(),
                files: 80,
                cases: 6100,
                repeat: 1,
                partial: false,
                shard: None,
                rerun: false,
            },
            interrupted: false,
            rules: Vec::new(),
            peers: vec![checked, PeerReport::unchecked("cpp".into(), "peers/cpp".into(), State::Skipped, skipped)],
            exit_code: Exit::NotConformant.code(),
        }
    }

    #[test]
    fn levels_stand_side_by_side_where_there_is_room() {
        let text = terminal(&report(), Style { colour: false, width: 80 }, Detail::NORMAL);
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
    fn known_defects_come_before_the_rules_that_they_break() {
        let mut report = report();
        let found = |defect: &str, words: &str, severity, explained: &[&str], passing| DefectReport {
            defect: defect.to_owned(),
            words: words.to_owned(),
            severity,
            explained: explained.iter().map(|id| (*id).to_owned()).collect(),
            passing,
            shortest: explained[0].to_owned(),
        };
        report.peers[0].diagnosis = Some(DiagnosisReport {
            defects: vec![
                found(
                    "latch-lost",
                    "An ESTOP is forgotten with the next command.",
                    Severity::Plant,
                    &["a/1", "a/2"],
                    1,
                ),
                found("last-member-wins", "Of two members the last one counts.", Severity::Acceptance, &["b/1"], 0),
            ],
            unexplained: vec!["c/1".to_owned()],
        });
        report.peers.truncate(1);
        let text = terminal(&report, Style { colour: false, width: 80 }, Detail::NORMAL);
        insta::assert_snapshot!(text, @"
        NCP 7.1, level strict: 6,100 cases in 80 files

        peer     role       wire           safety     strict
        gateway  commander  ✓ 2,600/2,600  ✗ 411/412  ✗ 20/20
                 observer   ✓ 900/900      -          -

        gateway
          complete: 0 cases run, `describe` among them

          2 known defects explain 3 of 4 failing cases
            • An ESTOP is forgotten with the next command.
              latch-lost moves a plant or loses a stop; explains 2 cases, though 1 case
              passes that it would fail; the shortest is a/1
            • Of two members the last one counts.
              last-member-wins rejects or accepts wrongly; explains 1 case; the shortest
              is b/1
            1 case is explained by none of them, such as c/1

        the peer does not conform at level strict
        ");
    }

    #[test]
    fn levels_stand_below_each_other_where_there_is_none() {
        let text = terminal(&report(), Style { colour: false, width: 44 }, Detail::NORMAL);
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
