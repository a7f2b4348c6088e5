# SPDX-License-Identifier: Apache-2.0
"""Between a document of FreeCAD and HaptiCell: parts become a workcell, parts are dragged until contact, placements come back.

Works with and without FreeCAD's window. FreeCAD counts in millimetres, HaptiCell in metres.
"""
import pathlib
import subprocess

import FreeCAD
import numpy

import hapticell

MM = 0.001


def pose_of(placement):
    """x, y, z, qw, qx, qy, qz in metres of a FreeCAD placement."""
    x, y, z, w = placement.Rotation.Q
    return [placement.Base.x * MM, placement.Base.y * MM, placement.Base.z * MM, w, x, y, z]


def placement_of(pose):
    """A FreeCAD placement of x, y, z, qw, qx, qy, qz in metres."""
    x, y, z, qw, qx, qy, qz = (float(number) for number in pose)
    return FreeCAD.Placement(FreeCAD.Vector(x / MM, y / MM, z / MM), FreeCAD.Rotation(qx, qy, qz, qw))


def is_same(a, b):
    """Within a tenth of a nanometre and of a microradian."""
    return a.Base.distanceToPoint(b.Base) < 1e-7 and a.Rotation.isSame(b.Rotation, 1e-7)


def parts_of(document):
    """The parts of an assembly: visible objects with solids that no other shape is made of."""
    found = []
    for thing in document.Objects:
        shape = getattr(thing, "Shape", None)
        if shape is None or not shape.Solids:
            continue
        if any(getattr(user, "Shape", None) is not None and user.Shape.Solids for user in thing.InList):
            continue  # A step of another part: the sketch of a pad, the operand of a cut.
        found.append(thing)
    return found


def _own_shape(part):
    """The shape in the part's own frame."""
    shape = part.Shape.copy()
    shape.Placement = FreeCAD.Placement()
    return shape


def global_placement(part):
    return part.getGlobalPlacement() if hasattr(part, "getGlobalPlacement") else part.Placement


def _set_global_placement(part, wanted):
    """Whatever groups it is in."""
    above = global_placement(part).multiply(part.Placement.inverse())
    part.Placement = above.inverse().multiply(wanted)


def send(document, file):
    """Writes the parts of the document as a workcell, each with its exact shape as STEP beside it.

    The parts keep FreeCAD's internal names, which are unique. Returns the Workcell.
    """
    file = pathlib.Path(file)
    folder = file.with_name(file.stem + "-parts")
    folder.mkdir(parents=True, exist_ok=True)
    cell = hapticell.Workcell()
    with cell.step("Assembly of FreeCAD"):
        for part in parts_of(document):
            step = folder / f"{part.Name}.step"
            _own_shape(part).exportStep(str(step))
            cell.add(step, name=part.Name, pose=pose_of(global_placement(part)), merge=True)
    cell.save(file)
    return cell


def open_window(file):
    """Shows the cell in HaptiCell's window, where the hand can hold its parts."""
    program = hapticell._engine.program_path("hapticell")
    if not program:
        raise hapticell.Error(place="hapticell", found="the program is not installed", fix="Install the package hapticell.",
                              message="hapticell: the program is not installed. Install the package hapticell.")
    return subprocess.Popen([program, str(file)])


def take_back(document, file):
    """Moves the parts to where the saved cell has them, as one step of undo. Returns the names of those that moved."""
    cell = hapticell.Workcell.open(file)
    moved = []
    document.openTransaction("Placements of HaptiCell")
    for part in parts_of(document):
        if part.Name not in cell:
            continue
        wanted = placement_of(cell[part.Name].pose)
        if not is_same(global_placement(part), wanted):
            _set_global_placement(part, wanted)
            moved.append(part.Name)
    document.commitTransaction()
    return moved


class Drag:
    """Moves one part of a document until contact with the others: nothing is passed through, however thin."""

    def __init__(self, document, part, clearance=1e-5, deviation=0.05):
        """`clearance` in metres to every other part; `deviation` of the triangles from the surface in millimetres."""
        self.part = part
        self.clearance = clearance
        self._scene = hapticell.Scene()
        others = []
        for each in parts_of(document):
            points, faces = _own_shape(each).tessellate(deviation)
            mesh = hapticell.Mesh(MM * numpy.array([tuple(point) for point in points]), numpy.array(faces))
            number = self._scene.add(mesh, pose_of(global_placement(each)))
            if each.Name == part.Name:
                self._moved = number
            else:
                others.append(number)
        self._scene.check([self._moved], others)

    def to(self, wanted):
        """The part goes towards the placement `wanted` (global); True if something stopped it."""
        swept = self._scene.sweep(self._moved, pose_of(wanted), clearance=self.clearance)
        self._scene.move(self._moved, swept.pose)
        _set_global_placement(self.part, placement_of(swept.pose))
        return swept.stopped


class Guard:
    """While it is on, parts that are moved in FreeCAD (Transform, a script, a property) stop at contact.

    FreeCAD tells an observer of each new placement; the guard then goes there from the last one by Drag.
    """

    def __init__(self, document, clearance=1e-5):
        self._document = document
        self._clearance = clearance
        self._drags = {}
        self._busy = False
        self.stops = 0
        FreeCAD.addDocumentObserver(self)

    def slotBeforeChangeObject(self, thing, name):
        """The part is still where it was: it is prepared there."""
        if self._busy or name != "Placement" or thing.Document is not self._document and thing.Document.Name != self._document.Name:
            return
        if thing.Name not in self._drags and thing.Name in [part.Name for part in parts_of(self._document)]:
            self._drags = {thing.Name: Drag(self._document, thing, self._clearance)}

    def slotChangedObject(self, thing, name):
        drag = self._drags.get(thing.Name)
        if self._busy or name != "Placement" or drag is None:
            return
        self._busy = True
        try:
            self.stops += drag.to(global_placement(thing))
        finally:
            self._busy = False

    def end(self):
        FreeCAD.removeDocumentObserver(self)
        self._drags = {}
