# SPDX-License-Identifier: Apache-2.0
"""The workbench HaptiCell: send an assembly, drag until contact, take placements back."""
import FreeCADGui


class _Send:
    def GetResources(self):
        return {"MenuText": "Open in HaptiCell", "ToolTip": "Save the parts as a workcell and open it in HaptiCell"}

    def IsActive(self):
        import FreeCAD
        return FreeCAD.ActiveDocument is not None

    def Activated(self):
        import FreeCAD
        from PySide2 import QtWidgets

        import hapticell_bridge
        file, _ = QtWidgets.QFileDialog.getSaveFileName(None, "Save as a workcell", "", "Workcell (*.hcell)")
        if file:
            hapticell_bridge.send(FreeCAD.ActiveDocument, file)
            hapticell_bridge.open_window(file)


class _TakeBack:
    def GetResources(self):
        return {"MenuText": "Take placements from HaptiCell", "ToolTip": "Move the parts to where a saved workcell has them"}

    def IsActive(self):
        import FreeCAD
        return FreeCAD.ActiveDocument is not None

    def Activated(self):
        import FreeCAD
        from PySide2 import QtWidgets

        import hapticell_bridge
        file, _ = QtWidgets.QFileDialog.getOpenFileName(None, "Workcell", "", "Workcell (*.hcell)")
        if file:
            moved = hapticell_bridge.take_back(FreeCAD.ActiveDocument, file)
            FreeCAD.Console.PrintMessage(f"HaptiCell: {len(moved)} parts moved\n")


class _StopAtContact:
    guard = None

    def GetResources(self):
        return {"MenuText": "Stop at contact", "ToolTip": "Parts that you move stop where they touch others", "Checkable": False}

    def IsActive(self):
        import FreeCAD
        return FreeCAD.ActiveDocument is not None

    def Activated(self, checked=0):
        import FreeCAD

        import hapticell_bridge
        if _StopAtContact.guard is not None:
            _StopAtContact.guard.end()
        _StopAtContact.guard = hapticell_bridge.Guard(FreeCAD.ActiveDocument) if checked else None


class HaptiCellWorkbench(FreeCADGui.Workbench):
    MenuText = "HaptiCell"
    ToolTip = "Assemblies by hand: contacts that can be felt"

    def Initialize(self):
        commands = {"HaptiCell_Send": _Send(), "HaptiCell_TakeBack": _TakeBack(), "HaptiCell_StopAtContact": _StopAtContact()}
        for name, command in commands.items():
            FreeCADGui.addCommand(name, command)
        self.appendMenu("HaptiCell", list(commands))
        self.appendToolbar("HaptiCell", list(commands))

    def GetClassName(self):
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(HaptiCellWorkbench())
