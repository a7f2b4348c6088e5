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


TASK = {"load_left_kg": 0, "load_right_kg": 2.4, "repetitions_per_min": 2, "static": False, "grip": "good", "duration_h": 7}


def test_ergonomics_scores_a_mannequins_posture_and_writes_its_report(case):
    figure = ("--sex", "female", "--percentile", "5", "--posture", "overhead")
    files = [case.folder / f"report.{ending}" for ending in ("pdf", "html", "csv", "json")]
    reports = [word for file in files for word in ("--report", file)]
    found = case.run("ergonomics", "posture", *figure, "--task", json.dumps(TASK), "--date", "20 Nov 2026", *reports)
    assert not found["partial"] and found["score"] == max(found[side]["rula"]["score"] for side in ("left", "right"))
    assert abs(found["stature"] - 1.525) < 1e-3 and found["right"]["rula"]["sub_scores"]["upper_arm"] >= 4
    assert found["drivers"][0]["input"] in ("upper arm", "neck") and found["drivers"][0]["score"] < found["score"]
    assert files[0].read_bytes().startswith(b"%PDF-") and "20 Nov 2026" in files[1].read_text()
    assert json.loads(files[3].read_text())["format"] == "hapticell-ergonomics-report"
    french = case.folder / "rapport.html"
    case.run("ergonomics", "posture", *figure, "--language", "fr", "--report", french)
    assert "Évaluation de la posture" in french.read_text(encoding="utf-8")
    bare = case.run("ergonomics", "posture", *figure)
    assert bare["partial"] and "load" in bare["missing"]
    case.run("ergonomics", "posture", *figure, "--fail-over", "1", expect=1)
    for bad, name in ((("--report", "report.doc"), ".doc"), (("--task", '{"load_left_kg":"x"}'), "load_left_kg"),
                      (("--task", '{"lod":1}'), "lod"), (("--percentile", "5", "--stature", "1.6"), "--stature")):
        assert name in case.run("ergonomics", "posture", *figure[:2], "--posture", "overhead", *(bad if "--stature" in bad else ("--percentile", "5", *bad)),
                                expect=2)


def test_ergonomics_zones_and_eaws(case):
    angles = {"trunk_flexion": 30, "trunk_twist": 0, "trunk_side_bend": 0, "upper_arm_flexion": 15, "gaze_below_horizontal": 10}
    zones = ergonomics(case, "en1005", angles)
    assert zones["level"] == 2 and zones["drivers"][0]["input"] == "trunk forward"
    assert ergonomics(case, "en1005", dict(angles, static=True), "--fail-over", "2", expect=1)["level"] == 3
    held = dict(angles, head_inclination=25)
    del held["gaze_below_horizontal"]
    iso = ergonomics(case, "iso11226", held)
    trunk = next(part for part in iso["parts"] if part["part"] == "trunk inclination")
    assert abs(trunk["holding_time_min"] - 3.25) < 1e-9 and iso["level"] == 2
    points = ergonomics(case, "eaws", {"stand_bent": 0.05, "sit_upright": 0.5})
    assert points["complete"] is False and abs(points["score"] - 6.0) < 1e-9, points
    for method, given, name in (("en1005", dict(angles, trunk=1), "trunk"), ("en1005", {}, "trunk_flexion"),
                                ("iso11226", dict(held, static=1), "static"), ("iso11226", angles, "head_inclination"),
                                ("eaws", {"sitting": 1}, "sitting"), ("eaws", {"lie": 0.7, "sit_bent": 0.7}, "shares"), ("eaws", [], "object")):
        assert name in ergonomics(case, method, given, expect=2)


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
           ("niosh", dict(lift, one_handed=True), "one_handed"), ("niosh", {"load_kg": 3}, "h_cm"),
           ("niosh", {"load_kg": 3, "v_cm": -5}, "v_cm: -5"), ("niosh", {"duration_h": 9}, "duration_h: 9"),
           ("niosh", {"d_cm": "far"}, "d_cm"), ("niosh", {"tasks": [lift, dict(lift, h_cm=-1)]}, "task 2, h_cm: -1")]
    for method, given, name in bad:
        message = ergonomics(case, method, given, expect=2)
        assert name in message, (given, message)


