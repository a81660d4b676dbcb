// What a reader can choose to plot: each vector by its components, each signal.

import { search } from "./search.ts";
import type { Signals } from "./signals.ts";
import { partner } from "./vectors.ts";

/** `detail`: unit and element. */
export interface Entry {
  readonly name: string;
  readonly unit: string;
  readonly element: string;
  readonly detail: string;
  readonly signals: readonly string[];
}

export interface Entries {
  found(query: string): readonly Entry[];
}

export function entries(signals: Signals): Entries {
  const all = signals.list.flatMap((listed): Entry[] => {
    const detail = [listed.unit, listed.element].filter(Boolean).join(" · ");
    const one = { ...listed, detail, signals: [listed.name] };
    const other = partner(listed.name);
    if (!other || !signals.has(other)) return [one];
    const name = `${listed.name}, ${other.slice(other.lastIndexOf(".") + 1)}`;
    return [{ ...one, name, signals: [listed.name, other] }, one];
  });
  return { found: (query) => search(all, query) };
}
