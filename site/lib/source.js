/** A source file as it is shown: a line an element, rules as links. */

import { relative, ruleOf } from "./addresses.js";

/** The lines of a text as HTML. */
export function sourceLines(text, rules, page) {
  const lines = text.replace(/\n$/, "").split("\n");
  return lines
    .map((line, index) => `<span class="l" id="L${index + 1}">${withRules(line, rules, page)}\n</span>`)
    .join("");
}

function withRules(line, rules, page) {
  const named = (id) => (rules.has(id) ? `<a href="${relative(page, ruleOf(id))}">${id}</a>` : id);
  return escaped(line).replace(/NCP-[A-Z]+-\d{3}/g, named);
}

/** A text within HTML. */
export const escaped = (text) =>
  text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;").replaceAll('"', "&quot;");
