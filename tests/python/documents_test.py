# SPDX-License-Identifier: Apache-2.0
"""Runs what is documented: docstrings, the page of the manual, scripts and notebooks of examples/python."""
import contextlib
import doctest
import io
import json
import os
import re
import runpy
import shutil
import sys
import types

from support import SOURCE, Case, hapticell, main

EXAMPLES = SOURCE / "examples/python"
PAGE = SOURCE / "docs/user/python.md"


def run_notebook(path):
    """Runs the cells of code of a notebook in order, in one namespace; returns what they printed."""
    notebook = json.loads(path.read_text(encoding="utf-8"))
    assert notebook["nbformat"] == 4, path
    namespace, printed = {"__name__": "__main__"}, io.StringIO()
    with contextlib.redirect_stdout(printed):
        for number, cell in enumerate(notebook["cells"]):
            if cell["cell_type"] != "code":
                continue
            code = compile("".join(cell["source"]), f"{path.name}, cell {number}", "exec")
            exec(code, namespace)  # noqa: S102
    return printed.getvalue(), namespace


class Documents(Case):
    def setUp(self):
        super().setUp()
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        shutil.copytree(SOURCE / "config/workcells", self.folder / "config/workcells")
        shutil.copytree(SOURCE / "examples/data", self.folder / "examples/data")
        os.chdir(self.folder)

    def test_docstrings(self):
        count = 0
        for name in ("hapticell", "hapticell._errors", "hapticell._workcells"):
            result = doctest.testmod(sys.modules[name])
            self.assertEqual(result.failed, 0, name)
            count += result.attempted
        self.assertGreater(count, 5)

    def test_page_of_the_manual(self):
        """Blocks marked `python` are doctests where they begin with >>>, else scripts; one namespace for the page."""
        namespace, count = {}, 0
        runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS)
        for block in re.finditer(r"^```python\n(.*?)^```", PAGE.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL):
            count += 1
            if not block.group(1).startswith(">>>"):
                exec(compile(block.group(1), f"{PAGE.name}, block {count}", "exec"), namespace)  # noqa: S102
                continue
            test = doctest.DocTestParser().get_doctest(block.group(1), namespace, f"block {count}", str(PAGE), 0)
            runner.run(test, clear_globs=False)
            namespace.update(test.globs)
        self.assertGreater(count, 5)
        self.assertEqual(runner.summarize(verbose=False).failed, 0)

    def test_notebooks(self):
        paths = sorted(EXAMPLES.glob("*.ipynb"))
        self.assertEqual(len(paths), 4)
        for path in paths:
            with self.subTest(notebook=path.name):
                printed, namespace = run_notebook(path)
                self.assertTrue(printed)
                self.assertTrue(any(name.isidentifier() and not isinstance(value, types.ModuleType)
                                    for name, value in namespace.items()))

    def test_scripts(self):
        for path in sorted(EXAMPLES.glob("*.py")):
            with self.subTest(script=path.name), contextlib.redirect_stdout(io.StringIO()) as printed:
                runpy.run_path(str(path), run_name="__main__")
            self.assertTrue(printed.getvalue(), path.name)

    def test_every_public_class_and_method_has_a_docstring(self):
        for name in hapticell.__all__:
            self.assertTrue(getattr(hapticell, name).__doc__, name)


main()
