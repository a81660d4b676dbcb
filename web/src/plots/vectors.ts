// Vectors among signals: pairs of components, their magnitudes.

import { known, type Values } from "../scene/data.ts";

const COMPONENT = /^(.*\.)(v|a|j|)([xy])$/s;

/** The y component of a vector by its x component; null of anything else. */
export function partner(name: string): string | null {
  const found = COMPONENT.exec(name);
  return found?.[3] === "x" ? `${found[1]}${found[2]}y` : null;
}

/** A vector by its x component: `force(frame, crank)`, `E.v`. */
export function vectorName(name: string): string {
  const [, owner = name, rate = ""] = COMPONENT.exec(name) ?? [];
  return rate ? owner + rate : owner.slice(0, -1);
}

/** Whether signals are vectors alone, each by its components x and y. */
export const areVectors = (names: readonly string[]): boolean =>
  names.length > 0 && names.length % 2 === 0 && names.every((name, i) => i % 2 === 1 || partner(name) === names[i + 1]);

export function magnitudes(x: Values, y: Values): (number | null)[] {
  return Array.from({ length: Math.min(x.length, y.length) }, (_, k) => {
    const [u, v] = [known(x, k), known(y, k)];
    return u === null || v === null ? null : Math.hypot(u, v);
  });
}
