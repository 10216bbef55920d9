import assert from "node:assert/strict";
import { getEventListeners, once } from "node:events";
import { createServer, type AddressInfo, type Socket } from "node:net";
import { test, type TestContext } from "node:test";
import {
  ConfigError,
  create,
  encode,
  NcpConnectionError,
  NcpServerError,
  NcpTimeoutError,
  NeuroSimClient,
  ReplyError,
  WebSocketNeuroSim,
  WebSocketTransport,
  type WebSocketClass,
  type WebSocketOptions,
} from "@ncp-conformance/peer";
import { WebSocket } from "ws";
import { answer, TestServer, type Behaviour } from "./web-socket-server.js";

const QUICK: WebSocketOptions = { WebSocket, timeoutMs: 5_000, retryMs: 5, maxRetryMs: 20 };
const NETWORK = { ref: "ncp.reference.rate", population_sizes: { pop: 1 } };

async function start(t: TestContext, options: WebSocketOptions = {}): Promise<[TestServer, WebSocketNeuroSim]> {
  const server = await TestServer.start();
  const client = new WebSocketNeuroSim(server.url, { ...QUICK, ...options });
  t.after(async () => {
    client.disconnect();
    await server.stop();
  });
  return [server, client];
}

/** A server that lets the first requests pass and does this with the next one. */
function after(passed: number, behaviour: Behaviour): Behaviour {
  let left = passed;
  return (...request) => (left-- === 0 ? behaviour(...request) : answer(...request));
}

const silent: Behaviour = () => {};

/** The error of a promise that must not be fulfilled. */
async function failure(promise: Promise<unknown>): Promise<unknown> {
  return promise.then(
    () => assert.fail("fulfilled"),
    (error: unknown) => error,
  );
}

async function until(condition: () => boolean): Promise<void> {
  for (const begin = performance.now(); !condition(); await new Promise(setImmediate)) {
    assert.ok(performance.now() - begin < 5_000, "it never came to that");
  }
}

function isLost(error: unknown, sent: boolean): void {
  assert.ok(error instanceof NcpConnectionError, String(error));
  assert.equal(error.sent, sent, error.message);
}

// --- requests and replies ------------------------------------------------------------------------

test("a session runs over one connection, which is made by the first request", async (t) => {
  const [server, client] = await start(t);
  assert.equal(client.transport.state, "idle");
  assert.equal(server.connections, 0);
  const opened = await client.open({ session_id: "s", network: NETWORK });
  assert.equal(client.transport.state, "open");
  assert.deepEqual(opened.resolved, { pop: 1 });
  for (let n = 1; n <= 20; n++) assert.equal((await client.step({ session_id: "s" })).sim_time_ms, 10 * n);
  assert.equal(await client.close("s"), true);
  assert.equal(server.connections, 1);
});

test("requests made at once are sent one after the other, in their order, and each gets its own reply", async (t) => {
  const [server, client] = await start(t);
  let unanswered = 0;
  server.behave = (request, socket) => {
    assert.equal(++unanswered, 1, "a request was sent before the reply to the one before it");
    setTimeout(() => {
      unanswered -= 1;
      socket.send(server.service.handle(request));
    }, 1);
  };
  await Promise.all(["a", "b"].map((session_id) => client.open({ session_id, network: NETWORK })));
  const runs = Array.from({ length: 20 }, (_, n) => ({ session_id: n % 3 === 0 ? "a" : "b", duration_ms: n + 1 }));
  const frames = await Promise.all(runs.map((run) => client.run(run)));
  const times = { a: 0, b: 0 };
  frames.forEach((frame, n) => {
    const { session_id, duration_ms } = runs[n]!;
    assert.equal(frame.session_id, session_id);
    assert.equal(frame.sim_time_ms, (times[session_id as "a" | "b"] += duration_ms));
  });
});

test("the transport hands text and bytes over unchanged", async (t) => {
  const [server, client] = await start(t);
  server.behave = (request, socket) => socket.send(request.startsWith("b") ? Buffer.from([0, 255, 7]) : `${request}!`);
  assert.equal(await client.transport.send(' { "a" : "\u00e9\u2028😀" }\n'), ' { "a" : "\u00e9\u2028😀" }\n!');
  assert.deepEqual(await client.transport.send("b"), Uint8Array.of(0, 255, 7));
});

