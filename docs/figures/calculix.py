# SPDX-License-Identifier: BSD-3-Clause
"""What scripts that solve with CalculiX share: their arguments, a run of it, the power a curve goes with."""
import argparse
import os
import subprocess

import numpy as np

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def arguments(description):
    """A parser with --octet, --ccx and --output."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--octet", type=os.path.abspath, default=os.path.join(ROOT, "build", "app", "octet"))
    parser.add_argument("--ccx", default="ccx")
    parser.add_argument("-o", "--output", help="PNG to write")
    return parser


def solve(ccx, folder, deck, nodes, components):
    """Values printed for all nodes, nodes x components, and what CalculiX told."""
    with open(os.path.join(folder, "solve.inp"), "w", encoding="ascii") as file:
        file.write(deck)
    told = subprocess.run([ccx, "solve"], cwd=folder, capture_output=True, text=True).stdout
    values = np.full((nodes, components), np.nan)
    with open(os.path.join(folder, "solve.dat"), encoding="ascii") as file:
        for words in map(str.split, file):
            if len(words) == components + 1 and words[0].isdigit():
                values[int(words[0]) - 1] = [float(w) for w in words[1:]]
    if np.isnan(values).any():
        raise RuntimeError("CalculiX gave no answer at some nodes:\n" + told[-2000:])
    return values, told


def line(pairs):
    """Power and factor's logarithm of the power law through (x, y) by least squares of the logarithms."""
    x, y = np.log(np.array(pairs, dtype=float)).T
    return np.polyfit(x, y, 1)
