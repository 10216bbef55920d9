/**
 * The values of the peer protocol: what arguments and results stand for.
 *
 * @module
 */

import type { Column } from "./bulk.js";
import { create } from "./encode.js";
import { NcpError } from "./errors.js";
import { isKind, TABLES, type Input, type Kind, type Messages } from "./messages.js";
import type { Shape, Table } from "./table.js";

export type Json = null | boolean | number | string | Json[] | { [name: string]: Json };
export type Args = Readonly<Record<string, Json>>;
export type Call = (args: Args) => Json;

/** A request that this program refuses itself: what it asks for has no form in the library. */
export class Refusal extends Error {
  readonly code: string;

  constructor(code: string, message: string) {
    super(message);
    this.code = code;
  }
}

/** Why something failed. What the library does not throw on purpose is a crash, and is reported as one. */
export function refusalOut(error: unknown): Json {
  if (error instanceof NcpError || error instanceof Refusal) return { code: error.code, message: error.message };
  process.stderr.write(`${error instanceof Error ? error.stack : String(error)}\n`);
  return { code: "internal", message: messageOf(error) };
}

export function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

const SPECIAL_DOUBLES: ReadonlyMap<Json, number> = new Map([
  ["NaN", NaN],
  ["Infinity", Infinity],
  ["-Infinity", -Infinity],
  ["-0", -0],
]);

export function doubleIn(value: Json | undefined): number {
  const double = typeof value === "number" ? value : SPECIAL_DOUBLES.get(value ?? null);
  if (double === undefined) throw new Refusal("type", "a double is expected");
  return double;
}

export function doubleOut(value: number): number | string {
  if (Object.is(value, -0)) return "-0";
  return Number.isFinite(value) ? value : String(value);
}

export function doubleOrNullIn(value: Json | undefined): number | null {
  return value === null || value === undefined ? null : doubleIn(value);
}

export function integerIn(value: Json | undefined): number {
  if (typeof value !== "number" || !Number.isInteger(value)) throw new Refusal("type", "an integer is expected");
  return value;
}

function i32In(value: Json): number {
  if (typeof value !== "number" || (value | 0) !== value) throw new Refusal("type", "an i32 is expected");
  return value;
}

export function i64In(value: Json): bigint {
  const integer = typeof value === "string" && /^-?[0-9]+$/.test(value) ? BigInt(value) : undefined;
  if (integer === undefined || BigInt.asIntN(64, integer) !== integer) throw new Refusal("type", "an i64 is expected");
  return integer;
}

export function bytesIn(base64: string): Uint8Array {
  return Buffer.from(base64, "base64");
}

export function bytesOut(bytes: Uint8Array): string {
  return Buffer.from(bytes.buffer, bytes.byteOffset, bytes.byteLength).toString("base64");
}

export function columnIn(column: Json): Column {
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

export function columnOut({ name, dtype, data }: Column): Json {
  const values =
    dtype === "i64" ? Array.from(data, String) : dtype === "i32" ? Array.from(data) : Array.from(data, doubleOut);
  return { name, dtype, data: values };
}

/** The fields to set, with the strings that stand for doubles replaced wherever the tables give a number. */
export function fieldsIn(table: Table, fields: Json): Json {
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

/** A message of the fields that are given, which a library of types takes to be of the types of the tables. */
export function messageIn<K extends Kind>(kind: K, fields: Json | undefined): Messages[K] {
  const message = create(kind, fieldsIn(TABLES[kind], fields ?? {}) as Input<K>);
  checkTypes(TABLES[kind], message as unknown as Record<string, unknown>);
  return message;
}

export function messageOrNullIn<K extends Kind>(kind: K, fields: Json | undefined): Messages[K] | null {
  return fields === null || fields === undefined ? null : messageIn(kind, fields);
}

/** Every field of a message, by its name on the wire. */
export function messageOut(message: Messages[Kind]): Json {
  return fieldsOut(TABLES[message.kind], message as unknown as Record<string, unknown>);
}

function fieldsOut(table: Table, message: Readonly<Record<string, unknown>>): Json {
  return Object.fromEntries(table.fields.map(({ name, shape }) => [name, valueOut(shape, message[name])]));
}

function valueOut(shape: Shape, value: unknown): Json {
  if (value === null) return null;
  switch (shape.is) {
    case "number":
      return doubleOut(value as number);
    case "numbers":
      return Array.from(value as Float64Array, doubleOut);
    case "integers":
      return Array.from(value as Float64Array);
    case "list":
      return (value as unknown[]).map((item) => valueOut(shape.of, item));
    case "map":
      return mapOut(value as Map<string, unknown>, (item) => valueOut(shape.of, item));
    case "message":
      return fieldsOut(shape.table, value as Record<string, unknown>);
    default:
      return value as Json;
  }
}

/** Unlike an assignment, `Object.fromEntries` keeps an entry of the name `__proto__`. */
export function mapOut<T>(of: ReadonlyMap<string, T>, each: (value: T) => Json): Json {
  return Object.fromEntries(Array.from(of, ([name, value]) => [name, each(value)]));
}

function checkTypes(table: Table, message: Readonly<Record<string, unknown>>): void {
  for (const { name, shape, optional } of table.fields) {
    const value = message[name];
    if (value !== null || !optional) checkType(shape, value);
  }
}

function checkType(shape: Shape, value: unknown): void {
  switch (shape.is) {
    case "integer":
      integerIn(value as Json);
      return;
    case "number":
      doubleIn(value as Json);
      return;
    case "boolean":
    case "pin":
      if (typeof value !== "boolean") throw new Refusal("type", "a boolean is expected");
      return;
    case "list":
      for (const item of value as unknown[]) checkType(shape.of, item);
      return;
    case "map":
      for (const item of (value as Map<string, unknown>).values()) checkType(shape.of, item);
      return;
    case "message":
      checkTypes(shape.table, value as Record<string, unknown>);
      return;
    case "numbers":
    case "integers":
      return;
    default:
      if (typeof value !== "string") throw new Refusal("type", "a string is expected");
  }
}

/** A frame as it travels: its text or its bytes. */
export function frameIn(args: Args): string | Uint8Array {
  return typeof args["base64"] === "string" ? bytesIn(args["base64"]) : textIn(args, "text");
}

export function kindIn(args: Args): Kind {
  const kind = textIn(args, "kind");
  if (!isKind(kind)) throw new Refusal("kind", `there is no kind ${kind}`);
  return kind;
}

/** Whether the call is about the strict profile. */
export function strictIn(args: Args): boolean {
  return args["strict"] === true;
}

export function textIn(args: Args, name: string): string {
  const value = args[name];
  if (typeof value !== "string") throw new Refusal("invalid", `the argument ${name} is not text`);
  return value;
}

export function textOrNullIn(args: Args, name: string): string | null {
  return args[name] === null || args[name] === undefined ? null : textIn(args, name);
}

export function listIn(args: Args, name: string): Json[] {
  const value = args[name];
  if (!Array.isArray(value)) throw new Refusal("invalid", `the argument ${name} is not an array`);
  return value;
}

export function isObject(value: Json | undefined): value is { [name: string]: Json } {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}
