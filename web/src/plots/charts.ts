// All plots of a page, tied to the drawing's time.

import type uPlot from "uplot";
import type { Drawing } from "../drawing/render.ts";
import type { Plot } from "../scene/data.ts";
import { nearest } from "../scene/times.ts";
import { type Chart, chart, HEIGHT } from "./chart.ts";
import type { Shared } from "./chart_options.ts";
import { held } from "./held.ts";
import { type PaperChart, paperChart } from "./paper.ts";
import { pointing } from "./pointing.ts";

export interface ChartsOptions extends Shared {
  readonly plots: readonly Plot[];
  /** What each plot shows, for those who don't see it. */
  readonly labels: readonly string[];
  readonly drawing: Drawing;
  /** The button that ends an enlargement. */
  readonly whole: HTMLElement | null;
}

export interface Charts {
  readonly all: readonly uPlot[];
  /** The same plots with other values. */
  update(plots: readonly Plot[]): void;
  /** Paper gets its own plots; back on the screen they go. */
  toPaper(): void;
  toScreen(): void;
}

/** A plot in each box, which says by data-plot which. */
export function charts(
  boxes: Iterable<HTMLElement>,
  { plots, labels, drawing, whole, ...shared }: ChartsOptions,
): Charts {
  const times = shared.time.values;
  const made = new Map<Element, Chart>(); // by figure and by area
  const inSight = new Set<Chart>();
  let index = 0;

  const sight = new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) {
      const each = made.get(target)!;
      if (isIntersecting) {
        inSight.add(each);
        refresh(each);
        each.follow(index);
      } else inSight.delete(each);
    }
  });
  const sized = new ResizeObserver((entries) => {
    for (const { target } of entries) {
      const { uplot, area } = made.get(target)!;
      const width = area.clientWidth;
      if (width && width !== uplot.width) uplot.setSize({ width, height: HEIGHT });
    }
  });
  let latest: readonly Plot[] | null = null;
  /** Plots out of sight wait until they are seen. */
  const refresh = (each: Chart): void => {
    const plot = latest?.[Number(each.box.dataset["plot"])];
    if (plot && plot !== each.plot) each.show(plot);
  };
  const moved = (time: number): void => {
    index = nearest(times, time);
    for (const each of inSight) each.follow(index);
  };
  const zoom = (min: number, max: number): void => {
    for (const { uplot } of list) uplot.setScale("x", { min, max });
    if (whole) whole.hidden = min === times[0] && max === times.at(-1);
    requestAnimationFrame(() => moved(times[index]!));
  };
  const unzoom = (): void => zoom(times[0]!, times.at(-1)!);
  const pointed = {
    ...held(drawing),
    goTo: (time: number) => drawing.setTime(times[nearest(times, time)]!),
    zoom,
    unzoom,
  };
  const list = Array.from(boxes, (box) => {
    const i = Number(box.dataset["plot"]);
    const each = chart(box, plots[i]!, labels[i]!, shared);
    made.set(box, each).set(each.area, each);
    pointing(each.uplot, pointed);
    sight.observe(box);
    sized.observe(each.area);
    return each;
  });
  whole?.addEventListener("click", unzoom);
  drawing.on("time", moved);
  moved(drawing.time);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    for (const { uplot } of list) uplot.redraw(false);
  });

  let onPaper: PaperChart[] = [];
  return {
    update(changed) {
      latest = changed;
      for (const each of inSight) refresh(each);
    },
    all: list.map(({ uplot }) => uplot),
    toPaper() {
      list.forEach(refresh);
      onPaper = list.map((each) => paperChart(each, shared));
    },
    toScreen() {
      for (const each of onPaper) each.remove();
      onPaper = [];
    },
  };
}
