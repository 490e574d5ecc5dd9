// The page: a form, its answers, and a link that holds the form.
import { curve, polar, short } from "./draw.js";
import { ofForm } from "./drop.js";
import { Solver } from "./solver.js";
import { View } from "./view.js";
import * as show from "./show.js";

const $ = id => document.getElementById(id);
const form = $("form"), fields = [...form.elements].filter(e => e.name && e.type !== "radio");
const NUMBERS = new Set(["angle", "bore", "outside", "width", "balls", "ball", "dynamic_rating", "static_rating", "radial", "axial", "speed"]);
const DEFAULTS = new Map(fields.map(field => [field.name, field.value]));
const PAUSE_MS = 700;
// After so long an unasked search ends.
const PATIENCE_S = 60;

const quick = new Solver(), slow = new Solver(told);
const view = new View($("view"));
let latest = 0, answer = null, points = [], clock = null, stage = "";

// What a number may have behind it, over the unit of its field.
const LENGTHS = { mm: 1, in: 25.4, inch: 25.4 }, FORCES = { N: 1, kN: 1e3, lbf: 4.4482216152605 };
const UNITS = {
  bore: LENGTHS, outside: LENGTHS, width: LENGTHS, ball: LENGTHS, radial: FORCES, axial: FORCES, dynamic_rating: FORCES, static_rating: FORCES,
  speed: { "r/min": 1, rpm: 1, Hz: 60, "rad/s": 30 / Math.PI }, angle: { "°": 1, deg: 1, rad: 180 / Math.PI },
};

function number(name, text) {
  const [, digits, unit] = text.match(/^([-+\d.,eE]*[\d.,])\s*(\D*)$/) ?? [null, text, ""];
  const factor = unit === "" ? 1 : Object.hasOwn(UNITS[name] ?? {}, unit) ? UNITS[name][unit] : NaN;
  return Number(digits.replace(",", ".")) * factor;
}

const by = () => form.elements.by.value;

// The form as a question; a field that holds no number is named.
function asked() {
  const question = {};
  for (const field of fields) {
    const text = field.value.trim(), hidden = field.closest("[hidden]");
    field.removeAttribute("aria-invalid");
    if (hidden || text === "") continue;
    if (!NUMBERS.has(field.name)) { question[field.name] = text; continue; }
    const value = number(field.name, text);
    if (!Number.isFinite(value)) return wrong(field.name, `${text}: allowed is a number${UNITS[field.name] ? `, alone or with one of ${Object.keys(UNITS[field.name]).join(", ")}` : ""}`);
    if (field.name === "balls" && !(Number.isInteger(value) && value > 0)) return wrong(field.name, `${text}: allowed is a whole number of balls`);
    question[field.name] = value;
  }
  return question;
}

function wrong(name, message) {
  const field = fields.find(field => field.name === name);
  field?.setAttribute("aria-invalid", "true");
  $("problem").textContent = message;
  $("problem").hidden = false;
  $("answers").inert = true;
  $("answers").style.opacity = .45;
  $("state").textContent = "see the message at the form";
  return null;
}

async function update() {
  const turn = ++latest, question = asked();
  slow.stop();
  idle();
  remember();
  if (!question) return;
  const found = await quick.ask("quick", { ask: "quick", ...question });
  if (!found || turn !== latest) return;
  const failed = found.error ? found : found.solution.error ? found.solution : null;
  if (failed) { wrong(failed.field ?? "", failed.error); if (found.text) $("text").textContent = found.text; return; }
  $("problem").hidden = true;
  $("answers").inert = false;
  $("answers").style.opacity = "";
  answer = found;
  const { sheet, solution, derived } = found;
  $("state").textContent = `${sheet.name ?? derived.name}: ${short(found.ms, 2)} ms`;
  document.title = `${sheet.name?.split(",")[0] ?? "bearing"} · tribodyn`;
  show.brief($("cards"), found);
  // Those of the sheet: what the solution says of the motion of balls without load concerns no number here.
  show.sentences($("warnings"), [sheet, derived]);
  show.tables({ rating: $("rating"), frequencies: $("frequencies"), geometry: $("geometry") }, found);
  show.stiffness($("stiffness"), found);
  $("text").textContent = found.text;
  $("full").replaceChildren();
  $("full-warnings").replaceChildren();
  balls(solution);
  lines(question, turn);
  document.documentElement.dataset.quick = turn;
  setTimeout(() => { if (turn === latest) friction("full", question, turn); }, PAUSE_MS);
}

