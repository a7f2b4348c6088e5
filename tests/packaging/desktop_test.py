#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The desktop entry, what a software centre shows, and the kinds of files, each by the tool that judges it.

usage: desktop_test.py PACKAGING_DESKTOP ICONS
A tool that is not installed leaves its test out with a sentence; where all are missing the whole is skipped (77).
"""
import configparser
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

DESKTOP, ICONS = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
OWN = {"cell.hcell": "application/x-hapticell-workcell", "a.htraj": "application/x-hapticell-motion",
       "a.hexercise": "application/x-hapticell-exercise", "a.htrain": "application/x-hapticell-training",
       "a.hstudy": "application/x-hapticell-study", "a.hresults": "application/x-hapticell-study-results"}
OTHERS = {"a.step": "model/step", "a.stp": "model/step", "a.iges": "model/iges", "a.stl": "model/stl",
          "a.urdf": "application/x-urdf+xml", "a.mcap": "application/x-mcap"}


def call(*words, **more):
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True, timeout=120, **more)
    assert done.returncode == 0, (words, done.returncode, done.stdout, done.stderr)
    return done.stdout.strip()


def entry():
    parser = configparser.ConfigParser(interpolation=None, strict=True)
    parser.optionxform = str
    parser.read(DESKTOP / "hapticell.desktop", encoding="utf-8")
    return parser["Desktop Entry"]


def test_entry_is_valid(_folder):
    assert call("desktop-file-validate", DESKTOP / "hapticell.desktop") == ""


def test_what_a_software_centre_shows_is_valid(_folder):
    call("appstreamcli", "validate", "--no-net", DESKTOP / "hapticell.metainfo.xml")


def test_a_file_is_of_its_kind_and_opens_here(folder):
    share = folder / "share"
    (share / "mime" / "packages").mkdir(parents=True)
    (share / "applications").mkdir()
    shutil.copy(DESKTOP / "hapticell-mime.xml", share / "mime" / "packages" / "hapticell.xml")
    shutil.copy(DESKTOP / "hapticell.desktop", share / "applications")
    call("update-mime-database", share / "mime")
    environment = {**os.environ, "XDG_DATA_HOME": str(share), "XDG_CONFIG_HOME": str(folder / "config"), "HOME": str(folder),
                   "XDG_CURRENT_DESKTOP": "GNOME", "DE": "gnome"}  # It asks gio then.
    opened = entry()["MimeType"].split(";")
    for name, kind in {**OWN, **OTHERS}.items():
        file = folder / name
        file.write_text("{}" if name in OWN else "solid\n")
        found = call("xdg-mime", "query", "filetype", file, env=environment)
        assert found == kind, (name, found, kind)
        assert kind in opened, kind


def test_each_kind_has_its_icon_at_all_sizes(_folder):
    names = [f"mimetypes/{kind.replace('/', '-')}" for kind in OWN.values()] + [f"apps/{entry()['Icon']}"]
    sizes = [f"{size}x{size}" for size in (16, 22, 24, 32, 48, 64, 128, 256, 512)]
    for name in names:
        assert (ICONS / "scalable" / f"{name}.svg").is_file(), name
        for size in sizes if shutil.which("rsvg-convert") else []:
            picture = (ICONS / size / f"{name}.png").read_bytes()
            assert picture[:8] == b"\x89PNG\r\n\x1a\n" and int.from_bytes(picture[16:20], "big") == int(size.split("x")[0]), name


TESTS = [(test_entry_is_valid, ["desktop-file-validate"]), (test_what_a_software_centre_shows_is_valid, ["appstreamcli"]),
         (test_a_file_is_of_its_kind_and_opens_here, ["update-mime-database", "xdg-mime", "gio"]),
         (test_each_kind_has_its_icon_at_all_sizes, [])]
done = 0
for test, tools in TESTS:
    missing = [tool for tool in tools if shutil.which(tool) is None]
    if missing:
        print(f"left out: {test.__name__}: {' and '.join(missing)} is not installed")
        continue
    with tempfile.TemporaryDirectory() as folder:
        test(pathlib.Path(folder))
    print(f"passed: {test.__name__}")
    done += 1
sys.exit(0 if done else 77)
