#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Man pages, completions and --version of all programs, and `hapticell-cli doctor`.

usage: shell_test.py PACKAGING_BUILD HAPTICELL_CLI PROGRAM...
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

BUILT, CLI = pathlib.Path(sys.argv[1]), sys.argv[2]
PROGRAMS = [program for program in sys.argv[2:] if program]
# Neither a display nor a platform for Qt: --help and --version need none.
BARE = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")}


def run(*words, expect=0, **more):
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True, timeout=120, env={**BARE, **more.pop("env", {})},
                          **more)
    assert expect is None or done.returncode == expect, (words, done.returncode, done.stdout, done.stderr)
    return done


def completed(*words):
    return [line.split("\t")[0] for line in run(CLI, "completion", "words", *words).stdout.splitlines()]


def test_version_says_commit_compiler_and_libraries():
    for program in PROGRAMS:
        lines = run(program, "--version").stdout.splitlines()
        name = pathlib.Path(program).name
        assert re.fullmatch(re.escape(name) + r" \d+\.\d+\.\d+", lines[0]), lines
        assert re.fullmatch(r"commit: ([0-9a-f]{7,40}|unknown)", lines[1]), lines
        assert re.match(r"compiler: (GCC|clang) \d+", lines[2]), lines
        assert re.match(r"libraries: \S+.* \d", lines[3]) and len(lines) == 4, lines


def test_every_option_of_help_stands_in_the_man_page():
    for program in PROGRAMS:
        page = (BUILT / "man" / f"{pathlib.Path(program).name}.1").read_text().replace("\\-", "-")
        assert ".SH NAME" in page and ".SH SYNOPSIS" in page and ".SH DESCRIPTION" in page
        for option in re.findall(r"(?m)^\s+(?:-\w, ?)?(--[a-z][a-z-]*)", run(program, "--help").stdout):
            assert option in page, (program, option)
    page = (BUILT / "man" / "hapticell-cli.1").read_text().replace("\\-", "-")
    for words in ("trajectory retime", "workcell pack", "doctor", "--fail-on-contact"):
        assert words in page, words
    if shutil.which("man"):
        for program in PROGRAMS:
            file = BUILT / "man" / f"{pathlib.Path(program).name}.1"
            said = run("man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", file, env={"LC_ALL": "C.UTF-8", "MANROFFSEQ": ""})
            faults = [line for line in said.stderr.splitlines() if "can't break line" not in line]  # A word longer than a line.
            assert not faults, faults


def test_completion_knows_commands_options_files_and_the_library():
    assert {"convert", "doctor", "trajectory"} <= set(completed("")), completed("")
    assert {"retime", "smooth"} <= set(completed("trajectory", ""))
    assert {"--robot", "--poses", "--json"} <= set(completed("ik", "--"))
    robots = completed("ik", "--robot", "")
    assert "library:ur5" in robots and any(line.startswith(":files ") and " urdf" in line for line in robots), robots
    assert ":files hcell" in completed("session", "--workcell", "")
    assert ":files hexercise" in completed("trajectory", "train", "")
    assert ":folders" in completed("trajectory", "exercises", "")
    assert {"en", "fr"} <= set(completed("ergonomics", "posture", "--language", ""))
    assert ":files hcell" in completed("workcell", "changes", "before.hcell", "")
    assert run(CLI, "completion", "tcsh", expect=2).stderr != ""


def test_bash_offers_them():
    if not shutil.which("bash"):
        return print("left out: bash is not installed")
    ask = r"""source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); compopt() { :; }; _hapticell_cli "$1"
printf '%s\n' "${COMPREPLY[@]}" """

    def offered(*words, folder=None):
        return run("bash", "-c", ask, "bash", BUILT / "completions" / "bash", CLI, *words, cwd=folder).stdout.split("\n")[:-1]

    assert offered("doc") == ["doctor"]
    with tempfile.TemporaryDirectory() as folder:
        for name in ("one cell.hcell", "two.HCELL", "part.stl"):
            (pathlib.Path(folder) / name).touch()
        (pathlib.Path(folder) / "sub").mkdir()
        found = offered("session", "--workcell", "", folder=folder)
        assert sorted(found) == ["one cell.hcell", "sub", "two.HCELL"], found


def test_zsh_and_fish_read_theirs():
    for shell in ("zsh", "fish"):
        if shutil.which(shell):
            run(shell, "-n", BUILT / "completions" / shell)
        else:
            print(f"left out: {shell} is not installed")
    if shutil.which("fish"):
        with tempfile.TemporaryDirectory() as home:
            said = run("fish", "-N", "-c", f"source {BUILT}/completions/fish; complete -C 'hapticell-cli trajectory ret'",
                       env={"PATH": f"{pathlib.Path(CLI).parent}:{os.environ['PATH']}", "HOME": home}).stdout
            assert {"retime", "retract"} == {line.split("\t")[0] for line in said.splitlines()}, said


def test_doctor_says_what_to_do():
    with tempfile.TemporaryDirectory() as home:
        environment = {"HOME": home, "XDG_STATE_HOME": f"{home}/state", "XDG_CONFIG_HOME": f"{home}/config"}
        text = run(CLI, "doctor", expect=None, env=environment)
        assert json.loads(text.stdout)["checks"]  # Into a pipe: the document, and the text beside it.
        told = run(CLI, "--json", "-", "doctor", expect=None, env=environment)
        document = json.loads(told.stdout)
        assert document["well"] == (told.returncode == 0) and told.returncode in (0, 1), told
        assert document["well"] == all(check["state"] != "problem" for check in document["checks"])
        names = [check["name"] for check in document["checks"]]
        for what in ("graphics card", "OpenGL", "real-time priority", "locked memory", "udev rules", "port 4747",
                     "disk, settings", "disk, copies"):
            assert what in names, (what, names)
        for check in document["checks"]:
            assert check["ok"] == (check["state"] != "problem"), check
            assert check["state"] in ("ok", "note", "problem") and check["found"], check
            assert (check["fix"] is None) == (check["state"] == "ok"), check
            assert check["found"] in text.stderr or "MB free" in check["found"], check
        file = pathlib.Path(home) / "report.json"
        run(CLI, "--json", file, "doctor", expect=None, env=environment)
        assert json.loads(file.read_text())["checks"]


for name, test in list(globals().items()):
    if name.startswith("test_"):
        test()
        print(f"passed: {name}")
