// The measures of the page, taken anew from the samples while its numbers are changed.

import { html, write } from "../drawing/elements.ts";
import { filled, type Say } from "../drawing/words.ts";
import { figuresOf, rowsOf } from "../live/live_figures.ts";
import type { LiveModel } from "../live/live_model.ts";
import type { Figure, LiveMeasure } from "../measures/measure.ts";
import { isLive } from "../measures/registry.ts";
import { met } from "../measures/requirement.ts";
import type { TimeAxis } from "../scene/data.ts";
import { sixDigits } from "../scene/numbers.ts";

interface Row {
  readonly measure: LiveMeasure;
  readonly number: number;
  readonly cells: readonly { readonly cell: HTMLElement; readonly as: string }[];
  readonly line: HTMLTableRowElement;
  /** The values (SI) of the samples at the file's numbers, by label. */
  readonly before: Readonly<Record<string, Figure>>;
}

export interface Measured {
  update(): void;
}

/** Takes over the rows of the table of measures, which stand in the order of the data. */
export function measured(live: LiveModel, say: Say, time: Pick<TimeAxis, "unit">): Measured {
  const lines = document.querySelectorAll<HTMLTableRowElement>("#measures table.measures tbody tr");
  const { second } = live.data;
  const rows = live.data.measures.flatMap((measure, number): Row[] => {
    const line = Array.from(lines).find((each) => each.querySelector("b")?.textContent === measure.name);
    if (!line) return [];
    const cells = Array.from(line.cells, (cell) => ({ cell, as: cell.innerHTML }));
    // A file whose motion has a gap has no values that others could be compared with.
    const before = live.original.failure ? {} : (figuresOf(live, number, live.original) ?? {});
    return [{ measure, number, line, cells, before }];
  });
  const badge = document.querySelector<HTMLElement>("#requirements");
  const badgeAs = badge?.innerHTML ?? "";
  let taken = false;
  /** What the file's own run found stands there again. */
  const restore = (): void => {
    taken = false;
    for (const { cells } of rows) for (const { cell, as } of cells) cell.innerHTML = as;
    if (badge) badge.innerHTML = badgeAs;
  };
  const update = (): void => {
    if (!live.changed) {
      if (taken) restore();
      return;
    }
    taken = true;
    const verdicts: boolean[] = [];
    for (const row of rows) {
      const verdict = show(row);
      if (verdict !== null) verdicts.push(verdict);
    }
    const shownBadge = badge?.querySelector<HTMLElement>(".mark");
    if (!verdicts.length || !shownBadge) return;
    const passed = verdicts.filter(Boolean).length;
    const text = filled(say("live.requirements"), { met: `${passed}`, total: `${verdicts.length}` });
    mark(shownBadge, passed === verdicts.length, text);
  };
  /** Writes the figures of the moment into a row; whether they meet its requirement, if it has one. */
  const show = ({ measure, number, line, before }: Row): boolean | null => {
    const found = isLive(measure) ? figuresOf(live, number) : undefined;
    const values = line.querySelectorAll<HTMLElement>(".line.value");
    const places = line.querySelectorAll<HTMLElement>(".line.where");
    measure.labels.forEach((label, i) => {
      const figure = found?.[label];
      const value = values[i]?.querySelector("b");
      if (value) write(value, figure ? shown(figure.value / measure.size) : "–");
      const place = places[i];
      if (place) write(place, figure?.time != null ? `t = ${sixDigits(figure.time / second)} ${time.unit}` : "–");
      const was = before[label];
      const after = values[i]?.nextElementSibling;
      const note = after?.classList.contains("was") ? after : null;
      if (figure && was && values[i]) {
        const change = shown((figure.value - was.value) / measure.size, true);
        const original = shown(was.value / measure.size);
        const text = filled(say("live.original"), { value: original, change });
        if (note) write(note, text);
        else values[i]!.after(html("span", { class: "note was" }, null, text));
      } else note?.remove(); // a change belongs to a value
    });
    const grade = isLive(measure) ? say("live.sampled") : say("live.not_computed");
    for (const note of line.querySelectorAll<HTMLElement>(".grade")) write(note, grade);
    if (!measure.requirement) return null;
    const verdict = met(measure.requirement, found, rowsOf(live.motion));
    const place = line.querySelector<HTMLElement>(".mark");
    if (place) mark(place, verdict, say(verdict ? "pass" : "fail"));
    return verdict;
  };
  return { update };
}

/** A verdict: a sign and a word. */
function mark(place: HTMLElement, good: boolean, text: string): void {
  place.classList.toggle("ok", good);
  place.classList.toggle("bad", !good);
  write(place, `${good ? "✓" : "✗"} ${text}`);
}

const shown = (value: number, signed = false): string =>
  `${signed && value > 0 ? "+" : ""}${sixDigits(value)}`.replace("-", "−");
