"use strict";
// What pages do: colours, filters, cases that open by their address, and the search.

const root = document.documentElement;
const get = (id) => document.getElementById(id);
document.querySelector(".tools").hidden = false;

// ------------------------------------------------------------------------------------------------------------- colours

const THEMES = ["system", "light", "dark"];
const SIGNS = { system: "◐", light: "○", dark: "●" };
const themeButton = get("theme");

function showTheme() {
  const theme = root.dataset.theme ?? "system";
  themeButton.textContent = SIGNS[theme];
  const words = theme === "system" ? "as the system" : theme;
  themeButton.title = `Colours: ${words}`;
  themeButton.setAttribute("aria-label", `Colours: ${words}`);
}

themeButton.addEventListener("click", () => {
  const next = THEMES[(THEMES.indexOf(root.dataset.theme ?? "system") + 1) % THEMES.length];
  if (next === "system") delete root.dataset.theme;
  else root.dataset.theme = next;
  try {
    localStorage.setItem("ncp-theme", next);
  } catch {
    // It holds for this page.
  }
  showTheme();
});
showTheme();

// ------------------------------------------------------------------------------------------------------------ contents

const wide = matchMedia("(min-width: 64rem)");
const aside = document.querySelector("[data-aside]");
if (aside) {
  const follow = () => {
    aside.open = wide.matches;
  };
  wide.addEventListener("change", follow);
  follow();
  aside.querySelector('[aria-current="page"]')?.scrollIntoView?.({ block: "nearest" });
  scrollTo(0, 0);
}

// ------------------------------------------------------------------------------------------------------------- filters

const filter = get("filter");
if (filter) {
  const list = document.querySelector(filter.dataset.filter);
  const rows = [...list.querySelectorAll("[data-row]")].map((row) => ({ row, text: undefined }));
  const groups = [...list.querySelectorAll("[data-group]")];
  const output = filter.parentElement.querySelector("output");
  filter.parentElement.hidden = false;
  const apply = () => {
    const words = filter.value
      .toLowerCase()
      .split(/\s+/)
      .filter((word) => word !== "");
    let shown = 0;
    for (const entry of rows) {
      entry.text ??= entry.row.textContent.toLowerCase();
      entry.row.hidden = !words.every((word) => entry.text.includes(word));
      if (!entry.row.hidden) shown += 1;
    }
    for (const group of groups) group.hidden = group.querySelector("[data-row]:not([hidden])") === null;
    output.value = words.length === 0 ? `${rows.length}` : `${shown} of ${rows.length}`;
  };
  let due;
  filter.addEventListener("input", () => {
    clearTimeout(due);
    due = setTimeout(apply, 80);
  });
  // A browser that goes back fills the field again.
  addEventListener("pageshow", apply);
}

// A case or a group that an address names is opened.
function open() {
  const target = get(decodeURIComponent(location.hash.slice(1)));
  if (!target) return;
  if (target.hidden && filter) {
    filter.value = "";
    filter.dispatchEvent(new Event("input"));
    target.hidden = false;
  }
  for (let at = target; at; at = at.parentElement) {
    if (at.tagName === "DETAILS") at.open = true;
  }
  target.scrollIntoView();
}
addEventListener("hashchange", open);
open();

// A case that is opened is the page's address, so that it can be passed on.
addEventListener(
  "toggle",
  ({ target }) => {
    if (target.matches?.("details.case") && target.open && location.hash !== `#${target.id}`) {
      history.replaceState(null, "", `#${target.id}`);
    }
  },
  true,
);

// -------------------------------------------------------------------------------------------------------------- search

const dialog = get("search");
const query = get("query");
const found = get("found");
const status = get("search-status");
const MOST = 40;
const WEIGHTS = {
  rule: 4,
  finding: 3,
  text: 2.5,
  page: 1.2,
  "bug class": 1,
  "live scenario": 0.8,
  defect: 0.5,
  case: 0.4,
};
let index;

function script(name) {
  return new Promise((resolve, reject) => {
    const element = document.createElement("script");
    element.src = `${root.dataset.root}assets/${name}`;
    element.addEventListener("load", resolve);
    element.addEventListener("error", reject);
    document.head.append(element);
  });
}

