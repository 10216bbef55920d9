//! What judging costs: ratios of one run, on one machine.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use clap::Args;
use ncp_spec::plane::Plane;
use ncp_spec::resilience::ActionBuffer;
use ncp_spec::session::ReferenceBackend;
use ncp_spec::wire::{ChannelMap, ChannelValue, CommandFrame, Frame, Message, NetworkRef, OpenSession, StepRequest};
use ncp_zenoh::{
    Bus, BusError, CommandPublisher, Commands, ControlClient, ControlServer, Intake, Link, SessionHost, StreamPublisher,
};
use serde::Serialize;

use crate::judge::traffic;
use crate::target::{Noise, Running, free_endpoint};
use crate::{LiveError, write_json};

/// How a benchmark is run.
#[derive(Debug, Args)]
pub(crate) struct Bench {
    /// How many times each thing is measured
    #[arg(long, value_name = "NUMBER", default_value_t = 4_000)]
    rounds: usize,
    /// Write what was measured as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<std::path::PathBuf>,
}

/// How many rounds follow each other before the other side of a comparison has its turn: what else the machine does
/// falls on both.
const TURN: usize = 50;

/// How many samples flood the tap.
const FLOOD: u64 = 200_000;

/// How long something may take to arrive.
const PATIENCE: Duration = Duration::from_secs(10);

/// What was measured.
#[derive(Debug, Serialize)]
struct Measured {
    rpc_us: Times,
    rpc_tapped_us: Times,
    /// How much the middle round trip takes longer with a tap, as a share.
    tap_costs: f64,
    put_us: Times,
    command_us: Times,
    /// How much longer a command takes to be obeyed than a bare put to arrive, at the middle.
    command_to_put: f64,
    /// Samples a second that the tap kept up with.
    tap_per_s: f64,
    /// How many of them it lost itself, or the network did.
    tap_lost: u64,
    /// How late this machine woke a thread at worst, in ms.
    noise_ms: f64,
}

/// A distribution, in µs.
#[derive(Debug, Clone, Copy, Serialize)]
struct Times {
    p50: f64,
    p99: f64,
}

/// Measures, and shows; it judges nothing.
///
/// # Errors
/// Zenoh refuses, or nothing arrives.
pub(crate) fn run(bench: &Bench) -> Result<bool, LiveError> {
    let endpoint = free_endpoint("tcp")?;
    let _router = Bus::open(&Link::Router(endpoint.clone()), None)?;
    let noise = Noise::new();
    let (rpc_us, rpc_tapped_us) = round_trips(&endpoint, bench.rounds)?;
    let (put_us, command_us) = commands(&endpoint, bench.rounds)?;
    let (tap_per_s, tap_lost) = flood(&endpoint)?;
    let measured = Measured {
        rpc_us,
        rpc_tapped_us,
        tap_costs: rpc_tapped_us.p50 / rpc_us.p50 - 1.0,
        put_us,
        command_us,
        command_to_put: command_us.p50 / put_us.p50,
        tap_per_s,
        tap_lost,
        noise_ms: noise.worst_ms(),
    };
    measured.print();
    write_json(bench.json.as_deref(), &measured)?;
    Ok(true)
}

impl Measured {
    fn print(&self) {
        println!("{:34} {:>10} {:>10}", "µs", "p50", "p99");
        for (what, Times { p50, p99 }) in [
            ("RPC round trip", self.rpc_us),
            ("RPC round trip beside a tap", self.rpc_tapped_us),
            ("bare Zenoh put, until it arrives", self.put_us),
            ("command, until the plant obeys", self.command_us),
        ] {
            println!("{what:34} {p50:10.1} {p99:10.1}");
        }
        println!("\nthe tap adds {:+.1} % to a round trip", 100.0 * self.tap_costs);
        println!("a command takes {:.2} times as long as a bare put", self.command_to_put);
        println!("the tap kept up with {:.0} samples a second; {} of {FLOOD} lost", self.tap_per_s, self.tap_lost);
        println!("this machine woke a thread {:.1} ms late at worst", self.noise_ms);
    }
}

