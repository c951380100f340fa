# SPDX-License-Identifier: BSD-3-Clause
"""Parts to meshes: the commands of the program octet as functions."""
import os
import shutil
import tempfile
import weakref

import numpy as np

from .arrays import Mesh
from .program import OctetError, Run, ask, find_program, told, words_of


class IncompleteError(OctetError):
    """A mesh was made, and is not right everywhere: `mesh` is it, the text tells where and why."""

    def __init__(self, mesh):
        faults = mesh.report["faults"]
        super().__init__(
            f"incomplete, {len(faults)} fault(s): {words_of(faults[0])}" if faults else "incomplete"
        )
        self.mesh = mesh


class _Folder:
    """For files of a run; it goes when nobody holds it any more."""

    def __init__(self):
        self.name = tempfile.mkdtemp(prefix="octet_")
        weakref.finalize(self, shutil.rmtree, self.name, ignore_errors=True)


def _words(options):
    """Keywords as words of the command line: wall_elements=2 is --wall-elements 2, cap=True is --cap; a list
    is an option several times, a dict one of places and values."""
    words = []
    for name, value in options.items():
        option = "--" + name.replace("_", "-")
        if value is None or value is False:
            continue
        if value is True:
            words.append(option)
            continue
        if isinstance(value, dict):
            value = [f"{place}={_text(size)}" for place, size in value.items()]
        for one in value if isinstance(value, (list, tuple)) else [value]:
            words += [option, _text(one)]
    return words


def _text(value):
    """Numbers with all their digits."""
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    return os.fspath(value) if isinstance(value, os.PathLike) else str(value)


def _part_file(part, folder):
    """A path stays; a shape that can write itself as BREP does so: of FreeCAD, of CadQuery, or a CadQuery
    Workplane that holds one."""
    if isinstance(part, (str, os.PathLike)):
        return os.fspath(part)
    shape = part.val() if hasattr(part, "val") else part
    if not hasattr(shape, "exportBrep"):
        raise TypeError(f"a part is a path, or a shape with exportBrep, not {type(part).__name__}")
    path = os.path.join(folder, "part.brep")
    shape.exportBrep(path)
    return path


def _field_files(field, folder):
    """Paths; a pair of points (n, 3) and sizes (n,) becomes a file."""
    fields = field if isinstance(field, list) else [field]
    files = []
    for n, one in enumerate(fields):
        if not isinstance(one, (str, os.PathLike)):
            points, sizes = one
            rows = np.column_stack([np.asarray(points, dtype=float), np.asarray(sizes, dtype=float)])
            one = os.path.join(folder, f"field{n}.csv")
            np.savetxt(one, rows, delimiter=",")
        files.append(one)
    return files


def _run(words, folder, output, follow):
    """The mesh of one run, whatever its status."""
    file = os.path.join(folder.name, "mesh.msh")
    outputs = [output] if isinstance(output, (str, os.PathLike)) else output
    for path in [file, *outputs]:
        words += ["--output", os.fspath(path)]
    run = Run(find_program(), words, os.path.join(folder.name, "report.json"))
    report = run.follow(**follow)
    return Mesh(file, report, run.summary(), folder)


def _judged(mesh, incomplete):
    if mesh.complete or incomplete == "accept":
        return mesh
    raise IncompleteError(mesh)


def _check_incomplete(incomplete):
    if incomplete not in ("raise", "accept"):
        raise ValueError(f"incomplete is 'raise' or 'accept', not {incomplete!r}")


def mesh(
    part,
    size=None,
    *,
    size_at=None,
    field=None,
    order=None,
    output=(),
    incomplete="raise",
    progress=None,
    time_limit=None,
    **options,
):
    """Meshes a part and returns a Mesh.

    part        path of a STEP, IGES or BREP file; or a shape of FreeCAD or CadQuery (with exportBrep)
    size        edge length of the elements; None: from the part's own dimensions
    size_at     sizes at places: {"Face12": 0.5, "bore*": "/24", "ball:0,0,0,5": 1}; or a list of "PLACE=SIZE"
    field       sizes over space: (points, sizes), arrays of shape (n, 3) and (n,), or a path (CSV, MSH, VTU)
    order       of the elements: 1 (what None means, unless a file of options says otherwise) or 2
    output      files to keep, too: .msh, .vtu, .inp, .unv, .bdf, .exo, .mesh, .meshb, .su2, .med, .xdmf,
                .cgns, .stl; a path or a list
    incomplete  "raise": a mesh that is not right everywhere raises IncompleteError, which has it;
                "accept": it is returned, and its report tells
    progress    called with (stage, fraction) as stages begin; what it raises ends the run
    time_limit  seconds; then the run is cancelled
    options     any other option of `octet mesh` in its own words: wall_elements=2, unit="m", cap=True,
                group={"fixed": "Face1,Face7-9"}, periodic=["x", "Face3=Face4"], layers="wall*=0.02,6"

    OctetError when there is no mesh: the text says why, with the CAD entity at fault.
    """
    _check_incomplete(incomplete)
    folder = _Folder()
    words = ["mesh", _part_file(part, folder.name)]
    fields = None if field is None else _field_files(field, folder.name)
    words += _words({"size": size, "size_at": size_at, "field": fields, "order": order, **options})
    made = _run(words, folder, output, {"progress": progress, "time_limit": time_limit})
    return _judged(made, incomplete)


