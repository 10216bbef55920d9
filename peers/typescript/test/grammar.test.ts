import assert from "node:assert/strict";
import { test } from "node:test";
import { decode, DecodeError, encode, kindOf, type Kind } from "@ncp-conformance/peer";
import { bytes, Random, rejects } from "./support.js";

/** A frame with a member that the tables do not list. */
const ignoring = (json: string): string => `{"kind":"close_session","session_id":"a","extra":${json}}`;
const timed = (spelling: string): string => `{"kind":"sensor_frame","t":${spelling}}`;
const counted = (spelling: string): string => `{"kind":"sensor_frame","seq":${spelling}}`;

test("a frame that is not UTF-8 is rejected, wherever the bytes stand", () => {
  const faulty = [
    [0x80],
    [0xc3],
    [0xc0, 0xaf],
    [0xc1, 0xbf],
    [0xe2, 0x82],
    [0xe0, 0x9f, 0xbf],
    [0xed, 0xa0, 0x80],
    [0xed, 0xbf, 0xbf],
    [0xf0, 0x8f, 0xbf, 0xbf],
    [0xf4, 0x90, 0x80, 0x80],
    [0xf5, 0x80, 0x80, 0x80],
    [0xff],
    [0xe2, 0x82, 0x41],
    [0xf0, 0x9f, 0x98],
  ];
  for (const sequence of faulty) {
    rejects("sensor_frame", bytes('{"kind":"sensor_frame","frame_id":"', sequence, '"}'), "malformed");
    rejects("sensor_frame", bytes('{"kind":"sensor_frame","extra":["', sequence, '"]}'), "malformed");
    rejects("sensor_frame", bytes('{"kind":"sensor_frame","', sequence, '":0}'), "malformed");
    rejects("sensor_frame", bytes('{"kind":"sensor_frame"}', sequence), "malformed");
  }
});

test("every well-formed UTF-8 sequence is read as its character", () => {
  for (const text of [
    "\u007f",
    "\u0080",
    "\u07ff",
    "\u0800",
    "\ud7ff",
    "\ue000",
    "\uffff",
    "\u{10000}",
    "\u{10ffff}",
    "\ufeff",
  ]) {
    assert.equal(decode("sensor_frame", bytes('{"kind":"sensor_frame","frame_id":"', text, '"}')).frame_id, text);
  }
});

test("a frame with a byte order mark is rejected", () => {
  rejects("sensor_frame", bytes([0xef, 0xbb, 0xbf], '{"kind":"sensor_frame"}'), "malformed");
  rejects("sensor_frame", '\ufeff{"kind":"sensor_frame"}', "malformed");
});

test("a frame that is not one object is rejected", () => {
  const faulty = [
    "",
    " ",
    "null",
    "true",
    "1",
    '"x"',
    "[]",
    '[{"kind":"sensor_frame"}]',
    "{",
    "}",
    '{"kind":"sensor_frame"',
    '{"kind":"sensor_frame"}{}',
    '{"kind":"sensor_frame"},',
    '{"kind":"sensor_frame"}x',
    '{"kind":"sensor_frame"}\0',
  ];
  for (const frame of faulty) rejects("sensor_frame", frame, "malformed");
});

test("white space is accepted between all tokens, and only JSON's", () => {
  const frame = (space: string): string =>
    [
      "",
      "{",
      '"kind"',
      ":",
      '"sensor_frame"',
      ",",
      '"channels"',
      ":",
      "{",
      '"a"',
      ":",
      "{",
      '"data"',
      ":",
      "[",
      "1",
      ",",
      "2",
      "]",
      "}",
      "}",
      "}",
      "",
    ].join(space);
  for (const space of [" ", "\t", "\n", "\r", " \t\r\n "]) {
    assert.deepEqual([...decode("sensor_frame", frame(space)).channels.get("a")!.data], [1, 2]);
  }
  for (const space of ["\f", "\v", "\u00a0", "\u2028", "\0"]) rejects("sensor_frame", frame(space), "malformed");
});

test("text that the JSON grammar lacks is rejected, also within an ignored member", () => {
  const faulty = [
    "",
    "01",
    "-01",
    "1.",
    ".5",
    "+1",
    "1e",
    "1e+",
    "1.e1",
    "- 1",
    "-",
    "0x10",
    "1_0",
    "NaN",
    "Infinity",
    "-Infinity",
    "nul",
    "nulll",
    "True",
    "tru",
    "'a'",
    "[1,]",
    "[,1]",
    "[1 2]",
    "[",
    "]",
    "{,}",
    '{"a"}',
    '{"a":}',
    '{"a":1,}',
    '{"a" 1}',
    "{a:1}",
    '"a',
    '"\\x"',
    '"\\u12"',
    '"\\u12G4"',
    '"\\U1234"',
    '"\t"',
    '"\n"',
    '"\u0000"',
    "1/**/",
    "//\n1",
    "undefined",
  ];
  for (const json of faulty) rejects("close_session", ignoring(json), "malformed");
});