// Figures and the table of the balls of a solution.
function balls(solution) {
  show.balls($("balls"), solution.balls);
  polar($("polar"), solution.balls);
  const { sheet, derived } = answer;
  if (!sheet.error && !derived.error) {
    view.show({ pitch: sheet.pitch_diameter_m, ball: sheet.ball_diameter_m, coefficients: [derived.groove_coefficient_inner, derived.groove_coefficient_outer], balls: solution.balls });
  }
}

const CURVES = [
  ["Highest pressure, GPa", point => point.peak_pressure_pa * 1e-9],
  ["Most loaded ball, N", point => point.ball_load_max_n],
  ["Radial stiffness, N/µm", point => point.stiffness_radial_n_per_m * 1e-6],
  ["Axial stiffness, N/µm", point => point.stiffness_axial_n_per_m * 1e-6],
  ["Largest contact angle, °", point => point.contact_angle_max_rad * 180 / Math.PI],
  ["Life L10r, h", point => point.rating_life_hours ?? NaN, true],
  ["Life L10r, 10⁶ rev", point => point.rating_life_l10r_mrev ?? NaN, true],
];

async function lines(question, turn) {
  const over = $("over").value, usual = { speed: 3000, radial: 1000, axial: 1000 }[over];
  const most = 2 * Math.abs(question[over] || usual), least = over === "speed" ? most / 40 : most / 200;
  const sign = question[over] < 0 ? -1 : 1;
  const range = { over, from: sign * least, to: sign * most, count: 25 };
  const found = await quick.ask("curve", { ask: "curve", form: question, range });
  if (!found?.list || turn !== latest) return;
  points = found.list;
  drawn(question);
}

function drawn(question) {
  const [label, value, log] = CURVES[$("shown").value];
  const names = { speed: "speed, r/min", radial: "radial load, N", axial: "axial load, N" };
  curve($("curve"), points, { label, value, log, x: names[$("over").value], at: question[$("over").value] });
}

function told({ stage: name, rpm }) {
  stage = Number.isFinite(rpm) ? `${name}, cage at ${short(rpm, 5)} r/min` : name;
}

function idle() {
  clearInterval(clock);
  $("stop").hidden = true;
  $("orbit").hidden = true;
  $("progress").textContent = "";
}

// The model with friction in a worker of its own, with a sign of life and an end. Where an equilibrium leaves open how
// balls without load move, the orbit follows unasked; what the equilibrium says of itself is shown if none is found.
async function friction(ask, question, turn, unasked = ask === "full", before = null) {
  const begun = performance.now(), orbit = ask === "orbit" || answer.usual_model === "steady-orbit";
  const what = orbit ? "steady orbit of balls and cage" : answer.usual_model === "traction" ? "equilibrium with traction, films" : "equilibrium";
  stage = "";
  let late = false;
  const tick = () => {
    const seconds = (performance.now() - begun) / 1e3;
    $("progress").textContent = `${what}: ${seconds.toFixed(0)} s${stage ? `, ${stage}` : ""}`;
    if (unasked && seconds > PATIENCE_S) { late = true; slow.stop(); }
  };
  tick();
  clock = setInterval(tick, 250);
  $("stop").hidden = false;
  $("orbit").hidden = true;
  const found = await slow.ask("full", { ask, ...question });
  if (turn !== latest) return;
  idle();
  $("orbit").hidden = orbit && found !== null && !found.error;
  if (before && (!found || found.error)) show.sentences($("full-warnings"), parts(before));
  const follows = !orbit && found?.solution?.implausible?.includes("idle balls");
  if (!follows) document.documentElement.dataset.full = turn;
  if (!found) { $("progress").textContent = late ? `${what}: ended after ${PATIENCE_S} s without an answer` : `${what}: stopped`; return; }
  if (found.error) { $("progress").textContent = found.error; return; }
  $("progress").textContent = `${what}: ${short(found.ms / 1e3, 2)} s`;
  show.friction($("full"), before ? { ...compared(before), ...found } : found);
  balls(found.solution);
  if (follows) { friction("orbit", question, turn, true, found); return; }
  show.sentences($("full-warnings"), parts(found));
}