test("a reply in bytes is read like one in text", async (t) => {
  const [server, client] = await start(t);
  server.behave = (request, socket) => socket.send(Buffer.from(server.service.handle(request)));
  await client.open({ session_id: "s", network: NETWORK });
  assert.equal((await client.run({ session_id: "s", duration_ms: 3 })).sim_time_ms, 3);
});

test("the transport's send serves a client of its own, without its object", async (t) => {
  const [, client] = await start(t);
  const { send } = client.transport;
  const other = new NeuroSimClient(send);
  await other.open({ session_id: "s", network: NETWORK });
  assert.equal(await client.close("s"), false);
  assert.equal(await other.close("s"), true);
});

test("a failure that the server reports leaves the connection as it is", async (t) => {
  const [server, client] = await start(t);
  assert.ok((await failure(client.step({ session_id: "s" }))) instanceof NcpServerError);
  await client.open({ session_id: "s", network: NETWORK });
  assert.equal(server.connections, 1);
});

// --- replies that are late, lost, double or another's --------------------------------------------

test("a request without a reply ends in time, and its late reply is nobody else's", async (t) => {
  const [server, client] = await start(t);
  await client.open({ session_id: "s", network: NETWORK });
  server.behave = after(0, (request, socket) => {
    const reply = server.service.handle(request);
    setTimeout(() => socket.send(reply), 60);
  });
  const late = failure(client.run({ session_id: "s", duration_ms: 1 }, { timeoutMs: 30 }));
  const next = client.run({ session_id: "s", duration_ms: 10 });
  const error = await late;
  assert.ok(error instanceof NcpTimeoutError);
  assert.equal(error.sent, true);
  assert.equal((await next).sim_time_ms, 11);
  assert.equal(server.connections, 2);
});

test("an aborted request rejects with the signal's reason, and its late reply is nobody else's", async (t) => {
  const [server, client] = await start(t);
  await client.open({ session_id: "s", network: NETWORK });
  const reason = new Error("enough");
  const abort = new AbortController();
  server.behave = after(0, (request, socket) => {
    const reply = server.service.handle(request);
    abort.abort(reason);
    setTimeout(() => socket.send(reply), 20);
  });
  assert.equal(await failure(client.run({ session_id: "s", duration_ms: 1 }, { signal: abort.signal })), reason);
  assert.equal((await client.run({ session_id: "s", duration_ms: 10 })).sim_time_ms, 11);
  assert.equal(server.connections, 2);
});

test("a request that is aborted while it waits is never sent, and costs the others nothing", async (t) => {
  const [server, client] = await start(t);
  await client.open({ session_id: "s", network: NETWORK });
  const abort = new AbortController();
  const options = { signal: abort.signal };
  const first = client.run({ session_id: "s", duration_ms: 1 });
  const second = failure(client.run({ session_id: "s", duration_ms: 100 }, options));
  const third = client.run({ session_id: "s", duration_ms: 10 });
  abort.abort();
  assert.equal(((await second) as Error).name, "AbortError");
  assert.equal((await first).sim_time_ms, 1);
  assert.equal((await third).sim_time_ms, 11);
  assert.equal(((await failure(client.step({ session_id: "s" }, options))) as Error).name, "AbortError");
  assert.equal(server.connections, 1);
  assert.equal(server.requests.length, 3);
});

test("a signal that outlives its requests keeps nothing of them", async (t) => {
  const [, client] = await start(t);
  const { signal } = new AbortController();
  await client.open({ session_id: "s", network: NETWORK }, { signal });
  await failure(client.open({ session_id: "s", network: NETWORK }, { signal }));
  assert.deepEqual(getEventListeners(signal, "abort"), []);
});

