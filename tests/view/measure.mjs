/**
 * How fast the page of `flexair view` is where the processor draws: `npm run measure` in web/, with the address of a page, or
 * without one of the made-up sample with its 100 strips and 26 modes. What it prints depends on what else the machine does:
 * therefore it measures a bare scene beside the page, in turns.
 */
import { loadavg } from "node:os";
import { pathToFileURL } from "node:url";
import { launch, missing, open, sample } from "./browser.mjs";

const TURNS = 3;
const SIZE = { width: 1280, height: 720 };

/** A canvas as large as the window, with antialiasing, in which each frame draws one square over all of it. */
const BARE = `<!doctype html><title>bare</title><style>body { margin: 0 } canvas { display: block }</style>
<canvas width="${SIZE.width}" height="${SIZE.height}"></canvas>
<script>
const gl = document.querySelector("canvas").getContext("webgl2", { alpha: false, antialias: true });
const program = gl.createProgram();
const add = (kind, text) => {
  const shader = gl.createShader(kind);
  gl.shaderSource(shader, "#version 300 es\\nprecision highp float;" + text);
  gl.compileShader(shader);
  gl.attachShader(program, shader);
};
add(gl.VERTEX_SHADER, "out vec3 c; uniform float t; void main() { vec2 p = vec2(gl_VertexID & 1, gl_VertexID >> 1);" +
  " c = vec3(p, t); gl_Position = vec4(2.0 * p - 1.0, 0.0, 1.0); }");
add(gl.FRAGMENT_SHADER, "in vec3 c; out vec4 o; void main() { o = vec4(c, 1.0); }");
gl.linkProgram(program);
gl.useProgram(program);
const moment = gl.getUniformLocation(program, "t");
const times = [];
const draw = (now) => {
  times.push(now);
  gl.uniform1f(moment, 0.5 + 0.5 * Math.sin(now / 1000));
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
  requestAnimationFrame(draw);
};
requestAnimationFrame(draw);
</script>`;

/** Frames a second of the bare scene. */
export async function bareRate(browser, seconds) {
  const page = await browser.newPage({ viewport: SIZE });
  await page.setContent(BARE);
  await page.waitForTimeout(1000 * seconds);
  const rate = await page.evaluate(() => (1000 * (times.length - 11)) / (times.at(-1) - times[10]));
  await page.close();
  return rate;
}

/** The page as it plays, coloured: its work a frame, ms; frames a second; quality; when its first picture stood, ms. */
export async function played(browser, address, seconds, options = "") {
  const { page } = await open(browser, `${address}#paused${options}`);
  const colour = await page.evaluate(() => JSON.parse(document.getElementById("scene").textContent).shows[0].colours[0].name);
  const firstPicture = await page.evaluate(() => performance.getEntriesByName("first picture")[0].startTime);
  await page.evaluate((name) => (flexair.setColour(name), flexair.play()), colour);
  await page.waitForTimeout(1000 * seconds);
  const found = await page.evaluate(() => ({ work: flexair.frameWork(), rate: flexair.framesPerSecond(), quality: flexair.quality() }));
  await page.close();
  return { ...found, firstPicture };
}

const middle = (values) => values.toSorted((a, b) => a - b)[values.length >> 1];

async function print(address) {
  const browser = await launch();
  const found = [];
  for (let turn = 0; turn < TURNS; turn++) {
    const bare = await bareRate(browser, 5);
    const fine = await played(browser, address, 16, ",quality=high");
    const own = await played(browser, address, 12);
    found.push({ bare, fine, own });
  }
  await browser.close();
  const say = (label, value, decimals = 1) => console.log(`${label}: ${middle(found.map(value)).toFixed(decimals)}`);
  console.log(`medians of ${TURNS} turns; load of the machine ${loadavg()[0].toFixed(1)}`);
  say("work a frame, ms, median over up to 300 frames", ({ fine }) => fine.work.median, 2);
  say("first picture after, ms", ({ fine }) => fine.firstPicture, 0);
  say("frames a second, 1280 × 720, antialiased", ({ fine }) => fine.rate);
  say("frames a second of a bare scene, 1280 × 720, antialiased", ({ bare }) => bare);
  say("frames a second with the quality that the page chooses", ({ own }) => own.rate);
  const qualities = found.map(({ own: { quality } }) => `${quality.antialias ? "" : "not "}antialiased, ratio ${quality.ratio}`);
  console.log(`which is ${qualities.join("; ")}`);
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href) {
  if (missing) throw new Error(missing);
  await print(process.argv[2] ? pathToFileURL(process.argv[2]).href : await sample());
}
