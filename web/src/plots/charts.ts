// All plots of a page, tied to the drawing's time.

import type uPlot from "uplot";
import type { Drawing } from "../drawing/render.ts";
import type { Say } from "../drawing/words.ts";
import type { Kept } from "../panels/kept.ts";
import type { TimeAxis } from "../scene/data.ts";
import { nearest } from "../scene/times.ts";
import { type Board, type Card, card, figureOf } from "./card.ts";
import { addition, type Choice, type Choices, read, written } from "./choice.ts";
import { overSignal, overTime } from "./curves.ts";
import { entries } from "./entries.ts";
import { save } from "./files.ts";
import { held } from "./held.ts";
import type { Colour } from "./looks.ts";
import { sampleAt } from "./monotone.ts";
import { type PaperChart, paperChart } from "./paper.ts";
import { plotBar } from "./plot_bar.ts";
import { pointing } from "./pointing.ts";
import type { Signals } from "./signals.ts";
import { type Tools, tools } from "./tools.ts";

/** A plot that the page has: its figure, its title, and what it shows for those who don't see it. */
export interface Own {
  readonly box: HTMLElement;
  readonly title: string;
  readonly label: string;
  readonly choice: Choice;
}

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
  const times = time.values;
  const defaults = own.map(({ choice }) => choice);
  const places = own.map(({ box }) => ({ parent: box.parentElement!, before: box.nextElementSibling }));
  const cards: { card: Card; tools: Tools }[] = [];
  const byBox = new Map<Element, Card>(); // by figure and by area
  const inSight = new Set<Card>();
  let chosen: Choices = { axis: "", plots: defaults };
  if (choosing) chosen = read(choosing.kept.read(), defaults, signals);
  const overTimes = overTime(times, options.column, time.unit, options.axis);
  const horizontal = () => (chosen.axis ? overSignal(chosen.axis, signals) : overTimes);
  const board = {
    signals,
    times,
    colour,
    say,
    x: horizontal(),
    window: [0, 1] as readonly [number, number],
    index: 0,
    goTo(time: number) {
      drawing.setTime(time);
      pointed.keep();
    },
    pointed: (chart) => pointing(chart.uplot, pointed),
  } satisfies Board;
  board.window = board.x.ends;

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
  const moved = (now: number): void => {
    board.index = nearest(times, now);
    for (const each of inSight) each.follow();
  };
  const zoom = (min: number, max: number): void => {
    board.window = [min, max];
    for (const { card } of cards) card.zoom();
    if (whole) whole.hidden = min === board.x.ends[0] && max === board.x.ends[1];
    requestAnimationFrame(() => moved(times[board.index]!));
  };
  const unzoom = (): void => zoom(...board.x.ends);
  const pointed = {
    ...held(drawing),
    goTo(place: number) {
      const { ascends, values, pieces } = board.x;
      drawing.setTime(times[ascends ? nearest(times, place) : sampleAt(values, pieces, place, board.index)]!);
    },
    zoom,
    unzoom,
  };
  const listed = choosing ? entries(signals) : null;

  const add = (box: HTMLElement, choice: Choice, title: string, label: string): Card => {
    const change = (to: Choice): void => {
      made.update(to);
      bar.update();
      keep();
    };
    const made: Card = card(box, choice, { title, label, board, edited: choosing ? change : null });
    const bar: Tools = tools(made, {
      signals,
      say,
      entries: listed,
      edited: choosing ? change : null,
      removed: () => remove(made),
      save(kind) {
        const note = signals.changed ? say("live.changed") : "";
        void save(made, kind, { time: overTimes, window: board.window, index: board.index, note });
      },
    });
    cards.push({ card: made, tools: bar });
    const area = box.querySelector(".chart")!;
    byBox.set(box, made).set(area, made);
    sight.observe(box);
    sized.observe(area);
    if (!choosing) made.seen(true); // all at once: there is nothing that folds
    return made;
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
      settle(i, gone.box, false);
    } else {
      cards.splice(cards.findIndex(({ card }) => card === gone), 1);
      inSight.delete(gone);
      gone.remove();
    }
    keep();
  };
  /** Puts a plot of the report among the first ones, or in its group. */
  const settle = (i: number, box: HTMLElement, top: boolean): void => {
    if (!choosing) return;
    const group = document.querySelector(`[data-of="${box.dataset["group"]}"]`) ?? places[i]!.parent;
    if (top) choosing.top.append(box);
    else {
      const after = [...group.children].find((each) => Number((each as HTMLElement).dataset["plot"]) > Number(box.dataset["plot"]));
      group.insertBefore(box, after ?? null);
    }
  };
  const keep = (): void => {
    chosen = { axis: chosen.axis, plots: cards.map(({ card }) => card.choice) };
    choosing?.kept.write(written(chosen, defaults));
  };
  const redraw = (): void => {
    board.x = horizontal();
    for (const { card, tools } of cards) {
      card.update();
      tools.update();
    }
  };
  chosen.plots.forEach((choice, i) => {
    const each = own[i];
    if (!each) return void addOther(choice);
    add(each.box, choice, each.title, each.label);
    if (choice.top !== each.choice.top) settle(i, each.box, choice.top);
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
        board.x = horizontal();
        board.window = board.x.ends;
        if (whole) whole.hidden = true;
        redraw();
        keep();
      },
      reset() {
        for (const { card } of [...cards]) if (ownAt(card.choice) < 0) remove(card);
        cards.forEach(({ card, tools }, i) => {
          card.update(defaults[i]!);
          tools.update();
          settle(i, card.box, defaults[i]!.top);
        });
        keep();
      },
    });
  }
  whole?.addEventListener("click", unzoom);
  drawing.on("time", moved);
  moved(drawing.time);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    for (const { card } of cards) card.chart?.uplot.redraw(false);
  });

  let onPaper: PaperChart[] = [];
  return {
    update() {
      const whole = board.window === board.x.ends;
      board.x = horizontal();
      if (whole) board.window = board.x.ends;
      for (const { card } of cards) {
        card.update();
        if (whole && chosen.axis) card.zoom();
      }
    },
    get all() {
      return cards.flatMap(({ card }) => (card.chart ? [card.chart.uplot] : []));
    },
    toPaper() {
      onPaper = cards.map(({ card }) => paperChart(card.box.querySelector(".chart")!, card.curves(), board.window, colour));
    },
    toScreen() {
      for (const each of onPaper) each.remove();
      onPaper = [];
    },
  };
}
