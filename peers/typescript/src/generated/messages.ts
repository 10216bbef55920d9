/**
 * The messages as plain JSON values, generated from the schemas of the repository by `npm run generate`;
 * do not edit.
 *
 * A message is complete: a field that was absent has its default, an unset optional one is `null`.
 * A type `…Input` is what a program gives to have a request made of it: what it leaves out gets its default.
 *
 * @module
 */

/** The shape of a channel's data. A receiver keeps a value that it does not know and passes it on unchanged. */
export type ChannelKind =
  /** One component. */
  | "scalar"
  /** Three components: x, y, z. */
  | "vec3"
  /** Four components: a rotation as a quaternion. */
  | "quat"
  /** Any number of components; `ChannelSpec.size` says how many. */
  | "array"
  /** Any other string: kept, and written unchanged. */
  | (string & {});

/** The part that an entity plays. A receiver keeps a value that it does not know and passes it on unchanged. */
export type EntityRole =
  /** A whole, made of other entities. */
  | "system"
  /** Something that both senses and acts, such as a robot. */
  | "actor"
  /** Something that measures. */
  | "sensor"
  /** Something that acts. */
  | "actuator"
  /** Any other string: kept, and written unchanged. */
  | (string & {});

/** The authority of a command. Only ACTIVE may move the plant. A receiver reads a value that it does not know as HOLD. */
export type Mode =
  /** Starting up: do not move. */
  | "init"
  /** Apply the channels. */
  | "active"
  /** Stay safe and still; lifts as soon as a newer active command comes. */
  | "hold"
  /** Emergency stop: latched by the plant until a supervisor resets it. */
  | "estop";

/** How `NetworkRef.ref` names the network. A receiver keeps a value that it does not know and passes it on unchanged. */
export type NetworkRefKind =
  /** A network that the server already holds, by its handle. */
  | "handle"
  /** A network that comes with the server, by its name. */
  | "builtin"
  /** A model in the server's library, by its identifier. */
  | "model_id"
  /** A network described in full by the reference itself. */
  | "spec"
  /** Any other string: kept, and written unchanged. */
  | (string & {});

/** What a record target measures. A receiver keeps a value that it does not know and passes it on unchanged. */
export type Observable =
  /** Membrane potential in mV. */
  | "V_m"
  /** Spike events: a time and a sender each. */
  | "spikes"
  /** Firing rate in Hz, or the rate variable of a rate-based model. */
  | "rate"
  /** Synaptic weight, in the simulator's unit. */
  | "weight"
  /** State of a binary neuron, 0 or 1. */
  | "binary_state"
  /** Any other string: kept, and written unchanged. */
  | (string & {});

/** The side of the control loop that a peer is on. A receiver keeps a value that it does not know and passes it on unchanged. */
export type Role =
  /** Computes commands from sensor frames. */
  | "controller"
  /** Executes commands: the robot or vehicle. */
  | "plant"
  /** Any other string: kept, and written unchanged. */
  | (string & {});

/** How the simulation advances. Closed: a receiver rejects a value that it does not know. */
export type SimMode =
  /** Chunk by chunk, as the steps are asked for. */
  | "stream"
  /** In one go, for a known duration. */
  | "batch";

/** How a stimulus drives its target. A receiver keeps a value that it does not know and passes it on unchanged. */
export type StimulusKind =
  /** Injected current in pA. */
  | "current_pA"
  /** Rate of a spike generator in Hz. */
  | "rate_hz"
  /** Spikes at given simulated times in ms. */
  | "spike_times"
  /** Synaptic weights to set, in the simulator's unit. */
  | "weight_set"
  /** Input to a rate-based model, in that model's unit. */
  | "rate_inject"
  /** Any other string: kept, and written unchanged. */
  | (string & {});

