// One button per series: shows its line and its value at the cursor, and hides or shows it.

import type uPlot from "uplot";
import { html, svg } from "../drawing/elements.ts";
import type { Plot } from "../scene/data.ts";
import { colourName, dash } from "./looks.ts";

/** Fills the box; gives the places of the values. */
export function legend(box: Element, plot: Plot, chart: uPlot): HTMLOutputElement[] {
  return plot.series.map((series, i) => {
    const button = html("button", { type: "button", "aria-pressed": "true" }, box);
    button.append(swatch(i));
    html("span", {}, button, series.name);
    const value = html("output", { "aria-live": "off" }, button);
    button.addEventListener("click", () => {
      const show = button.getAttribute("aria-pressed") !== "true";
      button.setAttribute("aria-pressed", String(show));
      chart.setSeries(i + 1, { show });
    });
    return value;
  });
}

function swatch(i: number): SVGSVGElement {
  const drawing = svg("svg", { viewBox: "0 0 26 8", "aria-hidden": "true" });
  const line = svg("path", { d: "M0 4H26", "stroke-dasharray": dash(i).join(" ") }, drawing);
  line.style.stroke = `var(--lw-${colourName(i)})`;
  return drawing;
}
