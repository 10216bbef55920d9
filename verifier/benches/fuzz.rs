//! How fast the search is: traces of 20 steps a second, with specification and peer in one process, and over standard
//! streams with the Rust peer.
//!
//! `cargo bench -p ncp-verifier --bench fuzz` prints the rates; the second needs the Rust peer, built in release mode.

use std::path::Path;
use std::time::{Duration, Instant};

use ncp_text::catalogue::Level;
use ncp_verifier::fuzz::{Extent, Harvest, Listener, Settings, fuzz, in_process};
use ncp_verifier::peer::{Connection, Launch, handshake};
use ncp_verifier::stop::Stop;
use ncp_verifier::suite::{Pattern, Suite};

/// The calls whose traces are timed.
const CALLS: [&str; 4] = ["watchdog.run", "link.run", "buffer.run", "governor.run"];
/// The steps of a trace.
const STEPS: usize = 20;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let quick = !std::env::args().any(|arg| arg == "--bench");
    let time = Duration::from_millis(if quick { 20 } else { 3000 });
    for call in CALLS {
        let filter = [Pattern::new(call)];
        let (started, mut traces) = (Instant::now(), 0);
        while started.elapsed() < time {
            traces += in_process(1, traces, 64, &filter, Some(STEPS));
        }
        let rate = traces as f64 / started.elapsed().as_secs_f64();
        println!("rate   in process  {call:<14} {rate:>8.0} traces of {STEPS} steps a second (aim: 20,000)");
    }
    let target = std::env::var("CARGO_TARGET_DIR").unwrap_or_else(|_| "../target".to_owned());
    let peer = Path::new(&target).join("release/ncp-peer-rust");
    if !peer.is_file() {
        println!("rate   over stdio  not measured: {} is not there", peer.display());
        return Ok(());
    }
    let suite = Suite::embedded()?;
    for call in CALLS {
        let launch = Launch::new(vec![peer.display().to_string()], ".");
        let stop = Stop::default();
        let mut connection = Connection::open(&launch)?;
        let description = handshake(&mut connection, Duration::from_secs(10), &stop)?;
        let settings = Settings {
            extent: Extent::Time(time),
            seed: 1,
            jobs: 1,
            patterns: vec![Pattern::new(call)],
            level: Level::Safety,
            roles: Vec::new(),
            timeout: Duration::from_secs(10),
            start_timeout: Duration::from_secs(10),
            memory: 1 << 30,
            tries: 100,
            harvest: Harvest::default(),
            length: Some(STEPS),
        };
        let tested = fuzz(&launch, connection, description, &suite, &settings, &Deaf, &stop)?;
        let rate = tested.inputs as f64 / tested.elapsed.as_secs_f64();
        println!("rate   over stdio  {call:<14} {rate:>8.0} traces of {STEPS} steps a second (aim: 5,000)");
    }
    Ok(())
}

/// Listens to nothing.
struct Deaf;

impl Listener for Deaf {
    fn asked(&self, _: u64) {}

    fn found(&self, _: &str, _: &str) {}
}
