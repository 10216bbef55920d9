import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { test } from "node:test";
import { KINDS, type Kind } from "@ncp-conformance/peer";
import { TABLES } from "#dist/messages.js";
import type { NamedField, Shape, Table } from "#dist/table.js";
import { repositoryFile } from "./support.js";

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

interface Row {
  readonly name: string;
  readonly type: string;
  readonly absent: string;
}

/** The tables of the text by the name of their message: `| field | type | default | meaning |`. */
function tablesOfTheText(): Map<string, Row[]> {
  const tables = new Map<string, Row[]>();
  for (const section of repositoryFile("spec/text/01-wire.md").split("\n### ").slice(1)) {
    const rows = section.split("\n").flatMap((line): Row[] => {
      const [, name, type, absent] = line
        .replaceAll("\\|", "¦")
        .split("|")
        .map((cell) => cell.trim().replaceAll("`", "").replaceAll("¦", "|"));
      return name === undefined || name === "field" || /^-+$/.test(name)
        ? []
        : [{ name, type: type ?? "", absent: absent ?? "" }];
    });
    tables.set(section.split(/[\s·]/)[0]!, rows);
  }
  return tables;
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
      return [...ENUMS].find(([, words]) => words === [...shape.values].join(" "))?.[0] ?? "?";
    default:
      return shape.is;
  }
}

/** The enums of section 1.4 with their wire strings. */
const ENUMS: ReadonlyMap<string, string> = new Map(
  [
    ...repositoryFile("spec/text/01-wire.md").matchAll(
      /^\| `(\w+)` \| ((?:`\w+`(?:, )?)+) \| (?:descriptive|reads|the frame)/gm,
    ),
  ].map(([, name, words]) => [name!, words!.replaceAll("`", "").replaceAll(",", "")]),
);

function absentOf(field: NamedField): string {
  if (field.shape.is === "kind" && field.required) return "none: it must be there";
  if (field.required) return "required";
  const value = field.absent();
  if (value === null) return "absent";
  if (value instanceof Map) return "{}";
  if (Array.isArray(value) || value instanceof Float64Array) return "[]";
  if (typeof value === "object") return "all defaults";
  if (typeof value === "number")
    return field.shape.is === "number" && Number.isInteger(value) ? value.toFixed(1) : String(value);
  return typeof value === "string" ? `"${value}"` : String(value);
}

function rowsOf(table: Table): Row[] {
  return table.fields.map((field) => ({
    name: field.name,
    type: typeOf(field.shape) + (field.optional ? "|null" : ""),
    absent: absentOf(field),
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

test("every message has the fields, types and defaults that the text's tables give, in their order", () => {
  assert.equal(ENUMS.size, 8);
  const text = tablesOfTheText();
  const compared = new Set<string>();
  for (const kind of KINDS) {
    if (kind === "error" || kind === "bulk_observation") continue;
    for (const [name, table] of withNested(TABLES[kind])) {
      // A stimulus frame inside a request has other defaults: the request's.
      const inner = table.name === "StimulusFrame" && table !== TABLES.stimulus_frame;
      const sameTypes = (row: Row): Row => (inner ? { ...row, absent: "" } : row);
      assert.deepEqual(rowsOf(table).map(sameTypes), text.get(name)?.map(sameTypes), name);
      compared.add(name);
    }
  }
  const messages = [...text].filter(([name, rows]) => rows.length > 0 && name !== "The").map(([name]) => name);
  assert.deepEqual([...compared].sort(), messages.sort());
});

test("the kinds are those that the text gives to its messages", () => {
  const inText = [...repositoryFile("spec/text/01-wire.md").matchAll(/^### \w+ · `(\w+)`$/gm)].map(([, kind]) => kind!);
  const expected = [...inText, "bulk_observation", "error"].sort();
  assert.deepEqual([...KINDS].sort() as string[], expected);
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
