/** Claims about any page of `flexair view`. */
import assert from "node:assert/strict";
import { open, pixels, state } from "./browser.mjs";

const showsOf = (page) => page.evaluate(() => JSON.parse(document.getElementById("scene").textContent).shows);

/** Draws every show, shows another picture at another moment and the same at the same, and says nothing on the console. */
export async function assertDraws(browser, address) {
  const { page, messages } = await open(browser, `${address}#paused`);
  const shows = await showsOf(page);
  for (const { name } of shows) {
    await page.evaluate((one) => flexair.setShow(one), name);
    assert.equal((await state(page)).show, name);
    await page.evaluate(() => flexair.renderOnce());
  }
  const moving = shows.find((show) => show.count > 1);
  const at = async (share) => {
    await page.evaluate(([name, time]) => (flexair.setShow(name), flexair.seek(time)), [
      moving.name,
      moving.start + share * (moving.count - 1) * moving.step,
    ]);
    return pixels(page);
  };
  const first = await at(0.21);
  assert.ok(first.colours > 60, `only ${first.colours} colours are drawn`);
  assert.notEqual((await at(0.47)).hash, first.hash, "two moments look the same");
  assert.deepEqual(await at(0.21), first, "the same moment looks different");
  assert.ok(await differsFromBackground(page), "the aircraft is not seen before its background");
  assert.equal(await page.locator("#still").isVisible(), false);
  assert.deepEqual(messages, []);
  await page.close();
}

/** Plays; changes camera, colour and deformation; fits on a phone. */
export async function assertHandles(browser, address) {
  const { page, messages } = await open(browser, `${address}#paused`);
  const show = (await showsOf(page))[0];
  const looks = new Set();
  for (const camera of ["chase", "wing tip", "side", "top"]) {
    await page.evaluate((one) => flexair.setCamera(one), camera);
    assert.equal((await state(page)).camera, camera);
    looks.add((await pixels(page)).hash);
  }
  assert.equal(looks.size, 4, "cameras look alike");
  const plain = await pixels(page);
  for (const { name } of show.colours) {
    await page.evaluate((one) => flexair.setColour(one), name);
    assert.equal((await state(page)).colour, name);
    assert.ok(await page.locator("#legend").isVisible());
    assert.notEqual((await pixels(page)).hash, plain.hash, `${name} does not colour`);
  }
  await page.evaluate(() => (flexair.setColour(null), flexair.setDeformation(20), flexair.renderOnce()));
  assert.equal((await state(page)).deformation, 20);
  if (show.count > 1) await assertPlays(page);
  await page.setViewportSize({ width: 400, height: 800 });
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 400, "the page is wider than the phone");
  assert.ok((await pixels(page)).colours > 60);
  assert.deepEqual(messages, []);
  await page.close();
}

async function assertPlays(page) {
  await page.evaluate(() => flexair.play());
  const from = (await state(page)).time;
  await page.waitForFunction((time) => flexair.state().time !== time, from);
  await page.evaluate(() => flexair.pause());
  assert.equal((await state(page)).playing, false);
}

/** Whether the middle of the picture seen from above has other colours than its corners, where nothing but ground is. */
async function differsFromBackground(page) {
  await page.evaluate(() => flexair.setCamera("top"));
  const { columns } = await pixels(page);
  return columns.middle > columns.edge;
}
