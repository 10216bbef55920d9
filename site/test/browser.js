import assert from "node:assert/strict";
import { createServer } from "node:http";
import { once } from "node:events";
import { readFile } from "node:fs/promises";
import { extname, join } from "node:path";
import { after, before, describe, test } from "node:test";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";
import { filesOf } from "../lib/links.js";

const WIDE = { width: 1440, height: 900 };
const NARROW = { width: 390, height: 844 };
const TYPES = {
  ".html": "text/html",
  ".css": "text/css",
  ".js": "text/javascript",
  ".svg": "image/svg+xml",
  ".txt": "text/plain",
};

export function inBrowser(site) {
  let browser;
  let server;
  const roots = { file: `${pathToFileURL(site)}/` };

  before(async () => {
    browser = await chromium.launch({
      executablePath: process.env.NCP_CHROMIUM ?? "/usr/bin/chromium",
      args: ["--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking"],
    });
    // Below a folder, as many hosts serve sites.
    server = createServer(async ({ url }, response) => {
      const path = decodeURIComponent(new URL(url, "http://localhost").pathname).replace(/^\/ncp\//, "");
      const body = await readFile(join(site, path)).catch(() => undefined);
      response.writeHead(body ? 200 : 404, { "content-type": TYPES[extname(path)] ?? "application/octet-stream" });
      response.end(body);
    }).listen(0, "127.0.0.1");
    await once(server, "listening");
    roots.server = `http://127.0.0.1:${server.address().port}/ncp/`;
  });
  after(async () => {
    await browser?.close();
    server?.close();
  });

  /** Pages of the site, from one on; whatever goes wrong in them, or is asked of elsewhere, fails the test. */
  async function visit(path, work, { at = "file", ...options } = {}) {
    const context = await browser.newContext({ viewport: WIDE, ...options });
    const page = await context.newPage();
    const wrong = [];
    page.on("pageerror", (error) => wrong.push(String(error)));
    page.on("console", (message) => ["error", "warning"].includes(message.type()) && wrong.push(message.text()));
    // What a way to the next page cuts off has not failed.
    page.on(
      "requestfailed",
      (request) => /ABORTED/.test(request.failure().errorText) || wrong.push(`${request.url()} failed`),
    );
    page.on(
      "response",
      (response) => response.status() >= 400 && wrong.push(`${response.url()}: ${response.status()}`),
    );
    page.on("request", (request) => request.url().startsWith(roots[at]) || wrong.push(`${request.url()} is asked for`));
    try {
      await page.goto(roots[at] + path);
      await work(page);
      assert.deepEqual(wrong, [], path);
    } finally {
      await context.close();
    }
  }

  for (const at of ["file", "server"]) {
    for (const viewport of [WIDE, NARROW]) {
      describe(`from a ${at}, ${viewport.width} pixels wide`, () => {
        test("a reader comes from the first page to a rule, its case and its code", async () => {
          await visit(
            "index.html",
            async (page) => {
              await page.getByRole("link", { name: "Safety", exact: true }).click();
              await page.locator("#NCP-SAFE-045").getByRole("link", { name: "Evidence" }).click();
              await page.waitForURL(/rules\/NCP-SAFE-045\.html$/);
              assert.equal(await page.textContent("h1"), "NCP-SAFE-045");
              await page
                .locator("details.group", { hasText: "safety/fence" })
                .locator("summary")
                .click({ position: { x: 4, y: 8 } });
              await page.getByRole("link", { name: "on/3-4-0/octant-0", exact: true }).click();
              const opened = page.locator("details.case[open]");
              await opened.first().waitFor();
              assert.equal(await opened.count(), 1);
              assert.match(await opened.textContent(), /governor\.run.*"geofence_radius_m": 5\.0/s);
              await opened.getByRole("link", { name: "NCP-SAFE-045" }).click();
              await page.getByRole("link", { name: "inside", exact: true }).click();
              await page.waitForURL(/source\/spec\/kernel\/src\/decisions\/fence\.rs\.html#L\d+$/);
              assert.match(await page.textContent(":target"), /fn inside/);
            },
            { at, viewport },
          );
        });

        test("the search finds a rule, a case, a finding and a section, and the keyboard leads there", async () => {
          await visit(
            "docs/verifier/README.html",
            async (page) => {
              for (const [words, wanted, address] of [
                ["ncp-safe-045", "NCP-SAFE-045", /rules\/NCP-SAFE-045\.html$/],
                [
                  "safety/fence/on/3-4-0/octant-0",
                  "safety/fence/on/3-4-0/octant-0",
                  /corpus\/safety\/fence\.html#safety\/fence\/on\/3-4-0\/octant-0$/,
                ],
                ["missing counts as the origin", "L03", /findings\.html#L03$/],
                [
                  "order gates",
                  "7.3 The order of the gates (7. Safety)",
                  /text\/07-safety\.html#73-the-order-of-the-gates$/,
                ],
              ]) {
                await page.keyboard.press("/");
                await page.keyboard.type(words);
                const first = page.locator("#found li").first().locator(".title");
                await first.filter({ hasText: wanted }).waitFor();
                await page.keyboard.press("ArrowDown");
                await page.keyboard.press("ArrowUp");
                await page.keyboard.press("Enter");
                await page.waitForURL(address);
              }
              await page.keyboard.press("/");
              await page.keyboard.type("qzxv wvxq zzyyxx");
              await page.getByText("Nothing was found.").waitFor();
              await page.keyboard.press("Escape");
              assert.equal(await page.locator("dialog[open]").count(), 0);
            },
            { at, viewport },
          );
        });
      });
    }
  }

  test("no page is wider than 390 pixels, and none has an error", async () => {
    const some = { "rules/": 12, "source/": 12, "corpus/": 6, "deep/": 5, "defects/": 4 };
    const pages = filesOf(site).filter((file) => file.endsWith(".html"));
    const chosen = pages.filter((file, nth) => {
      const every = Object.entries(some).find(([folder]) => file.startsWith(folder))?.[1] ?? 1;
      return nth % every === 0 || file.endsWith("index.html");
    });
    assert.ok(chosen.length > 150, `${chosen.length} pages`);
    await visit(
      "index.html",
      async (page) => {
        for (const file of chosen) {
          await page.goto(roots.file + file);
          const beyond = await page.evaluate(() => {
            document.querySelectorAll("details").forEach((one, nth) => (one.open = nth < 20));
            return document.documentElement.scrollWidth - document.documentElement.clientWidth;
          });
          assert.equal(beyond, 0, file);
        }
      },
      { viewport: NARROW },
    );
  });

  test("a filter leaves what has all its words, and an address opens what a filter would hide", async () => {
    await visit("corpus/wire/numbers.html", async (page) => {
      const shown = page.locator("details.case:visible");
      const all = await shown.count();
      await page.getByRole("searchbox", { name: "Only cases with" }).fill("ncp-wire-013 overflow");
      await page.locator("output", { hasText: `of ${all}` }).waitFor();
      const left = await shown.allTextContents();
      assert.ok(left.length > 0 && left.length < all, `${left.length} of ${all}`);
      for (const text of left) assert.match(text, /NCP-WIRE-013/);
      const hidden = await page.locator("details.case[hidden]").first().getAttribute("id");
      await page.evaluate((id) => (location.hash = id), hidden);
      await page.locator(`[id="${hidden}"][open]:visible`).waitFor();
    });
  });

  test("what an address names stands free of the bars above it", async () => {
    for (const [path, id] of [
      ["findings.html", "L04"],
      ["corpus/index.html", "safety"],
      ["text/07-safety.html", "NCP-SAFE-045"],
    ]) {
      await visit(`${path}#${id}`, async (page) => {
        const seen = await page.evaluate((id) => {
          const { left, top } = document.getElementById(id).getBoundingClientRect();
          return document.getElementById(id).contains(document.elementFromPoint(left + 8, top + 8));
        }, id);
        assert.ok(seen, `${path}#${id}`);
      });
    }
  });

  test("all of it can be reached by the keyboard, and focus is seen", async () => {
    await visit("rules/index.html", async (page) => {
      const focused = () => page.evaluate(() => document.activeElement.textContent.trim());
      await page.keyboard.press("Tab");
      assert.equal(await focused(), "To the content");
      const outline = await page.evaluate(() => getComputedStyle(document.activeElement).outlineStyle);
      assert.equal(outline, "solid");
      await page.keyboard.press("Enter");
      assert.equal(await page.evaluate(() => document.activeElement.id), "main");
      await page.keyboard.press("Tab");
      assert.equal(await page.evaluate(() => document.activeElement.id), "filter");
      await page.keyboard.type("NCP-CODEC-005");
      await page.locator("output", { hasText: /^1 of/ }).waitFor();
      await page.keyboard.press("Tab");
      assert.equal(await focused(), "NCP-CODEC-005");
      await page.keyboard.press("Enter");
      await page.waitForURL(/rules\/NCP-CODEC-005\.html$/);
    });
  });

  test("the colours are those of the system until a reader chooses others, which stay", async () => {
    const ground = (page) => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    for (const [colorScheme, own] of [
      ["light", "rgb(255, 255, 255)"],
      ["dark", "rgb(20, 23, 27)"],
    ]) {
      await visit(
        "index.html",
        async (page) => {
          assert.equal(await ground(page), own);
          const button = page.getByRole("button", { name: "Colours" });
          await button.focus();
          await page.keyboard.press("Enter");
          await page.getByRole("button", { name: "Colours: light" }).press("Enter");
          assert.equal(await ground(page), "rgb(20, 23, 27)");
          await page.getByRole("link", { name: "Rules", exact: true }).first().click();
          await page.waitForURL(/rules\/index\.html$/);
          assert.equal(await ground(page), "rgb(20, 23, 27)");
          await page.getByRole("button", { name: "Colours: dark" }).press("Enter");
          await page.getByRole("button", { name: "Colours: as the system" }).waitFor();
          assert.equal(await ground(page), own);
        },
        { at: "server", colorScheme },
      );
    }
  });

  test("every text stands out from its ground by 4.5 to 1", async () => {
    for (const colorScheme of ["light", "dark"]) {
      for (const path of [
        "text/07-safety.html",
        "text/12-security.html#NCP-STRICT-001",
        "findings.html#L04",
        "corpus/codec/encode.html",
        "live.html",
      ]) {
        await visit(path, async (page) => assert.deepEqual(await page.evaluate(faint), []), { colorScheme });
      }
    }
  });

  test("a page on paper is its text alone", async () => {
    await visit("text/07-safety.html", async (page) => {
      await page.emulateMedia({ media: "print" });
      assert.equal(await page.locator(".top:visible, .aside:visible, footer:visible").count(), 0);
      assert.ok(await page.locator("#NCP-SAFE-045").isVisible());
      assert.ok((await page.pdf({ format: "A4" })).length > 50_000);
    });
  });

  test("without scripts, text, links and cases are all there", async () => {
    await visit(
      "corpus/codec/encode.html",
      async (page) => {
        assert.equal(await page.getByRole("button").count(), 0);
        const first = page.locator("details.case").first();
        await first.locator("summary").click();
        assert.ok(await first.getByText("Expectation").isVisible());
        await first.locator("a.ref").first().click();
        await page.waitForURL(/rules/);
        assert.match(await page.textContent("h1"), /^NCP-CODEC-/);
      },
      { javaScriptEnabled: false },
    );
  });
}

/** In a page: what is written in a colour too near to that of its ground. */
function faint() {
  const numbers = (colour) => colour.match(/[\d.]+/g).map(Number);
  const light = ([red, green, blue]) => {
    const [r, g, b] = [red, green, blue].map((part) =>
      (part /= 255) <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4,
    );
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const ground = (element) => {
    const colour = numbers(getComputedStyle(element).backgroundColor);
    return colour[3] === 0 && element.parentElement ? ground(element.parentElement) : colour;
  };
  const found = new Set();
  for (const element of document.querySelectorAll("body *")) {
    const hasText = [...element.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.data.trim() !== "");
    if (!hasText || !element.checkVisibility({ opacityProperty: true })) continue;
    const [one, other] = [light(numbers(getComputedStyle(element).color)), light(ground(element))].sort(
      (a, b) => b - a,
    );
    const contrast = (one + 0.05) / (other + 0.05);
    if (contrast < 4.5) found.add(`${element.tagName}.${element.className}: ${contrast.toFixed(2)}`);
  }
  return [...found];
}
