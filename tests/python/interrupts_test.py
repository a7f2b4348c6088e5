# SPDX-License-Identifier: Apache-2.0
"""Ctrl+C ends long calls: a thread sends the signal while each is at work.

No clock is asserted: each call has so much to do that it would take minutes, and the test's own time limit is the only one. That
it ended early is seen by the exception, and by the work that it had not done.
"""
import os
import signal
import threading

from support import DEMO, SOURCE, Case, about_z, hapticell, main, numpy

ARM = str(SOURCE / "examples/data/arm.urdf")
#: Seconds until the signal comes: each call is in the engine by then.
AFTER = 0.4


class Interrupts(Case):
    def interrupted(self, call):
        """The call ends by KeyboardInterrupt; what it returned by itself, before the signal, is a failure."""
        timer = threading.Timer(AFTER, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        try:
            with self.assertRaises(KeyboardInterrupt):
                call()
                timer.cancel()  # It was too quick for the test.
        finally:
            timer.cancel()
            timer.join()

    def far_poses(self, count):
        poses = numpy.tile([0.0, 0, 0, 1, 0, 0, 0], (count, 1))
        poses[:, :3] = numpy.random.default_rng(1).uniform(-0.3, 0.3, (count, 3))
        return poses

    def test_a_batch_of_a_scene(self):
        scene = hapticell.Scene()
        torus = hapticell.Mesh.torus(0.3, 0.05)
        moved, fixed = scene.add(torus), scene.add(hapticell.Mesh.torus(0.25, 0.06))
        scene.check([moved], [fixed])
        self.interrupted(lambda: scene.distances(moved, self.far_poses(2_000_000), threads=1))

    def test_a_batch_of_a_pair(self):
        pair = hapticell.Pair(hapticell.Mesh.torus(0.3, 0.05), hapticell.Mesh.torus(0.25, 0.06))
        self.interrupted(lambda: pair.distances(self.far_poses(2_000_000)))

    def test_the_command_distance(self):
        hapticell.Mesh.torus(0.3, 0.05).save(self.folder / "a.obj")
        hapticell.Mesh.torus(0.25, 0.06).save(self.folder / "b.obj")
        poses = self.folder / "poses.csv"
        numpy.savetxt(poses, self.far_poses(200_000), delimiter=",", header="x,y,z,qw,qx,qy,qz", comments="")
        self.interrupted(lambda: hapticell.distance(moving=self.folder / "a.obj", environment=self.folder / "b.obj", poses=poses,
                                                    jobs=1))

    def test_free_solutions_of_a_robot(self):
        cell = hapticell.Workcell.open(DEMO)
        robot = cell.robot("robot")
        pose = robot.fk(numpy.array(cell["robot"].joints))
        self.interrupted(lambda: cell.free_ik("robot", numpy.tile(pose, (500_000, 1)), threads=1))

    def test_inverse_and_forward_kinematics(self):
        robot = hapticell.Robot.load(ARM)
        joints = numpy.tile([0.3, 0.2, 0.4, 0.1, 0.6, 0.2], (3_000_000, 1))
        self.interrupted(lambda: robot.ik_batch(numpy.tile(robot.fk(joints[0]), (3_000_000, 1))))
        self.interrupted(lambda: [robot.fk(joints) for _ in range(100)])

    def test_timing(self):
        t = numpy.linspace(0, 400, 8001)
        path = [about_z(0, numpy.cos(a), numpy.sin(3 * a), 0.2 * numpy.sin(7 * a)) for a in t]
        motion = hapticell.Trajectory(t, path)
        self.interrupted(lambda: motion.retimed(velocity=[0.5] * 6, acceleration=[2.0] * 6, jerk=[5.0] * 6, sample=0.0002))

    def test_the_command_feel(self):
        # M6 alone has sessions of seconds of virtual time, many times over.
        self.interrupted(lambda: hapticell.feel(full=True))

    def test_a_session(self):
        cell = hapticell.Workcell()
        cell.add("box:1,1,0.1", name="table", pose=[0, 0, -0.05, 1, 0, 0, 0])
        cell.add("box:0.06,0.06,0.06", name="part", pose=[0, 0, 0.05, 1, 0, 0, 0])
        self.interrupted(lambda: cell.session("part", lambda t, felt: ([0, 0, -0.03, 1, 0, 0, 0], 0.05 <= t < 0.15), duration=3600.0))


main()
