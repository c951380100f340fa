#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A solver on Octet's meshes beside Netgen's: errors against known answers, and iterations.

    docs/figures/solver.py [--octet build/app/octet] [--ccx ccx] [--tets 1e4,3e4,1e5,3e5] [-o docs/solver.png]

Linear elasticity by CalculiX on linear tetrahedra, two problems with exact solutions:
  cantilever  models/box.step, bent by a moment: the exact displacement is prescribed at the root z = 0, the linear
              normal stress acts on the end, the sides are free. The answer: a tip deflection of L^2 / 2 times the
              curvature.
  plate       models/plate_with_hole.step in plane strain under tension, as cut out of an infinite plate (Kirsch): the
              exact displacement on the outer sides, no displacement across the plate, the hole free. The answer: three
              times the tension at the hole.
Told are the error of the displacement (root of the mean square over the volume, as a share of the exact one's), that
of the answer (the largest stress averaged at nodes, for the plate), and the iterations of CalculiX's conjugate
gradients, with diagonal scaling and with incomplete Cholesky (nodes numbered along the longest axis). The error should
go with h^2, the number of tetrahedra to the power -2/3. The exit code is 0 when it does, within 0.1, on Octet's
meshes, and the solver takes no more iterations there than on Netgen's of as many tetrahedra, as a line through these
in the logarithms tells; Cholesky a tenth more at most.

Netgen is Debian's python3-netgen (apt-get install python3-netgen calculix-ccx python3-numpy python3-matplotlib).
"""
import os
import re
import subprocess
import sys
import tempfile

import numpy as np

import calculix

YOUNG, POISSON = 1.0, 0.3
SHEAR = YOUNG / (2 * (1 + POISSON))

# Debian's Netgen does not divide the edges of these parts when it reads them as STEP; as its own solids it does.
NETGEN = """
import sys
from netgen.csg import CSGeometry, Cylinder, OrthoBrick, Pnt
problem, mesh, size = sys.argv[1:]
solid = OrthoBrick(Pnt(0, 0, 0), Pnt(10, 20, 30))
if problem == "plate":
    solid = OrthoBrick(Pnt(0, 0, 0), Pnt(40, 30, 1)) - Cylinder(Pnt(20, 15, -1), Pnt(20, 15, 2), 6)
geometry = CSGeometry()
geometry.Add(solid)
geometry.GenerateMesh(maxh=float(size)).Export(mesh, "Gmsh2 Format")
"""

DECK = """*NODE, NSET=Nall
{nodes}
*ELEMENT, TYPE=C3D4, ELSET=Eall
{elements}
*MATERIAL, NAME=UNIT
*ELASTIC
{young}, {poisson}
*SOLID SECTION, ELSET=Eall, MATERIAL=UNIT
*STEP
*STATIC, SOLVER={solver}
*BOUNDARY
{fixed}
{loads}*NODE PRINT, NSET=Nall
U
*END STEP
"""


class Mesh:
    """Nodes, positive tetrahedra and boundary triangles of an MSH 2.2 file."""

    def __init__(self, path):
        lines = iter(open(path, encoding="ascii").read().split("\n"))
        for line in lines:
            if line == "$Nodes":
                count = int(next(lines))
                rows = np.array([next(lines).split() for _ in range(count)], dtype=float)
                number = {int(n): i for i, n in enumerate(rows[:, 0])}
                self.points = rows[:, 1:4]
            if line == "$Elements":
                words = [[int(w) for w in next(lines).split()] for _ in range(int(next(lines)))]
                tets = [[number[n] for n in w[-4:]] for w in words if w[1] == 4]
        self.tets = np.array(tets)
        self.number_along_longest_axis()
        p = self.points[self.tets]
        self.volume = np.einsum("ti,ti->t", np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), p[:, 3] - p[:, 0]) / 6
        turned = self.volume < 0
        self.tets[turned] = self.tets[turned][:, [1, 0, 2, 3]]
        self.volume = np.abs(self.volume)
        self.weight = np.zeros(len(self.points))
        np.add.at(self.weight, self.tets, np.repeat(self.volume[:, None] / 4, 4, axis=1))
        faces = np.concatenate([self.tets[:, list(f)] for f in ((0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3))])
        key, count = np.unique(np.sort(faces, axis=1), axis=0, return_counts=True)
        self.triangles = key[count == 1]

    def number_along_longest_axis(self):
        """Incomplete Cholesky depends on the numbers of the nodes: those of both meshers' follow one rule."""
        order = np.lexsort(self.points[:, np.argsort(np.ptp(self.points, axis=0))].T.round(9))
        number = np.empty_like(order)
        number[order] = np.arange(len(order))
        self.points, self.tets = self.points[order], number[self.tets]

    def shape_gradients(self):
        p = self.points[self.tets]
        inverse = np.linalg.inv(p[:, 1:] - p[:, :1])
        return np.concatenate([-inverse.sum(axis=2)[:, None, :], inverse.transpose(0, 2, 1)], axis=1)

    def stress_at_nodes(self, u):
        """Cauchy stress of the elements, averaged by volume."""
        strain = np.einsum("tki,tkj->tij", u[self.tets], self.shape_gradients())
        strain = 0.5 * (strain + strain.transpose(0, 2, 1))
        lame = 2 * SHEAR * POISSON / (1 - 2 * POISSON)
        stress = 2 * SHEAR * strain + lame * np.trace(strain, axis1=1, axis2=2)[:, None, None] * np.eye(3)
        total = np.zeros((len(self.points), 3, 3))
        for k in range(4):
            np.add.at(total, self.tets[:, k], self.volume[:, None, None] / 4 * stress)
        return total / self.weight[:, None, None]


class Cantilever:
    name, part = "cantilever", os.path.join(calculix.ROOT, "models", "box.step")
    low, high = np.zeros(3), np.array([10.0, 20.0, 30.0])
    curvature = 1e-3

    def exact(self, points):
        x, y, z = (points - 0.5 * (self.low + self.high) * [1, 1, 0]).T
        k = self.curvature
        return np.stack([-k / 2 * (z**2 + POISSON * (x**2 - y**2)), -POISSON * k * x * y, k * x * z], axis=1)

    def fixed(self, mesh):
        """Nodes and which of their displacements are prescribed."""
        return [(n, (0, 1, 2)) for n in np.flatnonzero(mesh.points[:, 2] < 1e-9)]

    def loads(self, mesh):
        """The consistent nodal forces of a traction that is linear on each triangle."""
        on_end = mesh.triangles[(mesh.points[mesh.triangles][:, :, 2] > self.high[2] - 1e-9).all(axis=1)]
        p = mesh.points[on_end]
        area = 0.5 * np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1)
        traction = YOUNG * self.curvature * (p[:, :, 0] - 0.5 * (self.low[0] + self.high[0]))
        force = np.zeros(len(mesh.points))
        np.add.at(force, on_end, area[:, None] / 12 * (traction + traction.sum(axis=1)[:, None]))
        return [(n, 2, force[n]) for n in np.unique(on_end)]

    def answer(self, mesh, u):
        tip = np.argmin(np.linalg.norm(mesh.points - self.high, axis=1))
        return u[tip, 0] / self.exact(mesh.points[tip:tip + 1])[0, 0]


