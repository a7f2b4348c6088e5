#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Keeps the public interface whole (docs/library/index.md). Public is what a folder of the engine lists as HEADERS in its
CMakeLists.txt: a public header includes public ones only, and so do the programs over the engine (cli/, app/), their tests and
the examples.

usage: public_headers.py PROJECT_ROOT | --list PROJECT_ROOT (prints the public headers) | --self-test
"""
import pathlib
import re
import sys

ENGINE = ["geometry", "config", "collision", "kinematics", "mannequin", "trajectory", "haptic", "xacro", "workcell",
          "manipulation", "feel", "studies", "agents"]
USERS = ["cli", "app", "examples", "tests/cli", "tests/app", "tests/consumer"]
LIBRARY = re.compile(r"hapticell_add_library\((.*?)\)\n", re.DOTALL)
HEADERS = re.compile(r"\bHEADERS\s+((?:[\w/]+\.h\s*)+)")
INCLUDE = re.compile(r'^\s*#\s*include\s*["<]([^">]+)[">]', re.MULTILINE)


def listed_headers(text):
    """The public headers of a CMakeLists.txt, by their names in it."""
    return [name for library in LIBRARY.findall(text + "\n") for found in HEADERS.findall(library) for name in found.split()]


def offences(name, text, public, all_headers):
    """Yields a sentence for each header of the engine in `text` that is not public."""
    for used in INCLUDE.findall(text):
        if used in all_headers and used not in public:
            yield f"{name} includes {used}, which is not public: list it as one of the HEADERS of its folder, or do without"


def self_test():
    text = "hapticell_add_library(a\n  SOURCES a.cpp c.h\n  HEADERS a.h\n    b.h\n  PUBLIC hapticell::d)\n"
    assert listed_headers(text) == ["a.h", "b.h"]
    assert not list(offences("x.h", '#include "d/a.h"\n#include <vector>\n', {"d/a.h"}, {"d/a.h", "d/c.h"}))
    assert list(offences("x.h", '#include "d/c.h"\n', {"d/a.h"}, {"d/a.h", "d/c.h"}))
    assert list(offences("x.cpp", "#include <d/c.h>\n", {"d/a.h"}, {"d/a.h", "d/c.h"}))


def main():
    if sys.argv[1] == "--self-test":
        self_test()
        print("1 passed, 0 failed")
        return 0
    root = pathlib.Path(sys.argv[-1])
    public, all_headers, internal, bad, read = set(), set(), set(), [], 0
    for top in ENGINE:
        all_headers |= {path.relative_to(root).as_posix() for path in (root / top).rglob("*.h")}
        for lists in (root / top).rglob("CMakeLists.txt"):
            folder = lists.parent.relative_to(root).as_posix()
            text = lists.read_text(encoding="utf-8")
            public |= {f"{folder}/{name}" for name in listed_headers(text)}
            # Headers of internal libraries are for the programs alone.
            internal |= {f"{folder}/{name}" for library in LIBRARY.findall(text + "\n") if " INTERNAL" in library
                         for name in re.findall(r"[\w/]+\.h", library)}
    if sys.argv[1] == "--list":
        print("\n".join(sorted(public)))
        return 0
    public -= internal
    all_headers = {name for name in all_headers - internal if not name.startswith("haptic/devices/drivers/")}
    bad += [f"{name} is listed, but is not there" for name in sorted(public - all_headers)]
    sources = [root / name for name in sorted(public & all_headers)]
    for top in USERS:
        sources += sorted(path for path in (root / top).rglob("*") if path.suffix in (".h", ".cpp"))
    for path in sources:
        read += 1
        bad += offences(path.relative_to(root).as_posix(), path.read_text(encoding="utf-8"), public, all_headers)
    print("\n".join(bad) if bad else f"{len(public)} of {len(all_headers)} headers are public; {read} files keep to them")
    return 1 if bad or not public else 0


if __name__ == "__main__":
    sys.exit(main())
