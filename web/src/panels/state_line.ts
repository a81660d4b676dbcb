// One sentence on the motion of the moment: how well it closes, or what hinders it and how to mend that.

import { filled, type Say } from "../drawing/words.ts";
import { closureError } from "../live/closure_error.ts";
import type { LiveModel } from "../live/live_model.ts";
import { gapOf } from "../program/gap.ts";
import type { Failure } from "../program/mechanism.ts";
import type { Scene } from "../scene/data.ts";
import { sixDigits } from "../scene/numbers.ts";

export interface StateWords {
  /** Of each condition on numbers what is wrong where it isn't met. */
  readonly faults: readonly string[];
  /** Of each dyad with two modes its links and its outer joints. */
  readonly groups: readonly (readonly [string, string])[];
  /** What there is to say of a dyad that can't close, where it must span too much and where too little. */
  readonly gap: readonly string[];
}

/** What there is to say of the motion of the moment. */
export function stateLine(
  live: LiveModel,
  say: Say,
  unit: string,
  scene: Scene,
  words: StateWords,
): string {
  const { data, motion } = live;
  const { failure } = motion;
  if (!failure) {
    const closes = filled(say("live.closes"), { error: closureError(scene).toExponential(1) });
    const left = live.powerResidual;
    const balances = left === null ? "" : ` ${filled(say("live.balances"), { error: left.toExponential(1) })}`;
    return `${closes}${balances}${live.changed && data.cams ? ` ${say("live.cams")}` : ""}`;
  }
  const apart = failure.kind === "group" && data.by ? gapLine(live, failure, words) : null;
  if (apart) return apart;
  const names: Record<string, string | undefined> = {
    parameter: data.parameters[failure.index],
    drive: data.drives[failure.index],
    group: data.program.groups[failure.index],
    higher: data.program.higher[failure.index]?.group,
    number: data.conditions.places[failure.index],
  };
  const at = `${sixDigits(motion.times[failure.pose]! / data.second)} ${unit}`;
  return filled(say(`live.failed_${failure.kind}`), {
    name: names[failure.kind] ?? "",
    time: at,
    what: failure.kind === "number" ? faultLine(live, failure, words.faults) : "",
  });
}

/** What is wrong with a number, at the values of the moment. */
function faultLine(
  live: LiveModel,
  { index, value = NaN, figures = [] }: Failure,
  faults: readonly string[],
): string {
  const { conditions, numbers } = live.data;
  const others = figures.map((figure, k) => [`f${k}`, sixDigits(figure)] as const);
  const text = filled(faults[index]!, {
    value: sixDigits(value / (conditions.sizes[index] ?? 1)),
    ...Object.fromEntries(others),
  });
  // Numbers of the file stand by names in expressions.
  return text.replace(/n'\d+/g, (name) => {
    const i = numbers.findIndex((number) => number.name === name);
    return i < 0 ? name : `${sixDigits(live.value(i) / numbers[i]!.size)} ${numbers[i]!.unit}`.trim();
  });
}

/** Where a dyad can't close and by how much, as the command line has it; null where the distances don't say it. */
function gapLine(live: LiveModel, { index, pose }: Failure, { groups, gap }: StateWords): string | null {
  const { mechanism, motion, data } = live;
  const { drive, size } = data.by!;
  const { ends, worst, distance, least, most } = gapOf(mechanism, index, motion, pose);
  const wide = most >= 0 && distance > most;
  if (!wide && !(distance < least)) return null;
  const limit = wide ? most : least;
  const value = (time: number): number => mechanism.driveValue(drive, time) / size;
  const [from, far, end] = [value(ends[0]), value(worst), value(ends[1])];
  const turnsBack = far < Math.min(from, end) || far > Math.max(from, end);
  const shown = (metres: number, digits = 6): string => `${Number((metres / data.length).toPrecision(digits))}`;
  return filled(gap[wide ? 0 : 1]!, {
    links: groups[index]![0],
    joints: groups[index]![1],
    from: sixDigits(from),
    to: sixDigits(turnsBack ? far : end), // the drive turns back on its way
    distance: shown(distance),
    limit: shown(limit),
    by: shown(Math.abs(distance - limit), 4),
  });
}
