//! Samples as a tap sees them, and what the text says of each and of their streams.

use std::collections::{BTreeMap, BTreeSet};
use std::time::{Duration, Instant};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use ncp_spec::keys::DEFAULT_REALM;
use ncp_spec::plane::Plane;
use ncp_spec::wire::{CommandFrame, Kind, Message, SensorFrame, decode_any};
use ncp_zenoh::{Arrival, Bus, BusError, Intake, SeenQos};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use zenoh::qos::CongestionControl;

use super::shown;
use crate::LiveError;
use crate::verdict::Rulings;

/// How many samples a tap holds that nobody has taken; one that is lost is counted.
const TAP: usize = 1 << 20;

/// A sample as it is captured: one JSON object a line.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(crate) struct Sample {
    /// Seconds since the tap began.
    pub(crate) at_s: f64,
    /// The key.
    pub(crate) key: String,
    /// `block` or `drop`.
    pub(crate) congestion: String,
    /// Zenoh's name.
    pub(crate) priority: String,
    /// Whether it was sent without batching.
    pub(crate) express: bool,
    /// The frame in base64.
    pub(crate) frame: String,
}

impl Sample {
    pub(crate) fn new(arrival: &Arrival, began: Instant) -> Self {
        let SeenQos { congestion, priority, express } = arrival.qos;
        Self {
            at_s: arrival.at.saturating_duration_since(began).as_secs_f64(),
            key: arrival.key.to_string(),
            congestion: if congestion == CongestionControl::Block { "block" } else { "drop" }.to_owned(),
            priority: format!("{priority:?}"),
            express,
            frame: STANDARD.encode(arrival.payload.to_bytes()),
        }
    }

    fn qos(&self) -> String {
        let Self { congestion, priority, express, .. } = self;
        format!("{congestion}, {priority}, {}express", if *express { "" } else { "not " })
    }
}

/// All samples of the realm's sessions, for so long.
///
/// # Errors
/// Zenoh refuses.
pub(crate) fn tap(bus: &Bus, longest: Duration) -> Result<Vec<Sample>, LiveError> {
    let mut samples = Vec::new();
    let overrun = tap_into(bus, longest, |sample| samples.push(sample))?;
    // A tap that lost samples itself would take them for gaps of a stream.
    if overrun > 0 {
        return Err(LiveError::Overrun(overrun));
    }
    Ok(samples)
}

/// Hands on all samples of the realm's sessions, for so long; how many it lost itself.
///
/// # Errors
/// Zenoh refuses.
pub(crate) fn tap_into(bus: &Bus, longest: Duration, take: impl FnMut(Sample)) -> Result<u64, LiveError> {
    let began = Instant::now();
    tap_while(bus, || began.elapsed() < longest, take)
}

/// The same, while something is so.
///
/// # Errors
/// Zenoh refuses.
pub(crate) fn tap_while(
    bus: &Bus,
    mut goes_on: impl FnMut() -> bool,
    mut take: impl FnMut(Sample),
) -> Result<u64, LiveError> {
    let pattern = bus.keys().fleet_glob().map_err(BusError::from)?;
    let intake: Intake<()> = Intake::subscribe(bus, pattern, TAP)?;
    let began = Instant::now();
    while goes_on() {
        if let Some(arrival) = intake.wait_for(Duration::from_millis(10)) {
            take(Sample::new(&arrival, began));
        }
    }
    Ok(intake.counts().overrun)
}

/// Judges samples: each by itself, then each stream, then what commands and sensor frames have to do with each other.
pub(crate) fn judge(samples: &[Sample], realm: &str, rulings: &mut Rulings) {
    let mut streams: BTreeMap<Stream<'_>, Vec<(f64, Message)>> = BTreeMap::new();
    for sample in samples {
        let Some(stream) = Stream::of(&sample.key, realm) else { continue };
        quality(sample, stream.plane, rulings);
        let Ok(frame) = STANDARD.decode(&sample.frame) else { continue };
        if let Some(message) = content(&frame, stream, rulings) {
            streams.entry(stream).or_default().push((sample.at_s, message));
        }
    }
    let sessions: BTreeSet<&str> = streams.keys().map(|stream| stream.session).collect();
    for session in sessions {
        let of_session = |plane: PlaneOf| {
            let of_plane = streams.iter().filter(move |(stream, _)| stream.session == session && stream.plane == plane);
            of_plane.map(|(stream, frames)| (stream.name, frames))
        };
        let sensors: Vec<Sensors<'_>> = of_session(PlaneOf::Perception)
            .map(|(name, frames)| (name, frames.iter().filter_map(|(at, m)| Some((*at, sensor(m)?))).collect()))
            .collect();
        let commands: Vec<(Option<&str>, Vec<&CommandFrame>)> = of_session(PlaneOf::Action)
            .map(|(name, frames)| (name, frames.iter().filter_map(|(_, m)| command(m)).collect()))
            .collect();
        let observed: Vec<&Message> = of_session(PlaneOf::Observation)
            .flat_map(|(_, frames)| frames.iter().map(|(_, message)| message))
            .collect();
        counters(session, &sensors, rulings);
        clocks(session, &sensors, rulings);
        order(session, &commands, rulings);
        echoes(session, &sensors, &commands, rulings);
        statuses(session, commands.iter().map(|(_, of_stream)| of_stream.len()).sum(), &observed, rulings);
        observations(session, &observed, rulings);
    }
}

