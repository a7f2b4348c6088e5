#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs hapticell-cli mannequin as a user would and checks its answers against sums made here.

usage: mannequin_command_test.py HAPTICELL_CLI
"""
import json
import math
import pathlib
import struct
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
    refused("no line after the header", "--sex", "male", "--percentile", 50, "--targets", folder / "none.csv")
    for ending in ("x.foo", "x"):
        refused(".json (the posture)", "--sex", "male", "--percentile", 50, "-o", folder / ending)
        assert not (folder / ending).exists()
    answer("--sex", "male", "--percentile", 50, "-o", "/dev/null")
    answer("--sex", "male", "--percentile", 50, "-o", folder / "x.json")
    assert json.loads((folder / "x.json").read_text())["format"] == "hapticell-posture"


def c3d(path, labels, frames, up=None):
    """A C3D of real numbers in millimetres: frames of places, one a label; nothing where a marker is not seen."""
    def group(number, name):
        return bytes([len(name)]) + struct.pack("b", -number) + name + struct.pack("<H", 3) + b"\0"

    def parameter(name, kind, sizes, content):
        body = struct.pack("b", kind) + bytes([len(sizes)]) + bytes(sizes) + content + b"\0"
        return bytes([len(name), 1]) + name + struct.pack("<H", 2 + len(body)) + body

    width = max(map(len, labels))
    section = group(1, b"POINT") + parameter(b"LABELS", -1, [width, len(labels)],
                                             b"".join(x.encode().ljust(width) for x in labels))
    section += parameter(b"UNITS", -1, [2], b"mm") + (parameter(b"Y_SCREEN", -1, [2], up) if up else b"") + b"\0\0"
    blocks = (len(section) + 4 + 511) // 512
    head = bytes([2, 0x50]) + struct.pack("<5Hf2Hf", len(labels), 0, 1, len(frames), 0, -1.0, 2 + blocks, 1, 100.0)
    data = b"".join(struct.pack("<4f", *(place or (0, 0, 0)), 0.0 if place else -1.0) for frame in frames for place in frame)
    path.write_bytes(head.ljust(512, b"\0") + (bytes([1, 0x50, blocks, 84]) + section).ljust(512 * blocks, b"\0") + data)


def standing_markers():
    """Helen Hayes on somebody who stands and looks along x; y to the left, z up, mm."""
    marks = {"V.Sacral": (-110, 0, 1000), "Top.Head": (0, 0, 1760), "Front.Head": (90, 0, 1680), "Rear.Head": (-90, 0, 1680)}
    for side, out in (("L", 1), ("R", -1)):
        for word, (x, y, z) in {"ASIS": (50, 120, 1010), "Shoulder": (0, 190, 1460), "Elbow": (0, 240, 1110), "Wrist": (10, 215, 860),
                                "Knee": (0, 145, 500), "Ankle": (0, 130, 80), "Heel": (-60, 90, 40), "Toe": (140, 90, 40)}.items():
            marks[f"{side}.{word}"] = (x, out * y, z)
    return marks


def bent(marks, degrees):
    """All above the hips turned forwards about the hips' axis."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return {name: ((c * x + s * (z - 920), y, 920 - s * x + c * (z - 920)) if z > 1050 or "Wrist" in name else (x, y, z))
            for name, (x, y, z) in marks.items()}


def test_markers(folder):
    stands = standing_markers()
    labels = list(stands)
    frames = [[bent(stands, angle)[name] for name in labels] for angle in range(0, 61, 2)]
    size = ("--sex", "male", "--percentile", 50)
    for name, turn, up in (("z.c3d", lambda p: p, b"+Z"), ("unsaid.c3d", lambda p: p, None),
                           ("y.c3d", lambda p: (p[0], p[2], -p[1]), None), ("wrong.c3d", lambda p: (p[0], p[2], -p[1]), b"+X")):
        c3d(folder / name, ["Worker:" + label for label in labels], [[turn(p) for p in frame] for frame in frames], up)
        found = answer(*size, "--motion", folder / name, "-o", folder / "fitted.bvh")
        assert found["marker_set"] == "Helen Hayes" and found["motion"]["frames"] == len(frames), found["motion"]
        assert found["up"] == ("y" if name[0] in "yw" else "z") and found["assumptions"], found["up"]
        done = subprocess.run([CLI, "ergonomics", "rula", "--motion", folder / name], capture_output=True, text=True)
        scores = json.loads(done.stdout)
        leans = [frame["trunk_inclination"] for frame in scores["frames"]]
        assert leans[0] < 6 and abs(leans[-1] - leans[0] - 60) < 6, (leans[0], leans[-1])
        assert scores["marker_set"] == "Helen Hayes" and scores["frames"][-1]["score"] > scores["frames"][0]["score"]
    told = answer(*size, "--motion", folder / "z.c3d", "--up", "y")
    assert told["up"] == "y" and any("as set" in each for each in told["assumptions"]), told["assumptions"]
    c3d(folder / "own.c3d", [f"P{i}" for i in range(len(labels))], frames, b"+Z")
    refused("--markers", *size, "--motion", folder / "own.c3d")
    landmark = {"V.Sacral": "sacrum", "Top.Head": "head_top", "Front.Head": "head_front", "Rear.Head": "head_back"}
    rows = ["name = \"Ours\"", "[markers]"]
    for i, label in enumerate(labels):
        side = {"L": "left_", "R": "right_"}.get(label[0], "")
        rows.append(f"{landmark.get(label) or side + label[2:].lower()} = \"P{i}\"")
    (folder / "own.toml").write_text("\n".join(rows))
    assert answer(*size, "--motion", folder / "own.c3d", "--markers", folder / "own.toml")["marker_set"] == "Ours"
    refused("nobody", *size, "--motion", folder / "own.c3d", "--markers", folder / "nobody.toml")
    refused("x, y, z, -x, -y or -z", *size, "--motion", folder / "z.c3d", "--up", "w")


with tempfile.TemporaryDirectory() as name:
    test_sizes()
    test_targets(pathlib.Path(name))
    (pathlib.Path(name) / "targets.csv").write_text("hand,x,y,z,qw,qx,qy,qz\nleft,0.3,0.2,1,1,0,0,0\n")
    test_refusals(pathlib.Path(name))
    test_markers(pathlib.Path(name))
print("4 passed, 0 failed")
