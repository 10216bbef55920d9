//! The real program against peers that listen: over TCP and WebSocket it finds what it finds over standard streams, and
//! a connection that is lost costs what a process costs that dies.

#![cfg(unix)]
#![expect(clippy::unwrap_used, clippy::panic, reason = "a test may fail that way")]

use std::collections::BTreeMap;
use std::io::{Read as _, Write as _};
use std::net::{Shutdown, TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use serde_json::{Value, json};
use tempfile::TempDir;

mod common;
mod made;

const TARGET: &str = "version/tiny/07-target";
const SCHEMES: [&str; 2] = ["tcp", "ws"];

/// What a run of the program left.
struct Run {
    exit: i32,
    stdout: String,
    stderr: String,
    result: Option<Value>,
}

impl Run {
    fn peer(&self) -> &Value {
        &self.result.as_ref().unwrap_or_else(|| panic!("no result: {}", self.stderr))["peers"][0]
    }

    /// The cases that did not pass: id and outcome.
    fn faults(&self) -> BTreeMap<String, String> {
        let text = |value: &Value| value.as_str().unwrap().to_owned();
        let cases = self.peer()["cases"].as_array().unwrap().iter();
        cases.filter(|case| case["outcome"] != "pass").map(|case| (text(&case["id"]), text(&case["outcome"]))).collect()
    }

    fn case(&self, id: &str) -> &Value {
        self.peer()["cases"].as_array().unwrap().iter().find(|case| case["id"] == id).unwrap()
    }
}

fn example(name: &str) -> String {
    let folder = Path::new(env!("CARGO_BIN_EXE_ncp-verify")).parent().unwrap().join("examples");
    folder.join(name).display().to_string()
}

fn verify(args: &[&str]) -> Run {
    verify_by("tests/data/vectors", args)
}

/// Runs the program by the vectors of a folder.
fn verify_by(vectors: &str, args: &[&str]) -> Run {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("result.json");
    let output = Command::new(env!("CARGO_BIN_EXE_ncp-verify"))
        .env("COLUMNS", "200")
        .args(["run", "--vectors", vectors, "--start-timeout", "5", "--json"])
        .arg(&file)
        .args(args)
        .stdin(Stdio::null())
        .output()
        .unwrap();
    Run {
        exit: output.status.code().unwrap(),
        stdout: String::from_utf8(output.stdout).unwrap(),
        stderr: String::from_utf8(output.stderr).unwrap(),
        result: std::fs::read_to_string(&file).ok().map(|text| common::read_result(&text)),
    }
}

/// A folder with a `peer.toml` whose command listens at its address.
fn folder(connect: &str, command: &[&str]) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let manifest = toml::toml! { name = "listener" language = "Rust" };
    let mut manifest = toml::Table::from(manifest);
    manifest.insert("connect".to_owned(), connect.into());
    if !command.is_empty() {
        manifest.insert("command".to_owned(), command.to_vec().into());
    }
    std::fs::write(folder.path().join("peer.toml"), manifest.to_string()).unwrap();
    folder
}

/// Runs the hostile peer in a mode, each connection in a server of its own that the verifier starts.
fn started(scheme: &str, mode: &[&str], args: &[&str]) -> Run {
    let address = format!("{scheme}://127.0.0.1:{{port}}");
    let (listen, hostile) = (example("listen"), example("hostile-peer"));
    let folder = folder(&address, &[&[&*listen, &*address, &*hostile], mode].concat());
    verify(&[&["--peer", folder.path().to_str().unwrap()], args].concat())
}

fn free_port() -> u16 {
    TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap().port()
}

/// A server that nobody starts for the verifier.
struct Server(Child, u16);

impl Server {
    fn start(command: impl FnOnce(u16) -> Command) -> Self {
        let port = free_port();
        let child = command(port).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
        Self(child, port)
    }

    /// The hostile peer in a mode, a process a connection.
    fn hostile(scheme: &str, mode: &[&str]) -> Self {
        Self::start(|port| {
            let mut command = Command::new(example("listen"));
            command.arg(format!("{scheme}://127.0.0.1:{port}")).arg(example("hostile-peer")).args(mode);
            command
        })
    }

    /// Until it listens.
    fn wait(&self) {
        let deadline = Instant::now() + Duration::from_secs(10);
        while TcpStream::connect(("127.0.0.1", self.1)).is_err() {
            assert!(Instant::now() < deadline);
            thread::sleep(Duration::from_millis(20));
        }
    }

