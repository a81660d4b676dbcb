// What a drawing shows of the world: all of it, or a part, nearer.

import type { Point } from "../scene/data.ts";
import { clamp } from "../scene/numbers.ts";
import type { Box } from "./survey.ts";
import type { View } from "./view.ts";

/** How much nearer than in the view that fits all; the world's place in the middle, if not that of this view. */
export interface Camera {
  readonly zoom: number;
  readonly centre: Point | null;
}

export const HOME: Camera = { zoom: 1, centre: null };
const LIMITS = { least: 0.5, most: 40 };

const middle = ({ width, height }: View): Point => [width / 2, height / 2];

/** The view through a camera; `fitted` is the one that fits all. */
export function through(fitted: View, { zoom, centre }: Camera): View {
  if (zoom === 1 && !centre) return fitted;
  const [k, [mx, my]] = [fitted.k * zoom, middle(fitted)];
  const [cx, cy] = centre ?? fitted.toWorld([mx, my]);
  return {
    ...fitted,
    k,
    toScreen: ([x, y]) => [mx + k * (x - cx), my - k * (y - cy)],
    toWorld: ([x, y]) => [cx + (x - mx) / k, cy - (y - my) / k],
  };
}

/** Nearer by a factor, with the world's place at `at` of the screen staying there. */
export function zoomed(camera: Camera, fitted: View, at: Point, factor: number): Camera {
  const zoom = clamp(camera.zoom * factor, LIMITS.least, LIMITS.most);
  const [x, y] = through(fitted, camera).toWorld(at);
  const [[mx, my], k] = [middle(fitted), fitted.k * zoom];
  return { zoom, centre: [x - (at[0] - mx) / k, y + (at[1] - my) / k] };
}

/** Moved by some pixels of the screen; the middle stays within `box`. */
export function panned(camera: Camera, fitted: View, [dx, dy]: Point, box: Box): Camera {
  const k = fitted.k * camera.zoom;
  const [x, y] = camera.centre ?? fitted.toWorld(middle(fitted));
  const within = (value: number, now: number, low: number, high: number): number =>
    clamp(value, Math.min(low, now), Math.max(high, now));
  return { zoom: camera.zoom, centre: [within(x - dx / k, x, box.x0, box.x1), within(y + dy / k, y, box.y0, box.y1)] };
}
