import assert from "node:assert/strict";
import { test } from "node:test";
import {
  create,
  decode,
  encode,
  type Input,
  type Kind,
  KINDS,
  type Message,
  NCP_CONTRACT_HASH,
  NCP_VERSION,
} from "@ncp-conformance/peer";
import { refuses } from "./support.js";

/** Built as a program without types would, to see what the library itself refuses. */
function build(kind: Kind, fields: unknown): string {
  return encode(create(kind, fields as Input<Kind>));
}

test("a message is written with every field of its table, in its order, and null for what is unset", () => {
  assert.equal(
    build("open_session", { session_id: "s", network: { kind: "spec" }, bindings: [{ entity: { path: "/w" } }] }),
    `{"ncp_version":"${NCP_VERSION}","kind":"open_session","session_id":"s",` +
      '"network":{"kind":"spec","ref":"","model_name":null,"population_sizes":{},"params":{}},' +
      '"record":{"targets":[]},"stimulus":{"targets":[]},' +
      '"sim":{"dt_ms":0.1,"chunk_ms":10,"seed":null,"mode":"stream","duration_ms":null},' +
      '"bindings":[{"entity":{"path":"/w","role":"sensor","meta":{}},"port":"","direction":"stimulus"}],' +
      `"contract_hash":"${NCP_CONTRACT_HASH}"}`,
  );
  assert.equal(
    build("observation_frame", { session_id: "s", seq: 2, records: { p: { times: [0.5], senders: [3], unit: "mV" } } }),
    `{"ncp_version":"${NCP_VERSION}","kind":"observation_frame","session_id":"s","seq":2,"t":0,"sim_time_ms":0,` +
      '"records":{"p":{"port":"","target":"","observable":"V_m","times":[0.5],"values":[],"senders":[3],"unit":"mV","recordable":null}},' +
      '"calibrated_posterior":false,"is_simulation_output":true}',
  );
});

test("a horizon is an array of plain channel maps", () => {
  assert.match(
    build("command_frame", { horizon: [{ v: { data: [1, 2] } }, {}] }),
    /"horizon":\[\{"v":\{"data":\[1,2\],"unit":null\}\},\{\}\]/,
  );
});

test("a program that names no mode gets active, and no contract hash its own", () => {
  assert.equal(create("command_frame", {}).mode, "active");
  assert.equal(create("control_status", {}).mode, "init");
  assert.equal(create("session_opened", { session_id: "s" }).contract_hash, NCP_CONTRACT_HASH);
  assert.equal(create("open_session", { session_id: "s", network: {}, contract_hash: null }).contract_hash, null);
});

test("the entries of a map are sorted by code points, not by UTF-16 units", () => {
  const names = [
    "\u{1f600}",
    "\uff5e",
    "b",
    "",
    "10",
    "9",
    "é",
    "__proto__",
    "a",
    "\ue000",
    "\u{10ffff}",
    "\ud7ff",
    "ab",
  ];
  const meta = new Map(names.map((name) => [name, {}] as const));
  const written = Object.keys(
    Object(
      JSON.parse(build("sensor_frame", { channels: meta }).replaceAll('"10"', '"1O"').replaceAll('"9"', '"9_"'))[
        "channels"
      ],
    ),
  );
  assert.deepEqual(written, [
    "",
    "1O",
    "9_",
    "__proto__",
    "a",
    "ab",
    "b",
    "é",
    "\ud7ff",
    "\ue000",
    "\uff5e",
    "\u{1f600}",
    "\u{10ffff}",
  ]);
});

test("entries that look like indices or like a prototype are written as any other", () => {
  const fields = JSON.parse(
    '{"channels":{"2":{},"10":{},"__proto__":{"data":[1]},"constructor":{}}}',
  ) as Input<"sensor_frame">;
  const frame = decode("sensor_frame", build("sensor_frame", fields));
  assert.deepEqual([...frame.channels.keys()], ["10", "2", "__proto__", "constructor"]);
  assert.deepEqual([...frame.channels.get("__proto__")!.data], [1]);
});

