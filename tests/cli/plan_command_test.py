#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The command `plan`: motions of a robot and of a solid, and why there is none.

usage: plan_command_test.py HAPTICELL_CLI [NAME_PART]
"""
import json
import pathlib
import subprocess
import sys
import tempfile

CLI = str(pathlib.Path(sys.argv[1]).resolve())
NAMES = ["shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint", "wrist_1_joint", "wrist_2_joint", "wrist_3_joint"]
START = [0.6, -1.2, 1.2, -1.5, -1.5, 0.0]
CELLS = pathlib.Path(__file__).resolve().parents[2] / "config" / "workcells"
HAND_GOAL = "0.25,-0.25,1.2,0.5,0.5,-0.5,0.5"  # Of the grip of a right hand, above the bench.
GOAL = [-0.6, -1.2, 1.2, -1.5, -1.5, 0.0]


def run(*words, folder, expect=0):
    done = subprocess.run([CLI, *map(str, words)], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          text=True, timeout=300, cwd=folder)
    assert done.returncode == expect, (done.returncode, done.stdout, done.stderr)
    return done


def robot_cell(folder, *more):
    run("workcell", "new", "cell.hcell", "--add", "library:ur5e,name=robot",
        "--add", "box:0.6,0.04,0.5,name=wall,pose=-0.65,-0.13,0.25,1,0,0,0",
        "--add", "box:1,1,0.1,name=plate,pose=0,0,-0.05,1,0,0,0", *more, folder=folder)
    cell = json.loads((folder / "cell.hcell").read_text())
    next(one for one in cell["entities"] if one["name"] == "robot")["joints"] = dict(zip(NAMES, START))
    (folder / "cell.hcell").write_text(json.dumps(cell))


def box_cell(folder):
    run("workcell", "new", "box.hcell", "--add", "box:0.1,0.04,0.04,name=bar,pose=0,0,0.1,1,0,0,0",
        "--add", "box:0.02,0.34,0.3,name=left,pose=-0.16,0,0.15,1,0,0,0",
        "--add", "box:0.02,0.34,0.3,name=right,pose=0.16,0,0.15,1,0,0,0",
        "--add", "box:0.34,0.34,0.02,name=floor,pose=0,0,-0.01,1,0,0,0", folder=folder)


def plan(*words, folder, expect=0):
    done = run("plan", *words, folder=folder, expect=expect)
    return json.loads(done.stdout)


def to_goal(folder, output, *words, expect=0):
    return plan("--workcell", "cell.hcell", "--entity", "robot", "--to-joints", ",".join(map(str, GOAL)), "-o", output,
                *words, folder=folder, expect=expect)


def test_a_plan_keeps_its_clearance_on_the_written_file(folder):
    robot_cell(folder)
    answer = to_goal(folder, "path.htraj", "--clearance", "0.01")
    assert answer["solved"] is True, answer
    assert answer["clearance_min_m"] >= 0.01 - 1e-6, answer
    assert answer["length"] > 0.3 and answer["time_s"] > 0 and answer["checks"] > 0, answer
    # The check of motions, which knows nothing of plans.
    check = json.loads(run("trajectory", "check", "path.htraj", "--workcell", "cell.hcell", "--entity", "robot",
                           "--fail-on-contact", "--fail-on-limit", folder=folder).stdout)
    assert check["free"] and check["within_limits"], check
    motion = json.loads((folder / "path.htraj").read_text())
    assert motion["format"] == "hapticell-trajectory"
    info = json.loads(run("trajectory", "info", "path.htraj", folder=folder).stdout)
    assert abs(info["duration"] - answer["duration_s"]) < 1e-9, (info, answer)


def test_a_hand_of_a_mannequin_reaches_over_a_bench(folder):
    """The shipped workbench: the right hand goes from beside the body over the bench, round its edge."""
    cell = CELLS / "workbench.hcell"
    answer = plan("--workcell", cell, "--entity", "operator", "--hand", "right", "--to", HAND_GOAL, "--clearance", "0.003",
                  "-o", "hand.htraj", folder=folder)
    assert answer["solved"] and answer["clearance_min_m"] >= 0.003 - 1e-6, answer
    measured = answer["measured"]
    assert measured["feet"] <= 3e-4 and measured["balance"] >= -1e-6 and measured["pose"] <= 1e-3, measured
    check = json.loads(run("trajectory", "check", "hand.htraj", "--workcell", cell, "--entity", "operator",
                           "--fail-on-contact", folder=folder).stdout)
    assert check["free"], check
    run("plan", "--workcell", cell, "--entity", "operator", "--to", HAND_GOAL, "-o", "no.htraj", folder=folder, expect=2)
    answer = plan("--workcell", cell, "--entity", "operator", "--hand", "left", "--to", "9,0,1,1,0,0,0", "-o", "no.htraj",
                  folder=folder, expect=1)
    assert answer["constraint"] == "reach" and "left hand of operator" in answer["reason"], answer
    assert not (folder / "no.htraj").exists()


RAIL = """<robot name="rail">
<link name="bed"><collision><geometry><box size="4.4 0.3 0.1"/></geometry></collision></link>
<link name="carriage"><collision><geometry><box size="0.3 0.3 0.2"/></geometry></collision></link>
<joint name="drive" type="prismatic"><parent link="bed"/><child link="carriage"/><origin xyz="0 0 0.16"/>
<axis xyz="1 0 0"/><limit lower="-2" upper="2" velocity="0.8" effort="1000"/></joint></robot>
"""


def rail_cell(folder):
    """A robot on a rail of 4 m, at its one end, and a post on the straight way of its arm."""
    (folder / "rail.urdf").write_text(RAIL)
    run("workcell", "new", "rail.hcell", "--add", "rail.urdf,name=rail,pose=0,0,0.05,1,0,0,0", "--add",
        "library:ur5e,name=robot,pose=-1.5,0,0.31,1,0,0,0", "--add", "box:0.3,0.9,2.4,name=post,pose=0,0.7,1.2,1,0,0,0",
        folder=folder)
    cell = json.loads((folder / "rail.hcell").read_text())
    rail, robot = cell["entities"][:2]
    rail["joints"] = {"drive": -1.5}
    robot["joints"] = dict(zip(NAMES, [-1.57, -1.2, 1.2, -1.57, -1.57, 0.0]))
    robot["attached"] = {"to": "rail", "link": "carriage", "placement": {"position": [0, 0, 0.1], "quaternion": [1, 0, 0, 0]}}
    (folder / "rail.hcell").write_text(json.dumps(cell))


def test_a_robot_moves_with_its_rail(folder):
    rail_cell(folder)
    base = ("--workcell", "rail.hcell", "--entity", "robot", "--to", "1.5,0.5,0.6,0,1,0,0")
    answer = plan(*base, "-o", "path.htraj", folder=folder)
    assert answer["solved"] and answer["clearance_min_m"] >= 0.005 - 1e-6, answer
    assert answer["measured"]["axis_speed"] <= 1 + 1e-6 and answer["measured"]["pose"] <= 1e-3, answer
    (axis,) = answer["axes"]
    assert axis == {"entity": "rail", "joints": ["drive"], "output": "path-rail.htraj"}, axis
    robot, rail = (json.loads((folder / name).read_text()) for name in ("path.htraj", "path-rail.htraj"))
    assert robot["joints"] == NAMES and rail["joints"] == ["drive"] and robot["take"] == rail["take"] != "", robot["take"]
    assert [row[0] for row in robot["frames"]] == [row[0] for row in rail["frames"]]
    # The check of motions, which knows nothing of plans; the arm alone would meet nothing, but miss its poses.
    check = json.loads(run("trajectory", "check", "path.htraj", "--workcell", "rail.hcell", "--together", "path-rail.htraj",
                           "--fail-on-contact", "--fail-on-limit", folder=folder).stdout)
    assert check["free"] and check["within_limits"], check
    # Both files or none; the name of the axis as it is, and another plan is another take.
    text = (folder / "rail.hcell").read_text()
    (folder / "süd.hcell").write_text(text.replace('"name": "rail"', '"name": "Süd/1"').replace('"to": "rail"', '"to": "Süd/1"'))
    (folder / "x-Süd_1.htraj").mkdir()
    south = ("--workcell", "süd.hcell", "--entity", "robot", "--to-joints=1.5,-1.57,-1.2,1.2,-1.57,-1.57,0", "-o", "x.htraj")
    run("plan", *south, folder=folder, expect=2)
    assert not (folder / "x.htraj").exists()
    (folder / "x-Süd_1.htraj").rmdir()
    (axis,) = plan(*south, folder=folder)["axes"]
    assert axis["entity"] == "Süd/1" and axis["output"] == "x-Süd_1.htraj", axis
    assert json.loads((folder / "x.htraj").read_text())["take"] not in ("", robot["take"])
    # The rail stays: out of reach, or joints of the robot alone.
    answer = plan(*base, "--keep-axes", "-o", "no.htraj", folder=folder, expect=1)
    assert answer["constraint"] == "reach" and not (folder / "no.htraj").exists(), answer
    joints = plan("--workcell", "rail.hcell", "--entity", "robot", "--to-joints=-1.2,-1.2,1.2,-1.57,-1.57,0", "-o",
                  "own.htraj", folder=folder)
    assert joints["solved"] and "axes" not in joints, joints
    joints = plan("--workcell", "rail.hcell", "--entity", "robot", "--to-joints=1.5,-1.57,-1.2,1.2,-1.57,-1.57,0", "-o",
                  "all.csv", folder=folder)
    assert joints["solved"] and (folder / "all-rail.csv").exists() and joints["planner"] != "straight", joints
    said = run("trajectory", "check", "path.htraj", "--workcell", "rail.hcell", "--together", "all-rail.csv",
               folder=folder, expect=2).stderr
    assert "does not name what moves" in said, said
    said = run("plan", "--workcell", "rail.hcell", "--entity", "robot", "--to-joints=1,2,3", "-o", "no.htraj",
               folder=folder, expect=2).stderr
    assert "7 joint positions" in said and "6 of its own" in said, said


def test_joints_of_a_mannequin_are_no_goal(folder):
    said = run("plan", "--workcell", CELLS / "workbench.hcell", "--entity", "operator", "--hand", "right", "--to-joints",
               "0,1,2", "-o", "no.htraj", folder=folder, expect=2).stderr
    assert "posture" in said and "hand" in said and not (folder / "no.htraj").exists(), said


def test_equal_seeds_give_equal_files(folder):
    robot_cell(folder)
    one = to_goal(folder, "one.htraj", "--seed", "4", "--jobs", "1")
    two = to_goal(folder, "two.htraj", "--seed", "4", "--jobs", "2", "--time", "500")
    assert (folder / "one.htraj").read_bytes() == (folder / "two.htraj").read_bytes()
    assert one["checks"] == two["checks"], (one, two)


def test_a_part_leaves_its_box(folder):
    box_cell(folder)
    answer = plan("--workcell", "box.hcell", "--entity", "bar", "--out", "-o", "out.csv", folder=folder)
    assert answer["solved"] and answer["clearance_min_m"] >= 0.005 - 1e-6, answer
    last = [float(word) for word in (folder / "out.csv").read_text().splitlines()[-1].split(",")]
    assert max(abs(last[1]), abs(last[2]), last[3] - 0.2, -last[3]) > 0.1, last


def test_a_start_in_contact_is_left(folder):
    run("workcell", "new", "table.hcell", "--add", "box:0.1,0.04,0.04,name=bar,pose=0,0,0.02,1,0,0,0",
        "--add", "box:1,1,0.1,name=table,pose=0,0,-0.05,1,0,0,0", folder=folder)
    answer = plan("--workcell", "table.hcell", "--entity", "bar", "--to", "0.2,0,0.3,1,0,0,0", "-o", "up.htraj", folder=folder)
    assert answer["solved"] and answer["clearance_min_m"] >= 0.005 - 1e-6, answer
    (left,) = answer["left"]
    assert (left["moved"], left["met"]) == ("bar", "table") and abs(left["gap_m"]) < 1e-5, left
    assert 0 < left["until_s"] < answer["duration_s"] and "reached" not in answer, answer
    assert any("bar touches table at the start" in note for note in answer["notes"]), answer


def beside_the_flange(folder, joints, gap):
    """A box of 0.08 x 0.08 x 0.1 m in front of the flange at these joint positions, `gap` m from it."""
    (folder / "joints.csv").write_text(",".join(NAMES) + "\n" + ",".join(map(str, joints)) + "\n")
    answer = json.loads(run("fk", "--robot", "library:ur5e", "--joints", "joints.csv", folder=folder).stdout)
    x, y, z, w, i, j, k = (answer["poses"][0][name] for name in ("x", "y", "z", "qw", "qx", "qy", "qz"))
    axis = (2 * (i * k + w * j), 2 * (j * k - w * i), 1 - 2 * (i * i + j * j))
    centre = [at + (0.05 + gap) * along for at, along in zip((x, y, z), axis)]
    return "box:0.08,0.08,0.1,name=part,pose=" + ",".join(f"{value:.9f}" for value in (*centre, w, i, j, k))


def test_a_robot_leaves_and_reaches_a_part(folder):
    for joints, gap, key in ((START, -0.0003, "left"), (START, 0.0005, "left"), (GOAL, -0.0003, "reached")):
        robot_cell(folder, "--add", beside_the_flange(folder, joints, gap))
        answer = to_goal(folder, "way.htraj")
        assert answer["solved"] and answer["clearance_min_m"] >= 0.005 - 1e-6, answer
        (pair,) = answer[key]
        assert pair["moved"].startswith("robot/") and pair["met"] == "part" and abs(pair["gap_m"] - gap) < 1e-5, pair
    robot_cell(folder, "--add", beside_the_flange(folder, START, -0.005))
    answer = to_goal(folder, "deep.htraj", expect=1)
    assert answer["constraint"] == "start" and "deep in part" in answer["reason"], answer
    assert not (folder / "deep.htraj").exists()


def test_a_motion_passes_given_poses(folder):
    box_cell(folder)
    (folder / "through.csv").write_text("x,y,z,qw,qx,qy,qz\n0,0,0.6,1,0,0,0\n0.5,0,0.6,1,0,0,0\n")
    answer = plan("--workcell", "box.hcell", "--entity", "bar", "--to", "0.5,0,0.1,1,0,0,0", "--through", "through.csv",
                  "-o", "way.csv", folder=folder)
    assert answer["solved"], answer
    rows = [[float(word) for word in line.split(",")[:4]] for line in (folder / "way.csv").read_text().splitlines()[1:]]
    for place in ((0, 0, 0.6), (0.5, 0, 0.6), (0.5, 0, 0.1)):
        nearest = min(max(abs(a - b) for a, b in zip(row[1:], place)) for row in rows)
        assert nearest < 5e-3, (place, nearest)


def test_a_motion_passes_frames_by_their_names(folder):
    box_cell(folder)
    cell = json.loads((folder / "box.hcell").read_text())
    left = next(one for one in cell["entities"] if one["name"] == "left")
    # Of the box at -0.16, 0, 0.15.
    left["frames"] = [{"name": name, "placement": {"position": place, "quaternion": [1, 0, 0, 0]}}
                      for name, place in (("over", [0.16, 0, 0.45]), ("beside", [0.66, 0, 0.45]), ("end", [0.66, 0, -0.05]))]
    (folder / "box.hcell").write_text(json.dumps(cell))
    answer = plan("--workcell", "box.hcell", "--entity", "bar", "--to-frame", "end", "--through-frame", "over",
                  "--through-frame", "beside", "-o", "way.csv", folder=folder)
    assert answer["solved"], answer
    rows = [[float(word) for word in line.split(",")[1:4]] for line in (folder / "way.csv").read_text().splitlines()[1:]]
    met = []
    for place in ((0, 0, 0.6), (0.5, 0, 0.6), (0.5, 0, 0.1)):
        apart = [max(abs(a - b) for a, b in zip(row, place)) for row in rows]
        met.append(apart.index(min(apart)))
        assert min(apart) < 5e-3, (place, min(apart))
    assert met == sorted(met) and met[-1] == len(rows) - 1, met
    said = run("plan", "--workcell", "box.hcell", "--entity", "bar", "--out", "--through-frame", "door", "-o", "no.csv",
               folder=folder, expect=2).stderr
    assert "'door'" in said, said


def test_an_unreachable_goal_is_explained(folder):
    robot_cell(folder)
    answer = plan("--workcell", "cell.hcell", "--entity", "robot", "--to", "3,0,0.5,1,0,0,0", "-o", "no.htraj", folder=folder,
                  expect=1)
    assert answer["solved"] is False and answer["constraint"] == "reach" and "reach" in answer["reason"], answer
    box_cell(folder)
    answer = plan("--workcell", "box.hcell", "--entity", "bar", "--to", "0.15,0,0.1,1,0,0,0", "-o", "no.htraj", folder=folder,
                  expect=1)
    assert answer["constraint"] == "blocked" and answer["blocked_by"] == "right", answer
    assert 0 < answer["nearest"]["distance"] < 0.3, answer
    assert not (folder / "no.htraj").exists()


def test_wrong_words_are_refused(folder):
    box_cell(folder)
    base = ("plan", "--workcell", "box.hcell", "--entity", "bar", "-o", "no.htraj")
    for words in ((), ("--out", "--to", "0,0,1,1,0,0,0"), ("--to", "0,0,1"), ("--to-joints", "1,2"), ("--to", "0,0,1,2,0,0,0")):
        said = run(*base, *words, folder=folder, expect=2).stderr
        assert said.strip(), words
    said = run("plan", "--workcell", "box.hcell", "--entity", "nut", "--out", "-o", "no.htraj", folder=folder, expect=2).stderr
    assert "'nut'" in said and "bar" in said, said
    said = run("plan", "--workcell", "box.hcell", "--entity", "bar", "--out", "-o", "no.txt", folder=folder, expect=2).stderr
    assert ".htraj" in said, said
    assert not (folder / "no.htraj").exists()


def main():
    part = sys.argv[2] if len(sys.argv) > 2 else ""
    for name, test in list(globals().items()):
        if name.startswith("test_") and part in name:
            with tempfile.TemporaryDirectory() as folder:
                test(pathlib.Path(folder))
            print(f"{name}: ok", flush=True)


if __name__ == "__main__":
    main()
