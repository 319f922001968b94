/** Pages that `flexair view` writes, in headless Chromium: FLEXAIR names the command. */
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { launch, listen, missing, ODD, open } from "./browser.mjs";
import { FINER, fly, fmuPage, RATE, unflown } from "./flown.mjs";
import { assertDraws, assertHandles } from "./looks.mjs";

const skip = missing ?? unflown;
if (skip) console.error(`\n*** SKIPPED: tests of the pages that flexair view writes: ${skip} ***\n`);

/** How far stations may be drawn from where the library has them, m: at the poses of the page, and between them. */
const AT_POSES = 1e-3;
const BETWEEN = 5e-3;

describe("a page that flexair view writes", { skip, timeout: 600_000 }, () => {
  const pages = skip ? [] : fly();
  const named = (name) => pages.find((page) => page.name === name);
  let browser;
  before(async () => {
    browser = await launch();
  });
  after(() => browser.close());

  for (const { name, address, tables } of pages) {
    test(`${name}: draws all, the same at the same moment, without a word on the console`, () => assertDraws(browser, address));
    test(`${name}: plays, changes camera, colour and deformation, fits on a phone`, () => assertHandles(browser, address));
    for (const [level, rows] of Object.entries(tables ?? {})) {
      test(`${level}: stations are drawn where the library has them`, async (context) => {
        const { page } = await open(browser, `${address}#paused`);
        const { stored, between } = await distances(page, level, rows);
        context.diagnostic(`at stored poses ${(1e3 * stored).toFixed(3)} mm, between them ${(1e3 * between).toFixed(3)} mm`);
        assert.ok(stored < AT_POSES, `${stored} m at stored poses`);
        assert.ok(between < BETWEEN, `${between} m between poses`);
        await page.close();
      });
    }
  }

  test("a click on a body says what the strip across it carries", async () => {
    const { page } = await open(browser, `${pages[0].address}#paused`);
    await page.evaluate(() => (flexair.setCamera("top"), flexair.renderOnce()));
    const box = await page.locator("#stage").boundingBox();
    await page.mouse.click(box.x + 0.5 * box.width, box.y + 0.3 * box.height);
    assert.match(await page.locator("#picked-name").innerText(), /^fuselage_fore, strip \d+$/);
    await page.close();
  });

  test("names: stay text", async () => {
    const { page, messages } = await open(browser, `${named("names").address}#paused`);
    assert.equal(await page.locator("#title").innerText(), ODD);
    assert.equal(await page.title(), ODD);
    assert.equal(await page.locator("img").count(), 0);
    assert.deepEqual(messages, []);
    await page.close();
  });

  test("names: stay text in the FMU's documentation", async () => {
    const page = await browser.newPage();
    const messages = listen(page);
    await page.goto(fmuPage());
    const scene = page.frameLocator("iframe");
    await scene.locator("#title", { hasText: "onerror" }).waitFor();
    assert.equal(await scene.locator("#title").innerText(), ODD);
    assert.ok((await page.locator("h1").first().innerText()).includes(ODD));
    assert.equal((await page.locator("img").count()) + (await scene.locator("img").count()), 0);
    assert.deepEqual(messages, []);
    await page.close();
  });

  test("roots: the last moment stands for a while before it all begins again", async () => {
    const { page } = await open(browser, `${named("roots").address}#paused`);
    const end = await page.locator("#scrub").evaluate((scrub) => Number(scrub.max));
    await page.evaluate((time) => (flexair.seek(time), flexair.play()), 0.98 * end);
    await page.waitForFunction((time) => flexair.state().time === time, end);
    await page.locator("#factor", { hasText: "then again" }).waitFor();
    await page.waitForFunction((time) => flexair.state().time < time / 2, end);
    assert.equal(await page.evaluate(() => flexair.state().playing), true);
    await page.close();
  });
});

/** The largest distance between where stations are drawn and where they are, m. */
async function distances(page, level, rows) {
  const isBetween = ({ time }) => Math.abs(time * RATE - Math.round(time * RATE)) > 1e-6;
  // Rows at the edges of pulses may stand between those of the step.
  const onGrid = rows.filter(({ time }) => Math.abs(time * RATE * FINER - Math.round(time * RATE * FINER)) < 1e-6);
  const drawn = await page.evaluate(([show, times]) => {
    flexair.setShow(show);
    const stations = JSON.parse(document.getElementById("scene").textContent).stations.map(({ name }) => name);
    return times.map((time) => {
      flexair.seek(time);
      return stations.map((name) => ({ name, at: flexair.stationPosition(name) }));
    });
  }, [`flight, ${level}`, onGrid.map(({ time }) => time)]);
  const most = { stored: 0, between: 0 };
  onGrid.forEach((row, i) => {
    for (const { name, at } of drawn[i]) {
      const off = ["north", "east", "down"].map((axis, k) => at[k] - row[`station.${name}.position.${axis}`]);
      const kind = isBetween(row) ? "between" : "stored";
      most[kind] = Math.max(most[kind], Math.hypot(...off));
    }
  });
  return most;
}
