import assert from "node:assert/strict";
import { test } from "node:test";
import { kept, type TextBox, textBox, widthOf } from "../src/drawing/crowding.ts";

const box = (x: number, y = 0): TextBox => ({ x, y, half: 10, high: 7 });

test("of texts over one another the first is kept", () => {
  assert.deepEqual(kept([box(0), box(12), box(25), null, box(25, 20)], []), [true, false, true, false, true]);
});

test("one that was left out comes back only with room to spare", () => {
  assert.deepEqual(kept([box(0), box(21)], [true, true]), [true, true]);
  assert.deepEqual(kept([box(0), box(21)], [true, false]), [true, false]);
  assert.deepEqual(kept([box(0), box(25)], [true, false]), [true, true]);
});

test("there are at most so many", () => {
  const many = Array.from({ length: 100 }, (_, i) => box(30 * i));
  assert.equal(kept(many, []).filter(Boolean).length, 40);
  assert.equal(kept(many, [], 3).filter(Boolean).length, 3);
});

test("a box lies where its text is anchored; hanzi are wide", () => {
  assert.equal(textBox("AB", 100, 5, "start").x, 101 + widthOf("AB") / 2);
  assert.equal(textBox("AB", 100, 5, "end").x, 99 - widthOf("AB") / 2);
  assert.equal(widthOf("曲柄"), 24);
});
