import assert from "node:assert/strict";
import { execFile, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { promisify } from "node:util";
import { NCP_CONTRACT_HASH, NCP_VERSION } from "@ncp-conformance/peer";
import { PACKAGE } from "./installed.js";

const ADAPTER = join(PACKAGE, "dist/adapter-module.js");
const shim = (name: string): string => join(PACKAGE, "test/shims", name);

interface Case {
  readonly call: string;
  readonly outcome: string;
  readonly status: string;
  readonly rules: string[];
}

/** What ncp-verify says of a module: the cases that these options choose. */
async function verdict(module: string, ...options: string[]): Promise<Case[]> {
  const folder = mkdtempSync(join(tmpdir(), "ncp-module-"));
  try {
    const result = join(folder, "result.json");
    const peer = `'${process.execPath}' '${ADAPTER}' --module '${module}'`;
    const verify = ["run", "--quiet", "--profile", "verify", "-p", "ncp-verifier", "--", "run", "--level", "safety"];
    // A peer that fails ends the program with 1.
    await promisify(execFile)("cargo", [...verify, ...options, "--peer-cmd", peer, "--json", result], {
      cwd: join(PACKAGE, "../.."),
      maxBuffer: 1 << 26,
    }).catch(() => undefined);
    return (JSON.parse(readFileSync(result, "utf8")) as { peers: { cases: Case[] }[] }).peers[0]!.cases;
  } finally {
    rmSync(folder, { recursive: true });
  }
}

function ask(module: string, ...calls: [call: string, args: unknown][]): Record<string, unknown>[] {
  const input = calls.map(([call, args], id) => `${JSON.stringify({ id, call, args })}\n`).join("");
  const { stdout, status } = spawnSync(process.execPath, [ADAPTER, "--module", module], { input, encoding: "utf8" });
  assert.equal(status, 0);
  return stdout
    .trimEnd()
    .split("\n")
    .map((line) => JSON.parse(line) as Record<string, unknown>);
}

const count = (cases: Case[], call: string, outcome: string): number =>
  cases.filter((found) => found.call === call && found.outcome === outcome).length;

test("a module is described by its own constants, and what it prints goes to the log", () => {
  const [described, version] = ask(
    shim("parsed.cjs"),
    ["describe", {}],
    ["version.check", { version: NCP_VERSION, strict: true }],
  );
  const { wire_version, contract_hash, roles } = described!["result"] as Record<string, unknown>;
  assert.deepEqual([wire_version, contract_hash, roles], [NCP_VERSION, NCP_CONTRACT_HASH, ["commander"]]);
  assert.deepEqual(version, { id: 1, result: { compatible: true } });
});

/** A third of the cases, of each call some: `ncp-verify` asks this library all of them by its own adapter. */
const SOME = ["--shard", "1/3"];

const skip = process.env["NCP_NO_VERIFIER"] !== undefined;

for (const [what, module, lossy] of [
  ["our own build", join(PACKAGE, "dist/index.js"), false],
  ["our own build for require", join(PACKAGE, "dist/cjs/index.js"), false],
  ["a module with the published API alone", shim("published.mjs"), false],
  ["one whose bus parses", shim("parsed.cjs"), true],
] as const) {
  test(`${what} fails nothing`, { skip }, async () => {
    const cases = await verdict(module, ...SOME);
    const outcomes = new Set(cases.map(({ outcome }) => outcome));
    assert.deepEqual([...outcomes].sort(), ["pass", "unsupported"]);
    for (const call of ["version.check", "contract.status", "negotiate"]) {
      assert.equal(count(cases, call, "unsupported"), 0, call);
      assert.ok(count(cases, call, "pass") > 5, call);
    }
    // What a bus loses is not asked of the module behind it.
    assert.equal(count(cases, "reply.check", "unsupported") > 0, lossy);
    assert.ok(count(cases, "reply.check", "pass") > 20);
  });
}

test("a client that judges nothing fails by the rules about replies, and a crash is one", { skip }, async () => {
  const cases = await verdict(shim("unjudging.mjs"), "--filter", "version.check", "--filter", "reply.check");
  assert.equal(count(cases, "version.check", "pass"), 0);
  assert.ok(count(cases, "reply.check", "fail") > 80);
  assert.ok(count(cases, "reply.check", "pass") > 0);
  const rules = cases.filter(({ call, status }) => call === "reply.check" && status === "failed");
  assert.ok(rules.some((found) => found.rules.includes("NCP-SESS-006")));
});
