import assert from "node:assert/strict";
import { test } from "node:test";
import { type Choice, keyOf, overlaid, read, without, written } from "../src/plots/choice.ts";
import { chartSvg } from "../src/plots/chart_svg.ts";
import { csvText, fileUnit } from "../src/plots/csv.ts";
import { curvesOf, overSignal, overTime } from "../src/plots/curves.ts";
import { extent } from "../src/scene/numbers.ts";
import { monotonePieces, sampleAt } from "../src/plots/monotone.ts";
import { polarView } from "../src/plots/polar.ts";
import { search } from "../src/plots/search.ts";
import { recordedSignals, type Signals } from "../src/plots/signals.ts";
import { ticks } from "../src/plots/ticks.ts";
import { areVectors, magnitudes, partner, vectorName } from "../src/plots/vectors.ts";

const listed = (name: string, unit = "mm", element = "point (crank)") => ({ name, unit, element });

test("a search puts names that begin with the words first, and asks for all words", () => {
  const speed = listed("e2.vx", "mm/s");
  const entries = [listed("com(E).x"), listed("BE.x"), listed("E.x"), speed, listed("force(a, E).x", "N")];
  assert.deepEqual(search(entries, "e").map(({ name }) => name), ["E.x", "e2.vx", "com(E).x", "force(a, E).x", "BE.x"]);
  assert.deepEqual(search(entries, "e mm/s").map(({ name }) => name), ["e2.vx"]);
  assert.deepEqual(search(entries, "E.x").map(({ name }) => name), ["E.x", "BE.x"]);
  assert.deepEqual(search(entries, "nothing"), []);
  assert.equal(search(entries, " ").length, entries.length);
});

test("a search finds what a plot calls a signal, and forces by either order of their links", () => {
  const force = { ...listed("force(guide, slider).x", "N", "joint"), quantity: "滑块对导杆的力" };
  const entries = [{ ...listed("E.vx", "mm/s", "点 (coupler)"), quantity: "点 E：速度" }, force, listed("E.x")];
  const found = (query: string): string[] => search(entries, query).map(({ name }) => name);
  assert.deepEqual(found("速度"), ["E.vx"]);
  assert.deepEqual(found("力"), ["force(guide, slider).x"]);
  assert.deepEqual(found("force(slider, guide).x"), ["force(guide, slider).x"]);
  assert.deepEqual(found("force(slider, crank).x"), []);
});

test("values that go up and down fall into monotone pieces that meet", () => {
  assert.deepEqual(monotonePieces([0, 1, 2, 1, 0, 1]), [[0, 2], [2, 4], [4, 5]]);
  assert.deepEqual(monotonePieces([0, 1, 1, 2]), [[0, 3]]);
  assert.deepEqual(monotonePieces([0, 1, null, 3, 2]), [[0, 1], [3, 4]]);
  assert.deepEqual(monotonePieces([]), []);
  assert.deepEqual(monotonePieces([5, 5]), [[0, 1]]);
});

test("a place on the axis is the sample of the piece that is next to the one before", () => {
  const values = [0, 10, 20, 30, 20, 10, 0];
  const pieces = monotonePieces(values);
  assert.equal(sampleAt(values, pieces, 11, 0), 1);
  assert.equal(sampleAt(values, pieces, 11, 6), 5);
  assert.equal(sampleAt(values, pieces, 99, 5), 3);
  assert.equal(sampleAt([null, null], [], 1, 0), 0);
});

test("extents leave gaps out", () => {
  assert.deepEqual(extent([3, null, -1, NaN]), [-1, 3]);
  assert.equal(extent([null]), null);
  assert.deepEqual(extent([3, 8, -1], (k) => k < 2), [3, 8]);
});

test("ticks are round and as many as asked for", () => {
  assert.deepEqual(ticks(0, 1, 5), [0, 0.2, 0.4, 0.6, 0.8, 1]);
  assert.deepEqual(ticks(2, 2, 5), [2]);
  for (const [low, high, count] of [[-3.3, 8.1, 4], [1e-7, 2e-7, 6], [-900, 1300, 3]] as const) {
    const found = ticks(low, high, count);
    assert.ok(found.length >= 2 && found.length <= 1.6 * count + 2, `${found}`);
    assert.ok(found.every((value) => value >= low * (1 - 1e-9) - 1e-12 && value <= high + 1e-9));
  }
});

test("vectors are pairs of components", () => {
  assert.equal(partner("E.vx"), "E.vy");
  assert.equal(partner("force(a, b).x"), "force(a, b).y");
  assert.equal(partner("E.vy"), null);
  assert.equal(partner("motor.torque"), null);
  assert.equal(vectorName("E.vx"), "E.v");
  assert.equal(vectorName("force(a, b).x"), "force(a, b)");
  assert.ok(areVectors(["E.x", "E.y", "F.ax", "F.ay"]));
  assert.ok(!areVectors(["E.x", "F.y"]));
  assert.deepEqual(magnitudes([3, null], [4, 1]), [5, null]);
});

