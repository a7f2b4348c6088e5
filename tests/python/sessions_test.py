# SPDX-License-Identifier: Apache-2.0
"""Sessions in virtual time with a hand written in Python."""
import csv
import json
import subprocess

from support import CLI, DEMO, DEMO_HAND, Case, hapticell, main, numpy


def cell():
    made = hapticell.Workcell()
    made.add("box:1,1,0.1", name="table", pose=[0, 0, -0.05, 1, 0, 0, 0])
    made.add("box:0.06,0.06,0.06", name="box", pose=[0, 0, 0.05, 1, 0, 0, 0])
    return made


def pressing(t, felt):
    """Takes the box, sinks by 30 mm within a second and stays."""
    return [0, 0, -0.03 * min(max(t - 0.5, 0), 1), 1, 0, 0, 0], 1 if 0.05 <= t < 0.15 else 0


class Sessions(Case):
    def test_a_hand_feels_the_table(self):
        result = cell().session("box", pressing, duration=2.0)
        trace = result.trace
        self.assertEqual(len(trace), 2001)
        self.assertAlmostEqual(trace["t"][-1], 2.0)
        self.assertTrue(trace["contact"].any())
        self.assertGreater(numpy.linalg.norm(trace["force"], axis=1).max(), 0.5)
        self.assertGreater(trace["moved"][-1][2], 0.03)  # It lies on the table, not in it.
        self.assertIn("table", result.contacts[0].entities)
        self.assertLess(result.penetration.max_m, 1e-6)

    def test_a_function_and_its_samples_are_the_same_session(self):
        rows = [[t, *pressing(t, None)[0], pressing(t, None)[1]] for t in numpy.arange(2001) * 0.001]
        live, path = cell().session("box", pressing, duration=2.0), cell().session("box", numpy.array(rows))
        self.assertTrue((live.trace == path.trace).all())
        self.assertEqual(live.force.max_n, path.force.max_n)

    def test_a_hand_that_answers_to_force(self):
        pushed = []

        def careful(t, felt):
            """Goes down until it feels half a newton, then stays."""
            down = pushed[-1] if pushed else 0.0
            if t > 0.5 and numpy.linalg.norm(felt.force) < 0.5:
                down += 3e-5
            pushed.append(down)
            return [0, 0, -down, 1, 0, 0, 0], 1 if 0.05 <= t < 0.15 else 0

        result = cell().session("box", careful, duration=3.0)
        self.assertLess(result.force.max_n, 1.5)
        self.assertGreater(result.force.max_n, 0.4)

    def test_the_trace_is_that_of_the_command(self):
        demo = hapticell.Workcell.open(DEMO)
        with open(DEMO_HAND, newline="") as file:
            rows = [row for row in csv.DictReader(file)]
        hand = numpy.array([[float(row[name]) for name in ("t", "x", "y", "z", "qw", "qx", "qy", "qz", "button")] for row in rows
                            if float(row["t"]) <= 2.0])
        here = demo.session("robot", hand, rate_manipulation=250)
        table = self.folder / "hand.csv"
        table.write_text("t,x,y,z,qw,qx,qy,qz,button\n" + "\n".join(",".join(repr(v) for v in row) for row in hand.tolist()))
        told = json.loads(subprocess.run([CLI, "session", "--workcell", DEMO, "--entity", "robot", "--hand", table,
                                          "--rate-manipulation", "250", "--trace", self.folder / "trace.csv"],
                                         capture_output=True, check=True).stdout)
        self.assertEqual(told["force"]["max_n"], here.force.max_n)
        written = numpy.genfromtxt(self.folder / "trace.csv", delimiter=",", names=True)
        self.assertClose(written["fx"], here.trace["force"][:, 0], 1e-6)
        self.assertClose(written["moved_x"], here.trace["moved"][:, 0], 1e-8)

    def test_what_a_hand_raises_ends_the_session(self):
        def failing(t, felt):
            if t > 0.3:
                raise LookupError("no more hands")
            return None

        with self.assertRaisesRegex(LookupError, "no more hands"):
            cell().session("box", failing, duration=2.0)

        def interrupting(t, felt):
            if t > 0.3:
                raise KeyboardInterrupt
            return None

        with self.assertRaises(KeyboardInterrupt):
            cell().session("box", interrupting, duration=2.0)

    def test_wrong_input_is_refused(self):
        self.assertError(lambda: cell().session("box", pressing), place="duration")
        self.assertError(lambda: cell().session("nobody", pressing, duration=1), found="nobody")
        self.assertError(lambda: cell().session("box", numpy.zeros((3, 4))), place="hand")
        self.assertError(lambda: cell().session("box", pressing, duration=1, rate_manipulation=1e9), place="rate_manipulation")
        self.assertError(lambda: cell().session("box", pressing, duration=1, set=["color=red"]))
        self.assertError(lambda: cell().session("box", lambda t, felt: "up", duration=1), place="pose")

    def test_progress_is_told(self):
        heard = []
        cell().session("box", pressing, duration=1.0, progress=lambda share, stage: heard.append(share))
        self.assertTrue(heard and sorted(heard) == heard and heard[-1] <= 1.0)


main()
