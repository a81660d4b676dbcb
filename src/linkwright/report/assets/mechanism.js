// A planar mechanism as an animated SVG drawing, from plain scene data. No dependencies, and one file,
// because notebook widgets and pages opened from disk take a single module.
//
//   const handle = render({ model: scene, el, words, time, autoplay });
//   handle.setTime(t); handle.setIndex(i); handle.on("time", (t, index) => ...); handle.destroy();
//
// `still({ model, el, width, height, ghosts })` draws one pose and faint others, for paper.
// The scene is described in linkwright/report/data.py (class Scene). World: x right, y up, angles in
// radians, counter-clockwise; screen lengths are CSS pixels. A null in a pose: no assembly there.

const NS = "http://www.w3.org/2000/svg";
const PALETTE = 8;
const SECONDS = { s: 1, ms: 1e-3, min: 60, h: 3600 };
const PAD = { x: 46, top: 40, bottom: 58 };
const BLOCK = { length: 30, height: 18 };

// ---------------------------------------------------------------- small tools

function make(tag, attributes = {}, parent = null) {
  const node = document.createElementNS(NS, tag);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  parent?.append(node);
  return node;
}

function html(tag, attributes = {}, parent = null, text = null) {
  const node = document.createElement(tag);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  if (text !== null) node.textContent = text;
  parent?.append(node);
  return node;
}

const round = (value) => Math.round(value * 100) / 100;
const clamp = (value, low, high) => Math.min(Math.max(value, low), high);

/** Largest of 1, 2, 5 times a power of ten that is not above `value`. */
function nice(value) {
  const power = 10 ** Math.floor(Math.log10(value) + 1e-9);
  return [5, 2, 1].map((m) => m * power).find((v) => v <= value * (1 + 1e-9)) ?? power;
}

/** Convex hull (Andrew's monotone chain), counter-clockwise in the plane of its coordinates. */
function hull(points) {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const chain = (list) => {
    const out = [];
    for (const p of list) {
      while (out.length > 1) {
        const [a, b] = out.slice(-2);
        if ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 1e-9) break;
        out.pop();
      }
      if (!out.length || Math.hypot(p[0] - out.at(-1)[0], p[1] - out.at(-1)[1]) > 1e-6) out.push(p);
    }
    return out;
  };
  const lower = chain(sorted);
  const upper = chain(sorted.reverse());
  return lower.length < 2 ? lower : [...lower.slice(0, -1), ...upper.slice(0, -1)];
}

/** Outline of the hull of `points`, a distance r outside it: a circle, a rounded bar or a rounded plate. */
function outline(points, r) {
  const ring = hull(points);
  if (ring.length === 1) {
    const [x, y] = ring[0];
    return `M${round(x - r)} ${round(y)}a${r} ${r} 0 1 1 ${2 * r} 0a${r} ${r} 0 1 1 ${-2 * r} 0Z`;
  }
  let path = "";
  ring.forEach((a, i) => {
    const b = ring[(i + 1) % ring.length];
    const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    const [nx, ny] = [(dy / Math.hypot(dx, dy)) * r, (-dx / Math.hypot(dx, dy)) * r];
    const start = `${round(a[0] + nx)} ${round(a[1] + ny)}`;
    path += i ? `A${r} ${r} 0 0 1 ${start}` : `M${start}`;
    path += `L${round(b[0] + nx)} ${round(b[1] + ny)}`;
    if (i === ring.length - 1) path += `A${r} ${r} 0 0 1 ${path.slice(1, path.indexOf("L"))}Z`;
  });
  return path;
}

// ---------------------------------------------------------------- where things are

/** Value of one pose array at sample k + f, by cubic interpolation through the samples around it. */
function between(values, times, k, f) {
  if (values.length === 1) return values[0];
  const [v0, v1] = [values[k], values[k + 1]];
  if (f === 0 || v0 == null) return v0;
  if (v1 == null) return null;
  const h = times[k + 1] - times[k];
  const slope = (i) => {
    const [a, b] = [values[i - 1], values[i + 1]];
    return a == null || b == null ? v1 - v0 : ((b - a) / (times[i + 1] - times[i - 1])) * h;
  };
  const [m0, m1] = [slope(k), slope(k + 1)];
  const g = 1 - f;
  return v0 * g * g * (1 + 2 * f) + m0 * f * g * g - m1 * f * f * g + v1 * f * f * (3 - 2 * f);
}

/** Pose {x, y, c, s} of a link at sample k + f, or null where it can't be assembled. */
function poseOf(link, times, k, f = 0) {
  const [x, y, c, s] = ["x", "y", "c", "s"].map((key) => between(link.pose[key], times, k, f));
  if (x == null || y == null || c == null || s == null) return null;
  const size = Math.hypot(c, s) || 1;
  return { x, y, c: c / size, s: s / size };
}

const place = (pose, [x, y]) => [pose.x + pose.c * x - pose.s * y, pose.y + pose.s * x + pose.c * y];

/** Points that revolute joints hold together, as one pin each: {name, places: [{link, local}], joints}. */
function pinsOf(scene) {
  const pinAt = new Map();
  const key = (link, point) => JSON.stringify([link, point]);
  for (const link of scene.links) {
    for (const [name, local] of Object.entries(link.points)) {
      pinAt.set(key(link.name, name), { name, places: [{ link, local }], joints: [] });
    }
  }
  for (const joint of scene.joints.filter((j) => j.kind === "revolute")) {
    const [a, b] = joint.links.map((name, i) => pinAt.get(key(name, joint.points[i])));
    if (a !== b) {
      if (a.name !== b.name) a.name = joint.name;
      a.places.push(...b.places);
      a.joints.push(...b.joints);
      for (const [k, pin] of pinAt) if (pin === b) pinAt.set(k, a);
    }
    a.joints.push(joint.name);
  }
  return [...new Set(pinAt.values())];
}