/** Observation plane: one large observation as a packed column block. Never on the action loop. */
export interface BulkObservation {
  /** Wire version of the sender, `major.minor`. */
  ncp_version: string;
  /** Always `bulk_observation`. */
  kind: "bulk_observation";
  /** The port of the record target that asked for it. */
  port: string;
  /** The population that was recorded. */
  target: string;
  /** What was measured. Defaults to `V_m`. */
  observable: Observable;
  /** Unit of the values, such as `mV`. May be unset. */
  unit: string | null;
  /** Name of the model variable, where it is not the observable's usual one. May be unset. */
  recordable: string | null;
  /** A BulkBlock: little-endian columns, `times` in ms of simulated time, `values` in `unit`, `senders` as ids. */
  block: string;
}

/** What a peer offers: its role, channels, rate and limits. */
export interface Capabilities {
  /** Wire version of the sender, `major.minor`. */
  ncp_version: string;
  /** Always `capabilities`. */
  kind: "capabilities";
  /** Who declares this. */
  controller_id: string;
  /** The side of the loop that it is on. Defaults to `controller`. */
  role: Role;
  /** Rate of the control loop in Hz. Defaults to 20. */
  control_rate_hz: number;
  /** Channels of the sensor frames. */
  sensor_channels: ChannelSpec[];
  /** Channels of the command frames. */
  command_channels: ChannelSpec[];
  /** The codec between channels and neural populations, such as `ncp.codec.rate.v0`. May be unset. */
  codec_id: string | null;
  /** The limits in force. Defaults to the defaults of SafetyLimits. */
  safety: SafetyLimits;
}

/** Declares one channel of a peer. */
export interface ChannelSpec {
  /** The channel's name, the key in `channels`. */
  name: string;
  /** The shape of its data. Defaults to `scalar`. */
  kind: ChannelKind;
  /** The unit of its components. May be unset. */
  unit: string | null;
  /** Number of components, where the kind leaves it open. May be unset. */
  size: number | null;
  /** Whether frames may come without it. Defaults to true. */
  optional: boolean;
  /** Remark for people. May be unset. */
  description: string | null;
}

/** One sample or setpoint of a named channel: a scalar, a vector or an array. */
export interface ChannelValue {
  /** The components, in the channel's order; a scalar has one. Unit: see `unit`. */
  data: number[];
  /** The unit of every component, such as `m`, `m/s` or `mV`. May be unset: then the unit is the one that was agreed for the channel. */
  unit: string | null;
}

/** Control plane, commander to server: ends a session. */
export interface CloseSession {
  /** Wire version of the sender, `major.minor`. */
  ncp_version: string;
  /** Always `close_session`. */
  kind: "close_session";
  /** The session to end. */
  session_id: string;
}

/** Action plane, commander to body: what the plant is to do now, and for a short while after. */
export interface CommandFrame {
  /** Wire version of the sender, `major.minor`. */
  ncp_version: string;
  /** Always `command_frame`. */
  kind: "command_frame";
  /** The `SensorFrame.seq` from which the command was computed; scoped to the named stream. 0: unstamped. */
  seq: number;
  /** When it was made: s on the sender's clock. Defaults to 0. */
  t: number;
  /** The coordinate frame that the channels are given in. Defaults to `world`. */
  frame_id: string;
  /** The authority of the command. Absent, unset or unknown reads as `hold`. */
  mode: Mode;
  /** How long the command may be applied, in ms on the plant's own clock from its arrival. Past it the plant holds. Defaults to 200. */
  ttl_ms: number;
  /** The setpoints of tick 0 by channel name. */
  channels: Record<string, ChannelValue>;
  /** Setpoints of the following ticks, for use while no newer command arrives; never past `ttl_ms`. */
  horizon: Record<string, ChannelValue>[];
  /** Length of a tick of the horizon in ms on the plant's clock. May be unset. */
  horizon_dt_ms: number | null;
}

/** The state of the control loop, once a tick. */
export interface ControlStatus {
  /** Wire version of the sender, `major.minor`. */
  ncp_version: string;
  /** Always `control_status`. */
  kind: "control_status";
  /** The loop's own counter of ticks. */
  seq: number;
  /** When it was made: s on the sender's clock. Defaults to 0. */
  t: number;
  /** The mode of the last command. Absent reads as `init`, unset or unknown as `hold`. */
  mode: Mode;
  /** Simulated time reached, in ms. */
  sim_time_ms: number;
  /** Time from reading the sensor to sending the command in ms on the sender's clock. */
  loop_latency_ms: number;
  /** Whether the governor let the command pass as it was. Defaults to true. */
  safety_ok: boolean;
  /** Remark for people, such as an overrun. May be unset. */
  note: string | null;
}

