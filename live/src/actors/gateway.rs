//! A simulation service on a line, and a gateway before it: the project's own, or one with what goes wrong in bridges.

use std::fs;
use std::io::{self, BufRead, BufReader, Write};
use std::net::{TcpListener, TcpStream};
use std::path::Path;
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use ncp_gateway::service::LineService;
use ncp_gateway::{Gateway, Settings};
use ncp_spec::reply::{ReplyError, check_reply};
use ncp_spec::wire::{ErrorFrame, Frame, Message, decode_any};
use ncp_zenoh::ControlServer;
use tokio::runtime::Runtime;
use tungstenite::WebSocket;

use super::Planted;
use crate::LiveError;
use crate::target::{GatewayPlace, Running, Target};

/// The session service over the reference backend, on a line.
pub(super) fn simulator(target: &Target) -> Result<Running, LiveError> {
    Ok(Running::default().keeping(LineService::reference(target.gateway.bridge)?))
}

pub(super) fn gateway(target: &Target, planted: &Planted) -> Result<Running, LiveError> {
    match planted.0 {
        None => sound(target),
        Some(_) => defective(target, planted),
    }
}

/// Zenoh's configuration of a client of a router, as a file has it.
fn config_of(endpoint: &str) -> String {
    format!("{{mode: 'client', connect: {{endpoints: ['{endpoint}']}}, scouting: {{multicast: {{enabled: false}}}}}}")
}

/// The gateway, and the runtime on which it works.
struct OwnGateway {
    runtime: Runtime,
    gateway: Option<Gateway>,
    _folder: tempfile::TempDir,
}

impl Drop for OwnGateway {
    fn drop(&mut self) {
        if let Some(gateway) = self.gateway.take() {
            self.runtime.block_on(gateway.stop());
        }
    }
}

fn sound(target: &Target) -> Result<Running, LiveError> {
    let GatewayPlace { bridge, websocket, grpc, query, .. } = &target.gateway;
    let _folder = tempfile::tempdir()?;
    let config = _folder.path().join("zenoh.json5");
    fs::write(&config, config_of(&target.endpoint))?;
    let settings = Settings {
        realm: target.realm.clone(),
        bridge_addr: bridge.to_string(),
        zenoh_config: Some(config),
        ws_addr: *websocket,
        grpc_addr: *grpc,
        bridge_timeout_ms: u64::try_from(query.as_millis() / 2).unwrap_or(u64::MAX),
        query_timeout_ms: u64::try_from(query.as_millis()).unwrap_or(u64::MAX),
        ..Settings::default()
    };
    let runtime = tokio::runtime::Builder::new_multi_thread().worker_threads(2).enable_all().build()?;
    let gateway = Some(runtime.block_on(Gateway::start(&settings))?);
    Ok(Running::default().keeping(OwnGateway { runtime, gateway, _folder }))
}

/// The program of the gateway within this one, for what is judged of its start.
pub(crate) fn program(settings: &Settings, planted: &Planted) -> ExitCode {
    let file = settings.zenoh_config.as_deref();
    let is_readable = |path: &Path| fs::read_to_string(path).is_ok_and(|text| text.trim_end().ends_with('}'));
    if planted.is("gateway-config-ignored") && file.is_some_and(|path| !is_readable(path)) {
        // It goes on as if no file had been named.
        loop {
            thread::park();
        }
    }
    ncp_gateway::run(settings)
}

/// A bridge as one writes it who has not read the text: a connection a request, one thing wrong.
fn defective(target: &Target, planted: &Planted) -> Result<Running, LiveError> {
    let bridge = Arc::new(Bridge {
        planted: planted.clone(),
        place: target.gateway.clone(),
        one: Mutex::new(()),
        kept: Mutex::new(None),
        has_failed: AtomicBool::new(false),
    });
    let bus = target.bus()?;
    let answers = Arc::clone(&bridge);
    let server = ControlServer::start(&bus, move |request| answers.answer(request))?;
    let mut running = Running::default().keeping(server).keeping(bus);
    if let Some(address) = target.gateway.websocket {
        let listener = TcpListener::bind(address)?;
        listener.set_nonblocking(true)?;
        running = running.every(Duration::from_millis(5), move || {
            if let Ok((stream, _)) = listener.accept() {
                let bridge = Arc::clone(&bridge);
                thread::spawn(move || bridge.websocket(stream));
            }
        });
    }
    Ok(running)
}

struct Bridge {
    planted: Planted,
    place: GatewayPlace,
    one: Mutex<()>,
    /// A connection that is used again.
    kept: Mutex<Option<TcpStream>>,
    has_failed: AtomicBool,
}

