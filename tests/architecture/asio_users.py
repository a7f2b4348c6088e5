#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every source that includes asio, itself or through the project's headers, is compiled with hapticell_asio's definitions.

usage: asio_users.py PROJECT compile_commands.json
"""
import functools
import json
import pathlib
import re
import sys

PROJECT, COMMANDS = pathlib.Path(sys.argv[1]), sys.argv[2]
FOREIGN = {"asio/": "-DASIO_DISABLE_STD_ALIGNED_ALLOC",
           "boost/asio": "-DBOOST_ASIO_DISABLE_STD_ALIGNED_ALLOC", "boost/beast": "-DBOOST_ASIO_DISABLE_STD_ALIGNED_ALLOC"}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


@functools.cache
def needed(file):
    """What `file` must be compiled with."""
    definitions = set()
    for bracket, name in INCLUDE.findall(file.read_text(errors="replace")):
        if bracket == "<":
            definitions |= {word for prefix, word in FOREIGN.items() if name.startswith(prefix)}
        elif (PROJECT / name).is_file():
            definitions |= needed(PROJECT / name)
    return frozenset(definitions)


users, offenders = 0, []
for entry in json.loads(pathlib.Path(COMMANDS).read_text()):
    source = pathlib.Path(entry["directory"], entry["file"])
    if PROJECT not in source.parents or not source.is_file():
        continue
    wanted = needed(source)
    users += bool(wanted)
    missing = wanted - set(entry["command"].split())
    offenders += [f"{source.relative_to(PROJECT)} lacks {word}: link hapticell_asio" for word in sorted(missing)]
print("\n".join(offenders))
assert users > 0, "no source includes asio any more: this check can go"
sys.exit(1 if offenders else 0)
