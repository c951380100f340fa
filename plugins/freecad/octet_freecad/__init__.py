# SPDX-License-Identifier: BSD-3-Clause
"""Octet in FreeCAD: a mesh object, the run of the program behind it, and what the FEM workbench needs of it.

    from octet_freecad import make_mesh, mesh
    obj = make_mesh(document, part)        # properties: Size, ElementOrder, LocalSizes, ...
    report = mesh(obj)                     # obj.FemMesh has groups Face1, Edge3, Solid1, ...
"""
from .mesh_object import make_mesh
from .mesher import mesh
from .program import OctetError

__all__ = ["make_mesh", "mesh", "OctetError"]
