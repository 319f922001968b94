/** Reads what the command wrote into the page: the scene and the numbers that it points to. */
import type { Scene } from "./scene";

export function readScene(): Scene {
  return JSON.parse(textOf("scene")) as Scene;
}

/** The numbers: base64 of a zlib stream (RFC 1950). */
export async function readData(): Promise<ArrayBuffer> {
  const binary = atob(textOf("data").trim());
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) bytes[i] = binary.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

function textOf(id: string): string {
  return document.getElementById(id)?.textContent ?? "";
}