/** Ties an entity to a port of the session. */
export interface EntityBinding {
  /** The entity. */
  entity: EntityRef;
  /** Name of a record or stimulus port of the same request. */
  port: string;
  /** Which way data flows through the port: `stimulus` into the simulation, `record` out of it. Defaults to `stimulus`. */
  direction: string;
}

/** An entity of the world, named by a path. */
export interface EntityRef {
  /** Slash-separated path of the entity, such as `/world/uav3/imu`. Defaults to the empty string. */
  path: string;
  /** The part that it plays. Defaults to `sensor`. */
  role: EntityRole;
  /** Free annotations. No unit, no meaning to the protocol. */
  meta: Record<string, string>;
}

/** Control plane, server to commander: the reply to a request that cannot be served. */
export interface ErrorFrame {
  /** Always `error`. */
  kind: "error";
  /** What went wrong, for people. */
  error: string;
  /** The session that it concerns. Left out when there is none. */
  session_id: string | null;
}

/** The state of a link as its receiver sees it. */
export interface LinkStatus {
  /** Wire version of the sender, `major.minor`. */
  ncp_version: string;
  /** Always `link_status`. */
  kind: "link_status";
  /** The session whose link it is. Defaults to the empty string. */
  session_id: string;
  /** When it was made: s on the sender's clock. Defaults to 0. */
  t: number;
  /** Highest seq received. Defaults to -1: none yet. */
  last_seq: number;
  /** Frames received. */
  received: number;
  /** Frames missing. */
  lost: number;
  /** Share of the expected frames that is missing, from 0 to 1. */
  loss_rate: number;
  /** Whether the loss has come in a burst that the loop must act on. Defaults to false. */
  burst: boolean;
}

/** The network that a session simulates. */
export interface NetworkRef {
  /** How `ref` is to be read. Defaults to `builtin`. */
  kind: NetworkRefKind;
  /** The reference: a handle, a name, a model identifier or a description. */
  ref: string;
  /** Name of the neuron model, where the reference leaves it open. May be unset. */
  model_name: string | null;
  /** Number of neurons by population name. */
  population_sizes: Record<string, number>;
  /** Model parameters by name, in the simulator's units. */
  params: Record<string, number>;
}

/** What one record port measured. */
export interface Observation {
  /** The port of the record target that asked for it. */
  port: string;
  /** The population that was recorded. */
  target: string;
  /** What was measured. Defaults to `V_m`. */
  observable: Observable;
  /** Sample or event times in ms of simulated time. */
  times: number[];
  /** The measured values, one a time, in `unit`. Empty for spikes. */
  values: number[];
  /** The neuron behind each time, as the simulator's id within the target. */
  senders: number[];
  /** Unit of the values, such as `mV`. May be unset. */
  unit: string | null;
  /** Name of the model variable, where it is not the observable's usual one. May be unset. */
  recordable: string | null;
}

/** Observation plane and answer to a step or run: what a session measured. Raw simulation output, never a validated reproduction. */
export interface ObservationFrame {
  /** Wire version of the sender, `major.minor`. */
  ncp_version: string;
  /** Always `observation_frame`. */
  kind: "observation_frame";
  /** The session that was observed. */
  session_id: string;
  /** Number of the frame within its stream, rising. 0: unstamped. */
  seq: number;
  /** When it was made: s on the sender's clock. Defaults to 0. */
  t: number;
  /** Simulated time reached, in ms. */
  sim_time_ms: number;
  /** The measurements by port. */
  records: Record<string, Observation>;
  /** Always false: NCP data is never a calibrated posterior. A frame that says otherwise is rejected. */
  calibrated_posterior: false;
  /** Always true: NCP data is the output of a simulation. A frame that says otherwise is rejected. */
  is_simulation_output: true;
}

