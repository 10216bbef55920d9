/**
 * The messages of the wire: every table of section 1.8, every enum of section 1.4.
 *
 * Fields keep their names of the wire, and with them their units: `_ms` milliseconds, `_s` seconds,
 * `_m` metres, `_mps` metres per second, `_rad` radians, `_hz` hertz. In a complete message an unset
 * optional field is `null`, a map is a `Map`, and an array of numbers is a `Float64Array`, also where
 * the numbers are integers (they stay within ±(2^53 − 1), so a double holds them exactly).
 *
 * @module
 */

import { NCP_CONTRACT_HASH, NCP_VERSION } from "./identity.js";
import {
  builtAs,
  field,
  fresh,
  inherited,
  leftOut,
  optional,
  required,
  table,
  type Entries,
  type Field,
  type InputOf,
  type MessageOf,
  type Shape,
  type Table,
} from "./table.js";

/** The family of a recorded quantity. */
export type Observable = "V_m" | "spikes" | "rate" | "weight" | "binary_state" | UnknownString;
/** What the values of a stimulus are. */
export type StimulusKind = "current_pA" | "rate_hz" | "spike_times" | "weight_set" | "rate_inject" | UnknownString;
/** How the `ref` of a network is to be read. */
export type NetworkRefKind = "handle" | "builtin" | "model_id" | "spec" | UnknownString;
/** What an entity is. */
export type EntityRole = "system" | "actor" | "sensor" | "actuator" | UnknownString;
/** The shape of a channel's value. */
export type ChannelKind = "scalar" | "vec3" | "quat" | "array" | UnknownString;
/** Who states capabilities. */
export type Role = "controller" | "plant" | UnknownString;
/** What a command asks for; only `active` moves a plant. */
export type Mode = "init" | "active" | "hold" | "estop";
/** How a simulation runs: step by step, or in one run. */
export type SimMode = "stream" | "batch";
/** A wire string that this version does not know, kept as it is. [NCP-WIRE-042] */
export type UnknownString = string & {};

// --- how fields are declared ---------------------------------------------------------------------

type Numbers = Field<Float64Array, ArrayLike<number>, false>;
type MapOf<Out, In = Out> = Field<Map<string, Out>, Entries<In>, false>;
type ListOf<Out, In = Out> = Field<Out[], readonly In[], false>;

const STRING: Shape = { is: "string" };
const INTEGER: Shape = { is: "integer" };
const NUMBER: Shape = { is: "number" };
const BOOLEAN: Shape = { is: "boolean" };
const NONE = new Float64Array(0);

const text = (absent: string): Field<string, string, false> => field(STRING, absent);
const integer = (absent: number): Field<number, number, false> => field(INTEGER, absent);
const number = (absent: number): Field<number, number, false> => field(NUMBER, absent);
const boolean = (absent: boolean): Field<boolean, boolean, false> => field(BOOLEAN, absent);
const pin = <const V extends boolean>(value: V): Field<V, V, false> => field({ is: "pin", value }, value);
const kind = <const K extends string>(value: K): Field<K, K, false> => ({
  ...field({ is: "kind", value }, value),
  required: true, // [NCP-WIRE-028]
});
const version = (): Field<string, string, false> => text(NCP_VERSION); // [NCP-WIRE-032]
const session = (): Field<string, string, true> => required({ is: "segment" }); // [NCP-WIRE-031]

const numbers = (): Numbers => field({ is: "numbers" }, NONE);
const integers = (): Numbers => field({ is: "integers" }, NONE);
const map = <Out, In = Out>(of: Shape): MapOf<Out, In> => fresh({ is: "map", of }, () => new Map<string, Out>());
const list = <Out, In = Out>(of: Shape): ListOf<Out, In> => fresh({ is: "list", of }, (): Out[] => []);

const shapeOf = (of: Table): Shape => ({ is: "message", table: of });
const nested = <T extends Table>(of: T): Field<MessageOf<T>, InputOf<T>, false> =>
  fresh(shapeOf(of), () => defaultsOf(of));
const mapOf = <T extends Table>(of: T): MapOf<MessageOf<T>, InputOf<T>> => map(shapeOf(of));
const listOf = <T extends Table>(of: T): ListOf<MessageOf<T>, InputOf<T>> => list(shapeOf(of));

