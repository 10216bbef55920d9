"use strict";
const $ = (id) => document.getElementById(id);
const el = (name, attributes, ...children) => {
  const made = name.startsWith("svg:")
    ? document.createElementNS("http://www.w3.org/2000/svg", name.slice(4))
    : document.createElement(name);
  for (const [key, value] of Object.entries(attributes ?? {})) {
    if (key === "onclick") made.addEventListener("click", value);
    else if (value !== undefined && value !== false) made.setAttribute(key, value === true ? "" : value);
  }
  made.append(...children.flat(Infinity).filter((child) => child !== undefined && child !== null && child !== ""));
  return made;
};
/** Prose with pieces of code between backticks. */
const prose = (text) => text.split("`").map((piece, place) => place % 2 ? el("code", {}, piece) : piece);
const unpack = async (id) => {
  const text = atob($(id).textContent.trim());
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).json();
};
const WORDS = { p: "passed", u: "unexpected pass", f: "failed", a: "advice", x: "expected failure", n: "not run",
  o: "not asked" };
const LOOK = { p: "p", u: "p", f: "f", a: "a", x: "x", n: "n", o: "o" };
const OUTCOMES = { p: "pass", f: "fail", u: "unsupported", c: "crash", t: "timeout", b: "protocol", n: "not run" };
const CHOICES = [["", "any status"], ["f", "failing"], ["c", "crash, timeout, protocol"], ["i", "inconclusive"],
  ["u", "unsupported"], ["x", "expected failure"], ["a", "advice"], ["n", "not run"], ["p", "passed"]];
const ROW = 52;
let data, shown = [], chosen = -1, opened = -1, peer = 0;
const chunks = new Map();

const plural = (count, word) => `${count.toLocaleString("en")} ${word}${count === 1 ? "" : "s"}`;
const pill = (mark, text) => el("span", { class: `pill ${LOOK[mark] ?? ""}` }, text);

unpack("index").then((index) => {
  data = index;
  about();
  verdicts();
  defects();
  matrix();
  choices();
  filter();
  fromHash();
  document.documentElement.dataset.ready = "1";
});

function about() {
  const of = data.of;
  document.title = `NCP ${of.wire} conformance, level ${of.level}`;
  const part = of.partial ? "; only a part of the cases was run: a pass is no conformance" : "";
  const cut = of.interrupted ? "; the run was interrupted" : "";
  $("run").textContent = `NCP ${of.wire}, level ${of.level}: ${plural(of.cases, "case")} in ` +
    `${plural(of.files, "file")}, ${of.started}, ncp-verify ${of.version}, corpus ${of.corpus.slice(0, 12)}` +
    `${part}${cut}`;
}

function verdicts() {
  const card = (each, place) => {
    const counts = [["f", "failed"], ["x", "expected failure"], ["a", "advice"], ["n", "not run"]]
      .map(([mark, word]) => [mark, each.status.split(mark).length - 1, word])
      .filter(([, count]) => count > 0)
      .map(([mark, count, word]) => [pill(mark, `${count.toLocaleString("en")} ${word}`), " "]);
    const levels = each.roles.map(([role, levels]) => el("div", {},
      `${role}: `, levels.map(([level, conformant, passed, all]) =>
        [pill(conformant ? "p" : "f", `${conformant ? "✓" : "✗"} ${level} ${all ? `${passed}/${all}` : ""}`.trim()), " "])));
    return el("div", { class: `card ${each.verdict.replace(" ", "-")}` },
      el("h3", {}, each.name, " ", el("span", { class: "dim" }, each.version)),
      el("p", {}, el("strong", {}, each.verdict), each.reason ? `: ${each.reason}` : ""),
      el("p", {}, counts.flat()), levels,
      each.notes.map((note) => el("p", { class: "dim" }, note)),
      each.crash ? el("details", {}, el("summary", {}, `the log of a crash: ${each.crash[0]}`),
        el("pre", {}, each.crash[1])) : "",
      el("p", {}, each.status.includes("f")
        ? el("button", { type: "button", onclick: () => show({ peer: place, status: "f" }) }, "its failing cases")
        : ""));
  };
  $("verdicts").append(el("h2", {}, "Verdict"), el("div", { class: "cards" }, data.peers.map(card)));
}

