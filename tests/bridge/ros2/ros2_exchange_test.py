#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`hapticell-cli ros2` against programs with another maker's DDS (fastdds_peer.cpp), in processes of their own, on loopback without
multicast: every field of what is published and heard, who comes late, who goes and comes again, 1 kHz.

usage: ros2_exchange_test.py HAPTICELL_CLI PROJECT [FASTDDS_PEER]
Exit 77 without the peer (Debian: libfastrtps-dev, fastddsgen and Java, when the tests are built).
"""
import concurrent.futures
import json
import math
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import xml.etree.ElementTree as ET

import type_hashes

CLI, ROOT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
PEER = sys.argv[3] if len(sys.argv) > 3 else None
CELL = ROOT / "config/workcells/demo.hcell"
# Of DDS, one for each lane of main() and from 88 to 98 one for each controller; those of other tests are in
# tests/support/ros2_domains.h.
DOMAINS = ("85", "86", "87")
CONTROLLERS = 88
# Of a message that has reached another program until that has worked on it, s; far more than it needs.
TAKEN = 0.3

children, is_over = [], threading.Event()


def spawn(words, **options):
    """A process that ends with this test, by end_children()."""
    if is_over.is_set():
        raise RuntimeError("the test has failed in another lane")
    process = subprocess.Popen([*map(str, words)], text=True, start_new_session=True, **options)
    children.append(process)
    if is_over.is_set():  # Another lane failed meanwhile.
        end_children()
    return process


def end_children():
    is_over.set()
    for process in list(children):
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)


class Domain:
    """One domain of DDS with the programs in it."""
    def __init__(self, number):
        self.number = number

    def peer(self, *words, output=subprocess.PIPE):
        return spawn([PEER, self.number, *words], stdout=output)

    def start(self, *words):
        return spawn([CLI, "ros2", *words, "--domain", self.number, "--this-machine"], stdout=subprocess.PIPE,
                     stderr=subprocess.PIPE)


def lines(process, wanted=0):
    out, _ = process.communicate(timeout=120)
    assert wanted is None or process.returncode == wanted, (process.args, process.returncode, out[-500:])
    return [json.loads(line) for line in out.splitlines()]


def first_line(process):
    """Waits for the first line that a process writes."""
    return json.loads(process.stdout.readline())


def kill(process):
    """Without a farewell to the others."""
    process.kill()
    process.communicate()


def answer(process, status=0):
    out, err = process.communicate(timeout=120)
    assert process.returncode == status, (process.args, process.returncode, err)
    return json.loads(out) if status == 0 else err


def interrupted(process):
    """The answer of a process that is ended as by Ctrl+C: it has done what is wanted of it."""
    os.killpg(process.pid, signal.SIGINT)
    return answer(process)


def motion_file(folder):
    """A motion of the robot of the cell with forces, as its twin in CSV."""
    subprocess.run([CLI, "session", "--workcell", CELL, "--entity", "robot", "--hand", ROOT / "config/workcells/demo-hand.csv", "--record",
                    folder / "m.htraj"], check=True, capture_output=True)
    return json.loads((folder / "m.htraj").read_text())


def types_are_announced(watches, hashes):
    """The hashes of types in discovery, as another DDS sees them."""
    seen, endpoints = {}, []
    for watch in watches:  # They printed every endpoint.
        watch.kill()
        endpoints += watch.communicate()[0].splitlines()
    for endpoint in map(json.loads, endpoints):
        if endpoint["user_data"]:
            assert endpoint["user_data"] == f"typehash=RIHS01_{hashes[endpoint['type']]};", endpoint
            seen[endpoint["kind"], endpoint["topic"]] = endpoint["type"]
    for topic in ("robot_description", "tf_static", "planning_scene", "tf", "joint_states", "moved/pose", "moved/wrench", "clock",
                  "contact_markers", "arm/joint_trajectory"):
        assert ("writer", "rt/" + topic) in seen, (topic, seen)
    for topic in ("joint_states", "joint_trajectory", "robot_description", "planning_scene", "collision_object"):
        assert ("reader", "rt/" + topic) in seen, (topic, seen)
    assert set(seen.values()) == set(hashes), set(hashes) - set(seen.values())


def part_of(motion, begin, end):
    return {**motion, "frames": [frame for frame in motion["frames"] if begin <= frame[0] <= end]}


def marked(domain, folder, cell, motion):
    """Messages of the contacts of a motion, by the time of the motion."""
    (folder / "part.htraj").write_text(json.dumps(motion))
    with (folder / "markers.txt").open("w") as output:  # More than a pipe holds.
        reader = domain.peer("read", "rt/contact_markers", "MarkerArray", 10**6, 60, output=output)
    answer(domain.start("publish", "--workcell", cell, "--motion", folder / "part.htraj", "--contacts", "--clock", "--seconds", 0.1))
    time.sleep(TAKEN)
    reader.kill()  # It printed every message.
    reader.wait()
    begin = motion["frames"][0][0]
    messages = []
    for message in map(json.loads, (folder / "markers.txt").read_text().splitlines()):
        header = message["markers"][0]["header"]
        assert header["frame_id"] == "world" and all(marker["header"] == header for marker in message["markers"])
        messages.append((begin + header["sec"] + 1e-9 * header["nanosec"], message["markers"]))
    assert len(messages) > 20, len(messages)
    return messages


def direction(w, x, y, z):
    """Where a rotation turns the x axis."""
    return [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)]


def contacts_are_marked(domain, folder, motion):
    whole = part_of(motion, 4.6, 6.7)
    forces = 1 + 7 + len(motion["joints"])
    inspected = json.loads(subprocess.run([CLI, "inspect", CELL], capture_output=True, text=True, check=True).stdout)
    bounds = {}

    def collect(entities):
        for entity in entities:
            if entity.get("bounds"):
                bounds[entity["name"]] = entity["bounds"]
            collect(entity["children"])
    collect(inspected["entities"])
    shown, ended = set(), set()
    for t, markers in marked(domain, folder, CELL, whole):
        added = {}
        for marker in markers:
            assert marker["id"] in (0, 1) and marker["frame_locked"] == marker["rest"] == 0 and marker["lifetime"] == 0.5
            if marker["action"] == 2:
                assert marker["ns"] in shown
                ended.add((marker["ns"], marker["id"]))
                continue
            assert marker["action"] == 0 and [round(c, 3) for c in marker["color"]] == [0.9, 0.2, 0.1, 1]
            added.setdefault(marker["ns"], {})[marker["id"]] = marker
        # Which are in contact is what the session wrote down.
        if all(abs(t - edge) > 1e-6 for touch in motion["touches"] for edge in touch[:2]) and t < whole["frames"][-1][0]:
            assert set(added) == {f"{first} / {second}" for t_in, t_out, first, second, _ in motion["touches"] if t_in <= t < t_out}, (t, added)
        shown |= set(added)
        # At a frame's own time rounding decides which of two is meant.
        felt = [[row for row in whole["frames"] if row[0] <= max(t + side, whole["frames"][0][0])][-1][forces:forces + 3]
                for side in (-1e-6, 1e-6)]
        for name, pair in added.items():
            arrow, ball = pair[0], pair[1]
            n = direction(*arrow["orientation"])
            assert (arrow["type"], ball["type"]) == (0, 2) and arrow["position"] == ball["position"]
            assert abs(sum(q * q for q in arrow["orientation"]) - 1) < 1e-9 and ball["orientation"] == [1, 0, 0, 0]
            along = [max(0.0, sum(f * c for f, c in zip(force, n))) for force in felt]
            assert any(abs(arrow["scale"][0] - (0.010 + 0.010 * f)) < 1e-6 for f in along) and ball["scale"] == [0.01, 0.01, 0.01], (t, arrow)
            # Half of the safety distance of 1 mm off the other part, on the side that the normal points to.
            box = bounds[name.split(" / ")[1]]
            assert all(low - 0.0011 < p < high + 0.0011 for low, p, high in zip(box["min"], arrow["position"], box["max"])), (arrow, box)
            towards = {"Stop rail": [-1, 0, 0]}.get(name.split(" / ")[1], [0, 0, 1])
            assert sum(a * b for a, b in zip(n, towards)) > 0.7, (name, n)  # Locators are round.
    assert len(shown) == 3 and ended == {(name, marker) for name in shown for marker in (0, 1)}, (shown, ended)


def depth_is_marked(domain, folder, motion):
    """The stop 5 mm nearer: the part, 1 mm off before, is 4 mm deep in it. The motion lists no contacts."""
    cell = json.loads(CELL.read_text())
    stop = next(entity for entity in cell["entities"] if entity["name"] == "Stop rail")
    stop["placement"]["position"][0] -= 0.005
    moved = folder / "config/workcells/stop.hcell"
    moved.parent.mkdir(parents=True)
    shutil.copytree(CELL.parent / "demo", moved.parent / "demo")
    (folder / "config/robots").symlink_to(ROOT / "config/robots")
    moved.write_text(json.dumps(cell))
    found = marked(domain, folder, moved, {**part_of(motion, 3.6, 6.0), "touches": []})
    pressed = [marker for t, markers in found for marker in markers if 5.5 < t < 6.0 and marker["id"] == 1 and marker["action"] == 0]
    assert len(pressed) > 20
    for ball in pressed:
        assert ball["ns"] == "robot/housing_4711 / Stop rail" and abs(ball["scale"][0] - (0.010 + 2 * 0.004)) < 4e-4, ball


def everything_arrives(domain, folder, motion):
    wanted = {"joints": ("joint_states", "JointState", 50), "frames": ("tf", "TFMessage", 50), "moved": ("moved/pose", "PoseStamped", 20),
              "clock": ("clock", "Clock", 20), "force": ("moved/wrench", "WrenchStamped", 20)}
    readers = {name: domain.peer("read", "rt/" + topic, form, count, 60) for name, (topic, form, count) in wanted.items()}
    publish = domain.start("publish", "--workcell", CELL, "--motion", folder / "m.htraj", "--clock", "--rate", 100, "--seconds", 100, "--repeat",
                           "--contacts")
    got = {name: lines(process) for name, process in readers.items()}
    # Who comes late gets what is latched.
    latched = {"text": ("robot_description", "String"), "fixed": ("tf_static", "TFMessage"), "scene": ("planning_scene", "PlanningScene")}
    late = {name: domain.peer("read", "rt/" + topic, form, 1, 60, "latched") for name, (topic, form) in latched.items()}
    got |= {name: lines(process) for name, process in late.items()}
    report = interrupted(publish)
    check_joints(motion, got["joints"], got["frames"])
    names = motion["joints"]
    robot = ET.fromstring(got["text"][0]["data"])
    assert set(names) <= {joint.get("name") for joint in robot.iter("joint")}
    for mesh in robot.iter("mesh"):
        assert mesh.get("filename").startswith("file:///"), mesh.get("filename")
    links = {link.get("name") for link in robot.iter("link")}
    children = [t["child"] for t in got["fixed"][0]["transforms"]] + [t["child"] for t in got["frames"][0]["transforms"]]
    assert len(children) == len(set(children)) and links - {"world", "cell"} <= set(children), (links, children)
    inspected = json.loads(subprocess.run([CLI, "inspect", CELL], capture_output=True, text=True, check=True).stdout)
    solids = {}

    def collect(entities):
        for entity in entities:
            if entity["kind"] == "solid" and entity["triangles"] > 0:
                solids[entity["name"]] = entity["triangles"]
            collect(entity["children"])
    collect(inspected["entities"])
    objects = {item["id"]: item for item in got["scene"][0]["objects"]}
    assert got["scene"][0]["is_diff"] == 1 and objects and set(objects) <= set(solids), (objects.keys(), solids.keys())
    for name, item in objects.items():
        assert item["triangles"] == solids[name] and item["header"]["frame_id"] == "world" and item["operation"] == 0
    times = [clock["sec"] + 1e-9 * clock["nanosec"] for clock in got["clock"]]
    assert all(abs(b - a - 0.01) < 1e-6 for a, b in zip(times, times[1:])), times
    assert got["moved"][0]["header"]["frame_id"] == "world" and abs(sum(q * q for q in got["moved"][0]["orientation"]) - 1) < 1e-9
    assert all(math.isfinite(f) for f in got["force"][0]["force"]) and got["force"][0]["torque"] == [0, 0, 0]
    assert report["published"]["/joint_states"] == report["ticks"] and report["published"]["/robot_description"] == 1


def check_joints(motion, states, frames):
    """Positions at the stamps of the messages, by an interpolation of our own."""
    names, rows = motion["joints"], motion["frames"]
    duration = rows[-1][0] - rows[0][0]
    previous = -1.0
    for state in states:
        assert state["name"] == names and len(state["position"]) == len(names) and state["effort"] == []
        stamp = state["header"]["sec"] + 1e-9 * state["header"]["nanosec"]
        assert stamp > previous
        previous = stamp
        t = rows[0][0] + math.fmod(stamp, duration)
        k = next((n for n, row in enumerate(rows) if row[0] >= t), len(rows) - 1)
        a, b = rows[max(0, k - 1)], rows[k]
        share = 0.0 if b[0] == a[0] else min(1.0, max(0.0, (t - a[0]) / (b[0] - a[0])))
        for j in range(len(names)):
            assert abs(state["position"][j] - (a[8 + j] + share * (b[8 + j] - a[8 + j]))) < 1e-5, (stamp, j)
    for message in frames:
        for transform in message["transforms"]:
            assert abs(sum(q * q for q in transform["rotation"]) - 1.0) < 1e-9


def a_motion_is_sent(domain, folder, motion):
    reader = domain.peer("read", "rt/arm/joint_trajectory", "JointTrajectory", 1, 30)
    # The trajectory first; the motion itself need not be published to its end.
    publish = domain.start("publish", "--workcell", CELL, "--motion", folder / "m.htraj", "--trajectory", "/arm/joint_trajectory", "--seconds", 0.1,
                           "--wait", 20, "--rate", 10)
    message = lines(reader)[0]
    time.sleep(TAKEN)
    interrupted(publish)
    rows = motion["frames"]
    assert message["joint_names"] == motion["joints"] and len(message["points"]) == len(rows)
    for row, point in zip(rows, message["points"]):
        assert point["positions"] == row[8:8 + len(motion["joints"])]
        assert abs(point["sec"] + 1e-9 * point["nanosec"] - (row[0] - rows[0][0])) < 1e-8
    assert set(message["points"][0]["velocities"]) == {0} and set(message["points"][-1]["velocities"]) == {0}
    assert "no reader" in answer(domain.start("publish", "--workcell", CELL, "--motion", folder / "m.htraj", "--trajectory", "/nobody", "--wait", 1), 2)


ACTION = "/arm/follow_joint_trajectory"


def small_motion(folder, motion):
    """A tenth of a radian of the second joint, from where the robot of the cell is: upwards, and a little too fast. The robot
    stands in a cell without anything else, which is prepared quickly."""
    cell = json.loads(CELL.read_text())
    robot = next(e for e in cell["entities"] if e["name"] == "robot")
    robot["source"]["file"] = str((CELL.parent / robot["source"]["file"]).resolve())
    (folder / "arm.hcell").write_text(json.dumps({"format": cell["format"], "version": cell["version"], "entities": [robot]}))
    start = [robot["joints"][name] for name in motion["joints"]]
    rows = []
    for i in range(26):
        s = i / 25
        rows.append([0.4 * s, 0, 0, 0, 1, 0, 0, 0, start[0], start[1] - 0.1 * s * s * (3 - 2 * s), *start[2:]])
    (folder / "small.htraj").write_text(json.dumps({"format": "hapticell-trajectory", "version": 1, "entity": "robot",
                                                    "joints": motion["joints"], "has_poses": False, "frames": rows}))
    return rows


def sending(folder, domain, *more, confirm="robot", wait=20):
    return spawn([CLI, "ros2", "send", "--workcell", folder / "arm.hcell", "--motion", folder / "small.htraj", "--action", ACTION, "--domain", domain,
                  "--this-machine", "--wait", wait, *(("--confirm", confirm) if confirm else ()), *more], stdin=subprocess.DEVNULL,
                 stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def sent_once(folder, domain, form, behaviour, start, *more, interrupt=False):
    """Exit status, result, sentence and what the controller saw."""
    controller = spawn([PEER, domain, "act", ACTION, form, 0, 60, start, behaviour], stdout=subprocess.PIPE)
    send = sending(folder, domain, "--services", "auto" if form == "plain" else form, *more)
    seen = []
    while interrupt:
        seen.append(json.loads(controller.stdout.readline()))
        if seen[-1] == {"state": 2}:
            os.killpg(send.pid, signal.SIGINT)
            break
    out, err = send.communicate(timeout=120)
    controller.kill()
    rest, _ = controller.communicate()
    seen += [json.loads(line) for line in rest.splitlines() if line.endswith("}")]
    return send.returncode, json.loads(out) if out else None, err, seen


def sent(*words, **options):
    """Again where a busy machine let the robot's joint states wait for half a second."""
    for _ in range(3):
        status, result, err, seen = sent_once(*words, **options)
        if not (result and "0.5 s" in result.get("reason", "") and words[3] != "silent"):
            break
    return status, result, err, seen


