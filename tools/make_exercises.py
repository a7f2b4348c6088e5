#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the sample exercises: cells of boxes and cylinders, the expert's hand, and what the exercise says.

usage: make_exercises.py FOLDER [HAPTICELL_CLI]

With the program the experts' recordings are made too, by sessions of the simulated hand.
"""
import json
import math
import pathlib
import subprocess
import sys

GREY, STEEL, BLUE, WOOD = [0.5, 0.5, 0.55], [0.72, 0.74, 0.76], [0.25, 0.45, 0.7], [0.65, 0.5, 0.35]


def solid(name, shape, position, color=GREY, locked=True, frames=(), mass=1.0):
    return {"name": name, "kind": "solid", "source": {"file": shape, "scale": 1.0},
            "placement": {"position": list(position), "quaternion": [1.0, 0.0, 0.0, 0.0]}, "parent": "",
            "color": color, "visible": True, "locked": locked, "checked": True, "on_contact": "slide",
            "force_class": "contact", "material": "steel", "mass": mass,
            "frames": [{"name": n, "placement": {"position": list(p), "quaternion": [1.0, 0.0, 0.0, 0.0]}}
                       for n, p in frames]}


def box(*size):
    return "box:" + ",".join(repr(s) for s in size)


def cell(entities, guides=(), safety=0.0005, eye=(0.5, -0.6, 0.45), target=(0.0, 0.0, 0.05)):
    return {"format": "hapticell-workcell", "version": 1, "entities": entities,
            "pair_sets": [{"name": "everything", "enabled": True, "first": [], "second": [],
                           "safety_distance": safety, "near_miss": 0.005}],
            "guides": list(guides), "view": {"eye": list(eye), "target": list(target)}, "trajectories": []}


def guide(name, kind, entity, position, quaternion=(1.0, 0.0, 0.0, 0.0), **more):
    return {"name": name, "kind": kind, "entity": entity, "enabled": True,
            "placement": {"position": list(position), "quaternion": list(quaternion)}, **more}


def eased(s):
    return s * s * s * (10 - 15 * s + 6 * s * s)


def hand(stations, scale):
    """The hand's path through (seconds to get there, displacement in the cell, turn (axis, angle)), at rest at each."""
    rows, t = ["t,x,y,z,qw,qx,qy,qz,button"], 0.0
    place, turn = (0.0, 0.0, 0.0), ((0.0, 0.0, 1.0), 0.0)
    middle = [0.5 * (min(s[1][k] for s in stations + [(0, place, turn)]) + max(s[1][k] for s in stations + [(0, place, turn)]))
              for k in range(3)]

    def add(p, axis, angle, pressed):
        half = 0.5 * angle
        q = [math.cos(half)] + [a * math.sin(half) for a in axis]
        x = [(p[k] - middle[k]) / scale for k in range(3)]
        rows.append("%.3f," % t + ",".join("%.6f" % v for v in x) + "," + ",".join("%.9f" % v for v in q) + ",%d" % pressed)

    for i in range(25):
        add(place, *turn, 1 if 5 <= i < 15 else 0)
        t += 0.02
    for seconds, to, to_turn in stations:
        steps = max(1, round(seconds / 0.02))
        axis = to_turn[0] if to_turn[1] else turn[0]
        for i in range(1, steps + 1):
            s = eased(i / steps)
            add([place[k] + s * (to[k] - place[k]) for k in range(3)], axis, turn[1] + s * (to_turn[1] - turn[1]), 0)
            t += 0.02
        place, turn = to, (axis, to_turn[1])
    for _ in range(10):
        add(place, *turn, 0)
        t += 0.02
    return "\n".join(rows) + "\n"


STILL = ((0.0, 0.0, 1.0), 0.0)
ROUND_X = (1.0, 0.0, 0.0)


def peg():
    wide, gap, deep = 0.04, 0.0206, 0.04
    off = 0.5 * gap + 0.5 * wide
    walls = [solid("wall left", box(wide, gap + 2 * wide, deep), (-off, 0, 0.5 * deep)),
             solid("wall right", box(wide, gap + 2 * wide, deep), (off, 0, 0.5 * deep)),
             solid("wall front", box(gap, wide, deep), (0, -off, 0.5 * deep)),
             solid("wall back", box(gap, wide, deep), (0, off, 0.5 * deep))]
    entities = [solid("table", box(0.4, 0.3, 0.02), (0.02, 0, -0.0105), WOOD),
                solid("peg", box(0.02, 0.02, 0.06), (0.09, 0, 0.032), BLUE, locked=False, mass=0.2)] + walls
    path = [(1.0, (0, 0, 0.05), STILL), (1.6, (-0.09, 0, 0.05), STILL), (0.3, (-0.09, 0, 0.05), STILL),
            (1.6, (-0.09, 0, 0.004), STILL)]
    return {"name": "Peg in hole", "text": "Lift the peg over the block and put it into the hole without leaning on the walls.",
            "cell": cell(entities, safety=0.0), "entity": "peg", "moved_by": "self_origin", "scale": 1.0, "path": path,
            "tube_radius": 0.006, "lead": 0.008, "deviation_costs_all": 0.006}


