//! A session with the built-in network of leaky integrate-and-fire neurons, over a local bus.
//!
//! ```text
//! cargo run -p ncp-spec --example session
//! ```
//!
//! A client opens a session of eight neurons, steps it for 120 ms, gives each neuron another current
//! meanwhile, prints what they did, and closes the session. Requests and replies travel as wire bytes.

use std::error::Error;
use std::io::{self, Write};

use ncp_spec::bus::{LocalBus, NeuroSimClient};
use ncp_spec::keys::Keys;
use ncp_spec::session::{ReferenceBackend, SessionService};
use ncp_spec::wire::{
    ChannelMap, ChannelValue, NetworkRef, NetworkRefKind, Observable, Observation, OpenSession, RecordSpec,
    RecordTarget, SimConfig, SortedMap, StepRequest, StimulusFrame, StimulusKind, StimulusSpec, StimulusTarget,
};

const SESSION: &str = "demo";
const POPULATION: &str = "exc";
const NEURONS: i64 = 8;
/// The neuron whose membrane potential is plotted.
const WATCHED: i64 = 6;
/// From one sample of V_m to the next, and the width of a column, in ms.
const COLUMN_MS: f64 = 2.0;
const COLUMNS: usize = 60;
const STEP_MS: f64 = 20.0;
const STEPS: u32 = 6;
/// During these steps the current flows.
const DRIVEN: std::ops::Range<u32> = 1..5;

fn main() -> Result<(), Box<dyn Error>> {
    run(&mut io::stdout().lock())
}

/// The whole session; what it shows goes to `out`.
pub(crate) fn run(out: &mut dyn Write) -> Result<(), Box<dyn Error>> {
    let bus = LocalBus::new();
    let mut service = SessionService::new(ReferenceBackend);
    let rpc = Keys::new(None)?.rpc()?;
    let _serving = bus.serve(&rpc, move |request| service.serve(request).into_bytes())?;
    let mut client = NeuroSimClient::new(bus, None)?;

    let opened = client.open(request())?;
    let provenance = opened.provenance.unwrap_or_default();
    writeln!(
        out,
        "opened {SESSION:?}: {} neurons of {} on {}",
        opened.resolved.get(POPULATION).unwrap_or(&0),
        provenance.network_ref,
        opened.backend,
    )?;
    writeln!(
        out,
        "simulation output: {}, calibrated posterior: {}\n",
        provenance.is_simulation_output, provenance.calibrated_posterior,
    )?;

    let (mut spikes, mut membrane) = (Observation::default(), Observation::default());
    for step in 0..STEPS {
        let is_driven = DRIVEN.contains(&step);
        let frame = client.step(StepRequest {
            session_id: SESSION.into(),
            advance_ms: Some(STEP_MS),
            stimulus: Some(currents(is_driven)),
            ..StepRequest::default()
        })?;
        let new = frame.records.get("spikes").map_or(0, |port| port.times.len());
        let current = if is_driven { "on" } else { "off" };
        writeln!(
            out,
            "step {}: current {current:<3}  {new:>3} spikes  simulated {:>3} ms",
            frame.seq, frame.sim_time_ms
        )?;
        collect(&mut spikes, &frame.records, "spikes");
        collect(&mut membrane, &frame.records, "membrane");
    }
    raster(out, &spikes)?;
    potential(out, &membrane)?;

    let closed = client.close(SESSION)?;
    writeln!(out, "\nclosed: {}", closed.is_some_and(|closed| closed.ok))?;
    Ok(())
}

fn request() -> OpenSession {
    let record = |port: &'static str, observable, ids| RecordTarget {
        port: port.into(),
        target: POPULATION.into(),
        observable,
        ids,
        cadence_ms: COLUMN_MS,
        ..RecordTarget::default()
    };
    OpenSession {
        session_id: SESSION.into(),
        network: NetworkRef {
            kind: NetworkRefKind::Builtin,
            reference: "ncp.reference.lif".into(),
            population_sizes: SortedMap::from_iter([(POPULATION, NEURONS)]),
            ..NetworkRef::default()
        },
        record: RecordSpec {
            targets: vec![
                record("spikes", Observable::Spikes, vec![]),
                record("membrane", Observable::Vm, vec![WATCHED]),
            ],
        },
        stimulus: StimulusSpec {
            targets: vec![StimulusTarget {
                port: "current".into(),
                target: POPULATION.into(),
                kind: StimulusKind::CurrentPa,
                ..StimulusTarget::default()
            }],
        },
        sim: SimConfig { dt_ms: 0.1, ..SimConfig::default() },
        ..OpenSession::default()
    }
}

