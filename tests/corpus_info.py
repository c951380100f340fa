#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Loads every part of a folder with `octet info` and prints one table: status, seconds, peak memory, cause.

    tests/corpus_info.py FOLDER|FILE... [--octet build/app/octet] [--time-limit 60] [--memory-limit 4]
                         [--manifest TSV --difficulty broken --kind solid] [--match TEXT] [--tsv FILE]

A part must load, or be refused in one line with exit code 2, within the limits. The exit code is 0 when every
part did.
"""
import argparse
import csv
import json
import os
import subprocess
import sys
import tempfile
import time

from corpus import add_choice, chosen_parts

HEAD = ("file", "status", "seconds", "cpu", "peak MB", "regions", "faces", "notes", "why")
GRACE = 30.0  # seconds beyond the limit that the program itself keeps


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_choice(parser)
    parser.add_argument("--octet", default="build/app/octet")
    parser.add_argument("--time-limit", type=float, default=60.0, help="seconds for reading one part")
    parser.add_argument("--memory-limit", type=float, default=4.0, help="GB for reading one part")
    parser.add_argument("--tsv", help="write the table here too")
    return parser.parse_args()


def load(args, part):
    """One row of the table, and whether the part did what it must."""
    command = [args.octet, "info", "--json", "--read-time-limit", str(args.time_limit),
               "--read-memory-limit", str(args.memory_limit), part]
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        start = time.monotonic()
        process = subprocess.Popen(command, stdout=out, stderr=err)
        pid = 0
        while not pid and time.monotonic() - start < args.time_limit + GRACE:
            time.sleep(0.005)
            pid, code, usage = os.wait4(process.pid, os.WNOHANG)
        hung = not pid
        if hung:
            process.kill()
            _, code, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(code)
        seconds = time.monotonic() - start
        out.seek(0)
        err.seek(0)
        text, complaint = out.read(), err.read().decode(errors="replace")
    row = {name: "" for name in HEAD}
    row.update({"file": os.path.basename(part), "seconds": f"{seconds:.2f}",
                "cpu": f"{usage.ru_utime + usage.ru_stime:.2f}", "peak MB": f"{usage.ru_maxrss / 1024:.0f}"})
    lines = complaint.splitlines()
    if hung:
        row["status"] = "HUNG"
    elif process.returncode == 0:
        report = json.loads(text)
        row.update({"status": "loaded", "regions": report["counts"]["regions"], "faces": report["counts"]["faces"],
                    "notes": len(report.get("notes", []))})
    elif process.returncode == 2 and len(lines) == 1:
        row.update({"status": "refused", "why": lines[0].removeprefix("octet: error: ")})
    else:
        row.update({"status": f"CRASHED {process.returncode}", "why": lines[-1] if lines else ""})
    return row, row["status"] in ("loaded", "refused")


def main():
    args = arguments()
    rows, good = [], True
    print("\t".join(HEAD))
    for part in chosen_parts(args):
        row, ok = load(args, part)
        rows.append(row)
        good = good and ok
        print("\t".join(str(row[name]) for name in HEAD), flush=True)
    if args.tsv:
        with open(args.tsv, "w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, HEAD, delimiter="\t", quoting=csv.QUOTE_NONE, escapechar="\\")
            writer.writeheader()
            writer.writerows(rows)
    loaded = [row for row in rows if row["status"] == "loaded"]
    print(f"{len(rows)} parts: {len(loaded)} loaded, "
          f"{sum(row['status'] == 'refused' for row in rows)} refused, "
          f"{sum(row['status'] not in ('loaded', 'refused') for row in rows)} crashed or hung", file=sys.stderr)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
