/**
 * Markdown as the pages of the project use it: links into the tree lead to the pages that show it, an id of a rule, a
 * case or a proved property leads to it, and the rules of the text become sections of their own.
 */

import GithubSlugger from "github-slugger";
import MarkdownIt from "markdown-it";
import anchor from "markdown-it-anchor";
import { pageOf, relative, ruleOf } from "./addresses.js";
import { linked } from "./tree.js";

/**
 * A renderer of the files of the tree.
 *
 * @param known what can be named: `rules`, `cases`, `claims` (maps to pages), `findings`, `chapters`
 * @param want is told of every file or folder that a page links to
 * @param block makes what stands above and below the sentence of a rule
 */
export function renderer({ known, want, block }) {
  const md = new MarkdownIt({ html: true, typographer: false });
  md.use(anchor, {
    slugify: (title, env) => env.slugger.slug(title),
    slugifyWithState: (title, { env }) => env.slugger.slug(title),
    permalink: anchor.permalink.linkInsideHeader({
      symbol: "#",
      placement: "after",
      ariaHidden: true,
      class: "anchor",
    }),
    callback: (token, { title, slug }) => headings.push({ level: Number(token.tag.slice(1)), title, slug }),
  });
  let headings = [];
  md.core.ruler.push("links", ({ tokens, env }) => {
    for (const token of tokens.filter(({ type }) => type === "inline")) link(token, env);
  });
  md.core.ruler.push("rules", ({ tokens, env, Token }) => rules(tokens, env, Token));
  md.core.ruler.push("claims", ({ tokens, env }) => claims(tokens, env));
  md.renderer.rules.table_open = () => '<div class="wide"><table>\n';
  md.renderer.rules.table_close = () => "</table></div>\n";

  /** Makes links of what names something, and leads the links of the tree to pages. */
  function link(inline, env) {
    let depth = 0;
    inline.children = inline.children.flatMap((token) => {
      if (token.type === "link_open") {
        depth += 1;
        if (!token.attrs.some(([name, value]) => name === "class" && value === "anchor")) lead(token, env);
      } else if (token.type === "link_close") {
        depth -= 1;
      } else if (depth === 0 && token.type === "text") {
        return named(token, env);
      } else if (depth === 0 && token.type === "code_inline") {
        const page = pageOfCode(token.content);
        return page === undefined ? [token] : around(token, page, env);
      }
      return [token];
    });
  }

  function lead(token, env) {
    const href = token.attrGet("href");
    const [path, fragment] = href.split("#", 2);
    if (path === "" || /^[a-z]+:/.test(path)) return;
    const target = linked(env.path, decodeURIComponent(path));
    const page = pageOf(target);
    if (page === undefined) throw new Error(`${env.path}: ${href} leads nowhere`);
    want(target);
    const [file, own] = page.split("#");
    const at = fragment ?? own;
    token.attrSet("href", encodeURI(relative(env.page, file)) + (at ? `#${at}` : ""));
  }

  function pageOfCode(code) {
    if (known.rules.has(code)) return ruleOf(code);
    return known.cases.get(code) ?? known.claims.get(code);
  }

  /** A text with links around the rules, findings, chapters and sections that it names. */
  function named(token, env) {
    const parts = [];
    const names = env.chapter === undefined ? NAMES : NAMES_IN_TEXT;
    let rest = 0;
    for (const match of token.content.matchAll(names)) {
      const groups = match.groups;
      let places;
      if (groups.rule) places = known.rules.has(groups.rule) ? [[groups.rule, ruleOf(groups.rule)]] : [];
      else if (groups.finding) places = [[groups.finding, `findings.html#${groups.finding}`]];
      else if (groups.chapter) places = numbers(match[0], (number) => known.chapters.get(number)?.page);
      else if (groups.section) places = numbers(match[0], (number) => known.sections.get(number));
      else places = numbers(match[0], (number) => env.chapter.numbered.get(number.padStart(3, "0")));
      for (const [words, page] of places) {
        const at = token.content.indexOf(words, Math.max(rest, match.index));
        if (page === undefined || at < rest) continue;
        parts.push(text(token, token.content.slice(rest, at)), ...around(text(token, words), page, env));
        rest = at + words.length;
      }
    }
    return rest === 0 ? [token] : [...parts, text(token, token.content.slice(rest))];
  }

  /** The items of the text that are rules become sections. */
  function rules(tokens, env, Token) {
    for (let at = 0; at + 2 < tokens.length; at += 1) {
      const id = tokens[at].type === "list_item_open" ? idOf(tokens[at + 2]) : undefined;
      if (id === undefined || !known.rules.has(id)) continue;
      tokens[at].tag = "section";
      tokens[at].attrs = [
        ["class", `rule ${known.rules.get(id).level}`],
        ["id", id],
      ];
      const level = tokens[at].level;
      const close = tokens.findIndex(
        (token, index) => index > at && token.type === "list_item_close" && token.level === level,
      );
      tokens[close].tag = "section";
      const open = tokens.findLastIndex((token, index) => index < at && token.type === "bullet_list_open");
      const end = tokens.findIndex(
        (token, index) => index > close && token.type === "bullet_list_close" && token.level === tokens[open].level,
      );
      tokens[open].tag = tokens[end].tag = "div";
      tokens[open].attrSet("class", "rules");
      tokens[at + 1].hidden = tokens[at + 3].hidden = false;
      bare(tokens[at + 2]);
      const html = (content) => Object.assign(new Token("html_block", "", 0), { content });
      const { head, foot } = block(known.rules.get(id), env.page);
      tokens.splice(close, 0, html(foot));
      tokens.splice(at + 1, 0, html(head));
    }
  }

  /** The first row of each claim gets its name. */
  function claims(tokens, env) {
    if (env.claims === undefined) return;
    tokens.forEach((token, at) => {
      const row = tokens[at - 2];
      if (token.type !== "inline" || row?.type !== "tr_open" || !env.claims.has(token.content)) return;
      row.attrSet("id", token.content);
      env.claims.delete(token.content);
    });
  }

  return (text, env) => {
    headings = [];
    env.slugger = new GithubSlugger();
    const html = md.render(text, env);
    const title = headings.find(({ level }) => level === 1)?.title ?? env.path;
    return { html, title, headings: headings.filter(({ level }) => level > 1) };
  };
}

