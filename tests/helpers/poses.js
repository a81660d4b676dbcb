// Runs programs over poses, one command a line: paths of the program and of arrays of doubles, poses one after another.
const fs = require("fs");
const doubles = (path) => new Float64Array(new Uint8Array(fs.readFileSync(path)).buffer);
require("readline")
  .createInterface({ input: process.stdin })
  .on("line", (line) => {
    let answer = "";
    try {
      const { program, x, p, out, poses, inputs, parameters, outputs } = JSON.parse(line);
      const made = (0, eval)(fs.readFileSync(program, "utf8"));
      const from = doubles(x), with_ = doubles(p), to = new Float64Array(poses * outputs);
      const each = with_.length > parameters;
      for (let i = 0; i < poses; i++) {
        if (i === 0 || each) made.parameters(with_.subarray(i * parameters, (i + 1) * parameters));
        made.pose(from.subarray(i * inputs, (i + 1) * inputs), to.subarray(i * outputs, (i + 1) * outputs));
      }
      fs.writeFileSync(out, new Uint8Array(to.buffer));
    } catch (error) {
      answer = String(error.stack);
    }
    process.stdout.write(JSON.stringify(answer) + "\n");
  });