test("a repeated member is rejected at the top, in maps, and in what is ignored", () => {
  const repeated: [Kind, string][] = [
    ["sensor_frame", '{"kind":"sensor_frame","seq":1,"seq":1}'],
    ["sensor_frame", '{"kind":"sensor_frame","seq":1,"s\\u0065q":1}'],
    ["sensor_frame", '{"kind":"sensor_frame","kind":"sensor_frame"}'],
    ["sensor_frame", '{"kind":"sensor_frame","x":1,"y":1,"x":1}'],
    ["sensor_frame", '{"kind":"sensor_frame","channels":{"a":{},"a":{}}}'],
    ["sensor_frame", '{"kind":"sensor_frame","channels":{"a":{"unit":null,"unit":null}}}'],
    ["close_session", ignoring('{"a":1,"a":1}')],
    ["close_session", ignoring('[[{"b":{"":1,"\\u00e9":2,"é":3}}]]')],
    ["close_session", ignoring('{"\\u0061":1,"\\u0061":1}')],
    ["close_session", ignoring('{"\\ud83d\\ude00":1,"😀":1}')],
    ["close_session", ignoring('{"__proto__":1,"__proto__":1}')],
  ];
  for (const [kind, frame] of repeated) rejects(kind, frame, "malformed");
});

test("one name in two objects is no repetition", () => {
  decode("close_session", ignoring('[{"a":{"a":{"a":1}}},{"a":1}]'));
  decode("sensor_frame", '{"kind":"sensor_frame","channels":{"seq":{"kind":1},"kind":{"kind":1}}}');
});

test("a repetition is found among many names", () => {
  const names = Array.from({ length: 5_000 }, (_, n) => `"name${n * 7}":0`);
  decode("close_session", ignoring(`{${names.join(",")}}`));
  rejects("close_session", ignoring(`{${names.join(",")},"name${7 * 4_321}":0}`), "malformed");
  rejects("close_session", ignoring(`{${names.join(",")},"nam\\u0065${7 * 17}":0}`), "malformed");
});

test("an escaped surrogate without its partner is rejected", () => {
  for (const escape of [
    "\\ud800",
    "\\udfff",
    "\\ude00\\ud83d",
    "\\ud83d\\u0041",
    "\\ud83dx",
    "\\ud83d\\n",
    "\\ud83d\\ud83d\\ude00",
  ]) {
    rejects("sensor_frame", `{"kind":"sensor_frame","frame_id":"${escape}"}`, "malformed");
    rejects("close_session", ignoring(`"${escape}"`), "malformed");
    rejects("close_session", ignoring(`{"${escape}":0}`), "malformed");
  }
  rejects("sensor_frame", '{"kind":"sensor_frame","frame_id":"\ud800"}', "malformed");
});

test("escapes are resolved in values and in names", () => {
  const frame = decode(
    "sensor_frame",
    '{"k\\u0069nd":"sensor_fram\\u0065","frame_id":"\\"\\\\\\/\\b\\f\\n\\r\\t\\u0000\\u00E9\\uffff\\uD83D\\uDE00 é😀"}',
  );
  assert.equal(frame.frame_id, '"\\/\b\f\n\r\t\0é\uffff😀 é😀');
});

test("a frame of 64 levels is read and one of 65 is rejected", () => {
  const nested = (levels: number): string => ignoring("[".repeat(levels - 1) + "]".repeat(levels - 1));
  decode("close_session", nested(64));
  rejects("close_session", nested(65), "limit");
  rejects("close_session", ignoring('{"a":'.repeat(64) + "1" + "}".repeat(64)), "limit");
  // Levels are counted as they stand, not as they come.
  decode("close_session", ignoring(`[${Array.from({ length: 200 }, () => "[[]]").join(",")}]`));
});

