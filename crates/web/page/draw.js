// Figures as SVG.
const NS = "http://www.w3.org/2000/svg";
const css = { accent: "var(--accent)", second: "var(--second)", line: "var(--line)", fill: "var(--fill)", bad: "var(--bad)" };

function element(name, attributes, text) {
  const made = document.createElementNS(NS, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text !== undefined) made.textContent = text;
  return made;
}

function sheet(place, width, height, label) {
  const svg = element("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": label });
  place.replaceChildren(svg);
  return (name, attributes, text) => svg.appendChild(element(name, attributes, text));
}

// Three to seven round steps from low to high.
export function ticks(low, high) {
  const span = high - low || Math.abs(high) || 1, rough = span / 5;
  const ten = 10 ** Math.floor(Math.log10(rough)), of = rough / ten;
  const step = ten * (of > 5 ? 10 : of > 2 ? 5 : of > 1 ? 2 : 1);
  const all = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * span; k += 1) all.push(k * step);
  return all;
}

export function short(value, digits = 3) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e7)) return value.toExponential(digits - 1).replace("e+", "e");
  const decimals = size === 0 ? 0 : Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
  const text = value.toFixed(Math.min(decimals, 8));
  return text.includes(".") ? text.replace(/\.?0+$/, "") : text;
}

// Loads and contact angles of the inner contacts; azimuth 0, where a radial load acts, is at the bottom.
export function polar(place, balls) {
  const size = 360, middle = size / 2, radius = 128;
  const add = sheet(place, size, size, "Loads and contact angles of the inner contacts over the azimuth");
  const loads = balls.map(ball => ball.load_inner_n), most = Math.max(...loads);
  const angles = balls.map((ball, k) => loads[k] > 1e-6 * most ? Math.abs(ball.contact_angle_inner_deg) : 0);
  const steepest = Math.max(...angles, 1e-9);
  const rings = ticks(0, most || 1).filter(value => value > 0), top = Math.max(most, rings.at(-1) ?? 1);
  const degrees = ticks(0, steepest).filter(value => value > 0), end = Math.max(steepest, degrees.at(-1) ?? 1);
  const at = (azimuth, part) => {
    const phi = azimuth * Math.PI / 180;
    return [middle + radius * part * Math.sin(phi), middle + radius * part * Math.cos(phi)];
  };
  const path = parts => parts.map(([x, y], k) => `${k ? "L" : "M"}${x.toFixed(2)} ${y.toFixed(2)}`).join("") + "Z";
  for (const value of rings) add("circle", { cx: middle, cy: middle, r: radius * value / top, fill: "none", stroke: css.line });
  for (let azimuth = 0; azimuth < 360; azimuth += 30) {
    const [x, y] = at(azimuth, 1), [tx, ty] = at(azimuth, 1.16);
    add("line", { x1: middle, y1: middle, x2: x, y2: y, stroke: css.line });
    add("text", { x: tx, y: ty + 4, "text-anchor": "middle", class: "soft" }, `${azimuth}°`);
  }
  add("path", { d: path(balls.map((ball, k) => at(ball.azimuth_deg, loads[k] / top))), fill: css.fill, stroke: css.accent, "stroke-width": 2 });
  if (steepest > 1e-6) {
    add("path", { d: path(balls.map((ball, k) => at(ball.azimuth_deg, angles[k] / end))), fill: "none", stroke: css.second, "stroke-width": 1.6, "stroke-dasharray": "5 3" });
  }
  balls.forEach((ball, k) => {
    const [cx, cy] = at(ball.azimuth_deg, loads[k] / top);
    const dot = add("circle", { cx, cy, r: 4, fill: css.accent });
    dot.appendChild(element("title", {}, `${short(ball.azimuth_deg)}°: ${short(loads[k], 4)} N at ${short(angles[k])}°`));
  });
  for (const value of rings) {
    const [x, y] = at(165, value / top);
    add("text", { x, y: y + 4, "text-anchor": "middle" }, `${short(value)}${value === rings.at(-1) ? " N" : ""}`);
  }
  if (steepest > 1e-6) add("text", { x: 2, y: size - 4, style: `fill: ${css.second}` }, `- - contact angle, rim ${short(end)}°`);
}