    fn url(&self, scheme: &str) -> String {
        format!("{scheme}://127.0.0.1:{}", self.1)
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        self.0.kill().unwrap();
        self.0.wait().unwrap();
    }
}

/// A script that puts the starter, or what it is told, behind a TCP socket: one connection at a time.
fn python(args: &[&str]) -> impl FnOnce(u16) -> Command {
    let args: Vec<String> = args.iter().map(|arg| (*arg).to_owned()).collect();
    move |port| {
        let mut command = Command::new("python3");
        command.arg("tests/data/serve.py").arg(port.to_string()).args(args);
        command
    }
}

#[test]
fn an_honest_server_conforms_and_takes_several_connections() {
    for scheme in SCHEMES {
        let server = Server::hostile(scheme, &["honest"]);
        for jobs in ["1", "3"] {
            let run = verify(&["--connect", &server.url(scheme), "--jobs", jobs]);
            assert_eq!((run.exit, run.faults().len()), (0, 0), "{scheme}: {}{}", run.stdout, run.stderr);
            assert_eq!(run.peer()["source"].as_str().unwrap().trim_end_matches('/'), server.url(scheme));
            assert_eq!(run.peer()["run"]["notes"], Value::Array(Vec::new()));
        }
    }
}

#[test]
fn a_fault_that_belongs_to_one_case_costs_that_case_on_every_road() {
    for (mode, outcome, on_frames) in [
        ("wrong-answer", "fail", "fail"),
        ("die-on-target", "crash", "crash"),
        ("die-after-target", "crash", "crash"),
        ("sleep-on-target", "timeout", "timeout"),
        ("skips-target", "timeout", "timeout"),
        ("binary-on-target", "protocol", "protocol"),
        ("prints-after-target", "protocol", "protocol"),
        ("prints-late-after-target", "protocol", "protocol"),
        ("twice-on-target", "protocol", "protocol"),
        ("unknown-id-on-target", "protocol", "protocol"),
        ("no-result-on-target", "protocol", "protocol"),
        ("huge-line-on-target", "protocol", "protocol"),
        // A frame that is not whole is none.
        ("half-a-line-on-target", "protocol", "crash"),
    ] {
        let timeout = if outcome == "timeout" { "1" } else { "10" };
        for (scheme, outcome) in [("tcp", outcome), ("ws", on_frames)] {
            let expected = BTreeMap::from([(TARGET.to_owned(), outcome.to_owned())]);
            let run = started(scheme, &[mode], &["--timeout", timeout]);
            assert_eq!((run.exit, run.faults()), (1, expected.clone()), "{scheme} {mode}: {}", run.stdout);
            let server = Server::hostile(scheme, &[mode]);
            let run = verify(&["--connect", &server.url(scheme), "--timeout", timeout]);
            assert_eq!((run.exit, run.faults()), (1, expected), "{scheme} {mode}: {}", run.stdout);
        }
    }
}

/// A folder of vectors with one frame of so many bytes, which has to be read and written whole.
fn a_large_frame(folder: &Path, bytes: usize) -> String {
    let head = r#"{"kind":"observation_frame","session_id":"s","seq":3,"t":1.5,"sim_time_ms":2.0,"#;
    let pins = r#""calibrated_posterior":false,"is_simulation_output":true,"#;
    let records = r#""records":{"a":{"port":"a","target":"b","values":[],"senders":[],"times":["#;
    let text = json!({"$concat": [head, pins, records, {"$repeat": "-0.25,", "times": bytes / 6}, "1.5]}}}"]});
    let case = json!({
        "id": "wire/large/frame", "title": "A large frame is read.", "why": "W.", "requirements": ["NCP-WIRE-015"],
        "flags": ["large"], "roles": ["observer"], "call": "decode",
        "args": {"kind": "observation_frame", "text": text}, "expect": {"relation": "message", "text": text}
    });
    made::vectors(folder, "wire", "large", "large", &[case])
}

#[test]
fn requests_and_answers_of_many_megabytes_travel_whole_on_every_road() {
    let folder = tempfile::tempdir().unwrap();
    let vectors = a_large_frame(folder.path(), 6 << 20);
    for scheme in SCHEMES {
        for (mode, faults) in [("honest", 0), ("cuts-large", 1)] {
            let server = Server::hostile(scheme, &[mode]);
            let run = verify_by(&vectors, &["--connect", &server.url(scheme)]);
            assert_eq!(run.faults().len(), faults, "{scheme} {mode}: {}{}", run.stdout, run.stderr);
            assert_eq!(run.peer()["totals"]["total"], 2, "describe and the frame");
        }
    }
}

