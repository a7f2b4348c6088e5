# SPDX-License-Identifier: Apache-2.0
"""The stubs say what is there: every public name, each method with its arguments. mypy reads them where it is installed."""
import ast
import inspect
import pathlib
import shutil
import subprocess

from support import SOURCE, Case, hapticell, main


def names_of(body):
    for node in body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            yield node.name
        elif isinstance(node, ast.AnnAssign):
            yield node.target.id
        elif isinstance(node, ast.ImportFrom):
            yield from (one.asname or one.name for one in node.names)


class Stubs(Case):
    def setUp(self):
        super().setUp()
        self.package = pathlib.Path(hapticell.__file__).parent
        self.trees = {name: ast.parse((self.package / name).read_text()) for name in ("__init__.pyi", "_engine.pyi")}

    def test_every_public_name_is_there(self):
        self.assertEqual(set(hapticell.__all__) - set(names_of(self.trees["__init__.pyi"].body)), set())
        self.assertTrue((self.package / "py.typed").exists())

    def test_every_method_is_there_and_documented(self):
        classes = {node.name: node for node in self.trees["_engine.pyi"].body if isinstance(node, ast.ClassDef)}
        for name, cls in vars(hapticell._engine).items():
            if not inspect.isclass(cls):
                continue
            there = set(names_of(classes[name].body))
            self.assertTrue(cls.__doc__, name)
            for member in vars(cls):
                if not member.startswith("_"):
                    self.assertIn(member, there, name)

    def test_no_type_of_cpp_is_left(self):
        text = (self.package / "_engine.pyi").read_text()
        self.assertNotIn("::", text)
        self.assertNotIn("pybind11", text)

    def test_mypy_accepts_the_examples(self):
        mypy = shutil.which("mypy")
        if mypy is None:
            self.skipTest("mypy is not installed")
        files = sorted((SOURCE / "examples/python").glob("*.py"))
        done = subprocess.run([mypy, "--ignore-missing-imports", "--no-error-summary", *files], capture_output=True, text=True,
                              check=False, env={"MYPYPATH": str(self.package.parent), "PATH": "/usr/bin:/bin"}, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


main()
