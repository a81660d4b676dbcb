import assert from "node:assert/strict";
import { test } from "node:test";
import { csvText } from "../src/plots/csv.ts";
import { familyCurves, familyOf } from "../src/plots/family.ts";
import { Field } from "../src/plots/field.ts";
import { isolines } from "../src/plots/isolines.ts";
import { placed, unpacked } from "../src/plots/letters.ts";
import { outline } from "../src/plots/outline.ts";
import { planeCsv } from "../src/plots/plane_csv.ts";
import { frameOf } from "../src/plots/plane_frame.ts";
import { inside, readingAt } from "../src/plots/plane_readout.ts";
import { planeSvg } from "../src/plots/plane_svg.ts";
import type { Plane } from "../src/plots/study.ts";
import { studyOf } from "../src/plots/study_data.ts";
import type { RawCharts } from "../src/plots/study_raw.ts";

const BANDS = { levels: [1], colours: ["#000000", "#ffffff"], ratios: false, ends: null };
const axis = (name: number, unit: string) => ({ name, unit });
const RAW: RawCharts = {
  charts: {
    graph: {
      x: axis(0, "s"),
      at: { from: 0, to: 4, count: 5 },
      y: axis(1, "mm"),
      rows: [
        { name: 2, colour: 0, look: "band", values: [1, 2, null, 4, 5], low: [0, 1, null, 3, 4] },
        { name: 3, colour: 9, values: [0, 1, 2, 3, 4], dash: 1 },
        { name: 4, colour: 1, look: "dots", values: [7], of: [3] },
      ],
      limits: [
        { text: 5, value: 3 },
        { text: 5, value: 5, upright: true },
      ],
    },
    bars: {
      x: axis(1, "mm"),
      at: [0.5, 1.5],
      y: axis(2, ""),
      rows: [{ name: 2, colour: 0, look: "bars", values: [3, 4], edges: [0, 1, 2] }],
    },
    plane: {
      x: axis(0, "mm"),
      y: axis(1, "mm"),
      fine: 0.5,
      layers: [
        {
          kind: "field",
          axis: axis(2, "N"),
          x: [0, 1, 2],
          y: [0, 10],
          values: [0, 1, 2, 3, 4, null],
          ...BANDS,
          family: true,
        },
        { kind: "spots", name: 3, colour: "muted", cross: true, x: [2], y: [10] },
      ],
    },
    rings: {
      x: axis(0, "mm"),
      y: axis(1, "mm"),
      fine: 0.5,
      equal: true,
      layers: [{ kind: "region", name: 2, colour: 0, paths: [0] }],
    },
  },
  paths: ["AAEAAEDA"], // from (0, 0) by (2, 0), (0, 2), (-2, 0)
};
const WORDS = ["Title", "t", "v", "range", "line", "dots", "v <= 3"];
const plane = (key: string): Plane => {
  const study = studyOf(RAW, key, WORDS);
  assert.ok("plane" in study);
  return study.plane;
};

test("lines and fields are read from their letters", () => {
  assert.deepEqual([...placed("AAEAAEDA", 0.5)], [0, 0, 1, 0, 1, 1, 0, 1]);
  assert.deepEqual([...placed("iBhB", 1)], [17, -17]);
  assert.deepEqual(unpacked("AAABQA//", 10, 20, false), [null, 10, 10 + (10 * 1023) / 4094, 20]);
  assert.equal(unpacked("//", 1, 1000, true)[0], 1000);
});

test("rows of a graph have their looks, gaps and limits", () => {
  const study = studyOf(RAW, "graph", WORDS);
  assert.ok("curves" in study);
  const { curves, x, levels, uprights, units } = study.curves;
  assert.deepEqual([...Array.from(x.values)], [0, 1, 2, 3, 4]);
  assert.deepEqual(curves.map(({ look }) => [look?.kind, look?.colour, look?.dash]), [
    ["band", "c0", 0],
    ["line", "c1", 1],
    ["dots", "c1", 0],
  ]);
  assert.deepEqual(curves[2]!.values, [null, null, null, 7, null]);
  assert.deepEqual([levels.map(({ value }) => value), uprights?.map(({ value }) => value)], [[3], [5]]);
  assert.deepEqual(units, ["mm"]);
  assert.ok(x.ends[1] > 5, "the axis reaches to its limit");
  const head = csvText(study.curves, { name: x.name, unit: x.unit, values: x.values }, "").split("\n")[0];
  assert.equal(head, "t [s],range min [mm],range max [mm],line [mm],dots [mm]");
});

test("bars stand between their edges, which are columns of the table", () => {
  const study = studyOf(RAW, "bars", WORDS);
  assert.ok("curves" in study);
  const { x, curves } = study.curves;
  const rows = csvText(study.curves, { name: x.name, unit: x.unit, values: x.values }, "").trim().split("\n");
  assert.deepEqual(rows, ["v [mm],v min [mm],v max [mm],range", "0.5,0,1,3", "1.5,1,2,4"]);
  const d = outline(curves[0]!.look!, x.values, curves[0]!.values, (v) => 10 * v, (v) => -v);
  assert.equal(d, "M0.00 0.00V-3.00h9.50V0.00ZM10.00 0.00V-4.00h9.50V0.00Z");
});

