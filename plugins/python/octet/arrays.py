# SPDX-License-Identifier: BSD-3-Clause
"""A classified mesh in arrays."""
import difflib
import fnmatch
import re
import shutil

import numpy as np

from . import msh

KINDS = ("Vertex", "Edge", "Face", "Region")
MESHIO = {1: ("line", "triangle", "tetra"), 2: ("line3", "triangle6", "tetra10")}  # by order


class Mesh:
    """Points, edges, triangles and tetrahedra, each with the model entity that it lies on, in the order of
    their numbers in the mesh's files, where these count from 1.

    points        (n, 3) float64, in the unit that the mesh was asked for in
    point_on      (n, 2) int32, dimension and tag of the model entity of least dimension that holds the point
    edges         (e, 2) int64, indices of points from 0; (e, 3) of second order: those on model edges
    edge_on       (e,) int32, tags of their model edges
    triangles     (t, 3) or (t, 6): those on model faces, oriented as these
    triangle_on   (t,) int32, tags of their model faces
    tets          (m, 4) or (m, 10): positive; nodes in the order of VTK, Abaqus and meshio
    tet_in        (m,) int32, tags of their model regions
    names         names by (dimension, tag): what CAD gave, or Face12 and Solid3
    groups        (dimension, tag) of the entities by the name that they have together: of `group` of
                  octet.mesh, or what CAD gave to several
    periodic      of what is the image of another entity, by (dimension, tag): the other's tag, the motion from
                  there to here (4, 4), and (n, 2) int64, indices of points here and there
    order         of the elements, 1 or 2
    file          its file, MSH 4.1; one that octet made for itself goes when the mesh does
    report        of the run (docs/conventions.md of octet), a dict; None of a file that was read
    summary       what the program prints for people, a line each
    """

    def __init__(self, file, report=None, summary=(), keep=None):
        for name, value in msh.read(file).items():
            setattr(self, name, value)
        self.order = 2 if self.tets.shape[1] == 10 else 1
        self.file, self.report, self.summary = file, report, list(summary)
        self._keep = keep  # the folder of the file

    def __repr__(self):
        told = f", {self.report['status']}" if self.report else ""
        return (
            f"<octet.Mesh: {len(self.points)} nodes, {len(self.tets)} tetrahedra of order {self.order}{told}>"
        )

    @property
    def complete(self):
        """Whether every claim about the mesh holds; None where there is no report."""
        return None if self.report is None else self.report["status"] == "complete"

    def entities(self, which):
        """(dimension, tag) of all that `which` names: such a pair; a number as Face12, Solid3 or Region3,
        which goes before a name of that sound; or a name or a pattern of names with * and ?, one of `groups`
        before one of `names`. KeyError when no name fits."""
        if not isinstance(which, str):
            dim, tag = which
            return [(int(dim), int(tag))]
        number = re.fullmatch(r"(vertex|edge|face|region|solid)(\d+)", which, flags=re.IGNORECASE)
        if number:
            dim = 3 if number[1].lower() == "solid" else KINDS.index(number[1].capitalize())
            return [(dim, int(number[2]))]
        if which in self.groups:
            return self.groups[which]
        found = sorted(entity for entity, name in self.names.items() if fnmatch.fnmatchcase(name, which))
        if not found:
            near = difflib.get_close_matches(which, [*self.groups, *self.names.values()], 1)
            raise KeyError(f"nothing is called {which!r}" + (f"; did you mean {near[0]!r}?" if near else ""))
        return found

    def _of(self, dim, tag):
        """Nodes of its elements, a row each."""
        if dim == 0:
            rows = np.flatnonzero((self.point_on == (0, tag)).all(axis=1))[:, None]
        else:
            rows, on = (
                (self.edges, self.edge_on),
                (self.triangles, self.triangle_on),
                (self.tets, self.tet_in),
            )[dim - 1]
            rows = rows[on == tag]
        if not len(rows):
            raise KeyError(f"the mesh has nothing on {KINDS[dim]}{tag}")
        return rows

    def nodes(self, which):
        """Indices of the points on the closure of all that `which` names (see entities), ascending: on a
        face, those of its edges and vertices, too. KeyError when there are none."""
        return np.unique(np.concatenate([self._of(*entity).ravel() for entity in self.entities(which)]))

    def elements(self, which):
        """Rows of `tets`, `triangles` or `edges` (or single points) on what `which` names. KeyError when
        there are none, ValueError when it names entities of more than one dimension."""
        entities = self.entities(which)
        if len({dim for dim, _ in entities}) > 1:
            raise ValueError(f"{which!r} names entities of several dimensions")
        return np.concatenate([self._of(*entity) for entity in entities])

    def save(self, path):
        """Copies its file. Other formats: `output` of octet.mesh, or meshio."""
        shutil.copyfile(self.file, path)

    def to_meshio(self, dim=None):
        """A meshio.Mesh, which writes MED, XDMF and others. Its cell data `entity` are tags of model
        entities; what MED has for groups (`cell_tags`, `point_tags`) puts the elements of each edge, face and
        region, and the node of each vertex, into a group by its name. Where `dim` is given it has the
        elements of that dimension alone, and `entity` for all data, as readers of XDMF want it."""
        import meshio

        kinds, cells, tags, families = MESHIO[self.order], [], [], {}
        for of, rows, on in (
            (1, self.edges, self.edge_on),
            (2, self.triangles, self.triangle_on),
            (3, self.tets, self.tet_in),
        ):
            if not len(rows) or dim not in (None, of):
                continue
            entities, which = np.unique(on, return_inverse=True)
            numbers = -len(families) - 1 - np.arange(len(entities))  # MED's families of elements are negative
            families.update((int(n), [self._name(of, tag)]) for n, tag in zip(numbers, entities))
            cells.append((kinds[of - 1], rows))
            tags.append((on, numbers[which]))
        entity = [on for on, _ in tags]
        if dim is not None:
            return meshio.Mesh(self.points, cells, cell_data={"entity": entity})
        on_vertices = np.flatnonzero(self.point_on[:, 0] == 0)
        at_point = np.zeros(len(self.points), dtype=np.int64)
        at_point[on_vertices] = np.arange(1, len(on_vertices) + 1)
        mesh = meshio.Mesh(
            self.points,
            cells,
            point_data={"point_tags": at_point},
            cell_data={"entity": entity, "cell_tags": [family for _, family in tags]},
        )
        mesh.cell_tags = families
        mesh.point_tags = {
            int(at_point[point]): [self._name(0, self.point_on[point, 1])] for point in on_vertices
        }
        return mesh

    def _name(self, dim, tag):
        return self.names.get((dim, int(tag)), f"{KINDS[dim]}{tag}")


def read(path):
    """The mesh of a binary MSH 4.1 file. ValueError when it is none."""
    return Mesh(path)
