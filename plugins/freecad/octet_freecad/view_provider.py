# SPDX-License-Identifier: BSD-3-Clause
"""How the mesh object stands in the tree, and what a double click on it opens."""
import FreeCADGui

from .commands import ICON
from .stateless import Stateless


class OctetViewProvider(Stateless):
    """Proxy of the view of a mesh object."""

    def __init__(self, view):
        view.Proxy = self

    def attach(self, view):
        self.Object = view.Object

    def getIcon(self):
        return ICON

    def setEdit(self, view, mode):
        from .task_panel import TaskPanel

        FreeCADGui.Control.showDialog(TaskPanel(view.Object))
        return True

    def unsetEdit(self, view, mode):
        FreeCADGui.Control.closeDialog()
        return True

    def doubleClicked(self, view):
        document = FreeCADGui.getDocument(view.Object.Document.Name)
        if not document.getInEdit():
            document.setEdit(view.Object.Name)
        return True
