import assert from "node:assert/strict";
import { test } from "node:test";
import { create, decode, DecodeError, encode, KINDS, normalise, type Input, type Kind } from "@ncp-conformance/peer";
import { TABLES } from "#dist/messages.js";
import type { Shape, Table } from "#dist/table.js";
import { Random } from "./support.js";

const random = new Random(20);

test("a random message of any kind reads back as what was written", () => {
  for (const kind of KINDS) {
    for (let n = 0; n < 300; n++) {
      const message = create(kind, randomFields(TABLES[kind], 0, kind) as Input<Kind>);
      const text = encode(message);
      assert.deepEqual(decode(kind, text), message, text);
      assert.equal(normalise(kind, Buffer.from(text)), text);
    }
  }
});

test("the order of members, white space and ignored members do not change what is read", () => {
  for (const kind of KINDS) {
    for (let n = 0; n < 200; n++) {
      const text = encode(create(kind, randomFields(TABLES[kind], 0, kind) as Input<Kind>));
      const other = respelled(text);
      assert.equal(normalise(kind, other), text, other);
    }
  }
});

test("a frame with some bytes changed is read or rejected, and what is read can be written and read again", () => {
  let read = 0;
  for (const kind of KINDS) {
    for (let n = 0; n < 1_000; n++) {
      const frame = Buffer.from(encode(create(kind, randomFields(TABLES[kind], 0, kind) as Input<Kind>)));
      for (let times = 1 + random.below(3); times > 0; times--) {
        frame[random.below(frame.length)] = random.chance(2)
          ? random.below(256)
          : random.pick([...Buffer.from('"{}[]:,0-e. \\tn')]);
      }
      try {
        const message = decode(kind, frame);
        assert.deepEqual(decode(kind, encode(message)), message);
        read++;
      } catch (error) {
        assert.ok(error instanceof DecodeError, `a crash: ${String(error)}`);
      }
    }
  }
  assert.ok(read > 1_000, `only ${read} frames were read`);
});

/** Some of the fields of a table, and all that are required, with random values. */
function randomFields(table: Table, level: number, kind?: Kind): Record<string, unknown> {
  const fields: Record<string, unknown> = {};
  for (const field of table.fields) {
    const { shape } = field;
    // A stimulus frame inside a request takes its session and its version from the request.
    const inherited = field.absent() === undefined && !field.required;
    if (inherited || shape.is === "kind" || (!field.required && random.chance(3))) continue;
    fields[field.name] = field.optional && random.chance(4) ? null : randomValue(shape, level + 1);
  }
  // Without its session, an error frame is written without the member.
  if (kind === "error" && fields["session_id"] === undefined) fields["session_id"] = null;
  return fields;
}

function randomValue(shape: Shape, level: number): unknown {
  const several = (most: number): unknown[] => Array.from({ length: random.below(most) });
  switch (shape.is) {
    case "string":
      return random.text();
    case "integer":
      return random.integer();
    case "number":
      return randomDouble();
    case "boolean":
      return random.chance(2);
    case "integers":
      return Float64Array.from(several(6), () => random.integer());
    case "numbers":
      return Float64Array.from(several(6), randomDouble);
    case "segment":
      return random.pick(["a", "uav3", "é", "x".repeat(256), "😀", "a.b", "-"]);
    case "kind":
    case "pin":
      return shape.value;
    case "enum":
      return shape.unknown === "keep" && random.chance(3) ? random.text() : random.pick([...shape.values]);
    case "list":
      return several(level > 3 ? 2 : 4).map(() => randomValue(shape.of, level + 1));
    case "map":
      return new Map(several(level > 3 ? 2 : 4).map(() => [random.text(), randomValue(shape.of, level + 1)]));
    case "message":
      return randomFields(shape.table, level);
  }
}

function randomDouble(): number {
  return random.chance(4) ? random.pick([0, -0, 1, 0.5, Number.MIN_VALUE, Number.MAX_VALUE]) : random.double();
}

/** The same frame with its members in another order, with white space, escapes and members that are to be ignored. */
function respelled(text: string): string {
  // JSON.parse would lose the sign of a zero and reorder names that look like indices, so the text is cut instead.
  let at = 0;
  const space = (): string => (random.chance(4) ? random.pick([" ", "\n", "\t", "\r\n"]) : "");
  const string = (): string => {
    const begin = at++;
    while (text[at] !== '"') at += text[at] === "\\" ? 2 : 1;
    at++;
    const characters = [...(JSON.parse(text.slice(begin, at)) as string)];
    return `"${characters.map((character) => (random.chance(4) ? escaped(character) : JSON.stringify(character).slice(1, -1))).join("")}"`;
  };
  const value = (inMap: boolean): string => {
    const spelled =
      text[at] === "{" ? object(inMap) : text[at] === "[" ? array(inMap) : text[at] === '"' ? string() : scalar();
    return space() + spelled + space();
  };
  const scalar = (): string => {
    const begin = at;
    while (!/[,\]}]/.test(text[at]!)) at++;
    return text.slice(begin, at);
  };
  const array = (inMap: boolean): string => {
    const items: string[] = [];
    at++;
    while (text[at] !== "]") {
      items.push(value(inMap));
      if (text[at] === ",") at++;
    }
    at++;
    return `[${items.join(",")}]`;
  };
  const object = (isMap: boolean): string => {
    const members: string[] = [];
    at++;
    while (text[at] !== "}") {
      const name = string();
      at++;
      members.push(`${space()}${name}${space()}:${value(!isMap && isMapName(JSON.parse(name) as string))}`);
      if (text[at] === ",") at++;
    }
    at++;
    if (!isMap && random.chance(3))
      members.push(random.pick(['"extra":{"a":[1,{"a":null}]}', '"Kind":1e5', '" ":"\\u0000"']));
    return `{${random.shuffled(members).join(",")}}`;
  };
  return space() + object(false) + space();
}

/** The fields that hold a map, or an array of maps: their entries are no fields. */
function isMapName(name: string): boolean {
  return ["meta", "population_sizes", "params", "resolved", "values", "records", "channels", "horizon"].includes(name);
}

function escaped(character: string): string {
  return Array.from(character.split(""), (unit) => `\\u${unit.charCodeAt(0).toString(16).padStart(4, "0")}`).join("");
}