/** A message all of whose fields have their defaults. */
function defaultsOf<T extends Table>(of: T): MessageOf<T> {
  return Object.fromEntries(of.fields.map(({ name, absent }) => [name, absent()])) as MessageOf<T>;
}

const enumeration = (unknown: "keep" | "hold" | "reject", ...values: string[]): Shape => ({
  is: "enum",
  values: new Set(values),
  unknown,
});

// --- enums: letter for letter [NCP-WIRE-040] [NCP-WIRE-087] --------------------------------------

const OBSERVABLE = enumeration("keep", "V_m", "spikes", "rate", "weight", "binary_state");
const STIMULUS_KIND = enumeration("keep", "current_pA", "rate_hz", "spike_times", "weight_set", "rate_inject");
const NETWORK_REF_KIND = enumeration("keep", "handle", "builtin", "model_id", "spec");
const ENTITY_ROLE = enumeration("keep", "system", "actor", "sensor", "actuator");
const CHANNEL_KIND = enumeration("keep", "scalar", "vec3", "quat", "array");
const ROLE = enumeration("keep", "controller", "plant");
const MODE = enumeration("hold", "init", "active", "hold", "estop"); // [NCP-WIRE-041]
const SIM_MODE = enumeration("reject", "stream", "batch"); // [NCP-WIRE-044]

// --- messages that stand inside others -----------------------------------------------------------

const CHANNEL_VALUE = table("ChannelValue", {
  /** The components, in the channel's unit. */
  data: numbers(),
  /** `m`, `m/s`, `rad`, …; `null`: the negotiated unit. */
  unit: optional<string>(STRING),
});

const ENTITY_REF = table("EntityRef", {
  /** Where it stands, such as `/world/uav3/imu`. */
  path: text(""),
  /** What it is. */
  role: field<EntityRole>(ENTITY_ROLE, "sensor"),
  /** Free annotations. */
  meta: map<string>(STRING),
});

const ENTITY_BINDING = table("EntityBinding", {
  /** The entity. */
  entity: nested(ENTITY_REF),
  /** The port of a record or stimulus target. */
  port: text(""),
  /** `stimulus` or `record`. */
  direction: text("stimulus"),
});

const NETWORK_REF = table("NetworkRef", {
  /** How `ref` is to be read. */
  kind: field<NetworkRefKind>(NETWORK_REF_KIND, "builtin"),
  /** A handle, a built-in name, a model id or a specification. */
  ref: text(""),
  /** A neuron model's name, such as `iaf_psc_alpha`. */
  model_name: optional<string>(STRING),
  /** Neurons a population. */
  population_sizes: map<number>(INTEGER),
  /** Model parameters by the simulator's names and units. */
  params: map<number>(NUMBER),
});

const RECORD_TARGET = table("RecordTarget", {
  /** Under which name the observation comes back. */
  port: text(""),
  /** The population. */
  target: text(""),
  /** The family of the quantity. */
  observable: field<Observable>(OBSERVABLE, "V_m"),
  /** Neurons of the population; empty: all. */
  ids: integers(),
  /** Sampling interval, ms. */
  cadence_ms: number(1),
  /** The simulator's names, such as `V_m`, `g_ex`, `w`. */
  recordables: list<string>(STRING),
});

const RECORD_SPEC = table("RecordSpec", {
  /** One entry a port. */
  targets: listOf(RECORD_TARGET),
});

const STIMULUS_TARGET = table("StimulusTarget", {
  /** The name that stimulus frames use. */
  port: text(""),
  /** The population. */
  target: text(""),
  /** What the values are. */
  kind: field<StimulusKind>(STIMULUS_KIND, "current_pA"),
  /** Neurons of the population; empty: all. */
  ids: integers(),
  /** Parameters of the stimulus. */
  params: map<number>(NUMBER),
});

const STIMULUS_SPEC = table("StimulusSpec", {
  /** One entry a port. */
  targets: listOf(STIMULUS_TARGET),
});

const SIM_CONFIG = table("SimConfig", {
  /** Integration step, ms. */
  dt_ms: number(0.1),
  /** Simulation time of one step request, ms. */
  chunk_ms: number(10),
  /** Random seed; `null`: the server chooses. */
  seed: optional<number>(INTEGER),
  /** `stream` step by step, `batch` in one run. */
  mode: field<SimMode>(SIM_MODE, "stream"),
  /** Length of a batch, ms. */
  duration_ms: optional<number>(NUMBER),
});

