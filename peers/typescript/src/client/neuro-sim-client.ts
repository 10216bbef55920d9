/**
 * The published client: sessions of a simulation service, with requests and replies as plain JSON values.
 *
 * @module
 */

import { DecodeError, NcpScientificBoundaryError, NcpServerError, ReplyError, VersionError } from "../errors.js";
import type * as wire from "../wire.js";
import type { Kind, Messages } from "../messages.js";
import { SessionClient, type RequestOptions, type Send } from "../session-client.js";
import { plain } from "./plain.js";

/** How a client is set up. */
export interface NeuroSimClientOptions {
  /** Whether the strict profile holds, by agreement with the server. */
  readonly strict?: boolean | undefined;
  /**
   * Told when what came back was not the reply to the request. Whoever matches replies by their order has
   * lost count then, and begins a new connection.
   */
  readonly onMisfit?: ((error: ReplyError) => void) | undefined;
}

/**
 * Opens, steps, runs and closes sessions, over anything that sends a request and hands back its reply.
 *
 * A method that resolves has a reply of the right kind, session and version, which reports no failure and
 * keeps the scientific boundary. It rejects with
 *
 * - {@link EncodeError} when no request can be made of what was given; nothing was sent,
 * - {@link NcpServerError} when the server reports a failure: an error frame, or `ok` false,
 * - {@link NcpVersionError} when the reply's version is not compatible,
 * - {@link NcpScientificBoundaryError} when the reply claims to be more than the output of a model,
 * - {@link ReplyError} when what came back does not answer the request,
 * - whatever `send` rejects with.
 */
export class NeuroSimClient {
  readonly #sessions: SessionClient;
  readonly #onMisfit: ((error: ReplyError) => void) | undefined;

  /** @param send - sends the text of a request and resolves with what came back, as it came */
  constructor(send: Send, options: NeuroSimClientOptions = {}) {
    this.#sessions = new SessionClient(send, options.strict);
    this.#onMisfit = options.onMisfit;
  }

  /** Opens a session. `ncp_version` and `contract_hash` are this library's unless they are given. */
  open(request: wire.OpenSessionInput, options?: RequestOptions): Promise<wire.SessionOpened> {
    return this.#outcome(this.#sessions.open(request, options));
  }

  /** Advances a session by `advance_ms`, or by its `chunk_ms`. */
  step(request: wire.StepRequestInput, options?: RequestOptions): Promise<wire.ObservationFrame> {
    return this.#outcome(this.#sessions.step(request, options));
  }

  /** Runs a session for `duration_ms`. */
  run(request: wire.RunRequestInput, options?: RequestOptions): Promise<wire.ObservationFrame> {
    return this.#outcome(this.#sessions.run(request, options));
  }

  /**
   * Closes a session that this client opened. One that it borrowed is left to its owner, without a
   * request. [NCP-SESS-040]
   *
   * @returns whether the session was this client's
   */
  close(sessionId: string, options?: RequestOptions): Promise<boolean> {
    return this.#checked(this.#sessions.close(sessionId, options));
  }

  async #outcome<K extends Kind>(reply: Promise<Messages[K] & { readonly kind: K }>): Promise<wire.Messages[K]> {
    return plain<K>(await this.#checked(reply));
  }

  async #checked<T>(outcome: Promise<T>): Promise<T> {
    try {
      return await outcome;
    } catch (error) {
      if (!(error instanceof ReplyError) || error instanceof NcpServerError) throw error;
      const { cause } = error;
      if (cause instanceof VersionError || (cause instanceof DecodeError && cause.code === "version")) {
        throw new VersionError(error.message, { cause });
      }
      if (cause instanceof DecodeError && cause.code === "provenance") {
        throw new NcpScientificBoundaryError(error.message, { cause });
      }
      this.#onMisfit?.(error);
      throw error;
    }
  }
}
