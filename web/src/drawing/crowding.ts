// Which of many texts are shown, and where: none over another.

import { set, shown } from "./elements.ts";
import { round } from "./written.ts";

/** The most texts of a drawing. */
export const MOST = 40;
/** By how much texts may touch, and how clear of others one must be that was elsewhere to come there, in pixels. */
const TOUCH = 1;
const CLEAR = 4;

/** A text's box on the screen: its middle, half its width and half its height. */
export interface TextBox {
  readonly x: number;
  readonly y: number;
  readonly half: number;
  readonly high: number;
}

/** A text at its place of the moment, the first of `boxes`; the others are where it may be instead. None: not seen. */
export interface Placed {
  readonly text: SVGTextElement;
  boxes: readonly TextBox[];
}

/** Of each text the number of its box, -1 where none is free; texts come in order, at most `most` are kept. `before`:
 * what it was. */
export function kept(
  texts: readonly (readonly TextBox[])[],
  before: readonly (number | undefined)[],
  most = MOST,
): number[] {
  const found: TextBox[] = [];
  return texts.map((boxes, i) => {
    if (found.length >= most) return -1;
    const was = before[i];
    const free = (box: TextBox, spare: number): boolean =>
      found.every(
        (other) =>
          Math.abs(box.x - other.x) >= box.half + other.half + spare ||
          Math.abs(box.y - other.y) >= box.high + other.high + spare,
      );
    const stays = was !== undefined && was >= 0 && boxes[was] && free(boxes[was], -TOUCH);
    const chosen = stays ? was : boxes.findIndex((box) => free(box, was === undefined ? -TOUCH : CLEAR));
    if (chosen >= 0) found.push(boxes[chosen]!);
    return chosen;
  });
}

/** Shows of texts those that have room, the first before the others. */
export function thinned(texts: readonly Placed[]): () => void {
  let before: number[] = [];
  return () => {
    before = kept(
      texts.map(({ boxes }) => boxes),
      before,
    );
    texts.forEach(({ text, boxes }, i) => {
      const box = boxes[before[i]!];
      shown(text, box !== undefined);
      if (!box || !before[i]) return;
      set(text, "x", round(box.x));
      set(text, "y", round(box.y));
    });
  };
}

/** About how wide a text is, in pixels: hanzi are as wide as they are high. */
export function widthOf(text: string, size = 12): number {
  let width = 0;
  for (const letter of text) width += /[\u2e80-\uffef]/.test(letter) ? 1 : 0.62;
  return width * size;
}

const known = new Map<string, number>();

/** How wide the text of an element is: measured once, or about where the element isn't on a screen. */
export function measured(text: SVGTextElement): number {
  const content = text.textContent ?? "";
  const key = `${text.getAttribute("class")} ${content}`;
  const width = known.get(key) ?? text.getComputedTextLength();
  if (!(width > 0)) return widthOf(content);
  known.set(key, width);
  return width;
}

/** The box of a text of some width that is anchored at a place. */
export function textBox(width: number, x: number, y: number, anchor: "start" | "middle" | "end" = "middle"): TextBox {
  const half = width / 2;
  return { x: x + (anchor === "start" ? half : anchor === "end" ? -half : 0), y, half: half + 1, high: 7 };
}
