/**
 * The page of `flexair view` in headless Chromium with a made-up sample, for which no flight is computed: `npm test` in web/.
 */
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { inflateSync } from "node:zlib";
import { launch, listen, missing, ODD, open, pixels, sample, state } from "./browser.mjs";
import { assertDraws, assertHandles } from "./looks.mjs";

if (missing) console.error(`\n*** SKIPPED: tests of the page of flexair view: ${missing} ***\n`);

const address = missing ? "" : await sample();

describe("the page of flexair view", { skip: missing, timeout: 600_000 }, () => {
  let browser;
  before(async () => {
    browser = await launch();
  });
  after(() => browser.close());

  test("draws all, the same at the same moment, without a word on the console", () => assertDraws(browser, address));
  test("plays, changes camera, colour and deformation, fits on a phone", () => assertHandles(browser, address));

  test("scrubs, and goes where one clicks in a chart", async () => {
    const { page } = await open(browser, `${address}#paused`);
    await page.locator("#scrub").evaluate((scrub) => {
      scrub.valueAsNumber = 12.5;
      scrub.dispatchEvent(new Event("input"));
    });
    assert.equal((await state(page)).time, 12.5);
    const box = await page.locator(".u-over").first().boundingBox();
    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
    assert.ok(Math.abs((await state(page)).time - 30) < 0.5, "half way along the chart is 30 s");
    await page.close();
  });

  test("a click on a strip says what it is and what it carries", async () => {
    const { page } = await open(browser, `${address}#paused`);
    await page.evaluate(() => (flexair.setCamera("top"), flexair.renderOnce()));
    const box = await page.locator("#stage").boundingBox();
    await page.mouse.click(box.x + box.width * 0.62, box.y + box.height * 0.54);
    assert.match(await page.locator("#picked-name").innerText(), /^wing, right, strip \d+$/);
    assert.match(await page.locator("#picked-values").innerText(), /Lift of a metre of span\s+[\d\s.−\u202f]+N\/m/);
    await page.keyboard.press("Escape");
    assert.equal(await page.locator("#picked").isVisible(), false);
    await page.close();
  });

  test("works by keyboard", async () => {
    const { page } = await open(browser, `${address}#paused`);
    const press = async (key) => (await page.keyboard.press(key), state(page));
    assert.equal((await press("ArrowRight")).time, 0.02);
    assert.equal((await press("2")).camera, "wing tip");
    assert.equal((await press("c")).colour, "lift");
    assert.equal((await press("+")).deformation, 2);
    assert.equal((await press(".")).speed, 2);
    assert.equal((await press("d")).theme, "dark");
    assert.equal((await press(" ")).playing, true);
    assert.equal((await press(" ")).playing, false);
    assert.equal((await press("End")).time, 60);
    assert.equal((await press("PageDown")).show, "gust, rigid");
    await press("?");
    assert.ok(await page.locator("#card").isVisible());
    assert.match(await page.locator("#card").innerText(), /three\.js and uPlot/);
    await press("Escape");
    const { camera, colour, deformation, time } = await press("r");
    assert.deepEqual({ camera, colour, deformation, time }, { camera: "chase", colour: null, deformation: 1, time: 0 });
    await page.close();
  });

  test("is usable on a phone 400 px wide, by fingers", async () => {
    const phone = { viewport: { width: 400, height: 800 }, hasTouch: true, isMobile: true };
    const { page, messages } = await open(browser, `${address}#paused`, phone);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 400, "the page is wider than the phone");
    await page.locator("#play").tap();
    assert.equal((await state(page)).playing, true);
    await page.locator("#play").tap();
    const [stage, chart] = await Promise.all(["#stage", ".chart >> nth=0"].map((one) => page.locator(one).boundingBox()));
    assert.ok(chart.y > stage.y + stage.height, "charts are not below the scene");
    const dragged = await dragByFinger(page, stage);
    assert.equal(dragged.camera, "free");
    assert.deepEqual(messages, []);
    await page.close();
  });

  test("names stay text", async () => {
    const { page, messages } = await open(browser, `${address}#paused`);
    assert.equal(await page.locator("#title").innerText(), `Sample jet ${ODD}`);
    assert.ok((await page.locator("#charts").innerText()).includes(ODD));
    assert.equal(await page.locator("img").count(), 0);
    assert.equal(await page.title(), `Sample jet ${ODD}`);
    assert.deepEqual(messages, []);
    await page.close();
  });

  test("stations are drawn where the scene says, also between frames and with larger deformation", async () => {
    const { page } = await open(browser, `${address}#paused`);
    const { scene, data } = await contents(page);
    for (const [time, factor] of [[8.3, 1], [8.313, 1], [31, 1], [8.3, 7]]) {
      for (const station of scene.stations) {
        const drawn = await page.evaluate(([at, k, name]) => {
          flexair.seek(at);
          flexair.setDeformation(k);
          return flexair.stationPosition(name);
        }, [time, factor, station.name]);
        const expected = positionOf(scene, data, station, time, factor);
        drawn.forEach((value, i) => assert.ok(Math.abs(value - expected[i]) < 1e-8, `${station.name} at ${time} s`));
      }
    }
    await page.close();
  });

  test("a picture is saved, and a film where Chromium records one", async () => {
    const { page, messages } = await open(browser, `${address}#paused`);
    const [picture] = await Promise.all([page.waitForEvent("download"), page.keyboard.press("p")]);
    assert.match(picture.suggestedFilename(), /\.png$/);
    if (await page.locator("#film").isEnabled()) {
      await page.keyboard.press("v");
      await page.evaluate(() => flexair.play());
      await page.waitForTimeout(1000);
      const [film] = await Promise.all([page.waitForEvent("download"), page.keyboard.press("v")]);
      assert.match(film.suggestedFilename(), /\.webm$/);
    }
    assert.deepEqual(messages, []);
    await page.close();
  });

  test("where frames come slowly the page gives up antialiasing, then pixels, and draws on", async () => {
    const page = await browser.newPage();
    const messages = listen(page);
    await page.addInitScript(() => {
      window.requestAnimationFrame = (draw) => setTimeout(() => draw(performance.now()), 40);
    });
    const quality = () => page.evaluate(() => flexair.quality());
    await page.goto(`${address}#paused`);
    await page.evaluate(() => flexair.ready);
    assert.deepEqual(await quality(), { antialias: true, ratio: 1 });
    await page.evaluate(() => flexair.play());
    await page.waitForFunction(() => !flexair.quality().antialias);
    await page.waitForFunction(() => flexair.quality().ratio === 0.5);
    assert.ok((await pixels(page)).colours > 60);
    assert.deepEqual(messages, []);
    await page.close();
  });

  test("without scripts a sentence and the plan view stand there", async () => {
    const { page } = await open(browser, address, { javaScriptEnabled: false });
    await assertStill(page, /needs scripts and WebGL/);
    await page.close();
  });
});

