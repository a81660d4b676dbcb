import assert from "node:assert/strict";
import { test } from "node:test";
import { between, place, poseOf } from "../src/drawing/poses.ts";
import type { LinkData } from "../src/scene/data.ts";

const times = [0, 1, 3, 4, 6];

test("at samples a row has its own values", () => {
  const row = [3, -1, 4, 1, 5];
  row.forEach((value, k) => assert.equal(between(row, times, k, 0), value));
});

test("a straight line stays one, over uneven times too", () => {
  const row = times.map((t) => 2 * t - 1);
  for (const [k, f] of [[1, 0.25], [2, 0.5]] as const) {
    const t = times[k]! + f * (times[k + 1]! - times[k]!);
    assert.ok(Math.abs(between(row, times, k, f)! - (2 * t - 1)) < 1e-12);
  }
});

test("a row of one value never changes", () => {
  assert.equal(between([7], times, 3, 0.9), 7);
});

test("beside a gap there is a value at the sample alone", () => {
  const row = [0, 1, null, 3, 4];
  assert.equal(between(row, times, 1, 0), 1);
  assert.equal(between(row, times, 1, 0.5), null);
  assert.equal(between(row, times, 2, 0.5), null);
  assert.equal(between(row, times, 3, 0.5), 3.5);
});

test("between samples a link isn't stretched", () => {
  const link: LinkData = {
    name: "crank",
    fixed: false,
    points: { A: [0, 0], B: [5, 0] },
    pose: { x: [1, 1], y: [2, 2], c: [1, 0], s: [0, 1] },
  };
  const pose = poseOf(link, [0, 1], 0, 0.5)!;
  assert.ok(Math.abs(Math.hypot(pose.c, pose.s) - 1) < 1e-12);
  const [x, y] = place(pose, [5, 0]);
  assert.ok(Math.abs(Math.hypot(x - 1, y - 2) - 5) < 1e-12);
});

test("a link without a pose at a sample has none", () => {
  const pose = { x: [0, null], y: [0, 0], c: [1, 1], s: [0, 0] };
  assert.equal(poseOf({ name: "a", fixed: false, points: {}, pose }, [0, 1], 1), null);
});
