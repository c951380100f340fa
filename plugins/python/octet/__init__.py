# SPDX-License-Identifier: BSD-3-Clause
"""Octet in Python: CAD parts (STEP, IGES, BREP) to classified tetrahedral meshes in numpy arrays.

    import octet
    mesh = octet.mesh("part.step", size=2, size_at={"Face12": 0.5})
    mesh.points, mesh.tets, mesh.tet_in             # coordinates, elements, their regions
    mesh.nodes("Face12"), mesh.elements("bore*")    # for loads and boundary conditions
    finer = octet.adapt(mesh, "part.step", sizes)   # a size per element, from an error estimate

The work is done by the program octet, in a process of its own."""
from .arrays import Mesh, read
from .meshing import IncompleteError, adapt, check, extract, improve, info, mesh, quality
from .program import OctetError

__all__ = [
    "Mesh",
    "OctetError",
    "IncompleteError",
    "adapt",
    "check",
    "extract",
    "improve",
    "info",
    "mesh",
    "quality",
    "read",
]
