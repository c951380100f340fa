#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What finalization costs in faithfulness: each part meshed with --no-finalize and with all of it.

    tests/bench/drift.py FOLDER|FILE... [--size default|N] [--timeout 60] [--meshvscad PATH]

One line a part: relative error of volume; of area, the sum of the faces' errors, which do not cancel out; and the
largest distance of the CAD's faces from their triangles as a share of the part's diagonal; before and after. A line
ends with `worse` where a magnitude grew by more than a tenth of itself and is above 1e-4 (of the diagonal: 1e-5). With
a number N the size is the part's diagonal / N. Octet samples a face a few times a triangle; a program that prints
`hausdorff_estimate` as JSON, asked with part and mesh, may tell the distance instead (--meshvscad).
OCTET names the program (default: build/app/octet).
"""
import argparse
import json
import os
import subprocess
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
OCTET = os.environ.get("OCTET", os.path.join(ROOT, "build", "app", "octet"))
NOISE = {"volume": 1e-4, "area": 1e-4, "distance": 1e-5}


def measured(part, flags, work, options):
    mesh = os.path.join(work, "mesh.msh")
    report = os.path.join(work, "report.json")
    try:
        run = subprocess.run([OCTET, "mesh", part, "-o", mesh, "--quiet", "--threads", "1",
                              "--report", report, *flags], capture_output=True, timeout=options.timeout)
    except subprocess.TimeoutExpired:
        return None
    if run.returncode not in (0, 3):
        return None
    with open(report) as file:
        told = json.load(file)
    distance = told.get("distance", {"largest": 0.0})["largest"]
    if options.meshvscad:
        judged = subprocess.run([options.meshvscad, part, mesh], capture_output=True, text=True).stdout
        distance = json.loads(judged)["hausdorff_estimate"]
    return {"status": told["status"], "volume": told["volume"]["relative_error"],
            "area": told["area"]["faces_relative_error"], "distance": distance / told["diagonal"]}


def diagonal(part):
    told = subprocess.run([OCTET, "info", part, "--json"], capture_output=True, text=True).stdout
    return json.loads(told)["diagonal"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("parts", nargs="+")
    parser.add_argument("--size", default="default")
    parser.add_argument("--timeout", default=60.0, type=float)
    parser.add_argument("--meshvscad")
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
            before = measured(part, [*flags, "--no-finalize"], work, options)
            after = measured(part, flags, work, options)
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
