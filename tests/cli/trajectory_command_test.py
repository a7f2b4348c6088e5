#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The command `trajectory`, on motions made here.

usage: trajectory_command_test.py HAPTICELL_CLI [NAME_PART]
"""
import json
import math
import pathlib
import re
import sys

import program_readers as readers
from command_line_test import box, main, write_binary_stl

ROOT = pathlib.Path(__file__).resolve().parents[2]



def write_motion(path, seconds=6.0, rate=100, tremor=0.0003):
    """A sweep along x with a hand's tremor across it."""
    rows = ["t,x,y,z,qw,qx,qy,qz"]
    for i in range(int(seconds * rate) + 1):
        t = i / rate
        y = 0.1 * math.sin(t) + tremor * math.sin(2 * math.pi * 9 * t)
        half = 0.2 * math.sin(0.5 * t)
        rows.append(",".join(repr(v) for v in (t, 0.1 * t - 0.3, y, 0.5, math.cos(half), 0.0, 0.0, math.sin(half))))
    path.write_text("\n".join(rows) + "\n")


def test_info(case):
    write_motion(case.folder / "a.csv")
    info = case.run("trajectory", "info", "a.csv")
    assert info["frames"] == 601 and abs(info["duration"] - 6) < 1e-12, info
    assert info["length"] > 0.6 and 0.0001 < info["tremor"]["position"] < 0.0004, info


def test_smooth_then_simplify_then_retime(case):
    write_motion(case.folder / "a.csv")
    smooth = case.run("trajectory", "smooth", "a.csv", "-o", "b.htraj")
    assert smooth["max_deviation"]["position"] <= 1e-3 and smooth["rms_jerk_after"] < smooth["rms_jerk_before"] / 10, smooth
    few = case.run("trajectory", "simplify", "b.htraj", "--tolerance", "0.001", "-o", "c.csv")
    assert few["frames_after"] < 60 and few["max_deviation"]["position"] <= 1.001e-3, few
    timed = case.run("trajectory", "retime", "b.htraj", "--velocity", "0.2", "--acceleration", "1", "-o", "d.htraj")
    assert timed["duration_after"] < 6 and timed["limit_use"]["velocity"] < 1.001, timed
    frames = json.loads((case.folder / "d.htraj").read_text())["frames"]
    fastest = max(abs(b[1] - a[1]) / (b[0] - a[0]) for a, b in zip(frames, frames[1:]))
    assert 0.15 < fastest < 0.2 * 1.01, fastest


def test_constant_speed(case):
    write_motion(case.folder / "a.csv", tremor=0.0)
    timed = case.run("trajectory", "retime", "a.csv", "--mode", "constant-speed", "--speed", "0.05", "-o", "d.csv")
    assert timed["duration_after"] > 12, timed


def test_export_to_every_format(case):
    write_motion(case.folder / "a.csv")
    case.run("trajectory", "simplify", "a.csv", "-o", "few.htraj")
    expected = {"csv": ["p.csv"], "json": ["p.json"], "krl": ["p.src", "p.dat"], "rapid": ["p.mod"], "fanuc": ["p.LS"],
                "urscript": ["p.script"]}
    for name, files in expected.items():
        done = case.run("trajectory", "export", "few.htraj", "--to", name, "-o", files[0])
        assert done["files"] == files, done
        assert all((case.folder / file).stat().st_size > 100 for file in files)
    folder = case.run("trajectory", "export", "few.htraj", "--to", "val3", "-o", "weld")
    assert len(folder["files"]) == 4 and (case.folder / "weld" / "start.pgx").exists(), folder
    case.run("trajectory", "export", "few.htraj", "--to", "inform", "-o", "p.jbi")
    assert (case.folder / "p.jbi").read_text().startswith("/JOB\n//NAME P\n"), (case.folder / "p.jbi").read_text()[:80]
    message = case.run("trajectory", "export", "few.htraj", "--to", "ros", "-o", "p.yaml", expect=2)
    assert "joints" in message and not (case.folder / "p.yaml").exists()
    assert "krl" in case.run("trajectory", "export", "few.htraj", "--to", "basic", "-o", "p.x", expect=2)


