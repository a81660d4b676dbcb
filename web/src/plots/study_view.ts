// What a chart of a study can do, however it is drawn.

import { html } from "../drawing/elements.ts";
import type { Say } from "../drawing/words.ts";
import type { Colour } from "./looks.ts";

export interface StudyView {
  /** Draws it, in a place that is as high already; before, it has its legend alone. */
  seen(): void;
  /** Anew after the place got another width. */
  sized(): void;
  /** All of it in sight again. */
  reset(): void;
  /** A key that was pressed on it; whether it did something. */
  key(key: string, far: boolean): boolean;
  /** The theme has changed. */
  themed(): void;
  csv(): string;
  /** The text of a file of a width, in light. */
  svg(width: number): string;
  /** A picture for paper, until the function that it gives is called. */
  toPaper(): () => void;
  remove(): void;
}

export interface StudyPlace {
  readonly box: HTMLElement;
  readonly area: HTMLElement;
  readonly legend: HTMLElement;
  readonly colour: Colour;
  readonly say: Say;
  /** What it shows, for those who don't see it. */
  readonly label: string;
  /** Calls after a zoom: whether all of it is in sight. */
  readonly zoomed: (whole: boolean) => void;
}

/** The places at the beginning of a legend for what is read at the cursor, by their names. */
export function readout(legend: HTMLElement, names: readonly string[]): HTMLOutputElement[] {
  const box = html("span", { class: "readout" });
  legend.prepend(box);
  return names.map((name) => {
    const entry = html("span", { class: "entry" }, box);
    html("span", {}, entry, name);
    return html("output", { "aria-live": "polite" }, entry, "–");
  });
}