/// A sensor stream: its name, and its frames with the second at which each arrived.
type Sensors<'a> = (Option<&'a str>, Vec<(f64, &'a SensorFrame)>);

/// A plane that is published on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum PlaneOf {
    Perception,
    Action,
    Observation,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Stream<'a> {
    session: &'a str,
    plane: PlaneOf,
    name: Option<&'a str>,
}

impl<'a> Stream<'a> {
    fn of(key: &'a str, realm: &str) -> Option<Self> {
        let realm = if realm.is_empty() { DEFAULT_REALM } else { realm };
        let rest = key.strip_prefix(realm)?.strip_prefix("/session/")?;
        let (session, rest) = rest.split_once('/')?;
        let (plane, name) = match rest.split_once('/') {
            Some((plane, name)) => (plane, Some(name)),
            None => (rest, None),
        };
        let plane = match plane {
            "sensor" => PlaneOf::Perception,
            "command" => PlaneOf::Action,
            "observation" => PlaneOf::Observation,
            _ => return None,
        };
        Some(Self { session, plane, name })
    }
}

/// The rule of the plane's quality of service, and the general one.
fn quality(sample: &Sample, plane: PlaneOf, rulings: &mut Rulings) {
    let (plane, rule) = match plane {
        PlaneOf::Perception => (Plane::Perception, "NCP-PLANE-002"),
        PlaneOf::Action => (Plane::Action, "NCP-PLANE-003"),
        PlaneOf::Observation => (Plane::Observation, "NCP-PLANE-004"),
    };
    let asked = plane.qos();
    let is_so = sample.congestion == asked.congestion.as_str()
        && sample.priority == asked.priority.as_str()
        && sample.express == asked.express;
    for rule in [rule, "NCP-TRANS-002"] {
        rulings.observe(rule, is_so, || format!("{} carries {}", sample.key, sample.qos()));
    }
}

/// The rules of a frame on its key; the frame, if it is one of its plane.
fn content(frame: &[u8], stream: Stream<'_>, rulings: &mut Rulings) -> Option<Message> {
    let decoded = decode_any(frame);
    let is_block = frame.starts_with(b"NCPB");
    let is_bulk = is_block || matches!(decoded, Ok(Message::BulkObservation(_)));
    if stream.plane == PlaneOf::Observation {
        if is_bulk {
            let why = || format!("a bare block on the observation plane of {}", stream.session);
            rulings.observe("NCP-OBS-011", !is_block, why);
        }
    } else {
        let why = || format!("a block on the {:?} plane of {}: {}", stream.plane, stream.session, shown(frame));
        rulings.observe("NCP-OBS-010", !is_bulk, why);
    }
    let message = match decoded {
        Ok(message) => {
            rulings.observe("NCP-WIRE-093", true, String::new);
            message
        }
        Err(error) => {
            if !is_block {
                rulings.fail("NCP-WIRE-093", format!("no receiver reads {}: {error}", shown(frame)));
            }
            return None;
        }
    };
    let (rule, plane) = match message.kind() {
        Kind::SensorFrame => ("NCP-KEY-002", PlaneOf::Perception),
        Kind::CommandFrame => ("NCP-KEY-003", PlaneOf::Action),
        Kind::ObservationFrame | Kind::ControlStatus | Kind::LinkStatus => ("NCP-KEY-004", PlaneOf::Observation),
        Kind::BulkObservation => return None,
        _ => return Some(message),
    };
    let why = || format!("a {} on the {:?} plane of {}", message.kind(), stream.plane, stream.session);
    rulings.observe(rule, plane == stream.plane, why);
    if message.kind() == Kind::ObservationFrame {
        let members: Value = serde_json::from_slice(frame).unwrap_or_default();
        let has_pins = ["calibrated_posterior", "is_simulation_output"].iter().all(|pin| members.get(pin).is_some());
        rulings.observe("NCP-PROV-007", has_pins, || format!("without pins: {}", shown(frame)));
    }
    Some(message)
}

