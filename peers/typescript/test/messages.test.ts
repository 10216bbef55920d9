import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { test } from "node:test";
import { isDeepStrictEqual } from "node:util";
import { KINDS, type Kind } from "@ncp-conformance/peer";
import { plainValue } from "#dist/client/plain.js";
import { TABLES } from "#dist/messages.js";
import type { Shape, Table } from "#dist/table.js";
import { type ProjectedMessage, projection, repositoryFile } from "./support.js";

const CHAPTERS = [
  "01-wire",
  "02-version-and-identity",
  "03-planes-and-keys",
  "04-sessions",
  "05-observations-and-bulk",
  "06-provenance",
  "07-safety",
  "08-resilience",
  "09-codec",
  "10-control-loop",
  "11-transports",
  "12-security",
];

const { enums, messages, error_frame } = projection();

interface Row {
  readonly name: string;
  readonly type: string;
  readonly required: boolean;
  readonly absent: unknown;
}

function typeOf(shape: Shape): string {
  switch (shape.is) {
    case "segment":
    case "kind":
      return "string";
    case "pin":
      return "boolean";
    case "integers":
      return "[integer]";
    case "numbers":
      return "[number]";
    case "list":
      return `[${typeOf(shape.of)}]`;
    case "map":
      return `{string: ${typeOf(shape.of)}}`;
    case "message":
      return shape.table.name;
    case "enum":
      return enumOf(shape) ?? "?";
    default:
      return shape.is;
  }
}

/** The enum that has these strings, and does the same with others. */
function enumOf({ values, unknown }: Shape & { is: "enum" }): string | undefined {
  const policy = unknown === "hold" ? { read_as: "hold" } : unknown;
  const found = Object.entries(enums).find(([, known]) => isDeepStrictEqual(Object.values(known.values), [...values]));
  return isDeepStrictEqual(found?.[1].unknown, policy) ? found?.[0] : undefined;
}

function rowsOf(table: Table): Row[] {
  return table.fields.map((field) => ({
    name: field.name,
    type: typeOf(field.shape) + (field.optional ? "|null" : ""),
    required: field.required,
    absent: field.required ? undefined : plainValue(field.absent()),
  }));
}

function rowsOfTheContract({ required = [], fields }: ProjectedMessage): Row[] {
  return Object.entries(fields).map(([name, { type, default: absent }]) => ({
    name,
    type,
    required: required.includes(name),
    absent,
  }));
}

/** The table and all that its fields lead to. */
function withNested(table: Table, found = new Map<string, Table>()): Map<string, Table> {
  if (found.has(table.name)) return found;
  found.set(table.name, table);
  const visit = (shape: Shape): void => {
    if (shape.is === "message") withNested(shape.table, found);
    if (shape.is === "list" || shape.is === "map") visit(shape.of);
  };
  for (const { shape } of table.fields) visit(shape);
  return found;
}

test("every message has the fields, types and defaults of the contract, in their order", () => {
  const compared = new Set<string>();
  for (const kind of KINDS) {
    for (const [name, table] of withNested(TABLES[kind])) {
      // A stimulus frame inside a request has other defaults: the request's.
      const inner = table.name === "StimulusFrame" && table !== TABLES.stimulus_frame;
      const comparable = (row: Row): Row => (inner ? { ...row, required: false, absent: undefined } : row);
      const expected = name === "ErrorFrame" ? error_frame : messages[name]!;
      assert.deepEqual(rowsOf(table).map(comparable), rowsOfTheContract(expected).map(comparable), name);
      compared.add(name);
    }
  }
  const all = Object.entries(messages).filter(([, { transparent }]) => transparent !== true);
  assert.deepEqual([...compared].sort(), [...all.map(([name]) => name), "ErrorFrame"].sort());
});

test("the kinds are those of the contract", () => {
  const expected = [...Object.values(messages), error_frame].flatMap(({ kind }) => kind ?? []);
  assert.deepEqual([...KINDS].sort() as string[], expected.sort());
  for (const kind of KINDS) {
    const field = TABLES[kind].byName.get("kind")!;
    assert.deepEqual(field.shape, { is: "kind", value: kind satisfies Kind });
  }
});

test("every rule that the code names is a rule of the text", () => {
  const known = new Set(
    CHAPTERS.flatMap((chapter) =>
      [...repositoryFile(`spec/text/${chapter}.md`).matchAll(/^- \*\*\[(NCP-\w+-\d{3})\]/gm)].map(([, id]) => id!),
    ),
  );
  const folder = new URL("../../src/", import.meta.url);
  for (const file of readdirSync(folder, { encoding: "utf8", recursive: true }).filter((file) => file.endsWith(".ts"))) {
    for (const [id] of readFileSync(new URL(file, folder), "utf8").matchAll(/NCP-[A-Z]+-\d{3}/g)) {
      assert.ok(known.has(id), `${file} names ${id}`);
    }
  }
});