/** Prismatic joints as guide and block, with the block's travel along the guide: {low, high} from its point. */
function guidesOf(scene, links, times) {
  return scene.joints
    .filter((j) => j.kind === "prismatic")
    .map((joint) => {
      const sides = joint.links.map((name, i) => {
        const link = links.get(name);
        return { link, local: link.points[joint.points[i]], angle: joint.angles[i] };
      });
      if (sides[1].link.fixed && !sides[0].link.fixed) sides.reverse();
      const [guide, block] = sides;
      const cylinder = joint.look === "cylinder" && !guide.link.fixed;
      let [low, high] = guide.link.fixed || cylinder ? [Infinity, -Infinity] : [0, 0];
      for (let k = 0; k < times.length; k++) {
        const [carrier, rider] = [poseOf(guide.link, times, k), poseOf(block.link, times, k)];
        if (!carrier || !rider) continue;
        const [ax, ay] = place(carrier, guide.local);
        const [bx, by] = place(rider, block.local);
        const along = Math.atan2(carrier.s, carrier.c) + guide.angle;
        const travel = (bx - ax) * Math.cos(along) + (by - ay) * Math.sin(along);
        [low, high] = [Math.min(low, travel), Math.max(high, travel)];
      }
      if (low > high) [low, high] = [0, 0];
      return { joint, guide, block, low, high, cylinder };
    });
}

const onGuide = ({ local, angle }, travel) => [
  local[0] + travel * Math.cos(angle),
  local[1] + travel * Math.sin(angle),
];

/** What the drawing needs to know once: links by name, pins, guides and the extents of all the motion. */
function survey(scene) {
  const times = scene.time.length ? scene.time : [0];
  const links = new Map(scene.links.map((link) => [link.name, link]));
  const guides = guidesOf(scene, links, times);
  const box = { x0: Infinity, x1: -Infinity, y0: Infinity, y1: -Infinity };
  const include = ([x, y]) => {
    [box.x0, box.x1] = [Math.min(box.x0, x), Math.max(box.x1, x)];
    [box.y0, box.y1] = [Math.min(box.y0, y), Math.max(box.y1, y)];
  };
  const gaps = times.map(() => false);
  for (let k = 0; k < times.length; k++) {
    for (const link of scene.links) {
      const pose = poseOf(link, times, k);
      if (!pose) gaps[k] = true;
      else for (const local of [...Object.values(link.points), ...(link.outlines ?? []).flat()]) include(place(pose, local));
    }
    for (const { guide, low, high } of guides) {
      const pose = poseOf(guide.link, times, k);
      if (pose) for (const travel of [low, high]) include(place(pose, onGuide(guide, travel)));
    }
  }
  for (const trace of scene.traces) {
    trace.x.forEach((x, k) => x != null && trace.y[k] != null && include([x, trace.y[k]]));
  }
  const areas = scene.areas ?? [];
  for (const ring of areas.flatMap((area) => area.rings)) ring.forEach(include);
  if (box.x0 > box.x1) [box.x0, box.x1, box.y0, box.y1] = [-1, 1, -1, 1];
  const narrow = { ...box };
  const centrodes = scene.centrodes ?? [];
  for (const { x, y } of centrodes) x.forEach((each, k) => each != null && include([each, y[k]]));
  const wide = { ...box };
  Object.assign(box, narrow);
  const size = Math.max(box.x1 - box.x0, box.y1 - box.y0) || 1;
  const moving = scene.links.filter((link) => !link.fixed);
  const colour = new Map(moving.map((link, i) => [link, i % PALETTE]));
  return { scene, times, links, guides, box, wide, size, gaps, colour, centrodes, areas, pins: pinsOf(scene) };
}

/** Sample and fraction at a time: {k, f, nearest}. */
function locate(times, t) {
  let [low, high] = [0, times.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= t) low = middle;
    else high = middle;
  }
  if (high === low) return { k: 0, f: 0, nearest: 0 };
  const f = clamp((t - times[low]) / (times[high] - times[low] || 1), 0, 1);
  return f === 1 ? { k: high, f: 0, nearest: high } : { k: low, f, nearest: f < 0.5 ? low : high };
}

// ---------------------------------------------------------------- the drawing

/** The direction (one of eight, screen radians) in which a pin's label meets its links least. */
function labelDirection(pin, facts) {
  const busy = [];
  const step = Math.max(1, Math.floor(facts.times.length / 16));
  for (let k = 0; k < facts.times.length; k += step) {
    for (const { link, local } of pin.places) {
      const pose = poseOf(link, facts.times, k);
      if (!pose || link.fixed) continue;
      const here = place(pose, local);
      for (const other of Object.values(link.points)) {
        const [x, y] = place(pose, other);
        if (Math.hypot(x - here[0], y - here[1]) > 1e-6 * facts.size) {
          busy.push(Math.atan2(-(y - here[1]), x - here[0]));
        }
      }
    }
  }
  if (pin.places.some(({ link }) => link.fixed)) for (const a of [0.9, 1.57, 2.24]) busy.push(a, a, a);
  const cost = (direction) =>
    busy.reduce((sum, angle) => sum + Math.max(0, Math.cos(angle - direction)) ** 3, 0);
  const choices = [-1, -3, 1, 3, 0, 4, -2, 2].map((eighth) => (eighth * Math.PI) / 4);
  return choices.reduce((best, choice) => (cost(choice) < cost(best) - 1e-9 ? choice : best));
}

const degrees = (angle) => round((-angle * 180) / Math.PI);

