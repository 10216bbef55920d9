import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { NCP_CONTRACT_HASH, NCP_VERSION } from "@ncp-conformance/peer";
import { defaultsOf } from "./support.js";

const ADAPTER = fileURLToPath(new URL("../adapter.js", import.meta.url));

interface Run {
  readonly answers: Record<string, unknown>[];
  readonly exitCode: number | null;
  readonly milliseconds: number;
}

/** Starts the program, gives it all the input in the pieces given, and waits for its end. */
async function run(...pieces: (string | Buffer)[]): Promise<Run> {
  const begin = performance.now();
  const child = spawn(process.execPath, [ADAPTER], { stdio: ["pipe", "pipe", "ignore"] });
  const output: Buffer[] = [];
  child.stdout.on("data", (chunk: Buffer) => output.push(chunk));
  for (const piece of pieces) child.stdin.write(piece);
  child.stdin.end();
  const exitCode = await new Promise<number | null>((resolve) => child.on("close", resolve));
  const lines = Buffer.concat(output).toString("utf8").split("\n");
  assert.equal(lines.pop(), "", "the output ends with a line feed");
  const answers = lines.map((line) => JSON.parse(line) as Record<string, unknown>);
  return { answers, exitCode, milliseconds: performance.now() - begin };
}

/** The answers to some calls, each without its id. */
async function ask(...calls: [call: string, args: unknown][]): Promise<unknown[]> {
  const { answers, exitCode } = await run(
    calls.map(([call, args], id) => `${JSON.stringify({ id, call, args })}\n`).join(""),
  );
  assert.equal(exitCode, 0);
  assert.deepEqual(
    answers.map(({ id }) => id),
    calls.map((_, id) => id),
  );
  return answers.map(({ id: _, ...rest }) => rest);
}

const codeOf = (answer: unknown): string | undefined => (answer as { error?: { code: string } }).error?.code;

test("the program ends with exit code 0 at the end of its input, also without any", async () => {
  assert.equal((await run()).exitCode, 0);
});

test("the program describes itself and claims all four roles", async () => {
  const [answer] = await ask(["describe", {}]);
  const { version, ...rest } = (answer as { result: Record<string, unknown> }).result;
  assert.match(String(version), /^\d+\.\d+\.\d+$/);
  assert.deepEqual(rest, {
    name: "typescript",
    language: "TypeScript",
    wire_version: NCP_VERSION,
    contract_hash: NCP_CONTRACT_HASH,
    roles: ["commander", "body", "server", "observer"],
    reference_networks: true,
  });
});

test("every call of the protocol is answered", async () => {
  const golden =
    "TkNQQgEAAgBoAAAALAAAAAUAAgADAAAAOAAAADEAAAAHAAQAAwAAAFAAAAB0aW1lc3NlbmRlcnMAAAAAAAD4PwAAAAAAAARAAAAAAAAAIkAHAAAAAAAAAAcAAAAAAAAACQAAAAAAAAA=";
  const columns = [
    { name: "times", dtype: "f64", data: [1.5, 2.5, 9] },
    { name: "senders", dtype: "i64", data: ["7", "7", "9"] },
  ];
  const closed = `{"ncp_version":"${NCP_VERSION}","kind":"session_closed","session_id":"s","ok":true}`;
  assert.deepEqual(
    await ask(
      ["decode", { kind: "session_closed", text: '{"session_id":"s","kind":"session_closed"}' }],
      [
        "decode",
        {
          kind: "session_closed",
          base64: Buffer.from('{"session_id":"s","kind":"session_closed"}').toString("base64"),
        },
      ],
      ["encode", { kind: "session_closed", fields: { session_id: "s" } }],
      ["version.check", { version: "0.4", strict: false }],
      ["contract.status", { peer_hash: null }],
      ["contract.verify", { peer_hash: NCP_CONTRACT_HASH }],
      ["negotiate", { version: NCP_VERSION, contract_hash: "x" }],
      ["key.build", { key: "sensor", realm: null, session: "uav3", name: "front" }],
      ["key.build", { key: "rpc", realm: "a/b" }],
      ["key.match", { pattern: "a/**", key: "a" }],
      ["plane.qos", { plane: "action" }],
      ["bulk.decode", { block: golden }],
      ["bulk.encode", { columns }],
      ["observation.pack", { times: [1.5, 2.5, 9], values: [], senders: ["7", "7", "9"] }],
      ["observation.unpack", { block: golden }],
      ["reply.check", { request: '{"kind":"close_session","session_id":"s"}', reply: closed }],
    ),
    [
      { result: { text: closed } },
      { result: { text: closed } },
      { result: { text: closed } },
      { result: { compatible: false } },
      { result: { status: "not_advertised" } },
      { result: {} },
      { result: { contract: "mismatch" } },
      { result: { key: "ncp/session/uav3/sensor/front" } },
      { result: { key: "a/b/rpc" } },
      { result: { matches: true } },
      { result: { congestion: "drop", priority: "RealTime", express: true } },
      { result: { columns } },
      { result: { block: golden } },
      { result: { block: golden } },
      { result: { times: [1.5, 2.5, 9], values: [], senders: ["7", "7", "9"] } },
      { result: {} },
    ],
  );
});

