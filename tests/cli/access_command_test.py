#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The command access on the shipped gearbox: order, clearances that follow from its drawing, persons, files.

usage: access_command_test.py HAPTICELL_CLI
"""
import json
import pathlib
import subprocess
import sys
import tempfile

CLI = pathlib.Path(sys.argv[1])
CELL = pathlib.Path(__file__).resolve().parents[2] / "config/access/gearbox.hcell"


def run(*words, status=0):
    done = subprocess.run([CLI, *map(str, words)], capture_output=True, text=True, timeout=600)
    assert done.returncode == status, (words, done.returncode, done.stderr[-2000:])
    return json.loads(done.stdout) if status == 0 and done.stdout.startswith("{") else done.stderr


def a_screw_goes_at_once(folder):
    answer = run("access", CELL, "--part", "screw 1", "--nobody", "-o", folder / "screw.htraj")
    assert answer["removable"] and answer["blocked_by"] == [] and answer["order"] == ["screw 1"], answer
    # The shank of 6.0 mm in the ring's hole of 6.3 and the boss's of 6.2, as polygons of 48 sides.
    assert 0.15e-3 < answer["clearance_min_m"] < 0.25e-3, answer["clearance_min_m"]
    assert answer["clearance_to"] == "boss 1", answer["clearance_to"]
    written = json.loads((folder / "screw.htraj").read_text())
    assert "screw 1" in json.dumps(written)
    assert answer["measured"]["depth"] <= answer["promised"]["depth"], answer["measured"]


def screws_and_rings_go_before_the_cover(folder):
    answer = run("access", CELL, "--part", "cover", "--nobody")
    assert not answer["removable"], answer
    assert sorted(answer["blocked_by"]) == [f"ring {i}" for i in range(1, 5)], answer["blocked_by"]
    order = answer["order"]
    assert len(order) == 9 and order[-1] == "cover", order
    for i in range(1, 5):
        assert order.index(f"screw {i}") < order.index(f"ring {i}"), order


def the_gear_is_last(folder):
    answer = run("access", CELL, "--part", "gear 1", "--percentile", 50, "--sex", "male", "-o", folder / "gear.htraj",
                 "--report", folder / "gear.pdf")
    order = answer["order"]
    assert order[-1] == "gear 1" and len(order) == 12, order
    assert order.index("cover") < order.index("pump wheel") < order.index("spacer 1"), order
    assert (folder / "gear.pdf").read_bytes().startswith(b"%PDF"), "no page"
    assert answer["path"] == str(folder / "gear.htraj")
    # The bore's radius is 0.2 mm greater than the shaft's.
    assert 0.15e-3 < answer["clearance_min_m"] <= 0.25e-3, answer["clearance_min_m"]
    assert [one["body"] for one in answer["reach"]] == ["P50M"]
    assert set(answer["sight"]) == set(answer["scores"]) == {"P50M"}
    # The written way is checked again as one that was shown, once what is before it has gone.
    shown = run("access", CELL, "--part", "gear 1", "--nobody", "--shown", folder / "gear.htraj")
    assert shown["steps"][-1]["way"] == "shown" and shown["order"] == order, shown["order"]


def a_person_takes_a_screw(folder):
    answer = run("access", CELL, "--part", "screw 1", "--percentile", "5,95", "--tool", "0.2,0.01")
    assert [one["body"] for one in answer["reach"]] == ["P5F", "P95F", "P5M", "P95M"], answer["reach"]
    assert any(one["reached"] for one in answer["reach"]), answer["reach"]
    for one in answer["reach"]:
        if not one["reached"]:
            assert one["why"], one
            continue
        assert 1 <= answer["scores"][one["body"]]["rula"] <= 7
        assert answer["sight"][one["body"]]["seen"] > 0.3


def what_is_fixed_has_no_way_and_writes_nothing(folder):
    cell = json.loads(CELL.read_text())
    for entity in cell["entities"]:
        if entity["name"] == "cover":
            entity["locked"] = True
    (folder / "locked.hcell").write_text(json.dumps(cell))
    answer = run("access", folder / "locked.hcell", "--part", "gear 1", "--nobody")
    assert not answer["removable"] and answer["order"] == [], answer
    assert any(one == "cover" or one.startswith("housing") for one in answer["blocked_by"]), answer["blocked_by"]
    assert all(way["by_fixed"] for way in answer["straight_ways"]), answer["straight_ways"]
    words = run("access", folder / "locked.hcell", "--part", "gear 1", "--nobody", "-o", folder / "no.htraj", status=2)
    assert "no way out was found" in words and not (folder / "no.htraj").exists(), words


def faults_are_told(folder):
    assert "no part is named 'gear 9'" in run("access", CELL, "--part", "gear 9", status=2)
    assert "is locked" in run("access", CELL, "--part", "housing left", status=2)
    assert "no assembly is named" in run("access", CELL, "--part", "cover", "--within", "Engine", status=2)
    assert "ending" in run("access", CELL, "--part", "screw 1", "--nobody", "-o", folder / "way.txt", status=2)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for check in (a_screw_goes_at_once, screws_and_rings_go_before_the_cover, the_gear_is_last, a_person_takes_a_screw,
                      what_is_fixed_has_no_way_and_writes_nothing, faults_are_told):
            check(folder)


main()
