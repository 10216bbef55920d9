/**
 * The control plane over a WebSocket: one frame a WebSocket message, in both directions. [NCP-TRANS-001]
 *
 * The wire has no id by which a reply could be told from another's. Each request has exactly one reply
 * [NCP-SESS-020], but only the requests of one session are served in order [NCP-SESS-036], and an error
 * frame need not say which session it concerns. So a connection carries one request at a time; what comes
 * back while it waits is its reply. Further requests wait in the order in which they were made.
 *
 * That holds only as long as no reply is outstanding that nobody waits for. So whenever a request is given
 * up, or something comes back that nobody asked for, the connection is dropped and the next request gets
 * a new one. A request that was sent is never sent again: it may have been carried out.
 *
 * @module
 */

import { ConfigError, NcpConnectionError, NcpTimeoutError } from "../errors.js";
import type { RequestOptions, Send } from "../session-client.js";
import { NeuroSimClient } from "./neuro-sim-client.js";

/** What is needed of a WebSocket: a browser's, the one of Node 22, and that of the package `ws` have it. */
export interface WebSocketLike {
  binaryType: string;
  onopen: ((event: any) => void) | null;
  onmessage: ((event: any) => void) | null;
  onerror: ((event: any) => void) | null;
  onclose: ((event: any) => void) | null;
  send(data: string): void;
  close(code?: number): void;
  /** Ends it without a closing handshake, where the class can. */
  terminate?(): void;
}

/** A class of WebSockets. */
export type WebSocketClass = new (url: string, protocols?: string | string[]) => WebSocketLike;

/** How the connection is kept. Times are in ms. */
export interface WebSocketOptions {
  /** The class of WebSockets. Defaults to the runtime's own, which browsers and Node 22 have. */
  readonly WebSocket?: WebSocketClass | undefined;
  /** Subprotocols to offer. */
  readonly protocols?: string | string[] | undefined;
  /** The time of a request from its call to its reply, unless the request says otherwise; `Infinity`: no limit. Defaults to 30,000. */
  readonly timeoutMs?: number | undefined;
  /** How long one attempt to connect may take. Defaults to 10,000. */
  readonly connectTimeoutMs?: number | undefined;
  /** The wait after the first failure. It doubles with each further one, and varies by half. Defaults to 200. */
  readonly retryMs?: number | undefined;
  /** The longest wait between two attempts. Defaults to 10,000. */
  readonly maxRetryMs?: number | undefined;
  /** After how many failures in a row the waiting requests are given up. Defaults to `Infinity`: only their time ends them. */
  readonly maxAttempts?: number | undefined;
}

/** `idle` is not connected, because no request waits; `waiting` is the time before another attempt. */
export type WebSocketState = "idle" | "connecting" | "open" | "waiting" | "closed";

/**
 * A client with its own WebSocket. It connects when the first request is made, connects again when a
 * request finds the connection lost, and lives until {@link WebSocketNeuroSim.disconnect}.
 */
export class WebSocketNeuroSim extends NeuroSimClient {
  /** The connection. Its `send` also serves a {@link NeuroSimClient} of its own. */
  readonly transport: WebSocketTransport;

  /** @param url - such as `wss://host/ncp` */
  constructor(url: string, options: WebSocketOptions & { readonly strict?: boolean | undefined } = {}) {
    const transport = new WebSocketTransport(url, options);
    super(transport.send, { strict: options.strict, onMisfit: () => transport.restart() });
    this.transport = transport;
  }

  /** Closes the connection for good. Sessions stay as they are: close them first. */
  disconnect(): void {
    this.transport.close();
  }
}

/** Carries requests over a WebSocket, one at a time. */
export class WebSocketTransport {
  readonly #url: string;
  readonly #options: Settings;
  readonly #queue: Pending[] = [];
  #inFlight: Pending | undefined;
  #socket: WebSocketLike | undefined;
  #open = false;
  #closed = false;
  /** Failures since the last reply. */
  #failures = 0;
  #lastFailure: unknown;
  /** The earliest time of the next attempt, ms on the runtime's monotonic clock. */
  #notBefore = 0;
  #retryTimer: Timer | undefined;
  #connectTimer: Timer | undefined;

