# SPDX-License-Identifier: Apache-2.0
"""What the tests of the Python package share."""
import math
import os
import pathlib
import sys
import tempfile
import unittest

try:
    import numpy
except ImportError:
    print("skipped: numpy is not installed")
    sys.exit(77)

import hapticell  # noqa: E402

SOURCE = pathlib.Path(os.environ["HAPTICELL_SOURCE"])
CLI = os.environ["HAPTICELL_CLI"]
DEMO = SOURCE / "config/workcells/demo.hcell"
DEMO_HAND = SOURCE / "config/workcells/demo-hand.csv"


def matrix_of(pose):
    """4 x 4 of x, y, z, qw, qx, qy, qz: by its own formula, nothing of the engine."""
    x, y, z, w, i, j, k = pose
    return numpy.array([
        [1 - 2 * (j * j + k * k), 2 * (i * j - w * k), 2 * (i * k + w * j), x],
        [2 * (i * j + w * k), 1 - 2 * (i * i + k * k), 2 * (j * k - w * i), y],
        [2 * (i * k - w * j), 2 * (j * k + w * i), 1 - 2 * (i * i + j * j), z],
        [0, 0, 0, 1]])


def about_z(angle, x=0.0, y=0.0, z=0.0):
    return [x, y, z, math.cos(angle / 2), 0, 0, math.sin(angle / 2)]


class Case(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="hapticell-test-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def assertClose(self, a, b, tolerance=1e-9):
        numpy.testing.assert_allclose(a, b, rtol=0, atol=tolerance)

    def assertError(self, call, **parts):
        with self.assertRaises(hapticell.Error) as caught:
            call()
        for name, value in parts.items():
            self.assertIn(value, getattr(caught.exception, name), name)
        return caught.exception


def main():
    unittest.main(verbosity=1)
