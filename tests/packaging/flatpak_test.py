#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The manifest of the Flatpak: its form, that what it names is there, and that no right is asked for without a reason.

usage: flatpak_test.py PROJECT_ROOT
Read by flatpak-builder where it is installed, else by python3-yaml; skipped (77) without both.
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as xml

ROOT = pathlib.Path(sys.argv[1])
MANIFEST = ROOT / "packaging" / "flatpak" / "org.hapticell.HaptiCell.yml"
DESKTOP = ROOT / "packaging" / "desktop"
RIGHTS = {"--socket=wayland", "--socket=fallback-x11", "--share=ipc", "--device=all", "--socket=pulseaudio", "--share=network",
          "--filesystem=home"}


def manifest():
    if shutil.which("flatpak-builder"):
        done = subprocess.run(["flatpak-builder", "--show-manifest", MANIFEST], capture_output=True, text=True, check=False)
        assert done.returncode == 0 and "Unknown property" not in done.stderr, done.stderr
        return json.loads(done.stdout)
    try:
        import yaml
    except ImportError:
        print("skipped: neither flatpak-builder nor python3-yaml is installed")
        sys.exit(77)
    return yaml.safe_load(MANIFEST.read_text(encoding="utf-8"))

# What the project asks CMake for, and the module or, as "sdk", the runtime's SDK that has it.
FOUND_IN = {"Boost": "boost", "CLI11": "cli11", "CycloneDDS": "cyclonedds", "Eigen3": "eigen", "LibArchive": "sdk", "NLopt": "nlopt",
            "OpenCASCADE": "opencascade", "OpenMesh": "openmesh", "OpenSSL": "sdk", "PkgConfig": "sdk", "Python3": "sdk", "Qt6": "sdk",
            "SQLite3": "sdk", "TBB": "onetbb", "Threads": "sdk", "assimp": "assimp", "draco": "draco", "glm": "glm",
            "meshoptimizer": "meshoptimizer", "nlohmann_json": "nlohmann-json", "ompl": "ompl", "pugixml": "pugixml",
            "sdformat12": "sdformat", "spdlog": "spdlog", "tl-expected": "tl-expected", "tomlplusplus": "tomlplusplus",
            "yaml-cpp": "yaml-cpp"}


def required_packages():
    """What the project's own folders need, without those that the manifest leaves out."""
    left_out = {"bench", "build", "examples", "python", "tests"}
    lists = [ROOT / "CMakeLists.txt", *(ROOT / "cmake").glob("*.cmake"),
             *(file for file in ROOT.glob("*/**/CMakeLists.txt") if file.relative_to(ROOT).parts[0] not in left_out)]
    text = "\n".join(file.read_text(encoding="utf-8") for file in lists)
    return set(re.findall(r"^\s*find_package\(([\w-]+)[^)]*\bREQUIRED\b", text, re.MULTILINE))


read = manifest()
assert {"runtime", "runtime-version", "sdk", "command", "finish-args", "modules"} <= set(read), sorted(read)
assert read["runtime"] == "org.kde.Platform" and read["sdk"] == "org.kde.Sdk" and str(read["runtime-version"]).startswith("6.")
assert set(read["finish-args"]) == RIGHTS, set(read["finish-args"]) ^ RIGHTS

names = [module["name"] for module in read["modules"]]
assert len(set(names)) == len(names) and names[-1] == "hapticell", names
for module in read["modules"]:
    assert module["buildsystem"] in ("cmake-ninja", "meson", "autotools", "simple"), module
    assert module["sources"] and (module["buildsystem"] != "simple" or module["build-commands"]), module
    for source in module["sources"]:
        if source["type"] == "dir":
            assert (MANIFEST.parent / source["path"] / "CMakeLists.txt").samefile(ROOT / "CMakeLists.txt"), source
        else:
            assert source["type"] == "archive" and source["url"].startswith("https://"), source
            assert re.fullmatch("[0-9a-f]{64}", source["sha256"]), source
for package in required_packages():
    assert package in FOUND_IN, f"{package} is asked for by CMake: add a module to the manifest, and its name to FOUND_IN"
    assert FOUND_IN[package] in (*names, "sdk"), f"{package}: there is no module {FOUND_IN[package]} in the manifest"
options = set((ROOT / "CMakeLists.txt").read_text(encoding="utf-8").split("option(")[1:])
for option in re.findall(r"-D(HAPTICELL_\w+)=", " ".join(read["modules"][-1]["config-opts"])):
    assert any(known.startswith(option + " ") for known in options), option

component = xml.parse(DESKTOP / read["rename-appdata-file"]).getroot()
assert component.findtext("id") == read.get("app-id", read.get("id")) == MANIFEST.stem
assert component.findtext("launchable") == read["rename-desktop-file"]
entry = (DESKTOP / read["rename-desktop-file"]).read_text(encoding="utf-8")
assert f"\nIcon={read['rename-icon']}\n" in entry and re.search(rf"^Exec={read['command']}\b", entry, re.MULTILINE)
assert re.search(r"RENAME hapticell\.xml", (ROOT / "packaging" / "CMakeLists.txt").read_text(encoding="utf-8"))
print(f"{len(names)} modules are described as they must be")
