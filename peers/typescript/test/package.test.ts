import assert from "node:assert/strict";
import { execFile, spawn } from "node:child_process";
import { once } from "node:events";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { createServer, type AddressInfo } from "node:net";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { promisify } from "node:util";
import { NCP_VERSION } from "@ncp-conformance/peer";
import { commands, examples, Installed, PACKAGE } from "./installed.js";
import { TestServer } from "./web-socket-server.js";

const run = promisify(execFile);
/** For programs that are no tests of this runner. */
const { NODE_OPTIONS, NODE_TEST_CONTEXT, ...env } = process.env;

let server: TestServer;
let installed: Installed;

before(async () => {
  server = await TestServer.start();
  installed = new Installed(server.port);
});
after(async () => {
  installed?.remove();
  await server?.stop();
});

/** Runs a file of the folder and returns what it prints. */
async function node(file: string, ...options: string[]): Promise<string> {
  const { stdout, stderr } = await run(process.execPath, [...options, file], { cwd: installed.folder, env, timeout: 30_000 });
  assert.equal(stderr, "");
  return stdout;
}

test("the package installs without dependencies, tests, adapter or leftovers of the build", () => {
  assert.deepEqual(installed.packages().sort(), ["@ncp-conformance", "ws"]);
  const files = installed.files();
  const documents = ["README.md", "LICENSE-APACHE", "LICENSE-MIT"];
  for (const file of ["dist/index.js", "dist/index.d.ts", "dist/cjs/index.js", "dist/cjs/index.d.ts", ...documents]) {
    assert.ok(files.includes(file), `${file} is missing`);
  }
  assert.deepEqual(
    files.filter((file) => /test|adapter|tsbuildinfo/.test(file)),
    [],
  );
  const root = join(installed.folder, "node_modules/@ncp-conformance/peer");
  const manifest = JSON.parse(readFileSync(join(root, "package.json"), "utf8")) as Record<string, unknown>;
  for (const field of ["dependencies", "peerDependencies", "optionalDependencies"]) assert.ok(!(field in manifest));
  for (const file of files.filter((file) => file.endsWith(".map"))) {
    const { sources } = JSON.parse(readFileSync(join(root, file), "utf8")) as { sources: string[] };
    for (const source of sources) assert.ok(existsSync(join(root, dirname(file), source)), `${file} names ${source}`);
  }
});

test("the README names commands and examples that are there", () => {
  assert.deepEqual([...examples().keys()], ["server.mjs", "client.mjs", "client.cjs", "index.html"]);
  assert.deepEqual(commands(), [
    "npm ci",
    "npm pack",
    "npm install path/to/ncp-conformance-peer-0.1.0.tgz ws",
    "node server.mjs &",
    "node client.mjs",
  ]);
});

test("the README's client runs a session as an ES module, and prints what the README says", async () => {
  // The interval is ln(20 / 5) · 10 ms on the grid of 0.1 ms, and 2 ms of rest: 13.9, then 15.9 more each time.
  const printed = "50 ms, spikes at 13.9, 29.8, 45.7 ms";
  assert.equal(await node("client.mjs"), `${printed}\n`);
  assert.ok(examples().get("client.mjs")!.includes(`// ${printed}\n`));
});