// Films of the balls that carry and what other formulas say, which an orbit leaves out.
const compared = ({ films, torque }) => ({ films, torque: torque && { skf_torque_nm: torque.skf_torque_nm, palmgren_torque_nm: torque.palmgren_torque_nm } });

const parts = found => [found.solution, found.films, found.torque];

// The form in the address: fields that differ from the defaults.
function remember() {
  const kept = new URLSearchParams();
  if (by() === "numbers") kept.set("by", "numbers");
  for (const field of fields) if (field.value.trim() !== DEFAULTS.get(field.name)) kept.set(field.name, field.value.trim());
  for (const id of ["over", "shown"]) if ($(id).selectedIndex > 0) kept.set(id, $(id).value);
  history.replaceState(null, "", `${location.pathname}${location.search}${kept.size ? `#${kept}` : ""}`);
}

function recall() {
  const kept = new URLSearchParams(location.hash.slice(1));
  form.elements.by.value = kept.get("by") === "numbers" ? "numbers" : "designation";
  for (const field of fields) {
    const value = kept.get(field.name) ?? DEFAULTS.get(field.name);
    if (field.tagName !== "SELECT" || [...field.options].some(option => option.value === value)) field.value = value;
  }
  for (const id of ["over", "shown"]) {
    const value = kept.get(id);
    if ([...$(id).options].some(option => option.value === value)) $(id).value = value;
  }
  sides();
}

function sides() {
  form.querySelector(".by-designation").hidden = by() !== "designation";
  form.querySelector(".by-numbers").hidden = by() !== "numbers";
}

async function copied(button, text) {
  const label = button.textContent;
  try { await navigator.clipboard.writeText(text); button.textContent = "Copied"; }
  catch { button.textContent = "Not allowed here"; }
  setTimeout(() => { button.textContent = label; }, 1500);
}

ofForm(asked);
$("shown").append(...CURVES.map(([label], k) => new Option(label, k)));
form.addEventListener("input", () => { sides(); update(); });
form.addEventListener("submit", event => event.preventDefault());
$("over").addEventListener("change", update);
$("shown").addEventListener("change", () => { remember(); const question = asked(); if (question) drawn(question); });
$("stop").addEventListener("click", () => slow.stop());
$("orbit").addEventListener("click", () => { const question = asked(); if (question) friction("orbit", question, latest); });
$("share").addEventListener("click", event => copied(event.target, location.href));
$("copy").addEventListener("click", event => copied(event.target, $("text").textContent));
$("reset").addEventListener("click", () => { history.replaceState(null, "", location.pathname + location.search); recall(); update(); });
$("save").addEventListener("click", () => {
  const link = document.createElement("a"), question = asked() ?? {};
  link.href = URL.createObjectURL(new Blob([$("text").textContent], { type: "text/plain" }));
  link.download = `${(question.designation ?? "bearing").replace(/[^A-Za-z0-9]+/g, "-")}.ron`;
  link.click();
  URL.revokeObjectURL(link.href);
});
$("turning").addEventListener("change", event => { view.turning = event.target.checked; view.draw(); });
addEventListener("hashchange", () => { recall(); update(); });
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => view.draw());

if (matchMedia("(prefers-reduced-motion: reduce)").matches) $("turning").checked = false;
view.turning = $("turning").checked;
view.tired = () => { $("turning").checked = false; };
recall();
update();
quick.ask("catalogue", { ask: "catalogue", pattern: "" }).then(found => {
  $("sizes").append(...(found?.list ?? []).map(({ designation, bore, outside, width }) => new Option(`${bore} × ${outside} × ${width} mm`, designation)));
});
