// The page's glue: plots, and one time for the drawing and all of them.
// `mechanism` (mechanism.js) and `uPlot` stand in the page before this.
/* global mechanism, uPlot, linkwrightWords */

const { time, scene, plots } = JSON.parse(document.getElementById("data").textContent);
const words = linkwrightWords.texts;
time.label = linkwrightWords.time;
plots.forEach((plot, i) => (plot.title = linkwrightWords.titles[i]));
scene.areas?.forEach((area, i) => (area.name = linkwrightWords.areas[i]));
const DASHES = [[], [7, 3], [2, 3], [10, 3, 2, 3], [5, 2, 1, 2, 1, 2]];
const PAPER = { width: 336, height: 180, scale: 3 };
const HEIGHT = 230;
const MOUSE = ["mousedown", "mouseup", "mousemove", "mouseleave", "mouseenter", "click", "dblclick"];
const DRAG = 6; // pixels that tell a drag from a click

const drawing = mechanism.render({
  model: scene,
  el: document.getElementById("drawing"),
  words,
  time,
  autoplay: true,
});
mechanism.still({ model: scene, el: document.getElementById("still"), words });

const colour = (name) => {
  const from = document.querySelector("#drawing .lw");
  return getComputedStyle(from).getPropertyValue(`--lw-${name}`).trim();
};
const seriesColour = (i) => colour(`c${i % 8}`);
const dash = (i) => DASHES[i % DASHES.length];

/** A value with five significant digits, its width steady while it changes. */
function figure(value) {
  if (value == null) return "–";
  const size = Math.abs(value);
  if (size !== 0 && (size >= 1e6 || size < 1e-4)) return value.toExponential(3).replace("-", "−");
  return value.toFixed(size === 0 ? 0 : Math.max(0, 4 - Math.floor(Math.log10(size)))).replace("-", "−");
}

function nearest(t) {
  const { values } = time;
  let [low, high] = [0, values.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (values[middle] <= t) low = middle;
    else high = middle;
  }
  return t > (values[low] + values[high]) / 2 ? high : low;
}

// ---------------------------------------------------------------- plots

/** Limits of the value axis: round-off around a constant is shown as a constant. */
function limits(u, low, high) {
  if (low == null) return [-1, 1];
  const size = Math.max(Math.abs(low), Math.abs(high));
  const spread = high - low < 1e-8 * size || size < 1e-10 ? Math.max(0.1 * size, size < 1e-10 ? 1 : 0) : 0;
  return uPlot.rangeNum(low - spread, high + spread, 0.08, true);
}

/** Options of one plot; `scale` enlarges all of it, for the finer dots of paper. */
function options(plot, { width, height, scale = 1 }) {
  const font = `${11 * scale}px system-ui, -apple-system, "Segoe UI", Roboto, Arial, "PingFang SC", "Microsoft YaHei", "Noto Sans CJK SC", sans-serif`;
  const axis = {
    font,
    labelFont: font,
    stroke: () => colour("muted"),
    grid: { stroke: () => colour("grid"), width: scale },
    ticks: { stroke: () => colour("line"), width: scale, size: 5 * scale },
    gap: 4 * scale,
    values: (u, splits) => splits.map((value) => String(Number(value.toPrecision(7))).replace("-", "−")),
  };
  const label = linkwrightWords.axis;
  const longest = (u, values) =>
    Math.max(...(values ?? [""]).map((v) => String(v).length), 3) * 6.4 * scale + 14 * scale;
  return {
    width: width * scale,
    height: height * scale,
    padding: [8 * scale, 10 * scale, 0, 0],
    legend: { show: false },
    focus: { alpha: 1 },
    cursor: {
      y: false,
      drag: { x: false, y: false, setScale: false },
      points: { size: 7 },
      bind: Object.fromEntries(MOUSE.map((name) => [name, () => null])), // `point` below takes over
    },
    scales: { x: { time: false }, y: { range: limits } },
    axes: [
      { ...axis, space: 46 * scale, size: 22 * scale, labelSize: 16 * scale, labelGap: 0, label },
      { ...axis, space: 25 * scale, size: longest },
    ],
    series: [
      {},
      ...plot.series.map((series, i) => ({
        label: series.name,
        stroke: () => seriesColour(i),
        width: 1.7 * scale,
        pxAlign: 0,
        dash: dash(i).map((part) => part * scale),
        points: { show: time.values.length < 2 },
      })),
    ],
  };
}

