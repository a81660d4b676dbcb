// Looks of a drawing and of its controls.

import { ARROW_KINDS } from "./arrows.ts";
import { PALETTE } from "./survey.ts";

/** Colours on light and on dark ground; --lw-c0 to --lw-c7 tell links and curves apart. */
const LIGHT =
  "--lw-ink:#1d2733;--lw-muted:#5b6876;--lw-paper:#fff;--lw-line:#d5dbe2;--lw-grid:#eef1f4;--lw-warn:#b3261e;" +
  "--lw-accent:#1f63a8;--lw-c0:#1f6fb5;--lw-c1:#c2571a;--lw-c2:#23835a;--lw-c3:#8250a8;--lw-c4:#9a7700;" +
  "--lw-c5:#0d8495;--lw-c6:#b8336a;--lw-c7:#5d6b7a;" +
  "--lw-velocity:#00796b;--lw-acceleration:#b45309;--lw-reaction:#c2185b;--lw-load:#7b1fa2;--lw-weight:#5d4037;" +
  "--lw-moment:#3949ab;";
const DARK =
  "--lw-ink:#e6ebf0;--lw-muted:#9aa7b4;--lw-paper:#171d24;--lw-line:#3a4551;--lw-grid:#212932;--lw-warn:#ff8a80;" +
  "--lw-accent:#7db8f0;--lw-c0:#6cb2f0;--lw-c1:#f2935c;--lw-c2:#62c795;--lw-c3:#c39be6;--lw-c4:#dcb93f;" +
  "--lw-c5:#55c7d6;--lw-c6:#ec7ba6;--lw-c7:#a3b1c0;" +
  "--lw-velocity:#4fd6c2;--lw-acceleration:#f5b056;--lw-reaction:#ff7fae;--lw-load:#d39bf0;--lw-weight:#c9a99c;" +
  "--lw-moment:#a9b4ff;";
const KINDS = ARROW_KINDS.map((kind) => `.lw-${kind}{--a:var(--lw-${kind})}`).join("");
const COLOURS = Array.from({ length: PALETTE }, (_, i) => `.lw-c${i}{--c:var(--lw-c${i})}`).join("");

