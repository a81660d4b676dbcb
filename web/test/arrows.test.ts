import assert from "node:assert/strict";
import { test } from "node:test";
import { arrowPath, arrowScale, arrowsOf, longestOf } from "../src/drawing/arrows.ts";
import { turnPath } from "../src/drawing/moments.ts";
import { arrowAt } from "../src/drawing/pick.ts";
import { readout, valueOf } from "../src/drawing/readout.ts";
import { survey } from "../src/drawing/survey.ts";
import { fit } from "../src/drawing/view.ts";
import type { Scene } from "../src/scene/data.ts";

const scene: Scene = {
  length_unit: "mm",
  time: [0, 1],
  links: [
    { name: "frame", fixed: true, points: { A: [0, 0] }, pose: { x: [0], y: [0], c: [1], s: [0] } },
    { name: "crank", fixed: false, points: { A: [0, 0], B: [2, 0] }, pose: { x: [0], y: [0], c: [1, 0], s: [0, 1] } },
  ],
  joints: [{ kind: "revolute", name: "A", links: ["frame", "crank"], points: ["A", "A"] }],
  traces: [],
  arrows: [
    { kind: "velocity", name: "B", unit: "mm/s", rows: ["B.vx", "B.vy"], at: ["crank", "B"] },
    { kind: "reaction", name: "force(frame, crank)", unit: "N", rows: ["F.x", "F.y"], at: ["frame", "A"] },
    { kind: "load", name: "push", unit: "N", rows: ["P.x", "P.y"], places: ["P.at_x", "P.at_y"] },
    { kind: "load", name: "unknown", unit: "N", rows: ["Q.x", "Q.y"], at: ["crank", "B"] },
  ],
  values: {
    "B.vx": [0, -3], "B.vy": [4, 0], "F.x": [6, 0], "F.y": [8, 1], "P.x": [0, 0], "P.y": [-5, NaN],
    "P.at_x": [1, 1], "P.at_y": [0, 0],
  },
};

test("arrows are those whose rows are known; the longest of each kind scales them", () => {
  const facts = survey(scene);
  assert.deepEqual(facts.arrows.map(({ data }) => data.name), ["B", "force(frame, crank)", "push"]);
  assert.deepEqual([...longestOf(facts.arrows)], [
    ["velocity", { value: 4, unit: "mm/s" }],
    ["reaction", { value: 10, unit: "N" }],
    ["load", { value: 5, unit: "N" }],
  ]);
  assert.equal(arrowScale(facts.longest, "reaction", 1, 1000), 7);
  assert.equal(arrowScale(facts.longest, "reaction", 2, 360), 8);
  assert.equal(arrowScale(facts.longest, "weight", 1, 1000), 0);
  assert.deepEqual(arrowsOf({ ...scene, values: {} }, facts.links), []);
});

test("a changed scene keeps the scale", () => {
  const facts = survey({ ...scene, values: { ...scene.values, "F.x": [60, 0] } }, survey(scene));
  assert.equal(facts.longest.get("reaction")?.value, 10);
});

test("an arrow begins at its place and its tip is off by the vector; a tiny one isn't drawn", () => {
  assert.equal(arrowPath([10, 20], [30, 0]), "M10 20L31 20L31 23.6L40 20L31 16.4L31 20Z");
  assert.equal(arrowPath([10, 20], [0, 0.5]), "");
  assert.equal(arrowPath([10, 20], [NaN, 0]), "");
});

test("a readout has place, speed and the largest reaction of a pin", () => {
  const facts = survey(scene);
  const pin = (name: string) => facts.pins.find((each) => each.name === name)!;
  assert.deepEqual(readout(facts, pin("B"), 1, 0), {
    name: "B", at: [0, 2], speed: { value: 3, unit: "mm/s" }, reaction: null, moments: [],
  });
  assert.deepEqual(readout(facts, pin("A"), 0, 0)?.reaction, { value: 10, unit: "N" });
});

const turned: Scene = {
  ...scene,
  arrows: [
    ...scene.arrows!,
    { kind: "moment", name: "motor.torque", unit: "N·m", rows: ["motor.torque"], at: ["frame", "A"] },
    { kind: "moment", name: "unknown", unit: "N·m", rows: ["other.torque"], at: ["frame", "A"] },
  ],
  values: { ...scene.values, "motor.torque": [-2, 4] },
};

test("a moment has one row, a scale of its own, and stands beside the values of its pin", () => {
  const facts = survey(turned);
  assert.equal(facts.arrows.length, 4);
  assert.deepEqual(facts.longest.get("moment"), { value: 4, unit: "N·m" });
  assert.equal(arrowScale(facts.longest, "moment", 1, 1000), 10);
  assert.equal(arrowScale(facts.longest, "moment", 2, 300), 11);
  assert.deepEqual(valueOf(facts, facts.arrows[3]!, 0, 0), { value: -2, unit: "N·m" });
  const pin = facts.pins.find(({ name }) => name === "A")!;
  assert.deepEqual(readout(facts, pin, 0, 0)?.moments, [["motor.torque", { value: -2, unit: "N·m" }]]);
  assert.deepEqual(readout(facts, facts.pins.find(({ name }) => name === "B")!, 0, 0)?.moments, []);
});

test("a moment's arrow leaves a gap below; negative ones are mirror images", () => {
  const numbers = (path: string): number[] => path.match(/-?[\d.]+/g)!.map(Number);
  const path = turnPath([10, 20], 20);
  assert.match(path, /^M24\.1\d 34\.1\dA20 20 0 1 0 .*A20 20 0 1 1 24\.1\d 34\.1\dZ$/); // counter-clockwise, y is down
  assert.match(turnPath([10, 20], -20), /^M-4\.1\d 34\.1\dA20 20 0 1 1 /);
  assert.equal(numbers(path).length, numbers(turnPath([10, 20], -20)).length);
  assert.equal(turnPath([10, 20], 1.9), "");
  assert.equal(turnPath([10, 20], NaN), "");
});

test("the nearest arrow of the kinds that are seen is found", () => {
  const facts = survey(turned);
  const view = fit(facts, 900, 500);
  const [x, y] = view.toScreen([0, 0]);
  const at = (dx: number, dy: number, kinds: readonly ("moment" | "reaction")[]) =>
    arrowAt(facts, view, new Map(kinds.map((kind) => [kind, 1])), 0, [x + dx, y + dy], 5)?.data.name;
  assert.equal(at(0, -20, ["moment"]), "motor.torque"); // half of the largest, whose radius is 40
  assert.equal(at(0, -27, ["moment"]), undefined);
  assert.equal(at(0, -20, []), undefined);
  assert.equal(at(21, -28, ["moment", "reaction"]), "force(frame, crank)");
});
