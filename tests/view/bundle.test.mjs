/** The bundle that is committed is the one that its sources make. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { test } from "node:test";

const web = resolve(import.meta.dirname, "../../web");
const npm = (...args) => execFileSync("npm", ["run", "--silent", ...args], { cwd: web, stdio: ["ignore", "ignore", "inherit"] });

test("web/dist/view.html is what `npm run build` writes, byte for byte", () => {
  const built = join(mkdtempSync(join(tmpdir(), "flexair-view-")), "view.html");
  npm("build", "--", built);
  const isSame = readFileSync(built).equals(readFileSync(join(web, "dist/view.html")));
  assert.ok(isSame, "it is another: run `npm run build` in web/ and commit what it writes");
});

test("types are right: `npm run check`", () => npm("check"));