class Plate:
    name, part = "plate", os.path.join(calculix.ROOT, "models", "plate_with_hole.step")
    low, high, centre, radius = np.zeros(3), np.array([40.0, 30.0, 1.0]), np.array([20.0, 15.0, 0.0]), 6.0
    tension = 1e-3

    def exact(self, points):
        x, y, _ = (points - self.centre).T
        r, t = np.hypot(x, y) / self.radius, np.arctan2(y, x)
        c = 3 - 4 * POISSON
        scale = self.radius * self.tension / (8 * SHEAR)
        ux = r * (c + 1) * np.cos(t) + 2 / r * ((1 + c) * np.cos(t) + np.cos(3 * t)) - 2 / r**3 * np.cos(3 * t)
        uy = r * (c - 3) * np.sin(t) + 2 / r * ((1 - c) * np.sin(t) + np.sin(3 * t)) - 2 / r**3 * np.sin(3 * t)
        return scale * np.stack([ux, uy, 0 * ux], axis=1)

    def fixed(self, mesh):
        p = mesh.points
        sides = ((p[:, :2] < 1e-9) | (p[:, :2] > self.high[:2] - 1e-9)).any(axis=1)
        across = (p[:, 2] < 1e-9) | (p[:, 2] > self.high[2] - 1e-9)
        return [(n, (0, 1, 2) if sides[n] else (2,)) for n in np.flatnonzero(sides | across)]

    def loads(self, mesh):
        return []

    def answer(self, mesh, u):
        return mesh.stress_at_nodes(u)[:, 0, 0].max() / (3 * self.tension)


def solve(ccx, folder, mesh, problem, solver):
    """Displacements, and the iterations."""
    exact = problem.exact(mesh.points)
    rows = lambda first, table, form: "\n".join(  # noqa: E731
        ", ".join([str(i + first)] + [form(x) for x in row]) for i, row in enumerate(table))
    fixed = problem.fixed(mesh)
    loads = "".join(f"{n + 1}, {axis + 1}, {force:.12e}\n" for n, axis, force in problem.loads(mesh))
    deck = DECK.format(
        nodes=rows(1, mesh.points, lambda x: f"{x:.12e}"), elements=rows(1, mesh.tets + 1, str), young=YOUNG,
        poisson=POISSON, solver=solver, loads="*CLOAD\n" + loads if loads else "",
        fixed="\n".join(f"{n + 1}, {a + 1}, {a + 1}, {exact[n, a]:.12e}" for n, axes in fixed for a in axes))
    u, told = calculix.solve(ccx, folder, deck, len(mesh.points), 3)
    iterations = [int(n) for n in re.findall(r"iteration=\s*(\d+)", told)]
    if not iterations:
        raise RuntimeError("CalculiX told no iterations:\n" + told[-2000:])
    return u, max(iterations)


