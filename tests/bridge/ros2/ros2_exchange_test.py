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
import time
import xml.etree.ElementTree as ET

import type_hashes

CLI, ROOT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
PEER = sys.argv[3] if len(sys.argv) > 3 else None
CELL = ROOT / "config/workcells/demo.hcell"
DOMAIN = "87"  # Up to 98 others are taken below; those of other tests are in tests/support/ros2_domains.h.


def peer(*words, output=subprocess.PIPE):
    return subprocess.Popen([PEER, DOMAIN, *map(str, words)], stdout=output, text=True)


def lines(process, wanted=0):
    out, _ = process.communicate(timeout=120)
    assert wanted is None or process.returncode == wanted, (process.args, process.returncode, out[-500:])
    return [json.loads(line) for line in out.splitlines()]


def start(*words):
    return subprocess.Popen([CLI, "ros2", *map(str, words), "--domain", DOMAIN, "--this-machine"], stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, text=True)


def answer(process, status=0):
    out, err = process.communicate(timeout=120)
    assert process.returncode == status, (process.args, process.returncode, err)
    return json.loads(out) if status == 0 else err


def motion_file(folder):
    """A motion of the robot of the cell with forces, as its twin in CSV."""
    subprocess.run([CLI, "session", "--workcell", CELL, "--entity", "robot", "--hand", ROOT / "config/workcells/demo-hand.csv", "--record",
                    folder / "m.htraj"], check=True, capture_output=True)
    return json.loads((folder / "m.htraj").read_text())


def types_are_announced(watch, hashes):
    """The hashes of types in discovery, as another DDS sees them."""
    watch.kill()  # It printed every endpoint.
    out, _ = watch.communicate()
    seen = {}
    for endpoint in map(json.loads, out.splitlines()):
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


def marked(folder, cell, motion):
    """Messages of the contacts of a motion, by the time of the motion."""
    (folder / "part.htraj").write_text(json.dumps(motion))
    with (folder / "markers.txt").open("w") as output:  # More than a pipe holds.
        reader = peer("read", "rt/contact_markers", "MarkerArray", 10**6, 60, output=output)
    time.sleep(0.5)
    answer(start("publish", "--workcell", cell, "--motion", folder / "part.htraj", "--contacts", "--clock", "--seconds", 0.1))
    time.sleep(0.2)
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


def contacts_are_marked(folder, motion):
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
    for t, markers in marked(folder, CELL, whole):
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


def depth_is_marked(folder, motion):
    """The stop 5 mm nearer: the part, 1 mm off before, is 4 mm deep in it. The motion lists no contacts."""
    cell = json.loads(CELL.read_text())
    stop = next(entity for entity in cell["entities"] if entity["name"] == "Stop rail")
    stop["placement"]["position"][0] -= 0.005
    moved = folder / "config/workcells/stop.hcell"
    moved.parent.mkdir(parents=True)
    shutil.copytree(CELL.parent / "demo", moved.parent / "demo")
    (folder / "config/robots").symlink_to(ROOT / "config/robots")
    moved.write_text(json.dumps(cell))
    found = marked(folder, moved, {**part_of(motion, 3.6, 6.0), "touches": []})
    pressed = [marker for t, markers in found for marker in markers if 5.5 < t < 6.0 and marker["id"] == 1 and marker["action"] == 0]
    assert len(pressed) > 20
    for ball in pressed:
        assert ball["ns"] == "robot/housing_4711 / Stop rail" and abs(ball["scale"][0] - (0.010 + 2 * 0.004)) < 4e-4, ball


def everything_arrives(folder, motion):
    readers = {"joints": peer("read", "rt/joint_states", "JointState", 50, 30), "frames": peer("read", "rt/tf", "TFMessage", 50, 30),
               "moved": peer("read", "rt/moved/pose", "PoseStamped", 20, 30), "clock": peer("read", "rt/clock", "Clock", 20, 30),
               "force": peer("read", "rt/moved/wrench", "WrenchStamped", 20, 30)}
    time.sleep(1.0)
    publish = start("publish", "--workcell", CELL, "--motion", folder / "m.htraj", "--clock", "--rate", 100, "--seconds", 12, "--repeat",
                    "--contacts")
    time.sleep(4.0)
    # Who comes late gets what is latched.
    late = {"text": peer("read", "rt/robot_description", "String", 1, 20, "latched"),
            "fixed": peer("read", "rt/tf_static", "TFMessage", 1, 20, "latched"),
            "scene": peer("read", "rt/planning_scene", "PlanningScene", 1, 20, "latched")}
    got = {name: lines(process) for name, process in {**readers, **late}.items()}
    report = answer(publish)
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


