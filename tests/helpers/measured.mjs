// Takes measures by the rules that pages have, one command a line: the measures, the times, values and rates of the rows.
import { createInterface } from "node:readline";
import { figures, RULES } from "../../web/src/measures/registry.ts";
import { met } from "../../web/src/measures/requirement.ts";

const numbers = (row) => row.map((value) => (value === null ? NaN : value));
createInterface({ input: process.stdin }).on("line", (line) => {
  let answer;
  try {
    const { measures, t, values, rates } = JSON.parse(line);
    const known = values.map((row, k) => ({ values: Float64Array.from(numbers(row)), rates: Float64Array.from(numbers(rates[k])) }));
    answer = measures.map((measure) => {
      const found = figures(measure, t, (row) => known[row]);
      return { figures: found ?? null, met: measure.requirement && met(measure.requirement, found, (row) => known[row]) };
    });
    answer = { rules: Object.keys(RULES), answer };
  } catch (error) {
    answer = { error: String(error.stack) };
  }
  process.stdout.write(JSON.stringify(answer) + "\n");
});