test("without WebGL a sentence and the plan view stand there", { skip: missing, timeout: 120_000 }, async () => {
  const browser = await launch(["--disable-gpu", "--disable-3d-apis"]);
  const { page, messages } = await open(browser, address);
  await assertStill(page, /draws no WebGL/);
  assert.deepEqual(messages, []);
  await browser.close();
});

async function assertStill(page, sentence) {
  assert.match(await page.locator("#still").innerText(), sentence);
  assert.ok(await page.locator("#still h1").isVisible());
  assert.ok(await page.locator("#still svg").isVisible());
  assert.equal(await page.locator("#app").isVisible(), false);
}

async function dragByFinger(page, stage) {
  const finger = await page.context().newCDPSession(page);
  const at = (x, y) => [{ x: stage.x + x, y: stage.y + y }];
  await finger.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: at(200, 150) });
  await finger.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: at(230, 160) });
  await finger.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: at(260, 170) });
  await finger.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  return state(page);
}

async function contents(page) {
  const [scene, data] = await page.evaluate(() => ["scene", "data"].map((id) => document.getElementById(id).textContent));
  const bytes = inflateSync(Buffer.from(data, "base64"));
  return { scene: JSON.parse(scene), data: new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength) };
}

/** Where a station is, computed from the numbers of the page by another way than the page does. */
function positionOf(scene, data, station, time, factor) {
  const show = scene.shows[0];
  const frame = (time - show.start) / show.step;
  const pose = Array.from({ length: 7 }, (_, i) => valueOf(show.poses, data, frame, 7 * station.section + i));
  const body = Array.from({ length: 7 }, (_, i) => valueOf(show.body, data, frame, i));
  const jig = scene.sections[station.section];
  const offset = turned(pose.slice(3), station.offset, factor);
  const inBody = jig.map((rest, i) => rest + factor * (pose[i] - rest) + offset[i]);
  return turned(body.slice(3), inBody, 1).map((value, i) => body[i] + value);
}

function valueOf(matrix, data, frame, column) {
  const row = Math.floor(frame + 1e-9);
  const share = frame - row < 1e-6 ? 0 : frame - row;
  let value = data.getFloat32(matrix.mean + 4 * column, true);
  for (let r = 0; r < matrix.rank; r++) {
    const factors = [row, Math.min(row + 1, matrix.rows - 1)].map((at) => data.getInt16(matrix.coefficients + 2 * (at * matrix.rank + r), true));
    const coefficient = ((1 - share) * factors[0] + share * factors[1]) * matrix.coefficientScale[r];
    value += coefficient * data.getInt16(matrix.basis + 2 * (r * matrix.columns + column), true) * matrix.basisScale[r];
  }
  return value;
}

/** A vector turned by a quaternion, the angle of which is multiplied (Rodrigues). */
function turned(quaternion, vector, factor) {
  const size = Math.hypot(...quaternion);
  const [w, ...v] = quaternion.map((part) => part / size);
  const sine = Math.hypot(...v);
  if (sine === 0) return vector;
  const angle = factor * 2 * Math.atan2(sine, w);
  const axis = v.map((part) => part / sine);
  const dot = axis.reduce((sum, part, i) => sum + part * vector[i], 0);
  const cross = [0, 1, 2].map((i) => axis[(i + 1) % 3] * vector[(i + 2) % 3] - axis[(i + 2) % 3] * vector[(i + 1) % 3]);
  return vector.map((part, i) => part * Math.cos(angle) + cross[i] * Math.sin(angle) + axis[i] * dot * (1 - Math.cos(angle)));
}