def motions_are_followed(domain, folder, motion):
    rows = small_motion(folder, motion)
    start = ",".join(f"{name}={q!r}" for name, q in zip(motion["joints"], rows[0][8:]))
    preview = sending(folder, domain.number, confirm=None)
    out, err = preview.communicate(timeout=120)
    shown = json.loads(out)
    assert preview.returncode == 0 and not shown["sent"] and "Nothing was sent" in err and "'robot' moves for" in err, err
    assert shown["tool_speed"] <= 0.25 < shown["tool_speed"] * shown["slowed"] and abs(shown["duration"] - 0.4 * shown["slowed"]) < 1e-6, shown
    with concurrent.futures.ThreadPoolExecutor() as pool:
        def run(domain, form, behaviour, *more, joints=start, **options):
            return pool.submit(sent, folder, str(domain), form, behaviour, joints, *more, **options)
        followed = {"plain": run(domain.number, "plain", "follow"), "numbered": run(88, "numbered", "noise"), "noise": run(89, "plain", "noise")}
        others = {"reject": run(90, "plain", "reject"), "abort": run(91, "plain", "abort"), "deaf": run(92, "plain", "deaf", "--tool-speed", "0.02", interrupt=True),
                  "user": run(93, "numbered", "follow", "--tool-speed", "0.02", interrupt=True),
                  "silent": run(94, "plain", "silent", "--tool-speed", "0.05"),
                  "stray": run(95, "plain", "stray", "--tool-speed", "0.05"), "idle": run(96, "plain", "idle"),
                  "elsewhere": run(97, "plain", "follow", joints=start.replace("joint_2=0.", "joint_2=0.1"))}
        followed, others = ({name: future.result() for name, future in runs.items()} for runs in (followed, others))
    for name, (status, result, err, seen) in followed.items():
        assert status == 0 and result["outcome"] == "succeeded" and result["sent"] and result["error_code"] == 0, (name, result, err)
        assert result["feedbacks"] > 0 and result["confirmation"] == shown["confirmation"], (name, result)
        goal = seen[0]["goal"]
        assert goal["joints"] == motion["joints"] and goal["rest"] == 0 and goal["version"] == 4 and len(goal["points"]) == len(rows)
        for row, point in zip(rows, goal["points"]):
            assert abs(point[0] - shown["slowed"] * row[0]) < 1e-8 and point[1:7] == row[8:], (row, point)
        assert set(goal["points"][0][7:]) == set(goal["points"][-1][7:]) == {0}
        assert [item["state"] for item in seen if "state" in item] == [1, 2, 4], seen
    cancelled = [{"cancel": 1, "stamp": 0}, {"state": 3}, {"state": 5}]
    for name, reason in (("user", "stopped by the user"), ("silent", "did not come for 0.5 s"), ("stray", "left the motion"),
                         ("idle", "did not start")):
        status, result, err, seen = others[name]
        assert status == 1 and result["outcome"] == "canceled" and reason in result["reason"], (name, result, err)
        assert [item for item in seen if item in cancelled][:3] == cancelled, (name, seen)
    status, result, err, seen = others["reject"]
    assert status == 1 and result["outcome"] == "rejected" and len(seen) == 1, (result, seen)
    status, result, err, seen = others["abort"]
    assert status == 1 and (result["outcome"], result["error_code"], result["error"]) == ("aborted", -4, "A2 left its path"), result
    status, result, err, seen = others["deaf"]
    assert status == 2 and "emergency stop" in err and seen.count(cancelled[0]) > 5, (status, err, seen)
    status, result, err, seen = others["elsewhere"]
    assert status == 2 and "'joint_2' of the robot is not at the first point" in err and seen == [], (err, seen)
    for name, sentence in (("arm", "the name of the robot, 'robot'"), ("robot", "no controller")):
        wrong = sending(folder, "98", confirm=name, wait=0.5)
        out, err = wrong.communicate(timeout=120)
        assert wrong.returncode == 2 and sentence in err, err


