// Eigenvalues one can point at: wheel zooms, dragging moves, a click shows the mode. No outside resource.
"use strict";
const data = JSON.parse(document.getElementById("data").textContent);
const NS = "http://www.w3.org/2000/svg", W = 760, H = 540, M = { l: 70, r: 64, t: 12, b: 44 };
const COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"];
const MARKS = [
  (x, y, r) => `M${x - r} ${y}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0`,
  (x, y, r) => `M${x - r} ${y - r}L${x + r} ${y + r}M${x - r} ${y + r}L${x + r} ${y - r}`,
  (x, y, r) => `M${x - r} ${y - r}h${2 * r}v${2 * r}h${-2 * r}z`,
  (x, y, r) => `M${x} ${y - r}L${x + r} ${y + r}h${-2 * r}z`,
  (x, y, r) => `M${x} ${y - 1.3 * r}L${x + 1.3 * r} ${y}L${x} ${y + 1.3 * r}L${x - 1.3 * r} ${y}z`,
];
const colour = (i) => COLOURS[i % COLOURS.length], mark = (i) => MARKS[i % MARKS.length];
const el = (name, attributes = {}, parent = null, text = "") => {
  const made = document.createElementNS(NS, name);
  for (const key in attributes) made.setAttribute(key, attributes[key]);
  if (text) made.textContent = text;
  if (parent) parent.appendChild(made);
  return made;
};
const digits = (v) => (v === 0 ? "0" : Math.abs(v) >= 1e4 || Math.abs(v) < 1e-3 ? v.toExponential(2) : String(+v.toPrecision(4)));

