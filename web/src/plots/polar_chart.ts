// A polar plot on the page.

import { html, svg } from "../drawing/elements.ts";
import { HEIGHT } from "./chart.ts";
import type { Curves } from "./curves.ts";
import { arrows, polarSvg } from "./polar.ts";

export interface PolarChart {
  show(curves: Curves): void;
  /** Turns the arrows to those of a sample. */
  follow(index: number): void;
  remove(): void;
}

export function polarChart(area: HTMLElement, first: Curves, label: string): PolarChart {
  const box = html("div", { class: "polar lw" }, area);
  const picture = svg("svg", { role: "img", "aria-label": label }, box);
  let curves = first;
  let index = 0;
  let width = 0;
  const colour = (name: string): string => `var(--lw-${name})`;
  const show = (changed: Curves): void => {
    curves = changed;
    width = area.clientWidth || 400;
    picture.setAttribute("viewBox", `0 0 ${width} ${HEIGHT}`);
    picture.innerHTML = polarSvg(curves, index, { width, height: HEIGHT, colour });
  };
  show(first);
  return {
    show,
    follow(sample) {
      index = sample;
      const paths = arrows(curves.vectors, index, width, HEIGHT);
      picture.querySelectorAll(".arrow").forEach((path, i) => path.setAttribute("d", paths[i] ?? ""));
    },
    remove: () => box.remove(),
  };
}
