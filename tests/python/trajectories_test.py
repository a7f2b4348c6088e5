# SPDX-License-Identifier: Apache-2.0
"""Trajectories: every edit against sums made here."""
from support import Case, about_z, hapticell, main, numpy


def circle(count=101, joints=False):
    t = numpy.linspace(0, 4, count)
    angle = numpy.pi * t / 4
    poses = [about_z(a, 0.2 * numpy.cos(a), 0.2 * numpy.sin(a), 0.1) for a in angle]
    if not joints:
        return hapticell.Trajectory(t, poses, name="circle")
    return hapticell.Trajectory(t, poses, joints=numpy.stack([angle, 2 * angle], 1), joint_names=["a", "b"])


class Trajectories(Case):
    def test_arrays_go_in_and_come_out(self):
        motion = circle(joints=True)
        self.assertEqual((len(motion), motion.joint_names, motion.joints.shape, motion.poses.shape), (101, ["a", "b"], (101, 2), (101, 7)))
        self.assertAlmostEqual(motion.duration, 4.0)
        self.assertClose(motion.joints[:, 1], 2 * motion.joints[:, 0])
        self.assertClose(motion.joints_at(2.0), [numpy.pi / 2, numpy.pi])
        self.assertError(lambda: hapticell.Trajectory([0, 0], circle(2).poses), place="index 1")
        self.assertError(lambda: hapticell.Trajectory([0, 1, 2], circle(2).poses), found="3 times")

    def test_files_come_back_bit_for_bit(self):
        motion = circle(joints=True)
        for name in ("a.htraj", "a.csv"):
            motion.save(self.folder / name)
            again = hapticell.Trajectory.load(self.folder / name)
            self.assertTrue((again.poses == motion.poses).all() and (again.joints == motion.joints).all())
        self.assertError(lambda: motion.save(self.folder / "a.src"), expected=".htraj")

    def test_cuts(self):
        motion = circle()
        part = motion.trimmed(1.0, 3.0)
        self.assertAlmostEqual(part.duration, 2.0)
        self.assertClose(part.poses[0], motion.pose_at(1.0), 1e-9)
        before, after = motion.split(1.5)
        self.assertClose(before.poses[-1], after.poses[0], 1e-9)
        self.assertAlmostEqual(before.duration + after.duration, 4.0)
        self.assertClose(motion.reversed().poses[0], motion.poses[-1])
        self.assertEqual(len(motion.resampled(0.5)), 9)
        self.assertEqual(len(motion.without_frames(10, 19)), 91)
        whole = before.joined([after.transformed([0, 0, 0.1, 1, 0, 0, 0])], speed=0.1)
        self.assertAlmostEqual(whole.duration, 4.0 + 1.0, 6)
        self.assertError(lambda: motion.split(9.0))

    def test_places(self):
        motion = circle()
        X = about_z(0.3, 1, 2, 3)
        self.assertClose(motion.transformed(X).poses[:, :3], [[1 + numpy.cos(0.3) * p[0] - numpy.sin(0.3) * p[1],
                                                               2 + numpy.sin(0.3) * p[0] + numpy.cos(0.3) * p[1], 3 + p[2]]
                                                              for p in motion.poses], 1e-12)
        self.assertClose(motion.mirrored([0, 0, 0], [0, 1, 0]).poses[:, 1], -motion.poses[:, 1])
        self.assertEqual(len(motion.with_frame(4.5, X)), 102)
        self.assertClose(motion.with_frame_at(50, X, reach=0.2).poses[50], X, 1e-9)
        self.assertEqual(len(motion.with_frame_moved(0, 50)), 101)
        self.assertAlmostEqual(motion.with_approach(0.1, [0, 0, 1], speed=0.1).duration, 5.0, 6)
        self.assertClose(motion.with_retract(0.1, [0, 0, 1]).poses[-1][2], 0.2, 1e-9)
        self.assertEqual(motion.with_name(3, "above").with_dwell(3, 1.0).name, "circle")

    def test_cleaning_stays_within_its_tolerance(self):
        motion = circle(401)
        few = motion.simplified(position=0.002, angle=0.05)
        self.assertLess(len(few), 60)
        position, angle, _ = few.deviation_from(motion)
        self.assertLessEqual(position, 0.002)
        self.assertLessEqual(angle, 0.05)
        noise = motion.poses.copy()
        noise[:, 2] += 2e-4 * numpy.sin(2 * numpy.pi * 9 * motion.times)
        shaky = hapticell.Trajectory(motion.times, noise)
        smooth = shaky.smoothed(position=0.001)
        self.assertLess(numpy.abs(smooth.poses[20:-20, 2] - 0.1).max(), 1e-4)
        self.assertError(lambda: motion.simplified(position=0), place="tolerance")

    def test_retiming_keeps_the_limits(self):
        motion = circle(joints=True)
        fast = motion.retimed(velocity=[1.0, 1.0], acceleration=[4.0, 4.0], sample=0.01)
        speed = numpy.abs(numpy.diff(fast.joints, axis=0) / numpy.diff(fast.times)[:, None])
        self.assertLessEqual(speed.max(), 1.0 + 1e-6)
        self.assertGreater(speed.max(), 0.95)
        # Joint b goes 2 pi at 1 rad/s, from rest to rest at 4 rad/s2: 2 pi + 1 / 4 s.
        self.assertAlmostEqual(fast.duration, 2 * numpy.pi + 0.25, 1)
        even = circle().retimed(speed=0.1, acceleration=1.0)
        self.assertGreater(even.duration, 0.2 * numpy.pi / 0.1)
        self.assertError(lambda: motion.retimed(velocity=[1.0], acceleration=[1.0]))


class Programs(Case):
    def test_a_program_is_written_and_read_again(self):
        few = circle().simplified(position=0.001, angle=0.02)
        made = hapticell.trajectory.export(few, to="krl", output=self.folder / "job.src")
        self.assertTrue((self.folder / "job.src").exists(), made)
        again = hapticell.Trajectory.load(self.folder / "job.src")
        self.assertClose(again.poses[-1][:3], few.poses[-1][:3], 1e-5)

    def test_check_takes_the_objects(self):
        cell = hapticell.Workcell()
        cell.add("box:0.05,0.05,0.05", name="tool", pose=[0.2, 0, 0.1, 1, 0, 0, 0])
        cell.add("box:0.1,0.1,0.1", name="post", pose=[0, 0.2, 0.1, 1, 0, 0, 0])
        motion = circle()
        motion.entity = "tool"
        result = hapticell.trajectory.check(motion, workcell=cell)
        self.assertFalse(result.free)
        self.assertEqual(result.findings[0].kind, "collision")


main()
