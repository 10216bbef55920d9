/** Holds the links of a site to its files: each leads to a page, and each fragment to an element. */

import { existsSync, readdirSync, readFileSync, statSync } from "node:fs";
import { join, posix } from "node:path";
import { Parser } from "htmlparser2";

/** The attributes that fetch what they name: none may lead out of the site. */
const FETCHED = new Set(["src", "srcset", "poster", "data"]);

/** The files of a folder, at any depth, sorted. */
export function filesOf(folder, within = "") {
  const entries = readdirSync(join(folder, within), { withFileTypes: true });
  const files = entries.flatMap((entry) => {
    const path = posix.join(within, entry.name);
    return entry.isDirectory() ? filesOf(folder, path) : [path];
  });
  return files.sort();
}

/** What is wrong with the links of a site: a line each. */
export function wrongLinks(folder) {
  const pages = new Map();
  for (const file of filesOf(folder).filter((file) => file.endsWith(".html"))) {
    pages.set(file, page(readFileSync(join(folder, file), "utf8")));
  }
  const wrong = [];
  for (const [file, { ids, links, repeated }] of pages) {
    wrong.push(...repeated.map((id) => `${file}: two elements have the id ${id}`));
    for (const { url, fetched } of links) {
      const why = wrongLink(url, fetched, file, ids, pages, folder);
      if (why !== undefined) wrong.push(`${file}: ${url} ${why}`);
    }
  }
  return wrong;
}

function wrongLink(url, fetched, file, ids, pages, folder) {
  if (/^[a-z][a-z0-9+.-]*:/i.test(url) || url.startsWith("//"))
    return fetched ? "is fetched from elsewhere" : undefined;
  if (url.startsWith("/")) return "is no relative link";
  const [path, fragment] = url.split("#", 2).map(decodeURIComponent);
  const target = path === "" ? file : posix.join(posix.dirname(file), path);
  if (target.startsWith("..")) return "leads out of the site";
  const known = target === file ? ids : pages.get(target)?.ids;
  if (known === undefined) {
    const there = existsSync(join(folder, target)) && statSync(join(folder, target)).isFile();
    return there && fragment === undefined ? undefined : "leads to no file";
  }
  return fragment === undefined || fragment === "" || known.has(fragment) ? undefined : "leads to no element";
}

/** The ids and links of a page. */
function page(html) {
  const ids = new Set();
  const repeated = [];
  const links = [];
  const parser = new Parser({
    onopentag(name, attributes) {
      if (attributes.id !== undefined) {
        if (ids.has(attributes.id)) repeated.push(attributes.id);
        ids.add(attributes.id);
      }
      for (const [attribute, url] of Object.entries(attributes)) {
        if (attribute === "href") links.push({ url, fetched: name === "link" });
        if (FETCHED.has(attribute)) links.push({ url, fetched: true });
      }
    },
  });
  parser.end(html);
  return { ids, links, repeated };
}
