/**
 * Requests, and the kind of message that answers each (chapter 4).
 *
 * @module
 */

import type { CloseSession, Kind, Messages, OpenSession, RunRequest, StepRequest } from "./messages.js";

/** A request on the control plane. */
export type Request = OpenSession | StepRequest | RunRequest | CloseSession;

/** The kind of a request. */
export type RequestKind = Request["kind"];

/** The kind that answers each kind of request. [NCP-SESS-001] */
export const REPLIES = {
  open_session: "session_opened",
  step_request: "observation_frame",
  run_request: "observation_frame",
  close_session: "session_closed",
} as const satisfies Record<RequestKind, Kind>;

/** The reply to a request of this type. */
export type ReplyTo<R extends Request> = Messages[(typeof REPLIES)[R["kind"]]];

/** Whether a kind is that of a request. */
export function isRequestKind(kind: string): kind is RequestKind {
  return Object.hasOwn(REPLIES, kind);
}
