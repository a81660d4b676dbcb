// Elements of SVG and HTML with their attributes.

export type Attributes = Readonly<Record<string, string | number>>;

export function svg<K extends keyof SVGElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  parent: Element | null = null,
): SVGElementTagNameMap[K] {
  return dressed(document.createElementNS("http://www.w3.org/2000/svg", tag), attributes, parent);
}

export function html<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  parent: Element | null = null,
  text: string | null = null,
): HTMLElementTagNameMap[K] {
  const node = dressed(document.createElement(tag), attributes, parent);
  if (text !== null) node.textContent = text;
  return node;
}

function dressed<E extends Element>(node: E, attributes: Attributes, parent: Element | null): E {
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, String(value));
  parent?.append(node);
  return node;
}

/** Gives an element a text; one that it has already isn't written again, since a browser would lay it out anew. */
export function write(node: Element, text: string): void {
  if (node.textContent !== text) node.textContent = text;
}

/** Shows an element or takes it out of sight. */
export function shown(node: SVGElement, yes: boolean): void {
  node.style.display = yes ? "" : "none";
}
