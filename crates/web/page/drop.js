// A recording or a table that is dropped onto the page: the bearing as it moves, and columns over time.
import { series, short } from "./draw.js";
import { Refused, read, readTable } from "./recording.js";
import { Solver } from "./solver.js";
import { View } from "./view.js";

const $ = id => document.getElementById(id);
// Larger files would not fit into the memory of a page.
const MOST_BYTES = 500e6;
// Seconds in which a recording plays, however short its simulated time is.
const PLAYED_S = 12;

const solver = new Solver();
let asked = () => null;
let view = null, shown = null, playing = false, last = 0;

// What gives the bearing of the form as a question, or null where it is wrong.
export function ofForm(question) { asked = question; }

export async function opened(file) {
  $("dropped-problem").hidden = true;
  try {
    if (file.size > MOST_BYTES) throw new Refused(`${short(file.size * 1e-6)} MB; allowed are ${MOST_BYTES * 1e-6}`);
    const bytes = new Uint8Array(await file.arrayBuffer());
    const recorded = /\.mcap(\.active)?$/i.test(file.name) || bytes[0] === 0x89;
    shown = recorded ? ofRecording(read(bytes)) : ofTable(readTable(new TextDecoder().decode(bytes)));
  } catch (error) {
    shown = null;
    playing = false;
    $("dropped-body").hidden = true;
    $("dropped-name").textContent = "";
    $("dropped-problem").textContent = `${file.name}: ${error instanceof Refused ? error.message : "damaged, or not a recording of tribodyn"}`;
    $("dropped-problem").hidden = false;
    $("dropped").hidden = false;
    return;
  }
  $("dropped").hidden = false;
  $("dropped-body").hidden = false;
  $("dropped-name").textContent = `${file.name}: ${shown.about}`;
  $("dropped-motion").hidden = !shown.frames;
  $("dropped-rate").value = shown.rate ?? "";
  found("", null);
  $("dropped-column").replaceChildren(...[...shown.columns.keys()].map(name => new Option(name, name)));
  $("dropped-column").value = shown.first;
  $("dropped-time").max = Math.max(0, (shown.frames?.length ?? 1) - 1);
  $("dropped-time").value = 0;
  if (shown.frames) view ??= new View($("dropped-view"));
  document.documentElement.dataset.dropped = file.name;
  draw();
  moment(0);
  play(Boolean(shown.frames) && !matchMedia("(prefers-reduced-motion: reduce)").matches);
  $("dropped").scrollIntoView({ block: "nearest" });
}

function ofRecording({ metadata, states, times, balls }) {
  const place = name => balls.names.indexOf(name), gpa = 1e9;
  const names = ["azimuth_deg", "load_inner_n", "load_outer_n", "contact_angle_inner_deg", "contact_angle_outer_deg"];
  const frames = balls.rows.map(rows => rows.map(row => ({
    ...Object.fromEntries(names.map(name => [name, row[place(name)]])),
    peak_pressure_inner_pa: gpa * row[place("peak_pressure_inner_gpa")],
    peak_pressure_outer_pa: gpa * row[place("peak_pressure_outer_gpa")],
  })));
  const number = name => Number(metadata[name]);
  const body = { pitch: number("pitch_diameter_mm"), ball: number("ball_diameter_mm"), coefficients: [number("inner_groove_coefficient"), number("outer_groove_coefficient")] };
  const most = frames.reduce((most, balls) => balls.reduce((m, ball) => Math.max(m, ball.load_inner_n), most), 1e-9);
  const x = states.get("time_s");
  // What a bearing does not have, such as the tilt of a held cage, is 0 throughout.
  const columns = new Map([...states].filter(([name, values]) => name !== "time_s" && values.some(v => v !== 0)));
  const first = ["cage_speed_rpm", "orbital_speed_mean_rpm"].find(name => columns.has(name)) ?? [...columns.keys()][0];
  const about = `${metadata.bearing ?? "bearing"}, ${frames[0].length} balls, ${short(x[x.length - 1] - x[0], 4)} s, ${x.length} states`;
  // A file that was cut off may lack what describes the bearing.
  return { x, label: "time, s", columns, first, about, times, frames: Number.isFinite(body.pitch * body.ball) ? frames : null, body, most, rate: rateOf(x) };
}

function ofTable(table) {
  const names = [...table.keys()], rising = column => column.length > 1 && column.every((v, k) => k === 0 || v > column[k - 1]);
  const along = names.length > 1 && rising(table.get(names[0])) ? names[0] : null;
  const count = Math.max(...[...table.values()].map(column => column.length));
  const columns = new Map([...table].filter(([name]) => name !== along));
  const x = along ? table.get(along) : Float64Array.from({ length: count }, (_, k) => k + 1);
  return { x, label: along ?? "row", columns, first: [...columns.keys()][0], about: `${count} rows, ${names.length} columns`, frames: null, rate: along && /^t(ime)?\b|_s$/i.test(along) ? rateOf(x) : null };
}

