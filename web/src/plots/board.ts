// What the plots of a page share: the horizontal axis, what is in sight of it, the sample at the cursor, the drawing.

import type { Drawing } from "../drawing/render.ts";
import type { Say } from "../drawing/words.ts";
import { nearest } from "../scene/times.ts";
import type { Chart } from "./chart.ts";
import { type Horizontal, overSignal } from "./curves.ts";
import { held } from "./held.ts";
import type { Colour } from "./looks.ts";
import { sampleAt } from "./monotone.ts";
import { pointing } from "./pointing.ts";
import type { Signals } from "./signals.ts";

export interface Board {
  readonly signals: Signals;
  readonly times: readonly number[];
  readonly colour: Colour;
  readonly say: Say;
  readonly x: Horizontal;
  readonly window: readonly [number, number];
  readonly index: number;
  /** Puts the drawing to a time and leaves it there. */
  goTo(time: number): void;
  /** Lets a pointer in a plot move the drawing and choose what is in sight. */
  pointed(chart: Chart): void;
  zoom(from: number, to: number): void;
  unzoom(): void;
  /** Takes a signal in place of the time; the time for an empty name. */
  over(axis: string): void;
  /** Values of signals have changed: whether what is in sight of the axis has. */
  changed(): boolean;
}

export interface BoardOptions extends Pick<Board, "signals" | "colour" | "say"> {
  readonly drawing: Drawing;
  readonly time: () => Horizontal;
  readonly axis: string;
  /** Calls after the cursor has moved, and after what is in sight has changed. */
  readonly moved: () => void;
  readonly zoomed: (whole: boolean) => void;
}

export function board({ signals, colour, say, drawing, time, axis, moved, zoomed }: BoardOptions): Board {
  const times = (): readonly number[] => time().values as readonly number[];
  let name = axis;
  const horizontal = (): Horizontal => (name ? overSignal(name, signals) : time());
  let x = horizontal();
  let window = x.ends;
  let index = nearest(times(), drawing.time);
  const zoom = (from: number, to: number): void => {
    window = [from, to];
    zoomed(from === x.ends[0] && to === x.ends[1]);
    requestAnimationFrame(moved);
  };
  const pointed = {
    ...held(drawing),
    goTo(place: number) {
      const { ascends, values, pieces } = x;
      drawing.setTime(times()[ascends ? nearest(times(), place) : sampleAt(values, pieces, place, index)]!);
    },
    zoom,
    unzoom: () => zoom(...x.ends),
  };
  drawing.on("time", (now) => {
    index = nearest(times(), now);
    moved();
  });
  return {
    signals,
    get times() {
      return times();
    },
    colour,
    say,
    get x() {
      return x;
    },
    get window() {
      return window;
    },
    get index() {
      return index;
    },
    goTo(time) {
      drawing.setTime(time);
      pointed.keep();
    },
    pointed: (chart) => pointing(chart.uplot, pointed),
    zoom,
    unzoom: pointed.unzoom,
    over(axis) {
      name = axis;
      x = horizontal();
      window = x.ends;
    },
    changed() {
      const [whole, before] = [window === x.ends, x];
      x = horizontal();
      if (whole) window = x.ends;
      return whole && x !== before;
    },
  };
}
