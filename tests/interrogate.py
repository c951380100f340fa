#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Asks the geometry of every part of a folder, the fast way and slowly, and prints one table.

    tests/interrogate.py FOLDER|FILE... [--program build/tests/geom/occt/octet_interrogate] [--limit 120]
                         [--segments 20000] [--points 1000] [--match WORD] [--manifest TSV --difficulty .. --kind ..]

Segments: Model::intersect against every surface asked without facets. Points: Model::region_at against OCCT's
solid classifier; where they differ, winding numbers of a fine triangulation decide who is right. The exit code
is 0 when nothing was missed, nothing was extra, and wherever the classifier differs it is the one in error.
"""
import argparse
import json
import os
import subprocess
import sys

from corpus import add_choice, chosen_parts


VERDICTS = ("ours_right", "within_tolerance", "theirs_right", "neither", "undecided")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_choice(parser)
    parser.add_argument("--program", default="build/tests/geom/occt/octet_interrogate")
    parser.add_argument("--limit", type=float, default=120.0, help="seconds a part may take")
    parser.add_argument("--segments", type=int, default=20000)
    parser.add_argument("--points", type=int, default=1000)
    return parser.parse_args()


def ask(path, args):
    command = [args.program, path, str(args.segments), str(args.points), str(0.35 * args.limit)]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=args.limit, check=False)
    except subprocess.TimeoutExpired:
        return {"refused": f"no answer in {args.limit:g} s"}
    lines = [line for line in done.stdout.splitlines() if line.startswith("{")]
    if not lines:
        return {"refused": f"ended with {done.returncode}"}
    return json.loads(lines[-1])


def main():
    args = arguments()
    totals = dict.fromkeys(("parts", "segments", "hits", "missed", "extra", "points", "differ", *VERDICTS), 0)
    print(f"{'part':34} {'faces':>6} {'segments':>8} {'hits':>7} {'missed':>6} {'extra':>5} {'cracks':>6} "
          f"{'points':>6} {'differ':>6} {'on':>3}  places", flush=True)
    for path in chosen_parts(args):
        name = os.path.basename(path)
        result = ask(path, args)
        if "refused" in result:
            print(f"{name:34} refused: {result['refused'][:120]}", flush=True)
            continue
        rays, sides = result["rays"], result["sides"]
        places = rays["places"] + sides["places"]
        print(f"{name:34} {result['faces']:6} {rays['segments']:8} {rays['hits']:7} {rays['missed']:6} "
              f"{rays['extra']:5} {rays['cracks']:6} {sides['points']:6} {sides['differ']:6} {sides['on']:3}  "
              f"{json.dumps(sides['verdicts']) if sides['verdicts'] else ''} {json.dumps(places) if places else ''}", flush=True)
        totals["parts"] += 1
        for key in ("segments", "hits", "missed", "extra"):
            totals[key] += rays[key]
        for key in ("points", "differ"):
            totals[key] += sides[key]
        for key, count in sides["verdicts"].items():
            totals[key] += count
    print(", ".join(f"{value} {key}" for key, value in totals.items()))
    faults = ("missed", "extra", "theirs_right", "neither", "undecided")
    return 0 if all(totals[key] == 0 for key in faults) else 1


if __name__ == "__main__":
    sys.exit(main())
