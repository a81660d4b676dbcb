// Pins that are open, because their links can't close: a dotted line from one link to the other, with its length.

import type { Point } from "../scene/data.ts";
import { set, shown, svg, write } from "./elements.ts";
import { place, poseOf } from "./poses.ts";
import type { Facts } from "./survey.ts";
import type { Move, View } from "./view.ts";
import { inPath, round } from "./written.ts";

/** The least opening that is shown, over the mechanism's size: below it lies round-off. */
const LEAST = 1e-6;

export function openings(facts: Facts, view: View, parent: Element): Move {
  if (!facts.scene.open?.includes(true)) return () => {};
  const parts = facts.pins
    .filter((pin) => pin.places.length > 1)
    .map((pin) => {
      const group = svg("g", { class: "lw-opening" }, parent);
      const line = svg("path", {}, group);
      const ends = [svg("circle", { r: 4.5 }, group), svg("circle", { r: 4.5 }, group)] as const;
      return { pin, group, line, ends, text: svg("text", { "text-anchor": "middle" }, group) };
    });
  return (sample, f) => {
    for (const { pin, group, line, ends, text } of parts) {
      const places = pin.places.map(({ link, local }): Point | null => {
        const pose = poseOf(link, facts.times, sample, f);
        return pose && place(pose, local);
      });
      const from = places[0];
      const to = farthest(from, places);
      const gap = from && to ? Math.hypot(to[0] - from[0], to[1] - from[1]) : 0;
      shown(group, gap > LEAST * facts.size);
      if (!from || !to || gap <= LEAST * facts.size) continue;
      const [a, b] = [view.toScreen(from), view.toScreen(to)];
      set(line, "d", `M${inPath(a)}L${inPath(b)}`);
      [a, b].forEach(([x, y], i) => {
        set(ends[i]!, "cx", round(x));
        set(ends[i]!, "cy", round(y));
      });
      set(text, "x", round((a[0] + b[0]) / 2));
      set(text, "y", round((a[1] + b[1]) / 2 - 8));
      write(text, `${Number(gap.toPrecision(4))} ${facts.scene.length_unit}`);
    }
  };
}

function farthest(from: Point | null | undefined, places: readonly (Point | null)[]): Point | null {
  if (!from) return null;
  const off = (at: Point): number => Math.hypot(at[0] - from[0], at[1] - from[1]);
  return places.reduce<Point | null>((best, at) => (at && (!best || off(at) > off(best)) ? at : best), null);
}
