// Which of many texts are shown: none over another.

import { shown } from "./elements.ts";

/** The most texts of a drawing. */
export const MOST = 40;
/** By how much texts may touch, and how clear of others one must be that was left out to come back, in pixels. */
const TOUCH = 1;
const CLEAR = 4;

/** A text's box on the screen: its middle, half its width and half its height. */
export interface TextBox {
  readonly x: number;
  readonly y: number;
  readonly half: number;
  readonly high: number;
}

/** A text at its place of the moment: none where it isn't to be seen. */
export interface Placed {
  readonly text: SVGTextElement;
  box: TextBox | null;
}

/** Which boxes are kept, the first before the others, at most `most`; `before`: which were. */
export function kept(boxes: readonly (TextBox | null)[], before: readonly boolean[], most = MOST): boolean[] {
  const found: TextBox[] = [];
  return boxes.map((box, i) => {
    if (!box || found.length >= most) return false;
    const spare = before[i] === false ? CLEAR : -TOUCH;
    const free = found.every(
      (other) =>
        Math.abs(box.x - other.x) >= box.half + other.half + spare ||
        Math.abs(box.y - other.y) >= box.high + other.high + spare,
    );
    if (free) found.push(box);
    return free;
  });
}

/** Shows of texts those that have room, the first before the others. */
export function thinned(texts: readonly Placed[]): () => void {
  let before: boolean[] = [];
  return () => {
    before = kept(
      texts.map(({ box }) => box),
      before,
    );
    texts.forEach(({ text }, i) => shown(text, before[i]!));
  };
}

/** About how wide a text is, in pixels: hanzi are as wide as they are high. */
export function widthOf(text: string, size = 12): number {
  let width = 0;
  for (const letter of text) width += /[\u2e80-\uffef]/.test(letter) ? 1 : 0.63;
  return width * size;
}

/** The box of a text that is anchored at a place. */
export function textBox(text: string, x: number, y: number, anchor: "start" | "middle" | "end" = "middle"): TextBox {
  const half = widthOf(text) / 2 + 1;
  return { x: x + (anchor === "start" ? half : anchor === "end" ? -half : 0), y, half, high: 7 };
}