REBA_ANGLES = {"upper_arm_flexion": 40, "upper_arm_abducted": False, "shoulder_raised": False, "arm_supported": False,
               "lower_arm_flexion": 80, "wrist_flexion": 12, "wrist_deviated": False, "neck_flexion": 18, "neck_twisted": False,
               "neck_side_bent": False, "trunk_flexion": 15, "trunk_twisted": False, "trunk_side_bent": False,
               "knee_flexion": 10, "legs_bilateral": True, "seated": False}
ZONES = {"trunk_flexion": 30, "trunk_twist": 0, "trunk_side_bend": 0, "upper_arm_flexion": 15, "upper_arm_abduction": 5,
         "movements_per_min": 1, "static": False, "trunk_supported": False, "arm_supported": False}
GOOD = [
    ("rula", {"scores": {"upper_arm": 4, "lower_arm": 2, "wrist": 3, "wrist_twist": 1, "neck": 3, "trunk": 4, "legs": 2,
                         "muscle_use_arm": 0, "force_arm": 0, "muscle_use_body": 0, "force_body": 0}}),
    ("rula", {"angles": RULA_ANGLES, "muscle_use": 0, "force": 0}),
    ("reba", {"scores": {"neck": 1, "trunk": 3, "legs": 3, "upper_arm": 2, "lower_arm": 2, "wrist": 1}, "load": 1, "coupling": 1,
              "activity": 0}),
    ("reba", {"angles": REBA_ANGLES, "load": 1, "coupling": 1, "activity": 0}),
    ("owas", {"code": "2151"}),
    ("niosh", {"load_kg": 12, "h_cm": 25, "v_cm": 55, "d_cm": 95, "asymmetry_deg": 0, "frequency_per_min": 3, "duration_h": 1,
               "coupling": "fair", "one_handed": False, "seated_or_kneeling": False, "restricted_space": False,
               "unstable_load": False, "pushing_pulling_or_carrying": False, "fast": False, "hot_or_cold": False,
               "slippery_floor": False}),
    ("en1005", dict(ZONES, gaze_below_horizontal=10)),
    ("iso11226", dict(ZONES, head_inclination=25, shoulder_raised_deg=0)),
    ("eaws", {"stand_bent": 0.05, "sit_upright": 0.5}),
]


def leaves(given, path=()):
    for name, value in given.items():
        if isinstance(value, dict):
            yield from leaves(value, path + (name,))
        else:
            yield path + (name,), value


def replaced(given, path, value):
    """A copy in which the field at `path` is `value`."""
    copy = json.loads(json.dumps(given))
    at = copy
    for name in path[:-1]:
        at = at[name]
    at[path[-1]] = value
    return copy


def bad_values(value):
    """Of the wrong kind, and outside any range (each is a run of the program: no more than needed)."""
    if isinstance(value, bool):
        return ["yes"]
    if isinstance(value, str):
        return ["maybe", [value]]
    return ["7", 1e6]


def test_every_field_of_every_method_is_refused_by_name_when_it_is_bad(case):
    for method, given in GOOD:
        ergonomics(case, method, given)
        for path, value in leaves(given):
            for bad in bad_values(value):
                message = ergonomics(case, method, replaced(given, path, bad), expect=2)
                assert path[-1] in message, (method, path, bad, message)
        misspelt = replaced(given, path[:-1] + (path[-1] + "x",), value)
        assert path[-1] + "x" in ergonomics(case, method, misspelt, expect=2), (method, path)


def test_every_field_of_task_data_is_refused_by_name_when_it_is_bad(case):
    task = dict(TASK, name="Screw", mannequin="Ann", shock=False, rapid_changes=False, walking=False, trunk_supported=False,
                left_arm_supported=False, right_arm_supported=False, lift=True, lift_distance_m=0.6, asymmetry_deg=0, note="x")
    figure = ("--sex", "female", "--percentile", "5")
    case.run("ergonomics", "posture", *figure, "--task", json.dumps(task))
    for name, value in task.items():
        for bad in ([7] if name in ("name", "mannequin", "note") else bad_values(value)):
            message = case.run("ergonomics", "posture", *figure, "--task", json.dumps(dict(task, **{name: bad})), expect=2)
            assert name in message or name.replace("_left", "").replace("_right", "") in message, (name, bad, message)
    assert "loadx" in case.run("ergonomics", "posture", *figure, "--task", json.dumps(dict(task, loadx=1)), expect=2)


