// A worker that answers questions one after the other; the newest of a kind takes the place of older ones that wait.
export class Solver {
  #worker = null; #id = 0; #waiting = new Map(); #busy = null;

  constructor(told = () => {}) { this.told = told; }

  // The answer, or null where a newer question of this kind came, or all were stopped.
  ask(kind, question) {
    this.#waiting.get(kind)?.done(null);
    return new Promise(done => {
      this.#waiting.set(kind, { question, done });
      this.#next();
    });
  }

  get busy() { return this.#busy !== null || this.#waiting.size > 0; }

  // Ends what is going on; the next question starts a new worker.
  stop() {
    const all = [...this.#waiting.values()];
    if (this.#busy) { all.push(this.#busy); this.#worker.terminate(); this.#worker = null; }
    this.#waiting.clear(); this.#busy = null;
    for (const { done } of all) done(null);
  }

  #next() {
    if (this.#busy || this.#waiting.size === 0) return;
    const [kind, asked] = this.#waiting.entries().next().value;
    this.#waiting.delete(kind);
    if (!this.#worker) this.#start();
    this.#busy = { ...asked, id: ++this.#id };
    this.#worker.postMessage({ id: this.#id, question: asked.question });
  }

  #start() {
    const worker = this.#worker = new Worker(new URL("worker.js", import.meta.url), { type: "module" });
    worker.onmessage = ({ data }) => {
      if (worker !== this.#worker) return;
      if (data.stage !== undefined) { this.told(data); return; }
      if (data.id !== this.#busy?.id) return;
      const { done } = this.#busy;
      this.#busy = null;
      // Memory of a module that broke off is not to be trusted.
      if (data.broken) { worker.terminate(); this.#worker = null; }
      done({ ...data.answer, ms: data.ms, list: Array.isArray(data.answer) ? data.answer : undefined });
      this.#next();
    };
    worker.onerror = event => {
      const busy = this.#busy;
      this.#busy = null; this.#worker = null;
      busy?.done({ error: event.message || "the worker does not start" });
    };
  }
}