function defects() {
  const section = $("defects");
  data.peers.forEach((each, place) => {
    const broken = each.status.includes("f");
    if (!broken && !each.untrue.length) return;
    section.append(el("h2", {}, `What is broken: ${each.name}`));
    each.untrue.forEach((text) => section.append(el("div", { class: "defect" }, pill("f", "list"), " ", text)));
    for (const found of each.defects) {
      section.append(el("div", { class: "defect" },
        pill("f", found.severity), " ", el("strong", {}, prose(found.words)), " ",
        el("code", { class: "dim" }, found.id), " ",
        el("div", { class: "dim" }, `explains ${plural(found.cases, "failing case")}, such as `,
          el("button", { type: "button", class: "pill", onclick: () => openId(found.shortest, place) },
            found.shortest),
          found.passing ? `; it would also fail ${plural(found.passing, "case")} that pass` : "")));
    }
    const left = plural(each.unexplained, "failing case");
    const unexplained = each.defects.length && each.unexplained ? `${left} no known defect explains. ` : "";
    const rules = new Map();
    for (let i = each.status.indexOf("f"); i >= 0; i = each.status.indexOf("f", i + 1)) {
      const rule = each.charged[i] ?? data.cases[i].rules[0];
      rules.set(rule, (rules.get(rule) ?? 0) + 1);
    }
    const weight = (rule) => data.severities.indexOf(data.rules[rule]?.severity);
    const sorted = [...rules].sort((a, b) => weight(a[0]) - weight(b[0]) || b[1] - a[1]);
    const row = ([rule, count]) => el("tr", {},
      el("td", {}, el("button", { type: "button", class: "pill f",
        onclick: () => show({ peer: place, status: "f", search: rule }) }, rule)),
      el("td", {}, data.rules[rule]?.severity ?? ""), el("td", {}, String(count)),
      el("td", {}, prose(data.rules[rule]?.sentence ?? "")));
    const table = (rows) => el("div", { class: "scroll broken" }, el("table", {},
      el("thead", {}, el("tr", {}, ["rule", "severity", "cases", "sentence"].map((head) => el("th", {}, head)))),
      el("tbody", {}, rows.map(row))));
    if (sorted.length) {
      const list = el("details", {}, el("summary", {}, `${unexplained}${plural(sorted.length, "broken rule")}`));
      const more = sorted.length > 60 ? el("p", { class: "dim" }, `and ${sorted.length - 60} more`) : "";
      list.addEventListener("toggle", () => list.append(table(sorted.slice(0, 60)), more), { once: true });
      list.open = data.peers.length <= 3 && (sorted.length <= 8 || !each.defects.length);
      section.append(list);
    }
  });
}

function matrix() {
  const deep = data.levels.length;
  const place = Int32Array.from(data.cases, (of) => of.chapter * deep + of.level);
  const count = ({ status }) => {
    const cells = Array.from({ length: data.chapters.length * deep }, () => ({ all: 0, good: 0, f: 0, x: 0, n: 0 }));
    for (let i = 0; i < place.length; i++) {
      const mark = status[i], cell = cells[place[i]];
      if (mark === "o" || cell === undefined) continue;
      cell.all++;
      if (mark === "p" || mark === "u" || mark === "a") cell.good++;
      else cell[mark]++;
    }
    return cells;
  };
  const cellOf = (cells, place, chapter) => el("td", {}, data.levels.map((level, l) => {
    const cell = cells[chapter * deep + l];
    if (!cell.all) return "";
    const mark = cell.f ? "f" : cell.n ? "n" : cell.x ? "x" : "p";
    const status = cell.f ? "f" : cell.x ? "x" : "";
    return el("button", { type: "button", class: `pill ${LOOK[mark]}`,
      "aria-label": `${data.peers[place].name}, ${data.chapters[chapter]}, ${level}: ${cell.good} of ${cell.all}`,
      onclick: () => show({ peer: place, chapter, level: l, status }) }, `${level} ${cell.good}/${cell.all}`);
  }));
  const row = (each, place) => {
    const cells = count(each);
    return el("tr", {}, el("th", { scope: "row" }, each.name),
      each.state === "checked" ? data.chapters.map((_, chapter) => cellOf(cells, place, chapter))
        : el("td", { colspan: data.chapters.length }, each.verdict));
  };
  $("matrix").append(el("h2", {}, "Peers × chapters × levels"), el("div", { class: "scroll" }, el("table", {},
    el("thead", {}, el("tr", {}, el("th", {}, "peer"), data.chapters.map((name) => el("th", { scope: "col" }, name)))),
    el("tbody", {}, data.peers.map(row)))));
}

