/**
 * The client's side of the control plane, over any transport that carries a request and its reply (chapter 4).
 *
 * @module
 */

import { create, encode } from "./encode.js";
import { NcpServerError } from "./errors.js";
import type { Input, ObservationFrame, SessionOpened } from "./messages.js";
import { checkReply } from "./reply.js";
import type { ReplyTo, Request } from "./requests.js";

/** What may be said of one request. A transport need not heed it. */
export interface RequestOptions {
  /** Ends the request when it is aborted. */
  readonly signal?: AbortSignal | undefined;
  /** How long the request may take, ms. */
  readonly timeoutMs?: number | undefined;
}

/** Sends the text of a request and answers with what came back. */
export type Send = (request: string, options?: RequestOptions) => Promise<string | Uint8Array>;

/** Opens, runs and closes sessions. Every method throws {@link ReplyError} when the reply is not one to go on with. */
export class SessionClient {
  readonly #send: Send;
  readonly #strict: boolean;
  /** The sessions that this client opened. Others are borrowed. */
  readonly #owned = new Set<string>();

  /** @param strict - whether the strict profile holds, by agreement with the server */
  constructor(send: Send, strict = false) {
    this.#send = send;
    this.#strict = strict;
  }

  async open(fields: Input<"open_session">, options?: RequestOptions): Promise<SessionOpened> {
    const opened = await this.#ask(create("open_session", fields), options);
    this.#owned.add(opened.session_id);
    return opened;
  }

  async step(fields: Input<"step_request">, options?: RequestOptions): Promise<ObservationFrame> {
    return this.#ask(create("step_request", fields), options);
  }

  async run(fields: Input<"run_request">, options?: RequestOptions): Promise<ObservationFrame> {
    return this.#ask(create("run_request", fields), options);
  }

  /**
   * Closes a session that this client opened, and leaves one that it borrowed to its owner. [NCP-SESS-040]
   *
   * @returns whether the session was this client's
   */
  async close(sessionId: string, options?: RequestOptions): Promise<boolean> {
    if (!this.#owned.has(sessionId)) return false;
    try {
      await this.#ask(create("close_session", { session_id: sessionId }), options);
    } catch (error) {
      // The server does not have it (any more). Should another client open it anew, it is that client's.
      if (error instanceof NcpServerError) this.#owned.delete(sessionId);
      throw error;
    }
    this.#owned.delete(sessionId);
    return true;
  }

  async #ask<R extends Request>(request: R, options?: RequestOptions): Promise<ReplyTo<R>> {
    return checkReply(request, await this.#send(encode(request), options), this.#strict);
  }
}
