#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The a-posteriori loop: solve, estimate, adapt. Plots error against unknowns for uniform and adapted meshes.

    docs/figures/adapt_loop.py [--octet build/app/octet] [--ccx ccx] [--unknowns 60000] [-o docs/adapt_loop.png]

The problem: Laplace's equation (steady heat) on models/l_domain.step, whose re-entrant edge is the z axis. The
temperature on the walls along z is that of u = r^(2/3) sin(2 phi / 3), which solves the problem and whose gradient
is infinite on that edge; the ends are insulated. CalculiX solves on linear tetrahedra. The error is the true one,
the norm of the gradient's, by quadrature. The sizes follow from the estimate of Zienkiewicz and Zhu (1987): the
gradient averaged at the nodes against that of the elements; an element's wanted size is its own times a power of
its share of the error. `octet adapt` meshes anew with these, into two to four times the elements, for of the sizes
that meet an octant the smallest counts.

Needs numpy, matplotlib and CalculiX (ccx).
"""
import os
import sys
import tempfile

import numpy as np

import calculix

sys.path.append(os.path.join(calculix.ROOT, "plugins", "python"))
import octet

PART = os.path.join(calculix.ROOT, "models", "l_domain.step")
RADIUS = 10.0  # of the part: half its width

DECK = """*NODE, NSET=Nall
{nodes}
*ELEMENT, TYPE=C3D4, ELSET=Eall
{tets}
*MATERIAL, NAME=UNIT
*CONDUCTIVITY
1.
*SOLID SECTION, ELSET=Eall, MATERIAL=UNIT
*INITIAL CONDITIONS, TYPE=TEMPERATURE
Nall, 0.
*STEP
*HEAT TRANSFER, STEADY STATE
*BOUNDARY
{walls}
*NODE PRINT, NSET=Nall
NT
*END STEP
"""


def polar(points):
    """Radius, and the angle in the domain, 0 to 3 pi / 2; the cut is in the middle of what is not in it."""
    x, y = points[..., 0] / RADIUS, points[..., 1] / RADIUS
    return np.hypot(x, y), np.mod(np.arctan2(y, x) + np.pi / 4, 2 * np.pi) - np.pi / 4


def exact(points):
    r, phi = polar(points)
    return r ** (2 / 3) * np.sin(2 * phi / 3)


def exact_gradient(points):
    r, phi = polar(points)
    steep = 2 / 3 * np.maximum(r, 1e-12) ** (-1 / 3) / RADIUS
    return np.stack([-steep * np.sin(phi / 3), steep * np.cos(phi / 3), 0 * r], axis=-1)


class Mesh:
    """What a linear element's solver needs of an octet.Mesh."""

    def __init__(self, mesh):
        self.mesh, self.points, self.tets = mesh, mesh.points, mesh.tets
        corners = self.points[self.tets]
        sides = corners[:, 1:] - corners[:, :1]
        self.volume = np.linalg.det(sides) / 6
        inverse = np.linalg.inv(sides)  # columns: gradients of the last three shape functions
        self.shape_gradient = np.concatenate([-inverse.sum(axis=2, keepdims=True), inverse], axis=2)
        pairs = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)]
        self.size = np.mean([np.linalg.norm(corners[:, a] - corners[:, b], axis=1) for a, b in pairs], axis=0)

    def walls(self):
        """Nodes on the faces along z."""
        of_faces = [self.mesh.nodes((2, tag)) for tag in np.unique(self.mesh.triangle_on)]
        return np.unique(np.concatenate([n for n in of_faces if np.ptp(self.points[n, 2]) > 0]))

    def gradient(self, values):
        return np.einsum("tdk,tk->td", self.shape_gradient, values[self.tets])

    def true_error(self, values):
        """Elements at the edge are cut into 512 for the quadrature, others into 8."""
        gradient = self.gradient(values)
        near = np.hypot(*self.points[self.tets].mean(axis=1)[:, :2].T) < 3 * self.size
        total = 0.0
        for chosen, cuts in ((near, 3), (~near, 1)):
            corners, g, volume = self.points[self.tets[chosen]], gradient[chosen], self.volume[chosen]
            for _ in range(cuts):
                corners, g = halved(corners), np.repeat(g, 8, axis=0)
                volume = np.repeat(volume / 8, 8)
            a = 0.5854101966249685  # the rule of degree 2
            for k in range(4):
                weights = np.full(4, (1 - a) / 3)
                weights[k] = a
                place = np.einsum("k,tkd->td", weights, corners)
                total += np.sum(volume / 4 * np.sum((exact_gradient(place) - g) ** 2, axis=1))
        return np.sqrt(total)

    def estimate(self, values):
        """Per element the norm of what the averaged gradient differs by."""
        gradient = self.gradient(values)
        weight, mean = np.zeros(len(self.points)), np.zeros((len(self.points), 3))
        for k in range(4):
            np.add.at(weight, self.tets[:, k], self.volume)
            np.add.at(mean, self.tets[:, k], self.volume[:, None] * gradient)
        d = (mean / weight[:, None])[self.tets] - gradient[:, None]
        return np.sqrt(self.volume / 20 * (np.sum(d**2, axis=(1, 2)) + np.sum(d.sum(axis=1) ** 2, axis=1)))

    def wanted_sizes(self, error, more):
        """Sizes for the least error at `more` times the elements: its density goes with a power of the size."""
        share = (np.mean(error) / np.maximum(error, 1e-3 * np.mean(error))) ** (2 / 5)
        scale = 1.0
        for _ in range(50):
            sizes = self.size * np.clip(scale * share, 0.25, 2.0)
            scale *= (np.sum((self.size / sizes) ** 3) / (more * len(self.tets))) ** (1 / 3)
        return sizes


