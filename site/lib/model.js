/** Everything of which pages are made, read once from the tree and from the matrix of `cargo assure trace`. */

import { readFileSync } from "node:fs";
import { basename, dirname, join } from "node:path";
import GithubSlugger from "github-slugger";
import { isDefects, listed, pageOf, pageOfCase, relative, ruleOf, sourceOf } from "./addresses.js";
import { corpus, deep, findings, flags } from "./corpus.js";
import { renderer } from "./markdown.js";
import { FILES, isFile, isFolder, read, ROOT, toml } from "./tree.js";

/** The kinds of evidence in their order, as they are counted and as a rule's page heads them. */
export const KINDS = {
  vectors: { one: "case", many: "cases", title: "Cases of the golden corpus" },
  tests: { one: "test", many: "tests", title: "Tests" },
  properties: { one: "property test", many: "property tests", title: "Property tests" },
  proofs: { one: "proof", many: "proofs", title: "Proofs" },
  fuzz: { one: "fuzz target", many: "fuzz targets", title: "Fuzz targets" },
  live: { one: "live scenario", many: "live scenarios", title: "Live scenarios" },
  mutants: { one: "planted defect", many: "planted defects", title: "Planted defects of the peer" },
  code: { one: "place in code", many: "places in code", title: "Code that carries it out" },
};

/** What the pages need. */
export function build() {
  const matrix = JSON.parse(readFileSync(process.env.NCP_SITE_MATRIX ?? join(ROOT, ".tools/site/matrix.json"), "utf8"));
  const model = { wireVersion: matrix.wire_version, contractHash: matrix.contract_hash };
  model.corpus = corpus();
  model.deep = deep();
  model.cases = new Map(model.corpus.flatMap((file) => file.cases.map((one) => [one.id, { ...one, file }])));
  model.proofs = proofs();
  model.defects = defects();
  model.live = live();
  model.rules = new Map(matrix.rules.map((rule) => [rule.id, rule]));
  for (const rule of model.rules.values()) complete(rule, model);
  model.findings = audited(matrix, model);
  model.flags = classes(model);
  Object.assign(model, pages(model));
  model.counts = counts(model);
  return model;
}

/** The engines that looked at each claim of the proofs, and what each of them found; with the rules of the claim. */
function proofs() {
  const claims = new Map();
  for (const path of FILES.filter((file) => file.startsWith("reports/lock/proofs-"))) {
    const { fates, rules } = toml(path);
    for (const [key, fate] of Object.entries(fates)) {
      const [engine, claim, ...more] = key.split(" ");
      if (more.length > 0) continue;
      const known = claims.get(claim) ?? { claim, rules: rules[claim] ?? [], engines: [] };
      known.engines.push({ engine, fate });
      claims.set(claim, known);
    }
  }
  return claims;
}

