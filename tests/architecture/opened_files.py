#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What users name is opened by geometry/system/regular_file.h only, which refuses pipes and devices; texts that nest are looked at by
geometry/system/nesting_limit.h before a library that recurses reads them.

usage: opened_files.py PROJECT | --self-test
"""
import pathlib
import re
import sys

OPENERS = re.compile(r"\bstd::(?:basic_)?i?fstream\b|\bf(?:re)?open\s*\(|::open\s*\([^;]*O_RD|\bparse_file\s*\(|\bLoad(?:All)?(?:From)?File\s*\(|"
                     r"\bload_file\s*\(|\.LoadFile\s*\(|\barchive_read_open_filename\s*\(")
PARSERS = re.compile(r"\bjson::parse\s*\(|\bJson::parse\s*\(|\btoml::parse\s*\(|\.Parse\s*\(\w|\bload_(?:buffer|buffer_inplace|string)\s*\(")

# Folders and files that open what the system or this program itself made, or what they asked about before.
OPEN_ALLOWED = {
    "geometry/system/regular_file.cpp": "it is the place",
    "haptic/devices/drivers/": "nodes of the system: devices are what they are for",
    "haptic/devices/usb_scan.cpp": "files of sysfs",
    "haptic/transport/pairing_key.cpp": "a file of the user's own settings, asked about by stat() before",
    "collision/trees/tree_cache.cpp": "the program's own cache", "collision/surfaces/surface_cache.cpp": "the program's own cache",
    "config/program_log.cpp": "a lock beside the program's own log",
    "workcell/files/autosave.cpp": "locks beside the program's own copies", "workcell/text/file_content.cpp": "writes only",
    "workcell/files/pack.cpp": "copies of files that were read", "workcell/files/pack_check.cpp": "what was just written",
    "workcell/files/archive.cpp": "what stands in the folder that was just made",
    "importer/model_package.cpp": "asks checkRegularFile() before", "importer/step_text.cpp": "asks readFileContent() before",
    "geometry/system/unfinished_files.cpp": "the program's own, and files of proc", "geometry/system/scratch_folder.cpp": "folders that the program made",
    "haptic/server/peer_process.cpp": "files of proc", "workcell/files/document_lock.cpp": "opened without waiting, 4 kB are read at most",
    "bench/": "no part of the programs", "app/shell/crash_guard.cpp": "writes only",
}
PARSE_ALLOWED = {
    "cli/mannequin/mannequin_command.cpp": "text that was just written", "workcell/format/entity_format.cpp": "text that this program wrote of what it had read",
    "cli/device/device_list.cpp": "told by this program's own child", "haptic/devices/drivers/haply/haply_messages.cpp": "a message of bounded length",
    "workcell/files/autosave.cpp": "what the program wrote beside its own copies", "workcell/files/document_lock.cpp": "4 kB at most",
    "bench/": "no part of the programs",
}
SKIPPED = ("build", "tests", ".git", "examples", "tools")


def allowed(name, table):
    return any(name == key or (key.endswith("/") and name.startswith(key)) for key, why in table.items() if why)


def offences(name, text):
    code = re.sub(r"//[^\n]*", "", text)
    found = []
    if not allowed(name, OPEN_ALLOWED):
        found += [f"{name}: {m.group(0).strip()} opens what may be a pipe or a device: use geometry/system/regular_file.h"
                  for m in OPENERS.finditer(code)]
    if not allowed(name, PARSE_ALLOWED) and PARSERS.search(code) and "checkNesting" not in code:
        found.append(f"{name}: {PARSERS.search(code).group(0)} recurses as deep as its text nests: ask geometry::checkNesting() before")
    return found


def self_test():
    assert offences("a/b.cpp", "std::ifstream stream(file);") and offences("a/b.cpp", "toml::parse_file(path)")
    assert offences("a/b.cpp", "json::parse(text)") and not offences("a/b.cpp", "checkNesting(text); json::parse(text)")
    assert not offences("geometry/system/regular_file.cpp", "::open(p, O_RDONLY)") and not offences("a/b.cpp", "// std::ifstream")
    assert offences("a/b.cpp", "::open(path.c_str(), O_RDONLY | O_CLOEXEC)") and not offences("a/b.cpp", "std::ofstream out(file);")


self_test()
if sys.argv[1] != "--self-test":
    root = pathlib.Path(sys.argv[1])
    sources = [p for p in root.rglob("*") if p.suffix in (".cpp", ".h") and p.relative_to(root).parts[0] not in SKIPPED]
    assert len(sources) > 500, "the project is elsewhere"
    found = [line for p in sorted(sources) for line in offences(p.relative_to(root).as_posix(), p.read_text(errors="replace"))]
    print("\n".join(found))
    sys.exit(1 if found else 0)