const own: Choice[] = [
  { of: keyOf(["E.x", "E.y"]), signals: ["E.x", "E.y"], view: "components", top: true, open: true },
  { of: "m.angle", signals: ["m.angle"], view: "components", top: false, open: false },
];
const point = [{ name: "E.x", values: [3, 0, -3] }, { name: "E.y", values: [4, null, 4] }];
const plots = [
  { title: "", group: "motion", unit: "mm", series: point },
  { title: "", group: "motion", unit: "deg", series: [{ name: "m.angle", values: [0, 90, 0] }] },
  { title: "", group: "force", unit: "N·m", series: [{ name: "=m.<torque", values: [1, 2, 3] }] },
] as const;
const signals: Signals = { ...recordedSignals(plots), axes: ["m.angle"] };

test("choices survive being written and read, what isn't there any more is left out", () => {
  const chosen = [own[0]!, overlaid(own[1]!, ["E.x"]), { ...own[0]!, of: "", view: "polar" as const }];
  const text = written({ axis: "m.angle", plots: chosen }, own);
  assert.deepEqual(read(text, own, signals), { axis: "m.angle", plots: chosen });
  assert.equal(JSON.parse(text).plots.length, 2);
  const gone = text.replaceAll("E.x", "gone.x").replace('"axis":"m.angle"', '"axis":"gone"');
  const left = read(gone, own, signals);
  assert.equal(left.axis, "");
  assert.deepEqual(left.plots.slice(0, 2).map((each) => each.signals), [["E.x", "E.y"], ["m.angle"]]);
  const others = ['{"version":2,"plots":[]}', '{"version":1,"plots":[null,{"of":1}]}'];
  for (const bad of [null, "", "{", "null", "[1]", ...others]) {
    assert.deepEqual(read(bad, own, signals).plots, own);
  }
});

test("a signal leaves a plot, in polar plots with its vector", () => {
  assert.deepEqual(without(own[0]!, "E.y").signals, ["E.x"]);
  const two: Choice = { ...own[0]!, signals: ["E.x", "E.y", "F.x", "F.y"], view: "polar" };
  assert.deepEqual(without(two, "F.x").signals, ["E.x", "E.y"]);
});

const times = [0, 0.5, 1];
const time = overTime(times, "t", "s", "time, s");
const choice = (names: readonly string[], view: Choice["view"] = "components"): Choice => ({
  ...own[0]!,
  signals: names,
  view,
});

test("curves of two units have two sides", () => {
  const made = curvesOf(choice(["E.x", "m.angle"]), "", signals, time, times);
  assert.deepEqual(made.units, ["mm", "deg"]);
  assert.deepEqual(made.curves.map(({ right }) => right), [false, true]);
  assert.equal(made.title, "E.x, m.angle");
});

test("a table has the time, the axis and all curves, its units as files spell them", () => {
  const over = overSignal("m.angle", signals);
  const made = curvesOf(choice(["E.x", "E.y"]), "", signals, over, times);
  assert.equal(csvText(made, time, ""), "t [s],m.angle [deg],E.x [mm],E.y [mm]\n0,0,3,4\n0.5,90,0,\n1,0,-3,4\n");
  const torque = curvesOf(choice(["=m.<torque"]), "", signals, time, times);
  const lines = csvText(torque, time, "Changed:\nnot").split("\n");
  assert.deepEqual(lines.slice(0, 2), ["# Changed: not", "t [s],'=m.<torque [N*m]"]);
  assert.equal(fileUnit("mm/s²"), "mm/s^2");
  const vector = curvesOf(choice(["E.x", "E.y"], "polar"), "", signals, time, times);
  assert.equal(csvText(vector, time, "").split("\n")[0], "t [s],E x [mm],E y [mm],|E| [mm]");
});

test("a picture is sound XML whatever names are, with its note and all curves in sight", () => {
  const colour = (name: string): string => `#${name}`;
  const base = { width: 400, height: 240, colour, window: [0, 1] as const, index: 0 };
  const torque = curvesOf(choice(["=m.<torque", "E.x"]), "", signals, time, times);
  const svg = chartSvg(torque, { ...base, note: "Changed: not verified", shown: () => true });
  assert.ok(svg.includes("=m.&lt;torque N·m") && !svg.includes("<torque"));
  assert.ok(svg.includes("Changed: not verified"));
  assert.equal(svg.match(/stroke="#c[01]"[^/]* stroke-width="1.7"/g)?.length, 2);
  const hidden = chartSvg(torque, { ...base, note: "", shown: (i) => i === 0 });
  assert.equal(hidden.match(/stroke="#c[01]"[^/]* stroke-width="1.7"/g)?.length, 1);
  const vector = curvesOf(choice(["E.x", "E.y"], "polar"), "", signals, time, times);
  const polar = chartSvg(vector, { ...base, note: "", shown: () => true });
  assert.ok(polar.includes('class="arrow"'));
});

test("a polar plot has the same scale along both axes and the origin in it", () => {
  const view = polarView([{ name: "", x: [100, 200], y: [50, 60], ghost: null }], 300, 200);
  assert.ok(Math.abs(view.x(1) - view.x(0) - (view.y(0) - view.y(1))) < 1e-9);
  assert.ok(view.x(0) > 0 && view.x(200) < 300 && view.y(0) < 200 && view.y(60) > 0);
});
