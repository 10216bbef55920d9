import assert from "node:assert/strict";
import { test } from "node:test";
import {
  assertScientificBoundary,
  create,
  decode,
  encode,
  EncodeError,
  NCP_CONTRACT_HASH,
  NCP_VERSION,
  NcpScientificBoundaryError,
  NcpServerError,
  NcpVersionError,
  NeuroSimClient,
  plain,
  ReferenceBackend,
  ReplyError,
  type RequestOptions,
  SessionService,
} from "@ncp-conformance/peer";
import { refuses } from "./support.js";

const NETWORK = { kind: "builtin", ref: "ncp.reference.lif", population_sizes: { pop: 2 }, params: { I_e: 500 } };
const OPENED = { kind: "session_opened", session_id: "s" };

/** A client of a server that answers everything with this. */
function told(reply: object): NeuroSimClient {
  return new NeuroSimClient(() => Promise.resolve(JSON.stringify(reply)));
}

function open(client: NeuroSimClient): Promise<unknown> {
  return client.open({ session_id: "s", network: NETWORK });
}

test("a client opens, steps, runs and closes a session, in plain JSON values", async () => {
  const service = new SessionService(new ReferenceBackend());
  const sent: string[] = [];
  const client = new NeuroSimClient((request) => {
    sent.push(request);
    return Promise.resolve(service.handle(request));
  });
  const opened = await client.open({
    session_id: "s",
    network: NETWORK,
    record: { targets: [{ port: "v", target: "pop", ids: Float64Array.of(2), cadence_ms: 2 }] },
  });
  assert.deepEqual(opened.resolved, { pop: 2 });
  assert.equal(opened.contract_hash, NCP_CONTRACT_HASH);
  assert.equal(opened.provenance?.is_simulation_output, true);

  const stepped = await client.step({ session_id: "s", advance_ms: 4 });
  const { times, values, senders } = stepped.records["v"]!;
  assert.ok(Array.isArray(values));
  assert.deepEqual(senders, [2, 2]);
  times.forEach((time, n) => assert.ok(Math.abs(time - 2 * (n + 1)) < 1e-9));
  values.forEach((value, n) => assert.ok(Math.abs(value - (-70 + 20 * (1 - Math.exp(-0.2 * (n + 1))))) < 1e-9));

  const ran = await client.run({ session_id: "s", duration_ms: 6 });
  assert.deepEqual([ran.seq, ran.sim_time_ms], [2, 10]);
  assert.deepEqual(JSON.parse(JSON.stringify(ran)), ran);
  assert.equal(await client.close("s"), true);
  assert.deepEqual(
    sent.map((text) => (JSON.parse(text) as { kind: string }).kind),
    ["open_session", "step_request", "run_request", "close_session"],
  );
});

test("a borrowed session is not closed, and nothing is sent", async () => {
  let sent = 0;
  const client = new NeuroSimClient(() => {
    sent += 1;
    return Promise.reject(new Error("never"));
  });
  assert.equal(await client.close("s"), false);
  assert.equal(sent, 0);
});

test("a session that the server no longer has is not closed once another client has opened it anew", async () => {
  const sent: string[] = [];
  let server = new SessionService(new ReferenceBackend());
  const client = new NeuroSimClient((request) => {
    sent.push(request);
    return Promise.resolve(server.handle(request));
  });
  await open(client);
  server = new SessionService(new ReferenceBackend()); // It was restarted.
  await assert.rejects(client.close("s"), NcpServerError);
  await open(new NeuroSimClient((request) => Promise.resolve(server.handle(request))));
  assert.equal(await client.close("s"), false);
  assert.equal(sent.length, 2);
});

test("a close that got no reply can be tried again", async () => {
  const service = new SessionService(new ReferenceBackend());
  let down = false;
  const client = new NeuroSimClient((request) =>
    down ? Promise.reject(new Error("down")) : Promise.resolve(service.handle(request)),
  );
  await open(client);
  down = true;
  await assert.rejects(client.close("s"), /down/);
  down = false;
  assert.equal(await client.close("s"), true);
});

test("each way to fail has an error of its own, and only a misfit tells that replies are out of step", async () => {
  const step = async (reply: object | string): Promise<[Error, number]> => {
    let misfits = 0;
    const text = typeof reply === "string" ? reply : JSON.stringify(reply);
    const client = new NeuroSimClient(() => Promise.resolve(text), { onMisfit: () => (misfits += 1) });
    const error: unknown = await client.step({ session_id: "s" }).then(() => undefined, (error: unknown) => error);
    assert.ok(error instanceof Error, `accepted: ${text}`);
    return [error, misfits];
  };
  const frame = { kind: "observation_frame", session_id: "s", ncp_version: NCP_VERSION };
  const cases: [object | string, new (...args: never[]) => Error, number][] = [
    [{ kind: "error", error: "no" }, NcpServerError, 0],
    [{ kind: "error", error: "no", session_id: "other" }, NcpServerError, 0],
    [{ ...frame, ncp_version: "0.4" }, NcpVersionError, 0],
    [{ ...frame, ncp_version: "half" }, NcpVersionError, 0],
    [{ ...frame, calibrated_posterior: true }, NcpScientificBoundaryError, 0],
    [{ ...frame, is_simulation_output: null }, NcpScientificBoundaryError, 0],
    [{ ...frame, kind: "session_closed" }, ReplyError, 1],
    [{ ...frame, session_id: "other" }, ReplyError, 1],
    [{ ...frame, seq: "1" }, ReplyError, 1],
    ["{", ReplyError, 1],
    ["", ReplyError, 1],
  ];
  for (const [reply, type, misfits] of cases) {
    const [error, told] = await step(reply);
    assert.equal(error.constructor, type, `${JSON.stringify(reply)}: ${String(error)}`);
    assert.equal(told, misfits, JSON.stringify(reply));
  }
});