const SIM_PROVENANCE = table("SimProvenance", {
  /** The network as it was resolved. */
  network_ref: text(""),
  /** The simulator and its version. */
  backend: text(""),
  /** The seed that was used. */
  seed: optional<number>(INTEGER),
  /** Pinned: the numbers are no calibrated statement about a real system. [NCP-PROV-003] */
  calibrated_posterior: pin(false),
  /** Pinned: a model produced the numbers. [NCP-PROV-004] */
  is_simulation_output: pin(true),
  /** The output is advice, not an instruction. */
  advisory_only: boolean(true),
  /** For people. */
  note: optional<string>(STRING),
});

const OBSERVATION = table("Observation", {
  /** The port of the record target. */
  port: text(""),
  /** The population. */
  target: text(""),
  /** The family of the quantity. */
  observable: field<Observable>(OBSERVABLE, "V_m"),
  /** A time a sample, ms of simulation time. */
  times: numbers(),
  /** A value a sample, in `unit`; empty for spikes. */
  values: numbers(),
  /** The neuron of each sample. */
  senders: integers(),
  /** `mV`, `nS`, `Hz`, … */
  unit: optional<string>(STRING),
  /** The simulator's name of the quantity. */
  recordable: optional<string>(STRING),
});

const CHANNEL_SPEC = table("ChannelSpec", {
  /** The channel's name. */
  name: text(""),
  /** The shape of its value. */
  kind: field<ChannelKind>(CHANNEL_KIND, "scalar"),
  /** The unit of its components. */
  unit: optional<string>(STRING),
  /** Components of an `array`. */
  size: optional<number>(INTEGER),
  /** Frames may come without it. */
  optional: boolean(true),
  /** For people. */
  description: optional<string>(STRING),
});

const SAFETY_LIMITS = table("SafetyLimits", {
  /** m/s; `null` or 0: no limit. */
  max_speed_mps: optional<number>(NUMBER),
  /** rad; advisory. */
  max_tilt_rad: optional<number>(NUMBER),
  /** m, about the frame's origin; `null` or 0: no fence. */
  geofence_radius_m: optional<number>(NUMBER),
  /** Age at which a sensor is stale, ms. */
  command_timeout_ms: number(500),
});

// --- messages of their own -----------------------------------------------------------------------

const OPEN_SESSION = table("OpenSession", {
  /** The wire version of the sender. */
  ncp_version: version(),
  kind: kind("open_session"),
  /** The id that the client chose. */
  session_id: session(),
  /** The network to run. */
  network: required<NetworkRef, NetworkRefInput>(shapeOf(NETWORK_REF)),
  /** What to record. */
  record: nested(RECORD_SPEC),
  /** What can drive it. */
  stimulus: nested(STIMULUS_SPEC),
  /** How to run. */
  sim: nested(SIM_CONFIG),
  /** Entities and their ports. */
  bindings: listOf(ENTITY_BINDING),
  /** The client's contract hash. [NCP-WIRE-025] [NCP-WIRE-089] */
  contract_hash: builtAs(optional<string>(STRING), NCP_CONTRACT_HASH),
});

const SESSION_OPENED = table("SessionOpened", {
  /** The wire version of the sender. */
  ncp_version: version(),
  kind: kind("session_opened"),
  /** The request's. */
  session_id: session(),
  /** `false`: nothing was opened. */
  ok: boolean(true),
  /** What runs the network. */
  backend: text("mock"),
  /** Neurons a population, as built. */
  resolved: map<number>(INTEGER),
  /** Where the numbers come from. */
  provenance: optional<SimProvenance, SimProvenanceInput>(shapeOf(SIM_PROVENANCE)),
  /** Why not, when `ok` is `false`. */
  error: optional<string>(STRING),
  /** The server's contract hash. [NCP-WIRE-025] [NCP-WIRE-089] */
  contract_hash: builtAs(optional<string>(STRING), NCP_CONTRACT_HASH),
});

const STIMULUS_FRAME = table("StimulusFrame", {
  /** The wire version of the sender. */
  ncp_version: version(),
  kind: kind("stimulus_frame"),
  /** The session. */
  session_id: session(),
  /** s, on the sender's monotonic clock. */
  t: number(0),
  /** A value a port, in the unit of its stimulus kind. */
  values: mapOf(CHANNEL_VALUE),
});

