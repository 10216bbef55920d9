import assert from "node:assert/strict";
import { test } from "node:test";
import {
  decode,
  decodeAny,
  encode,
  isKind,
  type Kind,
  kindOf,
  KINDS,
  NCP_CONTRACT_HASH,
  NCP_VERSION,
  normalise,
  plain,
} from "@ncp-conformance/peer";
import { defaultsOf, refuses, rejects } from "./support.js";

const OBSERVED = '"kind":"observation_frame","session_id":"a"';
const OPENED = '"kind":"session_opened","session_id":"a"';

/** The smallest frame of each kind. */
const SMALLEST: Readonly<Record<Kind, Readonly<Record<string, unknown>>>> = {
  open_session: { kind: "open_session", session_id: "a", network: {} },
  session_opened: { kind: "session_opened", session_id: "a" },
  stimulus_frame: { kind: "stimulus_frame", session_id: "a" },
  step_request: { kind: "step_request", session_id: "a" },
  run_request: { kind: "run_request", session_id: "a", duration_ms: 1 },
  observation_frame: { kind: "observation_frame", session_id: "a" },
  close_session: { kind: "close_session", session_id: "a" },
  session_closed: { kind: "session_closed", session_id: "a" },
  capabilities: { kind: "capabilities", controller_id: "" },
  sensor_frame: { kind: "sensor_frame" },
  command_frame: { kind: "command_frame" },
  control_status: { kind: "control_status" },
  link_status: { kind: "link_status" },
  bulk_observation: { kind: "bulk_observation" },
  error: { kind: "error", error: "" },
};

test("the smallest frame of each kind is read, and each of its members is required", () => {
  for (const kind of KINDS) {
    const smallest = SMALLEST[kind];
    assert.equal(decode(kind, JSON.stringify(smallest)).kind, kind);
    for (const name of Object.keys(smallest)) {
      const { [name]: _, ...rest } = smallest;
      rejects(kind, JSON.stringify(rest), name === "kind" ? "kind" : "missing");
      rejects(kind, JSON.stringify({ ...smallest, [name]: null }), "type");
    }
  }
});

test("an absent field reads as its default", () => {
  const command = decode("command_frame", '{"kind":"command_frame"}');
  assert.deepEqual(plain(command), defaultsOf("CommandFrame"));
  assert.deepEqual([command.frame_id, command.ttl_ms, command.mode], ["world", 200, "hold"]);
  assert.equal(decode("control_status", '{"kind":"control_status"}').mode, "init");
  assert.equal(decode("link_status", '{"kind":"link_status"}').last_seq, -1);
});

test("an absent contract hash stays absent", () => {
  assert.equal(decode("open_session", JSON.stringify(SMALLEST.open_session)).contract_hash, null);
  assert.equal(decode("session_opened", `{${OPENED}}`).contract_hash, null);
  assert.equal(
    decode("session_opened", `{${OPENED},"contract_hash":"${NCP_CONTRACT_HASH}"}`).contract_hash,
    NCP_CONTRACT_HASH,
  );
});

test("null is absent in an optional field and of the wrong type in any other", () => {
  assert.equal(decode("command_frame", '{"kind":"command_frame","horizon_dt_ms":null}').horizon_dt_ms, null);
  assert.equal(decode("step_request", '{"kind":"step_request","session_id":"a","stimulus":null}').stimulus, null);
  for (const name of ["ncp_version", "seq", "t", "frame_id", "mode", "ttl_ms", "channels", "horizon"]) {
    rejects("command_frame", `{"kind":"command_frame","${name}":null}`, "type");
  }
  rejects("command_frame", '{"kind":"command_frame","channels":{"a":null}}', "type");
  rejects("command_frame", '{"kind":"command_frame","channels":{"a":{"data":null}}}', "type");
  rejects("command_frame", '{"kind":"command_frame","channels":{"a":{"data":[null]}}}', "type");
  rejects("command_frame", '{"kind":"command_frame","horizon":[null]}', "type");
});

