#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Three ways to size a mesh, on one part [Handbook, fig. 15.11]: uniform; two faces finer; by curvature.

    docs/figures/size_controls.py [--octet build/app/octet] [-o docs/size_controls.png]

Needs numpy and matplotlib.
"""
import argparse
import os
import subprocess
import tempfile

import numpy as np
from mesh_view import boundary_of, draw, save, subplots

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PART = os.path.join(ROOT, "models", "bracket.step")
SIZE = ["--size", "6"]
FINER = {"Face@60,43,6.5": "1.3", "Face@87,15,4": "1.3"}  # the wide bore and one of the bolt holes
MESHES = {
    "the same size everywhere": SIZE + ["--uniform"],
    "two faces finer": SIZE + ["--uniform"] + [f"--size-at={place}={size}" for place, size in FINER.items()],
    "16 elements on a circle": SIZE + ["--curvature", "16"],
}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--octet", default=os.path.join(ROOT, "build", "app", "octet"))
    parser.add_argument("-o", "--output", default=os.path.join(ROOT, "docs", "size_controls.png"))
    args = parser.parse_args()
    figure, panels = subplots(1, 3, figsize=(12, 3.6), dpi=100)
    with tempfile.TemporaryDirectory() as folder:
        for axes, (title, options) in zip(panels, MESHES.items()):
            mesh = os.path.join(folder, "a.vtu")
            subprocess.run([args.octet, "mesh", PART, "-o", mesh, "--quiet"] + options, check=True)
            points, triangles, _ = boundary_of(mesh)
            draw(axes, points, triangles, np.tile([0.75, 0.82, 0.92], (len(triangles), 1)))
            axes.set_title(f"{title}: {len(triangles)} triangles", fontsize=9)
    figure.tight_layout()
    save(figure, args.output)


if __name__ == "__main__":
    main()