impl Times {
    fn of(mut times: Vec<Duration>) -> Self {
        times.sort_unstable();
        let at = |share: usize| times.get(times.len().saturating_sub(1) * share / 100);
        let us = |share| at(share).map_or(f64::NAN, |time| time.as_secs_f64() * 1e6);
        Self { p50: us(50), p99: us(99) }
    }
}

/// Measures two things in turns.
fn in_turns(
    rounds: usize,
    mut one: impl FnMut() -> Result<Duration, LiveError>,
    mut other: impl FnMut() -> Result<Duration, LiveError>,
    mut switch: impl FnMut(bool) -> Result<(), LiveError>,
) -> Result<(Times, Times), LiveError> {
    let (mut ones, mut others) = (Vec::new(), Vec::new());
    // The first turns warm up, and do not count.
    for turn in 0..=rounds.div_ceil(TURN) {
        switch(false)?;
        let times: Result<Vec<_>, _> = (0..TURN).map(|_| one()).collect();
        ones.extend(times?.into_iter().filter(|_| turn > 0));
        switch(true)?;
        let times: Result<Vec<_>, _> = (0..TURN).map(|_| other()).collect();
        others.extend(times?.into_iter().filter(|_| turn > 0));
    }
    Ok((Times::of(ones), Times::of(others)))
}

/// The round trip of a step, without a tap and with one.
fn round_trips(endpoint: &str, rounds: usize) -> Result<(Times, Times), LiveError> {
    let bus = || Bus::open(&Link::Connect(endpoint.to_owned()), Some("bench/rpc"));
    let (serves, asks, taps) = (bus()?, bus()?, bus()?);
    let host = SessionHost::new(|| ReferenceBackend);
    let observations = StreamPublisher::declare(
        &serves,
        serves.keys().observation("s").map_err(BusError::from)?,
        Plane::Observation.qos(),
    )?;
    // What is answered is published too, so that there is something to tap.
    let _server = ControlServer::start(&serves, move |request| {
        let reply = host.serve(request).into_bytes();
        let _ = observations.send_bytes(reply.clone());
        reply
    })?;
    let client = ControlClient::new(&asks, PATIENCE)?;
    let network = NetworkRef { reference: "ncp.reference.lif".into(), ..NetworkRef::default() };
    let open: Message = OpenSession { session_id: "s".into(), network, ..OpenSession::default() }.into();
    arrives(|| Ok(client.ask(&open).is_ok()))?;
    let step: Message = StepRequest { session_id: "s".into(), advance_ms: Some(0.1), ..StepRequest::default() }.into();
    let ask = || {
        let began = Instant::now();
        client.ask(&step)?;
        Ok(began.elapsed())
    };
    let mut tap: Option<Running> = None;
    let samples = Arc::new(AtomicU64::new(0));
    in_turns(rounds, ask, ask, |is_tapped| {
        tap = None;
        if is_tapped {
            let pattern = taps.keys().fleet_glob().map_err(BusError::from)?;
            let intake: Intake<()> = Intake::subscribe(&taps, pattern, 1 << 16)?;
            let (count, began) = (Arc::clone(&samples), Instant::now());
            tap = Some(Running::default().every(Duration::ZERO, move || {
                if let Some(arrival) = intake.wait_for(Duration::from_millis(5)) {
                    count.fetch_add(traffic::Sample::new(&arrival, began).frame.len() as u64, Ordering::Relaxed);
                }
            }));
            // A subscription takes its time to be known.
            thread::sleep(Duration::from_millis(30));
        }
        Ok(())
    })
}