const columns = (plot) => [time.values, ...plot.series.map((series) => series.values)];

function swatch(i) {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("viewBox", "0 0 26 8");
  svg.setAttribute("aria-hidden", "true");
  const line = document.createElementNS("http://www.w3.org/2000/svg", "path");
  line.setAttribute("d", "M0 4H26");
  line.setAttribute("stroke-dasharray", dash(i).join(" "));
  line.style.stroke = `var(--lw-c${i % 8})`;
  svg.append(line);
  return svg;
}

/** One button per series: shows its line and its value at the cursor, and hides or shows it. */
function legend(box, plot, chart) {
  return plot.series.map((series, i) => {
    const button = document.createElement("button");
    button.type = "button";
    button.setAttribute("aria-pressed", "true");
    const name = document.createElement("span");
    name.textContent = series.name;
    const value = document.createElement("output");
    value.setAttribute("aria-live", "off");
    button.append(swatch(i), name, value);
    button.addEventListener("click", () => {
      const shown = button.getAttribute("aria-pressed") !== "true";
      button.setAttribute("aria-pressed", String(shown));
      chart.setSeries(i + 1, { show: shown });
    });
    box.append(button);
    return value;
  });
}

const views = [];
const inSight = new IntersectionObserver((entries) => {
  for (const entry of entries) {
    const view = views.find(({ box }) => box === entry.target);
    view.visible = entry.isIntersecting;
    if (view.visible) view.follow();
  }
});
const sized = new ResizeObserver((entries) => {
  for (const { target } of entries) {
    const { chart, area } = views.find((view) => view.area === target);
    if (area.clientWidth && area.clientWidth !== chart.width)
      chart.setSize({ width: area.clientWidth, height: HEIGHT });
  }
});

let index = 0;

function build(box) {
  const plot = plots[Number(box.dataset.plot)];
  const area = box.querySelector(".chart");
  const chart = new uPlot(
    options(plot, { width: area.clientWidth || 400, height: HEIGHT }),
    columns(plot),
    area,
  );
  const values = legend(box.querySelector(".legend"), plot, chart);
  chart.over.setAttribute("role", "img");
  chart.over.setAttribute("aria-label", linkwrightWords.labels[Number(box.dataset.plot)]);
  const follow = () => {
    const left = chart.valToPos(time.values[index], "x");
    const inside = left >= 0 && left <= chart.over.clientWidth;
    chart.setCursor({ left: inside ? left : -10, top: 0 }, false);
    values.forEach((output, i) => (output.textContent = figure(plot.series[i].values[index])));
  };
  point(chart);
  views.push({ box, plot, area, chart, follow, visible: false });
  inSight.observe(box);
  sized.observe(area);
}

function moved(t) {
  index = nearest(t);
  for (const view of views) if (view.visible) view.follow();
}

// ---------------------------------------------------------------- pointing into a plot

let held = null; // what to go back to when the pointer leaves: {time, playing}

function hold() {
  held ??= { time: drawing.time, playing: drawing.playing };
}

function release() {
  if (!held) return;
  drawing.setTime(held.time);
  if (held.playing) drawing.play();
  held = null;
}

const whole = document.getElementById("whole");

function zoom(from, to) {
  for (const { chart } of views) chart.setScale("x", { min: from, max: to });
  whole.hidden = from === time.values[0] && to === time.values.at(-1);
  requestAnimationFrame(() => moved(time.values[index]));
}