test("every call with a trace is answered, a step an entry", async () => {
  const velocity = (...data: unknown[]): object => ({ velocity_setpoint: { data, unit: "m/s" } });
  const position = (...data: unknown[]): object => ({ channels: { pose_position: { data, unit: "m" } } });
  const entry = (answer: unknown, n: number): Record<string, never> =>
    (answer as { result: { steps: Record<string, never>[] } }).result.steps[n]!;
  const [governor, watchdog, buffer, length, link, rates, decoded, reflex, refused, loop, session] = await ask(
    [
      "governor.run",
      {
        limits: { max_speed_mps: 5 },
        capabilities: null,
        steps: [
          { op: "govern", command: { channels: velocity(30, 40, "-0") }, now_s: 1, sensor: null, last_sensor_s: 1 },
          { op: "govern", command: { t: "NaN", channels: velocity("Infinity") }, now_s: 1, last_sensor_s: 1 },
          { op: "note_link", burst: true },
          { op: "govern", command: { t: 5, seq: 3 }, now_s: 1, last_sensor_s: 1 },
          { op: "reset" },
          { op: "govern", command: { channels: velocity(1, 0, 0) }, now_s: "Infinity", last_sensor_s: 1 },
          { op: "dance" },
        ],
      },
    ],
    [
      "watchdog.run",
      {
        steps: [
          { op: "should_hold", now_s: 0 },
          { op: "command", now_s: 1, ttl_ms: 250, seq: 1 },
          { op: "should_hold", now_s: 1.25 },
          { op: "reset" },
          { op: "should_hold", now_s: 1.25 },
        ],
      },
    ],
    [
      "buffer.run",
      {
        steps: [
          { op: "command", text: '{"kind":"command_frame","mode":"active","channels":{"a":{"data":[1]}}}', now_s: 1 },
          { op: "active", now_s: 1 },
          {
            op: "command",
            base64: Buffer.from('{"kind":"command_frame","mode":"estop","t":""}').toString("base64"),
            now_s: 1,
          },
          { op: "active", now_s: 1 },
          { op: "reset" },
        ],
      },
    ],
    ["horizon.max_len", { ttl_ms: 200, dt_ms: 50 }],
    [
      "link.run",
      {
        ref_loss: null,
        threshold: null,
        steps: [
          { op: "frame", seq: 1 },
          { op: "frame", seq: 3 },
        ],
      },
    ],
    ["codec.encode", { codec: "uav", sensor: null }],
    ["codec.decode", { codec: "uav", rates: { vel_x: "NaN" }, t: 1, seq: 2, frame_id: "map", mode: "hold" }],
    ["reflex.step", { config: { target: [1, 0, 0] }, sensor: position(0, 0, 0) }],
    ["reflex.step", { config: { kp: "NaN" }, sensor: null }],
    [
      "loop.run",
      {
        period_ms: 50,
        limits: {},
        config: {},
        steps: [
          { op: "tick", now_s: 1 },
          { op: "sensor", sensor: { seq: 4, ...position(-1, 0, 0) }, now_s: 2 },
          { op: "tick", now_s: 2 },
          { op: "reset" },
        ],
      },
    ],
    ["session.run", { requests: ['{"kind":"close_session","session_id":"s"}', "?"] }],
  );
  const head = defaultsOf("CommandFrame");
  assert.deepEqual(entry(governor, 0), {
    frame: { ...head, seq: 0, t: 0, mode: "active", channels: velocity(3, 4, "-0") },
  });
  assert.deepEqual(entry(governor, 1), { frame: { ...head, seq: 0, t: "NaN", mode: "hold", channels: velocity(0) } });
  assert.deepEqual(entry(governor, 2), {});
  assert.deepEqual(entry(governor, 3), {
    frame: { ...head, seq: 3, t: 5, mode: "estop", channels: velocity(0, 0, 0) },
  });
  assert.equal(entry(governor, 5)["frame"]!["mode"], "hold");
  assert.deepEqual(Object.keys(entry(governor, 6)), ["error"]);
  assert.deepEqual(watchdog, { result: { steps: [{ hold: true }, {}, { hold: false }, {}, { hold: true }] } });
  assert.deepEqual(entry(buffer, 1), { channels: { a: { data: [1], unit: null } } });
  assert.equal(entry(buffer, 2)["error"]!["code"], "type");
  assert.deepEqual([entry(buffer, 3), entry(buffer, 4)], [{ channels: null }, {}]);
  assert.deepEqual(length, { result: { len: 4 } });
  assert.deepEqual(entry(link, 1), { last_seq: 3, received: 2, lost: 1, loss_rate: 1 / 3, burst: false });
  assert.deepEqual(rates, { result: { rates: { err_x: 100, err_y: 100, err_z: 100 } } });
  assert.deepEqual(decoded, {
    result: { command: { ...head, t: 1, seq: 2, frame_id: "map", mode: "hold", channels: velocity(0, 0, 0) } },
  });
  assert.deepEqual(reflex, {
    result: { command: { ...head, seq: 0, t: 0, mode: "active", channels: velocity(1, 0, 0) } },
  });
  assert.equal(codeOf(refused), "value");
  assert.equal(entry(loop, 0)["command"]!["mode"], "hold");
  assert.deepEqual(entry(loop, 2), {
    command: { ...head, seq: 4, t: 2, mode: "active", channels: velocity(1, 0, 0) },
    status: { ...defaultsOf("ControlStatus"), seq: 2, t: 2, mode: "active" },
  });
  const { replies } = (session as { result: { replies: string[] } }).result;
  assert.deepEqual(JSON.parse(replies[0]!), { ncp_version: NCP_VERSION, kind: "session_closed", session_id: "s", ok: false });
  assert.equal((JSON.parse(replies[1]!) as { kind: string }).kind, "error");
});

