/**
 * The messages as plain JSON values, mapped from their declarations: what a client takes and gives.
 *
 * A message is complete: a field that was absent has its default, an unset optional one is `null`.
 * A type `…Input` is what a program gives to have a request made of it: what it leaves out gets its default.
 *
 * @module
 */

import type * as messages from "./messages.js";
import type { Input, Kind } from "./messages.js";

export type {
  ChannelKind,
  EntityRole,
  Mode,
  NetworkRefKind,
  Observable,
  Role,
  SimMode,
  StimulusKind,
} from "./messages.js";

/** The plain JSON value of a message or of a field: an object for a map, an array for a typed array. */
export type Plain<T> = T extends string | number | boolean | null
  ? T
  : T extends Float64Array
    ? number[]
    : T extends Map<string, infer V>
      ? Record<string, Plain<V>>
      : T extends (infer I)[]
        ? Plain<I>[]
        : { [K in keyof T]: Plain<T[K]> };

/** The messages by kind. */
export type Messages = { [K in Kind]: Plain<messages.Messages[K]> };

/** A sample of one channel. */
export type ChannelValue = Plain<messages.ChannelValue>;
/** A thing of the simulated or the physical world, by its path. */
export type EntityRef = Plain<messages.EntityRef>;
/** Ties an entity to a port of the session. */
export type EntityBinding = Plain<messages.EntityBinding>;
/** Which network a session runs. */
export type NetworkRef = Plain<messages.NetworkRef>;
/** What to record. */
export type RecordTarget = Plain<messages.RecordTarget>;
/** What a session records. */
export type RecordSpec = Plain<messages.RecordSpec>;
/** Where a stimulus goes. */
export type StimulusTarget = Plain<messages.StimulusTarget>;
/** What a session can be driven by. */
export type StimulusSpec = Plain<messages.StimulusSpec>;
/** How the simulation runs. */
export type SimConfig = Plain<messages.SimConfig>;
/** Where the numbers of a session come from. */
export type SimProvenance = Plain<messages.SimProvenance>;
/** The recorded samples of one port. */
export type Observation = Plain<messages.Observation>;
/** A channel that a peer offers or takes. */
export type ChannelSpec = Plain<messages.ChannelSpec>;
/** What the governor enforces. */
export type SafetyLimits = Plain<messages.SafetyLimits>;
/** Control RPC: open a session. */
export type OpenSession = Plain<messages.OpenSession>;
/** The reply to `open_session`. */
export type SessionOpened = Plain<messages.SessionOpened>;
/** Values for the stimulus ports. */
export type StimulusFrame = Plain<messages.StimulusFrame>;
/** Control RPC: advance a session. */
export type StepRequest = Plain<messages.StepRequest>;
/** Control RPC: run a session for a stated time. */
export type RunRequest = Plain<messages.RunRequest>;
/** The reply to `step_request` and `run_request`, and the frame of the observation plane. */
export type ObservationFrame = Plain<messages.ObservationFrame>;
/** Control RPC: close a session. */
export type CloseSession = Plain<messages.CloseSession>;
/** The reply to `close_session`. */
export type SessionClosed = Plain<messages.SessionClosed>;
/** What a controller or a plant offers, and within which limits. */
export type Capabilities = Plain<messages.Capabilities>;
/** Perception: what the body senses. */
export type SensorFrame = Plain<messages.SensorFrame>;
/** Action: what the body is to do. */
export type CommandFrame = Plain<messages.CommandFrame>;
/** Observation: how the control loop is doing. */
export type ControlStatus = Plain<messages.ControlStatus>;
/** Observation: how a stream arrives. */
export type LinkStatus = Plain<messages.LinkStatus>;
/** Observation: the samples of one port as a BulkBlock. */
export type BulkObservation = Plain<messages.BulkObservation>;
/** The reply to a request that cannot be served. */
export type ErrorFrame = Plain<messages.ErrorFrame>;

/** What a program gives for {@link OpenSession}. */
export type OpenSessionInput = Input<"open_session">;
/** What a program gives for {@link StepRequest}. */
export type StepRequestInput = Input<"step_request">;
/** What a program gives for {@link RunRequest}. */
export type RunRequestInput = Input<"run_request">;
/** What a program gives for {@link CloseSession}. */
export type CloseSessionInput = Input<"close_session">;
