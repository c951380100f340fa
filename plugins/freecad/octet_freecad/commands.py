# SPDX-License-Identifier: BSD-3-Clause
"""What the toolbar and the menu have."""
import os

import FreeCAD
import FreeCADGui

from . import make_mesh
from .mesher import update_groups

ICON = os.path.join(os.path.dirname(__file__), "octet.svg")


def selected():
    """The one object selected, or None."""
    objects = FreeCADGui.Selection.getSelection()
    return objects[0] if len(objects) == 1 else None


def is_octet_mesh(obj):
    return getattr(getattr(obj, "Proxy", None), "Type", "") == "Fem::FemMeshOctet"


class MeshCommand:
    """A mesh object for the part selected, and its panel."""

    def GetResources(self):
        return {
            "Pixmap": ICON,
            "MenuText": "Octet mesh",
            "ToolTip": "Make a tetrahedral mesh of the part or body selected",
        }

    def IsActive(self):
        obj = selected()
        return obj is not None and bool(getattr(getattr(obj, "Shape", None), "Solids", []))

    def Activated(self):
        part = selected()
        document = part.Document
        document.openTransaction("Octet mesh")
        obj = make_mesh(document, part)
        document.commitTransaction()
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.getDocument(document.Name).setEdit(obj.Name)


class GroupsCommand:
    """For constraints that came after the mesh."""

    def GetResources(self):
        return {
            "Pixmap": ICON,
            "MenuText": "Update groups",
            "ToolTip": "Tell the mesh which of its nodes the constraints of its analysis refer to",
        }

    def IsActive(self):
        return is_octet_mesh(selected())

    def Activated(self):
        for name in update_groups(selected()):
            FreeCAD.Console.PrintWarning(f"{name} refers to elements that the mesh does not have\n")


def register():
    """Registers the commands; returns their names."""
    commands = {"Octet_Mesh": MeshCommand(), "Octet_UpdateGroups": GroupsCommand()}
    for name, command in commands.items():
        FreeCADGui.addCommand(name, command)
    return list(commands)
