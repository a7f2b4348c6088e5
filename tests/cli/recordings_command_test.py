#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Sessions, motions and scores as MCAP by the command line: against the trace and the motion of the same session, through
readers of others where node and their modules are installed (HAPTICELL_NODE_MODULES: a folder with node_modules), back
again, cut and bent files, the table for LeRobot, and a running haptic server.

usage: recordings_command_test.py HAPTICELL_CLI HAPTICELL_HAPTIC_SERVER [--readers]
With --readers, only what needs the readers of others; exit 77 without them.
"""
import csv
import json
import os
import pathlib
import random
import shutil
import socket
import subprocess
import sys
import tempfile
import time

CLI, SERVER = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
ROOT = pathlib.Path(__file__).resolve().parents[2]
CELLS = ROOT / "config/workcells"
READERS = pathlib.Path(__file__).resolve().parent / "mcap_readers.js"


def run(*words, status=0):
    done = subprocess.run([CLI, *map(str, words)], capture_output=True, text=True, timeout=300)
    assert done.returncode == status, (words, done.returncode, done.stderr[-2000:])
    return json.loads(done.stdout) if status == 0 else done.stderr


def table(file):
    with open(file, newline="") as lines:
        return list(csv.DictReader(lines))


def session(folder):
    return run("session", "--workcell", CELLS / "demo.hcell", "--entity", "robot", "--hand", CELLS / "demo-hand.csv", "--mcap",
               folder / "s.mcap", "--trace", folder / "trace.csv", "--record", folder / "r.htraj", "--rate-manipulation", 100)


def modules():
    """The folder with node_modules, or None."""
    node = shutil.which("node")
    for place in (os.environ.get("HAPTICELL_NODE_MODULES"), "/usr/share/nodejs", "/usr/local/lib"):
        if not node or not place:
            continue
        there = pathlib.Path(place)
        for base in (there / "node_modules", there):
            if all((base / name).is_dir() for name in ("@mcap/core", "@mcap/support", "@foxglove/rosmsg2-serialization", "@foxglove/rosmsg")):
                return there
    return None


def of_others(*words):
    done = subprocess.run(["node", READERS, modules(), *map(str, words)], capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr[-3000:]
    return json.loads(done.stdout) if words[0] == "read" else None


def others_read_a_session(folder):
    answer = session(folder)
    rows = table(folder / "trace.csv")
    read = of_others("read", folder / "s.mcap")
    assert read["profile"] == "ros2" and read["ordered"] and read["done"], read
    topics = read["topics"]
    for topic, kind in (("/stylus/pose", "geometry_msgs/msg/PoseStamped"), ("/stylus/wrench", "geometry_msgs/msg/WrenchStamped"),
                        ("/stylus/moved", "geometry_msgs/msg/PoseStamped"), ("/stylus/buttons", "sensor_msgs/msg/Joy")):
        assert topics[topic]["type"] == kind and topics[topic]["count"] == len(rows), (topic, topics[topic]["count"], len(rows))
    row, message = rows[100], topics["/stylus/pose"]["hundredth"]
    for name in "xyz":
        assert abs(float(row[name]) - message["pose"]["position"][name]) < 1e-9
        assert abs(float(row["q" + name]) - message["pose"]["orientation"][name]) < 1e-9
        assert abs(float(row["f" + name]) - topics["/stylus/wrench"]["hundredth"]["wrench"]["force"][name]) < 1e-6
    stamp = message["header"]["stamp"]
    assert abs(float(row["t"]) - stamp["sec"] - 1e-9 * stamp.get("nanosec", stamp.get("nsec"))) < 1e-6
    assert topics["/stylus/pose"]["times"][1] - topics["/stylus/pose"]["times"][0] == 1_000_000  # 1 kHz.
    motion = run("trajectory", "info", folder / "r.htraj")
    joints = topics["/joint_states"]
    assert joints["count"] == motion["frames"] and joints["last"]["name"] == motion["joints"]
    document = json.loads((folder / "r.htraj").read_text())
    assert joints["last"]["position"] == document["frames"][-1][8:8 + len(motion["joints"])]
    assert topics["/contacts"]["count"] == len(answer["contacts"]) if answer["contacts"] else "/contacts" not in topics
    assert "session.json" in read["attachments"] and "hapticell_motion" in read["metadata"]
    assert read["records"] == read["messages"] == sum(topic["count"] for topic in topics.values())


def files_of_others_are_read(folder):
    of_others("write", folder / "other.mcap", 2000)
    info = run("trajectory", "info", folder / "other.mcap")
    assert info["frames"] == 2000 and info["joints"] == ["a", "b"] and abs(info["duration"] - 1.999) < 1e-6, info
    run("convert", folder / "other.mcap", "-o", folder / "other.csv")
    rows = table(folder / "other.csv")
    assert float(rows[1999]["a"]) == 0.001 * 1999 and float(rows[7]["b"]) == -1 / 3


def motions_come_back(folder):
    session(folder)
    motion = run("trajectory", "info", folder / "r.htraj")
    again = run("trajectory", "info", folder / "s.mcap")
    for key in ("frames", "duration", "joints", "length", "max_speed", "entity", "moved"):
        same = motion[key] == again[key] if not isinstance(motion[key], float) else abs(motion[key] - again[key]) < 1e-6 * (1 + abs(motion[key]))
        assert same, (key, motion[key], again[key])
    run("convert", folder / "s.mcap", "-o", folder / "back.htraj")
    ours, theirs = (json.loads((folder / name).read_text()) for name in ("r.htraj", "back.htraj"))
    assert len(ours["frames"]) == len(theirs["frames"])
    for a, b in zip(ours["frames"], theirs["frames"]):
        assert a[1:] == b[1:] and abs(a[0] - b[0]) < 1e-9
    run("convert", folder / "back.htraj", "-o", folder / "again.mcap")
    run("trajectory", "export", folder / "s.mcap", "--to", "csv", "-o", folder / "poses.csv")
    assert len(table(folder / "poses.csv")) == motion["frames"]
    run("record", "--from", folder / "trace.csv", "--from", folder / "r.htraj", "--mcap", folder / "of_trace.mcap")
    assert "other.txt" in run("convert", folder / "s.mcap", "-o", folder / "other.txt", status=2)


def scores_are_kept(folder):
    sample = ROOT / "tests/samples/0.1/kim.htrain"
    attempts = json.loads(sample.read_text())["attempts"]
    (folder / "kim.htrain").write_text(json.dumps({**json.loads(sample.read_text()), "attempts": [
        {key: value for key, value in attempt.items() if key != "recording"} for attempt in attempts]}))
    answer = run("record", "--from", folder / "kim.htrain", "--mcap", folder / "kim.mcap")
    assert answer["attempts"] == len(attempts), answer
    again = run("record", "--from", folder / "kim.mcap", "--mcap", folder / "kim2.mcap")
    assert again["attempts"] == len(attempts)
    assert (folder / "kim.mcap").read_bytes() == (folder / "kim2.mcap").read_bytes()
    exercise = ROOT / "config/exercises/door.hexercise"
    expert = run("trajectory", "info", exercise.parent / json.loads(exercise.read_text())["recording"])
    assert run("record", "--from", exercise, "--mcap", folder / "door.mcap")["frames"] == expert["frames"]
    assert run("trajectory", "info", folder / "door.mcap")["length"] == expert["length"]


def table_has_what_lerobot_asks(folder):
    motion = json.loads((folder / "r.htraj").read_text())
    answer = run("record", "--from", folder / "r.htraj", "--lerobot", folder / "set", "--rate", 50, "--task", "open it")
    assert answer["frames"] == len(motion["frames"])
    info = json.loads((folder / "set/meta/info.json").read_text())
    rows = table(folder / "set/data/chunk-000/episode_000000.csv")
    assert info["total_frames"] == len(rows) and info["fps"] == 50
    names = info["features"]["observation.state"]["names"]
    assert names == motion["joints"]
    first, times = motion["frames"][0], [frame[0] for frame in motion["frames"]]
    for i in (0, len(rows) // 2, len(rows) - 1):  # By an interpolation of our own.
        t = first[0] + i / 50
        k = max(1, min(len(times) - 1, next((n for n, time_ in enumerate(times) if time_ >= t), len(times) - 1)))
        share = min(1.0, max(0.0, (t - times[k - 1]) / (times[k] - times[k - 1])))
        for j, name in enumerate(names):
            a, b = motion["frames"][k - 1][8 + j], motion["frames"][k][8 + j]
            assert abs(float(rows[i]["observation.state." + name]) - (a + share * (b - a))) < 1e-9
    assert float(rows[0]["action." + names[0]]) == float(rows[1]["observation.state." + names[0]])
    assert "not empty" in run("record", "--from", folder / "r.htraj", "--lerobot", folder / "set", status=2)


def bad_files_are_refused(folder):
    whole = (folder / "s.mcap").read_bytes()
    chance = random.Random(7)
    for size in (0, 5, 8, 100, len(whole) // 2, len(whole) - 9, len(whole) - 1):
        (folder / "cut.mcap").write_bytes(whole[:size])
        sentence = run("trajectory", "info", folder / "cut.mcap", status=2)
        assert "cut.mcap" in sentence, sentence
    for _ in range(10):
        bent = bytearray(whole)
        bent[chance.randrange(len(bent))] ^= 1 << chance.randrange(8)
        (folder / "bent.mcap").write_bytes(bent)
        run("trajectory", "info", folder / "bent.mcap", status=2)
    before = (folder / "again.mcap").read_bytes()
    run("record", "--from", folder / "bent.mcap", "--mcap", folder / "again.mcap", status=2)
    assert (folder / "again.mcap").read_bytes() == before
    assert "neither" in run("record", "--mcap", folder / "x.mcap", status=2)
    assert "neither" in run("record", "--from", folder / "r.htraj", status=2)


def a_server_is_recorded(folder):
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    server = subprocess.Popen([SERVER, "--listen", "127.0.0.1", "--port", str(port)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        time.sleep(1.0)
        hand = subprocess.Popen([CLI, "session", "--workcell", CELLS / "demo.hcell", "--entity", "robot", "--hand", CELLS / "demo-hand.csv",
                                 "--realtime", "--server", f"127.0.0.1:{port}"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(1.0)
        moved = False
        while not moved and hand.poll() is None:  # Until a record falls into the hand's motion, however busy the machine is.
            answer = run("record", "--server", f"127.0.0.1:{port}", "--seconds", 3, "--mcap", folder / "live.mcap")
            assert answer["complete"] and answer["samples"] > 10 and answer["ticks"] == answer["samples"] + answer["ticks_without_state"], answer
            info = run("trajectory", "info", folder / "live.mcap")
            assert info["frames"] == answer["samples"], info
            moved = info["length"] > 0.001
        assert moved
        hand.kill()
        hand.wait(60)
    finally:
        server.terminate()
        server.wait(20)
    assert "no haptic server" in run("record", "--server", f"127.0.0.1:{port}", "--seconds", 1, "--mcap", folder / "none.mcap", status=2)
    assert not (folder / "none.mcap").exists()


def main():
    readers = "--readers" in sys.argv
    if readers and not modules():
        print("skipped: node with @mcap/core, @mcap/support, @foxglove/rosmsg and @foxglove/rosmsg2-serialization is not installed "
              "(HAPTICELL_NODE_MODULES names their folder)")
        return 77
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        steps = [others_read_a_session, files_of_others_are_read] if readers else \
            [motions_come_back, scores_are_kept, table_has_what_lerobot_asks, bad_files_are_refused, a_server_is_recorded]
        for step in steps:
            step(folder)
            print("passed", step.__name__, flush=True)
    return 0


sys.exit(main())