test("a double is written so that it reads back bit for bit, the negative zero with its sign", () => {
  const text = build("sensor_frame", {
    t: -0,
    channels: { a: { data: [-0, 0, 5e-324, 1.7976931348623157e308, 0.1, 1e21, -1e-7] } },
  });
  assert.match(text, /"t":-0\.0,/);
  assert.match(text, /\[-0\.0,0,5e-324,1\.7976931348623157e\+308,0\.1,1e\+21,-1e-7\]/);
});

test("an integer is written as a plain integer, also the largest and a negative zero", () => {
  assert.match(build("sensor_frame", { seq: 9007199254740991 }), /"seq":9007199254740991,/);
  assert.match(build("sensor_frame", { seq: -0 }), /"seq":0,/);
  assert.match(
    build("observation_frame", { session_id: "s", records: { p: { senders: [-0, -9007199254740991] } } }),
    /"senders":\[0,-9007199254740991\]/,
  );
});

test("a number that JSON lacks is refused, wherever it stands", () => {
  for (const value of [NaN, Infinity, -Infinity]) {
    refuses("non_finite", () => build("sensor_frame", { t: value }));
    refuses("non_finite", () => build("command_frame", { horizon_dt_ms: value }));
    refuses("non_finite", () => build("command_frame", { horizon: [{ a: { data: [1, value] } }] }));
    refuses("non_finite", () => build("open_session", { session_id: "s", network: { params: { a: value } } }));
    refuses("non_finite", () => build("observation_frame", { session_id: "s", records: { p: { times: [value] } } }));
    refuses("non_finite", () => build("sensor_frame", { seq: value }));
  }
});

test("an integer beyond the safe range or with a fraction is refused", () => {
  refuses("value", () => build("sensor_frame", { seq: 2 ** 53 }));
  refuses("value", () => build("sensor_frame", { seq: -(2 ** 53) }));
  refuses("type", () => build("sensor_frame", { seq: 1.5 }));
  refuses("value", () => build("observation_frame", { session_id: "s", records: { p: { senders: [0, 2 ** 53] } } }));
  refuses("value", () => build("session_opened", { session_id: "s", resolved: { a: 1e300 } }));
});

test("an id that no receiver takes is refused", () => {
  for (const id of ["", "a/b", "@x", "."]) refuses("value", () => build("close_session", { session_id: id }));
});

test("a required field must be named", () => {
  const given: Readonly<Record<string, unknown>> = {
    session_id: "s",
    network: {},
    duration_ms: 1,
    controller_id: "c",
    error: "e",
  };
  const required: Partial<Record<Kind, string[]>> = {
    open_session: ["session_id", "network"],
    session_opened: ["session_id"],
    stimulus_frame: ["session_id"],
    step_request: ["session_id"],
    run_request: ["session_id", "duration_ms"],
    observation_frame: ["session_id"],
    close_session: ["session_id"],
    session_closed: ["session_id"],
    capabilities: ["controller_id"],
    error: ["error"],
  };
  for (const kind of KINDS) {
    const names = required[kind] ?? [];
    const all = Object.fromEntries(names.map((name) => [name, given[name]]));
    build(kind, all);
    for (const name of names) refuses("missing", () => build(kind, { ...all, [name]: undefined }));
  }
});

test("a pin with another than its pinned value is refused", () => {
  refuses("provenance", () => build("observation_frame", { session_id: "s", calibrated_posterior: true }));
  refuses("provenance", () => build("observation_frame", { session_id: "s", is_simulation_output: false }));
  refuses("provenance", () => build("session_opened", { session_id: "s", provenance: { calibrated_posterior: true } }));
  refuses("provenance", () => build("session_opened", { session_id: "s", provenance: { is_simulation_output: null } }));
  assert.match(
    build("session_opened", { session_id: "s", provenance: {} }),
    /"calibrated_posterior":false,"is_simulation_output":true/,
  );
});

