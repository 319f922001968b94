/**
 * A picture of each aircraft of the fleet in its trim, docs/fleet/*.webp, from pages of `flexair view`:
 *
 *     npm ci && npm run fleet                      # all, or those named: npm run fleet -- sailplane
 *
 * Needs Chromium as the tests in tests/view do, and the command: FLEXAIR, or target/release/flexair. The same command, Chromium, fonts and
 * processor make the same bytes.
 */
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import sharp from "sharp";
import { launch, missing, open } from "../tests/view/browser.mjs";
import { drag, style } from "./scene-alone.mjs";

const root = resolve(import.meta.dirname, "..");
const flexair = resolve(process.env.FLEXAIR ?? join(root, "target/release/flexair"));

/** CSS pixels, so few that texts can be read where the picture is 400 wide; and pixels of the picture for each. */
const SIZE = { width: 450, height: 270 };
const RATIO = 2;
const QUALITY = 80;
/** The most that a picture may weigh, bytes. */
const MOST = 60_000;

/** `turn`: how far the mouse drags the chase view, pixels; `wheel`: how far it is rolled there, away from the aircraft where it is positive. */
const views = [
  { name: "light-single", turn: [-15, 15], wheel: -380 },
  { name: "sailplane", turn: [-25, 25], wheel: -420 },
  { name: "v-tail-uav", turn: [-40, 12], wheel: -420 },
  { name: "flying-wing", turn: [-5, 30], wheel: -300 },
  { name: "t-tail", turn: [-42, 8], wheel: -360 },
  { name: "twin-boom", turn: [-20, 30], wheel: -340 },
  { name: "high-altitude", turn: [-5, -8], wheel: -380 },
  { name: "strut-braced", turn: [-20, 4], wheel: -420 },
];

async function make(browser, { name, turn, wheel }, folder) {
  const html = join(folder, `${name}.html`);
  const aircraft = join(root, "aircraft", `${name}.toml`);
  execFileSync(flexair, ["view", aircraft, "--modes", "20", "--trim", "--output", html], { stdio: ["ignore", "ignore", "inherit"] });
  const options = { viewport: SIZE, deviceScaleFactor: RATIO, colorScheme: "light" };
  const { page } = await open(browser, `${pathToFileURL(html).href}#paused,quality=high`, options);
  await page.addStyleTag({ content: style("") });
  await drag(page, SIZE, turn);
  await page.mouse.wheel(0, wheel);
  await page.evaluate(() => new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn))));
  const picture = await page.screenshot();
  await page.close();
  const file = join(root, "docs/fleet", `${name}.webp`);
  const { size } = await sharp(picture).webp({ quality: QUALITY, effort: 6 }).toFile(file);
  console.log(`${file}: ${size} bytes`);
  if (size > MOST) throw new Error(`${file} is larger than ${MOST} bytes`);
}

if (missing) throw new Error(missing);
const asked = process.argv.slice(2);
const unknown = asked.find((name) => !views.some((view) => view.name === name));
if (unknown) throw new Error(`no aircraft ${unknown}; there are ${views.map((view) => view.name).join(", ")}`);
const folder = mkdtempSync(join(tmpdir(), "flexair-fleet-"));
const browser = await launch();
try {
  for (const view of views) if (asked.length === 0 || asked.includes(view.name)) await make(browser, view, folder);
} finally {
  await browser.close();
  rmSync(folder, { recursive: true });
}