test("a field of another JSON type is rejected, at the top and within", () => {
  const values = { string: '"x"', number: "1", boolean: "true", array: "[]", object: "{}" };
  const fields: [string, keyof typeof values][] = [
    ["ncp_version", "string"],
    ["seq", "number"],
    ["t", "number"],
    ["frame_id", "string"],
    ["mode", "string"],
    ["ttl_ms", "number"],
    ["channels", "object"],
    ["horizon", "array"],
    ["horizon_dt_ms", "number"],
  ];
  for (const [name, right] of fields) {
    for (const [type, value] of Object.entries(values)) {
      const frame = `{"kind":"command_frame","${name}":${value}}`;
      if (type === right) decode("command_frame", frame);
      else rejects("command_frame", frame, "type");
    }
  }
  rejects("command_frame", '{"kind":"command_frame","horizon":[[]]}', "type");
  rejects("command_frame", '{"kind":"command_frame","horizon":[{"a":{"data":["1"]}}]}', "type");
  rejects("observation_frame", `{${OBSERVED},"records":{"p":{"senders":[1,true]}}}`, "type");
  rejects("open_session", '{"kind":"open_session","session_id":"a","network":{"params":{"a":"1"}}}', "type");
  rejects("error", '{"kind":"error","error":{}}', "type");
  rejects("error", '{"kind":"error","error":"x","session_id":1}', "type");
});

test("members that the tables do not list change nothing", () => {
  const plain = decode("command_frame", '{"kind":"command_frame","channels":{"a":{"data":[1]}}}');
  const more = decode(
    "command_frame",
    '{"x":{"kind":1,"seq":[]},"kind":"command_frame","Seq":"x","channels":{"a":{"Data":null,"data":[1],"":[{}]}},"__proto__":{"seq":7},"toString":1}',
  );
  assert.deepEqual(more, plain);
  assert.equal(normalise("command_frame", '{"kind":"command_frame","SEQ":1}').includes("SEQ"), false);
});

test("a frame of another kind is rejected, and an unknown kind by every reader", () => {
  for (const kind of KINDS) {
    const other = kind === "sensor_frame" ? "command_frame" : "sensor_frame";
    rejects(kind, JSON.stringify(SMALLEST[other]), "kind");
    for (const name of ["Sensor_frame", "sensor_frame ", "", "SetpointStep", "constructor", "__proto__"]) {
      rejects(kind, JSON.stringify({ ...SMALLEST[kind], kind: name }), "kind");
      refuses("kind", () => decodeAny(JSON.stringify({ kind: name })));
      assert.equal(isKind(name), false);
    }
    assert.equal(decodeAny(JSON.stringify(SMALLEST[kind])).kind, kind);
    assert.equal(kindOf(JSON.stringify(SMALLEST[kind])), kind);
  }
  refuses("kind", () => decodeAny("{}"));
});

test("a required session id must be a segment, and an optional one may be anything", () => {
  for (const id of ["", "a/b", "a b", "*", "@a", "..", "a\u0001", "x".repeat(257)]) {
    for (const kind of [
      "open_session",
      "session_opened",
      "stimulus_frame",
      "step_request",
      "run_request",
      "observation_frame",
      "close_session",
      "session_closed",
    ] as const) {
      rejects(kind, JSON.stringify({ ...SMALLEST[kind], session_id: id }), "value");
    }
    decode("link_status", JSON.stringify({ kind: "link_status", session_id: id }));
    decode("error", JSON.stringify({ kind: "error", error: "x", session_id: id }));
  }
});

test("decoding does not judge the version", () => {
  for (const version of ["0.4", "9", "", "not a version"]) {
    assert.equal(
      decode("sensor_frame", JSON.stringify({ kind: "sensor_frame", ncp_version: version })).ncp_version,
      version,
    );
  }
});

test("an unknown mode holds, whatever its letters", () => {
  for (const mode of ["init", "active", "hold", "estop"]) {
    assert.equal(decode("command_frame", JSON.stringify({ kind: "command_frame", mode })).mode, mode);
  }
  for (const mode of ["Active", "ACTIVE", "active ", "", "dance", "constructor"]) {
    assert.equal(decode("command_frame", JSON.stringify({ kind: "command_frame", mode })).mode, "hold");
    assert.equal(decode("control_status", JSON.stringify({ kind: "control_status", mode })).mode, "hold");
  }
  assert.equal(decode("command_frame", '{"kind":"command_frame","mode":"\\u0061ctive"}').mode, "active");
});

