/** What pictures of pages of `flexair view` have in common: the scene alone, and a mouse that points the camera. */

/**
 * Only the scene, as large as the picture, with what it says above and its legend below. That has a layer of its own: the grain of its colours
 * depends on where on a layer it lies, and that is else not always the same.
 */
export const style = (says) => `
  #stage { position: fixed !important; inset: 0; height: auto !important; z-index: 9 }
  #legend { top: auto; bottom: 10px; will-change: transform }
  #stage::after { content: ${JSON.stringify(says).replaceAll("\\n", "\\A ")}; position: absolute; left: 12px; top: 10px;
    white-space: pre; line-height: 1.4; font-size: 13px; font-weight: 600 }`;

/** Drags the mouse over a scene of a size, with a key held. */
export async function drag(page, size, [right, down], key) {
  if (key) await page.keyboard.down(key);
  await page.mouse.move(size.width / 2, size.height / 2);
  await page.mouse.down();
  await page.mouse.move(size.width / 2 + right, size.height / 2 + down, { steps: 8 });
  await page.mouse.up();
  if (key) await page.keyboard.up(key);
}
