// The first row of the plots: a search that adds one, the horizontal axis, the way back to the report's own plots.

import { html } from "../drawing/elements.ts";
import type { Say } from "../drawing/words.ts";
import { combobox } from "../panels/combobox.ts";
import type { Entries } from "./entries.ts";

export interface PlotBarOptions {
  readonly say: Say;
  readonly entries: Entries;
  /** Signals that can stand in place of the time, and the one that does; empty for the time, which has this name. */
  readonly axes: readonly string[];
  readonly axis: string;
  readonly time: string;
  readonly added: (signals: readonly string[]) => void;
  readonly onAxis: (axis: string) => void;
  readonly reset: () => void;
}

export function plotBar(box: Element, options: PlotBarOptions): void {
  const { say, entries, axes, axis, time, added, onAxis, reset } = options;
  combobox(box, {
    label: say("plots.search"),
    none: say("plots.no_match"),
    found: (query) => entries.found(query),
    chosen: ({ signals }) => added(signals),
  });
  if (axes.length) {
    const label = html("label", {}, box, say("plots.axis"));
    const select = html("select", {}, label);
    for (const [value, text] of [["", time], ...axes.map((name) => [name, name])] as const) {
      html("option", { value }, select, text);
    }
    select.value = axis;
    select.addEventListener("change", () => onAxis(select.value));
  }
  const back = html("button", { type: "button" }, box, say("plots.default"));
  back.addEventListener("click", reset);
}
