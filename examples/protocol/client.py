#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A whole client of the haptic server in Python: feels a floor and presses on it.

usage: client.py [--host HOST] [--port PORT] [--schema hapticell.fbs]

Needs flatc (Debian: flatbuffers-compiler) and the flatbuffers module (python3-flatbuffers). docs/library/protocol.md tells the
messages and the rules. One thread is enough here: the loop below sends and receives every 16 ms, heart-beats included.
A client that computes for long should send its heart-beats from a thread of its own.
"""
import argparse
import importlib
import pathlib
import socket
import struct
import subprocess
import sys
import tempfile
import time

import flatbuffers

PROTOCOL_VERSION = 1
IDENTIFIER = b"HCEL"


def load_schema(schema):
    """Lets flatc write the Python classes of the schema and returns a function that imports one of them by name."""
    folder = tempfile.mkdtemp(prefix="hapticell-protocol-")
    subprocess.run(["flatc", "--python", "-o", folder, str(schema)], check=True)
    sys.path.insert(0, folder)
    return lambda name: importlib.import_module("hapticell.haptic.wire." + name)


class Link:
    """Frames over a socket: 32-bit little-endian length, then one FlatBuffer (an Envelope)."""

    def __init__(self, host, port, wire):
        self.wire = wire
        self.body_types = {number: name for name, number in vars(wire("Body").Body).items() if name[0].isupper()}
        self.socket = socket.create_connection((host, port))
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.received = b""

    def send(self, name, build):
        """Sends the message `name`; build(builder, module) makes its table and returns the offset."""
        builder = flatbuffers.Builder(1024)
        body = build(builder, self.wire(name))
        envelope = self.wire("Envelope")
        envelope.EnvelopeStart(builder)
        envelope.EnvelopeAddBodyType(builder, getattr(self.wire("Body").Body, name))
        envelope.EnvelopeAddBody(builder, body)
        builder.Finish(envelope.EnvelopeEnd(builder), file_identifier=IDENTIFIER)
        flatbuffer = bytes(builder.Output())
        self.socket.sendall(struct.pack("<I", len(flatbuffer)) + flatbuffer)

    def receive(self, timeout):
        """All messages that have come, as (name, table); waits for the first at most `timeout` seconds."""
        self.socket.settimeout(timeout)
        try:
            piece = self.socket.recv(65536)
        except TimeoutError:
            return []
        if not piece:
            raise ConnectionError("the server closed the connection")
        self.received += piece
        messages = []
        while len(self.received) >= 4:
            (length,) = struct.unpack_from("<I", self.received)
            if len(self.received) < 4 + length:
                break
            messages.append(self.open(self.received[4:4 + length]))
            self.received = self.received[4 + length:]
        return messages

    def open(self, flatbuffer):
        envelope = self.wire("Envelope").Envelope.GetRootAs(flatbuffer, 0)
        name = self.body_types[envelope.BodyType()]
        table = getattr(self.wire(name), name)()
        table.Init(envelope.Body().Bytes, envelope.Body().Pos)
        return name, table


def hello(builder, module):
    program = builder.CreateString("HaptiCell example")
    module.HelloStart(builder)
    module.HelloAddProtocolVersion(builder, PROTOCOL_VERSION)
    module.HelloAddProgram(builder, program)  # kind: a controller, which is the default
    return module.HelloEnd(builder)


def forces_on(builder, module):
    module.ControlStart(builder)
    module.ControlAddForcesEnabled(builder, True)
    return module.ControlEnd(builder)


def heartbeat(sent, echo, held):
    def build(builder, module):
        module.HeartbeatStart(builder)
        module.HeartbeatAddSentNs(builder, sent)
        module.HeartbeatAddEchoNs(builder, echo)
        module.HeartbeatAddHeldNs(builder, held)
        return module.HeartbeatEnd(builder)
    return build


def hand(link, height):
    """The simulated hand wants the stylus at this height above the middle of the workspace."""
    def build(builder, module):
        module.HandTargetStart(builder)
        module.HandTargetAddHolding(builder, True)
        module.HandTargetAddPose(builder, link.wire("Pose").CreatePose(builder, 0, 0, height, 1, 0, 0, 0))
        return module.HandTargetEnd(builder)
    return build


def floor(link, sequence, proxy):
    """A floor at height 0, as felt around the proxy: gap = its height, gradient = upwards."""
    def build(builder, module):
        constraint = link.wire("Constraint")
        constraint.ConstraintStart(builder)
        constraint.ConstraintAddId(builder, 1)
        constraint.ConstraintAddGradient(builder, link.wire("Vector6").CreateVector6(builder, 0, 0, 1, 0, 0, 0))
        constraint.ConstraintAddGap(builder, proxy[2])
        entry = constraint.ConstraintEnd(builder)
        module.ConstraintSetStartConstraintsVector(builder, 1)
        builder.PrependUOffsetTRelative(entry)
        entries = builder.EndVector()
        module.ConstraintSetStart(builder)
        module.ConstraintSetAddSequence(builder, sequence)
        module.ConstraintSetAddStampNs(builder, time.monotonic_ns())
        module.ConstraintSetAddReference(builder, link.wire("Pose").CreatePose(builder, *proxy, 1, 0, 0, 0))
        module.ConstraintSetAddZoneRadius(builder, 0.060)
        module.ConstraintSetAddConstraints(builder, entries)
        return module.ConstraintSetEnd(builder)
    return build


def xyz(vector):
    return vector.X(), vector.Y(), vector.Z()


def connect(host, port, wire):
    link = Link(host, port, wire)
    link.send("Hello", hello)
    while True:
        for name, message in link.receive(5.0):
            if name == "Refusal":
                sys.exit("refused: " + message.Sentence().decode())
            if name == "Welcome":
                device = message.Device()
                print(f"{device.Name().decode()}: {device.PeakForce():g} N, {device.Stiffness():g} N/m")
                return link


def press(link):
    """Holds the stylus 5 mm above the floor until forces are on, lowers the hand 10 mm into it, prints what is felt."""
    height, sequence, pressed_since, next_beat, peer, last_print = 0.005, 0, None, 0.0, (0, 0), 0.0
    while pressed_since is None or time.monotonic() - pressed_since < 1.0:
        now = time.monotonic()
        if now >= next_beat:
            held = time.monotonic_ns() - peer[1] if peer[0] else 0
            link.send("Heartbeat", heartbeat(time.monotonic_ns(), peer[0], held))
            next_beat = now + 0.01  # Quick, as while forces are on: a client that dies is noticed by what does not come.
        state = None
        for name, message in link.receive(0.016):
            if name == "State":
                state = message
            elif name == "Heartbeat":
                peer = (message.SentNs(), time.monotonic_ns())
            elif name == "Refusal":
                sys.exit("refused: " + message.Sentence().decode())
        if state is None:
            continue
        sequence += 1
        link.send("ConstraintSet", floor(link, sequence, xyz(state.Proxy().P(link.vector3()))))
        link.send("Control", forces_on)
        link.send("HandTarget", hand(link, height))
        if state.ForceRamp() == 1.0:
            height = max(-0.010, height - 0.0002)
        if height == -0.010 and pressed_since is None:
            pressed_since = now
        if now - last_print > 0.1:
            last_print = now
            stylus, force = xyz(state.Stylus().P(link.vector3())), xyz(state.Force())
            print(f"tick {state.Tick()} stylus {1e3 * stylus[2]:7.3f} mm force {force[2]:6.3f} N")
        time.sleep(0.016)


def main():
    here = pathlib.Path(__file__).resolve().parent
    options = argparse.ArgumentParser(description="Presses the simulated hand on a floor.")
    options.add_argument("--host", default="127.0.0.1")
    options.add_argument("--port", type=int, default=4747)
    options.add_argument("--schema", default=here.parent.parent / "haptic" / "protocol" / "hapticell.fbs")
    asked = options.parse_args()
    wire = load_schema(asked.schema)
    link = connect(asked.host, asked.port, wire)
    link.vector3 = wire("Vector3").Vector3
    press(link)


if __name__ == "__main__":
    main()
