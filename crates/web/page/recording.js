// Reads recordings of tribodyn: MCAP with messages in Protocol Buffers, whose description is in the file.
import { decompress } from "./fzstd.js";

const text = new TextDecoder();

// What is said to whoever opened a file; all other failures are those of damaged ones.
export class Refused extends Error {}
const MAGIC = [0x89, 0x4d, 0x43, 0x41, 0x50, 0x30, 0x0d, 0x0a];
const SCHEMA = 3, CHANNEL = 4, MESSAGE = 5, CHUNK = 6, METADATA = 12;
const DOUBLE = 1, FLOAT = 2, MESSAGE_TYPE = 11, REPEATED = 3;

// A place in bytes from which values are taken.
class Cursor {
  constructor(bytes, at = 0, end = bytes.length) { this.bytes = bytes; this.at = at; this.end = end; this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength); }
  get left() { return this.end - this.at; }
  u8() { return this.bytes[this.at++]; }
  u16() { const v = this.view.getUint16(this.at, true); this.at += 2; return v; }
  u32() { const v = this.view.getUint32(this.at, true); this.at += 4; return v; }
  u64() { const v = this.view.getBigUint64(this.at, true); this.at += 8; return Number(v); }
  take(length) { const part = this.bytes.subarray(this.at, this.at + length); this.at += length; return part; }
  string() { return text.decode(this.take(this.u32())); }
  varint() {
    let value = 0, factor = 1;
    for (let byte = 0x80; byte & 0x80; factor *= 128) { byte = this.u8(); value += (byte & 0x7f) * factor; }
    return value;
  }
}

// Fields of a message in Protocol Buffers: number, kind of encoding, value or bytes.
function* fields(bytes) {
  const cursor = new Cursor(bytes);
  while (cursor.left > 0) {
    const tag = cursor.varint(), number = Math.floor(tag / 8), wire = tag & 7;
    if (wire === 0) yield [number, wire, cursor.varint()];
    else if (wire === 1) { yield [number, wire, cursor.view.getFloat64(cursor.at, true)]; cursor.at += 8; }
    else if (wire === 2) yield [number, wire, cursor.take(cursor.varint())];
    else if (wire === 5) { yield [number, wire, cursor.view.getFloat32(cursor.at, true)]; cursor.at += 4; }
    else throw new Refused("the recording is damaged: a message has an unknown encoding");
  }
}

// Messages that a schema describes, by their full names: for each field number its name, type and whether it repeats.
function described(bytes) {
  const types = new Map();
  const message = (within, bytes) => {
    const found = { name: "", fields: new Map() }, nested = [];
    for (const [number, , value] of fields(bytes)) {
      if (number === 1) found.name = `${within}.${text.decode(value)}`;
      if (number === 3) nested.push(value);
      if (number !== 2) continue;
      const field = {};
      for (const [part, , content] of fields(value)) {
        if (part === 1) field.name = text.decode(content);
        if (part === 3) field.number = content;
        if (part === 4) field.repeated = content === REPEATED;
        if (part === 5) field.type = content;
        if (part === 6) field.of = text.decode(content);
      }
      found.fields.set(field.number, field);
    }
    types.set(found.name, found.fields);
    nested.forEach(inner => message(found.name, inner));
  };
  for (const [number, , file] of fields(bytes)) {
    if (number !== 1) continue;
    const all = [...fields(file)], within = all.find(([part]) => part === 2);
    for (const [part, , value] of all) if (part === 4) message(within ? `.${text.decode(within[2])}` : "", value);
  }
  return types;
}

// Names and numbers of the single floating-point fields of a message.
const single = type => [...type.values()].filter(field => !field.repeated && (field.type === DOUBLE || field.type === FLOAT));

// Records of the file one after the other, those of chunks among them; a file that was cut off ends with its last whole one.
function* records(bytes) {
  const cursor = new Cursor(bytes);
  while (cursor.left >= 9) {
    const code = cursor.u8(), length = cursor.u64();
    if (length > cursor.left) return;
    const content = cursor.take(length);
    if (code !== CHUNK) { yield [code, content]; continue; }
    const chunk = new Cursor(content, 16), size = chunk.u64();
    chunk.u32();
    const compression = chunk.string(), packed = chunk.take(chunk.u64());
    if (compression !== "" && compression !== "zstd") throw new Refused(`chunks are compressed by ${compression}; allowed are zstd and none`);
    yield* records(compression ? decompress(packed, new Uint8Array(size)) : packed);
  }
}

