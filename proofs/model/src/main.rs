//! Model checking of the protocol over a network that loses, duplicates and reorders. See `README.md`.

mod explore;
mod governor;
mod handshake;
mod plant;
mod sessions;
mod signs;

use std::path::PathBuf;
use std::process::ExitCode;
use std::{fs, io};

use clap::Parser;
use ncp_proofs::report::{Answer, Broken, Engine, owned};
use thiserror::Error;

use explore::{check, refute};

/// Explores every state of the protocol within its bounds, and refutes the broken variants.
#[derive(Debug, Parser)]
struct Arguments {
    /// Write the result there, as JSON.
    #[arg(long)]
    json: Option<PathBuf>,
    /// Only the small models of the tests.
    #[arg(long)]
    small: bool,
}

#[derive(Debug, Error)]
enum Failure {
    #[error("cannot write the result: {0}")]
    Json(#[from] serde_json::Error),
    #[error("cannot write {0}: {1}")]
    Write(PathBuf, io::Error),
    #[error("a claim is not proved, or a broken variant not refuted")]
    NotShown,
}

const TRUSTED: [&str; 5] = [
    "rustc, and the processor: the code runs as it was compiled",
    "stateright explores every state that its model reaches; two states with one 64-bit fingerprint would be taken \
     for one",
    "the network and the peers of each model are at least as hostile as real ones within the bounds",
    "what each model keeps of the text, beside the code, says what the text says",
    "the plant that lies beside the action buffer tells states apart as the buffer's own would; that both act alike \
     is checked in every state",
];
const NOT_PROVED: [&str; 4] = [
    "anything beyond the bounds: more frames, other times, longer traces",
    "liveness: that something happens at last",
    "horizons, channels and units: the models send one velocity and no horizon",
    "the transport: how a request and its reply belong together is the matter of Zenoh's queries",
];

fn main() -> ExitCode {
    let done = run(&Arguments::parse());
    if let Err(failure) = &done {
        eprintln!("ncp-model: {failure}");
    }
    if done.is_ok() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn run(arguments: &Arguments) -> Result<(), Failure> {
    let small = arguments.small;
    let results = [
        check::<plant::PlantSide>(small),
        check::<governor::Latches>(small),
        check::<sessions::Sessions>(small),
        check::<handshake::Versions>(small),
    ];
    let broken = [
        refute::<plant::PlantSide>(),
        refute::<governor::Latches>(),
        refute::<sessions::Sessions>(),
        refute::<handshake::Versions>(),
    ];
    let report = Engine {
        name: "model".to_owned(),
        version: "stateright 0.31.0".to_owned(),
        results: results.concat(),
        broken: broken.concat(),
        trusted: owned(&TRUSTED),
        not_proved: owned(&NOT_PROVED),
        ..Engine::default()
    };
    for claim in &report.results {
        println!("{:8} {}", claim.verdict.as_str(), claim.property);
    }
    for variant in &report.broken {
        println!("{:8} {}", if variant.is_refuted() { "refuted" } else { "NOT REFUTED" }, variant.id);
    }
    if let Some(file) = &arguments.json {
        let text = serde_json::to_string_pretty(&report)? + "\n";
        fs::write(file, text).map_err(|error| Failure::Write(file.clone(), error))?;
    }
    let is_shown = report.results.iter().all(Answer::is_proved) && report.broken.iter().all(Broken::is_refuted);
    is_shown.then_some(()).ok_or(Failure::NotShown)
}
