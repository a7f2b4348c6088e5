// SPDX-License-Identifier: Apache-2.0
// Reads and writes MCAP by the readers of others (@mcap/core, @foxglove/rosmsg2-serialization), found in the folder of node
// modules that is given.
//
// usage: node mcap_readers.js MODULES read FILE        (JSON: topics with count and first and last message, metadata, attachments)
//        node mcap_readers.js MODULES write FILE none|zstd? COUNT
"use strict";
const fs = require("fs");
const path = require("path");
const { createRequire } = require("module");
const [, , modules, what, file, count] = process.argv;
const load = createRequire(path.join(path.resolve(modules), "x.js"));
const { McapIndexedReader, McapStreamReader, McapWriter } = load("@mcap/core");
const { MessageReader, MessageWriter } = load("@foxglove/rosmsg2-serialization");
const { parse } = load("@foxglove/rosmsg");

async function decompressors() {
  return (await load("@mcap/support").loadDecompressHandlers());
}

class FileReadable {
  constructor(bytes) { this.bytes = bytes; }
  async size() { return BigInt(this.bytes.length); }
  async read(offset, length) { return new Uint8Array(this.bytes.buffer, this.bytes.byteOffset + Number(offset), Number(length)); }
}

const plain = (key, value) => {
  if (typeof value === "bigint") return Number(value);
  if (ArrayBuffer.isView(value)) return Array.from(value);
  return value;
};

async function read() {
  const bytes = fs.readFileSync(file);
  const reader = await McapIndexedReader.Initialize({ readable: new FileReadable(bytes), decompressHandlers: await decompressors() });
  const topics = {};
  const readers = new Map();
  let last = -1n, ordered = true;
  for await (const message of reader.readMessages()) {
    const channel = reader.channelsById.get(message.channelId);
    const schema = reader.schemasById.get(channel.schemaId);
    const text = new TextDecoder().decode(schema.data);
    let decoded;
    if (channel.messageEncoding === "cdr") {
      if (!readers.has(schema.id)) readers.set(schema.id, new MessageReader(parse(text, { ros2: true })));
      decoded = readers.get(schema.id).readMessage(message.data);
    } else {
      JSON.parse(text);
      decoded = JSON.parse(new TextDecoder().decode(message.data));
    }
    if (message.logTime < last) ordered = false;
    last = message.logTime;
    const entry = (topics[channel.topic] ??= { type: schema.name, count: 0, times: [] });
    entry.count += 1;
    entry.first ??= decoded;
    entry.last = decoded;
    if (entry.times.length < 3) entry.times.push(message.logTime);
    if (entry.count === 101) entry.hundredth = decoded;
  }
  const attachments = [];
  for await (const attachment of reader.readAttachments()) attachments.push(attachment.name);
  const metadata = [];
  for await (const item of reader.readMetadata()) metadata.push(item.name);
  // And front to end, with every checksum.
  const stream = new McapStreamReader({ decompressHandlers: await decompressors(), validateCrcs: true });
  stream.append(bytes);
  let records = 0;
  for (let record; (record = stream.nextRecord()); ) records += record.type === "Message" ? 1 : 0;
  const counts = Object.fromEntries([...reader.statistics.channelMessageCounts].map(([id, n]) => [id, Number(n)]));
  console.log(JSON.stringify({ profile: reader.header.profile, topics, attachments, metadata, ordered, records,
    messages: reader.statistics.messageCount, counts, done: stream.done() }, plain));
}

async function write() {
  const parts = [];
  let size = 0n;
  const writable = { position: () => size, write: async (bytes) => { parts.push(Buffer.from(bytes)); size += BigInt(bytes.length); } };
  const writer = new McapWriter({ writable, useChunks: true, chunkSize: 4096 });
  await writer.start({ profile: "ros2", library: "another" });
  const joint = "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort\n" + "=".repeat(80) +
    "\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" + "=".repeat(80) + "\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n";
  const schemaId = await writer.registerSchema({ name: "sensor_msgs/msg/JointState", encoding: "ros2msg", data: new TextEncoder().encode(joint) });
  const channelId = await writer.registerChannel({ schemaId, topic: "/arm/joint_states", messageEncoding: "cdr", metadata: new Map() });
  const encoder = new MessageWriter(parse(joint, { ros2: true }));
  for (let i = 0; i < Number(count); ++i) {
    const nanoseconds = 1700000000000000000n + BigInt(i) * 1000000n;
    const data = encoder.writeMessage({ header: { stamp: { sec: Number(nanoseconds / 1000000000n), nsec: Number(nanoseconds % 1000000000n),
      nanosec: Number(nanoseconds % 1000000000n) }, frame_id: "" }, name: ["a", "b"], position: [0.001 * i, -1 / 3], velocity: [], effort: [] });
    await writer.addMessage({ channelId, sequence: i, logTime: nanoseconds, publishTime: nanoseconds, data });
  }
  await writer.end();
  fs.writeFileSync(file, Buffer.concat(parts));
}

(what === "write" ? write() : read()).catch((problem) => { console.error(problem); process.exit(1); });
