#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The wheel of tools/wheel, installed into a new environment, works without the build and leaves nothing behind."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["HAPTICELL_SOURCE"])
BUILD = pathlib.Path(os.environ["HAPTICELL_CLI"]).parents[1]
TRIAL = """
import pathlib, tempfile, hapticell
assert "site-packages" in hapticell.__file__, hapticell.__file__
plate, ball = hapticell.Mesh.box(0.4, 0.4, 0.02), hapticell.Mesh.sphere(0.05)
print(round(ball.distance(plate, pose=[0, 0, 0.11, 1, 0, 0, 0]).distance, 4))
print("ur5e" in hapticell.Robot.library())
# By the importer of the wheel: what it wrote is read again.
file = pathlib.Path(tempfile.mkdtemp()) / "plate.glb"
plate.save(file)
print(len(hapticell.Mesh.load(file).triangles))
"""


def run(*command, **options):
    return subprocess.run([str(one) for one in command], check=True, capture_output=True, text=True, **options).stdout


def make_wheel(folder):
    return pathlib.Path(run(SOURCE / "tools/wheel", "--build", BUILD, "--output", folder).strip())


class Wheel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        # Nothing of the build may help: no PYTHONPATH, no folder of the sources.
        cls.outside = {"env": {"PATH": "/usr/bin:/bin", "HOME": str(cls.folder)}, "cwd": cls.folder}
        cls.wheel = make_wheel(cls.folder / "one")

    def test_works_where_it_is_installed_and_goes_without_a_trace(self):
        environment = self.folder / "environment"
        run(sys.executable, "-m", "venv", "--system-site-packages", environment)
        python = environment / "bin/python"
        before = {path for path in environment.rglob("*") if path.is_file()}
        run(python, "-m", "pip", "install", "--no-index", "--no-deps", self.wheel, **self.outside)
        self.assertEqual(run(python, "-B", "-c", TRIAL, **self.outside).split(), ["0.05", "True", "12"])
        run(python, "-m", "pip", "uninstall", "-y", "hapticell", **self.outside)
        self.assertEqual({path for path in environment.rglob("*") if path.is_file()}, before)

    def test_is_the_same_file_each_time(self):
        self.assertEqual(self.wheel.read_bytes(), make_wheel(self.folder / "two").read_bytes())


if __name__ == "__main__":
    for needed in (shutil.which("patchelf"), __import__("importlib.util").util.find_spec("ensurepip")):
        if not needed:
            print("skipped: patchelf or python3-venv is not installed")
            sys.exit(77)
    unittest.main()
