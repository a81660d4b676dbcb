// What of a drawing its reader wants to see.

import type { ArrowKind } from "../scene/data.ts";

export interface Seen {
  /** Names of points, of links. */
  points: boolean;
  links: boolean;
  /** Lengths of bars and angles of driven links. */
  dimensions: boolean;
  /** The kinds of arrows that are seen, with the factor of their usual length. */
  readonly arrows: Map<ArrowKind, number>;
}

export const usual = (): Seen => ({ points: true, links: true, dimensions: false, arrows: new Map() });