test("a band is broken where it has no value", () => {
  const study = studyOf(RAW, "graph", WORDS);
  assert.ok("curves" in study);
  const { x, curves } = study.curves;
  const d = outline(curves[0]!.look!, x.values, curves[0]!.values, (v) => v, (v) => v);
  assert.equal(d.match(/M/g)?.length, 2);
});

test("a field is bilinear, linear in a triangle of three places, and has gaps", () => {
  const field = new Field([0, 1, 2], [0, 10], [0, 1, 2, 3, 4, null], BANDS);
  assert.equal(field.at(0.5, 5), 2);
  assert.equal(field.at(1, 10), 4);
  assert.equal(field.at(1.25, 2.5), 2);
  assert.equal(field.at(1.9, 9), null);
  assert.equal(field.at(3, 5), null);
  assert.deepEqual([...field.bandsOver([0, 1, 1.9], [1, 9])], [0, 1, 1, 1, 1, -1]);
  const ratios = new Field([0, 2], [0, 1], [1, 100, 1, 100], { ...BANDS, ratios: true });
  assert.ok(Math.abs(ratios.at(1, 0.5)! - 10) < 1e-9);
});

test("lines of a level lie on it, closed ones come back", () => {
  const places = Array.from({ length: 41 }, (_, i) => -2 + i / 10);
  const field = new Field(places, places, places.flatMap((y) => places.map((x) => x * x + y * y)), BANDS);
  const lines = isolines(field.finer(1));
  assert.equal(lines.length, 1);
  const [circle] = lines;
  for (let k = 0; k < circle!.length; k += 2) {
    assert.ok(Math.abs(Math.hypot(circle![k]!, circle![k + 1]!) - 1) < 3e-3);
  }
  assert.deepEqual([...circle!.slice(0, 2)], [...circle!.slice(-2)]);
  const saddle = new Field([0, 1], [0, 1], [1, -1, -1, 1], BANDS);
  assert.ok(isolines(saddle.finer(0.2)).length === 2);
  const holed = new Field([0, 1, 2], [0, 1], [0, 2, 0, 0, 2, null], BANDS);
  assert.equal(isolines(holed.finer(1)).length, 2);
});

test("a field is a family of curves, one for each value of the other parameter", () => {
  const shown = plane("plane");
  const { curves, x, units } = familyCurves(shown, familyOf(shown)!);
  assert.deepEqual(curves.map(({ name }) => name), ["v = 0 mm", "v = 10 mm"]);
  assert.deepEqual(curves.map(({ values }) => Array.from(values)), [[0, 1, 2], [3, 4, null]]);
  assert.deepEqual([Array.from(x.values), x.label, units], [[0, 1, 2], "t, mm", ["N"]]);
  assert.equal(familyOf(plane("rings")), null);
});

test("the table of a plane has its places, gaps empty", () => {
  const rows = planeCsv(plane("plane")).trim().split("\n");
  assert.deepEqual(rows, ["t [mm],v [mm],range [N]", "0,0,0", "1,0,1", "2,0,2", "0,10,3", "1,10,4", "2,10,"]);
  assert.deepEqual(planeCsv(plane("rings")).trim().split("\n"), [
    "curve,part,t [mm],v [mm]",
    "range,1,0,0",
    "range,1,1,0",
    "range,1,1,1",
    "range,1,0,1",
  ]);
});

test("what is read at a place is the value there, and nothing outside of the rings", () => {
  const shown = plane("plane");
  const frame = frameOf(shown, shown.box, 400);
  const reading = readingAt(shown, frame, [0.5, 5], () => true);
  assert.deepEqual(reading.values, [{ name: "range", text: "2.0000 N" }]);
  assert.equal(readingAt(shown, frame, [1.95, 9.8], () => true).values[0]!.text, "–");
  const ring = [Float64Array.of(0, 0, 4, 0, 4, 4, 0, 4), Float64Array.of(1, 1, 2, 1, 2, 2, 1, 2)];
  assert.deepEqual([[3, 3], [1.5, 1.5], [5, 1]].map(([x, y]) => inside(ring, [x!, y!])), [true, false, false]);
});

test("a plane of geometry has one scale for both axes, whatever is seen of it", () => {
  const shown = plane("rings");
  for (const box of [shown.box, [0.2, 0.1, 0.4, 0.9]] as const) {
    const { across, up, x, y } = frameOf(shown, box, 500);
    assert.ok(Math.abs(across(1) - across(0) - (up(0) - up(1))) < 1e-9);
    assert.ok(Math.abs(x(across(0.3)) - 0.3) < 1e-12 && Math.abs(y(up(0.7)) - 0.7) < 1e-12);
  }
});

test("texts can't end what they stand in", () => {
  const shown = { ...plane("plane"), limits: [{ value: 5, text: '"><script>' }] };
  const sheet = { width: 400, colour: () => "#000", shown: () => true, picture: () => "", id: "p" };
  const { inside: svg } = planeSvg(shown, frameOf(shown, shown.box, 400), sheet);
  assert.ok(!svg.includes("<script") && svg.includes("&lt;script"));
});
