#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`hapticell-cli live` and `session --live` watched by a client of this file, written after the specifications (RFC 6455,
foxglove.websocket.v1), and, where node and its modules are installed (HAPTICELL_NODE_MODULES: a folder with node_modules), by
@foxglove/ws-protocol. Compares every frame with the robot's forward kinematics, meshes with those of the cell.

usage: viewers_test.py HAPTICELL_CLI PROJECT_ROOT
"""
import base64
import concurrent.futures
import hashlib
import json
import math
import os
import pathlib
import re
import select
import shutil
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import time
import traceback

CLI, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
CELL = ROOT / "config" / "workcells" / "demo.hcell"
HAND = ROOT / "config" / "workcells" / "demo-hand.csv"
PROTOCOL = "foxglove.websocket.v1"


class Refused(Exception):
    pass


class Viewer:
    """One connection. Whole messages only: HaptiCell does not split them."""

    def __init__(self, port, path="/", origin=None, protocol=PROTOCOL, host="127.0.0.1"):
        self.socket = socket.create_connection((host, port), timeout=20)
        self.bytes = b""
        key = base64.b64encode(os.urandom(16)).decode()
        lines = [f"GET {path} HTTP/1.1", f"Host: {host}:{port}", "Upgrade: websocket", "Connection: Upgrade",
                 f"Sec-WebSocket-Key: {key}", "Sec-WebSocket-Version: 13", f"Sec-WebSocket-Protocol: {protocol}"]
        if origin is not None:
            lines.append(f"Origin: {origin}")
        self.socket.sendall(("\r\n".join(lines) + "\r\n\r\n").encode())
        while b"\r\n\r\n" not in self.bytes:
            self.more()
        head, self.bytes = self.bytes.split(b"\r\n\r\n", 1)
        text = head.decode()
        if not text.startswith("HTTP/1.1 101"):
            raise Refused(text.splitlines()[0])
        wanted = base64.b64encode(hashlib.sha1((key + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11").encode()).digest()).decode()
        assert f"sec-websocket-accept: {wanted.lower()}" in text.lower(), text
        assert f"sec-websocket-protocol: {PROTOCOL}" in text.lower(), text
        self.topics, self.subscribed = {}, {}

    def more(self):
        piece = self.socket.recv(1 << 20)
        if not piece:
            raise EOFError
        self.bytes += piece

    def need(self, count):
        while len(self.bytes) < count:
            self.more()

    def receive(self):
        """("text", str) or ("data", bytes)"""
        while True:
            self.need(2)
            first, length = self.bytes[0], self.bytes[1] & 127
            head = 2
            if length == 126:
                self.need(4)
                length, head = struct.unpack(">H", self.bytes[2:4])[0], 4
            elif length == 127:
                self.need(10)
                length, head = struct.unpack(">Q", self.bytes[2:10])[0], 10
            assert not self.bytes[1] & 128, "a server must not mask"
            self.need(head + length)
            payload, self.bytes = self.bytes[head:head + length], self.bytes[head + length:]
            opcode, is_last = first & 15, first & 128
            if opcode in (0, 1, 2) and not (opcode and is_last):
                kind = getattr(self, "kind", opcode) if opcode == 0 else opcode
                self.kind = kind
                self.part = (self.part if opcode == 0 else b"") + payload
                if not is_last:
                    continue
                opcode, payload = kind, self.part
            if opcode == 1:
                return "text", payload.decode()
            if opcode == 2:
                return "data", payload
            if opcode == 8:
                raise EOFError

    def send(self, text):
        payload, mask = text.encode(), os.urandom(4)
        head = bytes([0x81]) + (bytes([128 | len(payload)]) if len(payload) < 126 else bytes([128 | 126]) + struct.pack(">H", len(payload)))
        self.socket.sendall(head + mask + bytes(b ^ mask[k % 4] for k, b in enumerate(payload)))

    def welcome(self, topics=9):
        kind, text = self.receive()
        assert kind == "text" and json.loads(text)["op"] == "serverInfo", text
        while len(self.topics) < topics:
            kind, text = self.receive()
            said = json.loads(text)
            assert said["op"] == "advertise", said
            for channel in said["channels"]:
                self.topics[channel["topic"]] = channel
        return self

    def subscribe(self, *names):
        wishes = []
        for name in names:
            self.subscribed[len(self.subscribed) + 1] = name
            wishes.append({"id": len(self.subscribed), "channelId": self.topics[name]["id"]})
        self.send(json.dumps({"op": "subscribe", "subscriptions": wishes}))
        return self

    def message(self):
        """(topic, stamp in ns, bytes)"""
        while True:
            kind, payload = self.receive()
            if kind == "text":
                said = json.loads(payload)
                assert said["op"] in ("advertise",), said
                continue
            opcode, subscription, stamp = struct.unpack("<BIQ", payload[:13])
            assert opcode == 1
            return self.subscribed[subscription], stamp, payload[13:]

    def close(self):
        self.socket.close()


class Reader:
    """Plain CDR, low byte first."""

    def __init__(self, data):
        assert data[:4] == b"\x00\x01\x00\x00", data[:4]
        self.data, self.at = data[4:], 0

    def number(self, form):
        size = struct.calcsize(form)
        self.at += -self.at % size
        value = struct.unpack_from("<" + form, self.data, self.at)[0]
        self.at += size
        return value

    def text(self):
        length = self.number("I")
        value = self.data[self.at:self.at + length - 1].decode()
        self.at += length
        return value

    def header(self):
        stamp = self.number("i") * 10**9 + self.number("I")
        return stamp, self.text()


def frames_of(data):
    reader, found = Reader(data), {}
    for _ in range(reader.number("I")):
        stamp, parent = reader.header()
        child = reader.text()
        found[child] = (parent, [reader.number("d") for _ in range(7)], stamp)  # x y z, qx qy qz qw
    assert reader.at == len(reader.data)
    return found


started = []


def live(*words):
    process = subprocess.Popen([CLI, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    started.append(process)
    address = None
    while address is None:
        line = process.stderr.readline()
        assert line, "hapticell-cli ended before it served: " + process.stderr.read()
        address = re.search(r"ws://(\S+):(\d+)(/\S+)?", line)
    return process, int(address[2]), address[3] or "/"


def interrupted(process):
    """What it says when it is ended as by Ctrl+C: all that was wanted of it has been seen."""
    process.send_signal(signal.SIGINT)
    return ended(process)


def ended(process, expect=0):
    out, err = process.communicate(timeout=120)
    assert process.returncode == expect, (process.returncode, out, err)
    return json.loads(out)


def run(*words):
    done = subprocess.run([CLI, *map(str, words)], capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def test_a_viewer_sees_the_whole_cell():
    process, port, _ = live("live", "--workcell", CELL, "--port", 0)
    viewer = Viewer(port).welcome()
    assert {"/scene", "/tf", "/joint_states", "/stylus/pose", "/stylus/wrench", "/force", "/contacts", "/contact_points",
            "/log"} == set(viewer.topics)
    for topic in viewer.topics.values():
        if topic["encoding"] == "json":
            assert topic["schemaEncoding"] == "jsonschema" and json.loads(topic["schema"])["type"] == "object", topic
        else:
            assert topic["encoding"] == "cdr" and topic["schemaEncoding"] == "ros2msg" and "float64" in topic["schema"], topic
    viewer.subscribe("/scene", "/tf", "/joint_states")
    shapes, frames, joints = {}, {}, {}
    inspected = run("inspect", CELL)
    entities = {entity["name"]: entity for entity in inspected["entities"]}
    begin = time.monotonic()
    while time.monotonic() - begin < 5 and not (joints and frames and len(shapes) >= len(entities)):
        topic, stamp, data = viewer.message()
        assert abs(stamp - time.time_ns()) < 60 * 10**9
        if topic == "/scene":
            said = json.loads(data)
            for entity in said["entities"]:
                assert entity["frame_locked"] and entity["lifetime"] == {"sec": 0, "nsec": 0}
                (model,) = entity["models"]
                shapes[entity["id"]] = base64.b64decode(model["data"], validate=True)
        elif topic == "/tf":
            frames.update(frames_of(data))
        else:
            reader = Reader(data)
            reader.header()
            names = [reader.text() for _ in range(reader.number("I"))]
            joints.update(zip(names, [reader.number("d") for _ in range(reader.number("I"))]))
    # Each solid is there with all its triangles.
    for name, entity in entities.items():
        if entity["kind"] != "solid":
            continue
        model = shapes[name]
        magic, version, length = struct.unpack_from("<III", model)
        assert magic == 0x46546C67 and version == 2 and length == len(model)
        text = json.loads(model[20:20 + struct.unpack_from("<I", model, 12)[0]])
        count = sum(text["accessors"][part["indices"]]["count"] for mesh in text["meshes"] for part in mesh["primitives"])
        assert count == 3 * entity["triangles"], (name, count, entity["triangles"])
    # The links are where the robot's forward kinematics has them.
    for name, entity in entities.items():
        if entity["kind"] != "robot":
            continue
        links = {child: value for child, value in frames.items() if child.startswith(name + "/")}
        assert len(links) > 5 and all(parent == name for parent, _, _ in links.values())
        assert frames[name][0] == "world"
        assert all(joint in joints for joint in joints if joint.startswith(name + "/"))
        assert any(shape.startswith(name + "/") for shape in shapes)
    viewer.close()
    result = interrupted(process)
    assert result["viewers"] == 1 and result["messages"] > len(entities), result


def test_a_motion_is_played_as_the_checker_reads_it():
    with tempfile.TemporaryDirectory() as folder:
        motion = pathlib.Path(folder) / "motion.csv"
        recorded = subprocess.run([CLI, "session", "--workcell", CELL, "--entity", "robot", "--hand", HAND, "--record", motion],
                                  capture_output=True, text=True, timeout=300, check=False)
        assert recorded.returncode == 0, recorded.stderr
        process, port, _ = live("live", "--workcell", CELL, "--entity", "robot", "--motion", motion, "--port", 0, "--rate", 60)
        viewer = Viewer(port).welcome().subscribe("/tf", "/joint_states")
        placed, seen = {}, []
        try:
            while True:
                topic, _, data = viewer.message()
                if topic == "/tf":
                    placed.update(frames_of(data))
                    if "robot" in placed:
                        seen.append({name: value for name, value in placed.items() if name.startswith("robot")})
        except (EOFError, ConnectionError):
            pass
        result = ended(process)
        assert result["pictures"] > 30 and len(seen) > 20, (result, len(seen))
        last = seen[-1]
        # Where the last frame of the file has the tip, by the command that knows nothing of viewers.
        rows = motion.read_text().splitlines()
        head = next(k for k, line in enumerate(rows) if line.startswith("t,"))
        names, final = rows[head].split(","), rows[-1].split(",")
        joints = {name: final[k] for k, name in enumerate(names) if name.startswith("joint_")}
        assert len(joints) == 6, names
        table = pathlib.Path(folder) / "joints.csv"
        table.write_text(",".join(joints) + "\n" + ",".join(joints.values()) + "\n")
        pose = run("fk", "--robot", ROOT / "config" / "robots" / "hc6" / "robot.urdf", "--tip", "tcp", "--joints", table)["poses"][0]
        wanted = [pose["x"], pose["y"], pose["z"]]
        assert math.dist(last["robot/tcp"][1][:3], wanted) < 1e-6, (last["robot/tcp"], wanted)


def test_force_and_contacts_of_a_session_come_live():
    process, port, _ = live("session", "--workcell", CELL, "--entity", "robot", "--hand", HAND, "--realtime", "--live", 0)
    viewer = Viewer(port).welcome().subscribe("/force", "/contacts", "/stylus/wrench", "/contact_points", "/log")
    force, touched, wrench, drawn, words = 0.0, set(), 0, 0, []
    try:
        while True:
            topic, _, data = viewer.message()
            if topic == "/force":
                force = max(force, json.loads(data)["newtons"])
            elif topic == "/contacts":
                for pair in json.loads(data)["pairs"]:
                    if pair["contact"]:
                        touched.add(pair["second"])
            elif topic == "/stylus/wrench":
                reader = Reader(data)
                assert reader.header()[1] == "world"
                values = [reader.number("d") for _ in range(6)]
                wrench = max(wrench, math.dist(values[:3], [0, 0, 0]))
            elif topic == "/contact_points":
                drawn += sum(len(line["points"]) for entity in json.loads(data)["entities"] for line in entity["lines"])
            else:
                words.append(json.loads(data)["message"])
    except (EOFError, ConnectionError):
        pass
    result = ended(process)
    assert force > 0.1 and abs(force - wrench) < 0.05 * force, (force, wrench)
    other = {name for contact in result["contacts"] for name in contact["entities"]}
    assert touched and touched <= other, (touched, other)
    assert drawn > 0 and words, (drawn, words)


def test_strangers_are_refused():
    process, port, _ = live("live", "--workcell", CELL, "--port", 0)
    for origin in ("https://evil.example", "http://localhost.evil.example", "null", "http://127.0.0.1.evil.example:80"):
        try:
            Viewer(port, origin=origin)
            raise AssertionError(f"a page of {origin} may watch")
        except Refused as refused:
            assert "403" in str(refused), refused
    for origin in ("https://app.foxglove.dev", "http://localhost:8080", "http://127.0.0.1"):
        Viewer(port, origin=origin).welcome().close()
    try:
        Viewer(port, protocol="chat")
        raise AssertionError("a viewer of another protocol is served")
    except Refused as refused:
        assert "400" in str(refused), refused
    with socket.create_connection(("127.0.0.1", port), timeout=20) as plain:
        plain.sendall(b"GET / HTTP/1.1\r\nHost: here\r\n\r\n")
        page = plain.recv(65536).decode()
        assert "200 OK" in page and "Foxglove" in page, page
    for garbage in (b"\x00" * 100, b"GET / HTTP/9.9\r\n\r\n", b"GET /" + b"a" * 100000):
        with socket.create_connection(("127.0.0.1", port), timeout=20) as stranger:
            stranger.sendall(garbage)
    # A viewer that says nonsense is closed; the others go on.
    good = Viewer(port).welcome().subscribe("/force")
    for nonsense in ("[" * 5000, "no json", "{}", '{"op":5}', '{"op":"subscribe","subscriptions":[{"id":-1,"channelId":"x"},5]}'):
        bad = Viewer(port).welcome()
        bad.send(nonsense)
        bad.close()
    assert good.message()[0] == "/force"
    good.close()
    interrupted(process)


def test_other_machines_need_the_code():
    process, port, path = live("live", "--workcell", CELL, "--port", 0, "--listen", "0.0.0.0")
    assert re.fullmatch(r"/[0-9A-Z-]{20,}", path), path
    for wrong in ("/", "/0000", path[:-1]):
        try:
            Viewer(port, wrong)
            raise AssertionError("served without the code")
        except Refused as refused:
            assert "403" in str(refused), refused
    Viewer(port, path).welcome().close()
    interrupted(process)
    done = subprocess.run([CLI, "live", "--workcell", str(CELL), "--listen", "somewhere"], capture_output=True, text=True, check=False)
    assert done.returncode == 2 and "no IP address" in done.stderr, done.stderr
    done = subprocess.run([CLI, "session", "--workcell", str(CELL), "--entity", "robot", "--hand", str(HAND), "--live", "0"],
                          capture_output=True, text=True, check=False)
    assert done.returncode == 2 and "--realtime" in done.stderr, done.stderr


def test_a_slow_viewer_gets_fewer_messages_not_old_ones():
    process, port, _ = live("live", "--workcell", CELL, "--port", 0, "--rate", 500)
    slow = Viewer(port).welcome().subscribe("/scene", "/tf", "/force", "/contact_points")
    time.sleep(4)
    interrupted(process)
    newest = 0
    while select.select([slow.socket], [], [], 0.2)[0] or slow.bytes:
        try:
            newest = max(newest, slow.message()[1])
        except (EOFError, ConnectionError):
            break
    assert newest > 0


def node_modules():
    node = shutil.which("node")
    for place in (os.environ.get("HAPTICELL_NODE_MODULES"), "/usr/share/nodejs", "/usr/local/lib"):
        if node and place and (pathlib.Path(place) / "node_modules" / "@foxglove" / "ws-protocol").is_dir():
            return node, place
    return None


def test_the_protocol_s_own_client_reads_it():
    found = node_modules()
    if not found:
        return print("left out: node with @foxglove/ws-protocol and ws (HAPTICELL_NODE_MODULES names their folder)")
    node, modules = found
    process, port, _ = live("live", "--workcell", CELL, "--port", 0)
    done = subprocess.run([node, pathlib.Path(__file__).parent / "foxglove_client.js", modules, f"ws://127.0.0.1:{port}"],
                          capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, done.stderr
    heard = json.loads(done.stdout)
    assert heard["name"] == "HaptiCell" and "/tf" in heard["topics"], heard
    assert {"robot"} <= set(heard["frames"]) and heard["models"] > 3, heard
    interrupted(process)


only = sys.argv[3:]
tests = {name: test for name, test in sorted(globals().items()) if name.startswith("test_") and (not only or name in only)}
failed = []
try:
    # Beside each other: they mostly wait for messages.
    with concurrent.futures.ThreadPoolExecutor(len(tests)) as pool:
        for name, running in {name: pool.submit(test) for name, test in tests.items()}.items():
            try:
                running.result()
                print(name, "ok")
            except Exception:  # pylint: disable=broad-except
                traceback.print_exc()
                failed.append(name)
finally:
    for process in started:
        process.kill()
sys.exit(f"failed: {failed}" if failed else 0)