#[test]
fn of_a_server_that_is_started_exit_status_and_log_are_told() {
    let folder =
        folder("tcp://127.0.0.1:{port}", &["python3", &serve(), "{port}", "fragile", &example("hostile-peer")]);
    let run = verify(&["--peer", folder.path().to_str().unwrap()]);
    assert_eq!(run.faults(), BTreeMap::from([(TARGET.to_owned(), "crash".to_owned())]), "{}", run.stdout);
    let case = run.case(TARGET);
    assert_eq!((&case["what"], &case["log"]), (&"exited with status 3".into(), &"asked for 9.9".into()));
    let run = verify(&["--peer", folder.path().to_str().unwrap(), "--jobs", "3"]);
    assert_eq!(run.faults().into_keys().collect::<Vec<_>>(), [TARGET], "each job has a server of its own");
}

fn serve() -> String {
    std::env::current_dir().unwrap().join("tests/data/serve.py").display().to_string()
}

#[test]
fn a_server_with_a_fixed_port_is_started_anew_after_its_crash_and_has_no_use_for_jobs() {
    let port = free_port().to_string();
    let address = format!("tcp://127.0.0.1:{port}");
    let folder = folder(&address, &["python3", &serve(), &port, "fragile", &example("hostile-peer")]);
    let peer = folder.path().to_str().unwrap();
    let run = verify(&["--peer", peer]);
    assert_eq!(run.faults(), BTreeMap::from([(TARGET.to_owned(), "crash".to_owned())]), "{}", run.stdout);
    let run = verify(&["--peer", peer, "--jobs", "2"]);
    assert_eq!(run.exit, 2);
    assert!(run.stderr.contains("listener has a fixed port, so that there can be one of it"), "{}", run.stderr);
    let _other = TcpListener::bind(("127.0.0.1", port.parse().unwrap())).unwrap();
    let run = verify(&["--peer", peer]);
    assert_eq!(run.exit, 3);
    assert!(run.stderr.contains(&format!("something listens already at {address}")), "{}", run.stderr);
}

#[test]
fn the_starter_behind_a_socket_gets_the_verdict_that_it_gets_on_its_standard_streams() {
    let starter = "../peers/PROTOCOL-starter.py";
    let streams = verify(&["--peer-cmd", &format!("python3 {starter}")]);
    let server = Server::start(python(&["starter", starter]));
    let socket = verify(&["--connect", &server.url("tcp")]);
    assert_eq!((streams.exit, socket.exit), (1, 1));
    assert_eq!(socket.faults(), streams.faults());
    assert_eq!(socket.peer()["roles"], streams.peer()["roles"]);
    assert_eq!(socket.peer()["totals"], streams.peer()["totals"]);
}

#[test]
fn a_server_of_one_connection_at_a_time_is_asked_by_one_job_however_many_there_may_be() {
    let server = Server::start(python(&["starter", "../peers/PROTOCOL-starter.py"]));
    let one = verify(&["--connect", &server.url("tcp")]);
    let three = verify(&["--connect", &server.url("tcp"), "--jobs", "3"]);
    assert_eq!(three.faults(), one.faults(), "{}", three.stdout);
    assert_eq!(three.peer()["run"]["given_up"], Value::Null);
}

#[test]
fn a_crash_of_a_server_that_several_connections_share_is_charged_to_one_case() {
    let server = Supervised::start(0.0);
    let run = verify(&["--connect", &server.0.url("tcp"), "--jobs", "4"]);
    assert_eq!(run.faults(), BTreeMap::from([(TARGET.to_owned(), "crash".to_owned())]), "{}", run.stdout);
    assert_eq!(run.case(TARGET)["what"], "closed the connection");
}

/// A server that is started anew after each death, which ends all its connections: so many seconds later.
struct Supervised(Server);

impl Supervised {
    fn start(pause: f64) -> Self {
        let (serve, hostile) = (serve(), example("hostile-peer"));
        let script = format!("while :; do python3 {serve} $0 fragile {hostile}; sleep {pause}; done");
        Self(Server::start(|port| {
            let mut command = Command::new("sh");
            std::os::unix::process::CommandExt::process_group(&mut command, 0);
            command.args(["-c", &script, &port.to_string()]);
            command
        }))
    }
}

impl Drop for Supervised {
    fn drop(&mut self) {
        let pid = rustix::process::Pid::from_child(&self.0.0);
        rustix::process::kill_process_group(pid, rustix::process::Signal::KILL).unwrap();
    }
}

