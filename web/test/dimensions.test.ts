import assert from "node:assert/strict";
import { test } from "node:test";
import { between } from "../src/drawing/bars.ts";
import { angleLine, changed, figure, lengthLine } from "../src/drawing/dimension_lines.ts";
import { barrelOf, springPath } from "../src/drawing/springs.ts";
import type { LinkData } from "../src/scene/data.ts";

test("places along a line are dimensioned one after another, those of a plate around it", () => {
  assert.deepEqual(between([[0, 0], [5, 0], [2, 0], [2, 0]]), [[[0, 0], [2, 0]], [[2, 0], [5, 0]]]);
  assert.equal(between([[0, 0], [4, 0], [0, 3]]).length, 3);
  assert.deepEqual(between([[1, 1]]), []);
});

test("a length's line runs beside its bar, an angle's arc around its pin", () => {
  const line = lengthLine([0, 100], [60, 100])!;
  assert.deepEqual(line.middle, [30, 85]);
  assert.ok(line.d.startsWith("M0 85L60 85"));
  assert.equal(lengthLine([0, 0], [3, 3]), null);
  const arc = angleLine([0, 0], 0, Math.PI / 2);
  assert.ok(arc.d.endsWith("A30 30 0 0 0 0 -30"));
  assert.ok(angleLine([0, 0], 0, -1).d.includes("A30 30 0 0 1"));
});

test("a changed value stands behind the one that it was", () => {
  assert.equal(changed(158.2, 155), "155 → 158.2");
  assert.equal(changed(155.0000001, 155), "155");
  assert.equal(changed(155, null), "155");
  assert.equal(figure(-0.5), "−0.5");
  assert.equal(figure(1e-17), "0");
});

test("a strut's barrel has one length, and the rod never leaves it", () => {
  const link = (x: number[]): LinkData => {
    const still = x.map(() => 0);
    return { name: "", fixed: false, points: {}, pose: { x, y: still, c: x.map(() => 1), s: still } };
  };
  const spot = (x: number[]) => ({ link: link(x), local: [0, 0] as const });
  const barrel = barrelOf(spot([0, 0]), spot([60, 100]), [0, 1]);
  assert.ok(Math.abs(barrel - 0.92 * 60) < 1e-9);
  assert.ok(Math.abs(barrelOf(spot([0, 0]), spot([90, 100]), [0, 1]) - 60) < 1e-9);
  for (const end of [60, 100]) assert.ok(springPath([0, 0], [end, 0], "strut", 5, barrel).includes("M55.2 0L"));
});
