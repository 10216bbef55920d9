/**
 * The program that puts this library under test: it speaks the peer protocol on standard input and
 * output, and does nothing that the library does not do.
 *
 * @module
 */

import { readFileSync } from "node:fs";
import { TRACES } from "./adapter-traces.js";
import {
  bytesIn,
  bytesOut,
  columnIn,
  columnOut,
  doubleIn,
  doubleOut,
  fieldsIn,
  frameIn,
  i64In,
  isObject,
  kindIn,
  listIn,
  messageOf,
  Refusal,
  refusalOut,
  strictIn,
  textIn,
  textOrNullIn,
  type Args,
  type Call,
  type Json,
} from "./adapter-values.js";
import { decodeBlock, encodeBlock } from "./bulk.js";
import { contractStatus, negotiate, verifyContract } from "./contract.js";
import { decodeAny } from "./decode.js";
import { create, encode, normalise } from "./encode.js";
import { NCP_CONTRACT_HASH, NCP_VERSION } from "./identity.js";
import { Keys, matches } from "./keys.js";
import { TABLES, type Input, type Kind } from "./messages.js";
import { pack, unpack } from "./observation.js";
import { PLANES, type Plane } from "./planes.js";
import { checkReply } from "./reply.js";
import { isRequestKind, type Request, type RequestKind } from "./requests.js";
import { checkVersion } from "./version.js";

// --- the calls, in the order of the protocol's page ----------------------------------------------

const CALLS: ReadonlyMap<string, Call> = new Map<string, Call>([
  [
    "describe",
    () => ({
      name: "typescript",
      version: packageVersion(),
      language: "TypeScript",
      wire_version: NCP_VERSION,
      contract_hash: NCP_CONTRACT_HASH,
      roles: ["commander", "body", "server", "observer"],
      reference_networks: true,
    }),
  ],
  [
    "decode",
    (args) => {
      const frame = frameIn(args);
      return { text: normalise(kindIn(args), frame, strictIn(args)) };
    },
  ],
  [
    "encode",
    (args) => {
      const kind = kindIn(args);
      const fields = fieldsIn(TABLES[kind], args["fields"] ?? {});
      return { text: encode(create(kind, fields as Input<Kind>)) };
    },
  ],
  ["version.check", (args) => ({ compatible: checkVersion(textIn(args, "version"), args["strict"] === true) })],
  ["contract.status", (args) => ({ status: contractStatus(textOrNullIn(args, "peer_hash")) })],
  [
    "contract.verify",
    (args) => {
      verifyContract(textOrNullIn(args, "peer_hash"));
      return {};
    },
  ],
  ["negotiate", (args) => ({ contract: negotiate(textIn(args, "version"), textOrNullIn(args, "contract_hash")) })],
  ["key.build", (args) => ({ key: buildKey(args) })],
  ["key.match", (args) => ({ matches: matches(textIn(args, "pattern"), textIn(args, "key")) })],
  [
    "plane.qos",
    (args) => {
      const plane = textIn(args, "plane");
      if (!Object.hasOwn(PLANES, plane)) throw new Refusal("invalid", `there is no plane ${plane}`);
      return { ...PLANES[plane as Plane] };
    },
  ],
  ["bulk.decode", (args) => ({ columns: decodeBlock(bytesIn(textIn(args, "block"))).map(columnOut) })],
  ["bulk.encode", (args) => ({ block: bytesOut(encodeBlock(listIn(args, "columns").map(columnIn))) })],
  [
    "observation.pack",
    (args) => {
      const times = Float64Array.from(listIn(args, "times"), doubleIn);
      const values = Float64Array.from(listIn(args, "values"), doubleIn);
      const senders = BigInt64Array.from(listIn(args, "senders"), i64In);
      return { block: bytesOut(pack({ times, values, senders })) };
    },
  ],
  [
    "observation.unpack",
    (args) => {
      const { times, values, senders } = unpack(bytesIn(textIn(args, "block")));
      return {
        times: Array.from(times, doubleOut),
        values: Array.from(values, doubleOut),
        senders: Array.from(senders, String),
      };
    },
  ],
  [
    "reply.check",
    (args) => {
      const request = decodeAny(textIn(args, "request"));
      if (!isRequestKind(request.kind)) throw new Refusal("kind", `${request.kind} is not a request`);
      checkReply(request as Request, textIn(args, "reply"), strictIn(args));
      return {};
    },
  ],
  ...TRACES,
]);