test("a number is read as the nearest double, however it is spelled", () => {
  const spellings: [string, number][] = [
    ["0", 0],
    ["-0", -0],
    ["-0.0", -0],
    ["0e9", 0],
    ["-0E-9", -0],
    ["5", 5],
    ["5.0", 5],
    ["50e-1", 5],
    ["0.05E+2", 5],
    ["1e22", 1e22],
    ["9007199254740993", 9007199254740992],
    ["9007199254740995", 9007199254740996],
    ["0.1", 0.1],
    ["123456789012345e-22", 123456789012345e-22],
    ["1.7976931348623158e308", Number.MAX_VALUE],
    ["4.9e-324", Number.MIN_VALUE],
    ["2.4703282292062328e-324", Number.MIN_VALUE],
    ["2.4703282292062327e-324", 0],
    ["-1e-400", -0],
    ["1e-99999999999999999999", 0],
    ["0e99999999999999999999", 0],
    ["2.2250738585072011e-308", 2.225073858507201e-308],
    ["1.00000000000000011102230246251565", 1],
    ["1.00000000000000011102230246251566", 1 + Number.EPSILON],
    [`0.${"0".repeat(400)}1e401`, 1],
    [`1${"0".repeat(400)}e-400`, 1],
    ["3.14159265358979323846264338327950288419716939937510", Math.PI],
  ];
  for (const [spelling, value] of spellings) {
    assert.ok(Object.is(decode("sensor_frame", timed(spelling)).t, value), spelling);
    const inArray = decode("sensor_frame", `{"kind":"sensor_frame","channels":{"a":{"data":[${spelling}]}}}`);
    assert.ok(Object.is(inArray.channels.get("a")!.data[0], value), spelling);
  }
});

test("a number beyond the largest double is rejected, also where it is ignored", () => {
  for (const spelling of [
    "1e309",
    "-1e309",
    "1.7976931348623159e308",
    "1e99999999999999999999",
    `1${"0".repeat(309)}`,
  ]) {
    rejects("sensor_frame", timed(spelling), "malformed");
    rejects("sensor_frame", `{"kind":"sensor_frame","channels":{"a":{"data":[0,${spelling}]}}}`, "malformed");
    rejects("close_session", ignoring(spelling), "malformed");
  }
});

test("every double survives decoding and encoding bit for bit", () => {
  const random = new Random(1);
  const edges = [
    0,
    -0,
    Number.MIN_VALUE,
    -Number.MIN_VALUE,
    Number.MAX_VALUE,
    -Number.MAX_VALUE,
    2.2250738585072014e-308,
    1e21,
    1e-7,
    0.1 + 0.2,
  ];
  for (const value of [...edges, ...Array.from({ length: 3_000 }, () => random.double())]) {
    const sign = Object.is(value, -0) ? "-" : "";
    for (const spelling of [String(value), value.toExponential(20), value.toPrecision(17)].map(
      (digits) => sign + digits,
    )) {
      const frame = decode("sensor_frame", timed(spelling));
      assert.ok(Object.is(frame.t, value), spelling);
      const again = decode("sensor_frame", encode(frame));
      assert.ok(Object.is(again.t, value), spelling);
    }
  }
});

test("random decimals are read as the double whose half-way points enclose them", () => {
  const random = new Random(2);
  for (let n = 0; n < 2_000; n++) {
    let digits = String(1 + random.below(9));
    for (let i = random.below(30); i > 0; i--) digits += random.below(10);
    const exponent = random.below(60) - 30;
    const value = decode("sensor_frame", timed(`${digits}e${exponent}`)).t;
    assert.ok(isNearest(BigInt(digits), exponent, value), `${digits}e${exponent} read as ${value}`);
  }
});

test("an integer in another spelling or out of range is rejected", () => {
  for (const spelling of ["1.0", "1e3", "-0", "0.0", "1E0", "-0.0", "10e-1"])
    rejects("sensor_frame", counted(spelling), "type");
  for (const spelling of ["9007199254740992", "-9007199254740992", "9007199254740993", "18446744073709551616"]) {
    rejects("sensor_frame", counted(spelling), "value");
    rejects(
      "open_session",
      `{"kind":"open_session","session_id":"a","network":{"population_sizes":{"a":${spelling}}}}`,
      "value",
    );
    rejects(
      "open_session",
      `{"kind":"open_session","session_id":"a","network":{},"record":{"targets":[{"ids":[1,${spelling}]}]}}`,
      "value",
    );
  }
  for (const value of [0, 1, -1, 9007199254740991, -9007199254740991]) {
    assert.equal(decode("sensor_frame", counted(String(value))).seq, value);
  }
});

test("an ignored value is accepted exactly when the language's own reader accepts it", () => {
  const random = new Random(3);
  let accepted = 0;
  for (let n = 0; n < 20_000; n++) {
    const json = mutated(random, randomJson(random, 0));
    const verdict = judge(json);
    if (verdict) accepted++;
    assert.equal(isAccepted("close_session", ignoring(json)), verdict, json);
  }
  assert.ok(accepted > 4_000 && accepted < 16_000, `${accepted} of 20000 were accepted`);
});

