// Names of pins and links, kept clear of what they name.

import type { LinkData, Point } from "../scene/data.ts";
import { clamp } from "../scene/numbers.ts";
import { measured, type Placed, textBox } from "./crowding.ts";
import { set, svg, write } from "./elements.ts";
import { hull, mean, widestGap } from "./geometry.ts";
import { BLOCK, onGuide } from "./guides.ts";
import type { Pin, Spot } from "./pins.ts";
import { type Pose, place, poseOf } from "./poses.ts";
import { colourOf, type Facts } from "./survey.ts";
import type { Move, View } from "./view.ts";
import { round } from "./written.ts";

/** A text, the place that it belongs to, and how far off it stands, in pixels. */
interface Label extends Placed {
  readonly at: Spot;
  /** Half the text's width, near enough; 0 where it may leave the drawing. */
  readonly half: number;
  readonly width: number;
  readonly anchor: "start" | "middle" | "end";
  readonly offset: (pose: Pose) => Point;
}

export interface Labels {
  readonly move: Move;
  readonly pins: readonly Placed[];
  readonly links: readonly Placed[];
  readonly directions: ReadonlyMap<string, number>;
}

/** `kept`: where names of pins stood before: while numbers change they stay on their sides. */
export function labels(
  facts: Facts,
  view: View,
  r: number,
  parent: Element,
  kept: Labels["directions"] = new Map(),
): Labels {
  const directions = new Map(facts.pins.map((pin) => [pin.name, kept.get(pin.name) ?? labelDirection(pin, facts)]));
  const every = facts.pins.map((pin) => ({ pin, label: pinLabel(pin, directions.get(pin.name)!, r, parent) }));
  const joined = every.filter(({ pin }) => pin.joints.length).map(({ label }) => label);
  const pins = [...joined, ...every.filter(({ pin }) => !pin.joints.length).map(({ label }) => label)];
  const links = facts.scene.links.flatMap((link) => {
    const label = link.fixed ? null : linkLabel(link, facts, r, parent);
    return label ? [label] : [];
  });
  const move: Move = (sample, f) => {
    for (const label of [...pins, ...links]) {
      const { text, at, half, anchor, offset } = label;
      const pose = poseOf(at.link, facts.times, sample, f);
      label.boxes = [];
      if (!pose) continue;
      const [x, y] = view.toScreen(place(pose, at.local));
      const [dx, dy] = offset(pose);
      const into = (at: number): number => (half ? clamp(at, half + 4, view.width - half - 4) : at);
      const inside = into(x + dx);
      set(text, "x", round(inside));
      set(text, "y", round(y + dy));
      const box = textBox(label.width, inside, y + dy, anchor);
      label.boxes = half && (dx || dy) ? [box, { ...box, x: into(x - dx), y: y - dy }] : [box];
    }
  };
  return { move, pins, links, directions };
}

function pinLabel(pin: Pin, direction: number, r: number, parent: Element): Label {
  const [dx, dy] = [Math.cos(direction), Math.sin(direction)];
  const anchor = dx > 0.3 ? "start" : dx < -0.3 ? "end" : "middle";
  const text = svg("text", { class: "lw-label", "text-anchor": anchor, dy: "0.35em" }, parent);
  write(text, pin.name);
  const offset = (): Point => [dx * (r + 7), dy * (r + 9)];
  return { text, boxes: [], at: pin.places[0], half: 0, width: measured(text), anchor, offset };
}

/** The direction (one of eight, screen radians) in which a pin's label meets its links least. */
function labelDirection(pin: Pin, facts: Facts): number {
  const busy = busyDirections(pin, facts);
  if (pin.places.some(({ link }) => link.fixed)) for (const a of [0.9, 1.57, 2.24]) busy.push(a, a, a); // its symbol
  const cost = (direction: number) =>
    busy.reduce((sum, angle) => sum + Math.max(0, Math.cos(angle - direction)) ** 3, 0);
  const choices = [-1, -3, 1, 3, 0, 4, -2, 2].map((eighth) => (eighth * Math.PI) / 4);
  return choices.reduce((best, choice) => (cost(choice) < cost(best) - 1e-9 ? choice : best));
}

/** Where the links of a pin reach from it, over the motion (screen radians). */
function busyDirections(pin: Pin, facts: Facts): number[] {
  const busy: number[] = [];
  const step = Math.max(1, Math.floor(facts.times.length / 16));
  for (let k = 0; k < facts.times.length; k += step) {
    for (const { link, local } of pin.places) {
      const pose = poseOf(link, facts.times, k);
      if (!pose || link.fixed) continue;
      const here = place(pose, local);
      for (const other of Object.values(link.points)) {
        const [x, y] = place(pose, other);
        if (Math.hypot(x - here[0], y - here[1]) > 1e-6 * facts.size) {
          busy.push(Math.atan2(-(y - here[1]), x - here[0]));
        }
      }
    }
  }
  return busy;
}

/** A link's name: in the middle of a plate, along the side of a bar or a slide. */
function linkLabel(link: LinkData, facts: Facts, r: number, parent: Element): Label | null {
  const points = Object.values(link.points);
  const ring = hull(points);
  const [a, b] = ring;
  if (!a) return null;
  const riding = facts.guides.find(({ block }) => block.link === link);
  const slide = riding ?? facts.guides.find(({ guide }) => guide.link === link);
  const side = riding ? riding.block : slide?.guide;
  let middle = mean(ring);
  if (b && ring.length === 2) middle = widestGap([a, b], points);
  else if (slide?.cylinder && side === slide.guide) middle = onGuide(side, (slide.low + slide.high) / 4);
  const look = `lw-label lw-name ${slanted(link.name)} ${colourOf(facts, link)}`;
  const text = svg("text", { class: look, "text-anchor": "middle", dy: "0.35em" }, parent);
  write(text, link.name);
  const along = b ? Math.atan2(b[1] - a[1], b[0] - a[0]) : (side?.angle ?? 0);
  const away = b ? r + 3 : BLOCK.height / 2 + 6;
  const half = 3.2 * link.name.length;
  const offset = (pose: Pose): Point => {
    if (ring.length > 2) return [0, 0];
    const across = Math.atan2(pose.s, pose.c) + along - Math.PI / 2;
    return [Math.cos(across) * (away + half), -Math.sin(across) * (away + 7)];
  };
  return { text, boxes: [], at: { link, local: middle }, half, width: measured(text), anchor: "middle", offset };
}

/** The class of a slanted name: Latin names are slanted, hanzi have no slanted form. */
const slanted = (name: string): string => (/^[ -\u024f]*$/.test(name) ? "lw-slanted" : "");