test("each key has its own form", async () => {
  const keys = ["sensor", "command", "observation", "sensor_glob", "command_glob", "session_glob", "fleet_glob"];
  const answers = await ask(
    ...keys.map((key): [string, unknown] => ["key.build", { key, realm: "r", session: "s", name: null }]),
  );
  assert.deepEqual(
    answers.map((answer) => (answer as { result: { key: string } }).result.key),
    [
      "r/session/s/sensor",
      "r/session/s/command",
      "r/session/s/observation",
      "r/session/s/sensor/**",
      "r/session/s/command/**",
      "r/session/s/**",
      "r/session/**",
    ],
  );
});

test("a refusal is answered with its code", async () => {
  const answers = await ask(
    ["decode", { kind: "sensor_frame", text: "{" }],
    ["decode", { kind: "sensor_frame", base64: Buffer.from([0x7b, 0x22, 0xff]).toString("base64") }],
    ["decode", { kind: "nothing", text: "{}" }],
    ["decode", { kind: "sensor_frame", text: '{"kind":"sensor_frame","t":null}' }],
    ["decode", { kind: "sensor_frame" }],
    ["encode", { kind: "sensor_frame", fields: { t: "NaN" } }],
    ["encode", { kind: "sensor_frame", fields: { seq: 9007199254740993 } }],
    ["encode", { kind: "close_session", fields: {} }],
    ["version.check", { version: "0.4", strict: true }],
    ["contract.verify", { peer_hash: null }],
    ["key.build", { key: "sensor", realm: null, session: "a b" }],
    ["key.match", { pattern: "a//b", key: "a" }],
    ["bulk.decode", { block: "" }],
    ["bulk.encode", { columns: [{ name: "a", dtype: "i32", data: [2147483648] }] }],
    ["bulk.encode", { columns: [{ name: "a", dtype: "i64", data: ["9223372036854775808"] }] }],
    ["observation.pack", { times: [1], values: [1, 2], senders: [] }],
    ["reply.check", { request: '{"kind":"sensor_frame"}', reply: "{}" }],
    ["reply.check", { request: '{"kind":"close_session","session_id":"s"}', reply: '{"kind":"error","error":"no"}' }],
  );
  assert.deepEqual(answers.map(codeOf), [
    "malformed",
    "malformed",
    "kind",
    "type",
    "invalid",
    "non_finite",
    "value",
    "missing",
    "version",
    "contract",
    "key",
    "key",
    "block",
    "type",
    "type",
    "block",
    "kind",
    "reply",
  ]);
});

