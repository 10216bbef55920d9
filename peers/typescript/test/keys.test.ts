import assert from "node:assert/strict";
import { test } from "node:test";
import { isSegment, Keys, matches, PLANES, validateRealm, validateSegment } from "@ncp-conformance/peer";
import { Random, refuses } from "./support.js";

test("the keys of the default realm are those of the text", () => {
  for (const keys of [new Keys(), new Keys(null), new Keys("ncp")]) {
    assert.equal(keys.rpc(), "ncp/rpc");
    assert.equal(keys.sensor("a"), "ncp/session/a/sensor");
    assert.equal(keys.sensor("a", "front"), "ncp/session/a/sensor/front");
    assert.equal(keys.sensor("a", null), "ncp/session/a/sensor");
    assert.equal(keys.command("a"), "ncp/session/a/command");
    assert.equal(keys.command("a", "arm"), "ncp/session/a/command/arm");
    assert.equal(keys.observation("a"), "ncp/session/a/observation");
    assert.equal(keys.sensorGlob("a"), "ncp/session/a/sensor/**");
    assert.equal(keys.commandGlob("a"), "ncp/session/a/command/**");
    assert.equal(keys.sessionGlob("a"), "ncp/session/a/**");
    assert.equal(keys.fleetGlob(), "ncp/session/**");
  }
});

test("a realm, an id and a name stand in the key unchanged", () => {
  const keys = new Keys("Engram/ncp/e\u0301");
  assert.equal(keys.rpc(), "Engram/ncp/e\u0301/rpc");
  assert.equal(keys.sensor("UAV-3:%2F", "ÄÖ😀"), "Engram/ncp/e\u0301/session/UAV-3:%2F/sensor/ÄÖ😀");
});

const INVALID = [
  "",
  "/",
  "a/b",
  "/a",
  "a/",
  "*",
  "**",
  "a*",
  "$",
  "$*",
  "a$",
  "#",
  "a#b",
  "?",
  "a?",
  " ",
  "a b",
  " a",
  "a\t",
  "a\n",
  "\va",
  "a\f",
  "a\r",
  "@",
  "@a",
  ".",
  "..",
  "\0",
  "a\u0001",
  "\u001f",
  "\u007f",
  "\u0080",
  "a\u009f",
  "\ud800",
  "x".repeat(257),
  "é".repeat(129),
  "😀".repeat(65),
];
const VALID = [
  "a",
  "0",
  "a@",
  "...",
  ".a",
  "a.",
  "-",
  "_",
  "~",
  "é",
  "\u00a0",
  "\u2028",
  "日本",
  "😀",
  "x".repeat(256),
  "é".repeat(128),
  "😀".repeat(64),
  "__proto__",
  "%2F",
  "a\\b",
  '"',
  "\ufeff",
];

test("a segment that no key may hold is refused, as an id and as a name", () => {
  const keys = new Keys();
  for (const segment of INVALID) {
    refuses("key", () => validateSegment(segment));
    assert.equal(isSegment(segment), false);
    for (const build of [
      keys.sensor,
      keys.command,
      keys.observation,
      keys.sensorGlob,
      keys.commandGlob,
      keys.sessionGlob,
    ]) {
      refuses("key", () => build.call(keys, segment));
    }
    refuses("key", () => keys.sensor("a", segment));
    refuses("key", () => keys.command("a", segment));
  }
});

test("every other segment is accepted, of any script", () => {
  for (const segment of VALID) {
    validateSegment(segment);
    assert.equal(new Keys(segment).sensor(segment, segment), `${segment}/session/${segment}/sensor/${segment}`);
  }
});

test("a realm is checked segment by segment", () => {
  for (const segment of INVALID.filter((segment) => segment !== "a/b")) {
    for (const realm of [segment, `a/${segment}`, `${segment}/a`, `a/${segment}/b`])
      refuses("key", () => validateRealm(realm));
  }
  validateRealm(Array.from({ length: 20 }, () => "x".repeat(256)).join("/"));
});

test("a value that is no text is refused as a key and not as a crash", () => {
  for (const value of [1, {}, [], true]) {
    refuses("key", () => new Keys(value as unknown as string));
    refuses("key", () => new Keys().sensor(value as unknown as string));
    refuses("key", () => matches(value as unknown as string, "a"));
  }
});

