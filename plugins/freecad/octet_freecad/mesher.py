# SPDX-License-Identifier: BSD-3-Clause
"""From a mesh object to its mesh: the part to a file, the program, its mesh and its report back."""
import os
import re
import shlex
import shutil
import tempfile

import FreeCAD
import Fem

from . import groups
from .program import OctetError, Run, find_program, words_of

PREFERENCES = "User parameter:BaseApp/Preferences/Mod/Octet"
MILLIMETRE = "mm"


def preferred_program():
    return FreeCAD.ParamGet(PREFERENCES).GetString("Program", "")


def shape_of(part):
    """The part's shape where FreeCAD's solvers take its faces to be: up to 0.21 in its container, since then
    in the document. OctetError when there is nothing to mesh."""
    shape = getattr(part, "Shape", None)
    if shape is None or shape.isNull():
        raise OctetError("no part is chosen, or it has no shape")
    if not shape.Solids:
        raise OctetError(f"{part.Label} has no solid")
    if int(FreeCAD.Version()[0]) >= 1 and hasattr(part, "getGlobalPlacement"):
        shape = shape.copy()
        shape.Placement = part.getGlobalPlacement()
    return shape


def size_words(line):
    """A line of LocalSizes in octet's words: numbers are the file's, a solid is a region."""
    line = re.sub(r"^\s*solid(?=[\d%:@])", "Region", line.strip(), flags=re.IGNORECASE)
    return re.sub(r"^(vertex|edge|face|region)(?=\d)", r"\1%", line, flags=re.IGNORECASE)


def arguments(obj, part_file, mesh_file):
    """Of octet mesh, for what the object asks for."""
    words = [
        "mesh",
        part_file,
        "-o",
        mesh_file,
        "--unit",
        MILLIMETRE,
        "--order",
        "1" if obj.ElementOrder == "1st" else "2",
    ]
    for option, quantity in (("--size", obj.Size), ("--min-size", obj.MinSize)):
        if quantity.Value > 0.0:
            words += [option, repr(quantity.Value)]
    for option, number in (("--target-elements", obj.TargetElements), ("--threads", obj.Threads)):
        if number > 0:
            words += [option, str(number)]
    for line in obj.LocalSizes:
        if line.strip():
            words += ["--size-at", size_words(line)]
    return words + shlex.split(obj.Options)


def analysis_of(obj):
    """The analysis that holds the object, or None."""
    for holder in obj.InList:
        if holder.isDerivedFrom("Fem::FemAnalysis"):
            return holder
    return None


def update_groups(obj):
    """Groups of the mesh for the members of its analysis as they are now. Returns the names of those that
    refer to elements without mesh."""
    analysis = analysis_of(obj)
    if analysis is None:
        return []
    femmesh = obj.FemMesh.copy()
    lacking = groups.add_analysis_groups(femmesh, obj.Part, analysis.Group)
    obj.FemMesh = femmesh
    return lacking


def words_as_shown(fault, renumbered, counts):
    """One line: entity as FreeCAD counts, place, cause, what to do."""
    number = None
    if fault["dim"] >= 0 and fault["tag"] > 0:
        number = groups.number_shown(fault["dim"], fault["tag"], renumbered, counts)
    if number is not None:
        fault = {**fault, "entity": f"{groups.KINDS[fault['dim']]} {number}"}
    return words_of(fault)


class Mesher:
    """A run for one mesh object: `start`, then `running` and `cancel`, then `finish`."""

    def __init__(self, obj):
        self.obj = obj
        self.run = None
        self._folder = None

    def start(self):
        """OctetError when there is no part or no program."""
        program = find_program(preferred_program())
        shape = shape_of(self.obj.Part)
        self._counts = (len(shape.Vertexes), len(shape.Edges), len(shape.Faces), len(shape.Solids))
        self._folder = tempfile.mkdtemp(prefix="octet_")
        part_file, self._mesh_file, report_file = (
            os.path.join(self._folder, name) for name in ("part.brep", "mesh.unv", "report.json")
        )
        try:
            shape.exportBrep(part_file)
            self.run = Run(program, arguments(self.obj, part_file, self._mesh_file), report_file)
        except (OSError, ValueError) as error:  # no room on the disk; a quote without its end in Options
            shutil.rmtree(self._folder, ignore_errors=True)
            raise OctetError(str(error)) from error

    def running(self):
        return self.run is not None and self.run.running()

    def cancel(self):
        if self.run is not None:
            self.run.cancel()

    def finish(self, time_limit=None):
        """Waits, `time_limit` seconds at most, and gives the object its mesh, groups and outcome. Returns the
        report. OctetError when there is no mesh: the object keeps the one that it had, and its status tells.
        """
        obj = self.obj
        try:
            report = self.run.follow(time_limit=time_limit)
            femmesh = Fem.read(self._mesh_file)
        except Exception as error:
            obj.Status, obj.Summary, obj.Faults = "failed", [], [str(error)]
            if isinstance(error, OctetError):
                raise
            raise OctetError(str(error)) from error
        finally:
            shutil.rmtree(self._folder, ignore_errors=True)
        groups.count_as_freecad(femmesh, report["renumbered"], self._counts)
        analysis = analysis_of(obj)
        lacking = (
            groups.add_analysis_groups(femmesh, obj.Part, analysis.Group) if analysis is not None else []
        )
        obj.FemMesh = femmesh
        obj.Status = report["status"]
        obj.Summary = [" ".join(line.split()) for line in self.run.summary()[1:]]
        faults = [
            words_as_shown(fault, report["renumbered"], self._counts)
            for fault in report["faults"] + report["warnings"]
        ]
        obj.Faults = faults + [f"{name} refers to elements that the mesh does not have" for name in lacking]
        return report


def mesh(obj, time_limit=None):
    """Meshes the object and waits for it; `time_limit` in seconds. Returns the report. OctetError when there
    is no mesh."""
    mesher = Mesher(obj)
    mesher.start()
    return mesher.finish(time_limit)
