#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every picture of the documents is shown by one and can be retaken, and none is retaken in vain.

usage: pictures_test.py DOCS_PICTURES_PROGRAM PROJECT_ROOT
"""
import pathlib
import re
import subprocess
import sys

PICTURE = re.compile(r"!\[[^\]]*\]\(([^()\s]+)\)")


def lines(*command):
    return set(subprocess.run(command, check=True, capture_output=True, text=True).stdout.split())


def main(program, root):
    folder = root / "docs/pictures"
    kept = {str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file()}
    shown = set()
    for page in [root / "README.md", *(root / "docs").rglob("*.md")]:
        for target in PICTURE.findall(page.read_text(encoding="utf-8")):
            path = (page.parent / target).resolve()
            if path.is_relative_to(folder):
                shown.add(str(path.relative_to(folder)))
    taken = {name + ".png" for name in lines(program, "--list")} | lines(root / "tools/take_pictures", "--others")
    faults = [f"docs/pictures/{name}: no document shows it" for name in sorted(kept - shown)]
    faults += [f"docs/pictures/{name}: neither docs_pictures nor another program takes it" for name in sorted(kept - taken)]
    faults += [f"docs/pictures/{name}: is taken, but is not there" for name in sorted(taken - kept)]
    faults += [f"docs/pictures/{name}: {(folder / name).stat().st_size} bytes are too many"
               for name in sorted(kept) if (folder / name).stat().st_size > 600_000]
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()))
