// Panning and zooming a drawing by the keyboard, while it has the focus: arrows, with Shift in large steps, + - 0.

import type { Point } from "../scene/data.ts";
import { html } from "./elements.ts";
import type { Frame } from "./frame.ts";
import type { Say } from "./words.ts";

export interface KeyActions {
  /** Moves what is seen by some pixels of the drawing. */
  readonly pan: (by: Point) => void;
  /** Nearer by a factor about the middle. */
  readonly zoom: (factor: number) => void;
  readonly fit: () => void;
}

/** How far a key pans, in pixels of the drawing, and how much nearer one brings. */
const STEP = { plain: 40, shift: 160 };
export const CLOSER = 1.4;
/** To where the view goes, in steps to the right and down. */
const WAYS: Readonly<Record<string, Point>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

let described = 0;

/** Lets a drawing have the focus, and says what keys do: to screen readers, and below it while it has the focus. */
export function keyboard({ stage, drawing }: Frame, say: Say, { pan, zoom, fit }: KeyActions): void {
  const id = `lw-keys-${described++}`;
  html("p", { class: "lw-keys", id }, stage, say("drawing_keys"));
  drawing.setAttribute("tabindex", "0");
  drawing.setAttribute("aria-describedby", id);
  const acts: Readonly<Record<string, () => void>> = {
    "+": () => zoom(CLOSER),
    "=": () => zoom(CLOSER),
    "-": () => zoom(1 / CLOSER),
    _: () => zoom(1 / CLOSER),
    "0": fit,
  };
  drawing.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const way = WAYS[event.key];
    const act = acts[event.key];
    if (!way && !act) return;
    event.preventDefault();
    event.stopPropagation(); // notebooks have keys of their own
    const step = event.shiftKey ? STEP.shift : STEP.plain;
    if (way) pan([-step * way[0], -step * way[1]]);
    else act?.();
  });
}
