// The centrodes of a motion that the page computed: as report/centrodes.py finds and cuts those of the model file.

import { type Centrode, known, type LinkData } from "../scene/data.ts";
import { extent } from "../scene/numbers.ts";
import type { Motion } from "../program/mechanism.ts";
import type { LiveModel } from "./live_model.ts";

/** How far from the motion a centrode is drawn, in sizes of the motion. */
const FAR = 0.5;

interface Reach {
  readonly centre: number;
  readonly half: number;
}

/** The paths of the instant centres of links, NaN where they are far away. */
export function centrodesOf(
  stated: readonly Pick<Centrode, "link" | "point">[],
  links: readonly LinkData[],
  live: LiveModel,
  motion: Motion,
): Centrode[] {
  const names = [...new Set(links.flatMap(({ points }) => Object.keys(points)))];
  const [across, up] = reaches(names, live, motion);
  const found = stated.filter(({ point }) => live.signal(`${point}.vx`, motion));
  return found.map(({ link, point }) => {
    const [x, y, vx, vy] = ["x", "y", "vx", "vy"].map((axis) => live.signal(`${point}.${axis}`, motion)!);
    const omega = live.signal(`${link}.omega`, motion)!;
    const pole = {
      x: omega.map((turn, k) => x![k]! - vy![k]! / turn),
      y: omega.map((turn, k) => y![k]! + vx![k]! / turn),
    };
    // In units of the reach; beyond 1 nothing is drawn. A centre at infinity and one that isn't known are away, too.
    const away = omega.map((_, k) => {
      const far = Math.max(off(pole.x[k]!, across), off(pole.y[k]!, up));
      return Number.isNaN(far) ? Infinity : far;
    });
    cut(away, omega);
    const size = live.data.length;
    const here = (row: Float64Array): Float64Array => row.map((value, k) => (away[k]! <= 1 ? value / size : NaN));
    const fixed = { x: here(pole.x), y: here(pole.y) };
    return { link, point, ...fixed, ...carried(links.find(({ name }) => name === link)!, fixed) };
  });
}

/** Hides one of two poses between which the centre passes through infinity. */
function cut(away: Float64Array, omega: Float64Array): void {
  const farther: number[] = [];
  for (let k = 0; k + 1 < omega.length; k++) {
    if (Math.sign(omega[k]!) * Math.sign(omega[k + 1]!) <= 0) farther.push(away[k]! > away[k + 1]! ? k : k + 1);
  }
  for (const k of farther) away[k] = Infinity;
}

const off = (value: number, { centre, half }: Reach): number => Math.abs(value - centre) / half;

/** The places, horizontal and vertical, that points reach and how far beyond them is still drawn (m). */
function reaches(names: readonly string[], live: LiveModel, motion: Motion): [Reach, Reach] {
  const ends = ["x", "y"].map((axis) => {
    const all = names.flatMap((name) => extent(live.signal(`${name}.${axis}`, motion) ?? []) ?? []);
    return [Math.min(...all), Math.max(...all)] as const;
  });
  const size = Math.max(...ends.map(([low, high]) => high - low));
  const [across, up] = ends.map(([low, high]) => ({ centre: (low + high) / 2, half: (high - low) / 2 + FAR * size }));
  return [across!, up!];
}

/** Places in the world as a link carries them in its own axes. */
function carried({ pose }: LinkData, { x, y }: Record<"x" | "y", Float64Array>): Pick<Centrode, "u" | "v"> {
  const arm = (k: number): [number, number] => [x[k]! - known(pose.x, k)!, y[k]! - known(pose.y, k)!];
  return {
    u: x.map((_, k) => arm(k)[0] * known(pose.c, k)! + arm(k)[1] * known(pose.s, k)!),
    v: x.map((_, k) => arm(k)[1] * known(pose.c, k)! - arm(k)[0] * known(pose.s, k)!),
  };
}
