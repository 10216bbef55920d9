//! `ncp-mutants`: holds changed kernels against the properties. One line of JSON each says what refutes it, or that
//! nothing does; `--symbolic` asks the solvers, too.
#![forbid(unsafe_code)]

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

use ncp_proofs::engines::symbolic::{self, Solvers};
use ncp_proofs::engines::{Outcome, Patience, Verdict, compared, enumeration, standin};
use ncp_proofs::mutants::{MUTANTS, harness};
use ncp_proofs::properties::{PROPERTIES, Property};
use ncp_proofs::{report, terminal};
use serde_json::{Value, json};

const WORKERS: usize = 2;
/// Samples of a property: at first, and when the enumeration finds nothing.
const FEW: u64 = 2_000;
const MANY: u64 = 200_000;
/// What the solvers may take for one property.
const PATIENCE: Duration = Duration::from_secs(120);

fn main() -> ExitCode {
    let is_symbolic = std::env::args().any(|arg| arg == "--symbolic");
    let Some(root) = Path::new(env!("CARGO_MANIFEST_DIR")).parent() else {
        return ExitCode::FAILURE;
    };
    // A changed kernel may panic, which refutes it.
    std::panic::set_hook(Box::new(|_| {}));
    let next = AtomicUsize::new(0);
    thread::scope(|scope| {
        for worker in 0..WORKERS {
            let next = &next;
            scope.spawn(move || {
                while let Some((id, file)) = MUTANTS.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let answer = if is_symbolic {
                        by_solvers(id, root, worker)
                    } else {
                        by_numbers(id, file)
                    };
                    println!("{answer}");
                }
            });
        }
    });
    ExitCode::SUCCESS
}

/// Samples, and enumerates.
fn by_numbers(id: &str, file: &str) -> Value {
    let enumerated = |property: &Property| {
        let harness = harness(id, property.id)?;
        let outcome = enumeration::run(property, &harness, usize::MAX)?;
        refuted(id, "enumeration", property, &outcome)
    };
    let sampled = |samples, property: &Property| {
        let harness = harness(id, property.id)?;
        let outcome = standin::run(&harness, samples, usize::MAX);
        refuted(id, "kani-stand-in", property, &outcome)
    };
    // What production's numbers compute is said by one property, which samples do not widen.
    let is_number = file == "scalar.rs";
    let wanted = || {
        PROPERTIES
            .iter()
            .filter(|property| !is_number || property.id.starts_with("number/"))
    };
    wanted()
        .find_map(|property| sampled(FEW, property))
        .or_else(|| wanted().find_map(enumerated))
        .or_else(|| wanted().find_map(|property| sampled(MANY, property)))
        .unwrap_or_else(|| json!({ "id": id, "said": "no numbers refute it" }))
}

/// Asks the solvers of every property.
fn by_solvers(id: &str, root: &Path, worker: usize) -> Value {
    let mut undecided = Vec::new();
    for property in PROPERTIES {
        let Some(harness) = harness(id, property.id) else {
            continue;
        };
        let solvers = Solvers {
            bin: venv(root),
            script: root.join("proofs/evidence/solve.py"),
            patience: Patience::of(PATIENCE),
            known: Some(root.join(".tools/proofs-known")),
        };
        let evidence = root.join(format!(".tools/mutants/evidence-{worker}"));
        let outcome = symbolic::prove(property, &harness, &solvers, &evidence);
        if let Some(answer) = refuted(id, "symbolic", property, &outcome) {
            return answer;
        }
        if outcome.verdict != Verdict::Proved {
            undecided.push(format!("{}: {}", property.id, outcome.detail));
        }
    }
    let said = if undecided.is_empty() {
        "every property is proved of it".to_owned()
    } else {
        format!("undecided: {}", undecided.join("; "))
    };
    json!({ "id": id, "said": said })
}

fn venv(root: &Path) -> PathBuf {
    let bin = if cfg!(windows) { "Scripts" } else { "bin" };
    root.join(".tools/proofs-venv").join(bin)
}

fn refuted(id: &str, engine: &str, property: &Property, outcome: &Outcome) -> Option<Value> {
    let found = outcome.counterexample.as_ref()?;
    let harness = harness(id, property.id)?;
    let compared = compared(&harness, found, usize::MAX);
    let shown = report::counterexample(property.id, &harness, found);
    let shown = terminal::with_compared(shown, compared);
    Some(json!({
        "id": id, "said": format!("refuted by {}, {engine}", property.id), "property": property.id,
        "engine": engine, "counterexample": shown,
    }))
}
