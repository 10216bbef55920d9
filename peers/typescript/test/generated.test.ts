import assert from "node:assert/strict";
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";

const ROOT = new URL("../../", import.meta.url);
const { generate } = (await import(new URL("scripts/generate-types.mjs", ROOT).href)) as {
  generate(folder?: URL): string;
};
const committed = readFileSync(new URL("src/generated/messages.ts", ROOT), "utf8");

test("the generated types are what the schemas generate", () => {
  assert.equal(committed, generate(), "stale; if this is meant: npm run generate");
});

test("a field that a schema gains, loses or retypes changes the generated types", () => {
  const folder = mkdtempSync(join(tmpdir(), "ncp-schemas-"));
  try {
    const copy = pathToFileURL(`${folder}/`);
    cpSync(new URL("../../schemas/", ROOT), copy, { recursive: true });
    assert.equal(generate(copy), committed);
    const file = join(folder, "session_closed.schema.json");
    const schema = readFileSync(file, "utf8");
    const edit = (change: (properties: Record<string, object>) => void): string => {
      const edited = JSON.parse(schema) as { properties: Record<string, object> };
      change(edited.properties);
      writeFileSync(file, JSON.stringify(edited));
      return generate(copy);
    };
    assert.match(edit((of) => (of["why"] = { type: "string", description: "Why." })), /\/\*\* Why\. \*\/\n  why: string;/);
    assert.doesNotMatch(edit((of) => delete of["ok"]).split("interface SessionClosed")[1]!.split("}")[0]!, /ok/);
    assert.match(edit((of) => (of["ok"] = { type: "integer" })), /interface SessionClosed \{[^}]*ok: number;/);
    assert.throws(() => edit((of) => (of["ok"] = { type: "colour" })), /no type for/);
  } finally {
    rmSync(folder, { recursive: true });
  }
});
