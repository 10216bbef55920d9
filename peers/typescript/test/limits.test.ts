import assert from "node:assert/strict";
import { test } from "node:test";
import { create, decode, decodeAny, encode, normalise, type Kind } from "@ncp-conformance/peer";
import { refuses, rejects } from "./support.js";

const MIB = 1_048_576;

/** A frame of exactly so many bytes. */
function padded(frame: string, bytes: number): Uint8Array {
  const out = Buffer.alloc(bytes, " ");
  out.write(frame);
  return out;
}

test("a frame of 1 MiB is read and one of a byte more is rejected", () => {
  for (const kind of ["sensor_frame", "command_frame", "bulk_observation"] as Kind[]) {
    const frame = JSON.stringify({ kind });
    decode(kind, padded(frame, MIB));
    decodeAny(padded(frame, MIB));
    rejects(kind, padded(frame, MIB + 1), "limit");
    refuses("limit", () => decodeAny(padded(frame, MIB + 1)));
  }
});

test("the limit counts bytes, also of a frame that comes as text", () => {
  const frame = (n: number): string => JSON.stringify({ kind: "error", error: "é".repeat(n) });
  const most = (MIB - frame(0).length) / 2;
  decode("error", frame(Math.floor(most)));
  rejects("error", frame(Math.floor(most) + 1), "limit");
});

test("an observation frame of 64 MiB is read and one of a byte more is rejected", () => {
  const frame = '{"kind":"observation_frame","session_id":"a"}';
  decode("observation_frame", padded(frame, 64 * MIB));
  decodeAny(padded(frame, 64 * MIB));
  rejects("observation_frame", padded(frame, 64 * MIB + 1), "limit");
});

test("a frame at its limit can still be normalised, although its defaults make it longer", () => {
  const frame = `{"kind":"sensor_frame","frame_id":"${"x".repeat(MIB - 40)}"}`;
  assert.ok(normalise("sensor_frame", frame).length > MIB);
});

test("4096 entries of a map are read and one more is rejected", () => {
  const frame = (n: number): string =>
    `{"kind":"sensor_frame","channels":{${Array.from({ length: n }, (_, i) => `"c${i}":{}`).join(",")}}}`;
  assert.equal(decode("sensor_frame", frame(4_096)).channels.size, 4_096);
  rejects("sensor_frame", frame(4_097), "limit");
});

test("4096 items of an array that is not numeric are read and one more is rejected", () => {
  const frame = (n: number): string =>
    `{"kind":"command_frame","horizon":[${Array.from({ length: n }, () => "{}").join(",")}]}`;
  assert.equal(decode("command_frame", frame(4_096)).horizon.length, 4_096);
  rejects("command_frame", frame(4_097), "limit");
});

test("a numeric array may have as many items as the frame has room for", () => {
  const frame = `{"kind":"sensor_frame","channels":{"a":{"data":[${"0,".repeat(500_000)}1]}}}`;
  assert.equal(decode("sensor_frame", frame).channels.get("a")!.data.length, 500_001);
});

test("an ignored member may have more entries and items than a field", () => {
  const entries = Array.from({ length: 5_000 }, (_, i) => `"c${i}":[]`).join(",");
  decode("sensor_frame", `{"kind":"sensor_frame","x":{${entries}},"y":[${"{},".repeat(5_000)}{}],${entries}}`);
});

test("numbers take eight bytes an item, and what only looks like many takes no more than that", () => {
  const many = `{"kind":"observation_frame","session_id":"a","records":{"p":{"values":[${"0,".repeat(4_000_000)}0]}}}`;
  const before = process.memoryUsage().arrayBuffers;
  const frame = decode("observation_frame", many);
  assert.equal(frame.records.get("p")!.values.byteLength, 8 * 4_000_001);
  assert.ok(process.memoryUsage().arrayBuffers - before < 8 * many.length);
  rejects(
    "observation_frame",
    `{"kind":"observation_frame","session_id":"a","records":{"p":{"values":[${",".repeat(1_000_000)}]}}}`,
    "malformed",
  );
});

test("hostile frames are read or rejected in time that grows with their length", () => {
  const length = 8 * MIB;
  const inside = (open: string, part: (n: number) => string, close: string): string => {
    const parts: string[] = [];
    for (let size = 0, n = 0; size < length; n++) size += (parts[n] = part(n)).length;
    return `{"kind":"observation_frame","session_id":"a",${open}${parts.join("")}${close}}`;
  };
  const hostile: [string, string][] = [
    ["names", inside('"x":{"":0', (n) => `,"${n * 65_536}":0`, "}")],
    ["escaped names", inside('"x":{"":0', (n) => `,"\\u0061${n.toString(36)}":0`, "}")],
    ["objects", inside('"x":[0', () => ',{"a":0}', "]")],
    ["escapes", inside('"x":"', () => "\\n", '"')],
    ["a field of escapes", inside('"ncp_version":"', () => "\\u00e9", '"')],
    ["digits", inside('"t":0.', (n) => String(n), "")],
    ["zeros", inside('"t":0.', () => "0000000000", "")],
    ["exponent", inside('"t":0e', () => "9999999999", "")],
    ["open arrays", inside('"records":{"p":{"values":[', () => "[", "")],
    ["white space", inside('"t":', () => " \n\t\r", "0")],
  ];
  for (const [name, frame] of hostile) {
    const begin = performance.now();
    try {
      decode("observation_frame", frame);
    } catch {
      // Whether it is accepted is not the question here.
    }
    const took = performance.now() - begin;
    assert.ok(took < 5_000, `${name} took ${took.toFixed(0)} ms`);
  }
});

test("the encoder refuses what is beyond a limit", () => {
  const values = (n: number): Record<string, object> =>
    Object.fromEntries(Array.from({ length: n }, (_, i) => [`c${i}`, {}]));
  encode(create("sensor_frame", { channels: values(4_096) }));
  refuses("limit", () => encode(create("sensor_frame", { channels: values(4_097) })));
  refuses("limit", () => encode(create("command_frame", { horizon: Array.from({ length: 4_097 }, () => ({})) })));
  refuses("limit", () => encode(create("error", { error: "x".repeat(MIB) })));
  refuses("limit", () => encode(create("error", { error: "€".repeat(MIB / 3) })));
  const room = MIB - encode(create("error", { error: "" })).length;
  assert.equal(Buffer.byteLength(encode(create("error", { error: "x".repeat(room) }))), MIB);
});
