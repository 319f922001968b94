/**
 * Writes a page with a made-up aircraft, in the format of src/scene.ts, to try the page without the Rust command:
 *
 *     node test/sample.mjs target/sample.html
 *
 * A jet of 100 strips and 26 modes flies for 60 s through a gust; its motion is invented, not computed.
 */
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { pathToFileURL } from "node:url";
import { deflateSync } from "node:zlib";
import { airframe } from "./airframe.mjs";
import { Blocks } from "./blocks.mjs";

const ODD = "</script><img src=x onerror=console.error('broken-out')>";
const MODES = 26;
const RATE = 50;
const SECONDS = 60;
const SPEED = 130;
const HEIGHT = 3000;

/** Columns of poses of an undeformed aircraft. */
const restOf = (scene) => scene.sections.flatMap((at) => [...at, 1, 0, 0, 0]);

/** What a mode moves at each section, for a unit of its coordinate: 3 of position, 4 of the quaternion. */
function shapeOf(scene, mode) {
  const half = scene.halfSpan;
  return scene.sections.flatMap(([x, y]) => {
    const share = Math.min(Math.abs(y) / half, 1);
    const side = mode % 2 === 1 ? Math.sign(y) : 1;
    const waves = 1 + Math.floor(mode / 4);
    const isTwist = mode % 4 >= 2;
    const bend = side * share ** 2 * Math.cos((waves - 1) * Math.PI * share);
    const fuselage = y === 0 ? 0.15 * Math.cos((waves * Math.PI * x) / half) : 0;
    if (isTwist) return [0, 0, 0, 0, 0, 0.5 * side * share, 0];
    const slope = (side * 2 * share) / half;
    return [0, 0, -(bend + fuselage), 0, -0.5 * Math.sign(y) * slope, 0, 0];
  });
}

/** Velocity of the gust at a distance along the track, m/s: 1 − cos from 1000 m on, 180 m long. */
function gustAt(distance) {
  const share = (distance - 1000) / 180;
  return share > 0 && share < 1 ? 6 * (1 - Math.cos(2 * Math.PI * share)) : 0;
}

/** The made-up answer of a mode to the gust. */
function modeAt(mode, time, gain) {
  const frequency = 1.8 + 1.4 * mode;
  const size = (0.5 * gain) / (1 + mode) ** 1.5;
  const since = time - 1000 / SPEED;
  const ring = since > 0 ? Math.exp(-0.6 * since) * Math.sin(2 * Math.PI * frequency * since) : 0;
  const manoeuvre = 0.35 * Math.exp(-(((time - 30) / 4) ** 2));
  return size * (ring + manoeuvre + 0.15);
}

function quaternion(roll, pitch, yaw) {
  const [cr, sr, cp, sp, cy, sy] = [roll, pitch, yaw].flatMap((angle) => [Math.cos(angle / 2), Math.sin(angle / 2)]);
  return [
    cr * cp * cy + sr * sp * sy,
    sr * cp * cy - cr * sp * sy,
    cr * sp * cy + sr * cp * sy,
    cr * cp * sy - sr * sp * cy,
  ];
}

/** O and attitude over time: a pitching and a gentle turn to the right. */
function bodyAt(time) {
  const bank = 0.5 * Math.exp(-(((time - 42) / 8) ** 2));
  const yaw = 0.35 / (1 + Math.exp(-(time - 42) / 4));
  const pitch = 0.05 + 0.02 * Math.sin(0.5 * time) + 0.02 * Math.exp(-(((time - 30) / 3) ** 2));
  const north = SPEED * time;
  const east = yaw > 0.001 ? SPEED * 0.35 * 4 * Math.log1p(Math.exp((time - 42) / 4)) : 0;
  return [north, east, -HEIGHT - 20 * Math.sin(0.3 * time), ...quaternion(bank, pitch, yaw)];
}