def test_each_score_of_a_posture_lists_what_it_is_made_of(case):
    found = case.run("ergonomics", "posture", "--sex", "female", "--percentile", "5", "--posture", "overhead", "--task", json.dumps(TASK))
    for side in (found["left"], found["right"]):
        assert side["inputs"]["upper_arm_flexion"] > 90 and side["inputs"]["wrist_twist"] in ("mid", "end")
        for method in ("rula", "reba"):
            score = side[method]
            assert len(score["tables"]) == 3 and score["tables"][-1]["table"] == "C" and score["source"]
            assert score["drivers"][0]["input"] in ("upper_arm", "neck") and score["drivers"][0]["score"] < score["score"]
            better = score["nearest_better_posture"]
            assert better["level"] < score["level"] and better["changes"]
            turned = dict(side["inputs"], **{change["input"]: change["to"] for change in better["changes"]})
            again = {name: turned[name] for name in RULA_ANGLES} if method == "rula" else {
                name: turned[name] for name in turned if name not in ("legs_supported", "wrist_twist")}
            loads = {name: score["sub_scores"][name] for name in ("load", "coupling", "activity")} if method == "reba" else {
                name: score["sub_scores"][name] for name in ("muscle_use_arm", "force_arm", "muscle_use_body", "force_body")}
            assert ergonomics(case, method, {"angles": again, **loads})["score"] == better["score"], (method, better)
        assert side["en1005"]["drivers"] and side["iso11226"]["drivers"]
    owas = found["owas"]
    assert owas["tables"][0]["value"] == owas["category"] == ergonomics(case, "owas", {"code": str(owas["code"])})["score"]
    stooped = case.run("ergonomics", "posture", "--sex", "male", "--percentile", "95", "--posture", "stooping")["owas"]
    assert stooped["category"] > 1 and stooped["drivers"] and stooped["next_level"]["level"] < stooped["category"]
    assert stooped["partial"] and stooped["missing"] == ["load"] and stooped["sub_scores"]["load"] is None and not owas["partial"]


LIFT_TASK = {"load_left_kg": 9, "load_right_kg": 9, "repetitions_per_min": 4, "static": False, "grip": "poor", "duration_h": 2, "lift": True,
             "lift_distance_m": 0.6}


def changed(inputs, changes):
    return dict(inputs, **{change["input"]: change["to"] for change in changes})


def test_every_method_says_what_brings_its_next_level_down(case):
    """What is told is put in again: the command must come to the level that it promised."""
    figure = ("ergonomics", "posture", "--sex", "female", "--percentile", "50", "--task", json.dumps(LIFT_TASK))
    for posture in ("overhead", "both_hands_forward"):
        found = case.run(*figure, "--posture", posture)
        for side in (found["left"], found["right"]):
            for method in ("en1005", "iso11226"):
                zones = side[method]
                assert ergonomics(case, method, zones["inputs"])["level"] == zones["level"] == 3, (posture, method)
                assert all(driver["changes"] for driver in zones["drivers"])
                better = zones["nearest_better_posture"]
                again = ergonomics(case, method, changed(zones["inputs"], better["changes"]))
                assert again["level"] == better["level"] < 3 and again["score"] == better["zone"], (posture, method, better)
        assert set(found["better_places"]) == {"RULA", "REBA", "OWAS", "EN 1005-4", "ISO 11226", "EAWS"}
        assert found["joint_comfort_drivers"] and found["hand_forces"]["drivers"][0]["lower_class_n"] < 177
        niosh = found["niosh"]
        assert niosh["level"] > 1 and niosh["drivers"][0]["value"] == min(d["value"] for d in niosh["drivers"])
        for way in niosh["next_level"]["any_of"]:
            again = ergonomics(case, "niosh", changed(niosh["inputs"], [way]))
            assert again["score"] <= niosh["next_level"]["lifting_index_at_most"], (posture, way)
    overhead = case.run(*figure, "--posture", "overhead")["eaws_outline"]
    assert overhead["level"] == 3 and overhead["nearest_better_posture"]["level"] == 1 and overhead["posture_drivers"]
    stooped = case.run(*figure, "--posture", "stooping")["owas"]
    assert stooped["nearest_better_posture"]["changes"][0]["input"] in ("trunk_flexion", "knee_flexion")
    shares = ergonomics(case, "eaws", {"stand_bent": 0.67, "stand_hands_above_head": 0.2})
    assert shares["drivers"][0]["points"] == 32 and shares["next_level"]["score"] <= 50 and shares["level"] == 3
    two = {"tasks": [dict(niosh["inputs"]), dict(niosh["inputs"], load_kg=5)]}
    composite = ergonomics(case, "niosh", two)
    assert composite["drivers"][0]["task"] == 1 and composite["drivers"][0]["lifting_index"] < composite["score"]
    assert composite["next_level"]["any_of"]


