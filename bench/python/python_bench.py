#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What a call from Python costs over C++, beside other packages in the same run where they are installed.

The engine's own time is that of a batch, which is one call: `Pair.distances`, `Robot.fk` of an array. A single call's time less
that is what Python costs. Peers: python-fcl and trimesh if they can be imported, and damped least squares in numpy.

usage: PYTHONPATH=build/release/python bench/python/python_bench.py [ARM.urdf]
"""
import pathlib
import subprocess
import sys
import time

import numpy

import hapticell

ROOT = pathlib.Path(__file__).resolve().parents[2]
COUNT = 5000


def best(call, clock=time.thread_time, rounds=15):
    """Seconds of the quickest of several rounds: what else runs only makes it slower. Of this thread's processor time."""
    times = []
    for _ in range(rounds):
        begin = clock()
        call()
        times.append(clock() - begin)
    return min(times)


def one_by_one(function, rows):
    def call():
        for row in rows:
            function(row)
    return best(call) / len(rows)


def import_time(module):
    words = f"import time; b = time.process_time(); import {module}; print(time.process_time() - b)"
    told = (subprocess.run([sys.executable, "-c", words], capture_output=True, text=True, check=True) for _ in range(15))
    return min(float(one.stdout) for one in told)


def distances():
    torus, ball = hapticell.Mesh.torus(0.3, 0.08), hapticell.Mesh.sphere(0.05)
    s = numpy.linspace(0, 2 * numpy.pi, COUNT)
    zero, one = numpy.zeros_like(s), numpy.ones_like(s)
    poses = numpy.stack([0.5 * numpy.cos(s), 0.5 * numpy.sin(s), 0.1 + zero, one, zero, zero, zero], axis=1)
    poses = numpy.ascontiguousarray(poses)  # A pose that is not contiguous is copied: 1.4 us more.
    rows = list(poses)
    pair = hapticell.Pair(ball, torus)
    batch = best(lambda: pair.distances(poses)) / COUNT
    single = one_by_one(pair.distance, rows)
    yield "distance, engine (batch of one pair)", batch
    yield "distance, one call", single
    # By a pair of boxes, whose query is so short that the difference is not lost in its noise.
    boxes = hapticell.Pair(hapticell.Mesh.box(0.1, 0.1, 0.1), hapticell.Mesh.box(0.1, 0.1, 0.1))
    yield "distance, Python's part", one_by_one(boxes.distance, rows) - best(lambda: boxes.distances(poses)) / COUNT
    scene = hapticell.Scene()
    moved, fixed = scene.add(ball), scene.add(torus)
    scene.check([moved], [fixed])
    yield "distance, scene's batch on all cores", best(lambda: scene.distances(moved, poses), time.perf_counter) / COUNT
    try:
        import fcl
    except ImportError:
        return
    models = []
    for mesh in (ball, torus):
        model = fcl.BVHModel()
        model.beginModel(len(mesh.vertices), len(mesh.triangles))
        model.addSubModel(mesh.vertices, mesh.triangles)
        model.endModel()
        models.append(fcl.CollisionObject(model, fcl.Transform()))

    def peer(row):
        models[0].setTransform(fcl.Transform(row[3:], row[:3]))
        fcl.distance(*models, fcl.DistanceRequest(), fcl.DistanceResult())
    yield "distance, python-fcl, one call", one_by_one(peer, rows[::20])


def numeric_ik(robot, pose, q):
    """Damped least squares as scripts have it: with the engine's own forward kinematics and Jacobian."""
    for _ in range(60):
        at = robot.fk(q)
        w, v = at[3], at[4:]
        dot = w * pose[3] + v @ pose[4:]
        turn = 2 * numpy.sign(dot) * (w * pose[4:] - pose[3] * v - numpy.cross(pose[4:], v))
        error = numpy.concatenate([pose[:3] - at[:3], turn])
        if error @ error < 1e-12:
            break
        J = robot.jacobian(q)
        q = q + J.T @ numpy.linalg.solve(J @ J.T + 1e-6 * numpy.eye(6), error)
    return q


def kinematics(file):
    robot = hapticell.Robot.load(file)
    random = numpy.random.default_rng(1)
    q = robot.rest + random.uniform(-0.5, 0.5, (COUNT, robot.dof))
    batch, single = best(lambda: robot.fk(q)) / COUNT, one_by_one(robot.fk, list(q))
    yield "pose (fk), engine (batch)", batch
    yield "pose (fk), one call", single
    yield "pose (fk), Python's part", single - batch
    yield "Jacobian, one call", one_by_one(robot.jacobian, list(q))
    poses = robot.fk(q[:2000])
    yield f"ik ({robot.inverse_model}), engine (batch)", best(lambda: robot.ik_batch(poses)) / len(poses)
    yield "ik, one call", one_by_one(robot.ik, list(poses))
    yield "ik, numpy's damped least squares", one_by_one(lambda pose: numeric_ik(robot, pose, robot.rest), list(poses[:100]))


def main():
    print(f"{'import hapticell':45} {1e3 * import_time('hapticell'):9.1f} ms")
    print(f"{'import numpy':45} {1e3 * import_time('numpy'):9.1f} ms")
    for name, seconds in [*distances(), *kinematics(sys.argv[1] if len(sys.argv) > 1 else ROOT / "examples/data/arm.urdf")]:
        print(f"{name:45} {1e6 * seconds:9.3f} us")


main()
