# SPDX-License-Identifier: Apache-2.0
"""The add-on for FreeCAD in FreeCAD's own Python, without a window. Skipped (77) where FreeCAD is not installed."""
import importlib.util
import pathlib
import sys

for folder in ("/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib"):
    if pathlib.Path(folder).is_dir() and folder not in sys.path:
        sys.path.append(folder)
if importlib.util.find_spec("FreeCAD") is None:
    print("skipped: FreeCAD is not installed")
    sys.exit(77)

import FreeCAD  # noqa: E402

from support import SOURCE, Case, hapticell, main  # noqa: E402

sys.path.insert(0, str(SOURCE / "python/freecad"))
import hapticell_bridge as bridge  # noqa: E402


class Bridge(Case):
    def setUp(self):
        super().setUp()
        self.document = FreeCAD.newDocument()
        self.addCleanup(lambda: FreeCAD.closeDocument(self.document.Name))
        self.peg = self.document.addObject("Part::Cylinder", "Peg")
        self.peg.Radius, self.peg.Height = 10, 50
        self.peg.Placement.Base = FreeCAD.Vector(0, 0, 100)
        plate = self.document.addObject("Part::Box", "Plate")
        plate.Length, plate.Width, plate.Height = 200, 200, 20
        hole = self.document.addObject("Part::Cylinder", "Hole")
        hole.Radius, hole.Height = 11, 60
        hole.Placement.Base = FreeCAD.Vector(100, 100, -20)
        self.base = self.document.addObject("Part::Cut", "Base")
        self.base.Base, self.base.Tool = plate, hole
        self.base.Placement.Base = FreeCAD.Vector(-100, -100, 0)
        self.document.recompute()

    def test_placements_go_there_and_back(self):
        placement = FreeCAD.Placement(FreeCAD.Vector(10, -20, 30), FreeCAD.Rotation(FreeCAD.Vector(1, 2, 3), 40))
        self.assertTrue(bridge.is_same(bridge.placement_of(bridge.pose_of(placement)), placement))

    def test_an_assembly_becomes_a_cell_and_its_placements_come_back(self):
        file = self.folder / "assembly.hcell"
        cell = bridge.send(self.document, file)
        self.assertEqual(sorted(cell.names), ["Base", "Peg"])  # What the cut is made of is no part.
        self.assertAlmostEqual(cell["Peg"].pose[2], 0.1)
        # The peg fits the hole with a millimetre all around, and the shapes are exact.
        cell.move("Peg", [0, 0, -0.01, 1, 0, 0, 0])
        self.assertAlmostEqual(float(cell.distances("Peg")["distance"][0]), 0.001, 4)
        cell.save()
        self.assertEqual(bridge.take_back(self.document, file), ["Peg"])
        self.assertAlmostEqual(self.peg.Placement.Base.z, -10, 6)
        self.assertEqual(bridge.take_back(self.document, file), [])

    def test_a_drag_ends_at_contact(self):
        drag = bridge.Drag(self.document, self.peg)
        self.assertFalse(drag.to(FreeCAD.Placement(FreeCAD.Vector(0, 0, -10), FreeCAD.Rotation())))  # Into the hole.
        self.assertTrue(drag.to(FreeCAD.Placement(FreeCAD.Vector(50, 0, -10), FreeCAD.Rotation())))
        self.assertAlmostEqual(self.peg.Placement.Base.x, 1.0, 1)

    def test_a_move_in_freecad_stops_while_the_guard_is_on(self):
        guard = bridge.Guard(self.document)
        self.peg.Placement = FreeCAD.Placement(FreeCAD.Vector(60, 0, 100), FreeCAD.Rotation())
        self.assertEqual(guard.stops, 0)
        self.peg.Placement = FreeCAD.Placement(FreeCAD.Vector(60, 0, -100), FreeCAD.Rotation())
        self.assertEqual(guard.stops, 1)
        self.assertAlmostEqual(self.peg.Placement.Base.z, 20, 1)  # On the plate, not through it.
        guard.end()
        self.peg.Placement.Base = FreeCAD.Vector(60, 0, -100)
        self.assertAlmostEqual(self.peg.Placement.Base.z, -100)


main()