const unzoom = () => zoom(time.values[0], time.values.at(-1));
whole?.addEventListener("click", unzoom);

function point(chart) {
  const { over } = chart;
  const position = (event) => {
    const { left, width } = over.getBoundingClientRect();
    return Math.min(Math.max(event.clientX - left, 0), width);
  };
  const goTo = (event) => drawing.setTime(time.values[nearest(chart.posToVal(position(event), "x"))]);
  let start = null; // where a mouse drag began, in pixels
  const span = (event) => {
    const here = position(event);
    return { left: Math.min(start, here), width: Math.abs(here - start) };
  };
  const select = (left, width) => chart.setSelect({ left, width, top: 0, height: over.clientHeight }, false);

  over.addEventListener("pointermove", (event) => {
    if (event.pointerType !== "mouse" && !event.buttons) return;
    hold();
    goTo(event);
    if (start !== null) {
      const { left, width } = span(event);
      select(left, width > DRAG ? width : 0);
    }
  });
  over.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    hold();
    goTo(event);
    if (event.pointerType === "mouse") {
      over.setPointerCapture(event.pointerId);
      start = position(event);
    } else {
      held = { time: drawing.time, playing: false };
    }
  });
  over.addEventListener("pointerup", (event) => {
    if (start !== null && span(event).width > DRAG) {
      const { left, width } = span(event);
      zoom(chart.posToVal(left, "x"), chart.posToVal(left + width, "x"));
    } else {
      held = { time: drawing.time, playing: false };
    }
    start = null;
    select(0, 0);
  });
  over.addEventListener("pointerleave", () => start === null && release());
  over.addEventListener("pointercancel", () => {
    start = null;
    held = null;
    select(0, 0);
  });
  over.addEventListener("dblclick", unzoom);
}

for (const box of document.querySelectorAll("figure.plot")) build(box);
drawing.on("time", moved);
moved(drawing.time);

// ---------------------------------------------------------------- light and dark, paper

matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
  for (const { chart } of views) chart.redraw(false);
});

let printing = false;

/** Paper gets its own plots: light, of fixed size, and finer than the screen's. */
function toPaper() {
  if (printing) return;
  printing = true;
  document.documentElement.dataset.theme = "light";
  for (const { box, plot, area } of views) {
    const paper = document.createElement("div");
    paper.className = "chart-paper";
    area.after(paper);
    const chart = new uPlot(options(plot, PAPER), columns(plot), document.createElement("div"));
    paper.append(chart.ctx.canvas);
    box.paper = { chart, paper };
  }
  for (const details of document.querySelectorAll("details:not([open])")) {
    details.dataset.opened = "";
    details.open = true;
  }
}

function toScreen() {
  if (!printing) return;
  printing = false;
  delete document.documentElement.dataset.theme;
  for (const { box } of views) {
    box.paper.chart.destroy();
    box.paper.paper.remove();
  }
  for (const details of document.querySelectorAll("details[data-opened]")) {
    delete details.dataset.opened;
    details.open = false;
  }
}

window.addEventListener("beforeprint", toPaper);
window.addEventListener("afterprint", toScreen);
matchMedia("print").addEventListener("change", (event) => (event.matches ? toPaper() : toScreen()));

// ---------------------------------------------------------------- tables for spreadsheets

/** Text to the clipboard; where a browser gives a page from disk none, by a selection. */
async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    const area = document.createElement("textarea");
    area.value = text;
    document.body.append(area);
    area.select();
    document.execCommand("copy");
    area.remove();
  }
}

for (const button of document.querySelectorAll("button.copy")) {
  button.hidden = false;
  const said = button.textContent;
  button.addEventListener("click", async () => {
    await copy(button.dataset.copy);
    button.textContent = words["report.copied"];
    setTimeout(() => (button.textContent = said), 2000);
  });
}

// for the browser's console and for tests
window.linkwright = { drawing, charts: views.map(({ chart }) => chart) };
