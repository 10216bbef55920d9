/** The site as Eleventy makes it, in folders that are removed at the end. */

import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after } from "node:test";
import { fileURLToPath } from "node:url";

const SITE = dirname(dirname(fileURLToPath(import.meta.url)));

/** A folder that is there until all tests have ended. */
export function temporary() {
  const folder = mkdtempSync(join(tmpdir(), "ncp-site-"));
  after(() => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

/** Makes the site, and returns its folder. */
export function make() {
  const folder = temporary();
  const eleventy = join(SITE, "node_modules/@11ty/eleventy/cmd.cjs");
  // What reports tests to a file is meant for this process alone.
  const env = { ...process.env, NODE_OPTIONS: "" };
  execFileSync(process.execPath, [eleventy, "--quiet", `--output=${folder}`], { cwd: SITE, env, stdio: "inherit" });
  return folder;
}