def run_mesher(args, name, problem, size, path):
    if name == "octet":
        command = [args.octet, "mesh", problem.part, "-o", path, "--size", repr(size), "--format", "msh22-ascii", "--quiet"]
    else:
        command = ["/usr/bin/python3", "-c", NETGEN, problem.name, path, repr(size)]
    subprocess.run(command, check=True, capture_output=True)
    return Mesh(path)


def meshed(args, name, problem, tets, folder):
    """A mesh of about so many tetrahedra."""
    volume = np.prod(problem.high - problem.low)
    size = (8 * volume / tets) ** (1 / 3)
    for _ in range(4):
        mesh = run_mesher(args, name, problem, size, os.path.join(folder, "mesh.msh"))
        share = len(mesh.tets) / tets
        if 0.8 < share < 1.25:
            break
        size *= min(max(share ** (1 / 3), 0.5), 2.0)
    return mesh


def line(rows, column):
    return calculix.line([(row["tets"], row[column]) for row in rows])


def order(rows):
    """Of the error, in the mesh size."""
    return -3 * line(rows, "error")[0]


def plot(path, results):
    from mesh_view import save, subplots

    figure, axes = subplots(1, 2, figsize=(8.4, 3.6), dpi=110)
    for (problem, mesher), rows in results.items():
        look = {"marker": "o" if mesher == "octet" else "s", "markersize": 4,
                "linestyle": "-" if problem == "cantilever" else "--",
                "color": "tab:blue" if mesher == "octet" else "tab:orange", "label": f"{problem}, {mesher}"}
        tets = [row["tets"] for row in rows]
        axes[0].loglog(tets, [row["error"] for row in rows], **look)
        axes[1].loglog(tets, [row["scaling"] for row in rows], **look)
    first = next(iter(results.values()))
    ends = np.array([first[0]["tets"], first[-1]["tets"]])
    axes[0].loglog(ends, 0.5 * first[0]["error"] * (ends / ends[0]) ** (-2 / 3), ":", color="gray", label="$h^2$")
    axes[0].set(xlabel="tetrahedra", ylabel="error of the displacement")
    axes[1].set(xlabel="tetrahedra", ylabel="iterations, diagonal scaling")
    for a in axes:
        a.grid(True, which="both", linewidth=0.3)
        a.legend(fontsize=7)
    figure.tight_layout()
    save(figure, path)


def main():
    parser = calculix.arguments(__doc__)
    parser.add_argument("--tets", default="1e4,3e4,1e5,3e5")
    args = parser.parse_args()
    results, good = {}, True
    print("| problem | mesher | tetrahedra | error of displacement | answer over exact | iterations: scaling | Cholesky |\n"
          "|---|---|---|---|---|---|---|")
    for problem in (Cantilever(), Plate()):
        for mesher in ("octet", "netgen"):
            rows = results[problem.name, mesher] = []
            for tets in (float(t) for t in args.tets.split(",")):
                with tempfile.TemporaryDirectory() as folder:
                    mesh = meshed(args, mesher, problem, tets, folder)
                    u, scaling = solve(args.ccx, folder, mesh, problem, "ITERATIVE SCALING")
                    _, cholesky = solve(args.ccx, folder, mesh, problem, "ITERATIVE CHOLESKY")
                exact = problem.exact(mesh.points)
                mean = lambda v: np.sqrt(np.sum(mesh.weight * np.sum(v**2, axis=1)))  # noqa: E731
                row = {"tets": len(mesh.tets), "error": mean(u - exact) / mean(exact), "scaling": scaling,
                       "cholesky": cholesky, "answer": problem.answer(mesh, u)}
                rows.append(row)
                print(f"| {problem.name} | {mesher} | {row['tets']} | {row['error']:.2e} | {row['answer']:.4f} | "
                      f"{scaling} | {cholesky} |", flush=True)
    for problem in ("cantilever", "plate"):
        ours, theirs = results[problem, "octet"], results[problem, "netgen"]
        shares = {c: np.mean([row[c] / np.exp(np.polyval(line(theirs, c), np.log(row["tets"]))) for row in ours])
                  for c in ("scaling", "cholesky")}
        print(f"{problem}: error goes with h^{order(ours):.2f} (Netgen h^{order(theirs):.2f}); iterations over "
              f"Netgen's: {shares['scaling']:.2f} with scaling, {shares['cholesky']:.2f} with Cholesky")
        good = good and order(ours) > 1.9 and shares["scaling"] <= 1.0 and shares["cholesky"] <= 1.1
    if args.output:
        plot(args.output, results)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
