//! A table of the cases, for spreadsheets and `awk`.

use ncp_text::catalogue::Role;

use super::model::{CaseReport, PeerReport, Report};

const HEAD: &str = "peer\tcase\tcall\tlevel\troles\tbinding\toutcome\tstatus\truling\tcharged\trules\tbrief";

/// Renders a report as tab-separated values: a line a case, and one that names the columns.
#[must_use]
pub(super) fn tsv(report: &Report) -> String {
    let lines = report.peers.iter().flat_map(|peer| peer.cases.iter().map(|case| line(peer, case)));
    std::iter::once(HEAD.to_owned()).chain(lines).map(|line| line + "\n").collect()
}

fn line(peer: &PeerReport, case: &CaseReport) -> String {
    let roles = case.roles.iter().copied().map(Role::as_str).collect::<Vec<_>>().join(",");
    let brief = if case.outcome.as_str() == "pass" { String::new() } else { case.in_brief() };
    let cells: [&str; 12] = [
        &peer.name,
        &case.id,
        case.call.as_str(),
        case.level.as_str(),
        &roles,
        if case.binding { "yes" } else { "no" },
        case.outcome.as_str(),
        case.status.as_str(),
        &case.ruling,
        case.charged.as_deref().unwrap_or_default(),
        &case.rules.join(","),
        &brief,
    ];
    // A cell holds neither a tab nor the end of a line.
    cells.map(|cell| cell.split(char::is_control).collect::<Vec<_>>().join(" ")).join("\t")
}
