import assert from "node:assert/strict";
import { test } from "node:test";
import { replacing, withKeys } from "../src/panels/languages.ts";

test("a text is replaced everywhere, or at some of its places in their order", () => {
  const asked = replacing({ Time: "时间", Value: ["数值", null] });
  assert.deepEqual(["Value", "Time", "Value", "Time", "Value"].map(asked), ["数值", "时间", null, "时间", null]);
});

test("a name that objects have by birth is a text like others", () => {
  assert.equal(replacing({})("constructor"), null);
  assert.equal(replacing({})("__proto__"), null);
});

test("the words of another language have the keys of the present one, in the order of their letters", () => {
  const here = { time: "time", texts: { "a.b": "one", 10: "two", 9: "three" }, list: ["x", { of: ["y"], at: [0] }] };
  const there = [["X", [[0, 0], ["Y", "Z"]]], ["Drei", "Zwei", "Eins"].reverse(), "Zeit"];
  assert.deepEqual(withKeys(there, here), {
    time: "Zeit",
    texts: { 10: "Eins", 9: "Zwei", "a.b": "Drei" },
    list: ["X", { at: [0, 0], of: ["Y", "Z"] }],
  });
});