test("a pattern covers the keys that the text's wildcards say", () => {
  const cases: [string, string, boolean][] = [
    ["ncp/rpc", "ncp/rpc", true],
    ["ncp/rpc", "ncp/rpc/x", false],
    ["ncp/rpc", "ncp", false],
    ["ncp/rpc", "NCP/rpc", false],
    ["a/*", "a/b", true],
    ["a/*", "a", false],
    ["a/*", "a/b/c", false],
    ["*", "a", true],
    ["*/*", "a/b", true],
    ["*/b", "a/b", true],
    ["a/*/c", "a/b/c", true],
    ["a/*/c", "a/c", false],
    ["**", "a", true],
    ["**", "a/b/c", true],
    ["a/**", "a", true],
    ["a/**", "a/b", true],
    ["a/**", "a/b/c", true],
    ["a/**", "b", false],
    ["**/c", "c", true],
    ["**/c", "a/b/c", true],
    ["**/c", "a/c/b", false],
    ["a/**/c", "a/c", true],
    ["a/**/c", "a/b/b/c", true],
    ["a/**/c/**/d", "a/x/c/c/y/d", true],
    ["a/**/c/**/d", "a/x/d/c", false],
    ["**/a/**/a", "a", false],
    ["**/*", "a", true],
    ["*/**", "a", true],
    ["**/*/**", "a/b", true],
    ["a/**/*", "a", false],
    ["a/**/**", "a", true],
    ["ncp/session/**", "ncp/session", true],
    ["ncp/session/a/sensor/**", "ncp/session/a/sensor", true],
    ["ncp/session/a/sensor/**", "ncp/session/a/sensor/front", true],
    ["ncp/session/a/sensor/**", "ncp/session/a/sensors", false],
    ["a$*", "a", true],
    ["a$*", "abc", true],
    ["a$*", "ba", false],
    ["a$*", "a/b", false],
    ["$*c", "abc", true],
    ["a$*c", "ac", true],
    ["a$*c", "abcb", false],
    ["a$*b$*c", "aXbYc", true],
    ["a$*b$*c", "acb", false],
    ["$*ab$*ab", "ab", false],
    ["$*ab$*ab", "abab", true],
    ["a$*a", "a", false],
    ["a$*a", "aa", true],
    ["$*", "a", true],
    ["a$*$*b", "ab", true],
    ["😀$*", "😀é", true],
    ["*", "@a", false],
    ["**", "@a", false],
    ["**", "a/@b", false],
    ["$*", "@a", false],
    ["$*a", "@a", false],
    ["@$*", "@a", false],
    ["@a", "@a", true],
    ["a/@b/**", "a/@b/c", true],
    ["**/@b", "a/@b", true],
    ["**/@b/**", "a/@b/c", true],
    ["**/@b/**", "@b/@b", false],
    ["a/*/c", "a/@b/c", false],
    ["*", "a@b", true],
    ["a/**/c", "a/@b/c", false],
    ["**/c/**", "c/@x/c", false],
    ["**/c/**/@x/**", "c/@x/c", true],
  ];
  for (const [pattern, key, covered] of cases) assert.equal(matches(pattern, key), covered, `${pattern} over ${key}`);
});

test("what is no key expression is refused", () => {
  for (const expression of [
    "",
    "/",
    "a/",
    "/a",
    "a//b",
    "a#",
    "?",
    "a*",
    "*a",
    "***",
    "a**",
    "$",
    "a$b",
    "$a",
    "**$*",
    "$**",
    "$$*",
    "\ud800",
  ]) {
    refuses("key", () => matches(expression, "a"));
    refuses("key", () => matches("a", expression));
  }
  for (const key of ["*", "**", "a/**", "a$*"]) refuses("key", () => matches("**", key));
});

test("matching agrees with a plain recursive definition on random expressions", () => {
  const random = new Random(5);
  const chunk = (): string => random.pick(["a", "b", "ab", "@a", "aab"]);
  const wild = (): string => random.pick(["a", "b", "ab", "@a", "*", "**", "**", "a$*", "$*b", "$*a$*", "a$*b"]);
  for (let n = 0; n < 20_000; n++) {
    const pattern = Array.from({ length: 1 + random.below(5) }, wild);
    const key = Array.from({ length: 1 + random.below(5) }, chunk);
    assert.equal(
      matches(pattern.join("/"), key.join("/")),
      covers(pattern, key),
      `${pattern.join("/")} over ${key.join("/")}`,
    );
  }
});

test("matching does not take exponential time", () => {
  const begin = performance.now();
  assert.equal(matches(`${"**/a/".repeat(200)}b`, `${"a/".repeat(2_000)}a`), false);
  assert.equal(matches(`${"$*a".repeat(200)}b`, "a".repeat(5_000)), false);
  assert.ok(performance.now() - begin < 1_000);
});

test("each plane has the quality of service of the text", () => {
  assert.deepEqual(PLANES, {
    control: { congestion: "block", priority: "Data", express: false },
    perception: { congestion: "drop", priority: "DataHigh", express: false },
    action: { congestion: "drop", priority: "RealTime", express: true },
    observation: { congestion: "block", priority: "Data", express: false },
  });
});

function covers(pattern: readonly string[], key: readonly string[]): boolean {
  const [first, ...rest] = pattern;
  if (first === undefined) return key.length === 0;
  if (first === "**")
    return covers(rest, key) || (key.length > 0 && !key[0]!.startsWith("@") && covers(pattern, key.slice(1)));
  if (key.length === 0) return false;
  return coversChunk(first, key[0]!) && covers(rest, key.slice(1));
}

function coversChunk(pattern: string, chunk: string): boolean {
  if (chunk.startsWith("@")) return pattern === chunk;
  const expression = pattern === "*" ? ".*" : pattern.split("$*").join(".*");
  return new RegExp(`^${expression}$`).test(chunk);
}
