/** Elements of the page. Text of the data is only ever set as text. */

/** The element of the page with an id. */
export function element<T extends HTMLElement = HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no element ${id}`);
  return found as T;
}

/** A new element with a text. */
export function make<K extends keyof HTMLElementTagNameMap>(tag: K, text = ""): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  made.textContent = text;
  return made;
}

/** Sets a text, if it is another. */
export function say(to: HTMLElement, text: string): void {
  if (to.textContent !== text) to.textContent = text;
}

/** Fills a menu with [value, text]. */
export function fill(menu: HTMLSelectElement, entries: [string, string][]): void {
  menu.replaceChildren(...entries.map(([value, text]) => entry(value, text)));
}

export function entry(value: string, text: string): HTMLOptionElement {
  const option = make("option", text);
  option.value = value;
  return option;
}
