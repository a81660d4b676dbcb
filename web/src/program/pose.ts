// One pose of a mechanism, whose parameters may be moved: where its points lie, and how they move.

import type { ProgramData, Program } from "./data.ts";
import { closed, type Placed } from "./drag.ts";
import { type HigherGroups, PATIENCE } from "./higher_groups.ts";

/** What a pose asks of its mechanism. */
export interface Owner {
  readonly data: ProgramData;
  only(kind: keyof ProgramData["programs"]): Program;
  /** Let programs know all parameters. */
  tell(parameters: Float64Array): void;
  /** Put drives, branches, and what else depends on the time alone into a pose's inputs. */
  drive(time: number, x: Float64Array): void;
  derived(free: ArrayLike<number>): Float64Array;
}

export class Pose {
  private readonly owner: Owner;
  private readonly higher: HigherGroups;
  time: number;
  private readonly x: Float64Array;
  private readonly out: Float64Array;
  private free: Float64Array;
  private p: Float64Array;

  /** `higher` stand at the pose already. */
  constructor(owner: Owner, higher: HigherGroups, free: ArrayLike<number>, time: number) {
    [this.owner, this.higher, this.time] = [owner, higher, time];
    this.free = Float64Array.from(free);
    this.p = owner.derived(free).slice();
    this.x = new Float64Array(2 * owner.data.inputs);
    this.out = new Float64Array(4 * owner.data.points.length + 2 * owner.data.groups.length);
    this.look();
  }

  /** Move to other values of the free parameters and another time. False, and back to where it was, where groups would
   * open. */
  move(free: Float64Array, time = this.time): boolean {
    const { data } = this.owner;
    const [from, before, since] = [this.p, this.free, this.time];
    const goal = this.owner.derived(free).slice();
    if (data.higher.length) {
      const kept = this.higher.kept();
      const onTheWay = (share: number, x: Float64Array): void => {
        const there = share < 1 ? goal.map((end, i) => from[i]! + share * (end - from[i]!)) : goal;
        this.owner.tell(there);
        this.owner.drive(since + share * (time - since), x);
      };
      this.higher.restart(onTheWay);
      if (!this.higher.advance(onTheWay, 1, PATIENCE)) {
        this.higher.restore(kept);
        this.owner.tell(from);
        return false;
      }
    }
    [this.free, this.p, this.time] = [Float64Array.from(free), goal, time];
    if (this.look()) return true;
    [this.free, this.p, this.time] = [before, from, since];
    this.look();
    return false;
  }

  /** Where a point lies (m) and how it moves with each free parameter, and last with the time. */
  place(point: number): Placed {
    const { data } = this.owner;
    const [count, at] = [data.free.length, 4 * point];
    const [program, slopes] = [this.owner.only("dragged"), this.owner.only("slopes")];
    const given = new Float64Array(2 * count);
    given.set(this.free);
    const both = new Float64Array(2 * data.parameters);
    both.set(this.p);
    const along = both.subarray(data.parameters);
    const [laws, x] = [this.owner.only("law_slopes"), this.x.slice()];
    const drives = x.subarray(data.inputs, data.inputs + data.drives.count * data.drives.width);
    const moves = Array.from({ length: count }, (_, i) => {
      given.fill(0, count);
      given[count + i] = 1;
      slopes.pose(given, along);
      laws.parameters(both);
      laws.pose([this.time], drives);
      program.parameters(both);
      program.pose(x, this.out);
      return Float64Array.of(this.out[at + 1]!, this.out[at + 3]!);
    });
    along.fill(0);
    program.parameters(both);
    program.pose(this.flowing(), this.out);
    moves.push(Float64Array.of(this.out[at + 1]!, this.out[at + 3]!));
    return { x: this.out[at]!, y: this.out[at + 2]!, slopes: moves };
  }

  /** The inputs, with drives that go on as they do. */
  private flowing(): Float64Array {
    const { drives, inputs } = this.owner.data;
    const x = this.x.slice();
    for (let i = 0; i < drives.count; i++) x[inputs + i * drives.width] = x[i * drives.width + 1]!;
    return x;
  }

  /** All points and reaches at the parameters of the moment; whether all groups are closed. */
  private look(): boolean {
    const { data } = this.owner;
    this.owner.tell(this.p);
    this.owner.drive(this.time, this.x.subarray(0, data.inputs));
    this.higher.fill(this.x);
    const both = new Float64Array(2 * data.parameters);
    both.set(this.p);
    this.owner.only("dragged").parameters(both);
    this.owner.only("dragged").pose(this.x, this.out);
    const first = 4 * data.points.length;
    const known = this.out.subarray(0, first).every((value, i) => i % 2 === 1 || Number.isFinite(value));
    return known && closed(data.groups.map((_, i) => this.out[first + 2 * i]!));
  }
}
