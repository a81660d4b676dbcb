// Prismatic joints as guide and block.

import type { LinkData, Point, PrismaticJoint, Scene } from "../scene/data.ts";
import { place, poseOf } from "./poses.ts";

/** Size of a block on the screen, in pixels. */
export const BLOCK = { length: 30, height: 18 };

/** One side of a prismatic joint: its line by a point and a direction in its link's axes. */
export interface Side {
  readonly link: LinkData;
  readonly local: Point;
  readonly angle: number;
}

/** Guide and block with the block's travel along the guide, from `low` to `high` of the guide's point. */
export interface Guide {
  readonly guide: Side;
  readonly block: Side;
  readonly low: number;
  readonly high: number;
  readonly cylinder: boolean;
}

export function guidesOf(scene: Scene, links: ReadonlyMap<string, LinkData>, times: readonly number[]): Guide[] {
  return scene.joints
    .filter((joint) => joint.kind === "prismatic")
    .map((joint) => {
      const [one, other] = [side(joint, 0, links), side(joint, 1, links)];
      const [guide, block] = other.link.fixed && !one.link.fixed ? [other, one] : [one, other];
      const cylinder = joint.look === "cylinder" && !guide.link.fixed;
      return { guide, block, cylinder, ...travel(guide, block, cylinder, times) };
    });
}

function side(joint: PrismaticJoint, i: 0 | 1, links: ReadonlyMap<string, LinkData>): Side {
  const link = links.get(joint.links[i])!;
  return { link, local: link.points[joint.points[i]]!, angle: joint.angles[i] };
}

/** How far the block goes; a slot in a moving link reaches to the guide's own point too. */
function travel(guide: Side, block: Side, cylinder: boolean, times: readonly number[]): { low: number; high: number } {
  let [low, high] = guide.link.fixed || cylinder ? [Infinity, -Infinity] : [0, 0];
  for (let k = 0; k < times.length; k++) {
    const [carrier, rider] = [poseOf(guide.link, times, k), poseOf(block.link, times, k)];
    if (!carrier || !rider) continue;
    const [ax, ay] = place(carrier, guide.local);
    const [bx, by] = place(rider, block.local);
    const along = Math.atan2(carrier.s, carrier.c) + guide.angle;
    const here = (bx - ax) * Math.cos(along) + (by - ay) * Math.sin(along);
    [low, high] = [Math.min(low, here), Math.max(high, here)];
  }
  return low > high ? { low: 0, high: 0 } : { low, high };
}

/** Whether a link is barrel or rod of a cylinder, whose symbol stands for what lies on its line. */
export const inCylinder = (guides: readonly Guide[], link: LinkData): boolean =>
  guides.some(({ cylinder, guide, block }) => cylinder && [guide.link, block.link].includes(link));

/** The place on a side's line at a distance from its point. */
export const onGuide = ({ local, angle }: Side, travel: number): Point => [
  local[0] + travel * Math.cos(angle),
  local[1] + travel * Math.sin(angle),
];
