// Runs a mechanism as the page does, one command a line: paths of the emitted code and of the page's data, and `sets` of
// free parameters, one after another (it writes parameters, rows and reaches of each set, and answers with the failures),
// or `drags` of points to targets.
import fs from "node:fs";
import readline from "node:readline";
import { drag } from "../../web/src/program/drag.ts";
import { Mechanism } from "../../web/src/program/mechanism.ts";

const doubles = (path) => new Float64Array(new Uint8Array(fs.readFileSync(path)).buffer);

function mechanismOf({ code, data }) {
  const { times, ...page } = JSON.parse(fs.readFileSync(data, "utf8"));
  return new Mechanism(page, (0, eval)(fs.readFileSync(code, "utf8")), times);
}

function dragged(command) {
  const mechanism = mechanismOf(command);
  return command.drags.map(({ free, time, point, target, freedom }) => {
    const found = drag(mechanism, free, time, point, target, { times: [time, time], ...freedom });
    return { ...found, free: [...found.free] };
  });
}

function run({ sets, out, ...paths }) {
  const mechanism = mechanismOf(paths);
  const page = mechanism.data;
  const from = doubles(sets);
  const [parts, failures, ends] = [[], [], []];
  const count = page.free.length;
  for (let i = 0; i < (count ? from.length / count : 1); i++) {
    const motion = mechanism.run(from.subarray(i * count, (i + 1) * count));
    const measured = motion.measured.flatMap(({ values, rates }) => [values, rates]);
    parts.push(motion.parameters, ...motion.rows, ...motion.reaches, ...measured);
    failures.push(motion.failure);
    ends.push(motion.times.at(-1));
  }
  fs.writeFileSync(out, Buffer.concat(parts.map((part) => Buffer.from(part.buffer, part.byteOffset, part.byteLength))));
  return { failures, ends };
}

readline.createInterface({ input: process.stdin }).on("line", (line) => {
  let answer;
  try {
    const command = JSON.parse(line);
    answer = command.drags ? { drags: dragged(command) } : run(command);
  } catch (error) {
    answer = { error: String(error.stack) };
  }
  process.stdout.write(JSON.stringify(answer) + "\n");
});
