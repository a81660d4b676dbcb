// What callers ask of a drawing, and steer it by.

import type { Point, Scene, Texts, TimeAxis } from "../scene/data.ts";
import type { Pin } from "./pins.ts";
import type { Seen } from "./seen.ts";

export interface RenderOptions {
  readonly model: Scene;
  readonly el: Element;
  /** Texts under "report.*" keys. */
  readonly words?: Texts;
  /** Unit and name of the scene's time. */
  readonly time?: Pick<TimeAxis, "unit" | "label">;
  /** Yields to a wish for reduced motion. */
  readonly autoplay?: boolean;
}

export type Listener = (time: number, index: number) => void;

/** A drawing on the page, as callers steer it. */
export interface Drawing {
  readonly playing: boolean;
  readonly time: number;
  play(): void;
  pause(): void;
  /** Setting a time or a sample ends the play. */
  setTime(t: number): void;
  setIndex(i: number): void;
  /** The same links and points in another motion, of as many poses; `original` is drawn faintly behind it. */
  update(scene: Scene, original: Scene | null): void;
  /** The place in the world of a place in the window. */
  place(x: number, y: number): Point;
  /** The pin or point next to a place in the window, none farther away than some pixels. */
  pick(x: number, y: number, within: number): Pin | null;
  readonly picture: SVGSVGElement;
  readonly seen: Seen;
  /** The scene that is drawn. */
  readonly scene: Scene;
  /** Shows all the motion, that of a changed scene too. */
  fit(): void;
  /** Calls back when the time changes, until the function that it gives is called. */
  on(event: "time", callback: Listener): () => void;
  destroy(): void;
}
