//! The vectors of the evidence: counterexamples to planted defects, which any peer can be asked.
//!
//! A run of some engines replaces what these found, and leaves what the others found.

use std::collections::BTreeSet;

use crate::report::{self, Report};

/// How the line of a case begins.
const CASE: &str = "  {\"id\":\"proofs/report/";

/// The file of vectors after a run, given as it was before: the cases of every engine that the report has, and those
/// that stood there of every other one.
#[must_use]
pub fn vectors(report: &Report, before: &str) -> String {
    let now = report::vectors(report);
    let here: BTreeSet<&str> =
        report.engines.iter().filter(|engine| !engine.not_run).map(|engine| &*engine.name).collect();
    let mut names: Vec<&str> = Vec::new();
    for (engine, _) in cases(before).chain(cases(&now)) {
        if !names.contains(&engine) {
            names.push(engine);
        }
    }
    let mut lines: Vec<&str> = Vec::new();
    for name in names {
        let text = if here.contains(name) { &now } else { before };
        lines.extend(cases(text).filter(|(engine, _)| *engine == name).map(|(_, line)| line.trim_end_matches(',')));
    }
    let is_case = |line: &&str| line.starts_with(CASE);
    let head: Vec<&str> =
        now.lines().take_while(|line| !is_case(line) && *line != "]}").filter(|line| !line.is_empty()).collect();
    format!("{}\n{}\n]}}\n", head.join("\n"), lines.join(",\n"))
}

/// The lines of a file of vectors that hold a case, with the engine that found it.
fn cases(text: &str) -> impl Iterator<Item = (&str, &str)> {
    text.lines().filter_map(|line| Some((line.strip_prefix(CASE)?.split('/').next()?, line)))
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn report(engines: &[(&str, &[&str])]) -> Report {
        let engine = |(name, ids): &(&str, &[&str])| {
            let vector = json!({"roles": ["body"], "call": "watchdog.run", "args": {}, "expect": {}});
            let found = json!({"check": "c", "inputs": [], "vector": vector});
            let broken =
                |id: &&str| json!({"id": id, "property": "p", "family": "f", "about": "A.", "counterexample": found});
            json!({"name": name, "broken": ids.iter().map(broken).collect::<Vec<_>>()})
        };
        let engines: Vec<_> = engines.iter().map(engine).collect();
        Report { engines: serde_json::from_value(json!(engines)).unwrap(), ..Report::default() }
    }

    #[test]
    fn a_run_of_all_engines_writes_what_they_found() {
        let report = report(&[("symbolic", &["a", "b"]), ("model", &["c"])]);
        assert_eq!(vectors(&report, ""), report::vectors(&report));
        assert_eq!(vectors(&report, &report::vectors(&report)), report::vectors(&report));
    }

    #[test]
    fn a_run_of_one_engine_leaves_what_the_others_found() {
        let before = report::vectors(&report(&[("symbolic", &["a", "b"]), ("model", &["c"]), ("path", &["d"])]));
        let after = vectors(&report(&[("model", &["e", "f"])]), &before);
        assert_eq!(
            after,
            report::vectors(&report(&[("symbolic", &["a", "b"]), ("model", &["e", "f"]), ("path", &["d"])]))
        );
    }
}