  /** @throws {@link ConfigError} when the URL is no WebSocket's, a time is not positive, or there is no class of WebSockets */
  constructor(url: string, options: WebSocketOptions = {}) {
    this.#url = checkedUrl(url);
    const WebSocket = options.WebSocket ?? (globalThis.WebSocket as WebSocketClass | undefined);
    if (WebSocket === undefined) {
      throw new ConfigError("this runtime has no WebSocket: give one as the option WebSocket, such as that of `ws`");
    }
    this.#options = {
      WebSocket,
      protocols: options.protocols,
      timeoutMs: positive("timeoutMs", options.timeoutMs ?? 30_000),
      connectTimeoutMs: positive("connectTimeoutMs", options.connectTimeoutMs ?? 10_000),
      retryMs: positive("retryMs", options.retryMs ?? 200),
      maxRetryMs: positive("maxRetryMs", options.maxRetryMs ?? 10_000),
      maxAttempts: positive("maxAttempts", options.maxAttempts ?? Infinity),
    };
  }

  /** How it stands with the connection. */
  get state(): WebSocketState {
    if (this.#closed) return "closed";
    if (this.#open) return "open";
    if (this.#socket !== undefined) return "connecting";
    return this.#retryTimer === undefined ? "idle" : "waiting";
  }

  /**
   * Sends a request and resolves with its reply, unread. It can be handed on without its object.
   *
   * Rejects with {@link NcpTimeoutError}, with {@link NcpConnectionError}, or with the reason of the signal.
   */
  readonly send: Send = (request: string, options: RequestOptions = {}): Promise<string | Uint8Array> =>
    new Promise((resolve, reject) => {
      const { signal } = options;
      const timeoutMs = positive("timeoutMs", options.timeoutMs ?? this.#options.timeoutMs);
      if (signal?.aborted) throw signal.reason;
      if (this.#closed) throw new NcpConnectionError("the connection was closed by this side", false);

      const pending: Pending = {
        text: request,
        settle: (outcome) => {
          stop(timer);
          signal?.removeEventListener("abort", onAbort);
          if ("reply" in outcome) resolve(outcome.reply);
          else reject(outcome.error);
        },
      };
      const onAbort = (): void => this.#giveUp(pending, signal?.reason);
      const timer = after(timeoutMs, () => {
        const sent = pending === this.#inFlight;
        const cause = sent ? undefined : this.#lastFailure;
        this.#giveUp(pending, new NcpTimeoutError(`there was no reply within ${timeoutMs} ms`, sent, { cause }));
      });
      signal?.addEventListener("abort", onAbort);
      this.#queue.push(pending);
      this.#advance();
    });

  /**
   * Drops the connection, because what comes over it cannot be matched any more. The request in flight is
   * rejected; those that wait go over a new connection.
   */
  restart(): void {
    if (this.#socket !== undefined) this.#fail("the connection was given up: a reply did not fit its request");
  }

  /** Closes the connection for good and rejects all requests. */
  close(): void {
    if (this.#closed) return;
    this.#closed = true;
    this.#rest();
    this.#drop("close");
    const [inFlight, waiting] = [this.#inFlight, this.#queue.splice(0)];
    this.#inFlight = undefined;
    inFlight?.settle({ error: new NcpConnectionError("the connection was closed by this side", true) });
    for (const pending of waiting) {
      pending.settle({ error: new NcpConnectionError("the connection was closed by this side", false) });
    }
  }

  /** Does what can be done next: send, connect, wait for the next attempt, or rest. */
  #advance(): void {
    if (this.#closed || this.#inFlight !== undefined) return;
    const [next] = this.#queue;
    if (next === undefined) return this.#rest();
    if (this.#open) {
      this.#queue.shift();
      this.#inFlight = next;
      try {
        this.#socket?.send(next.text);
      } catch (error) {
        this.#fail("the request could not be sent", error);
      }
    } else if (this.#socket === undefined && this.#retryTimer === undefined) {
      const wait = this.#notBefore - performance.now();
      if (wait <= 0) return this.#connect();
      this.#retryTimer = after(wait, () => {
        this.#retryTimer = undefined;
        this.#connect();
      });
    }
  }

  #connect(): void {
    let socket: WebSocketLike;
    try {
      socket = new this.#options.WebSocket(this.#url, this.#options.protocols);
    } catch (error) {
      return this.#fail("the connection could not be made", error);
    }
    this.#socket = socket;
    const { connectTimeoutMs } = this.#options;
    this.#connectTimer = after(connectTimeoutMs, () =>
      this.#fail(`there was no connection within ${connectTimeoutMs} ms`),
    );
    socket.binaryType = "arraybuffer";
    let trouble: unknown;
    socket.onopen = (): void => {
      stop(this.#connectTimer);
      this.#open = true;
      this.#advance();
    };
    socket.onmessage = (event: { data: unknown }): void => this.#receive(event.data);
    // What goes wrong is told first by an error without consequence, and then by the close.
    socket.onerror = (event: { error?: unknown }): void => void (trouble = event.error);
    socket.onclose = (event: { code: number }): void =>
      this.#fail(
        this.#open ? `the connection was lost (${event.code})` : `the connection failed (${event.code})`,
        trouble,
      );
  }

  #receive(data: unknown): void {
    const reply = typeof data === "string" ? data : data instanceof ArrayBuffer ? new Uint8Array(data) : undefined;
    const pending = this.#inFlight;
    if (pending === undefined || reply === undefined) {
      return this.#fail("something came that was no reply"); // The next reply could not be told from it.
    }
    this.#inFlight = undefined;
    this.#failures = 0;
    this.#lastFailure = undefined;
    pending.settle({ reply });
    this.#advance();
  }

  /** Ends a request from this side. */
  #giveUp(pending: Pending, error: unknown): void {
    if (pending === this.#inFlight) {
      this.#inFlight = undefined;
      this.#drop(); // Its reply may still come.
    } else {
      const place = this.#queue.indexOf(pending);
      if (place >= 0) this.#queue.splice(place, 1);
    }
    pending.settle({ error });
    this.#advance();
  }

  /** The connection is of no more use: drops it, and tries another if a request waits. */
  #fail(what: string, cause?: unknown): void {
    this.#drop();
    this.#failures += 1;
    const failure = new NcpConnectionError(what, false, { cause });
    this.#lastFailure = failure;
    const { retryMs, maxRetryMs, maxAttempts } = this.#options;
    const wait = Math.min(LONGEST, maxRetryMs, retryMs * 2 ** Math.min(this.#failures - 1, 50));
    this.#notBefore = performance.now() + wait * (0.5 + Math.random() / 2);

    const inFlight = this.#inFlight;
    this.#inFlight = undefined;
    inFlight?.settle({ error: new NcpConnectionError(`${what}; the request may have been carried out`, true, { cause }) });
    if (this.#failures >= maxAttempts) {
      this.#failures = 0;
      for (const pending of this.#queue.splice(0)) pending.settle({ error: failure });
    }
    this.#advance();
  }

  /** Stops trying to connect; an open connection stays. */
  #rest(): void {
    stop(this.#retryTimer);
    this.#retryTimer = undefined;
    if (!this.#open) this.#drop();
  }

  #drop(how: "terminate" | "close" = "terminate"): void {
    stop(this.#connectTimer);
    const socket = this.#socket;
    this.#socket = undefined;
    this.#open = false;
    if (socket === undefined) return;
    socket.onopen = socket.onmessage = socket.onclose = null;
    socket.onerror = (): void => {}; // Node would end the program for an error that nobody hears.
    if (how === "terminate" && socket.terminate !== undefined) socket.terminate();
    else socket.close(1000);
  }
}

/** The options, with their defaults. */
type Settings = {
  readonly [Name in keyof WebSocketOptions]-?: Name extends "protocols"
    ? WebSocketOptions[Name]
    : Exclude<WebSocketOptions[Name], undefined>;
};

interface Pending {
  readonly text: string;
  settle(outcome: { readonly reply: string | Uint8Array } | { readonly error: unknown }): void;
}

type Timer = ReturnType<typeof setTimeout>;

/** Timers cannot wait longer, ms. */
const LONGEST = 2 ** 31 - 1;

function after(ms: number, action: () => void): Timer | undefined {
  return ms > LONGEST ? undefined : setTimeout(action, Math.ceil(ms));
}

function stop(timer: Timer | undefined): void {
  if (timer !== undefined) clearTimeout(timer);
}

function positive(name: string, value: number): number {
  if (!(value > 0)) throw new ConfigError(`${name} is ${value}`);
  return value;
}

function checkedUrl(url: string): string {
  let protocol: string;
  try {
    ({ protocol } = new URL(url));
  } catch {
    throw new ConfigError(`${JSON.stringify(String(url))} is not a URL`);
  }
  if (protocol !== "ws:" && protocol !== "wss:") throw new ConfigError(`${protocol} is not the scheme of a WebSocket`);
  return url;
}