def posture_of(case, **joints):
    file = case.folder / ("-".join(f"{name}{angle}" for name, angle in joints.items()) + ".json")
    file.write_text(json.dumps({"format": "hapticell-posture", "version": 1, "unit": "deg", "joints": joints}))
    return case.run("ergonomics", "posture", "--sex", "male", "--percentile", "50", "--posture", file)


def zone(side, method, part):
    return next(entry["zone"] for entry in side[method]["parts"] if entry["part"] == part)


def test_angles_do_not_leak_and_do_not_jump(case):
    bend = posture_of(case, vl5_right_bend=11, vl1_right_bend=12, vt6_right_bend=9)
    turn = posture_of(case, vt6_left_turn=25, vl1_left_turn=8, vl5_left_turn=2)
    for found, flag in ((bend, "trunk_side_bent"), (turn, "trunk_twisted")):
        for side in (found["left"], found["right"]):
            assert side["inputs"]["trunk_flexion"] == 0 and side["inputs"][flag] and side["inputs"]["measured"], side["inputs"]
            assert side["rula"]["sub_scores"]["trunk"] == side["reba"]["sub_scores"]["trunk"] == 2
            assert zone(side, "en1005", "trunk forward") == zone(side, "iso11226", "trunk inclination") == "acceptable"
        assert found["owas"]["inputs"]["trunk_flexion"] == 0
    back = posture_of(case, r_shoulder_flexion=-30)["right"]
    assert not back["inputs"]["lower_arm_across_midline"] and back["rula"]["sub_scores"]["lower_arm"] == 2
    assert abs(back["inputs"]["upper_arm_flexion"] + 30) < 1
    sides = [posture_of(case, r_shoulder_abduction=angle)["right"] for angle in (94, 95, 96, 97)]
    for a, b in zip(sides, sides[1:]):
        for method in ("rula", "reba"):
            scores = [(a[method]["sub_scores"][name], b[method]["sub_scores"][name]) for name in a[method]["sub_scores"]]
            assert all(x is None or abs(x - y) <= 1 for x, y in scores), (method, scores)
    neck = dict(RULA_ANGLES, neck_flexion=-0.6)
    by_eye = ergonomics(case, "rula", {"angles": neck, "muscle_use": 0, "force": 0})
    measured = ergonomics(case, "rula", {"angles": dict(neck, measured=True), "muscle_use": 0, "force": 0})
    assert by_eye["sub_scores"]["neck"] == 4 and measured["sub_scores"]["neck"] == 1


def test_own_limits_of_the_hands_force(case):
    table = case.folder / "limits.csv"
    table.write_text("# source: our physiologist, 2026\nhand,height_from_m,height_to_m,limit_n\nany,0,3,40\nright,1.0,3,30\n")
    figure = ("ergonomics", "posture", "--sex", "male", "--percentile", "50", "--posture", "overhead", "--task", json.dumps(TASK))
    without = case.run(*figure)["hand_forces"]
    assert without["partial"] and without["missing"] == ["force_limits"]
    found = case.run(*figure, "--force-limits", table)["hand_forces"]
    assert not found["partial"], found
    right = next(limit for limit in found["limits"] if limit["method"] == "own" and limit["hand"] == "right")
    assert right["limit_n"] == 30 and abs(right["share"] - 2.4 * 9.80665 / 30) < 1e-9
    for text, name in (("hand,force\nany,3\n", "force"), ("limit_n\n-3\n", "limit_n"), ("limit_n\n", "line of values"), ("hand\nleft\n", "limit_n"),
                       ("hand,limit_n\nboth,3\n", "hand"), ("height_from_m,height_to_m,limit_n\n2,1,3\n", "height_to_m"),
                       ("limit_n\n1,2\n", "fields"), ("", "no header line")):
        table.write_text(text)
        assert name in case.run(*figure, "--force-limits", table, expect=2), text


if __name__ == "__main__":
    sys.exit(main(globals()))
