//! The messages of section 1.8, in the contract's order. `[NCP-WIRE-080] [NCP-WIRE-090]`
//!
//! `Default` is what a program gets that builds a message. What a receiver reads for an absent field
//! is the same, but where the declaration says `absent`.

use super::enums::{ChannelKind, EntityRole, Mode, NetworkRefKind, Observable, Role, SimMode, StimulusKind};
use super::error::{Breach, DecodeError, DecodeProblem, EncodeError, Rule};
use super::json::{LeftOut, Purpose, Reader, Writer};
use super::record::record;
use super::table::{Field, JsonType, Table};
use super::value::{Item, Value};
use super::{Fields, Frame, Kind, SortedMap, Text};
use crate::keys::segment_problem;
use crate::version::check_version;
use crate::{CONTRACT_HASH, WIRE_VERSION};

/// Values by the name of their channel or port.
pub type ChannelMap = SortedMap<ChannelValue>;

const EMPTY: Text = Text::Borrowed("");
const WORLD: Text = Text::Borrowed("world");

fn own_hash() -> Option<Text> {
    Some(Text::Borrowed(CONTRACT_HASH))
}

record! {
    /// One sample of one channel.
    message ChannelValue {
        /// The components, in the channel's unit.
        data: Vec<f64> = Vec::new();
        /// `m`, `m/s`, `rad`, …; none: the negotiated unit.
        unit: Option<Text> = None;
    }
}

impl ChannelValue {
    /// Components in a unit.
    pub fn new(data: impl Into<Vec<f64>>, unit: impl Into<Text>) -> Self {
        Self { data: data.into(), unit: Some(unit.into()) }
    }

    /// Components in the negotiated unit.
    pub fn without_unit(data: impl Into<Vec<f64>>) -> Self {
        Self { data: data.into(), unit: None }
    }
}

record! {
    /// A thing of the simulated or the physical world, by its path.
    message EntityRef {
        /// Where it stands, such as `/world/uav3/imu`.
        path: Text = EMPTY;
        /// What it is.
        role: EntityRole = EntityRole::Sensor;
        /// Free annotations.
        meta: SortedMap<Text> = SortedMap::new();
    }
}

record! {
    /// Ties an entity to a port of the session.
    message EntityBinding {
        /// The entity.
        entity: EntityRef = EntityRef::default();
        /// The port of a record or stimulus target.
        port: Text = EMPTY;
        /// `stimulus` or `record`.
        direction: Text = Text::Borrowed("stimulus");
    }
}

record! {
    /// Which network a session runs.
    message NetworkRef {
        /// How [`reference`](Self::reference) is to be read.
        kind: NetworkRefKind = NetworkRefKind::Builtin;
        /// A handle, a built-in name, a model id or a specification; `ref` on the wire.
        reference "ref": Text = EMPTY;
        /// A neuron model's name, such as `iaf_psc_alpha`.
        model_name: Option<Text> = None;
        /// Neurons a population.
        population_sizes: SortedMap<i64> = SortedMap::new();
        /// Model parameters by the simulator's names, in the simulator's units.
        params: SortedMap<f64> = SortedMap::new();
    }
}

record! {
    /// What to record.
    message RecordTarget {
        /// Under which name the observation comes back.
        port: Text = EMPTY;
        /// The population.
        target: Text = EMPTY;
        /// The family of the quantity.
        observable: Observable = Observable::Vm;
        /// Neurons of the population; empty: all.
        ids: Vec<i64> = Vec::new();
        /// Sampling interval in ms.
        cadence_ms: f64 = 1.0;
        /// The simulator's names, such as `V_m`, `g_ex`, `w`.
        recordables: Vec<Text> = Vec::new();
    }
}

record! {
    /// What a session records.
    message RecordSpec {
        /// One entry a port.
        targets: Vec<RecordTarget> = Vec::new();
    }
}

