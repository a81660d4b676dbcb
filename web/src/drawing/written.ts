// Numbers as they are inPath into a drawing.

/** A screen length: hundredths of a pixel. */
export const round = (value: number): number => Math.round(value * 100) / 100;

/** A place on the screen, in a path. */
export const inPath = ([x, y]: readonly [number, number]): string => `${round(x)} ${round(y)}`;

/** An angle of the world as rotate() takes it: degrees, clockwise. */
export const degrees = (angle: number): number => round((-angle * 180) / Math.PI);
