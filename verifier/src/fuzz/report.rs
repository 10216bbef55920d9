//! What a search found, for people and for programs.

use std::fmt::Write as _;

use serde::Serialize;

use super::coverage::Summary;
use super::search::{Finding, Shrunk, Tested};
use crate::peer::excerpt;
use crate::report::Style;

/// How much of an input is shown.
const INPUT_CHARS: usize = 1200;
/// How many lines of the table of features are shown, unless all of it is asked for.
const NEVER_SHOWN: usize = 6;

/// The whole as JSON.
#[derive(Debug, Serialize)]
struct Whole<'t> {
    seed: u64,
    peers: Vec<OfPeer<'t>>,
}

#[derive(Debug, Serialize)]
struct OfPeer<'t> {
    name: &'t str,
    version: &'t str,
    language: &'t str,
    /// Of the dictionary: how many tries were made, and how many there are.
    swept: [u64; 2],
    inputs: u64,
    steps: u64,
    seconds: f64,
    allowed: u64,
    open: Vec<(&'t str, u64)>,
    unsupported: Vec<(&'t str, u64)>,
    faults: usize,
    given_up: Option<&'t str>,
    findings: Vec<OfFinding<'t>>,
    coverage: Summary,
}

#[derive(Debug, Serialize)]
struct OfFinding<'t> {
    call: &'t str,
    kind: &'t str,
    place: &'t str,
    rule: Option<&'t str>,
    binds: bool,
    like: Option<&'t str>,
    times: u64,
    first: u64,
    steps: [usize; 2],
    smallest: bool,
    args: serde_json::Value,
    expect: serde_json::Value,
    specification: &'t str,
    answer: &'t str,
    differences: Vec<String>,
    log: Option<&'t str>,
}

/// The results of all peers as JSON.
///
/// # Errors
/// They cannot be written, which no input of ours can cause.
pub fn json(seed: u64, tested: &[(String, Tested)]) -> Result<String, serde_json::Error> {
    let peers = tested.iter().map(|(name, tested)| {
        Ok(OfPeer {
            name,
            version: &tested.description.version,
            language: &tested.description.language,
            swept: [tested.swept.0, tested.swept.1],
            inputs: tested.inputs,
            steps: tested.steps,
            seconds: tested.elapsed.as_secs_f64(),
            allowed: tested.allowed,
            open: tested.open.iter().map(|(why, count)| (*why, *count)).collect(),
            unsupported: tested.unsupported.iter().map(|(call, count)| (*call, *count)).collect(),
            faults: tested.faults,
            given_up: tested.given_up.as_deref(),
            findings: tested.findings.iter().map(of_finding).collect::<Result<_, _>>()?,
            coverage: tested.coverage.summary(),
        })
    });
    let peers = peers.collect::<Result<_, serde_json::Error>>()?;
    Ok(serde_json::to_string_pretty(&Whole { seed, peers })? + "\n")
}

fn of_finding(finding: &Finding) -> Result<OfFinding<'_>, serde_json::Error> {
    let decided = finding.decided.as_ref();
    Ok(OfFinding {
        call: finding.found.input.call.as_str(),
        kind: finding.kind,
        place: &finding.place,
        rule: decided.map(|decided| decided.rule.as_str()),
        binds: decided.is_none_or(|decided| decided.binds),
        like: decided.map(|decided| decided.like.as_str()),
        times: finding.times,
        first: finding.first,
        steps: [finding.shrunk.from, finding.shrunk.to],
        smallest: finding.shrunk.is_smallest,
        args: serde_json::from_str(&finding.found.input.args.to_string())?,
        expect: serde_json::from_str(&finding.found.expect.to_string())?,
        specification: &finding.found.specification,
        answer: &finding.found.answer,
        differences: finding.found.differences.first.iter().map(ToString::to_string).collect(),
        log: finding.fault.as_ref().map(|fault| fault.log.as_str()),
    })
}

/// What was found of a peer, in words.
#[must_use]
pub fn terminal(name: &str, seed: u64, tested: &Tested, style: Style, whole_coverage: bool) -> String {
    let mut out = String::new();
    let about = &tested.description;
    let seconds = tested.elapsed.as_secs_f64();
    let rate = if seconds > 0.0 { tested.inputs as f64 / seconds } else { 0.0 };
    line(&mut out, &format!("{} {} ({})", style.bold(name), about.version, about.language));
    line(
        &mut out,
        &format!(
            "  {} inputs of {} steps in {seconds:.1} s, {rate:.0}/s; --seed {seed} asks the same again",
            tested.inputs, tested.steps
        ),
    );
    if tested.swept.1 > 0 {
        let (made, all) = tested.swept;
        line(&mut out, &format!("  dictionary: {made} of {all} tries, first with what the text has no word of"));
    }
    if tested.nothing_asked {
        line(&mut out, "  nothing was asked: no call fits the filter, the level and the roles that the peer claims");
    }
    if let Some(why) = &tested.given_up {
        line(&mut out, &style.red(&format!("  given up: {why}")));
    }
    let unsupported: Vec<String> = tested.unsupported.iter().map(|(call, count)| format!("{call} ({count})")).collect();
    if !unsupported.is_empty() {
        line(&mut out, &format!("  answered `unsupported`: {}", unsupported.join(", ")));
    }
    for (nth, finding) in tested.findings.iter().enumerate() {
        out.push('\n');
        show(&mut out, nth + 1, finding, style);
    }
    out.push('\n');
    let found = tested.findings.len();
    line(
        &mut out,
        &match found {
            0 => style.green("  no disagreement"),
            1 => style.red("  1 disagreement"),
            _ => style.red(&format!("  {found} disagreements")),
        },
    );
    let open: u64 = tested.open.values().sum();
    if open + tested.allowed > 0 {
        let text =
            format!("  {} answers differ as the text allows, {open} where it leaves the answer open", tested.allowed);
        line(&mut out, &style.dim(&text));
        if whole_coverage {
            for (why, count) in &tested.open {
                line(&mut out, &style.dim(&format!("    {count:>8}  {why}")));
            }
        }
    }
    out.push('\n');
    coverage(&mut out, &tested.coverage.summary(), style, whole_coverage);
    out
}

