import assert from "node:assert/strict";
import { test } from "node:test";
import {
  ActionBuffer,
  checkReply,
  create,
  decode,
  decodeAny,
  encode,
  Keys,
  type Kind,
  KINDS,
  NCP_VERSION,
  ReferenceBackend,
  type RequestKind,
  SessionService,
} from "@ncp-conformance/peer";
import { moving, refuses } from "./support.js";

const HEADS: Readonly<Record<Kind, object>> = {
  open_session: { session_id: "s", network: {} },
  session_opened: { session_id: "s" },
  stimulus_frame: { session_id: "s" },
  step_request: { session_id: "s", stimulus: {} },
  run_request: { session_id: "s", duration_ms: 1 },
  observation_frame: { session_id: "s" },
  close_session: { session_id: "s" },
  session_closed: { session_id: "s" },
  capabilities: { controller_id: "c" },
  sensor_frame: {},
  command_frame: { seq: 1 },
  control_status: {},
  link_status: {},
  bulk_observation: {},
  error: { error: "no" },
};

test("a strict receiver asks for a compatible version in every frame, an error frame aside", () => {
  for (const kind of KINDS) {
    const withVersion = (version: object): string => JSON.stringify({ kind, ...version, ...HEADS[kind] });
    decode(kind, withVersion({ ncp_version: NCP_VERSION }), true);
    assert.equal(decodeAny(withVersion({ ncp_version: NCP_VERSION }), true).kind, kind);
    if (kind === "error") {
      decode(kind, withVersion({}), true);
      continue;
    }
    refuses("missing", () => decode(kind, withVersion({}), true));
    for (const ncp_version of ["0.4", "1.0", "", "0.4.0"]) {
      refuses("version", () => decode(kind, withVersion({ ncp_version }), true));
      decode(kind, withVersion({ ncp_version }));
    }
    decode(kind, withVersion({}));
  }
});

test("a strict receiver rejects a command that is not stamped", () => {
  for (const seq of [0, -1]) {
    const frame = encode(moving([1, 0, 0], { seq }));
    refuses("value", () => decode("command_frame", frame, true));
    decode("command_frame", frame);
  }
});

test("a strict plant drops every command whose seq does not rise, an ESTOP aside", () => {
  const plant = (): ActionBuffer => {
    const buffer = new ActionBuffer(true);
    buffer.receive(encode(moving([1, 0, 0], { seq: 5 })), 0);
    assert.notEqual(buffer.active(0), null);
    return buffer;
  };
  for (const [seq, moves] of [
    [4, true],
    [5, true],
    [6, false],
    [0, true],
  ] as const) {
    const buffer = plant();
    buffer.accept(moving([0, 0, 0], { seq, mode: "hold" }), 0);
    assert.equal(buffer.active(0) !== null, moves);
  }
  for (const seq of [0, 4, 6]) {
    const buffer = plant();
    buffer.accept(moving([0, 0, 0], { seq, mode: "estop" }), 0);
    assert.equal(buffer.stopped, true);
  }
  const fresh = new ActionBuffer(true);
  fresh.accept(moving([1, 0, 0], { seq: 0 }), 0);
  assert.equal(fresh.active(0), null);
  // Rejected for its version and its seq, an ESTOP is still one.
  const buffer = plant();
  assert.throws(() => buffer.receive('{"kind":"command_frame","mode":"estop"}', 0));
  assert.equal(buffer.stopped, true);
});

test("a strict server refuses what says no version", () => {
  const service = new SessionService(new ReferenceBackend(), { strict: true });
  const without = (kind: Kind, fields: object): string => JSON.stringify({ kind, session_id: "s", ...fields });
  const network = { ref: "ncp.reference.rate" };
  assert.equal(decode("session_opened", service.handle(without("open_session", { network }))).ok, false);
  const open = create("open_session", { session_id: "s", network });
  checkReply(open, service.handle(encode(open)), true);
  decode("error", service.handle(without("step_request", {})));
  decode("error", service.handle(without("close_session", {})));
  const step = create("step_request", { session_id: "s" });
  assert.equal(checkReply(step, service.handle(encode(step)), true).seq, 1);
  refuses("reply", () => checkReply(step, '{"kind":"observation_frame","session_id":"s"}', true));
  checkReply(step, '{"kind":"observation_frame","session_id":"s"}');
});

test("the strict profile has one control key a verb", () => {
  const keys = new Keys("a/b");
  assert.equal(keys.rpcVerb("step_request"), "a/b/rpc/step_request");
  for (const kind of ["a/b", "", "session_opened", "stimulus_frame", "error"]) {
    refuses("key", () => keys.rpcVerb(kind as never));
  }
});

test("a request that takes another door than its own is not carried out", () => {
  const service = new SessionService(new ReferenceBackend(), { strict: true });
  const network = { ref: "ncp.reference.rate" };
  const open = encode(create("open_session", { session_id: "s", network }));
  const close = encode(create("close_session", { session_id: "s" }));
  const kindAt = (frame: string, verb: RequestKind): string => decodeAny(service.handle(frame, verb)).kind;
  assert.equal(kindAt(open, "step_request"), "error");
  assert.equal(kindAt(open, "open_session"), "session_opened");
  assert.equal(kindAt(close, "step_request"), "error");
  // Had it been carried out, there would be nothing left to close.
  assert.equal(decode("session_closed", service.handle(close, "close_session")).ok, true);
});