record! {
    /// Where a stimulus goes.
    message StimulusTarget {
        /// The name that stimulus frames use.
        port: Text = EMPTY;
        /// The population.
        target: Text = EMPTY;
        /// What the values are.
        kind: StimulusKind = StimulusKind::CurrentPa;
        /// Neurons of the population; empty: all.
        ids: Vec<i64> = Vec::new();
        /// Parameters of the stimulus.
        params: SortedMap<f64> = SortedMap::new();
    }
}

record! {
    /// What can drive a session.
    message StimulusSpec {
        /// One entry a port.
        targets: Vec<StimulusTarget> = Vec::new();
    }
}

record! {
    /// How a session runs.
    message SimConfig {
        /// The simulation's resolution in ms.
        dt_ms: f64 = 0.1;
        /// How far a step goes that does not say, in ms.
        chunk_ms: f64 = 10.0;
        /// The seed of the random numbers.
        seed: Option<i64> = None;
        /// Chunk by chunk, or once.
        mode: SimMode = SimMode::Stream;
        /// How long a batch runs, in ms.
        duration_ms: Option<f64> = None;
    }
}

record! {
    /// Where the numbers of a session come from.
    message SimProvenance {
        /// The network that was built.
        network_ref: Text = EMPTY;
        /// What runs it.
        backend: Text = EMPTY;
        /// The seed of the random numbers.
        seed: Option<i64> = None;
        /// Pinned to `false`: the numbers are no calibrated statement about a real system.
        calibrated_posterior: bool = false;
        /// Pinned to `true`: a model produced the numbers.
        is_simulation_output: bool = true;
        /// Whether the numbers only advise.
        advisory_only: bool = true;
        /// For people.
        note: Option<Text> = None;
    }
}

record! {
    /// Control RPC: open a session.
    frame OpenSession of OpenSession "open_session" {
        /// The id that the client chose.
        [required] session_id: Text = EMPTY;
        /// The network to run.
        [required] network: NetworkRef = NetworkRef::default();
        /// What to record.
        record: RecordSpec = RecordSpec::default();
        /// What can drive it.
        stimulus: StimulusSpec = StimulusSpec::default();
        /// How to run.
        sim: SimConfig = SimConfig::default();
        /// Entities and their ports.
        bindings: Vec<EntityBinding> = Vec::new();
        /// The client's contract hash.
        contract_hash: Option<Text> = own_hash(), absent None;
    }
}

record! {
    /// The reply to [`OpenSession`].
    frame SessionOpened of SessionOpened "session_opened" {
        /// The request's.
        [required] session_id: Text = EMPTY;
        /// `false`: nothing was opened.
        ok: bool = true;
        /// What runs the network.
        backend: Text = Text::Borrowed("mock");
        /// Neurons a population, as built.
        resolved: SortedMap<i64> = SortedMap::new();
        /// Where the numbers come from.
        provenance: Option<SimProvenance> = None;
        /// Why not, when `ok` is `false`.
        error: Option<Text> = None;
        /// The server's contract hash.
        contract_hash: Option<Text> = own_hash(), absent None;
    }
}

record! {
    /// Values for the stimulus ports.
    frame StimulusFrame of StimulusFrame "stimulus_frame" {
        /// The session.
        [required] session_id: Text = EMPTY;
        /// Seconds on the sender's monotonic clock.
        t: f64 = 0.0;
        /// A value a port, in the unit of its stimulus kind.
        values: ChannelMap = ChannelMap::new();
    }
}

record! {
    /// Control RPC: advance a session.
    frame StepRequest of StepRequest "step_request" {
        /// The session.
        [required] session_id: Text = EMPTY;
        /// Simulation time to advance in ms; none: [`SimConfig::chunk_ms`].
        advance_ms: Option<f64> = None;
        /// Applied before the step; of the request's session and version.
        stimulus: Option<StimulusFrame> = None;
    }
}

