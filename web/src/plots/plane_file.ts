// A plane as an SVG file: title, picture, legend.

import { swatch } from "./chart_svg.ts";
import { lookOf } from "./layer_look.ts";
import { frameOf } from "./plane_frame.ts";
import { folded, type PlaneSheet } from "./plane_sheet.ts";
import { planeSvg } from "./plane_svg.ts";
import type { Plane } from "./study.ts";
import type { Box } from "./study_raw.ts";
import { element, escaped, text } from "./svg_parts.ts";

const [TITLE, LINE] = [26, 17];
const FONTS = "system-ui, 'Segoe UI', Roboto, Arial, 'PingFang SC', 'Microsoft YaHei', 'Noto Sans CJK SC', sans-serif";

/** The text of the file. */
export function planeFile(plane: Plane, box: Box, sheet: PlaneSheet): string {
  const { width, colour } = sheet;
  const titles = folded(plane.title, width - 20, 7.4);
  const top = TITLE + LINE * (titles.length - 1);
  const { inside, height } = planeSvg(plane, frameOf(plane, box, width), sheet);
  let out = "";
  titles.forEach((row, i) => {
    out += text(row, { x: 10, y: 18 + LINE * i, "font-size": 13, "font-weight": 600, fill: colour("ink") });
  });
  out += `<g transform="translate(0 ${top})">${inside}</g>`;
  let y = top + height + 12;
  plane.layers.forEach((layer, i) => {
    if (layer.kind === "field" || !sheet.shown(i)) return;
    out += swatch({ look: lookOf(layer) }, i, 10, y - 4, colour);
    for (const row of folded(layer.name, width - 52)) {
      out += text(row, { x: 42, y, "font-size": 11, fill: colour("ink") });
      y += LINE;
    }
  });
  const total = y + 2;
  const head = `xmlns="http://www.w3.org/2000/svg" width="${width}" height="${total}" viewBox="0 0 ${width} ${total}"`;
  const ground = element("rect", { width, height: total, fill: colour("paper") });
  return `<svg ${head} font-family="${FONTS}"><title>${escaped(plane.title)}</title>${ground}${out}</svg>\n`;
}