/** Control plane, commander to server: opens a session on a network. */
export interface OpenSession {
  /** Wire version of the sender, `major.minor`. The server compares it before anything else. */
  ncp_version: string;
  /** Always `open_session`. */
  kind: "open_session";
  /** The session's id, chosen by the sender; one segment of a key. */
  session_id: string;
  /** The network to simulate. */
  network: NetworkRef;
  /** What to record. Defaults to nothing. */
  record: RecordSpec;
  /** Where it will be stimulated. Defaults to nowhere. */
  stimulus: StimulusSpec;
  /** How to run it. Defaults to the defaults of SimConfig. */
  sim: SimConfig;
  /** Entities behind the ports. Defaults to none. */
  bindings: EntityBinding[];
  /** Contract hash of the sender, 16 lower-case hex digits. Advisory; may be unset, and then stays so. */
  contract_hash: string | null;
}

/** Everything that a session records. */
export interface RecordSpec {
  /** The targets, in no particular order; their ports are distinct. */
  targets: RecordTarget[];
}

/** One thing to record. */
export interface RecordTarget {
  /** Name under which the observation comes back, the key in `ObservationFrame.records`. */
  port: string;
  /** Population to record from. */
  target: string;
  /** What to measure. Defaults to `V_m`. */
  observable: Observable;
  /** Neurons to record, as the simulator's ids within the target. Empty: all. */
  ids: number[];
  /** Sampling interval in ms of simulated time. Defaults to 1. */
  cadence_ms: number;
  /** Names of model variables to record besides the observable, such as `g_ex`. */
  recordables: string[];
}

/** Control plane, commander to server: runs a session for a given time and returns what was recorded. */
export interface RunRequest {
  /** Wire version of the sender, `major.minor`. */
  ncp_version: string;
  /** Always `run_request`. */
  kind: "run_request";
  /** The session to run. */
  session_id: string;
  /** How long, in ms of simulated time. */
  duration_ms: number;
  /** Stimulus to apply before the run. May be unset. */
  stimulus: StimulusFrameInsideRequest | null;
}

/** Bounds that the plant enforces on every command, whoever sent it. */
export interface SafetyLimits {
  /** Largest speed in m/s, as a Euclidean norm. Unset or 0: no limit. */
  max_speed_mps: number | null;
  /** Largest tilt in rad. Advisory: NCP does not enforce it. May be unset. */
  max_tilt_rad: number | null;
  /** Radius in m of the ball about the origin of the frame that the plant must not leave. Unset or 0: no fence. */
  geofence_radius_m: number | null;
  /** Age in ms on the plant's clock beyond which a sensor reading counts as stale. Defaults to 500. */
  command_timeout_ms: number;
}

/** Perception plane, body to commander: what the sensors read. */
export interface SensorFrame {
  /** Wire version of the sender, `major.minor`. */
  ncp_version: string;
  /** Always `sensor_frame`. */
  kind: "sensor_frame";
  /** Number of the frame within its named stream, rising. Commands echo it; join on it, never on arrival time. 0: unstamped. */
  seq: number;
  /** When it was measured: s on the sender's clock. Defaults to 0. */
  t: number;
  /** The coordinate frame that the channels are given in. Defaults to `world`. */
  frame_id: string;
  /** The readings by channel name. */
  channels: Record<string, ChannelValue>;
}

/** Control plane, server to commander: the answer to CloseSession. */
export interface SessionClosed {
  /** Wire version of the server, `major.minor`. */
  ncp_version: string;
  /** Always `session_closed`. */
  kind: "session_closed";
  /** The id of the request. */
  session_id: string;
  /** False: there was no such session. Defaults to true. */
  ok: boolean;
}

/** Control plane, server to commander: the answer to OpenSession. */
export interface SessionOpened {
  /** Wire version of the server, `major.minor`. */
  ncp_version: string;
  /** Always `session_opened`. */
  kind: "session_opened";
  /** The id of the request. */
  session_id: string;
  /** Whether the session is open. False: nothing was opened, and `error` says why. Defaults to true. */
  ok: boolean;
  /** The simulator that serves the session. Defaults to `mock`. */
  backend: string;
  /** Number of neurons by population name, as resolved by the server. */
  resolved: Record<string, number>;
  /** What produces the session's data. May be unset. */
  provenance: SimProvenance | null;
  /** Why the session was refused. May be unset. */
  error: string | null;
  /** Contract hash of the server, 16 lower-case hex digits. Advisory; may be unset, and then stays so. */
  contract_hash: string | null;
}