record! {
    /// Control RPC: run a session for a stated time.
    frame RunRequest of RunRequest "run_request" {
        /// The session.
        [required] session_id: Text = EMPTY;
        /// Simulation time to run, in ms.
        [required] duration_ms: f64 = 0.0;
        /// Applied before the run; of the request's session and version.
        stimulus: Option<StimulusFrame> = None;
    }
}

record! {
    /// The samples of one port, in step with each other.
    message Observation {
        /// The port of the record target.
        port: Text = EMPTY;
        /// The population.
        target: Text = EMPTY;
        /// The family of the quantity.
        observable: Observable = Observable::Vm;
        /// Simulation times in ms.
        times: Vec<f64> = Vec::new();
        /// The values, in [`unit`](Self::unit).
        values: Vec<f64> = Vec::new();
        /// The neurons.
        senders: Vec<i64> = Vec::new();
        /// The unit of the values.
        unit: Option<Text> = None;
        /// The simulator's name of the quantity, such as `g_ex`.
        recordable: Option<Text> = None;
    }
}

record! {
    /// The reply to [`StepRequest`] and [`RunRequest`], and the frame of the observation plane.
    frame ObservationFrame of ObservationFrame "observation_frame" {
        /// The session.
        [required] session_id: Text = EMPTY;
        /// Counts the frames of this stream.
        seq: i64 = 0;
        /// Seconds on the sender's monotonic clock.
        t: f64 = 0.0;
        /// Simulation time at the end of the step, in ms.
        sim_time_ms: f64 = 0.0;
        /// An observation a port.
        records: SortedMap<Observation> = SortedMap::new();
        /// Pinned to `false`: the numbers are no calibrated statement about a real system.
        calibrated_posterior: bool = false;
        /// Pinned to `true`: a model produced the numbers.
        is_simulation_output: bool = true;
    }
}

record! {
    /// One port's samples as a BulkBlock. The contract gives it no JSON form; this one is allowed
    /// (`NCP-OBS-012`).
    frame BulkObservation of BulkObservation "bulk_observation" {
        /// The port of the record target.
        port: Text = EMPTY;
        /// The population.
        target: Text = EMPTY;
        /// The family of the quantity.
        observable: Observable = Observable::Vm;
        /// The unit of the values.
        unit: Option<Text> = None;
        /// The simulator's name of the quantity.
        recordable: Option<Text> = None;
        /// The BulkBlock, in base64 on the wire; [`bulk`](crate::bulk) reads it. `// [NCP-OBS-011]`
        block: Vec<u8> = Vec::new();
    }
}

record! {
    /// Control RPC: close a session.
    frame CloseSession of CloseSession "close_session" {
        /// The session.
        [required] session_id: Text = EMPTY;
    }
}

record! {
    /// The reply to [`CloseSession`].
    frame SessionClosed of SessionClosed "session_closed" {
        /// The session.
        [required] session_id: Text = EMPTY;
        /// `false`: there was no such session.
        ok: bool = true;
    }
}

record! {
    /// What a channel carries.
    message ChannelSpec {
        /// The channel's name.
        name: Text = EMPTY;
        /// The shape of its value.
        kind: ChannelKind = ChannelKind::Scalar;
        /// The unit of its components.
        unit: Option<Text> = None;
        /// How many components an array has.
        size: Option<i64> = None;
        /// Whether a frame may lack it.
        optional: bool = true;
        /// For people.
        description: Option<Text> = None;
    }
}

record! {
    /// The limits within which a plant may move.
    message SafetyLimits {
        /// The largest speed in m/s.
        max_speed_mps: Option<f64> = None;
        /// The largest tilt in rad; it only advises.
        max_tilt_rad: Option<f64> = None;
        /// The radius of the fence about the frame's origin, in m.
        geofence_radius_m: Option<f64> = None;
        /// How old the last sensor frame may be, in ms.
        command_timeout_ms: f64 = 500.0;
    }
}

