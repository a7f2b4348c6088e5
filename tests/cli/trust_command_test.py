#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What the command line believes and what not: files that a workcell names, the user's folders, servers, typed codes.

usage: trust_command_test.py HAPTICELL_CLI HAPTICELL_HAPTIC_SERVER WORKCELLS [NAME_PART]
"""
import json
import os
import pathlib
import pty
import select
import signal
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "haptic" / "server"))
from server_process import Server

CLI, SERVER, WORKCELLS = (str(pathlib.Path(word).resolve()) for word in sys.argv[1:4])
TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"


def run(*words, folder, expect=0, code=None, **environment):
    known = {name: str(value) for name, value in {**os.environ, **environment}.items() if value is not None}
    given = {"stdin": subprocess.DEVNULL} if code is None else {"input": code}
    done = subprocess.run([CLI, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=120,
                          cwd=folder, env=known, **given)
    assert done.returncode == expect, (done.returncode, done.stderr)
    return done


def write_cell(folder, entities, trajectories=()):
    (folder / "cell.hcell").write_text(json.dumps(
        {"format": "hapticell-workcell", "version": 1, "entities": list(entities), "trajectories": list(trajectories)}))


def part(name, file, kind="solid"):
    return {"name": name, "kind": kind, "source": {"file": str(file)}}


def test_a_pack_takes_no_file_that_is_nothing_of_a_workcell(folder):
    (folder / "part.obj").write_text(TRIANGLE)
    for entities, trajectories in (([part("part", "part.obj"), part("all", "/etc/passwd", "assembly")], []),
                                   ([part("part", "part.obj")], [{"name": "way", "file": "/etc/passwd"}])):
        write_cell(folder, entities, trajectories)
        for options in ([], ["--allow-outside"]):
            said = run("workcell", "pack", "cell.hcell", "-o", "pack.zip", *options, folder=folder, expect=2).stderr
            assert "/etc/passwd" in said, said
            assert sorted(p.name for p in folder.iterdir()) == ["cell.hcell", "part.obj"], list(folder.iterdir())


def test_a_pack_lists_what_lies_outside_and_takes_it_when_told(folder):
    for name in ("cells", "parts"):
        (folder / name).mkdir()
    (folder / "parts" / "far.obj").write_text(TRIANGLE)
    (folder / "cells" / "near.obj").write_text(TRIANGLE)
    write_cell(folder / "cells", [part("far", "../parts/far.obj"), part("near", "near.obj")])
    said = run("workcell", "pack", "cells/cell.hcell", "-o", "pack", folder=folder, expect=2).stderr
    assert str(folder / "parts" / "far.obj") in said and "--allow-outside" in said and "near.obj" not in said, said
    assert not (folder / "pack").exists()
    made = json.loads(run("workcell", "pack", "cells/cell.hcell", "-o", "pack", "--allow-outside", folder=folder).stdout)
    assert sorted(made["files"]) == ["files/far.obj", "files/near.obj"], made
    assert made["outside"] == [str(folder / "parts" / "far.obj")], made


def test_nothing_is_found_in_the_current_folder(folder):
    for place in (".config/hapticell", "hapticell"):
        (folder / place).mkdir(parents=True)
        (folder / place / "hapticell.toml").write_text("nonsense = true\n")
    (folder / ".local/lib/hapticell/drivers").mkdir(parents=True)
    for home in (None, "", "."):
        said = run("devices", folder=folder, expect=2, HOME=home, XDG_CONFIG_HOME=None).stderr
        assert "HOME" in said and "nonsense" not in said, said
    listing = json.loads(run("devices", folder=folder, HOME="/nonexistent", XDG_CONFIG_HOME=".",
                             HAPTICELL_DRIVERS="drivers:.").stdout)
    assert all(entry.startswith("/") for entry in listing["driver_folders"]), listing["driver_folders"]


def test_settings_and_plug_ins_that_others_may_write_are_refused(folder):
    settings = folder / "cfg" / "hapticell"
    settings.mkdir(parents=True)
    (settings / "hapticell.toml").write_text("[server]\nport = 4848\n")
    run("devices", folder=folder, XDG_CONFIG_HOME=folder / "cfg")
    settings.chmod(0o777)
    said = run("devices", folder=folder, expect=2, XDG_CONFIG_HOME=folder / "cfg").stderr
    assert "other users can write to it" in said and "chmod" in said, said
    drivers = folder / "drivers"
    drivers.mkdir()
    (drivers / "odd.so").write_bytes(b"")
    (drivers / "odd.so").chmod(0o666)
    listing = json.loads(run("devices", folder=folder, HAPTICELL_DRIVERS=drivers).stdout)
    odd = next(driver for driver in listing["drivers"] if driver["name"] == "odd")
    assert not odd["usable"] and "other users can write" in odd["problem"], odd


def code_of(folder):
    environment = dict(os.environ, XDG_CONFIG_HOME=str(folder / "server"))
    done = subprocess.run([SERVER, "--pair"], capture_output=True, text=True, timeout=60, env=environment)
    assert done.returncode == 0, done.stderr
    return done.stdout.strip()


def test_a_pairing_code_is_read_from_standard_input(folder):
    code = code_of(folder)
    key = folder / "cfg/hapticell/servers/scene.example_4747.key"
    for words in (["scene.example"], ["scene.example", "-"]):
        run("pair", *words, "--unchecked", folder=folder, code=code + "\n", XDG_CONFIG_HOME=folder / "cfg")
        assert key.read_text().strip() == code
        key.unlink()
    said = run("pair", "scene.example", "--unchecked", folder=folder, code="", expect=2, XDG_CONFIG_HOME=folder / "cfg").stderr
    assert "pairing code" in said, said
    said = run("pair", "scene.example", code, "--unchecked", folder=folder, XDG_CONFIG_HOME=folder / "cfg").stderr
    assert "Every user of this machine can see" in said, said


def test_a_pairing_code_is_typed_without_being_shown(folder):
    code = code_of(folder)
    child, terminal = pty.fork()
    if child == 0:
        os.environ["XDG_CONFIG_HOME"] = str(folder / "cfg")
        os.execv(CLI, [CLI, "pair", "scene.example", "--unchecked"])
    shown, asked, end = b"", False, time.monotonic() + 60
    while time.monotonic() < end:
        if select.select([terminal], [], [], 0.1)[0]:
            try:
                got = os.read(terminal, 4096)
            except OSError:
                break
            shown += got
        if b"not shown" in shown and not asked:
            asked = True
            time.sleep(0.3)  # Until the echo is off, as for somebody who types.
            os.write(terminal, code.encode() + b"\n")
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0, shown
    assert asked and code.encode() not in shown, shown
    assert (folder / "cfg/hapticell/servers/scene.example_4747.key").read_text().strip() == code


def test_a_session_whose_server_is_lost_fails_and_says_when(folder):
    cell = pathlib.Path(WORKCELLS) / "demo.hcell"
    hand = folder / "hand.csv"
    hand.write_text("t,x,y,z,qw,qx,qy,qz,button\n0,0,0,0,1,0,0,0,0\n20,0,0,0.01,1,0,0,0,0\n")
    for number in (signal.SIGKILL, signal.SIGTERM, signal.SIGSTOP):
        with Server(SERVER) as server:
            session = subprocess.Popen(
                [CLI, "session", "--workcell", cell, "--entity", "robot", "--hand", hand, "--realtime", "--server",
                 f"127.0.0.1:{server.port}", "--trace", "trace.csv", "--record", "way.htraj"],
                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=folder)
            while "controls the stylus" not in server.process.stderr.readline():
                assert session.poll() is None, session.communicate()
            time.sleep(1.5)
            server.process.send_signal(number)
            out, errors = session.communicate(timeout=120)
            if number == signal.SIGSTOP:
                server.process.send_signal(signal.SIGCONT)
        assert session.returncode == 2, (number, session.returncode, errors)
        assert out == "" and "was lost after" in errors and " s" in errors, (number, out, errors)
        assert not (folder / "trace.csv").exists() and not (folder / "way.htraj").exists()


wanted = sys.argv[4] if len(sys.argv) > 4 else ""
for name, test in list(globals().items()):
    if name.startswith("test_") and wanted in name:
        with tempfile.TemporaryDirectory() as made:
            test(pathlib.Path(made).resolve())
        print("passed", name, flush=True)
