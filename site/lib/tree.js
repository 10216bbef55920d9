/** The source tree: what git has in it, read as text. */

import { execFileSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { dirname, join, posix, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { parse } from "smol-toml";

/** The root of the project. */
export const ROOT = resolve(dirname(fileURLToPath(import.meta.url)), "../..");

/** The files that git has, or would have, and that are there: their paths from the root, sorted. */
export const FILES = listed();
const KNOWN = new Set(FILES);
const FOLDERS = new Set(FILES.flatMap(ancestors));

/** Whether this is a file of the tree. */
export const isFile = (path) => KNOWN.has(path);

/** Whether this is a folder of the tree. */
export const isFolder = (path) => FOLDERS.has(path);

/** The files of a folder, at any depth, whose names end so. */
export const filesIn = (folder, end = "") =>
  FILES.filter((file) => file.startsWith(`${folder}/`) && file.endsWith(end));

/** The text of a file. */
export const read = (path) => readFileSync(join(ROOT, path), "utf8");

/** A file of TOML. */
export const toml = (path) => parse(read(path), { integersAsBigInt: "asNeeded" });

/** Where a link leads that stands in a file. */
export const linked = (from, link) => posix.normalize(posix.join(posix.dirname(from), link)).replace(/\/$/, "");

function listed() {
  const options = { cwd: ROOT, encoding: "utf8", maxBuffer: 64 << 20 };
  const git = execFileSync("git", ["ls-files", "-z", "--cached", "--others", "--exclude-standard"], options);
  const files = git.split("\0").filter((file) => file !== "" && existsSync(join(ROOT, file)));
  return [...new Set(files)].sort();
}

function ancestors(file) {
  const parts = file.split("/");
  return parts.slice(1).map((_, index) => parts.slice(0, index + 1).join("/"));
}