const NAMES = /(?<rule>NCP-[A-Z]+-\d{3})|\b(?<finding>L(?:0[1-9]|[12]\d|3[0-5]))\b/g;
const LIST = "(?:, | and | to | or |, and )";
const NAMES_IN_TEXT = new RegExp(
  `${NAMES.source}|\\bchapters? (?<chapter>\\d+(?:${LIST}\\d+)*)` +
    `|\\bsections? (?<section>\\d+\\.\\d+(?:${LIST}\\d+\\.\\d+)*)` +
    `|\\brules? (?<number>\\d+(?:${LIST}\\d+)*)`,
  "gi",
);

/** Each number of a list, with its page. The first keeps the word before it. */
function numbers(list, page) {
  return [...list.matchAll(/(?:[a-z]+ )?(\d+(?:\.\d+)?)/gi)].map(([words, number], nth) => [
    nth === 0 ? words : number,
    page(number),
  ]);
}

function text(token, content) {
  return Object.assign(Object.create(Object.getPrototypeOf(token)), token, { content });
}

function around(token, page, env) {
  const open = Object.assign(text(token, ""), { type: "link_open", tag: "a", nesting: 1, attrs: [], markup: "" });
  open.attrs = [["href", relative(env.page, page)]];
  const close = Object.assign(text(token, ""), { type: "link_close", tag: "a", nesting: -1, attrs: null, markup: "" });
  return [open, token, close];
}

/** The id with which an item begins: `**[NCP-WIRE-007]** …`. */
function idOf(inline) {
  const [first, second, third, fourth] = inline?.children ?? [];
  const strong = [first, second, third].find((token) => token?.type === "strong_open");
  if (strong === undefined) return undefined;
  const begins = /^\*\*\[(NCP-[A-Z]+-\d{3})\]\*\*/.exec(inline.content);
  return begins?.[1];
}

/** Takes the id at the beginning and the tag at the end away: the head of the rule shows them. */
function bare(inline) {
  const children = inline.children;
  const begin = children.findIndex(({ type }) => type === "strong_close") + 1;
  const end = children.findLastIndex(({ type }) => type === "em_open");
  inline.children = children.slice(begin, end);
  const [first] = inline.children;
  if (first !== undefined) first.content = first.content.trimStart();
  const last = inline.children.at(-1);
  if (last !== undefined) last.content = last.content.trimEnd();
}