/** A stimulus frame inside a request, which says what the frame leaves out. [NCP-WIRE-035] */
const INNER_STIMULUS = table("StimulusFrame", {
  /** The request's. */
  ncp_version: inherited<string>(STRING),
  kind: field<"stimulus_frame">({ is: "kind", value: "stimulus_frame" }, "stimulus_frame"),
  /** The request's. */
  session_id: inherited<string>(STRING),
  /** s, on the sender's monotonic clock. */
  t: number(0),
  /** A value a port, in the unit of its stimulus kind. */
  values: mapOf(CHANNEL_VALUE),
});

const STEP_REQUEST = table("StepRequest", {
  /** The wire version of the sender. */
  ncp_version: version(),
  kind: kind("step_request"),
  /** The session. */
  session_id: session(),
  /** Simulation time to advance, ms; `null`: the session's `chunk_ms`. */
  advance_ms: optional<number>(NUMBER),
  /** Applied before the step. */
  stimulus: optional<StimulusFrame, InputOf<typeof INNER_STIMULUS>>(shapeOf(INNER_STIMULUS)),
});

const RUN_REQUEST = table("RunRequest", {
  /** The wire version of the sender. */
  ncp_version: version(),
  kind: kind("run_request"),
  /** The session. */
  session_id: session(),
  /** Simulation time to run, ms. */
  duration_ms: required<number>(NUMBER),
  /** Applied before the run. */
  stimulus: optional<StimulusFrame, InputOf<typeof INNER_STIMULUS>>(shapeOf(INNER_STIMULUS)),
});

const OBSERVATION_FRAME = table("ObservationFrame", {
  /** The wire version of the sender. */
  ncp_version: version(),
  kind: kind("observation_frame"),
  /** The session. */
  session_id: session(),
  /** Counts the frames of this stream. */
  seq: integer(0),
  /** s, on the sender's monotonic clock. */
  t: number(0),
  /** Simulation time at the end of the step, ms. */
  sim_time_ms: number(0),
  /** An observation a port. */
  records: mapOf(OBSERVATION),
  /** Pinned: the numbers are no calibrated statement about a real system. [NCP-PROV-001] */
  calibrated_posterior: pin(false),
  /** Pinned: a model produced the numbers. [NCP-PROV-002] */
  is_simulation_output: pin(true),
});

const CLOSE_SESSION = table("CloseSession", {
  /** The wire version of the sender. */
  ncp_version: version(),
  kind: kind("close_session"),
  /** The session. */
  session_id: session(),
});

const SESSION_CLOSED = table("SessionClosed", {
  /** The wire version of the sender. */
  ncp_version: version(),
  kind: kind("session_closed"),
  /** The session. */
  session_id: session(),
  /** `false`: there was no such session. */
  ok: boolean(true),
});

const CAPABILITIES = table("Capabilities", {
  /** The wire version of the sender. */
  ncp_version: version(),
  kind: kind("capabilities"),
  /** Who says so. */
  controller_id: required<string>(STRING),
  /** `controller` or `plant`. */
  role: field<Role>(ROLE, "controller"),
  /** Ticks a second. */
  control_rate_hz: number(20),
  /** What it senses or needs. */
  sensor_channels: listOf(CHANNEL_SPEC),
  /** What it commands or obeys. */
  command_channels: listOf(CHANNEL_SPEC),
  /** Such as `ncp.codec.rate.v0`. */
  codec_id: optional<string>(STRING),
  /** The limits. */
  safety: nested(SAFETY_LIMITS),
});

const SENSOR_FRAME = table("SensorFrame", {
  /** The wire version of the sender. */
  ncp_version: version(),
  kind: kind("sensor_frame"),
  /** Counts the frames of this stream; 0: not stamped. */
  seq: integer(0),
  /** s, on the sender's monotonic clock. */
  t: number(0),
  /** The reference frame. */
  frame_id: text("world"),
  /** A value a channel. */
  channels: mapOf(CHANNEL_VALUE),
});

