// Angles that are known but for whole turns (rad).

const TURN = 2 * Math.PI;

/** The largest turn between neighbours of a path on which an angle is made continuous. */
export const MAX_TURN = 0.5;

/** The same angle in -pi..pi. */
export function wrapped(angle: number): number {
  const past = (angle + Math.PI) % TURN;
  return (past < 0 ? past + TURN : past) - Math.PI;
}

/** How many turns bring an angle within half a turn of another. */
export const wholeTurns = (angle: number, near: number): number => Math.round((near - angle) / TURN);