test("a connection lost in the middle fails the request that was sent, once, and carries on with those that were not", async (t) => {
  const [server, client] = await start(t);
  await client.open({ session_id: "s", network: NETWORK });
  server.behave = after(0, (request, _, server) => {
    server.service.handle(request);
    server.cut();
  });
  const lost = failure(client.run({ session_id: "s", duration_ms: 1 }));
  const next = client.run({ session_id: "s", duration_ms: 10 });
  isLost(await lost, true);
  assert.equal((await next).sim_time_ms, 11);
  assert.equal(server.requests.filter((request) => request.includes('"duration_ms":1,')).length, 1);
});

test("a reply that nobody waits for ends the connection, and is not taken for the reply to a later request", async (t) => {
  const [server, client] = await start(t);
  await client.open({ session_id: "s", network: NETWORK });
  server.behave = after(0, (request, socket) => {
    const reply = server.service.handle(request);
    socket.send(reply);
    socket.send(reply);
  });
  assert.equal((await client.run({ session_id: "s", duration_ms: 1 })).sim_time_ms, 1);
  await until(() => client.transport.state !== "open");
  assert.equal((await client.run({ session_id: "s", duration_ms: 10 })).sim_time_ms, 11);
  assert.equal(server.connections, 2);
});

test("a reply to another request fails the request, and the next one gets a connection without leftovers", async (t) => {
  const [server, client] = await start(t);
  await client.open({ session_id: "s", network: NETWORK });
  server.behave = after(0, (request, socket) => {
    const reply = server.service.handle(request);
    socket.send(encode(create("session_closed", { session_id: "s" })));
    setTimeout(() => socket.send(reply), 5);
  });
  assert.ok((await failure(client.run({ session_id: "s", duration_ms: 1 }))) instanceof ReplyError);
  assert.equal((await client.run({ session_id: "s", duration_ms: 10 })).sim_time_ms, 11);
  assert.equal(server.connections, 2);
});

// --- connecting ----------------------------------------------------------------------------------

test("a client that is there before its server waits for it", async (t) => {
  const gone = await TestServer.start();
  const { port, url } = gone;
  await gone.stop();
  const client = new WebSocketNeuroSim(url, QUICK);
  t.after(() => client.disconnect());
  const opened = client.open({ session_id: "s", network: NETWORK });
  await new Promise((resolve) => setTimeout(resolve, 60));
  assert.ok(["connecting", "waiting"].includes(client.transport.state), client.transport.state);
  const server = await TestServer.start(port);
  t.after(() => server.stop());
  assert.equal((await opened).ok, true);
});

test("a server that restarts is found again by the next request", async (t) => {
  const first = await TestServer.start();
  const client = new WebSocketNeuroSim(first.url, QUICK);
  t.after(() => client.disconnect());
  await client.open({ session_id: "s", network: NETWORK });
  await first.stop();
  const second = await TestServer.start(first.port);
  t.after(() => second.stop());
  await until(() => client.transport.state !== "open");
  // It has forgotten the session, and says so.
  assert.ok((await failure(client.step({ session_id: "s" }))) instanceof NcpServerError);
  await client.open({ session_id: "s", network: NETWORK });
});

test("without a server a request ends in time, says why, and leaves nothing that goes on trying", async (t) => {
  const gone = await TestServer.start();
  await gone.stop();
  const client = new WebSocketNeuroSim(gone.url, { ...QUICK, timeoutMs: 400 });
  t.after(() => client.disconnect());
  const error = await failure(client.step({ session_id: "s" }));
  assert.ok(error instanceof NcpTimeoutError);
  assert.equal(error.sent, false);
  isLost(error.cause, false);
  assert.equal(client.transport.state, "idle");
});

test("after so many failures in a row the waiting requests are given up, and a later one tries again", async (t) => {
  const { Class, attempts } = failing();
  const client = new WebSocketNeuroSim("ws://localhost", { ...QUICK, WebSocket: Class, maxAttempts: 3 });
  t.after(() => client.disconnect());
  const requests = [client.step({ session_id: "s" }), client.step({ session_id: "t" })].map(failure);
  for (const error of await Promise.all(requests)) isLost(error, false);
  assert.equal(attempts.length, 3);
  isLost(await failure(client.step({ session_id: "s" })), false);
  assert.equal(attempts.length, 6);
});

