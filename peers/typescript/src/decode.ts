/**
 * From bytes to messages. There is no other way to a decoded message, so none passes by the checks.
 * [NCP-PROV-006]
 *
 * @module
 */

import { DecodeError, VersionError } from "./errors.js";
import { frameBytesOf, JsonReader } from "./json.js";
import { isSegment } from "./keys.js";
import { ENTRIES, frameBytes, OBSERVATION_FRAME_BYTES } from "./limits.js";
import {
  isKind,
  TABLES,
  type Kind,
  type Message,
  type Messages,
  type RunRequest,
  type StepRequest,
} from "./messages.js";
import type { Names } from "./names.js";
import type { NamedField, Shape, Table } from "./table.js";
import { checkVersion } from "./version.js";

/**
 * Reads a frame of one kind.
 *
 * @param kind - the kind that is expected
 * @param frame - the bytes as they came, or their text
 * @param strict - whether the strict profile holds, by agreement with the sender
 * @returns the complete message: absent fields have their defaults, unset optional ones are `null`
 * @throws {@link DecodeError} when the frame is rejected
 *
 * Unless `strict`, the value of `ncp_version` is not judged, which is the version guard's matter. [NCP-WIRE-033]
 *
 * Rules: NCP-WIRE-001 to NCP-WIRE-070, NCP-PROV-001 to NCP-PROV-006, NCP-STRICT-002 to NCP-STRICT-004.
 */
export function decode<K extends Kind>(kind: K, frame: string | Uint8Array, strict = false): Messages[K] {
  if (!isKind(kind)) throw new DecodeError("kind", "the kind that is expected is not a known one");
  const bytes = frameBytesOf(frame, frameBytes(kind)); // [NCP-WIRE-060] [NCP-WIRE-061] [NCP-WIRE-062] [NCP-WIRE-063]
  const reader = new JsonReader(bytes);
  beginObject(reader);
  const message = readMessage(reader, TABLES[kind], strict) as unknown as Messages[K];
  reader.finish();
  if (kind === "step_request" || kind === "run_request") settleStimulus(message as StepRequest | RunRequest);
  if (strict) checkStrictly(message);
  return message;
}

/**
 * Reads a frame of whichever kind it says that it has.
 *
 * @param strict - as of {@link decode}
 * @throws {@link DecodeError} when the frame is rejected
 */
export function decodeAny(frame: string | Uint8Array, strict = false): Message {
  const bytes = frameBytesOf(frame, OBSERVATION_FRAME_BYTES);
  return decode(kindOf(bytes), bytes, strict);
}

/**
 * The kind that a frame says that it has. The frame is looked at up to its `kind` and not judged.
 *
 * @throws {@link DecodeError} when the frame names no known kind
 */
export function kindOf(frame: string | Uint8Array): Kind {
  const reader = new JsonReader(frameBytesOf(frame, OBSERVATION_FRAME_BYTES));
  beginObject(reader);
  reader.enterObject();
  for (let first = true; ; first = false) {
    const name = reader.nextMember(first);
    if (name === undefined) throw new DecodeError("kind", "the frame has no kind"); // [NCP-WIRE-028]
    if (name !== "kind") {
      reader.skip();
      continue;
    }
    expectType(reader, "string");
    const kind = reader.string();
    if (!isKind(kind)) throw reader.error("kind", `${shown(kind)} is not a known kind`); // [NCP-WIRE-029]
    return kind;
  }
}

function beginObject(reader: JsonReader): void {
  // [NCP-WIRE-003] [NCP-WIRE-006]
  if (reader.peek() !== "object") throw new DecodeError("malformed", "the frame is not an object");
}

/** @param versioned - whether the message must say its version, where the table has a default for it */
function readMessage(reader: JsonReader, table: Table, versioned = false): Record<string, unknown> {
  // Every field is set in its order at once, so that all messages of a table have one hidden class.
  const message: Record<string, unknown> = {};
  for (const { name } of table.fields) message[name] = undefined;
  let seen = 0;
  let unknown: Names | undefined;

  reader.enterObject();
  for (let first = true; ; first = false) {
    const name = reader.nextMember(first);
    if (name === undefined) break;
    const field = table.byName.get(name);
    if (field === undefined) {
      unknown ??= reader.newNames();
      if (!reader.addName(unknown)) throw repeated(reader);
      reader.skip(); // [NCP-WIRE-026]
    } else {
      if ((seen & field.bit) !== 0) throw repeated(reader);
      seen |= field.bit;
      message[name] = readField(reader, field);
    }
  }

  for (const field of table.fields) {
    if ((seen & field.bit) !== 0) continue;
    // [NCP-STRICT-002]
    if (field.required || (versioned && field.name === "ncp_version")) {
      const code = field.shape.is === "kind" ? "kind" : "missing"; // [NCP-WIRE-027] [NCP-WIRE-028]
      throw reader.error(code, `${field.name} is missing`);
    }
    message[field.name] = field.absent(); // [NCP-WIRE-023] [NCP-PROV-005]
  }
  return message;
}

