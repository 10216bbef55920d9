/**
 * What a client accepts as the reply to its request (chapter 4).
 *
 * @module
 */

import { decode, kindOf } from "./decode.js";
import { NcpError, NcpServerError, ReplyError } from "./errors.js";
import { REPLIES, type ReplyTo, type Request } from "./requests.js";
import { checkVersion } from "./version.js";

/**
 * Reads the reply to a request and accepts it only if it answers that request and reports no failure.
 *
 * @param request - the request that was sent
 * @param reply - the frame that came back
 * @param strict - whether the strict profile holds: the reply must say a version
 * @throws {@link ReplyError} when the reply is not one to go on with; its `cause` is the deeper error, if any.
 *   A {@link NcpServerError} when it answers the request, and says that it failed.
 */
export function checkReply<R extends Request>(request: R, reply: string | Uint8Array, strict = false): ReplyTo<R> {
  const message = readReply(request, reply, strict);
  if (message.session_id !== request.session_id) {
    throw new ReplyError(`the reply is for the session ${JSON.stringify(message.session_id)}`); // [NCP-SESS-002]
  }
  refusing("the reply's version is refused", () => checkVersion(message.ncp_version, true)); // [NCP-SESS-003]
  if ("ok" in message && !message.ok) {
    const reason = message.kind === "session_opened" ? message.error : null;
    throw new NcpServerError(reason ?? `the server reports that ${request.kind} failed`); // [NCP-SESS-004]
  }
  return message as ReplyTo<R>; // [NCP-SESS-007]
}

function readReply(request: Request, reply: string | Uint8Array, strict: boolean): ReplyTo<Request> {
  return refusing("the reply is rejected", () => {
    if (kindOf(reply) === "error") throw new NcpServerError(decode("error", reply).error); // [NCP-SESS-005] [NCP-WIRE-100]
    return decode(REPLIES[request.kind], reply, strict); // [NCP-SESS-001] [NCP-SESS-006]
  });
}

/** Runs a check; what it refuses is refused as a reply. */
function refusing<T>(what: string, check: () => T): T {
  try {
    return check();
  } catch (error) {
    if (!(error instanceof NcpError) || error instanceof ReplyError) throw error;
    throw new ReplyError(`${what}: ${error.message}`, { cause: error });
  }
}