def test_programs_know_their_language(case):
    """Names, all axes' speeds, and numbers that a language cannot hold: refused, nothing written."""
    write_motion(case.folder / "a.csv", seconds=0.5, rate=10)
    export = lambda *words, **more: case.run("trajectory", "export", "a.csv", *words, **more)
    export("--to", "krl", "-o", "p.src")
    axes = dict(re.findall(r"\$VEL_AXIS\[(\d)\] = (\d+)", (case.folder / "p.src").read_text()))
    assert axes == {str(i): "20" for i in range(1, 7)}, axes
    for word in ("loop", "circ", "return", "default", "ptp"):
        done = export("--to", "krl", "--name", word, "-o", "p.src")
        name = re.search(r"DEF (\w+)\(", (case.folder / "p.src").read_text()).group(1)
        assert name == "p_" + word and any(name in note for note in done["notes"]), done
    for given, name in (("test", "p_test"), ("Étape 2", "Etape_2")):
        export("--to", "rapid", "--name", given, "-o", "p.mod")
        assert (case.folder / "p.mod").read_text().startswith("MODULE %s\n" % name)
    refused = [("fanuc", "--speed", "5"), ("fanuc", "--speed", "0.0004"), ("krl", "--speed", "0.00004"), ("krl", "--joint-speed", "0.004"),
               ("inform", "--speed", "2"), ("urscript", "--speed", "1e-7"), ("val3", "--blend", "1e-7"), ("rapid", "--speed", "nan"),
               ("fanuc", "--tool", "tGrip")]
    for words in refused:
        message = export("--to", *words, "-o", "none.x", expect=2)
        assert words[1].strip("-").replace("-", " ") in message, message
        assert not list(case.folder.glob("none*")), words
    rows = (case.folder / "a.csv").read_text().splitlines()
    (case.folder / "d.csv").write_text("\n".join([rows[0] + ",dwell"] + [r + (",0.004" if i == 2 else ",0") for i, r in enumerate(rows[1:])]))
    assert "dwell" in case.run("trajectory", "export", "d.csv", "--to", "fanuc", "-o", "none.ls", expect=2)
    assert not (case.folder / "none.ls").exists()


def test_programs_are_opened_again(case):
    """Each language that is read gives the same poses back; a stranger's program too."""
    write_motion(case.folder / "a.csv", seconds=2.0, rate=20)
    given = [[float(n) for n in row.split(",")] for row in (case.folder / "a.csv").read_text().splitlines()[1:]]
    for name, file in (("krl", "p.src"), ("rapid", "p.mod"), ("fanuc", "p.ls"), ("urscript", "p.script")):
        done = case.run("trajectory", "export", "a.csv", "--to", name, "-o", file)
        assert done["measured"]["position"] <= done["promised"]["position"] == 1e-6, done
        info = case.run("trajectory", "info", file)
        assert info["frames"] == len(given) and info["moved"] == "tcp" and info["notes"], info
        case.run("trajectory", "export", file, "--to", "csv", "-o", "again.csv")
        again = [[float(n) for n in row.split(",")] for row in (case.folder / "again.csv").read_text().splitlines()[1:]]
        for one, other in zip(again, given):
            assert math.dist(one[1:4], other[1:4]) < 1e-6, (name, one, other)
            assert readers.angle_between(readers.of_quaternion(*one[4:8]), readers.of_quaternion(*other[4:8])) < 1e-4, name
    (case.folder / "joints.script").write_text("def home():\n  movej([0, -1.5, 1.5, 0, 1.0, 0], a=1.4, v=1.05)\nend\n")
    message = case.run("trajectory", "info", "joints.script", expect=2)
    assert "--robot" in message and "line 2" in message, message
    info = case.run("trajectory", "info", "joints.script", "--robot", "library:hc6")
    (case.folder / "q.csv").write_text(",".join(info["joints"]) + "\n0,-1.5,1.5,0,1.0,0\n")
    pose = case.run("fk", "--robot", "library:hc6", "--joints", "q.csv")["poses"][0]
    assert math.dist(info["bounds"]["min"], [pose[axis] for axis in "xyz"]) < 1e-12, (info, pose)


def test_check_against_a_wall(case):
    write_motion(case.folder / "a.csv")
    write_binary_stl(case.folder / "part.stl", box((0.02, 0.02, 0.02)))
    write_binary_stl(case.folder / "wall.stl", box((0.001, 1, 1), (0.0, 0, 0.5)))
    case.run("workcell", "new", "cell.hcell", "--add", "part.stl,name=part,unit=m", "--add", "wall.stl,name=wall,unit=m")
    found = case.run("trajectory", "check", "a.csv", "--workcell", "cell.hcell", "--entity", "part", "--fail-on-contact", expect=1)
    first = found["findings"][0]
    assert first["kind"] == "collision" and first["pair"] == ["part", "wall"] and not found["free"], found
    # The part's front, 10 mm before its origin, reaches the wall's face at -0.5 mm; it is turned a little.
    assert 2.85 < first["t_in"] < 2.92, first
    message = case.run("trajectory", "check", "a.csv", "--workcell", "cell.hcell", "--entity", "none", expect=2)
    assert "none" in message