function flight(scene, blocks, name, level, gain) {
  const times = Array.from({ length: SECONDS * RATE + 1 }, (_, i) => i / RATE);
  const modes = times.map((time) => Array.from({ length: MODES }, (_, mode) => modeAt(mode, time, gain)));
  const shapes = Array.from({ length: MODES }, (_, mode) => shapeOf(scene, mode));
  const elevator = times.map((time) => 0.12 * Math.exp(-(((time - 29) / 1.5) ** 2)) - 0.02);
  const aileron = times.map((time) => 0.2 * Math.exp(-(((time - 36) / 2) ** 2)) - 0.2 * Math.exp(-(((time - 47) / 2) ** 2)));
  const thrust = times.map((time) => 42e3 + 12e3 * Math.sin(0.2 * time));
  const lift = scene.strips.map((_, i) => 4e3 * Math.sqrt(1 - (((i % 34) / 34) ** 2)));
  const series = [
    ["acceleration.z", "m/s2", "Vertical acceleration"],
    ["alpha", "rad", "Angle of attack"],
    ["tip.deflection", "m", "Deflection of the wing tip"],
    ["load.root.bending", "N.m", "Root bending moment, right"],
    ["load.root.torsion", "N.m", ODD],
    ["speed", "m/s", "Airspeed"],
    ["altitude", "m", "Altitude"],
    ["roll", "rad", "Bank angle"],
    ["pitch", "rad", "Pitch angle"],
    ["surface.elevator", "rad", "Elevator"],
    ["surface.aileron", "rad", "Aileron"],
    ["thrust.left", "N", "Thrust, left"],
  ].map(([name, unit, label], i) => {
    const factor = [9.8, 0.05, 1, 3e5, 2e4, 3, 20, 0.4, 0.06, 0.2, 0.3, 8e3][i];
    const offset = [0, 0.05, 0, 4e5, 0, SPEED, HEIGHT, 0, 0.05, 0, 0, 42e3][i];
    const values = modes.map((row, k) => [offset + factor * row[i % 6] + 0.1 * factor * Math.sin(0.4 * times[k] + i)]);
    return { name, unit, label, values: blocks.dense(values) };
  });
  return {
    kind: "flight", name, level, facts: [["Speed", `${SPEED} m/s`], ["Level", level]],
    start: 0, step: 1 / RATE, count: times.length, loops: false,
    poses: blocks.lowRank(restOf(scene), shapes, modes),
    body: blocks.dense(times.map(bodyAt)),
    controls: blocks.dense(times.map((_, k) => [elevator[k], aileron[k], 0.05 * modes[k][1]])),
    thrust: blocks.dense(thrust.map((value) => [value, value])),
    colours: coloursOf(scene, blocks, times, modes, lift),
    charts: series,
    wind: { outputs: blocks.dense(times.map((time) => [0, 3, -gustAt(SPEED * time)])) },
  };
}

function coloursOf(scene, blocks, times, modes, lift) {
  const per = (shape) => times.map((_, k) => [modes[k][0], modes[k][2]].flatMap((q, i) => [q * (i === 0 ? 1 : 0.3)]));
  const strips = [lift.map((value) => value * 0.8), lift.map((_, i) => 1500 * Math.sin(i))];
  const bending = [scene.sections.map(([, y]) => -2e5 * (1 - Math.abs(y) / scene.halfSpan)), scene.sections.map(([x]) => 2e4 * x)];
  const twist = [scene.sections.map(([, y]) => 0.1 * (Math.abs(y) / scene.halfSpan)), scene.sections.map(([x]) => 0.01 * x)];
  return [
    { name: "lift", label: "Lift of a metre of span", unit: "N/m", on: "strips", min: 0, max: 6e3, values: blocks.lowRank(lift, strips, per()) },
    { name: "bending", label: "Bending moment", unit: "N.m", on: "sections", min: -8e4, max: 4e4, values: blocks.lowRank(scene.sections.map(() => 0), bending, per()) },
    { name: "twist", label: "Twist", unit: "rad", on: "sections", min: -0.03, max: 0.03, values: blocks.lowRank(scene.sections.map(() => 0), twist, per()) },
  ];
}

