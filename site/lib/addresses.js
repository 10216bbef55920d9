/** Which page of the site shows a file or a folder of the tree, and how pages link to each other. */

import { posix } from "node:path";
import { filesIn, isFile, isFolder } from "./tree.js";

/** The page of a path, from the root of the site; nothing for what the tree does not have. */
export function pageOf(path) {
  if (isFile(path)) return pageOfFile(path);
  return isFolder(path) ? pageOfFolder(path) : undefined;
}

/** A page of the site as a link from another one. */
export const relative = (from, to) => posix.relative(posix.dirname(from), to);

/** A source as it is shown, with a line. */
export const sourceOf = (path, line) => `source/${path}.html${line ? `#L${line}` : ""}`;

/** The page of a rule. */
export const ruleOf = (id) => `rules/${id}.html`;

/** Whether a file of defects is a table of its own in the site. */
export const isDefects = (path) =>
  /^defects\/(peer\/|deep\/)?[\w-]+\.toml$/.test(path) && path !== "defects/Cargo.toml";

function pageOfFile(path) {
  const within = /^(.*)\.[^./]+$/.exec(path)?.[1] ?? path;
  if (/^spec\/text\/\d\d-.*\.md$/.test(path)) return `text/${posix.basename(within)}.html`;
  if (path.endsWith(".md")) return `docs/${within}.html`;
  if (/^vectors\/(corpus|deep)\/.*\.json$/.test(path)) return `${within.slice("vectors/".length)}.html`;
  if (isDefects(path)) return `${within}.html`;
  const own = {
    "vectors/findings.toml": "findings.html",
    "vectors/flags.toml": "flags.html",
    "live/scenarios.toml": "live.html",
  };
  return own[path] ?? sourceOf(path);
}

function pageOfFolder(path) {
  if (isFile(`${path}/README.md`)) return `docs/${path}/README.html`;
  const area = /^vectors\/corpus(?:\/(\w+))?$/.exec(path);
  if (area !== null) return `corpus/index.html${area[1] ? `#${area[1]}` : ""}`;
  if (path === "vectors/deep") return "deep/index.html";
  const defects = /^defects\/(peer|deep)$/.exec(path);
  if (defects !== null) return `defects/index.html#${defects[1]}`;
  return `source/${path}/index.html`;
}

/** The files of a folder, without those of its folders. */
export const listed = (folder) => filesIn(folder).filter((file) => posix.dirname(file) === folder);

/** The place of a case, which knows its file. */
export const pageOfCase = ({ id, file }) => `${pageOf(file.path)}#${id}`;
