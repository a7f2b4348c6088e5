#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs hapticell-cli mannequin as a user would and checks its answers against sums made here.

usage: mannequin_command_test.py HAPTICELL_CLI
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

CLI = sys.argv[1]


def run(*words):
    done = subprocess.run([CLI, "mannequin", *map(str, words)], capture_output=True, text=True, timeout=120)
    return done.returncode, done.stdout, done.stderr


def answer(*words):
    status, out, err = run(*words)
    assert status == 0, (words, status, err)
    return json.loads(out)


def refused(part, *words):
    status, out, err = run(*words)
    assert status == 2 and out == "" and part in err, (words, status, out, err)


def test_sizes():
    for sex, percentile, stature in (("male", 5, 1.648), ("male", 95, 1.870), ("female", 50, 1.626)):
        figure = answer("--sex", sex, "--percentile", percentile, "--measure")
        assert figure["dof"] == 56 and len(figure["joints"]) == 56
        assert len({joint["name"] for joint in figure["joints"]}) == 56
        measures = figure["measures"]
        assert abs(measures["stature"] - stature) < 1e-3
        for name in ("span acromial_height elbow_height trochanter_height knee_height tibial_height eye_height "
                     "sitting_height biacromial_breadth hand_length foot_length").split():
            assert 0.1 < measures[name] < 2.2, name
        x, y, z = figure["center_of_mass"]
        assert 0.55 <= z / stature <= 0.57 and abs(y) < 1e-6 and abs(x) < 0.1
        assert abs(sum(s["mass"] for s in figure["segments"]) - figure["mass"]) < 1e-6
        assert figure["limits_exceeded"] == []
    assert answer("--sex", "male", "--stature", 1.9, "--mass", 120)["mass"] == 120


def test_targets(folder):
    posture = folder / "posture.json"
    posture.write_text(json.dumps({"format": "hapticell-posture", "version": 1, "unit": "deg", "joints": {
        "r_shoulder_flexion": 60, "r_elbow_flexion": 50, "l_shoulder_flexion": 40, "l_elbow_flexion": 70,
        "vl1_flexion": 8, "r_radioulnar_pronation": 20}}))
    hands = answer("--sex", "female", "--percentile", 50, "--posture", posture)["hands"]

    def row(step, side, pose):
        return ",".join(map(repr, [step, *pose["position"], *pose["orientation"]])).replace(",", f",{side},", 1)

    lines = ["step,hand,x,y,z,qw,qx,qy,qz", row(1, "left", hands["left"]), row(1, "right", hands["right"])]
    far = {"position": [5.0, 0.0, 1.0], "orientation": [1, 0, 0, 0]}
    lines.append(row(2, "right", far))
    targets = folder / "targets.csv"
    targets.write_text("\n".join(lines) + "\n")
    result = answer("--sex", "female", "--percentile", 50, "--targets", targets, "--lock", "feet", "--hands", "both")
    first, second = result["results"]
    assert first["status"] == "solved", first
    for side in ("left", "right"):
        assert first["hands"][side]["position_error"] < 1e-3
        assert first["hands"][side]["orientation_error"] < math.radians(0.5)
    assert first["foot_displacement"] < 1e-3 and len(first["posture"]["joints"]) == 56
    assert second["status"] == "unreachable" and 3.0 < second["hands"]["right"]["position_error"] < 5.0
    assert second["foot_displacement"] < 1e-3 and second["balance_margin"] > 0.0
    assert result["timing"]["median_us"] > 0
    # What was found is a posture file that leads to where the hands were wanted.
    found = folder / "found.json"
    found.write_text(json.dumps(first["posture"]))
    again = answer("--sex", "female", "--percentile", 50, "--posture", found)["hands"]
    for side in ("left", "right"):
        assert math.dist(again[side]["position"], hands[side]["position"]) < 1.1e-3
    locked = answer("--sex", "female", "--percentile", 50, "--targets", targets, "--lock", "trunk,feet", "--hands", "right")
    start = answer("--sex", "female", "--percentile", 50)["root"]
    for one in locked["results"]:
        assert math.dist(one["posture"]["root"]["position"], start["position"]) < 1e-9
    status, _, _ = run("--sex", "female", "--percentile", 50, "--targets", targets, "--lock", "feet", "--fail-on-limit")
    assert status == 1
    targets.write_text("hand,x,y,z,qw,qx,qy,qz\nmiddle,0,0,1,1,0,0,0\n")
    refused("line 2, column 'hand'", "--sex", "male", "--percentile", 50, "--targets", targets)
    targets.write_text("hand,x,y,z,qw,qx,qy,qz\nleft,0,0,1,2,0,0,0\n")
    refused("unit quaternion", "--sex", "male", "--percentile", 50, "--targets", targets)


def test_refusals(folder):
    refused("1.2 to 2.3", "--sex", "male", "--stature", 1.1)
    refused("1.2 to 2.3", "--sex", "male", "--stature", 2.4)
    refused("0.1 to 99.9", "--sex", "female", "--percentile", 100)
    refused("one of --percentile and --stature", "--sex", "female")
    refused("male or female", "--sex", "other", "--percentile", 50)
    refused("gone.json", "--sex", "male", "--percentile", 50, "--posture", "gone.json")
    refused("trunk, feet or pelvis", "--sex", "male", "--percentile", 50, "--lock", "head", "--targets", folder / "targets.csv")
    for words in (("--lock", "head"), ("--hands", "middle")):  # Also where nothing asks for hands.
        refused(words[0], "--sex", "male", "--percentile", 50, *words)
    (folder / "none.csv").write_text("hand,x,y,z,qw,qx,qy,qz\n")
    refused("no row behind the header", "--sex", "male", "--percentile", 50, "--targets", folder / "none.csv")
    for ending in ("x.foo", "x"):
        refused(".json (the posture)", "--sex", "male", "--percentile", 50, "-o", folder / ending)
        assert not (folder / ending).exists()
    answer("--sex", "male", "--percentile", 50, "-o", "/dev/null")
    answer("--sex", "male", "--percentile", 50, "-o", folder / "x.json")
    assert json.loads((folder / "x.json").read_text())["format"] == "hapticell-posture"


with tempfile.TemporaryDirectory() as name:
    test_sizes()
    test_targets(pathlib.Path(name))
    (pathlib.Path(name) / "targets.csv").write_text("hand,x,y,z,qw,qx,qy,qz\nleft,0.3,0.2,1,1,0,0,0\n")
    test_refusals(pathlib.Path(name))
print("3 passed, 0 failed")
