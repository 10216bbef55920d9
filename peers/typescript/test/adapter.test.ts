import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

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
    wire_version: "0.5",
    contract_hash: "24e8e6e31e1dec8a",
    roles: ["commander", "body", "server", "observer"],
  });
});

test("every call of the protocol is answered", async () => {
  const golden =
    "TkNQQgEAAgBoAAAALAAAAAUAAgADAAAAOAAAADEAAAAHAAQAAwAAAFAAAAB0aW1lc3NlbmRlcnMAAAAAAAD4PwAAAAAAAARAAAAAAAAAIkAHAAAAAAAAAAcAAAAAAAAACQAAAAAAAAA=";
  const columns = [
    { name: "times", dtype: "f64", data: [1.5, 2.5, 9] },
    { name: "senders", dtype: "i64", data: ["7", "7", "9"] },
  ];
  const closed = '{"ncp_version":"0.5","kind":"session_closed","session_id":"s","ok":true}';
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
      ["contract.verify", { peer_hash: "24e8e6e31e1dec8a" }],
      ["negotiate", { version: "0.5", contract_hash: "x" }],
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
  assert.deepEqual(await ask(["governor.run", {}], ["constructor", {}], ["", null]), [
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
  ];
  const answers = await ask(...calls.flatMap((call) => shapes.map((args): [string, unknown] => [call, args])));
  for (const answer of answers) assert.notEqual(codeOf(answer), "internal", JSON.stringify(answer));
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
    `${JSON.stringify({ id, call: "decode", args: { kind: "sensor_frame", text: '{"ncp_version":"0.5","kind":"sensor_frame","seq":42,"t":12.345678,"frame_id":"world","channels":{"pose_position":{"data":[1.0,2.0,3.0],"unit":"m"}}}' } })}\n`;
  const { answers, milliseconds } = await run(Array.from({ length: 40_000 }, (_, id) => request(id)).join(""));
  assert.equal(answers.length, 40_000);
  assert.ok(milliseconds < 4_000, `they took ${milliseconds.toFixed(0)} ms`);
});
