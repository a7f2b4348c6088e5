# SPDX-License-Identifier: Apache-2.0
"""The add-on's InitGui.py in FreeCAD's own program without a window: its workbench registers, and its commands do what they say
with a Gui and dialogs that only keep what they are given. Skipped (77) where freecadcmd is not installed.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

SCRIPT = r'''
import os, sys, traceback, types
status = 1
try:
    import FreeCAD, Part
    source, folder = os.environ["HAPTICELL_SOURCE"], os.environ["HAPTICELL_FOLDER"]
    commands, workbenches, shown = {}, [], {}
    gui = types.ModuleType("FreeCADGui")
    class Workbench:
        def appendMenu(self, name, entries): shown["menu"] = (name, entries)
        def appendToolbar(self, name, entries): shown["bar"] = (name, entries)
    gui.Workbench = Workbench
    gui.addCommand = commands.__setitem__
    gui.addWorkbench = workbenches.append
    sys.modules["FreeCADGui"] = gui
    file = os.path.join(folder, "assembly.hcell")
    widgets = types.ModuleType("PySide2.QtWidgets")
    class QFileDialog:
        getSaveFileName = staticmethod(lambda *given: (file, ""))
        getOpenFileName = staticmethod(lambda *given: (file, ""))
    widgets.QFileDialog = QFileDialog
    side = types.ModuleType("PySide2")
    side.QtWidgets = widgets
    sys.modules["PySide2"], sys.modules["PySide2.QtWidgets"] = side, widgets
    place = os.path.join(source, "python", "freecad")
    sys.path.insert(0, place)
    for name in ("Init.py", "InitGui.py"):  # As FreeCAD runs them: as text, in names of their own.
        with open(os.path.join(place, name)) as text:
            exec(compile(text.read(), os.path.join(place, name), "exec"), {"__name__": "__main__"})
    bench, = workbenches
    assert bench.GetClassName() == "Gui::PythonWorkbench"
    bench.Initialize()
    names = ["HaptiCell_Send", "HaptiCell_TakeBack", "HaptiCell_StopAtContact"]
    assert sorted(commands) == sorted(names), commands
    assert shown["menu"] == ("HaptiCell", names) and shown["bar"] == ("HaptiCell", names), shown
    for command in commands.values():
        words = command.GetResources()
        assert words["MenuText"] and words["ToolTip"]
        assert not command.IsActive()  # No document is open.
    document = FreeCAD.newDocument()
    plate = document.addObject("Part::Box", "Plate")
    plate.Length, plate.Width, plate.Height = 200, 200, 20
    peg = document.addObject("Part::Box", "Peg")
    peg.Length, peg.Width, peg.Height = 20, 20, 50
    peg.Placement.Base = FreeCAD.Vector(50, 50, 100)
    document.recompute()
    assert all(command.IsActive() for command in commands.values())
    import hapticell, hapticell_bridge
    opened = []
    hapticell_bridge.open_window = opened.append
    commands["HaptiCell_Send"].Activated()
    assert opened == [file], opened
    cell = hapticell.Workcell.open(file)
    assert sorted(cell.names) == ["Peg", "Plate"], cell.names
    cell.move("Peg", [0.05, 0.05, 0.3, 1, 0, 0, 0])
    cell.save()
    commands["HaptiCell_TakeBack"].Activated()
    assert abs(peg.Placement.Base.z - 300) < 1e-6, peg.Placement
    # The switch: on, a move stops on the plate; off, it does not.
    commands["HaptiCell_StopAtContact"].Activated(1)
    peg.Placement = FreeCAD.Placement(FreeCAD.Vector(50, 50, -100), FreeCAD.Rotation())
    assert abs(peg.Placement.Base.z - 20) < 0.1, peg.Placement
    commands["HaptiCell_StopAtContact"].Activated(0)
    peg.Placement = FreeCAD.Placement(FreeCAD.Vector(50, 50, -100), FreeCAD.Rotation())
    assert abs(peg.Placement.Base.z + 100) < 1e-6, peg.Placement
    status = 0
    print("WORKBENCH DONE")
except BaseException:
    traceback.print_exc()
sys.stdout.flush()
os._exit(status)
'''


def main():
    program = shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
    if program is None:
        print("skipped: freecadcmd is not installed")
        return 77
    with tempfile.TemporaryDirectory(prefix="hapticell-test-") as folder:
        script = pathlib.Path(folder, "workbench.py")
        script.write_text(SCRIPT)
        own = {name: folder for name in ("HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME")}
        run = subprocess.run([program, str(script)], env={**os.environ, **own, "HAPTICELL_FOLDER": folder}, text=True,
                             stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if run.returncode == 0 and "WORKBENCH DONE" in run.stdout:
        return 0
    print(run.stdout)
    return 1


sys.exit(main())
