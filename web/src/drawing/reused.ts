// Drawings that are filled anew: an element takes the place of the one that stood there, where it is of its kind. A
// browser has but the changes to see to then.

import type { Attributes } from "./elements.ts";

/** With what elements were made. */
const made = new WeakMap<Element, Attributes>();

/** Of the elements that are being filled anew the child that stands next; the others are filled as they are made. */
const next = new Map<Element, Element | null>();

/** Fills an element anew with what `fill` draws into it; what is left of before is removed. */
export function refilled<T>(root: Element, fill: () => T): T {
  next.set(root, root.firstElementChild);
  try {
    return fill();
  } finally {
    for (let child of next.values()) {
      while (child) {
        const left: Element = child;
        child = child.nextElementSibling;
        left.remove();
      }
    }
    next.clear();
  }
}

/** Puts an element at the end of what a parent has been filled with. */
export function put(node: Element, parent: Element): void {
  const there = next.get(parent);
  if (there === undefined) parent.append(node);
  else if (there === node) next.set(parent, node.nextElementSibling);
  else parent.insertBefore(node, there);
}

/** The element that stands where one of a kind is to be put, if it is of that kind: it has the attributes then. */
export function reused(tag: string, attributes: Attributes, parent: Element | null): Element | null {
  const there = parent && next.get(parent);
  const was = there && there.localName === tag && made.get(there);
  if (!was || was["class"] !== attributes["class"]) return null;
  const keys = Object.keys(attributes);
  if (keys.length !== Object.keys(was).length || !keys.every((key) => key in was)) return null;
  for (const key of keys) if (was[key] !== attributes[key]) there.setAttribute(key, String(attributes[key]));
  made.set(there, attributes);
  next.set(parent, there.nextElementSibling);
  next.set(there, there.firstElementChild);
  return there;
}

/** Remembers with what an element was made. */
export function remember(node: Element, attributes: Attributes): void {
  made.set(node, attributes);
}
