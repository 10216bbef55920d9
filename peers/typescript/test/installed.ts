import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

/** The folder of the package's sources. */
export const PACKAGE = fileURLToPath(new URL("../../", import.meta.url));

const README = readFileSync(join(PACKAGE, "README.md"), "utf8");
const NPM = process.platform === "win32" ? "npm.cmd" : "npm";

/** A folder into which the packed package was installed, with the examples of the README. */
export class Installed {
  readonly folder: string;
  readonly #root: string;

  /** @param port - stands in the examples instead of theirs */
  constructor(port: number) {
    this.#root = mkdtempSync(join(tmpdir(), "ncp-peer-"));
    this.folder = join(this.#root, "empty");
    mkdirSync(this.folder);
    // Nothing is fetched: `ws` is packed as it lies in this package's own node_modules.
    const ws = pack(join(PACKAGE, "node_modules/ws"), this.#root, "--ignore-scripts");
    const peer = pack(PACKAGE, this.#root);
    for (const command of commands()) {
      const [program, ...args] = command.split(" ");
      if (program !== "npm" || args[0] !== "install") continue;
      npm(this.folder, ...args.map((arg) => (arg.endsWith(".tgz") ? peer : arg === "ws" ? ws : arg)));
    }
    for (const [name, text] of examples()) {
      writeFileSync(join(this.folder, name), text.replaceAll("28475", String(port)));
    }
  }

  /** The packages that are installed. */
  packages(): string[] {
    const entries = readdirSync(join(this.folder, "node_modules"), { withFileTypes: true });
    return entries.filter(({ name }) => !name.startsWith(".")).map(({ name }) => name);
  }

  /** The files of the package, by their paths in it. */
  files(): string[] {
    const found = readdirSync(join(this.folder, "node_modules/@ncp-conformance/peer"), {
      withFileTypes: true,
      recursive: true,
    });
    const root = join(this.folder, "node_modules/@ncp-conformance/peer/");
    return found
      .filter((entry) => entry.isFile())
      .map((entry) => join(entry.parentPath, entry.name).slice(root.length).replaceAll("\\", "/"));
  }

  remove(): void {
    rmSync(this.#root, { recursive: true, force: true });
  }
}

/** The shell commands of the README, a line each. */
export function commands(): string[] {
  return fences("sh").flatMap((text) => text.trim().split("\n"));
}

/** The examples of the README that name their file, by its name. */
export function examples(): Map<string, string> {
  const files = [...fences("js"), ...fences("html")].map((text): [string, string] => {
    const [first = ""] = text.split("\n", 1);
    const name = /^(?:\/\/|<!--) ([\w.]+)(?: -->)?$/.exec(first)?.[1];
    if (name === undefined) throw new Error(`an example does not name its file: ${first}`);
    // A comment before the document type would make a browser take the page for an old one.
    return [name, text.slice(first.length + 1)];
  });
  return new Map(files);
}

function fences(language: string): string[] {
  return [...README.matchAll(new RegExp(`^\`\`\`${language}\\n([^]*?)^\`\`\`$`, "gm"))].map(([, text]) => text!);
}

/** Packs a folder and returns the path of the tarball. */
function pack(folder: string, into: string, ...options: string[]): string {
  const printed = npm(folder, "pack", "--silent", "--pack-destination", into, ...options);
  return join(into, printed.trim().split("\n").at(-1)!);
}

function npm(folder: string, ...args: string[]): string {
  const env = { ...process.env, npm_config_offline: "true", npm_config_audit: "false", npm_config_fund: "false" };
  // A test runner around this one must not be taken for the runner of what npm starts.
  const { NODE_OPTIONS, NODE_TEST_CONTEXT, ...rest } = env as Record<string, string>;
  return execFileSync(NPM, args, { cwd: folder, env: rest, encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
}