/// Each stream counts for itself, and does not begin again.
fn counters(session: &str, sensors: &[Sensors<'_>], rulings: &mut Rulings) {
    const RULE: &str = "NCP-PLANE-005";
    let stamped = |frames: &[(f64, &SensorFrame)]| -> Vec<i64> {
        frames.iter().map(|(_, frame)| frame.seq).filter(|seq| *seq != 0).collect()
    };
    let streams: Vec<(Option<&str>, Vec<i64>)> =
        sensors.iter().map(|(name, frames)| (*name, stamped(frames))).collect();
    let mut apart = 0;
    for (name, seqs) in &streams {
        let back = seqs.windows(2).find(|pair| pair[1] <= pair[0]);
        if let Some(pair) = back {
            rulings.fail(RULE, format!("{session}, stream {name:?}: seq {} after {}", pair[1], pair[0]));
        }
        let by_one = seqs.windows(2).filter(|pair| pair[1] == pair[0] + 1).count();
        if seqs.len() >= 5 && by_one * 5 >= (seqs.len() - 1) * 4 {
            apart += 1;
        }
    }
    let long = streams.iter().filter(|(_, seqs)| seqs.len() >= 5).count();
    if long < 2 {
        return;
    }
    // Streams that leave out in turn what others have count together.
    let all: BTreeSet<i64> = streams.iter().flat_map(|(_, seqs)| seqs.iter().copied()).collect();
    let is_disjoint = all.len() == streams.iter().map(|(_, seqs)| seqs.len()).sum::<usize>();
    let span = all.last().zip(all.first()).map_or(0, |(last, first)| last - first + 1);
    let is_dense = i64::try_from(all.len()).unwrap_or(i64::MAX) * 10 >= span * 9;
    if is_disjoint && is_dense && apart < long {
        rulings.fail(RULE, format!("the {} sensor streams of {session} share one counter", streams.len()));
    } else if apart == long {
        rulings.observe(RULE, true, String::new);
    } else {
        rulings.unclear(RULE, format!("frames of {session} were lost on the way"));
    }
}

/// `t` is in seconds: it goes on as fast as the frames arrive.
fn clocks(session: &str, sensors: &[Sensors<'_>], rulings: &mut Rulings) {
    for (name, frames) in sensors {
        let (Some((first_s, first)), Some((last_s, last))) = (frames.first(), frames.last()) else { continue };
        let arrived_s = last_s - first_s;
        let rate = (last.t - first.t) / arrived_s;
        if arrived_s > 0.5 && !(0.01..=100.0).contains(&rate) {
            let why = format!("{session}, stream {name:?}: t goes on by {rate:.3} a second, and is no time in s");
            rulings.fail("NCP-WIRE-093", why);
        }
    }
}

/// Commands of one stream arrive in the order of their stamps.
fn order(session: &str, commands: &[(Option<&str>, Vec<&CommandFrame>)], rulings: &mut Rulings) {
    for (name, frames) in commands {
        for pair in frames.windows(2) {
            let is_so = pair[1].seq >= pair[0].seq && pair[1].t >= pair[0].t;
            rulings.observe("NCP-CTRL-020", is_so, || {
                format!("{session}, stream {name:?}: seq {} arrives after seq {}", pair[1].seq, pair[0].seq)
            });
        }
    }
}

/// A command's seq is that of a sensor frame.
fn echoes(
    session: &str,
    sensors: &[Sensors<'_>],
    commands: &[(Option<&str>, Vec<&CommandFrame>)],
    rulings: &mut Rulings,
) {
    let seen: BTreeSet<i64> =
        sensors.iter().flat_map(|(_, frames)| frames.iter().map(|(_, frame)| frame.seq)).collect();
    let (Some(first), Some(last)) = (seen.first(), seen.last()) else { return };
    // What came before the tap, or is on its way, cannot be told.
    let within =
        commands.iter().flat_map(|(_, frames)| frames).filter(|command| (*first..=*last).contains(&command.seq));
    for command in within {
        let why = || format!("{session}: seq {} of a command is that of no sensor frame", command.seq);
        rulings.observe("NCP-PLANE-006", seen.contains(&command.seq), why);
    }
}

/// A loop that commands says so, by a counter of its own.
fn statuses(session: &str, commands: usize, observed: &[&Message], rulings: &mut Rulings) {
    const RULE: &str = "NCP-CTRL-017";
    if commands < 5 {
        return;
    }
    let seqs: Vec<i64> =
        observed.iter().filter_map(|m| if let Message::ControlStatus(m) = m { Some(m.seq) } else { None }).collect();
    let is_each = seqs.len() * 4 >= commands * 3;
    rulings.observe(RULE, is_each, || format!("{session}: {} status frames beside {commands} commands", seqs.len()));
    for pair in seqs.windows(2) {
        let why = || format!("{session}: the status counts {} after {}", pair[1], pair[0]);
        rulings.observe(RULE, pair[1] == pair[0] + 1, why);
    }
}

/// Observations count by one.
fn observations(session: &str, observed: &[&Message], rulings: &mut Rulings) {
    let seqs: Vec<i64> =
        observed.iter().filter_map(|m| if let Message::ObservationFrame(m) = m { Some(m.seq) } else { None }).collect();
    for pair in seqs.windows(2) {
        let why = || format!("{session}: observation {} after {}", pair[1], pair[0]);
        rulings.observe("NCP-SESS-034", pair[1] == pair[0] + 1, why);
    }
}

fn sensor(message: &Message) -> Option<&SensorFrame> {
    if let Message::SensorFrame(frame) = message { Some(frame) } else { None }
}

fn command(message: &Message) -> Option<&CommandFrame> {
    if let Message::CommandFrame(frame) = message { Some(frame) } else { None }
}

#[cfg(test)]
mod tests {
    use zenoh::qos::Priority;

    use super::*;
    use crate::verdict::Verdict;

    #[test]
    fn the_texts_names_of_priorities_are_zenohs() {
        for (text, zenoh) in
            [("RealTime", Priority::RealTime), ("DataHigh", Priority::DataHigh), ("Data", Priority::Data)]
        {
            assert_eq!(format!("{zenoh:?}"), text);
        }
    }

    fn sample(key: &str, frame: &str) -> Sample {
        let frame = STANDARD.encode(frame);
        let (congestion, priority) = ("drop".to_owned(), "DataHigh".to_owned());
        Sample { at_s: 0.0, key: key.to_owned(), congestion, priority, express: false, frame }
    }

    fn verdict(rule: &str, samples: &[Sample]) -> Verdict {
        let mut rulings = Rulings::new(&[rule.to_owned()]);
        judge(samples, "ncp", &mut rulings);
        rulings.verdicts("watch", str::to_owned)[0].verdict
    }

    /// Frames of the streams `front` and `rear`, with these stamps in turn.
    fn streams(seqs: &[(i64, i64)]) -> Vec<Sample> {
        let frame = |name: &str, seq: i64| {
            sample(&format!("ncp/session/s/sensor/{name}"), &format!(r#"{{"kind":"sensor_frame","seq":{seq}}}"#))
        };
        seqs.iter().flat_map(|(front, rear)| [frame("front", *front), frame("rear", *rear)]).collect()
    }

    #[test]
    fn streams_that_share_a_counter_are_told_from_those_that_count_for_themselves() {
        let rule = "NCP-PLANE-005";
        let own: Vec<_> = (1..9).map(|n| (n, n)).collect();
        let far: Vec<_> = (1..9).map(|n| (n, 1_000 + n)).collect();
        let shared: Vec<_> = (1..9).map(|n| (2 * n, 2 * n + 1)).collect();
        let lossy: Vec<_> = (1..9).map(|n| (3 * n, 7 * n)).collect();
        assert_eq!(verdict(rule, &streams(&own)), Verdict::Passed);
        assert_eq!(verdict(rule, &streams(&far)), Verdict::Passed);
        assert_eq!(verdict(rule, &streams(&shared)), Verdict::Failed);
        assert_eq!(verdict(rule, &streams(&lossy)), Verdict::Inconclusive);
        assert_eq!(verdict(rule, &streams(&[(5, 5), (6, 6), (1, 7)])), Verdict::Failed);
    }

    #[test]
    fn a_sample_of_another_quality_a_block_and_a_frame_on_another_plane_are_seen() {
        let sensor = r#"{"kind":"sensor_frame","seq":1}"#;
        let sound = sample("ncp/session/s/sensor", sensor);
        assert_eq!(verdict("NCP-PLANE-002", std::slice::from_ref(&sound)), Verdict::Passed);
        assert_eq!(verdict("NCP-PLANE-002", &[Sample { express: true, ..sound.clone() }]), Verdict::Failed);
        assert_eq!(verdict("NCP-PLANE-003", std::slice::from_ref(&sound)), Verdict::Inconclusive);
        assert_eq!(verdict("NCP-OBS-010", &[sound]), Verdict::Passed);
        assert_eq!(verdict("NCP-OBS-010", &[sample("ncp/session/s/command", "NCPB…")]), Verdict::Failed);
        assert_eq!(verdict("NCP-KEY-002", &[sample("ncp/session/s/command", sensor)]), Verdict::Failed);
        assert_eq!(verdict("NCP-WIRE-093", &[sample("ncp/session/s/sensor", "{")]), Verdict::Failed);
    }
}