/** Barrel (on the guide link) or rod and piston (on the block link) of a cylinder, for its whole travel. */
function cylinderShapes(guideOrBlock, { low, high, guide }, k, parent) {
  const forward = Math.abs(high) >= Math.abs(low);
  const [near, far] = [Math.abs(forward ? low : high) * k, Math.abs(forward ? high : low) * k];
  const isBarrel = guideOrBlock === guide;
  const turn = guideOrBlock.angle + (forward === isBarrel ? 0 : Math.PI);
  const [x, y] = guideOrBlock.local;
  const transform = `translate(${round(k * x)} ${round(-k * y)}) rotate(${degrees(turn)})`;
  const axes = make("g", { transform }, parent);
  if (isBarrel) {
    make(
      "rect",
      { class: "lw-body", x: 0, y: -10, width: round(Math.max(near - 14, 20)), height: 20, rx: 3 },
      axes,
    );
  } else {
    const length = round(far - near + 24);
    make("path", { class: "lw-rod", d: `M0 0H${length}` }, axes);
    make("rect", { class: "lw-piston", x: length - 3, y: -8, width: 6, height: 16 }, axes);
  }
}

/** The transform that puts what is drawn in a link's axes to its pose. */
function matrix(pose, toScreen) {
  const turn = [pose.c, -pose.s, pose.s, pose.c].map((value) => value.toFixed(6)).join(" ");
  return `matrix(${turn} ${toScreen([pose.x, pose.y]).map(round).join(" ")})`;
}

/** Shapes of all moving links, in layers under `parent`; returns a function that moves them to a sample. */
function bodies(facts, k, r, parent) {
  const layers = ["slots", "bodies", "blocks"].map((name) => make("g", { class: `lw-${name}` }, parent));
  const parts = facts.scene.links
    .filter((link) => !link.fixed)
    .map((link) => {
      const groups = layers.map((layer) => make("g", { class: `lw-c${facts.colour.get(link)}` }, layer));
      const [slots, body, blocks] = groups;
      const points = Object.values(link.points).map(([x, y]) => [k * x, -k * y]);
      let sliding = false;
      for (const joint of facts.guides) {
        const { guide, block, low, high, cylinder } = joint;
        for (const side of [guide, block].filter((each) => each.link === link)) {
          sliding = true;
          if (cylinder) cylinderShapes(side, joint, k, side === guide ? body : slots);
          else if (side === guide) {
            const ends = [low, high].map((travel) => onGuide(guide, travel)).map(([x, y]) => [k * x, -k * y]);
            make("path", { class: "lw-slot", d: outline(ends, BLOCK.height / 2 + 3) }, slots);
          } else {
            const [x, y] = [round(k * side.local[0]), round(-k * side.local[1])];
            const size = {
              x: -BLOCK.length / 2,
              y: -BLOCK.height / 2,
              width: BLOCK.length,
              height: BLOCK.height,
            };
            const transform = `translate(${x} ${y}) rotate(${degrees(side.angle)})`;
            make("rect", { class: "lw-block", ...size, rx: 2, transform }, blocks);
          }
        }
      }
      for (const line of link.outlines ?? []) {
        const d = line.map(([x, y]) => `${round(k * x)} ${round(-k * y)}`).join("L");
        make("path", { class: "lw-slot lw-outline", d: `M${d}Z` }, slots);
      }
      if (hull(points).length > 1 || !sliding)
        make("path", { class: "lw-body", d: outline(points, r) }, body);
      return { link, groups };
    });
  return (toScreen, sample, f) => {
    for (const { link, groups } of parts) {
      const pose = poseOf(link, facts.times, sample, f);
      for (const group of groups) {
        group.style.display = pose ? "" : "none";
        if (pose) group.setAttribute("transform", matrix(pose, toScreen));
      }
    }
  };
}

/** Hatching of fixed ground: a line of `length` from the origin along x, with strokes below it. */
function hatch(parent, x, length, y = 0) {
  let d = `M${round(x)} ${y}h${round(length)}`;
  for (let s = x + 5; s <= x + length + 0.1; s += 7) d += `M${round(s)} ${y}l-6 7`;
  make("path", { class: "lw-ground", d }, parent);
}

/** What does not move: grid, scale bar, ground symbols and fixed guides. */
function backdrop(facts, view, parent) {
  const { k, width, height, toScreen } = view;
  const grid = make("g", { class: "lw-grid" }, parent);
  const step = nice(110 / k);
  const [left, top] = view.toWorld([0, 0]);
  const [right, bottom] = view.toWorld([width, height]);
  for (let i = Math.ceil(left / step); i * step < right; i++) {
    const x = round(toScreen([i * step, 0])[0]);
    make("path", { d: `M${x} 0V${height}`, class: i ? "" : "lw-axis" }, grid);
    if (!i) make("text", { x: x + 5, y: 13 }, grid).textContent = "y";
  }
  for (let i = Math.ceil(bottom / step); i * step < top; i++) {
    const y = round(toScreen([0, i * step])[1]);
    make("path", { d: `M0 ${y}H${width}`, class: i ? "" : "lw-axis" }, grid);
    if (!i) make("text", { x: width - 12, y: y - 5 }, grid).textContent = "x";
  }
  const bar = make("g", { class: "lw-scale", transform: `translate(14 ${height - 14})` }, parent);
  make("path", { d: `M0 -5v5h${round(step * k)}v-5` }, bar);
  const value = Number(step.toPrecision(6));
  make("text", { x: round((step * k) / 2), y: -6 }, bar).textContent = `${value} ${facts.scene.length_unit}`;

  for (const { guide, low, high } of facts.guides.filter((each) => each.guide.link.fixed)) {
    const pose = poseOf(guide.link, facts.times, 0);
    if (!pose) continue;
    const [x, y] = toScreen(place(pose, guide.local));
    let turn = Math.atan2(pose.s, pose.c) + guide.angle;
    const flip = Math.cos(turn) < -1e-9 || (Math.abs(Math.cos(turn)) < 1e-9 && turn < 0);
    if (flip) turn += Math.PI;
    const [from, to] = (flip ? [-high, -low] : [low, high]).map((travel) => travel * k);
    const rail = make(
      "g",
      { transform: `translate(${round(x)} ${round(y)}) rotate(${degrees(turn)})` },
      parent,
    );
    const spare = BLOCK.length / 2 + 8;
    const [start, end] = [Math.min(0, from - spare), Math.max(0, to + spare)].map(round);
    make("path", { class: "lw-centre", d: `M${start} 0H${end}` }, rail);
    hatch(rail, from - spare, to - from + 2 * spare, BLOCK.height / 2 + 2);
  }
  for (const pin of facts.pins) {
    const ground = pin.places.find(({ link }) => link.fixed);
    const pose = ground && poseOf(ground.link, facts.times, 0);
    if (!pose) continue;
    const [x, y] = toScreen(place(pose, ground.local)).map(round);
    const mark = make("g", { transform: `translate(${x} ${y})` }, parent);
    if (!pin.joints.length) make("path", { class: "lw-ground", d: "M-5 0H5M0 -5V5" }, mark);
    else {
      make("path", { class: "lw-pivot", d: "M0 0L-11 18H11Z" }, mark);
      hatch(mark, -16, 32, 18);
    }
  }
}

