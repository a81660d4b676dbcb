// The bands of a field as pixels.

import type { Field } from "./field.ts";
import type { Frame } from "./plane_frame.ts";

/** The address of a picture that fills the frame; `finer`: its pixels to one of the screen. */
export function fieldPicture(field: Field, frame: Frame, finer = Math.min(devicePixelRatio, 2)): string {
  const pixels = (from: number, to: number): number => Math.round((to - from) * finer);
  const [width, height] = [pixels(frame.left, frame.right), pixels(frame.top, frame.bottom)];
  if (width < 1 || height < 1) return "";
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [width, height];
  const context = canvas.getContext("2d")!;
  const image = context.createImageData(width, height);
  const xs = Array.from({ length: width }, (_, i) => frame.x(frame.left + (i + 0.5) / finer));
  const ys = Array.from({ length: height }, (_, j) => frame.y(frame.top + (j + 0.5) / finer));
  const bands = field.bandsOver(xs, ys);
  const colours = field.colours.map((colour) => [1, 3, 5].map((at) => Number.parseInt(colour.slice(at, at + 2), 16)));
  bands.forEach((band, k) => {
    if (band < 0) return;
    image.data.set([...colours[band]!, 255], 4 * k);
  });
  context.putImageData(image, 0, 0);
  return canvas.toDataURL("image/png");
}
