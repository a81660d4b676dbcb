// What measures say, over the curves of a plot: limits of requirements as lines, places as dots that lead there.

import type uPlot from "uplot";
import { svg } from "../drawing/elements.ts";
import type { Curves, Mark } from "./curves.ts";
import { colourOf } from "./looks.ts";
import "./of_studies.ts";
import type { Level } from "./signals.ts";

export interface MarkLayer {
  update(u: uPlot, curves: Curves): void;
}

/** Limits of both axes. */
const linesOf = ({ levels, uprights }: Curves): readonly Level[] =>
  !globalThis.WITHOUT_STUDIES && uprights ? [...levels, ...uprights] : levels;

export function markLayer(over: HTMLElement, goTo: (time: number) => void): MarkLayer {
  let root: SVGSVGElement | null = null;
  let made = "";
  let marks: readonly Mark[] = [];
  const build = (curves: Curves): void => {
    root ??= svg("svg", { class: "plot-marks lw" }, over);
    root.replaceChildren();
    for (const level of linesOf(curves)) {
      const line = svg("g", { class: "level" }, root);
      svg("path", {}, line);
      svg("text", {}, line).textContent = level.text;
    }
    curves.marks.forEach((mark, i) => {
      const dot = svg("g", { class: "place", role: "button", tabindex: 0, "aria-label": mark.text }, root);
      svg("title", {}, dot).textContent = mark.text;
      svg("circle", { r: 11, class: "reach" }, dot);
      svg("circle", { r: 4 }, dot).style.fill = `var(--lw-${colourOf(curves.curves[mark.curve]!, mark.curve)})`;
      const act = (event: Event): void => {
        event.preventDefault();
        event.stopPropagation();
        goTo(marks[i]!.time);
      };
      dot.addEventListener("pointerdown", (event) => event.stopPropagation());
      dot.addEventListener("click", act);
      dot.addEventListener("keydown", (event) => {
        if (event.key === "Enter" || event.key === " ") act(event);
      });
    });
  };
  return {
    update(u, curves) {
      marks = curves.marks;
      const dots = marks.map((each) => [each.text, each.curve]);
      const lines = linesOf(curves);
      const key = JSON.stringify([lines.map((each) => each.text), dots]);
      if (key !== made && (marks.length || lines.length || root)) build(curves);
      made = key;
      if (!root) return;
      // Not those of the element, which would lay out the page anew.
      const [width, height] = [u.bbox.width / devicePixelRatio, u.bbox.height / devicePixelRatio];
      const groups = [...root.children] as SVGGElement[];
      curves.levels.forEach(({ value, right }, i) => {
        const y = u.valToPos(value, right ? "right" : "y");
        const group = groups[i]!;
        group.style.display = y >= 0 && y <= height ? "" : "none";
        group.firstElementChild!.setAttribute("d", `M0 ${y}H${width}`);
        const text = group.lastElementChild!;
        text.setAttribute("x", String(width - 3));
        text.setAttribute("y", String(y > 14 ? y - 4 : y + 12));
      });
      if (!globalThis.WITHOUT_STUDIES) curves.uprights?.forEach(({ value }, i) => {
        const x = u.valToPos(value, "x");
        const group = groups[curves.levels.length + i]!;
        group.style.display = x >= 0 && x <= width ? "" : "none";
        group.firstElementChild!.setAttribute("d", `M${x} 0V${height}`);
        const text = group.lastElementChild as SVGElement;
        text.style.textAnchor = x > width / 2 ? "end" : "start";
        text.setAttribute("x", String(x > width / 2 ? x - 4 : x + 4));
        text.setAttribute("y", String(12 + 14 * i));
      });
      marks.forEach((mark, i) => {
        const group = groups[lines.length + i]!;
        const right = curves.curves[mark.curve]!.right;
        const [x, y] = [u.valToPos(mark.x, "x"), u.valToPos(mark.y, right ? "right" : "y")];
        const hidden = u.series[mark.curve + 1]?.show === false || x < -1 || x > width + 1 || !Number.isFinite(y);
        group.style.display = hidden ? "none" : "";
        group.setAttribute("transform", `translate(${x} ${y})`);
      });
    },
  };
}