def test_check_of_a_robot_that_carries_a_part(case):
    """A gripper on the flange, a part on the gripper: both are checked, and never against what they hang on."""
    joints = [[0.05 * i, 0.0, 0.0, 0.0, 0.0, 0.0] for i in range(11)]
    (case.folder / "q.csv").write_text("\n".join(["A1,A2,A3,A4,A5,A6"] + [",".join(map(repr, q)) for q in joints]) + "\n")
    poses = case.run("fk", "--robot", "library:kuka_kr6_r900", "--joints", "q.csv", "--tip", "tool0")["poses"]
    poses = [[pose[k] for k in ("x", "y", "z", "qw", "qx", "qy", "qz")] for pose in poses]
    rows = ["t,x,y,z,qw,qx,qy,qz,q1,q2,q3,q4,q5,q6"]
    rows += [",".join(map(repr, [0.1 * i] + list(pose) + q)) for i, (pose, q) in enumerate(zip(poses, joints))]
    (case.folder / "m.csv").write_text("\n".join(rows) + "\n")
    # A post where the part's middle comes, 0.3 m before the flange, when A1 is at 0.3 rad.
    x, y, z, *turn = poses[6]
    ahead = [row[2] for row in readers.of_quaternion(*turn)]
    post = [x + 0.3 * ahead[0], y + 0.3 * ahead[1], z + 0.3 * ahead[2]]
    write_binary_stl(case.folder / "part.stl", box((0.08, 0.08, 0.08)))
    write_binary_stl(case.folder / "post.stl", box((0.01, 0.01, 0.5)))
    case.run("workcell", "new", "cell.hcell", "--add", "library:kuka_kr6_r900,name=robot",
             "--add", "part.stl,name=gripper,unit=m", "--add", "part.stl,name=part,unit=m",
             "--add", "post.stl,name=post,unit=m,pose=%r,%r,%r,1,0,0,0" % tuple(post))
    cell = json.loads((case.folder / "cell.hcell").read_text())
    robot, gripper, part = cell["entities"][:3]
    robot["tip_link"] = "tool0"
    at = {"position": [0.0, 0.0, 0.0], "quaternion": [1.0, 0.0, 0.0, 0.0]}
    gripper["attached"] = {"to": "robot", "link": "tool0", "placement": {**at, "position": [0.0, 0.0, 0.03]}}
    part["attached"] = {"to": "gripper", "link": "", "placement": {**at, "position": [0.0, 0.0, 0.27]}}
    (case.folder / "cell.hcell").write_text(json.dumps(cell))
    found = case.run("trajectory", "check", "m.csv", "--workcell", "cell.hcell", "--entity", "robot", "--fail-on-contact",
                     expect=1)
    assert [f["pair"] for f in found["findings"] if f["kind"] == "collision"] == [["part", "post"]], found
    assert not found["touching_at_start"], found  # The gripper reaches 10 mm into the last link, which carries it.
    hit = [f for f in found["findings"] if f["kind"] == "collision"][0]
    reach = math.hypot(post[0], post[1])
    # Its side, 40 mm from its middle, meets the post's, some 5 mm from its own, on a circle of that reach.
    assert abs(hit["t_in"] - (0.6 - 0.045 / reach / 0.5)) < 0.01, (hit, reach)
    cell["entities"].pop()
    (case.folder / "cell.hcell").write_text(json.dumps(cell))
    free = case.run("trajectory", "check", "m.csv", "--workcell", "cell.hcell", "--entity", "robot", "--fail-on-contact")
    assert free["free"] and free["least_clearance"] is None, free


