// Bundles what pages need, for `python3 dev.py web`: node build.ts FOLDER BANNER. Files lie below FOLDER as they do in
// the package; each begins with BANNER, but for the licence of what is bundled.

import { cp, readFile } from "node:fs/promises";
import { join } from "node:path";
import { type BuildOptions, build, type Plugin } from "esbuild";

const [folder, banner] = process.argv.slice(2);
if (folder === undefined || banner === undefined) throw new Error("usage: node build.ts FOLDER BANNER");

const here = import.meta.dirname;

/** What no plot uses of uPlot, 10 kB of each page: axes of dates, stepped lines, bars, splines, joined tables. Each
 * pattern with how often it stands in uPlot's file. */
const UNUSED: readonly (readonly [RegExp, string, number])[] = [
  [/const FEAT_TIME += true;/g, "const FEAT_TIME = false;", 1],
  [/let isTime = .*;/g, "", 3],
  [/isTime/g, "false", 7],
  [/const (\[ timeIncrs\w+, .*\]|_tzDate|_fmtDate|_timeAxisSplits|_timeAxisVals|_timeSeriesVal) +=.*;/g, "", 7],
  [/uPlot\.(join|fmtDate|tzDate) +=.*;/g, "", 3],
  [/\(paths\.(stepped|bars|spline) +=.*\);/g, "", 3],
];
const usedParts: Plugin = {
  name: "the parts of uPlot that plots use",
  setup(loading) {
    loading.onLoad({ filter: /uPlot\.esm\.js$/ }, async ({ path }) => {
      let contents = await readFile(path, "utf8");
      for (const [pattern, kept, count] of UNUSED) {
        const times = contents.match(pattern)?.length ?? 0;
        if (times !== count) throw new Error(`uPlot has ${pattern} ${times} times, not ${count}`);
        contents = contents.replaceAll(pattern, kept);
      }
      return { contents };
    });
  },
};

const shared: BuildOptions = {
  absWorkingDir: here,
  bundle: true,
  minify: true,
  charset: "utf8",
  target: "es2022",
  legalComments: "none", // the report's page has the licence of what it contains
  banner: { js: banner, css: banner },
  logLevel: "warning",
  plugins: [usedParts],
};

/** A script of our own pages. */
const page = (entry: string, outfile: string, define: Record<string, string> = {}) =>
  build({
    ...shared,
    define: { "globalThis.DRAWING_STYLES": "undefined", ...define },
    entryPoints: [`src/entry/${entry}.ts`],
    format: "iife",
    outfile: join(folder, outfile),
  });

/** The style sheet of drawings: a file for pages, a constant for widgets. */
const drawing = { ...shared, entryPoints: ["src/drawing/drawing.css"] };
const { outputFiles } = await build({ ...drawing, banner: {}, write: false });

await Promise.all([
  page("languages", "presentation/assets/languages.js"),
  page("report", "report/assets/report.js", { "globalThis.WITHOUT_STUDIES": "true" }),
  page("report_studies", "report/assets/report_studies.js"),
  page("sheet", "exports/process_simulate/sheet.js"),
  build({
    ...shared,
    entryPoints: ["src/entry/widget.ts"],
    format: "esm",
    define: { "globalThis.DRAWING_STYLES": JSON.stringify(outputFiles[0]!.text.trim()) },
    outfile: join(folder, "report/assets/mechanism.js"),
  }),
  build({ ...drawing, outfile: join(folder, "report/assets/lw.css") }),
  build({
    ...shared,
    entryPoints: ["uplot/dist/uPlot.min.css"],
    outfile: join(folder, "report/assets/uplot.min.css"),
  }),
  cp(join(here, "node_modules/uplot/LICENSE"), join(folder, "report/assets/LICENSE.uplot.txt")),
]);