// One entry for every point: conjugate pairs are two points of one mode.
const points = [];
data.snapshots.forEach((s, i) => s.modes.forEach((m) => {
  points.push({ i, m, s, x: m.re, y: m.im });
  if (m.im > 0) points.push({ i, m, s, x: m.re, y: -m.im });
}));
const sizes = points.map((p) => Math.hypot(p.x, p.y)).filter((v) => v > 0);
const largest = Math.max(1e-300, ...sizes), smallest = Math.min(largest, ...sizes);
let logarithmic = largest / smallest > 300, selected = null, hidden = new Set(), view = null;
const threshold = 10 ** Math.floor(Math.log10(Math.max(smallest, largest * 1e-6)));
const forward = (v) => (logarithmic ? Math.sign(v) * Math.log1p(Math.abs(v) / threshold) : v);
const backward = (w) => (logarithmic ? Math.sign(w) * threshold * Math.expm1(Math.abs(w)) : w);
const home = () => {
  const xs = points.map((p) => forward(p.x)), ys = points.map((p) => Math.abs(forward(p.y)));
  const reach = Math.max(...ys, 0.3 * forward(largest)) * 1.15 || 1, left = Math.min(...xs, -0.3 * forward(largest));
  const right = Math.max(...xs, 0.1 * Math.abs(left), forward(threshold) * logarithmic);
  return { x0: left - 0.08 * (right - left), x1: right + 0.05 * (right - left), y0: -reach, y1: reach };
};
const svg = document.getElementById("plane");
const px = (v) => M.l + ((forward(v) - view.x0) / (view.x1 - view.x0)) * (W - M.l - M.r);
const py = (v) => H - M.b - ((forward(v) - view.y0) / (view.y1 - view.y0)) * (H - M.t - M.b);
const ticks = (low, high, count) => {
  if (logarithmic) {
    const out = [0];
    for (let k = Math.log10(threshold); k <= 16; k++) out.push(10 ** k, -(10 ** k));
    const inside = out.filter((v) => forward(v) >= low && forward(v) <= high).sort((a, b) => a - b);
    const each = Math.ceil(inside.length / count);
    return inside.filter((v) => v === 0 || Math.round(Math.log10(Math.abs(v))) % each === 0);
  }
  const raw = (high - low) / count, unit = 10 ** Math.floor(Math.log10(raw));
  const step = unit * [1, 2, 5, 10].find((f) => f * unit >= raw), out = [];
  for (let v = Math.ceil(low / step) * step; v <= high; v += step) out.push(Math.abs(v) < step / 1e6 ? 0 : v);
  return out;
};
function draw() {
  view = view || home();
  svg.replaceChildren();
  const inside = { x: M.l, y: M.t, width: W - M.l - M.r, height: H - M.t - M.b };
  el("rect", { ...inside, class: "frame" }, svg);
  const clip = el("clipPath", { id: "clip" }, svg);
  el("rect", inside, clip);
  const area = el("g", { "clip-path": "url(#clip)" }, svg), zero = px(0);
  el("rect", { x: zero, y: M.t, width: Math.max(0, W - zero), height: inside.height, class: "unstable" }, area);
  for (const v of ticks(view.x0, view.x1, 8)) {
    el("line", { x1: px(v), x2: px(v), y1: M.t, y2: H - M.b, class: v ? "grid" : "axis" }, area);
    el("text", { x: px(v), y: H - M.b + 16, class: "tick", "text-anchor": "middle" }, svg, digits(v));
  }
  for (const v of ticks(view.y0, view.y1, 9)) {
    el("line", { x1: M.l, x2: W - M.r, y1: py(v), y2: py(v), class: v ? "grid" : "axis" }, area);
    el("text", { x: M.l - 6, y: py(v) + 4, class: "tick", "text-anchor": "end" }, svg, digits(v));
    el("text", { x: W - M.r + 6, y: py(v) + 4, class: "tick" }, svg, digits(v / (2 * Math.PI)));
  }
  el("text", { x: (M.l + W - M.r) / 2, y: H - 8, class: "name", "text-anchor": "middle" }, svg, "real part [1/s]");
  for (const [x, text] of [[14, "imaginary part [rad/s]"], [W - 6, "imaginary part / 2π [Hz]"]])
    el("text", { transform: `translate(${x} ${H / 2}) rotate(-90)`, class: "name", "text-anchor": "middle" }, svg, text);
  for (const ratio of [0.02, 0.1, 0.3, 0.7]) for (const sign of [1, -1]) {
    const line = [];
    for (let k = 0; k <= 240; k++) {
      const size = 2 * largest * 10 ** (-8 * (1 - k / 240));
      line.push(`${px(-ratio * size).toFixed(1)} ${py(sign * Math.sqrt(1 - ratio ** 2) * size).toFixed(1)}`);
    }
    el("path", { d: "M" + line.join("L"), class: "ray" }, area);
  }
  for (const track of data.tracks || []) for (const sign of [1, -1])
    el("path", { d: "M" + track.map(([x, y]) => `${px(x).toFixed(1)} ${py(sign * y).toFixed(1)}`).join("L"), class: "track" }, area);
  points.forEach((p) => {
    if (hidden.has(p.i)) return;
    const chosen = selected && selected.m === p.m;
    const d = mark(p.i)(px(p.x), py(p.y), chosen ? 7 : 5);
    el("path", { d, stroke: colour(p.i), class: chosen ? "root chosen" : "root" }, area);
    const hit = el("circle", { cx: px(p.x), cy: py(p.y), r: 9, class: "hit" }, area);
    hit.addEventListener("mouseenter", (event) => tell(p, event));
    hit.addEventListener("mouseleave", () => (tip.hidden = true));
    hit.addEventListener("click", () => select(p));
  });
}
const tip = document.getElementById("tip");
const value = (m) => digits(m.re) + (m.im ? ` ± ${digits(m.im)}i` : "") + " 1/s";
function tell(p, event) {
  const leading = p.m.states.slice().sort((a, b) => b[1] - a[1]).slice(0, 4);
  tip.textContent = [`${p.s.name}: mode ${p.m.number}`, value(p.m), `${digits(p.m.hz)} Hz, damping ${digits(p.m.damping)}`, p.m.kind,
    ...leading.map(([k, share]) => `${p.s.states[k]} ${(100 * share).toFixed(0)} %`)].join("\n");
  tip.hidden = false;
  tip.style.left = `${event.pageX + 14}px`;
  tip.style.top = `${event.pageY + 14}px`;
}
const panel = document.getElementById("mode"), calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
let moving = [], phase = 0, last = 0;
function select(p) {
  selected = p;
  draw();
  panel.replaceChildren();
  const add = (name, text, parent = panel, cls = "") => {
    const made = document.createElement(name);
    made.textContent = text;
    made.className = cls;
    parent.appendChild(made);
    return made;
  };
  add("h2", `Mode ${p.m.number} of ${p.s.name}`);
  add("p", `${value(p.m)}, ${digits(p.m.hz)} Hz, damping ${digits(p.m.damping)}, ${p.m.kind}` + (p.m.multiplicity > 1 ? `, ${p.m.multiplicity} times` : ""));
  const table = add("table", "");
  const head = add("tr", "", table);
  for (const text of ["state", "participation", "shape in nominal values" + (p.m.im && !calm ? ", moving" : "")]) add("th", text, head);
  moving = p.m.states.slice().sort((a, b) => b[1] - a[1]).slice(0, 20).map(([k, share, re, im]) => {
    const row = add("tr", "", table);
    add("td", p.s.states[k], row);
    const part = add("td", "", row, "bar");
    add("span", "", part).style.width = `${(100 * share).toFixed(1)}%`;
    add("small", `${(100 * share).toFixed(1)} %`, part);
    const cell = add("td", "", row, "swing"), bar = add("span", "", cell);
    cell.title = `${digits(Math.hypot(re, im))} at ${digits((Math.atan2(im, re) * 180) / Math.PI)}°`;
    return { bar, re, im };
  });
  pose(0);
}
function pose(angle) {
  for (const { bar, re, im } of moving) {
    const now = re * Math.cos(angle) - im * Math.sin(angle);
    bar.style.left = `${now >= 0 ? 50 : 50 + 50 * now}%`;
    bar.style.width = `${50 * Math.abs(now)}%`;
  }
}
function tick(time) {
  if (selected && selected.m.im > 0 && !calm && !document.hidden) {
    phase += ((time - last) / 1000) * Math.PI;
    pose(phase);
  }
  last = time;
  requestAnimationFrame(tick);
}
const where = (event) => {
  const box = svg.getBoundingClientRect();
  return [((event.clientX - box.left) / box.width) * W, ((event.clientY - box.top) / box.height) * H];
};
svg.addEventListener("wheel", (event) => {
  event.preventDefault();
  const [x, y] = where(event), f = Math.exp(event.deltaY / 600);
  const cx = view.x0 + ((x - M.l) / (W - M.l - M.r)) * (view.x1 - view.x0), cy = view.y0 + ((H - M.b - y) / (H - M.t - M.b)) * (view.y1 - view.y0);
  view = { x0: cx + f * (view.x0 - cx), x1: cx + f * (view.x1 - cx), y0: cy + f * (view.y0 - cy), y1: cy + f * (view.y1 - cy) };
  draw();
}, { passive: false });
let held = null;
svg.addEventListener("pointerdown", (event) => (held = { at: where(event), view: { ...view } }));
window.addEventListener("pointerup", () => (held = null));
svg.addEventListener("pointermove", (event) => {
  if (!held) return;
  const [x, y] = where(event), dx = ((x - held.at[0]) / (W - M.l - M.r)) * (view.x1 - view.x0), dy = ((y - held.at[1]) / (H - M.t - M.b)) * (view.y1 - view.y0);
  if (Math.hypot(x - held.at[0], y - held.at[1]) < 3) return;
  view = { x0: held.view.x0 - dx, x1: held.view.x1 - dx, y0: held.view.y0 + dy, y1: held.view.y1 + dy };
  draw();
});
const reset = () => { view = null; draw(); };
svg.addEventListener("dblclick", reset);
document.getElementById("reset").addEventListener("click", reset);
const scale = document.getElementById("log");
scale.checked = logarithmic;
scale.addEventListener("change", () => { logarithmic = scale.checked; reset(); });
document.querySelectorAll("[data-show]").forEach((box) => box.addEventListener("change", () => {
  box.checked ? hidden.delete(+box.dataset.show) : hidden.add(+box.dataset.show);
  draw();
}));
document.querySelectorAll("tr[data-mode]").forEach((row) => row.addEventListener("click", () => {
  const [i, number] = row.dataset.mode.split(" ").map(Number);
  select(points.find((p) => p.i === i && p.m.number === number));
}));
document.querySelectorAll("[data-key]").forEach((key) => {
  const i = +key.dataset.key, icon = el("svg", { width: 16, height: 16 });
  el("path", { d: mark(i)(8, 8, 5), stroke: colour(i), class: "root" }, icon);
  key.appendChild(icon);
});
draw();
const first = points.find((p) => p.m.number === data.chosen) || points.find((p) => p.m.im > 0) || points[0];
if (first) select(first);
requestAnimationFrame(tick);