record! {
    /// What a controller or a plant offers, and within which limits.
    frame Capabilities of Capabilities "capabilities" {
        /// Who says so.
        [required] controller_id: Text = EMPTY;
        /// Which end of the loop it is.
        role: Role = Role::Controller;
        /// Ticks a second.
        control_rate_hz: f64 = 20.0;
        /// What it senses or needs.
        sensor_channels: Vec<ChannelSpec> = Vec::new();
        /// What it commands or obeys.
        command_channels: Vec<ChannelSpec> = Vec::new();
        /// Such as `ncp.codec.rate.v0`.
        codec_id: Option<Text> = None;
        /// The limits.
        safety: SafetyLimits = SafetyLimits::default();
    }
}

record! {
    /// Perception: what the body senses.
    frame SensorFrame of SensorFrame "sensor_frame" {
        /// Counts the frames of this stream, not of the session; 0: not stamped.
        /// `// [NCP-PLANE-005]`
        seq: i64 = 0;
        /// Seconds on the sender's monotonic clock.
        t: f64 = 0.0;
        /// The reference frame.
        frame_id: Text = WORLD;
        /// A value a channel.
        channels: ChannelMap = ChannelMap::new();
    }
}

record! {
    /// Action: what the body is to do.
    frame CommandFrame of CommandFrame "command_frame" {
        /// The `seq` of the sensor frame that it was computed from; 0: not stamped.
        /// `// [NCP-PLANE-006]`
        seq: i64 = 0;
        /// Seconds on the sender's monotonic clock.
        t: f64 = 0.0;
        /// The reference frame.
        frame_id: Text = WORLD;
        /// Only [`Mode::Active`] moves the plant. A program that builds a command means it; a
        /// receiver that finds no mode reads [`Mode::Hold`].
        mode: Mode = Mode::Active, absent Mode::Hold;
        /// How long the command may be acted upon, in ms from its arrival.
        ttl_ms: f64 = 200.0;
        /// The setpoints of tick 0.
        channels: ChannelMap = ChannelMap::new();
        /// The setpoints of the ticks 1, 2, …; plain maps on the wire. `// [NCP-WIRE-051]`
        horizon: Vec<ChannelMap> = Vec::new();
        /// The length of a tick in ms.
        horizon_dt_ms: Option<f64> = None;
    }
}

record! {
    /// Observation: how the control loop is doing.
    frame ControlStatus of ControlStatus "control_status" {
        /// Its own counter.
        seq: i64 = 0;
        /// Seconds on the sender's monotonic clock.
        t: f64 = 0.0;
        /// The mode of the last command.
        mode: Mode = Mode::Init;
        /// Simulation time in ms.
        sim_time_ms: f64 = 0.0;
        /// Measured time of the tick in ms.
        loop_latency_ms: f64 = 0.0;
        /// Whether the governor let the command pass.
        safety_ok: bool = true;
        /// For people.
        note: Option<Text> = None;
    }
}

record! {
    /// Observation: how a stream arrives.
    frame LinkStatus of LinkStatus "link_status" {
        /// The session; may be empty.
        session_id: Text = EMPTY;
        /// Seconds on the sender's monotonic clock.
        t: f64 = 0.0;
        /// The highest seq seen; −1: none.
        last_seq: i64 = -1;
        /// Frames that arrived.
        received: i64 = 0;
        /// Frames that did not.
        lost: i64 = 0;
        /// Lost over expected, 0 to 1.
        loss_rate: f64 = 0.0;
        /// Whether the loss detector is above its threshold.
        burst: bool = false;
    }
}

/// The reply to a request that cannot be served. It is not one of the proto's messages, and has no
/// version.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct ErrorFrame {
    /// What went wrong, for people.
    pub error: Text,
    /// The session that it concerns.
    pub session_id: Option<Text>,
}

impl ErrorFrame {
    /// The table of the error frame.
    pub const TABLE: Table = Table {
        message: "ErrorFrame",
        kind: Some(Kind::Error),
        fields: &[
            Field { name: "kind", json: JsonType::String, required: true },
            Field { name: "error", json: JsonType::String, required: true },
            Field { name: "session_id", json: <Option<Text>>::JSON, required: false },
        ],
    };

