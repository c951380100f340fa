#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Speed and memory of whole runs, from the STEP file to the written mesh.

    tests/bench/bench.py compare [PART...] [--tets 1e5,1e6] [--pairs 5] [--threads 1] [--rivals hxt,gmsh] [--fast]
    tests/bench/bench.py compare [PART...]  --tets default ...
    tests/bench/bench.py growth  [PART...] [--tets 1e4,1e5,1e6] [--threads 1] [--fast]
    tests/bench/bench.py writing [PART]    [--tets 1e6]

compare: Octet and Debian's programs `gmsh -3 -algo hxt` and `gmsh -3` (apt-get install gmsh), each at its own size
for about the wanted number of tetrahedra, in alternating pairs; medians of the pairs' ratios of CPU time a
tetrahedron, wall time a tetrahedron and memory a tetrahedron (above 1: Octet is ahead), and both qualities. With
--tets default the number is what Octet makes unasked. A rival that makes no tetrahedra at any of five sizes, each
within 100 s and 50 microseconds a wanted one, has failed. At the end the median over all parts.
growth: one run a count; CPU seconds by stage and in brackets the peak memory up to its end in MiB, and the exponents of time and memory against the count (least squares of
the logarithms, from 1e5 on when there are three such counts).
writing: the time of the stage "writing" against `dd` with as many bytes into the same directory.