function choices() {
  const fill = (id, options) => options.forEach(([value, text]) => $(id).append(el("option", { value }, text)));
  fill("peer", [["", "all peers"], ...data.peers.map((each, place) => [place, each.name])]);
  fill("status", CHOICES);
  fill("chapter", [["", "all chapters"], ...data.chapters.map((name, place) => [place, name])]);
  fill("level", [["", "all levels"], ...data.levels.map((name, place) => [place, name])]);
  if (data.peers.some((each) => each.status.includes("f"))) $("status").value = "f";
  for (const id of ["peer", "status", "chapter", "level"]) $(id).addEventListener("change", filter);
  let timer;
  $("search").addEventListener("input", () => { clearTimeout(timer); timer = setTimeout(filter, 60); });
  $("filters").addEventListener("submit", (event) => event.preventDefault());
  $("filters").addEventListener("reset", () => setTimeout(filter));
  $("list").addEventListener("scroll", draw, { passive: true });
  addEventListener("resize", draw);
}

/** Whether a case of a peer is of the status that is looked for. */
function fits(each, i, status) {
  const mark = each.status[i], outcome = each.outcome[i];
  switch (status) {
    case "": return mark !== "o";
    case "c": return "ctb".includes(outcome);
    case "u": return outcome === "u";
    case "i": return each.waits.has(i);
    case "p": return mark === "p" || mark === "u";
    default: return mark === status;
  }
}

function filter() {
  const [of, status, chapter, level] = ["peer", "status", "chapter", "level"].map((id) => $(id).value);
  const words = $("search").value.toLowerCase().split(/\s+/).filter(Boolean);
  const peers = of === "" ? data.peers : [data.peers[of]];
  for (const each of peers) each.waits = typeof each.waits.has === "function" ? each.waits : new Set(each.waits);
  shown = [];
  data.cases.forEach((each, i) => {
    if (chapter !== "" && each.chapter !== Number(chapter)) return;
    if (level !== "" && each.level !== Number(level)) return;
    if (!peers.some((peer) => fits(peer, i, status))) return;
    if (words.length) {
      each.text ??= [each.id, each.title, each.call, ...each.rules].join(" ").toLowerCase();
      const meant = () => peers.filter((peer) => fits(peer, i, status));
      const charged = () => meant().map((peer) => peer.charged[i] ?? "").join(" ").toLowerCase();
      if (!words.every((word) => each.text.includes(word) || charged().includes(word))) return;
    }
    shown.push(i);
  });
  chosen = Math.min(Math.max(chosen, shown.indexOf(opened)), shown.length - 1);
  $("count").textContent = `${shown.length.toLocaleString("en")} of ${data.cases.length.toLocaleString("en")}`;
  $("space").style.height = `${shown.length * ROW}px`;
  draw();
}

function show({ peer: of = "", status = "", chapter = "", level = "", search = "" }) {
  $("peer").value = of; $("status").value = status; $("chapter").value = chapter; $("level").value = level;
  $("search").value = search;
  chosen = -1;
  $("list").scrollTop = 0;
  filter();
  $("cases").scrollIntoView();
  $("list").focus({ preventScroll: true });
}

const marks = (i) => data.peers.map((each) => el("span", { class: `m ${LOOK[each.status[i]]}`,
  title: `${each.name}: ${WORDS[each.status[i]]}` }));

function row(i, place) {
  const each = data.cases[i];
  const words = data.peers.filter((peer) => peer.status[i] === "f").length;
  return el("div", { class: "row", role: "option", id: `row-${place}`, "aria-selected": String(place === chosen),
    style: `top:${place * ROW}px`, "aria-posinset": place + 1, "aria-setsize": shown.length,
    onclick: () => { chosen = place; open(i); } },
  el("div", {}, prose(each.title)),
  el("div", { class: "sub" }, el("code", {}, each.id),
    el("span", { class: "marks", "aria-label": `${words} of ${data.peers.length} peers fail` }, marks(i))));
}

function draw() {
  const list = $("list"), first = Math.max(0, Math.floor(list.scrollTop / ROW) - 5);
  const rows = shown.slice(first, first + Math.ceil(list.clientHeight / ROW) + 10);
  $("space").replaceChildren(...rows.map((i, place) => row(i, first + place)));
  list.setAttribute("aria-activedescendant", chosen >= 0 ? `row-${chosen}` : "");
}

