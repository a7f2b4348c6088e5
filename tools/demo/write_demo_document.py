#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the demonstration workcell document around the meshes of make_demo_workcell.py.

usage: write_demo_document.py config/workcells/demo.hcell

The shipped file has then been opened and saved once in HaptiCell, which writes every key in the program's own layout.
"""
import json
import math
import sys

from make_demo_workcell import (A1_HEIGHT, A2_FORWARD, A2_HEIGHT, FOREARM, FOREARM_RISE, HOUSING_GRIP, JAW_CENTRE, SEAT,
                                UPPER_ARM, WRIST_TO_FLANGE)

BASE_HEIGHT = 0.35
GREY, DARK, STEEL, BLUE, TAN, LIGHT = ((0.50, 0.51, 0.52), (0.27, 0.30, 0.34), (0.40, 0.45, 0.52), (0.33, 0.40, 0.51),
                                       (0.66, 0.56, 0.42), (0.62, 0.64, 0.66))
SOLIDS = [("Base plate 500 x 620", "base_plate", "Fixture F20", BLUE), ("Clamp tower A", "clamp_tower_a", "Fixture F20", STEEL),
          ("Clamp tower B", "clamp_tower_b", "Fixture F20", STEEL), ("Clamp tower C", "clamp_tower_c", "Fixture F20", STEEL),
          ("Locators 1, 3, 4", "locators_1_3_4", "Fixture F20", LIGHT), ("Locator 2", "locator_2", "Fixture F20", LIGHT),
          ("Stop rail", "stop_rail", "Fixture F20", STEEL), ("Table", "table", "", GREY),
          ("Pedestal", "pedestal", "", DARK), ("Conveyor", "conveyor", "Conveyor and 3 housings", GREY),
          ("Fence", "fence", "Fence, posts, cabinet", DARK), ("Posts", "posts", "Fence, posts, cabinet", GREY),
          ("Cabinet", "cabinet", "Fence, posts, cabinet", LIGHT)]
HOUSINGS = [("Housing 4712", 0.20), ("Housing 4713", 0.90), ("Housing 4714", 1.60)]


def placement(x=0.0, y=0.0, z=0.0):
    return {"position": [x, y, z], "quaternion": [1.0, 0.0, 0.0, 0.0]}


def joints_over_the_seat(x, rise):
    """Joint angles that hold the part `rise` above its seat with the tool pointing down, in the plane of axis 1."""
    wrist_x = x - A2_FORWARD
    wrist_z = SEAT + HOUSING_GRIP + rise + JAW_CENTRE + WRIST_TO_FLANGE - BASE_HEIGHT - A1_HEIGHT - A2_HEIGHT
    lower = math.hypot(FOREARM, FOREARM_RISE)
    distance = math.hypot(wrist_x, wrist_z)
    upper_angle = math.atan2(wrist_z, wrist_x) + math.acos(
        (UPPER_ARM ** 2 + distance ** 2 - lower ** 2) / (2 * UPPER_ARM * distance))
    a2 = math.pi / 2 - upper_angle
    elbow = (UPPER_ARM * math.sin(a2), UPPER_ARM * math.cos(a2))
    forearm_angle = math.atan2(wrist_z - elbow[1], wrist_x - elbow[0])
    a3 = math.atan2(FOREARM_RISE, FOREARM) - forearm_angle - a2
    return {"joint_1": 0.0, "joint_2": round(a2, 9), "joint_3": round(a3, 9), "joint_4": 0.0,
            "joint_5": round(math.pi / 2 - a2 - a3, 9), "joint_6": 0.0}


def solid(name, mesh, parent, color, pose, locked=True):
    return {"name": name, "kind": "solid", "source": {"file": f"demo/{mesh}.stl", "scale": 1.0}, "placement": pose,
            "parent": parent, "color": list(color), "locked": locked}


def document():
    robot = {"name": "robot", "kind": "robot", "source": {"file": "../robots/hc6/robot.urdf", "scale": 1.0},
             "placement": placement(z=BASE_HEIGHT), "joints": joints_over_the_seat(0.99, 0.030), "tip_link": "tcp", "mass": 12.0}
    entities = [robot] + [solid(*row, placement()) for row in SOLIDS]
    entities += [solid(name, "housing", "Conveyor and 3 housings", TAN, placement(x, 1.18, 0.868), False) for name, x in HOUSINGS]
    cell = [row[0] for row in SOLIDS if row[0] != "Pedestal"] + [name for name, _ in HOUSINGS]
    sets = [{"name": "Robot against the cell", "first": ["robot"], "second": cell, "safety_distance": 0.001, "near_miss": 0.010},
            {"name": "Housings against everything", "first": [name for name, _ in HOUSINGS], "second": [],
             "safety_distance": 0.0005, "near_miss": 0.005}]
    return {"format": "hapticell-workcell", "version": 1, "entities": entities, "pair_sets": sets,
            "view": {"eye": [2.75, -1.95, 1.95], "target": [0.72, 0.10, 0.78]}, "trajectories": []}


if __name__ == "__main__":
    with open(sys.argv[1], "w", encoding="utf-8", newline="\n") as file:
        json.dump(document(), file, indent=2, ensure_ascii=False)
        file.write("\n")
