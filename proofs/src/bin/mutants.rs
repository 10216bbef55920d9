//! `ncp-mutants`: holds changed kernels against the properties. One line of JSON each says what refutes it, or that
//! nothing does; `--symbolic` asks the solvers, too. Each is held by a process of its own, as it may not come to an
//! end.
#![forbid(unsafe_code)]

use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitCode, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use ncp_proofs::engines::symbolic::{self, Limits, Solvers};
use ncp_proofs::engines::{Outcome, Patience, Verdict, enumeration, standin};
use ncp_proofs::harness::compared;
use ncp_proofs::mutants::{MUTANTS, harness};
use ncp_proofs::properties::{PROPERTIES, Property};
use ncp_proofs::report;
use serde_json::{Value, json};

const WORKERS: usize = 2;
/// Samples of a property: at first, and when the enumeration finds nothing.
const FEW: u64 = 2_000;
const MANY: u64 = 200_000;
/// What the solvers may take for one property; on the kernel as it is, each takes less.
const PER_PROPERTY: Duration = Duration::from_secs(40);
/// And for all properties of one changed kernel.
const PER_CHANGE: Duration = Duration::from_secs(150);
/// A process that takes longer goes on without an end.
const MOST: Duration = Duration::from_secs(400);

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    let Some(root) = Path::new(env!("CARGO_MANIFEST_DIR")).parent() else {
        return ExitCode::FAILURE;
    };
    match args[..] {
        [] | ["--symbolic"] => {
            hold_all(&args);
            ExitCode::SUCCESS
        }
        ["--one", id] | ["--one", id, "--symbolic"] => {
            // A changed kernel may panic, which refutes it.
            std::panic::set_hook(Box::new(|_| {}));
            let Some((id, is_number)) = MUTANTS.iter().find(|(other, _)| *other == id) else {
                return ExitCode::FAILURE;
            };
            let answer = match args.len() {
                2 => by_numbers(id, *is_number),
                _ => by_solvers(id, root),
            };
            println!("{answer}");
            ExitCode::SUCCESS
        }
        _ => {
            eprintln!("Usage: ncp-mutants [--one ID] [--symbolic]");
            ExitCode::from(2)
        }
    }
}

/// Holds every changed kernel, some at a time.
fn hold_all(options: &[&str]) {
    let next = AtomicUsize::new(0);
    thread::scope(|scope| {
        for _ in 0..WORKERS {
            scope.spawn(|| {
                while let Some((id, _)) = MUTANTS.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let answer = hold(id, options);
                    println!("{}", answer.unwrap_or_else(|why| json!({ "id": id, "said": why })));
                }
            });
        }
    });
}

/// Holds one of them in a process of its own.
fn hold(id: &str, options: &[&str]) -> Result<Value, String> {
    let failed = |error: std::io::Error| format!("not held against anything: {error}");
    let program = std::env::current_exe().map_err(failed)?;
    let mut command = Command::new(program);
    command.args(["--one", id]).args(options).stdout(Stdio::piped());
    let mut child = command.spawn().map_err(failed)?;
    end_in_time(&mut child).map_err(failed)?;
    let output = child.wait_with_output().map_err(failed)?;
    serde_json::from_slice(&output.stdout).map_err(|_| "not decided in time".to_owned())
}

/// Waits for a process, and ends it when it takes too long. Its one answer fits into the pipe.
fn end_in_time(child: &mut Child) -> std::io::Result<()> {
    let until = Instant::now() + MOST;
    while child.try_wait()?.is_none() {
        if Instant::now() > until {
            return child.kill();
        }
        thread::sleep(Duration::from_millis(20));
    }
    Ok(())
}

/// Samples, and enumerates.
fn by_numbers(id: &str, is_number: bool) -> Value {
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
    let wanted = || PROPERTIES.iter().filter(|property| !is_number || property.id.starts_with("number/"));
    wanted()
        .find_map(|property| sampled(FEW, property))
        .or_else(|| wanted().find_map(enumerated))
        .or_else(|| wanted().find_map(|property| sampled(MANY, property)))
        .unwrap_or_else(|| json!({ "id": id, "said": "no numbers refute it" }))
}

/// Asks the solvers of every property.
fn by_solvers(id: &str, root: &Path) -> Value {
    let mut undecided = Vec::new();
    let until = Instant::now() + PER_CHANGE;
    for property in PROPERTIES {
        let left = until.saturating_duration_since(Instant::now());
        let Some(harness) = harness(id, property.id) else {
            continue;
        };
        let solvers = Solvers {
            bin: venv(root),
            script: root.join("proofs/evidence/solve.py"),
            patience: Patience::of(left.min(PER_PROPERTY)),
            limits: Limits::default(),
            known: Some(root.join(".tools/proofs-known")),
        };
        let evidence = root.join(".tools/mutants/evidence").join(id);
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
    let mut shown = report::counterexample(property.id, &harness, found);
    shown.compared = compared(&harness, found, usize::MAX);
    Some(json!({
        "id": id, "said": format!("refuted by {}, {engine}", property.id), "property": property.id,
        "engine": engine, "counterexample": shown,
    }))
}