function move(by) {
  if (!shown.length) return;
  chosen = Math.min(Math.max(chosen + by, 0), shown.length - 1);
  const list = $("list"), top = chosen * ROW;
  if (top < list.scrollTop) list.scrollTop = top;
  if (top + ROW > list.scrollTop + list.clientHeight) list.scrollTop = top + ROW - list.clientHeight;
  draw();
  if (!$("case").hidden) open(shown[chosen], false);
}

function openId(id, of) {
  const i = data.cases.findIndex((each) => each.id === id);
  if (i < 0) return;
  if (of !== undefined) peer = of;
  show({ peer: of ?? "", search: id });
  chosen = shown.indexOf(i);
  open(i);
}

async function detail(i) {
  const chunk = Math.floor(i / data.chunk);
  if (!chunks.has(chunk)) chunks.set(chunk, unpack(`chunk-${chunk}`));
  return (await chunks.get(chunk))[i % data.chunk];
}

async function open(i, focus = true) {
  opened = i;
  const asked = (place) => data.peers[place]?.status[i] !== "o" && data.peers[place]?.state === "checked";
  const picked = $("peer").value === "" ? peer : Number($("peer").value);
  const wanted = [picked, ...data.peers.keys()];
  const failing = wanted.find((place) => asked(place) && data.peers[place].status[i] === "f");
  peer = asked(picked) && (picked === peer || $("peer").value !== "") ? picked : failing ?? wanted.find(asked) ?? 0;
  if ($("peer").value === "" && data.peers[peer].status[i] !== "f" && failing !== undefined) peer = failing;
  $("split").classList.add("open");
  $("case").hidden = false;
  draw();
  await render();
  if (focus) {
    $("case").scrollTop = 0;
    $("case").focus({ preventScroll: true });
    if (innerWidth <= 900) $("case").scrollIntoView();
  }
  const of = new URLSearchParams({ case: data.cases[i].id, peer: data.peers[peer].name });
  history.replaceState(null, "", `#${of}`);
}

function fromHash() {
  const asked = new URLSearchParams(location.hash.slice(1));
  const place = data.peers.findIndex((each) => each.name === asked.get("peer"));
  if (asked.has("case")) openId(asked.get("case"), place < 0 ? undefined : place);
}

function close() {
  $("split").classList.remove("open");
  $("case").hidden = true;
  opened = -1;
  history.replaceState(null, "", location.pathname);
  $("list").focus();
  draw();
}

const parse = (text) => { try { return JSON.parse(text); } catch { return undefined; } };
const quote = (text) => `'${text.replaceAll("'", "'\\''")}'`;

async function render() {
  const i = opened, each = data.cases[i], of = data.peers[peer];
  const about = await detail(i);
  if (opened !== i) return;
  const found = about.peers[peer] ?? {};
  const tab = (each, place) => each.status[i] === "o" ? "" : el("button", { type: "button",
    "aria-pressed": String(place === peer), onclick: () => { peer = place; render(); } },
  el("span", { class: `m ${LOOK[each.status[i]]}` }), ` ${each.name}`);
  const charged = of.charged[i];
  const ruleOf = (id) => el("p", { class: "rule" }, el("code", {}, id), " ",
    pill(charged === id ? "f" : "", data.rules[id]?.keyword ?? ""), " ", prose(data.rules[id]?.sentence ?? ""));
  const rules = [...new Set([charged, ...each.rules].filter(Boolean))];
  const by = of.command ? `--peer-cmd ${quote(of.source)}` : `--peer ${quote(of.source)}`;
  const command = `ncp-verify run ${by} --level ${data.levels[each.level]} --filter ${quote(each.id)} --verbose`;
  const copy = el("button", { type: "button", onclick: async () => {
    try { await navigator.clipboard.writeText(command); } catch {
      const range = document.createRange();
      range.selectNodeContents(copy.previousElementSibling);
      getSelection().removeAllRanges();
      getSelection().addRange(range);
    }
    copy.textContent = "copied";
  } }, "copy");
  const status = of.status[i], outcome = OUTCOMES[of.outcome[i]] ?? "";
  const request = about.request === undefined ? undefined : parse(about.request);
  const answer = found.answer === undefined ? undefined : parse(found.answer);
  const parts = el("div", {},
    el("header", {}, el("h2", {}, prose(each.title)),
      el("button", { type: "button", "aria-label": "Close", onclick: close }, "×")),
    el("p", { class: "dim" }, el("code", {}, each.id), ` · ${each.call} · ${data.levels[each.level]}` +
      `${each.binding ? "" : " · advice only"} · ${each.roles.join(", ")}`),
    el("div", { class: "tabs", role: "group", "aria-label": "Peers" }, data.peers.map(tab)),
    el("p", {}, pill(status, WORDS[status]), " ", outcome, found.what ? `: it ${found.what}` : "",
      of.waits.includes?.(i) || of.waits.has?.(i) ? ` — inconclusive: it waits for ${charged}` : "",
      found.note ? ` — ${found.note}` : "", found.reason ? ` — expected: ${found.reason}` : ""),
    rules.map(ruleOf), el("p", { class: "dim" }, prose(about.why ?? "")),
    el("div", { class: "copy" }, el("pre", {}, command), copy),
    differences(found), trace(each, about, request, answer),
    el("h3", {}, "Answers"), both(about, found, answer),
    input(about, request),
    found.log ? [el("h3", {}, "Its log"), el("pre", {}, found.log)] : "");
  $("case").replaceChildren(...parts.childNodes);
}