function readField(reader: JsonReader, field: NamedField): unknown {
  if (reader.peek() === "null" && field.optional) {
    reader.null(); // [NCP-WIRE-022]
    return null;
  }
  return readValue(reader, field.shape); // [NCP-WIRE-021]: `null` is of none of the types
}

/** Reads a value of a field, a map or an array: the same rules everywhere. [NCP-WIRE-050] */
function readValue(reader: JsonReader, shape: Shape): unknown {
  switch (shape.is) {
    case "string":
      expectType(reader, "string");
      return reader.string();
    case "integer":
      expectType(reader, "number");
      return reader.integer();
    case "number":
      expectType(reader, "number");
      return reader.number();
    case "boolean":
      expectType(reader, "boolean");
      return reader.boolean();
    case "integers":
    case "numbers":
      expectType(reader, "array");
      return reader.numbers(shape.is === "integers");
    case "segment": {
      expectType(reader, "string");
      const id = reader.string();
      if (!isSegment(id)) throw reader.error("value", `${shown(id)} is not a valid id`); // [NCP-WIRE-031]
      return id;
    }
    case "kind": {
      expectType(reader, "string");
      const kind = reader.string();
      // [NCP-WIRE-029] [NCP-WIRE-030] [NCP-WIRE-036]
      if (kind !== shape.value) throw reader.error("kind", `${shown(kind)} instead of ${shape.value}`);
      return kind;
    }
    case "pin": {
      // [NCP-PROV-001] [NCP-PROV-002] [NCP-PROV-003] [NCP-PROV-004]
      const holds = reader.peek() === "boolean" && reader.boolean() === shape.value;
      if (!holds) throw reader.error("provenance", `the pin is not ${shape.value}`);
      return shape.value;
    }
    case "enum": {
      expectType(reader, "string");
      const word = reader.string();
      if (shape.values.has(word) || shape.unknown === "keep") return word; // [NCP-WIRE-040] [NCP-WIRE-042]
      if (shape.unknown === "hold") return "hold"; // [NCP-WIRE-041]
      throw reader.error("value", `${shown(word)} is not known`); // [NCP-WIRE-044]
    }
    case "list":
      expectType(reader, "array");
      return readList(reader, shape.of);
    case "map":
      expectType(reader, "object");
      return readMap(reader, shape.of);
    case "message":
      expectType(reader, "object");
      return readMessage(reader, shape.table);
  }
}

function readList(reader: JsonReader, of: Shape): unknown[] {
  const items: unknown[] = [];
  reader.enterArray();
  while (reader.nextItem(items.length)) {
    // [NCP-WIRE-067] [NCP-WIRE-068]
    if (items.length === ENTRIES) throw reader.error("limit", `the array has more than ${ENTRIES} items`);
    items.push(readValue(reader, of));
  }
  return items;
}

function readMap(reader: JsonReader, of: Shape): Map<string, unknown> {
  const entries = new Map<string, unknown>();
  reader.enterObject();
  for (let first = true; ; first = false) {
    const name = reader.nextMember(first);
    if (name === undefined) return entries;
    if (entries.has(name)) throw repeated(reader);
    // [NCP-WIRE-066] [NCP-WIRE-068]
    if (entries.size === ENTRIES) throw reader.error("limit", `the map has more than ${ENTRIES} entries`);
    entries.set(name, readValue(reader, of));
  }
}

/** Fills in what a request's stimulus frame leaves out, and holds what it says against the request. */
function settleStimulus(request: StepRequest | RunRequest): void {
  const { stimulus } = request;
  if (stimulus === null) return;
  for (const name of ["ncp_version", "session_id"] as const) {
    const said: string | undefined = stimulus[name];
    // [NCP-WIRE-037] [NCP-WIRE-038]
    if (said !== undefined && said !== request[name]) {
      throw new DecodeError("value", `${shown(said)} is not the request's`, ["stimulus", name]);
    }
    stimulus[name] = request[name]; // [NCP-WIRE-035]
  }
}

/** What the strict profile asks of a frame beyond its version being there. An error frame has none to judge. */
function checkStrictly(message: Message): void {
  if ("ncp_version" in message) {
    try {
      checkVersion(message.ncp_version, true); // [NCP-STRICT-003]
    } catch (error) {
      if (!(error instanceof VersionError)) throw error;
      throw new DecodeError("version", error.message, ["ncp_version"]);
    }
  }
  if (message.kind === "command_frame" && message.seq < 1) {
    throw new DecodeError("value", `the seq ${message.seq} is less than 1`, ["seq"]); // [NCP-STRICT-004]
  }
}

function expectType(reader: JsonReader, type: "string" | "number" | "boolean" | "array" | "object"): void {
  const found = reader.peek();
  if (found !== type) throw reader.error("type", `${type} expected, ${found} found`); // [NCP-WIRE-020]
}

function repeated(reader: JsonReader): DecodeError {
  return reader.error("malformed", "the member is repeated"); // [NCP-WIRE-007]
}

function shown(text: string): string {
  return JSON.stringify(text.length > 40 ? `${text.slice(0, 40)}…` : text);
}
