#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Which meshers give a valid and faithful mesh of which parts, at the same size.

    tests/bench/peers.py FOLDER|FILE... --meshstat PATH --meshvscad PATH [--octet build/app/octet]
                         [--meshers octet,gmsh,hxt,netgen] [--size default] [--limit 120]
                         [--manifest TSV --difficulty easy,medium --kind solid] [--match TEXT]

The size is Octet's own default of each part, or with a number N the part's diagonal / N; every mesher gets the same.
gmsh and hxt are Debian's `gmsh -3` without and with `-algo hxt`, netgen is Debian's python3-netgen under
/usr/bin/python3 (apt-get install gmsh python3-netgen). A mesh is `valid` by meshstat, `faithful` when meshvscad finds
every face, sharp edge and vertex of the CAD in it as well; `none` is no mesh with volume elements, `late` one out of
time. Cells hold the verdict, the number of tetrahedra, the smallest dihedral angle and the CPU seconds.
"""
import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import corpus  # noqa: E402

NETGEN = """
import sys
from netgen.NgOCC import LoadOCCGeometry
part, mesh, size = sys.argv[1:]
LoadOCCGeometry(part).GenerateMesh(maxh=float(size)).Export(mesh, "Gmsh2 Format")
"""
VERDICTS = ("faithful", "valid", "invalid", "none", "late")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    corpus.add_choice(parser)
    parser.add_argument("--octet", default="build/app/octet")
    parser.add_argument("--meshers", default="octet,gmsh,hxt,netgen")
    parser.add_argument("--size", default="default", help="default, or N for diagonal/N")
    parser.add_argument("--limit", type=float, default=120.0, help="seconds a run may take")
    parser.add_argument("--meshstat", required=True)
    parser.add_argument("--meshvscad", required=True)
    return parser.parse_args()


def command_of(args, mesher, part, mesh, size):
    gmsh = ["gmsh", "-3", "-nt", "1", "-bin", "-v", "0", "-clmax", repr(size), part, "-o", mesh]
    return {
        "octet": [args.octet, "mesh", part, "-o", mesh, "--quiet", "--threads", "1", "--size", repr(size)],
        "gmsh": gmsh,
        "hxt": gmsh + ["-algo", "hxt"],
        "netgen": ["/usr/bin/python3", "-c", NETGEN, part, mesh, repr(size)],
    }[mesher]


def size_of(args, part):
    """Edge length in millimetre, or None when Octet cannot read the part."""
    code, out, _, _ = corpus.call([args.octet, "info", part, "--json"], args.limit)
    if code != 0:
        return None
    told = json.loads(out)
    return told["default_size"] if args.size == "default" else told["diagonal"] / float(args.size)


def judged(args, mesher, part, mesh, code):
    """(verdict, smallest dihedral or None, tetrahedra)"""
    if code is None:
        return "late", None, 0
    if not os.path.exists(mesh):
        return "none", None, 0
    _, out, _, _ = corpus.call([args.meshstat, "--compact", mesh], args.limit)
    try:
        stat = json.loads(out)
    except ValueError:
        return "none", None, 0
    tets = stat["counts"]["tets"]
    if not tets:
        return "none", None, 0
    least = stat["quality"]["min_dihedral"]
    if not stat.get("valid"):
        return "invalid", least, tets
    faithful = corpus.judge_part(args, part, mesh) == "ok"
    return ("faithful" if faithful else "valid"), least, tets


def cpu_of_children():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def run(args, mesher, part, size, folder):
    """(verdict, cell)"""
    mesh = os.path.join(folder, mesher + ".msh")
    if os.path.exists(mesh):
        os.remove(mesh)
    before = cpu_of_children()
    code, _, _, _ = corpus.call(command_of(args, mesher, part, mesh, size), args.limit)
    seconds = cpu_of_children() - before
    verdict, least, tets = judged(args, mesher, part, mesh, code)
    shape = "" if least is None else f" {tets} {least:.1f} {seconds:.1f}s"
    return verdict, verdict + shape


def main():
    args = arguments()
    meshers = args.meshers.split(",")
    parts = corpus.chosen_parts(args)
    width = max((len(os.path.basename(p)) for p in parts), default=4)
    print(" | ".join(["part".ljust(width)] + [m.ljust(28) for m in meshers]))
    counts = {m: dict.fromkeys(VERDICTS, 0) for m in meshers}
    with tempfile.TemporaryDirectory() as folder:
        for part in parts:
            size = size_of(args, part)
            cells = [os.path.basename(part).ljust(width)]
            if size is None:
                print(cells[0] + " | octet info refuses it, so it has no size", flush=True)
                continue
            for mesher in meshers:
                verdict, cell = run(args, mesher, part, size, folder)
                counts[mesher][verdict] += 1
                cells.append(cell.ljust(28))
            print(" | ".join(cells).rstrip(), flush=True)
    for mesher in meshers:
        print(mesher.ljust(8), ", ".join(f"{n} {v}" for v, n in counts[mesher].items()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