function differences(found) {
  if (!found.differences?.length) return "";
  const row = ([at, expected, got, hint]) => el("tr", {}, el("td", {}, el("code", {}, at || "the whole")),
    el("td", {}, el("code", {}, expected ?? "nothing")), el("td", {}, el("code", {}, got ?? "nothing")),
    el("td", { class: "dim" }, hint ?? ""));
  return [el("h3", {}, "What differs"), el("div", { class: "scroll" }, el("table", { class: "steps" },
    el("thead", {}, el("tr", {}, ["where", "expected", "got", ""].map((head) => el("th", {}, head)))),
    el("tbody", {}, found.differences.map(row)))),
  found.more ? el("p", { class: "dim" }, `and ${plural(found.more, "more difference")}`) : ""];
}

/** A value over several lines; those at or below the places are marked. */
function lines(value, places, mark) {
  const out = [];
  const put = (value, at, indent, before, after) => {
    const bad = places.some((place) => place !== "" && (at === place || at.startsWith(`${place}/`)));
    const line = (text) => out.push(el("span", { class: bad ? mark : undefined }, text, bad ? "" : "\n"));
    const pad = "  ".repeat(indent), compact = JSON.stringify(value);
    const inside = places.some((place) => place.startsWith(`${at}/`));
    if (value === null || typeof value !== "object" || (compact.length < 60 && !inside)) {
      return line(`${pad}${before}${compact}${after}`);
    }
    const list = Array.isArray(value), entries = Object.entries(value);
    line(`${pad}${before}${list ? "[" : "{"}`);
    entries.forEach(([key, child], place) => put(child, `${at}/${key.replaceAll("~", "~0").replaceAll("/", "~1")}`,
      indent + 1, list ? "" : `${JSON.stringify(key)}: `, place + 1 < entries.length ? "," : ""));
    line(`${pad}${list ? "]" : "}"}${after}`);
  };
  put(value, "", 0, "", "");
  return el("pre", {}, out);
}

/** A frame within an answer is shown as what it is. */
const unwrapped = (result) => parse(result?.text ?? "") ?? result;

function both(about, found, answer) {
  const places = (found.differences ?? []).map(([at]) => at);
  const [relation, text] = about.expected ?? ["", ""];
  // Where the spelling is judged, nothing is spelled anew.
  const spelled = relation.startsWith("spelled");
  const value = spelled ? undefined : parse(text);
  const expected = value === undefined || typeof value === "string" ? el("pre", {}, text)
    : lines(value, places, "want");
  const whole = answer && "result" in answer ? answer.result : answer;
  const result = spelled && typeof whole?.text === "string" ? el("pre", {}, whole.text) : unwrapped(whole);
  const got = found.answer === undefined ? el("p", { class: "dim" }, "as expected; what passes is not kept")
    : result instanceof Node ? result
    : result === undefined || typeof result === "string" ? el("pre", {}, found.answer) : lines(result, places, "bad");
  return el("div", { class: "both" }, el("div", {}, el("h3", {}, `Expected `, el("span", { class: "dim" }, relation)),
    expected), el("div", {}, el("h3", {}, "Got"), found.answer === undefined && !found.pass ? el("p", { class: "dim" },
    found.lacks ? "it has no such function" : "no answer") : got));
}