test("the wait between attempts doubles up to its limit, and varies by half", async (t) => {
  const { Class, attempts } = failing();
  const options = { ...QUICK, WebSocket: Class, retryMs: 20, maxRetryMs: 80, maxAttempts: 9 };
  const client = new WebSocketNeuroSim("ws://localhost", options);
  t.after(() => client.disconnect());
  await failure(client.step({ session_id: "s" }));
  const waits = attempts.slice(1).map((time, n) => time - attempts[n]!);
  assert.equal(waits.length, 8);
  // A busy machine makes a wait longer, never shorter.
  [20, 40, 80, 80, 80, 80, 80, 80].forEach((wait, n) => assert.ok(waits[n]! >= wait / 2 - 2, `${waits[n]} of ${wait} ms`));
  // Doubled without a limit, the last wait would be 1,280 ms at least.
  assert.ok(waits[7]! < 1_280, `${waits[7]} ms`);
});

test("a peer that takes the connection and says nothing is given up", async (t) => {
  const sockets: Socket[] = [];
  const mute = createServer((socket) => sockets.push(socket.on("error", () => {}))).listen(0, "127.0.0.1");
  await once(mute, "listening");
  const url = `ws://127.0.0.1:${(mute.address() as AddressInfo).port}`;
  const client = new WebSocketNeuroSim(url, { ...QUICK, connectTimeoutMs: 20, maxAttempts: 2 });
  t.after(() => {
    client.disconnect();
    for (const socket of sockets) socket.destroy();
    mute.close();
  });
  const error = await failure(client.step({ session_id: "s" }));
  isLost(error, false);
  assert.match((error as Error).message, /within 20 ms/);
  assert.equal(sockets.length, 2);
});

test("closing rejects what is under way and all that comes later", async (t) => {
  const [server, client] = await start(t);
  server.behave = silent;
  const sent = failure(client.step({ session_id: "s" }));
  const waiting = failure(client.step({ session_id: "s" }));
  await until(() => server.requests.length > 0);
  client.disconnect();
  client.disconnect();
  isLost(await sent, true);
  isLost(await waiting, false);
  isLost(await failure(client.step({ session_id: "s" })), false);
  assert.equal(client.transport.state, "closed");
});

test("what cannot become a connection is refused when it is built", async () => {
  const build = (url: string, options: WebSocketOptions): unknown => new WebSocketTransport(url, options);
  for (const url of ["", "localhost", "http://localhost", "file:///x"]) {
    assert.throws(() => build(url, QUICK), ConfigError, url);
  }
  for (const name of ["timeoutMs", "connectTimeoutMs", "retryMs", "maxRetryMs", "maxAttempts"] as const) {
    for (const value of [0, -1, NaN]) assert.throws(() => build("ws://localhost", { ...QUICK, [name]: value }), ConfigError);
  }
  const own = globalThis.WebSocket;
  try {
    globalThis.WebSocket = undefined as never;
    assert.throws(() => build("ws://localhost", {}), /WebSocket/);
  } finally {
    globalThis.WebSocket = own;
  }
  const send = new WebSocketTransport("ws://localhost", QUICK).send("", { timeoutMs: -1 });
  assert.ok((await failure(send)) instanceof ConfigError);
});

test("a request without a limit of time is not ended by the longest time that a timer can wait", async (t) => {
  const [server, client] = await start(t, { timeoutMs: Infinity });
  server.behave = (request, socket) => void setTimeout(() => answer(request, socket, server), 20);
  await client.open({ session_id: "s", network: NETWORK });
});

/** A class of WebSockets that never connect, and the times at which they were made. */
function failing(): { Class: WebSocketClass; attempts: number[] } {
  const attempts: number[] = [];
  class Class {
    binaryType = "";
    onopen = null;
    onmessage = null;
    onerror = null;
    onclose: ((event: { code: number }) => void) | null = null;
    constructor() {
      attempts.push(performance.now());
      setImmediate(() => this.onclose?.({ code: 1006 }));
    }
    send(): void {}
    close(): void {}
  }
  return { Class, attempts };
}
