import assert from "node:assert/strict";
import { test } from "node:test";
import { kept, type TextBox, textBox, widthOf } from "../src/drawing/crowding.ts";

const box = (x: number, y = 0): TextBox => ({ x, y, half: 10, high: 7 });
const at = (...boxes: TextBox[]): TextBox[] => boxes;

test("of texts over one another the first is kept", () => {
  assert.deepEqual(kept([at(box(0)), at(box(12)), at(box(25)), [], at(box(25, 20))], []), [0, -1, 0, -1, 0]);
});

test("one that may be elsewhere goes there, and stays as long as it can", () => {
  assert.deepEqual(kept([at(box(0)), at(box(12), box(12, 20))], []), [0, 1]);
  assert.deepEqual(kept([at(box(0)), at(box(40), box(40, 20))], [0, 1]), [0, 1]);
});

test("one that was left out comes back only with room to spare", () => {
  assert.deepEqual(kept([at(box(0)), at(box(21))], [0, 0]), [0, 0]);
  assert.deepEqual(kept([at(box(0)), at(box(21))], [0, -1]), [0, -1]);
  assert.deepEqual(kept([at(box(0)), at(box(25))], [0, -1]), [0, 0]);
});

test("there are at most so many", () => {
  const many = Array.from({ length: 100 }, (_, i) => at(box(30 * i)));
  const count = (most?: number): number => kept(many, [], most).filter((each) => each >= 0).length;
  assert.equal(count(), 40);
  assert.equal(count(3), 3);
});

test("a box lies where its text is anchored; hanzi are wide", () => {
  assert.equal(textBox(20, 100, 5, "start").x, 110);
  assert.equal(textBox(20, 100, 5, "end").x, 90);
  assert.equal(widthOf("曲柄"), 24);
});