function input(about, request) {
  if (about.request === undefined) return "";
  const args = request?.args ?? {};
  let bytes;
  if (typeof args.text === "string") bytes = new TextEncoder().encode(args.text);
  const coded = args.base64 ?? args.block;
  if (typeof coded === "string") {
    try { bytes = Uint8Array.from(atob(coded), (c) => c.charCodeAt(0)); } catch { bytes = undefined; }
  }
  return [el("h3", {}, "Input"), request === undefined ? el("pre", {}, about.request) : lines(request, [], ""),
    bytes ? [el("details", { open: bytes.length <= 256 },
      el("summary", {}, `${plural(bytes.length, "byte")}, in hex and as text`), el("pre", {}, hex(bytes)))] : ""];
}

function hex(bytes) {
  const rows = [];
  for (let at = 0; at < Math.min(bytes.length, 4096); at += 16) {
    const row = [...bytes.slice(at, at + 16)];
    const digits = row.map((byte) => byte.toString(16).padStart(2, "0")).join(" ").padEnd(47);
    const text = row.map((byte) => byte >= 32 && byte < 127 ? String.fromCharCode(byte) : "·").join("");
    rows.push(`${at.toString(16).padStart(4, "0")}  ${digits}  ${text}`);
  }
  if (bytes.length > 4096) rows.push(`… ${bytes.length - 4096} more`);
  return rows.join("\n");
}

const number = (value) => value === "Infinity" ? Infinity : value === "-Infinity" ? -Infinity
  : value === "-0" ? -0 : typeof value === "number" ? value : NaN;
const MODES = { active: "--good", hold: "--warn", estop: "--bad", init: "--none" };

/** What a step says of the mode or the hold of a plant. */
function state(step) {
  if (!step || typeof step !== "object") return undefined;
  const frame = step.frame ?? step.command;
  if (typeof frame?.mode === "string") return frame.mode;
  if (typeof step.hold === "boolean") return step.hold ? "hold" : "active";
  if ("channels" in step) return step.channels === null ? "hold" : "active";
  return undefined;
}

function trace(each, about, request, answer) {
  const steps = request?.args?.steps;
  if (!Array.isArray(steps)) return "";
  const expected = parse(about.expected?.[1] ?? "")?.steps ?? [], got = answer?.result?.steps;
  let clock = 0;
  const rows = steps.map((step, place) => {
    const now = number(step.now_s);
    if (Number.isFinite(now)) clock = now;
    const command = typeof step.command === "object" ? step.command : parse(step.text ?? "");
    const ttl = number(step.ttl_ms ?? command?.ttl_ms);
    const position = (step.sensor?.channels?.pose_position?.data ?? []).map(number);
    return { place, step, now, at: clock, op: step.op, mode: command?.mode,
      ttl: Number.isFinite(ttl) && /command|govern/.test(step.op) ? Math.max(0, ttl / 1000) : undefined,
      away: position.length === 3 ? Math.hypot(...position) : undefined,
      want: state(expected[place]), got: got ? state(got[place]) : undefined };
  });
  const radius = number(request.args.limits?.geofence_radius_m);
  return [el("h3", {}, "Trace"), timeline(each, rows, radius), table(rows, expected, got)];
}