/// From 340 to 760 pA, or nothing. Below 375 pA a neuron stays under its threshold.
fn current_of(neuron: i64) -> f64 {
    280.0 + 60.0 * neuron as f64
}

fn currents(is_driven: bool) -> StimulusFrame {
    let of = |neuron| if is_driven { current_of(neuron) } else { 0.0 };
    let values: Vec<f64> = (1..=NEURONS).map(of).collect();
    StimulusFrame {
        session_id: SESSION.into(),
        values: ChannelMap::from_iter([("current", ChannelValue::new(values, "pA"))]),
        ..StimulusFrame::default()
    }
}

fn collect(all: &mut Observation, records: &SortedMap<Observation>, port: &str) {
    if let Some(new) = records.get(port) {
        all.times.extend(&new.times);
        all.values.extend(&new.values);
        all.senders.extend(&new.senders);
    }
}

/// The column of a time: a sample at its end belongs to it.
fn column(time_ms: f64) -> usize {
    ((time_ms / COLUMN_MS - 1e-9).floor() as usize).min(COLUMNS - 1)
}

/// A row a neuron, a column every 2 ms, a bar a spike.
fn raster(out: &mut dyn Write, spikes: &Observation) -> io::Result<()> {
    writeln!(out, "\nspikes\n")?;
    for neuron in (1..=NEURONS).rev() {
        let mut row = ['·'; COLUMNS];
        let mut count = 0;
        for (&time_ms, &sender) in spikes.times.iter().zip(&spikes.senders) {
            if sender == neuron {
                row[column(time_ms)] = '│';
                count += 1;
            }
        }
        let row: String = row.into_iter().collect();
        writeln!(out, "{neuron:>4}  {:>3} pA  {row}  {count:>2}", current_of(neuron))?;
    }
    axis(out)
}

/// V_m of one neuron: a row every 3 mV in eighths, a column every 2 ms.
fn potential(out: &mut dyn Write, membrane: &Observation) -> io::Result<()> {
    const REST_MV: f64 = -70.0;
    const ROW_MV: f64 = 3.0;
    const ROWS: usize = 5;
    const EIGHTHS: [char; 9] = [' ', '▁', '▂', '▃', '▄', '▅', '▆', '▇', '█'];
    writeln!(out, "\nV_m of neuron {WATCHED}, mV\n")?;
    let mut heights = [0.0; COLUMNS];
    for (&time_ms, &v) in membrane.times.iter().zip(&membrane.values) {
        heights[column(time_ms)] = (v - REST_MV) / ROW_MV;
    }
    for row in (0..ROWS).rev() {
        let of = |height: &f64| EIGHTHS[((height - row as f64) * 8.0).round().clamp(0.0, 8.0) as usize];
        let cells: String = heights.iter().map(of).collect();
        let top = REST_MV + ROW_MV * (row + 1) as f64;
        let line = format!("{top:>11.0}  {cells}");
        writeln!(out, "{}", line.trim_end())?;
    }
    axis(out)
}

fn axis(out: &mut dyn Write) -> io::Result<()> {
    let every = 10;
    let ticks: String = (0..COLUMNS / every).map(|_| format!("└{}", " ".repeat(every - 1))).collect();
    let times: String = (0..COLUMNS / every)
        .map(|at| format!("{:<every$}", format!("{:.0}", (at * every) as f64 * COLUMN_MS)))
        .collect();
    writeln!(out, "{:13}{}", "", ticks.trim_end())?;
    writeln!(out, "{:13}{times}ms", "")
}
