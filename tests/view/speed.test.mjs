/**
 * How fast the page of `flexair view` is. Bounds are those that a busy machine keeps, three times the work and fewer than half the
 * frames of what is wanted; `npm run measure` in web/ says what it is.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { launch, missing, sample, slow } from "./browser.mjs";
import { bareRate, played } from "./measure.mjs";

/** ms */
const WORK = 12;
const FIRST_PICTURE = 6000;
const RATE = 8;

if (missing) console.error(`\n*** SKIPPED: the test of the speed of the page of flexair view: ${missing} ***\n`);

const skip = missing ?? (slow ? undefined : "SLOW=1 runs it");
test("a frame is little work, and frames come often enough", { skip, timeout: 300_000 }, async (context) => {
  const browser = await launch();
  const bare = await bareRate(browser, 3);
  const { work, rate, quality, firstPicture } = await played(browser, await sample(), 11);
  await browser.close();
  context.diagnostic(`first picture after ${firstPicture.toFixed(0)} ms`);
  context.diagnostic(`work a frame ${work.median.toFixed(2)} ms, median over ${work.frames} frames`);
  context.diagnostic(`${rate.toFixed(1)} frames a second, ${JSON.stringify(quality)}; ${bare.toFixed(1)} of a bare scene`);
  assert.ok(work.median < WORK, `${work.median} ms of work a frame, allowed are ${WORK}`);
  assert.ok(firstPicture < FIRST_PICTURE, `the first picture stands after ${firstPicture} ms, allowed are ${FIRST_PICTURE}`);
  // Where not even a bare scene comes to that many, there is nothing to see.
  const least = Math.min(RATE, bare / 2);
  assert.ok(rate > least, `${rate} frames a second, ${least} are wanted`);
});
