/**
 * The server's side of the control plane: from the bytes of a request to the text of its one reply (chapter 4.2).
 *
 * @module
 */

import { decode, kindOf } from "./decode.js";
import { create, encode } from "./encode.js";
import { SessionError } from "./errors.js";
import type {
  ChannelValue,
  CloseSession,
  Message,
  Observation,
  OpenSession,
  RunRequest,
  SimProvenance,
  StepRequest,
} from "./messages.js";
import { isRequestKind, type Request, type RequestKind } from "./requests.js";
import { checkVersion } from "./version.js";

/** What runs networks. */
export interface Backend {
  /** What a `session_opened` names. */
  readonly name: string;

  /**
   * Builds what a session asks for.
   *
   * @throws {@link SessionError} when it cannot
   */
  open(request: OpenSession): Simulation;
}

/** One open simulation. */
export interface Simulation {
  /** Neurons a population, as built. */
  readonly resolved: ReadonlyMap<string, number>;
  /** Where the numbers come from. [NCP-SESS-039] */
  readonly provenance: Partial<SimProvenance>;
  /** The simulation time that was run, ms. [NCP-SESS-033] */
  readonly timeMs: number;

  /**
   * Runs on. What is refused has changed nothing.
   *
   * @param forMs - simulation time, ms; finite and not negative
   * @param stimulus - values by port, which act from the first step and stay
   * @returns the observations since the last call: one for each port that the session records [NCP-SESS-038]
   * @throws {@link SessionError} when it is refused
   */
  advance(forMs: number, stimulus: ReadonlyMap<string, ChannelValue>): Map<string, Observation>;
}

/** How a service is set up beyond its backend. */
export interface SessionServiceOptions {
  /** Whether the strict profile holds, by agreement with the commander. */
  readonly strict?: boolean | undefined;
  /** The server's monotonic clock, s. */
  readonly clock?: (() => number) | undefined;
}

interface Session {
  readonly simulation: Simulation;
  /** Simulation time of a step request that names none, ms. */
  readonly chunkMs: number;
  seq: number;
}

/** Serves the requests of all sessions, each to its end before the next. [NCP-SESS-036] */
export class SessionService {
  readonly #backend: Backend;
  readonly #strict: boolean;
  readonly #clock: () => number;
  readonly #sessions = new Map<string, Session>(); // [NCP-SESS-035]

  constructor(backend: Backend, options: SessionServiceOptions = {}) {
    this.#backend = backend;
    this.#strict = options.strict ?? false;
    this.#clock = options.clock ?? ((): number => performance.now() / 1000);
  }

  /**
   * The text of the one reply to a request, whatever its bytes. [NCP-SESS-020]
   *
   * @param verb - the kind in the strict profile's control key at which the request came, if it came at one
   */
  handle(frame: string | Uint8Array, verb?: RequestKind): string {
    let session: string | null = null;
    try {
      const request = requestIn(frame);
      if (verb !== undefined && request.kind !== verb) {
        throw new SessionError(`${request.kind} does not belong at the key of ${verb}`); // [NCP-STRICT-007]
      }
      session = request.session_id;
      return encode(this.#reply(request, frame));
    } catch (error) {
      // Whatever failed, here or in the simulator, costs this request only. [NCP-SESS-021] [NCP-SESS-037]
      return encode(create("error", { error: reasonOf(error), session_id: session }));
    }
  }

  #reply(request: Request, frame: string | Uint8Array): Message {
    if (request.kind === "open_session") return this.#open(request, frame);
    if (this.#strict) decode(request.kind, frame, true); // [NCP-STRICT-009]
    if (request.kind === "close_session") return this.#close(request);
    return this.#advance(request);
  }

  #open(request: OpenSession, frame: string | Uint8Array): Message {
    const { session_id } = request;
    try {
      checkVersion(request.ncp_version, true); // [NCP-SESS-023] The contract hash is not judged. [NCP-SESS-025]
      if (this.#strict) decode("open_session", frame, true); // [NCP-STRICT-008]
      if (this.#sessions.has(session_id)) throw new SessionError("the session is already open"); // [NCP-SESS-030]
      const { chunk_ms: chunkMs } = request.sim;
      checkTime("chunk_ms", chunkMs);
      const simulation = this.#backend.open(request);
      const { resolved, provenance } = simulation;
      const opened = create("session_opened", {
        session_id,
        backend: this.#backend.name,
        resolved,
        provenance, // [NCP-SESS-039]
      });
      this.#sessions.set(session_id, { simulation, chunkMs, seq: 0 });
      return opened;
    } catch (error) {
      // [NCP-SESS-024]
      return create("session_opened", {
        session_id,
        ok: false,
        backend: this.#backend.name,
        error: reasonOf(error),
      });
    }
  }

  #advance(request: StepRequest | RunRequest): Message {
    const { session_id } = request;
    const session = this.#sessions.get(session_id);
    if (session === undefined) throw new SessionError("the session is not open"); // [NCP-SESS-026]
    // [NCP-SESS-031]
    const forMs = request.kind === "run_request" ? request.duration_ms : (request.advance_ms ?? session.chunkMs);
    checkTime(request.kind === "run_request" ? "duration_ms" : "advance_ms", forMs); // [NCP-SESS-032]
    const records = session.simulation.advance(forMs, request.stimulus?.values ?? new Map());
    // [NCP-SESS-027]
    return create("observation_frame", {
      session_id,
      seq: ++session.seq, // [NCP-SESS-034]
      t: this.#clock(),
      sim_time_ms: session.simulation.timeMs, // [NCP-SESS-033]
      records,
    });
  }

  #close({ session_id }: CloseSession): Message {
    // [NCP-SESS-028] [NCP-SESS-029]
    return create("session_closed", { session_id, ok: this.#sessions.delete(session_id) });
  }
}

function requestIn(frame: string | Uint8Array): Request {
  const kind = kindOf(frame);
  if (!isRequestKind(kind)) throw new SessionError(`${kind} is not a request`); // [NCP-SESS-022]
  return decode(kind, frame);
}

function checkTime(name: string, ms: number): void {
  if (!Number.isFinite(ms) || ms < 0) throw new SessionError(`${name} is ${ms}`);
}

/** Why, for people, in a form that can be sent. */
function reasonOf(error: unknown): string {
  const reason = error instanceof Error ? error.message : String(error);
  return reason.slice(0, REASON).replace(/\p{Surrogate}/gu, "\ufffd");
}

const REASON = 1_000;