def a_motion_is_sent(folder, motion):
    reader = peer("read", "rt/arm/joint_trajectory", "JointTrajectory", 1, 30)
    answer(start("publish", "--workcell", CELL, "--motion", folder / "m.htraj", "--trajectory", "/arm/joint_trajectory", "--seconds", 0.1,
                 "--wait", 20, "--rate", 10))
    message = lines(reader)[0]
    rows = motion["frames"]
    assert message["joint_names"] == motion["joints"] and len(message["points"]) == len(rows)
    for row, point in zip(rows, message["points"]):
        assert point["positions"] == row[8:8 + len(motion["joints"])]
        assert abs(point["sec"] + 1e-9 * point["nanosec"] - (row[0] - rows[0][0])) < 1e-8
    assert set(message["points"][0]["velocities"]) == {0} and set(message["points"][-1]["velocities"]) == {0}
    assert "no reader" in answer(start("publish", "--workcell", CELL, "--motion", folder / "m.htraj", "--trajectory", "/nobody", "--wait", 1), 2)


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
    return subprocess.Popen([CLI, "ros2", "send", "--workcell", folder / "arm.hcell", "--motion", folder / "small.htraj", "--action", ACTION, "--domain", domain,
                             "--this-machine", "--wait", str(wait), *(("--confirm", confirm) if confirm else ()), *more], stdin=subprocess.DEVNULL,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True)


def sent_once(folder, domain, form, behaviour, start, *more, interrupt=False):
    """Exit status, result, sentence and what the controller saw."""
    controller = subprocess.Popen([PEER, domain, "act", ACTION, form, "0", "60", start, behaviour], stdout=subprocess.PIPE, text=True)
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


def motions_are_followed(folder, motion):
    rows = small_motion(folder, motion)
    start = ",".join(f"{name}={q!r}" for name, q in zip(motion["joints"], rows[0][8:]))
    preview = sending(folder, DOMAIN, confirm=None)
    out, err = preview.communicate(timeout=120)
    shown = json.loads(out)
    assert preview.returncode == 0 and not shown["sent"] and "Nothing was sent" in err and "'robot' moves for" in err, err
    assert shown["tool_speed"] <= 0.25 < shown["tool_speed"] * shown["slowed"] and abs(shown["duration"] - 0.4 * shown["slowed"]) < 1e-6, shown
    with concurrent.futures.ThreadPoolExecutor() as pool:
        def run(domain, form, behaviour, *more, joints=start, **options):
            return pool.submit(sent, folder, str(domain), form, behaviour, joints, *more, **options)
        followed = {"plain": run(DOMAIN, "plain", "follow"), "numbered": run(88, "numbered", "noise"), "noise": run(89, "plain", "noise")}
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


