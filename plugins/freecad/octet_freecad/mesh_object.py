# SPDX-License-Identifier: BSD-3-Clause
"""The document object: what is to be meshed, and how fine."""
import FreeCAD

from .stateless import Stateless

PROPERTIES = [
    # name, type, group, tooltip, value
    ("Part", "App::PropertyLink", "Octet", "The part or body whose solids are meshed", None),
    (
        "Size",
        "App::PropertyLength",
        "Octet",
        "Edge length of the elements; 0: from the part's own dimensions",
        None,
    ),
    (
        "MinSize",
        "App::PropertyLength",
        "Octet",
        "Nothing is refined further than this; 0: a thirty-second of the size",
        None,
    ),
    (
        "TargetElements",
        "App::PropertyInteger",
        "Octet",
        "Scale the sizes to get about so many tetrahedra; 0: do not",
        None,
    ),
    (
        "ElementOrder",
        "App::PropertyEnumeration",
        "Octet",
        "Elements with four nodes, or with ten that follow curved faces",
        ["2nd", "1st"],
    ),
    (
        "LocalSizes",
        "App::PropertyStringList",
        "Octet",
        "Sizes at places, one a line: Face12=0.5, Edge3=0.2, Solid2=4 (mm), Edge5=/12 (twelve elements)",
        None,
    ),
    ("Threads", "App::PropertyInteger", "Octet", "0: all; the mesh is the same for any number", None),
    ("Options", "App::PropertyString", "Octet", "More options of octet mesh, as on its command line", None),
    (
        "Status",
        "App::PropertyString",
        "Outcome",
        "complete: every claim about the mesh was tested and holds",
        None,
    ),
    ("Summary", "App::PropertyStringList", "Outcome", "Counts, shapes, volume and distance to the CAD", None),
    (
        "Faults",
        "App::PropertyStringList",
        "Outcome",
        "What is not as it should be, with the CAD entity and the place",
        None,
    ),
]
READ_ONLY = ("Status", "Summary", "Faults")


class OctetMesh(Stateless):
    """Proxy of a Fem::FemMeshObjectPython."""

    Type = "Fem::FemMeshOctet"

    def __init__(self, obj):
        obj.Proxy = self
        self.add_properties(obj)

    def add_properties(self, obj):
        for name, kind, group, tooltip, value in PROPERTIES:
            if name in obj.PropertiesList:
                continue
            obj.addProperty(kind, name, group, tooltip)
            if value is not None:
                setattr(obj, name, value)
            if name in READ_ONLY:
                obj.setEditorMode(name, 1)

    def onDocumentRestored(self, obj):
        """A document of an older version gets the properties that it lacks."""
        self.add_properties(obj)

    def execute(self, obj):
        """Meshes are made when asked for, not with every change of the document."""


def make_mesh(document, part, name="OctetMesh"):
    """A mesh object for `part` in `document`, not meshed yet; into the active analysis where there is a
    window."""
    obj = document.addObject("Fem::FemMeshObjectPython", name)
    OctetMesh(obj)
    obj.Part = part
    if FreeCAD.GuiUp:
        from .view_provider import OctetViewProvider

        OctetViewProvider(obj.ViewObject)
        import FemGui

        analysis = FemGui.getActiveAnalysis()
        if analysis is not None and analysis.Document == document:
            analysis.addObject(obj)
    return obj
