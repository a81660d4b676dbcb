// A circle for each pin and each point that moves.

import { svg } from "./elements.ts";
import { place, poseOf } from "./poses.ts";
import { colourOf, type Facts } from "./survey.ts";
import { type Move, putCircle, type View } from "./view.ts";

/** `r`: radius of the ends of bars, in pixels. */
export function pinCircles(facts: Facts, view: View, r: number, parent: Element): Move {
  const parts = facts.pins.flatMap((pin) => {
    const joined = pin.joints.length > 0;
    const moving = pin.places.find(({ link }) => !link.fixed);
    if (!joined && !moving) return [];
    const look = joined ? "lw-pin" : `lw-point ${colourOf(facts, moving!.link)}`;
    const radius = joined ? Math.min(r - 1.5, 4.8) : 2.6;
    const circle = svg("circle", { class: look, r: radius, "data-point": pin.name }, parent);
    return [{ circle, at: pin.places.find(({ link }) => link.fixed) ?? pin.places[0] }];
  });
  return (sample, f) => {
    for (const { circle, at } of parts) {
      const pose = poseOf(at.link, facts.times, sample, f);
      putCircle(circle, pose && view.toScreen(place(pose, at.local)));
    }
  };
}
