//! The bundled peers: each has to do what its list of expected failures says, and nothing worse.
//!
//! The run is one of this very program, over the cases of the tree.

use std::fs;
use std::path::Path;

use ncp_text::CHAPTERS;

use super::rows::{Found, Unrun};
use super::{CORPUS, Finding, Gate, TEXT};
use crate::report::{CaseReport, PeerReport, Report, State};
use crate::verdict::Status;

/// Runs every bundled peer, and reads what became of it.
pub(super) fn check(gate: &Gate<'_>) -> Result<Found, Unrun> {
    let same = |file: &str, text: &str| {
        let of_the_tree = fs::read_to_string(gate.path(TEXT).join(file));
        of_the_tree.is_ok_and(|of_the_tree| of_the_tree == text)
    };
    if let Some(other) = CHAPTERS.iter().find(|chapter| !same(chapter.file, chapter.text)) {
        let file = other.file;
        return Err(Unrun::Missing(format!("this program was built of another {TEXT}/{file}: cargo verify gate")));
    }
    let result = gate.tools.scratch().path("peers.json");
    let (vectors, json) = (gate.path(CORPUS).display().to_string(), result.display().to_string());
    let command = gate.tools.itself(&["--vectors", &vectors, "--json", &json])?;
    let ended = gate.tools.run(command, "peers")?;
    match Report::read(&result) {
        Ok(report) => judge(&report),
        Err(_) => Err(Unrun::broken(Finding::new(ended.last_words()))),
    }
}

fn judge(report: &Report) -> Result<Found, Unrun> {
    let findings: Vec<Finding> = report.peers.iter().flat_map(of_peer).collect();
    let skipped = report.peers.iter().filter(|peer| peer.state == State::Skipped);
    let skipped: Vec<String> = skipped
        .map(|peer| format!("{} was not checked: {}", peer.name, peer.reason.as_deref().unwrap_or("unknown")))
        .collect();
    if findings.is_empty() && !skipped.is_empty() {
        return Err(Unrun::Missing(skipped.join("; ")));
    }
    let expected: usize = report.peers.iter().map(|peer| peer.totals.expected_failures).sum();
    let said = match report.peers.len() {
        1 => format!("{} does as it says", report.peers[0].name),
        count => format!("{count} peers do as they say"),
    };
    let said = if expected > 0 { format!("{said}, {expected} failures expected") } else { said };
    Ok(Found { said, findings }.only_if_good())
}

/// What a peer does that it does not say.
fn of_peer(peer: &PeerReport) -> Vec<Finding> {
    let name = &peer.name;
    let manifest = Path::new(&peer.source).join("peer.toml").display().to_string().replace('\\', "/");
    let of = |text: String| Finding::at(&manifest, None, text);
    if peer.state == State::NotStarted {
        return vec![of(format!("{name} was not started: {}", peer.reason.as_deref().unwrap_or("unknown")))];
    }
    let mut rules: Vec<(&str, Vec<&CaseReport>)> = Vec::new();
    for case in peer.cases.iter().filter(|case| case.status == Status::Failed) {
        match rules.iter_mut().find(|(rule, _)| *rule == case.rule()) {
            Some((_, cases)) => cases.push(case),
            None => rules.push((case.rule(), vec![case])),
        }
    }
    rules.sort_by_key(|(_, cases)| std::cmp::Reverse(cases.len()));
    let failing = rules.iter().map(|(rule, cases)| {
        let (first, many) = (cases[0], cases.len());
        let cases = if many == 1 { "1 case fails".to_owned() } else { format!("{many} cases fail") };
        of(format!("{name}: {cases} by {rule}: {}: {}", first.id, first.in_brief())).by(rule)
    });
    let untrue = peer.expected_failures.iter().flat_map(crate::report::ExcuseReport::untrue);
    failing.chain(untrue.map(|text| of(format!("{name}: {text}")).by("expected-failures"))).collect()
}