test("the README's client runs with the WebSocket of the runtime, without that of ws", async () => {
  const text = readFileSync(join(installed.folder, "client.mjs"), "utf8");
  const own = text.replace(/^import .* from "ws".*\n/m, "").replace(", { WebSocket }", "");
  assert.ok(!/ws"|WebSocket }\)/.test(own));
  writeFileSync(join(installed.folder, "client-own.mjs"), own);
  // In Node 20 it is there on request; later versions take the option as well.
  const printed = await node("client-own.mjs", "--experimental-websocket", "--no-warnings");
  assert.equal(printed, "50 ms, spikes at 13.9, 29.8, 45.7 ms\n");
});

test("the README's client runs a session as CommonJS", async () => {
  assert.equal(await node("client.cjs"), `${NCP_VERSION} true match\n`);
});

test("the README's server serves the README's client", async (t) => {
  const probe = createServer().listen(0, "127.0.0.1");
  await once(probe, "listening");
  const port = String((probe.address() as AddressInfo).port);
  probe.close();
  for (const file of ["server.mjs", "client.mjs"]) {
    writeFileSync(join(installed.folder, `own-${file}`), examples().get(file)!.replaceAll("28475", port));
  }
  const own = spawn(process.execPath, ["own-server.mjs"], { cwd: installed.folder, env, stdio: "inherit" });
  t.after(() => own.kill());
  // The client comes first or second: it waits for its server.
  assert.equal(await node("own-client.mjs"), "50 ms, spikes at 13.9, 29.8, 45.7 ms\n");
});

test("both builds offer the same names, among them those of the published client", async () => {
  writeFileSync(
    join(installed.folder, "names.mjs"),
    `import { createRequire } from "node:module";
     import * as esm from "@ncp-conformance/peer";
     const require = createRequire(import.meta.url);
     const cjs = require("@ncp-conformance/peer");
     console.log(JSON.stringify([
       ...[esm, cjs].map((of) => Object.keys(of).sort()),
       [import.meta.resolve("@ncp-conformance/peer"), require.resolve("@ncp-conformance/peer")],
     ]));`,
  );
  const [esm, cjs, paths] = JSON.parse(await node("names.mjs")) as [string[], string[], string[]];
  assert.match(paths[0]!, /peer\/dist\/index\.js$/);
  assert.match(paths[1]!, /peer[/\\]dist[/\\]cjs[/\\]index\.js$/); // New Nodes could require the other one, too.
  assert.deepEqual(esm, cjs);
  for (const name of [
    "NCP_VERSION",
    "NCP_CONTRACT_HASH",
    "checkVersion",
    "contractStatus",
    "assertScientificBoundary",
    "NcpVersionError",
    "NcpScientificBoundaryError",
    "NeuroSimClient",
    "WebSocketNeuroSim",
  ]) {
    assert.ok(esm.includes(name), `${name} is missing`);
  }
});

const CONSUMER = `
  import { NeuroSimClient, WebSocketNeuroSim, checkVersion, type Send, type wire } from "@ncp-conformance/peer";

  const send: Send = (request, options) => Promise.resolve(options?.signal?.aborted ? "" : request);
  export async function use(client: NeuroSimClient = new WebSocketNeuroSim("ws://h")): Promise<number[]> {
    const opened: wire.SessionOpened = await client.open({ session_id: "s", network: { ref: "x" } });
    // @ts-expect-error: an id is a string
    await client.step({ session_id: 5 });
    // @ts-expect-error: the time of a run is required
    await client.run({ session_id: "s" });
    const { records } = await client.step({ session_id: opened.session_id }, { timeoutMs: 5 });
    // @ts-expect-error: no such field
    void opened.nothing;
    return Object.values(records).flatMap((record) => record.values);
  }
  export const client: NeuroSimClient = new NeuroSimClient(send, { strict: checkVersion("1.0") });
`;

for (const [what, file, options] of [
  ["an ES module by Node's rules", "consumer.mts", { module: "Node16", lib: ["ES2022", "DOM"], types: [] }],
  ["CommonJS by Node's rules", "consumer.cts", { module: "Node16", lib: ["ES2022"], types: ["node"] }],
  ["a bundler", "consumer.ts", { module: "ESNext", moduleResolution: "Bundler", lib: ["ES2022", "DOM"], types: [] }],
  ["an old resolver", "old.ts", { module: "CommonJS", moduleResolution: "Node10", lib: ["ES2022", "DOM"], types: [] }],
] as const) {
  test(`the types resolve for ${what}, and catch mistakes`, async () => {
    writeFileSync(join(installed.folder, file), CONSUMER);
    const config = {
      compilerOptions: {
        target: "ES2022",
        strict: true,
        noEmit: true,
        skipLibCheck: false,
        typeRoots: [join(PACKAGE, "node_modules/@types")],
        ...options,
      },
      files: [file],
    };
    writeFileSync(join(installed.folder, `${file}.json`), JSON.stringify(config));
    const tsc = join(PACKAGE, "node_modules/typescript/bin/tsc");
    await run(process.execPath, [tsc, "-p", `${file}.json`], { cwd: installed.folder, env }).catch(
      (error: { stdout: string }) => assert.fail(error.stdout),
    );
  });
}
