#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What finalization costs in faithfulness: each part meshed with --no-finalize and with all of it.

    tests/bench/drift.py FOLDER|FILE... [--size default|N] [--timeout 60]

One line a part: relative error of volume and of area, and the largest distance of the CAD's faces from their triangles
as a share of those triangles' edges, before and after. A line ends with `worse` where a magnitude grew by more than a
tenth of itself and is above 1e-4 (a share of 0.05). With a number N the size is the part's diagonal / N.
OCTET names the program (default: build/app/octet).
"""
import argparse
import json
import os
import subprocess
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
OCTET = os.environ.get("OCTET", os.path.join(ROOT, "build", "app", "octet"))
NOISE = {"volume": 1e-4, "area": 1e-4, "distance": 0.05}


def measured(part, flags, work, timeout):
    report = os.path.join(work, "report.json")
    try:
        run = subprocess.run([OCTET, "mesh", part, "-o", os.path.join(work, "mesh.msh"), "--quiet", "--threads", "1",
                              "--report", report, *flags], capture_output=True, timeout=timeout)
    except subprocess.TimeoutExpired:
        return None
    if run.returncode not in (0, 3):
        return None
    with open(report) as file:
        told = json.load(file)
    claims = {claim["name"]: claim for claim in told["claims"]}
    return {"status": told["status"], "volume": told["volume"]["relative_error"],
            "area": told["area"]["relative_error"], "distance": claims["surface-distance"]["worst"]}


def diagonal(part):
    told = subprocess.run([OCTET, "info", part, "--json"], capture_output=True, text=True).stdout
    return json.loads(told)["diagonal"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("parts", nargs="+")
    parser.add_argument("--size", default="default")
    parser.add_argument("--timeout", default=60.0, type=float)
    options = parser.parse_args()
    parts = []
    for name in options.parts:
        inside = sorted(os.listdir(name)) if os.path.isdir(name) else []
        parts += [os.path.join(name, file) for file in inside] if inside else [name]
    counted = worse = 0
    with tempfile.TemporaryDirectory() as work:
        for part in parts:
            if not part.lower().endswith((".step", ".stp", ".iges", ".igs", ".brep")):
                continue
            flags = [] if options.size == "default" else ["--size", repr(diagonal(part) / float(options.size))]
            before = measured(part, [*flags, "--no-finalize"], work, options.timeout)
            after = measured(part, flags, work, options.timeout)
            if before is None or after is None:
                print(f"{os.path.basename(part):32} no mesh in time", flush=True)
                continue
            grown = [name for name, noise in NOISE.items()
                     if abs(after[name]) > max(1.1 * abs(before[name]), noise)]
            counted += 1
            worse += bool(grown)
            print(f"{os.path.basename(part):32} {after['status']:10}"
                  + "".join(f" {name} {before[name]:+.1e} -> {after[name]:+.1e}" for name in NOISE)
                  + (f" worse: {', '.join(grown)}" if grown else ""), flush=True)
    print(f"{counted} parts, {worse} worse by more than a tenth")


if __name__ == "__main__":
    main()
