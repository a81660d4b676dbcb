// What a reader chose to plot, as it is kept from one visit to the next.

import { areVectors, partner } from "./vectors.ts";

export type View = "components" | "magnitude" | "polar";

/** One plot: `of` is the report's own plot that it was (all its signals), empty for one that the reader added; `top`:
 * among the first ones; `open`: unfolded. */
export interface Choice {
  readonly of: string;
  readonly signals: readonly string[];
  readonly view: View;
  readonly top: boolean;
  readonly open: boolean;
}

export interface Choices {
  /** The signal in place of the time; empty for the time. */
  readonly axis: string;
  readonly plots: readonly Choice[];
}

export const keyOf = (signals: readonly string[]): string => signals.join("|");

/** A plot of a signal; of the x component of a vector, of both. */
export const addition = (signals: readonly string[]): Choice => ({
  of: "",
  signals,
  view: "components",
  top: true,
  open: true,
});

/** Only vectors have magnitudes and polar plots. */
export const viewOf = ({ signals, view }: Choice): View => (areVectors(signals) ? view : "components");

/** A choice with another signal. */
export const overlaid = (choice: Choice, signals: readonly string[]): Choice => ({
  ...choice,
  signals: [...choice.signals, ...signals.filter((name) => !choice.signals.includes(name))],
});

/** A choice without a signal; in other views than that of components, without the vector of that x component. */
export function without(choice: Choice, name: string): Choice {
  const gone = viewOf(choice) === "components" ? [name] : [name, partner(name)];
  return { ...choice, signals: choice.signals.filter((each) => !gone.includes(each)) };
}

/** The units of signals, each once: the left axis, then the right one. */
export const unitsOf = (signals: readonly string[], unit: (name: string) => string): string[] => [
  ...new Set(signals.map(unit)),
];

/** What differs from the report's own plots, as a text. */
export function written({ axis, plots }: Choices, own: readonly Choice[]): string {
  const before = new Map(own.map((choice) => [choice.of, JSON.stringify(choice)]));
  const others = plots.filter((each) => before.get(each.of) !== JSON.stringify(each));
  return JSON.stringify({ version: 1, axis, plots: others });
}

/** The choices of a text, with what is left of them: signals that there are, in two units at most. A text that says
 * nothing sensible leaves the report's own plots. */
export function read(
  text: string | null,
  own: readonly Choice[],
  signals: { readonly axes: readonly string[]; has(name: string): boolean; unit(name: string): string },
): Choices {
  const none = { axis: "", plots: own };
  let kept: { version?: unknown; axis?: unknown; plots?: unknown };
  try {
    kept = JSON.parse(text ?? "{}") ?? {};
  } catch {
    return none;
  }
  if (kept.version !== 1 || !Array.isArray(kept.plots)) return none;
  const found = kept.plots.flatMap((each): Choice[] => {
    const { of, signals: names, view, top, open } = (each ?? {}) as Partial<Choice>;
    if (typeof of !== "string" || !Array.isArray(names)) return [];
    const there = names.filter((name) => typeof name === "string" && signals.has(name));
    if (!there.length || unitsOf(there, signals.unit).length > 2) return [];
    const shown = view === "magnitude" || view === "polar" ? view : "components";
    return [{ of, signals: there, view: shown, top: top === true, open: open === true }];
  });
  const changed = new Map(found.filter(({ of }) => of).map((choice) => [choice.of, choice]));
  const axis = typeof kept.axis === "string" && signals.axes.includes(kept.axis) ? kept.axis : "";
  return { axis, plots: [...own.map((each) => changed.get(each.of) ?? each), ...found.filter(({ of }) => !of)] };
}
