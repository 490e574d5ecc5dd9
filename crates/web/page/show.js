// Numbers as cards and tables.
import { short } from "./draw.js";

const text = (name, content, attributes = {}) => Object.assign(document.createElement(name), { textContent: content }, attributes);
const row = cells => { const tr = document.createElement("tr"); tr.append(...cells); return tr; };
const known = value => value !== null && value !== undefined && Number.isFinite(value);

function cards(place, all) {
  place.replaceChildren(...all.filter(([, value]) => value !== null).map(([label, value, unit, id]) => {
    const div = document.createElement("div"), dd = text("dd", value);
    dd.append(" ", text("small", unit ?? ""));
    if (id) dd.id = id;
    div.append(text("dt", label), dd);
    return div;
  }));
}

const one = (label, value, unit, id, digits = 4) => [label, known(value) ? short(value, digits) : null, unit, id];
const range = (values, digits = 3) => {
  const [low, high] = [Math.min(...values), Math.max(...values)];
  return short(low, digits) === short(high, digits) ? short(low, digits) : `${short(low, digits)} to ${short(high, digits)}`;
};

// Warnings of the parts of an answer, each once.
export function sentences(place, parts) {
  const all = new Set();
  for (const part of parts.filter(Boolean)) {
    if (part.error) all.add(part.error);
    for (const warning of part.warnings ?? []) all.add(warning);
  }
  place.replaceChildren(...[...all].map(sentence => text("li", sentence)));
}

export function brief(place, { sheet, solution }) {
  if (sheet.error || solution.error) { place.replaceChildren(); return; }
  const { rating, stiffness } = sheet, loaded = solution.balls.filter(ball => ball.load_inner_n > 1e-6 * sheet.ball_load_max_n);
  cards(place, [
    one("Life L10", rating.rating_life_l10_mrev, "10⁶ rev", "life"),
    one("Life L10r of the loads", rating.rating_life_l10r_mrev, "10⁶ rev", "life-r"),
    one(rating.rating_life_lnmr_mrev == null ? "L10r in hours" : "Lnmr in hours, with film and contamination",
      rating.rating_life_hours, "h", "hours"),
    one("Static safety s₀", rating.static_safety, "", "safety", 3),
    one("Highest pressure", rating.peak_pressure_max_pa * 1e-9, "GPa", "pressure"),
    one("Most loaded ball", sheet.ball_load_max_n, "N", "ball-load"),
    ["Balls that carry", `${sheet.loaded_balls} of ${sheet.ball_count}`, ""],
    ["Contact angles, inner", loaded.length ? range(loaded.map(ball => ball.contact_angle_inner_deg)) : null, "°"],
    one("Stiffness, radial", stiffness[0][0] * 1e-6, "N/µm", "k-radial"),
    one("Stiffness, axial", stiffness[2][2] * 1e-6, "N/µm", "k-axial"),
    one("Displacement, radial", Math.hypot(sheet.ring_displacement_m[0], sheet.ring_displacement_m[1]) * 1e6, "µm"),
    one("Displacement, axial", sheet.ring_displacement_m[2] * 1e6, "µm"),
    one("Viscosity ratio κ", rating.viscosity_ratio, "", "kappa", 3),
    one("Torque, rule of thumb", known(sheet.friction_torque_estimate_nm) ? sheet.friction_torque_estimate_nm * 1e3 : null, "N mm", "torque-rule", 3),
  ]);
}

function table(place, caption, rows) {
  const body = document.createElement("tbody");
  for (const [label, value, unit, id] of rows.filter(([, value]) => value !== null && value !== "–")) {
    const cell = text("td", `${value} ${unit ?? ""}`.trim());
    if (id) cell.id = id;
    body.append(row([text("th", label, { scope: "row" }), cell]));
  }
  place.replaceChildren(text("caption", caption, { hidden: true }), body);
}

const line = (label, value, unit, id, digits = 4) => [label, known(value) ? short(value, digits) : null, unit, id];

export function tables({ rating, frequencies, geometry }, { sheet, derived }) {
  const r = sheet.rating ?? {}, f = sheet.rating?.frequencies ?? {}, d = derived.error ? {} : derived;
  table(rating, "Ratings and lives", [
    line("Dynamic rating C_r", r.dynamic_rating_n, "N"), line("Static rating C_0r", r.static_rating_n, "N"),
    line("Fatigue load limit C_u", r.fatigue_load_limit_n, "N"), line("Equivalent load P", r.equivalent_load_n, "N"),
    line("L10", r.rating_life_l10_mrev, "10⁶ rev"), line("L10r by the load distribution", r.rating_life_l10r_mrev, "10⁶ rev"),
    line("a_ISO", r.life_modification_factor, "", "a-iso", 3), line("L_nmr", r.rating_life_lnmr_mrev, "10⁶ rev"),
    line("Static safety", r.static_safety, "", "", 3),
  ]);
  table(frequencies, "Frequencies", [
    line("Shaft", f.shaft_hz, "Hz"), line("Cage, FTF", f.cage_hz, "Hz", "ftf"),
    line("Outer race, BPFO", f.ball_pass_outer_hz, "Hz", "bpfo"), line("Inner race, BPFI", f.ball_pass_inner_hz, "Hz", "bpfi"),
    line("Ball, BSF", f.ball_spin_hz, "Hz", "bsf"), line("Ball defect, 2 BSF", f.ball_defect_hz, "Hz"),
    line("Pitch diameter times speed", sheet.speed_factor_mm_rpm, "mm r/min"),
  ]);
  table(geometry, "Geometry", [
    line("Balls", sheet.ball_count, ""), line("Ball diameter", sheet.ball_diameter_m * 1e3, "mm", "", 6),
    line("Pitch diameter", sheet.pitch_diameter_m * 1e3, "mm", "", 6), line("Radial clearance", d.radial_clearance_m * 1e6, "µm", "", 3),
    line("Free contact angle", d.contact_angle_deg, "°", "", 4), line("Groove over ball, inner", d.groove_coefficient_inner, "", "", 4),
    line("Groove over ball, outer", d.groove_coefficient_outer, "", "", 4),
    ["Lubricant", d.lubrication ?? null, ""],
  ]);
}

