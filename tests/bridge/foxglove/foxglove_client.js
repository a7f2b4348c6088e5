// SPDX-License-Identifier: Apache-2.0
// Watches a live view by @foxglove/ws-protocol and @foxglove/rosmsg2-serialization, found in the folder of node modules that is
// given, and prints what it heard as JSON.
//
// usage: node foxglove_client.js MODULES ADDRESS
"use strict";
const path = require("path");
const { createRequire } = require("module");
const [, , modules, address] = process.argv;
const load = createRequire(path.join(path.resolve(modules), "x.js"));
const { FoxgloveClient } = load("@foxglove/ws-protocol");
const { MessageReader } = load("@foxglove/rosmsg2-serialization");
const { parse } = load("@foxglove/rosmsg");
const WebSocket = load("ws");

const heard = { name: "", topics: [], frames: [], models: 0 };
const client = new FoxgloveClient({ ws: new WebSocket(address, [FoxgloveClient.SUPPORTED_SUBPROTOCOL]) });
const decoders = new Map();
const finish = () => {
  console.log(JSON.stringify(heard));
  process.exit(0);
};
client.on("serverInfo", (info) => { heard.name = info.name; });
client.on("error", (error) => { console.error(String(error)); process.exit(1); });
client.on("advertise", (channels) => {
  for (const channel of channels) {
    heard.topics.push(channel.topic);
    if (channel.topic !== "/tf" && channel.topic !== "/scene") continue;
    const reader = channel.encoding === "cdr" ? new MessageReader(parse(channel.schema, { ros2: true })) : undefined;
    decoders.set(client.subscribe(channel.id), (data) => (reader
      ? reader.readMessage(data).transforms.forEach((transform) => heard.frames.push(transform.child_frame_id))
      : JSON.parse(new TextDecoder().decode(data)).entities.forEach((entity) => { heard.models += entity.models.length; })));
  }
});
client.on("message", (event) => decoders.get(event.subscriptionId)(event.data));
setTimeout(finish, 3000);
