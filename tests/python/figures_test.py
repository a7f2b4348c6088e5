# SPDX-License-Identifier: Apache-2.0
"""Figures, postures and scores: against published statures, and against the command."""
from support import Case, hapticell, main, numpy


class Figures(Case):
    def test_median_man_and_woman_are_those_of_ansur(self):
        # ANSUR II, medians of stature: 1755 and 1626 mm.
        self.assertAlmostEqual(hapticell.Figure("male", percentile=50).stature, 1.755, 3)
        self.assertAlmostEqual(hapticell.Figure("female", percentile=50).stature, 1.626, 3)
        self.assertAlmostEqual(hapticell.Figure("male", stature=1.9).measures["stature"], 1.9, 2)
        self.assertAlmostEqual(hapticell.Figure("male", stature=1.9, mass=95).mass, 95, 6)
        self.assertError(lambda: hapticell.Figure("male", stature=3.0))
        self.assertError(lambda: hapticell.Figure("child"), place="sex")
        self.assertError(lambda: hapticell.Figure("male", 50, 1.8), place="size")

    def test_the_command_says_the_same(self):
        figure = hapticell.Figure("female", percentile=95)
        told = hapticell.mannequin(sex="female", percentile=95, measure=True)
        for name in ("stature", "span", "eye_height", "hand_length"):
            self.assertAlmostEqual(told.measures[name], figure.measures[name], 9)

    def test_posture_is_an_object_of_named_angles(self):
        figure = hapticell.Figure()
        posture = figure.posture("standing")
        self.assertEqual((len(posture.angles), len(posture.joint_names())), (56, 56))
        bent = posture.copy()
        bent["r_elbow_flexion"] = 1.5
        self.assertNotEqual(posture["r_elbow_flexion"], 1.5)
        self.assertGreater(figure.hand_pose(bent, "right")[2], figure.hand_pose(posture, "right")[2])
        self.assertClose(bent.mirrored()["l_elbow_flexion"], 1.5)
        bent["r_elbow_flexion"] = -2.0
        self.assertTrue(any("r_elbow_flexion" in text for text in bent.violations()))
        self.assertError(lambda: posture["r_tail"], found="r_tail")
        self.assertError(lambda: figure.posture("flying"), expected="standing")

    def test_scores_grow_with_the_bend(self):
        figure = hapticell.Figure("male", stature=1.8)
        task = dict(load_kg=(4, 4), repetitions_per_min=2, static=False, shock=False, grip="good")
        standing, stooping = (figure.scores(figure.posture(name), **task) for name in ("standing", "stooping"))
        self.assertGreater(stooping.reba, standing.reba)
        self.assertGreater(stooping.rula, standing.rula)
        self.assertEqual(len(stooping.owas_code if isinstance(stooping.owas_code, str) else str(stooping.owas_code)), 4)
        self.assertGreater(len(figure.scores(figure.posture("standing")).missing), 0)
        self.assertError(lambda: figure.scores(figure.posture("standing"), grip="firm"), place="grip")

    def test_center_of_mass_is_over_the_feet(self):
        figure = hapticell.Figure()
        x, y, z = figure.center_of_mass(figure.posture("standing"))
        self.assertAlmostEqual(y, 0, 2)
        self.assertTrue(0.5 * figure.stature < z < 0.62 * figure.stature)

    def test_reach_holds_the_hand(self):
        figure = hapticell.Figure()
        reach = figure.reach(figure.posture("standing"), "right")
        self.assertGreater(reach.volume, 0.1)

    def test_lifting_equation_of_the_applications_manual(self):
        # Waters et al. 1994, example 1 of NIOSH 94-110, loading punch press stock: RWL 7.4 kg (16.4 lb) at the destination.
        result = hapticell.ergonomics.niosh(input={"load_kg": 20, "h_cm": 50.8, "v_cm": 160.02, "d_cm": 121.92, "asymmetry_deg": 0,
                                                   "frequency_per_min": 0.2, "duration_h": 1, "coupling": "fair"})
        self.assertAlmostEqual(result.recommended_weight_limit_kg, 23 * (25 / 50.8) * (1 - 0.003 * abs(160.02 - 75)) * (0.82 + 4.5 / 121.92), 2)


main()
