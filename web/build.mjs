/**
 * Builds dist/view.html, or the file that is named, the template into which `flexair view` writes: page, style and script in one
 * file.
 */
import { build } from "esbuild";
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, resolve } from "node:path";

const target = resolve(process.argv[2] ?? `${import.meta.dirname}/dist/view.html`);
process.chdir(import.meta.dirname);

const MARKERS = { "{{title}}": 2, "{{plan}}": 1, "{{scene}}": 1, "{{data}}": 1 };

const bundle = async (entry, loader) => {
  const { outputFiles } = await build({
    entryPoints: [entry],
    bundle: true,
    minify: true,
    write: false,
    target: ["es2022", "chrome123", "firefox120", "safari17.5"],
    format: loader === "js" ? "iife" : undefined,
    // The licences stand in the page itself.
    legalComments: "none",
    charset: "utf8",
  });
  return outputFiles[0].text.trim();
};

const parts = {
  "<!--style-->": (await bundle("node_modules/uplot/dist/uPlot.min.css", "css")) + (await bundle("src/style.css", "css")),
  "<!--script-->": await bundle("src/main.ts", "js"),
  "<!--licence three-->": escape(await readFile("node_modules/three/LICENSE", "utf8")),
  "<!--licence uplot-->": escape(await readFile("node_modules/uplot/LICENSE", "utf8")),
};

function escape(text) {
  return text.trim().replaceAll("&", "&amp;").replaceAll("<", "&lt;");
}

const page = await readFile("src/page.html", "utf8");
const whole = page.replace(/<!--[a-z ]+-->/g, (place) => parts[place]);
for (const [marker, count] of Object.entries(MARKERS)) {
  const found = whole.split(marker).length - 1;
  if (found !== count) throw new Error(`${marker} stands ${found} times in the page, not ${count}`);
}
await mkdir(dirname(target), { recursive: true });
await writeFile(target, whole);
console.log(`${target}: ${(whole.length / 1000).toFixed(0)} kB`);