CPU time, of all processes of a run, is what to compare on a machine that others use too. OCTET names the program
(default: build/app/octet).
"""
import argparse
import json
import math
import os
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import threading
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
OCTET = os.environ.get("OCTET", os.path.join(ROOT, "build", "app", "octet"))
PARTS = [os.path.join(ROOT, "models", name) for name in ("bracket.step", "blade.step")]


class Run:
    """One process: wall and CPU seconds, peak memory in bytes."""

    def __init__(self, command, limit=None):
        begin = time.monotonic()
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        timer = threading.Timer(limit, process.kill) if limit else None
        if timer:
            timer.start()
        _, status, usage = os.wait4(process.pid, 0)
        if timer:
            timer.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
        self.wall = time.monotonic() - begin
        self.cpu = usage.ru_utime + usage.ru_stime
        self.memory = 1024 * usage.ru_maxrss
        self.code = process.returncode


class Octet:
    name = "octet"

    def __init__(self, work, threads, fast):
        self.mesh = os.path.join(work, "octet.msh")
        self.report = os.path.join(work, "octet.json")
        self.threads = threads
        self.fast = ["--fast"] if fast else []

    def run(self, part, size):
        sizes = ["--size", repr(size), "--max-elements", "1000000000"] if size else []
        run = Run(
            [
                OCTET,
                "mesh",
                part,
                "-o",
                self.mesh,
                *sizes,
                "--threads",
                str(self.threads),
                "--quiet",
                "--report",
                self.report,
                *self.fast,
            ]
        )
        if run.code not in (0, 3):
            sys.exit(f"octet failed on {part} at size {size} (exit code {run.code})")
        with open(self.report) as file:
            self.told = json.load(file)
        run.tets = self.told["tets"]
        return run


class Gmsh:
    def __init__(self, work, threads, hxt):
        self.name = "hxt" if hxt else "gmsh"
        self.mesh = os.path.join(work, self.name + ".msh")
        self.options = (["-algo", "hxt"] if hxt else []) + ["-nt", str(threads), "-bin", "-v", "0"]
        self.wanted = 0

    def run(self, part, size):
        if os.path.exists(self.mesh):
            os.remove(self.mesh)
        command = ["gmsh", "-3", *self.options, "-clmin", "0", "-clmax", repr(size), part, "-o", self.mesh]
        run = Run(command, limit=100 + 50e-6 * self.wanted)
        run.tets = quality(self.mesh)["tets"] if run.code == 0 and os.path.exists(self.mesh) else 0
        return run


def quality(mesh):
    """Without any tetrahedra {"tets": 0} alone."""
    text = subprocess.run([OCTET, "quality", "--json", mesh], capture_output=True, text=True).stdout
    if not text:  # a surface mesh, which HXT leaves where it fails
        return {"tets": 0}
    told = json.loads(text)
    measures = {measure["name"]: measure for measure in told["all"]}
    angle, ratio = measures["smallest dihedral"], measures["mean ratio"]
    return {"tets": told["tets"], "least": angle["least"], "p1": angle["p1"], "ratio": ratio["mean"]}


def first_size(part, tets):
    text = subprocess.run([OCTET, "info", part, "--json"], capture_output=True, text=True).stdout
    return (6.0 * json.loads(text)["volume"] / tets) ** (1.0 / 3.0)


def fitted_size(mesher, part, tets, near=0.1):
    """The count goes as size^-3; a tenth away is near enough, for what is compared is the cost a tetrahedron. The
    size that came nearest of five; None where none gave a mesh."""
    mesher.wanted = tets
    size, best = first_size(part, tets), (math.inf, None)
    for _ in range(5):
        run = mesher.run(part, size)
        if run.tets == 0:  # a little coarser may do
            size *= 1.15
            continue
        best = min(best, (abs(math.log(run.tets / tets)), size))
        if best[0] < math.log(1.0 + near):
            break
        size *= (run.tets / tets) ** (1.0 / 3.0)
    return best[1]


def median_ratio(pairs, value):
    return statistics.median(value(rival) / rival.tets / (value(own) / own.tets) for own, rival in pairs)


def compare(options, work):
    octet = Octet(work, options.threads, options.fast)
    rivals = [Gmsh(work, options.threads, name == "hxt") for name in options.rivals.split(",")]
    print(
        f"{'part':16} {'rival':5} {'tets':>9} {'its':>9} {'cpu s':>7} {'its':>7} | {'cpu':>5} {'wall':>5} {'memory':>6}"
        " | least, 1st percentile of the smallest dihedral; mean ratio: octet / rival"
    )
    ratios, failed = {rival.name: [] for rival in rivals}, {rival.name: 0 for rival in rivals}
    for part in options.parts:
        name = os.path.basename(part)
        for tets in options.tets:
            own_size = fitted_size(octet, part, tets) if tets else None
            wanted = tets or octet.run(part, None).tets
            for rival in rivals:
                size = fitted_size(rival, part, wanted)
                pairs = (
                    [(octet.run(part, own_size), rival.run(part, size)) for _ in range(options.pairs)]
                    if size
                    else []
                )
                if not size or any(run.tets == 0 for _, run in pairs):
                    print(f"{name:16} {rival.name:5} {wanted:9d}    failed", flush=True)
                    failed[rival.name] += 1
                    continue
                own, other = quality(octet.mesh), quality(rival.mesh)
                shapes = "{least:.1f} {p1:.1f} {ratio:.3f}"
                cpu = median_ratio(pairs, lambda r: r.cpu)
                ratios[rival.name].append(cpu)
                print(
                    f"{name:16} {rival.name:5} {own['tets']:9d} {other['tets']:9d} "
                    f"{statistics.median(a.cpu for a, _ in pairs):7.2f} "
                    f"{statistics.median(b.cpu for _, b in pairs):7.2f} | "
                    f"{cpu:5.2f} {median_ratio(pairs, lambda r: r.wall):5.2f} "
                    f"{median_ratio(pairs, lambda r: r.memory):6.2f} | "
                    f"{shapes.format(**own)} / {shapes.format(**other)}",
                    flush=True,
                )
    for rival, of_parts in ratios.items():
        if len(of_parts) > 1:
            print(
                f"{rival}: {len(of_parts)} compared, median of the ratios of CPU time {statistics.median(of_parts):.2f}, "
                f"below 1 on {sum(r < 1 for r in of_parts)}; {failed[rival]} failed"
            )


def exponent(points):
    """Slope of log y over log x."""
    logs = [(math.log(x), math.log(y)) for x, y in points]
    mean_x, mean_y = (statistics.fmean(column) for column in zip(*logs))
    return sum((x - mean_x) * (y - mean_y) for x, y in logs) / sum((x - mean_x) ** 2 for x, _ in logs)


def growth(options, work):
    octet = Octet(work, options.threads, options.fast)
    for part in options.parts:
        print(f"{os.path.basename(part)}, {options.threads} threads")
        runs = []
        for tets in options.tets:
            run = octet.run(part, first_size(part, 1.15 * tets))
            runs.append(run)
            stages = " ".join(
                f"{stage['stage']} {stage['cpu_seconds']:.2f} ({stage['peak_bytes'] / 2**20:.0f})"
                for stage in octet.told["times"]
            )
            print(
                f"{run.tets:10d} tets, {octet.told['triangles']:8d} triangles, cpu {run.cpu:8.2f} s, "
                f"wall {run.wall:8.2f} s, {run.memory / 2**20:7.0f} MiB, {run.memory / run.tets:6.0f} B/tet, "
                f"{octet.told['status']}: {stages}",
                flush=True,
            )
        fit = [run for run in runs if run.tets >= 90_000]
        fit = fit if len(fit) >= 3 else runs
        if len(fit) >= 2:
            print(
                f"exponents from {fit[0].tets}: cpu {exponent([(r.tets, r.cpu) for r in fit]):.3f}, "
                f"wall {exponent([(r.tets, r.wall) for r in fit]):.3f}, "
                f"memory {exponent([(r.tets, r.memory) for r in fit]):.3f}"
            )


def writing(options, work):
    octet = Octet(work, options.threads, options.fast)
    for tets in options.tets:
        part = options.parts[0]
        octet.run(part, first_size(part, 1.15 * tets))
        size = os.path.getsize(octet.mesh)
        stage = next(s for s in octet.told["times"] if s["stage"] == "writing")
        begin = time.monotonic()
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(
            ["dd", "if=/dev/zero", f"of={work}/dd", "bs=1M", f"count={size // 2**20 + 1}"],
            stderr=subprocess.DEVNULL,
            check=True,
        )
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        wall = time.monotonic() - begin
        cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        print(
            f"{size / 1e6:.0f} MB: octet {stage['seconds']:.2f} s (cpu {stage['cpu_seconds']:.2f}), dd {wall:.2f} s "
            f"(cpu {cpu:.2f}); share of dd's rate: {wall / stage['seconds']:.2f}"
        )


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("what", choices=["compare", "growth", "writing"])
    parser.add_argument("parts", nargs="*", default=PARTS)
    parser.add_argument(
        "--tets", default="1e5", help="counts, comma separated; default: what Octet makes unasked"
    )
    parser.add_argument("--pairs", default=5, type=int)
    parser.add_argument("--threads", default=1, type=int)
    parser.add_argument("--rivals", default="hxt")
    parser.add_argument("--fast", action="store_true", help="octet mesh --fast")
    options = parser.parse_intermixed_args()
    options.tets = [0 if n == "default" else int(float(n)) for n in options.tets.split(",")]
    if options.what != "compare" and 0 in options.tets:
        sys.exit("--tets default is for compare alone")
    if not os.access(OCTET, os.X_OK):
        sys.exit(f"{OCTET} is not built: scripts/quickstart builds it")
    if options.what == "compare" and shutil.which("gmsh") is None:
        sys.exit("gmsh is not installed: apt-get install gmsh")
    with tempfile.TemporaryDirectory() as work:
        {"compare": compare, "growth": growth, "writing": writing}[options.what](options, work)


if __name__ == "__main__":
    main()
