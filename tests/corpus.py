#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes every part of a folder and prints one table: what came out, what `octet check` says, what judges say.

    tests/corpus.py FOLDER|FILE... [--octet build/app/octet] [--sizes default,40] [--order 1] [--limit 300]
                    [--manifest TSV --difficulty easy --kind solid] [--meshstat PATH] [--meshvscad PATH]
                    [--keep DIR] [--jobs 1] [--turns 3 --turner build/tests/geom/occt/octet_turn_part]

A size is `default`, a number N: the part's diagonal / N, or =N: that many elements. A manifest is a tab separated table with the columns
name, difficulty and kind. The judges are independent programs that print JSON (`meshstat MESH`,
`meshvscad PART MESH`). With --assemblies (needs meshstat) the table also tells the regions, how many of the model's
faces between two regions have triangles, how many such triangles there are (each face of two tetrahedra of
different regions must be one, once), whether each triangle has a tetrahedron in each of the regions that its face
bounds (`sides`, by tests/interfaces.py), and the worst error of a region's volume against the CAD's. With --turns N each part is meshed as it stands and turned at
random N times (the same turns each time, at the size of the part as it stands; build the target octet_turn_part), and runs of other status than the part's
as it stands, or more than a tenth more or fewer elements, are told. The target
octet_make_parts writes folders of random parts (build/tests/geom/occt/octet_make_parts FOLDER --count 100 --seed 1). The exit code is 0 when every run is complete and every judge content.
"""
import argparse
import csv
import json
import math
import os
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor

from interfaces import check_interfaces

SUFFIXES = (".step", ".stp", ".iges", ".igs", ".brep", ".brp")
STATUS = {0: "complete", 2: "refused", 3: "incomplete", 4: "failed"}
HEAD = ("file", "size", "status", "tets", "min dih", "p1 dih", "vol err", "regions", "shared", "shared tris", "sides",
        "worst vol", "check", "stat", "cad", "seconds", "why")
ASSEMBLY_HEAD = ("regions", "shared", "shared tris", "sides", "worst vol")


def add_choice(parser):
    """The options by which `chosen_parts` chooses."""
    parser.add_argument("parts", nargs="+", help="folders or CAD files")
    parser.add_argument("--manifest", help="TSV with the columns name, difficulty, kind")
    parser.add_argument("--difficulty", help="comma separated; only these rows of the manifest")
    parser.add_argument("--kind", help="comma separated; only these rows of the manifest")
    parser.add_argument("--match", help="only files whose name holds this")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_choice(parser)
    parser.add_argument("--octet", default="build/app/octet")
    parser.add_argument("--sizes", default="default,40", help="comma separated: default, N for diagonal/N, =N for N elements")
    parser.add_argument("--order", choices=("1", "2"), default="1", help="of the elements")
    parser.add_argument("--limit", type=float, default=300.0, help="seconds a run may take")
    parser.add_argument("--assemblies", action="store_true", help="tell regions, shared faces, volumes of regions")
    parser.add_argument("--meshstat")
    parser.add_argument("--meshvscad")
    parser.add_argument("--turns", type=int, default=0, help="random rotations of each part, too")
    parser.add_argument("--turner", default="build/tests/geom/occt/octet_turn_part")
    parser.add_argument("--keep", help="keep meshes and reports in this directory")
    parser.add_argument("--jobs", type=int, default=1, help="parts at a time")
    return parser.parse_args()


def chosen_parts(args):
    files = []
    for part in args.parts:
        if os.path.isdir(part):
            files += [os.path.join(part, n) for n in sorted(os.listdir(part)) if n.lower().endswith(SUFFIXES)]
        else:
            files.append(part)
    if args.manifest:
        with open(args.manifest, newline="", encoding="utf-8") as table:
            rows = {row["name"]: row for row in csv.DictReader(table, delimiter="\t", quoting=csv.QUOTE_NONE)}
        files = [f for f in files if os.path.basename(f) in rows]
        for column in ("difficulty", "kind"):
            wanted = getattr(args, column)
            if wanted:
                files = [f for f in files if rows[os.path.basename(f)][column] in wanted.split(",")]
    return [f for f in files if not args.match or args.match in os.path.basename(f)]


def call(command, limit):
    """(exit code or None when out of time, stdout, stderr, seconds)"""
    start = time.monotonic()
    try:
        done = subprocess.run(command, capture_output=True, timeout=limit, check=False)
        code, out, err = done.returncode, done.stdout, done.stderr
    except subprocess.TimeoutExpired as late:
        code, out, err = None, late.stdout or b"", late.stderr or b""
    return code, out.decode(errors="replace"), err.decode(errors="replace"), time.monotonic() - start


def judge_mesh(args, mesh):
    """Verdict of meshstat, `ok` or its first reason, and all it says."""
    _, out, err, _ = call([args.meshstat, "--compact", mesh], args.limit)
    try:
        report = json.loads(out)
    except ValueError:
        return "crash " + err.strip()[:60], {}
    if report.get("valid"):
        return "ok", report
    problems = report.get("problems") or [report.get("error", "not valid")]
    return str(problems[0]), report


def judge_assembly(args, part, mesh, stat, row):
    """Regions and what they share, in the model and as meshstat counts it in the mesh: `ok`, or what is wrong."""
    _, _, wrong = check_interfaces(mesh)
    row["sides"] = f"{len(wrong)} wrong" if wrong else "ok"
    code, out, _, _ = call([args.octet, "info", part, "--json"], args.limit)
    if code != 0 or not stat:
        return "unknown"
    info = json.loads(out)
    shared = {f["tag"] for f in info["faces"] if 0 not in f["regions"] and f["regions"][0] != f["regions"][1]}
    meshed = {s["tag"] for s in stat["surfaces_by_tag"]}
    volumes = {v["tag"]: v["volume"] for v in stat["volumes_by_tag"]}
    errors = [volumes.get(r["tag"], 0.0) / r["volume"] - 1.0 for r in info["regions"]]
    match = stat["surface_elements_match"]
    row["regions"] = f"{len(volumes)}/{len(info['regions'])}"
    row["shared"] = f"{len(shared & meshed)}/{len(shared)}"
    row["shared tris"] = stat["faces"]["interface_between_volume_tags"]
    row["worst vol"] = f"{max(errors, key=abs):+.1e}"
    if wrong:
        return wrong[0]
    if not match["exact_match"]:
        return "triangles are not the faces of the regions"
    return "ok" if shared <= meshed and len(volumes) == len(errors) else "regions or shared faces are missing"


def judge_part(args, part, mesh):
    """Verdict of meshvscad: `ok`, or what of the CAD the mesh lacks."""
    _, out, err, _ = call([args.meshvscad, part, mesh], args.limit)
    try:
        report = json.loads(out)
    except ValueError:
        return "crash " + err.strip()[:60]
    if "error" in report:
        return str(report["error"])
    faces, edges, vertices = report["faces"], report["model_edges"], report["model_vertices"]
    lacks = {
        "faces": faces["with_no_triangle"],
        "far faces": faces["farther_than_half_edge"],
        "sharp edges": edges["missing_sharp"],
        "smooth edges": edges["missing_smooth"],
        "vertices": vertices["missing"] - vertices["missing_artificial"],
    }
    missing = [f"{n} {name}" for name, n in lacks.items() if n]
    return ("lacks " + ", ".join(missing)) if missing else "ok"


def size_options(args, part, size):
    """The size as an option; turned parts get that of the part as it stands, whose box they do not share."""
    if size == "default" and not args.turns:
        return []
    if size.startswith("="):
        return ["--target-elements", size[1:]]
    code, out, err, _ = call([args.octet, "info", part, "--json"], args.limit)
    if code != 0:
        raise RuntimeError(err.strip() if code is not None else "octet info ran out of time")
    info = json.loads(out)
    return ["--size", repr(info["default_size"] if size == "default" else info["diagonal"] / float(size))]


def run_one(args, part, size, folder, standing):
    """One row of the table; `standing` is the part itself, or what it was before it was turned."""
    name = os.path.basename(part)
    own = os.path.abspath(part).replace(os.sep, "_")[-200:]  # files of two folders may have one name
    mesh = os.path.join(folder, f"{own}-{size}.msh")
    report_file = mesh + ".json"
    row = dict.fromkeys(HEAD, "-")
    row.update(file=name, size=size if size == "default" or size.startswith("=") else f"d/{size}", status="-", why="", good=False)
    try:
        options = size_options(args, standing, size)
    except RuntimeError as error:
        row.update(status="refused", why=str(error))
        return row
    command = [args.octet, "mesh", part, "-o", mesh, "--report", report_file, "--quiet", "--order", args.order] + options
    code, _, err, seconds = call(command, args.limit)
    row["seconds"] = f"{seconds:.1f}"
    row["status"] = "timeout" if code is None else STATUS.get(code, f"crash {code}")
    row["why"] = err.strip().replace("\n", " ")
    if code not in (0, 3):
        return row
    with open(report_file, encoding="utf-8") as file:
        report = json.load(file)
    row["tets"] = report["tets"]
    row["min dih"] = f"{report['quality']['min_dihedral']:.1f}"
    row["p1 dih"] = f"{report['quality']['p1_min_dihedral']:.1f}"
    row["vol err"] = f"{report['volume']['relative_error']:+.1e}"
    if report["faults"]:
        fault = report["faults"][0]
        row["why"] = f"{len(report['faults'])} faults: {fault['entity']}: {fault['cause']}"
    check, out, err, _ = call([args.octet, "check", mesh, part], args.limit)
    told = {0: "ok", 3: "broken" if "BROKEN" in out else "left out"}
    row["check"] = "timeout" if check is None else told.get(check, f"exit {check} {err.strip()}")
    verdicts = [row["check"]]
    if args.meshstat:
        row["stat"], stat = judge_mesh(args, mesh)
        verdicts.append(row["stat"])
        if args.assemblies:
            verdicts.append(judge_assembly(args, part, mesh, stat, row))
    if args.meshvscad:
        row["cad"] = judge_part(args, part, mesh)
        verdicts.append(row["cad"])
    row["good"] = code == 0 and all(v == "ok" for v in verdicts)
    row["dihedral"] = report["quality"]["min_dihedral"]
    if not args.keep:
        os.remove(mesh)
    return row


def turned_parts(args, part, folder):
    """The part as it stands and turned."""
    stem = os.path.splitext(os.path.basename(part))[0]
    turned = [os.path.join(folder, f"{stem}-turn{n}.brep") for n in range(1, args.turns + 1)]
    for seed, file in enumerate(turned, 1):
        code, _, err, _ = call([args.turner, part, file, str(seed)], args.limit)
        if code != 0:
            sys.exit(f"{args.turner}: {part}: {err.strip()}")
    return [part] + turned


def print_turns(args, rows, sizes):
    """Where a turned part comes out otherwise than the part as it stands; rows come part by part, turn by turn."""
    worst, off = 0.0, 0
    block = (1 + args.turns) * len(sizes)
    for first in range(0, len(rows), block):
        for k in range(len(sizes), block):
            still, turned = rows[first + k % len(sizes)], rows[first + k]
            same = still["status"] == turned["status"]
            share = turned["tets"] / still["tets"] - 1 if "-" not in (still["tets"], turned["tets"]) else 0.0
            worst = max(worst, abs(share))
            if not same or abs(share) > 0.1:
                off += 1
                print(f"{turned['file']} {turned['size']}: {still['status']} -> {turned['status']}, elements {100 * share:+.0f} %")
    print(f"{off} of {len(rows) - len(rows) // (1 + args.turns)} turned runs differ in status or by more than 10 % in elements, "
          f"the worst by {100 * worst:.0f} %")


def widths_of(args, parts):
    shown = [h for h in HEAD if args.assemblies or h not in ASSEMBLY_HEAD]
    widths = {h: max(len(h), 10) for h in shown}
    widths["file"] = max([len("file")] + [len(os.path.basename(p)) for p in parts])
    widths["why"] = 3
    return widths


def print_row(cells, widths):
    print(" | ".join(str(cells[h]).ljust(widths[h]) for h in widths).rstrip(), flush=True)


def main():
    args = arguments()
    parts = chosen_parts(args)
    if not parts:
        print("no part to mesh", file=sys.stderr)
        return 2
    sizes = args.sizes.split(",")
    with tempfile.TemporaryDirectory() as scratch:
        folder = args.keep or scratch
        os.makedirs(folder, exist_ok=True)
        with ThreadPoolExecutor(max_workers=args.jobs) as pool:
            standing = {p: p for p in parts}
            if args.turns:
                standing = {t: p for p in parts for t in turned_parts(args, p, folder)}
                parts = list(standing)
            jobs = [pool.submit(run_one, args, p, s, folder, standing[p]) for p in parts for s in sizes]
            widths = widths_of(args, parts)
            print_row({h: h for h in HEAD}, widths)
            rows = []
            for job in jobs:
                rows.append(job.result())
                print_row(rows[-1], widths)
    good = sum(r["good"] for r in rows)
    complete = sum(r["status"] == "complete" for r in rows)
    angles = [r["dihedral"] for r in rows if r.get("dihedral") is not None]
    least = min(angles) if angles else math.nan
    sharp = sum(a < 15.0 for a in angles)
    print(f"{len(parts)} parts, {len(rows)} runs: {complete} complete, {good} complete and confirmed by every judge; "
          f"smallest dihedral {least:.1f} degrees, below 15 degrees in {sharp} runs")
    if args.turns:
        print_turns(args, rows, sizes)
    misses = [abs(r["tets"] / float(r["size"][1:]) - 1) for r in rows if r["size"].startswith("=") and r["tets"] != "-"]
    if misses:
        near = sum(m <= 0.15 for m in misses)
        print(f"{near} of {len(misses)} within 15 % of the elements asked for, the worst off by {100 * max(misses):.0f} %")
    return 0 if good == len(rows) else 1


if __name__ == "__main__":
    sys.exit(main())
