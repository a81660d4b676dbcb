// Points that revolute joints hold together, as one pin each.

import type { LinkData, Point, Scene } from "../scene/data.ts";

/** A point of a link, in its axes. */
export interface Spot {
  readonly link: LinkData;
  readonly local: Point;
}

/** A pin, or a point that no joint holds. */
export interface Pin {
  name: string;
  readonly places: [Spot, ...Spot[]];
  readonly joints: string[];
}

export function pinsOf(scene: Scene): Pin[] {
  const key = (link: string, point: string) => JSON.stringify([link, point]);
  const pinAt = new Map<string, Pin>();
  for (const link of scene.links) {
    for (const [name, local] of Object.entries(link.points)) {
      pinAt.set(key(link.name, name), { name, places: [{ link, local }], joints: [] });
    }
  }
  for (const { kind, name, links, points } of scene.joints) {
    if (kind !== "revolute") continue;
    const a = pinAt.get(key(links[0], points[0]))!;
    const b = pinAt.get(key(links[1], points[1]))!;
    if (a !== b) {
      if (a.name !== b.name) a.name = name;
      a.places.push(...b.places);
      a.joints.push(...b.joints);
      for (const [at, pin] of pinAt) if (pin === b) pinAt.set(at, a);
    }
    a.joints.push(name);
  }
  return [...new Set(pinAt.values())];
}