def test_a_session_is_recorded_cleaned_checked_and_exported(case):
    demo = ROOT / "config" / "workcells"
    session = case.run("session", "--workcell", demo / "demo.hcell", "--entity", "robot", "--hand", demo / "demo-hand.csv",
                       "--rate-manipulation", "100", "--record", "rec.htraj", timeout=200)
    assert session["penetration"]["max_m"] <= 1e-4
    recorded = json.loads((case.folder / "rec.htraj").read_text())
    assert recorded["entity"] == "robot" and recorded["moved"] == "tcp" and len(recorded["joints"]) == 6
    assert len(recorded["frames"]) > 300, len(recorded["frames"])
    case.run("trajectory", "smooth", "rec.htraj", "-o", "smooth.htraj")
    found = case.run("trajectory", "check", "rec.htraj", "--workcell", demo / "demo.hcell", timeout=120)
    assert found["free"] and found["within_limits"], found["findings"][:5]
    timed = case.run("trajectory", "retime", "smooth.htraj", "--robot", "library:hc6", "--workcell", demo / "demo.hcell",
                     "-o", "fast.htraj", timeout=120)
    assert timed["limit_use"]["velocity"] <= 1.001 and timed["max_deviation"]["position"] < 1e-4, timed
    assert not timed["kept_free"]["findings"], timed["kept_free"]
    # The smoothed joints count, as its poses were smoothed apart from them; the tool passes where they bring it.
    assert "missed" not in timed and timed["measured"]["position"] <= 5e-5, timed["measured"]
    assert timed["measured"]["pose_by_joints"] <= 1e-6, timed["measured"]
    ros = case.run("trajectory", "export", "fast.htraj", "--to", "ros", "-o", "p.yaml")
    again = case.run("trajectory", "info", "p.yaml")
    assert again["frames"] == ros["frames"] and again["joints"] == recorded["joints"]
    for name in ("krl", "rapid", "fanuc", "urscript", "val3"):
        done = case.run("trajectory", "export", "fast.htraj", "--to", name, "--robot", "library:hc6", "-o", "prog." + name)
        assert done["measured"]["position"] <= done["promised"]["position"] == 1e-6, (name, done["measured"])
    read_back(case, json.loads((case.folder / "fast.htraj").read_text()), demo / "demo.hcell")


def read_back(case, motion, cell):
    """Every target of every program, and where the arm comes by its joints, within 1 um and 1e-4 deg."""
    frames = [(f[1:4], readers.of_quaternion(*f[4:8])) for f in motion["frames"]]
    (case.folder / "joints.csv").write_text("\n".join(
        [",".join(motion["joints"])] + [",".join(repr(v) for v in f[8:14]) for f in motion["frames"]]))
    robot = next(e for e in json.loads(cell.read_text())["entities"] if e["name"] == "robot")
    base = robot["placement"]["position"]
    assert robot["placement"]["quaternion"] == [1, 0, 0, 0] and robot["tool"]["position"] == [0, 0, 0]

    def reached(joints_file):
        poses = case.run("fk", "--robot", "library:hc6", "--joints", joints_file)["poses"]
        return [([b + p[axis] for b, axis in zip(base, "xyz")],
                 readers.of_quaternion(*(p[part] for part in ("qw", "qx", "qy", "qz")))) for p in poses]

    def same(ones, others, what):
        assert len(ones) == len(others), (what, len(ones), len(others))
        for i, (one, other) in enumerate(zip(ones, others)):
            assert math.dist(one[0], other[0]) < 1e-6, (what, i, one, other)
            assert readers.angle_between(one[1], other[1]) < 1e-4, (what, i, one, other)

    same(reached("joints.csv"), frames, "forward kinematics of the frames")
    text = lambda name: (case.folder / name).read_text()
    programs = {
        "krl": (readers.read_krl(case.folder, "prog"), text("prog.src"), r"PTP \{([^}]*)\}"),
        "rapid": (readers.read_rapid(case.folder, "prog.rapid"), text("prog.rapid"), r"MoveAbsJ \[\[([^\]]*)\]"),
        "fanuc": (readers.read_fanuc(case.folder, "prog.fanuc"), None, None),
        "urscript": (readers.read_urscript(case.folder, "prog.urscript"), text("prog.urscript"), r"movej\(\[([^\]]*)\]"),
    }
    for name, (targets, program, first) in programs.items():
        same(targets, frames[len(frames) - len(targets):], name)  # the first move may be one of joints only
        assert len(targets) >= len(frames) - 1, name
        if first:
            found = readers.numbers(re.sub(r"\bA\d ", "", re.search(first, program).group(1)))
            joints = found if name == "urscript" else [math.radians(v) for v in found]
            (case.folder / "first.csv").write_text(",".join(motion["joints"]) + "\n" + ",".join(map(repr, joints)) + "\n")
            same(reached("first.csv"), frames[:1], name + ", first move")
    targets, start = readers.read_val3(next(case.folder.rglob("*.dtx")).parent)
    assert len(targets) == len(frames) - 1, len(targets)
    same(targets, frames[1:], "val3")
    (case.folder / "first.csv").write_text(",".join(motion["joints"]) + "\n" + ",".join(repr(math.radians(v)) for v in start) + "\n")
    same(reached("first.csv"), frames[:1], "val3, first move")


def frames_of(case, name):
    return json.loads((case.folder / name).read_text())["frames"]


