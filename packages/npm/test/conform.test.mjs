// The tests that conform registers, by files of tests that check right and wrong peers. NCP_VERIFY names the program.
import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { createServer } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { fileURLToPath } from "node:url";

const project = fileURLToPath(new URL("../../..", import.meta.url));
const folder = mkdtempSync(join(tmpdir(), "ncp-conform-"));
after(() => rmSync(folder, { recursive: true }));
const right = ["python3", join(project, "peers/python-pure/adapter.py")];

/** Runs a file of tests that only conforms. */
function conformed(options, env = {}) {
  const file = join(folder, "peer.test.mjs");
  const module = new URL("../test.mjs", import.meta.url).href;
  writeFileSync(file, `import { conform } from ${JSON.stringify(module)};\nawait conform(${JSON.stringify(options)});\n`);
  const { NODE_OPTIONS, NODE_TEST_CONTEXT, ...rest } = process.env;
  const args = ["--test", "--test-reporter=tap", file];
  return spawnSync(process.execPath, args, { encoding: "utf8", env: { ...rest, ...env }, cwd: folder });
}

/** The right peer, but every version is compatible. */
function wrong() {
  const file = join(folder, "planted.py");
  writeFileSync(
    file,
    `import json, subprocess, sys
peer = subprocess.Popen(${JSON.stringify(right)}, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1)
for line in sys.stdin:
    peer.stdin.write(line)
    answer = json.loads(peer.stdout.readline())
    if json.loads(line)["call"] == "version.check" and "result" in answer:
        answer["result"]["compatible"] = True
    print(json.dumps(answer), flush=True)
`,
  );
  return ["python3", file];
}

test("a right peer passes each case and the verdict", () => {
  const { status, stdout } = conformed({ command: right, filter: "version/" });
  assert.equal(status, 0, stdout);
  assert.match(stdout, /^ +ok \d+ - version\//m);
  assert.match(stdout, /ok \d+ - verdict/);
});

test("a peer that listens is tested where it listens", async () => {
  const port = await new Promise((found) => {
    const free = createServer().listen(0, "127.0.0.1", () => {
      const { port } = free.address();
      free.close(() => found(port));
    });
  });
  const serve = `import socket, subprocess, sys
server = socket.create_server(("127.0.0.1", int(sys.argv[1])))
while True:
    with server.accept()[0] as connection:
        subprocess.run(sys.argv[2:], stdin=connection, stdout=connection)
`;
  const server = spawn("python3", ["-c", serve, `${port}`, ...right]);
  try {
    const { status, stdout } = conformed({ connect: `tcp://127.0.0.1:${port}`, filter: "version/" });
    assert.equal(status, 0, stdout);
    assert.match(stdout, /^ +ok \d+ - version\/guard\/lenient\/older-minor$/m);
  } finally {
    server.kill();
  }
});

test("a wrong peer fails with the rule and what differs", () => {
  const { status, stdout } = conformed({ command: wrong(), filter: "version/" });
  assert.equal(status, 1, stdout);
  assert.match(stdout, /not ok \d+ - version\//);
  assert.match(stdout, /NCP-VER-\d{3}: .*\S/);
  assert.match(stdout, /\/compatible: expected false, got true/);
  assert.match(stdout, /not ok \d+ - verdict/);
});

test("an expected failure is to do, and an unexpected pass fails", () => {
  const expected = join(folder, "known.toml");
  const args = ["run", "--level", "wire", "--filter", "version/", "--peer-cmd", wrong().join(" ")];
  args.push("--json", join(folder, "result.json"), "--write-expected", expected);
  spawnSync(process.env.NCP_VERIFY, args);
  const known = conformed({ command: wrong(), filter: "version/", expected });
  assert.equal(known.status, 0, known.stdout);
  assert.match(known.stdout, /# TODO expected failure/);
  const mended = conformed({ command: right, filter: "version/", expected });
  assert.equal(mended.status, 1, mended.stdout);
  assert.match(mended.stdout, /unexpected pass/);
});

test("a peer that dies at start, and a program that is missing, are said", () => {
  const dead = conformed({ command: ["false"], filter: "version/" });
  assert.equal(dead.status, 1);
  assert.match(dead.stdout, /exited with status 1 before it answered/);
  const missing = conformed({ command: right }, { NCP_VERIFY: "/nowhere/ncp-verify" });
  assert.equal(missing.status, 1);
  assert.match(missing.stdout, /nowhere/);
});
