// The bearing in three dimensions: surfaces of revolution, balls coloured by pressure, contact forces. Plain WebGL.
const VERTEX = `
attribute vec3 place, normal;
uniform mat4 model, camera;
varying vec3 n;
void main() { n = mat3(model[0].xyz, model[1].xyz, model[2].xyz) * normal; gl_Position = camera * model * vec4(place, 1.0); }`;
const FRAGMENT = `
precision mediump float;
varying vec3 n;
uniform vec3 colour, light;
void main() {
  vec3 m = normalize(n) * (n.z < 0.0 ? -1.0 : 1.0);
  float d = max(dot(m, light), 0.0), s = pow(max(dot(reflect(-light, m), light), 0.0), 24.0);
  gl_FragColor = vec4(colour * (0.34 + 0.66 * d) + 0.25 * s, 1.0);
}`;

// Column by column.
const times = (a, b) => Array.from({ length: 16 }, (_, k) => [0, 1, 2, 3].reduce((sum, m) => sum + a[4 * m + k % 4] * b[4 * (k >> 2) + m], 0));
const moved = (x, y, z, s = 1) => [s, 0, 0, 0, 0, s, 0, 0, 0, 0, s, 0, x, y, z, 1];
const about = (axis, angle) => {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return { x: [1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, 0, 0, 0, 1], y: [c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, 0, 0, 0, 1], z: [c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] }[axis];
};
const perspective = (aspect, near, far, f) => [f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0, 2 * far * near / (near - far), 0];

// Triangles of a closed profile of (radius, z), turned about z from one angle to another, with caps where it is open.
function revolved(profile, from, to, steps) {
  const places = [], normals = [];
  const corner = ([r, z], phi) => [r * Math.cos(phi), r * Math.sin(phi), z];
  const triangle = (corners, normal) => corners.forEach((c, k) => { places.push(...c); normals.push(...(Array.isArray(normal[0]) ? normal[k] : normal)); });
  for (let k = 0; k < profile.length; k += 1) {
    const a = profile[k], b = profile[(k + 1) % profile.length];
    const [dr, dz] = [b[0] - a[0], b[1] - a[1]], length = Math.hypot(dr, dz) || 1;
    for (let j = 0; j < steps; j += 1) {
      const [p, q] = [from + (to - from) * j / steps, from + (to - from) * (j + 1) / steps];
      const n = phi => [dz / length * Math.cos(phi), dz / length * Math.sin(phi), -dr / length];
      triangle([corner(a, p), corner(b, p), corner(b, q)], [n(p), n(p), n(q)]);
      triangle([corner(a, p), corner(b, q), corner(a, q)], [n(p), n(q), n(q)]);
    }
  }
  if (to - from < 2 * Math.PI - 1e-6) {
    const half = profile.length / 2;
    for (const [phi, sign] of [[from, 1], [to, -1]]) {
      const n = [sign * Math.sin(phi), -sign * Math.cos(phi), 0];
      for (let k = 0; k + 1 < half; k += 1) {
        const [a, b, c, d] = [profile[k], profile[k + 1], profile[profile.length - 2 - k], profile[profile.length - 1 - k]].map(p => corner(p, phi));
        triangle([a, b, c], n); triangle([a, c, d], n);
      }
    }
  }
  return { places, normals };
}

// A ring between its race, a groove with shoulders, and a cylinder; race first, cylinder back.
function ring(groove, shoulder, cylinder, half, outer) {
  const steps = 24, race = [], back = [];
  for (let k = 0; k <= steps; k += 1) {
    const z = half * (2 * k / steps - 1), r = groove(z);
    race.push([outer ? Math.max(r, shoulder) : Math.min(r, shoulder), z]);
    back.unshift([cylinder, z]);
  }
  return [...race, ...back];
}

function sphere() {
  const half = 20, arc = Array.from({ length: half + 1 }, (_, k) => [Math.sin(Math.PI * k / half), -Math.cos(Math.PI * k / half)]);
  const { places } = revolved(arc, 0, 2 * Math.PI, 32);
  return { places, normals: places };
}