def test_edits_are_copies(case):
    write_motion(case.folder / "a.csv", rate=50)
    before = (case.folder / "a.csv").read_bytes()
    part = case.run("trajectory", "trim", "a.csv", "--from", "1", "--to", "3", "-o", "b.htraj")
    assert abs(part["motions"][0]["duration"] - 2) < 1e-9 and frames_of(case, "b.htraj")[0][0] == 0, part
    halves = case.run("trajectory", "split", "a.csv", "--at", "2.5", "-o", "c.htraj", "--rest", "d.htraj")
    assert abs(sum(m["duration"] for m in halves["motions"]) - 6) < 1e-9, halves
    whole = case.run("trajectory", "join", "c.htraj", "--with", "d.htraj", "-o", "e.htraj")
    assert abs(whole["motions"][0]["duration"] - 6.001) < 1e-9, whole
    case.run("trajectory", "reverse", "a.csv", "-o", "f.htraj")
    assert abs(frames_of(case, "f.htraj")[0][1] - 0.3) < 1e-12
    case.run("trajectory", "mirror", "a.csv", "--plane", "x", "--offset", "0.5", "-o", "g.htraj")
    assert abs(frames_of(case, "g.htraj")[0][1] - 1.3) < 1e-12
    case.run("trajectory", "move", "a.csv", "--frame", "100", "--pose", "0,0,0.6,1,0,0,0", "--reach", "0.5", "-o", "h.htraj")
    moved = frames_of(case, "h.htraj")
    assert moved[100][1:4] == [0, 0, 0.6] and abs(moved[126][3] - 0.5) < 1e-12 and moved[110][3] > 0.5
    case.run("trajectory", "insert", "a.csv", "--at", "1.005", "-o", "i.htraj")
    assert len(frames_of(case, "i.htraj")) == 302
    case.run("trajectory", "delete", "a.csv", "--first", "10", "--last", "19", "-o", "j.htraj")
    assert len(frames_of(case, "j.htraj")) == 291
    case.run("trajectory", "dwell", "a.csv", "--frame", "150", "--seconds", "2", "-o", "k.htraj")
    timed = case.run("trajectory", "retime", "k.htraj", "--velocity", "1", "--acceleration", "20", "-o", "l.htraj")
    assert timed["duration_after"] > 2, timed
    longer = case.run("trajectory", "approach", "a.csv", "--length", "0.1", "--speed", "0.05", "-o", "m.htraj")
    assert abs(longer["motions"][0]["duration"] - 8) < 1e-9
    even = case.run("trajectory", "resample", "a.csv", "--step", "0.5", "-o", "n.csv")
    assert even["motions"][0]["frames"] == 13, even
    assert (case.folder / "a.csv").read_bytes() == before
    for words in (("trim", "--from", "9"), ("split", "--at", "99"), ("mirror", "--plane", "w"),
                  ("move", "--frame", "1", "--pose", "1,2,3"), ("delete", "--first", "5", "--last", "900")):
        case.run("trajectory", words[0], "a.csv", *words[1:], "-o", "z.csv", expect=2)
    assert not (case.folder / "z.csv").exists()


def test_points_are_named_and_reordered(case):
    rows = ["t,x,y,z,qw,qx,qy,qz,by_hand"] + [f"{i},{0.1 * i},0,0,1,0,0,0,1" for i in range(4)]
    (case.folder / "p.csv").write_text("\n".join(rows) + "\n")
    case.run("trajectory", "name", "p.csv", "--frame", "3", "--name", "drop", "-o", "named.htraj")
    case.run("trajectory", "reorder", "named.htraj", "--frame", "3", "--to", "1", "-o", "other.htraj")
    other = json.loads((case.folder / "other.htraj").read_text())
    assert other["names"] == [[1, "drop"]], other
    assert [round(f[1], 9) for f in other["frames"]] == [0, 0.3, 0.1, 0.2], other
    assert [round(f[0], 9) for f in other["frames"]] == [0, 3, 5, 6], other
    info = case.run("trajectory", "info", "other.htraj")
    assert info["points"] == [{"frame": 1, "name": "drop"}], info
    wrong = case.run("trajectory", "reorder", "named.htraj", "--frame", "9", "--to", "0", "-o", "x.htraj", expect=2)
    assert "frame 9" in wrong and not (case.folder / "x.htraj").exists(), wrong


