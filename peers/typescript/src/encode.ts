/**
 * From messages to text. The encoder writes nothing that a receiver would have to reject.
 *
 * @module
 */

import { decode } from "./decode.js";
import { EncodeError, type ErrorCode } from "./errors.js";
import { integerText, itemsText, numberText, stringText } from "./json-writer.js";
import { isSegment } from "./keys.js";
import { ENTRIES, frameBytes } from "./limits.js";
import { isKind, TABLES, type Input, type Kind, type Message, type Messages } from "./messages.js";
import type { Shape, Table } from "./table.js";
import { compareCodePoints, isWellFormed, utf8Length } from "./unicode.js";

/**
 * Builds a complete message. What is not named gets the default of its field; a `CommandFrame` is then
 * `active`, and an `OpenSession` or a `SessionOpened` states this library's contract hash.
 *
 * @param kind - the kind of the message
 * @param fields - the fields to set, named as on the wire; `null` unsets an optional one
 * @throws {@link EncodeError} when a required field is not named, or a field cannot be taken
 *
 * Rules: NCP-WIRE-088 to NCP-WIRE-090.
 */
export function create<K extends Kind>(kind: K, fields: Input<K>): Messages[K] {
  if (!isKind(kind)) throw new EncodeError("kind", "this is not a known kind");
  const message = new Builder().message(TABLES[kind], fields) as unknown as Messages[K];
  if ((message.kind === "step_request" || message.kind === "run_request") && message.stimulus !== null) {
    // A stimulus frame takes from its request what it was not given.
    message.stimulus.ncp_version ??= message.ncp_version;
    message.stimulus.session_id ??= message.session_id;
  }
  return message;
}

/**
 * Writes a message as the text of its frame.
 *
 * @throws {@link EncodeError} when the message holds a number that JSON lacks, or something that every
 * receiver would reject
 *
 * Rules: NCP-WIRE-080 to NCP-WIRE-092, NCP-PROV-007, NCP-PROV-008.
 */
export function encode(message: Message): string {
  const text = write(message);
  const limit = frameBytes(message.kind);
  // A UTF-16 unit takes three bytes at most, so that most texts need no second look.
  if (text.length * 3 > limit && utf8Length(text) > limit) {
    throw new EncodeError("limit", `the frame would have more than ${limit} bytes`); // [NCP-WIRE-091]
  }
  return text;
}

/**
 * Reads a frame of one kind and writes it as this library would have: every field of the tables, in
 * their order, and nothing else. The result may be longer than the frame, and also than a frame may be.
 *
 * @param strict - whether the strict profile holds, by agreement with the sender
 * @throws {@link DecodeError} when the frame is rejected
 */
export function normalise(kind: Kind, frame: string | Uint8Array, strict = false): string {
  return write(decode(kind, frame, strict));
}

function write(message: Message): string {
  if (typeof message !== "object" || message === null || !isKind(message.kind)) {
    throw new EncodeError("kind", "this is not a message");
  }
  const text = new Writer().message(TABLES[message.kind], message);
  if (message.kind === "step_request" || message.kind === "run_request") checkStimulus(message);
  return text;
}

/** Holds a request's stimulus frame against the request, as every receiver does. [NCP-WIRE-091] */
function checkStimulus(request: Messages["step_request" | "run_request"]): void {
  if (request.stimulus === null) return;
  for (const name of ["ncp_version", "session_id"] as const) {
    if (request.stimulus[name] !== request[name]) {
      throw new EncodeError("value", "this is not the request's", ["stimulus", name]);
    }
  }
}

/** Knows where in the message it is. */
class Walker {
  protected readonly path: (string | number)[] = [];

  protected error(code: ErrorCode, message: string): EncodeError {
    return new EncodeError(code, message, this.path);
  }

  protected mistyped(expected: string, found: unknown): EncodeError {
    return this.error("type", `${expected} expected, ${typeName(found)} found`);
  }

  protected within<T>(step: string | number, go: () => T): T {
    this.path.push(step);
    const value = go();
    this.path.pop();
    return value;
  }
}

/** Completes what a program names. It gives fields their form; their values are the writer's matter. */
class Builder extends Walker {
  message(table: Table, input: unknown): Record<string, unknown> {
    if (!isObject(input)) throw this.mistyped(table.name, input);
    for (const name of Object.keys(input)) {
      if (!table.byName.has(name)) throw this.error("value", `${table.name} has no field ${stringText(name)}`);
    }
    const message: Record<string, unknown> = {};
    for (const field of table.fields) {
      const given = Object.hasOwn(input, field.name) ? input[field.name] : undefined;
      message[field.name] = this.within(field.name, () => {
        if (given === undefined) {
          const built = field.built();
          if (built === undefined && field.required) throw this.error("missing", "the field must be named");
          return built;
        }
        return given === null && field.optional ? null : this.value(field.shape, given);
      });
    }
    return message;
  }

  private value(shape: Shape, given: unknown): unknown {
    switch (shape.is) {
      case "message":
        return this.message(shape.table, given);
      case "map":
        return this.map(shape.of, given);
      case "list":
        if (!Array.isArray(given)) throw this.mistyped("array", given);
        return given.map((item, n) => this.within(n, () => this.value(shape.of, item)));
      case "integers":
      case "numbers":
        return given instanceof Float64Array ? given : this.numbers(given);
      default:
        return given;
    }
  }