def linked(domain, mirror):
    """The link as the window starts it, with JSON lines in both directions."""
    job = {"do": "link", "domain": int(domain.number), "this_machine": True, "workcell": str(CELL), "entity": "robot", "mirror": mirror}
    return spawn([CLI.with_name("hapticell-ros2"), json.dumps(job)], stdin=subprocess.PIPE, stdout=subprocess.PIPE)


def the_window_is_linked(domain, motion):
    wanted = [0.1 * k for k in range(len(motion["joints"]))]
    link = linked(domain, False)
    link.stdin.write("no JSON\n" + json.dumps({"joints": wanted[1:]}) + "\n" + json.dumps({"joints": wanted, "place": [1, 2, 3, 1, 0, 0, 0]}) + "\n")
    link.stdin.flush()
    states, frames = domain.peer("read", "rt/joint_states", "JointState", 20, 30), domain.peer("read", "rt/tf", "TFMessage", 20, 30)
    for state in lines(states)[-5:]:
        assert state["name"] == motion["joints"] and state["position"] == wanted, state
    placed = [t for t in lines(frames)[-1]["transforms"] if t["header"]["frame_id"] == "world"]
    assert len(placed) == 1 and placed[0]["translation"] == [1, 2, 3], placed
    out, _ = link.communicate(timeout=30)  # The end of its input ends it.
    assert link.returncode == 0 and json.loads(out.splitlines()[-1])["published"]["/joint_states"] >= 20, out[-500:]
    start = ",".join(f"{name}={q!r}" for name, q in zip(motion["joints"], wanted))
    robot = domain.peer("act", ACTION, "plain", 0, 60, start, "follow", output=subprocess.DEVNULL)
    link, heard, report = linked(domain, True), None, None
    while not (heard and report and report["heard_hz"] > 0):
        line = json.loads(link.stdout.readline())
        heard, report = line.get("heard", heard), line if "topics" in line else report
    robot.kill()
    robot.wait()
    link.communicate(timeout=30)
    topics = {topic["name"]: (topic["type"], topic["publishers"]) for topic in report["topics"]}
    assert heard == wanted and topics["/joint_states"] == ("sensor_msgs::msg::dds_::JointState_", 1), (heard, topics)
    assert topics[ACTION + "/_action/status"] == ("action_msgs::msg::dds_::GoalStatusArray_", 1), topics