const mean = (points) => [0, 1].map((axis) => points.reduce((sum, p) => sum + p[axis], 0) / points.length);

/** Middle of the longest stretch of a bar that is free of pins. */
function widestGap([a, b], points) {
  const along = ([x, y]) => (x - a[0]) * (b[0] - a[0]) + (y - a[1]) * (b[1] - a[1]);
  const row = [...points].sort((p, q) => along(p) - along(q));
  const size = ([p, q]) => along(q) - along(p);
  const gaps = row.slice(1).map((p, i) => [row[i], p]);
  return mean(gaps.reduce((best, gap) => (size(gap) > size(best) ? gap : best)));
}

/** The class of a slanted name: Latin names are slanted, hanzi have no slanted form. */
const slanted = (name) => (/^[ -\u024f]*$/.test(name) ? "lw-slanted" : "");

/** Names of pins and links: returns a function that moves them to a sample. */
function labels(facts, view, r, parent) {
  const texts = facts.pins.map((pin) => {
    const direction = labelDirection(pin, facts);
    const [dx, dy] = [Math.cos(direction), Math.sin(direction)];
    const anchor = dx > 0.3 ? "start" : dx < -0.3 ? "end" : "middle";
    const text = make("text", { class: "lw-label", "text-anchor": anchor, dy: "0.35em" }, parent);
    text.textContent = pin.name;
    return { text, places: pin.places, half: 0, offset: () => [dx * (r + 7), dy * (r + 9)] };
  });
  for (const link of facts.scene.links.filter((each) => !each.fixed)) {
    const ring = hull(Object.values(link.points));
    if (!ring.length) continue;
    const riding = facts.guides.find(({ block }) => block.link === link);
    const slide = riding ?? facts.guides.find(({ guide }) => guide.link === link);
    const side = riding ? riding.block : slide?.guide;
    let middle = mean(ring);
    if (ring.length === 2) middle = widestGap(ring, Object.values(link.points));
    else if (slide?.cylinder && side === slide.guide) middle = onGuide(side, (slide.low + slide.high) / 4);
    const colour = `lw-c${facts.colour.get(link)}`;
    const text = make(
      "text",
      { class: `lw-label lw-name ${slanted(link.name)} ${colour}`, "text-anchor": "middle", dy: "0.35em" },
      parent,
    );
    text.textContent = link.name;
    const bar = ring.length > 1;
    const along = bar ? Math.atan2(ring[1][1] - ring[0][1], ring[1][0] - ring[0][0]) : (side?.angle ?? 0);
    const away = bar ? r + 3 : BLOCK.height / 2 + 6;
    const half = 3.2 * link.name.length; // of the text's width, near enough
    const offset = (pose) => {
      if (ring.length > 2) return [0, 0];
      const across = Math.atan2(pose.s, pose.c) + along - Math.PI / 2;
      return [Math.cos(across) * (away + half), -Math.sin(across) * (away + 7)];
    };
    texts.push({ text, places: [{ link, local: middle }], half, offset });
  }
  return (sample, f) => {
    for (const { text, places, half, offset } of texts) {
      const pose = poseOf(places[0].link, facts.times, sample, f);
      text.style.display = pose ? "" : "none";
      if (!pose) continue;
      const [x, y] = view.toScreen(place(pose, places[0].local));
      const [dx, dy] = offset(pose);
      text.setAttribute("x", round(half ? clamp(x + dx, half + 4, view.width - half - 4) : x + dx));
      text.setAttribute("y", round(y + dy));
    }
  };
}

/** A spring between two places on the screen: a coil, or the barrel and rod of a strut. */
function springPath([x0, y0], [x1, y1], look, r) {
  const length = Math.hypot(x1 - x0, y1 - y0) || 1;
  const [ux, uy] = [(x1 - x0) / length, (y1 - y0) / length];
  const at = (share, across) => {
    const along = share * length;
    return `${round(x0 + along * ux - across * uy)} ${round(y0 + along * uy + across * ux)}`;
  };
  if (look === "strut") {
    const w = 0.7 * r;
    const barrel = `M${at(0.1, -w)}L${at(0.6, -w)}L${at(0.6, w)}L${at(0.1, w)}Z`;
    return `M${at(0, 0)}L${at(0.1, 0)}${barrel}M${at(0.6, 0)}L${at(1, 0)}`;
  }
  const teeth = 12;
  const coil = [...Array(teeth).keys()].map((i) => `L${at(0.15 + (0.7 * (i + 0.5)) / teeth, i % 2 ? r : -r)}`);
  return `M${at(0, 0)}L${at(0.15, 0)}${coil.join("")}L${at(0.85, 0)}L${at(1, 0)}`;
}

