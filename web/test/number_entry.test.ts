import assert from "node:assert/strict";
import { test } from "node:test";
import { entered } from "../src/panels/number_entry.ts";

const mm = (text: string): number | null => entered(text, "mm", 1e-3);

test("numbers, arithmetic and units as files have them", () => {
  const near = (text: string, value: number): void => {
    assert.ok(Math.abs((mm(text) ?? NaN) - value) < 1e-12 * Math.abs(value), `${text}: ${mm(text)}`);
  };
  for (const text of ["160", " 160 mm", "16 cm", "0.16 m", "2*80", "160+5-5"]) near(text, 160);
  for (const text of ["(100 + 60) mm", "１６０", "1.6e2", "160,0"]) near(text, 160);
  near("−10", -10);
  near("320/2", 160);
  near("-(2-4)*80", 160);
});

test("what is no length", () => {
  const texts = ["", "abc", "160 kg", "2*", "1..2", "160 mm mm", "(160", "1/0", "mm", "160; 5"];
  for (const text of texts) assert.equal(mm(text), null, text);
});

test("other units", () => {
  assert.equal(entered("45 rpm", "rpm", Math.PI / 30), 45);
  assert.ok(Math.abs(entered("1 rad", "deg", Math.PI / 180)! - 180 / Math.PI) < 1e-12);
  assert.equal(entered("5 N*m", "N·m", 1), 5);
  assert.equal(entered("5", "", 1), 5);
});
