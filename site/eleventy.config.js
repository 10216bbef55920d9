/** How Eleventy makes the site: `npm run build -- --output FOLDER`. */

import { posix } from "node:path";
import MarkdownIt from "markdown-it";
import { listed, pageOf, pageOfCase, relative, ruleOf, sourceOf } from "./lib/addresses.js";
import { build, counted, KINDS, rooms } from "./lib/model.js";
import { entries } from "./lib/search.js";
import { sourceLines } from "./lib/source.js";
import { read } from "./lib/tree.js";

export default function (eleventy) {
  const model = build();
  const tables = {
    rule: model.rules,
    chapter: byPath(model.chapters),
    document: byPath(model.documents),
    corpus: byPath(model.corpus),
    deep: byPath(model.deep),
    defects: byPath(model.defects),
  };

  // Pages are made over keys: Eleventy copies its data for each template, and the model is large.
  eleventy.addGlobalData("keys", {
    ...Object.fromEntries(Object.entries(tables).map(([name, table]) => [name, [...table.keys()]])),
    source: model.sources,
    folder: model.folders,
  });
  eleventy.addNunjucksGlobal("model", model);
  eleventy.addNunjucksGlobal("KINDS", KINDS);
  eleventy.addNunjucksGlobal("isFinding", (flag) => /^L\d\d$/.test(flag));
  eleventy.addNunjucksGlobal("rooms", rooms(model.documents));
  eleventy.addFilter("in", (key, table) => tables[table].get(key));
  eleventy.addFilter("pageOf", pageOf);
  eleventy.addFilter("pageOfCase", pageOfCase);
  eleventy.addFilter("ruleOf", ruleOf);
  eleventy.addFilter("sourceOf", sourceOf);
  eleventy.addFilter("listed", listed);
  eleventy.addFilter("basename", (path) => posix.basename(path));
  eleventy.addFilter("sourceLines", (path, page) => sourceLines(read(path), model.rules, page));
  eleventy.addFilter("number", (value) => value.toLocaleString("en"));
  eleventy.addFilter("counted", (value, one, many) => counted(value, { one, many: many ?? `${one}s` }));
  eleventy.addFilter("from", (to, page) => {
    const [file, fragment] = to.split("#");
    return encodeURI(relative(page, file)) + (fragment === undefined ? "" : `#${fragment}`);
  });
  const inline = new MarkdownIt();
  eleventy.addFilter("inline", (text) => inline.renderInline(text));
  eleventy.addFilter("capital", (text) => text.charAt(0).toUpperCase() + text.slice(1));
  eleventy.addFilter("json", (value) => JSON.stringify(value));
  eleventy.addNunjucksGlobal("searchEntries", entries(model));

  eleventy.addPassthroughCopy({
    assets: "assets",
    "node_modules/minisearch/dist/umd/index.js": "assets/minisearch.js",
  });
  eleventy.addPassthroughCopy({ "node_modules/minisearch/LICENSE.txt": "assets/minisearch-LICENSE.txt" });
  eleventy.setUseGitIgnore(false);
  return {
    dir: { input: "pages", includes: "_includes", data: "_data", output: "../reports/site" },
    templateFormats: ["njk"],
  };
}

const byPath = (list) => new Map(list.map((one) => [one.path, one]));
