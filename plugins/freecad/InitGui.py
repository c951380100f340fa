# SPDX-License-Identifier: BSD-3-Clause
# FreeCAD runs this when its window opens, not as a module: names are looked up inside of the methods.
import FreeCADGui


class OctetWorkbench(FreeCADGui.Workbench):
    """A workbench with the commands of Octet; the FEM workbench has everything else."""

    MenuText = "Octet"
    ToolTip = "Tetrahedral meshes of solids for the FEM workbench"

    def __init__(self):
        import os
        import octet_freecad

        self.__class__.Icon = os.path.join(os.path.dirname(octet_freecad.__file__), "octet.svg")

    def Initialize(self):
        import FemGui  # noqa: F401  (analyses and mesh objects are its types)
        from octet_freecad import commands

        names = commands.register()
        self.appendToolbar("Octet", names)
        self.appendMenu("Octet", names)

    def GetClassName(self):
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(OctetWorkbench())