// From grey over blue and yellow to red, by pressure in GPa up to where steel yields.
export function pressureColour(gpa) {
  const stops = [[0, [.62, .65, .68]], [1, [.25, .55, .85]], [2, [.95, .8, .25]], [3, [.9, .4, .15]], [4.2, [.75, .08, .1]]];
  if (!(gpa > 0)) return stops[0][1];
  const next = stops.findIndex(([limit]) => limit >= gpa);
  if (next < 0) return stops.at(-1)[1];
  const [[a, low], [b, high]] = [stops[next - 1], stops[next]], part = (gpa - a) / (b - a);
  return low.map((c, k) => c + part * (high[k] - c));
}

export class View {
  #gl; #at = {}; #parts = {}; #turn = [0.42, -0.75]; #bearing = null; #phase = 0; #asked = false; #last = 0; #slow = 0;

  constructor(canvas) {
    this.canvas = canvas;
    this.turning = false;
    const gl = this.#gl = canvas.getContext("webgl", { antialias: true, preserveDrawingBuffer: true });
    if (!gl) { canvas.replaceWith(Object.assign(document.createElement("p"), { textContent: "The view needs WebGL, which this browser does not offer." })); return; }
    const program = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source); gl.compileShader(shader); gl.attachShader(program, shader);
    }
    gl.linkProgram(program); gl.useProgram(program); gl.enable(gl.DEPTH_TEST);
    for (const name of ["place", "normal"]) { this.#at[name] = gl.getAttribLocation(program, name); gl.enableVertexAttribArray(this.#at[name]); }
    for (const name of ["model", "camera", "colour", "light"]) this.#at[name] = gl.getUniformLocation(program, name);
    this.#parts.ball = this.#loaded(sphere());
    this.#parts.rod = this.#loaded(revolved([[0, 0], [.035, 0], [.035, 1], [0, 1]], 0, 2 * Math.PI, 12));
    this.#listen();
    new ResizeObserver(() => this.draw()).observe(canvas);
  }

  #listen() {
    let held = null;
    const canvas = this.canvas, turn = (x, y) => { this.#turn = [Math.max(-1.5, Math.min(1.5, this.#turn[0] + x)), this.#turn[1] + y]; this.draw(); };
    canvas.addEventListener("pointerdown", event => { held = [event.clientX, event.clientY]; canvas.setPointerCapture(event.pointerId); });
    canvas.addEventListener("pointermove", event => {
      if (!held) return;
      turn((event.clientY - held[1]) * .008, (event.clientX - held[0]) * .008);
      held = [event.clientX, event.clientY];
    });
    for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, () => { held = null; });
    canvas.addEventListener("keydown", event => {
      const by = { ArrowLeft: [0, -.12], ArrowRight: [0, .12], ArrowUp: [-.12, 0], ArrowDown: [.12, 0] }[event.key];
      if (by) { turn(...by); event.preventDefault(); }
    });
  }

  #loaded({ places, normals }) {
    const gl = this.#gl, of = data => { const b = gl.createBuffer(); gl.bindBuffer(gl.ARRAY_BUFFER, b); gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(data), gl.STATIC_DRAW); return b; };
    return { place: of(places), normal: of(normals), count: places.length / 3 };
  }

  // Sizes in one unit; balls as the solution has them, or placed where a recording has them; most is
  // the force of the longest rod.
  show({ pitch, ball, coefficients: [fi, fo], balls, placed = false, most }) {
    if (!this.#gl) return;
    const [d, rm] = [1, .5 * pitch / ball], half = .62 * d;
    const key = [pitch, ball, fi, fo].join();
    if (this.#bearing?.key !== key) {
      const inner = z => rm - .5 * d + fi * d - Math.sqrt(Math.max(0, (fi * d) ** 2 - z * z));
      const outer = z => rm + .5 * d - fo * d + Math.sqrt(Math.max(0, (fo * d) ** 2 - z * z));
      const { PI } = Math;
      this.#parts.inner = this.#loaded(revolved(ring(inner, rm - .28 * d, rm - .85 * d, half, false), 0, 2 * PI, 96));
      // Cut open so that the balls are to be seen.
      this.#parts.outer = this.#loaded(revolved(ring(outer, rm + .28 * d, rm + .85 * d, half, true), -.42 * PI, .92 * PI, 80));
    }
    this.#bearing = { key, rm, balls, placed, most: most ?? Math.max(...balls.map(b => b.load_inner_n), 1e-9) };
    this.draw();
  }

  draw() {
    if (this.#asked || !this.#bearing || !this.#gl) return;
    this.#asked = true;
    requestAnimationFrame(now => {
      this.#asked = false;
      if (this.turning) {
        this.#phase += Math.min(now - this.#last, 60) * 4e-4;
        // Without a graphics processor the view would take the time of the computation.
        this.#slow = now - this.#last > 90 ? this.#slow + 1 : 0;
        if (this.#slow > 8) { this.turning = false; this.tired?.(); } else queueMicrotask(() => this.draw());
      }
      this.#last = now;
      this.#paint();
    });
  }

  #paint() {
    const gl = this.#gl, canvas = this.canvas, ratio = Math.min(devicePixelRatio || 1, 2);
    const [w, h] = [canvas.clientWidth * ratio | 0, canvas.clientHeight * ratio | 0];
    if (!w || !h) return;
    if (canvas.width !== w || canvas.height !== h) { canvas.width = w; canvas.height = h; }
    gl.viewport(0, 0, w, h);
    const ground = getComputedStyle(canvas.closest("section")).backgroundColor.match(/[\d.]+/g).map(v => v / 255);
    gl.clearColor(ground[0], ground[1], ground[2], 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const { rm, balls, placed, most } = this.#bearing, away = 3.1 * (rm + .85);
    // Azimuth 0, where a radial load acts, points down.
    const world = times(about("x", this.#turn[0]), times(about("y", this.#turn[1]), about("z", -Math.PI / 2)));
    const camera = times(perspective(w / h, .1 * away, 3 * away, 2.55), moved(0, 0, -away));
    gl.uniformMatrix4fv(this.#at.camera, false, camera);
    gl.uniform3fv(this.#at.light, [.37, .56, .74]);
    const put = (part, model, colour) => {
      for (const name of ["place", "normal"]) { gl.bindBuffer(gl.ARRAY_BUFFER, part[name]); gl.vertexAttribPointer(this.#at[name], 3, gl.FLOAT, false, 0, 0); }
      gl.uniformMatrix4fv(this.#at.model, false, times(world, model));
      gl.uniform3fv(this.#at.colour, colour);
      gl.drawArrays(gl.TRIANGLES, 0, part.count);
    };
    put(this.#parts.inner, about("z", 0), [.55, .58, .62]);
    put(this.#parts.outer, about("z", 0), [.5, .53, .57]);
    for (let k = 0; k < balls.length; k += 1) {
      const place = k + this.#phase * balls.length / (2 * Math.PI), low = Math.floor(place), part = place - low;
      const [a, b] = [balls[low % balls.length], balls[(low + 1) % balls.length]];
      const mixed = name => a[name] + part * (b[name] - a[name]);
      const phi = placed ? balls[k].azimuth_deg * Math.PI / 180 : (balls[0].azimuth_deg * Math.PI / 180) + 2 * Math.PI * place / balls.length;
      const to = times(about("z", phi), moved(rm, 0, 0));
      const gpa = 1e-9 * Math.max(mixed("peak_pressure_inner_pa"), mixed("peak_pressure_outer_pa"));
      put(this.#parts.ball, times(to, moved(0, 0, 0, .5)), pressureColour(gpa));
      // Forces of the races on the ball, as long as they are large, along their contact angles.
      for (const [side, sign] of [["inner", -1], ["outer", 1]]) {
        const length = mixed(`load_${side}_n`) / most;
        if (length < .01) continue;
        const angle = mixed(`contact_angle_${side}_deg`) * Math.PI / 180;
        const turned = times(to, about("y", sign > 0 ? Math.PI / 2 - angle : -Math.PI / 2 - angle));
        put(this.#parts.rod, times(turned, [1.6, 0, 0, 0, 0, 1.6, 0, 0, 0, 0, .5 + .9 * length, 0, 0, 0, 0, 1]), [.85, .2, .15]);
      }
    }
  }
}
