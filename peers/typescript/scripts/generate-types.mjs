// Writes src/generated/messages.ts from the JSON Schemas of the repository, which come from the proto.
//
//   node scripts/generate-types.mjs            writes the file
//   node scripts/generate-types.mjs --check    fails if the file is not what would be written

import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { argv, exit } from "node:process";
import { fileURLToPath } from "node:url";

const SCHEMAS = new URL("../../../schemas/", import.meta.url);
const TARGET = new URL("../src/generated/messages.ts", import.meta.url);

/** What a client sends: of these a program writes some fields and leaves the others to their defaults. */
const REQUESTS = ["OpenSession", "StepRequest", "RunRequest", "CloseSession"];

/** The text of the file, as the schemas in the folder have it. */
export function generate(folder = SCHEMAS) {
  const definitions = new Map();
  const kinds = new Map();
  for (const schema of schemasIn(folder)) {
    const name = typeName(schema.title);
    kinds.set(schema.properties.kind.const, name);
    for (const [inner, definition] of Object.entries(schema.$defs ?? {})) define(definitions, inner, definition);
    define(definitions, name, schema);
  }
  const isObject = (name) => definitions.get(name)?.type === "object";
  const names = [...definitions.keys()].sort();
  const given = reachable(definitions, REQUESTS).filter(isObject).sort();

  return [
    HEAD,
    ...names.filter((name) => definitions.get(name).anyOf).map((name) => enumeration(name, definitions.get(name))),
    ...names.filter(isObject).map((name) => complete(name, definitions.get(name))),
    ...given.map((name) => input(name, definitions.get(name), isObject)),
    messages(kinds),
  ].join("\n");
}

const HEAD = `/**
 * The messages as plain JSON values, generated from the schemas of the repository by \`npm run generate\`;
 * do not edit.
 *
 * A message is complete: a field that was absent has its default, an unset optional one is \`null\`.
 * A type \`…Input\` is what a program gives to have a request made of it: what it leaves out gets its default.
 *
 * @module
 */
`;

function schemasIn(folder) {
  const files = readdirSync(folder).filter((file) => file.endsWith(".schema.json"));
  return files
    .sort()
    .map((file) => JSON.parse(readFileSync(new URL(file, folder), "utf8")))
    .filter((schema) => schema.properties?.kind?.const !== undefined);
}

/** Keeps a definition; files that define the same name have to agree. */
function define(definitions, name, definition) {
  const { $schema, $id, $comment, $defs, title, ...own } = definition;
  const known = definitions.get(name);
  if (known !== undefined && JSON.stringify(known) !== JSON.stringify(own)) {
    throw new Error(`the schemas define ${name} in two ways`);
  }
  definitions.set(name, own);
}

function typeName(title) {
  return title === "RPC error frame" ? "ErrorFrame" : title;
}

/** The names of definitions to which these lead, and these. */
function reachable(definitions, roots) {
  const found = new Set();
  const visit = (name) => {
    if (found.has(name) || !definitions.has(name)) return;
    found.add(name);
    for (const [, inner] of JSON.stringify(definitions.get(name)).matchAll(/"#\/\$defs\/(\w+)"/g)) visit(inner);
  };
  roots.forEach(visit);
  return [...found];
}

function enumeration(name, { description, anyOf }) {
  const words = anyOf.map((one) => {
    if (one.const !== undefined) return `  /** ${one.description} */\n  | ${JSON.stringify(one.const)}`;
    // Where any other string is kept, a program sees it; where it stands for a known one, it sees that one.
    return one.description.includes("kept") ? `  /** ${one.description} */\n  | (string & {})` : undefined;
  });
  return `/** ${description} */\nexport type ${name} =\n${words.filter(Boolean).join("\n")};\n`;
}

function complete(name, { description, properties }) {
  const fields = Object.entries(properties).map(
    ([field, property]) => `${comment(property)}  ${field}: ${typeOf(property, FORM_OF_MESSAGES)};\n`,
  );
  return `/** ${description} */\nexport interface ${name} {\n${fields.join("")}}\n`;
}

function input(name, { properties, required = [] }, isObject) {
  const form = { ...FORM_OF_INPUTS, reference: (to) => (isObject(to) ? `${to}Input` : to) };
  const fields = Object.entries(properties).map(([field, property]) => {
    const named = required.includes(field) && field !== "kind";
    return `${comment(property)}  readonly ${field}${named ? "" : "?"}: ${typeOf(property, form)}${named ? "" : " | undefined"};\n`;
  });
  return `/** What a program gives for {@link ${name}}. */\nexport interface ${name}Input {\n${fields.join("")}}\n`;
}

function comment({ description }) {
  return `  /** ${description} */\n`;
}

const FORM_OF_MESSAGES = {
  reference: (to) => to,
  numbers: "number[]",
  list: (of) => `${of}[]`,
  map: (of) => `Record<string, ${of}>`,
};

const FORM_OF_INPUTS = {
  numbers: "ArrayLike<number>",
  list: (of) => `readonly ${of}[]`,
  map: (of) => `Readonly<Record<string, ${of}>>`,
};

const PRIMITIVES = { string: "string", number: "number", integer: "number", boolean: "boolean", null: "null" };
/** Definitions that are a string or a number with a bound, which a type cannot say. */
const BOUNDED = { segment: "string", integer: "number" };

function typeOf(schema, form) {
  if (schema.const !== undefined) return JSON.stringify(schema.const);
  if (schema.anyOf) return schema.anyOf.map((one) => typeOf(one, form)).join(" | ");
  if (Array.isArray(schema.type)) return schema.type.map((type) => PRIMITIVES[type]).join(" | ");
  if (schema.$ref !== undefined) {
    const name = schema.$ref.replace("#/$defs/", "");
    return BOUNDED[name] ?? form.reference(name);
  }
  if (schema.type === "array") {
    const of = typeOf(schema.items, form);
    return of === "number" ? form.numbers : form.list(of);
  }
  if (schema.type === "object") return form.map(typeOf(schema.additionalProperties, form));
  const primitive = PRIMITIVES[schema.type];
  if (primitive === undefined) throw new Error(`no type for ${JSON.stringify(schema)}`);
  return primitive;
}

function messages(kinds) {
  const entries = [...kinds].sort(([a], [b]) => (a < b ? -1 : 1)).map(([kind, name]) => `  ${kind}: ${name};\n`);
  return `/** The messages by kind. */\nexport interface Messages {\n${entries.join("")}}\n`;
}

if (argv[1] === fileURLToPath(import.meta.url)) {
  const text = generate();
  if (!argv.includes("--check")) writeFileSync(TARGET, text);
  else if (readFileSync(TARGET, "utf8") !== text) {
    console.error("src/generated/messages.ts is stale; if this is meant: npm run generate");
    exit(1);
  }
}
