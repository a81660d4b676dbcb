// Parts of an SVG as text: attributes and texts can't end what they stand in.

import { known, type Values } from "../scene/data.ts";

/** Size in pixels, and colours by their names among those of drawings. */
export interface Sheet {
  readonly width: number;
  readonly height: number;
  readonly colour: (name: string) => string;
}

type Attributes = Readonly<Record<string, string | number>>;

const CONTROLS = /[\u0000-\u0008\u000b-\u001f\u007f-\u009f\ufffe\uffff]|[\ud800-\udbff](?![\udc00-\udfff])/g;

export const escaped = (value: string): string =>
  value
    .replace(CONTROLS, "\ufffd")
    .replaceAll("&", "&amp;")
    .replaceAll("<", "&lt;")
    .replaceAll(">", "&gt;")
    .replaceAll('"', "&quot;");

const written = (attributes: Attributes): string =>
  Object.entries(attributes)
    .filter(([, value]) => value !== "")
    .map(([key, value]) => ` ${key}="${escaped(String(value))}"`)
    .join("");

/** An element without content; lines aren't filled. */
export const element = (tag: string, attributes: Attributes): string =>
  `<${tag}${written({ fill: "none", ...attributes })}/>`;

export const text = (content: string, attributes: Attributes): string =>
  `<text${written(attributes)}>${escaped(content)}</text>`;

/** A curve through samples, broken where there is no value. */
export function pathOf(x: Values, y: Values, across: (value: number) => number, up: (value: number) => number): string {
  let d = "";
  let broken = true;
  for (let k = 0; k < y.length; k++) {
    const [a, b] = [known(x, k), known(y, k)];
    if (a === null || b === null) {
      broken = true;
      continue;
    }
    d += `${broken ? "M" : "L"}${across(a).toFixed(2)} ${up(b).toFixed(2)}`;
    broken = false;
  }
  return d;
}