def robots_are_heard(domain, folder):
    listen = domain.start("listen", "-o", folder / "heard.htraj", "--trajectory", folder / "sent.htraj", "--description", folder / "robot.urdf",
                          "--seconds", 100)
    # More than is asked for: a writer finds the listener earlier than the listener finds the writer.
    writers = [domain.peer("write", "rt/joint_states", "JointState", 300, 100), domain.peer("write", "rt/joint_trajectory", "JointTrajectory", 30, 10),
               domain.peer("write", "rt/robot_description", "String", 1, 1, "latched")]
    for writer in writers:
        assert first_line(writer)["written"] > 0
    time.sleep(TAKEN)
    report = interrupted(listen)
    for writer in writers:
        kill(writer)
    heard = json.loads((folder / "heard.htraj").read_text())
    assert heard["joints"] == ["A1", "A2", "A3", "A4", "A5", "A6"] and not heard["has_poses"]
    assert report["joint_states"] == len(heard["frames"]) >= 190, report
    first = round(heard["frames"][0][8] / 0.001)
    for k, frame in enumerate(heard["frames"]):
        assert abs(frame[0] - 0.01 * k) < 1e-6 and frame[8:] == [0.001 * (k + first), -0.5, 0.25, 0.0, -0.001 * (k + first), 1 / 3], frame
    sent = json.loads((folder / "sent.htraj").read_text())
    assert sent["joints"] == ["a", "b"] and [f[0] for f in sent["frames"]] == [0.25, 1.25, 2.25, 3.25]
    assert [f[8:] for f in sent["frames"]] == [[0.5 * k, -1.0 * k] for k in range(4)]
    assert (folder / "robot.urdf").read_text() == '<robot name="r"><link name="base"/></robot>\n'
    assert "no message" in answer(domain.start("listen", "-o", folder / "none.htraj", "--seconds", 1), 2)
    assert not (folder / "none.htraj").exists()


