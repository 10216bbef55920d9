//! How fast a run is, and what its report costs, in one table.
//!
//! `cargo bench -p ncp-verifier --bench run` needs the Rust peer, built in release mode, and prints absolute numbers,
//! each the best of some runs beside what it aims at. Without a Chromium (`NCP_CHROMIUM` names one) the opening of the
//! page is not measured.

use std::error::Error;
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use ncp_verifier::peer::{Connection, Launch, handshake};
use ncp_verifier::run::{Deaf, Outcome, Settings, run};
use ncp_verifier::stop::Stop;
use ncp_verifier::suite::{Case, Suite};
use serde_json::{Value, json};

type Any<T> = Result<T, Box<dyn Error>>;

/// Of so many runs, the best counts: others share the machine.
const RUNS: usize = 5;
/// From this size on a request is one at the limit of a frame.
const AT_THE_LIMIT: usize = 32 << 20;
/// How often each case is asked for the rate of the steady state.
const REPEAT: u32 = 30;
/// The peers of the large report; of each, one case in as many fails.
const PEERS: usize = 20;
/// The cases that each of them has.
const CASES: usize = 10_000;

fn main() -> Any<()> {
    let quick = !std::env::args().any(|arg| arg == "--bench");
    let target = std::env::var("CARGO_TARGET_DIR").unwrap_or_else(|_| "../target".to_owned());
    let peer = std::path::absolute(Path::new(&target).join("release/ncp-peer-rust"))?;
    if !peer.is_file() {
        println!("not measured: {} is not there", peer.display());
        return Ok(());
    }
    if quick {
        return asked(&peer, 1, |case| !case.is_large()).map(drop);
    }
    let folder = tempfile::tempdir()?;
    let file = |name: &str| folder.path().join(name);
    let (result, large, page, empty) = (file("result.json"), file("large.json"), file("page.html"), file("empty.html"));
    let of_peer = format!("--peer-cmd={}", peer.display());
    let whole = || program(&["run", "--level", "strict", &of_peer, "--json"], &[&result]);
    println!("{:<48} {:>12} {:>12}", "what", "measured", "aim");
    row("the corpus at level strict, the whole program", &seconds(best(|| timed(whole()))?.0), "2 s");
    row("  the most memory of the verifier", &most_memory(whole())?, "");
    let small = best(|| asked(&peer, 1, |case| case.request_bytes() < AT_THE_LIMIT))?;
    row("  without the requests of 64 MiB", &seconds(small.0), "0.2 s");
    let steady = best(|| asked(&peer, REPEAT, |case| !case.is_large()))?;
    row("cases up to 64 KiB in the steady state", &format!("{:.0}/s", steady.1), "150,000/s");
    enlarge(&result, &large)?;
    std::fs::write(&empty, "<!doctype html>")?;
    row("a result of 20 peers with 10,000 cases each", &megabytes(&large)?, "");
    let convert = || program(&["convert", "--to", "html"], &[&large, Path::new("-o"), &page]);
    row("  made a page", &seconds(best(|| timed(convert()))?.0), "");
    row("  the most memory of the verifier", &most_memory(convert())?, "200 MB");
    row("  the size of the page", &megabytes(&page)?, "10 MB");
    let opening = opened(&page, &empty).map_or_else(|why| format!("not measured: {why}"), seconds);
    row("  the page opens in Chromium", &opening, "1 s");
    Ok(())
}

/// The best time of some runs, with what came with it.
fn best<T>(mut measure: impl FnMut() -> Any<(Duration, T)>) -> Any<(Duration, T)> {
    let mut best = measure()?;
    for _ in 1..RUNS {
        let next = measure()?;
        if next.0 < best.0 {
            best = next;
        }
    }
    Ok(best)
}

fn row(what: &str, measured: &str, aim: &str) {
    println!("{what:<48} {measured:>12} {aim:>12}");
}

fn seconds(time: Duration) -> String {
    format!("{:.2} s", time.as_secs_f64())
}

fn megabytes(file: &Path) -> Any<String> {
    Ok(format!("{:.1} MB", std::fs::metadata(file)?.len() as f64 / 1e6))
}

/// The program, with words and then files.
fn program(words: &[&str], files: &[&Path]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ncp-verify"));
    command.args(words).args(files).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command
}

/// How long a command takes.
fn timed(mut command: Command) -> Any<(Duration, ())> {
    let started = Instant::now();
    let status = command.status()?;
    if status.success() { Ok((started.elapsed(), ())) } else { Err(format!("{command:?} ended with {status}").into()) }
}

