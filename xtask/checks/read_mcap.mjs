// Reads recordings with the indexed reader of @mcap/core, the one inside Foxglove and Lichtblick.
//
// Usage: node read_mcap.mjs FILE.mcap ...   (@mcap/core 2.2.2, @mcap/support 1.1.0, @mcap/nodejs 1.0.2)
//
// Checked for each file: it opens by its indexes; the time span that a viewer takes from them is that of the messages; what
// a viewer asks for when it seeks to the end (the latest message of each topic, read backwards) is there; every message
// decodes by the schema in the file; the counts are those of the statistics. Exit code 1 names the file and what is wrong.

import { McapIndexedReader } from "@mcap/core";
import { FileHandleReadable } from "@mcap/nodejs";
import { loadDecompressHandlers, protobufFromBinaryDescriptor } from "@mcap/support";
import { open } from "node:fs/promises";

const EPOCH_YEAR = 2026;
// What the picture needs after a seek.
const DRAWN = ["/tf", "/bearing/contacts", "/bearing/geometry"];

function require(condition, message) {
  if (!condition) {
    throw new Error(message);
  }
}

function decoders(reader) {
  const found = new Map();
  for (const [id, channel] of reader.channelsById) {
    const schema = reader.schemasById.get(channel.schemaId);
    const type = protobufFromBinaryDescriptor(schema.data).lookupType(schema.name);
    found.set(id, (data) => type.decode(data));
  }
  return found;
}

/** The span of a recording as viewers work it out. */
function span(chunks) {
  const starts = chunks.map((chunk) => chunk.messageStartTime);
  const ends = chunks.map((chunk) => chunk.messageEndTime);
  const less = (a, b) => (a < b ? a : b);
  return [starts.reduce(less), ends.reduce((a, b) => (a > b ? a : b))];
}

/** The latest message of a topic at the end of the recording, as after a seek. */
async function latest(reader, topic) {
  for await (const message of reader.readMessages({ topics: [topic], reverse: true })) {
    return message;
  }
  return undefined;
}

async function check(path) {
  const file = await open(path, "r");
  try {
    const readable = new FileHandleReadable(file);
    const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers: await loadDecompressHandlers() });
    const statistics = reader.statistics;
    require(statistics != undefined, "no statistics");
    const empty = reader.chunkIndexes.filter((chunk) => chunk.messageIndexOffsets.size === 0);
    require(empty.length === 0, `${empty.length} chunks without messages`);
    const [start, end] = span(reader.chunkIndexes);
    const stated = [statistics.messageStartTime, statistics.messageEndTime];
    require(start === stated[0] && end === stated[1], `a viewer shows ${start} to ${end}, the messages are of ${stated}`);
    const year = new Date(Number(start / 1000000n)).getUTCFullYear();
    require(year === EPOCH_YEAR, `a viewer opens it in ${year}`);
    const decode = decoders(reader);
    let messages = 0n;
    for await (const message of reader.readMessages()) {
      decode.get(message.channelId)(message.data);
      messages += 1n;
    }
    require(messages === statistics.messageCount, `${messages} messages, the statistics say ${statistics.messageCount}`);
    for (const topic of DRAWN) {
      require((await latest(reader, topic)) != undefined, `nothing on ${topic} to draw after a seek`);
    }
    return `${messages} messages in ${reader.chunkIndexes.length} chunks`;
  } finally {
    await file.close();
  }
}

let failed = 0;
for (const path of process.argv.slice(2)) {
  try {
    console.log(`${path}: ${await check(path)}`);
  } catch (error) {
    console.error(`${path}: ${error.message}`);
    failed += 1;
  }
}
process.exitCode = failed > 0 ? 1 : process.argv.length > 2 ? 0 : 2;
