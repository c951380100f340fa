#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Assemblies of many solids that touch, to see how cost grows with their number.

    tests/bench/assembly.py bolted N OUT.step     two plates, and N x N bolts and washers (2 N^2 + 2 solids)
    tests/bench/assembly.py boxes N OUT.step      N x N rounded boxes side by side (26 N^2 faces)
    tests/bench/assembly.py plate N OUT.step      one plate with N x N holes

Needs FreeCAD's Python modules (apt-get install freecad-python3)."""

import argparse
import glob
import sys

sys.path += glob.glob("/usr/lib/freecad*/lib")
import FreeCAD  # noqa: E402
import Part  # noqa: E402

V = FreeCAD.Vector


def grid(n, pitch):
    return [V((i + 0.5) * pitch, (j + 0.5) * pitch, 0) for i in range(n) for j in range(n)]


def moved(shape, way):
    copy = shape.copy()
    copy.translate(way)
    return copy


def plate(n, pitch, radius, thickness):
    holes = [Part.makeCylinder(radius, thickness, place) for place in grid(n, pitch)]
    return Part.makeBox(n * pitch, n * pitch, thickness).cut(holes)


def bolt():
    shaft = Part.makeCylinder(6, 16)
    head = Part.makeCylinder(10, 6, V(0, 0, 16)).common(Part.makeBox(17, 17, 6, V(-8.5, -8.5, 16)))
    whole = shaft.fuse(head).removeSplitter()
    return whole.cut(Part.makeCylinder(3, 5, V(0, 0, 17))).cut(Part.makeBox(1.5, 14, 2, V(-0.75, -7, 20.5)))


def washer():
    ring = Part.makeCylinder(9, 2, V(0, 0, -2)).cut(Part.makeCylinder(6, 2, V(0, 0, -2)))
    below = [e for e in ring.Edges if len(e.Vertexes) == 1 and abs(e.BoundBox.ZMax + 2) < 1e-6]
    return ring.makeFillet(0.5, below)


def bolted(n):
    pitch = 30.0
    one = plate(n, pitch, 6, 8)
    solids = [one, moved(one, V(0, 0, 8))]
    for place in grid(n, pitch):
        solids += [moved(bolt(), place), moved(washer(), place)]
    return Part.makeCompound(solids)


def boxes(n):
    box = Part.makeBox(20, 20, 10)
    box = box.makeFillet(1, box.Edges)
    return Part.makeCompound([moved(box, place) for place in grid(n, 25.0)])


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    kinds = {"bolted": bolted, "boxes": boxes, "plate": lambda n: plate(n, 10.0, 3, 3)}
    parser.add_argument("kind", choices=kinds)
    parser.add_argument("n", type=int)
    parser.add_argument("out")
    options = parser.parse_args()
    shape = kinds[options.kind](options.n)
    shape.exportStep(options.out)
    print(f"{options.out}: {len(shape.Solids)} solids, {len(shape.Faces)} faces")


if __name__ == "__main__":
    main()