def test_a_robots_joints_are_found_again(case):
    joints = [[0.1 + 0.01 * i, -1.2, 1.4, -1.5 + 0.01 * i, -1.5, 0.3] for i in range(30)]
    (case.folder / "q.csv").write_text("shoulder_pan_joint,shoulder_lift_joint,elbow_joint,wrist_1_joint,wrist_2_joint,wrist_3_joint\n" +
                                       "\n".join(",".join(repr(v) for v in row) for row in joints) + "\n")
    case.run("workcell", "new", "cell.hcell", "--add", "library:ur5e,name=robot")
    names = [j["name"] for j in case.run("inspect", "cell.hcell")["entities"][0]["joints"]]
    (case.folder / "q.csv").write_text(",".join(names) + "\n" + "\n".join(",".join(repr(v) for v in row) for row in joints) + "\n")
    poses = case.run("fk", "--robot", "library:ur5e", "--joints", "q.csv")["poses"]
    frames = []
    for i, (pose, row) in enumerate(zip(poses, joints)):
        frames.append([0.05 * i, *(pose[k] for k in ("x", "y", "z", "qw", "qx", "qy", "qz")), *row])
    (case.folder / "r.htraj").write_text(json.dumps({"format": "hapticell-trajectory", "version": 1, "entity": "robot",
                                                     "moved": "tcp", "joints": names, "frames": frames}))
    lost = case.run("trajectory", "approach", "r.htraj", "--length", "0.03", "-o", "s.htraj")
    assert lost["motions"][0]["joints"] == 0 and "--workcell" in lost["notes"][0], lost
    found = case.run("trajectory", "approach", "r.htraj", "--length", "0.03", "--workcell", "cell.hcell", "-o", "s.htraj")
    assert found["motions"][0]["joints"] == 6 and found["off_pose"]["position"] < 1e-6, found
    again = frames_of(case, "s.htraj")
    assert max(abs(a - b) for a, b in zip(again[1][8:], joints[0])) < 1e-5, (again[1][8:], joints[0])


def test_curves_and_score(case):
    write_motion(case.folder / "a.csv", tremor=0.0)
    curves = case.run("trajectory", "curves", "a.csv", "--samples", "500", "-o", "curves.csv")
    assert abs(curves["peaks"]["y"]["speed"] - 0.1) < 2e-3 and curves["samples"] == 500, curves
    assert (case.folder / "curves.csv").read_text().startswith("t,x,x_speed")
    write_motion(case.folder / "shaky.csv", tremor=0.002)
    best, worse = (case.run("trajectory", "score", "a.csv", "--run", name) for name in ("a.csv", "shaky.csv"))
    assert best["points"] > 99 and best["completed"] == 1 and worse["points"] < best["points"] - 3, (best, worse)


def test_training_fades_its_help(case):
    folder = ROOT / "config" / "exercises"
    assert len(case.run("trajectory", "exercises", folder)["exercises"]) == 4
    helps = []
    for _ in range(2):
        run = case.run("trajectory", "train", folder / "peg_in_hole.hexercise", "--hand", folder / "peg_in_hole-hand.csv",
                       "--trainee", "Ana", "--results", "ana.htrain", "--csv", "ana.csv", "-o", "run.htraj", timeout=120)
        assert run["success"] and run["score"]["completed"] == 1, run
        helps.append(run["help"])
    assert helps == [1.0, 0.8], helps
    kept = json.loads((case.folder / "ana.htrain").read_text())
    assert kept["trainee"] == "Ana" and len(kept["attempts"]) == 2
    assert len((case.folder / "ana.csv").read_text().splitlines()) == 3
    train = ("trajectory", "train", folder / "peg_in_hole.hexercise", "--hand", folder / "peg_in_hole-hand.csv")
    test = case.run(*train, "--results", "ana.htrain", "--csv", "ana.csv", "--kind", "retention", "--date",
                    "1970-01-02T00:00:00Z", timeout=120)
    assert test["kind"] == "retention" and test["help"] == 0 and abs(test["next_help"] - 0.6) < 1e-9, test
    assert (case.folder / "ana.csv").read_text().splitlines()[-1].endswith(",retention,86400")
    assert json.loads((case.folder / "ana.htrain").read_text())["attempts"][2]["kind"] == "retention"
    refused = case.run(*train, "--results", "ana.htrain", "--kind", "transfer", expect=2)
    assert "practised" in refused, refused


