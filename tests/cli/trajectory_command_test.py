#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The command `trajectory`, on motions made here.

usage: trajectory_command_test.py HAPTICELL_CLI [NAME_PART]
"""
import json
import math
import pathlib
import sys

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
    message = case.run("trajectory", "export", "few.htraj", "--to", "ros", "-o", "p.yaml", expect=2)
    assert "joints" in message and not (case.folder / "p.yaml").exists()
    assert "krl" in case.run("trajectory", "export", "few.htraj", "--to", "basic", "-o", "p.x", expect=2)


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
    timed = case.run("trajectory", "retime", "smooth.htraj", "--robot", "library:hc6", "-o", "fast.htraj")
    assert timed["limit_use"]["velocity"] <= 1.001 and timed["max_deviation"]["position"] < 1e-4, timed
    ros = case.run("trajectory", "export", "fast.htraj", "--to", "ros", "-o", "p.yaml")
    again = case.run("trajectory", "info", "p.yaml")
    assert again["frames"] == ros["frames"] and again["joints"] == recorded["joints"]
    for name in ("krl", "rapid", "fanuc", "urscript", "val3"):
        case.run("trajectory", "export", "fast.htraj", "--to", name, "--robot", "library:hc6", "-o", "prog-" + name)


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