def linked(mirror):
    """The link as the window starts it, with JSON lines in both directions."""
    job = {"do": "link", "domain": int(DOMAIN), "this_machine": True, "workcell": str(CELL), "entity": "robot", "mirror": mirror}
    return subprocess.Popen([CLI.with_name("hapticell-ros2"), json.dumps(job)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)


def the_window_is_linked(motion):
    wanted = [0.1 * k for k in range(len(motion["joints"]))]
    link = linked(False)
    link.stdin.write("no JSON\n" + json.dumps({"joints": wanted[1:]}) + "\n" + json.dumps({"joints": wanted, "place": [1, 2, 3, 1, 0, 0, 0]}) + "\n")
    link.stdin.flush()
    states, frames = peer("read", "rt/joint_states", "JointState", 20, 30), peer("read", "rt/tf", "TFMessage", 20, 30)
    for state in lines(states)[-5:]:
        assert state["name"] == motion["joints"] and state["position"] == wanted, state
    placed = [t for t in lines(frames)[-1]["transforms"] if t["header"]["frame_id"] == "world"]
    assert len(placed) == 1 and placed[0]["translation"] == [1, 2, 3], placed
    out, _ = link.communicate(timeout=30)  # The end of its input ends it.
    assert link.returncode == 0 and json.loads(out.splitlines()[-1])["published"]["/joint_states"] >= 20, out[-500:]
    start = ",".join(f"{name}={q!r}" for name, q in zip(motion["joints"], wanted))
    robot = subprocess.Popen([PEER, DOMAIN, "act", ACTION, "plain", "0", "60", start, "follow"], stdout=subprocess.DEVNULL)
    link, heard, report = linked(True), None, None
    while not (heard and report and report["heard_hz"] > 0):
        line = json.loads(link.stdout.readline())
        heard, report = line.get("heard", heard), line if "topics" in line else report
    robot.kill()
    robot.wait()
    link.communicate(timeout=30)
    topics = {topic["name"]: (topic["type"], topic["publishers"]) for topic in report["topics"]}
    assert heard == wanted and topics["/joint_states"] == ("sensor_msgs::msg::dds_::JointState_", 1), (heard, topics)
    assert topics[ACTION + "/_action/status"] == ("action_msgs::msg::dds_::GoalStatusArray_", 1), topics


def robots_are_heard(folder):
    listen = start("listen", "-o", folder / "heard.htraj", "--trajectory", folder / "sent.htraj", "--description", folder / "robot.urdf",
                   "--seconds", 9)
    time.sleep(0.5)
    writers = [peer("write", "rt/joint_states", "JointState", 200, 100), peer("write", "rt/joint_trajectory", "JointTrajectory", 1, 1),
               peer("write", "rt/robot_description", "String", 1, 1, "latched")]
    report = answer(listen)
    for writer in writers:
        lines(writer)
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
    assert "no message" in answer(start("listen", "-o", folder / "none.htraj", "--seconds", 1), 2)
    assert not (folder / "none.htraj").exists()


def a_robot_is_mirrored(folder, motion):
    listen = start("listen", "--workcell", CELL, "--entity", "robot", "--mirror", folder / "mirror.hcell", "--seconds", 6)
    publish = start("publish", "--workcell", CELL, "--motion", folder / "m.htraj", "--seconds", 0, "--rate", 200)
    answer(publish)
    answer(listen)
    cell = json.loads((folder / "mirror.hcell").read_text())
    robot = next(entity for entity in cell["entities"] if entity["name"] == "robot")
    last = motion["frames"][-1][8:8 + len(motion["joints"])]
    duration = motion["frames"][-1][0] - motion["frames"][0][0]
    if duration < 5.0:
        assert all(abs(a - b) < 1e-3 for a, b in zip(robot["joints"], last)), (robot["joints"], last)


def objects_are_taken(folder):
    listen = start("listen", "--workcell", CELL, "--objects", "--mirror", folder / "with_objects.hcell", "--seconds", 6)
    lines(peer("write", "rt/planning_scene", "PlanningScene", 1, 1, "latched"))
    assert answer(listen)["objects"] == 1
    cell = json.loads((folder / "with_objects.hcell").read_text())
    crate = next(entity for entity in cell["entities"] if entity["name"] == "crate")
    assert "box:0.5,0.25,2" in json.dumps(crate) and len(cell["entities"]) == len(json.loads(CELL.read_text())["entities"]) + 1, crate
    inspected = json.loads(subprocess.run([CLI, "inspect", folder / "with_objects.hcell"], capture_output=True, text=True, check=True).stdout)
    found = next(entity for entity in inspected["entities"] if entity["name"] == "crate")
    for side, wanted in (("min", [0.0, -0.125, 0.5]), ("max", [0.5, 0.125, 2.5])):
        assert all(abs(a - b) < 1e-6 for a, b in zip(found["bounds"][side], wanted)), found


def peers_go_and_come(folder):
    publish = start("publish", "--workcell", CELL, "--motion", folder / "m.htraj", "--rate", 200, "--seconds", 14, "--repeat")
    first = peer("read", "rt/joint_states", "JointState", 100000, 60)
    time.sleep(4.0)
    first.kill()  # Without a farewell.
    first.communicate()
    again = lines(peer("read", "rt/joint_states", "JointState", 100, 20))
    assert len(again) == 100
    assert answer(publish)["late_5ms"] >= 0
    # And the other way round: a reader hears the second publisher after the first was killed.
    reader = peer("read", "rt/joint_states", "JointState", 400, 40)
    for _ in range(2):
        publish = start("publish", "--workcell", CELL, "--rate", 100, "--seconds", 30)
        time.sleep(5.0)
        publish.kill()
        publish.communicate()
    assert len(lines(reader)) == 400


def a_thousand_a_second_arrive(folder):
    # Of the last ten that are kept, a reader on a busy machine misses some: nothing is asked for but order and some.
    reader = peer("read", "rt/joint_states", "JointState", 10**6, 20)
    time.sleep(1.0)
    report = answer(start("publish", "--workcell", CELL, "--motion", folder / "m.htraj", "--rate", 1000, "--seconds", 8, "--repeat"))
    states = lines(reader, None)
    stamps = [state["header"]["sec"] * 10**9 + state["header"]["nanosec"] for state in states]
    assert len(states) > 100 and stamps == sorted(set(stamps)), len(states)
    assert report["ticks"] == 8001 == report["published"]["/joint_states"]
    print("1 kHz:", len(states), "of", report["ticks"], "read;", report["late_5ms"], "ticks more than 5 ms late")


def main():
    hashes = type_hashes.check(ROOT)
    if not PEER:
        print("skipped: Fast DDS, fastddsgen or Java was not there when the tests were built")
        return 77
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        motion = motion_file(folder)
        watch = peer("watch", "-", "-", 0, 250)
        for step in (lambda: everything_arrives(folder, motion), lambda: a_motion_is_sent(folder, motion),
                     lambda: motions_are_followed(folder, motion), lambda: the_window_is_linked(motion), lambda: robots_are_heard(folder),
                     lambda: a_robot_is_mirrored(folder, motion), lambda: objects_are_taken(folder),
                     lambda: types_are_announced(watch, hashes), lambda: contacts_are_marked(folder, motion),
                     lambda: depth_is_marked(folder, motion), lambda: peers_go_and_come(folder), lambda: a_thousand_a_second_arrive(folder)):
            step()
            print("passed", flush=True)
    return 0


sys.exit(main())
