//! One page that holds a whole result, without a network.
//!
//! What the page shows at once is one compressed block; what it shows of a case when that is opened is in blocks of
//! [`CHUNK`] cases, each of which the page's script unpacks when it is needed. So the page opens quickly, whatever its
//! size. The script renders; it computes no verdict.

use std::collections::HashMap;
use std::io::Write as _;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;
use ncp_text::catalogue::{Level, Role};
use serde::Serialize;
use serde_json::{Value, json};

use super::format::RenderError;
use super::model::{CaseReport, DifferenceReport, PeerReport, Report, Rule, State};
use crate::check::in_words;
use crate::peer::excerpt;
use crate::run::OutcomeKind;
use crate::severity::Severity;
use crate::suite::{Case, Expect, Suite};
use crate::verdict::Status;

/// How many cases a block holds.
const CHUNK: usize = 100;
/// How large a page may be, in bytes.
const LARGEST: usize = 9_500_000;
/// How many bytes of a request, an answer or a log are shown; less, where the page would be too large.
const SHOWN: [usize; 6] = [16_000, 4_000, 1_500, 500, 150, 0];

const PAGE: &str = include_str!("page/page.html");
const STYLE: &str = include_str!("page/page.css");
const SCRIPT: &str = include_str!("page/page.js");

/// Renders a report as a page. With the suite that it draws on, each case can be opened to its input and expectation;
/// without, only those that did not pass.
///
/// # Errors
/// [`RenderError`] if its data cannot be written, which does not occur.
pub(super) fn html(report: &Report, suite: Option<&Suite>) -> Result<String, RenderError> {
    let mut page = String::new();
    for shown in SHOWN {
        page = with_data(&blocks(report, suite, shown)?);
        if page.len() <= LARGEST {
            break;
        }
    }
    Ok(page)
}

fn with_data(data: &str) -> String {
    // Data comes last, so that nothing within it is taken for a place to fill.
    PAGE.replace("/*STYLE*/", STYLE).replace("/*SCRIPT*/", SCRIPT).replace("<!--DATA-->", data)
}

/// The blocks of the page, with so much of each text.
fn blocks(report: &Report, suite: Option<&Suite>, shown: usize) -> Result<String, RenderError> {
    let cases = Cases::of(report, suite);
    let mut out = block("index", &index(report, &cases))?;
    for (number, ids) in cases.all.chunks(CHUNK).enumerate() {
        let details: Vec<Value> = ids.iter().map(|id| cases.detail(id, shown)).collect();
        out.push_str(&block(&format!("chunk-{number}"), &details)?);
    }
    Ok(out)
}

fn block(id: &str, value: &impl Serialize) -> Result<String, RenderError> {
    let mut packer = GzEncoder::new(Vec::new(), Compression::default());
    packer.write_all(&serde_json::to_vec(value)?).map_err(RenderError::Pack)?;
    let packed = STANDARD.encode(packer.finish().map_err(RenderError::Pack)?);
    Ok(format!("<script type=\"text/plain\" id=\"{id}\">{packed}</script>\n"))
}

/// The cases of all peers, in the order in which they first occur.
struct Cases<'r> {
    all: Vec<&'r str>,
    places: HashMap<&'r str, usize>,
    /// By case, what each peer made of it.
    found: HashMap<&'r str, Vec<(usize, &'r CaseReport)>>,
    suite: HashMap<&'r str, &'r Case>,
    rules: HashMap<&'r str, &'r Rule>,
}

impl<'r> Cases<'r> {
    fn of(report: &'r Report, suite: Option<&'r Suite>) -> Self {
        let mut found: HashMap<&str, Vec<(usize, &CaseReport)>> = HashMap::new();
        let mut all = Vec::new();
        for (place, peer) in report.peers.iter().enumerate() {
            for case in &peer.cases {
                let of_it = found.entry(&case.id).or_default();
                if of_it.is_empty() {
                    all.push(case.id.as_str());
                }
                of_it.push((place, case));
            }
        }
        let suite: HashMap<&str, &Case> =
            suite.into_iter().flat_map(Suite::with_describe).map(|case| (case.id.as_str(), case)).collect();
        let places = all.iter().enumerate().map(|(place, id)| (*id, place)).collect();
        let rules = report.rules.iter().map(|rule| (rule.id.as_str(), rule)).collect();
        Self { all, places, found, suite, rules }
    }

