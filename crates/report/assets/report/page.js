// Covers the drawings of a report with interactive charts: zoom, read-out at the cursor, legends that toggle, ranges to choose from.
// Without this script, and on paper, the drawings are what is seen.
(() => {
  "use strict";
  const source = document.getElementById("charts");
  if (!source || typeof uPlot === "undefined") return;
  const { columns, charts } = JSON.parse(source.textContent);
  const tone = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const FONT = "12px " + getComputedStyle(document.body).fontFamily;
  const FAMILIES = { BPFO: "--c2", BPFI: "--c3", FTF: "--c5", BSF: "--c4", f_r: "--muted" };

  const decoded = new Map();
  function column(k) {
    if (!decoded.has(k)) {
      const bytes = Uint8Array.from(atob(columns[k]), (c) => c.charCodeAt(0));
      const view = new DataView(bytes.buffer);
      decoded.set(k, Array.from({ length: bytes.length / 4 }, (_, i) => view.getFloat32(4 * i, true)));
    }
    return decoded.get(k);
  }

  const element = (tag, attributes, ...inside) => {
    const made = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
    made.append(...inside);
    return made;
  };

  /// Fewest decimals that say a step whole, 0.25 with two of them; steps have three figures at most.
  const decimals = (step) => {
    const least = Math.min(12, Math.max(0, -Math.floor(Math.log10(step) + 1e-9)));
    const whole = (k) => Math.abs(step * 10 ** k - Math.round(step * 10 ** k)) < 1e-4 * step * 10 ** k;
    return [0, 1, 2].map((more) => least + more).find(whole) ?? least + 2;
  };
  const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";
  const power = (k) => "10" + (k < 0 ? "⁻" : "") + [...String(Math.abs(k))].map((d) => SUPERSCRIPTS[d]).join("");
  /// `2.25e-7`: decimals of the mantissa so that the step is whole.
  const scientific = (v, step) => {
    if (Math.abs(v) < 1e-6 * step) return "0";
    const order = Math.floor(Math.log10(Math.abs(v)) + 1e-9);
    return v.toExponential(Math.min(12, decimals(step / 10 ** order)));
  };
  const numbers = (values) => {
    const step = values.length > 1 ? Math.abs(values[1] - values[0]) : Math.abs(values[0]) || 1;
    const most = Math.max(...values.map((v) => Math.abs(v ?? 0)));
    const write = (v) => (most < 1e6 && step >= 1e-6 ? v.toFixed(decimals(step)) : scientific(v, step));
    return values.map((v) => (v == null ? v : write(v).replace("-", "−").replace("e+", "e")));
  };
  const figures = (v) => {
    if (v == null) return "–";
    const text = Math.abs(v) >= 1e6 || (v !== 0 && Math.abs(v) < 1e-4) ? v.toExponential(3) : String(Number(v.toPrecision(6)));
    return text.replace("-", "−");
  };
  const withUnit = (label, unit) => (unit ? `${label}, ${unit}` : label);

  /// A range with room around it. Columns have seven figures: less than a millionth of the values is rounding.
  const padded = (low, high, cover) => {
    if (low == null || high == null) return [0, 1];
    if (cover) [low, high] = [Math.min(low, cover[0]), Math.max(high, cover[1])];
    const least = 1e-6 * Math.max(Math.abs(low), Math.abs(high));
    if (high - low < least) [low, high] = [0.5 * (low + high - 1e4 * least), 0.5 * (low + high + 1e4 * least)];
    const room = high > low ? 0.06 * (high - low) : 0.1 * Math.abs(high) || 1;
    return [low - room, high + room];
  };

  const axis = (more) => ({ stroke: () => tone("--muted"), font: FONT, labelFont: FONT, labelGap: 2, gap: 5,
    grid: { stroke: () => tone("--grid"), width: 1 }, ticks: { stroke: () => tone("--grid"), width: 1, size: 5 }, ...more });

  /// Room for the widest number beside the ordinate.
  const room = (u, values, index, cycle) => {
    const own = u.axes[index];
    if (cycle > 1) return own._size;
    u.ctx.font = own.font[0];
    const widest = (values ?? []).reduce((most, text) => Math.max(most, u.ctx.measureText(text ?? "").width), 0);
    return Math.ceil(widest / devicePixelRatio) + own.ticks.size + own.gap + 4;
  };

  /// Marked frequencies: lines through the area, labels in rows at its top where they do not cover one another.
  function drawMarks(u, chart, shown) {
    const { ctx, bbox } = u;
    const scale = devicePixelRatio;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    ctx.font = `${12 * scale}px ` + FONT.slice(5);
    ctx.textBaseline = "middle";
    ctx.textAlign = "left";
    const placed = [];
    for (const mark of chart.marks) {
      if (!shown.has(mark.family) || mark.at < u.scales.x.min || mark.at > u.scales.x.max) continue;
      const x = u.valToPos(mark.at, "x", true);
      const wide = ctx.measureText(mark.label).width + 10 * scale;
      const left = Math.min(Math.max(x - wide / 2, bbox.left), bbox.left + bbox.width - wide);
      const free = (row) => !placed.some((p) => p.row === row && left < p.left + p.wide && left + wide > p.left);
      placed.push({ mark, x, left, wide, row: [0, 1, 2].find(free) ?? -1, colour: tone(FAMILIES[mark.family]) });
    }
    ctx.setLineDash([4 * scale, 4 * scale]);
    ctx.lineWidth = scale;
    for (const { x, row, colour } of placed) {
      ctx.strokeStyle = colour;
      ctx.beginPath();
      ctx.moveTo(x, bbox.top + (4 + 17 * (row + 1)) * scale);
      ctx.lineTo(x, bbox.top + bbox.height);
      ctx.stroke();
    }
    for (const { mark, left, wide, row, colour } of placed.filter((p) => p.row >= 0)) {
      const middle = bbox.top + (12.5 + 17 * row) * scale;
      ctx.fillStyle = tone("--paper");
      ctx.fillRect(left, middle - 8 * scale, wide, 16 * scale);
      ctx.fillStyle = colour;
      ctx.fillText(mark.label, left + 5 * scale, middle);
    }
    ctx.restore();
  }

  /// Round orders within a range of frequencies.
  function orders(low, high, shaft, wide) {
    const least = ((high - low) / shaft) * (46 / Math.max(wide, 46));
    const magnitude = 10 ** Math.floor(Math.log10(least));
    const step = [1, 2, 5, 10].map((k) => k * magnitude).find((s) => s >= least);
    const found = [];
    for (let k = Math.ceil(low / shaft / step - 1e-9); k * step * shaft <= high * (1 + 1e-9); k += 1) found.push(k * step * shaft);
    return found;
  }

  // uPlot's logarithmic axis never ends where it begins just below a power of ten.
  const decade = (v) => 10 ** Math.floor(Math.log10(v));
  const isPower = (v) => v != null && Math.abs(Math.log10(v) - Math.round(Math.log10(v))) < 1e-6;

  function axes(chart, last) {
    const log = chart.kind === "spectrum";
    const powers = { filter: (_, splits) => splits.map((v) => (isPower(v) ? v : null)) };
    const lines = axis({});
    const all = [
      axis({ label: last ? withUnit(chart.label, chart.unit) : null, labelSize: 20, size: 30, space: 64, values: (_, v) => numbers(v) }),
      axis({ size: room, space: 34, values: (_, v) => (log ? v.map((x) => (isPower(x) ? power(Math.round(Math.log10(x))) : "")) : numbers(v)),
        ...(log ? { grid: { ...lines.grid, ...powers }, ticks: { ...lines.ticks, ...powers } } : {}) }),
    ];
    if (chart.shaft_hz) {
      all.push(axis({ scale: "x", side: 0, size: 28, label: "Order (multiples of the shaft frequency)", labelSize: 20, grid: { show: false },
        splits: (u, _, low, high) => orders(low, high, chart.shaft_hz, u.bbox.width / devicePixelRatio),
        values: (_, v) => numbers(v.map((hz) => hz / chart.shaft_hz)) }));
    }
    return all;
  }

  const readout = (chart) => (_, x) => {
    if (x == null) return "–";
    const own = `${figures(x)}${chart.unit === "°" ? "" : " "}${chart.unit}`;
    return chart.shaft_hz ? `${own}, order ${(x / chart.shaft_hz).toFixed(2)}` : own;
  };

  function plot(chart, panel, place, state, last) {
    const tones = (label) => `--c${state.labels.indexOf(label) % 7}`;
    const lines = panel.lines.map((line) => ({ label: line.label, width: 1.4, stroke: () => tone(tones(line.label)), points: { show: false },
      value: (_, v) => figures(v) + (v == null || !panel.unit ? "" : " " + panel.unit) }));
    const log = chart.kind === "spectrum";
    const options = {
      width: place.clientWidth, height: state.height + (last ? 20 : 0) + (chart.shaft_hz ? 48 : 0), padding: [10, 24, 0, 0],
      series: [{ label: chart.label, value: readout(chart) }, ...lines],
      scales: { x: { time: false, range: (u, low, high) => (low === high ? [low - 0.5, low + 0.5] : [low, high]) },
        y: log ? { distr: 3, range: (_, low, high) => (low > 0 ? [decade(low), high * (chart.marks.length ? 40 : 2)] : [0.1, 1]) }
          : { range: (_, low, high) => padded(low, high, panel.cover) } },
      axes: axes(chart, last),
      cursor: { drag: { x: true, y: false, dist: 6 }, points: { size: 7 }, sync: { key: state.key, setSeries: false },
        bind: { dblclick: () => () => { show(state, chart.views[0]); return null; } } },
      legend: { live: true },
      hooks: { draw: [(u) => drawMarks(u, chart, state.families)] },
    };
    const data = [column(chart.x), ...panel.lines.map((line) => column(line.y))];
    const made = new uPlot(options, data, place);
    for (const entry of made.root.querySelectorAll(".u-series:not(:first-child) th")) {
      entry.tabIndex = 0;
      entry.setAttribute("role", "button");
      entry.title = "Show or hide";
      entry.addEventListener("keydown", (e) => { if (e.key === "Enter" || e.key === " ") { e.preventDefault(); entry.click(); } });
    }
    return made;
  }

  const together = (state) => (state.key === "time" ? states.filter((s) => s.key === "time") : [state]);
  function scaled(state, from, to) {
    for (const one of together(state)) for (const u of one.plots) u.setScale("x", { min: from, max: to });
  }
  function show(state, view) { scaled(state, view.from, view.to); }
  function zoomed(state, factor) {
    const { min, max } = state.plots[0].scales.x;
    const [first, last] = state.ends;
    const half = Math.min(0.5 * factor * (max - min), 0.5 * (last - first));
    const middle = Math.min(Math.max(0.5 * (min + max), first + half), last - half);
    scaled(state, middle - half, middle + half);
  }

  function tools(state, chart, figure) {
    const button = (text, name, press) => {
      const made = element("button", { type: "button", "aria-label": name }, text);
      made.addEventListener("click", press);
      return made;
    };
    const all = [];
    const drawing = chart.kind === "orbit" ? ["Polar", "Over the azimuth"] : null;
    const charted = (on) => { figure.classList.toggle("live-shown", on); if (on) sized(state); };
    if (drawing) {
      const pair = [button(drawing[0], drawing[0], () => set(false)), button(drawing[1], drawing[1], () => set(true))];
      const set = (on) => { charted(on); pair.forEach((b, k) => b.setAttribute("aria-pressed", String(on === (k === 1)))); };
      pair.forEach((b, k) => b.setAttribute("aria-pressed", String(k === 0)));
      return pair;
    }
    for (const view of chart.views) {
      const made = button(view.name, view.name, () => show(state, view));
      state.buttons.push([made, view]);
      all.push(made);
    }
    all.push(button("+", "Zoom in", () => zoomed(state, 0.5)), button("−", "Zoom out", () => zoomed(state, 2)));
    const families = [...new Set(chart.marks.map((mark) => mark.family))];
    for (const family of families) {
      const made = element("button", { type: "button", class: "family", "aria-pressed": "true" },
        element("i", { style: `background: var(${FAMILIES[family]})` }), family);
      made.addEventListener("click", () => {
        const on = !state.families.has(family);
        if (on) state.families.add(family); else state.families.delete(family);
        made.setAttribute("aria-pressed", String(on));
        state.plots.forEach((u) => u.redraw(false));
      });
      all.push(made);
    }
    return all;
  }

  function note(chart) {
    const count = chart.samples.toLocaleString("en").replaceAll(",", "\u202f");
    const what = chart.kind === "spectrum" ? "lines" : "samples";
    const shown = chart.each === 1 ? `All ${count} ${what} of a curve are in the figure.`
      : `Least and greatest of each ${chart.each} of ${count} ${what} of a curve.`;
    return `${shown} Drag to zoom, double-click to go back, click a name to hide its curve.`;
  }

  function sized(state) {
    for (const u of state.plots) {
      const width = u.root.parentElement.clientWidth;
      if (width > 0 && width !== u.width) u.setSize({ width, height: u.height });
    }
  }

  const states = [];
  function build(chart) {
    const figure = document.getElementById(chart.name);
    if (!figure) return;
    const x = column(chart.x);
    const state = { plots: [], buttons: [], families: new Set(chart.marks.map((mark) => mark.family)), ends: [x[0], x[x.length - 1]],
      key: chart.kind === "history" ? "time" : chart.name, height: chart.panels.length > 1 ? 170 : 300,
      labels: [...new Set(chart.panels.flatMap((panel) => panel.lines.map((line) => line.label)))] };
    const body = element("div", { class: "chart" });
    const live = element("div", { class: "live" },
      element("div", { class: "head" }, element("h3", {}, chart.title), element("div", { class: "tools" }, ...tools(state, chart, figure))), body);
    figure.prepend(live);
    figure.classList.add("ready");
    if (chart.kind !== "orbit") figure.classList.add("live-shown");
    chart.panels.forEach((panel, k) => {
      const heading = element("p", { class: "axis" });
      if (panel.title) heading.append(element("b", {}, panel.title), " · ");
      heading.append(withUnit(panel.label, panel.unit));
      const place = element("div", {});
      body.append(heading, place);
      state.plots.push(plot(chart, panel, place, state, k === chart.panels.length - 1));
    });
    body.append(element("p", { class: "note" }, note(chart)));
    const first = chart.views[0];
    if (first) for (const u of state.plots) u.setScale("x", { min: first.from, max: first.to });
    state.plots[0].hooks.setScale = [...(state.plots[0].hooks.setScale ?? []), (u, key) => {
      if (key !== "x") return;
      const near = (a, b) => Math.abs(a - b) < 1e-6 * (state.ends[1] - state.ends[0]);
      for (const [made, view] of state.buttons) {
        made.setAttribute("aria-pressed", String(near(u.scales.x.min, view.from) && near(u.scales.x.max, view.to)));
      }
    }];
    state.buttons.forEach(([made], k) => made.setAttribute("aria-pressed", String(k === 0)));
    states.push(state);
    new ResizeObserver(() => sized(state)).observe(body);
  }

  charts.forEach(build);
  const repaint = () => states.forEach((state) => state.plots.forEach((u) => {
    u.root.querySelectorAll(".u-series:not(:first-child) .u-marker").forEach((m, k) => {
      m.style.borderColor = m.style.background = u.series[k + 1].stroke();
    });
    u.redraw(false);
  }));
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", repaint);
  repaint();
})();
