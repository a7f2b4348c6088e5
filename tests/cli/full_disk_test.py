#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A disk without room: whatever a command was to write, the file that stood there stands, nothing else is left, the exit status
is 2 and one sentence says why. The disk is a small file system in memory, in a name space of its own; where the system
lets nobody make one, files are limited in size instead.

usage: full_disk_test.py HAPTICELL_CLI HAPTIC_SERVER
"""
import json
import math
import os
import pathlib
import resource
import signal
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
CELLS = ROOT / "config/workcells"
OLD = "OLD CONTENT " + 3000 * "x" + "\n"
FREE = 4096  # Bytes.
SMALL = {"c.csv", "r.csv", "m.json"}  # These would fit: for them there is no room at all.
INSIDE = "--on-a-small-disk"


def commands(cli, server, motion):
    """Name of the file that is written, and the command that writes it."""
    cell = CELLS / "demo.hcell"
    long_names = [word for part in ("table", "housing", "conveyor", "fence", "posts", "stop_rail")
                  for word in ("--add", f"{CELLS}/demo/{part}.stl,name={part}{900 * 'a'},unit=mm")]
    yield "n.hcell", [cli, "workcell", "new", "OUT"] + long_names
    yield "t.step", [cli, "convert", CELLS / "demo/table.stl", "--unit", "mm", "-o", "OUT"]
    for name in ("t.glb", "t.gltf", "t.stl", "t.ply", "t.off", "t.obj"):
        yield name, [cli, "convert", cell, "-o", "OUT"]
    yield "t.urdf", [cli, "convert", "library:hc6", "-o", "OUT"]
    for name in ("p.zip", "p.tar.gz"):
        yield name, [cli, "workcell", "pack", cell, "-o", "OUT"]
    yield "c.csv", [cli, "workcell", "changes", cell, CELLS / "car_door.hcell", "--all", "-o", "OUT"]
    yield "s.htraj", [cli, "trajectory", "simplify", motion, "--tolerance", "0.00001", "-o", "OUT"]
    for name, kind in (("s.csv", "csv"), ("s.src", "krl"), ("s.mod", "rapid"), ("s.LS", "fanuc")):
        yield name, [cli, "trajectory", "export", motion, "--to", kind, "-o", "OUT"]
    posture = ["--sex", "male", "--percentile", "50", "--posture", "standing"]
    for name in ("r.html", "r.csv", "r.json", "r.pdf"):
        yield name, [cli, "ergonomics", "posture", *posture, "--report", "OUT"]
    for name in ("m.obj", "m.json", "m.x3d"):
        yield name, [cli, "mannequin", *posture, "-o", "OUT"]
    yield "i.json", [cli, "--json", "OUT", "inspect", "library:hc6"]
    session = [cli, "session", "--workcell", cell, "--entity", "robot", "--hand", CELLS / "demo-hand.csv", "--seconds", "3"]
    yield "t.csv", [*session, "--trace", "OUT"]
    yield "d.hdev", [server, "--port", "0", "--seconds", "1", "--no-real-time", "--record", "OUT"]


def write_motion(path):
    rows = ["t,x,y,z,qw,qx,qy,qz"]
    rows += [f"{i / 100!r},{0.001 * i - 0.3!r},{0.1 * math.sin(i / 30)!r},0.5,1,0,0,0" for i in range(600)]
    path.write_text("\n".join(rows) + "\n")


def limit_files():
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))


def fill(folder, free):
    """Takes all room but so many bytes."""
    with open(folder / "fill", "wb", buffering=0) as file:
        try:
            while True:
                file.write(bytes(1024))
        except OSError:
            pass
        file.truncate(file.tell() // FREE * FREE - free)


def check(folder, elsewhere, name, words, is_small_disk):
    """Gives what is wrong, or None."""
    for left in folder.iterdir():
        subprocess.run(["rm", "-rf", left], check=True)
    out = folder / name
    out.write_text(OLD)
    if is_small_disk:
        fill(folder, 0 if name in SMALL else FREE)
    before = {path.name for path in folder.iterdir()}
    words = [str(out) if word == "OUT" else str(word) for word in words]
    environment = dict(os.environ, XDG_STATE_HOME=str(elsewhere / "state"), XDG_CACHE_HOME=str(elsewhere / "cache"))
    done = subprocess.run(words, cwd=elsewhere, env=environment, capture_output=True, text=True, timeout=120,
                          preexec_fn=None if is_small_disk else limit_files)
    sentence = done.stderr.strip().splitlines()[-1] if done.stderr.strip() else ""
    if done.returncode != 2:
        return f"exit status {done.returncode}: {sentence}"
    if out.read_text(errors="replace") != OLD:
        return "the old file does not stand"
    if {path.name for path in folder.iterdir()} != before:
        return f"left: {sorted({path.name for path in folder.iterdir()} - before)}"
    if not sentence or "Traceback" in done.stderr or "terminate" in done.stderr:
        return f"no sentence: {done.stderr}"
    return None


def run(cli, server, is_small_disk):
    failures, count = [], 0
    with tempfile.TemporaryDirectory() as base:
        folder, elsewhere = pathlib.Path(base, "full"), pathlib.Path(base, "elsewhere")
        folder.mkdir()
        elsewhere.mkdir()
        if is_small_disk:
            subprocess.run(["mount", "-t", "tmpfs", "-o", "size=1m", "tmpfs", folder], check=True)
        try:
            write_motion(elsewhere / "motion.csv")
            for name, words in commands(cli, server, elsewhere / "motion.csv"):
                wrong = check(folder, elsewhere, name, words, is_small_disk)
                count += 1
                if wrong:
                    failures.append(f"{name}: {wrong}")
        finally:
            if is_small_disk:
                subprocess.run(["umount", folder], check=True)
    print("\n".join(failures))
    print(f"{count - len(failures)} passed, {len(failures)} failed" + ("" if is_small_disk else " (files limited in size: no small disk here)"))
    return 1 if failures else 0


def main():
    if sys.argv[1] == INSIDE:
        return run(sys.argv[2], sys.argv[3], True)
    cli, server = (str(pathlib.Path(word).resolve()) for word in sys.argv[1:3])
    trial = "d=$(mktemp -d) && mount -t tmpfs tmpfs $d && umount $d && rmdir $d"
    for space in (["unshare", "-rm"], ["unshare", "-m"]):
        if subprocess.run([*space, "sh", "-c", trial], capture_output=True).returncode == 0:
            return subprocess.run([*space, sys.executable, __file__, INSIDE, cli, server]).returncode
    return run(cli, server, False)


if __name__ == "__main__":
    sys.exit(main())
