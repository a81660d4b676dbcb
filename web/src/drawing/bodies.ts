// The moving links: bars and plates, slots, blocks, cylinders, lines of cams.

import type { LinkData, Point } from "../scene/data.ts";
import { svg } from "./elements.ts";
import { hull, outline } from "./geometry.ts";
import { BLOCK, type Guide, inCylinder, onGuide, type Side } from "./guides.ts";
import { poseOf } from "./poses.ts";
import { colourOf, type Facts } from "./survey.ts";
import { type Move, putShape, type View } from "./view.ts";
import { degrees, inPath, round } from "./written.ts";

/** From a link's axes to pixels in them, y down. */
type ToPixels = (local: Point) => Point;

/** Shapes of all moving links in layers under `parent`: slots lowest, blocks on top. `r`: half a bar's width. */
export function bodies(facts: Facts, view: View, r: number, parent: Element): Move {
  const toPixels: ToPixels = ([x, y]) => [view.k * x, -view.k * y];
  const layers = {
    slots: svg("g", { class: "lw-slots" }, parent),
    bodies: svg("g", { class: "lw-bodies" }, parent),
    blocks: svg("g", { class: "lw-blocks" }, parent),
  };
  const outlines = (link: LinkData, layer: Element) => {
    for (const line of link.outlines ?? []) {
      const d = line.map((at) => inPath(toPixels(at))).join("L");
      svg("path", { class: "lw-slot lw-outline", d: `M${d}Z` }, layer);
    }
  };
  const fixed = facts.scene.links
    .filter((link) => link.fixed && link.outlines?.length)
    .map((link) => {
      const group = svg("g", { class: "lw-on-frame" }, layers.slots);
      outlines(link, group);
      return { link, groups: [group] };
    });
  const moving = facts.scene.links
    .filter((link) => !link.fixed)
    .map((link) => {
      const inLayer = (layer: Element) => svg("g", { class: colourOf(facts, link) }, layer);
      const groups = [inLayer(layers.slots), inLayer(layers.bodies), inLayer(layers.blocks)] as const;
      const [slots, body] = groups;
      const sliding = slides(facts, link, toPixels, view.k, groups);
      outlines(link, slots);
      const points = Object.values(link.points).map(toPixels);
      const ring = hull(points).length;
      const drawn = inCylinder(facts.guides, link) ? ring > 2 : ring > 1 || !sliding;
      if (drawn) svg("path", { class: "lw-body", d: outline(points, r) }, body);
      return { link, groups: groups.filter((group) => group.hasChildNodes()) };
    });
  return (sample, f) => {
    for (const { link, groups } of [...fixed, ...moving]) {
      const pose = poseOf(link, facts.times, sample, f);
      for (const group of groups) putShape(group, pose, view);
    }
  };
}

/** What a link has of prismatic joints; whether there is any. */
function slides(
  facts: Facts,
  link: LinkData,
  toPixels: ToPixels,
  k: number,
  [slots, body, blocks]: readonly [Element, Element, Element],
): boolean {
  let found = false;
  for (const joint of facts.guides) {
    for (const side of [joint.guide, joint.block].filter((each) => each.link === link)) {
      found = true;
      if (joint.cylinder) cylinder(side, joint, k, toPixels, side === joint.guide ? body : slots);
      else if (side === joint.guide) slot(joint, toPixels, slots);
      else block(side, toPixels, blocks);
    }
  }
  return found;
}

function slot({ guide, low, high }: Guide, toPixels: ToPixels, parent: Element): void {
  const ends = [low, high].map((travel) => toPixels(onGuide(guide, travel)));
  svg("path", { class: "lw-slot", d: outline(ends, BLOCK.height / 2 + 3) }, parent);
}

function block(side: Side, toPixels: ToPixels, parent: Element): void {
  const transform = `translate(${inPath(toPixels(side.local))}) rotate(${degrees(side.angle)})`;
  const { length: width, height } = BLOCK;
  svg("rect", { class: "lw-block", x: -width / 2, y: -height / 2, width, height, rx: 2, transform }, parent);
}

/** Barrel (on the guide's link) or rod and piston (on the block's) of a cylinder, for its whole travel. */
function cylinder(side: Side, { low, high, guide }: Guide, k: number, toPixels: ToPixels, parent: Element): void {
  const forward = Math.abs(high) >= Math.abs(low);
  const [near, far] = [Math.abs(forward ? low : high) * k, Math.abs(forward ? high : low) * k];
  const isBarrel = side === guide;
  const turn = side.angle + (forward === isBarrel ? 0 : Math.PI);
  const transform = `translate(${inPath(toPixels(side.local))}) rotate(${degrees(turn)})`;
  const axes = svg("g", { transform }, parent);
  if (isBarrel) {
    const width = round(Math.max(near - 14, 20));
    svg("rect", { class: "lw-body", x: 0, y: -10, width, height: 20, rx: 3 }, axes);
  } else {
    const length = round(far - near + 24);
    svg("path", { class: "lw-rod", d: `M0 0H${length}` }, axes);
    svg("rect", { class: "lw-piston", x: length - 3, y: -8, width: 6, height: 16 }, axes);
  }
}
