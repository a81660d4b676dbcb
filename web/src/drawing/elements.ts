// Elements of SVG and HTML with their attributes.

import { put, remember, reused } from "./reused.ts";

export type Attributes = Readonly<Record<string, string | number>>;

/** In a drawing that is filled anew it is the one that stood there, if that is of its kind. */
export function svg<K extends keyof SVGElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  parent: Element | null = null,
): SVGElementTagNameMap[K] {
  const there = reused(tag, attributes, parent);
  if (there) return there as SVGElementTagNameMap[K];
  const node = document.createElementNS("http://www.w3.org/2000/svg", tag);
  remember(node, attributes);
  return dressed(node, attributes, parent);
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
  if (parent) put(node, parent);
  return node;
}

/** Gives an element a text; one that it has already isn't written again, since a browser would lay it out anew. */
export function write(node: Element, text: string): void {
  if (node.textContent !== text) node.textContent = text;
}

/** Gives an element of a drawing an attribute, where it isn't what the element has: a browser sees to each again. */
export function set(node: Element, key: string, value: string | number): void {
  const text = String(value);
  if (node.getAttribute(key) !== text) node.setAttribute(key, text);
}

/** Shows an element or takes it out of sight. */
export function shown(node: SVGElement, yes: boolean): void {
  const display = yes ? "" : "none";
  if (node.style.display !== display) node.style.display = display;
}
