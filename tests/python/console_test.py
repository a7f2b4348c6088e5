# SPDX-License-Identifier: Apache-2.0
"""The interpreter behind the window's console, spoken to as the window does."""
import json
import os
import signal
import subprocess
import sys
import time

from support import DEMO, Case, hapticell, main


class Interpreter:
    def __init__(self, case):
        self.process = subprocess.Popen([sys.executable, "-P", "-m", "hapticell._console"], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        case.addCleanup(self.close)
        self.number = 0
        self.case = case
        case.assertEqual(self.hear()["say"], "ready")

    def close(self):
        self.process.kill()
        self.process.communicate()

    def hear(self):
        return json.loads(self.process.stdout.readline())

    def say(self, **message):
        self.number += 1
        self.process.stdin.write(json.dumps({"id": self.number, **message}) + "\n")
        self.process.stdin.flush()

    def until(self, *kinds):
        """(the first message of these kinds, what was printed before, errors before)"""
        printed = {"out": "", "err": ""}
        while True:
            message = self.hear()
            if message["say"] in kinds:
                return message, printed["out"], printed["err"]
            if message["say"] in printed:
                printed[message["say"]] += message["text"]

    def run(self, source, **more):
        self.say(do="run", source=source, **more)
        return self.until("done", "more")


class Console(Case):
    def setUp(self):
        super().setUp()
        self.interpreter = Interpreter(self)

    def test_expressions_are_shown_and_names_stay(self):
        self.assertEqual(self.interpreter.run("x = 6 * 7")[1], "")
        self.assertEqual(self.interpreter.run("x")[1], "42\n")
        self.assertEqual(self.interpreter.run("a = 1\nb = 2\na + b")[1], "3\n")
        self.assertEqual(self.interpreter.run("_ + 1")[1], "4\n")

    def test_a_block_is_complete_after_an_empty_line(self):
        self.assertEqual(self.interpreter.run("for i in range(2):")[0]["say"], "more")
        self.assertEqual(self.interpreter.run("for i in range(2):\n    print(i)")[0]["say"], "more")
        self.assertEqual(self.interpreter.run("for i in range(2):\n    print(i)\n")[1], "0\n1\n")

    def test_errors_have_a_traceback_of_the_users_own_lines(self):
        _, out, err = self.interpreter.run("def half(x):\n    return x / 0\n\nhalf(1)")
        self.assertEqual(out, "")
        self.assertIn("return x / 0", err)
        self.assertIn("ZeroDivisionError", err)
        self.assertNotIn("_console.py", err)
        self.assertIn("SyntaxError", self.interpreter.run("1 +* 2")[2])

    def test_the_cell_comes_and_goes_as_text(self):
        cell = hapticell.Workcell.open(DEMO)
        text = cell._document_text(str(DEMO.parent))
        given = {"text": text, "folder": str(DEMO.parent), "path": str(DEMO)}
        name = cell.names[0]
        done, out, _ = self.interpreter.run("cell.names[0], cell.path, selection", cell=given, selection=[name])
        self.assertEqual(out, f"{(name, str(DEMO), [name])}\n")
        self.assertIsNone(done["cell"])  # Nothing was changed.
        done, _, err = self.interpreter.run(f"cell.set({name!r}, color=[1, 0, 0])")
        self.assertEqual(err, "")
        other = hapticell.Workcell()
        other._take_document(done["cell"]["text"], str(DEMO.parent), str(DEMO))
        self.assertEqual(other[name].color, [1, 0, 0])
        self.assertEqual(other.names, cell.names)
        # It is this cell from now on: the next statement changes nothing.
        self.assertIsNone(self.interpreter.run(f"cell[{name!r}].color")[0]["cell"])
        self.assertIn("cell of the window again", self.interpreter.run("cell = 5")[2] + self.interpreter.run("1")[2])

    def test_known_shapes_are_not_read_again(self):
        part = self.folder / "part.obj"
        hapticell.Mesh.box(0.1, 0.1, 0.1).save(part)
        cell = hapticell.Workcell()
        cell.add(part, name="part")
        text = cell._document_text(str(self.folder))
        part.unlink()
        cell._take_document(text.replace('"locked": false', '"locked": true'), str(self.folder), "")
        self.assertTrue(cell["part"].locked)
        cell.set("part", locked=False)
        cell.add("box:1,1,1", name="block", pose=[1, 0, 0, 1, 0, 0, 0])
        self.assertAlmostEqual(float(cell.distances("part")["distance"][0]), 0.45, 9)  # Its shape is there.

    def test_ctrl_c_ends_what_runs_and_nothing_else(self):
        self.interpreter.process.send_signal(signal.SIGINT)  # Nothing runs: nothing happens.
        self.interpreter.run("kept = 1")
        self.interpreter.say(do="run", source="print('on')\nwhile True: pass")
        self.assertEqual(self.interpreter.until("out")[0]["text"], "on\n")
        time.sleep(0.2)
        self.interpreter.process.send_signal(signal.SIGINT)
        self.assertIn("KeyboardInterrupt", self.interpreter.until("done")[2])
        self.assertEqual(self.interpreter.run("kept")[1], "1\n")

    def test_endless_printing_can_be_interrupted(self):
        self.interpreter.say(do="run", source="while True: print('x' * 1000)\n")
        for _ in range(20):
            self.interpreter.hear()
        self.interpreter.process.send_signal(signal.SIGINT)
        self.assertIn("KeyboardInterrupt", self.interpreter.until("done")[2])

    def test_a_script_has_the_cell_and_names_of_its_own(self):
        script = self.folder / "two.py"
        script.write_text("import sys\nfor x in range(2):\n    cell.add('box:1,1,1', name=f'box {x}')\nprint(__name__)\nsys.exit(3)\n")
        self.interpreter.say(do="script", file=str(script))
        done, out, err = self.interpreter.until("done")
        self.assertEqual((out, err), ("__main__\n", "exit status 3\n"))
        self.assertIn('"box 1"', done["cell"]["text"])
        self.assertIn("NameError", self.interpreter.run("x")[2])

    def test_others_output_and_input_do_not_disturb_the_line(self):
        self.interpreter.run("import os, subprocess; _ = os.write(1, b'raw'); _ = subprocess.run(['echo', 'child'])")
        self.assertIn("EOFError", self.interpreter.run("input()")[2])
        self.assertEqual(self.interpreter.run("1 + 1")[1], "2\n")

    def test_an_end_of_the_process_is_an_end_of_the_process(self):
        self.interpreter.say(do="run", source="import os; os._exit(1)")
        self.assertEqual(self.interpreter.process.wait(), 1)

    def test_completion(self):
        self.interpreter.run("cell.add('box:1,1,1', name='Fixture A')")
        self.interpreter.say(do="complete", text="y = cell.set_j")
        words, _, _ = self.interpreter.until("words")
        self.assertEqual((words["start"], words["words"]), (4, ["cell.set_joints("]))
        self.interpreter.say(do="complete", text="cell['Fix")
        words, _, _ = self.interpreter.until("words")
        self.assertEqual((words["start"], words["words"]), (6, ["Fixture A"]))


main()