    fn found(&self, id: &str) -> &[(usize, &'r CaseReport)] {
        self.found.get(id).map_or(&[], Vec::as_slice)
    }

    /// What is shown of a case when it is opened.
    fn detail(&self, id: &str, shown: usize) -> Value {
        let cut = |text: &str| excerpt(text.as_bytes(), shown);
        let case = self.suite.get(id);
        let request = match case {
            Some(case) => Some(case.made_of().unwrap_or_else(|| format!("{{{}", case.body()))),
            None => self.found(id).iter().find_map(|(_, found)| found.request.clone()),
        };
        let in_words = || self.found(id).iter().find_map(|(_, found)| found.expected.clone());
        let expected = match case {
            Some(case) => Some(expected(&case.expect)),
            None => in_words().map(|words| ("", words)),
        };
        let differences = |found: &CaseReport| {
            let row = |difference: &DifferenceReport| {
                let DifferenceReport { at, expected, got, hint, .. } = difference;
                json!([at, expected.as_deref().map(cut), got.as_deref().map(cut), hint])
            };
            found.differences.iter().take(20).map(row).collect::<Vec<_>>()
        };
        let of_peer = |(place, found): &(usize, &CaseReport)| {
            let mut about = serde_json::Map::new();
            let mut put = |name: &str, text: Option<String>| about.extend(text.map(|t| (name.to_owned(), json!(t))));
            put("what", found.what.clone());
            put("note", found.note.clone());
            put("reason", found.reason.clone());
            put("answer", found.answer.as_deref().map(cut));
            put("log", found.log.as_deref().map(cut));
            about.extend((found.outcome == OutcomeKind::Unsupported).then(|| ("lacks".to_owned(), json!(true))));
            about.extend((found.outcome == OutcomeKind::Pass).then(|| ("pass".to_owned(), json!(true))));
            if !found.differences.is_empty() {
                about.insert("differences".to_owned(), json!(differences(found)));
                about.insert("more".to_owned(), json!(found.more_differences));
            }
            let tells = about.len() > usize::from(found.outcome == OutcomeKind::Pass);
            (tells || found.outcome == OutcomeKind::Pass).then(|| (place.to_string(), Value::Object(about)))
        };
        let peers: serde_json::Map<String, Value> = self.found(id).iter().filter_map(of_peer).collect();
        json!({
            "request": request.as_deref().map(cut), "why": case.map(|case| &case.why),
            "expected": expected.map(|(relation, text)| [relation.to_owned(), cut(&text)]), "peers": peers,
        })
    }
}

/// An expectation: its relation, and what is compared.
fn expected(expect: &Expect) -> (&'static str, String) {
    match expect {
        Expect::Reject(_) => ("a refusal", in_words(expect)),
        Expect::Accept => ("any result", in_words(expect)),
        Expect::Json(value) => ("equal as JSON", value.expand().into_owned()),
        Expect::Message { text, or_reject: false, .. } => ("the same message", text.get().into_owned()),
        Expect::Message { text, .. } => ("the same message, or a refusal", text.get().into_owned()),
        Expect::Encoding(text) => ("spelled as this frame", text.get().into_owned()),
        Expect::Bytes(bytes) => ("exactly these bytes, in base64", STANDARD.encode(bytes)),
        Expect::Columns(columns) => ("a block with these columns", columns.expand().into_owned()),
        Expect::Pattern { shape, or_reject: false, .. } => ("like this, as far as it says", shape.to_string()),
        Expect::Pattern { shape, .. } => ("like this, or a refusal", shape.to_string()),
    }
}

/// What the page shows at once. The cases are written as they are found: as values they would cost more than the page.
#[derive(Serialize)]
struct Index<'r> {
    #[serde(flatten)]
    head: Value,
    cases: Vec<About<'r>>,
    peers: Vec<Value>,
}

/// What the page shows at once of a case.
#[derive(Serialize)]
struct About<'r> {
    id: &'r str,
    title: &'r str,
    rules: &'r [String],
    call: &'static str,
    level: Option<usize>,
    binding: bool,
    roles: Vec<&'static str>,
    chapter: Option<usize>,
}

fn index<'r>(report: &Report, cases: &Cases<'r>) -> Index<'r> {
    let mut chapters: Vec<&str> = report.rules.iter().map(chapter).collect();
    chapters.dedup();
    let used = |chapter: &&str| cases.all.iter().any(|id| cases.chapter(id) == *chapter);
    chapters.retain(used);
    let about = |id: &'r str| {
        let (_, case) = cases.found(id).first()?;
        Some(About {
            id,
            title: &case.title,
            rules: &case.rules,
            call: case.call.as_str(),
            level: Level::ALL.iter().position(|level| *level == case.level),
            binding: case.binding,
            roles: case.roles.iter().copied().map(Role::as_str).collect(),
            chapter: chapters.iter().position(|chapter| *chapter == cases.chapter(id)),
        })
    };
    let rule = |rule: &Rule| {
        let Rule { id, sentence, severity, .. } = rule;
        (id.clone(), json!({"sentence": sentence, "keyword": rule.keyword.as_str(), "severity": severity}))
    };
    let asked = &report.asked;
    let head = json!({
        "of": {
            "wire": report.wire_version, "level": asked.level.as_str(), "cases": asked.cases, "files": asked.files,
            "started": report.started, "version": report.tool.version, "corpus": report.corpus.sha256,
            "partial": asked.partial, "interrupted": report.interrupted,
        },
        "chunk": CHUNK,
        "levels": Level::ALL.map(Level::as_str),
        "severities": Severity::ALL,
        "chapters": chapters.iter().map(|chapter| chapter.trim_end_matches(".md")).collect::<Vec<_>>(),
        "rules": report.rules.iter().map(rule).collect::<serde_json::Map<_, _>>(),
    });
    let peers = report.peers.iter().map(|of| peer(of, cases)).collect();
    Index { head, cases: cases.all.iter().copied().filter_map(about).collect(), peers }
}

