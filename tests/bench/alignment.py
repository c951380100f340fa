#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 15.10 of [Handbook] again: one part aligned with the octree and turned by 30 degrees, before finalization,
with smoothing alone, with short edges collapsed too, and with all of it.

    tests/bench/alignment.py [PART] [--size 5] [--picture docs/alignment.png]

Prints the smallest and the largest dihedral angle of each of the eight meshes beside the handbook's figures. Debian's
`gmsh` turns the part; --picture needs matplotlib. OCTET names the program (default: build/app/octet).
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
OCTET = os.environ.get("OCTET", os.path.join(ROOT, "build", "app", "octet"))
COLUMNS = [("before", ["--no-finalize"]), ("smoothing", ["--finalize", "smoothing"]),
           ("and short edges", ["--finalize", "nicks"]), ("all", ["--finalize", "all"])]
# Smallest and largest angle; of "before" the text gives the largest alone.
HANDBOOK = {"before": (None, 179.9), "smoothing": (1.23, 169.0), "and short edges": (6.7, 169.0), "all": (11.0, 145.0)}


def turned(part, work):
    script, out = os.path.join(work, "turn.geo"), os.path.join(work, "turned.step")
    with open(script, "w") as file:
        file.write(f'SetFactory("OpenCASCADE");\nv() = ShapeFromFile("{os.path.abspath(part)}");\n'
                   f'Rotate {{{{1, 0, 0}}, {{0, 0, 0}}, Pi / 6}} {{ Volume{{v()}}; }}\nSave "{out}";\n')
    subprocess.run(["gmsh", "-0", "-v", "0", script], check=True, stdout=subprocess.DEVNULL)
    return out


def meshed(part, size, options, mesh):
    """Angles by the report: before finalization flat elements may be turned by rounding, which `octet quality` refuses."""
    report = mesh + ".json"
    run = subprocess.run([OCTET, "mesh", part, "-o", mesh, "--format", "msh22-ascii", "--size", str(size), "--quiet",
                          "--report", report, *options], capture_output=True, text=True)
    if run.returncode not in (0, 3):
        sys.exit(run.stderr)
    with open(report) as file:
        told = json.load(file)
    return told["quality"]["min_dihedral"], told["quality"]["max_dihedral"], told["tets"]


def surface(mesh):
    """Points and triangles of an ASCII MSH 2.2 file."""
    with open(mesh) as file:
        lines = file.read().split("\n")
    begin = lines.index("$Nodes")
    points = {}
    for line in lines[begin + 2:begin + 2 + int(lines[begin + 1])]:
        number, *place = line.split()
        points[int(number)] = tuple(map(float, place))
    begin = lines.index("$Elements")
    words = (list(map(int, line.split())) for line in lines[begin + 2:begin + 2 + int(lines[begin + 1])])
    return points, [w[3 + w[2]:] for w in words if w[1] == 2]


def draw(axes, mesh, turn):
    """The surface, seen from the same side of the part whichever way it is turned."""
    from math import cos, pi, sin
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection
    points, triangles = surface(mesh)
    angle = -pi / 6 if turn else 0.0
    back = {n: (x, cos(angle) * y - sin(angle) * z, sin(angle) * y + cos(angle) * z) for n, (x, y, z) in points.items()}
    axes.add_collection3d(Poly3DCollection([[back[n] for n in t] for t in triangles], facecolor="#c9d8e8",
                                           edgecolor="#203040", linewidth=0.2))
    spans = [(min(p[k] for p in back.values()), max(p[k] for p in back.values())) for k in range(3)]
    axes.set(xlim=spans[0], ylim=spans[1], zlim=spans[2])
    axes.set_box_aspect([hi - lo for lo, hi in spans])
    axes.view_init(28, -58)
    axes.set_axis_off()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("part", nargs="?", default=os.path.join(ROOT, "models", "bracket.step"))
    parser.add_argument("--size", type=float, default=5.0)
    parser.add_argument("--picture")
    options = parser.parse_args()
    if options.picture:
        import matplotlib
        matplotlib.use("Agg")
        from matplotlib import pyplot
        figure = pyplot.figure(figsize=(10, 5.4))
    with tempfile.TemporaryDirectory() as work:
        print(f"{'':10}" + "".join(f"{name:>18}" for name, _ in COLUMNS))
        for row, (name, part) in enumerate([("aligned", options.part), ("turned", turned(options.part, work))]):
            cells = []
            for column, (title, flags) in enumerate(COLUMNS):
                mesh = os.path.join(work, "mesh.msh")
                least, largest, tets = meshed(part, options.size, flags, mesh)
                cells.append(f"{least:9.2f} {largest:7.2f} ")
                if options.picture:
                    axes = figure.add_subplot(2, 4, 4 * row + column + 1, projection="3d")
                    draw(axes, mesh, row == 1)
                    axes.set_title(f"{name}, {title}\n{least:.1f} to {largest:.1f} degrees, {tets} tets", fontsize=7)
            print(f"{name:10}" + "".join(f"{cell:>18}" for cell in cells), flush=True)
        cells = [f"{'' if low is None else f'{low:.2f}':>9} {high:7.2f} " for low, high in HANDBOOK.values()]
        print(f"{'handbook':10}" + "".join(f"{cell:>18}" for cell in cells))
    if options.picture:
        figure.subplots_adjust(0.0, 0.0, 1.0, 0.92, 0.0, 0.15)
        figure.savefig(options.picture, dpi=100)
        from PIL import Image  # which matplotlib needs, too
        Image.open(options.picture).convert("RGB").quantize(16).save(options.picture, optimize=True)


if __name__ == "__main__":
    main()
