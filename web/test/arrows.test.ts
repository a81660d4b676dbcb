import assert from "node:assert/strict";
import { test } from "node:test";
import { arrowPath, arrowScale, arrowsOf, longestOf } from "../src/drawing/arrows.ts";
import { readout } from "../src/drawing/readout.ts";
import { survey } from "../src/drawing/survey.ts";
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
    name: "B", at: [0, 2], speed: { value: 3, unit: "mm/s" }, reaction: null,
  });
  assert.deepEqual(readout(facts, pin("A"), 0, 0)?.reaction, { value: 10, unit: "N" });
});