fn line(out: &mut String, text: &str) {
    // Writing to a string cannot fail.
    let _ = writeln!(out, "{text}");
}

fn show(out: &mut String, nth: usize, finding: &Finding, style: Style) {
    let found = &finding.found;
    let rule = finding.decided.as_ref().map_or("no rule that is known", |decided| decided.rule.as_str());
    let place = if finding.place.is_empty() { String::new() } else { format!(" at {}", finding.place) };
    let head = format!("{nth}. {} · {rule} · {}{place}", found.input.call.as_str(), finding.kind);
    line(out, &style.red(&head));
    if let Some(decided) = &finding.decided {
        let advice = if decided.binds { "" } else { ", which is advice" };
        line(out, &format!("   {}{advice}", decided.sentence));
        line(out, &style.dim(&format!("   the rule of the most similar case, {}", decided.like)));
    }
    let Shrunk { from, to, is_smallest } = finding.shrunk;
    let shrunk = match (from, to) {
        (0, _) | (1, 1) => String::new(),
        _ if from > to => format!(", shrunk from {from} steps to {to}"),
        _ => format!(", of {to} steps"),
    };
    let needed = match is_smallest {
        true if to > 1 => ", each of which is needed",
        true => "",
        false => ", perhaps not the smallest: more --tries shrink it further",
    };
    let times = if finding.times == 1 { "once".to_owned() } else { format!("{} times", finding.times) };
    line(out, &format!("   seen {times}, first as input {}{shrunk}{needed}", finding.first));
    let args = excerpt(found.input.args.to_string().as_bytes(), INPUT_CHARS);
    line(out, &format!("   asked     {args}"));
    line(out, &format!("   spec      {}", excerpt(found.specification.as_bytes(), INPUT_CHARS)));
    line(out, &format!("   peer      {}", excerpt(found.answer.as_bytes(), INPUT_CHARS)));
    for difference in found.differences.first.iter().take(3) {
        line(out, &format!("   {difference}"));
    }
    if let Some(fault) = finding.fault.as_ref().filter(|fault| !fault.log.trim().is_empty()) {
        for said in fault.log.lines().rev().take(4).collect::<Vec<_>>().into_iter().rev() {
            line(out, &style.dim(&format!("   | {said}")));
        }
    }
}

fn coverage(out: &mut String, summary: &Summary, style: Style, whole: bool) {
    line(out, &style.bold("  reached"));
    for call in &summary.calls {
        let never = match call.never.len() {
            0 => String::new(),
            count => {
                let shown = if whole { count } else { NEVER_SHOWN };
                let more = if count > shown { ", …" } else { "" };
                format!("; never {}{more}", call.never.iter().take(shown).cloned().collect::<Vec<_>>().join(", "))
            }
        };
        line(
            out,
            &format!(
                "    {:<20} {:>8} inputs {:>9} steps {:>4} of {:>4} pairs of features{never}",
                call.call, call.inputs, call.steps, call.pairs, call.of
            ),
        );
        if whole {
            for (feature, count) in call.features.iter().filter(|(_, count)| *count > 0) {
                line(out, &style.dim(&format!("        {count:>9}  {feature}")));
            }
            for pair in &call.never_together {
                line(out, &style.dim(&format!("        never      {pair}")));
            }
        }
    }
    let counted = |counts: &std::collections::BTreeMap<String, u64>| {
        let shown = counts.iter().map(|(below, count)| format!("<{} {count}", below.trim()));
        shown.collect::<Vec<_>>().join(", ")
    };
    line(out, &format!("    steps of a trace: {}", counted(&summary.lengths)));
    line(out, &format!("    bytes of a request: {}", counted(&summary.bytes)));
    let numbers: Vec<String> = summary.numbers.iter().map(|(class, count)| format!("{class} {count}")).collect();
    line(out, &format!("    numbers: {}", numbers.join(", ")));
    line(out, &format!("    {} combinations of call, answer and features", summary.combinations));
}
