// All plots of a page, tied to the drawing's time.

import type uPlot from "uplot";
import type { Drawing } from "../drawing/render.ts";
import type { Say } from "../drawing/words.ts";
import { found } from "../panels/found.ts";
import type { Kept } from "../panels/kept.ts";
import type { TimeAxis } from "../scene/data.ts";
import { type Board, board } from "./board.ts";
import { type Card, card, figureOf } from "./card.ts";
import { addition, type Choice, type Choices, read, written } from "./choice.ts";
import { type Horizontal, overTime } from "./curves.ts";
import { entries } from "./entries.ts";
import { save } from "./files.ts";
import type { Colour } from "./looks.ts";
import { type PaperChart, paperChart } from "./paper.ts";
import { groupOf, type Own, place } from "./places.ts";
import { plotBar } from "./plot_bar.ts";
import type { Signals } from "./signals.ts";
import { type Tools, tools } from "./tools.ts";

export interface ChartsOptions {
  readonly time: TimeAxis;
  /** Name and unit of the time's axis, and how files call it. */
  readonly axis: string;
  readonly column: string;
  readonly own: readonly Own[];
  readonly signals: Signals;
  readonly colour: Colour;
  readonly say: Say;
  readonly drawing: Drawing;
  /** The button that ends an enlargement. */
  readonly whole: HTMLElement | null;
  /** Where a reader chooses, where the first plots stand, and where a choice is kept; null where nothing is chosen. */
  readonly choosing: { readonly bar: Element; readonly top: Element; readonly kept: Kept } | null;
}

export interface Charts {
  readonly all: readonly uPlot[];
  /** The same plots with other values. */
  update(): void;
  /** Paper gets its own plots; back on the screen they go. */
  toPaper(): void;
  toScreen(): void;
}

export function charts(options: ChartsOptions): Charts {
  const { time, own, signals, colour, say, drawing, whole, choosing } = options;
  const defaults = own.map(({ choice }) => choice);
  const groups = own.map(({ box }) => groupOf(box));
  const cards: { card: Card; tools: Tools }[] = [];
  const byBox = new Map<Element, Card>(); // by figure and by area
  const inSight = new Set<Card>();
  let chosen: Choices = choosing ? read(choosing.kept.read(), defaults, signals) : { axis: "", plots: defaults };
  let timed: Horizontal | null = null;
  /** The axis of times, which follows the run's length. */
  const overTimes = (): Horizontal => {
    const [now, before] = [signals.times?.() ?? time.values, signals.times?.(true) ?? time.values];
    if (timed?.values !== now) {
      timed = overTime(now, options.column, time.unit, options.axis, now === before ? null : before);
    }
    return timed;
  };
  const shared: Board = board({
    signals,
    colour,
    say,
    drawing,
    time: overTimes,
    axis: chosen.axis,
    moved() {
      for (const each of inSight) each.follow();
    },
    zoomed(all) {
      for (const { card } of cards) card.zoom();
      if (whole) whole.hidden = all;
    },
  });

  const sight = new IntersectionObserver((changes) => {
    for (const { target, isIntersecting } of changes) {
      const each = byBox.get(target);
      if (isIntersecting && each) inSight.add(each);
      else if (each) inSight.delete(each);
      each?.seen(isIntersecting);
    }
  });
  const sized = new ResizeObserver((changes) => {
    for (const { target } of changes) byBox.get(target)?.sized();
  });
  const listed = choosing ? entries(signals) : null;

  const add = (box: HTMLElement, choice: Choice, title: string, label: string): void => {
    const change = (to: Choice): void => {
      made.update(to);
      bar.update();
      keep();
    };
    const made: Card = card(box, choice, { title, label, board: shared, edited: choosing ? change : null });
    const bar: Tools = tools(made, {
      signals,
      say,
      entries: listed,
      edited: choosing ? change : null,
      removed: () => remove(made),
      save(kind) {
        const note = signals.changed ? say("live.changed") : "";
        void save(made, kind, { time: overTimes(), window: shared.window, index: shared.index, note });
      },
    });
    const area = found(".chart", box);
    cards.push({ card: made, tools: bar });
    byBox.set(box, made).set(area, made);
    sight.observe(box);
    sized.observe(area);
    if (!choosing) made.seen(true); // all at once: there is nothing that folds
  };
  const addOther = (choice: Choice): HTMLElement => {
    const box = figureOf();
    choosing!.top.append(box);
    add(box, choice, "", "");
    return box;
  };
  const ownAt = (choice: Choice): number => defaults.findIndex(({ of }) => of === choice.of && of !== "");
  /** A plot of the report goes back folded among the others; another one goes. */
  const remove = (gone: Card): void => {
    const i = ownAt(gone.choice);
    if (i >= 0) {
      gone.update({ ...defaults[i]!, top: false, open: false });
      cards.find(({ card }) => card === gone)!.tools.update();
      settle(i, false);
    } else {
      cards.splice(cards.findIndex(({ card }) => card === gone), 1);
      inSight.delete(gone);
      gone.remove();
    }
    keep();
  };
  /** Puts a plot of the report among the first ones, or in its group. */
  const settle = (i: number, top: boolean): void => {
    if (choosing) place(own[i]!.box, top ? choosing.top : groups[i]!, !top);
  };
  const keep = (): void => {
    chosen = { axis: chosen.axis, plots: cards.map(({ card }) => card.choice) };
    choosing?.kept.write(written(chosen, defaults));
  };
  chosen.plots.forEach((choice, i) => {
    const each = own[i];
    if (!each) return void addOther(choice);
    add(each.box, choice, each.title, each.label);
    if (choice.top !== each.choice.top) settle(i, choice.top);
  });
  if (choosing && listed) {
    plotBar(choosing.bar, {
      say,
      entries: listed,
      axes: signals.axes,
      axis: chosen.axis,
      time: time.label,
      added(names) {
        const box = addOther(addition(names));
        keep();
        box.scrollIntoView({ block: "nearest" });
      },
      onAxis(axis) {
        chosen = { ...chosen, axis };
        shared.over(axis);
        if (whole) whole.hidden = true;
        for (const { card } of cards) card.update();
        keep();
      },
      reset() {
        for (const { card } of [...cards]) if (ownAt(card.choice) < 0) remove(card);
        cards.forEach(({ card, tools }, i) => {
          card.update(defaults[i]!);
          tools.update();
          settle(i, defaults[i]!.top);
        });
        keep();
      },
    });
  }
  whole?.addEventListener("click", () => shared.unzoom());
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    for (const { card } of cards) card.chart?.uplot.redraw(false);
  });

  let onPaper: PaperChart[] = [];
  return {
    update() {
      const zoomed = shared.changed();
      for (const { card } of cards) {
        if (zoomed) card.zoom();
        card.update();
      }
    },
    get all() {
      return cards.flatMap(({ card }) => (card.chart ? [card.chart.uplot] : []));
    },
    toPaper() {
      for (const { card } of cards) card.named();
      onPaper = cards.map(({ card }) => paperChart(found(".chart", card.box), card.curves(), shared.window, colour));
    },
    toScreen() {
      for (const each of onPaper) each.remove();
      onPaper = [];
    },
  };
}