function buildKey(args: Args): string {
  const keys = new Keys(textOrNullIn(args, "realm"));
  const key = textIn(args, "key");
  switch (key) {
    case "rpc": {
      const verb = textOrNullIn(args, "verb");
      return verb === null ? keys.rpc() : keys.rpcVerb(verb as RequestKind);
    }
    case "sensor":
      return keys.sensor(textIn(args, "session"), textOrNullIn(args, "name"));
    case "command":
      return keys.command(textIn(args, "session"), textOrNullIn(args, "name"));
    case "observation":
      return keys.observation(textIn(args, "session"));
    case "sensor_glob":
      return keys.sensorGlob(textIn(args, "session"));
    case "command_glob":
      return keys.commandGlob(textIn(args, "session"));
    case "session_glob":
      return keys.sessionGlob(textIn(args, "session"));
    case "fleet_glob":
      return keys.fleetGlob();
    default:
      throw new Refusal("invalid", `there is no key ${key}`);
  }
}

// --- the conversation ----------------------------------------------------------------------------

function packageVersion(): string {
  const manifest = JSON.parse(readFileSync(new URL("../package.json", import.meta.url), "utf8")) as { version: string };
  return manifest.version;
}

/** The answer to one line, or `undefined` for a line that is no request. */
function answer(line: Buffer): string | undefined {
  const request = requestIn(line);
  if (request === undefined) return undefined;
  const { id = null, call, args } = request;
  try {
    const does = CALLS.get(String(call));
    const outcome = does === undefined ? { unsupported: true } : { result: does(isObject(args) ? args : {}) };
    return JSON.stringify({ id, ...outcome });
  } catch (error) {
    return JSON.stringify({ id, error: refusalOut(error) });
  }
}

function requestIn(line: Buffer): Args | undefined {
  try {
    const request = JSON.parse(line.toString("utf8")) as Json;
    if (isObject(request)) return request;
    process.stderr.write("a line is not an object\n");
  } catch (error) {
    process.stderr.write(`a line is not JSON: ${messageOf(error)}\n`);
  }
  return undefined;
}

const LINE_FEED = 0x0a;
/** Answers are written together until they have this many characters. */
const BATCH = 1 << 18;

/** The parts of a line whose end has not come yet. They are joined once, so that a long line stays linear. */
let begun: Buffer[] = [];
let answers: string[] = [];
let waiting = 0;

function take(chunk: Buffer): void {
  let from = 0;
  for (let end = chunk.indexOf(LINE_FEED); end >= 0; end = chunk.indexOf(LINE_FEED, from)) {
    const rest = chunk.subarray(from, end);
    const line = begun.length === 0 ? rest : Buffer.concat([...begun, rest]);
    begun = [];
    takeLine(line);
    from = end + 1;
  }
  if (from < chunk.length) begun.push(chunk.subarray(from));
  flush();
}

function takeLine(line: Buffer): void {
  if (line.length === 0) return;
  const text = answer(line);
  if (text === undefined) return;
  answers.push(text, "\n");
  waiting += text.length;
  if (waiting > BATCH) flush();
}

function flush(): void {
  if (answers.length > 0) process.stdout.write(answers.join(""));
  answers = [];
  waiting = 0;
}

process.stdin.on("data", take);
process.stdin.on("end", () => {
  // A last line may lack its line feed.
  take(Buffer.from("\n"));
});
// Who no longer reads wants no more answers.
process.stdout.on("error", () => process.exit(0));
