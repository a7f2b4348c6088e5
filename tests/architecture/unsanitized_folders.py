#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What reads files or texts from outside keeps its sanitizers in the preset `input`: no folder that the preset takes without
them holds a source that opens files or parses.

usage: unsanitized_folders.py PROJECT | --self-test
"""
import json
import pathlib
import re
import sys

READS = re.compile(r'#include "geometry/system/(?:regular_file|nesting_limit)\.h"|\bstd::(?:basic_)?i?fstream\b|[Jj]son::parse\s*\(|'
                   r"\btoml::parse")
ALLOWED = {
    "bridge/ros2/": "no test with the label `input` runs that program",
    "collision/surfaces/surface_cache.cpp": "the program's own cache", "collision/trees/tree_cache.cpp": "the program's own cache",
}


def offence(name, text):
    if any(name.startswith(key) for key in ALLOWED):
        return None
    found = READS.search(re.sub(r"//[^\n]*", "", text))
    return found and f"{name}: {found.group(0)} reads: take its folder off HAPTICELL_UNSANITIZED_FOLDERS in CMakePresets.json"


def self_test():
    assert offence("a/b.cpp", '#include "geometry/system/regular_file.h"') and offence("a/b.cpp", "const json x = json::parse(text);")
    assert offence("a/b.cpp", "std::ifstream in(file);") and not offence("a/b.cpp", "std::ofstream out(file); // std::ifstream")
    assert not offence("collision/trees/tree_cache.cpp", "std::ifstream in(file);")


self_test()
if sys.argv[1] != "--self-test":
    root = pathlib.Path(sys.argv[1])
    presets = json.loads((root / "CMakePresets.json").read_text(encoding="utf-8"))["configurePresets"]
    folders = next(p for p in presets if p["name"] == "input")["cacheVariables"]["HAPTICELL_UNSANITIZED_FOLDERS"].split(";")
    found = [f"{folder}: no such folder" for folder in folders if not (root / folder).is_dir()]
    for source in sorted(p for folder in folders for p in (root / folder).rglob("*") if p.suffix in (".cpp", ".h")):
        found += filter(None, [offence(source.relative_to(root).as_posix(), source.read_text(errors="replace"))])
    print("\n".join(found))
    sys.exit(1 if found else 0)
