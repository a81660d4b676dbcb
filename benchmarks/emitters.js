// Times poses of emitted programs in Node.js: JavaScript, WebAssembly, and a loop of as many multiplications and
// additions. Takes the path of a JSON file (see emitters.py), prints figures as JSON: ns of a pose, round by round.
const fs = require("fs");
const doubles = (path) => new Float64Array(new Uint8Array(fs.readFileSync(path)).buffer);
const task = JSON.parse(fs.readFileSync(process.argv[2], "utf8"));

// One multiplication and one addition for each instruction, in eight chains that don't wait for one another.
function plain(x, out, steps) {
  let a = x[0], b = a + 1, c = a + 2, d = a + 3, e = a + 4, f = a + 5, g = a + 6, h = a + 7;
  for (let k = 0; k < steps; k += 8) {
    a = a * 0.999 + 0.1;
    b = b * 0.998 + 0.2;
    c = c * 0.997 + 0.3;
    d = d * 0.996 + 0.4;
    e = e * 0.995 + 0.5;
    f = f * 0.994 + 0.6;
    g = g * 0.993 + 0.7;
    h = h * 0.992 + 0.8;
  }
  out[0] = a + b + c + d + e + f + g + h;
}

function ways({ javascript, webassembly, x, p, poses, inputs, outputs, instructions }) {
  const from = doubles(x), parameters = doubles(p);
  const rows = Array.from({ length: poses }, (_, i) => from.subarray(i * inputs, (i + 1) * inputs));
  const made = (0, eval)(fs.readFileSync(javascript, "utf8"));
  made.parameters(parameters);
  const { exports } = new WebAssembly.Instance(new WebAssembly.Module(fs.readFileSync(webassembly)));
  const at = exports.free.value, begin = at + parameters.byteLength, end = begin + from.byteLength;
  const bytes = end + 8 * outputs * poses - exports.memory.buffer.byteLength;
  if (bytes > 0) exports.memory.grow(Math.ceil(bytes / 65536));
  new Float64Array(exports.memory.buffer, at).set(parameters);
  new Float64Array(exports.memory.buffer, begin).set(from);
  exports.parameters(at);
  const found = new Float64Array(outputs * poses);
  const to = Array.from({ length: poses }, (_, i) => found.subarray(i * outputs, (i + 1) * outputs));
  const other = new Float64Array(1);
  return {
    found: () => [found, new Float64Array(exports.memory.buffer, end, outputs * poses)],
    runs: {
      plain: () => { for (let i = 0; i < poses; i++) plain(rows[i], other, instructions); },
      javascript: () => { for (let i = 0; i < poses; i++) made.pose(rows[i], to[i]); },
      webassembly: () => exports.poses(poses, begin, end),
    },
  };
}

const figures = task.cases.map((one) => {
  const { runs, found } = ways(one);
  const ns = Object.fromEntries(Object.keys(runs).map((way) => [way, []]));
  for (const run of Object.values(runs)) {
    // Engines compile what is called often: the first runs are to warm up.
    const until = performance.now() + task.warm;
    do run(); while (performance.now() < until);
  }
  for (let round = 0; round < task.rounds; round++) {
    for (const [way, run] of Object.entries(runs)) {
      const start = performance.now();
      run();
      ns[way].push((1e6 * (performance.now() - start)) / one.poses);
    }
  }
  found().forEach((values, k) => fs.writeFileSync(one.out[k], new Uint8Array(values.slice().buffer)));
  return ns;
});
console.log(JSON.stringify(figures));