test("a refusal and a broken boundary keep a session from being opened, and it is not this client's", async () => {
  await assert.rejects(open(told({ ...OPENED, ok: false, error: "no such network" })), (error) => {
    assert.ok(error instanceof NcpServerError);
    assert.equal(error.message, "no such network");
    return true;
  });
  const provenance = { calibrated_posterior: true };
  await assert.rejects(open(told({ ...OPENED, provenance })), NcpScientificBoundaryError);
  const client = told({ ...OPENED, ok: false });
  await assert.rejects(open(client), NcpServerError);
  assert.equal(await client.close("s"), false);
});

test("what no request can be made of is refused before anything is sent", async () => {
  const client = new NeuroSimClient(() => assert.fail("sent"));
  await assert.rejects(client.step({ session_id: "a/b" }), EncodeError);
  await assert.rejects(client.run({ session_id: "s", duration_ms: NaN }), EncodeError);
});

test("signal and time of a request reach whatever sends it, and its failure comes back as it is", async () => {
  const failure = new Error("down");
  let told: RequestOptions | undefined;
  const client = new NeuroSimClient((_, options) => {
    told = options;
    return Promise.reject(failure);
  });
  const options = { signal: new AbortController().signal, timeoutMs: 5 };
  await assert.rejects(client.step({ session_id: "s" }, options), (error) => error === failure);
  assert.equal(told, options);
});

test("under the strict profile a reply must say its version", async () => {
  const reply = (): Promise<string> => Promise.resolve('{"kind":"observation_frame","session_id":"s"}');
  await new NeuroSimClient(reply).step({ session_id: "s" });
  await assert.rejects(new NeuroSimClient(reply, { strict: true }).step({ session_id: "s" }), ReplyError);
});

test("a name that objects have by themselves is a name like others", async () => {
  const reply = '{"kind":"session_opened","session_id":"s","resolved":{"__proto__":1,"constructor":2}}';
  const { resolved } = await new NeuroSimClient(() => Promise.resolve(reply)).open({ session_id: "s", network: {} });
  assert.deepEqual(Object.entries(resolved), Object.entries(JSON.parse('{"__proto__":1,"constructor":2}') as object));
});

// --- the scientific boundary ---------------------------------------------------------------------

test("the scientific boundary is where the text has its pins", () => {
  const observation = { kind: "observation_frame", session_id: "s" };
  const holds: unknown[] = [
    observation,
    { ...observation, calibrated_posterior: false, is_simulation_output: true },
    { ...OPENED },
    { ...OPENED, provenance: null },
    { ...OPENED, provenance: {} },
    { ...OPENED, calibrated_posterior: true },
    { kind: "command_frame", calibrated_posterior: true },
    create("session_opened", { session_id: "s", provenance: {} }),
    create("observation_frame", { session_id: "s" }),
  ];
  for (const frame of holds) assertScientificBoundary(frame);

  const broken: unknown[] = [undefined, null, 1, "{}", [], {}, { kind: "nothing" }, { calibrated_posterior: false }];
  for (const value of [true, null, 0, "false", undefined]) {
    broken.push({ ...observation, calibrated_posterior: value }, { ...OPENED, provenance: { calibrated_posterior: value } });
  }
  for (const value of [false, null, 1, "true", undefined]) {
    broken.push({ ...observation, is_simulation_output: value }, { ...OPENED, provenance: { is_simulation_output: value } });
  }
  for (const frame of broken) refuses("provenance", () => assertScientificBoundary(frame));
  assert.throws(() => assertScientificBoundary({}), NcpScientificBoundaryError);
});

// --- plain messages ------------------------------------------------------------------------------

test("a plain message is the JSON of its frame", () => {
  const command = create("command_frame", {
    channels: { a: { data: [1, -0.5] } },
    horizon: [{ b: { data: [], unit: "m" } }],
  });
  assert.deepEqual(plain(command), JSON.parse(encode(command)));
  const opened = decode("session_opened", '{"kind":"session_opened","session_id":"s","provenance":{"seed":3}}');
  assert.deepEqual(plain(opened), JSON.parse(encode(opened)));
});
