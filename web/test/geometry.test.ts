import assert from "node:assert/strict";
import { test } from "node:test";
import { hull, mean, outline, widestGap } from "../src/drawing/geometry.ts";
import type { Point } from "../src/scene/data.ts";

const square: Point[] = [[0, 0], [2, 0], [2, 2], [0, 2]];

test("a hull goes counter-clockwise and leaves out what is inside, on an edge or twice there", () => {
  assert.deepEqual(hull([[1, 1], ...square, [1, 0], [2, 2]]), square);
});

test("a hull of points on a line is its two ends", () => {
  assert.deepEqual(hull([[1, 1], [3, 3], [0, 0]]), [[0, 0], [3, 3]]);
});

test("a hull of one place, given several times, is that place", () => {
  assert.deepEqual(hull([[1, 2], [1, 2 + 1e-9]]), [[1, 2]]);
  assert.deepEqual(hull([]), []);
});

test("every point lies on or left of each side of its hull", () => {
  const points = Array.from({ length: 60 }, (_, i): Point => [Math.sin(i * i), Math.cos(3 * i * i + 1)]);
  const ring = hull(points);
  ring.forEach((a, i) => {
    const b = ring[(i + 1) % ring.length]!;
    for (const p of points) assert.ok((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > -1e-8);
  });
});

test("an outline is a circle, a rounded bar or a rounded plate", () => {
  assert.equal(outline([[5, 5]], 2), "M3 5a2 2 0 1 1 4 0a2 2 0 1 1 -4 0Z");
  assert.equal(outline([[0, 0], [10, 0]], 1), "M0 -1L10 -1A1 1 0 0 1 10 1L0 1A1 1 0 0 1 0 -1Z");
  assert.equal(outline(square, 1).match(/A/g)?.length, 4);
  assert.equal(outline([], 1), "");
});

test("the middle of the widest gap of a bar is found whichever way its points are named", () => {
  const points: Point[] = [[10, 0], [0, 0], [3, 0]];
  assert.deepEqual(widestGap([[0, 0], [10, 0]], points), [6.5, 0]);
  assert.deepEqual(widestGap([[10, 0], [0, 0]], points), [6.5, 0]);
  assert.deepEqual(mean(square), [1, 1]);
});