/// The most memory that a command holds, where the operating system tells.
fn most_memory(mut command: Command) -> Any<String> {
    let mut child = command.spawn()?;
    let status = format!("/proc/{}/status", child.id());
    let mut most: f64 = 0.0;
    while child.try_wait()?.is_none() {
        let text = std::fs::read_to_string(&status).unwrap_or_default();
        let told: Option<f64> =
            text.lines().find_map(|line| line.strip_prefix("VmHWM:")?.trim().strip_suffix(" kB")?.parse().ok());
        most = told.unwrap_or(0.0).max(most);
        std::thread::sleep(Duration::from_millis(2));
    }
    Ok(if most > 0.0 { format!("{:.0} MB", most * 1024.0 / 1e6) } else { "not told".to_owned() })
}

/// Reads the vectors, starts the peer and asks it the cases that are meant: how long that takes, and the rate.
fn asked(peer: &Path, repeat: u32, is_meant: impl Fn(&Case) -> bool) -> Any<(Duration, f64)> {
    let (started, stop) = (Instant::now(), Stop::default());
    let suite = Suite::embedded()?;
    let launch = Launch::new(vec![peer.display().to_string()], ".");
    let mut connection = Connection::open(&launch)?;
    handshake(&mut connection, Duration::from_secs(10), &stop)?;
    let cases: Vec<&Case> = suite.cases().iter().filter(|case| is_meant(case)).collect();
    let settings = Settings { repeat, ..Settings::default() };
    let record = run(&launch, connection, &cases, &settings, &Deaf, &stop);
    if let Some(wrong) = record.cases.iter().find(|case| case.outcome != Outcome::Pass) {
        return Err(format!("the Rust peer fails: {wrong:?}").into());
    }
    let rate = record.rate.map_or(0.0, |rate| rate.answers as f64 / rate.elapsed.as_secs_f64());
    Ok((started.elapsed(), rate))
}

/// A result of many peers from that of one: of each, another twentieth of the cases fails.
fn enlarge(result: &Path, large: &Path) -> Any<()> {
    let mut report: Value = serde_json::from_slice(&std::fs::read(result)?)?;
    let one = report["peers"][0].take();
    let cases = one["cases"].as_array().ok_or("the result has no cases")?;
    let peer = |number: usize| {
        let case = |(place, case): (usize, &Value)| {
            let mut case = case.clone();
            case["id"] = format!("{}-{place}", case["id"].as_str().unwrap_or_default()).into();
            if place % PEERS == number {
                let request = format!("{{\"call\":\"decode\",\"args\":{{\"text\":\"{}\"}}}}", "x".repeat(place % 1000));
                let differs = json!({"at": "/a", "expected": "1", "got": "2", "hint": null, "text": "/a: expected 1"});
                let more = json!({
                    "outcome": "fail", "status": "failed", "ruling": "failed", "charged": case["rules"][0],
                    "expected": "the result {}", "differences": [differs], "place": "/a", "request": request,
                    "answer": request,
                });
                case.as_object_mut()
                    .into_iter()
                    .for_each(|case| case.extend(more.as_object().cloned().unwrap_or_default()));
            }
            case
        };
        let mut peer = one.clone();
        peer["name"] = format!("peer-{number}").into();
        peer["cases"] = cases.iter().cycle().take(CASES).enumerate().map(case).collect();
        peer
    };
    report["peers"] = (0..PEERS).map(peer).collect();
    Ok(serde_json::to_writer_pretty(BufWriter::new(File::create(large)?), &report)?)
}

/// How long Chromium takes longer for a page than for an empty one.
fn opened(page: &Path, empty: &Path) -> Any<Duration> {
    let chromium = std::env::var_os("NCP_CHROMIUM").unwrap_or_else(|| "chromium".into());
    let open = |page: &Path| {
        let profile = tempfile::tempdir()?;
        let mut command = Command::new(&chromium);
        command.args(["--headless", "--no-sandbox", "--disable-gpu", "--virtual-time-budget=30000", "--dump-dom"]);
        command.arg(format!("--user-data-dir={}", profile.path().display())).arg(format!("file://{}", page.display()));
        let started = Instant::now();
        let output = command.stderr(Stdio::null()).output()?;
        let shown = page == empty || String::from_utf8_lossy(&output.stdout).contains("data-ready=\"1\"");
        if shown { Ok((started.elapsed(), ())) } else { Err("the page is not ready".into()) }
    };
    let ((of_page, ()), (of_empty, ())) = (best(|| open(page))?, best(|| open(empty))?);
    Ok(of_page.saturating_sub(of_empty))
}
