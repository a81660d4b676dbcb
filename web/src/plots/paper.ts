// A plot for paper: light, of fixed size, and finer than the screen's.

import uPlot from "uplot";
import { html } from "../drawing/elements.ts";
import { chartOptions, columns } from "./chart_options.ts";
import type { Curves } from "./curves.ts";
import type { Colour } from "./looks.ts";
import { polarSvg } from "./polar.ts";

const PAPER = { width: 336, height: 180, scale: 3 };

export interface PaperChart {
  remove(): void;
}

/** Drawn behind the one on the screen, in the colours of the moment. */
export function paperChart(area: Element, curves: Curves, window: readonly [number, number], colour: Colour): PaperChart {
  const paper = html("div", { class: "chart-paper" });
  area.after(paper);
  if (curves.vectors.length) {
    const { width, height } = PAPER;
    paper.innerHTML = `<svg viewBox="0 0 ${width} ${height}">${polarSvg(curves, null, { width, height, colour })}</svg>`;
    return { remove: () => paper.remove() };
  }
  const uplot = new uPlot(chartOptions({ curves, window, index: 0 }, colour, PAPER), columns(curves), html("div"));
  paper.append(uplot.ctx.canvas);
  return {
    remove() {
      uplot.destroy();
      paper.remove();
    },
  };
}