def test_smoothing_keeps_free_in_the_cell(case):
    write_binary_stl(case.folder / "block.stl", box((0.2, 0.2, 0.2)))
    write_binary_stl(case.folder / "part.stl", box((0.02, 0.02, 0.02)))
    case.run("workcell", "new", "cell.hcell", "--add", "block.stl,name=block,unit=m", "--add",
             "part.stl,name=part,unit=m,pose=-0.2,-0.1115,0,1,0,0,0")
    rows = ["t,x,y,z,qw,qx,qy,qz"]
    for i in range(201):
        s = 0.0025 * i
        x, y = (-0.2 + s, -0.1115) if s < 0.3115 else (0.1115, -0.1115 + s - 0.3115)
        rows.append(f"{0.01 * i},{x},{y},0,1,0,0,0")
    (case.folder / "round.csv").write_text("\n".join(rows) + "\n")
    wide = ("--tolerance", "0.02", "--angle-tolerance", "0.1")
    case.run("trajectory", "smooth", "round.csv", *wide, "-o", "cut.htraj")
    case.run("trajectory", "check", "cut.htraj", "--workcell", "cell.hcell", "--entity", "part", "--fail-on-contact", expect=1)
    kept = case.run("trajectory", "smooth", "round.csv", *wide, "--workcell", "cell.hcell", "--entity", "part", "-o", "kept.htraj")
    assert kept["kept_free"]["nearer"] and not kept["kept_free"]["findings"], kept
    free = case.run("trajectory", "check", "kept.htraj", "--workcell", "cell.hcell", "--entity", "part", "--fail-on-contact")
    assert free["free"], free


ROS = """joint_names: [q1, q2, q3, q4, q5, q6]
points:
- positions: [0.0, 0.0, 0.1, 0.2, 0.3, 0.0]
  time_from_start: {sec: 0, nanosec: 0}
- positions: [0.2, 0.1, 0.1, 0.2, 0.3, 0.1]
  time_from_start: {sec: 1, nanosec: 0}
- positions: [0.3, 0.2, 0.0, 0.2, 0.3, 0.4]
  time_from_start: {sec: 2, nanosec: 0}
"""


def poses_by_fk(case, rows, robot="library:hc6"):
    """Where these joints put the tool, by another command: list of (position, rotation)."""
    names = [f"joint_{i + 1}" for i in range(6)]
    (case.folder / "fk.csv").write_text(",".join(names) + "\n" + "\n".join(",".join(map(repr, row)) for row in rows) + "\n")
    poses = case.run("fk", "--robot", robot, "--joints", "fk.csv")["poses"]
    return [([p[axis] for axis in "xyz"], readers.of_quaternion(*(p[k] for k in ("qw", "qx", "qy", "qz")))) for p in poses]


def read_csv(path):
    lines = path.read_text().splitlines()
    names = lines[0].split(",")
    return [dict(zip(names, map(float, line.split(",")))) for line in lines[1:]]


def test_a_ros_trajectory_gets_its_poses_from_the_robot(case):
    (case.folder / "q.yaml").write_text(ROS)
    joints = [[0.0, 0.0, 0.1, 0.2, 0.3, 0.0], [0.2, 0.1, 0.1, 0.2, 0.3, 0.1], [0.3, 0.2, 0.0, 0.2, 0.3, 0.4]]
    assert case.run("trajectory", "info", "q.yaml")["has_poses"] is False
    case.run("trajectory", "export", "q.yaml", "--to", "krl", "-o", "p.src", "--robot", "library:hc6")
    expected = poses_by_fk(case, joints)
    targets = readers.read_krl(case.folder, "p")
    for (p, R), (q, S) in zip(targets, expected[len(expected) - len(targets):]):
        assert math.dist(p, q) < 1e-6 and readers.angle_between(R, S) < 1e-4, (p, q)
    for name in ("krl", "rapid", "fanuc", "urscript", "val3"):
        refused = case.run("trajectory", "export", "q.yaml", "--to", name, "-o", "none", expect=2)
        assert "--robot" in refused and not list(case.folder.glob("none*")), refused
    case.run("trajectory", "export", "q.yaml", "--to", "csv", "-o", "with.csv", "--robot", "library:hc6")
    for row, (p, _) in zip(read_csv(case.folder / "with.csv"), expected):
        assert math.dist([row[k] for k in "xyz"], p) < 1e-9, row
    # Without the robot a table of joints alone is honest, and is read as such.
    case.run("trajectory", "export", "q.yaml", "--to", "csv", "-o", "alone.csv")
    assert "x" not in read_csv(case.folder / "alone.csv")[0]
    assert case.run("trajectory", "info", "alone.csv")["has_poses"] is False
    refused = case.run("trajectory", "mirror", "alone.csv", "-o", "m.csv", expect=2)
    assert "poses" in refused and not (case.folder / "m.csv").exists(), refused


