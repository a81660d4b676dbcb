// Runs a mechanism as the page does, one command a line: paths of the emitted code, of the page's data, and of sets of
// free parameters, one after another. Writes parameters, rows and reaches of each set, and answers with the failures.
import fs from "node:fs";
import readline from "node:readline";
import { Mechanism } from "../../web/src/program/mechanism.ts";

const doubles = (path) => new Float64Array(new Uint8Array(fs.readFileSync(path)).buffer);

function run({ code, data, sets, out }) {
  const { times, ...page } = JSON.parse(fs.readFileSync(data, "utf8"));
  const mechanism = new Mechanism(page, (0, eval)(fs.readFileSync(code, "utf8")), times);
  const from = doubles(sets);
  const [parts, failures] = [[], []];
  const count = page.free.length;
  for (let i = 0; i < (count ? from.length / count : 1); i++) {
    const motion = mechanism.run(from.subarray(i * count, (i + 1) * count));
    parts.push(motion.parameters, ...motion.rows, ...motion.reaches);
    failures.push(motion.failure);
  }
  fs.writeFileSync(out, Buffer.concat(parts.map((part) => Buffer.from(part.buffer, part.byteOffset, part.byteLength))));
  return failures;
}

readline.createInterface({ input: process.stdin }).on("line", (line) => {
  let answer;
  try {
    answer = { failures: run(JSON.parse(line)) };
  } catch (error) {
    answer = { error: String(error.stack) };
  }
  process.stdout.write(JSON.stringify(answer) + "\n");
});