/** The tables of planted defects; of those of the peer, what became of each. */
function defects() {
  const { fates } = toml("reports/lock/mutants.toml");
  return FILES.filter(isDefects).map((path) => {
    const text = read(path);
    const lines = text.split("\n");
    const about = /^(?:#.*\n)+/.exec(text)?.[0].replace(/^# ?/gm, "").trim() ?? "";
    const list = toml(path).defect.map((one) => ({
      ...one,
      edits: one.edit ?? [],
      line: lines.indexOf(`name = "${one.name}"`) + 1,
      fate: path.startsWith("defects/peer/") ? fates[one.name] : undefined,
    }));
    return { path, page: pageOf(path), name: path.slice("defects/".length, -".toml".length), about, defects: list };
  });
}

/** The live scenarios, each rule with what was found when it was last run. */
function live() {
  const { fates } = toml("reports/lock/live.toml");
  const lines = read("live/scenarios.toml").split("\n");
  return toml("live/scenarios.toml").scenario.map((one) => ({
    ...one,
    line: lines.indexOf(`name = "${one.name}"`) + 1,
    verdicts: one.rules.map((rule) => ({ rule, fate: fates[`${one.name} ${rule}`] ?? "not run" })),
  }));
}

/** Adds to a rule its cases, and to its evidence the pages that show it. */
function complete(rule, { corpus, deep, proofs, defects }) {
  rule.area = rule.id.split("-")[1];
  rule.page = ruleOf(rule.id);
  rule.binding = rule.keyword.startsWith("MUST");
  rule.who = rule.roles.length === 4 ? "all roles" : rule.roles.join(", ");
  rule.text = `text/${basename(rule.chapter, ".md")}.html#${rule.id}`;
  rule.files = corpus.flatMap((file) => {
    const cases = file.cases.filter(({ requirements }) => requirements.includes(rule.id));
    return cases.length > 0 ? [{ file, cases }] : [];
  });
  rule.cases = rule.files.reduce((sum, { cases }) => sum + cases.length, 0);
  rule.deep = deep.flatMap((file) => {
    const cases = file.cases.filter(({ requirements }) => requirements.includes(rule.id));
    return cases.length > 0 ? [{ file, count: cases.length }] : [];
  });
  rule.broken = defects.flatMap((table) => {
    const list = table.defects.filter(({ rules }) => rules?.includes(rule.id));
    return list.length > 0 ? [{ table, defects: list }] : [];
  });
  rule.kinds = {};
  for (const evidence of rule.evidence) {
    const [file, ...rest] = evidence.place.split(" ");
    const item = rest.join(" ");
    const one = { ...evidence, file, item, page: sourceOf(file, evidence.line) };
    if (evidence.kind === "proofs")
      Object.assign(one, { page: `${pageOf(file)}#${item}`, engines: proofs.get(item)?.engines ?? [] });
    if (evidence.kind === "live" || evidence.kind === "mutants") one.page = `${pageOf(file)}#${item}`;
    (rule.kinds[evidence.kind] ??= []).push(one);
  }
  const count = (kind) => (rule.kinds[kind] ?? []).reduce((sum, { count }) => sum + count, 0);
  rule.counts = Object.keys(KINDS)
    .map((kind) => [kind, count(kind)])
    .filter(([, count]) => count > 0);
}

/** The audited findings, each with its cases, its planted defects, and the code that answers it. */
function audited(matrix, { corpus, defects, live, rules }) {
  const traced = new Map(matrix.findings.map((finding) => [finding.id, finding]));
  return Object.entries(findings()).map(([id, finding]) => {
    const files = corpus.flatMap((file) => {
      const cases = file.cases.filter((one) => one.flags.includes(id));
      return cases.length > 0 ? [{ file, cases }] : [];
    });
    const named = finding.rules.map((rule) => rules.get(rule));
    const code = named.flatMap((rule) => rule.kinds.code ?? []).filter(({ file }) => file.startsWith("spec/"));
    return {
      id,
      ...finding,
      named,
      files,
      cases: files.reduce((sum, { cases }) => sum + cases.length, 0),
      exclusion: traced.get(id)?.exclusion,
      scenarios: live.filter((one) => one.findings?.includes(id)),
      defects: defects.flatMap((table) =>
        table.defects.filter((one) => one.finding === id).map((one) => ({ ...one, table })),
      ),
      code: [...new Map(code.map((one) => [one.page, one])).values()],
    };
  });
}

/** The bug classes, each with the files whose cases catch it. */
function classes({ corpus }) {
  return Object.entries(flags()).map(([name, flag]) => {
    const files = corpus.map((file) => ({ file, count: file.cases.filter((one) => one.flags.includes(name)).length }));
    const cases = files.reduce((sum, { count }) => sum + count, 0);
    return { name, ...flag, cases, found: files.filter(({ count }) => count > 0) };
  });
}

/** The pages that are made of Markdown, and the sources and folders that some page links to. */
function pages(model) {
  const wanted = new Set();
  const want = (path) => wanted.add(path);
  const chapterFiles = FILES.filter((file) => /^spec\/text\/\d\d-.*\.md$/.test(file));
  const chapters = chapterFiles.map((path) => chapter(path, model));
  const known = {
    rules: model.rules,
    cases: new Map([...model.cases.values()].map((one) => [one.id, pageOfCase(one)])),
    claims: new Map([...model.proofs.keys()].map((claim) => [claim, `docs/reports/proofs.html#${claim}`])),
    chapters: new Map(chapters.map((one) => [String(one.number), one])),
    sections: new Map(chapters.flatMap(({ sections }) => sections)),
  };
  const render = renderer({ known, want, block });
  for (const one of chapters) {
    Object.assign(one, render(read(one.path), { path: one.path, page: one.page, chapter: one }));
  }
  const documents = FILES.filter((file) => file.endsWith(".md") && !chapterFiles.includes(file)).map((path) => {
    const page = pageOf(path);
    const claims = path === "reports/proofs.md" ? new Set(model.proofs.keys()) : undefined;
    const made = render(read(path), { path, page, claims });
    return { path, page, ...made, about: firstSentence(made.html) };
  });
  for (const rule of model.rules.values()) {
    want(`spec/text/${rule.chapter}`);
    rule.evidence.forEach(({ place }) => want(place.split(" ")[0]));
  }
  model.defects.forEach(({ path, defects }) => {
    want(path);
    defects.forEach(({ edits }) => edits.forEach(({ file }) => want(file)));
  });
  const own = (path, of) => of(path) && pageOf(path)?.startsWith("source/");
  const folders = [...wanted].filter((path) => own(path, isFolder)).sort();
  folders.flatMap(listed).forEach(want);
  const isShown = (path) =>
    own(path, isFile) || path === "live/scenarios.toml" || isDefects(path) || /^spec\/text\/\d/.test(path);
  const sources = [...wanted].filter(isShown).sort();
  return { chapters, documents, sources, folders };
}

function chapter(path, { rules }) {
  const text = read(path);
  const page = pageOf(path);
  const own = [...rules.values()].filter(({ chapter }) => chapter === basename(path));
  const numbered = new Map();
  for (const { id, page } of own) {
    const number = id.split("-")[2];
    numbered.set(number, numbered.has(number) ? undefined : page);
  }
  const slugger = new GithubSlugger();
  const headings = [...text.matchAll(/^#+ (.*)$/gm)].map(([, title]) => [
    title,
    slugger.slug(title.replaceAll("`", "")),
  ]);
  const sections = headings.flatMap(([title, slug]) => {
    const number = /^(\d+\.\d+) /.exec(title)?.[1];
    return number === undefined ? [] : [[number, `${page}#${slug}`]];
  });
  const number = Number(basename(path).slice(0, 2));
  const name = number === 0 ? "Introduction" : /^# (?:\d+\. )?(.*)$/m.exec(text)?.[1];
  return { path, page, number, name, rules: own, numbered, sections };
}

/** The first sentence of the first paragraph of a page. */
function firstSentence(html) {
  const words = /<p>(.*?)<\/p>/s.exec(html)?.[1].replace(/<[^>]*>/g, "") ?? "";
  return /^.*?[.:](?=\s|$)/s.exec(words)?.[0].replace(/:$/, ".") ?? words;
}

/** What stands above and below the sentence of a rule in its chapter. */
function block(rule, page) {
  const { id, level, keyword, who, counts } = rule;
  const evidence = counts.filter(([kind]) => kind !== "code").map(([kind, count]) => counted(count, KINDS[kind]));
  const none = rule.exclusion ? "no evidence is possible" : "no evidence";
  const shown = evidence.length > 0 ? evidence.join(" · ") : none;
  const head =
    `<header><a class="id" href="#${id}">${id}</a><span class="badge level ${level}">${level}</span>` +
    `<span class="badge keyword">${keyword}</span><span class="badge role">${who}</span></header>\n`;
  const link = `<a href="${relative(page, rule.page)}" aria-label="Evidence for ${id}">Evidence</a>`;
  const foot = `<p class="evidence">${link} ${shown}</p>\n`;
  return { head, foot };
}

/** A number of things, in words. */
export function counted(count, { one, many }) {
  return `${count.toLocaleString("en")} ${count === 1 ? one : many}`;
}

/** The numbers that the first page states. */
function counts({ rules, corpus, deep, proofs, live }) {
  const sum = (files) => files.reduce((all, { cases }) => all + cases.length, 0);
  const mutants = toml("reports/lock/mutants.toml").counts;
  const proved = [...proofs.values()].filter(({ engines }) => engines.some(({ fate }) => fate.startsWith("proved")));
  return {
    rules: rules.size,
    binding: [...rules.values()].filter(({ binding }) => binding).length,
    files: corpus.length,
    cases: sum(corpus),
    deep: sum(deep),
    claims: proofs.size,
    proved: proved.length,
    killed: mutants.killed,
    mutants: mutants.killed + mutants.survived + mutants.unfinished + mutants.misnamed,
    scenarios: live.length,
    verdicts: toml("reports/lock/live.toml").counts["verdicts passed"],
  };
}

/** The folders of the pages of Markdown, the root first, each with its pages. */
export function rooms(documents) {
  const rooms = new Map();
  for (const one of documents) {
    const folder = dirname(one.path) === "." ? "" : one.path.split("/")[0];
    rooms.set(folder, [...(rooms.get(folder) ?? []), one]);
  }
  return [...rooms].sort(([one], [other]) => (one < other ? -1 : 1)).map(([folder, pages]) => ({ folder, pages }));
}