def test_retime_passes_taught_places_of_a_robot(case):
    joints = [[0.0] * 6, [0.6, -0.3, 0.4, 0.0, 0.5, 0.0], [0.6, 0.2, 0.1, 0.0, 0.9, 0.3], [-0.4, 0.2, 0.1, 0.0, 0.9, 0.3], [0.0] * 6]
    header = "t,x,y,z,qw,qx,qy,qz," + ",".join(f"joint_{i + 1}" for i in range(6))
    (case.folder / "fk.csv").write_text(",".join(f"joint_{i + 1}" for i in range(6)) + "\n" + "\n".join(",".join(map(repr, q)) for q in joints) + "\n")
    poses = case.run("fk", "--robot", "library:hc6", "--joints", "fk.csv")["poses"]
    for base in (0.0, 0.75):  # The same, and with the robot on a base.
        rows = [[float(i), p["x"], p["y"], p["z"] + base, p["qw"], p["qx"], p["qy"], p["qz"], *q] for i, (p, q) in enumerate(zip(poses, joints))]
        (case.folder / "taught.csv").write_text(header + "\n" + "\n".join(",".join(map(repr, row)) for row in rows) + "\n")
        done = case.run("trajectory", "retime", "taught.csv", "--robot", "library:hc6", "-o", "fast.csv")
        assert done["measured"]["position"] <= 5e-5 and done["measured"]["velocity"] <= 1.001, done
        assert done["measured"]["pose_by_joints"] <= 1e-6 and done["rests_at_corners"] == 3, done
        fast = read_csv(case.folder / "fast.csv")
        again = poses_by_fk(case, [[row[f"joint_{i + 1}"] for i in range(6)] for row in fast])
        for row, (p, _) in zip(fast, again):
            assert math.dist([row["x"], row["y"], row["z"] - base], p) < 1e-6, row
        for row in rows:
            assert min(math.dist([r["x"], r["y"], r["z"]], row[1:4]) for r in fast) < 5e-4, row
    # Without the robot the frames say that poses and joints were made apart.
    done = case.run("trajectory", "retime", "taught.csv", "--velocity", "2", "-o", "apart.csv")
    assert any("pose_apart" in note for note in done["assumptions"]), done
    assert any(row["pose_apart"] for row in read_csv(case.folder / "apart.csv"))


def test_what_is_written_was_measured(case):
    """What a missed promise does is shown by kept_result_test: these commands miss none that could be asked here."""
    write_motion(case.folder / "a.csv")
    kept = case.run("trajectory", "simplify", "a.csv", "-o", "few.csv")
    assert "missed" not in kept and kept["measured"]["position"] <= kept["promised"]["position"] == 1e-3, kept
    even = case.run("trajectory", "resample", "a.csv", "--step", "0.5", "-o", "n.csv")
    assert even["measured"]["position"] <= 1e-9, even
    close = case.run("trajectory", "retime", "a.csv", "--velocity", "0.2", "--acceleration", "5", "--tolerance", "1e-7",
                     "--angle-tolerance", "1e-6", "--sample", "0.5", "-o", "b.csv", "--allow-miss")
    assert close["sample"] < 0.5 or close["rests_at_corners"] > 0, close
    assert "missed" in close or close["measured"]["position"] <= 1e-7 + 1e-9, close
    # Without a name for the result nothing is left either, and it is measured all the same.
    before = sorted(p.name for p in case.folder.iterdir())
    assert case.run("trajectory", "smooth", "a.csv")["measured"]["position"] <= 1e-3
    assert sorted(p.name for p in case.folder.iterdir()) == before


def test_smooth_keeps_its_tolerance_with_few_frames(case):
    (case.folder / "square.csv").write_text("t,x,y,z,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n1,0.1,0,0,1,0,0,0\n2,0.1,0.1,0,1,0,0,0\n"
                                            "3,0,0.1,0,1,0,0,0\n4,0,0,0,1,0,0,0\n")
    done = case.run("trajectory", "smooth", "square.csv", "-o", "s.csv")
    assert done["max_deviation"]["position"] <= 1e-3 and done["measured"]["position"] <= 1e-3, done
    for given, row in zip(read_csv(case.folder / "square.csv"), read_csv(case.folder / "s.csv")):
        assert math.dist([given[k] for k in "xyz"], [row[k] for k in "xyz"]) <= 1.001e-3, row


def test_bad_input(case):
    write_motion(case.folder / "a.csv")
    (case.folder / "bad.htraj").write_text('{"format":"hapticell-trajectory","version":9}')
    assert "newer" in case.run("trajectory", "info", "bad.htraj", expect=2)
    assert "none.csv" in case.run("trajectory", "info", "none.csv", expect=2)
    assert "--tolerance" in case.run("trajectory", "smooth", "a.csv", "--tolerance", "0", "-o", "b.csv", expect=2)
    assert not (case.folder / "b.csv").exists()
    assert "--mode" in case.run("trajectory", "retime", "a.csv", "--mode", "fast", expect=2)


if __name__ == "__main__":
    sys.exit(main(globals()))
