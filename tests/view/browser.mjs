/** Chromium for the tests of the page of `flexair view`, and what they ask of a page. */
import { execFileSync } from "node:child_process";
import { mkdtempSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const web = resolve(import.meta.dirname, "../../web");
/** A name that would be markup where it is not taken as text. */
export const ODD = "</script><img src=x onerror=console.error('broken-out')>";
const SOFTWARE = ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];

/** Chromium of the environment, or the first on the path. */
function findChromium() {
  if (process.env.CHROMIUM) return process.env.CHROMIUM;
  for (const name of ["chromium", "chromium-browser", "google-chrome"]) {
    try {
      return execFileSync("which", [name], { encoding: "utf8" }).trim();
    } catch {
      continue;
    }
  }
  return undefined;
}

function findDriver() {
  try {
    return createRequire(join(web, "package.json"))("playwright-core").chromium;
  } catch {
    return undefined;
  }
}

const chromium = findChromium();
const driver = findDriver();

/** Whether what is slow and rarely breaks is tested too. */
export const slow = Boolean(process.env.SLOW);

/** Why the tests cannot run, if they cannot. */
export const missing =
  (!chromium && "no Chromium: name one in CHROMIUM, or apt-get install chromium") ||
  (!driver && "no playwright-core: run `npm ci` in web/") ||
  undefined;

export function launch(args = SOFTWARE) {
  return driver.launch({ executablePath: chromium, args: ["--no-sandbox", ...args] });
}

/** Writes the made-up sample, and gives its address. */
export async function sample() {
  const { writeSample } = await import(pathToFileURL(join(web, "test/sample.mjs")));
  const file = join(mkdtempSync(join(tmpdir(), "flexair-view-")), "sample.html");
  await writeSample(file);
  return pathToFileURL(file).href;
}

/** All that the console of a page says, as it says it. */
export function listen(page) {
  const messages = [];
  page.on("console", (message) => messages.push(`${message.type()}: ${message.text()}`));
  page.on("pageerror", (error) => messages.push(String(error)));
  return messages;
}

/** Opens an address; `messages` gathers all that the console says. */
export async function open(browser, address, options = {}) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 720 }, ...options });
  // Generous, for machines that are busy with other work.
  page.setDefaultTimeout(120_000);
  const messages = listen(page);
  await page.goto(address);
  if (options.javaScriptEnabled !== false) await page.evaluate(() => flexair.ready.catch(() => undefined));
  return { page, messages };
}

/** What is drawn: a hash of all pixels, how many colours there are, and how many in the column in the middle and at the edge. */
export function pixels(page) {
  return page.evaluate(async () => {
    // What was chosen just now may have changed the size of the canvas.
    for (let frame = 0; frame < 2; frame++) await new Promise(requestAnimationFrame);
    const drawn = document.querySelector("#stage canvas");
    const copy = Object.assign(document.createElement("canvas"), { width: drawn.width, height: drawn.height });
    const context = copy.getContext("2d");
    flexair.renderOnce();
    context.drawImage(drawn, 0, 0);
    const { width, height } = copy;
    const data = new Uint32Array(context.getImageData(0, 0, width, height).data.buffer);
    let hash = 2166136261;
    for (const pixel of data) hash = Math.imul(hash ^ pixel, 16777619);
    const coloursOf = (column) => new Set(data.filter((_, i) => i % width === column)).size;
    return { hash, colours: new Set(data).size, columns: { middle: coloursOf(width >> 1), edge: coloursOf(1) } };
  });
}

export const state = (page) => page.evaluate(() => flexair.state());
