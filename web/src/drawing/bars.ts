// What is dimensioned in a drawing: distances between the pins of a link, and the angles of driven links.

import type { LinkData, Point } from "../scene/data.ts";
import { hull } from "./geometry.ts";
import type { Pin, Spot } from "./pins.ts";
import type { Facts } from "./survey.ts";

/** A distance between two places: of one link, or of the two links of a cylinder. */
export interface Bar {
  readonly from: Spot;
  readonly to: Spot;
}

/** The distances between neighbouring pins of links, bars before plates, then the lengths of cylinders and springs. */
export function barsOf(facts: Facts): Bar[] {
  const { links, springs = [] } = facts.scene;
  const of = links.map((link) => between(ends(facts, link)).map(([a, b]) => ({ link, a, b })));
  const found = of.filter((sides) => !sides[0]?.link.fixed || sides.length < 2).sort((a, b) => a.length - b.length);
  const bars = found.flat().map(({ link, a, b }): Bar => ({ from: { link, local: a }, to: { link, local: b } }));
  const cylinders = facts.guides.filter(({ cylinder }) => cylinder);
  const spots = springs.map((spring) =>
    spring.links.map((name, i): Spot => {
      const link = facts.links.get(name)!;
      return { link, local: link.points[spring.points[i]!]! };
    }),
  );
  return [
    ...bars,
    ...cylinders.map(({ guide, block }): Bar => ({ from: guide, to: block })),
    ...spots.map(([from, to]): Bar => ({ from: from!, to: to! })),
  ];
}

/** What is dimensioned of a link: its pins; of one that has a single pin, its points. */
function ends(facts: Facts, link: LinkData): Point[] {
  const pins = pinned(facts, link);
  const points = Object.values(link.points);
  const slides = facts.guides.some(({ guide, block }) => guide.link === link || block.link === link);
  return pins.length < 2 && !link.fixed && !slides && points.length <= 4 ? points : pins;
}

/** The places of a link's pins in its axes. */
const pinned = (facts: Facts, link: LinkData): Point[] =>
  facts.pins
    .filter((pin) => pin.joints.length)
    .flatMap((pin) => pin.places.filter((each) => each.link === link).map(({ local }) => local));

/** Neighbouring places: along a line, or around a plate, which then lies on the right. */
export function between(points: readonly Point[]): [Point, Point][] {
  const ring = hull(points);
  const [a, b] = ring;
  if (!a || !b) return [];
  if (ring.length > 2) return ring.map((p, i): [Point, Point] => [ring[(i + 1) % ring.length]!, p]);
  const along = ([x, y]: Point) => (x - a[0]) * (b[0] - a[0]) + (y - a[1]) * (b[1] - a[1]);
  const row = [...points].sort((p, q) => along(p) - along(q));
  const apart = row.filter((p, i) => !i || Math.hypot(p[0] - row[i - 1]![0], p[1] - row[i - 1]![1]) > 1e-9);
  return apart.slice(1).map((p, i): [Point, Point] => [apart[i]!, p]);
}

/** The angle of a driven link against another, at the pin of both. */
export interface Turned {
  readonly link: LinkData;
  readonly on: LinkData;
  readonly at: Spot;
}

export function turnedOf(facts: Facts): Turned[] {
  return (facts.scene.driven ?? []).flatMap(([name, other]) => {
    const [link, on] = [facts.links.get(name), facts.links.get(other)];
    const both = ({ places }: Pin) => [link, on].every((each) => places.some((place) => place.link === each));
    const pin = facts.pins.find(both);
    const at = pin?.places.find((place) => place.link === on);
    return link && on && at ? [{ link, on, at }] : [];
  });
}
