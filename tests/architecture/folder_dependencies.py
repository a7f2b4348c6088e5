#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Keeps the order of the folders: folders.txt lists all of them bottom to top, and a file includes only what lies in its own
folder or in one above it in that list. There are no exceptions.

Besides: which top folders a top folder may use, which foreign headers belong where, that a folder directly holds at most
30 sources (a header and its source count as one) and a README.md, and that tests mirror the folders.

usage: folder_dependencies.py PROJECT_ROOT | --self-test
       folder_dependencies.py --users FOLDER     the top folders with files that need FOLDER, one way or another
"""
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
ORDER = [line.split("#")[0].strip() for line in (HERE / "folders.txt").read_text().splitlines() if line.split("#")[0].strip()]
MOST_SOURCES = 30

# Which folders the files below a folder may include besides those below the same one. "*": any lower one.
ENGINES = {"geometry", "config", "collision", "kinematics", "mannequin", "trajectory"}
ALLOWED = {
    "geometry": set(),
    "config": {"geometry"},
    "collision": {"geometry"},
    "kinematics": {"geometry"},
    "mannequin": {"geometry", "kinematics"},
    "trajectory": {"geometry", "kinematics"},
    "exchange": {"geometry", "trajectory"},
    "haptic/rendering": {"geometry"},
    "haptic/protocol": {"geometry", "haptic/rendering"},
    "haptic/transport": {"geometry", "config", "haptic/rendering", "haptic/protocol"},
    "haptic/devices": {"geometry", "config", "haptic/rendering", "haptic/protocol"},
    "haptic/server": {"geometry", "config", "haptic/rendering", "haptic/protocol", "haptic/transport", "haptic/devices"},
    "haptic/client": {"geometry", "config", "haptic/rendering", "haptic/protocol", "haptic/transport"},
    "xacro": {"geometry"},
    "workcell": ENGINES | {"xacro"},
    "importer": {"config", "geometry", "workcell"},
    "manipulation": ENGINES | {"workcell", "haptic"},
    "feel": ENGINES - {"mannequin"} | {"workcell", "manipulation", "haptic"},
    "planning": ENGINES | {"workcell", "manipulation"},
    "studies": ENGINES | {"workcell", "manipulation", "planning"},
    "bridge": {"*"},
    "access": ENGINES | {"workcell", "manipulation", "planning"},
    "agents": ENGINES | {"workcell", "manipulation", "planning"},
    "cli": {"*"},
    "python": {"*"},
    "app": {"*"},
}
# Tests that belong to no folder of the program, or serve several of one.
TESTS_BESIDE = {"support", "architecture", "consumer", "fuzz", "app/docs_pictures", "app/pages", "haptic/devices/odd_drivers"}
# Foreign headers that only some folders may see.
FOREIGN = {
    r"^Q[A-Z]|^QtCore|^Qt": {"app"},
    r"^tinyxml": {"workcell", "xacro"},
    r"^yaml-cpp/": {"trajectory", "xacro"},
    r"^archive": {"workcell", "importer"},
    r"^meshoptimizer": {"mannequin", "workcell", "importer", "app"},
    r"^toml\+\+": {"agents", "config", "mannequin", "studies", "workcell"},
    r"^sqlite3": {"studies"},
    r"^nlopt": {"studies"},
    r"^ompl/": {"planning"},
    r"^(zstd|lz4)": {"exchange"},
    r"^(dds/|ros2_messages)": {"bridge"},
    r"^(oneapi/)?tbb/": {"agents", "collision", "manipulation", "studies"},
    r"^asio": {"haptic/transport", "haptic/server", "haptic/client"},
    r"^openssl/": {"haptic/transport"},
    r"^CLI/": {"cli"},
    r"^pybind11/": {"python"},
    r"^cairo": {"mannequin"},
    r"^OpenMesh/": {"geometry"},
    r"^flatbuffers/": {"haptic/protocol"},
    r"^(Standard|TopoDS|STEP|XCAF|gp_|BRep|TDF_|Poly_|IGES|assimp/)": {"importer"},
}
# Eigen stays inside .cpp files.
SOURCE_ONLY = re.compile(r"^Eigen/")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def room_of(path):
    """The entry of ALLOWED that a path belongs to."""
    parts = path.split("/")
    two = "/".join(parts[:2])
    return two if two in ALLOWED else parts[0] if parts[0] in ALLOWED and len(parts) > 1 else None


def offences(name, text):
    """Yields a sentence for each include in the file `name` (relative to the root) that is not allowed."""
    folder, room = name.rpartition("/")[0], room_of(name)
    if room is None:
        return
    for number, line in enumerate(text.splitlines(), 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        target = match.group(2)
        used, used_room = target.rpartition("/")[0], room_of(target)
        if used_room and used_room != room:
            allowed = ALLOWED[room]
            if "*" not in allowed and used_room not in allowed and used_room.split("/")[0] not in allowed:
                yield f"{name}:{number}: {room}/ may not use {used_room}/ ({target})"
        if used in ORDER and folder in ORDER and ORDER.index(used) > ORDER.index(folder):
            yield f"{name}:{number}: {folder}/ lies below {used}/ and may not use it ({target})"
        if SOURCE_ONLY.match(target) and name.endswith(".h"):
            yield f"{name}:{number}: Eigen belongs in .cpp files only"
        for pattern, folders in FOREIGN.items():
            if re.match(pattern, target) and room.split("/")[0] not in folders and room not in folders:
                yield f"{name}:{number}: only {', '.join(sorted(folders))} may include {target}"


def crowding(folder, names, has_readme):
    """Yields what is wrong with what lies in a folder directly."""
    stems = {name.rpartition(".")[0] for name in names}
    if len(stems) > MOST_SOURCES:
        yield f"{folder}/ holds {len(stems)} sources; at most {MOST_SOURCES}: make a sub-folder"
    if folder not in ORDER:
        yield f"{folder}/ is not in tests/architecture/folders.txt"
    if not has_readme:
        yield f"{folder}/ has no README.md that says what lives there, what it may use and where to begin reading"


def self_test():
    def found(name, line):
        return list(offences(name, line + "\n"))

    assert found("geometry/shapes/a.cpp", '#include "collision/trees/b.h"')
    assert found("workcell/text/a.cpp", '#include "workcell/files/b.h"')
    assert not found("workcell/files/a.cpp", '#include "workcell/text/b.h"')
    assert found("app/style/a.cpp", '#include "app/shell/b.h"')
    assert list(crowding("workcell/text", [f"{n}.h" for n in range(31)], True))
    assert not list(crowding("workcell/text", [f"{n}.{e}" for n in range(30) for e in ("h", "cpp")], True))
    assert list(crowding("workcell/text", [], False)) and list(crowding("workcell/nowhere", [], True))
    assert found("collision/a.h", "#include <Eigen/Core>")
    assert found("haptic/server/a.cpp", "#include <QString>")
    assert found("haptic/rendering/a.cpp", '#include "haptic/server/loop.h"')
    assert found("workcell/a.cpp", "#include <STEPCAFControl_Reader.hxx>")
    assert found("app/a.cpp", "#include <assimp/scene.h>")
    assert not found("importer/a.cpp", "#include <STEPCAFControl_Reader.hxx>")
    assert not found("collision/a.cpp", "#include <Eigen/Core>")
    assert not found("collision/a.cpp", '#include "geometry/shapes/pose.h"')
    assert not found("manipulation/a.cpp", '#include "haptic/transport/haptic_link.h"')
    assert not found("app/a.cpp", "#include <QString>")


def users_of(wanted):
    """Top folders of the files that include something below `wanted`, or include such a file."""
    root = HERE.parent.parent
    needs, found = {}, {folder for folder in ORDER if folder == wanted or folder.startswith(wanted + "/")}
    for folder in ORDER:
        needs[folder] = {match.group(2).rpartition("/")[0] for path in (root / folder).glob("*.*") if path.suffix in (".h", ".cpp")
                         for match in map(INCLUDE.match, path.read_text(encoding="utf-8").splitlines()) if match}
    while True:
        more = {folder for folder in ORDER if folder not in found and needs[folder] & found}
        if not more:
            return list(dict.fromkeys(folder.split("/")[0] for folder in ORDER if folder in found))
        found |= more


def main():
    if sys.argv[1] == "--users":
        users = users_of(sys.argv[2].strip("/"))
        if not users:
            sys.exit(f"{sys.argv[2]}: no folder of the program; tests/architecture/folders.txt lists them")
        print("\n".join(users))
        return 0
    if sys.argv[1] == "--self-test":
        self_test()
        print("1 passed, 0 failed")
        return 0
    root = pathlib.Path(sys.argv[1])
    bad, read = [], 0
    for top in sorted({name.split("/")[0] for name in ALLOWED}):
        inside = {}
        for path in sorted((root / top).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                read += 1
                name = path.relative_to(root).as_posix()
                inside.setdefault(name.rpartition("/")[0], []).append(path.name)
                bad += offences(name, path.read_text(encoding="utf-8"))
        for folder, names in inside.items():
            bad += crowding(folder, names, (root / folder / "README.md").exists())
    bad += [f"{folder}/ of folders.txt holds no source" for folder in ORDER if not list((root / folder).glob("*.*"))]
    parents = {folder[:at] for folder in ORDER for at in range(len(folder)) if folder[at] == "/"}
    for path in sorted((root / "tests").rglob("*.cpp")):
        folder = path.parent.relative_to(root / "tests").as_posix()
        beside = any(folder == other or folder.startswith(other + "/") for other in TESTS_BESIDE)
        if not beside and folder not in ORDER and folder not in parents:
            bad.append(f"tests/{folder}/ mirrors no folder of the program")
    print("\n".join(bad) if bad else f"{read} files keep the table")
    return 1 if bad or read == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