test("an unknown string of a descriptive enum is kept and written unchanged", () => {
  const frame = decode("observation_frame", `{${OBSERVED},"records":{"p":{"observable":"Ca2+ "}}}`);
  assert.equal(frame.records.get("p")!.observable, "Ca2+ ");
  assert.match(encode(frame), /"observable":"Ca2\+ "/);
  assert.equal(decode("capabilities", '{"kind":"capabilities","controller_id":"c","role":""}').role, "");
});

test("an unknown simulation mode is rejected", () => {
  for (const mode of ["Stream", "", "live"]) {
    rejects("open_session", JSON.stringify({ ...SMALLEST.open_session, sim: { mode } }), "value");
  }
  assert.equal(
    decode("open_session", JSON.stringify({ ...SMALLEST.open_session, sim: { mode: "batch" } })).sim.mode,
    "batch",
  );
});

test("a stimulus frame inside a request takes from it what it leaves out, in any order", () => {
  for (const [kind, rest] of [
    ["step_request", ""],
    ["run_request", ',"duration_ms":5'],
  ] as const) {
    const frame = decode(
      kind,
      `{"stimulus":{"t":2,"values":{"a":{"data":[1]}}},"ncp_version":"0.7","session_id":"q","kind":"${kind}"${rest}}`,
    );
    assert.equal(frame.stimulus!.kind, "stimulus_frame");
    assert.equal(frame.stimulus!.session_id, "q");
    assert.equal(frame.stimulus!.ncp_version, "0.7");
    assert.equal(frame.stimulus!.t, 2);
    assert.equal(decode(kind, `{"stimulus":{},"session_id":"q","kind":"${kind}"${rest}}`).stimulus!.ncp_version, NCP_VERSION);
  }
});

test("a stimulus frame inside a request must fit the request", () => {
  const step = (stimulus: object, request: object = {}): string =>
    JSON.stringify({ kind: "step_request", session_id: "a", ...request, stimulus });
  decode("step_request", step({ kind: "stimulus_frame", session_id: "a", ncp_version: NCP_VERSION }));
  rejects("step_request", step({ kind: "step_request" }), "kind");
  rejects("step_request", step({ session_id: "b" }), "value");
  rejects("step_request", step({ session_id: "" }), "value");
  rejects("step_request", step({ ncp_version: "0.4" }), "value");
  rejects("step_request", step({ ncp_version: NCP_VERSION }, { ncp_version: "0.4" }), "value");
  rejects("step_request", step({ kind: null }), "type");
  rejects("step_request", step({ session_id: null }), "type");
});

test("the pins of an observation frame hold or the frame is rejected", () => {
  decode("observation_frame", `{${OBSERVED},"calibrated_posterior":false,"is_simulation_output":true}`);
  for (const value of ["true", "null", "0", '"false"', "[]", "{}", '""']) {
    rejects("observation_frame", `{${OBSERVED},"calibrated_posterior":${value}}`, "provenance");
    rejects("session_opened", `{${OPENED},"provenance":{"calibrated_posterior":${value}}}`, "provenance");
  }
  for (const value of ["false", "null", "1", '"true"', "[true]"]) {
    rejects("observation_frame", `{${OBSERVED},"is_simulation_output":${value}}`, "provenance");
    rejects("session_opened", `{${OPENED},"provenance":{"is_simulation_output":${value}}}`, "provenance");
  }
});

test("an absent pin reads as pinned, and no provenance has no pins", () => {
  const frame = decode("observation_frame", `{${OBSERVED}}`);
  assert.equal(frame.calibrated_posterior, false);
  assert.equal(frame.is_simulation_output, true);
  assert.equal(decode("session_opened", `{${OPENED},"provenance":null}`).provenance, null);
  assert.equal(decode("session_opened", `{${OPENED},"provenance":{}}`).provenance!.is_simulation_output, true);
});

test("an error says where in the frame it lies", () => {
  assert.throws(() => decode("command_frame", '{"kind":"command_frame","horizon":[{},{"a/b":{"data":[1,2,"x"]}}]}'), {
    name: "DecodeError",
    code: "type",
    path: "/horizon/1/a~1b/data/2",
  });
});
