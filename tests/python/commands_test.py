# SPDX-License-Identifier: Apache-2.0
"""Every command of the program, found by its own grammar, against hapticell-cli itself.

Commands with a line in CALLS are run both ways and their results compared, number by number; only times differ. Each of the
others must at least refuse an empty call by the same sentence, and have the options that its help lists.
"""
import inspect
import json
import os
import re
import subprocess

from support import CLI, SOURCE, Case, about_z, hapticell, main, numpy
from hapticell import _commands

#: Parts of a result that are times, or depend on the machine's state and on where the running program is.
TIMES = re.compile(r"driver_folders|timing|_us$|_ms$|per_second|seconds|machine_time|^time$|^date|free_mb|load|uptime|^finished|^started")
ARM = str(SOURCE / "examples/data/arm.urdf")
HAND = str(SOURCE / "config/workcells/demo-hand.csv")


def plain(value):
    """As json.loads would have it."""
    if isinstance(value, dict):
        return {key: plain(one) for key, one in value.items()}
    if isinstance(value, numpy.ndarray):
        return plain(value.tolist())
    if isinstance(value, list):
        return [plain(one) for one in value]
    return value


def without_times(value):
    if isinstance(value, dict):
        return {key: without_times(one) for key, one in value.items() if not TIMES.search(key)}
    return [without_times(one) for one in value] if isinstance(value, list) else value


def prepare(folder):
    """Files that the calls name."""
    hapticell.Mesh.box(0.1, 0.1, 0.1).save(folder / "a.obj")
    hapticell.Mesh.torus(0.3, 0.05).save(folder / "b.obj")
    poses = [about_z(0.1 * i, 0.02 * i, 0, 0.3 - 0.02 * i) for i in range(12)]
    (folder / "poses.csv").write_text("x,y,z,qw,qx,qy,qz\n" + "\n".join(",".join(map(repr, pose)) for pose in poses) + "\n")
    robot = hapticell.Robot.load(ARM)
    joints = [[0.1 * i + 0.02 * j for j in range(robot.dof)] for i in range(5)]
    (folder / "joints.csv").write_text(",".join(robot.joint_names) + "\n" + "\n".join(",".join(map(repr, row)) for row in joints) + "\n")
    (folder / "tips.csv").write_text("x,y,z,qw,qx,qy,qz\n" + "\n".join(
        ",".join(map(repr, pose)) for pose in robot.fk(numpy.array(joints)).tolist()) + "\n")
    t = numpy.linspace(0, 3, 61)
    motion = hapticell.Trajectory(t, [about_z(a, 0.2 * numpy.cos(a), 0.2 * numpy.sin(a), 0.1) for a in t], name="arc")
    motion.save(folder / "m.htraj")
    motion.transformed([0, 0, 1, 1, 0, 0, 0]).save(folder / "n.htraj")
    cell = hapticell.Workcell()
    cell.add("box:1,1,0.1", name="table", pose=[0, 0, -0.05, 1, 0, 0, 0])
    cell.add("box:0.06,0.06,0.06", name="box", pose=[0, 0, 0.05, 1, 0, 0, 0])
    cell.save(folder / "cell.hcell")
    (folder / "hand.csv").write_text("t,x,y,z,qw,qx,qy,qz,button\n" + "\n".join(
        f"{0.01 * i},0,0,{-0.0003 * max(i - 30, 0)},1,0,0,0,{int(5 <= i < 15)}" for i in range(100)) + "\n")
    (folder / "rula.json").write_text(json.dumps({"angles": {
        "upper_arm_flexion": 50, "upper_arm_abducted": True, "lower_arm_flexion": 70, "wrist_flexion": 10, "neck_flexion": 12,
        "trunk_flexion": 25, "legs_supported": True}, "muscle_use": 0, "force": 0}))
    (folder / "reba.json").write_text(json.dumps({"scores": {"neck": 1, "trunk": 3, "legs": 3, "upper_arm": 2, "lower_arm": 2, "wrist": 1},
                                                  "load": 1, "coupling": 1, "activity": 0}))
    (folder / "owas.json").write_text('{"code":"2151"}')
    (folder / "niosh.json").write_text(json.dumps({"load_kg": 12, "h_cm": 25, "v_cm": 55, "d_cm": 95, "asymmetry_deg": 0,
                                                   "frequency_per_min": 3, "duration_h": 1, "coupling": "good"}))


