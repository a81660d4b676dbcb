// A plot on the page: its head with tools, its curves in the view that its reader chose, its legend.

import { html } from "../drawing/elements.ts";
import { filled } from "../drawing/words.ts";
import { found } from "../panels/found.ts";
import type { Board } from "./board.ts";
import { type Chart, chart } from "./chart.ts";
import { chartKey } from "./chart_options.ts";
import { type Choice, unitsOf, viewOf, without } from "./choice.ts";
import { type Curves, curvesOf } from "./curves.ts";
import { figure } from "./figure.ts";
import { legend } from "./legend.ts";
import { polarChart } from "./polar_chart.ts";
import type { Signals } from "./signals.ts";

export interface Card {
  readonly box: HTMLElement;
  choice: Choice;
  readonly chart: Chart | null;
  /** What it shows now, which it computes where it isn't in sight. */
  curves(): Curves;
  /** Has a legend, which one that was never in sight lacks. */
  named(): void;
  shown(curve: number): boolean;
  /** Another choice; `changed`: its values are others. */
  update(choice?: Choice): void;
  follow(): void;
  /** Whether it is in sight: until then it does nothing. */
  seen(yes: boolean): void;
  zoom(): void;
  sized(): void;
  remove(): void;
}

export interface CardOptions {
  /** Empty for that of its curves. */
  readonly title: string;
  /** For those who don't see it. */
  readonly label: string;
  readonly board: Board;
  /** A reader chose something; null where nothing can be chosen. */
  readonly edited: ((choice: Choice) => void) | null;
}

export function card(
  box: HTMLElement,
  first: Choice,
  { title, label, board, edited }: CardOptions,
): Card {
  const { signals, say } = board;
  const area = found<HTMLElement>(".chart", box);
  const values = found(".legend", box);
  let outputs: HTMLOutputElement[] = [];
  let curves: Curves | null = null;
  let drawn: Chart | null = null;
  let polar: ReturnType<typeof polarChart> | null = null;
  let key = "";
  let [inSight, stale] = [false, true];
  let hidden = new Set<number>();

  const clear = (): void => {
    drawn?.destroy();
    polar?.remove();
    [drawn, polar] = [null, null];
  };
  /** Writes the title of a plot that a reader added. */
  const name = ({ title, units }: Curves): void => {
    found(".added", box).textContent = title;
    found(".unit", box).textContent = ` ${units.join(", ")}`;
  };
  const legends = (now: Curves): void => {
    hidden = new Set();
    const two = now.units.length > 1;
    outputs = legend(values, now.curves.map(({ name, unit }) => ({ name, unit: two ? unit : "" })), {
      toggle(i, show) {
        if (show) hidden.delete(i);
        else hidden.add(i);
        drawn?.uplot.setSeries(i + 1, { show });
      },
      remove:
        edited && now.curves.length > 1
          ? (i) => {
              const { name, signals: of } = now.curves[i]!;
              const text = filled(say("plots.remove_signal"), { name });
              return { label: text, act: () => edited(without(made.choice, of[0]!)) };
            }
          : undefined,
    });
  };
  const draw = (): void => {
    stale = false;
    const { choice } = made;
    curves = curvesOf(choice, title, signals, board.x, board.times);
    if (!title) name(curves);
    const view = choice.open ? viewOf(choice) : "folded";
    const now = `${view} ${chartKey(curves)}`;
    if (now !== key) {
      clear();
      key = now;
      legends(curves);
      if (view === "polar") polar = polarChart(area, curves, label || curves.title);
      else if (view !== "folded") {
        const { colour, window } = board;
        drawn = chart(area, curves, label || curves.title, { colour, window, goTo: (time) => board.goTo(time) });
        board.pointed(drawn);
      }
    } else {
      drawn?.show(curves);
      polar?.show(curves);
    }
    follow();
  };
  const follow = (): void => {
    if (!inSight && !drawn) return;
    drawn?.follow(board.index);
    polar?.follow(board.index);
    outputs.forEach((output, i) => {
      output.textContent = figure(curves?.curves[i]?.values[board.index]);
    });
  };
  const made: Card = {
    box,
    choice: first,
    get chart() {
      return drawn;
    },
    curves: () => (curves && !stale ? curves : curvesOf(made.choice, title, signals, board.x, board.times)),
    named() {
      if (!outputs.length) legends(made.curves());
    },
    shown: (i) => !hidden.has(i),
    update(choice = made.choice) {
      made.choice = choice;
      box.classList.toggle("folded", !choice.open);
      stale = true;
      if (inSight) draw();
    },
    follow,
    seen(yes) {
      inSight = yes;
      if (yes && stale) draw();
      else if (yes) follow();
    },
    zoom: () => drawn?.zoom(board.window),
    sized() {
      drawn?.sized();
      if (polar && curves) polar.show(curves);
    },
    remove() {
      clear();
      box.remove();
    },
  };
  box.classList.toggle("folded", !first.open);
  return made;
}

/** The figure of a plot that a reader adds. */
export function figureOf(): HTMLElement {
  const box = html("figure", { class: "plot" });
  const head = html("figcaption", {}, box);
  html("span", { class: "added" }, head);
  html("span", { class: "unit" }, head);
  html("div", { class: "chart" }, box);
  html("div", { class: "legend lw" }, box);
  return box;
}

/** Which signals can join those of a plot: of its units, or of one more where it has one. */
export function joins(choice: Choice, signals: Signals): (name: string) => boolean {
  const units = unitsOf(choice.signals, signals.unit);
  return (name) => !choice.signals.includes(name) && (units.length < 2 || units.includes(signals.unit(name)));
}

