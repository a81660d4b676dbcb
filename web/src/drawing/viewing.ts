// The part of the world that a drawing shows, as its reader moves it: buttons, gestures, keys, the whole screen.

import type { Point } from "../scene/data.ts";
import { clamp } from "../scene/numbers.ts";
import { type Camera, HOME, panned, zoomed } from "./camera.ts";
import type { Frame } from "./frame.ts";
import { keyboard } from "./keyboard.ts";
import { navigation } from "./navigation.ts";
import type { Pin } from "./pins.ts";
import type { Facts } from "./survey.ts";
import type { View } from "./view.ts";
import { viewTools } from "./view_tools.ts";
import type { Say } from "./words.ts";

export interface Viewing {
  readonly camera: Camera;
  /** Back to all the motion. */
  home(): void;
  /** How high the drawing is at most and at least. */
  heights(): { readonly most: number; readonly least: number };
  /** Shows what the view is, once it is drawn. */
  update(): void;
}

export interface ViewingOptions extends Frame {
  readonly say: Say;
  readonly facts: () => Facts;
  /** The view that fits all, as it was drawn last. */
  readonly fitted: () => View;
  readonly pick: (x: number, y: number, within: number) => Pin | null;
  /** Draws anew, soon. */
  readonly redraw: () => void;
  /** Fits all the motion into the view, and calls `home`. */
  readonly fit: () => void;
}

/** How near to a point a press drags it, not the ground, in pixels. */
const NEAR = { mouse: 14, touch: 24 };

export function viewing({ root, stage, drawing, say, facts, fitted, pick, redraw, fit }: ViewingOptions): Viewing {
  let camera = HOME;
  const whole = (): boolean => document.fullscreenElement === root;
  const zoom = (at: Point, factor: number): void => {
    camera = zoomed(camera, fitted(), at, factor);
    redraw();
  };
  const pan = (by: Point): void => {
    camera = panned(camera, fitted(), by, facts().wide);
    redraw();
  };
  const middle = (): Point => [fitted().width / 2, fitted().height / 2];
  const closer = (factor: number): void => zoom(middle(), factor);
  const tools = viewTools({ stage, root, say, zoom: closer, fit });
  keyboard({ root, stage, drawing }, say, { pan, zoom: closer, fit });
  navigation({
    picture: drawing,
    zoom,
    pan,
    fit,
    free: () => camera.zoom > 1,
    alone: whole,
    taken: ({ clientX, clientY, pointerType }) => {
      const near = pointerType === "mouse" ? NEAR.mouse : NEAR.touch;
      return drawing.classList.contains("lw-live") && pick(clientX, clientY, near) !== null;
    },
  });
  /** What a whole screen has room for above the controls. */
  const room = (): number => {
    const others = [...root.querySelectorAll<HTMLElement>(":scope > div")].filter((each) => each !== stage);
    const taken = others.reduce((sum, each) => sum + (each.offsetHeight ? each.offsetHeight + 8 : 0), 0);
    return Math.max(window.innerHeight - taken - 32, 200);
  };
  return {
    get camera() {
      return camera;
    },
    home() {
      camera = HOME;
    },
    heights() {
      // On a phone the drawing stays in sight above the rest of the page.
      const share = window.innerWidth < 760 ? 0.42 : 0.66;
      if (!whole()) return { most: clamp(window.innerHeight * share, 240, 720), least: 200 };
      const high = room();
      return { most: high, least: high };
    },
    update() {
      tools.update({ fits: camera === HOME });
      drawing.classList.toggle("lw-zoomed", camera.zoom > 1);
    },
  };
}