// Samples a second, where times are even.
function rateOf(times) {
  const step = (times[times.length - 1] - times[0]) / (times.length - 1);
  const even = times.every((time, k) => k === 0 || Math.abs(time - times[k - 1] - step) < 0.01 * step);
  return even ? Math.round(1e6 / step) * 1e-6 : null;
}

function found(text, answer) {
  $("dropped-verdict").textContent = text;
  $("dropped-envelope").replaceChildren();
  if (!answer) return;
  const { verdict, evidence } = answer.diagnosis;
  series($("dropped-envelope"), { xs: answer.envelope_hz, ys: answer.envelope, x: "frequency, Hz", label: "squared envelope over its mean", marks: evidence.map(line => [line.fault, line.frequency_hz]) });
  $("dropped-verdict").textContent = `${verdict.fault ? `Fault: ${verdict.fault}` : "No fault seen"}. ${verdict.reasons.join(". ")}.`;
}

async function search() {
  const question = asked(), rate = Number($("dropped-rate").value.replace(",", "."));
  if (!question) { found("See the message at the form.", null); return; }
  if (!(rate > 0)) { found("Samples a second: allowed is a number above 0.", null); return; }
  const samples = Array.from(shown.columns.get($("dropped-column").value));
  found("Searching…", null);
  const answer = await solver.ask("vibration", { ask: "vibration", form: question, signal: { samples, rate } });
  if (answer) found(answer.error ?? "", answer.error ? null : answer);
}

// Turns a recording's view: it stays as it is turned.
function moment(at) {
  if (!shown?.frames) return;
  const frame = Math.round(at), time = shown.times[frame];
  view.show({ ...shown.body, balls: shown.frames[frame], placed: true, most: shown.most });
  $("dropped-now").textContent = `${short(time, 5)} s`;
  const part = (time - shown.x[0]) / (shown.x[shown.x.length - 1] - shown.x[0]);
  shown.mark?.setAttribute("x1", shown.ends[0] + part * (shown.ends[1] - shown.ends[0]));
  shown.mark?.setAttribute("x2", shown.mark.getAttribute("x1"));
}

function draw() {
  const name = $("dropped-column").value, ys = shown.columns.get(name), finite = ys.filter(Number.isFinite);
  const mean = finite.reduce((sum, y) => sum + y, 0) / finite.length, rms = Math.sqrt(finite.reduce((sum, y) => sum + y * y, 0) / finite.length);
  const least = finite.reduce((a, b) => Math.min(a, b), Infinity), most = finite.reduce((a, b) => Math.max(a, b), -Infinity);
  $("dropped-numbers").textContent = `least ${short(least, 6)}, mean ${short(mean, 6)}, largest ${short(most, 6)}, rms ${short(rms, 6)}`;
  shown.mark = series($("dropped-chart"), { xs: shown.x, ys, x: shown.label, label: name, at: shown.frames ? shown.x[0] : undefined });
  const width = $("dropped-chart").firstChild.viewBox.baseVal.width;
  shown.ends = [78, width - 18];
}

function play(on) {
  playing = on;
  $("dropped-play").textContent = on ? "Pause" : "Play";
  if (on) { last = performance.now(); requestAnimationFrame(step); }
}

function step(now) {
  if (!playing || !shown?.frames) return;
  const slider = $("dropped-time"), most = Number(slider.max);
  const begun = shown.at ?? Number(slider.value);
  shown.at = (begun + (now - last) * 1e-3 / PLAYED_S * most) % Math.max(most, 1);
  last = now;
  slider.value = Math.round(shown.at);
  moment(shown.at);
  requestAnimationFrame(step);
}

$("open").addEventListener("change", event => { const [file] = event.target.files; if (file) opened(file); event.target.value = ""; });
$("dropped-search").addEventListener("click", search);
$("dropped-column").addEventListener("change", () => { draw(); found("", null); moment(Number($("dropped-time").value)); });
$("dropped-time").addEventListener("input", event => { shown.at = Number(event.target.value); play(false); moment(shown.at); });
$("dropped-play").addEventListener("click", () => play(!playing));
$("dropped-close").addEventListener("click", () => { play(false); shown = null; $("dropped").hidden = true; $("open").focus(); });
addEventListener("dragover", event => { event.preventDefault(); });
addEventListener("drop", event => {
  event.preventDefault();
  const [file] = event.dataTransfer?.files ?? [];
  if (file) opened(file);
});
