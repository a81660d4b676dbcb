// Where a plane lies in its picture: what is seen of it, margins for the numbers of the axes, one scale where these are
// equal.

import { clamp } from "../scene/numbers.ts";
import { tick } from "./figure.ts";
import type { Plane } from "./study.ts";
import type { Box } from "./study_raw.ts";
import { ticks } from "./ticks.ts";

const LETTER = 6.3;
const [TOP, RIGHT, BOTTOM, NAME] = [8, 12, 38, 15];
const [LOWEST, HIGHEST, FREE] = [170, 460, 240];

export interface Frame {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
  /** The whole picture without what stands below the axes. */
  readonly height: number;
  /** What is seen, and pixels of places. */
  readonly box: Box;
  readonly across: (x: number) => number;
  readonly up: (y: number) => number;
  /** Places of pixels. */
  readonly x: (pixel: number) => number;
  readonly y: (pixel: number) => number;
  readonly xs: readonly number[];
  readonly ys: readonly number[];
}

/** The frame of a picture of some width that shows a box, or more where the axes are equal. */
export function frameOf({ equal, box: whole }: Plane, [x0, y0, x1, y1]: Box, width: number): Frame {
  const marks = (low: number, high: number, pixels: number): number[] =>
    ticks(low, high, Math.max(2, Math.round(pixels / 60)));
  const longest = Math.max(...ticks(y0, y1, 6).map((value) => tick(value).length), 3);
  const left = longest * LETTER + 14 + (equal ? 0 : NAME);
  const room = width - left - RIGHT;
  const aspect = (whole[3] - whole[1]) / (whole[2] - whole[0] || 1);
  const tall = equal ? clamp(room * aspect * 1.06, LOWEST, Math.min(HIGHEST, 1.3 * room)) : FREE;
  const bottom = TOP + tall;
  let [low, high, down, top] = [x0, x1, y0, y1];
  if (equal) {
    const least = 1e-12 * Math.max(Math.abs(x1), Math.abs(y1), 1e-300);
    const per = 1.06 * Math.max((x1 - x0) / room, (y1 - y0) / tall, least);
    const [cx, cy, dx, dy] = [(x0 + x1) / 2, (y0 + y1) / 2, (per * room) / 2, (per * tall) / 2];
    [low, high, down, top] = [cx - dx, cx + dx, cy - dy, cy + dy];
  }
  const [wide, high_] = [high - low || 1, top - down || 1];
  return {
    left,
    right: left + room,
    top: TOP,
    bottom,
    height: bottom + BOTTOM,
    box: [low, down, high, top],
    across: (x) => left + ((x - low) / wide) * room,
    up: (y) => bottom - ((y - down) / high_) * tall,
    x: (pixel) => low + ((pixel - left) / room) * wide,
    y: (pixel) => down + ((bottom - pixel) / tall) * high_,
    xs: marks(low, high, room),
    ys: marks(down, top, tall * 1.4),
  };
}
