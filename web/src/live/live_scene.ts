// The scene of a motion that the page computed.

import type { Centrode, LinkData, Point, PoseRows, Scene, Values } from "../scene/data.ts";
import type { Motion } from "../program/mechanism.ts";
import { extent } from "../scene/numbers.ts";
import { centrodesOf } from "./live_centrodes.ts";
import type { LiveModel } from "./live_model.ts";
import { slotAlong } from "./slot_shape.ts";

/** A row in another unit. */
function scaled(row: Float64Array, size: number): Float64Array {
  const found = new Float64Array(row.length);
  for (let k = 0; k < row.length; k++) found[k] = row[k]! / size;
  return found;
}

/** `base` in the motion of the moment: where links are, their shapes, the paths of points; where it can't close, links
 * as near to it as they come. */
export function sceneOf(base: Scene, live: LiveModel, motion: Motion = live.motion): Scene {
  const { data, mechanism } = live;
  const rows = motion.failure ? mechanism.nearest(motion) : motion.rows;
  const shape = mechanism.shape(motion.parameters);
  let next = 0;
  const coordinate = (): number => shape[next++]! / data.length;
  const links = base.links.map((link): LinkData => {
    const points = Object.fromEntries(
      Object.keys(link.points).map((name): [string, Point] => [name, [coordinate(), coordinate()]]),
    );
    const { outlines, ...rest } = link;
    const lines = motion === live.original ? outlines : outlinesOf(link.name, live, motion);
    const pose = poseOf(link, data.poses, rows, data.length);
    return lines ? { ...rest, points, pose, outlines: lines } : { ...rest, points, pose };
  });
  const joints = base.joints.map((joint) =>
    joint.kind === "prismatic" ? { ...joint, angles: [shape[next++]!, shape[next++]!] as const } : joint,
  );
  const traces = base.traces.map(({ name }) => ({
    name,
    x: scaled(live.signal(`${name}.x`, motion)!, data.length),
    y: scaled(live.signal(`${name}.y`, motion)!, data.length),
  }));
  let rolling: Centrode[] | null = null;
  const time = motion.times.map((each) => each / data.second);
  const values = valuesOf(base, live, motion);
  return {
    ...base,
    links,
    joints,
    traces,
    time,
    values,
    open: openings(motion, 4 * data.poses.length, time.length),
    /** Found when they are looked at: mostly they aren't. */
    get centrodes() {
      return (rolling ??= centrodesOf(base.centrodes ?? [], links, live, motion));
    },
  };
}

/** The outlines of a link that can be computed: those of cams and their rollers, slots, pitch circles. */
function outlinesOf(link: string, live: LiveModel, motion: Motion): Point[][] | null {
  const { data, mechanism } = live;
  const found = data.outlines.flatMap((one, i) => {
    if (one.link !== link) return [];
    const reach = one.travel ? (extent(live.signal(one.travel, motion) ?? []) ?? [NaN, NaN]) : [];
    const lines = mechanism.outline(i, one, motion.parameters, reach);
    return one.width ? lines.map((line) => slotAlong(line, one.width! / 2)) : lines;
  });
  const scaled = found.map((line) => line.map(([x, y]): Point => [x / data.length, y / data.length]));
  return scaled.length ? scaled : null;
}

/** The rows that arrows name, in the page's units. */
function valuesOf({ arrows = [] }: Scene, live: LiveModel, motion: Motion): Record<string, Values> {
  const { signals, arrow_rows, sizes, poses } = live.data;
  const found: Record<string, Values> = {};
  const named = new Set(arrows.flatMap(({ rows, places = [] }) => [...rows, ...places]));
  for (const [i, label] of [...signals, ...arrow_rows].entries()) {
    if (named.has(label)) found[label] = scaled(motion.rows[4 * poses.length + i]!, sizes[i]!);
  }
  return found;
}

function poseOf(link: LinkData, poses: readonly string[], rows: readonly Float64Array[], size: number): PoseRows {
  const at = 4 * poses.indexOf(link.name);
  if (at < 0) return { x: [0], y: [0], c: [1], s: [0] };
  return { x: scaled(rows[at]!, size), y: scaled(rows[at + 1]!, size), c: rows[at + 2]!, s: rows[at + 3]! };
}

/** At which poses some link has no place of its own. */
const openings = ({ failure, rows }: Motion, places: number, count: number): boolean[] =>
  Array.from({ length: count }, (_, k) => {
    return failure !== null && rows.slice(0, places).some((row) => !Number.isFinite(row[k]!));
  });