/** Lanes over time: what came, how long it lives, what the plant does, whether a latch holds, and the fence. */
function timeline(each, rows, radius) {
  const timed = rows.some((row) => Number.isFinite(row.now));
  const x0 = Math.min(...rows.map((row) => timed ? row.at : row.place));
  let x1 = Math.max(...rows.map((row) => timed ? row.at + Math.min(row.ttl ?? 0, 5) : row.place));
  if (!(x1 > x0)) x1 = x0 + 1;
  const still = timed && rows.every((row) => row.at === x0);
  const width = 860, left = 92, xOf = (row) => {
    const share = still ? (row.place + 0.5) / rows.length : ((timed ? row.at : row.place) - x0) / (x1 - x0);
    return left + share * (width - left - 20);
  };
  const per = still ? 0 : (width - left - 20) / (x1 - x0);
  const parts = [];
  let y = 24;
  const label = (text) => parts.push(el("svg:text", { x: 4, y: y + 4 }, text),
    el("svg:line", { class: "axis", x1: left, x2: width, y1: y, y2: y }));
  const dot = (row, mode, shape) => {
    const color = `fill:var(${MODES[mode] ?? "--accent"})`, x = xOf(row);
    const tip = el("svg:title", {}, `step ${row.place}, ${row.op}${timed ? ` at ${row.at} s` : ""}: ${mode ?? ""}`);
    parts.push(shape === "box" ? el("svg:rect", { x: x - 5, y: y - 5, width: 10, height: 10, style: color }, tip)
      : el("svg:circle", { cx: x, cy: y, r: 5, style: color }, tip));
  };
  const lane = (name, use) => { label(name); use(); y += 26; };
  lane("comes", () => rows.forEach((row) => {
    if (row.mode || /command|govern|sensor|frame|note_link/.test(row.op)) dot(row, row.mode, "box");
    else if (row.op === "reset") parts.push(el("svg:text", { x: xOf(row) - 4, y: y + 4 }, "R",
      el("svg:title", {}, `step ${row.place}: reset`)));
  }));
  if (rows.some((row) => row.ttl !== undefined) && !per) {
    lane("ttl", () => rows.filter((row) => row.ttl !== undefined).forEach((row) => parts.push(
      el("svg:text", { x: xOf(row) - 12, y: y + 4 }, `${row.ttl} s`))));
  } else if (rows.some((row) => row.ttl !== undefined)) {
    lane("ttl", () => rows.filter((row) => row.ttl !== undefined).forEach((row, place) => parts.push(
      el("svg:rect", { x: xOf(row), y: y - 4 + (place % 2) * 5, height: 4, style: "fill:var(--accent);opacity:.6",
        width: Math.max(2, Math.min(row.ttl * per, width - 8 - xOf(row))) }, el("svg:title", {}, `${row.ttl} s`)))));
  }
  const wanted = rows.some((row) => row.want), answered = rows.some((row) => row.got);
  const latch = (name, of) => lane(name, () => {
    let from;
    const end = (x) => { parts.push(el("svg:rect", { x: from, y: y - 4, width: Math.max(3, x - from), height: 8,
      style: "fill:var(--bad);opacity:.7" }, el("svg:title", {}, "ESTOP holds"))); from = undefined; };
    rows.forEach((row) => {
      if (of(row) === "estop") from ??= xOf(row);
      else if (from !== undefined && (row.op === "reset" || of(row) === "active")) end(xOf(row));
    });
    if (from !== undefined) end(width - 12);
  });
  const latches = (of) => rows.some((row) => of(row) === "estop");
  if (wanted) lane("expected", () => rows.filter((row) => row.want).forEach((row) => dot(row, row.want)));
  if (answered) lane("got", () => rows.filter((row) => row.got).forEach((row) => {
    dot(row, row.got);
    if (row.want && row.want !== row.got) parts.push(el("svg:circle", { cx: xOf(row), cy: y, r: 9,
      style: "fill:none;stroke:var(--bad);stroke-width:2" }));
  }));
  if (latches((row) => row.want)) latch("latch, exp.", (row) => row.want);
  if (latches((row) => row.got)) latch("latch, got", (row) => row.got);
  const away = rows.filter((row) => Number.isFinite(row.away));
  if (away.length && radius > 0 && Number.isFinite(radius)) {
    const top = y, height = 70, most = Math.max(radius, ...away.map((row) => row.away)) * 1.15;
    const yOf = (value) => top + height - (value / most) * height;
    parts.push(el("svg:text", { x: 4, y: top + height / 2 }, "fence"),
      el("svg:line", { x1: left, x2: width, y1: yOf(radius), y2: yOf(radius),
        style: "stroke:var(--bad);stroke-dasharray:5 3" }),
      el("svg:text", { x: width - 70, y: yOf(radius) - 3, class: "soft" }, `${radius} m`),
      el("svg:line", { class: "axis", x1: left, x2: width, y1: top + height, y2: top + height }),
      el("svg:polyline", { points: away.map((row) => `${xOf(row)},${yOf(row.away)}`).join(" "),
        style: "fill:none;stroke:var(--accent);stroke-width:2" }),
      away.map((row) => el("svg:circle", { cx: xOf(row), cy: yOf(row.away), r: 4,
        style: `fill:var(${row.away > radius ? "--bad" : "--accent"})` },
      el("svg:title", {}, `step ${row.place}: ${row.away} m from the origin`))));
    y = top + height + 20;
  }
  const ticks = still ? [] : [0, 0.25, 0.5, 0.75, 1].map((share) => {
    const value = x0 + share * (x1 - x0);
    const text = timed ? `${Number(value.toPrecision(6))} s` : String(Math.round(value));
    const anchor = share === 0 ? "start" : share === 1 ? "end" : "middle";
    const x = left + share * (width - left - 20);
    return el("svg:text", { x, y: y + 4, class: "soft", "text-anchor": anchor }, text);
  });
  const legend = Object.entries(MODES).flatMap(([mode, color], place) => [
    el("svg:circle", { cx: left + 8 + place * 70, cy: 8, r: 4, style: `fill:var(${color})` }),
    el("svg:text", { x: left + 16 + place * 70, y: 12, class: "soft" }, mode)]);
  const note = still ? el("svg:text", { x: left, y: y + 4, class: "soft" }, `all at ${x0} s, in their order`) : "";
  const about = { viewBox: `0 0 ${width} ${y + 12}`, role: "img", "aria-label": `The trace of ${each.id} over time` };
  return el("div", { class: "scroll" }, el("svg:svg", about,
    legend, parts, ticks, note));
}

