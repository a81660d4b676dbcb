// A plot for paper: light, of fixed size, and finer than the screen's.

import uPlot from "uplot";
import { html } from "../drawing/elements.ts";
import type { Chart } from "./chart.ts";
import { chartOptions, columns, type Shared } from "./chart_options.ts";

const PAPER = { width: 336, height: 180, scale: 3 };

export interface PaperChart {
  remove(): void;
}

/** Drawn behind the one on the screen, in the colours of the moment. */
export function paperChart({ plot, area }: Chart, shared: Shared): PaperChart {
  const paper = html("div", { class: "chart-paper" });
  area.after(paper);
  const uplot = new uPlot(chartOptions(plot, shared, PAPER), columns(plot, shared.time), html("div"));
  paper.append(uplot.ctx.canvas);
  return {
    remove() {
      uplot.destroy();
      paper.remove();
    },
  };
}