#[test]
fn a_server_that_comes_back_behind_a_proxy_that_accepts_meanwhile_is_asked_on() {
    let server = Supervised::start(1.0);
    server.0.wait();
    let port = cutting(server.0.1, Vec::new());
    let run = verify(&["--connect", &format!("tcp://127.0.0.1:{port}")]);
    assert_eq!(run.faults(), BTreeMap::from([(TARGET.to_owned(), "crash".to_owned())]), "{}", run.stdout);
}

/// Passes bytes on between a client and a server, and cuts off each of the first connections after so many bytes of
/// answers. Where the server is gone, it accepts and closes, as what stands before a server does.
fn cutting(server: u16, cuts: Vec<usize>) -> u16 {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = listener.local_addr().unwrap().port();
    thread::spawn(move || {
        let mut cuts = cuts.into_iter();
        for client in listener.incoming() {
            let client = client.unwrap();
            let Ok(server) = TcpStream::connect(("127.0.0.1", server)) else { continue };
            let mut left = cuts.next().unwrap_or(usize::MAX);
            let (mut from, mut to) = (client.try_clone().unwrap(), server.try_clone().unwrap());
            thread::spawn(move || {
                let _ = std::io::copy(&mut from, &mut to);
                let _ = to.shutdown(Shutdown::Write);
            });
            let (mut from, mut to) = (server, client);
            thread::spawn(move || {
                let mut piece = [0; 512];
                while let Ok(count @ 1..) = from.read(&mut piece) {
                    let count = count.min(left);
                    left -= count;
                    if to.write_all(&piece[..count]).is_err() || left == 0 {
                        break;
                    }
                }
                let _ = (from.shutdown(Shutdown::Both), to.shutdown(Shutdown::Both));
            });
        }
    });
    port
}

#[test]
fn connections_that_are_cut_at_random_cost_a_case_each_at_most() {
    let cuts = vec![420, 811, 530, 307, 1004, 699];
    for scheme in SCHEMES {
        let server = Server::hostile(scheme, &["honest"]);
        server.wait();
        for jobs in ["1", "2"] {
            let port = cutting(server.1, cuts.clone());
            let run = verify(&["--connect", &format!("{scheme}://127.0.0.1:{port}"), "--repeat", "20", "--jobs", jobs]);
            let faults = run.faults();
            assert!(!faults.is_empty() && faults.len() <= cuts.len(), "{scheme} {jobs}: {faults:?}\n{}", run.stdout);
            assert!(faults.values().all(|outcome| ["crash", "protocol"].contains(&&**outcome)), "{faults:?}");
            assert_eq!(run.peer()["totals"]["not_run"], 0, "{}", run.stdout);
        }
    }
}

#[test]
fn where_nobody_listens_it_is_said_within_seconds() {
    for url in [format!("tcp://127.0.0.1:{}", free_port()), format!("ws://127.0.0.1:{}/", free_port())] {
        let run = verify(&["--connect", &url]);
        assert_eq!(run.exit, 3, "{}", run.stderr);
        assert!(run.stderr.starts_with(&format!("error: `{url}` cannot be reached: ")), "{}", run.stderr);
        assert_eq!(run.stderr.matches("error:").count(), 1, "{}", run.stderr);
        assert!(run.stderr.contains("start the server first"), "{}", run.stderr);
    }
    let run = verify(&["--connect", "http://localhost:1"]);
    assert_eq!(run.exit, 2);
    assert!(run.stderr.contains("is no address of a peer: tcp://HOST:PORT or ws://HOST:PORT/PATH"), "{}", run.stderr);
}

#[test]
fn a_peer_that_listens_is_searched_too() {
    let server = Server::hostile("ws", &["wrong-answer"]);
    let output = Command::new(env!("CARGO_BIN_EXE_ncp-verify"))
        .args(["fuzz", "--connect", &server.url("ws"), "--cases", "200", "--seed", "7", "--filter", "version.check"])
        .output()
        .unwrap();
    // It errs by one version, and that is not drawn.
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stdout));
    let command = PathBuf::from(example("hostile-peer"));
    let streams = Command::new(env!("CARGO_BIN_EXE_ncp-verify"))
        .args(["fuzz", "--peer-cmd", &format!("{} wrong-answer", command.display())])
        .args(["--cases", "200", "--seed", "7", "--filter", "version.check"])
        .output()
        .unwrap();
    assert_eq!(streams.status.code(), output.status.code());
}
