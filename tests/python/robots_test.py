# SPDX-License-Identifier: Apache-2.0
"""Robots: forward kinematics against a chain multiplied here, Jacobians against differences, inverse against forward."""
import pickle

from support import SOURCE, Case, hapticell, main, matrix_of, numpy

ARM = SOURCE / "examples/data/arm.urdf"


class Robots(Case):
    def setUp(self):
        super().setUp()
        self.robot = hapticell.Robot.load(ARM)
        self.random = numpy.random.default_rng(7)

    def joints(self, count=None):
        low, high = self.robot.lower, self.robot.upper
        return self.random.uniform(0.8 * low, 0.8 * high, (count, len(low)) if count else len(low))

    def test_library_robot_is_known(self):
        names = hapticell.Robot.library()
        self.assertGreater(len(names), 3)
        robot = hapticell.Robot.load("library:" + names[0])
        self.assertEqual(len(robot.joint_names), robot.dof)
        self.assertEqual(robot.rest.shape, (robot.dof,))

    def test_forward_equals_the_product_of_the_urdf(self):
        import xml.etree.ElementTree as tree
        root, q = tree.parse(ARM).getroot(), self.joints()
        child = {joint.find("child").get("link"): joint for joint in root.iter("joint")}
        values = dict(zip(self.robot.joint_names, q))

        def rotation(axis, angle):
            axis = numpy.array(axis, float) / numpy.linalg.norm(axis)
            K = numpy.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
            return numpy.eye(3) + numpy.sin(angle) * K + (1 - numpy.cos(angle)) * K @ K

        X, link = numpy.eye(4), self.robot.tip
        while link in child:
            joint = child[link]
            origin = joint.find("origin")
            numbers = lambda name: [float(v) for v in (origin.get(name) if origin is not None and origin.get(name) else "0 0 0").split()]
            roll, pitch, yaw = numbers("rpy")
            step = numpy.eye(4)
            step[:3, :3] = rotation([0, 0, 1], yaw) @ rotation([0, 1, 0], pitch) @ rotation([1, 0, 0], roll)
            step[:3, 3] = numbers("xyz")
            if joint.get("name") in values:
                turn = numpy.eye(4)
                turn[:3, :3] = rotation([float(v) for v in joint.find("axis").get("xyz").split()], values[joint.get("name")])
                step = step @ turn
            X, link = step @ X, joint.find("parent").get("link")
        self.assertClose(matrix_of(self.robot.fk(q)), X, 1e-9)

    def test_batch_of_joints_equals_one_by_one(self):
        q = self.joints(50)
        self.assertClose(self.robot.fk(q), [self.robot.fk(one) for one in q], 0)
        names = self.robot.link_names
        self.assertClose(self.robot.link_poses(q[0])[names.index(self.robot.tip)], self.robot.fk(q[0]), 1e-12)

    def test_jacobian_is_the_difference_quotient(self):
        q, step = self.joints(), 1e-6
        J = self.robot.jacobian(q)
        for i in range(self.robot.dof):
            d = numpy.zeros(self.robot.dof)
            d[i] = step
            a, b = matrix_of(self.robot.fk(q - d)), matrix_of(self.robot.fk(q + d))
            W = (b[:3, :3] - a[:3, :3]) / (2 * step) @ matrix_of(self.robot.fk(q))[:3, :3].T
            self.assertClose(J[:, i], [*(b[:3, 3] - a[:3, 3]) / (2 * step), W[2, 1], W[0, 2], W[1, 0]], 1e-6)
        self.assertGreater(self.robot.manipulability(q), 0)

    def test_every_solution_reaches_the_pose(self):
        pose = self.robot.fk(self.joints())
        solution = self.robot.ik(pose)
        self.assertTrue(solution)
        self.assertEqual(solution.status, "solved")
        found = self.robot.ik_all(pose)
        self.assertGreater(len(found), 1)
        for one in found:
            self.assertClose(matrix_of(self.robot.fk(one.joints)), matrix_of(pose), 1e-6)
        self.assertFalse(self.robot.ik([99, 0, 0, 1, 0, 0, 0]))
        self.assertEqual(self.robot.ik([99, 0, 0, 1, 0, 0, 0]).status, "unreachable")

    def test_batch_starts_each_from_the_one_before(self):
        poses = self.robot.fk(self.robot.rest + numpy.linspace(0, 0.4, 30)[:, None] * numpy.ones(self.robot.dof))
        batch = self.robot.ik_batch(poses)
        start = self.robot.rest
        for i, pose in enumerate(poses):
            one = self.robot.ik(pose, start)
            self.assertEqual(one.status, batch.status[i])
            self.assertClose(one.joints, batch.joints[i], 0)
            start = one.joints

    def test_wrong_input_is_refused(self):
        self.assertError(lambda: self.robot.fk([1, 2]), place="joints", expected="6")
        self.assertError(lambda: self.robot.fk([numpy.nan] * self.robot.dof), place="joints")
        self.assertError(lambda: hapticell.Robot.load(ARM, tip="nobody"), place="tip", found="nobody")
        error = self.assertError(lambda: hapticell.Robot.load("library:nobody"), file="library:nobody")
        again = pickle.loads(pickle.dumps(error))
        self.assertEqual((again.found, str(again)), (error.found, str(error)))


main()
