// The module in a worker of its own: questions and answers are JSON.
const utf8 = new TextEncoder(), text = new TextDecoder();

const module = fetch(new URL("tribodyn.wasm.gz", import.meta.url)).then(async response => {
  let exports;
  const page = {
    stage(at, length, rpm) {
      postMessage({ stage: text.decode(new Uint8Array(exports.memory.buffer, at, length)), rpm });
    },
  };
  if (!response.ok) throw new Error(`the module is not there (${response.status})`);
  const packed = new Uint8Array(await response.arrayBuffer());
  // A server that sends it as packed content has it unpacked already.
  const isPacked = packed[0] === 0x1f && packed[1] === 0x8b;
  const bytes = isPacked ? await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer() : packed;
  exports = (await WebAssembly.instantiate(bytes, { page })).instance.exports;
  return exports;
});

function ask({ memory, tribodyn_question, tribodyn_ask, tribodyn_answer_length }, question) {
  const bytes = utf8.encode(JSON.stringify(question));
  const place = tribodyn_question(bytes.length);
  // Memory may have grown: its buffer is then another one.
  new Uint8Array(memory.buffer, place, bytes.length).set(bytes);
  const answer = tribodyn_ask();
  return JSON.parse(text.decode(new Uint8Array(memory.buffer, answer, tribodyn_answer_length())));
}

onmessage = async ({ data: { id, question } }) => {
  try {
    const exports = await module, begun = performance.now();
    postMessage({ id, answer: ask(exports, question), ms: performance.now() - begun });
  } catch (error) {
    postMessage({ id, answer: { error: `the computation ended: ${error.message}` }, broken: true });
  }
};
