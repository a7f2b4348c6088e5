#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Drives the built hapticell-cli as a user would, and checks what it answers against sums made here.

usage: command_line_test.py HAPTICELL_CLI [NAME_PART]
"""
import json
import math
import os
import pathlib
import stat
import struct
import subprocess
import sys
import tempfile

CLI = str(pathlib.Path(sys.argv[1]).resolve())
BOX_FACES = [(0, 2, 1), (0, 3, 2), (4, 5, 6), (4, 6, 7), (0, 1, 5), (0, 5, 4), (1, 2, 6), (1, 6, 5), (2, 3, 7), (2, 7, 6),
             (3, 0, 4), (3, 4, 7)]


def box(size, center=(0, 0, 0), scale=1.0):
    sx, sy, sz = (0.5 * s for s in size)
    corners = [(-sx, -sy, -sz), (sx, -sy, -sz), (sx, sy, -sz), (-sx, sy, -sz), (-sx, -sy, sz), (sx, -sy, sz), (sx, sy, sz),
               (-sx, sy, sz)]
    corners = [tuple((c + o) * scale for c, o in zip(corner, center)) for corner in corners]
    return [tuple(corners[i] for i in face) for face in BOX_FACES]


def write_binary_stl(path, triangles):
    with open(path, "wb") as file:
        # Begins with "solid" on purpose: many exporters do, and the file is binary all the same.
        file.write(b"solid made by a test".ljust(80) + struct.pack("<I", len(triangles)))
        for triangle in triangles:
            file.write(struct.pack("<12fH", 0, 0, 0, *(v for corner in triangle for v in corner), 0))


def write_ascii_stl(path, triangles):
    lines = ["solid test"]
    for triangle in triangles:
        lines += ["facet normal 0 0 0", "outer loop"] + ["vertex %.9g %.9g %.9g" % corner for corner in triangle]
        lines += ["endloop", "endfacet"]
    path.write_text("\n".join(lines + ["endsolid test"]) + "\n")


def write_obj(path, triangles):
    lines, count = [], 0
    for triangle in triangles:
        lines += ["v %.9g %.9g %.9g" % corner for corner in triangle]
        lines.append(f"f {count + 1} {count + 2} {count + 3}")
        count += 3
    path.write_text("\n".join(lines) + "\n")


ARM = """<robot name="arm">
<link name="base"/><link name="upper"/><link name="lower"/><link name="tip"/>
<joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/><origin xyz="0 0 0.1"/><axis xyz="0 0 1"/>
<limit lower="-2.5" upper="2.5" velocity="1" effort="1"/></joint>
<joint name="elbow" type="revolute"><parent link="upper"/><child link="lower"/><origin xyz="0.5 0 0"/><axis xyz="0 0 1"/>
<limit lower="-2.5" upper="2.5" velocity="1" effort="1"/></joint>
<joint name="end" type="fixed"><parent link="lower"/><child link="tip"/><origin xyz="0.3 0 0"/></joint>
</robot>
"""


class Case:
    """One call of the program in a fresh folder."""

    def __init__(self, folder):
        self.folder = folder

    def run(self, *arguments, expect=0, timeout=60):
        done = subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True, timeout=timeout, cwd=self.folder)
        self.error = done.stderr
        assert done.returncode == expect, f"exit {done.returncode}, expected {expect}: {done.stderr[-600:]}"
        return json.loads(done.stdout) if expect in (0, 1) else done.stderr


def near(a, b, tolerance=1e-9):
    if isinstance(a, (list, tuple)):
        return len(a) == len(b) and all(near(x, y, tolerance) for x, y in zip(a, b))
    return abs(a - b) <= tolerance


def poses(path, rows):
    path.write_text("x,y,z,qw,qx,qy,qz\n" + "\n".join(",".join(repr(float(v)) for v in row) for row in rows) + "\n")


def test_inspect_reads_each_mesh_format_alike(case):
    triangles = box((0.2, 0.4, 0.6), (1, 0, 0))
    write_binary_stl(case.folder / "a.stl", triangles)
    write_ascii_stl(case.folder / "b.stl", triangles)
    write_obj(case.folder / "c.obj", triangles)
    for name, tolerance in (("a.stl", 1e-7), ("b.stl", 1e-9), ("c.obj", 1e-9)):
        answer = case.run("inspect", name)
        (entity,) = answer["entities"]
        assert entity["kind"] == "solid" and entity["triangles"] == 12, entity
        assert near(entity["bounds"]["min"], [0.9, -0.2, -0.3], tolerance), entity
        assert near(entity["bounds"]["max"], [1.1, 0.2, 0.3], tolerance), entity
        assert near(entity["volume"], 0.048, 1e-7), entity
        assert {"format", "unit", "up_axis", "warnings"} <= set(answer)


def test_inspect_a_robot(case):
    (case.folder / "arm.urdf").write_text(ARM)
    answer = case.run("inspect", "arm.urdf")
    (robot,) = answer["entities"]
    assert robot["kind"] == "robot" and robot["dof"] == 2, robot
    assert [joint["name"] for joint in robot["joints"]] == ["shoulder", "elbow"], robot["joints"]
    assert near(robot["joints"][0]["lower"], -2.5) and "inverse_model" in robot


def test_bad_files_are_one_sentence(case):
    write_binary_stl(case.folder / "cut.stl", box((1, 1, 1)))
    data = (case.folder / "cut.stl").read_bytes()
    (case.folder / "cut.stl").write_bytes(data[:200])
    (case.folder / "nan.stl").write_bytes(data[:96] + struct.pack("<f", math.nan) + data[100:])
    (case.folder / "empty.stl").write_bytes(b"")
    (case.folder / "text.ply").write_text("ply\nformat ascii 1.0\nelement vertex 1000000000\nproperty float x\nend_header\n")
    (case.folder / "index.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")
    for name in ("cut.stl", "nan.stl", "empty.stl", "text.ply", "index.obj", "absent.stl"):
        message = case.run("inspect", name, expect=2)
        assert name in message and message.strip().count("\n") == 0, message


def test_bad_robots_are_one_sentence(case):
    def variant(name, old, new):
        assert old in ARM
        (case.folder / name).write_text(ARM.replace(old, new))

    variant("roots.urdf", '<link name="base"/>', '<link name="base"/><link name="other"><visual/></link>')
    variant("cycle.urdf", '<parent link="base"/>', '<parent link="tip"/>')
    variant("parent.urdf", '<parent link="upper"/>', '<parent link="nowhere"/>')
    (case.folder / "broken.urdf").write_text(ARM[:200])
    for name in ("roots.urdf", "cycle.urdf", "parent.urdf", "broken.urdf"):
        message = case.run("inspect", name, expect=2)
        assert name in message and message.strip().count("\n") == 0, (name, message)


def test_a_missing_mesh_leaves_its_shape_out(case):
    assert '<link name="base"/>' in ARM
    (case.folder / "mesh.urdf").write_text(ARM.replace(
        '<link name="base"/>', '<link name="base"><visual><geometry><mesh filename="gone.stl"/></geometry></visual></link>'))
    answer = case.run("inspect", "mesh.urdf")
    assert answer["entities"][0]["unchecked_links"] == ["base"]
    assert any("gone.stl does not exist" in warning for warning in answer["warnings"]), answer["warnings"]


def test_xacro_takes_arguments(case):
    (case.folder / "arm.xacro").write_text('''<robot name="$(arg name)" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="reach" default="0.5"/>
  <link name="a"/><link name="b"/>
  <joint name="j" type="revolute"><parent link="a"/><child link="b"/><origin xyz="${2 * $(arg reach)} 0 0"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" velocity="1" effort="1"/></joint>
</robot>''')
    message = case.run("inspect", "arm.xacro", expect=2)
    assert "arm.xacro, line 1: undefined substitution argument name" in message and "name:=VALUE" in message, message
    answer = case.run("inspect", "arm.xacro", "name:=mine", "reach:=0.75")
    assert answer["format"] == "xacro" and answer["entities"][0]["name"] == "mine"
    assert {"name": "reach", "value": "0.75", "default": "0.5"} in answer["arguments"], answer["arguments"]
    (case.folder / "joints.csv").write_text("j\n0\n")
    for text, reach in (("arm.xacro,name:=mine", 1.0), ("arm.xacro,name:=mine,reach:=0.75", 1.5)):
        answer = case.run("fk", "--robot", text, "--joints", "joints.csv")
        assert abs(answer["poses"][0]["x"] - reach) < 1e-12, answer
    case.run("workcell", "new", "cell.hcell", "--add", "arm.xacro,name:=mine,reach:=0.75,name=arm")
    cell = json.loads((case.folder / "cell.hcell").read_text())
    assert cell["entities"][0]["source"]["arguments"] == {"name": "mine", "reach": "0.75"}, cell["entities"][0]
    assert case.run("inspect", "cell.hcell")["entities"][0]["name"] == "arm"
    assert "nothing" in case.run("inspect", "arm.xacro", "nothing", expect=2)


def test_distance_between_boxes(case):
    write_obj(case.folder / "moving.obj", box((0.2, 0.2, 0.2)))
    write_obj(case.folder / "wall.obj", box((0.1, 4.0, 4.0), (1.0, 0, 0)))
    write_obj(case.folder / "floor.obj", box((4.0, 4.0, 0.1), (0, 0, -1.0)))
    c = math.cos(math.pi / 8)
    s = math.sin(math.pi / 8)
    poses(case.folder / "poses.csv", [(0, 0, 0, 1, 0, 0, 0), (0.8, 0, 0, 1, 0, 0, 0), (0.9, 0.3, 0, 1, 0, 0, 0), (0, 0, -0.5, 1, 0, 0, 0),
                                      (0, 0, 0, c, 0, 0, s)])
    answer = case.run("distance", "--moving", "moving.obj", "--environment", "wall.obj", "floor.obj", "--poses", "poses.csv")
    results = answer["results"]
    expected = [0.85, 0.05, 0.0, 0.35, 0.95 - 0.1 * math.sqrt(2)]
    assert [near(r["distance"], d, 1e-9) for r, d in zip(results, expected)] == [True] * 5, results
    assert [r["colliding"] for r in results] == [False, False, True, False, False]
    first = results[1]
    assert near(first["point_on_moving"][0], 0.9, 1e-9) and near(first["point_on_environment"][0], 0.95, 1e-9), first
    assert near(first["normal"], [-1, 0, 0], 1e-9), "the normal points from the environment to the moving part"
    assert near(results[2]["point_on_moving"], results[2]["point_on_environment"], 1e-9)
    assert {"median_us", "p99_us", "max_us", "build_ms"} <= set(answer["timing"])


def test_distance_units_and_zone(case):
    write_obj(case.folder / "moving.obj", box((200, 200, 200)))
    write_obj(case.folder / "wall.obj", box((100, 4000, 4000), (1000, 0, 0)))
    poses(case.folder / "poses.csv", [(0, 0, 0, 1, 0, 0, 0), (0.84, 0, 0, 1, 0, 0, 0)])
    answer = case.run("distance", "--moving", "moving.obj", "--environment", "wall.obj", "--poses", "poses.csv", "--unit", "mm",
                      "--safety-zone", "0.1")
    far, close = answer["results"]
    assert far["distance"] is None and far["distance_at_least"] >= 0.1 or near(far["distance"], 0.85, 1e-9), far
    assert near(close["distance"], 0.01, 1e-9) and close["contacts"] >= 1, close


def test_distances_keep_their_digits_far_from_the_origin(case):
    """Coordinates of a map, kilometres away: a float would keep a quarter of a millimetre."""
    write_obj(case.folder / "moving.obj", box((0.2, 0.2, 0.2)))
    write_obj(case.folder / "wall.obj", box((0.2, 0.2, 0.2), (1000.20123, 2000.0, 3000.0)))
    poses(case.folder / "poses.csv", [[1000, 2000, 3000, 1, 0, 0, 0], [1000.001, 2000, 3000, 1, 0, 0, 0]])
    answer = case.run("distance", "--moving", "moving.obj", "--environment", "wall.obj", "--poses", "poses.csv")
    assert near([r["distance"] for r in answer["results"]], [0.00123, 0.00023], 1e-9), answer


def test_bad_tables_name_line_and_column(case):
    write_obj(case.folder / "part.obj", box((1, 1, 1)))
    for text, part in (("x,y,z,qw,qx,qy\n0,0,0,1,0,0\n", "qz"), ("x,y,z,qw,qx,qy,qz\n0,0,zero,1,0,0,0\n", "2"),
                       ("x,y,z,qw,qx,qy,qz\n0,0,0,0.2,0,0,0\n", "2"), ("x,y,z,qw,qx,qy,qz\n0,0,nan,1,0,0,0\n", "2"),
                       ("x,y,z,qw,qx,qy,qz\n0,0,0,1\n", "2"), ("x,y,z,qw,qx,qy,qz\n", "no line after the header")):
        (case.folder / "bad.csv").write_text(text)
        message = case.run("distance", "--moving", "part.obj", "--environment", "part.obj", "--poses", "bad.csv", expect=2)
        assert "bad.csv" in message and part in message, message


def test_forward_and_inverse_kinematics_of_a_planar_arm(case):
    (case.folder / "arm.urdf").write_text(ARM)
    rows = [(0.3, 0.7), (-1.0, 2.0), (0.0, 0.0)]
    (case.folder / "joints.csv").write_text("elbow,shoulder\n" + "".join(f"{e},{s}\n" for s, e in rows))
    answer = case.run("fk", "--robot", "arm.urdf", "--joints", "joints.csv", "--tip", "tip")
    table = []
    for (s, e), pose in zip(rows, answer["poses"]):
        x, y = 0.5 * math.cos(s) + 0.3 * math.cos(s + e), 0.5 * math.sin(s) + 0.3 * math.sin(s + e)
        values = [pose[k] for k in ("x", "y", "z", "qw", "qx", "qy", "qz")] if isinstance(pose, dict) else pose
        half = (s + e) / 2
        expected = [x, y, 0.1, math.cos(half), 0, 0, math.sin(half)]
        sign = 1 if values[3] * expected[3] + values[6] * expected[6] > 0 else -1
        assert near(values[:3], expected[:3]) and near([sign * v for v in values[3:]], expected[3:]), (values, expected)
        table.append(expected)
    poses(case.folder / "poses.csv", table + [[2.0, 0, 0.1, 1, 0, 0, 0]])
    answer = case.run("ik", "--robot", "arm.urdf", "--poses", "poses.csv", "--tip", "tip", "--start", "0.2,0.6")
    for (s, e), result in zip(rows, answer["results"]):
        assert result["status"] == "solved", result
        assert near(result["joints"], [s, e], 1e-6), result
        assert result["position_error"] < 1e-6 and result["orientation_error"] < 1e-6
    assert answer["results"][3]["status"] == "unreachable", answer["results"][3]
    assert "warnings" not in answer, answer
    answer = case.run("ik", "--robot", "arm.urdf", "--poses", "poses.csv", "--tip", "tip", "--start", "0.2,66")
    assert len(answer["warnings"]) == 1 and "elbow" in answer["warnings"][0] and "66" in answer["warnings"][0], answer


RAIL = """<robot name="rail"><link name="bed"/><link name="carriage"/>
<joint name="drive" type="prismatic"><parent link="bed"/><child link="carriage"/><axis xyz="1 0 0"/>
<limit lower="-2" upper="2" velocity="1" effort="1"/></joint></robot>
"""


def test_external_axes_carry_the_robot_or_the_part(case):
    (case.folder / "arm.urdf").write_text(ARM)
    (case.folder / "rail.urdf").write_text(RAIL)
    (case.folder / "table.urdf").write_text(RAIL.replace("rail", "table").replace("prismatic", "revolute").replace("1 0 0", "0 0 1")
                                            .replace("drive", "turn").replace("carriage", "plate"))
    # 2.5 m from the rail's middle: the arm of 0.8 m reaches that from the rail's end only.
    poses(case.folder / "far.csv", [[2.5, 0.3, 0.1, 1, 0, 0, 0]])
    assert case.run("ik", "--robot", "arm.urdf", "--poses", "far.csv")["results"][0]["status"] == "unreachable"
    answer = case.run("ik", "--robot", "arm.urdf", "--poses", "far.csv", "--on", "rail.urdf,link=carriage")
    assert answer["joint_names"] == ["drive", "shoulder", "elbow"], answer["joint_names"]
    (case.folder / "joints.csv").write_text("drive,shoulder,elbow\n" + "1.9,0.4,0.5\n")
    forward = case.run("fk", "--robot", "arm.urdf", "--joints", "joints.csv", "--on", "rail.urdf,pose=0,0,0.2,1,0,0,0")
    pose = forward["poses"][0]
    assert near([pose["x"], pose["y"], pose["z"]],
                [1.9 + 0.5 * math.cos(0.4) + 0.3 * math.cos(0.9), 0.5 * math.sin(0.4) + 0.3 * math.sin(0.9), 0.3])
    # The part on a table 0.6 m in front: what the arm reaches in the cell, told in the plate that is turned by q.
    (case.folder / "joints.csv").write_text("turn,shoulder,elbow\n" + "0.7,0.4,0.5\n")
    forward = case.run("fk", "--robot", "arm.urdf", "--joints", "joints.csv", "--part-on", "table.urdf,pose=0.6,0,0,1,0,0,0")
    pose = forward["poses"][0]
    x, y = 0.5 * math.cos(0.4) + 0.3 * math.cos(0.9) - 0.6, 0.5 * math.sin(0.4) + 0.3 * math.sin(0.9)
    c, s = math.cos(-0.7), math.sin(-0.7)
    assert near([pose["x"], pose["y"], pose["z"]], [c * x - s * y, s * x + c * y, 0.1]), pose
    poses(case.folder / "plate.csv", [[pose[key] for key in ("x", "y", "z", "qw", "qx", "qy", "qz")]])
    answer = case.run("ik", "--robot", "arm.urdf", "--poses", "plate.csv", "--part-on", "table.urdf,pose=0.6,0,0,1,0,0,0")
    assert answer["results"][0]["status"] == "solved" and len(answer["results"][0]["joints"]) == 3, answer["results"]
    assert "does not move" in case.run("ik", "--robot", "arm.urdf", "--poses", "far.csv", "--on", "rail.urdf,link=bed", expect=2)
    # In a cell: the robot hangs on the carriage, a session takes the rail along.
    case.run("workcell", "new", "cell.hcell", "--add", "rail.urdf,name=rail", "--add", "arm.urdf,name=arm,on=rail:carriage")
    (case.folder / "hand.csv").write_text("t,x,y,z,qw,qx,qy,qz,button\n0,0,0,0,1,0,0,0,0\n0.1,0,0,0,1,0,0,0,1\n"
                                          "0.3,0,0,0,1,0,0,0,0\n1,0.05,0,0,1,0,0,0,0\n")
    told = case.run("session", "--workcell", "cell.hcell", "--entity", "arm", "--hand", "hand.csv", "--set", "moved_by=tcp_with_axes",
                    "--set", "axes=cell", "--set", "scale=4", "--rate-manipulation", "100")
    rail = told["final_state"]["axes"][0]
    assert rail["name"] == "rail" and rail["joints"][0] > 0.05, rail
    assert "no entity" in case.run("workcell", "new", "bad.hcell", "--add", "arm.urdf,on=nothing:x", expect=2)


def test_all_solutions_have_the_answer_among_them(case):
    # Nine joints for six freedoms, with narrow limits: a search for others does not come upon every answer again.
    joints = "".join(
        f'<link name="l{i + 1}"/><joint name="j{i}" type="revolute"><parent link="l{i}"/><child link="l{i + 1}"/>'
        f'<origin xyz="0.1 0 0.2"/><axis xyz="{("0 0 1", "0 1 0", "1 0 0")[i % 3]}"/>'
        '<limit lower="-0.3" upper="0.3" velocity="1" effort="1"/></joint>' for i in range(9))
    (case.folder / "snake.urdf").write_text(f'<robot name="snake"><link name="l0"/>{joints}</robot>')
    turns = [",".join(str(round(0.299 * math.sin(1.7 * row * row + 2.3 * i), 4)) for i in range(9)) for row in range(30)]
    (case.folder / "joints.csv").write_text("\n".join([",".join(f"j{i}" for i in range(9)), *turns]) + "\n")
    reached = case.run("fk", "--robot", "snake.urdf", "--joints", "joints.csv")["poses"]
    poses(case.folder / "poses.csv", [tuple(pose[key] for key in ("x", "y", "z", "qw", "qx", "qy", "qz")) for pose in reached])
    answer = case.run("ik", "--robot", "snake.urdf", "--poses", "poses.csv", "--all")
    for result in answer["results"]:
        assert result["status"] == "solved", result["status"]
        assert any(near(one["joints"], result["joints"], 1e-3) and one["within_limits"] for one in result["solutions"])


def test_workcell_new_then_inspect(case):
    write_obj(case.folder / "table.obj", box((1000, 1000, 100)))
    (case.folder / "arm.urdf").write_text(ARM)
    case.run("workcell", "new", "cell.hcell", "--add", "table.obj,name=table,unit=mm,pose=1,0,0,1,0,0,0", "--add", "arm.urdf,name=arm",
             "--check", "arm:table,near_miss=0.02,safety=0.002")
    document = json.loads((case.folder / "cell.hcell").read_text())
    assert document["format"] == "hapticell-workcell" and document["version"] == 1
    answer = case.run("inspect", "cell.hcell")
    by_name = {entity["name"]: entity for entity in answer["entities"]}
    assert near(by_name["table"]["bounds"]["max"], [1.5, 0.5, 0.05], 1e-9), by_name["table"]
    assert by_name["arm"]["kind"] == "robot"
    document["version"] = 2
    (case.folder / "newer.hcell").write_text(json.dumps(document))
    assert "newer.hcell" in case.run("inspect", "newer.hcell", expect=2)


def test_a_mesh_that_faces_inward_is_told_wherever_it_comes_in(case):
    inward = [(a, c, b) for a, b, c in box((0.4, 0.4, 0.1))]
    write_binary_stl(case.folder / "inward.stl", inward)
    write_obj(case.folder / "inward.obj", inward)
    write_obj(case.folder / "outward.obj", box((0.4, 0.4, 0.1)))
    (case.folder / "arm.urdf").write_text(ARM.replace(
        '<link name="upper"/>', '<link name="upper"><collision><geometry><mesh filename="inward.stl"/></geometry></collision></link>'))
    told = "face inward"
    for part, is_told in (("inward.stl", True), ("inward.obj", True), ("arm.urdf", True), ("outward.obj", False)):
        new = case.run("workcell", "new", part + ".hcell", "--add", part + ",name=part")
        for answer in (new, case.run("inspect", part + ".hcell"), case.run("inspect", part)):
            assert (told in " ".join(answer["warnings"])) == is_told, (part, answer["warnings"])
    assert told in " ".join(case.run("convert", "inward.stl", "--output", "again.obj")["warnings"])


def test_workcell_new_refuses_what_means_nothing(case):
    brick = "box:1,1,1,name=k"
    assert "--add" in case.run("workcell", "new", "cell.hcell", expect=2)
    assert "itself" in case.run("workcell", "new", "cell.hcell", "--add", brick, "--check", "k:k", expect=2)
    assert "'k' is already in use" in case.run("workcell", "new", "cell.hcell", "--add", brick, "--add", brick, expect=2)
    assert "once" in case.run("workcell", "new", "cell.hcell", "--add", brick + ",name=j", expect=2)
    assert "--check" in case.run("workcell", "new", "cell.hcell", "--add", brick, "--check", ":", expect=2)
    assert "no option is named 'colour'" in case.run("workcell", "new", "cell.hcell", "--add", "brick.obj,colour=red", expect=2)
    assert not (case.folder / "cell.hcell").exists()


def hand(path, stations, step=0.01):
    """A hand that moves in straight lines between (t, x, y, z, button)."""
    rows, t = [], 0.0
    while t <= stations[-1][0] + 1e-9:
        for (t0, *p0, b0), (t1, *p1, _) in zip(stations, stations[1:]):
            if t0 - 1e-9 <= t <= t1 + 1e-9:
                s = (t - t0) / (t1 - t0)
                p = [a + (b - a) * s for a, b in zip(p0, p1)]
                rows.append(f"{t:.3f},{p[0]:.6f},{p[1]:.6f},{p[2]:.6f},1,0,0,0,{b0}")
                break
        t += step
    path.write_text("t,x,y,z,qw,qx,qy,qz,button\n" + "\n".join(rows) + "\n")


def session_on_a_table(case, *more):
    write_obj(case.folder / "table.obj", box((1, 1, 0.1), (0, 0, -0.05)))
    write_obj(case.folder / "brick.obj", box((0.1, 0.06, 0.04)))
    case.run("workcell", "new", "cell.hcell", "--add", "table.obj,name=table", "--add", "brick.obj,name=brick,pose=0,0,0.06,1,0,0,0",
             "--check", "brick:table,near_miss=0.02,safety=0")
    hand(case.folder / "hand.csv", [(0, 0, 0, 0.02, 0), (0.3, 0, 0, 0.02, 1), (0.5, 0, 0, 0.02, 0), (2.0, 0, 0, -0.035, 0),
                                    (4.0, 0.04, 0, -0.035, 0), (5.0, 0.04, 0, 0.02, 0)])
    return case.run("session", "--workcell", "cell.hcell", "--entity", "brick", "--hand", "hand.csv", *more)


def test_session_presses_slides_and_lifts(case):
    for rate in (10, 1000):
        answer = session_on_a_table(case, "--rate-manipulation", rate, "--trace", "trace.csv")
        assert answer["penetration"]["max_m"] <= 1e-4, answer["penetration"]
        assert 1.0 < answer["force"]["max_n"] <= 6.4, answer["force"]
        assert answer["force"]["max_step_n_per_ms"] <= 1.0 + 1e-9, answer["force"]
        assert answer["energy"]["min_j"] >= -1e-3, answer["energy"]
        assert len(answer["contacts"]) >= 1, answer["contacts"]
        lines = (case.folder / "trace.csv").read_text().splitlines()
        assert lines[0].startswith("t,x,y,z,qw,qx,qy,qz,proxy_x,proxy_y,proxy_z,fx,fy,fz"), lines[0]
        assert 4900 <= len(lines) <= 5200, len(lines)
        column = lines[0].split(",").index("fz")
        pressed = [float(line.split(",")[column]) for line in lines[2500:3500]]
        assert min(pressed) > 0.5, "the table pushes up while the hand presses"


def test_session_refuses_what_does_not_exist(case):
    session_on_a_table(case)
    message = case.run("session", "--workcell", "cell.hcell", "--entity", "stone", "--hand", "hand.csv", expect=2)
    assert "stone" in message and "brick" in message, message
    message = case.run("session", "--workcell", "cell.hcell", "--entity", "brick", "--hand", "hand.csv", "--set", "scale=huge", expect=2)
    assert "scale" in message, message
    message = case.run("session", "--workcell", "cell.hcell", "--entity", "brick", "--hand", "hand.csv", "--set", "colour=red", expect=2)
    assert "colour" in message, message


def test_session_refuses_what_is_unknown_or_said_twice(case):
    session_on_a_table(case)
    words = ["session", "--workcell", "cell.hcell", "--entity", "brick", "--hand", "hand.csv"]
    assert "--bogus" in case.run(*words, "--bogus", "1", expect=2)
    assert "more" in case.run(*words, "more", expect=2)
    assert "--entity" in case.run(*words, "--entity", "table", expect=2)
    assert "'scale' twice" in case.run(*words, "--set", "scale=1", "--set", "scale=2", expect=2)


def test_a_hand_path_of_a_clock_in_millimetres_is_recognised(case):
    plain = session_on_a_table(case, "--trace", "plain.csv")
    assert plain["assumptions"] == [], plain["assumptions"]
    rows = [line.split(",") for line in (case.folder / "hand.csv").read_text().splitlines()]
    for row in rows[1:]:
        row[0] = f"{1700000000 + float(row[0]):.3f}"
        row[1:4] = [f"{1000 * float(value):.6f}" for value in row[1:4]]
    (case.folder / "clock.csv").write_text("\n".join(",".join(row) for row in rows) + "\n")
    told = case.run("session", "--workcell", "cell.hcell", "--entity", "brick", "--hand", "clock.csv", "--trace", "clock_trace.csv")
    assert len(told["assumptions"]) == 2 and "millimetres" in told["assumptions"][1], told["assumptions"]
    assert abs(told["duration_s"] - plain["duration_s"]) < 1e-3, told["duration_s"]
    assert abs(told["force"]["max_n"] - plain["force"]["max_n"]) < 0.01, (told["force"], plain["force"])
    message = hand(case.folder / "far.csv", [(0, 0, 0, 5000, 0), (1, 0, 0, 5000, 0)]) or case.run(
        "session", "--workcell", "cell.hcell", "--entity", "brick", "--hand", "far.csv", expect=2)
    assert "metres" in message and "5000" in message, message


def test_a_session_that_passes_still_shows_its_collision(case):
    told = session_on_a_table(case, "--set", "on_contact=pass")
    assert told["force"]["max_n"] < 0.05, told["force"]
    assert told["penetration"]["max_m"] > 0.002 and told["penetration"]["blocked_max_m"] == 0.0, told["penetration"]
    (contact,) = told["contacts"]
    assert set(contact["entities"]) == {"brick", "table"} and contact["max_force"] == 0.0, contact


def test_a_session_fails_on_contact_when_asked(case):
    session_on_a_table(case)
    words = ("session", "--workcell", "cell.hcell", "--entity", "brick", "--hand", "hand.csv", "--fail-on-contact")
    assert case.run(*words, expect=1)["contacts"]
    hand(case.folder / "still.csv", [(0, 0, 0, 0, 0), (0.5, 0, 0, 0, 1)])
    assert not case.run(*words[:-2], "still.csv", words[-1])["contacts"]


def test_rates_are_those_asked_for(case):
    told = session_on_a_table(case, "--rate-manipulation", "10", "--rate-gui", "25")
    assert near(told["rates"]["manipulation_hz"], 10.0, 0.05) and near(told["rates"]["gui_hz"], 25.0, 0.2), told["rates"]


def test_a_result_goes_into_what_is_no_file_and_follows_links(case):
    write_binary_stl(case.folder / "a.stl", box((1, 1, 1)))
    (case.folder / "real.json").write_text("old")
    (case.folder / "link.json").symlink_to("real.json")
    done = subprocess.run([CLI, "inspect", "a.stl", "--json", "link.json"], cwd=case.folder)
    assert done.returncode == 0 and (case.folder / "link.json").is_symlink()
    assert json.loads((case.folder / "real.json").read_text())["format"]
    os.mkfifo(case.folder / "pipe")
    reader = subprocess.Popen(["cat", "pipe"], cwd=case.folder, stdout=subprocess.PIPE)
    assert subprocess.run([CLI, "inspect", "a.stl", "--json", "pipe"], cwd=case.folder, timeout=60).returncode == 0
    assert json.loads(reader.communicate(timeout=60)[0])["format"]
    assert stat.S_ISFIFO((case.folder / "pipe").stat().st_mode)
    # A link of the test's own to the device: a program that is wrong replaces the link, not the machine's device.
    (case.folder / "full").symlink_to("/dev/full")
    if os.path.exists("/dev/full"):
        assert "No space" in case.run("inspect", "a.stl", "--json", "full", expect=2)
        assert (case.folder / "full").is_symlink()
    (case.folder / "folder").mkdir()
    assert "a folder" in case.run("inspect", "a.stl", "--json", "folder", expect=2)


def test_session_without_forces_gives_none(case):
    answer = session_on_a_table(case, "--set", "forces=off")
    assert answer["force"]["max_n"] == 0.0, answer["force"]
    assert answer["penetration"]["max_m"] <= 1e-4, answer["penetration"]


def test_usage(case):
    assert "'insepct'; expected one of" in case.run("insepct", "box.stl", expect=2)
    assert subprocess.run([CLI, "--help"], capture_output=True).returncode == 0
    case.run(expect=2)
    case.run("fly", expect=2)
    assert "no command is named 'fly'" in case.run("trajectory", "fly", "a.csv", expect=2) and "retime" in case.error
    case.run("trajectory", expect=2)
    case.run("inspect", expect=2)


def main(tests):
    wanted = sys.argv[2] if len(sys.argv) > 2 else ""
    passed = failed = 0
    for name, test in list(tests.items()):
        if not name.startswith("test_") or wanted not in name:
            continue
        with tempfile.TemporaryDirectory() as folder:
            try:
                test(Case(pathlib.Path(folder)))
                passed += 1
                print("ok     ", name)
            except Exception as problem:  # a test run goes on after a failure
                failed += 1
                print("FAILED ", name, "-", type(problem).__name__, problem)
    print(f"{passed} passed, {failed} failed")
    return 1 if failed or not passed else 0


if __name__ == "__main__":
    sys.exit(main(globals()))
