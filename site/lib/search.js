/** What the search of the site finds. */

import { pageOfCase } from "./addresses.js";

/** The entries: a kind, a title, a page, and words. */
export function entries({ rules, chapters, documents, findings, flags, defects, live, cases }) {
  const found = [];
  const add = (kind, title, page, text) => found.push([kind, title, page, text]);
  for (const rule of rules.values()) add("rule", rule.id, rule.page, plain(rule.sentence));
  for (const one of chapters) addSections("text", one, add);
  for (const { id, title, required, severity } of findings)
    add("finding", id, `findings.html#${id}`, `${title} ${required} ${severity}`);
  for (const { name, description } of flags) add("bug class", name, `flags.html#${name}`, description);
  for (const one of documents) addSections("page", one, add);
  for (const { name, about } of live) add("live scenario", name, `live.html#${name}`, about);
  for (const { page, defects: list } of defects) {
    for (const { name, about } of list) add("defect", name, `${page}#${name}`, plain(about));
  }
  for (const one of cases.values()) add("case", one.id, pageOfCase(one), plain(one.title));
  return found;
}

/** A page with its sections: what stands under each heading, without the rules, which are entries of their own. */
function addSections(kind, { page, title, html }, add) {
  const parts = html.split(/(?=<h[1-6] id=")/);
  for (const part of parts) {
    const head = /^<h([1-6]) id="([^"]*)"[^>]*>(.*?) <a class="anchor"/s.exec(part);
    const prose = part.replace(/<section class="rule.*?<\/section>/gs, "").replace(/<h[1-6].*?<\/h[1-6]>/s, "");
    const heading = head === null ? title : words(head[3]);
    const named = head === null || head[1] === "1" ? heading : `${heading} (${title})`;
    add(kind, named, head === null || head[1] === "1" ? page : `${page}#${head[2]}`, words(prose).slice(0, 3000));
  }
}

const plain = (markdown) => markdown.replaceAll("`", "");

function words(html) {
  const text = html
    .replace(/<[^>]*>/g, " ")
    .replaceAll("&lt;", "<")
    .replaceAll("&gt;", ">")
    .replaceAll("&quot;", '"');
  return text.replaceAll("&amp;", "&").replace(/\s+/g, " ").trim();
}
