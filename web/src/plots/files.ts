// The files of a plot.

import { download, fileName, png } from "../panels/download.ts";
import { HEIGHT } from "./chart.ts";
import type { Card } from "./card.ts";
import { chartSvg } from "./chart_svg.ts";
import { csvText } from "./csv.ts";
import type { Horizontal } from "./curves.ts";
import { lightColours } from "./looks.ts";

export type FileKind = "csv" | "png" | "svg";

/** `note`: empty, or that the model was changed. */
export interface FileOptions {
  readonly time: Horizontal;
  readonly window: readonly [number, number];
  readonly index: number;
  readonly note: string;
}

/** Saves a plot as it is shown, in light. */
export async function save(card: Card, kind: FileKind, { time, window, index, note }: FileOptions): Promise<void> {
  const curves = card.curves();
  const name = `${fileName(curves.title)}.${kind}`;
  if (kind === "csv") return download(name, new Blob([csvText(curves, time, note)], { type: "text/csv" }));
  const width = Math.max(320, Math.round(card.box.clientWidth || 480));
  const colour = lightColours();
  const text = chartSvg(curves, { width, height: HEIGHT + 20, colour, window, index, note, shown: card.shown });
  download(name, kind === "svg" ? new Blob([text], { type: "image/svg+xml" }) : await png(text));
}