/** A line through points, interrupted where there is none. */
function linePath(xs, ys, toScreen) {
  let d = "";
  let pen = false;
  xs.forEach((x, i) => {
    const here = x != null && ys[i] != null;
    if (here) d += `${pen ? "L" : "M"}${toScreen([x, ys[i]]).map(round).join(" ")}`;
    pen = here;
  });
  return d;
}

const traceColour = (facts, i) => `lw-c${(facts.colour.size + i) % PALETTE}`;

/** The fixed and the moving centrode of each link, and its instant centre; returns a function that moves them. */
function centrodes(facts, view, svg) {
  const parts = facts.centrodes.map((centrode) => {
    const link = facts.links.get(centrode.link);
    const group = make("g", { class: `lw-centrode lw-c${facts.colour.get(link)}` }, svg);
    make("path", { class: "lw-fixed", d: linePath(centrode.x, centrode.y, view.toScreen) }, group);
    const local = ([u, v]) => [view.k * u, -view.k * v];
    const moving = make("path", { class: "lw-moving", d: linePath(centrode.u, centrode.v, local) }, group);
    return { link, centrode, group, moving, dot: make("circle", { r: 3.4 }, group) };
  });
  const move = (sample, f) => {
    for (const { link, centrode, moving, dot } of parts) {
      const pose = poseOf(link, facts.times, sample, f);
      moving.style.display = pose ? "" : "none";
      if (pose) moving.setAttribute("transform", matrix(pose, view.toScreen));
      const [x, y] = [centrode.x, centrode.y].map((values) => between(values, facts.times, sample, f));
      dot.style.display = x == null || y == null ? "none" : "";
      if (x == null || y == null) continue;
      const [cx, cy] = view.toScreen([x, y]);
      dot.setAttribute("cx", round(cx));
      dot.setAttribute("cy", round(cy));
    }
  };
  return { move, parts };
}

/** Scale and origin that fit all the motion in a drawing `width` wide and at most `most` high. */
function fit(facts, width, most, { x0, x1, y0, y1 } = facts.box) {
  const [wide, high] = [Math.max(x1 - x0, facts.size * 1e-3), Math.max(y1 - y0, facts.size * 1e-3)];
  const [roomX, roomY] = [Math.max(width - 2 * PAD.x, 50), most - PAD.top - PAD.bottom];
  const k = Math.min(roomX / wide, roomY / high);
  const height = Math.round(Math.max(k * high + PAD.top + PAD.bottom, 200));
  const ox = width / 2 - (k * (x0 + x1)) / 2;
  const oy = (PAD.top + height - PAD.bottom) / 2 + (k * (y0 + y1)) / 2;
  const toScreen = ([x, y]) => [ox + k * x, oy - k * y];
  const toWorld = ([x, y]) => [(x - ox) / k, (oy - y) / k];
  return { k, width, height, toScreen, toWorld };
}

/** Fill `svg`; returns {show(sample, f)} which moves the drawing. `ghosts`: samples drawn faintly. */
function draw(svg, facts, width, most, say, { ghosts = [], box } = {}) {
  const view = fit(facts, width, most, box);
  const r = clamp(width / 90, 4.5, 7);
  svg.replaceChildren();
  svg.setAttribute("viewBox", `0 0 ${view.width} ${view.height}`);
  backdrop(facts, view, make("g", {}, svg));
  const areas = facts.areas.map(({ rings }, i) => {
    const group = make("g", { class: `lw-area lw-c${i % PALETTE}` }, svg);
    const d = rings.map((ring) => `M${ring.map((at) => view.toScreen(at).map(round).join(" ")).join("L")}Z`);
    make("path", { d: d.join("") }, group);
    return { group };
  });
  for (const sample of ghosts) {
    bodies(facts, view.k, r, make("g", { class: "lw-ghost" }, svg))(view.toScreen, sample, 0);
  }
  const traces = facts.scene.traces.map((trace, i) => {
    const group = make("g", { class: `lw-trace ${traceColour(facts, i)}` }, svg);
    make("path", { d: linePath(trace.x, trace.y, view.toScreen) }, group);
    return { trace, group, dot: make("circle", { r: 3.4 }, group) };
  });
  const rolling = centrodes(facts, view, svg);
  const move = bodies(facts, view.k, r, make("g", {}, svg));
  const springs = (facts.scene.springs ?? []).map((spring) => {
    const links = spring.links.map((link) => facts.links.get(link));
    const path = make("path", { class: "lw-spring", "data-spring": spring.name }, svg);
    return { spring, path, ends: links.map((link, i) => [link, link.points[spring.points[i]]]) };
  });
  const pins = facts.pins.map((pin) => {
    const joined = pin.joints.length > 0;
    const moving = pin.places.find(({ link }) => !link.fixed);
    const colour = moving ? `lw-c${facts.colour.get(moving.link)}` : "";
    const circle = make(
      "circle",
      { r: joined ? Math.min(r - 1.5, 4.8) : 2.6 },
      joined || moving ? svg : null,
    );
    circle.setAttribute("class", joined ? "lw-pin" : `lw-point ${colour}`);
    circle.setAttribute("data-point", pin.name);
    return { circle, places: pin.places };
  });
  const name = labels(facts, view, r, make("g", { class: "lw-labels" }, svg));
  const note = make("text", { class: "lw-note", x: width / 2, y: 24, "text-anchor": "middle" }, svg);
  note.textContent = say("not_assembled");

  const show = (sample, f = 0) => {
    move(view.toScreen, sample, f);
    rolling.move(sample, f);
    name(sample, f);
    for (const { spring, path, ends } of springs) {
      const poses = ends.map(([link]) => poseOf(link, facts.times, sample, f));
      path.style.display = poses.includes(null) ? "none" : "";
      if (poses.includes(null)) continue;
      const [start, end] = ends.map(([, local], i) => view.toScreen(place(poses[i], local)));
      path.setAttribute("d", springPath(start, end, spring.look, r));
    }
    for (const { circle, places } of pins) {
      const at = places.find(({ link }) => link.fixed) ?? places[0];
      const pose = poseOf(at.link, facts.times, sample, f);
      circle.style.display = pose ? "" : "none";
      if (!pose) continue;
      const [x, y] = view.toScreen(place(pose, at.local));
      circle.setAttribute("cx", round(x));
      circle.setAttribute("cy", round(y));
    }
    for (const { trace, dot } of traces) {
      const same = trace.x.length === facts.times.length;
      const [x, y] = same ? [trace.x, trace.y].map((values) => between(values, facts.times, sample, f)) : [];
      dot.style.display = x == null || y == null ? "none" : "";
      if (x == null || y == null) continue;
      const [cx, cy] = view.toScreen([x, y]);
      dot.setAttribute("cx", round(cx));
      dot.setAttribute("cy", round(cy));
    }
    note.style.display = facts.gaps[sample] || (f && facts.gaps[sample + 1]) ? "" : "none";
  };
  return { show, areas, traces, centrodes: rolling.parts };
}