def door():
    width = 0.36
    entities = [solid("frame left", box(0.04, 0.3, 0.56), (-0.045, 0.14, 0.28)),
                solid("frame right", box(0.04, 0.3, 0.56), (width + 0.0235, 0.14, 0.28)),
                solid("cabinet floor", box(width + 0.09, 0.3, 0.02), (0.5 * width, 0.14, -0.012), WOOD),
                solid("door", box(width, 0.018, 0.54), (0.5 * width, -0.022, 0.28), BLUE, locked=False, mass=4.0,
                      frames=[("handle", (0.5 * width - 0.03, -0.02, 0.0))])]
    radius = width - 0.03
    path, turned, steps = [], 1.0, 150
    for i in range(1, steps + 1):
        a = turned * eased(i / steps)
        dx = radius * math.cos(a) - 0.042 * math.sin(a) - radius
        dy = -radius * math.sin(a) - 0.042 * math.cos(a) + 0.042
        path.append((0.02, (dx, dy, 0.0), STILL))
    hinge = guide("hinge", "hinge", "door", (0.0, 0.0, 0.28), lower=-1.2, upper=0.0, friction=0.2)
    return {"name": "Door", "text": "Take the door by its handle and open it by sixty degrees along its hinge.",
            "cell": cell(entities, [hinge], eye=(0.9, -1.1, 0.8), target=(0.18, 0, 0.25)), "entity": "door",
            "moved_by": "frame:handle", "scale": 4.0, "path": path, "tube_radius": 0.03, "lead": 0.03,
            "deviation_costs_all": 0.03}


def screw():
    entities = [solid("plate left", box(0.05, 0.12, 0.03), (-0.034, 0, 0.015)),
                solid("plate right", box(0.05, 0.12, 0.03), (0.034, 0, 0.015)),
                solid("table", box(0.3, 0.3, 0.02), (0, 0, -0.0105), WOOD),
                solid("screw", "cylinder:0.007,0.05", (0, 0, 0.062), STEEL, locked=False, mass=0.1)]
    turn, pitch = 2.4, 0.02
    advance = -pitch * turn / (2 * math.pi)
    path = [(3.0, (0, 0, advance), ((0.0, 0.0, 1.0), -turn))]
    thread = guide("thread", "screw", "screw", (0, 0, 0.0), pitch=pitch, friction=0.1)
    return {"name": "Screw", "text": "Turn the screw by a hundred and forty degrees; it goes in as its thread leads it.",
            "cell": cell(entities, [thread], eye=(0.25, -0.3, 0.25), target=(0, 0, 0.04)), "entity": "screw",
            "moved_by": "self_origin", "scale": 1.0, "path": path, "tube_radius": 0.006, "lead": 0.004,
            "deviation_costs_all": 0.006}


def extraction():
    # A filter unit behind a slot that is wide but low: it comes out on its side only.
    wide, high, thick = 0.09, 0.05, 0.02
    out = 0.12
    walls = [solid("panel left", box(out, thick, 0.3), (-0.5 * wide - 0.5 * out, 0, 0.15)),
             solid("panel right", box(out, thick, 0.3), (0.5 * wide + 0.5 * out, 0, 0.15)),
             solid("panel below", box(wide, thick, 0.125), (0, 0, 0.0625)),
             solid("panel above", box(wide, thick, 0.125), (0, 0, 0.2375)),
             solid("housing floor", box(0.33, 0.3, 0.02), (0, 0.16, 0.09)),
             solid("housing back", box(0.33, 0.02, 0.3), (0, 0.32, 0.15))]
    unit = solid("filter unit", box(0.036, 0.1, 0.076), (0, 0.14, 0.142), BLUE, locked=False, mass=0.5)
    quarter = 0.5 * math.pi
    round_y = (0.0, 1.0, 0.0)
    path = [(0.8, (0, 0.02, 0.03), STILL), (1.6, (0, 0.02, 0.03), (round_y, quarter)),
            (0.8, (0, 0.02, 0.008), (round_y, quarter)), (2.4, (0, -0.24, 0.008), (round_y, quarter))]
    return {"name": "Extraction", "text": "Bring the filter unit out of its housing: lift it, lay it on its side, and draw "
            "it through the slot.", "cell": cell(walls + [unit], safety=0.0, eye=(0.5, -0.7, 0.5), target=(0, 0.05, 0.15)),
            "entity": "filter unit", "moved_by": "self_origin", "scale": 2.0, "path": path, "tube_radius": 0.015,
            "lead": 0.015, "deviation_costs_all": 0.015}


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for made in (peg(), door(), screw(), extraction()):
        stem = made["name"].lower().replace(" ", "_")
        (folder / f"{stem}.hcell").write_text(json.dumps(made["cell"], indent=1) + "\n")
        (folder / f"{stem}-hand.csv").write_text(hand(made["path"], made["scale"]))
        exercise = {"format": "hapticell-exercise", "version": 1, "name": made["name"], "text": made["text"],
                    "workcell": f"{stem}.hcell", "recording": f"{stem}-expert.htraj"}
        exercise.update({k: made[k] for k in ("tube_radius", "lead", "deviation_costs_all")})
        (folder / f"{stem}.hexercise").write_text(json.dumps(exercise, indent=1) + "\n")
        if len(sys.argv) < 3:
            continue
        done = subprocess.run(
            [sys.argv[2], "session", "--workcell", folder / f"{stem}.hcell", "--entity", made["entity"], "--hand",
             folder / f"{stem}-hand.csv", "--set", f"moved_by={made['moved_by']}", "--set", "axes=cell", "--set",
             f"scale={made['scale']}", "--record", folder / f"{stem}-expert.htraj", "--record-interval", "0.02"],
            capture_output=True, text=True, timeout=120, check=False)
        print(stem, done.returncode, done.stderr.strip()[-300:])
        if done.returncode == 0:
            result = json.loads(done.stdout)
            print("  ", {k: result[k] for k in ("force", "penetration", "contacts")}, result["final_state"]["pose"])


if __name__ == "__main__":
    main()
