#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A source outside tests/ has at most 400 lines: what is longer does several jobs, and each becomes a file with its own name.
LONGER lists those that are longer for now, with the lines that they may have: it may only shrink.

usage: file_lengths.py PROJECT | --self-test
"""
import pathlib
import sys

from source_folders import SOURCES

MOST_LINES = 400
FOLDERS = (*SOURCES, "bench", "examples", "tools")
LONGER = {
    "collision/pieces/separating_directions.cpp": 402,
    "collision/surfaces/surface_fit.cpp": 401,
    "app/agents/agents_panel.cpp": 418,
    "app/ergonomics/workplace_panel.cpp": 439,
    "app/studies/section_form.cpp": 427,
}


def offences(lines, longer):
    """Yields a sentence for each source of {name: lines} that is too long, and for each entry of `longer` that is out of date."""
    for name, count in sorted(lines.items()):
        most = longer.get(name, MOST_LINES)
        if count > most:
            yield f"{name}: {count} lines; at most {most}: give each of its jobs a file of its own"
    for name in sorted(longer):
        if lines.get(name, 0) <= MOST_LINES:
            yield f"{name}: is not over {MOST_LINES} lines any more: take it out of LONGER"


def self_test():
    assert not list(offences({"a/b.cpp": 400, "a/c.cpp": 500}, {"a/c.cpp": 500}))
    assert len(list(offences({"a/b.cpp": 401, "a/c.cpp": 501}, {"a/c.cpp": 500}))) == 2
    assert list(offences({"a/c.cpp": 400}, {"a/c.cpp": 500}))
    assert list(offences({}, {"a/c.cpp": 500})), "the file is gone"


if sys.argv[1] == "--self-test":
    self_test()
    sys.exit(0)
project, counts = pathlib.Path(sys.argv[1]), {}
for folder in FOLDERS:
    for source in sorted((project / folder).rglob("*")):
        if source.suffix in (".h", ".cpp"):
            counts[source.relative_to(project).as_posix()] = source.read_text(errors="replace").count("\n")
found = list(offences(counts, LONGER))
print("\n".join(found) or f"{len(counts)} sources are short, but for {len(LONGER)}")
assert len(counts) > 500, f"only {len(counts)} sources were found"
sys.exit(1 if found else 0)