impl Cases<'_> {
    /// The chapter of the rule that a case is about.
    fn chapter(&self, id: &str) -> &str {
        let rule = self.found(id).first().and_then(|(_, case)| case.rules.first());
        rule.and_then(|rule| self.rules.get(rule.as_str())).map_or("", |rule| chapter(rule))
    }
}

fn chapter(rule: &Rule) -> &str {
    rule.place.split(':').next().unwrap_or_default()
}

fn peer(peer: &PeerReport, cases: &Cases<'_>) -> Value {
    // A character a case: `o` for those that the peer was not asked.
    let (mut status, mut outcome) = (vec![b'o'; cases.all.len()], vec![b'o'; cases.all.len()]);
    let (mut charged, mut waits) = (serde_json::Map::new(), Vec::new());
    for case in &peer.cases {
        let Some(place) = cases.places.get(case.id.as_str()).copied() else { continue };
        for (marks, mark) in [(&mut status, mark_of(case.status)), (&mut outcome, letter_of(case.outcome))] {
            if let Some(at) = marks.get_mut(place) {
                *at = mark;
            }
        }
        charged.extend(case.charged.as_ref().map(|rule| (place.to_string(), json!(rule))));
        waits.extend(case.waits().then_some(place));
    }
    let text = |marks: Vec<u8>| String::from_utf8(marks).unwrap_or_default();
    let roles: Vec<Value> = peer
        .roles
        .iter()
        .map(|role| {
            let level = |level: &super::LevelReport| {
                json!([level.level.as_str(), level.conformant, level.binding_passed, level.binding])
            };
            json!([role.role.as_str(), role.levels.iter().map(level).collect::<Vec<_>>()])
        })
        .collect();
    let diagnosis = peer.diagnosis.as_ref();
    let defects: Vec<Value> = diagnosis
        .iter()
        .flat_map(|diagnosis| &diagnosis.defects)
        .map(|found| {
            json!({
                "id": found.defect, "words": found.words, "severity": found.severity, "cases": found.explained.len(),
                "passing": found.passing, "shortest": found.shortest,
            })
        })
        .collect();
    let run = peer.run.as_ref();
    let given_up = run.and_then(|run| run.given_up.as_ref()).map(|why| format!("given up: {why}"));
    json!({
        "name": peer.name, "source": peer.source, "command": peer.source.contains(char::is_whitespace),
        "state": if peer.state == State::Checked { "checked" } else { "unchecked" },
        "version": peer.description.as_ref().map_or("", |about| &about.version),
        "reason": peer.reason, "verdict": peer.verdict(), "roles": roles, "defects": defects,
        "unexplained": diagnosis.map_or(0, |diagnosis| diagnosis.unexplained.len()),
        "untrue": peer.expected_failures.iter().flat_map(super::ExcuseReport::untrue).collect::<Vec<_>>(),
        "notes": given_up.iter().chain(run.iter().flat_map(|run| &run.notes)).collect::<Vec<_>>(),
        "crash": run.and_then(|run| run.crash_log.as_ref())
            .map(|crash| [crash.case.clone(), excerpt(crash.log.as_bytes(), 20_000)]),
        "status": text(status), "outcome": text(outcome), "charged": charged, "waits": waits,
    })
}

/// The letter by which the page knows a status.
const fn mark_of(status: Status) -> u8 {
    match status {
        Status::Passed => b'p',
        Status::UnexpectedPass => b'u',
        Status::Failed => b'f',
        Status::Advice => b'a',
        Status::ExpectedFailure => b'x',
        Status::NotRun => b'n',
    }
}

/// The letter by which the page knows an outcome.
const fn letter_of(outcome: OutcomeKind) -> u8 {
    match outcome {
        OutcomeKind::Pass => b'p',
        OutcomeKind::Fail => b'f',
        OutcomeKind::Unsupported => b'u',
        OutcomeKind::Crash => b'c',
        OutcomeKind::Timeout => b't',
        OutcomeKind::Protocol => b'b',
        OutcomeKind::NotRun => b'n',
    }
}
