import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { createServer, type Server } from "node:http";
import { readFile } from "node:fs/promises";
import type { AddressInfo } from "node:net";
import { once } from "node:events";
import { tmpdir } from "node:os";
import { extname, join, normalize } from "node:path";
import { after, before, test } from "node:test";
import { chromium, type BrowserContext, type Page } from "playwright-core";
import { Installed } from "../installed.js";
import { answer, TestServer } from "../web-socket-server.js";

type Library = typeof import("@ncp-conformance/peer");

let server: TestServer;
let installed: Installed;
let web: Server;
let profile: string;
let browser: BrowserContext;

before(async () => {
  server = await TestServer.start();
  installed = new Installed(server.port);
  web = await serve(installed.folder);
  profile = mkdtempSync(join(tmpdir(), "ncp-chromium-"));
  browser = await chromium.launchPersistentContext(profile, {
    executablePath: process.env["NCP_CHROMIUM"] ?? (await onPath("chromium")),
    headless: true,
    args: [
      "--no-sandbox",
      "--disable-gpu",
      "--disable-quic",
      "--no-first-run",
      "--disable-background-networking",
      "--disable-component-update",
      "--disable-sync",
    ],
  });
});
after(async () => {
  await browser?.close();
  web?.close();
  await server?.stop();
  installed?.remove();
  if (profile !== undefined) rmSync(profile, { recursive: true, force: true });
});

/** Opens the README's page, and fails the test for whatever goes wrong in it. */
async function openPage(): Promise<{ page: Page; wrong: string[] }> {
  const page = await browser.newPage();
  const wrong: string[] = [];
  page.on("pageerror", (error) => wrong.push(String(error)));
  page.on("requestfailed", (request) => wrong.push(`${request.url()} failed`));
  await page.goto(`http://localhost:${(web.address() as AddressInfo).port}/index.html`);
  return { page, wrong };
}

test("the README's page runs a session in a browser", async () => {
  const { page, wrong } = await openPage();
  await page.getByText("closed").waitFor({ timeout: 20_000 });
  // V = −70 + 20·(1 − exp(−t / 10)) mV while it is below the threshold, and at −70 for the 2 ms after 13.9 ms.
  const volts = (t: number): string => (-70 + 20 * (1 - Math.exp(-t / 10))).toFixed(3);
  assert.equal(
    (await page.locator("#log").innerText()).trimEnd(),
    [
      "session demo-browser runs on ncp.reference",
      `5 ms: ${volts(5)} mV`,
      `10 ms: ${volts(10)} mV`,
      `15 ms: ${(-70).toFixed(3)} mV`,
      `20 ms: ${volts(20 - 15.9)} mV`,
      "closed",
    ].join("\n"),
  );
  assert.deepEqual(wrong, []);
  const screenshot = process.env["NCP_SCREENSHOT"];
  if (screenshot !== undefined) await page.screenshot({ path: screenshot });
  await page.close();
});

test("in a browser, too, the client times out, is aborted, finds its server again, and names what went wrong", async () => {
  const { page, wrong } = await openPage();
  await page.getByText("closed").waitFor({ timeout: 20_000 });
  const before = server.connections;
  server.behave = (request, socket) => {
    const { duration_ms } = JSON.parse(request) as { duration_ms?: number };
    if (duration_ms === 404) return socket.terminate();
    if (duration_ms !== 408) answer(request, socket, server);
  };
  const told = await page.evaluate(async (url) => {
    const name = "@ncp-conformance/peer";
    const ncp = (await import(name)) as Library;
    const client = new ncp.WebSocketNeuroSim(url, { retryMs: 5 });
    const session_id = "lab";
    const outcome = async (request: Promise<object>): Promise<string> =>
      request.then(
        (frame) => `${(frame as { sim_time_ms: number }).sim_time_ms} ms`,
        (error: Error) => error.name,
      );
    const opened = await client.open({ session_id, network: { ref: "ncp.reference.rate" } });
    const run = (duration_ms: number, options = {}): Promise<string> =>
      outcome(client.run({ session_id, duration_ms }, options));
    const aborted = (request: (signal: AbortSignal) => Promise<string>): Promise<string> => {
      const abort = new AbortController();
      setTimeout(() => abort.abort(), 50);
      return request(abort.signal);
    };
    const outcomes = [
      ncp.contractStatus(opened.contract_hash),
      await run(10),
      await run(408, { timeoutMs: 50 }),
      await run(10),
      await aborted((signal) => run(408, { signal })),
      await run(404),
      await run(10),
      await outcome(client.step({ session_id: "nobody" })),
      await outcome(client.step({ session_id: "a/b" })),
      String(await client.close(session_id)),
      client.transport.state,
    ];
    client.disconnect();
    return [...outcomes, client.transport.state];
  }, server.url);
  assert.deepEqual(told, [
    "match",
    "10 ms",
    "NcpTimeoutError",
    "20 ms",
    "AbortError",
    "NcpConnectionError",
    "30 ms",
    "NcpServerError",
    "EncodeError",
    "true",
    "open",
    "closed",
  ]);
  assert.equal(server.connections - before, 4);
  assert.deepEqual(wrong, []);
  await page.close();
});

/** Serves the files of a folder. */
async function serve(folder: string): Promise<Server> {
  const types: Record<string, string> = { ".html": "text/html", ".js": "text/javascript" };
  const web = createServer((request, response) => {
    const path = normalize(new URL(request.url ?? "/", "http://localhost").pathname);
    readFile(join(folder, path)).then(
      (content) => {
        response.setHeader("content-type", `${types[extname(path)] ?? "application/octet-stream"}; charset=utf-8`);
        response.end(content);
      },
      () => response.writeHead(404).end(),
    );
  });
  web.listen(0, "localhost");
  await once(web, "listening");
  return web;
}

/** The path of a program. */
async function onPath(program: string): Promise<string> {
  const which = spawn(process.platform === "win32" ? "where" : "which", [program]);
  let path = "";
  which.stdout.on("data", (data) => (path += String(data)));
  await once(which, "close");
  assert.notEqual(path, "", `${program} is not on the path; NCP_CHROMIUM can say where it is`);
  return path.trim().split("\n")[0]!;
}