def a_robot_is_mirrored(domain, folder, motion):
    listen = domain.start("listen", "--workcell", CELL, "--entity", "robot", "--mirror", folder / "mirror.hcell", "--seconds", 100)
    last = motion["frames"][-1]
    moved, held = folder / "moved.htraj", folder / "held.htraj"
    moved.write_text(json.dumps({**part_of(motion, last[0] - 1.0, last[0]), "touches": []}))
    held.write_text(json.dumps({**motion, "frames": [[t, *last[1:]] for t in (0.0, 0.5)], "touches": []}))
    answer(domain.start("publish", "--workcell", CELL, "--motion", moved, "--seconds", 0, "--rate", 200))
    # It stays at the end, until that was heard for certain.
    publish = domain.start("publish", "--workcell", CELL, "--motion", held, "--seconds", 100, "--repeat", "--rate", 100)
    lines(domain.peer("read", "rt/joint_states", "JointState", 20, 60))
    time.sleep(TAKEN)
    interrupted(listen)
    interrupted(publish)
    cell = json.loads((folder / "mirror.hcell").read_text())
    joints = next(entity["joints"] for entity in cell["entities"] if entity["name"] == "robot")
    for name, wanted in zip(motion["joints"], last[8:8 + len(motion["joints"])]):
        assert abs(joints[name] - wanted) < 1e-3, (name, joints, last)


