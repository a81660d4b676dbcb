// How well the joints of a scene close: found from where its links are, whoever placed them.

import { place, poseOf } from "../drawing/poses.ts";
import type { LinkData, Point, Scene } from "../scene/data.ts";

/** The largest miss of any joint at any pose, over the size of the largest link; poses that are open don't count. */
export function closureError(scene: Scene): number {
  const links = new Map(scene.links.map((link) => [link.name, link]));
  let [worst, size] = [0, 0];
  for (const link of scene.links) {
    const points = Object.values(link.points);
    for (const [x, y] of points) for (const [u, v] of points) size = Math.max(size, Math.hypot(x - u, y - v));
  }
  const at = (link: LinkData, point: string, k: number): Point | null => {
    const pose = poseOf(link, scene.time, k);
    return pose && place(pose, link.points[point]!);
  };
  for (let k = 0; k < scene.time.length; k++) {
    if (scene.open?.[k]) continue;
    for (const joint of scene.joints) {
      const [a, b] = [links.get(joint.links[0])!, links.get(joint.links[1])!];
      const [from, to] = [at(a, joint.points[0], k), at(b, joint.points[1], k)];
      if (!from || !to) continue;
      const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
      if (joint.kind === "revolute") worst = Math.max(worst, Math.hypot(dx, dy));
      else {
        const pose = poseOf(a, scene.time, k)!;
        const along = Math.atan2(pose.s, pose.c) + joint.angles[0];
        worst = Math.max(worst, Math.abs(dy * Math.cos(along) - dx * Math.sin(along)));
      }
    }
  }
  return worst / (size || 1);
}