/** The index: it is loaded and built when somebody first searches. */
function load() {
  index ??= Promise.all([script("minisearch.js"), script("search-index.js")]).then(() => {
    const search = new MiniSearch({
      fields: ["title", "text"],
      searchOptions: {
        combineWith: "AND",
        prefix: true,
        boost: { title: 2 },
        boostDocument: (id) => WEIGHTS[window.ncpSearch[id][0]] ?? 1,
      },
    });
    search.addAll(window.ncpSearch.map(([, title, , text], id) => ({ id, title, text })));
    return search;
  });
  return index;
}

async function search() {
  const wanted = query.value.trim();
  if (wanted === "") {
    show([], "");
    return;
  }
  status.textContent = "Searching …";
  const all = (await load()).search(wanted);
  if (wanted !== query.value.trim()) return;
  // An id that is written as it stands comes first.
  const exact = ({ id }) => Number(window.ncpSearch[id][1].toLowerCase() === wanted.toLowerCase());
  all.sort((one, other) => exact(other) - exact(one) || other.score - one.score);
  const more = all.length > MOST ? `, the best ${MOST} of them below` : "";
  show(all.slice(0, MOST), all.length === 0 ? "Nothing was found." : `${all.length.toLocaleString("en")} found${more}`);
}

function show(results, words) {
  status.textContent = words;
  query.setAttribute("aria-expanded", String(results.length > 0));
  query.removeAttribute("aria-activedescendant");
  found.replaceChildren(
    ...results.map(({ id }, nth) => {
      const [kind, title, page, text] = window.ncpSearch[id];
      const item = document.createElement("li");
      item.id = `found-${nth}`;
      item.setAttribute("role", "option");
      item.setAttribute("aria-selected", "false");
      const link = document.createElement("a");
      link.href = root.dataset.root + page;
      link.tabIndex = -1;
      for (const [name, content] of [
        ["kind", kind],
        ["title", title],
        ["text", excerpt(text)],
      ]) {
        const part = document.createElement("span");
        part.className = name;
        part.textContent = content;
        link.append(part);
      }
      item.append(link);
      return item;
    }),
  );
  if (results.length > 0) pick(0);
}

/** The part of a text where the first word of the query stands. */
function excerpt(text) {
  const word = query.value.trim().split(/\s+/)[0].toLowerCase();
  const at = Math.max(0, text.toLowerCase().indexOf(word) - 60);
  return (at > 0 ? "… " : "") + text.slice(at, at + 160) + (text.length > at + 160 ? " …" : "");
}

const picked = () => [...found.children].findIndex((item) => item.getAttribute("aria-selected") === "true");

function pick(nth) {
  const items = [...found.children];
  items.forEach((item, index) => item.setAttribute("aria-selected", String(index === nth)));
  query.setAttribute("aria-activedescendant", items[nth].id);
  items[nth].scrollIntoView({ block: "nearest" });
}

function openSearch() {
  if (dialog.open) return;
  dialog.showModal();
  query.select();
  load().catch(() => {
    status.textContent = "The index cannot be loaded.";
  });
}

get("open-search").addEventListener("click", openSearch);
addEventListener("keydown", (event) => {
  const isTyped = event.target.matches?.("input, textarea, select, [contenteditable]");
  if (event.key === "/" && !isTyped && !event.ctrlKey && !event.metaKey && !event.altKey) {
    event.preventDefault();
    openSearch();
  }
});
let dueSearch;
query.addEventListener("input", () => {
  clearTimeout(dueSearch);
  dueSearch = setTimeout(search, 120);
});
query.addEventListener("keydown", (event) => {
  const count = found.children.length;
  if (event.key === "Escape") {
    // A field for a search would only be emptied.
    event.preventDefault();
    dialog.close();
  } else if (event.key === "Enter") {
    event.preventDefault();
    found.children[picked()]?.querySelector("a").click();
  } else if (count > 0 && (event.key === "ArrowDown" || event.key === "ArrowUp")) {
    event.preventDefault();
    pick((picked() + (event.key === "ArrowDown" ? 1 : count - 1)) % count);
  }
});
// A click beside the dialog closes it, and so does a way to the same page.
dialog.addEventListener("click", (event) => {
  if (event.target === dialog || event.target.closest("a")) dialog.close();
});