function mode(scene, blocks, number) {
  const frequency = 1.8 + 1.4 * number;
  const count = 49;
  const turns = Array.from({ length: count }, (_, i) => [1.2 * Math.sin((2 * Math.PI * i) / (count - 1))]);
  return {
    kind: "mode", name: `mode ${number + 1}: ${["wing bending", "wing bending, antisymmetric", "wing torsion", "wing torsion, antisymmetric"][number % 4]}`,
    level: "modal", facts: [["Frequency", `${frequency.toFixed(2)} Hz`], ["Damping", "2.0 %"], ["Family", "symmetric"], ["What moves", "wings, up to 1.20 m at the tips"]],
    start: 0, step: 1 / frequency / (count - 1), count, loops: true,
    poses: blocks.lowRank(restOf(scene), [shapeOf(scene, number)], turns),
    ...still(scene, blocks, count), colours: [], charts: [],
  };
}

function trim(scene, blocks) {
  return {
    kind: "trim", name: "trim", level: "geometrically exact", facts: [["Tip", "1.1 m upwards"]],
    start: 0, step: 0, count: 1, loops: false,
    poses: blocks.lowRank(restOf(scene), [shapeOf(scene, 0)], [[1.1]]),
    ...still(scene, blocks, 1), colours: [], charts: [],
  };
}

function still(scene, blocks, count) {
  const rows = (row) => blocks.dense(Array.from({ length: count }, () => row));
  return { body: rows([0, 0, -HEIGHT, ...quaternion(0, 0.05, 0)]), controls: rows([0, 0, 0]), thrust: rows([42e3, 42e3]) };
}

function sceneOf(blocks) {
  const scene = airframe(ODD);
  const gust = {
    along: [1, 0, 0], start: 950, end: 1230, direction: [0, 0, -1],
    profile: Array.from({ length: 141 }, (_, i) => gustAt(950 + 2 * i)), text: "1 − cos gust, 12 m/s, 180 m long",
  };
  const shows = [
    { ...flight(scene, blocks, "gust", "geometrically exact", 1), gust, ghost: "gust, rigid" },
    flight(scene, blocks, "gust, rigid", "rigid", 0),
    trim(scene, blocks),
    ...Array.from({ length: 8 }, (_, i) => mode(scene, blocks, i)),
  ];
  const { halfSpan, ...rest } = scene;
  return { format: 1, title: `Sample jet ${ODD}`, aircraft: `sample jet ${ODD}`, notes: [`A made-up aircraft; ${ODD}`], clamped: false, ...rest, shows };
}

/** The page with the sample, made from the template. */
export async function samplePage(template) {
  const blocks = new Blocks();
  const scene = sceneOf(blocks);
  const escaped = scene.title.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");
  const parts = {
    title: escaped,
    plan: planOf(scene),
    scene: JSON.stringify(scene).replaceAll("<", "\\u003c"),
    data: deflateSync(blocks.bytes(), { level: 9 }).toString("base64"),
  };
  return template.replace(/\{\{(title|plan|scene|data)\}\}/g, (_, name) => parts[name]);
}

function planOf(scene) {
  const outlines = scene.strips.map(({ section, corners }) => {
    const at = scene.sections[section];
    const points = corners.map((corner) => `${(at[1] + corner[1]).toFixed(2)},${(-at[0] - corner[0]).toFixed(2)}`);
    return `<polygon points="${points.join(" ")}"/>`;
  });
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="-16 -14 32 30" fill="#cdd8e2" stroke="#345" stroke-width="0.05">${outlines.join("")}</svg>`;
}

/** Writes the sample page to a file. */
export async function writeSample(file) {
  const template = await readFile(join(import.meta.dirname, "../dist/view.html"), "utf8");
  await mkdir(dirname(file), { recursive: true });
  await writeFile(file, await samplePage(template));
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href) {
  await writeSample(process.argv[2] ?? join(import.meta.dirname, "../target/sample.html"));
}
