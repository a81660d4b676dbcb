import assert from "node:assert/strict";
import { test } from "node:test";
import { signalsOf, timesOf } from "../src/live/packed.ts";

test("times at equal distances have the digits of the file's", () => {
  assert.deepEqual(timesOf({ from: 0, to: 0.3, count: 4 }), [0, 0.1, 0.2, 0.3]);
  assert.deepEqual(timesOf({ from: 1, to: 1, count: 1 }), [1]);
  assert.deepEqual(timesOf([0, 0.5, 2]), [0, 0.5, 2]);
});

test("signals are named by their elements", () => {
  const owners = [
    ["point", "crank", "B", 0],
    ["force", "a, b", "force(a, b)", 0],
    ["energy", "", "", 1],
  ] as const;
  const { signals, owners: elements } = signalsOf({ owners, endings: [["x", "y"], ["energy"]] });
  assert.deepEqual(signals, ["B.x", "B.y", "force(a, b).x", "force(a, b).y", "energy"]);
  assert.deepEqual(elements.map(({ count }) => count), [2, 2, 1]);
});