/** How the simulation is to be run. */
export interface SimConfig {
  /** Integration step in ms of simulated time. Defaults to 0.1. */
  dt_ms: number;
  /** How far one step advances, in ms of simulated time, unless the step says otherwise. Defaults to 10. */
  chunk_ms: number;
  /** Seed of the random number generators. May be unset: then the server chooses and reports it in the provenance. */
  seed: number | null;
  /** Chunk by chunk or in one go. Defaults to `stream`. */
  mode: SimMode;
  /** Length of a batch run in ms of simulated time. May be unset. */
  duration_ms: number | null;
}

/** What produced the data of a session. It says what the data is, and what it is not. */
export interface SimProvenance {
  /** The network that was resolved, in the server's words. */
  network_ref: string;
  /** Simulator and its version, as the server names them. */
  backend: string;
  /** The seed in effect. May be unset. */
  seed: number | null;
  /** Always false: NCP data is never a calibrated posterior. A frame that says otherwise is rejected. */
  calibrated_posterior: false;
  /** Always true: NCP data is the output of a simulation. A frame that says otherwise is rejected. */
  is_simulation_output: true;
  /** Whether the results are advice only and must not be acted on unseen. Defaults to true. */
  advisory_only: boolean;
  /** Remark for people. May be unset. */
  note: string | null;
}

/** Control plane, commander to server: advances a session and returns what was recorded. */
export interface StepRequest {
  /** Wire version of the sender, `major.minor`. */
  ncp_version: string;
  /** Always `step_request`. */
  kind: "step_request";
  /** The session to advance. */
  session_id: string;
  /** How far, in ms of simulated time. May be unset: then `SimConfig.chunk_ms`. */
  advance_ms: number | null;
  /** Stimulus to apply before the step. May be unset. */
  stimulus: StimulusFrameInsideRequest | null;
}

/** Values for the stimulus ports of a session, on its own or inside a request. */
export interface StimulusFrame {
  /** Wire version of the sender, `major.minor`. Inside a request it may be left out. */
  ncp_version: string;
  /** Always `stimulus_frame`. Inside a request it may be left out. */
  kind: "stimulus_frame";
  /** The session that it is for. Inside a request it may be left out. */
  session_id: string;
  /** When it was made: s on the sender's clock. Defaults to 0. */
  t: number;
  /** The values by port, each in the unit of its stimulus kind. */
  values: Record<string, ChannelValue>;
}

/** Values for the stimulus ports of a session, on its own or inside a request. Inside a request ncp_version, kind, session_id may be left out. */
export interface StimulusFrameInsideRequest {
  /** Wire version of the sender, `major.minor`. Inside a request it may be left out. */
  ncp_version: string;
  /** Always `stimulus_frame`. Inside a request it may be left out. */
  kind: "stimulus_frame";
  /** The session that it is for. Inside a request it may be left out. */
  session_id: string;
  /** When it was made: s on the sender's clock. Defaults to 0. */
  t: number;
  /** The values by port, each in the unit of its stimulus kind. */
  values: Record<string, ChannelValue>;
}

/** Every place where a session can be stimulated. */
export interface StimulusSpec {
  /** The targets, in no particular order; their ports are distinct. */
  targets: StimulusTarget[];
}

/** One place where a session can be stimulated. */
export interface StimulusTarget {
  /** Name by which stimulus frames address it, the key in `StimulusFrame.values`. */
  port: string;
  /** Population to stimulate. */
  target: string;
  /** How the values act. Defaults to `current_pA`. */
  kind: StimulusKind;
  /** Neurons to stimulate, as the simulator's ids within the target. Empty: all. */
  ids: number[];
  /** Parameters of the stimulation device by name, in the simulator's units. */
  params: Record<string, number>;
}

