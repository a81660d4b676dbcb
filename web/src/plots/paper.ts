// A plot for paper: light, of fixed size, and finer than the screen's.

import uPlot from "uplot";
import { html } from "../drawing/elements.ts";
import { chartOptions, columns } from "./chart_options.ts";
import type { Curves } from "./curves.ts";
import { type Colour, colourOf } from "./looks.ts";
import "./of_studies.ts";
import { polarSvg } from "./polar.ts";
import { clipped } from "./traces.ts";

const PAPER = { width: 336, height: 180, scale: 3 };

export interface PaperChart {
  remove(): void;
}

/** Drawn behind the one on the screen, in the colours of the moment. */
export function paperChart(
  area: Element,
  curves: Curves,
  window: readonly [number, number],
  colour: Colour,
): PaperChart {
  const paper = html("div", { class: "chart-paper" });
  area.after(paper);
  if (curves.vectors.length) {
    const { width, height } = PAPER;
    const inner = polarSvg(curves, null, { width, height, colour });
    paper.innerHTML = `<svg viewBox="0 0 ${width} ${height}">${inner}</svg>`;
    return { remove: () => paper.remove() };
  }
  const options = chartOptions({ curves, window, index: 0 }, colour, PAPER);
  options.hooks = { ...options.hooks, draw: [(u) => drawMarks(u, curves, colour)] };
  const uplot = new uPlot(options, columns(curves), html("div"));
  paper.append(uplot.ctx.canvas);
  return {
    remove() {
      uplot.destroy();
      paper.remove();
    },
  };
}

/** What the screen has as elements over the curves: limits of requirements and places of measures. */
function drawMarks(u: uPlot, { curves, levels, marks, uprights = [] }: Curves, colour: Colour): void {
  const { ctx, bbox } = u;
  const size = PAPER.scale * devicePixelRatio;
  clipped(u, () => {
    ctx.font = `${10 * size}px sans-serif`;
    ctx.textAlign = "right";
    ctx.strokeStyle = ctx.fillStyle = colour("warn");
    ctx.lineWidth = size;
    ctx.setLineDash([6 * size, 4 * size]);
    for (const { value, right, text } of levels) {
      const y = u.valToPos(value, right ? "right" : "y", true);
      ctx.stroke(new Path2D(`M${bbox.left} ${y}h${bbox.width}`));
      ctx.fillText(text, bbox.left + bbox.width - 3 * size, y - 3 * size);
    }
    if (!globalThis.WITHOUT_STUDIES) uprights.forEach(({ value, text }, i) => {
      const x = u.valToPos(value, "x", true);
      const late = x > bbox.left + bbox.width / 2;
      ctx.stroke(new Path2D(`M${x} ${bbox.top}v${bbox.height}`));
      ctx.textAlign = late ? "right" : "left";
      ctx.fillText(text, x + (late ? -4 : 4) * size, bbox.top + (12 + 12 * i) * size);
    });
    for (const { curve, x, y } of marks) {
      ctx.fillStyle = colour(colourOf(curves[curve]!, curve));
      ctx.beginPath();
      ctx.arc(u.valToPos(x, "x", true), u.valToPos(y, curves[curve]!.right ? "right" : "y", true), 3 * size, 0, 7);
      ctx.fill();
    }
  });
}