def objects_are_taken(domain, folder):
    listen = domain.start("listen", "--workcell", CELL, "--objects", "--mirror", folder / "with_objects.hcell", "--seconds", 100)
    crate = domain.peer("write", "rt/planning_scene", "PlanningScene", 1, 1, "latched")
    assert first_line(crate)["written"] == 1
    time.sleep(TAKEN)
    assert interrupted(listen)["objects"] == 1
    kill(crate)
    cell = json.loads((folder / "with_objects.hcell").read_text())
    crate = next(entity for entity in cell["entities"] if entity["name"] == "crate")
    assert "box:0.5,0.25,2" in json.dumps(crate) and len(cell["entities"]) == len(json.loads(CELL.read_text())["entities"]) + 1, crate
    inspected = json.loads(subprocess.run([CLI, "inspect", folder / "with_objects.hcell"], capture_output=True, text=True, check=True).stdout)
    found = next(entity for entity in inspected["entities"] if entity["name"] == "crate")
    for side, wanted in (("min", [0.0, -0.125, 0.5]), ("max", [0.5, 0.125, 2.5])):
        assert all(abs(a - b) < 1e-6 for a, b in zip(found["bounds"][side], wanted)), found


def peers_go_and_come(domain, folder):
    publish = domain.start("publish", "--workcell", CELL, "--motion", folder / "m.htraj", "--rate", 200, "--seconds", 100, "--repeat")
    gone = domain.peer("read", "rt/joint_states", "JointState", 100000, 60)
    first_line(gone)
    kill(gone)
    assert len(lines(domain.peer("read", "rt/joint_states", "JointState", 100, 60))) == 100
    assert interrupted(publish)["late_5ms"] >= 0
    # And the other way round: a reader hears the second publisher after the first was killed.
    reader = domain.peer("read", "rt/joint_states", "JointState", 100000, 60)
    for _ in range(2):
        began, count = time.time(), 0
        publish = domain.start("publish", "--workcell", CELL, "--rate", 100, "--seconds", 100)
        while count < 100:
            stamp = first_line(reader)["header"]
            count += stamp["sec"] + 1e-9 * stamp["nanosec"] > began
        os.killpg(publish.pid, signal.SIGKILL)
        publish.communicate()
    kill(reader)