/** What a program gives for {@link ChannelValue}. */
export interface ChannelValueInput {
  /** The components, in the channel's order; a scalar has one. Unit: see `unit`. */
  readonly data?: ArrayLike<number> | undefined;
  /** The unit of every component, such as `m`, `m/s` or `mV`. May be unset: then the unit is the one that was agreed for the channel. */
  readonly unit?: string | null | undefined;
}

/** What a program gives for {@link CloseSession}. */
export interface CloseSessionInput {
  /** Wire version of the sender, `major.minor`. */
  readonly ncp_version?: string | undefined;
  /** Always `close_session`. */
  readonly kind?: "close_session" | undefined;
  /** The session to end. */
  readonly session_id: string;
}

/** What a program gives for {@link EntityBinding}. */
export interface EntityBindingInput {
  /** The entity. */
  readonly entity?: EntityRefInput | undefined;
  /** Name of a record or stimulus port of the same request. */
  readonly port?: string | undefined;
  /** Which way data flows through the port: `stimulus` into the simulation, `record` out of it. Defaults to `stimulus`. */
  readonly direction?: string | undefined;
}

/** What a program gives for {@link EntityRef}. */
export interface EntityRefInput {
  /** Slash-separated path of the entity, such as `/world/uav3/imu`. Defaults to the empty string. */
  readonly path?: string | undefined;
  /** The part that it plays. Defaults to `sensor`. */
  readonly role?: EntityRole | undefined;
  /** Free annotations. No unit, no meaning to the protocol. */
  readonly meta?: Readonly<Record<string, string>> | undefined;
}

/** What a program gives for {@link NetworkRef}. */
export interface NetworkRefInput {
  /** How `ref` is to be read. Defaults to `builtin`. */
  readonly kind?: NetworkRefKind | undefined;
  /** The reference: a handle, a name, a model identifier or a description. */
  readonly ref?: string | undefined;
  /** Name of the neuron model, where the reference leaves it open. May be unset. */
  readonly model_name?: string | null | undefined;
  /** Number of neurons by population name. */
  readonly population_sizes?: Readonly<Record<string, number>> | undefined;
  /** Model parameters by name, in the simulator's units. */
  readonly params?: Readonly<Record<string, number>> | undefined;
}

/** What a program gives for {@link OpenSession}. */
export interface OpenSessionInput {
  /** Wire version of the sender, `major.minor`. The server compares it before anything else. */
  readonly ncp_version?: string | undefined;
  /** Always `open_session`. */
  readonly kind?: "open_session" | undefined;
  /** The session's id, chosen by the sender; one segment of a key. */
  readonly session_id: string;
  /** The network to simulate. */
  readonly network: NetworkRefInput;
  /** What to record. Defaults to nothing. */
  readonly record?: RecordSpecInput | undefined;
  /** Where it will be stimulated. Defaults to nowhere. */
  readonly stimulus?: StimulusSpecInput | undefined;
  /** How to run it. Defaults to the defaults of SimConfig. */
  readonly sim?: SimConfigInput | undefined;
  /** Entities behind the ports. Defaults to none. */
  readonly bindings?: readonly EntityBindingInput[] | undefined;
  /** Contract hash of the sender, 16 lower-case hex digits. Advisory; may be unset, and then stays so. */
  readonly contract_hash?: string | null | undefined;
}

/** What a program gives for {@link RecordSpec}. */
export interface RecordSpecInput {
  /** The targets, in no particular order; their ports are distinct. */
  readonly targets?: readonly RecordTargetInput[] | undefined;
}

/** What a program gives for {@link RecordTarget}. */
export interface RecordTargetInput {
  /** Name under which the observation comes back, the key in `ObservationFrame.records`. */
  readonly port?: string | undefined;
  /** Population to record from. */
  readonly target?: string | undefined;
  /** What to measure. Defaults to `V_m`. */
  readonly observable?: Observable | undefined;
  /** Neurons to record, as the simulator's ids within the target. Empty: all. */
  readonly ids?: ArrayLike<number> | undefined;
  /** Sampling interval in ms of simulated time. Defaults to 1. */
  readonly cadence_ms?: number | undefined;
  /** Names of model variables to record besides the observable, such as `g_ex`. */
  readonly recordables?: readonly string[] | undefined;
}

