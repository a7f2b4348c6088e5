#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Whether two sessions in real time felt the same, for tools/check_arm64; exit 1 where they did not.

usage: compare_sessions.py A.json B.json
"""
import json
import sys

# Both run by the clock, so that contacts begin and end a little apart: as much as the latency of a step and of a message.
SECONDS = 0.1
# N: the hand is as much as 0.1 s apart, and a contact's stiffness does the rest.
NEWTONS = 0.5
# m and rad at the end, where the hand rests.
METRES, RADIANS = 0.001, 0.005


def faults(a, b):
    pairs = [[(c["entities"], c["parts"]) for c in session["contacts"]] for session in (a, b)]
    if sorted(map(str, pairs[0])) != sorted(map(str, pairs[1])):
        yield f"other pairs touched: {pairs[0]} and {pairs[1]}"
    else:
        for first, second in zip(a["contacts"], b["contacts"]):
            if abs(first["time_in"] - second["time_in"]) > SECONDS:
                yield f"{first['entities']} touched at {first['time_in']} and {second['time_in']} s"
    if abs(a["force"]["max_n"] - b["force"]["max_n"]) > NEWTONS:
        yield f"the greatest forces were {a['force']['max_n']:.2f} and {b['force']['max_n']:.2f} N"
    for session in (a, b):
        if session["force"]["max_n"] < 0.5:
            yield f"no force was felt ({session['force']['max_n']:.2f} N)"
        if session["penetration"]["max_m"] > 0.0:
            yield f"parts overlapped by {session['penetration']['max_m']} m"
    ends = [session["final_state"]["moved_frame"]["position"] for session in (a, b)]
    if max(abs(x - y) for x, y in zip(*ends)) > METRES:
        yield f"it ended at {ends[0]} and {ends[1]} m"
    if max(abs(x - y) for x, y in zip(a["final_state"]["joints"], b["final_state"]["joints"])) > RADIANS:
        yield "the joints ended elsewhere"


def main():
    sessions = []
    for path in sys.argv[1:3]:
        with open(path) as file:
            sessions.append(json.load(file))
    found = list(faults(*sessions))
    for fault in found:
        print(fault)
    for session, path in zip(sessions, sys.argv[1:3]):
        print(f"{path}: {session['rates']['haptic_hz']:.0f} Hz, {session['ticks_missed']} ticks missed, "
              f"latency {session['latency']['p50_ms']:.2f} ms (p99 {session['latency']['p99_ms']:.2f}), "
              f"force {session['force']['max_n']:.2f} N, {len(session['contacts'])} contacts")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
