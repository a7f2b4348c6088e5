#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the hand path of the demonstration: take the robot, lower the part into the fixture, slide it on the locators to
the stop rail and along it, lift it out, let go.

usage: make_hand_path.py config/workcells/demo-hand.csv

Device frame: origin in the middle of the workspace, x to the right, y away from the user, z up; metres. The path is what
the hand intends: it presses some 7 mm deeper than the contacts allow. Between the stations it moves by minimum jerk.
"""
import sys

# time at the station, x, y, z, button
STATIONS = [(0.0, -0.025, 0.0, 0.010, 0), (0.5, -0.025, 0.0, 0.010, 0), (0.6, -0.025, 0.0, 0.010, 1),
            (0.8, -0.025, 0.0, 0.010, 0), (2.8, -0.025, 0.0, -0.026, 0), (3.4, -0.025, 0.0, -0.026, 0),
            (6.0, 0.026, 0.0, -0.026, 0), (7.8, 0.026, 0.045, -0.026, 0), (9.0, 0.026, -0.010, -0.026, 0),
            (10.6, 0.000, 0.0, 0.040, 0), (10.9, 0.0, 0.0, 0.040, 0), (11.0, 0.0, 0.0, 0.040, 1),
            (11.2, 0.0, 0.0, 0.040, 0), (12.0, 0.0, 0.0, 0.040, 0)]
STEP = 0.01


def at(time):
    for (t0, *p0, _), (t1, *p1, button) in zip(STATIONS, STATIONS[1:]):
        if time <= t1 + 1e-9:
            s = (time - t0) / (t1 - t0)
            s = s ** 3 * (10 - 15 * s + 6 * s * s)
            return [a + (b - a) * s for a, b in zip(p0, p1)], button
    raise ValueError(time)


def main(path):
    with open(path, "w", newline="\n") as file:
        file.write("t,x,y,z,qw,qx,qy,qz,button\n")
        for k in range(int(STATIONS[-1][0] / STEP) + 1):
            (x, y, z), button = at(k * STEP)
            pressed = 1 if button and k * STEP > 0.5 else 0
            file.write(f"{k * STEP:.2f},{x:.6f},{y:.6f},{z:.6f},1,0,0,0,{pressed}\n")


if __name__ == "__main__":
    main(sys.argv[1])
