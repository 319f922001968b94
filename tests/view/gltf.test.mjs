/**
 * Files of `flexair view --gltf` and `--gltf-morph` by the Khronos validator: those in the folder VIEW_GLTF, or else what the command
 * that FLEXAIR names writes. No errors and no warnings; hints are listed. After `npm ci` in web/.
 */
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { describe, test } from "node:test";
import { unflown, writeGltf } from "./flown.mjs";

function findValidator() {
  try {
    return createRequire(resolve(import.meta.dirname, "../../web/package.json"))("gltf-validator");
  } catch {
    return undefined;
  }
}

const validator = findValidator();
const given = process.env.VIEW_GLTF;
const missing = (!validator && "no gltf-validator: run `npm ci` in web/") || (!given && unflown) || false;
if (missing) console.error(`\n*** SKIPPED: tests of the glTF files of flexair view: ${missing} ***\n`);

const folder = missing ? "" : given || writeGltf();
const names = missing ? [] : readdirSync(folder).filter((name) => name.endsWith(".glb"));

/** Severities from here on are hints and remarks. */
const HINT = 2;

describe("the glTF files of flexair view", { skip: missing }, () => {
  test("there are some", () => assert.ok(names.length > 0, `no .glb in ${folder}`));

  for (const name of names) {
    test(`${name}: the Khronos validator finds no error and warns of nothing`, async () => {
      const bytes = new Uint8Array(readFileSync(join(folder, name)));
      const { issues, info } = await validator.validateBytes(bytes, { uri: name, maxIssues: 0 });
      const told = issues.messages.map(({ code, message, pointer }) => `${code} at ${pointer}: ${message}`);
      const wrong = told.filter((_, i) => issues.messages[i].severity < HINT);
      assert.deepEqual(wrong, []);
      assert.deepEqual([issues.numErrors, issues.numWarnings], [0, 0]);
      const hints = new Map();
      for (const { code } of issues.messages) hints.set(code, (hints.get(code) ?? 0) + 1);
      const { animationCount, drawCallCount, totalVertexCount, totalTriangleCount } = info;
      console.log(
        `${name}: ${(bytes.length / 1e6).toFixed(1)} MB, ${animationCount} animations, ${drawCallCount} primitives, ` +
          `${totalVertexCount} vertices, ${totalTriangleCount} triangles; hints: ` +
          ([...hints].map(([code, count]) => `${code} × ${count}`).join(", ") || "none"),
      );
    });
  }
});
