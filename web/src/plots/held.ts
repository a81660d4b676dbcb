// A drawing that is held while the pointer is in a plot, and goes on as before when it leaves.

import type { Drawing } from "../drawing/render.ts";

export interface Held {
  hold(): void;
  release(): void;
  /** The time of now is what it goes back to. */
  keep(): void;
  /** There is nothing to go back to. */
  drop(): void;
}

export function held(drawing: Drawing): Held {
  let before: { time: number; playing: boolean } | null = null;
  return {
    hold() {
      before ??= { time: drawing.time, playing: drawing.playing };
    },
    release() {
      if (!before) return;
      drawing.setTime(before.time);
      if (before.playing) drawing.play();
      before = null;
    },
    keep() {
      before = { time: drawing.time, playing: false };
    },
    drop() {
      before = null;
    },
  };
}
