#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What a call from Python costs over C++, beside other packages in the same run where they are installed.

The engine's own time is that of a batch, which is one call: `Pair.distances`, `Robot.fk` of an array. A single call's time less
that is what Python costs. Peers: python-fcl and PyKDL (Debian: python3-pykdl) if they can be imported, and damped least
squares in numpy.

usage: PYTHONPATH=build/release/python bench/python/python_bench.py [ARM.urdf]
"""
import pathlib
import subprocess
import sys
import time
import xml.etree.ElementTree

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


def kdl_chain(file):
    """The joints of a URDF, which is one chain, as PyKDL has them."""
    import PyKDL

    def vector(element, name, otherwise):
        return [float(x) for x in (element.get(name, otherwise) if element is not None else otherwise).split()]

    chain = PyKDL.Chain()
    for joint in xml.etree.ElementTree.parse(file).getroot().iter("joint"):
        origin = joint.find("origin")
        at = PyKDL.Frame(PyKDL.Rotation.RPY(*vector(origin, "rpy", "0 0 0")), PyKDL.Vector(*vector(origin, "xyz", "0 0 0")))
        axis = at.M * PyKDL.Vector(*vector(joint.find("axis"), "xyz", "1 0 0"))
        chain.addSegment(PyKDL.Segment(PyKDL.Joint(joint.get("name"), at.p, axis, PyKDL.Joint.RotAxis), at))
    return chain


def kdl_kinematics(file, robot, q, poses):
    """The same poses by PyKDL, from Python; it must give the same ones."""
    import PyKDL
    chain = kdl_chain(file)
    forward, inverse = PyKDL.ChainFkSolverPos_recursive(chain), PyKDL.ChainIkSolverPos_LMA(chain)
    joints, frame, found = PyKDL.JntArray(robot.dof), PyKDL.Frame(), PyKDL.JntArray(robot.dof)

    def fk(row):
        for i, value in enumerate(row):
            joints[i] = value
        forward.JntToCart(joints, frame)
        return frame

    for row, pose in zip(q[:100], poses[:100]):
        assert max(abs(fk(row).p[i] - pose[i]) for i in range(3)) < 1e-9, "PyKDL has another arm"
    yield "pose (fk), PyKDL, one call", one_by_one(fk, list(q))
    start = PyKDL.JntArray(robot.dof)
    for i, value in enumerate(robot.rest):
        start[i] = value
    frames = [PyKDL.Frame(PyKDL.Rotation.Quaternion(*p[4:], p[3]), PyKDL.Vector(*p[:3])) for p in poses[:500]]
    reached = sum(inverse.CartToJnt(start, one, found) >= 0 for one in frames)
    yield f"ik, PyKDL's LMA, one call ({reached} of {len(frames)} found, one each)", one_by_one(
        lambda one: inverse.CartToJnt(start, one, found), frames)


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
    try:
        yield from kdl_kinematics(file, robot, q[:2000], poses)
    except ImportError:
        pass


def main():
    print(f"{'import hapticell':45} {1e3 * import_time('hapticell'):9.1f} ms")
    print(f"{'import numpy':45} {1e3 * import_time('numpy'):9.1f} ms")
    for name, seconds in [*distances(), *kinematics(sys.argv[1] if len(sys.argv) > 1 else ROOT / "examples/data/arm.urdf")]:
        print(f"{name:60} {1e6 * seconds:9.3f} us")


main()
