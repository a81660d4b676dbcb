// What a layer of a plane looks like in a legend.

import type { Look } from "./outline.ts";
import type { Layer } from "./study.ts";

export function lookOf(layer: Layer): Look {
  switch (layer.kind) {
    case "lines":
      return { kind: "line", colour: layer.colour, dash: layer.dash };
    case "region":
      return { kind: "strong", colour: layer.colour, dash: 0 };
    case "spots":
      return { kind: "dots", colour: layer.scale ? "muted" : layer.colour, dash: 0 };
    default:
      return { kind: "line", colour: "muted", dash: 0 };
  }
}

