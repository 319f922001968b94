/** The airframe of the sample: a jet with a swept wing, a tail, a fuselage, two pylons and two engines. */

const HALF_SPAN = 14;
const ROOT = 3.6;
const TIP = 1.2;
const SWEEP = Math.tan(0.45);

/** Adds a lifting surface from `from` to `to` of `count` strips. */
function surface(scene, { component, from, to, chords, count, thickness, flapFrom = 2, flapTo = -1, control, normal, axis }) {
  const between = (a, b, share) => a + (b - a) * share;
  for (let i = 0; i < count; i++) {
    const [a, b, middle] = [i / count, (i + 1) / count, (i + 0.5) / count];
    const at = [0, 1, 2].map((k) => between(from[k], to[k], middle));
    scene.sections.push(at);
    const end = (share, x) => {
      const chord = between(chords[0], chords[1], share);
      return [0, 1, 2].map((k) => between(from[k], to[k], share) - at[k] + (k === 0 ? chord * (0.35 - x) : 0));
    };
    const strip = {
      component, number: scene.strips.length + 1, section: scene.sections.length - 1,
      corners: [end(a, 0), end(b, 0), end(b, 1), end(a, 1)], normal, thickness,
    };
    if (middle > flapFrom && middle < flapTo) {
      strip.flap = { hinge: [end(a, 0.72), end(b, 0.72)], axis, controls: [control] };
    }
    scene.strips.push(strip);
  }
}

function fuselage(scene) {
  const rings = [];
  for (let i = 0; i <= 24; i++) {
    const x = 12 - i;
    const nose = Math.sqrt(Math.max(1 - Math.max((x - 8) / 4, 0) ** 2, 0));
    const tail = 1 - 0.85 * Math.max((-3 - x) / 9, 0) ** 1.4;
    scene.sections.push([x, 0, 0]);
    const radius = 1.35 * nose * tail;
    rings.push({ section: scene.sections.length - 1, offset: [0, 0, -0.5 * (1 - tail)], radius: [radius, radius * 1.05] });
  }
  scene.bodies.push({ component: "fuselage", rings });
  return rings;
}

export function airframe(odd) {
  const scene = {
    halfSpan: HALF_SPAN, size: 2 * HALF_SPAN, sections: [], strips: [], bodies: [], engines: [], stations: [], cuts: [],
    controls: [{ name: "elevator" }, { name: "aileron" }, { name: "rudder" }],
  };
  const up = [0, 0, -1];
  for (const side of [1, -1]) {
    const name = side > 0 ? "wing, right" : "wing, left";
    const wing = { chords: [ROOT, TIP], count: 34, thickness: 0.12, flapFrom: 0.65, flapTo: 0.93, normal: up };
    const axis = [0, 1, 0];
    surface(scene, { ...wing, component: name, from: [1.5, side * 0.9, 0.6], to: [1.5 - SWEEP * HALF_SPAN, side * HALF_SPAN, -0.2], control: { control: 1, gain: side }, axis });
  }
  for (const side of [1, -1]) {
    const tail = { chords: [1.9, 1], count: 10, thickness: 0.1, flapFrom: 0, flapTo: 1, normal: up };
    surface(scene, { ...tail, component: "tailplane", from: [-10.2, side * 0.1, -3.4], to: [-11.7, side * 4.4, -3.4], control: { control: 0, gain: 1 }, axis: [0, 1, 0] });
  }
  surface(scene, { component: "fin", from: [-8.6, 0, -0.9], to: [-10.4, 0, -3.6], chords: [3, 2], count: 12, thickness: 0.1, flapFrom: 0.1, flapTo: 0.95, control: { control: 2, gain: 1 }, normal: [0, 1, 0], axis: [0, 0, 1] });
  const rings = fuselage(scene);
  const at = rings[17].section;
  for (const side of [1, -1]) {
    scene.engines.push({ name: side > 0 ? "right" : "left", section: at, offset: [0, side * 2.2, -0.9], direction: [1, 0, 0], size: 3, thrustScale: 4e4 });
  }
  const pylon = [1.2, 0, -1.2].map((y) => ({ section: at, offset: [0, y * 1.4, -0.85], radius: [0.8, 0.12] }));
  scene.bodies.push({ component: "pylons", rings: pylon });
  scene.stations.push(
    { name: "tip.right", section: 33, offset: [0, 0, 0] },
    { name: "tip.left", section: 67, offset: [0, 0, 0] },
    { name: "engine.right", section: at, offset: [0, 2.2, -0.9] },
    { name: "nose", section: rings[0].section, offset: [0, 0, 0] },
    { name: "pilot", section: rings[3].section, offset: [0.1, -0.4, -0.5] },
    { name: odd, section: rings[24].section, offset: rings[24].offset },
  );
  scene.cuts.push({ name: "root", section: 2, offset: [0, 0, 0], normal: [0, 1, 0] }, { name: "mid", section: 16, offset: [0, 0, 0], normal: [0, 1, 0] });
  return scene;
}