// A curve over a load or speed, with a line where the form stands; `log` for what spans decades.
export function curve(place, points, { value, label, x, at, log }) {
  // Text keeps its size in a narrow window.
  const width = Math.max(320, Math.min(720, place.clientWidth || 720)), height = 300, left = 78, right = 18, top = 14, bottom = 44;
  const add = sheet(place, width, height, `${label} over ${x}`);
  const known = points.map(point => [point.at, value(point)]).filter(([, y]) => Number.isFinite(y) && (!log || y > 0));
  if (known.length < 2) {
    add("text", { x: width / 2, y: height / 2, "text-anchor": "middle" }, points.find(point => point.error)?.error.slice(0, 90) ?? "no values here");
    return;
  }
  const scale = log ? Math.log10 : y => y, ys = known.map(([, y]) => scale(y));
  const xs = [points[0].at, points.at(-1).at];
  let low = log ? Math.floor(Math.min(...ys)) : Math.min(0, ...ys), high = log ? Math.ceil(Math.max(...ys)) : Math.max(0, ...ys);
  if (high === low) high = low + 1;
  const X = v => left + (v - xs[0]) / (xs[1] - xs[0]) * (width - left - right);
  const Y = v => height - bottom - (v - low) / (high - low) * (height - top - bottom);
  const levels = log ? Array.from({ length: high - low + 1 }, (_, k) => low + k).filter((_, k) => k % Math.ceil((high - low) / 6) === 0) : ticks(low, high);
  for (const level of levels) {
    add("line", { x1: left, x2: width - right, y1: Y(level), y2: Y(level), stroke: css.line });
    add("text", { x: left - 8, y: Y(level) + 4, "text-anchor": "end" }, short(log ? 10 ** level : level));
  }
  for (const level of ticks(...xs)) {
    add("line", { y1: top, y2: height - bottom, x1: X(level), x2: X(level), stroke: css.line });
    add("text", { x: X(level), y: height - bottom + 17, "text-anchor": "middle" }, short(level));
  }
  add("text", { x: (left + width - right) / 2, y: height - 8, "text-anchor": "middle", class: "soft" }, x);
  add("text", { x: 14, y: (top + height - bottom) / 2, "text-anchor": "middle", class: "soft", transform: `rotate(-90 14 ${(top + height - bottom) / 2})` }, label);
  add("path", { d: known.map(([a, y], k) => `${k ? "L" : "M"}${X(a).toFixed(2)} ${Y(scale(y)).toFixed(2)}`).join(""), fill: "none", stroke: css.accent, "stroke-width": 2.2 });
  for (const [a, y] of known) {
    add("circle", { cx: X(a), cy: Y(scale(y)), r: 3, fill: css.accent }).appendChild(element("title", {}, `${short(a, 4)}: ${short(y, 4)}`));
  }
  if (at >= xs[0] && at <= xs[1]) add("line", { x1: X(at), x2: X(at), y1: top, y2: height - bottom, stroke: css.second, "stroke-width": 1.5, "stroke-dasharray": "5 3" });
}

// Long series over a time or another column: of each pixel the least and the largest value.
export function series(place, { xs, ys, x, label, at, marks = [] }) {
  const width = Math.max(320, Math.min(1100, place.clientWidth || 720)), height = 260, left = 78, right = 18, top = 14, bottom = 44;
  const add = sheet(place, width, height, `${label} over ${x}`);
  const [from, to] = [xs[0], xs[xs.length - 1]];
  let low = Infinity, high = -Infinity;
  for (const y of ys) if (Number.isFinite(y)) { low = Math.min(low, y); high = Math.max(high, y); }
  if (!(low <= high) || !(from < to)) { add("text", { x: width / 2, y: height / 2, "text-anchor": "middle" }, "no values here"); return; }
  if (high === low) { low -= Math.abs(low) * 1e-3 || 1; high += Math.abs(high) * 1e-3 || 1; }
  const X = v => left + (v - from) / (to - from) * (width - left - right);
  const Y = v => height - bottom - (v - low) / (high - low) * (height - top - bottom);
  for (const level of ticks(low, high)) {
    add("line", { x1: left, x2: width - right, y1: Y(level), y2: Y(level), stroke: css.line });
    add("text", { x: left - 8, y: Y(level) + 4, "text-anchor": "end" }, short(level, 5));
  }
  for (const level of ticks(from, to)) {
    if (X(level) > width - right - 14) continue;
    add("line", { y1: top, y2: height - bottom, x1: X(level), x2: X(level), stroke: css.line });
    add("text", { x: X(level), y: height - bottom + 17, "text-anchor": "middle" }, short(level, 5));
  }
  add("text", { x: (left + width - right) / 2, y: height - 8, "text-anchor": "middle", class: "soft" }, x);
  add("text", { x: 14, y: (top + height - bottom) / 2, "text-anchor": "middle", class: "soft", transform: `rotate(-90 14 ${(top + height - bottom) / 2})` }, label);
  const pixels = new Map();
  for (let k = 0; k < ys.length; k += 1) {
    if (!Number.isFinite(ys[k]) || !(xs[k] >= from && xs[k] <= to)) continue;
    const px = Math.round(X(xs[k])), there = pixels.get(px);
    if (there) { there[1] = Math.min(there[1], ys[k]); there[2] = Math.max(there[2], ys[k]); there[3] = ys[k]; }
    else pixels.set(px, [ys[k], ys[k], ys[k], ys[k]]);
  }
  const path = [...pixels].flatMap(([px, values]) => [...new Set(values)].map(y => `${px} ${Y(y).toFixed(1)}`));
  for (const [name, value] of marks) {
    add("line", { y1: top, y2: height - bottom, x1: X(value), x2: X(value), stroke: css.second, "stroke-dasharray": "4 3" });
    add("text", { x: X(value) + 3, y: top + 10, style: `fill: ${css.second}` }, name);
  }
  add("path", { d: `M${path.join("L")}`, fill: "none", stroke: css.accent, "stroke-width": 1.4 });
  return add("line", { y1: top, y2: height - bottom, x1: X(at ?? from), x2: X(at ?? from), stroke: at === undefined ? "none" : css.second, "stroke-width": 1.5 });
}
