// What a drawing needs to know once: links by name, pins, guides, and the extents of all the motion.

import { type AreaData, type Centrode, known, type LinkData, type Point, type Scene } from "../scene/data.ts";
import { type Arrow, arrowsOf, type Longest, longestOf } from "./arrows.ts";
import { type Guide, guidesOf, inCylinder, onGuide } from "./guides.ts";
import { type Pin, pinsOf } from "./pins.ts";
import { place, poseOf } from "./poses.ts";

/** How many colours links and curves have; they repeat after that. */
export const PALETTE = 8;

export interface Box {
  x0: number;
  x1: number;
  y0: number;
  y1: number;
}

export interface Facts {
  readonly scene: Scene;
  /** The scene's times; one where it has none. */
  readonly times: readonly number[];
  readonly links: ReadonlyMap<string, LinkData>;
  readonly guides: readonly Guide[];
  readonly pins: readonly Pin[];
  /** All that moves, and with the centrodes. */
  readonly box: Readonly<Box>;
  readonly wide: Readonly<Box>;
  readonly size: number;
  /** By sample: is there a link without a pose? */
  readonly gaps: readonly boolean[];
  /** The colour of each moving link. */
  readonly colour: ReadonlyMap<LinkData, number>;
  readonly areas: readonly AreaData[];
  readonly arrows: readonly Arrow[];
  /** By which arrows are scaled: the longest of each kind. */
  readonly longest: Longest;
}

/** What stays while a scene changes: the extents, and how arrows are scaled. */
export type Kept = Pick<Facts, "box" | "wide" | "size" | "longest">;

/** `kept`: what stays of before, where the scene has only changed. */
export function survey(scene: Scene, kept: Kept | null = null): Facts {
  const times = scene.time.length ? scene.time : [0];
  const links = new Map(scene.links.map((link) => [link.name, link]));
  const guides = guidesOf(scene, links, times);
  const { areas = [] } = scene;
  const gaps = scene.open ?? times.map((_, k) => scene.links.some((link) => !poseOf(link, times, k)));
  const moving = scene.links.filter((link) => !link.fixed);
  const colour = new Map(moving.map((link, i) => [link, i % PALETTE]));
  const pins = pinsOf(scene).filter((pin) => pin.joints.length || !ofCylinder(pin, guides));
  const { box, wide, size } = kept ?? extents(scene, guides, times);
  const arrows = arrowsOf(scene, links);
  const longest = kept?.longest ?? longestOf(arrows);
  return { scene, times, links, guides, pins, box, wide, size, gaps, colour, areas, arrows, longest };
}

/** The extents that hold two scenes. */
export function together(a: Facts, b: Facts): Pick<Facts, "box" | "wide" | "size"> {
  const union = (p: Box, q: Box): Box => ({
    x0: Math.min(p.x0, q.x0),
    x1: Math.max(p.x1, q.x1),
    y0: Math.min(p.y0, q.y0),
    y1: Math.max(p.y1, q.y1),
  });
  return { box: union(a.box, b.box), wide: union(a.wide, b.wide), size: Math.max(a.size, b.size) };
}

function extents(
  scene: Scene,
  guides: readonly Guide[],
  times: readonly number[],
): Pick<Facts, "box" | "wide" | "size"> {
  const { areas = [], centrodes = [] } = scene;
  const box: Box = { x0: Infinity, x1: -Infinity, y0: Infinity, y1: -Infinity };
  for (const at of reached(scene, guides, times)) include(box, at);
  for (const trace of scene.traces) includeRows(box, trace);
  for (const ring of areas.flatMap((area) => area.rings)) for (const at of ring) include(box, at);
  if (box.x0 > box.x1) Object.assign(box, { x0: -1, x1: 1, y0: -1, y1: 1 });
  const wide = { ...box };
  for (const centrode of centrodes) includeRows(wide, centrode);
  return { box, wide, size: Math.max(box.x1 - box.x0, box.y1 - box.y0) || 1 };
}

/** All places in the world that links and guides reach at the samples. */
function* reached(scene: Scene, guides: readonly Guide[], times: readonly number[]): Generator<Point> {
  for (let k = 0; k < times.length; k++) {
    for (const link of scene.links) {
      const pose = poseOf(link, times, k);
      if (!pose) continue;
      for (const local of Object.values(link.points)) yield place(pose, local);
      for (const line of link.outlines ?? []) for (const local of line) yield place(pose, local);
    }
    for (const { guide, low, high } of guides) {
      const pose = poseOf(guide.link, times, k);
      if (pose) for (const travel of [low, high]) yield place(pose, onGuide(guide, travel));
    }
  }
}

function include(box: Box, [x, y]: Point): void {
  [box.x0, box.x1] = [Math.min(box.x0, x), Math.max(box.x1, x)];
  [box.y0, box.y1] = [Math.min(box.y0, y), Math.max(box.y1, y)];
}

function includeRows(box: Box, { x, y }: Pick<Centrode, "x" | "y">): void {
  for (let k = 0; k < x.length; k++) {
    const [each, up] = [known(x, k), known(y, k)];
    if (each !== null && up !== null) include(box, [each, up]);
  }
}

/** Whether a point is the end of a barrel or rod, which the symbol of a cylinder shows. */
const ofCylinder = ({ places }: Pin, guides: readonly Guide[]): boolean =>
  places.some(({ link }) => inCylinder(guides, link));

/** The class of a link's colour. */
export const colourOf = (facts: Facts, link: LinkData): string => `lw-c${facts.colour.get(link)}`;

/** The class of a path's colour: those after the links' own. */
export const traceColour = (facts: Facts, i: number): string => `lw-c${(facts.colour.size + i) % PALETTE}`;