    fn read_members(r: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let mut has_kind = false;
        let mut error = None;
        let mut session_id = None;
        let mark = r.mark();
        let mut more = r.open_object(JsonType::Object("ErrorFrame"))?;
        while more {
            let name_at = r.at();
            let name = r.name()?;
            match &*name {
                "kind" => r.fill_kind(&mut has_kind, Kind::Error)?,
                "error" => r.fill(&mut error, "error")?,
                "session_id" => r.fill(&mut session_id, "session_id")?,
                _ => r.ignore(&name, name_at)?,
            }
            more = r.next_member()?;
        }
        r.no_repeats(mark)?;
        r.settle_header(has_kind, true)?;
        // [NCP-WIRE-101] Nor is there one for a program that builds the frame without it.
        let missing = || r.error(DecodeProblem::Missing).inside("error");
        let error = error.ok_or_else(missing)?;
        Ok(Self { error, session_id: session_id.flatten() })
    }

    // [NCP-WIRE-102]
    fn write_members(&self, w: &mut Writer) {
        w.literal(r#"{"kind":"error","error":"#);
        w.string(&self.error);
        if let Some(session_id) = &self.session_id {
            w.literal(r#","session_id":"#);
            w.string(session_id);
        }
        w.literal("}");
    }
}

impl Frame for ErrorFrame {
    const KIND: Kind = Kind::Error;

    // [NCP-WIRE-100]
    fn decode(frame: &[u8]) -> Result<Self, DecodeError> {
        Self::KIND.check_len(frame.len())?;
        let mut r = Reader::new(frame, Purpose::Receive)?;
        r.begin()?;
        let message = Self::read_members(&mut r)?;
        r.end()?;
        Ok(message)
    }

    /// An error frame has no version that could be asked for.
    fn decode_strict(frame: &[u8]) -> Result<Self, DecodeError> {
        Self::decode(frame)
    }

    fn encode(&self) -> Result<String, EncodeError> {
        let mut w = Writer::new();
        self.write_members(&mut w);
        w.finish(Self::KIND)
    }
}

impl Fields for ErrorFrame {
    fn build(fields: &[u8]) -> Result<Self, DecodeError> {
        let mut r = Reader::new(fields, Purpose::Build)?;
        r.begin()?;
        let message = Self::read_members(&mut r)?;
        r.end()?;
        Ok(message)
    }

    fn show(&self, w: &mut Writer) -> Result<(), EncodeError> {
        self.write_members(w);
        Ok(())
    }
}

/// A stimulus frame inside a request may leave its header to the request.
impl Value for StimulusFrame {
    const JSON: JsonType = JsonType::Object("StimulusFrame");

    fn read(r: &mut Reader<'_>) -> Result<Self, DecodeError> {
        r.in_request = true;
        let frame = Self::read_members(r);
        r.in_request = false;
        frame
    }

    fn write(&self, w: &mut Writer) -> Result<(), EncodeError> {
        self.write_members(w)
    }
}

/// What the types of a message do not express. It holds of every message that was read, and of
/// every message that is written.
trait Rules {
    /// Takes over what the frame inside a request left to it.
    fn inherit(&mut self, _left_out: LeftOut) {}

    /// Says which rule the message breaks.
    fn check(&self) -> Result<(), Breach> {
        Ok(())
    }

    /// Says whether the strict profile misses the message's place in its stream.
    fn check_stamp(&self) -> Result<(), Breach> {
        Ok(())
    }
}

impl Rules for SensorFrame {}
impl Rules for ControlStatus {}
impl Rules for LinkStatus {}
impl Rules for Capabilities {}
impl Rules for BulkObservation {}

impl Rules for CommandFrame {
    /// `[NCP-STRICT-004]`
    fn check_stamp(&self) -> Result<(), Breach> {
        if self.seq < 1 {
            return Err(Breach { field: "seq", rule: Rule::Unstamped });
        }
        Ok(())
    }
}

impl Rules for OpenSession {
    fn check(&self) -> Result<(), Breach> {
        check_session_id(&self.session_id)
    }
}

impl Rules for SessionOpened {
    fn check(&self) -> Result<(), Breach> {
        check_session_id(&self.session_id)?;
        let Some(provenance) = &self.provenance else {
            return Ok(());
        };
        // [NCP-PROV-003] [NCP-PROV-004]
        check_pin("provenance.calibrated_posterior", provenance.calibrated_posterior, false)?;
        check_pin("provenance.is_simulation_output", provenance.is_simulation_output, true)
    }
}

impl Rules for StimulusFrame {
    fn check(&self) -> Result<(), Breach> {
        check_session_id(&self.session_id)
    }
}

impl Rules for StepRequest {
    fn inherit(&mut self, left_out: LeftOut) {
        inherit(self.stimulus.as_mut(), left_out, &self.ncp_version, &self.session_id);
    }

    fn check(&self) -> Result<(), Breach> {
        check_session_id(&self.session_id)?;
        check_stimulus(self.stimulus.as_ref(), &self.ncp_version, &self.session_id)
    }
}

impl Rules for RunRequest {
    fn inherit(&mut self, left_out: LeftOut) {
        inherit(self.stimulus.as_mut(), left_out, &self.ncp_version, &self.session_id);
    }

    fn check(&self) -> Result<(), Breach> {
        check_session_id(&self.session_id)?;
        check_stimulus(self.stimulus.as_ref(), &self.ncp_version, &self.session_id)
    }
}

impl Rules for ObservationFrame {
    // [NCP-PROV-001] [NCP-PROV-002] [NCP-PROV-006] [NCP-PROV-008]
    fn check(&self) -> Result<(), Breach> {
        check_session_id(&self.session_id)?;
        check_pin("calibrated_posterior", self.calibrated_posterior, false)?;
        check_pin("is_simulation_output", self.is_simulation_output, true)
    }
}

impl Rules for CloseSession {
    fn check(&self) -> Result<(), Breach> {
        check_session_id(&self.session_id)
    }
}

impl Rules for SessionClosed {
    fn check(&self) -> Result<(), Breach> {
        check_session_id(&self.session_id)
    }
}

// [NCP-WIRE-031]
fn check_session_id(id: &str) -> Result<(), Breach> {
    match segment_problem(id) {
        None => Ok(()),
        Some(problem) => Err(Breach { field: "session_id", rule: Rule::SessionId(problem) }),
    }
}

fn check_pin(field: &'static str, value: bool, pinned: bool) -> Result<(), Breach> {
    if value == pinned { Ok(()) } else { Err(Breach { field, rule: Rule::Pin { pinned } }) }
}

// [NCP-WIRE-035]
fn inherit(stimulus: Option<&mut StimulusFrame>, left_out: LeftOut, ncp_version: &Text, session_id: &Text) {
    let Some(stimulus) = stimulus else { return };
    if left_out.ncp_version {
        stimulus.ncp_version.clone_from(ncp_version);
    }
    if left_out.session_id {
        stimulus.session_id.clone_from(session_id);
    }
}

fn check_stimulus(stimulus: Option<&StimulusFrame>, ncp_version: &str, session_id: &str) -> Result<(), Breach> {
    let Some(stimulus) = stimulus else {
        return Ok(());
    };
    if stimulus.session_id != session_id {
        return Err(Breach { field: "stimulus.session_id", rule: Rule::StimulusSession }); // [NCP-WIRE-037]
    }
    if stimulus.ncp_version != ncp_version {
        return Err(Breach { field: "stimulus.ncp_version", rule: Rule::StimulusVersion }); // [NCP-WIRE-038]
    }
    Ok(())
}