export function stiffness(place, { sheet }) {
  place.replaceChildren();
  if (sheet.error) return;
  const names = ["F_x, N", "F_y, N", "F_z, N", "M_x, N m", "M_y, N m"], over = ["x, m", "y, m", "z, m", "θ_x, rad", "θ_y, rad"];
  const largest = (i, j) => Math.sqrt(Math.abs(sheet.stiffness[i][i] * sheet.stiffness[j][j]));
  const head = document.createElement("thead"), body = document.createElement("tbody");
  head.append(row([text("td", ""), ...over.map(name => text("th", name, { scope: "col" }))]));
  sheet.stiffness.forEach((values, i) => body.append(row([text("th", names[i], { scope: "row" }),
    ...values.map((value, j) => text("td", Math.abs(value) < 1e-9 * largest(i, j) ? "0" : value.toExponential(3).replace("e+", "e"), { id: `k${i}${j}` }))])));
  place.append(head, body);
}

export function balls(place, all) {
  const columns = [
    ["azimuth, °", "azimuth_deg", 1, 4], ["load inner, N", "load_inner_n", 1, 4], ["outer, N", "load_outer_n", 1, 4],
    ["angle inner, °", "contact_angle_inner_deg", 1, 4], ["outer, °", "contact_angle_outer_deg", 1, 4],
    ["pressure inner, GPa", "peak_pressure_inner_pa", 1e-9, 4], ["outer, GPa", "peak_pressure_outer_pa", 1e-9, 4],
    ["axes inner, mm", "semi_axis_across_inner_m", 2e3, 3], ["", "semi_axis_rolling_inner_m", 2e3, 3],
    ["λ inner", "lambda_ratio_inner", 1, 3], ["λ outer", "lambda_ratio_outer", 1, 3],
    ["heat inner, W", "power_loss_inner_w", 1, 3], ["outer, W", "power_loss_outer_w", 1, 3],
  ].filter(([, field]) => all.some(ball => known(ball[field])));
  const head = document.createElement("thead"), body = document.createElement("tbody");
  head.append(row(columns.map(([label]) => text("th", label, { scope: "col" }))));
  // What carries nothing has neither pressure nor angle.
  const most = Math.max(...all.map(ball => ball.load_outer_n));
  const idle = (ball, field) => ["inner", "outer"].some(side => field.includes(side) && ball[`load_${side}_n`] < 1e-9 * most);
  const shown = (ball, [, field, factor, digits]) => idle(ball, field) ? (field.startsWith("load") ? "0" : "–") : short(ball[field] * factor, digits);
  body.append(...all.map(ball => row(columns.map(column => text("td", shown(ball, column))))));
  place.replaceChildren(head, body);
}

// What the model with friction adds.
export function friction(place, { solution, films, torque }) {
  const sum = name => solution.balls.reduce((total, ball) => total + (ball[name] ?? 0), 0);
  const loaded = (films?.contacts ?? []).filter(contact => contact.load_n > 0);
  const least = loaded.length ? loaded.reduce((a, b) => a.lambda_ratio < b.lambda_ratio ? a : b) : null;
  // Nothing drives balls without an inner contact: what follows from their motion means nothing.
  const moves = !solution.implausible?.includes("idle balls");
  const nmm = value => known(value) ? value * 1e3 : null;
  cards(place, [
    one("Cage speed", moves ? solution.cage_speed_rpm : null, "r/min", "cage-speed", 5),
    one("Friction torque", moves ? nmm(torque?.torque_nm ?? Math.abs(solution.shaft_torque_nm)) : null, "N mm", "torque"),
    one("by SKF's model", nmm(torque?.skf_torque_nm), "N mm", "torque-skf", 3),
    one("by Palmgren's formula", nmm(torque?.palmgren_torque_nm), "N mm", "torque-palmgren", 3),
    one("rolling in the inlets", moves ? nmm(torque?.rolling_nm) : null, "N mm", "", 3),
    one("sliding", moves && torque && known(torque.sliding_inner_nm) ? nmm(torque.sliding_inner_nm + torque.sliding_outer_nm) : null, "N mm", "", 3),
    one("Heat of the inner contacts", solution.power_loss_inner_w ?? sum("power_loss_inner_w"), "W", "", 3),
    one("of the outer contacts", solution.power_loss_outer_w ?? sum("power_loss_outer_w"), "W", "", 3),
    one("Largest pocket force", solution.pocket_force_max_n ?? null, "N", "", 3),
    one("Least film parameter λ", least?.lambda_ratio, "", "lambda", 3),
    one("Least film there", least ? least.film_minimum_m * 1e6 : null, "µm", "film", 3),
  ]);
}

