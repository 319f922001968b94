/** Pages that `flexair view` writes, tables of `flexair simulate` that say where stations are in the same flights, and an FMU's page. */
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { ODD, slow } from "./browser.mjs";

const root = resolve(import.meta.dirname, "../..");
const command = process.env.FLEXAIR && resolve(process.env.FLEXAIR);

/** Why there are no pages of the command, if there are none. */
export const unflown = command ? undefined : "FLEXAIR does not name the command flexair";

/** Poses a second, as `flexair view` has them by itself. */
export const RATE = 50;
/** Rows of a table for each pose. */
export const FINER = 4;
const MANOEUVRE = ["--input", "elevator=2311:-0.05@0.2:0.4", "--duration", "4"];
const PAIRS = [
  ["exact", "geometrically_exact"],
  ["inconsistent", "ruthlessly_linearised"],
  ["rigid", "consistently_linearised"],
];

const newFolder = () => mkdtempSync(join(tmpdir(), "flexair-view-"));
const runnerIn = (folder) => (...args) => execFileSync(command, args, { cwd: folder, stdio: ["ignore", "ignore", "inherit"] });

/** Flies all, without SLOW some: pages with their names and addresses, some with tables of their flights by level of fidelity. */
export function fly() {
  const folder = newFolder();
  const run = runnerIn(folder);
  const page = (name, ...args) => {
    const file = `${name}.html`;
    run("view", ...args, "--output", file);
    return { name, address: pathToFileURL(join(folder, file)).href };
  };
  const table = (level) => {
    const file = `${level}.csv`;
    run("simulate", ...MANOEUVRE, "--set", `model=${level}`, "--step", String(1 / (RATE * FINER)), "--output", file);
    return [level, read(join(folder, file))];
  };
  const { lopsided, odd, inputs } = writeFiles(folder);
  const wing = join(root, "aircraft/goland-wing.toml");
  const gust = ["--set", "gust.shape=one_minus_cosine", "--set", "gust.start=0.3"];
  const others = () => [
    page("clamped wing in a gust", wing, "--trim", "--mode-shapes", "--duration", "2", ...gust),
    page("aircraft without symmetry", lopsided, "--trim", "--input", "aileron=step:0.02", "--duration", "2"),
    page("40 modes in a gust", "--modes", "40", "--mode-shapes", "--duration", "2", ...gust),
  ];
  return [
    ...PAIRS.slice(0, slow ? PAIRS.length : 1).map((pair) => ({
      ...page(pair.join(" and "), ...MANOEUVRE, "--compare", pair.join(",")),
      tables: Object.fromEntries(pair.map(table)),
    })),
    ...(slow ? others() : []),
    page("roots", "--root", "phugoid", "--root", "elastic 1"),
    page("names", odd, "--flight", inputs, "--mode-shapes"),
  ];
}

/** The address of the documentation of an FMU whose aircraft has a name that would be markup. */
export function fmuPage() {
  const folder = newFolder();
  const { odd } = writeFiles(folder);
  runnerIn(folder)("package", "--no-check", "--aircraft", odd, "--output", "odd.fmu");
  execFileSync("python3", ["-m", "zipfile", "--extract", "odd.fmu", "odd"], { cwd: folder });
  return pathToFileURL(join(folder, "odd/documentation/index.html")).href;
}

/** A folder with files for game engines: of a flight at a linear and at the geometrically exact level, of other aircraft, with targets. */
export function writeGltf() {
  const folder = newFolder();
  const write = (name, option, ...args) => runnerIn(folder)("view", ...args, option, `${name}.glb`, "--output", `${name}.html`);
  const gust = ["--set", "gust.shape=one_minus_cosine", "--duration", "1"];
  const { lopsided } = writeFiles(folder);
  write("two levels in a gust", "--gltf", ...gust, "--compare", "exact,geometrically_exact");
  write("40 modes", "--gltf", "--modes", "40", "--mode-shapes");
  write("targets", "--gltf-morph", "--trim");
  write("without symmetry", "--gltf", lopsided, "--trim");
  write("clamped wing", "--gltf", join(root, "aircraft/goland-wing.toml"), "--mode-shapes");
  write("targets of a flying wing", "--gltf-morph", join(root, "tests/data/flying-wing.toml"), "--set", "model=exact", "--trim");
  return folder;
}

/** An aircraft with its engine on one wing; an aircraft and a flight whose names would be markup, as far as such names are allowed. */
function writeFiles(folder) {
  const small = readFileSync(join(root, "tests/data/small-aircraft.toml"), "utf8");
  const changed = (from, to) => {
    if (!small.includes(from)) throw new Error(`small-aircraft.toml has no ${from}`);
    return small.replace("symmetric = true", "symmetric = false").replace(from, to);
  };
  const engine = 'name = "only"\ncomponent = ';
  const lopsided = changed(`${engine}"fuselage"\nat_m = 0`, `${engine}"wing_left"\nat_m = 2`);
  // A slash would be another folder.
  const bare = ODD.replace("</script>", "");
  const files = { lopsided: "lopsided.toml", odd: `${bare}.toml`, inputs: `${bare}.csv` };
  writeFileSync(join(folder, files.lopsided), lopsided);
  writeFileSync(join(folder, files.odd), changed('name = "Small aircraft"', `name = "${ODD}"`));
  writeFileSync(join(folder, files.inputs), "time,elevator\n0,0\n0.1,-0.002\n0.5,0\n");
  return files;
}

/** A table of numbers: its rows, each by the names of the columns. */
function read(file) {
  const [head, ...lines] = readFileSync(file, "utf8").trim().split("\n").map((line) => line.split(","));
  return lines.map((line) => Object.fromEntries(head.map((name, i) => [name, Number(line[i])])));
}
