// Lengths of bars and angles of driven links, as thin lines with quiet texts.

import type { Point } from "../scene/data.ts";
import { type Bar, barsOf, type Turned, turnedOf } from "./bars.ts";
import { type Placed, textBox, widthOf } from "./crowding.ts";
import { set, shown, svg, write } from "./elements.ts";
import { place, poseOf } from "./poses.ts";
import type { Spot } from "./pins.ts";
import type { Facts } from "./survey.ts";
import type { Move, View } from "./view.ts";
import { inPath, round } from "./written.ts";

/** How far a line stands off its bar, and the radius of an angle's arc, in pixels. */
const OFF = 15;
const ARC = 30;

export interface Dimensions {
  readonly move: Move;
  /** The texts, those of angles first. */
  readonly texts: readonly Placed[];
}

/** `original`: the mechanism as it was, whose values stand before changed ones. */
export function dimensionLines(facts: Facts, original: Facts | null, view: View, parent: Element): Dimensions {
  const line = () => svg("path", { class: "lw-dimension" }, parent);
  const text = () => svg("text", { class: "lw-measure", "text-anchor": "middle", dy: "0.35em" }, parent);
  const part = () => ({ line: line(), placed: { text: text(), boxes: [] } as Placed });
  const angles = turnedOf(facts).map((turned, i) => ({ turned, before: original && turnedOf(original)[i], ...part() }));
  const old = original && barsOf(original);
  const bars = barsOf(facts).map((bar, i) => ({ bar, before: old?.[i], ...part() }));
  const move: Move = (sample, f) => {
    const at = (spot: Spot): Point | null => {
      const pose = poseOf(spot.link, facts.times, sample, f);
      return pose && place(pose, spot.local);
    };
    for (const { bar, before, line, placed } of bars) {
      const [a, b] = [at(bar.from), at(bar.to)];
      const was = before && original ? lengthOf(before, original, sample, f) : null;
      const there = a && b && lengthLine(view.toScreen(a), view.toScreen(b));
      lay(line, placed, there, a && b ? changed(Math.hypot(b[0] - a[0], b[1] - a[1]), was) : "");
    }
    for (const { turned, before, line, placed } of angles) {
      const vertex = at(turned.at);
      const angle = angleOf(turned, facts, sample, f);
      const was = before && original ? angleOf(before, original, sample, f) : null;
      const there = vertex && angle && angleLine(view.toScreen(vertex), angle.from, angle.by);
      lay(line, placed, there, angle ? `${changed(degrees(angle.by), was && degrees(was.by), 4)}°` : "");
    }
  };
  return { move, texts: [...angles, ...bars].map(({ placed }) => placed) };
}

interface Line {
  readonly d: string;
  readonly middle: Point;
}

function lay(line: SVGPathElement, placed: Placed, there: Line | null, text: string): void {
  shown(line, there !== null);
  placed.boxes = [];
  if (!there) return;
  set(line, "d", there.d);
  const [x, y] = there.middle;
  write(placed.text, text);
  set(placed.text, "x", round(x));
  set(placed.text, "y", round(y));
  placed.boxes = [textBox(widthOf(text), x, y)];
}

/** A line beside a bar on the screen, on its left, with a stroke across each end. */
export function lengthLine([x0, y0]: Point, [x1, y1]: Point): Line | null {
  const length = Math.hypot(x1 - x0, y1 - y0);
  if (length < 8) return null;
  const [ux, uy] = [(x1 - x0) / length, (y1 - y0) / length];
  const at = (along: number, across: number): Point => [x0 + along * ux + across * uy, y0 + along * uy - across * ux];
  const stroke = (along: number): string => `M${inPath(at(along, OFF - 4))}L${inPath(at(along, OFF + 4))}`;
  const d = `M${inPath(at(0, OFF))}L${inPath(at(length, OFF))}${stroke(0)}${stroke(length)}`;
  return { d, middle: at(length / 2, OFF) };
}

/** An arc around a place on the screen, from a direction of the world by an angle, and the direction's own line. */
export function angleLine([x, y]: Point, from: number, by: number): Line {
  const at = (angle: number, radius: number): Point => [x + radius * Math.cos(angle), y - radius * Math.sin(angle)];
  const arc = `A${ARC} ${ARC} 0 ${Math.abs(by) > Math.PI ? 1 : 0} ${by > 0 ? 0 : 1} ${inPath(at(from + by, ARC))}`;
  const d = `M${inPath([x, y])}L${inPath(at(from, ARC + 12))}M${inPath(at(from, ARC))}${arc}`;
  return { d, middle: at(from + by / 2, ARC + 16) };
}

function lengthOf({ from, to }: Bar, facts: Facts, sample: number, f: number): number | null {
  const [one, other] = [poseOf(from.link, facts.times, sample, f), poseOf(to.link, facts.times, sample, f)];
  if (!one || !other) return null;
  const [a, b] = [place(one, from.local), place(other, to.local)];
  return Math.hypot(b[0] - a[0], b[1] - a[1]);
}

/** The direction of a link's x axis from that of another, within half a turn. */
function angleOf({ link, on }: Turned, facts: Facts, k: number, f: number): { from: number; by: number } | null {
  const [one, other] = [poseOf(link, facts.times, k, f), poseOf(on, facts.times, k, f)];
  if (!one || !other) return null;
  const by = Math.atan2(other.c * one.s - other.s * one.c, other.c * one.c + other.s * one.s);
  return { from: Math.atan2(other.s, other.c), by };
}

const degrees = (angle: number): number => (angle * 180) / Math.PI;

/** A value, after the one that it was if that is another. */
export function changed(value: number, was: number | null, digits = 5): string {
  const [now, before] = [figure(value, digits), was === null ? null : figure(was, digits)];
  return before === null || before === now ? now : `${before} → ${now}`;
}

/** A value as drawings have it. */
export function figure(value: number, digits = 5): string {
  const rounded = Number(value.toPrecision(digits));
  return String(Math.abs(rounded) < 1e-9 ? 0 : rounded).replace("-", "−");
}