#: Per command: positional words, then options by Python's name. Files are those of prepare().
CALLS = {
    "convert": [(["a.obj"], {"output": "a.stl"})],
    "devices": [([], {})],
    "distance": [([], {"moving": "a.obj", "environment": ["b.obj"], "poses": "poses.csv"}),
                 ([], {"moving": "a.obj", "environment": ["b.obj"], "poses": "poses.csv", "safety_zone": 0.05, "fail_on_contact": True})],
    "ergonomics rula": [([], {"input": "rula.json"})],
    "ergonomics reba": [([], {"input": "reba.json"})],
    "ergonomics owas": [([], {"input": "owas.json"})],
    "ergonomics niosh": [([], {"input": "niosh.json"})],
    "feel": [([], {"only": "M9"})],
    "fk": [([], {"robot": ARM, "joints": "joints.csv"})],
    "ik": [([], {"robot": ARM, "poses": "tips.csv", "all": True, "start": "0,0,0,0,0,0"})],
    "inspect": [(["a.obj"], {}), (["cell.hcell"], {}), ([ARM], {})],
    "library": [([], {})],
    "mannequin": [([], {"sex": "male", "percentile": 50, "measure": True}), ([], {"sex": "female", "stature": 1.6})],
    "session": [([], {"workcell": "cell.hcell", "entity": "box", "hand": "hand.csv", "set": ["scale=fine"]})],
    "trajectory info": [(["m.htraj"], {})],
    "trajectory simplify": [(["m.htraj"], {"output": "s.htraj"})],
    "trajectory smooth": [(["m.htraj"], {"output": "s.htraj"})],
    "trajectory resample": [(["m.htraj"], {"output": "s.htraj", "step": 0.1})],
    "trajectory trim": [(["m.htraj"], {"output": "s.htraj", "from_": 0.5, "to": 2.0})],
    "trajectory reverse": [(["m.htraj"], {"output": "s.htraj"})],
    "trajectory join": [(["m.htraj"], {"output": "s.htraj", "with_": ["n.htraj"]})],
    "trajectory mirror": [(["m.htraj"], {"output": "s.htraj", "plane": "y", "offset": -0.1})],
    "trajectory export": [(["m.htraj"], {"to": "urscript", "output": "s.script"})],
    "workcell new": [(["w.hcell"], {"add": ["box:1,1,1,name=a", "box:1,1,1,name=b,pose=3,0,0,1,0,0,0"], "check": ["a:b"]})],
}


def command_line(command, positional, options):
    """The words of a shell for the same call, made apart from the package's own conversion."""
    names = {_commands.python_name(option["name"]): option for option in command._options}
    words = [*command._path, *positional]
    for name, value in options.items():
        option = names[name]
        if value is True:
            words.append(option["name"])
        elif isinstance(value, list) and option["repeated"]:
            for one in value:
                words += [option["name"], str(one)]
        elif isinstance(value, list):
            words += [option["name"], *map(str, value)]
        else:
            words.append(f"{option['name']}={value}")
    return words