def a_thousand_a_second_arrive(domain, folder):
    # Of the last ten that are kept, a reader on a busy machine misses some: nothing is asked for but order and some.
    with (folder / "states.txt").open("w") as output:  # More than a pipe holds.
        reader = domain.peer("read", "rt/joint_states", "JointState", 10**6, 100, output=output)
    report = answer(domain.start("publish", "--workcell", CELL, "--motion", folder / "m.htraj", "--rate", 1000, "--seconds", 5, "--repeat"))
    time.sleep(TAKEN)
    kill(reader)  # It printed every message.
    states = [json.loads(line) for line in (folder / "states.txt").read_text().splitlines()]
    stamps = [state["header"]["sec"] * 10**9 + state["header"]["nanosec"] for state in states]
    assert len(states) > 100 and stamps == sorted(set(stamps)), len(states)
    assert report["ticks"] == 5001 == report["published"]["/joint_states"]
    print("1 kHz:", len(states), "of", report["ticks"], "read;", report["late_5ms"], "ticks more than 5 ms late")


def main():
    hashes = type_hashes.check(ROOT)
    if not PEER:
        print("skipped: Fast DDS, fastddsgen or Java was not there when the tests were built")
        return 77
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        motion = motion_file(folder)
        domains = [Domain(number) for number in DOMAINS]
        watches = [domain.peer("watch", "-", "-", 0, 250) for domain in domains]

        def steps_of(domain, *steps):
            """One after another; what they mostly do is wait."""
            for step, *more in steps:
                began = time.monotonic()
                step(domain, *more)
                print(f"passed: {step.__name__}, {time.monotonic() - began:.1f} s", flush=True)
        lanes = (((motions_are_followed, folder, motion), (the_window_is_linked, motion)),
                 ((everything_arrives, folder, motion), (a_motion_is_sent, folder, motion), (contacts_are_marked, folder, motion),
                  (depth_is_marked, folder, motion)),
                 ((robots_are_heard, folder), (a_robot_is_mirrored, folder, motion), (objects_are_taken, folder), (peers_go_and_come, folder),
                  (a_thousand_a_second_arrive, folder)))
        with concurrent.futures.ThreadPoolExecutor() as pool:
            try:
                running = [pool.submit(steps_of, domain, *steps) for domain, steps in zip(domains, lanes)]
                for ended in concurrent.futures.as_completed(running):
                    ended.result()
                types_are_announced(watches, hashes)
            finally:
                end_children()
    return 0


sys.exit(main())