/** The style sheet of drawings; it stands in each, for widgets come without a page. */
export const STYLE = `
.lw{${LIGHT}}
@media screen and (prefers-color-scheme:dark){.lw{${DARK}}}
:is([data-theme="dark"],[data-jp-theme-light="false"]) .lw{${DARK}}
:is([data-theme="light"],[data-jp-theme-light="true"]) .lw{${LIGHT}}
@media print{.lw.lw.lw{${LIGHT}}}
${COLOURS}
.lw{color:var(--lw-ink);font:14px/1.4 system-ui,-apple-system,"Segoe UI",Roboto,"Helvetica Neue",Arial,
  "PingFang SC","Microsoft YaHei","Noto Sans CJK SC","Source Han Sans SC",sans-serif}
.lw *{box-sizing:border-box}
.lw svg.lw-drawing{touch-action:pan-y;display:block;width:100%;height:auto;background:var(--lw-paper);border-radius:6px}
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
.lw-original{opacity:.55;pointer-events:none}
.lw-original *{fill:none;stroke:var(--lw-muted);stroke-width:1;stroke-dasharray:8 4}
.lw-original circle{display:none}
.lw-opening path{stroke:var(--lw-warn);stroke-width:1.5;stroke-dasharray:2 3;fill:none}
.lw-opening circle{fill:none;stroke:var(--lw-warn);stroke-width:1.7;stroke-dasharray:7 7}
.lw-drawing .lw-opening text{fill:var(--lw-warn);font-weight:600}
.lw-opening text{paint-order:stroke;stroke:var(--lw-paper);stroke-width:3px}
.lw-grabbable{cursor:grab}
.lw-dragging{cursor:grabbing}
.lw-live{touch-action:pan-y}
.lw-modes{display:flex;gap:.35rem;align-items:center;margin-top:.5rem;font-size:13px;color:var(--lw-muted)}
.lw-modes button{font:inherit;color:inherit;background:var(--lw-paper);padding:2px 8px;cursor:pointer}
.lw-modes button{border:1px solid var(--lw-line);border-radius:4px}
.lw-modes button[aria-pressed="true"]{color:var(--lw-paper);background:var(--lw-accent);border-color:var(--lw-accent)}
.lw-hint{color:var(--lw-warn)}
.lw-ghost *{fill:none;stroke-width:1}
.lw-trace path{stroke:var(--c);stroke-width:1.8;fill:none;stroke-linejoin:round}
.lw-trace circle{fill:var(--c);stroke:var(--lw-paper);stroke-width:1}
.lw-centrode path{stroke:var(--c);stroke-width:1.5;fill:none;stroke-linejoin:round}
.lw-centrode path.lw-moving{stroke-dasharray:5 3}
.lw-centrode circle{fill:none;stroke:var(--c);stroke-width:2}
.lw-pin{fill:var(--lw-paper);stroke:var(--lw-ink);stroke-width:1.7}
.lw-point{fill:var(--c)}
.lw-drawing .lw-label{fill:var(--lw-ink);font-weight:600;paint-order:stroke;stroke:var(--lw-paper);
  stroke-width:3px;stroke-linejoin:round}
.lw-drawing .lw-name{fill:var(--c);font-weight:400}
.lw-drawing .lw-name.lw-slanted{font-style:italic}
.lw-drawing .lw-note{fill:var(--lw-warn);font-size:14px;font-weight:600}
.lw .lw-hidden{display:none}
${KINDS}
.lw-drawing .lw-arrow,.lw-key .lw-arrow{stroke:var(--a);fill:var(--a);stroke-width:1.8;stroke-linejoin:round}
.lw-dimension{stroke:var(--lw-muted);stroke-width:.9;fill:none}
.lw-drawing .lw-measure{fill:var(--lw-muted);paint-order:stroke;stroke:var(--lw-paper);stroke-width:4px;
  stroke-linejoin:round;font-variant-numeric:tabular-nums}
.lw-stage{position:relative}
.lw svg.lw-zoomed{touch-action:none}
.lw-zoomed{cursor:move}
.lw-zoomed.lw-grabbable{cursor:grab}
.lw-panning,.lw-zoomed.lw-dragging{cursor:grabbing}
.lw-keys{display:none;position:absolute;left:8px;right:8px;bottom:6px;margin:0;padding:2px 8px;border-radius:5px;
  background:var(--lw-paper);border:1px solid var(--lw-line);color:var(--lw-muted);font-size:12px;pointer-events:none}
.lw-drawing:focus-visible~.lw-keys{display:block}
.lw-tools{position:absolute;top:6px;right:6px;display:flex;gap:2px;pointer-events:none}
.lw-tools button{pointer-events:auto;font:12px/1 inherit;font-family:inherit;color:var(--lw-muted);min-width:28px;
  height:28px;padding:0 6px;
  background:none;border:1px solid transparent;border-radius:4px;cursor:pointer}
.lw-tools button:hover{border-color:var(--lw-line);color:var(--lw-ink)}
.lw-tools svg{display:block;width:16px;height:16px;fill:none;stroke:currentColor;stroke-width:1.5}
.lw-tools .lw-idle{opacity:.6}
.lw-hover{position:absolute;display:grid;grid-template-columns:auto auto;gap:0 .6em;padding:4px 8px;border-radius:5px;
  background:var(--lw-paper);border:1px solid var(--lw-line);box-shadow:0 1px 5px #0003;font-size:12px;
  pointer-events:none;white-space:nowrap;font-variant-numeric:tabular-nums}
.lw-hover[hidden],.lw-scale-of[hidden]{display:none}
.lw-hover b{grid-column:1/-1}
.lw-hover span:nth-of-type(odd){color:var(--lw-muted)}
.lw-hover span:nth-of-type(even){text-align:right}
.lw:fullscreen{background:var(--lw-paper);padding:12px;overflow:auto}
.lw-scale-of output{white-space:nowrap}
.lw-kind,.lw-scale-of{display:inline-flex;flex-wrap:wrap;align-items:center;gap:.4rem}
.lw-kind .lw-swatch{background:var(--a)}
.lw-scale-of input{width:70px;height:18px;margin:0;accent-color:var(--a)}
.lw-key{overflow:visible}
.lw .lw-chooser{position:relative;margin:0;padding:0;border:0;background:none}
.lw .lw-chooser summary{cursor:pointer;padding:0;margin:0}
.lw-chooser>div{position:absolute;z-index:2;bottom:1.7em;left:0;width:15rem;max-width:80vw;padding:8px;
  background:var(--lw-paper);border:1px solid var(--lw-line);border-radius:6px;box-shadow:0 2px 10px #0003}
.lw-chooser input[type="search"]{width:100%;font:inherit;color:inherit;background:var(--lw-paper);
  border:1px solid var(--lw-line);border-radius:4px;padding:3px 6px}
.lw-list{display:flex;flex-direction:column;gap:2px;max-height:13rem;overflow:auto;margin:6px 0}
.lw-chooser button{font:inherit;color:inherit;background:none;border:1px solid var(--lw-line);border-radius:4px;
  padding:1px 8px;margin-right:6px;cursor:pointer}
@media (pointer:coarse){.lw-tools button{min-width:36px;height:36px}.lw-tools{top:0}}
.lw-bar,.lw-options{display:flex;align-items:center;gap:.5rem .75rem;margin-top:.5rem;flex-wrap:wrap}
.lw-options{gap:.35rem 1rem;color:var(--lw-muted);font-size:13px}
.lw-options label{display:inline-flex;align-items:center;gap:.35rem;cursor:pointer}
.lw-options .lw-paths{display:inline-flex;gap:.2rem .8rem;flex-wrap:wrap;align-items:center}
.lw-swatch{width:16px;height:3px;border-radius:2px;background:var(--c)}
.lw-play{flex:none;width:38px;height:38px;padding:0;border:0;border-radius:50%;background:var(--lw-accent);
  cursor:pointer}
.lw-play svg{display:block;width:100%;height:100%;fill:var(--lw-paper)}
.lw-play[aria-pressed="true"] .lw-icon-play,.lw-play[aria-pressed="false"] .lw-icon-pause{display:none}
.lw-track{position:relative;flex:1 1 8rem;min-width:7rem}
.lw-track input{display:block;width:100%;height:24px;margin:0;accent-color:var(--lw-accent);cursor:pointer}
.lw-gaps{position:relative;height:3px;margin:0 8px}
.lw-gaps i{position:absolute;top:0;height:3px;min-width:3px;background:var(--lw-warn)}
.lw-time{flex:none;font-variant-numeric:tabular-nums;text-align:right;white-space:nowrap}
.lw select{font:inherit;color:inherit;background:var(--lw-paper);border:1px solid var(--lw-line);
  border-radius:4px;padding:2px 4px}
.lw :is(button,input,select,svg.lw-drawing):focus-visible{outline:2px solid var(--lw-accent);outline-offset:2px}
`;