function table(rows, expected, got) {
  const brief = (value) => value === undefined ? "" : JSON.stringify(value).replace(/^\{\}$/, "");
  const row = ({ place, step, now, op, want, got: state }) => {
    const { op: _, now_s: __, ...rest } = step;
    return el("tr", { class: want && state && want !== state ? "wrong" : undefined },
      el("td", {}, String(place)), el("td", {}, Number.isFinite(now) ? String(now) : ""), el("td", {}, op),
      [rest, expected[place], ...(got ? [got[place]] : [])].map((value) =>
        el("td", {}, el("code", {}, brief(value).slice(0, 300)))));
  };
  return el("details", {}, el("summary", {}, plural(rows.length, "step")), el("div", { class: "scroll" },
    el("table", { class: "steps" }, el("thead", {}, el("tr", {}, ["", "s", "step", "asked", "expected", got ? "got" : ""]
      .map((head) => el("th", {}, head)))), el("tbody", {}, rows.slice(0, 500).map(row)))));
}

document.addEventListener("keydown", (event) => {
  const typing = /^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName);
  if (event.key === "Escape") {
    if (typing) event.target.blur();
    else if (!$("case").hidden) close();
    return;
  }
  if (typing || event.ctrlKey || event.metaKey || event.altKey) return;
  const inList = document.activeElement === $("list");
  const act = { "/": () => $("search").focus(), j: () => move(1), k: () => move(-1),
    "[": () => turn(-1), "]": () => turn(1) }[event.key]
    ?? (inList && { ArrowDown: () => move(1), ArrowUp: () => move(-1), PageDown: () => move(10),
      PageUp: () => move(-10), Home: () => move(-shown.length), End: () => move(shown.length),
      Enter: () => chosen >= 0 && open(shown[chosen]) }[event.key]);
  if (!act) return;
  event.preventDefault();
  act();
});

function turn(by) {
  if (opened < 0) return;
  const asked = [...data.peers.keys()].filter((place) => data.peers[place].status[opened] !== "o");
  const at = asked.indexOf(peer);
  if (at >= 0) peer = asked[(at + by + asked.length) % asked.length];
  render();
}

const root = document.documentElement, night = matchMedia("(prefers-color-scheme: dark)");
const paint = (dark) => { root.classList.toggle("dark", dark); root.classList.toggle("light", !dark); };
paint(night.matches);
night.addEventListener("change", () => paint(night.matches));
$("theme").addEventListener("click", () => paint(!root.classList.contains("dark")));
addEventListener("hashchange", fromHash);

/** The list holds only what is in sight; on paper there is no sight. */
addEventListener("beforeprint", () => {
  const lines = shown.slice(0, 1000).map((i) => el("tr", {}, el("td", {}, el("code", {}, data.cases[i].id)),
    el("td", {}, data.cases[i].title),
    el("td", {}, data.peers.filter((each) => each.status[i] === "f").map((each) => each.name).join(", "))));
  const more = shown.length > 1000 ? el("p", {}, `and ${plural(shown.length - 1000, "more case")}`) : "";
  $("cases").append(el("div", { id: "printed" }, el("table", {}, el("thead", {}, el("tr", {},
    ["case", "", "fails"].map((head) => el("th", {}, head)))), el("tbody", {}, lines)), more));
});
addEventListener("afterprint", () => $("printed")?.remove());
