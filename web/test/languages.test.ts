import assert from "node:assert/strict";
import { test } from "node:test";
import { replacing } from "../src/panels/languages.ts";

test("a text is replaced everywhere, or at some of its places in their order", () => {
  const asked = replacing({ Time: "时间", Value: ["数值", null] });
  assert.deepEqual(["Value", "Time", "Value", "Time", "Value"].map(asked), ["数值", "时间", null, "时间", null]);
});

test("a name that objects have by birth is a text like others", () => {
  assert.equal(replacing({})("constructor"), null);
  assert.equal(replacing({})("__proto__"), null);
});
