//! The system under test: where it is, and what of it is looked at.

use std::net::{SocketAddr, TcpListener};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use ncp_spec::wire::SensorFrame;
use ncp_zenoh::{Bus, BusError, Link};
use serde::Deserialize;

use crate::LiveError;
use crate::judge::road::Road;

/// A running system.
#[derive(Debug, Clone)]
pub(crate) struct Target {
    /// Where its router or a peer of it listens.
    pub(crate) endpoint: String,
    /// Its realm.
    pub(crate) realm: String,
    /// The session whose planes are looked at.
    pub(crate) session: String,
    /// The built-in network that a server is asked to open.
    pub(crate) network: String,
    /// Where an observer writes the pairs that it joined: one JSON array a line, the seq of the command and that of the
    /// sensor frame.
    pub(crate) joined: PathBuf,
    /// How its motion is read from its sensor stream.
    pub(crate) mapping: Mapping,
    /// The road to its session service.
    pub(crate) road: Road,
    /// Where its gateway is, if that is looked at.
    pub(crate) gateway: GatewayPlace,
}

/// A gateway, and what it stands before.
#[derive(Debug, Clone)]
pub(crate) struct GatewayPlace {
    /// Where it looks for the simulation service.
    pub(crate) bridge: SocketAddr,
    /// Where it serves WebSockets, if it does.
    pub(crate) websocket: Option<SocketAddr>,
    /// Where it serves gRPC, if it does.
    pub(crate) grpc: Option<SocketAddr>,
    /// The program, if it can be started.
    pub(crate) program: Option<PathBuf>,
    /// How long a client waits for a reply.
    pub(crate) query: Duration,
}

impl GatewayPlace {
    /// Addresses on loopback that are free now, and a client that does not wait long.
    ///
    /// # Errors
    /// The operating system has none.
    pub(crate) fn free() -> Result<Self, LiveError> {
        let listeners = [(); 3].map(|()| TcpListener::bind("127.0.0.1:0"));
        let [bridge, websocket, grpc] = listeners.map(|listener| listener.and_then(|listener| listener.local_addr()));
        let query = Duration::from_millis(2_500);
        Ok(Self { bridge: bridge?, websocket: Some(websocket?), grpc: Some(grpc?), program: None, query })
    }
}

/// How a plant's motion is read from its sensor stream, and which command moves it.
#[derive(Debug, Clone, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct Mapping {
    /// The stream; none: the one without a name.
    pub(crate) stream: Option<String>,
    /// The channel that says how fast the plant moves.
    pub(crate) channel: String,
    /// What it says at most while the plant holds, in the channel's unit.
    pub(crate) still: f64,
    /// The channel that is commanded.
    pub(crate) command: String,
    /// The setpoint that moves it.
    pub(crate) setpoint: Vec<f64>,
    /// The unit of the setpoint.
    pub(crate) unit: String,
    /// How long the plant takes to come to rest, and how late it may notice, in ms.
    pub(crate) tolerance_ms: f64,
}

impl Default for Mapping {
    fn default() -> Self {
        Self {
            stream: None,
            channel: "pose_velocity".to_owned(),
            still: 1e-6,
            command: "velocity_setpoint".to_owned(),
            setpoint: vec![0.5, 0.0, 0.0],
            unit: "m/s".to_owned(),
            tolerance_ms: 60.0,
        }
    }
}

impl Mapping {
    /// Whether a frame says that the plant moves; none if it does not say.
    pub(crate) fn moves(&self, frame: &SensorFrame) -> Option<bool> {
        let channel = frame.channels.get(&self.channel)?;
        Some(channel.data.iter().any(|component| component.abs() > self.still))
    }
}

impl Target {
    /// Connects to it.
    ///
    /// # Errors
    /// Nobody listens there, or Zenoh refuses.
    pub(crate) fn bus(&self) -> Result<Bus, BusError> {
        Bus::open(&Link::Connect(self.endpoint.clone()), Some(&self.realm))
    }
}

/// An endpoint on loopback that is free now.
///
/// # Errors
/// The operating system has none.
pub(crate) fn free_endpoint(protocol: &str) -> Result<String, LiveError> {
    let port = TcpListener::bind("127.0.0.1:0").and_then(|listener| listener.local_addr())?.port();
    Ok(format!("{protocol}/127.0.0.1:{port}"))
}

/// What keeps running until it is dropped.
#[derive(Default)]
pub(crate) struct Running {
    stop: Arc<AtomicBool>,
    threads: Vec<JoinHandle<()>>,
    /// What has to live as long, such as a server.
    _keeps: Vec<Box<dyn Send>>,
}

impl Running {
    /// Runs a loop in a thread, until it is dropped; it is called every `period`, and is late rather than twice.
    pub(crate) fn every(mut self, period: Duration, mut tick: impl FnMut() + Send + 'static) -> Self {
        let stop = Arc::clone(&self.stop);
        self.threads.push(thread::spawn(move || {
            let mut next = Instant::now();
            while !stop.load(Ordering::Relaxed) {
                tick();
                next = (next + period).max(Instant::now());
                thread::sleep(next.saturating_duration_since(Instant::now()));
            }
        }));
        self
    }

    /// Keeps something until it is dropped.
    pub(crate) fn keeping(mut self, keep: impl Send + 'static) -> Self {
        self._keeps.push(Box::new(keep));
        self
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
        for thread in self.threads.drain(..) {
            // What it panicked of, it has printed.
            let _ = thread.join();
        }
    }
}

/// Measures how late this machine wakes a thread that sleeps: what is less than that, no verdict may rest on.
pub(crate) struct Noise {
    worst_us: Arc<AtomicU64>,
    _running: Running,
}

impl Noise {
    /// Begins to measure.
    pub(crate) fn new() -> Self {
        const NAP: Duration = Duration::from_millis(2);
        let worst_us = Arc::new(AtomicU64::new(0));
        let into = Arc::clone(&worst_us);
        let _running = Running::default().every(Duration::ZERO, move || {
            let began = Instant::now();
            thread::sleep(NAP);
            let late = began.elapsed().saturating_sub(NAP);
            into.fetch_max(u64::try_from(late.as_micros()).unwrap_or(u64::MAX), Ordering::Relaxed);
        });
        Self { worst_us, _running }
    }

    /// The worst since the last time it was asked, in ms.
    pub(crate) fn worst_ms(&self) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "some milliseconds")]
        let worst_us = self.worst_us.swap(0, Ordering::Relaxed) as f64;
        worst_us / 1e3
    }
}
