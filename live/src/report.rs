//! Verdicts as people read them.

use crate::verdict::{Ruling, Verdict};

/// A line for a scenario that has been run.
pub(crate) fn progress(scenario: &str, rulings: &[Ruling]) {
    let worst = rulings.iter().map(|ruling| ruling.verdict).max().unwrap_or(Verdict::Inconclusive);
    eprintln!("{scenario:34} {worst}");
}

/// The matrix: scenario, rule, verdict, how much was observed; then what did not pass, with the sentence of its rule.
pub(crate) fn matrix(rulings: &[Ruling]) {
    println!("{:34} {:15} {:13} observed", "scenario", "rule", "verdict");
    for Ruling { scenario, rule, verdict, observed, measured, .. } in rulings {
        let measured = measured.map(|measured| format!("  {measured}")).unwrap_or_default();
        println!("{scenario:34} {rule:15} {verdict:13} {observed:8}{measured}");
    }
    for Ruling { scenario, rule, verdict, why, sentence, .. } in rulings {
        if let Some(why) = why {
            println!("\n{verdict}: {rule} in {scenario}\n  {sentence}\n  {why}");
        }
    }
    let count = |of| rulings.iter().filter(|ruling| ruling.verdict == of).count();
    let [passed, failed, unclear] = [Verdict::Passed, Verdict::Failed, Verdict::Inconclusive].map(count);
    println!("\n{} verdicts: {passed} passed, {failed} failed, {unclear} inconclusive", rulings.len());
}
