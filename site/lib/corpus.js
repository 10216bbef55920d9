/** The cases: of the golden corpus, and of the deep set. */

import { filesIn, read, toml } from "./tree.js";

/** More than this of an argument is left to the file. */
const SHOWN = 12_000;

/** The files of the golden corpus, each with its cases. */
export const corpus = () => filesIn("vectors/corpus", ".json").map(vectorFile);

/** The files of the deep set. */
export const deep = () => filesIn("vectors/deep", ".json").map(vectorFile);

/** The bug classes, by name. */
export const flags = () => toml("vectors/flags.toml");

/** The audited findings, by id. */
export const findings = () => toml("vectors/findings.toml");

function vectorFile(path) {
  const text = read(path);
  const { area, name, about, cases } = JSON.parse(text);
  const written = writtenMembers(text);
  if (written.length !== cases.length) {
    throw new Error(`${path} is not laid out as the generator does: ${written.length} of ${cases.length} cases found`);
  }
  return {
    path,
    area,
    name,
    about,
    id: `${area}/${name}`,
    cases: cases.map((one, index) => shownCase(one, written[index], path)),
  };
}

function shownCase(one, written, path) {
  const {
    id,
    title,
    requirements,
    flags,
    roles,
    needs = [],
    call,
    args,
    expect,
    by,
    rests_on: restsOn = [],
    why,
  } = one;
  // What is shown is what the file says, to the spelling of each number.
  for (const [member, value] of Object.entries({ args, expect })) {
    if (JSON.stringify(JSON.parse(written[member])) !== JSON.stringify(value)) {
      throw new Error(`${path}: ${id}: ${member} was cut out wrongly`);
    }
  }
  return {
    id,
    title,
    requirements,
    flags,
    roles,
    needs,
    call,
    restsOn,
    why,
    by: Object.entries(by ?? {}),
    args: shortened(written.args),
    expect: shortened(written.expect),
  };
}

/** A text with how much of it is left out. */
function shortened(text) {
  const shown = text.length <= SHOWN ? text : text.slice(0, SHOWN);
  return { text: shown, more: text.length - shown.length };
}

/** The members of each case as they are written: a case stands between braces of the second level. */
function writtenMembers(text) {
  const level = /^ */.exec(text.split("\n")[1])[0];
  const brace = level.repeat(2);
  const cases = [];
  let lines;
  for (const line of text.split("\n")) {
    if (line === `${brace}{`) {
      lines = [];
    } else if (line === `${brace}}` || line === `${brace}},`) {
      cases.push(membersOf(lines.join("\n")));
      lines = undefined;
    } else {
      lines?.push(line.slice(3 * level.length));
    }
  }
  return cases;
}

/** The members of an object as they are written, of which the braces are left out. */
function membersOf(inner) {
  const members = {};
  let [depth, from] = [0, 0];
  const until = (end) => {
    const [, name, value] = /^\s*"(\w+)": ([^]*)$/.exec(inner.slice(from, end));
    members[name] = value;
    from = end + 1;
  };
  for (const { 0: token, index } of inner.matchAll(/"(?:[^"\\]+|\\.)*"|[[\]{},]/g)) {
    if (token === "{" || token === "[") {
      depth += 1;
    } else if (token === "}" || token === "]") {
      depth -= 1;
    } else if (token === "," && depth === 0) {
      until(index);
    }
  }
  until(inner.length);
  return members;
}
