#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes mutated STEP files and fails on a crash, a hang, a false claim or a wrong mesh.

    tests/fuzz.py PART.step... [--octet build/app/octet] [--count 1000] [--seed 1] [--limit 30]
                  [--size-share 12] [--meshstat PATH] [--keep DIR]

A mutation flips bytes, drops an entity, doubles one, swaps two references, or turns a number into 0, 1e300, nan
or its negative. The same seed gives the same files. The size is the sound part's diagonal / --size-share, and
elements are limited. Right answers are exit codes 0 (then `octet check` agrees, and meshstat if it is given), 2, 3
and 4 with a line on stderr; a signal, another code, silence or a run past the limit is a failure.
"""
import argparse
import json
import os
import random
import re
import subprocess
import sys
import tempfile

NUMBER = re.compile(rb"(?<=[(,])-?\d+\.\d*(?:E[+-]?\d+)?(?=[),])")
REFERENCE = re.compile(rb"(?<=[(,])#\d+(?=[),])")


def flip_bytes(data, dice):
    result = bytearray(data)
    for _ in range(dice.randint(1, 4)):
        result[dice.randrange(len(result))] = dice.randrange(256)
    return bytes(result)


def entities(data):
    return [m.span() for m in re.finditer(rb"^#\d+ *=.*?;\r?\n", data, re.M | re.S)]


def drop_entity(data, dice):
    first, last = dice.choice(entities(data))
    return data[:first] + data[last:]


def double_entity(data, dice):
    first, last = dice.choice(entities(data))
    return data[:last] + data[first:last] + data[last:]


def change_number(data, dice):
    first, last = dice.choice([m.span() for m in NUMBER.finditer(data)])
    value = dice.choice([b"0.", b"1.E+300", b"NaN", b"-1.", b"-" + data[first:last], b"1.E-12"])
    return data[:first] + value.replace(b"--", b"") + data[last:]


def swap_references(data, dice):
    a, b = sorted(dice.sample([m.span() for m in REFERENCE.finditer(data)], 2))
    return data[: a[0]] + data[b[0] : b[1]] + data[a[1] : b[0]] + data[a[0] : a[1]] + data[b[1] :]


MUTATIONS = (flip_bytes, drop_entity, double_entity, change_number, swap_references)


def diagonal(octet, part):
    out = subprocess.run([octet, "info", "--json", part], capture_output=True, text=True, check=True)
    return json.loads(out.stdout)["diagonal"]


def verdict(args, part, size, directory):
    """None, or what went wrong."""
    mesh = os.path.join(directory, "fuzz.msh")
    if os.path.exists(mesh):
        os.remove(mesh)
    command = [args.octet, "mesh", part, "-o", mesh, "--size", repr(size), "--quiet", "--threads", "1"]
    command += ["--max-elements", "200000", "--read-time-limit", repr(args.limit / 2)]
    try:
        run = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=args.limit)
    except subprocess.TimeoutExpired:
        return f"longer than {args.limit:g} s"
    if run.returncode not in (0, 2, 3, 4):
        return f"exit code {run.returncode}: {run.stderr[-200:]}"
    if run.returncode in (2, 4) and not run.stderr.startswith("octet: error: "):
        return f"exit code {run.returncode} without an error line"
    if run.returncode in (2, 4) and os.path.exists(mesh):
        return f"exit code {run.returncode} and a mesh"
    if run.returncode == 0:
        check = subprocess.run([args.octet, "check", mesh, part], capture_output=True, text=True)
        if check.returncode != 0:
            return "complete, but octet check says " + check.stdout[-200:]
        if args.meshstat and subprocess.run([args.meshstat, mesh], capture_output=True).returncode != 0:
            return "complete, but meshstat objects"
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("parts", nargs="+", help="sound STEP files to mutate")
    parser.add_argument("--octet", default="build/app/octet")
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--limit", type=float, default=30.0, help="seconds a run may take")
    parser.add_argument("--size-share", type=float, default=12.0)
    parser.add_argument("--meshstat")
    parser.add_argument("--keep", help="keep the files that failed in this directory")
    args = parser.parse_args()
    sources = []
    for part in args.parts:
        with open(part, "rb") as file:
            sources.append((part, file.read(), diagonal(args.octet, part) / args.size_share))
    failures = 0
    with tempfile.TemporaryDirectory() as directory:
        for n in range(args.count):
            dice = random.Random(f"{args.seed} {n}")
            name, data, size = sources[n % len(sources)]
            mutate = dice.choice(MUTATIONS)
            part = os.path.join(directory, "fuzz.step")
            with open(part, "wb") as file:
                file.write(mutate(data, dice))
            wrong = verdict(args, part, size, directory)
            if wrong is None:
                continue
            failures += 1
            print(f"{n}: {os.path.basename(name)}, {mutate.__name__}: {wrong}", flush=True)
            if args.keep:
                os.makedirs(args.keep, exist_ok=True)
                os.replace(part, os.path.join(args.keep, f"{n}_{os.path.basename(name)}"))
    print(f"{args.count} mutations, {failures} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
