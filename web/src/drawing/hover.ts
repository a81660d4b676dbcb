// A small readout beside a point, where the mouse is or a finger tapped. Plots have the same values: screen readers
// don't hear of it.

import { figure } from "./dimension_lines.ts";
import { html } from "./elements.ts";
import type { Pin } from "./pins.ts";
import { type Quantity, readout } from "./readout.ts";
import type { Facts } from "./survey.ts";
import type { View } from "./view.ts";
import type { Say } from "./words.ts";

/** How near to a point one has to be, in pixels: with a mouse, with a finger. */
const NEAR = { mouse: 12, touch: 24 };

export interface Hover {
  /** Follows the time. */
  update(facts: Facts, view: View, k: number, f: number): void;
}

export interface HoverOptions {
  readonly stage: HTMLElement;
  readonly picture: SVGSVGElement;
  readonly say: Say;
  readonly pick: (x: number, y: number, within: number) => Pin | null;
  /** Asks for an update. */
  readonly changed: () => void;
}

export function hover({ stage, picture, say, pick, changed }: HoverOptions): Hover {
  const box = html("div", { class: "lw-hover", "aria-hidden": "true", hidden: "" }, stage);
  let name: string | null = null;
  const choose = (pin: Pin | null): void => {
    if ((pin?.name ?? null) === name) return;
    name = pin?.name ?? null;
    changed();
  };
  picture.addEventListener("pointermove", (event) => {
    if (event.pointerType === "mouse" && !event.buttons) choose(pick(event.clientX, event.clientY, NEAR.mouse));
  });
  picture.addEventListener("pointerdown", (event) => {
    if (event.pointerType !== "mouse") choose(pick(event.clientX, event.clientY, NEAR.touch));
  });
  picture.addEventListener("pointerleave", (event) => {
    if (event.pointerType === "mouse" && !event.buttons) choose(null);
  });
  const update: Hover["update"] = (facts, view, k, f) => {
    const pin = name === null ? null : facts.pins.find((each) => each.name === name);
    const said = pin ? readout(facts, pin, k, f) : null;
    box.hidden = !said;
    if (!said) return;
    const [x, y] = view.toScreen(said.at);
    const unit = facts.scene.length_unit;
    const lines = [
      ["x", quantity({ value: said.at[0], unit })],
      ["y", quantity({ value: said.at[1], unit })],
      ...(said.speed ? [[say("hover_speed"), quantity(said.speed)]] : []),
      ...(said.reaction ? [[say("hover_reaction"), quantity(said.reaction)]] : []),
    ];
    box.replaceChildren(html("b", {}, null, said.name));
    for (const [what = "", value = ""] of lines) {
      html("span", {}, box, what);
      html("span", {}, box, value);
    }
    // On the side with more room, as the drawing may be wider on the screen than in its own pixels.
    const share = (value: number, whole: number) => `${(value / whole) * 100}%`;
    const [right, below] = [x < view.width / 2, y < view.height / 2];
    box.style.left = right ? `calc(${share(x, view.width)} + 14px)` : "";
    box.style.right = right ? "" : `calc(${share(view.width - x, view.width)} + 14px)`;
    box.style.top = below ? `calc(${share(y, view.height)} + 10px)` : "";
    box.style.bottom = below ? "" : `calc(${share(view.height - y, view.height)} + 10px)`;
  };
  return { update };
}

const quantity = ({ value, unit }: Quantity): string => `${figure(value, 4)} ${unit}`;
