#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The shapes of Octet's elements beside those of Gmsh, of Gmsh with Netgen's optimizer, and of Netgen.

    tests/bench/quality_peers.py FOLDER|FILE... [--tets 1e5] [--meshers octet,gmsh,gmsh+netgen,netgen] [--limit 300]
                                 [--manifest TSV --difficulty easy --kind solid] [--match TEXT] [--markdown]

Every mesher meshes each part at its own size for about the wanted number of tetrahedra (what is finer for the part's
own sake stays so), with one thread. A cell holds the count; the least dihedral angle of the elements that the part
does not limit, and of all; the largest of those not limited; the 1st percentile of the elements' least angles; the
mean of their mean ratios; and CPU seconds of the whole run. All by `octet quality`. Netgen's files name no model
edges, so sharp edges cannot be told there, and the first angle is `-`. A mesh of less than a third of the tetrahedra
is `not the size`: Debian's Netgen does not divide some edges.

gmsh is Debian's `gmsh -3`; netgen Debian's python3-netgen under /usr/bin/python3 (apt-get install gmsh
python3-netgen); gmsh+netgen is Gmsh's mesh after Netgen's optimizer for volumes, called from there, for Debian's Gmsh
is built without it. OCTET names the program (default: build/app/octet).
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import bench  # noqa: E402
import corpus  # noqa: E402

# What both programs that Python runs need. Netgen holds tetrahedra the other way round, and writes MSH 2.0, which
# differs from 2.2 in the header only, without the model's edges: all its triangles count as one face.
REWRITE = """
import sys
def rewrite(mesh, one_face):
    lines = open(mesh).read().split("\\n")
    lines[1] = "2.2 0 8"
    for i in range(lines.index("$Elements") + 2, len(lines)):
        words = lines[i].split()
        if len(words) > 4 and words[1] == "4":
            words[-1], words[-2] = words[-2], words[-1]
        if len(words) > 4 and one_face:
            words[3] = words[4] = "1"
        lines[i] = " ".join(words)
    open(mesh, "w").write("\\n".join(lines))
part, mesh, size = sys.argv[1:]
"""
NETGEN = REWRITE + """
from netgen.NgOCC import LoadOCCGeometry
LoadOCCGeometry(part).GenerateMesh(maxh=float(size)).Export(mesh, "Gmsh2 Format")
rewrite(mesh, True)
"""
GMSH_NETGEN = REWRITE + """
import subprocess
from netgen.read_gmsh import ReadGmsh
subprocess.run(["gmsh", "-3", "-nt", "1", "-v", "0", "-format", "msh2", "-clmin", "0", "-clmax", size, part, "-o",
                mesh], check=True)
rewrite(mesh, False)
read = ReadGmsh(mesh)
read.OptimizeVolumeMesh()
read.Export(mesh, "Gmsh2 Format")
rewrite(mesh, True)
"""
COMMANDS = {
    "octet": lambda part, mesh, size: [bench.OCTET, "mesh", part, "-o", mesh, "--quiet", "--threads", "1",
                                       "--max-elements", "100000000", "--size", size],
    "gmsh": lambda part, mesh, size: ["gmsh", "-3", "-nt", "1", "-bin", "-v", "0", "-clmin", "0", "-clmax", size, part,
                                      "-o", mesh],
    "gmsh+netgen": lambda part, mesh, size: ["/usr/bin/python3", "-c", GMSH_NETGEN, part, mesh, size],
    "netgen": lambda part, mesh, size: ["/usr/bin/python3", "-c", NETGEN, part, mesh, size],
}
COLUMNS = ("tets", "free", "all", "largest", "p1", "ratio", "cpu s")


def shapes(mesh):
    """What `octet quality` says of the file, or None when it is no mesh."""
    if not os.path.exists(mesh):
        return None
    done = subprocess.run([bench.OCTET, "quality", "--json", mesh], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        return None
    told = json.loads(done.stdout)
    of_all = {measure["name"]: measure for measure in told["all"]}
    # Where all elements are limited, or none, there is no second table.
    free = {measure["name"]: measure for measure in told.get("without_limited") or told["all"]}
    return {"tets": told["tets"], "free": free["smallest dihedral"]["least"],
            "all": of_all["smallest dihedral"]["least"], "largest": free["largest dihedral"]["largest"],
            "p1": of_all["smallest dihedral"]["p1"], "ratio": of_all["mean ratio"]["mean"]}


class Mesher:
    """What bench.fitted_size fits the size of."""

    def __init__(self, name, work, limit):
        self.name = name
        self.mesh = os.path.join(work, name + ".msh")
        self.limit = limit
        self.found = None

    def run(self, part, size):
        if os.path.exists(self.mesh):
            os.remove(self.mesh)
        run = bench.Run(["timeout", str(self.limit), *COMMANDS[self.name](part, self.mesh, repr(size))])
        self.found = shapes(self.mesh)
        run.tets = self.found["tets"] if self.found else 0
        if self.found:
            self.found["cpu s"] = run.cpu
        return run

    def near(self, part, tets, size):
        """The size that gives about so many tetrahedra, from `size` on; `found` is what it gave."""
        for _ in range(3):
            run = self.run(part, size)
            if run.tets == 0 or abs(run.tets / tets - 1.0) < 0.25:
                break
            # The count goes as size^-3, less where the part's own detail sets it.
            size *= min(max((run.tets / tets) ** (1.0 / 3.0), 0.4), 3.0)
        return size


def cells(name, found, tets):
    if found is None:
        return ["no mesh"] + [""] * (len(COLUMNS) - 1)
    if found["tets"] < tets / 3:
        return [str(found["tets"]), "not the size"] + [""] * (len(COLUMNS) - 2)
    free = "-" if "netgen" in name else f"{found['free']:.1f}"
    return [str(found["tets"]), free, f"{found['all']:.1f}", f"{found['largest']:.1f}", f"{found['p1']:.1f}",
            f"{found['ratio']:.3f}", f"{found['cpu s']:.1f}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    corpus.add_choice(parser)
    parser.add_argument("--tets", default=1e5, type=float)
    parser.add_argument("--meshers", default=",".join(COMMANDS))
    parser.add_argument("--limit", type=float, default=300.0, help="seconds a run may take")
    parser.add_argument("--markdown", action="store_true", help="a table for the docs")
    args = parser.parse_args()
    parts = corpus.chosen_parts(args)
    width = max((len(os.path.splitext(os.path.basename(part))[0]) for part in parts), default=4)
    row = (lambda words: "| " + " | ".join(words) + " |") if args.markdown else \
        (lambda words: f"{words[0]:{width}} {words[1]:11}" + "".join(f"{w:>9}" for w in words[2:]))
    print(row(["part", "mesher", *COLUMNS]))
    if args.markdown:
        print("|---" * (2 + len(COLUMNS)) + "|")
    with tempfile.TemporaryDirectory() as work:
        for part in parts:
            size = bench.first_size(part, args.tets)
            for name in args.meshers.split(","):
                mesher = Mesher(name, work, args.limit)
                size = mesher.near(part, args.tets, size)
                print(row([os.path.splitext(os.path.basename(part))[0], name, *cells(name, mesher.found, args.tets)]), flush=True)


if __name__ == "__main__":
    main()