/** What a program gives for {@link RunRequest}. */
export interface RunRequestInput {
  /** Wire version of the sender, `major.minor`. */
  readonly ncp_version?: string | undefined;
  /** Always `run_request`. */
  readonly kind?: "run_request" | undefined;
  /** The session to run. */
  readonly session_id: string;
  /** How long, in ms of simulated time. */
  readonly duration_ms: number;
  /** Stimulus to apply before the run. May be unset. */
  readonly stimulus?: StimulusFrameInsideRequestInput | null | undefined;
}

/** What a program gives for {@link SimConfig}. */
export interface SimConfigInput {
  /** Integration step in ms of simulated time. Defaults to 0.1. */
  readonly dt_ms?: number | undefined;
  /** How far one step advances, in ms of simulated time, unless the step says otherwise. Defaults to 10. */
  readonly chunk_ms?: number | undefined;
  /** Seed of the random number generators. May be unset: then the server chooses and reports it in the provenance. */
  readonly seed?: number | null | undefined;
  /** Chunk by chunk or in one go. Defaults to `stream`. */
  readonly mode?: SimMode | undefined;
  /** Length of a batch run in ms of simulated time. May be unset. */
  readonly duration_ms?: number | null | undefined;
}

/** What a program gives for {@link StepRequest}. */
export interface StepRequestInput {
  /** Wire version of the sender, `major.minor`. */
  readonly ncp_version?: string | undefined;
  /** Always `step_request`. */
  readonly kind?: "step_request" | undefined;
  /** The session to advance. */
  readonly session_id: string;
  /** How far, in ms of simulated time. May be unset: then `SimConfig.chunk_ms`. */
  readonly advance_ms?: number | null | undefined;
  /** Stimulus to apply before the step. May be unset. */
  readonly stimulus?: StimulusFrameInsideRequestInput | null | undefined;
}

/** What a program gives for {@link StimulusFrameInsideRequest}. */
export interface StimulusFrameInsideRequestInput {
  /** Wire version of the sender, `major.minor`. Inside a request it may be left out. */
  readonly ncp_version?: string | undefined;
  /** Always `stimulus_frame`. Inside a request it may be left out. */
  readonly kind?: "stimulus_frame" | undefined;
  /** The session that it is for. Inside a request it may be left out. */
  readonly session_id?: string | undefined;
  /** When it was made: s on the sender's clock. Defaults to 0. */
  readonly t?: number | undefined;
  /** The values by port, each in the unit of its stimulus kind. */
  readonly values?: Readonly<Record<string, ChannelValueInput>> | undefined;
}

/** What a program gives for {@link StimulusSpec}. */
export interface StimulusSpecInput {
  /** The targets, in no particular order; their ports are distinct. */
  readonly targets?: readonly StimulusTargetInput[] | undefined;
}

/** What a program gives for {@link StimulusTarget}. */
export interface StimulusTargetInput {
  /** Name by which stimulus frames address it, the key in `StimulusFrame.values`. */
  readonly port?: string | undefined;
  /** Population to stimulate. */
  readonly target?: string | undefined;
  /** How the values act. Defaults to `current_pA`. */
  readonly kind?: StimulusKind | undefined;
  /** Neurons to stimulate, as the simulator's ids within the target. Empty: all. */
  readonly ids?: ArrayLike<number> | undefined;
  /** Parameters of the stimulation device by name, in the simulator's units. */
  readonly params?: Readonly<Record<string, number>> | undefined;
}

/** The messages by kind. */
export interface Messages {
  bulk_observation: BulkObservation;
  capabilities: Capabilities;
  close_session: CloseSession;
  command_frame: CommandFrame;
  control_status: ControlStatus;
  error: ErrorFrame;
  link_status: LinkStatus;
  observation_frame: ObservationFrame;
  open_session: OpenSession;
  run_request: RunRequest;
  sensor_frame: SensorFrame;
  session_closed: SessionClosed;
  session_opened: SessionOpened;
  step_request: StepRequest;
  stimulus_frame: StimulusFrame;
}