const COMMAND_FRAME = table("CommandFrame", {
  /** The wire version of the sender. */
  ncp_version: version(),
  kind: kind("command_frame"),
  /** The `seq` of the sensor frame that it was computed from; 0: not stamped. */
  seq: integer(0),
  /** s, on the sender's monotonic clock. */
  t: number(0),
  /** The reference frame. */
  frame_id: text("world"),
  /**
   * Only `active` moves the plant. Absent from a frame it is `hold` [NCP-WIRE-024]; a program that does
   * not name it means `active` [NCP-WIRE-088].
   */
  mode: builtAs(field<Mode>(MODE, "hold"), "active"),
  /** How long the command may be acted upon, ms from its arrival. */
  ttl_ms: number(200),
  /** The setpoints of tick 0. */
  channels: mapOf(CHANNEL_VALUE),
  /** The setpoints of the ticks 1, 2, …: plain channel maps. [NCP-WIRE-051] */
  horizon: list<Map<string, ChannelValue>, Entries<ChannelValueInput>>({ is: "map", of: shapeOf(CHANNEL_VALUE) }),
  /** The length of a tick, ms. */
  horizon_dt_ms: optional<number>(NUMBER),
});

const CONTROL_STATUS = table("ControlStatus", {
  /** The wire version of the sender. */
  ncp_version: version(),
  kind: kind("control_status"),
  /** Its own counter. */
  seq: integer(0),
  /** s, on the sender's monotonic clock. */
  t: number(0),
  /** The mode of the last command. */
  mode: field<Mode>(MODE, "init"),
  /** Simulation time, ms. */
  sim_time_ms: number(0),
  /** Measured time of the tick, ms. */
  loop_latency_ms: number(0),
  /** The governor let the command pass. */
  safety_ok: boolean(true),
  /** For people. */
  note: optional<string>(STRING),
});

const LINK_STATUS = table("LinkStatus", {
  /** The wire version of the sender. */
  ncp_version: version(),
  kind: kind("link_status"),
  /** The session; may be empty. */
  session_id: text(""),
  /** s, on the sender's monotonic clock. */
  t: number(0),
  /** The highest seq seen; −1: none. */
  last_seq: integer(-1),
  /** Frames that arrived. */
  received: integer(0),
  /** Frames that did not. */
  lost: integer(0),
  /** Lost over expected, 0 to 1. */
  loss_rate: number(0),
  /** The loss detector is above its threshold. */
  burst: boolean(false),
});

const BULK_OBSERVATION = table("BulkObservation", {
  /** The wire version of the sender. */
  ncp_version: version(),
  kind: kind("bulk_observation"),
  /** The port of the record target. */
  port: text(""),
  /** The population. */
  target: text(""),
  /** The family of the quantity. */
  observable: field<Observable>(OBSERVABLE, "V_m"),
  /** The unit of `values`. */
  unit: optional<string>(STRING),
  /** The simulator's name of the quantity. */
  recordable: optional<string>(STRING),
  /** The BulkBlock in base64. [NCP-OBS-011] [NCP-OBS-012] */
  block: text(""),
});

const ERROR_FRAME = table("ErrorFrame", {
  kind: kind("error"),
  /** What went wrong, for people. [NCP-WIRE-101] */
  error: required<string>(STRING),
  /** The session that it concerns. [NCP-WIRE-100] [NCP-WIRE-102] */
  session_id: leftOut(optional<string>(STRING)),
});

// --- what a program sees -------------------------------------------------------------------------

/** The tables of the messages that travel on their own, by kind. */
export const TABLES = {
  open_session: OPEN_SESSION,
  session_opened: SESSION_OPENED,
  stimulus_frame: STIMULUS_FRAME,
  step_request: STEP_REQUEST,
  run_request: RUN_REQUEST,
  observation_frame: OBSERVATION_FRAME,
  close_session: CLOSE_SESSION,
  session_closed: SESSION_CLOSED,
  capabilities: CAPABILITIES,
  sensor_frame: SENSOR_FRAME,
  command_frame: COMMAND_FRAME,
  control_status: CONTROL_STATUS,
  link_status: LINK_STATUS,
  bulk_observation: BULK_OBSERVATION,
  error: ERROR_FRAME,
} as const;

/** The name of a message type on the wire. `error` is the RPC error frame. */
export type Kind = keyof typeof TABLES;

/** Every kind, in the order of the contract, and `error` last. */
export const KINDS: readonly Kind[] = Object.freeze(Object.keys(TABLES) as Kind[]);

/** Whether the text is the name of a kind. */
export function isKind(text: string): text is Kind {
  return Object.hasOwn(TABLES, text);
}

