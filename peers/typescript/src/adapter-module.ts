/**
 * The program that puts any module with the published TypeScript API under test, unchanged:
 * `node adapter-module.js --module PATH`. It is linked with no implementation of NCP, and decides nothing.
 *
 * @module
 */

import { existsSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { parseArgs } from "node:util";

/** What a client is given to send with, and what it sends and is told: texts or parsed JSON, as the module has it. */
type Send = (request: unknown) => Promise<unknown>;

interface Client {
  open(request: unknown): Promise<unknown>;
  step(request: unknown): Promise<unknown>;
  run(request: unknown): Promise<unknown>;
  close(session: unknown): Promise<unknown>;
}

/** The published names, each of which a module may lack. */
interface Published {
  readonly NCP_VERSION?: string;
  readonly NCP_CONTRACT_HASH?: string;
  readonly checkVersion?: (version: string, strict: boolean) => boolean;
  readonly contractStatus?: (peerHash: string | undefined) => unknown;
  readonly NcpVersionError?: new () => Error;
  readonly NcpScientificBoundaryError?: new () => Error;
  readonly NeuroSimClient?: new (send: Send) => Client;
}

type Args = Readonly<Record<string, unknown>>;
type Frame = Readonly<Record<string, unknown>>;

/** The module has no such function, or cannot be told this. */
class Unsupported extends Error {}

const { values: options } = parseArgs({
  options: { module: { type: "string" }, name: { type: "string" }, roles: { type: "string", default: "commander" } },
});
if (options.module === undefined) {
  process.stderr.write("Usage: node adapter-module.js --module PATH [--name TEXT] [--roles LIST]\n");
  process.exit(2);
}

// What the module prints goes to the log.
const answer = process.stdout.write.bind(process.stdout);
process.stdout.write = process.stderr.write.bind(process.stderr) as typeof process.stdout.write;

const file = createRequire(join(process.cwd(), "here.js")).resolve(
  existsSync(options.module) ? resolve(options.module) : options.module,
);
const imported = (await import(pathToFileURL(file).href)) as Published & { default?: Published };
const published: Published = imported.NCP_VERSION === undefined ? (imported.default ?? imported) : imported;
const manifest = manifestOf(dirname(file));

// --- the calls -----------------------------------------------------------------------------------

const CALLS: ReadonlyMap<string, (args: Args) => unknown> = new Map<string, (args: Args) => unknown>([
  [
    "describe",
    () => ({
      name: options.name ?? manifest.name ?? file,
      version: manifest.version ?? "unknown",
      language: "TypeScript",
      wire_version: published.NCP_VERSION ?? "unknown",
      contract_hash: published.NCP_CONTRACT_HASH ?? "unknown",
      roles: options.roles.split(","),
    }),
  ],
  ["version.check", (args) => ({ compatible: checkVersion(args["version"] as string, args["strict"] === true) })],
  ["contract.status", (args) => ({ status: contractStatus(args["peer_hash"]) })],
  [
    "negotiate",
    (args) => {
      // By its definition: the version guard, strict, and then the status.
      checkVersion(args["version"] as string, true);
      return { contract: contractStatus(args["contract_hash"]) };
    },
  ],
  ["reply.check", checkReply],
]);

function checkVersion(version: string, strict: boolean): boolean {
  return has(published.checkVersion)(version, strict);
}

function contractStatus(hash: unknown): string {
  const status = String(has(published.contractStatus)((hash as string | null) ?? undefined));
  return status.replace(/(?<=[a-z])(?=[A-Z])/g, "_").toLowerCase();
}

function has<T>(name: T | undefined): T {
  if (name === undefined) throw new Unsupported();
  return name;
}

/** Has a client send the request over a `Send` that brings this reply back: it resolves or it rejects. */
async function checkReply(args: Args): Promise<object> {
  // The strict profile is not published.
  if (args["strict"] === true) throw new Unsupported();
  const { parsed, closing } = await (form ??= formOf());
  const request = JSON.parse(args["request"] as string) as Frame;
  const text = args["reply"] as string;
  if (parsed && !isFaithful(text)) throw new Unsupported();
  const told = new Told(parsed, published.NCP_VERSION);
  const client = new (has(published.NeuroSimClient))(told.send);
  // Only a session of its own is closed.
  if (request["kind"] !== "open_session") {
    await client.open(opening(String(request["session_id"]))).catch(() => {
      throw new Unsupported();
    });
  }
  told.next(text);
  const outcome = call(client, request, closing);
  await outcome.catch(() => undefined);
  // It refused, or was content, before it sent anything: of the reply that says nothing.
  if (told.waits) throw new Unsupported();
  await outcome;
  return {};
}

async function call(client: Client, request: Frame, closing: Closing): Promise<unknown> {
  switch (request["kind"]) {
    case "open_session":
      return client.open(request);
    case "step_request":
      return client.step(request);
    case "run_request":
      return client.run(request);
    case "close_session":
      return client.close(closing(request));
    default:
      throw new Unsupported();
  }
}

// --- the forms that are not written down ---------------------------------------------------------

type Closing = (request: Frame) => unknown;
interface Form {
  /** Whether a `Send` brings back parsed JSON, rather than a text. */
  readonly parsed: boolean;
  /** What `close` is given. */
  readonly closing: Closing;
}

let form: Promise<Form> | undefined;

/** Opens and closes a session with right replies, to see what the module sends and how it wants to be told. */
async function formOf(): Promise<Form> {
  const closings: Closing[] = [(request) => request["session_id"], (request) => request];
  for (const closing of closings) {
    for (const parsed of [false, true]) {
      const told = new Told(parsed, published.NCP_VERSION);
      try {
        const client = new (has(published.NeuroSimClient))(told.send);
        await client.open(opening("probe"));
        await client.close(closing({ ncp_version: published.NCP_VERSION, kind: "close_session", session_id: "probe" }));
        const last = told.sent.at(-1);
        if (last?.["kind"] === "close_session" && last["session_id"] === "probe") return { parsed, closing };
      } catch (error) {
        if (error instanceof Unsupported) throw error;
        process.stderr.write(`not by ${parsed ? "parsed" : "text"} replies: ${messageOf(error)}\n`);
      }
    }
  }
  throw new Unsupported();
}

function opening(session: string): Frame {
  return {
    ncp_version: published.NCP_VERSION,
    kind: "open_session",
    session_id: session,
    network: { kind: "builtin", ref: "ncp.reference.lif" },
  };
}

/** A `Send` that answers rightly, until it is told what to answer. */
class Told {
  readonly sent: Frame[] = [];
  readonly #parsed: boolean;
  readonly #version: string | undefined;
  #next: string | undefined;

  constructor(parsed: boolean, version: string | undefined) {
    this.#parsed = parsed;
    this.#version = version;
  }

  next(text: string): void {
    this.#next = text;
  }

  /** Whether nobody has asked for what it was told to answer. */
  get waits(): boolean {
    return this.#next !== undefined;
  }

  readonly send: Send = (request) => {
    const frame = (typeof request === "string" ? JSON.parse(request) : request) as Frame;
    this.sent.push(frame);
    const text = this.#next ?? this.#right(frame);
    this.#next = undefined;
    return Promise.resolve(this.#parsed ? JSON.parse(text) : text);
  };

  #right(request: Frame): string {
    const kind = request["kind"] === "open_session" ? "session_opened" : "session_closed";
    return JSON.stringify({ ncp_version: this.#version, kind, session_id: request["session_id"], ok: true });
  }
}

/**
 * Whether parsed JSON says all that its text says. Where the module takes parsed JSON, its bus has parsed it, and what
 * that loses is not the module's: text that is not JSON, a repeated member, the spelling of an integer.
 */
function isFaithful(text: string): boolean {
  try {
    JSON.parse(text);
  } catch {
    return false;
  }
  const names: (Set<string> | undefined)[] = [];
  // A string is matched in runs: letter by letter, a long one would exhaust the stack of the expression.
  for (const [token, colon] of text.matchAll(/"[^"\\]*(?:\\.[^"\\]*)*"(\s*:)?|[{}[\]]|-?[0-9][0-9.eE+-]*/g)) {
    if (token.startsWith('"')) {
      const name = colon === undefined ? undefined : (JSON.parse(token.slice(0, -colon.length)) as string);
      if (name !== undefined && names.at(-1)?.has(name)) return false;
      if (name !== undefined) names.at(-1)?.add(name);
    } else if ("{[".includes(token)) {
      names.push(token === "{" ? new Set() : undefined);
    } else if ("}]".includes(token)) {
      names.pop();
    } else if (Number.isInteger(Number(token)) ? !Number.isSafeInteger(Number(token)) || /[.eE]|^-0/.test(token) : false) {
      return false;
    }
  }
  return true;
}

// --- the conversation ----------------------------------------------------------------------------

/** Errors of the language are thrown by mistake; all others refuse. */
const MISTAKES = [TypeError, RangeError, ReferenceError, EvalError, URIError];

function codeOf(error: unknown): string {
  if (!(error instanceof Error) || MISTAKES.some((mistake) => error instanceof mistake)) return "internal";
  if (published.NcpVersionError !== undefined && error instanceof published.NcpVersionError) return "version";
  const { NcpScientificBoundaryError: boundary } = published;
  if (boundary !== undefined && error instanceof boundary) return "provenance";
  return "invalid";
}

function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

function manifestOf(folder: string): { name?: string; version?: string } {
  const here = join(folder, "package.json");
  const found = existsSync(here) ? (JSON.parse(readFileSync(here, "utf8")) as { name?: string; version?: string }) : {};
  return found.name !== undefined || dirname(folder) === folder ? found : manifestOf(dirname(folder));
}

async function take(line: string): Promise<void> {
  if (line === "") return;
  const { id, call: name, args } = JSON.parse(line) as { id: unknown; call: string; args: Args };
  let outcome: object;
  try {
    const does = CALLS.get(name);
    outcome = does === undefined ? { unsupported: true } : { result: await does(args) };
  } catch (error) {
    outcome =
      error instanceof Unsupported
        ? { unsupported: true }
        : { error: { code: codeOf(error), message: messageOf(error) } };
  }
  answer(`${JSON.stringify({ id, ...outcome })}\n`);
}

/** The parts of a line whose end has not come yet. */
let begun: Buffer[] = [];
for await (const chunk of process.stdin as AsyncIterable<Buffer>) {
  let from = 0;
  for (let end = chunk.indexOf("\n"); end >= 0; end = chunk.indexOf("\n", from)) {
    const line = Buffer.concat([...begun, chunk.subarray(from, end)]).toString("utf8");
    begun = [];
    from = end + 1;
    await take(line);
  }
  begun.push(chunk.subarray(from));
}
await take(Buffer.concat(begun).toString("utf8"));
