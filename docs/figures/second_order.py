#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a solver makes of elements of second order: curved, straight-sided, and of first order.

    docs/figures/second_order.py [--octet build/app/octet] [--ccx ccx] [--sizes 2,1.4,1,0.7] [-o docs/second_order.png]

CalculiX on models/plate_with_hole.step in plane strain under tension, as cut out of an infinite plate (Kirsch): the
exact displacement on the outer sides, no displacement across the plate, the hole free. Octet's INP files as they are,
of first order, of second order, and of second order with every node put back into the middle of its straight edge, as
meshers do that know nothing of the CAD any more. Told is the error of the displacement (root of the mean square over
the nodes, as a share of the exact one's). The exit code is 0 when it goes with the size (the number of elements to the
power -1/3) to the power 1.9 and more of first order, 2.7 and more of second, and straight sides double it at least.

apt-get install calculix-ccx python3-numpy python3-matplotlib
"""
import os
import re
import subprocess
import sys
import tempfile

import numpy as np

import calculix
from solver import POISSON, YOUNG, Plate

DECK = """*INCLUDE, INPUT=mesh.inp
*MATERIAL, NAME=UNIT
*ELASTIC
{young}, {poisson}
*SOLID SECTION, ELSET={region}, MATERIAL=UNIT
*STEP
*STATIC, SOLVER=SPOOLES
*BOUNDARY
{fixed}
*NODE PRINT, NSET=Nall
U
*END STEP
"""


class Inp:
    """Nodes and elements of an INP file; its text, for CalculiX to read."""

    def __init__(self, path):
        self.text = open(path, encoding="ascii").read()
        blocks = re.split(r"^\*", self.text, flags=re.M)
        rows = lambda block: [[float(w) for w in line.split(",")] for line in block.split("\n")[1:] if line]  # noqa: E731
        self.points = np.array(next(rows(b) for b in blocks if b.startswith("NODE,")))[:, 1:]
        elements = next(b for b in blocks if b.startswith("ELEMENT,"))
        self.region = re.search(r"ELSET=(\S+)", elements).group(1)
        self.elements = np.array(rows(elements), dtype=int)[:, 1:] - 1

    def straighten(self):
        """Nodes into the middles of their corners: 1-2, 2-3, 3-1, 1-4, 2-4, 3-4."""
        for k, (a, b) in enumerate(((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))):
            ends = self.points[self.elements[:, a]] + self.points[self.elements[:, b]]
            self.points[self.elements[:, 4 + k]] = 0.5 * ends
        nodes = "\n".join(f"{i + 1}, {p[0]:.12e}, {p[1]:.12e}, {p[2]:.12e}" for i, p in enumerate(self.points))
        self.text = re.sub(r"(\*NODE, NSET=Nall\n)[^*]*", lambda m: m.group(1) + nodes + "\n", self.text, count=1)


def error_of(args, problem, size, kind):
    """Elements, and the error of the displacement."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "mesh.inp")
        subprocess.run([args.octet, "mesh", problem.part, "-o", path, "--size", repr(size), "--uniform", "--quiet",
                        "--order", "1" if kind == "first" else "2"], check=True)
        mesh = Inp(path)
        if kind == "straight":
            mesh.straighten()
            with open(path, "w", encoding="ascii") as file:
                file.write(mesh.text)
        exact = problem.exact(mesh.points)
        deck = DECK.format(young=YOUNG, poisson=POISSON, region=mesh.region, fixed="\n".join(
            f"{n + 1}, {a + 1}, {a + 1}, {exact[n, a]:.12e}" for n, axes in problem.fixed(mesh) for a in axes))
        u, _ = calculix.solve(args.ccx, folder, deck, len(mesh.points), 3)
    return len(mesh.elements), np.sqrt(np.sum((u - exact)**2) / np.sum(exact**2))


LABEL = {"first": "first order", "straight": "second order, straight edges", "curved": "second order, on the CAD"}


def plot(path, sizes, results):
    from mesh_view import save, subplots

    figure, axes = subplots(1, 1, figsize=(4.6, 3.6), dpi=110)
    for kind, colour in (("first", "tab:orange"), ("straight", "tab:gray"), ("curved", "tab:blue")):
        axes.loglog(sizes, [error for _, error in results[kind]], "o-", markersize=4, color=colour, label=LABEL[kind])
    axes.set(xlabel="size, mm", ylabel="error of the displacement")
    axes.minorticks_off()
    axes.set_xticks(sizes, [f"{size:g}" for size in sizes])
    axes.grid(True, linewidth=0.3)
    axes.legend(fontsize=7)
    figure.tight_layout()
    save(figure, path)


def main():
    parser = calculix.arguments(__doc__)
    parser.add_argument("--sizes", default="2,1.4,1,0.7")
    args = parser.parse_args()
    sizes = [float(s) for s in args.sizes.split(",")]
    problem, results, power = Plate(), {}, {}
    print("| elements | how many | error of the displacement | power of the size |\n|---|---|---|---|")
    for kind, label in LABEL.items():
        rows = results[kind] = [error_of(args, problem, size, kind) for size in sizes]
        power[kind] = -3 * calculix.line(rows)[0]
        print(f"| {label} | {', '.join(str(n) for n, _ in rows)} | {', '.join(f'{e:.2e}' for _, e in rows)} | "
              f"{power[kind]:.2f} |", flush=True)
    if args.output:
        plot(args.output, sizes, results)
    last = {kind: rows[-1][1] for kind, rows in results.items()}
    return 0 if power["first"] > 1.9 and power["curved"] > 2.7 and last["straight"] > 2 * last["curved"] else 1


if __name__ == "__main__":
    sys.exit(main())
