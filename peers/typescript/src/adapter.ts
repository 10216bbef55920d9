/**
 * The program that puts this library under test: it speaks the peer protocol on standard input and
 * output, and does nothing that the library does not do.
 *
 * @module
 */

import { readFileSync } from "node:fs";
import { decodeBlock, encodeBlock, type Column } from "./bulk.js";
import { contractStatus, NCP_CONTRACT_HASH, negotiate, verifyContract } from "./contract.js";
import { decodeAny } from "./decode.js";
import { create, encode, normalise } from "./encode.js";
import { NcpError } from "./errors.js";
import { Keys, matches } from "./keys.js";
import { isKind, TABLES, type Input, type Kind } from "./messages.js";
import { pack, unpack } from "./observation.js";
import { PLANES, type Plane } from "./planes.js";
import { checkReply, isRequestKind, type Request } from "./reply.js";
import type { Shape, Table } from "./table.js";
import { checkVersion, NCP_VERSION } from "./version.js";

type Json = null | boolean | number | string | Json[] | { [name: string]: Json };
type Args = Readonly<Record<string, Json>>;
type Call = (args: Args) => Json;

/** A request that this program refuses itself: what it asks for has no form in the library. */
class Refusal extends Error {
  readonly code: string;

  constructor(code: string, message: string) {
    super(message);
    this.code = code;
  }
}

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
    }),
  ],
  [
    "decode",
    (args) => {
      const frame = typeof args["base64"] === "string" ? bytesIn(args["base64"]) : textIn(args, "text");
      return { text: normalise(kindIn(args), frame) };
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
      checkReply(request as Request, textIn(args, "reply"));
      return {};
    },
  ],
]);

function buildKey(args: Args): string {
  const keys = new Keys(textOrNullIn(args, "realm"));
  const key = textIn(args, "key");
  switch (key) {
    case "rpc":
      return keys.rpc();
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

// --- values: what arguments and results stand for ------------------------------------------------

const SPECIAL_DOUBLES: ReadonlyMap<Json, number> = new Map([
  ["NaN", NaN],
  ["Infinity", Infinity],
  ["-Infinity", -Infinity],
  ["-0", -0],
]);

function doubleIn(value: Json): number {
  const double = typeof value === "number" ? value : SPECIAL_DOUBLES.get(value);
  if (double === undefined) throw new Refusal("type", "a double is expected");
  return double;
}

function doubleOut(value: number): number | string {
  if (Object.is(value, -0)) return "-0";
  return Number.isFinite(value) ? value : String(value);
}

function i32In(value: Json): number {
  if (typeof value !== "number" || (value | 0) !== value) throw new Refusal("type", "an i32 is expected");
  return value;
}

function i64In(value: Json): bigint {
  const integer = typeof value === "string" && /^-?[0-9]+$/.test(value) ? BigInt(value) : undefined;
  if (integer === undefined || BigInt.asIntN(64, integer) !== integer) throw new Refusal("type", "an i64 is expected");
  return integer;
}

function bytesIn(base64: string): Uint8Array {
  return Buffer.from(base64, "base64");
}

function bytesOut(bytes: Uint8Array): string {
  return Buffer.from(bytes.buffer, bytes.byteOffset, bytes.byteLength).toString("base64");
}

function columnIn(column: Json): Column {
  if (!isObject(column)) throw new Refusal("type", "a column is an object");
  const name = textIn(column, "name");
  const dtype = textIn(column, "dtype");
  const data = listIn(column, "data");
  switch (dtype) {
    case "f32":
      return { name, dtype, data: Float32Array.from(data, doubleIn) };
    case "f64":
      return { name, dtype, data: Float64Array.from(data, doubleIn) };
    case "i32":
      return { name, dtype, data: Int32Array.from(data, i32In) };
    case "i64":
      return { name, dtype, data: BigInt64Array.from(data, i64In) };
    default:
      throw new Refusal("block", `there is no dtype ${dtype}`);
  }
}

function columnOut({ name, dtype, data }: Column): Json {
  const values =
    dtype === "i64" ? Array.from(data, String) : dtype === "i32" ? Array.from(data) : Array.from(data, doubleOut);
  return { name, dtype, data: values };
}

/** The fields to set, with the strings that stand for doubles replaced wherever the tables give a number. */
function fieldsIn(table: Table, fields: Json): Json {
  if (!isObject(fields)) return fields;
  return mapEntries(fields, (name, value) => {
    const field = table.byName.get(name);
    return field === undefined ? value : valueIn(field.shape, value);
  });
}

function valueIn(shape: Shape, value: Json): Json {
  switch (shape.is) {
    case "number":
      return SPECIAL_DOUBLES.get(value) ?? value;
    case "numbers":
      return Array.isArray(value) ? value.map((item) => SPECIAL_DOUBLES.get(item) ?? item) : value;
    case "list":
      return Array.isArray(value) ? value.map((item) => valueIn(shape.of, item)) : value;
    case "map":
      return isObject(value) ? mapEntries(value, (_, item) => valueIn(shape.of, item)) : value;
    case "message":
      return fieldsIn(shape.table, value);
    default:
      return value;
  }
}

/** Unlike an assignment, `Object.fromEntries` keeps an entry of the name `__proto__`. */
function mapEntries(of: Args, each: (name: string, value: Json) => Json): Json {
  return Object.fromEntries(Object.entries(of).map(([name, value]) => [name, each(name, value)]));
}

function kindIn(args: Args): Kind {
  const kind = textIn(args, "kind");
  if (!isKind(kind)) throw new Refusal("kind", `there is no kind ${kind}`);
  return kind;
}

function textIn(args: Args, name: string): string {
  const value = args[name];
  if (typeof value !== "string") throw new Refusal("invalid", `the argument ${name} is not text`);
  return value;
}

function textOrNullIn(args: Args, name: string): string | null {
  return args[name] === null || args[name] === undefined ? null : textIn(args, name);
}

function listIn(args: Args, name: string): Json[] {
  const value = args[name];
  if (!Array.isArray(value)) throw new Refusal("invalid", `the argument ${name} is not an array`);
  return value;
}

function isObject(value: Json | undefined): value is { [name: string]: Json } {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

function packageVersion(): string {
  const manifest = JSON.parse(readFileSync(new URL("../package.json", import.meta.url), "utf8")) as { version: string };
  return manifest.version;
}

// --- the conversation ----------------------------------------------------------------------------

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
    return JSON.stringify({ id, error: { code: codeOf(error), message: messageOf(error) } });
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

/** Why a call failed. What the library does not throw on purpose is a crash, and is reported as one. */
function codeOf(error: unknown): string {
  if (error instanceof NcpError || error instanceof Refusal) return error.code;
  process.stderr.write(`${error instanceof Error ? error.stack : String(error)}\n`);
  return "internal";
}

function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
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
