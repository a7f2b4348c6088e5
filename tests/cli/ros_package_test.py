#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A robot of a cell as a package of ROS 2: its files, and the robot equal when it is read again.

usage: ros_package_test.py HAPTICELL_CLI
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET

CLI = pathlib.Path(sys.argv[1])
CELL = pathlib.Path(__file__).resolve().parents[2] / "config/workcells/demo.hcell"


def run(*words, status=0):
    done = subprocess.run([CLI, *map(str, words)], capture_output=True, text=True, timeout=300)
    assert done.returncode == status, (words, done.returncode, done.stderr[-2000:])
    return json.loads(done.stdout) if status == 0 else done.stderr


def robot_of(entities):
    for entity in entities:
        if entity["kind"] == "robot":
            return entity
        below = robot_of(entity["children"])
        if below:
            return below
    return None


def main():
    with tempfile.TemporaryDirectory() as name:
        place = pathlib.Path(name) / "demo_arm"
        answer = run("ros2", "package", "--workcell", CELL, "-o", place, "--samples", 3000)
        for file in ("package.xml", "CMakeLists.txt", "launch/display.launch.py", "config/joint_limits.yaml", "config/robot.srdf",
                     "urdf/robot.urdf"):
            assert (place / file).is_file(), file
        compile((place / "launch/display.launch.py").read_text(), "display.launch.py", "exec")
        urdf, srdf = ET.parse(place / "urdf/robot.urdf").getroot(), ET.parse(place / "config/robot.srdf").getroot()
        assert ET.parse(place / "package.xml").findtext("name") == "demo_arm" and urdf.get("name") == srdf.get("name")
        links = {link.get("name") for link in urdf.iter("link")}
        for mesh in urdf.iter("mesh"):
            assert (place / mesh.get("filename").removeprefix("package://demo_arm/")).is_file(), mesh.get("filename")
        pairs = [(pair.get("link1"), pair.get("link2"), pair.get("reason")) for pair in srdf.iter("disable_collisions")]
        assert len(pairs) == sum(answer["pairs"].values()) > 0 and len({frozenset(pair[:2]) for pair in pairs}) == len(pairs)
        assert all(first in links and second in links for first, second, _ in pairs)
        children = {frozenset((joint.find("parent").get("link"), joint.find("child").get("link"))) for joint in urdf.iter("joint")}
        shaped = {link.get("name") for link in urdf.iter("link") if link.find("collision") is not None}
        for pair in children:  # Joined links with a shape are never checked.
            assert not pair <= shaped or pair in {frozenset(entry[:2]) for entry in pairs}, pair
        before, after = (robot_of(run("inspect", file)["entities"]) for file in (CELL, place / "urdf/robot.urdf"))
        assert [joint for joint in after["joints"] if joint["type"] != "fixed"] == [joint for joint in before["joints"] if joint["type"] != "fixed"]
        assert after["dof"] == before["dof"] == answer["joints"]
        assert "not empty" in run("ros2", "package", "--workcell", CELL, "-o", place, "--samples", 10, status=2)
        print("pairs", answer["pairs"])
    return 0


sys.exit(main())
