//! The program, and a router by which clients reach it.

use std::collections::BTreeMap;
use std::fs;
use std::io::{BufRead, BufReader};
use std::net::{SocketAddr, TcpListener};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::Duration;

use ncp_zenoh::{Bus, ControlClient, Link};
use rustix::process::{Pid, Signal, kill_process};
use serde_json::Value;

use crate::{LONG, until};

/// The program, ended when it is dropped.
pub(crate) struct Program {
    child: Child,
    log: Arc<Mutex<Vec<Value>>>,
    endpoint: String,
    _router: Bus,
    _folder: tempfile::TempDir,
}

/// The program with nothing of the environment but what a test says.
pub(crate) fn command(variables: &[(&str, &str)]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ncp-gateway"));
    command.env_clear().envs(variables.iter().copied()).env("NCP_LOG", "json");
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

impl Program {
    /// Starts the program in front of a service, with all front ends, and waits until it takes requests.
    pub(crate) fn start(service: SocketAddr, variables: &[(&str, &str)]) -> Self {
        let port = TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap().port();
        let endpoint = format!("tcp/127.0.0.1:{port}");
        let _router = Bus::open(&Link::Router(endpoint.clone()), None).unwrap();
        let _folder = tempfile::tempdir().unwrap();
        let config = _folder.path().join("zenoh.json5");
        let content = format!(
            "{{mode: 'client', connect: {{endpoints: ['{endpoint}']}}, scouting: {{multicast: {{enabled: false}}}}}}"
        );
        fs::write(&config, content).unwrap();
        let mut command = command(&[
            ("NCP_BRIDGE_ADDR", &service.to_string()),
            ("NCP_ZENOH_CONFIG", config.to_str().unwrap()),
            ("NCP_WS_ADDR", "127.0.0.1:0"),
            ("NCP_GRPC_ADDR", "127.0.0.1:0"),
            ("NCP_HTTP_ADDR", "127.0.0.1:0"),
        ]);
        let mut child = command.envs(variables.iter().copied()).spawn().unwrap();
        let log: Arc<Mutex<Vec<Value>>> = Arc::default();
        let (into, lines) = (Arc::clone(&log), BufReader::new(child.stderr.take().unwrap()).lines());
        thread::spawn(move || {
            for line in lines.map_while(Result::ok) {
                let event = serde_json::from_str(&line).unwrap_or(Value::String(line));
                into.lock().unwrap().push(event);
            }
        });
        let program = Self { child, log, endpoint, _router, _folder };
        until("the program starts", || program.says("requests are taken"));
        program
    }

    /// Whether its log has a message that contains this.
    pub(crate) fn says(&self, text: &str) -> bool {
        self.events().iter().any(|event| event["message"].as_str().is_some_and(|message| message.contains(text)))
    }

    pub(crate) fn events(&self) -> Vec<Value> {
        self.log.lock().unwrap().clone()
    }

    /// Where a front end listens.
    pub(crate) fn address(&self, front: &str) -> SocketAddr {
        let events = self.events();
        let event = events.iter().find(|event| event["message"] == "listening" && event["front"] == front);
        event.unwrap()["address"].as_str().unwrap().parse().unwrap()
    }

    /// A client over Zenoh, once it reaches the gateway.
    pub(crate) fn client(&self) -> Client {
        let bus = Bus::open(&Link::Connect(self.endpoint.clone()), None).unwrap();
        let asks = ControlClient::new(&bus, Duration::from_secs(10)).unwrap();
        // What asks for nothing is answered by the gateway itself.
        until("the gateway answers", || asks.ask_bytes(*br#"{"kind":"sensor_frame"}"#).is_ok());
        Client { asks, _bus: bus }
    }

    /// The value of a counter, or of a sample of a histogram.
    pub(crate) fn counted(&self, sample: &str) -> f64 {
        let samples: BTreeMap<String, f64> = crate::http::get(self.address("http"), "/metrics")
            .1
            .lines()
            .filter(|line| !line.starts_with('#'))
            .filter_map(|line| line.rsplit_once(' '))
            .map(|(sample, value)| (sample.to_owned(), value.parse().unwrap()))
            .collect();
        samples.get(sample).copied().unwrap_or_default()
    }

    /// Asks it to end.
    pub(crate) fn terminate(&self) {
        kill_process(Pid::from_child(&self.child), Signal::TERM).unwrap();
    }

    /// Waits until it has ended.
    pub(crate) fn wait(&mut self) -> ExitStatus {
        let mut status = None;
        until("the program ends", || {
            status = self.child.try_wait().unwrap();
            status.is_some()
        });
        status.unwrap()
    }
}

impl Drop for Program {
    fn drop(&mut self) {
        // One that has ended cannot be killed.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// A client over Zenoh.
pub(crate) struct Client {
    asks: ControlClient,
    _bus: Bus,
}

impl Client {
    /// The bytes of the reply.
    pub(crate) fn ask(&self, request: &str) -> Vec<u8> {
        self.asks.ask_bytes(request).unwrap_or_else(|error| panic!("{request}: {error} ({LONG:?})"))
    }

    /// The reply as JSON.
    pub(crate) fn json(&self, request: &str) -> Value {
        crate::json(&self.ask(request))
    }
}