def adapt(
    mesh, part, sizes, *, order=None, output=(), incomplete="raise", progress=None, time_limit=None, **options
):
    """Meshes the part anew with the sizes that an error estimate wants, and returns a Mesh.

    mesh    that was solved on: a Mesh, or the path of an MSH file
    sizes   one for each of its tetrahedra, or one for each of its nodes, in their order
    order   of the new elements; None: as those of `mesh`, where that is a Mesh
    Others as of octet.mesh; options are those of `octet adapt`. The unit is that of `mesh`.
    """
    _check_incomplete(incomplete)
    folder = _Folder()
    given = np.asarray(sizes, dtype=float).ravel()
    if isinstance(mesh, Mesh):
        order = mesh.order if order is None else order
        if len(given) not in (len(mesh.tets), len(mesh.points)):
            raise ValueError(
                f"{len(given)} sizes are neither one for each of {len(mesh.tets)} tetrahedra nor for each of "
                f"{len(mesh.points)} nodes"
            )
    file = os.path.join(folder.name, "sizes.csv")
    np.savetxt(file, given)
    words = ["adapt", _mesh_file(mesh), _part_file(part, folder.name)]
    words += _words({"field": file, "order": order, **_with_unit(mesh, options)})
    made = _run(words, folder, output, {"progress": progress, "time_limit": time_limit})
    return _judged(made, incomplete)


def improve(mesh, part, *, incomplete="raise", progress=None, time_limit=None, **options):
    """Better shapes for a classified mesh of the part, from any mesher (MSH): returns a Mesh. Arguments as of
    octet.adapt; options are those of `octet improve`."""
    _check_incomplete(incomplete)
    folder = _Folder()
    words = ["improve", _mesh_file(mesh), _part_file(part, folder.name), *_words(_with_unit(mesh, options))]
    made = _run(words, folder, (), {"progress": progress, "time_limit": time_limit})
    return _judged(made, incomplete)


def _mesh_file(mesh):
    return mesh.file if isinstance(mesh, Mesh) else os.fspath(mesh)


def _with_unit(mesh, options):
    """A mesh that octet made is in the unit that it was asked for in."""
    if isinstance(mesh, Mesh) and mesh.report:
        return {"unit": mesh.report["mesh_unit"], **options}
    return options


def info(part, **options):
    """What a part is (unit, size, entities with centres, normals, radii and ends, names, faults): the JSON of
    `octet info`, a dict. With at="0,10,5", or a list of such, key "at" tells what is at these places."""
    folder = _Folder()
    return ask(find_program(), ["info", _part_file(part, folder.name), *_words(options)])


def extract(part, places, output, **options):
    """Writes some faces of a part as its file has them, to look at or to send on: `octet extract`. Places are a
    text or a list of such ("Face12", "Region2", "Face%#4711", a face "Face@x,y,z"); the output is a .step or
    .brep file, whose path is returned. around=N: how often the faces that touch those are taken, too."""
    folder = _Folder()
    places = [places] if isinstance(places, str) else list(places)
    words = [_part_file(part, folder.name), *places, "-o", os.fspath(output), *_words(options)]
    told(find_program(), ["extract", *words])
    return os.fspath(output)


def check(mesh, part, **options):
    """Every claim about a mesh against its part: the JSON of `octet check`, a dict with its status."""
    folder = _Folder()
    words = [_mesh_file(mesh), _part_file(part, folder.name), *_words(_with_unit(mesh, options))]
    return ask(find_program(), ["check", *words])


def quality(mesh, **options):
    """Shapes of a mesh's elements: the JSON of `octet quality`, a dict."""
    return ask(find_program(), ["quality", _mesh_file(mesh), *_words(_with_unit(mesh, options))])