  private map(of: Shape, given: unknown): Map<string, unknown> {
    if (!isObject(given)) throw this.mistyped("map", given);
    const entries = given instanceof Map ? [...(given as Map<unknown, unknown>)] : Object.entries(given);
    const map = new Map<string, unknown>();
    for (const [name, value] of entries) {
      if (typeof name !== "string") throw this.error("type", "the name of an entry is not a string");
      map.set(
        name,
        this.within(name, () => this.value(of, value)),
      );
    }
    return map;
  }

  private numbers(given: unknown): Float64Array {
    if (!Array.isArray(given) && !ArrayBuffer.isView(given)) throw this.mistyped("array of numbers", given);
    const items = given as unknown as ArrayLike<unknown>;
    const values = new Float64Array(items.length);
    for (let n = 0; n < items.length; n++) {
      const item = items[n];
      if (typeof item !== "number") throw this.within(n, () => this.mistyped("number", item));
      values[n] = item;
    }
    return values;
  }
}

/** Writes a complete message and checks what it writes. */
class Writer extends Walker {
  message(table: Table, message: unknown): string {
    if (!isObject(message)) throw this.mistyped(table.name, message);
    let text = "{";
    // [NCP-WIRE-080] [NCP-WIRE-081]
    for (const field of table.fields) {
      const value = message[field.name];
      if (value === null && field.leftOut) continue; // [NCP-WIRE-102]
      text += text.length > 1 ? `,"${field.name}":` : `"${field.name}":`;
      if (value === null && field.optional) {
        text += "null"; // [NCP-WIRE-082]
        continue;
      }
      this.path.push(field.name);
      text += this.value(field.shape, value);
      this.path.pop();
    }
    return `${text}}`;
  }

  private value(shape: Shape, value: unknown): string {
    switch (shape.is) {
      case "string":
        return this.string(value);
      case "segment":
        // [NCP-WIRE-091]
        if (!isSegment(value as string)) throw this.error("value", "this is not a valid id");
        return this.string(value);
      case "kind":
        if (value !== shape.value) throw this.error("kind", `this is not ${shape.value}`);
        return stringText(shape.value);
      case "enum":
        // [NCP-WIRE-087] Descriptive enums keep unknown strings. [NCP-WIRE-043] [NCP-WIRE-045]
        if (shape.unknown !== "keep" && !shape.values.has(value as string)) {
          throw this.error("value", "this is not one of the enum's strings");
        }
        return this.string(value);
      case "integer":
        return this.integer(value);
      case "number":
        return this.number(value);
      case "boolean":
        if (typeof value !== "boolean") throw this.mistyped("boolean", value);
        return value ? "true" : "false";
      case "pin":
        // [NCP-PROV-007] [NCP-PROV-008]
        if (value !== shape.value) throw this.error("provenance", `the pin is not ${shape.value}`);
        return shape.value ? "true" : "false";
      case "integers":
        return `[${itemsText(this.array(value), (item, n) =>
          Number.isSafeInteger(item) ? integerText(item) : this.within(n, () => this.integer(item)),
        )}]`;
      case "numbers":
        return `[${itemsText(this.array(value), (item, n) =>
          Number.isFinite(item) ? numberText(item) : this.within(n, () => this.number(item)),
        )}]`;
      case "list":
        return this.list(shape.of, value);
      case "map":
        return this.map(shape.of, value);
      case "message":
        return this.message(shape.table, value);
    }
  }

  private string(value: unknown): string {
    if (typeof value !== "string") throw this.mistyped("string", value);
    if (!isWellFormed(value)) throw this.error("value", "a surrogate lacks its partner"); // [NCP-WIRE-092]
    return stringText(value);
  }

  private integer(value: unknown): string {
    if (typeof value !== "number") throw this.mistyped("integer", value);
    if (Number.isSafeInteger(value)) return integerText(value);
    this.checkFinite(value);
    const code = Number.isInteger(value) ? "value" : "type";
    throw this.error(code, `${value} is not an integer within ±(2^53 − 1)`); // [NCP-WIRE-091]
  }

  private number(value: unknown): string {
    if (typeof value !== "number") throw this.mistyped("number", value);
    this.checkFinite(value);
    return numberText(value);
  }

  private checkFinite(value: number): void {
    if (!Number.isFinite(value)) throw this.error("non_finite", `JSON has no ${value}`); // [NCP-WIRE-086]
  }

  private array(value: unknown): Float64Array {
    if (!(value instanceof Float64Array)) throw this.mistyped("Float64Array", value);
    return value;
  }

  private list(of: Shape, value: unknown): string {
    if (!Array.isArray(value)) throw this.mistyped("array", value);
    if (value.length > ENTRIES) throw this.error("limit", `the array has more than ${ENTRIES} items`); // [NCP-WIRE-091]
    return `[${value.map((item, n) => this.within(n, () => this.value(of, item))).join(",")}]`;
  }

  private map(of: Shape, value: unknown): string {
    if (!(value instanceof Map)) throw this.mistyped("Map", value);
    const map = value as Map<unknown, unknown>;
    if (map.size > ENTRIES) throw this.error("limit", `the map has more than ${ENTRIES} entries`); // [NCP-WIRE-091]
    const names = [...map.keys()].map((name) => {
      if (typeof name !== "string") throw this.error("type", "the name of an entry is not a string");
      return name;
    });
    if (names.length > 1) names.sort(compareCodePoints); // [NCP-WIRE-083]
    const entries = names.map((name) => {
      const spelled = this.string(name);
      return `${spelled}:${this.within(name, () => this.value(of, map.get(name)))}`;
    });
    return `{${entries.join(",")}}`;
  }
}

function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

function typeName(value: unknown): string {
  if (value === null) return "null";
  return Array.isArray(value) ? "array" : typeof value;
}
