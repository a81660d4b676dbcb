// A circle for each pin and each point that moves.

import { svg } from "./elements.ts";
import { place, poseOf } from "./poses.ts";
import { colourOf, type Facts } from "./survey.ts";
import { type Move, putCircle, type View } from "./view.ts";

/** `r`: radius of the ends of bars, in pixels. */
export function pinCircles(facts: Facts, view: View, r: number, parent: Element): Move {
  const parts = facts.pins.map((pin) => {
    const joined = pin.joints.length > 0;
    const moving = pin.places.find(({ link }) => !link.fixed);
    const circle = svg("circle", {
      class: joined ? "lw-pin" : `lw-point ${moving ? colourOf(facts, moving.link) : ""}`,
      r: joined ? Math.min(r - 1.5, 4.8) : 2.6,
      "data-point": pin.name,
    });
    if (joined || moving) parent.append(circle);
    return { circle, at: pin.places.find(({ link }) => link.fixed) ?? pin.places[0] };
  });
  return (sample, f) => {
    for (const { circle, at } of parts) {
      const pose = poseOf(at.link, facts.times, sample, f);
      putCircle(circle, pose && view.toScreen(place(pose, at.local)));
    }
  };
}
