#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Keeps docs/architecture.md's table: a folder includes only the folders (and foreign libraries) it is allowed.

usage: folder_dependencies.py PROJECT_ROOT | --self-test
"""
import pathlib
import re
import sys

# Folder -> folders it may include besides itself. Kept in the order of docs/architecture.md.
ALLOWED = {
    "geometry": set(),
    "config": {"geometry"},
    "collision": {"geometry"},
    "kinematics": {"geometry"},
    "mannequin": {"geometry", "kinematics"},
    "mannequin/ergonomics": {"geometry", "mannequin"},
    "trajectory": {"geometry", "kinematics"},
    "trajectory/checks": {"geometry", "trajectory"},
    "haptic/rendering": {"geometry"},
    "haptic/protocol": {"geometry", "haptic/rendering"},
    "haptic/devices": {"geometry", "config", "haptic/rendering", "haptic/protocol"},
    "haptic/client": {"geometry", "config", "haptic/rendering", "haptic/protocol"},
    "haptic/server": {"geometry", "config", "haptic/rendering", "haptic/protocol", "haptic/devices",
                      "haptic/client"},
    "xacro": {"geometry"},
    "workcell": {"geometry", "xacro", "config", "collision", "kinematics", "mannequin", "mannequin/ergonomics", "trajectory"},
    "importer": {"geometry", "workcell"},
    "manipulation": {"geometry", "config", "collision", "kinematics", "mannequin", "mannequin/ergonomics", "trajectory", "trajectory/checks", "workcell", "haptic/rendering",
                     "haptic/protocol", "haptic/devices", "haptic/server", "haptic/client"},
    "feel": {"geometry", "config", "collision", "kinematics", "trajectory", "workcell", "manipulation",
             "haptic/rendering", "haptic/protocol", "haptic/devices", "haptic/server", "haptic/client"},
    "cli": {"*"},
    "app": {"*"},
}
# Foreign headers that only some folders may see.
FOREIGN = {
    r"^Q[A-Z]|^QtCore|^Qt": {"app"},
    r"^tinyxml": {"workcell", "xacro"},
    r"^yaml-cpp/": {"trajectory", "xacro"},
    r"^archive": {"workcell", "importer"},
    r"^meshoptimizer": {"mannequin", "workcell", "importer", "app"},
    r"^toml\+\+": {"config", "mannequin", "workcell"},
    r"^asio": {"haptic/server", "haptic/client"},
    r"^openssl/": {"haptic/client"},
    r"^CLI/": {"cli"},
    r"^cairo": {"mannequin"},
    r"^OpenMesh/": {"geometry"},
    r"^flatbuffers/": {"haptic/protocol"},
    r"^(Standard|TopoDS|STEP|XCAF|gp_|BRep|TDF_|Poly_|IGES|assimp/)": {"importer"},
}
# Eigen stays inside .cpp files.
SOURCE_ONLY = re.compile(r"^Eigen/")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def folder_of(path):
    parts = path.split("/")
    if len(parts) < 2:
        return None
    two = "/".join(parts[:2])
    if two in ALLOWED:
        return two
    return parts[0] if parts[0] in ALLOWED else None


def offences(name, text):
    """Yields a sentence for each include in the file `name` (relative to the root) that the table forbids."""
    own = folder_of(name)
    if own is None:
        return
    for number, line in enumerate(text.splitlines(), 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        target = match.group(2)
        used = folder_of(target)
        if used and used != own and "*" not in ALLOWED[own] and used not in ALLOWED[own]:
            yield f"{name}:{number}: {own}/ may not use {used}/ ({target})"
        if SOURCE_ONLY.match(target) and name.endswith(".h"):
            yield f"{name}:{number}: Eigen belongs in .cpp files only"
        for pattern, folders in FOREIGN.items():
            if re.match(pattern, target) and own.split("/")[0] not in folders and own not in folders:
                yield f"{name}:{number}: only {', '.join(sorted(folders))} may include {target}"


def self_test():
    def found(name, line):
        return list(offences(name, line + "\n"))

    assert found("geometry/a.cpp", '#include "collision/b.h"')
    assert found("collision/a.h", "#include <Eigen/Core>")
    assert found("haptic/server/a.cpp", "#include <QString>")
    assert found("haptic/rendering/a.cpp", '#include "haptic/server/loop.h"')
    assert found("workcell/a.cpp", "#include <STEPCAFControl_Reader.hxx>")
    assert found("app/a.cpp", "#include <assimp/scene.h>")
    assert not found("importer/a.cpp", "#include <STEPCAFControl_Reader.hxx>")
    assert not found("collision/a.cpp", "#include <Eigen/Core>")
    assert not found("collision/a.cpp", '#include "geometry/pose.h"')
    assert not found("manipulation/a.cpp", '#include "haptic/client/haptic_link.h"')
    assert not found("app/a.cpp", "#include <QString>")


def main():
    if sys.argv[1] == "--self-test":
        self_test()
        print("1 passed, 0 failed")
        return 0
    root = pathlib.Path(sys.argv[1])
    bad, read = [], 0
    for folder in sorted({name.split("/")[0] for name in ALLOWED}):
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                read += 1
                bad += offences(path.relative_to(root).as_posix(), path.read_text(encoding="utf-8"))
    print("\n".join(bad) if bad else f"{read} files keep the table")
    return 1 if bad or read == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
