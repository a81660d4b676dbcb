// One plot on the page.

import uPlot from "uplot";
import { found } from "../panels/found.ts";
import type { Plot } from "../scene/data.ts";
import { chartOptions, columns, type Shared } from "./chart_options.ts";
import { figure } from "./figure.ts";
import { legend } from "./legend.ts";

export const HEIGHT = 230;

export interface Chart {
  /** The figure, and in it the area that the curves fill. */
  readonly box: HTMLElement;
  readonly area: HTMLElement;
  /** What it shows now. */
  plot: Plot;
  readonly uplot: uPlot;
  /** Shows the same signals with other values. */
  show(plot: Plot): void;
  /** Puts the cursor and the legend's values to a sample. */
  follow(index: number): void;
}

/** `label`: what the plot shows, for those who don't see it. */
export function chart(box: HTMLElement, plot: Plot, label: string, shared: Shared): Chart {
  const { time } = shared;
  const area = found<HTMLElement>(".chart", box);
  const size = { width: area.clientWidth || 400, height: HEIGHT };
  const uplot = new uPlot(chartOptions(plot, shared, size), columns(plot, time), area);
  const values = legend(found(".legend", box), plot, uplot);
  uplot.over.setAttribute("role", "img");
  uplot.over.setAttribute("aria-label", label);
  let index = 0;
  const follow = (sample: number): void => {
    index = sample;
    const left = uplot.valToPos(time.values[index]!, "x");
    const inside = left >= 0 && left <= uplot.over.clientWidth;
    uplot.setCursor({ left: inside ? left : -10, top: 0 }, false);
    values.forEach((output, i) => {
      output.textContent = figure(made.plot.series[i]!.values[index]);
    });
  };
  const show = (changed: Plot): void => {
    made.plot = changed;
    const { min, max } = uplot.scales["x"]!;
    uplot.batch(() => {
      uplot.setData(columns(changed, time));
      if (min != null && max != null) uplot.setScale("x", { min, max });
    });
    follow(index);
  };
  const made: Chart = { box, area, plot, uplot, follow, show };
  return made;
}