class Commands(Case):
    def setUp(self):
        super().setUp()
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(self.folder)
        prepare(self.folder)
        self.commands = {" ".join(command._path): command for command in _commands.runnable()}

    def run_program(self, words):
        return subprocess.run([CLI, *words], capture_output=True, text=True, check=False, stdin=subprocess.DEVNULL)

    def test_results_are_those_of_the_program(self):
        for name, calls in CALLS.items():
            command = self.commands[name]
            for positional, options in calls:
                with self.subTest(command=name, options=options):
                    told = self.run_program([*command_line(command, positional, options), "--json=-"])
                    self.assertIn(told.returncode, (0, 1), told.stderr)
                    made = {path.name: path.read_bytes() for path in self.folder.iterdir() if path.name[0] in "sw"}
                    result = command(*positional, **options)
                    self.assertEqual(without_times(plain(result)), without_times(json.loads(told.stdout)))
                    self.assertEqual(result.exit_status if hasattr(result, "exit_status") else 0, told.returncode)
                    for path, content in made.items():
                        self.assertEqual((self.folder / path).read_bytes(), content, path)

    def test_every_command_has_its_call_with_every_option(self):
        self.assertGreater(len(self.commands), 25)
        for name, command in self.commands.items():
            with self.subTest(command=name):
                here = hapticell
                for word in command._path:
                    here = getattr(here, _commands.python_name(word))
                self.assertEqual(here.__doc__, command.__doc__)
                told = self.run_program([*command._path, "--help"]).stdout
                options = set(re.findall(r"^  (?:-\w,)?(--[\w-]+)", told, re.MULTILINE)) - {"--help", "--json", "--version"}
                self.assertTrue(options <= {option["name"] for option in command._options}, options)
                for option in command._options:
                    self.assertIn(_commands.python_name(option["name"]), inspect.signature(here).parameters)

    def test_what_is_missing_is_refused_by_the_same_sentence(self):
        for name, command in self.commands.items():
            required = [option for option in command._options if option["required"]]
            if not required or name == "pair":
                continue
            with self.subTest(command=name):
                told = self.run_program(command._path)
                self.assertEqual(told.returncode, 2)
                with self.assertRaises(hapticell.Error) as caught:
                    hapticell._engine.run_command([*command._path, "--json=-"])
                self.assertIn(str(caught.exception).splitlines()[0], told.stderr)
                with self.assertRaises(TypeError):
                    command()

    def test_errors_have_their_parts(self):
        error = self.assertError(lambda: hapticell.inspect("none.stl"), file="none.stl")
        self.assertIn(str(error), self.run_program(["inspect", "none.stl"]).stderr)
        self.assertError(lambda: hapticell.distance(moving="a.obj", environment=["b.obj"], poses=numpy.ones((2, 5))), place="--poses")
        with self.assertRaises(TypeError):
            hapticell.trajectory()
        with self.assertRaises(TypeError):
            hapticell.inspect("a.obj", colour="red")

    def test_arrays_and_objects_stand_for_files(self):
        poses = numpy.genfromtxt("poses.csv", delimiter=",", skip_header=1)
        from_file = hapticell.distance(moving="a.obj", environment=["b.obj"], poses="poses.csv")
        from_array = hapticell.distance(moving="a.obj", environment="b.obj", poses=poses)
        self.assertTrue((from_file.results["distance"] == from_array.results["distance"]).all())
        self.assertEqual(from_file.results["point_on_moving"].shape, (12, 3))
        table = numpy.genfromtxt("joints.csv", delimiter=",", names=True)
        columns = {name: table[name] for name in table.dtype.names}
        self.assertEqual(plain(hapticell.fk(robot=ARM, joints=columns).poses), plain(hapticell.fk(robot=ARM, joints="joints.csv").poses))
        cell, motion = hapticell.Workcell.open("cell.hcell"), hapticell.Trajectory.load("m.htraj")
        self.assertEqual(plain(hapticell.inspect(cell).entities), plain(hapticell.inspect("cell.hcell").entities))
        self.assertEqual(hapticell.trajectory.info(motion).duration, hapticell.trajectory.info("m.htraj").duration)

    def test_nothing_is_printed(self):
        words = "import hapticell; hapticell.inspect('a.obj'); hapticell.feel(only='M9')"
        done = subprocess.run([os.sys.executable, "-W", "ignore", "-c", words], capture_output=True, text=True, check=True)
        self.assertEqual((done.stdout, done.stderr), ("", ""))


class Interrupts(Case):
    def test_ctrl_c_ends_a_command(self):
        words = ("import hapticell, _thread, threading\n"
                 "threading.Timer(0.5, _thread.interrupt_main).start()\n"
                 "try:\n    hapticell.feel(full=True)\nexcept KeyboardInterrupt:\n    print('interrupted')")
        done = subprocess.run([os.sys.executable, "-c", words], capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout, "interrupted\n", done.stderr)

    def test_progress_is_told(self):
        heard = []
        hapticell.feel(only="M9", progress=lambda share, stage: heard.append(stage))
        self.assertTrue(heard)


main()