def halved(corners):
    """Each tetrahedron as eight of an eighth of its volume."""
    a, b, c, d = (corners[:, k] for k in range(4))
    ab, ac, ad, bc, bd, cd = (0.5 * (p + q) for p, q in ((a, b), (a, c), (a, d), (b, c), (b, d), (c, d)))
    parts = ((a, ab, ac, ad), (ab, b, bc, bd), (ac, bc, c, cd), (ad, bd, cd, d),
             (ab, ac, ad, cd), (ab, ad, bd, cd), (ab, bd, bc, cd), (ab, bc, ac, cd))
    return np.stack([np.stack(p, axis=1) for p in parts], axis=1).reshape(-1, 4, 3)


def solve(ccx, folder, mesh):
    walls = mesh.walls()
    nodes = [f"{n}, {x:.12g}, {y:.12g}, {z:.12g}" for n, (x, y, z) in enumerate(mesh.points, 1)]
    tets = [f"{n}, " + ", ".join(str(v + 1) for v in tet) for n, tet in enumerate(mesh.tets, 1)]
    fixed = [f"{n + 1}, 11, 11, {u:.9e}" for n, u in zip(walls, exact(mesh.points[walls]))]
    deck = DECK.format(nodes="\n".join(nodes), tets="\n".join(tets), walls="\n".join(fixed))
    values = calculix.solve(ccx, folder, deck, len(mesh.points), 1)[0][:, 0]
    values[walls] = exact(mesh.points[walls])
    return values


def solved(args, folder, mesh):
    mesh = Mesh(mesh)
    values = solve(args.ccx, folder, mesh)
    return mesh, values, len(mesh.points) - len(mesh.walls()), mesh.true_error(values)


def uniform(args, folder):
    found, size = [], 3.0
    while not found or found[-1][0] < args.unknowns:
        _, _, unknowns, error = solved(args, folder, octet.mesh(PART, size, uniform=True))
        print(f"uniform   size {size:6.3f}  unknowns {unknowns:7d}  error {error:.5f}", flush=True)
        found.append((unknowns, error))
        size /= 2**0.5
    return found


def adapted(args, folder):
    found, made = [], octet.mesh(PART, 3.0, uniform=True)
    while not found or found[-1][0] < args.unknowns:
        mesh, values, unknowns, error = solved(args, folder, made)
        estimate = mesh.estimate(values)
        print(f"adapted   size {mesh.size.min():6.3f}  unknowns {unknowns:7d}  error {error:.5f}  "
              f"estimated {np.linalg.norm(estimate):.5f}", flush=True)
        found.append((unknowns, error))
        made = octet.adapt(made, PART, mesh.wanted_sizes(estimate, 1.2), uniform=True)
    return found


def slope(found):
    """Of the second half of the points."""
    return calculix.line(found[len(found) // 2:])[0]


def plot(path, results):
    from mesh_view import save, subplots

    figure, axes = subplots(figsize=(5.2, 3.8), dpi=110)
    for (name, found), mark in zip(results.items(), ("s-", "o-")):
        axes.loglog(*zip(*found), mark, label=f"{name}: slope {slope(found):.2f}", markersize=4)
    axes.set(xlabel="unknowns", ylabel="error of the gradient", title="L-shaped domain, CalculiX")
    axes.grid(True, which="both", linewidth=0.3)
    axes.legend()
    figure.tight_layout()
    save(figure, path)


def main():
    parser = calculix.arguments(__doc__)
    parser.add_argument("--unknowns", type=int, default=60000, help="end with the first mesh of so many")
    args = parser.parse_args()
    os.environ["OCTET"] = args.octet
    results = {}
    for name, run in (("uniform", uniform), ("adapted", adapted)):
        with tempfile.TemporaryDirectory() as folder:
            results[name] = run(args, folder)
    for name, found in results.items():
        print(f"{name}: error goes with unknowns^{slope(found):.3f}")
    if args.output:
        plot(args.output, results)
    return 0 if slope(results["adapted"]) < slope(results["uniform"]) - 0.05 else 1


if __name__ == "__main__":
    sys.exit(main())
