# SPDX-License-Identifier: Apache-2.0
"""Workcells: commands and undo, saving, checks of a robot, pictures."""
import json
import os
import shutil
import subprocess

from support import CLI, DEMO, SOURCE, Case, about_z, hapticell, main, numpy


class Workcells(Case):
    def cell(self):
        cell = hapticell.Workcell()
        cell.add("box:1,1,0.1", name="table", pose=[0, 0, -0.05, 1, 0, 0, 0])
        cell.add("box:0.1,0.1,0.1", name="part", pose=[0, 0, 0.25, 1, 0, 0, 0])
        return cell

    def test_changes_are_steps_that_can_be_undone(self):
        cell = self.cell()
        self.assertEqual(cell.names, ["table", "part"])
        self.assertEqual(list(cell), cell.names)
        cell.move("part", about_z(0.5, 0.3, 0, 0.5))
        cell.rename("part", "lid")
        cell.set("lid", color=[1, 0, 0], mass=2.5, locked=False, on_contact="stop")
        self.assertIn("lid", cell)
        self.assertEqual((cell["lid"].mass, cell["lid"].on_contact, cell["lid"].kind), (2.5, "stop", "solid"))
        self.assertClose(cell["lid"].pose, about_z(0.5, 0.3, 0, 0.5))
        steps = len(cell.history)
        for _ in range(3):
            self.assertTrue(cell.undo())
        self.assertClose(cell["part"].pose, [0, 0, 0.25, 1, 0, 0, 0])
        self.assertEqual(len(cell.history), steps - 3)
        self.assertTrue(cell.redo())
        self.assertClose(cell["part"].pose[0], 0.3)

    def test_a_step_that_fails_changes_nothing(self):
        cell = self.cell()
        with self.assertRaises(ZeroDivisionError):
            with cell.step("Nothing"):
                cell.remove("part")
                1 / 0
        self.assertIn("part", cell)
        with cell.step("Both"):
            cell.remove("part")
            cell.remove("table")
        self.assertEqual((len(cell), cell.history[-1]), (0, "Both"))
        cell.undo()
        self.assertEqual(len(cell), 2)

    def test_saved_cell_is_the_one_that_the_program_reads(self):
        cell = self.cell()
        cell.add_check("Lid", ["part"], ["table"], safety_distance=0.002)
        self.assertTrue(cell.dirty)
        cell.save(self.folder / "a.hcell")
        self.assertFalse(cell.dirty)
        again = hapticell.Workcell.open(self.folder / "a.hcell")
        self.assertEqual(again.names, cell.names)
        document = json.loads((self.folder / "a.hcell").read_text())
        self.assertEqual(document["format"], "hapticell-workcell")
        told = json.loads(subprocess.run([CLI, "inspect", self.folder / "a.hcell"], capture_output=True, check=True).stdout)
        self.assertEqual([one["name"] for one in told["entities"]], cell.names)
        cell.convert(self.folder / "a.glb")
        self.assertGreater((self.folder / "a.glb").stat().st_size, 500)
        self.assertError(lambda: cell.save(self.folder / "a.txt"), expected=".hcell")
        self.assertError(lambda: hapticell.Workcell.open(self.folder / "b.hcell"), file="b.hcell")

    def test_distances_as_the_cell_stands(self):
        cell = self.cell()
        found = cell.distances("part")
        self.assertEqual((len(found), found[0].other), (1, "table"))
        self.assertAlmostEqual(found["distance"][0], 0.2, 9)
        cell.leave_out("part", "table")
        self.assertEqual(len(cell.distances("part")), 0)
        self.assertError(lambda: cell.distances("nobody"), found="nobody", expected="table")

    def test_what_is_attached_goes_along(self):
        cell = self.cell()
        cell.attach("part", "table")
        cell.move("table", [1, 0, -0.05, 1, 0, 0, 0])
        self.assertClose(cell["part"].pose[:3], [1, 0, 0.25])
        self.assertEqual(cell["part"].attached_to, "table")
        cell.detach("part")
        self.assertEqual(cell["part"].attached_to, "")

    def test_wrong_values_are_refused(self):
        cell = self.cell()
        self.assertError(lambda: cell.set("part", weight=2), place="weight", expected="mass")
        self.assertError(lambda: cell.set("part", on_contact="bounce"), found="bounce")
        self.assertError(lambda: cell.add("box:1,1,1", name="table"), found="in use")
        self.assertError(lambda: cell.set_joints("part", [1.0]))
        self.assertEqual(len(cell), 2)

    def test_import_of_a_file_reports_progress(self):
        hapticell.Mesh.box(0.2, 0.2, 0.2).save(self.folder / "b.step")
        heard, cell = [], hapticell.Workcell()
        names = cell.add(self.folder / "b.step", merge=True, progress=lambda share, stage: heard.append(share))
        self.assertEqual(len(names), 1)
        self.assertTrue(heard and all(0 <= share <= 1 for share in heard))
        self.assertEqual(cell[names[0]].source, str(self.folder / "b.step"))

    def test_picture_is_a_png_of_the_cell(self):
        if not hapticell._engine.program_path("hapticell"):
            self.skipTest("the window is not built")
        if not os.environ.get("DISPLAY") and not shutil.which("xvfb-run"):
            self.skipTest("there is no display and no xvfb-run")
        cell = self.cell()
        with_part = cell.render(self.folder / "cell.png", size=(320, 200))
        self.assertEqual(with_part[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(numpy.frombuffer(with_part[16:24], ">u4").tolist(), [320, 200])
        self.assertEqual((self.folder / "cell.png").read_bytes(), with_part)
        cell.remove("part")
        self.assertNotEqual(cell.render(size=(320, 200)), with_part)


class RobotInCell(Case):
    def setUp(self):
        super().setUp()
        self.cell = hapticell.Workcell()
        self.cell.add(SOURCE / "examples/data/arm.urdf", name="arm")
        self.robot = self.cell.robot("arm")

    def test_free_solutions_are_solutions_that_are_free(self):
        pose = self.robot.fk(self.robot.rest + 0.3)
        everything = [one for one in self.robot.ik_all(pose) if one.within_limits]
        self.assertGreater(len(everything), 0)
        tool = pose[:3]
        self.cell.add("box:0.1,0.1,0.1", name="block", pose=[*tool, 1, 0, 0, 0])
        self.assertEqual(len(self.cell.free_ik("arm", [pose])[0]), 0)
        self.cell.move("block", [5, 0, 0, 1, 0, 0, 0])
        check = self.cell.joint_check("arm")
        for joints in self.cell.free_ik("arm", [pose])[0]:
            self.assertClose(self.robot.fk(joints)[:3], tool, 1e-6)
            self.assertTrue(check.is_free(joints))

    def test_check_of_many_equals_check_of_each(self):
        self.cell.add("box:0.4,0.4,0.4", name="block", pose=[0.4, 0, 0.3, 1, 0, 0, 0])
        check = self.cell.joint_check("arm")
        q = numpy.random.default_rng(3).uniform(-1.2, 1.2, (100, self.robot.dof))
        many = check.are_free(q)
        self.assertEqual(many.tolist(), [check.is_free(one) for one in q])
        self.assertTrue(many.any() and not many.all())
        blocked = q[~many][0]
        self.assertIn("would touch", check.contact(blocked))
        self.assertEqual(check.contact(q[many][0]), "")
        self.assertGreaterEqual(check.clearance(q[many][0], 2.0), 0)
        self.assertFalse(check.are_free([[numpy.nan] * self.robot.dof])[0])

    def test_demonstration_cell_opens(self):
        cell = hapticell.Workcell.open(DEMO)
        self.assertEqual(cell["robot"].kind, "robot")
        joints = cell["robot"].joints
        cell.set_joints("robot", joints * 0)
        self.assertClose(cell["robot"].joints, joints * 0)
        cell.undo()
        self.assertClose(cell["robot"].joints, joints)


main()