// ---------------------------------------------------------------- looks

const LIGHT =
  "--lw-ink:#1d2733;--lw-muted:#5b6876;--lw-paper:#fff;--lw-line:#d5dbe2;--lw-grid:#eef1f4;--lw-warn:#b3261e;" +
  "--lw-accent:#1f63a8;--lw-c0:#1f6fb5;--lw-c1:#c2571a;--lw-c2:#23835a;--lw-c3:#8250a8;--lw-c4:#9a7700;" +
  "--lw-c5:#0d8495;--lw-c6:#b8336a;--lw-c7:#5d6b7a;";
const DARK =
  "--lw-ink:#e6ebf0;--lw-muted:#9aa7b4;--lw-paper:#171d24;--lw-line:#3a4551;--lw-grid:#212932;--lw-warn:#ff8a80;" +
  "--lw-accent:#7db8f0;--lw-c0:#6cb2f0;--lw-c1:#f2935c;--lw-c2:#62c795;--lw-c3:#c39be6;--lw-c4:#dcb93f;" +
  "--lw-c5:#55c7d6;--lw-c6:#ec7ba6;--lw-c7:#a3b1c0;";
const COLOURS = Array.from({ length: PALETTE }, (_, i) => `.lw-c${i}{--c:var(--lw-c${i})}`).join("");

const STYLE = `
.lw{${LIGHT}}
@media screen and (prefers-color-scheme:dark){.lw{${DARK}}}
:is([data-theme="dark"],[data-jp-theme-light="false"]) .lw{${DARK}}
:is([data-theme="light"],[data-jp-theme-light="true"]) .lw{${LIGHT}}
@media print{.lw.lw.lw{${LIGHT}}}
${COLOURS}
.lw{color:var(--lw-ink);font:14px/1.4 system-ui,-apple-system,"Segoe UI",Roboto,"Helvetica Neue",Arial,"PingFang SC","Microsoft YaHei","Noto Sans CJK SC","Source Han Sans SC",sans-serif}
.lw *{box-sizing:border-box}
.lw svg.lw-drawing{display:block;width:100%;height:auto;background:var(--lw-paper);border-radius:6px}
.lw-drawing text{font-size:12px;fill:var(--lw-muted)}
.lw-grid path{stroke:var(--lw-grid);fill:none}
.lw-grid path.lw-axis{stroke:var(--lw-line)}
.lw-grid text{font-style:italic}
.lw-scale path{stroke:var(--lw-muted);stroke-width:1.5;fill:none}
.lw-scale text{text-anchor:middle}
.lw-ground{stroke:var(--lw-muted);stroke-width:1.3;fill:none}
.lw-spring{stroke:var(--lw-ink);stroke-width:1.4;fill:none;stroke-linejoin:round}
.lw-pivot{stroke:var(--lw-ink);stroke-width:1.4;fill:var(--lw-paper);stroke-linejoin:round}
.lw-area path{fill:var(--c);fill-opacity:.14;fill-rule:evenodd;stroke:var(--c);stroke-opacity:.6;stroke-width:1}
.lw-centre{stroke:var(--lw-muted);stroke-width:1;stroke-dasharray:14 3 2 3;fill:none}
.lw-body,.lw-slot,.lw-block,.lw-piston{stroke:var(--c);stroke-width:1.6;fill:var(--c);fill-opacity:.2}
.lw-slot{fill-opacity:.07;stroke-width:1.2}
.lw-block{fill-opacity:.45}
.lw-piston{fill-opacity:.9}
.lw-rod{stroke:var(--c);stroke-width:5;fill:none}
.lw-ghost{opacity:.28}
.lw-ghost *{fill:none;stroke-width:1}
.lw-trace path{stroke:var(--c);stroke-width:1.8;fill:none;stroke-linejoin:round}
.lw-trace circle{fill:var(--c);stroke:var(--lw-paper);stroke-width:1}
.lw-centrode path{stroke:var(--c);stroke-width:1.5;fill:none;stroke-linejoin:round}
.lw-centrode path.lw-moving{stroke-dasharray:5 3}
.lw-centrode circle{fill:none;stroke:var(--c);stroke-width:2}
.lw-pin{fill:var(--lw-paper);stroke:var(--lw-ink);stroke-width:1.7}
.lw-point{fill:var(--c)}
.lw-drawing .lw-label{fill:var(--lw-ink);font-weight:600;paint-order:stroke;stroke:var(--lw-paper);stroke-width:3px;stroke-linejoin:round}
.lw-drawing .lw-name{fill:var(--c);font-weight:400}
.lw-drawing .lw-name.lw-slanted{font-style:italic}
.lw-drawing .lw-note{fill:var(--lw-warn);font-size:14px;font-weight:600}
.lw .lw-hidden,.lw-no-points .lw-label:not(.lw-name),.lw-no-links .lw-name{display:none}
.lw-bar,.lw-options{display:flex;align-items:center;gap:.5rem .75rem;margin-top:.5rem;flex-wrap:wrap}
.lw-options{gap:.35rem 1rem;color:var(--lw-muted);font-size:13px}
.lw-options label{display:inline-flex;align-items:center;gap:.35rem;cursor:pointer}
.lw-options .lw-paths{display:inline-flex;gap:.2rem .8rem;flex-wrap:wrap;align-items:center}
.lw-swatch{width:16px;height:3px;border-radius:2px;background:var(--c)}
.lw-play{flex:none;width:38px;height:38px;padding:0;border:0;border-radius:50%;background:var(--lw-accent);cursor:pointer}
.lw-play svg{display:block;width:100%;height:100%;fill:var(--lw-paper)}
.lw-play[aria-pressed="true"] .lw-icon-play,.lw-play[aria-pressed="false"] .lw-icon-pause{display:none}
.lw-track{position:relative;flex:1 1 8rem;min-width:7rem}
.lw-track input{display:block;width:100%;height:24px;margin:0;accent-color:var(--lw-accent);cursor:pointer}
.lw-gaps{position:relative;height:3px;margin:0 8px}
.lw-gaps i{position:absolute;top:0;height:3px;min-width:3px;background:var(--lw-warn)}
.lw-time{flex:none;font-variant-numeric:tabular-nums;text-align:right;white-space:nowrap}
.lw select{font:inherit;color:inherit;background:var(--lw-paper);border:1px solid var(--lw-line);border-radius:4px;padding:2px 4px}
.lw :is(button,input,select):focus-visible{outline:2px solid var(--lw-accent);outline-offset:2px}
`;

