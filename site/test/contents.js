import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { parseDocument } from "htmlparser2";
import { filesOf } from "../lib/links.js";
import { make } from "./made.js";

const ROOT = dirname(dirname(dirname(fileURLToPath(import.meta.url))));
const read = (path) => readFileSync(join(ROOT, path), "utf8");

export function ofContents(site) {
  const page = (path) => readFileSync(join(site, path), "utf8");

  test("the same sources make the same bytes", () => {
    const other = make();
    assert.deepEqual(filesOf(other), filesOf(site));
    const differing = filesOf(site).filter(
      (file) => !readFileSync(join(site, file)).equals(readFileSync(join(other, file))),
    );
    assert.deepEqual(differing, []);
  });

  test("every rule of the text is an anchor of its chapter, leads to its page, and is bare of Markdown", () => {
    let rules = 0;
    for (const name of readdirSync(join(ROOT, "spec/text")).filter((name) => /^\d\d-.*\.md$/.test(name))) {
      const made = page(`text/${name.replace(/md$/, "html")}`);
      for (const [, id] of read(`spec/text/${name}`).matchAll(/^- \*\*\[(NCP-[A-Z]+-\d{3})\]\*\*/gm)) {
        rules += 1;
        const section = new RegExp(`<section class="rule [a-z]+" id="${id}">.*?</section>`, "s").exec(made)?.[0];
        assert.ok(section?.includes(`href="../rules/${id}.html"`), `${name}: ${id}`);
        assert.doesNotMatch(section, /\*\*\[|\(wire;|\(safety;|\(strict;/, id);
        assert.ok(page(`rules/${id}.html`).includes(`href="../text/${name.replace(/md$/, "html")}#${id}"`), id);
      }
    }
    assert.ok(rules > 300, `${rules} rules`);
  });

  test("every case of the corpus and of the deep set is an element of the page of its file", () => {
    let cases = 0;
    for (const folder of ["vectors/corpus", "vectors/deep"]) {
      for (const file of filesOf(join(ROOT, folder)).filter((file) => file.endsWith(".json"))) {
        const made = page(`${folder.replace("vectors/", "")}/${file.replace(/json$/, "html")}`);
        const ids = new Set([...made.matchAll(/<details class="case" id="([^"]*)"/g)].map(([, id]) => id));
        const wanted = JSON.parse(read(`${folder}/${file}`)).cases.map(({ id }) => id);
        assert.deepEqual([...ids], wanted, file);
        cases += wanted.length;
      }
    }
    assert.ok(cases > 9000, `${cases} cases`);
  });

  test("a case is shown with the spelling of its file", () => {
    const { cases } = JSON.parse(read("vectors/corpus/wire/numbers.json"));
    const made = parseDocument(page("corpus/wire/numbers.html"));
    const shown = texts(made, "pre");
    for (const { id, args, expect } of cases) {
      for (const value of [args, expect]) {
        const text = shown.shift();
        if (text.length < 12_000) assert.deepEqual(JSON.parse(text), value, id);
      }
    }
    assert.equal(shown.length, 0);
  });

  test("all evidence of the matrix stands on the page of its rule", () => {
    const matrix = JSON.parse(
      readFileSync(process.env.NCP_SITE_MATRIX ?? join(ROOT, ".tools/site/matrix.json"), "utf8"),
    );
    for (const { id, sentence, evidence } of matrix.rules) {
      const made = page(`rules/${id}.html`);
      const shown = text(parseDocument(made));
      assert.ok(letters(shown).includes(letters(sentence)), `${id}: ${sentence}`);
      for (const { kind, place, line } of evidence) {
        const [file, item = ""] = place.split(" ");
        if (kind === "vectors") assert.ok(made.includes(`href="../${file.slice(8, -5)}.html"`), `${id}: ${place}`);
        else if (["tests", "properties", "fuzz", "code"].includes(kind)) {
          assert.ok(made.includes(`href="../source/${file}.html#L${line}"`), `${id}: ${place}`);
        } else assert.ok(made.includes(`#${item}"`), `${id}: ${place}`);
      }
    }
  });

  test("every audited finding stands with its severity, its rules and its cases", () => {
    const made = page("findings.html");
    for (const [, id, severity, rules] of read("vectors/findings.toml").matchAll(
      /^(L\d\d) = \{ severity = "(\w+)".*? rules = \[(.*?)\]/gm,
    )) {
      const section = new RegExp(`<section class="finding ${severity}" id="${id}".*?</section>`, "s").exec(made)?.[0];
      assert.ok(section !== undefined, id);
      for (const [rule] of rules.matchAll(/NCP-[A-Z]+-\d{3}/g))
        assert.ok(section.includes(`rules/${rule}.html`), `${id}: ${rule}`);
    }
    const flagged = filesOf(join(ROOT, "vectors/corpus")).flatMap(
      (file) => JSON.parse(read(`vectors/corpus/${file}`)).cases,
    );
    for (const { id } of flagged.filter(({ flags }) => flags.includes("L03"))) assert.ok(made.includes(`#${id}"`), id);
  });

  test("every page of the project is a page of the site", () => {
    for (const path of [
      "README.md",
      "ARCHITECTURE.md",
      "CONTRIBUTING.md",
      "SECURITY.md",
      "CHANGELOG.md",
      "peers/PROTOCOL.md",
      "reports/proofs.md",
    ]) {
      const title = /^# (.*)$/m.exec(read(path))[1];
      assert.ok(page(`docs/${path.replace(/md$/, "html")}`).includes(title), path);
      assert.ok(page("docs/index.html").includes(`>${title}</a>`), path);
    }
  });
}

/** A text without marks, of which Markdown has its own. */
const letters = (text) => text.replace(/[^\p{L}\p{N}]/gu, "");

/** The texts of the elements of a name, in order. */
function texts(node, name) {
  if (node.name === name) return [text(node)];
  return (node.children ?? []).flatMap((child) => texts(child, name));
}

function text(node) {
  return node.type === "text" ? node.data : (node.children ?? []).map(text).join("");
}
