import assert from "node:assert/strict";
import { test } from "node:test";
import { HOME, panned, through, zoomed } from "../src/drawing/camera.ts";
import { sameView, type View } from "../src/drawing/view.ts";

const fitted: View = {
  k: 2,
  width: 400,
  height: 300,
  toScreen: ([x, y]) => [50 + 2 * x, 250 - 2 * y],
  toWorld: ([x, y]) => [(x - 50) / 2, (250 - y) / 2],
};
const box = { x0: 0, x1: 150, y0: 0, y1: 100 };

test("without a zoom the view is the fitted one", () => {
  assert.equal(through(fitted, HOME), fitted);
  assert.ok(sameView(through(fitted, { zoom: 1, centre: fitted.toWorld([200, 150]) }), fitted));
});

test("zooming keeps the place of the world under the pointer", () => {
  let camera = HOME;
  for (const [at, factor] of [[[120, 80], 1.7], [[300, 210], 3], [[20, 20], 0.4]] as const) {
    const before = through(fitted, camera).toWorld(at);
    camera = zoomed(camera, fitted, at, factor);
    const after = through(fitted, camera).toScreen(before);
    assert.ok(Math.hypot(after[0] - at[0], after[1] - at[1]) < 1e-9);
  }
  assert.ok(Math.abs(through(fitted, camera).k - 2 * 1.7 * 3 * 0.4) < 1e-12);
});

test("a zoom has bounds", () => {
  assert.equal(zoomed(HOME, fitted, [0, 0], 1e6).zoom, 40);
  assert.equal(zoomed(HOME, fitted, [0, 0], 1e-6).zoom, 0.5);
});

test("panning moves what is drawn with the pointer, as far as the motion goes", () => {
  const camera = zoomed(HOME, fitted, [200, 150], 4);
  const [before, after] = [camera, panned(camera, fitted, [8, -16], box)].map((each) => through(fitted, each));
  assert.deepEqual(after!.toScreen(before!.toWorld([100, 100])), [108, 84]);
  assert.equal(panned(camera, fitted, [1e6, 0], box).centre![0], 0);
  assert.equal(panned(camera, fitted, [0, 1e6], box).centre![1], 100);
});
