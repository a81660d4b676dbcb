// Paths of points, areas behind the mechanism, and centrodes: what can be switched on and off.

import { known, type Point, type Values } from "../scene/data.ts";
import { svg } from "./elements.ts";
import { poseOf, spot } from "./poses.ts";
import { colourOf, type Facts, PALETTE, traceColour } from "./survey.ts";
import { type Move, putCircle, putShape, type View } from "./view.ts";
import { inPath } from "./written.ts";

/** Groups of the drawing in the order of the scene's list, and what moves in them. */
export interface Layer {
  readonly groups: readonly SVGGElement[];
  readonly move: Move;
}

/** Radius of the dot that runs along a path, in pixels. */
const DOT = 3.4;

/** A line through points, interrupted where there is none. */
export function linePath(xs: Values, ys: Values, toScreen: (at: Point) => Point): string {
  let d = "";
  let pen = false;
  for (let i = 0; i < xs.length; i++) {
    const [x, y] = [known(xs, i), known(ys, i)];
    const here = x !== null && y !== null;
    if (here) d += `${pen ? "L" : "M"}${inPath(toScreen([x, y]))}`;
    pen = here;
  }
  return d;
}

export function areas(facts: Facts, view: View, parent: Element): SVGGElement[] {
  return facts.areas.map(({ rings }, i) => {
    const group = svg("g", { class: `lw-area lw-c${i % PALETTE}` }, parent);
    const d = rings.map((ring) => `M${ring.map((at) => inPath(view.toScreen(at))).join("L")}Z`);
    svg("path", { d: d.join("") }, group);
    return group;
  });
}

/** The paths with their dots; one that isn't of the scene's times has none. */
export function traces(facts: Facts, view: View, parent: Element): Layer {
  const parts = facts.scene.traces.map((trace, i) => {
    const group = svg("g", { class: `lw-trace ${traceColour(facts, i)}` }, parent);
    svg("path", { d: linePath(trace.x, trace.y, view.toScreen) }, group);
    return { trace, group, dot: svg("circle", { r: DOT }, group) };
  });
  const move: Move = (sample, f) => {
    for (const { trace, dot } of parts) {
      const same = trace.x.length === facts.times.length;
      const at = same ? spot(trace.x, trace.y, facts.times, sample, f) : null;
      putCircle(dot, at && view.toScreen(at));
    }
  };
  return { groups: parts.map(({ group }) => group), move };
}

/** The fixed and the moving centrode of those links that are `chosen`, and their instant centres. */
export function centrodes(facts: Facts, view: View, chosen: readonly boolean[], parent: Element): Move {
  const seen = chosen.includes(true) ? (facts.scene.centrodes ?? []).filter((_, i) => chosen[i]) : [];
  const parts = seen.map((centrode) => {
    const link = facts.links.get(centrode.link)!;
    const group = svg("g", { class: `lw-centrode ${colourOf(facts, link)}` }, parent);
    svg("path", { class: "lw-fixed", d: linePath(centrode.x, centrode.y, view.toScreen) }, group);
    const local = ([u, v]: Point): Point => [view.k * u, -view.k * v];
    const moving = svg("path", { class: "lw-moving", d: linePath(centrode.u, centrode.v, local) }, group);
    return { link, centrode, moving, dot: svg("circle", { r: DOT }, group) };
  });
  return (sample, f) => {
    for (const { link, centrode, moving, dot } of parts) {
      putShape(moving, poseOf(link, facts.times, sample, f), view);
      const at = spot(centrode.x, centrode.y, facts.times, sample, f);
      putCircle(dot, at && view.toScreen(at));
    }
  };
}