/** A sample of one channel. */
export interface ChannelValue extends MessageOf<typeof CHANNEL_VALUE> {}
/** A thing of the simulated or the physical world, by its path. */
export interface EntityRef extends MessageOf<typeof ENTITY_REF> {}
/** Ties an entity to a port of the session. */
export interface EntityBinding extends MessageOf<typeof ENTITY_BINDING> {}
/** Which network a session runs. */
export interface NetworkRef extends MessageOf<typeof NETWORK_REF> {}
/** What to record. */
export interface RecordTarget extends MessageOf<typeof RECORD_TARGET> {}
/** What a session records. */
export interface RecordSpec extends MessageOf<typeof RECORD_SPEC> {}
/** Where a stimulus goes. */
export interface StimulusTarget extends MessageOf<typeof STIMULUS_TARGET> {}
/** What a session can be driven by. */
export interface StimulusSpec extends MessageOf<typeof STIMULUS_SPEC> {}
/** How the simulation runs. */
export interface SimConfig extends MessageOf<typeof SIM_CONFIG> {}
/** Where the numbers of a session come from. */
export interface SimProvenance extends MessageOf<typeof SIM_PROVENANCE> {}
/** The recorded samples of one port. */
export interface Observation extends MessageOf<typeof OBSERVATION> {}
/** A channel that a peer offers or takes. */
export interface ChannelSpec extends MessageOf<typeof CHANNEL_SPEC> {}
/** What the governor enforces. */
export interface SafetyLimits extends MessageOf<typeof SAFETY_LIMITS> {}

/** Control RPC: open a session. */
export interface OpenSession extends MessageOf<typeof OPEN_SESSION> {}
/** The reply to `open_session`. */
export interface SessionOpened extends MessageOf<typeof SESSION_OPENED> {}
/** Values for the stimulus ports. */
export interface StimulusFrame extends MessageOf<typeof STIMULUS_FRAME> {}
/** Control RPC: advance a session. */
export interface StepRequest extends MessageOf<typeof STEP_REQUEST> {}
/** Control RPC: run a session for a stated time. */
export interface RunRequest extends MessageOf<typeof RUN_REQUEST> {}
/** The reply to `step_request` and `run_request`, and the frame of the observation plane. */
export interface ObservationFrame extends MessageOf<typeof OBSERVATION_FRAME> {}
/** Control RPC: close a session. */
export interface CloseSession extends MessageOf<typeof CLOSE_SESSION> {}
/** The reply to `close_session`. */
export interface SessionClosed extends MessageOf<typeof SESSION_CLOSED> {}
/** What a controller or a plant offers, and within which limits. */
export interface Capabilities extends MessageOf<typeof CAPABILITIES> {}
/** Perception: what the body senses. */
export interface SensorFrame extends MessageOf<typeof SENSOR_FRAME> {}
/** Action: what the body is to do. */
export interface CommandFrame extends MessageOf<typeof COMMAND_FRAME> {}
/** Observation: how the control loop is doing. */
export interface ControlStatus extends MessageOf<typeof CONTROL_STATUS> {}
/** Observation: how a stream arrives. */
export interface LinkStatus extends MessageOf<typeof LINK_STATUS> {}
/** Observation: the samples of one port as a BulkBlock. */
export interface BulkObservation extends MessageOf<typeof BULK_OBSERVATION> {}
/** The reply to a request that cannot be served. */
export interface ErrorFrame extends MessageOf<typeof ERROR_FRAME> {}

type ChannelValueInput = InputOf<typeof CHANNEL_VALUE>;
type NetworkRefInput = InputOf<typeof NETWORK_REF>;
type SimProvenanceInput = InputOf<typeof SIM_PROVENANCE>;

/** The message types by kind. */
export interface Messages {
  open_session: OpenSession;
  session_opened: SessionOpened;
  stimulus_frame: StimulusFrame;
  step_request: StepRequest;
  run_request: RunRequest;
  observation_frame: ObservationFrame;
  close_session: CloseSession;
  session_closed: SessionClosed;
  capabilities: Capabilities;
  sensor_frame: SensorFrame;
  command_frame: CommandFrame;
  control_status: ControlStatus;
  link_status: LinkStatus;
  bulk_observation: BulkObservation;
  error: ErrorFrame;
}

/** Any message; its `kind` tells which. */
export type Message = Messages[Kind];

/** What a program gives to build a message of a kind: the fields without a default, and others at will. */
export type Input<K extends Kind> = InputOf<(typeof TABLES)[K]>;