test("numbers that JSON lacks pass in both directions", async () => {
  const doubles = ["NaN", "Infinity", "-Infinity", "-0", 0, 0.1];
  const columns = [
    { name: "a", dtype: "f64", data: doubles },
    { name: "b", dtype: "f32", data: ["NaN", "-0", 1.5] },
  ];
  const [encoded, written] = await ask(
    ["bulk.encode", { columns }],
    [
      "encode",
      {
        kind: "command_frame",
        fields: {
          t: "-0",
          channels: { "-0": { data: ["-0", 1], unit: "-0" } },
          horizon: [{ __proto__: null, a: { data: ["-0"] } }],
        },
      },
    ],
  );
  const [decoded] = await ask(["bulk.decode", (encoded as { result: unknown }).result]);
  assert.deepEqual(decoded, { result: { columns } });
  const { text } = (written as { result: { text: string } }).result;
  assert.match(
    text,
    /"t":-0\.0,.*"channels":\{"-0":\{"data":\[-0\.0,1\],"unit":"-0"\}\},"horizon":\[\{"a":\{"data":\[-0\.0\]/,
  );
});

test("a call that the program does not know is unsupported", async () => {
  assert.deepEqual(await ask(["governor.walk", {}], ["constructor", {}], ["", null]), [
    { unsupported: true },
    { unsupported: true },
    { unsupported: true },
  ]);
});

test("arguments of any shape never crash the program nor a call", async () => {
  const calls = [
    "decode",
    "encode",
    "version.check",
    "contract.status",
    "contract.verify",
    "negotiate",
    "key.build",
    "key.match",
    "plane.qos",
    "bulk.decode",
    "bulk.encode",
    "observation.pack",
    "observation.unpack",
    "reply.check",
    "governor.run",
    "watchdog.run",
    "buffer.run",
    "horizon.max_len",
    "link.run",
    "codec.encode",
    "codec.decode",
    "reflex.step",
    "loop.run",
    "session.run",
  ];
  const steps = [
    1,
    {},
    { op: "constructor" },
    ...["govern", "note_link", "reset", "command", "should_hold", "active", "frame", "sensor", "tick"].flatMap((op) => [
      { op },
      { op, now_s: "x", seq: 0.5, ttl_ms: {}, text: 1, burst: "yes" },
      { op, now_s: 1, command: { t: "x" }, sensor: { seq: "x", channels: { a: { data: ["x"] } } } },
      { op, now_s: 1, command: { mode: 5, horizon: [{ a: { unit: 5 } }] }, sensor: 5, last_sensor_s: [] },
      { op, now_s: 1, command: { mode: "dance", channels: [] }, sensor: { channels: { a: null } } },
      { op, now_s: "NaN", seq: 1e300, ttl_ms: "-Infinity", text: "{", command: {}, sensor: {} },
    ]),
  ];
  const shapes: unknown[] = [
    undefined,
    null,
    1,
    "x",
    [],
    {},
    { kind: null, text: 1 },
    { kind: "command_frame", fields: [] },
    { kind: "command_frame", fields: { horizon: [1] } },
    { kind: "open_session", fields: { session_id: {}, network: { params: 1 } } },
    { columns: [1] },
    { columns: [{ name: "a", dtype: "f64", data: [{}] }] },
    { columns: [{ name: "a", dtype: "constructor", data: [] }] },
    { times: [null], values: {}, senders: [1] },
    { plane: "constructor", key: "constructor" },
    { block: "%%%" },
    { version: 5, peer_hash: 5 },
    { realm: {}, key: "rpc" },
    { request: "[]", reply: "" },
    { steps, period_ms: 50 },
    { steps, period_ms: "NaN", limits: { max_speed_mps: "NaN" }, ref_loss: "Infinity", threshold: "x" },
    { steps, period_ms: 1, limits: { max_speed_mps: "x" }, capabilities: { sensor_channels: [{ unit: 5 }] } },
    { steps, period_ms: 1, limits: [], capabilities: { command_channels: 1 }, config: { target: [1], kp: "x" } },
    { steps: 5, config: [], codec: "other", requests: [5] },
    { codec: { encoders: [{ channel: "a", component: "x" }] }, rates: { a: "x" }, t: 0, seq: 0 },
    { codec: { encoders: [5] }, rates: [] },
    { codec: { decoders: [{ channel: "a", component: 0, population: "p", value_range: [1] }] } },
    { codec: "uav", sensor: { channels: { pose_error: 5 } }, rates: {}, t: {}, mode: "x" },
    { requests: ["", "{}", "\ud800"] },
  ];
  const answers = await ask(...calls.flatMap((call) => shapes.map((args): [string, unknown] => [call, args])));
  for (const answer of answers) assert.ok(!JSON.stringify(answer).includes('"internal"'), JSON.stringify(answer));
});

test("lines that are no requests are passed over, and a last line needs no line feed", async () => {
  const { answers, exitCode } = await run(
    '\n[]\nnull\n{"id":1,\n\0\n{"id":2,"call":"nope"}\n{"id":"x","call":"no',
    'pe"}',
  );
  assert.deepEqual(answers, [
    { id: 2, unsupported: true },
    { id: "x", unsupported: true },
  ]);
  assert.equal(exitCode, 0);
});

test("a request may come in any pieces, also cut within a character", async () => {
  const line = Buffer.from(
    `${JSON.stringify({ id: 1, call: "key.build", args: { key: "sensor", session: "é😀" } })}\n`,
  );
  const { answers } = await run(...Array.from(line, (_, n) => line.subarray(n, n + 1)));
  assert.deepEqual(answers, [{ id: 1, result: { key: "ncp/session/é😀/sensor" } }]);
});

test("a line of 160 MiB is answered", async () => {
  const long = Buffer.alloc(160 * 1_048_576, " ");
  long.write('{"id":1,"call":"decode","args":{"kind":"observation_frame","text":"');
  long.write('"}}\n', long.length - 4);
  const { answers, milliseconds } = await run(long, '{"id":2,"call":"nope"}\n');
  assert.deepEqual(
    answers.map(({ id }) => id),
    [1, 2],
  );
  assert.equal(codeOf(answers[0]), "limit");
  assert.ok(milliseconds < 20_000, `it took ${milliseconds.toFixed(0)} ms`);
});

test("an observation frame of 64 MiB is read and written within twenty seconds", async () => {
  const values = "0.12345678901234568,".repeat(3_355_000);
  const text = `{"kind":"observation_frame","session_id":"s","records":{"p":{"values":[${values}0]}}}`;
  const { answers, milliseconds } = await run(
    `${JSON.stringify({ id: 1, call: "decode", args: { kind: "observation_frame", text } })}\n`,
  );
  const result = answers[0]!["result"] as { text: string };
  assert.equal(result.text.split("0.12345678901234568,").length, 3_355_001);
  assert.ok(milliseconds < 20_000, `it took ${milliseconds.toFixed(0)} ms`);
});

test("forty thousand small requests are answered within four seconds", async () => {
  const request = (id: number): string =>
    `${JSON.stringify({ id, call: "decode", args: { kind: "sensor_frame", text: '{"kind":"sensor_frame","seq":42,"t":12.345678,"frame_id":"world","channels":{"pose_position":{"data":[1.0,2.0,3.0],"unit":"m"}}}' } })}\n`;
  const { answers, milliseconds } = await run(Array.from({ length: 40_000 }, (_, id) => request(id)).join(""));
  assert.equal(answers.length, 40_000);
  assert.ok(milliseconds < 4_000, `they took ${milliseconds.toFixed(0)} ms`);
});
