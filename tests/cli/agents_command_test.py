#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Agents by the command line: runs repeat, the recording is free of contact for the check of motions, words that are wrong are
refused and nothing is written.

usage: agents_command_test.py HAPTICELL_CLI
"""
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

CLI = pathlib.Path(sys.argv[1])
ROOT = pathlib.Path(__file__).resolve().parents[2]
TASK = ROOT / "config/agents/obstacle-field.toml"


def run(*words, status=0):
    done = subprocess.run([CLI, *map(str, words)], capture_output=True, text=True, timeout=600)
    assert done.returncode == status, (words, done.returncode, done.stderr[-2000:])
    return json.loads(done.stdout) if status == 0 else done.stderr


def runs_repeat_on_any_number_of_threads():
    one = run("agents", TASK, "--runs", 3, "--modes", "operator,both", "--jobs", 1)
    two = run("agents", TASK, "--runs", 3, "--modes", "operator,both", "--jobs", 2)
    assert one == two
    assert [mode["mode"] for mode in one["modes"]] == ["operator", "both"] and len(one["runs"]) == 6
    for mode in one["modes"]:
        runs = [r for r in one["runs"] if r["mode"] == mode["mode"]]
        assert mode["solved"] == sum(r["solved"] for r in runs)
        assert mode["least_clearance_m"] == min(r["clearance_m"] for r in runs) >= 0.005 - 1e-6, mode
    assert run("agents", TASK, "--runs", 3, "--modes", "operator,both", "--seed", 2)["runs"] != one["runs"]


def a_recording_is_free_of_contact(folder):
    motion, wishes = folder / "way.htraj", folder / "wishes.csv"
    answer = run("agents", TASK, "--record", motion, "--wishes", wishes)["recording"]
    assert answer["measured"] == {"contacts": 0.0, "joint_limits": 0.0}
    checked = run("trajectory", "check", motion, "--workcell", ROOT / "config/agents/obstacle_field.hcell", "--fail-on-contact",
                  "--fail-on-limit")
    assert checked["free"] and checked["frames"] == answer["frames"]
    rows = list(csv.DictReader(wishes.open()))
    assert len(rows) == answer["frames"] - 1
    assert max(float(row["goal_strength"]) for row in rows) > 0.1 and float(rows[-1]["t"]) > 1.0


def wrong_words_are_refused(folder):
    assert "operator, agents or both" in run("agents", TASK, "--modes", "nobody", status=2)
    assert "no agent 'goul'" in run("agents", TASK, "--weights", "goul=1", status=2)
    assert "NAME=NUMBER" in run("agents", TASK, "--weights", "goal=fast", status=2)
    text = TASK.read_text().replace('cell = "', f'cell = "{TASK.parent}/')
    for old, new, part in (('what = "limits"', 'what = "magic"', "one of goal"), ('entity = "robot"', 'entity = "rob"', "no entity"),
                           ("within = 0.10", "within = 10.0", "within"), ("[goal]", "[gaol]", "goal is missing")):
        (folder / "t.toml").write_text(text.replace(old, new))
        message = run("agents", folder / "t.toml", "--record", folder / "no.htraj", status=2)
        assert part in message, (part, message)
    assert not (folder / "no.htraj").exists()


def main():
    runs_repeat_on_any_number_of_threads()
    with tempfile.TemporaryDirectory() as name:
        a_recording_is_free_of_contact(pathlib.Path(name))
    with tempfile.TemporaryDirectory() as name:
        wrong_words_are_refused(pathlib.Path(name))
    print("3 passed, 0 failed")


if __name__ == "__main__":
    sys.exit(main())
