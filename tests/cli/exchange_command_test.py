#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The commands that bring shapes in and give them back: convert, workcell pack, workcell changes.

usage: exchange_command_test.py HAPTICELL_CLI [NAME_PART]
"""
import csv
import fcntl
import json
import math
import os
import re
import subprocess
import sys
import zipfile

import command_line_test
from command_line_test import box, main, near, write_binary_stl

ARM = """<robot name="arm"><link name="base"/><link name="l"><visual><origin xyz="0.1 0 0"/><geometry><box size="0.2 0.02 0.02"/>
</geometry></visual></link><joint name="j" type="revolute"><parent link="base"/><child link="l"/><origin xyz="0 0 0.5"/>
<axis xyz="0 0 1"/><limit lower="-2" upper="2" effort="1" velocity="1"/></joint></robot>"""


def solids(entities):
    for entity in entities:
        if entity["triangles"] > 0:
            yield entity
        yield from solids(entity["children"])


def bounds(entity):
    return entity["bounds"]["min"] + entity["bounds"]["max"]


def test_a_cell_that_is_open_elsewhere_is_not_replaced(case):
    case.run("workcell", "new", "a.hcell", "--add", "box:1,1,1")
    before = (case.folder / "a.hcell").read_bytes()
    lock = case.folder / ".a.hcell.lock"
    assert not lock.exists(), "it goes with the command"
    with open(lock, "w") as file:
        json.dump({"user": "anna", "host": "far", "since": "2026-11-26 09:30", "process": 12}, file)
        file.flush()
        fcntl.flock(file, fcntl.LOCK_EX)
        message = case.run("workcell", "new", "a.hcell", "--add", "box:2,2,2", expect=2)
        assert "anna on far since 2026-11-26 09:30" in message and "Close it there" in message, message
        assert (case.folder / "a.hcell").read_bytes() == before
    lock.write_text(json.dumps({"user": "anna", "host": "far", "process": 12}))
    assert "anna on far" in case.run("workcell", "new", "a.hcell", "--add", "box:2,2,2", expect=2), "another machine's counts"
    lock.write_text("what a program left that died")
    case.run("workcell", "new", "a.hcell", "--add", "box:2,2,2")
    assert (case.folder / "a.hcell").read_bytes() != before and not lock.exists()
    assert sorted(path.name for path in case.folder.iterdir()) == ["a.hcell"], list(case.folder.iterdir())


def test_damaged_entries_of_a_step_file_are_named_and_no_print_of_a_reader_is_in_the_answer(case):
    write_binary_stl(case.folder / "box.stl", box((0.2, 0.1, 0.05), (0.3, 0.0, 0.1)))
    case.run("convert", "box.stl", "-o", "box.step")
    text = (case.folder / "box.step").read_text()
    loud = dict(os.environ, HAPTICELL_IMPORTER_VERBOSE="1")
    answers = 0
    for found in list(re.finditer(r"#(\d+) = DIRECTION\('',\([^)]*\)\)", text))[:8]:
        (case.folder / "bent.step").write_text(text[:found.start()] + f"#{found[1]} = DIRECTION('',$)" + text[found.end():])
        done = subprocess.run([command_line_test.CLI, "inspect", "bent.step"], capture_output=True, text=True, cwd=case.folder, env=loud)
        said = done.stderr if done.returncode == 2 else " ".join(json.loads(done.stdout)["warnings"])
        assert done.returncode in (0, 2) and f"1 damaged entry (#{found[1]})" in said, (done.returncode, said)
        answers += done.returncode == 0
    assert answers > 0, "one of them at least is read without the entry"


def test_every_writable_format_keeps_the_solid(case):
    write_binary_stl(case.folder / "box.stl", box((0.2, 0.1, 0.05), (0.3, 0.0, 0.1)))
    want = next(solids(case.run("inspect", "box.stl", "--unit", "m")["entities"]))
    for name in ("out.step", "out.glb", "out.gltf", "out.obj", "out.ply", "out.off", "out.stl"):
        made = case.run("convert", "box.stl", "-o", name)
        assert made["output"] == name and made["triangles"] == 12 and made["parts"] == 1, made
        read = case.run("inspect", name)
        found = list(solids(read["entities"]))
        assert not any("unit" in warning for warning in read["warnings"]), (name, read)
        assert len(found) == 1 and found[0]["triangles"] == 12, (name, found)
        assert near(bounds(found[0]), bounds(want), 1e-6), (name, found, want)
        assert near(found[0]["volume"], 0.2 * 0.1 * 0.05, 1e-8), (name, found)


def test_a_converted_mesh_has_the_size_that_inspect_says(case):
    for size in (0.3, 30, 40000):  # Metres by its size, millimetres by its size.
        write_binary_stl(case.folder / "part.stl", box((size, size, size)))
        want = case.run("inspect", "part.stl")
        for name in ("a.obj", "a.ply", "a.off", "a.stl", "a.step", "a.glb"):
            case.run("convert", "part.stl", "-o", name)
            read = case.run("inspect", name)
            assert near(bounds(next(solids(read["entities"]))), bounds(want["entities"][0]), 1e-6 * size), (size, name, read)
            if name == "a.obj":  # The numbers of a mesh file stay those of the mesh file.
                assert read["unit"] == want["unit"], read
                top = max(float(line.split()[1]) for line in (case.folder / name).read_text().splitlines() if line.startswith("v "))
                assert near([top], [size / 2], 1e-6 * size), top
    case.run("convert", "part.stl", "--unit", "in", "-o", "inch.ply")
    read = case.run("inspect", "inch.ply")
    assert read["unit"] == "m" and near(bounds(next(solids(read["entities"])))[3:4], [20000 * 0.0254], 1e-2), read
    case.run("convert", "part.stl", "--unit", "mm", "--output-unit", "in", "-o", "inch.off")
    read = case.run("inspect", "inch.off")
    assert read["unit"] == "in" and near(bounds(next(solids(read["entities"])))[3:4], [20], 1e-9), read


def test_names_and_colours_of_mesh_files(case):
    (case.folder / "two.mtl").write_text("newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 0.5 0.25\n")
    lines, count = ["# File units = inches", "mtllib two.mtl"], 0
    for name, material, x in (("base plate", "a", 0), ("pin", "b", 3)):
        lines.append(f"o {name}\nusemtl {material}")
        for triangle in box((1, 1, 1), (x, 0, 0)):
            lines += [f"v {p[0]} {p[1]} {p[2]}" for p in triangle]
            lines.append(f"f {count + 1} {count + 2} {count + 3}")
            count += 3
    (case.folder / "two.obj").write_text("\n".join(lines) + "\n")
    read = case.run("inspect", "two.obj")
    assert read["unit"] == "in" and read["warnings"] == [], read
    assert [(e["name"], e["color"], e["triangles"]) for e in read["entities"]] == [
        ("base plate", [1, 0, 0], 12), ("pin", [0, 0.5, 0.25], 12)], read
    assert near(bounds(read["entities"][1]), [0.0635, -0.0127, -0.0127, 0.0889, 0.0127, 0.0127], 1e-9), read
    for name in ("t.step", "t.glb", "t.obj", "t.ply", "t.off"):
        case.run("convert", "two.obj", "-o", name)
        found = list(solids(case.run("inspect", name)["entities"]))
        assert len(found) == 2, (name, found)
        assert all(near(e["color"], c, 0.003) for e, c in zip(found, ([1, 0, 0], [0, 0.5, 0.25]))), (name, found)
        assert near(bounds(found[1]), bounds(read["entities"][1]), 1e-6), (name, found)
    case.run("workcell", "new", "cell.hcell", "--add", "two.obj,name=fixture")
    kept = {e["name"]: e for e in json.loads((case.folder / "cell.hcell").read_text())["entities"]}
    assert kept["pin"]["parent"] == "fixture" and kept["pin"]["color"] == [0, 0.5, 0.25] and kept["pin"]["source"]["part"] == "pin", kept
    (case.folder / "two.mtl").unlink()
    assert any("two.mtl" in w for w in case.run("inspect", "two.obj")["warnings"])


def test_units_and_up_axis_of_a_conversion(case):
    write_binary_stl(case.folder / "box.stl", box((200, 100, 50)))
    case.run("convert", "box.stl", "--unit", "mm", "--up", "y", "-o", "m.obj")
    case.run("convert", "m.obj", "-o", "in.obj", "--output-unit", "in")
    found = next(solids(case.run("inspect", "in.obj")["entities"]))
    size = [high - low for low, high in zip(found["bounds"]["min"], found["bounds"]["max"])]
    assert near(size, [0.2, 0.05, 0.1], 1e-9), size


def test_a_step_round_trip_carries_what_was_moved(case):
    for name in "abc":
        write_binary_stl(case.folder / f"{name}.stl", box((0.1, 0.1, 0.1)))
    case.run("workcell", "new", "cell.hcell", "--add", "a.stl,name=a", "--add", "b.stl,name=b,pose=1,0,0,1,0,0,0",
             "--add", "c.stl,name=c")
    case.run("convert", "cell.hcell", "-o", "first.step")
    case.run("workcell", "new", "again.hcell", "--add", "first.step,name=first")
    cell = json.loads((case.folder / "again.hcell").read_text())
    moved = {"a": [0.5, 0.25, 0.125], "b": [0.5, 0.25, -0.125]}
    half = math.sqrt(0.5)
    for entity in cell["entities"]:
        if entity["name"] in moved:
            entity["placement"] = {"position": moved[entity["name"]], "quaternion": [half, 0, 0, half]}
    (case.folder / "again.hcell").write_text(json.dumps(cell))
    case.run("convert", "again.hcell", "-o", "second.step")
    found = {e["name"]: e for e in solids(case.run("inspect", "second.step")["entities"])}
    assert set(found) == {"a", "b", "c"}, found.keys()
    for name, place in {**moved, "c": [0, 0, 0]}.items():
        middle = [0.5 * (low + high) for low, high in zip(found[name]["bounds"]["min"], found[name]["bounds"]["max"])]
        assert near(middle, place, 1e-6), (name, middle, place)
    changes = case.run("workcell", "changes", "--since-import", "again.hcell", "-o", "changes.csv")["changes"]
    assert sorted(c["name"] for c in changes) == ["a", "b"] and all(c["change"] == "moved" for c in changes), changes
    rows = list(csv.DictReader((case.folder / "changes.csv").open()))
    assert all([float(row[f"to_{axis}"]) for axis in "xyz"] == moved[row["name"]] for row in rows), rows
    assert all(near(float(row["angle_rad"]), math.pi / 2, 1e-9) for row in rows), rows


def test_a_robot_with_its_new_base(case):
    (case.folder / "arm.urdf").write_text(ARM)
    case.run("workcell", "new", "cell.hcell", "--add", "arm.urdf,name=robot,pose=1,2,3,0,1,0,0")
    case.run("convert", "cell.hcell", "-o", "moved.urdf")
    (case.folder / "q.csv").write_text("j\n0.5\n")
    pose = case.run("fk", "--robot", "moved.urdf", "--joints", "q.csv", "--tip", "l")["poses"][0]
    assert near([pose["x"], pose["y"], pose["z"]], [1, 2, 2.5], 1e-12), pose
    robot = case.run("inspect", "moved.urdf")["entities"][0]
    assert robot["dof"] == 1 and robot["joints"][-1]["upper"] == 2, robot
    case.run("convert", "moved.urdf", "-o", "moved.glb")
    write_binary_stl(case.folder / "box.stl", box((1, 1, 1)))
    assert "robot" in case.run("convert", "box.stl", "-o", "box.urdf", expect=2)


def test_fewer_triangles_say_how_far_they_are_off(case):
    rod = []
    for k in range(96):
        p, q = ((0.1 * math.cos(t), 0.1 * math.sin(t)) for t in (2 * math.pi * (k + s) / 96 for s in (0, 1)))
        rod += [((*p, 0), (*q, 0), (*q, 0.2)), ((*p, 0), (*q, 0.2), (*p, 0.2)), ((0, 0, 0), (*q, 0), (*p, 0)),
                ((0, 0, 0.2), (*p, 0.2), (*q, 0.2))]
    write_binary_stl(case.folder / "rod.stl", rod)
    made = case.run("convert", "rod.stl", "--simplify", "0.001", "-o", "few.stl")
    assert made["triangles"] < 300 and 0 < made["deviation"] <= 0.001, made
    assert made["promised"] == {"surface": 0.001} and 0 < made["measured"]["surface"] <= 0.001001, made
    hull = case.run("convert", "rod.stl", "--hull", "-o", "hull.stl")
    assert hull["deviation"] < 1e-6, hull
    for none in ("0", "nan", "inf", "-1", "1e-3x"):
        case.run("convert", "rod.stl", "--simplify", none, "-o", "none.stl", expect=2)
        for option in ("--chord", "--angle"):
            case.run("convert", "rod.stl", option, none, "-o", "none.stl", expect=2)
    case.run("convert", "rod.stl", "--simplify", "0.001", "--hull", "-o", "none.stl", expect=2)
    assert not (case.folder / "none.stl").exists()


def test_conversions_that_cannot_be(case):
    write_binary_stl(case.folder / "box.stl", box((1, 1, 1)))
    (case.folder / "old.step").write_text("what stood here")
    for arguments in (("box.stl", "-o", "box.dwg"), ("missing.stl", "-o", "x.step"),
                      ("box.stl", "-o", "no/such/folder/x.step"), ("old.step", "-o", "old.step")):
        message = case.run("convert", *arguments, expect=2)
        assert "hapticell-cli:" in message and "what():" not in message, message
    assert (case.folder / "old.step").read_text() == "what stood here"
    assert not list(case.folder.glob("*.part"))


def test_a_pack_is_whole_as_folder_and_as_archive(case):
    (case.folder / "parts").mkdir()
    write_binary_stl(case.folder / "parts" / "a.stl", box((0.1, 0.1, 0.1)))
    case.run("workcell", "new", "cell.hcell", "--add", "parts/a.stl,name=a", "--add", "library:ur5e")
    packed = case.run("workcell", "pack", "cell.hcell", "-o", "pack")
    assert packed["files"] == ["files/a.stl"], packed
    case.run("workcell", "pack", "cell.hcell", "-o", "pack", expect=2)
    archive = case.run("workcell", "pack", "cell.hcell", "-o", "cell.zip")
    assert archive["workcell"] == "cell.hcell", archive
    with zipfile.ZipFile(case.folder / "cell.zip") as zipped:
        assert zipped.testzip() is None and sorted(zipped.namelist()) == ["cell.hcell", "files/a.stl"], zipped.namelist()
        zipped.extractall(case.folder / "unzipped")
    before = case.run("inspect", "cell.hcell")["entities"]
    for name in ("pack/cell.hcell", "unzipped/cell.hcell"):
        assert case.run("inspect", name)["entities"] == before, name


def test_changes_between_two_documents(case):
    write_binary_stl(case.folder / "a.stl", box((0.1, 0.1, 0.1)))
    case.run("workcell", "new", "one.hcell", "--add", "a.stl,name=a", "--add", "a.stl,name=b")
    case.run("workcell", "new", "two.hcell", "--add", "a.stl,name=a,pose=0,0,0.4,1,0,0,0", "--add", "a.stl,name=c")
    changes = {c["name"]: c for c in case.run("workcell", "changes", "one.hcell", "two.hcell")["changes"]}
    assert {name: c["change"] for name, c in changes.items()} == {"a": "moved", "b": "removed", "c": "added"}, changes
    assert near(changes["a"]["distance"], 0.4) and changes["a"]["angle"] == 0, changes
    assert case.run("workcell", "changes", "one.hcell", "one.hcell")["changes"] == []
    case.run("workcell", "changes", "one.hcell", expect=2)
    case.run("workcell", "changes", "--since-import", "one.hcell", "two.hcell", expect=2)


if __name__ == "__main__":
    sys.exit(main(globals()))
