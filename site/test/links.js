import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { wrongLinks } from "../lib/links.js";
import { temporary } from "./made.js";

/** What a page of that body is told about its links. */
function wrong(body) {
  const folder = temporary();
  writeFileSync(join(folder, "page.html"), `<!doctype html><h1 id="top">Page</h1>${body}`);
  writeFileSync(join(folder, "other.html"), '<p id="a/b">Other</p>');
  return wrongLinks(folder);
}

test("a link that leads nowhere is named, and so is what comes from elsewhere", () => {
  assert.deepEqual(wrong('<a href="other.html#a/b">x</a><a href="#top">x</a><a href="https://example.org">x</a>'), []);
  for (const [body, expected] of [
    ['<a href="gone.html">x</a>', "page.html: gone.html leads to no file"],
    ['<a href="other.html#c">x</a>', "page.html: other.html#c leads to no element"],
    ['<a href="#bottom">x</a>', "page.html: #bottom leads to no element"],
    ['<a href="/other.html">x</a>', "page.html: /other.html is no relative link"],
    ['<a href="../page.html">x</a>', "page.html: ../page.html leads out of the site"],
    [
      '<script src="https://example.org/x.js"></script>',
      "page.html: https://example.org/x.js is fetched from elsewhere",
    ],
    ['<link rel="stylesheet" href="//example.org/x.css">', "page.html: //example.org/x.css is fetched from elsewhere"],
    ['<p id="top"></p>', "page.html: two elements have the id top"],
  ]) {
    assert.deepEqual(wrong(body), [expected]);
  }
});

export function ofLinks(site) {
  test("every link of the site leads to a page of it, and every fragment to an element", () => {
    assert.deepEqual(wrongLinks(site), []);
  });
}
