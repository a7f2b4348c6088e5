# SPDX-License-Identifier: Apache-2.0
"""Meshes, pairs and scenes: against distances of spheres and boxes, which everybody can compute."""
import _thread
import gc
import threading
import time

from support import Case, about_z, hapticell, main, matrix_of, numpy


def cube(size=1.0):
    """Twelve triangles by hand."""
    v = numpy.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float) * size
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return v, numpy.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])


class Meshes(Case):
    def test_arrays_go_in_and_are_seen_again_without_a_copy(self):
        vertices, triangles = cube()
        mesh = hapticell.Mesh(vertices, triangles)
        self.assertClose(mesh.vertices, vertices)
        self.assertTrue((mesh.triangles == triangles).all())
        self.assertTrue(mesh.closed)
        self.assertAlmostEqual(mesh.volume, 1.0)
        self.assertClose(mesh.bounds, [[0, 0, 0], [1, 1, 1]])
        a, b = mesh.vertices, mesh.vertices
        self.assertEqual(a.ctypes.data, b.ctypes.data)
        with self.assertRaises(ValueError):
            a[0, 0] = 2.0
        del mesh
        gc.collect()
        self.assertClose(a, vertices)  # The view keeps its mesh.

    def test_wrong_arrays_are_refused_with_what_was_expected(self):
        vertices, triangles = cube()
        self.assertError(lambda: hapticell.Mesh(vertices, triangles + 1), place="triangles", found="8")
        self.assertError(lambda: hapticell.Mesh(vertices[:, :2], triangles), expected="(n, 3)")
        vertices[0, 0] = numpy.nan
        self.assertError(lambda: hapticell.Mesh(vertices, triangles), place="vertices")
        self.assertError(lambda: hapticell.Mesh.box(0, 1, 1), place="x")
        self.assertError(lambda: hapticell.Mesh.load("/nowhere.stl"), file="/nowhere.stl")

    def test_distance_of_boxes_is_the_gap(self):
        a, b = hapticell.Mesh.box(1, 1, 1), hapticell.Mesh.box(2, 1, 1)
        found = a.distance(b, pose=[0, 0, 0, 1, 0, 0, 0], other_pose=[2, 0, 0, 1, 0, 0, 0])
        self.assertAlmostEqual(found.distance, 0.5)
        self.assertAlmostEqual(float(found), 0.5)
        self.assertClose(found.normal, [-1, 0, 0])
        self.assertClose(found.point_b - found.point_a, [0.5, 0, 0])
        self.assertFalse(found.colliding)
        self.assertTrue(a.distance(b).colliding)
        small = hapticell.Mesh.box(0.1, 0.1, 0.1)
        self.assertTrue(small.distance(a).contained)
        self.assertEqual(small.contact_regions(a, 0.01, pose=[0, 0, 0.555, 1, 0, 0, 0]), 1)
        self.assertTrue(a.contains([0.4, 0.4, 0.4]))
        self.assertFalse(a.contains([0.6, 0, 0]))

    def test_poses_may_be_matrices_and_must_be_rigid(self):
        a, b = hapticell.Mesh.box(1, 0.2, 0.2), hapticell.Mesh.box(0.2, 0.2, 0.2)
        seven = about_z(0.7, 0.1, 0.9, 0.05)
        self.assertAlmostEqual(a.distance(b, seven).distance, a.distance(b, matrix_of(seven)).distance, 12)
        self.assertError(lambda: a.distance(b, [0, 0, 0, 2, 0, 0, 0]), place="pose", found="length 2")
        self.assertError(lambda: a.distance(b, [numpy.nan, 0, 0, 1, 0, 0, 0]), place="pose")
        self.assertError(lambda: a.distance(b, 2 * numpy.eye(4)), found="not a rigid pose")
        self.assertError(lambda: a.distance(b, [1, 2, 3]), found="(3)")
        self.assertError(lambda: a.distance(b, "here"), place="pose")

    def test_saved_mesh_comes_back(self):
        mesh = hapticell.Mesh.torus(0.2, 0.05)
        mesh.save(self.folder / "torus.ply")
        again = hapticell.Mesh.load(self.folder / "torus.ply")
        self.assertEqual(len(again.triangles), len(mesh.triangles))
        self.assertAlmostEqual(again.volume, mesh.volume, 6)

    def test_pair_agrees_with_single_queries(self):
        a, b = hapticell.Mesh.torus(0.2, 0.05), hapticell.Mesh.sphere(0.03)
        pair = hapticell.Pair(b, a)
        poses = numpy.array([about_z(0.01 * i, 0.2, 0.001 * i, 0.1) for i in range(200)])
        rows = pair.distances(poses)
        for pose, row in zip(poses[::17], rows[::17]):
            self.assertAlmostEqual(row["distance"], b.distance(a, pose).distance, 9)
            self.assertAlmostEqual(numpy.linalg.norm(row["point_a"] - row["point_b"]), row["distance"], 9)
        self.assertTrue(pair.within(1.0))
        self.assertFalse(pair.collides())


