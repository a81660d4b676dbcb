// Dragging a point of the drawing: in `shape` its mechanism's numbers follow, in `move` the time does.

import type { Drawing } from "../drawing/render.ts";
import { nearest } from "../scene/times.ts";
import type { Hindrance, LiveModel } from "./live_model.ts";

/** How near to a point one has to press, in pixels: with a mouse, with a finger. */
const NEAR = { mouse: 14, touch: 24 };

export interface DragOptions {
  readonly live: LiveModel;
  readonly drawing: Drawing;
  readonly held: (number: number) => boolean;
  /** Whether dimensions follow a drag; else the time. */
  readonly shapes: () => boolean;
  /** A drag ended (null), or is as near to the pointer as it gets: by how much it is off, in SI, and what keeps it. */
  readonly said: (off: number | null, by?: Hindrance) => void;
}

export function dragging({ live, drawing, held, shapes, said }: DragOptions): void {
  const { picture } = drawing;
  const { data } = live;
  let point = -1;
  let links: readonly string[] = [];
  let time = 0;
  let start: Float64Array | null = null;
  let every = false;
  let waiting: readonly [number, number] | null = null;
  const pick = (event: PointerEvent): number => {
    const pin = drawing.pick(event.clientX, event.clientY, event.pointerType === "mouse" ? NEAR.mouse : NEAR.touch);
    const names = pin?.places.flatMap(({ link, local }) =>
      Object.entries(link.points).flatMap(([name, at]) => (at === local ? [name] : [])),
    );
    links = pin?.places.map(({ link }) => link.name) ?? [];
    return data.program.points.findIndex((name) => names?.includes(name));
  };
  /** What one frame does, however many events came since the last. */
  const follow = (): void => {
    const target = waiting;
    waiting = null;
    if (!target || point < 0) return;
    if (shapes()) {
      const found = live.drag(point, target, time, every ? null : links, held);
      if (found.time !== time) drawing.setTime((time = found.time) / data.second);
      said(found.reached ? null : found.off, found);
    } else drawing.setTime((time = nearestTime(target)) / data.second);
  };
  /** The time near the present one at which the point comes nearest to a place. */
  const nearestTime = ([x, y]: readonly [number, number]): number => {
    const name = data.program.points[point]!;
    const [xs, ys] = [live.signal(`${name}.x`), live.signal(`${name}.y`)];
    if (!xs || !ys) return time;
    const pose = nearest(live.motion.times, time);
    const off = (k: number): number => Math.hypot(xs[k]! - x, ys[k]! - y);
    const reach = Math.ceil(xs.length / 6);
    const count = xs.length - 1; // a cycle: the last pose is the first one
    let best = pose;
    for (let step = -reach; step <= reach; step++) {
      const k = (((pose + step) % count) + count) % count;
      if (off(k) < off(best) * (1 - 1e-9)) best = k;
    }
    return live.motion.times[best]!;
  };
  picture.addEventListener("pointerdown", (event) => {
    if (!event.isPrimary) return end(); // a second finger zooms
    if (event.button !== 0 || event.shiftKey) return;
    point = pick(event);
    if (point < 0) return;
    event.preventDefault();
    drawing.pause();
    time = drawing.time * data.second;
    start = live.values.slice();
    live.begin();
    picture.setPointerCapture(event.pointerId);
    picture.classList.add("lw-dragging");
  });
  picture.addEventListener("pointermove", (event) => {
    if (point < 0) {
      picture.classList.toggle("lw-grabbable", pick(event) >= 0);
      return;
    }
    if (event.buttons === 0) return end();
    const [x, y] = drawing.place(event.clientX, event.clientY);
    every = event.altKey;
    if (waiting === null) requestAnimationFrame(follow);
    waiting = [x * data.length, y * data.length];
  });
  const end = (): void => {
    if (point < 0) return;
    follow();
    live.end();
    start = null;
    point = -1;
    said(null);
    picture.classList.remove("lw-dragging");
  };
  document.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !start) return;
    waiting = null;
    live.restore(start);
    end();
  });
  for (const kind of ["pointerup", "pointercancel", "lostpointercapture"]) picture.addEventListener(kind, end);
}
