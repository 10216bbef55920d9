import assert from "node:assert/strict";
import { test } from "node:test";
import {
  checkReply,
  create,
  DecodeError,
  NCP_VERSION,
  REPLIES,
  ReplyError,
  type Request,
  VersionError,
} from "@ncp-conformance/peer";

const REQUESTS: readonly Request[] = [
  create("open_session", { session_id: "s", network: {} }),
  create("step_request", { session_id: "s" }),
  create("run_request", { session_id: "s", duration_ms: 1 }),
  create("close_session", { session_id: "s" }),
];

function isRefused(request: Request, reply: unknown): ReplyError {
  const frame = typeof reply === "string" ? reply : JSON.stringify(reply);
  try {
    checkReply(request, frame);
  } catch (error) {
    assert.ok(error instanceof ReplyError, `not a ReplyError: ${String(error)}`);
    return error;
  }
  throw new assert.AssertionError({ message: `accepted: ${frame}` });
}

test("a reply that fits is accepted, with or without a version and with more members", () => {
  for (const request of REQUESTS) {
    const kind = REPLIES[request.kind];
    for (const more of [{}, { ncp_version: NCP_VERSION }, { ncp_version: `0${NCP_VERSION}` }, { ok: true }, { extra: [] }]) {
      assert.equal(checkReply(request, JSON.stringify({ kind, session_id: "s", ...more })).kind, kind);
    }
  }
});

test("a reply of another kind is rejected", () => {
  for (const request of REQUESTS) {
    for (const kind of [
      "session_opened",
      "observation_frame",
      "session_closed",
      "open_session",
      "command_frame",
      "nothing",
    ]) {
      if (kind !== REPLIES[request.kind]) isRefused(request, { kind, session_id: "s" });
    }
  }
});

test("a reply for another session is rejected", () => {
  for (const request of REQUESTS) isRefused(request, { kind: REPLIES[request.kind], session_id: "S" });
});

test("a reply of an incompatible or malformed version is rejected", () => {
  for (const request of REQUESTS) {
    isRefused(request, { kind: REPLIES[request.kind], session_id: "s", ncp_version: "0.4" });
    const error = isRefused(request, { kind: REPLIES[request.kind], session_id: "s", ncp_version: "0.4.0" });
    assert.ok(error.cause instanceof VersionError);
  }
});

test("a reply that reports a failure is an error with its reason", () => {
  assert.equal(
    isRefused(REQUESTS[0]!, { kind: "session_opened", session_id: "s", ok: false, error: "no such network" }).message,
    "no such network",
  );
  isRefused(REQUESTS[0]!, { kind: "session_opened", session_id: "s", ok: false });
  isRefused(REQUESTS[3]!, { kind: "session_closed", session_id: "s", ok: false });
});

test("an error frame is an error, whatever session it names", () => {
  for (const request of REQUESTS) {
    assert.equal(isRefused(request, { kind: "error", error: "unknown session" }).message, "unknown session");
    isRefused(request, { kind: "error", error: "x", session_id: "s" });
    isRefused(request, { kind: "error", error: "x", session_id: "other" });
    isRefused(request, { kind: "error" });
  }
});

test("a reply that cannot be decoded is rejected, and the error says why", () => {
  for (const request of REQUESTS) {
    for (const reply of [
      "",
      "null",
      "[]",
      "{}",
      '{"kind":1}',
      `{"kind":"${REPLIES[request.kind]}"}`,
      `{"kind":"${REPLIES[request.kind]}","session_id":"s","session_id":"s"}`,
    ]) {
      assert.ok(isRefused(request, reply).cause instanceof DecodeError);
    }
  }
  isRefused(REQUESTS[1]!, { kind: "observation_frame", session_id: "s", calibrated_posterior: true });
  isRefused(REQUESTS[1]!, { kind: "observation_frame", session_id: "s", is_simulation_output: false });
});
