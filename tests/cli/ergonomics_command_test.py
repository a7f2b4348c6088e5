#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The command `ergonomics`, against sums made here.

usage: ergonomics_command_test.py HAPTICELL_CLI [NAME_PART]
"""
import json
import sys

from command_line_test import main

RULA_ANGLES = {"upper_arm_flexion": 40, "upper_arm_abducted": False, "shoulder_raised": False, "arm_supported": False,
               "lower_arm_flexion": 80, "lower_arm_across_midline": False, "wrist_flexion": 12, "wrist_deviated": False,
               "wrist_twist": "mid", "neck_flexion": 18, "neck_twisted": False, "neck_side_bent": False, "trunk_flexion": 15,
               "trunk_twisted": False, "trunk_side_bent": False, "legs_supported": True}


def ergonomics(case, method, given, *more, expect=0):
    return case.run("ergonomics", method, "--input", json.dumps(given), *more, expect=expect)


def test_ergonomics_scores_with_reasons(case):
    bench = ergonomics(case, "rula", {"angles": RULA_ANGLES, "muscle_use": 1, "force": 0})
    assert [bench[k] for k in ("score_a", "score_b", "score_c", "score_d", "score")] == [3, 2, 4, 3, 3], bench
    assert bench["sub_scores"]["upper_arm"] == 2 and not bench["partial"] and bench["level"] == 2
    assert [entry["value"] for entry in bench["tables"]] == [3, 2, 3] and bench["assumptions"]
    assert all(driver["score"] < 3 for driver in bench["drivers"] + bench["posture_drivers"])
    reba = ergonomics(case, "reba", {"scores": {"neck": 1, "trunk": 2, "legs": 2, "upper_arm": 2, "lower_arm": 1, "wrist": 1},
                                     "load": 2, "coupling": 0, "activity": 0})
    assert reba["score"] == 4 and reba["score_a"] == 5 and reba["score_b"] == 1
    owas = ergonomics(case, "owas", {"code": "4141"})
    assert owas["score"] == owas["level"] == 4 and owas["sub_scores"] == {"back": 4, "arms": 1, "legs": 4, "load": 1}
    lift = {"load_kg": 10, "h_cm": 40, "v_cm": 30, "d_cm": 70, "asymmetry_deg": 30, "frequency_per_min": 2, "duration_h": 2,
            "coupling": "poor"}
    niosh = ergonomics(case, "niosh", lift, "--fail-over", "1", expect=1)
    limit = 23 * 25 / 40 * (1 - 0.003 * 45) * (0.82 + 4.5 / 70) * (1 - 0.0032 * 30) * 0.84 * 0.9
    assert abs(niosh["recommended_weight_limit_kg"] - limit) < 1e-9 and abs(niosh["score"] - 10 / limit) < 1e-9
    ergonomics(case, "niosh", lift, "--fail-over", "1.5")


def test_ergonomics_marks_what_is_missing(case):
    angles = dict(RULA_ANGLES)
    del angles["trunk_flexion"]
    without = ergonomics(case, "rula", {"angles": angles, "muscle_use": 0, "force": 0})
    assert without["score"] is None and without["partial"] and "trunk" in without["missing"]
    assert without["score_range"][0] < without["score_range"][1] and without["sub_scores"]["trunk"] is None
    light = ergonomics(case, "rula", {"angles": RULA_ANGLES})
    assert light["partial"] and "force_arm" in light["missing"] and light["score_range"][1] > light["score"]


def test_ergonomics_refuses_bad_fields_by_name(case):
    scores = {"upper_arm": 4, "lower_arm": 2, "wrist": 3, "wrist_twist": 1, "neck": 3, "trunk": 4, "legs": 2}
    lift = {"load_kg": 12, "h_cm": 25, "v_cm": 55, "d_cm": 95, "asymmetry_deg": 0, "frequency_per_min": 3, "duration_h": 1,
            "coupling": "fair"}
    bad = [("rula", {"scores": dict(scores, lower_arm=4)}, "lower_arm"), ("rula", {"scores": dict(scores, neck=2.5)}, "neck"),
           ("rula", {"scores": dict(scores, neck=True)}, "neck"), ("rula", {"scores": scores, "muscle_use": 2}, "muscle_use"),
           ("rula", {"scores": dict(scores, nek=1)}, "nek"), ("rula", {}, "scores"), ("rula", {"a": []}, "a"),
           ("rula", {"angles": dict(RULA_ANGLES, trunk_flexion=400)}, "trunk_flexion"),
           ("rula", {"angles": dict(RULA_ANGLES, wrist_twist="left")}, "wrist_twist"),
           ("reba", {"angles": {"seated": 1}}, "seated"), ("reba", {"scores": {}, "load": 4}, "load"),
           ("owas", {"code": "2181"}, "legs"), ("owas", {"code": "215"}, "code"), ("owas", {}, "code"),
           ("niosh", dict(lift, duration_h=9), "duration_h"), ("niosh", dict(lift, coupling="bad"), "coupling"),
           ("niosh", dict(lift, one_handed=True), "one_handed"), ("niosh", {"load_kg": 3}, "h_cm")]
    for method, given, name in bad:
        message = ergonomics(case, method, given, expect=2)
        assert name in message, (given, message)


if __name__ == "__main__":
    sys.exit(main(globals()))