// ---------------------------------------------------------------- controls

/** Playback speeds to offer, as multiples of real time, and the one to start with (a cycle of some seconds). */
function speeds(seconds) {
  const usual = seconds >= 1 && seconds <= 12 ? 1 : nice(seconds / 4);
  const list = [0.1, 0.2, 0.5, 1, 2, 5].map((m) => Number((m * usual).toPrecision(2)));
  return { usual, list: [...new Set([...list, 1])].sort((a, b) => a - b) };
}

function controls(root, facts, { say, time, real }) {
  const bar = html("div", { class: "lw-bar" }, root);
  const play = html("button", { class: "lw-play", type: "button" }, bar);
  const icons = make("svg", { viewBox: "0 0 38 38", "aria-hidden": "true" }, play);
  make("path", { class: "lw-icon-play", d: "M15 11.5v15l12-7.5z" }, icons);
  make("path", { class: "lw-icon-pause", d: "M13 12h4v14h-4zM21 12h4v14h-4z" }, icons);
  const track = html("div", { class: "lw-track" }, bar);
  const last = facts.times.length - 1;
  const slider = html(
    "input",
    { type: "range", min: 0, max: last, step: 1, value: 0, "aria-label": time.label },
    track,
  );
  const gaps = html("div", { class: "lw-gaps" }, track);
  facts.gaps.forEach((gap, i) => {
    if (!gap || facts.gaps[i - 1]) return;
    const end = facts.gaps.findIndex((other, j) => j > i && !other);
    const width = ((end < 0 ? last : end - 1) - i) / Math.max(last, 1);
    const style = `left:${(i / Math.max(last, 1)) * 100}%;width:${width * 100}%`;
    html("i", { style, title: say("not_assembled") }, gaps);
  });
  const readout = html("output", { class: "lw-time", "aria-live": "off" }, bar);

  const options = html("div", { class: "lw-options" }, root);
  const speedLabel = html("label", {}, options, say("speed"));
  const speed = html("select", {}, speedLabel);
  const { usual, list } = speeds(real);
  for (const factor of list) {
    const option = html("option", { value: factor }, speed, `× ${factor}`);
    if (factor === 1 && SECONDS[time.unit]) option.textContent = say("real_time");
    option.selected = factor === usual;
  }
  const check = (parent, checked = true) => {
    const label = html("label", {}, parent);
    const box = html("input", { type: "checkbox" }, label);
    box.checked = checked;
    return { label, box };
  };
  const [points, links] = ["point_names", "link_names"].map((key) => {
    const { label, box } = check(options);
    label.append(say(key));
    return box;
  });
  const choices = (key, entries, checked) => {
    const group = html("span", { class: "lw-paths", role: "group", "aria-label": say(key) }, options);
    if (entries.length) html("span", {}, group, say(key));
    return entries.map(({ name, colour }) => {
      const { label, box } = check(group, checked);
      html("span", { class: `lw-swatch ${colour}` }, label);
      label.append(name);
      return box;
    });
  };
  const coloured = facts.areas.map(({ name }, i) => ({ name, colour: `lw-c${i % PALETTE}` }));
  const areas = choices("areas", coloured, true);
  const named = facts.scene.traces.map(({ name }, i) => ({ name, colour: traceColour(facts, i) }));
  const traces = choices("paths", named, true);
  const rolling = facts.centrodes.map(({ link }) => ({
    name: link,
    colour: `lw-c${facts.colour.get(facts.links.get(link))}`,
  }));
  const centrodes = choices("centrodes", rolling, false);
  const still = last < 1 || facts.times[last] === facts.times[0];
  if (still) for (const part of [bar, speedLabel]) part.classList.add("lw-hidden");
  return { play, slider, readout, speed, points, links, areas, traces, centrodes };
}

const speaker = (words) => (key) => words[`report.${key}`] ?? key.replaceAll("_", " ");

function frame(el, say) {
  const root = html("div", { class: "lw" });
  html("style", {}, root, STYLE);
  const svg = make("svg", { class: "lw-drawing", role: "img", "aria-label": say("drawing") }, root);
  el.replaceChildren(root);
  return { root, svg };
}

