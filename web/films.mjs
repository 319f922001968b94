/**
 * The films of README.md, from frames of pages of `flexair view`:
 *
 *     npm ci && npm run films                      # all, or those named: npm run films -- wing-in-the-tunnel
 *
 * Needs Chromium as the tests in tests/view do, and the command: FLEXAIR, or target/release/flexair. The flights are computed anew; the
 * same command, Chromium, fonts and processor make the same bytes.
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

/** CSS pixels of a frame, so few that texts can be read where the film is 400 wide; and pixels of the film for each. */
const SIZE = { width: 480, height: 300 };
const RATIO = 2;
const FRAMES_PER_SECOND = 20;
const QUALITY = 82;
/** The most that a film may weigh, bytes. */
const MOST = 3e6;

/**
 * `says`: what stands in the picture. `from`, `to`: moments of the flight, s; the film has the first of them and not the last.
 * `speed`: seconds of flight a second of film. `pause`: how long the last frame stands, s. `turn`, `shift`: how far the mouse drags
 * the chase view, pixels; `wheel`: how far it is rolled there, away from the aircraft.
 */
const films = [
  {
    name: "jet-in-a-gust",
    view: ["--set", "gust.shape=one_minus_cosine", "--set", "gust.gradient=30", "--set", "gust.peak=15", "--duration", "3"],
    says: "Business jet in a 1 − cos gust\ndeformation × 4\n0.3 × real time",
    deformation: 4,
    from: 0.8,
    to: 2.3,
    speed: 0.3,
    pause: 0.8,
    turn: [38, 0],
    shift: [0, -22],
    wheel: -240,
  },
  {
    name: "wing-in-the-tunnel",
    view: ["aircraft/very-flexible-wing.toml", "--set", "airspeed=57", "--input", "wind_down=sine:-1.5@0:1", "--duration", "6"]
      .concat("--compare", "geometrically_exact,rigid"),
    says: "Very flexible wing at 57 m/s, wind up and down by 1.5 m/s\ntrue to scale, 0.5 × real time; violet: if it were rigid",
    from: 5,
    to: 6,
    speed: 0.5,
    pause: 0,
    turn: [50, 0],
    shift: [0, 52],
    wheel: 0,
  },
];

/** Opens a film's page and points the camera. */
async function stage(browser, address, film) {
  const options = { viewport: SIZE, deviceScaleFactor: RATIO, colorScheme: "light" };
  const { page } = await open(browser, `${address}#paused,quality=high`, options);
  await page.addStyleTag({ content: style(film.says) });
  await page.evaluate((deformation) => {
    flexair.setColour("bending");
    flexair.setDeformation(deformation);
  }, film.deformation ?? 1);
  await drag(page, SIZE, film.turn);
  await drag(page, SIZE, film.shift, "Shift");
  await page.mouse.wheel(0, film.wheel);
  return page;
}

/** Pictures of a page at the film's moments, PNG. */
async function take(page, { from, to, speed }) {
  const count = Math.round(((to - from) / speed) * FRAMES_PER_SECOND);
  const frames = [];
  for (let frame = 0; frame < count; frame++) {
    await page.evaluate((time) => {
      flexair.seek(time);
      // The frame after the one in which it is drawn.
      return new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn)));
    }, from + (frame / FRAMES_PER_SECOND) * speed);
    frames.push(await page.screenshot());
  }
  return frames;
}

async function make(browser, film, folder) {
  const html = join(folder, `${film.name}.html`);
  execFileSync(flexair, ["view", ...film.view, "--output", html], { cwd: root, stdio: ["ignore", "ignore", "inherit"] });
  const page = await stage(browser, pathToFileURL(html).href, film);
  const frames = await take(page, film);
  await page.close();
  const delay = frames.map(() => 1000 / FRAMES_PER_SECOND);
  delay[delay.length - 1] += 1000 * film.pause;
  const file = join(root, "docs", `${film.name}.webp`);
  const { size } = await sharp(frames, { join: { animated: true } }).webp({ quality: QUALITY, effort: 4, delay, loop: 0 }).toFile(file);
  console.log(`${file}: ${frames.length} frames, ${size} bytes`);
  if (size > MOST) throw new Error(`${file} is larger than ${MOST} bytes`);
}

if (missing) throw new Error(missing);
const asked = process.argv.slice(2);
const unknown = asked.find((name) => !films.some((film) => film.name === name));
if (unknown) throw new Error(`no film ${unknown}; there are ${films.map((film) => film.name).join(", ")}`);
const folder = mkdtempSync(join(tmpdir(), "flexair-films-"));
const browser = await launch();
try {
  for (const film of films) if (asked.length === 0 || asked.includes(film.name)) await make(browser, film, folder);
} finally {
  await browser.close();
  rmSync(folder, { recursive: true });
}
