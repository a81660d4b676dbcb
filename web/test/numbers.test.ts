import assert from "node:assert/strict";
import { test } from "node:test";
import { speeds } from "../src/drawing/speeds.ts";
import { figure, tick } from "../src/plots/figure.ts";
import { nice } from "../src/scene/numbers.ts";
import { locate, nearest } from "../src/scene/times.ts";

test("nice numbers are 1, 2, 5 times a power of ten, and never above", () => {
  const cases = [[1, 1], [1.99, 1], [2, 2], [4.9, 2], [5, 5], [9.99, 5], [10, 10], [0.03, 0.02], [7e-9, 5e-9]] as const;
  for (const [value, found] of cases) assert.ok(Math.abs(nice(value) - found) < 1e-9 * found, `${value}`);
});

test("figures have five digits, a minus sign of their own and a dash for nothing", () => {
  assert.equal(figure(0), "0");
  assert.equal(figure(-3.14159265), "−3.1416");
  assert.equal(figure(123456.7), "123457");
  assert.equal(figure(0.000123456), "0.00012346");
  assert.equal(figure(-1.5e-7), "−1.500e−7");
  assert.equal(figure(null), "–");
  assert.equal(figure(undefined), "–");
});

test("numbers of axes have no round-off", () => {
  assert.equal(tick(0.1 + 0.2), "0.3");
  assert.equal(tick(-20), "−20");
});

test("a time is located between its samples and clamped to the ends", () => {
  const times = [0, 1, 2, 4];
  assert.deepEqual(locate(times, 3), { k: 2, f: 0.5, nearest: 3 });
  assert.deepEqual(locate(times, 1), { k: 1, f: 0, nearest: 1 });
  assert.deepEqual(locate(times, 9), { k: 3, f: 0, nearest: 3 });
  assert.deepEqual(locate(times, -1), { k: 0, f: 0, nearest: 0 });
  assert.deepEqual(locate([5], 5), { k: 0, f: 0, nearest: 0 });
  assert.equal(nearest(times, 2.9), 2);
  assert.equal(nearest(times, 3.1), 3);
  assert.equal(nearest([], 1), 0);
});

test("a cycle of some seconds plays in real time, others in some seconds; real time is always offered", () => {
  assert.equal(speeds(3).usual, 1);
  assert.equal(speeds(0.04).usual, 0.01);
  for (const seconds of [0.04, 3, 500]) {
    const { usual, list } = speeds(seconds);
    assert.ok(list.includes(1) && list.includes(usual));
    assert.deepEqual(list, [...list].sort((a, b) => a - b));
  }
});