test("a decoded message that a program has changed is checked when it is written", () => {
  const frame = decode("observation_frame", '{"kind":"observation_frame","session_id":"s"}');
  (frame as { calibrated_posterior: boolean }).calibrated_posterior = true;
  refuses("provenance", () => encode(frame));
  const command = create("command_frame", {});
  (command as { mode: string }).mode = "dance";
  refuses("value", () => encode(command));
  refuses("kind", () => encode({ kind: "nothing" } as unknown as Message));
});

test("a value of the wrong type and an unknown field are refused", () => {
  const faulty: [Kind, unknown][] = [
    ["sensor_frame", { seq: "1" }],
    ["sensor_frame", { seq: null }],
    ["sensor_frame", { t: true }],
    ["sensor_frame", { frame_id: 1 }],
    ["sensor_frame", { channels: [] }],
    ["sensor_frame", { channels: null }],
    ["sensor_frame", { channels: { a: 1 } }],
    ["sensor_frame", { channels: { a: { data: 1 } } }],
    ["sensor_frame", { channels: { a: { data: ["1"] } } }],
    ["sensor_frame", { channels: { a: { data: [null] } } }],
    ["sensor_frame", { channels: { a: { unit: 1 } } }],
    ["command_frame", { horizon: {} }],
    ["control_status", { safety_ok: 1 }],
    ["open_session", { session_id: "s", network: [] }],
  ];
  for (const [kind, fields] of faulty) refuses("type", () => build(kind, fields));
  for (const fields of [{ sequence: 1 }, { channels: { a: { Data: [] } } }, JSON.parse('{"__proto__":1}') as unknown]) {
    refuses("value", () => build("sensor_frame", fields));
  }
});

test("an enum that is not descriptive takes its own strings only", () => {
  refuses("value", () => build("command_frame", { mode: "Active" }));
  refuses("value", () => build("open_session", { session_id: "s", network: {}, sim: { mode: "live" } }));
  assert.match(build("capabilities", { controller_id: "c", role: "spectator" }), /"role":"spectator"/);
});

test("a string without a UTF-8 form is refused", () => {
  refuses("value", () => build("sensor_frame", { frame_id: "a\ud800" }));
  refuses("value", () => build("sensor_frame", { channels: { "\udfff": {} } }));
  assert.match(build("sensor_frame", { frame_id: "😀\ufeff" }), /"frame_id":"😀\ufeff"/);
});

test("a stimulus frame inside a request takes what it is not given from the request, and must fit it", () => {
  assert.match(
    build("run_request", { session_id: "s", ncp_version: "0.6", duration_ms: 1, stimulus: { t: 1 } }),
    /"stimulus":\{"ncp_version":"0\.6","kind":"stimulus_frame","session_id":"s","t":1,"values":\{\}\}/,
  );
  build("step_request", { session_id: "s", stimulus: create("stimulus_frame", { session_id: "s" }) });
  refuses("value", () => build("step_request", { session_id: "s", stimulus: { session_id: "other" } }));
  refuses("value", () => build("step_request", { session_id: "s", stimulus: { ncp_version: "0.4" } }));
  refuses("kind", () => build("step_request", { session_id: "s", stimulus: { kind: "sensor_frame" } }));
});

test("an error frame has its kind, its error, and a session only if there is one", () => {
  assert.equal(build("error", { error: "no" }), '{"kind":"error","error":"no"}');
  assert.equal(build("error", { error: "no", session_id: "s" }), '{"kind":"error","error":"no","session_id":"s"}');
});

test("the types of the messages say what the tables say", () => {
  // These lines are checked by the compiler.
  const command: { mode: "init" | "active" | "hold" | "estop"; horizon_dt_ms: number | null } = create(
    "command_frame",
    { mode: "estop" },
  );
  const pinned: false = create("observation_frame", { session_id: "s" }).calibrated_posterior;
  // @ts-expect-error `session_id` is required.
  refuses("missing", () => create("close_session", {}));
  // @ts-expect-error `active` is spelled so.
  create("command_frame", { mode: "Active" });
  // @ts-expect-error `seq` is a number.
  create("sensor_frame", { seq: "1" });
  assert.equal(command.mode, "estop");
  assert.equal(pinned, false);
});
