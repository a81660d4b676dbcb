// Springs between points of links: coils, and struts as barrel and rod.

import type { Point, SpringLook } from "../scene/data.ts";
import { set, shown, svg } from "./elements.ts";
import type { Spot } from "./pins.ts";
import { place, poseOf } from "./poses.ts";
import type { Facts } from "./survey.ts";
import type { Move, View } from "./view.ts";
import { round } from "./written.ts";

const TEETH = 12;

/** `r`: how far a coil reaches to either side, in pixels. */
export function springs(facts: Facts, view: View, r: number, parent: Element): Move {
  const parts = (facts.scene.springs ?? []).map(({ name, look, links, points }) => {
    const end = (i: 0 | 1) => {
      const link = facts.links.get(links[i])!;
      return { link, local: link.points[points[i]]! };
    };
    const path = svg("path", { class: "lw-spring", "data-spring": name }, parent);
    const [from, to] = [end(0), end(1)];
    return { path, look, from, to, barrel: look === "strut" ? view.k * barrelOf(from, to, facts.times) : 0 };
  });
  return (sample, f) => {
    for (const { path, look, from, to, barrel } of parts) {
      const poses = [poseOf(from.link, facts.times, sample, f), poseOf(to.link, facts.times, sample, f)] as const;
      const there = poses[0] !== null && poses[1] !== null;
      shown(path, there);
      if (!there) continue;
      const start = view.toScreen(place(poses[0], from.local));
      const stop = view.toScreen(place(poses[1], to.local));
      set(path, "d", springPath(start, stop, look, r, barrel));
    }
  };
}

/** How long a strut's barrel is: it holds the rod at its shortest, and reaches no farther than that. */
export function barrelOf(from: Spot, to: Spot, times: readonly number[]): number {
  let [least, most] = [Infinity, 0];
  for (let k = 0; k < times.length; k++) {
    const [one, other] = [poseOf(from.link, times, k), poseOf(to.link, times, k)];
    if (!one || !other) continue;
    const [a, b] = [place(one, from.local), place(other, to.local)];
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    [least, most] = [Math.min(least, length), Math.max(most, length)];
  }
  return most ? Math.min(0.92 * least, 0.6 * most) : 0;
}

/** A spring between two places on the screen: a coil, or rod and barrel, which has its own length, of a strut. */
export function springPath([x0, y0]: Point, [x1, y1]: Point, look: SpringLook, r: number, barrel: number): string {
  const length = Math.hypot(x1 - x0, y1 - y0) || 1;
  const [ux, uy] = [(x1 - x0) / length, (y1 - y0) / length];
  const at = (share: number, across: number): string => {
    const along = share * length;
    return `${round(x0 + along * ux - across * uy)} ${round(y0 + along * uy + across * ux)}`;
  };
  if (look === "strut") {
    const w = 0.7 * r;
    const [begin, end] = [Math.min(1.6 * r, 0.3 * barrel) / length, Math.min(barrel / length, 0.95)];
    const tube = `M${at(begin, -w)}L${at(end, -w)}L${at(end, w)}L${at(begin, w)}Z`;
    return `M${at(0, 0)}L${at(begin, 0)}${tube}M${at(end, 0)}L${at(1, 0)}`;
  }
  const coil = Array.from({ length: TEETH }, (_, i) => `L${at(0.15 + (0.7 * (i + 0.5)) / TEETH, i % 2 ? r : -r)}`);
  return `M${at(0, 0)}L${at(0.15, 0)}${coil.join("")}L${at(0.85, 0)}L${at(1, 0)}`;
}
