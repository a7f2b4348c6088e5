#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Studies by the command line: rows equal for threads, chunks, kills and interruptions; what does not belong together is found;
a variant is opened; a full disk. Batches of distances and of inverse solutions against single ones.

usage: study_command_test.py HAPTICELL_CLI
"""
import csv
import json
import pathlib
import resource
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time

CLI = pathlib.Path(sys.argv[1])
ROOT = pathlib.Path(__file__).resolve().parents[2]
STUDIES = ROOT / "config/studies"
CELLS = ROOT / "config/workcells"


def run(*words, status=0, **more):
    done = subprocess.run([CLI, *map(str, words)], capture_output=True, text=True, timeout=600, **more)
    assert done.returncode == status, (words, done.returncode, done.stderr[-2000:])
    return json.loads(done.stdout) if status == 0 and done.stdout.startswith("{") else done.stderr


def rows(results):
    """Everything of the table of variants, with the bits of its numbers."""
    with sqlite3.connect(f"file:{results}?mode=ro", uri=True) as base:
        return base.execute("SELECT * FROM variants ORDER BY number").fetchall()


def small_study(folder, text=None):
    """A few variants of the shipped study of the car door."""
    for name in ("car-door.hcell", "car-door-welds.csv"):
        (folder / name).write_bytes((STUDIES / name).read_bytes())
    if text is None:
        text = (STUDIES / "car-door-robot.hstudy").read_text().replace("steps = 7", "steps = 3").replace("turns = 8", "turns = 2")
    (folder / "s.hstudy").write_text(text)
    return folder / "s.hstudy"


def rows_do_not_depend_on_how_they_were_made(folder):
    study = small_study(folder)
    answer = run("study", "run", study, "-o", folder / "one", "--jobs", 1)
    assert answer["complete"] and answer["rows"] == answer["variants"] == 9, answer
    expected = rows(folder / "one")
    assert len(expected) == 9
    run("study", "run", study, "-o", folder / "two", "--jobs", 2)
    assert rows(folder / "two") == expected
    again = run("study", "run", study, "-o", folder / "two")
    assert again["rows"] == 0 and again["kept"] == 9, again
    for chunk in range(1, 5):
        run("study", "run", study, "-o", folder / f"c{chunk}", "--chunk", f"{chunk}/4", "--jobs", 1)
    parts = [folder / f"c{chunk}" for chunk in range(1, 5)]
    assert run("study", "merge", *parts, "-o", folder / "merged")["complete"]
    assert rows(folder / "merged") == expected
    return study, expected, parts


def stops_are_made_good(folder, study, expected):
    for sign, name in ((signal.SIGINT, "stopped"), (signal.SIGKILL, "killed")):
        child = subprocess.Popen([CLI, "study", "run", study, "-o", folder / name, "--jobs", "1"], stdout=subprocess.DEVNULL,
                                 stderr=subprocess.DEVNULL)
        end = time.monotonic() + 300
        while child.poll() is None and time.monotonic() < end and not (folder / name).exists():
            time.sleep(0.02)
        time.sleep(0.3)
        child.send_signal(sign)
        child.wait(300)
        run("study", "run", study, "-o", folder / name)
        assert rows(folder / name) == expected, name


def strangers_are_found(folder, study, parts):
    assert "also in" in run("study", "merge", *parts, parts[1], "-o", folder / "twice", status=2)
    assert not (folder / "twice").exists()
    assert "are in no part" in run("study", "merge", *parts[:2], "-o", folder / "few", status=2)
    partial = run("study", "merge", *parts[:2], "-o", folder / "few", "--partial")
    assert not partial["complete"]
    assert run("study", "run", study, "-o", folder / "few")["complete"]
    (folder / "other").write_bytes(parts[0].read_bytes())
    with sqlite3.connect(folder / "other") as base:
        base.execute("UPDATE head SET value = '0.0.1 abc' WHERE key = 'version'")
    assert "version 0.0.1 abc" in run("study", "merge", folder / "other", *parts[1:], "-o", folder / "mixed", status=2)
    assert "version 0.0.1 abc" in run("study", "run", study, "-o", folder / "other", "--chunk", "1/4", status=2)
    study.write_text(study.read_text().replace("dwell = 0.5", "dwell = 0.75"))
    assert "another study" in run("study", "run", study, "-o", folder / "one", status=2)
    study.write_text(study.read_text().replace("dwell = 0.75", "dwell = 0.5"))
    (folder / "text").write_text("no results" * 200)
    assert "study" in run("study", "show", folder / "text", status=2)
    for chunk in ("0/4", "5/4", "1", "a/b", "1/4/2"):
        assert "--chunk" in run("study", "run", study, "-o", folder / "x", "--chunk", chunk, status=2)


def results_are_read(folder, expected):
    summary = run("study", "show", folder / "one")
    assert summary["rows"] == 9 and summary["complete"] and len(summary["runs"]) == 1, summary
    best = run("study", "best", folder / "one", "--count", 3)["variants"]
    assert len(best) == 3 and [b["feasible"] for b in best] == sorted((b["feasible"] for b in best), reverse=True)
    front = run("study", "best", folder / "one", "--pareto")["variants"]
    assert all(one["feasible"] for one in front)
    for words in (("--csv", "-o", folder / "t1.csv"), ("--csv", folder / "t2.csv")):
        assert run("study", "export", folder / "one", *words)["rows"] == 9
    assert (folder / "t1.csv").read_text() == (folder / "t2.csv").read_text()
    printed = subprocess.run([CLI, "study", "export", "--csv", folder / "one"], capture_output=True, text=True, check=True)
    assert printed.stdout == (folder / "t1.csv").read_text()
    table = list(csv.DictReader((folder / "t1.csv").open()))
    assert [float(line["sideways"]) for line in table] == [row[1] for row in expected]

    opened = run("study", "open", folder / "one", "--variant", best[0]["number"], "-o", folder / "best.hcell")
    assert opened["same_as_row"] and opened["results"] == best[0]["results"], opened
    places = {e["name"]: e["placement"]["position"] for e in json.loads((folder / "best.hcell").read_text())["entities"]}
    before = {e["name"]: e["placement"]["position"] for e in json.loads((folder / "car-door.hcell").read_text())["entities"]}
    for name in ("pedestal", "robot"):
        moved = [a - b for a, b in zip(places[name], before[name])]
        wanted = [best[0]["values"]["sideways"], best[0]["values"]["towards_door"], 0.0]
        assert all(abs(a - b) < 1e-9 for a, b in zip(moved, wanted)), (name, moved, wanted)
    # A row that somebody changed is not opened as if it had been measured.
    (folder / "forged").write_bytes((folder / "one").read_bytes())
    with sqlite3.connect(folder / "forged") as base:
        base.execute("UPDATE variants SET \"reach.share\" = 0.5 WHERE number = 4")
    assert "differ" in run("study", "open", folder / "forged", "--variant", 4, "-o", folder / "f.hcell", status=2)
    assert "no variant 99" in run("study", "open", folder / "one", "--variant", 99, "-o", folder / "f.hcell", status=2)


def a_full_disk_is_told(folder):
    """With one target and many variants, so that the file must grow."""
    text = (STUDIES / "car-door-robot.hstudy").read_text().replace("steps = 7", "steps = 18").replace("turns = 8", "turns = 1")
    study = small_study(folder, text)
    welds = (folder / "car-door-welds.csv").read_text().splitlines()
    (folder / "car-door-welds.csv").write_text("\n".join(welds[:2]) + "\n")

    def limited(most):
        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))

        return run("study", "run", study, "-o", folder / "full", status=2, preexec_fn=limit)

    told = limited(12288)
    assert "full" in told and not (folder / "full").exists(), told
    told = limited(49152)
    assert "full" in told and (folder / "full").exists(), told
    assert run("study", "run", study, "-o", folder / "full")["rows"] > 0
    run("study", "run", study, "-o", folder / "roomy")
    assert rows(folder / "full") == rows(folder / "roomy") and len(rows(folder / "full")) == 324


def faults_name_line_and_key(folder):
    text = (STUDIES / "car-door-robot.hstudy").read_text()
    for old, new, words in (("axis = \"x\"", "axes = \"x\"", ("line", "axis")), ("entity = \"pedestal\"", "entity = \"pedal\"", ("pedal", "pedestal")),
                            ("what = \"reach\"", "what = \"reaches\"", ("reaches", "cycle_time")),
                            ("turns = 8 ", "turns = 800 ", ("turns", "line")), ("car-door-welds.csv", "none.csv", ("none.csv",))):
        assert old in text, old
        told = run("study", "run", small_study(folder, text.replace(old, new, 1)), "-o", folder / "x", status=2)
        assert all(word in told for word in words), (new, told)


def batches_agree_with_single_answers(folder):
    poses = ["x,y,z,qw,qx,qy,qz"] + [f"{0.3 + 0.005 * i!r},{-0.4 + 0.006 * i!r},{0.35 + 0.002 * i!r},0,1,0,0" for i in range(150)]
    (folder / "poses.csv").write_text("\n".join(poses) + "\n")
    ask = ["ik", "--collision-free", "--workcell", CELLS / "demo.hcell", "--entity", "robot", "--poses", folder / "poses.csv", "--all"]
    one, two = (run(*ask, "--jobs", jobs) for jobs in (1, 2))
    assert one["results"] == two["results"] and one["timing"]["per_second"] > 0
    free = [r for r in one["results"] if r["status"] == "solved"]
    assert free and any(r["status"] == "colliding" for r in one["results"]), [r["status"] for r in one["results"]]
    # Another way to the same answer: the continuous check of a motion finds the first solution free, and no other one.
    for pick in free[:: max(1, len(free) // 5)]:
        names = one["joint_names"]
        motion = ["t," + ",".join(names)] + [f"{t}," + ",".join(map(repr, pick["joints"])) for t in (0, 1)]
        (folder / "still.csv").write_text("\n".join(motion) + "\n")
        check = run("trajectory", "check", folder / "still.csv", "--workcell", CELLS / "demo.hcell", "--entity", "robot")
        assert not [f for f in check["touching_at_start"] if not f["pair"][1].startswith("robot/")], (pick, check)

    ask = ["distance", "--moving", CELLS / "demo/housing.stl", "--environment", CELLS / "demo/table.stl", "--poses", folder / "poses.csv"]
    one, two = (run(*ask, "--jobs", jobs) for jobs in (1, 2))
    assert one["results"] == two["results"] and one["timing"]["per_second"] > 0
    hits = [i for i, r in enumerate(one["results"]) if r["colliding"]]
    ended = run(*ask, "--until-contact")
    assert len(ended["results"]) == (hits[0] + 1 if hits else 150)
    assert ended["results"] == one["results"][:len(ended["results"])]


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        study, expected, parts = rows_do_not_depend_on_how_they_were_made(folder)
        results_are_read(folder, expected)
        stops_are_made_good(folder, study, expected)
        strangers_are_found(folder, study, parts)
        a_full_disk_is_told(folder)
        batches_agree_with_single_answers(folder)
        faults_name_line_and_key(folder)
    print("ok")


main()
