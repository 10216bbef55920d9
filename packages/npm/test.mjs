// Each case of the suite as a test of node:test, from one run of ncp-verify.
import { execFile } from "node:child_process";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { describe, it } from "node:test";
import { promisify } from "node:util";
import { program } from "./index.mjs";

const run = promisify(execFile);

/** Has the program check the peer, and registers a test for each case; the result is what the program wrote. */
export async function conform({ command, connect, level = "wire", filter = [], expected, deep = false }) {
  const folder = await mkdtemp(join(tmpdir(), "ncp-verify-"));
  try {
    const file = join(folder, "result.json");
    const args = ["run", "--color", "never", "--level", level, "--json", file];
    if (connect) args.push("--connect", connect);
    else args.push("--peer-cmd", typeof command === "string" ? command : command.map(quoted).join(" "));
    for (const pattern of [filter].flat()) args.push(`--filter=${pattern}`);
    if (expected) args.push("--expected", expected);
    if (deep) args.push("--deep");
    try {
      await run(program(), args, { maxBuffer: 2 ** 28 });
    } catch (error) {
      // Not conformant: the cases say why.
      if (error.code !== 1) throw new Error(`ncp-verify: ${error.stderr?.trim() || error.message}`);
    }
    const result = JSON.parse(await readFile(file, "utf8"));
    register(result);
    return result;
  } finally {
    await rm(folder, { recursive: true, force: true });
  }
}

/** A word of a command, as a shell would have it. */
function quoted(word) {
  return `'${word.replaceAll("'", "'\\''")}'`;
}

function register(result) {
  const [peer] = result.peers;
  for (const [area, cases] of grouped(peer.cases)) {
    describe(area, () => cases.forEach((one) => it(one.id, (test) => tell(test, one, result))));
  }
  it("verdict", () => {
    if (result.exit_code !== 0) throw failure(verdict(peer));
  });
}

function areaOf({ id }) {
  return `ncp/${id.split("/")[0]}`;
}

function grouped(cases) {
  const areas = new Map();
  for (const one of cases) areas.set(areaOf(one), [...(areas.get(areaOf(one)) ?? []), one]);
  return areas;
}

/** Reports what the result says of a case. */
function tell(test, one, result) {
  if (one.status === "passed") return;
  if (one.status === "expected failure") test.todo(`expected failure: ${one.reason ?? ""}`);
  else if (one.outcome === "unsupported" && one.status !== "unexpected pass") {
    return test.skip(`unsupported: the peer has no ${one.call} for this`);
  } else if (one.status === "advice") return test.diagnostic(told(one, result));
  throw failure(told(one, result));
}

function told(one, result) {
  const charged = one.charged ?? one.rules[0];
  const rule = result.rules.find(({ id }) => id === charged);
  const lines = [`${one.status === "failed" ? one.outcome : one.status}: ${one.title}`];
  lines.push(`${charged}: ${rule?.sentence ?? ""}`);
  if (one.what) lines.push(one.outcome === "not run" ? one.what : `it ${one.what}`);
  for (const difference of one.differences ?? []) lines.push(difference.text);
  for (const member of ["expected", "request", "answer", "log", "note", "reason"]) {
    if (one[member] !== undefined) lines.push(`${member}: ${one[member]}`);
  }
  return lines.join("\n");
}

function verdict(peer) {
  const failed = peer.cases.filter(({ status }) => ["failed", "unexpected pass", "not run"].includes(status));
  const stale = peer.expected_failures.filter((entry) => entry.stale || entry.expired || entry.stale_cases.length);
  const lines = [`${peer.conclusion ?? peer.state}: ${failed.length} cases`];
  if (peer.run?.given_up) lines.push(`given up: ${peer.run.given_up}`);
  return [...lines, ...stale.map(({ entry }) => `${entry}: stale or expired`)].join("\n");
}

/** An error without a stack: where this file throws is of no interest. */
function failure(message) {
  const error = new Error(message);
  error.stack = message;
  return error;
}