test("random bytes and frames cut short never do more than be rejected", () => {
  const random = new Random(4);
  const frame = Buffer.from(
    '{"kind":"command_frame","mode":"active","channels":{"a":{"data":[1.5,-2e3],"unit":"m/s"}},"horizon":[{"é":{}}],"x":[{"y":null}]}',
  );
  for (let length = 0; length < frame.length; length++) {
    assert.equal(isAccepted("command_frame", frame.subarray(0, length)), false);
    isAccepted(
      "command_frame",
      Uint8Array.from({ length }, () => random.below(256)),
    );
  }
});

test("the kind of a frame is found wherever it stands", () => {
  assert.equal(kindOf('{"x":{"kind":"error"},"kind":"command_frame","seq":'), "command_frame");
  assert.equal(kindOf(' {"kind":"error"}'), "error");
});

/** Whether digits · 10^exponent lies between the half-way points around the double, by exact arithmetic. */
function isNearest(digits: bigint, exponent: number, value: number): boolean {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, value);
  const pattern = view.getBigUint64(0);
  // value = mantissa · 2^power; the half-way points are (2 · mantissa ± 1) · 2^(power − 1), below a power of two half as far.
  const mantissa = (pattern & 0xfffffffffffffn) | 0x10000000000000n;
  const power = Number(pattern >> 52n) - 1075;
  const lower = mantissa === 0x10000000000000n ? 4n * mantissa - 1n : 4n * mantissa - 2n;
  const upper = 4n * mantissa + 2n;
  const scale = power - 2;
  const exact = digits * 10n ** BigInt(Math.max(exponent, 0)) * 2n ** BigInt(Math.max(-scale, 0));
  const unit = 10n ** BigInt(Math.max(-exponent, 0)) * 2n ** BigInt(Math.max(scale, 0));
  const even = mantissa % 2n === 0n;
  return even ? lower * unit <= exact && exact <= upper * unit : lower * unit < exact && exact < upper * unit;
}

function isAccepted(kind: Kind, frame: string | Uint8Array): boolean {
  try {
    decode(kind, frame);
    return true;
  } catch (error) {
    assert.ok(error instanceof DecodeError, `a crash: ${String(error)}`);
    return false;
  }
}

/** The rules of section 1.1 over what `JSON.parse` alone would accept. */
function judge(json: string): boolean {
  let members = 0;
  let finite = true;
  let wellFormed = /^\P{Surrogate}*$/u.test(json);
  let value: unknown;
  try {
    value = JSON.parse(json, (name, item: unknown) => {
      if (typeof item === "number" && !Number.isFinite(item)) finite = false;
      if (typeof item === "string" && /\p{Surrogate}/u.test(item)) wellFormed = false;
      if (/\p{Surrogate}/u.test(name)) wellFormed = false;
      return item;
    });
  } catch {
    return false;
  }
  const count = (item: unknown): void => {
    if (typeof item !== "object" || item === null) return;
    if (!Array.isArray(item)) members += Object.keys(item).length;
    for (const inner of Object.values(item)) count(inner);
  };
  count(value);
  // Outside of strings, a colon stands once a member; a repeated one leaves fewer members than colons.
  const colons = json.replace(/"(?:\\.|[^"\\])*"/g, "").split(":").length - 1;
  return finite && wellFormed && colons === members;
}

function randomJson(random: Random, level: number): string {
  const space = random.chance(6) ? random.pick([" ", "\n", "\t\r"]) : "";
  switch (random.below(level > 3 ? 5 : 7)) {
    case 0:
      return space + random.pick(["null", "true", "false"]);
    case 1:
      return space + String(random.integer());
    case 2:
      return (
        space + random.pick([random.double().toString(), random.double().toExponential(), "-0", "1e400", "1E-400"])
      );
    case 3:
    case 4:
      return space + randomString(random) + space;
    case 5:
      return `[${space}${Array.from({ length: random.below(4) }, () => randomJson(random, level + 1)).join(",")}]${space}`;
    default: {
      const member = (): string => `${randomString(random)}${space}:${randomJson(random, level + 1)}`;
      return `{${Array.from({ length: random.below(4) }, member).join(",")}}`;
    }
  }
}

function randomString(random: Random): string {
  if (random.chance(8))
    return random.pick(['"\\ud83d"', '"\\ude00"', '"\\ud83d\\ude00"', '"\\u0041\\/"', '"a"', '"\\u0061"']);
  return JSON.stringify(random.text(3));
}

function mutated(random: Random, json: string): string {
  if (random.chance(2) || json.length === 0) return json;
  const at = random.below(json.length);
  const put = random.pick([
    "",
    "",
    '"',
    "\\",
    ",",
    ":",
    "{",
    "}",
    "[",
    "]",
    "0",
    "-",
    ".",
    "e",
    "\u0001",
    " ",
    "u",
    "a",
  ]);
  return json.slice(0, at) + put + json.slice(at + random.below(2));
}