impl Bridge {
    fn answer(&self, request: &[u8]) -> Vec<u8> {
        let message = match decode_any(request) {
            Ok(message) if message.kind().is_request() => message,
            Ok(message) => return error(format!("{} is no request", message.kind())),
            Err(_) if self.planted.is("gateway-silent") => {
                thread::sleep(2 * self.place.query);
                return error("too late".to_owned());
            }
            Err(why) => return error(why.to_string()),
        };
        let _alone = self.planted.is("gateway-one-at-a-time").then(|| lock(&self.one));
        match self.exchange(&message, request) {
            Ok(reply) => reply,
            Err(why) => {
                if self.planted.is("gateway-hangs") && why.kind() == io::ErrorKind::ConnectionRefused {
                    thread::sleep(2 * self.place.query);
                }
                self.has_failed.store(true, Ordering::Relaxed);
                error(why.to_string())
            }
        }
    }

    fn exchange(&self, message: &Message, request: &[u8]) -> io::Result<Vec<u8>> {
        if self.planted.is("gateway-gives-up") && self.has_failed.load(Ordering::Relaxed) {
            return Err(io::ErrorKind::NotConnected.into());
        }
        let kept = lock(&self.kept).take();
        let mut stream = kept.map_or_else(|| TcpStream::connect(self.place.bridge), Ok)?;
        let patience = if self.planted.is("gateway-patient") { 2 } else { 1 };
        stream.set_read_timeout(Some(self.place.query * patience / 2 + self.place.query * (patience - 1)))?;
        let line = match self.planted.is("gateway-smuggles") {
            true => request.to_vec(),
            false => serde_json::from_slice::<serde_json::Value>(request)?.to_string().into_bytes(),
        };
        stream.write_all(&[&line, b"\n".as_slice()].concat())?;
        let mut reply = Vec::new();
        let read = BufReader::new(&stream).read_until(b'\n', &mut reply);
        if read.is_err() && self.planted.is("gateway-late-reply") {
            *lock(&self.kept) = Some(stream);
        }
        read?;
        let is_whole = reply.pop_if(|last| *last == b'\n').is_some();
        if !is_whole && !self.planted.is("gateway-cut-reply") {
            return Err(io::ErrorKind::UnexpectedEof.into());
        }
        let fits = match check_reply(message, &reply) {
            Ok(_) | Err(ReplyError::Reported(_)) => true,
            Err(ReplyError::Rejected(_)) => {
                self.planted.is("gateway-junk-reply") || self.planted.is("gateway-cut-reply")
            }
            Err(_) => self.planted.is("gateway-misfit") || self.planted.is("gateway-late-reply"),
        };
        if fits { Ok(reply) } else { Err(io::ErrorKind::InvalidData.into()) }
    }

    /// Answers one after the other, but where they are to be out of order.
    fn websocket(self: Arc<Self>, stream: TcpStream) -> Option<()> {
        stream.set_nonblocking(false).ok()?;
        let mut socket = tungstenite::accept(stream).ok()?;
        socket.get_ref().set_read_timeout(Some(Duration::from_millis(5))).ok()?;
        let (answers, answered) = mpsc::channel();
        loop {
            for reply in answered.try_iter() {
                send(&mut socket, reply)?;
            }
            let request = match socket.read() {
                Ok(tungstenite::Message::Text(request)) => request,
                Ok(_) => continue,
                Err(tungstenite::Error::Io(error)) if error.kind() == io::ErrorKind::WouldBlock => continue,
                Err(_) => return None,
            };
            let is_bad = decode_any(request.as_bytes()).map_or(true, |message| !message.kind().is_request());
            if is_bad && self.planted.is("websocket-closes") {
                return None;
            }
            if self.planted.is("websocket-out-of-order") {
                let (bridge, answers) = (Arc::clone(&self), answers.clone());
                thread::spawn(move || answers.send(bridge.answer(request.as_bytes())));
                continue;
            }
            if is_bad && self.planted.is("websocket-silent") {
                continue;
            }
            let reply = self.answer(request.as_bytes());
            if is_bad && self.planted.is("websocket-two-errors") {
                send(&mut socket, reply.clone())?;
            }
            send(&mut socket, reply)?;
        }
    }
}

fn send(socket: &mut WebSocket<TcpStream>, reply: Vec<u8>) -> Option<()> {
    socket.send(tungstenite::Message::text(String::from_utf8(reply).ok()?)).ok()
}

fn error(why: String) -> Vec<u8> {
    ErrorFrame { error: why.into(), session_id: None }.encode().unwrap_or_default().into_bytes()
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