// ---------------------------------------------------------------- what callers use

/**
 * Draw the scene `model` into `el`, with play, speed and time controls. `words`: texts under "report.*" keys.
 * `time`: {unit, label} of the scene's time. `autoplay` yields to a wish for reduced motion.
 */
export function render({ model, el, words = {}, time = { unit: "s", label: "time" }, autoplay = false }) {
  const say = speaker(words);
  const facts = survey(model);
  const { times } = facts;
  const [first, last] = [times[0], times.at(-1)];
  const perSecond = SECONDS[time.unit] ? 1 / SECONDS[time.unit] : (last - first) / 4;
  const { root, svg } = frame(el, say);
  const ui = controls(root, facts, { say, time, real: (last - first) / perSecond });
  const decimals = clamp(1 - Math.floor(Math.log10((last - first) / (times.length - 1) || 1)), 0, 9);
  const listeners = new Set();
  let picture = { show() {}, areas: [], traces: [], centrodes: [] };
  let now = first;
  let tick = 0;

  const show = () => {
    const { k, f, nearest } = locate(times, now);
    picture.show(k, f);
    ui.slider.value = nearest;
    ui.readout.textContent = `${time.label} ${now.toFixed(decimals)} ${time.unit}`.trim();
    const note = facts.gaps[nearest] ? ` ${say("not_assembled")}` : "";
    ui.slider.setAttribute("aria-valuetext", `${now.toFixed(decimals)} ${time.unit}${note}`);
    return nearest;
  };
  const goTo = (t) => {
    now = clamp(t, first, last);
    const nearest = show();
    for (const listener of listeners) listener(now, nearest);
  };
  const options = () => {
    svg.classList.toggle("lw-no-points", !ui.points.checked);
    svg.classList.toggle("lw-no-links", !ui.links.checked);
    for (const kind of ["areas", "traces", "centrodes"]) {
      picture[kind].forEach(({ group }, i) => group.classList.toggle("lw-hidden", !ui[kind][i].checked));
    }
  };
  const layout = () => {
    const width = Math.round(root.clientWidth) || 640;
    const box = ui.centrodes.some((each) => each.checked) ? facts.wide : facts.box;
    picture = draw(svg, facts, width, clamp(window.innerHeight * 0.66, 280, 720), say, { box });
    options();
    show();
  };
  const pause = () => {
    cancelAnimationFrame(tick);
    tick = 0;
    ui.play.setAttribute("aria-pressed", "false");
    ui.play.setAttribute("aria-label", say("play"));
  };
  const play = () => {
    if (tick || last === first) return;
    ui.play.setAttribute("aria-pressed", "true");
    ui.play.setAttribute("aria-label", say("pause"));
    let before = null;
    const step = (stamp) => {
      // a hidden tab stops the frames: on return go on from where it stood
      const elapsed = before === null ? 0 : Math.min(stamp - before, 100) / 1000;
      before = stamp;
      tick = requestAnimationFrame(step);
      goTo(first + ((now - first + elapsed * perSecond * Number(ui.speed.value)) % (last - first)));
    };
    tick = requestAnimationFrame(step);
  };
  const setTime = (t) => {
    pause();
    goTo(t);
  };
  const setIndex = (i) => setTime(times[clamp(Math.round(i), 0, times.length - 1)]);

  ui.play.addEventListener("click", () => (tick ? pause() : play()));
  ui.slider.addEventListener("input", () => setIndex(Number(ui.slider.value)));
  for (const box of [ui.points, ui.links, ...ui.areas, ...ui.traces]) box.addEventListener("change", options);
  for (const box of ui.centrodes) box.addEventListener("change", layout); // they may need more room
  let width = 0;
  const watcher = new ResizeObserver(() => {
    if (!root.clientWidth || root.clientWidth === width) return;
    width = root.clientWidth;
    layout();
  });
  layout();
  watcher.observe(root);
  pause();
  if (autoplay && !window.matchMedia("(prefers-reduced-motion: reduce)").matches) play();

  return {
    setTime,
    setIndex,
    play,
    pause,
    get playing() {
      return tick !== 0;
    },
    get time() {
      return now;
    },
    on(event, callback) {
      if (event !== "time") throw new Error(`unknown event: ${event}`);
      listeners.add(callback);
      return () => listeners.delete(callback);
    },
    destroy() {
      pause();
      watcher.disconnect();
      listeners.clear();
      el.replaceChildren();
    },
  };
}

/** Draw the scene once, at its first pose that can be assembled, with `ghosts` faint poses over the motion. */
export function still({ model, el, words = {}, width = 690, height = 430, ghosts = 8 }) {
  const say = speaker(words);
  const facts = survey(model);
  const sound = [...facts.times.keys()].filter((k) => !facts.gaps[k]);
  const count = Math.min(ghosts, sound.length - 1);
  const part = (i) => sound[Math.floor(((i + 1) * sound.length) / (count + 1))];
  const faint = Array.from({ length: Math.max(count, 0) }, (_, i) => part(i));
  const { svg } = frame(el, say);
  const { show, centrodes } = draw(svg, facts, width, height, say, { ghosts: faint });
  for (const { group } of centrodes) group.remove();
  show(sound[0] ?? 0);
  return svg;
}

/** Notebook widgets (anywidget) hand over a model with get() and on(); their scene is under "scene". */
function widget({ model, el }) {
  if (typeof model.get !== "function") return render({ model, el });
  let handle = null;
  const fresh = () => {
    handle?.destroy();
    handle = render({ model: model.get("scene"), el, words: model.get("words") ?? {} });
  };
  fresh();
  model.on("change:scene", fresh);
  return () => {
    model.off("change:scene", fresh);
    handle.destroy();
  };
}

export default { render: widget };