class Scenes(Case):
    def setUp(self):
        super().setUp()
        self.scene = hapticell.Scene()
        self.ball = self.scene.add(hapticell.Mesh.sphere(0.1, 96), [0, 0, 1, 1, 0, 0, 0])
        self.plate = self.scene.add(hapticell.Mesh.box(2, 2, 0.002))
        self.post = self.scene.add(hapticell.Mesh.box(0.1, 0.1, 3), [0.9, 0, 0, 1, 0, 0, 0])
        self.scene.check([self.ball], [self.plate, self.post])

    def test_nearest_is_the_nearest(self):
        found = self.scene.nearest()
        self.assertEqual((found.part, found.other), (self.ball, self.post))
        self.assertAlmostEqual(float(found), 0.75, 3)
        self.assertIsNone(self.scene.nearest(limit=0.5))
        self.assertEqual([one.other for one in self.scene.contacts(1.0)], [self.post, self.plate])
        self.assertAlmostEqual(float(self.scene.distance(self.ball, self.plate)), 0.899, 6)
        self.assertFalse(self.scene.collides())
        self.assertEqual(len(self.scene), 3)

    def test_sweep_stops_at_a_thin_plate(self):
        swept = self.scene.sweep(self.ball, [0, 0, -1, 1, 0, 0, 0], clearance=0.01)
        self.assertTrue(swept.stopped)
        self.assertEqual(swept.nearest.other, self.plate)
        self.assertAlmostEqual(swept.pose[2], 0.001 + 0.01 + 0.1, 4)
        self.assertAlmostEqual(self.scene.pose(self.ball)[2], 1.0)  # It did not move.
        self.assertFalse(self.scene.sweep(self.ball, [0, 0, 0.5, 1, 0, 0, 0]).stopped)

    def test_batch_equals_one_by_one(self):
        poses = numpy.tile([0.0, 0, 1, 1, 0, 0, 0], (500, 1))
        poses[:, 0] = numpy.linspace(-0.9, 0.7, 500)
        poses[:, 2] = numpy.linspace(0.05, 0.4, 500)
        rows = self.scene.distances(self.ball, poses)
        again = self.scene.distances(self.ball, poses, threads=1)
        self.assertTrue((rows == again).all())
        for pose, row in list(zip(poses, rows))[::49]:
            self.scene.move(self.ball, pose)
            found = self.scene.nearest()
            self.assertAlmostEqual(row["distance"], float(found), 9)
            self.assertEqual(row["other"], found.other)
        self.assertTrue((self.scene.distances(self.ball, poses, limit=1e-3)["other"] == -1).any())

    def test_parts_that_are_not_there_are_refused(self):
        self.scene.remove(self.post)
        self.assertEqual(self.scene.nearest().other, self.plate)
        self.assertError(lambda: self.scene.pose(self.post), place="part")
        self.assertError(lambda: self.scene.distance(self.plate, self.ball + 99), place="part")

    def test_other_threads_go_on_during_a_batch(self):
        poses = numpy.tile([0.0, 0, 0.2, 1, 0, 0, 0], (40000, 1))
        poses[:, 0] = numpy.linspace(-0.5, 0.5, len(poses))
        count, done = [0], threading.Event()

        def work():
            while not done.is_set():
                count[0] += 1
                time.sleep(0)

        thread = threading.Thread(target=work)
        thread.start()
        before = count[0]
        hapticell.Pair(hapticell.Mesh.sphere(0.1, 200), hapticell.Mesh.torus(0.5, 0.05)).distances(poses)
        went_on = count[0] - before
        done.set()
        thread.join()
        self.assertGreater(went_on, 10)

    def test_interrupt_ends_a_batch(self):
        pair = hapticell.Pair(hapticell.Mesh.sphere(0.1, 200), hapticell.Mesh.torus(0.5, 0.05))
        poses = numpy.tile([0.0, 0, 0.2, 1, 0, 0, 0], (3_000_000, 1))
        poses[:, 0] = numpy.linspace(-0.5, 0.5, len(poses))
        timer = threading.Timer(0.2, _thread.interrupt_main)
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            pair.distances(poses)
        timer.join()


main()
