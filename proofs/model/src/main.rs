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
use serde_json::{Value, json};
use sha2::{Digest, Sha256};
use thiserror::Error;

use explore::{Broken, Checked, check, refute};

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
    #[error("cannot write {0}: {1}")]
    Write(PathBuf, io::Error),
    #[error("a claim is not proved, or a broken variant not refuted")]
    NotShown,
}

const TRUSTED: [&str; 5] = [
    "rustc, and the processor: the code runs as it was compiled",
    "stateright explores every state that its model reaches; two states with one 64-bit fingerprint would be taken for one",
    "the network and the peers of each model are at least as hostile as real ones within the bounds",
    "what each model keeps of the text, beside the code, says what the text says",
    "the plant that lies beside the action buffer tells states apart as the buffer's own would; that both act alike is checked in every state",
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
    let mut claims = check::<plant::PlantSide>(small);
    claims.extend(check::<governor::Latches>(small));
    claims.extend(check::<sessions::Sessions>(small));
    claims.extend(check::<handshake::Versions>(small));
    let mut broken = refute::<plant::PlantSide>();
    broken.extend(refute::<governor::Latches>());
    broken.extend(refute::<sessions::Sessions>());
    broken.extend(refute::<handshake::Versions>());
    for claim in &claims {
        println!(
            "{:8} {}: {} states, depth {}, {} s",
            claim.result, claim.id, claim.states, claim.depth, claim.seconds
        );
    }
    for variant in &broken {
        let word = if variant.refuted { "refuted" } else { "NOT REFUTED" };
        println!("{word:8} {}", variant.id);
    }
    if let Some(file) = &arguments.json {
        let text = format!("{:#}\n", report(&claims, &broken));
        fs::write(file, text).map_err(|error| Failure::Write(file.clone(), error))?;
    }
    let shown = claims.iter().all(|claim| claim.result == "proved");
    if shown && broken.iter().all(|variant| variant.refuted) { Ok(()) } else { Err(Failure::NotShown) }
}

fn report(claims: &[Checked], broken: &[Broken]) -> Value {
    json!({
        "engine": "model checking",
        "version": "stateright 0.31.0",
        "properties": claims,
        "broken": broken,
        "trusted": TRUSTED,
        "not_proved": NOT_PROVED,
        "code_digest": code_digest(),
    })
}

/// Of the source of what runs in the models.
fn code_digest() -> String {
    const SOURCES: [&str; 12] = [
        include_str!("../../../spec/src/safety/governor.rs"),
        include_str!("../../../spec/src/safety/kernel/deadline.rs"),
        include_str!("../../../spec/src/safety/kernel/fence.rs"),
        include_str!("../../../spec/src/safety/kernel/gates.rs"),
        include_str!("../../../spec/src/safety/kernel/order.rs"),
        include_str!("../../../spec/src/safety/kernel/plant.rs"),
        include_str!("../../../spec/src/safety/kernel/watchdog.rs"),
        include_str!("../../../spec/src/resilience/action_buffer.rs"),
        include_str!("../../../spec/src/session/service.rs"),
        include_str!("../../../spec/src/version.rs"),
        include_str!("../../../spec/src/contract.rs"),
        include_str!("../../../spec/src/reply.rs"),
    ];
    let mut total = Sha256::new();
    for source in SOURCES {
        total.update(source);
        total.update([0]);
    }
    total.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}