// A table that grows: a row of numbers for each message.
class Table {
  constructor(type) {
    this.fields = single(type);
    this.names = this.fields.map(field => field.name);
    this.places = new Map(this.fields.map((field, place) => [field.number, place]));
    this.rows = [];
  }
  row(bytes) {
    const row = new Float64Array(this.names.length);
    for (const [number, , value] of fields(bytes)) { const place = this.places.get(number); if (place !== undefined) row[place] = value; }
    return row;
  }
}

// Times, states and balls of a recording, and what it says of itself.
export function read(bytes) {
  if (MAGIC.some((byte, k) => bytes[k] !== byte)) throw new Refused("not an MCAP recording");
  const schemas = new Map(), channels = new Map(), metadata = {};
  let states = null, balls = null;
  const times = [], perTime = [];
  for (const [code, content] of records(bytes.subarray(MAGIC.length))) {
    const cursor = new Cursor(content);
    if (code === SCHEMA) { const id = cursor.u16(), name = cursor.string(); cursor.string(); schemas.set(id, { name, data: cursor.take(cursor.u32()) }); }
    if (code === CHANNEL) { const id = cursor.u16(), schema = cursor.u16(); channels.set(id, { schema, topic: cursor.string() }); }
    if (code === METADATA && cursor.string() === "simulation") for (const end = cursor.u32() + cursor.at; cursor.at < end;) metadata[cursor.string()] = cursor.string();
    if (code !== MESSAGE) continue;
    const { topic, schema } = channels.get(cursor.u16()) ?? {}, { name, data } = schemas.get(schema) ?? {};
    if (topic !== "/bearing/state" && topic !== "/bearing/balls") continue;
    cursor.at += 20;
    const message = cursor.take(cursor.left);
    if (topic === "/bearing/state") {
      states ??= new Table(described(data).get(`.${name}`));
      states.rows.push(states.row(message));
      continue;
    }
    if (!balls) {
      const types = described(data), of = types.get(`.${name}`), each = [...of.values()].find(field => field.repeated && field.type === MESSAGE_TYPE);
      balls = { table: new Table(types.get(each.of)), number: each.number, time: [...of.values()].find(field => field.name === "time_s").number };
    }
    const parts = [...fields(message)];
    times.push(parts.find(([number]) => number === balls.time)?.[2] ?? 0);
    perTime.push(parts.filter(([number]) => number === balls.number).map(([, , value]) => balls.table.row(value)));
  }
  if (!states || !balls) throw new Refused("not a recording of tribodyn: it holds no bearing");
  return { metadata, states: columns(states), times: Float64Array.from(times), balls: { names: balls.table.names, rows: perTime } };
}

function columns({ names, rows }) {
  return new Map(names.map((name, place) => [name, Float64Array.from(rows, row => row[place])]));
}

// Numbers of a table with its columns by comma, semicolon, tab or blanks, with names above them or without.
export function readTable(content) {
  const lines = content.split(/\r?\n/).filter(line => line.trim() !== "" && !line.startsWith("#"));
  if (lines.length < 2) throw new Refused("not a table: allowed are two lines or more");
  const mark = [";", "\t", ","].find(mark => lines[1].includes(mark)) ?? /\s+/;
  const decimal = mark === ";" || mark === "\t";
  const cells = line => line.trim().split(mark).map(cell => cell.trim().replace(/^"(.*)"$/, "$1"));
  const number = cell => cell === "" ? NaN : Number(decimal ? cell.replace(",", ".") : cell);
  const first = cells(lines[0]), named = first.some(cell => cell !== "" && Number.isNaN(number(cell)));
  const names = named ? first : first.map((_, k) => `column ${k + 1}`), values = names.map(() => []);
  lines.slice(named ? 1 : 0).forEach(line => cells(line).slice(0, names.length).forEach((cell, k) => values[k].push(number(cell))));
  const kept = names.map((name, k) => [name, Float64Array.from(values[k])]).filter(([, column]) => column.some(Number.isFinite));
  if (kept.length === 0) throw new Refused("not a table: it has no column of numbers");
  return new Map(kept);
}