/// How long a bare put takes to arrive, and a command until the plant's buffer gives it to the motors.
fn commands(endpoint: &str, rounds: usize) -> Result<(Times, Times), LiveError> {
    let bus = || Bus::open(&Link::Connect(endpoint.to_owned()), Some("bench/command"));
    let (sends, obeys) = (bus()?, bus()?);
    let publisher = CommandPublisher::declare(&sends, "s", None)?;
    let plant = Commands::of(&obeys, "s", None, ActionBuffer::new())?;
    let bare_key = sends.keys().command("bare", None).map_err(BusError::from)?;
    let bare = StreamPublisher::declare(&sends, bare_key.clone(), Plane::Action.qos())?;
    let arrived: Intake<()> = Intake::subscribe(&obeys, bare_key, 64)?;
    arrives(|| Ok(publisher.stream().has_reader()? && bare.has_reader()?))?;
    let text = command(1).encode().map_err(BusError::from)?;
    let put = || {
        let began = Instant::now();
        bare.send_bytes(text.clone())?;
        let arrival = arrived.wait_for(PATIENCE).ok_or(BusError::NoReply(PATIENCE))?;
        Ok(arrival.at.saturating_duration_since(began))
    };
    let mut seq = 0;
    let obey = || {
        seq += 1;
        let began = Instant::now();
        publisher.send(&command(seq))?;
        // A motor's loop that looks all the time.
        loop {
            let setpoint =
                plant.active().and_then(|active| active.get("velocity_setpoint").map(|channel| channel.data.clone()));
            if setpoint.is_some_and(|data| data.first() == Some(&setpoint_of(seq))) {
                return Ok(began.elapsed());
            }
            if began.elapsed() > PATIENCE {
                return Err(BusError::NoReply(PATIENCE).into());
            }
            thread::yield_now();
        }
    };
    in_turns(rounds, put, obey, |_| Ok(()))
}

/// A command that is told from the one before by its setpoint.
fn command(seq: i64) -> CommandFrame {
    let setpoint = ChannelValue::new([setpoint_of(seq), 0.0, 0.0], "m/s");
    let channels = ChannelMap::from_iter([("velocity_setpoint", setpoint)]);
    CommandFrame { seq, ttl_ms: 60_000.0, channels, ..CommandFrame::default() }
}

fn setpoint_of(seq: i64) -> f64 {
    f64::from(i32::try_from(seq % 1_000).unwrap_or(0)) / 1_000.0
}

/// How many samples a second the tap takes, and how many were lost on the way to it.
fn flood(endpoint: &str) -> Result<(f64, u64), LiveError> {
    let bus = || Bus::open(&Link::Connect(endpoint.to_owned()), Some("bench/flood"));
    let (sends, taps) = (bus()?, bus()?);
    let key = sends.keys().observation("s").map_err(BusError::from)?;
    // A plane that waits: what is lost, the tap loses.
    let stream = StreamPublisher::declare(&sends, key, Plane::Observation.qos())?;
    let (taken, stop) = (Arc::new(AtomicU64::new(0)), Arc::new(AtomicBool::new(false)));
    let text = command(1).encode().map_err(BusError::from)?;
    thread::scope(|scope| {
        let (count, has_stopped) = (Arc::clone(&taken), Arc::clone(&stop));
        let tap = scope.spawn(move || {
            traffic::tap_while(
                &taps,
                || !has_stopped.load(Ordering::Relaxed),
                |_| {
                    count.fetch_add(1, Ordering::Relaxed);
                },
            )
        });
        let sent = arrives(|| Ok(stream.has_reader()?)).and_then(|()| {
            let began = Instant::now();
            for _ in 0..FLOOD {
                stream.send_bytes(text.clone())?;
            }
            // Whatever has not come by then is lost.
            let _ = arrives(|| Ok(taken.load(Ordering::Relaxed) >= FLOOD));
            Ok(began.elapsed())
        });
        stop.store(true, Ordering::Relaxed);
        let overrun = tap.join().unwrap_or(Ok(FLOOD))?;
        let came = taken.load(Ordering::Relaxed);
        #[expect(clippy::cast_precision_loss, reason = "a count of samples")]
        let per_s = came as f64 / sent?.as_secs_f64();
        Ok((per_s, overrun.max(FLOOD.saturating_sub(came))))
    })
}

fn arrives(mut is_so: impl FnMut() -> Result<bool, LiveError>) -> Result<(), LiveError> {
    let began = Instant::now();
    while !is_so()? {
        if began.elapsed() > PATIENCE {
            return Err(BusError::NoReply(PATIENCE).into());
        }
        thread::sleep(Duration::from_millis(1));
    }
    Ok(())
}
