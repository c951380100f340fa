# SPDX-License-Identifier: BSD-3-Clause
"""The program octet: where it is, how it is called, what it tells."""
import json
import os
import re
import shutil
import subprocess
import threading
import time

COMPLETE, INCOMPLETE = 0, 3  # exit codes with a mesh
SETTING = "its place can be set by $OCTET"


class OctetError(Exception):
    """The program was not found, or ended without a mesh; the text says why, with the CAD entity at fault."""


def find_program(preferred="", setting=SETTING):
    """Path of octet: `preferred` or $OCTET where one is given, else beside this package (in a built checkout
    or an installation), else on the PATH. OctetError, which ends with `setting`, when there is none."""
    given = os.fspath(preferred) or os.environ.get("OCTET", "")
    if given:
        found = shutil.which(os.path.expanduser(given))
        if found:
            return found
        raise OctetError(f"{given} is not a program; {setting}")
    here = os.path.dirname(os.path.realpath(__file__))
    for place in ("../../../build/app", "../../../../bin"):
        found = shutil.which(os.path.normpath(os.path.join(here, place, "octet")))
        if found:
            return found
    found = shutil.which("octet")
    if found:
        return found
    raise OctetError(f"the program octet is neither beside its Python package nor on the PATH; {setting}")


def _reason(lines, code):
    """Of an end without a result."""
    told = [line[len("octet: error: ") :].strip() for line in lines if line.startswith("octet: error: ")]
    return "; ".join(told) or f"octet ended with code {code} and said nothing"


class Run:
    """One run of the program that makes a mesh: begun by the constructor, followed by `stage` and `fraction`,
    ended by `wait`."""

    def __init__(self, program, arguments, report):
        self.stage, self.fraction = "", 0.0
        self._stages = []  # that began, with the fraction done then
        self.report_file = report
        self._output, self._errors = [], []
        self._cancelled = False
        self._process = subprocess.Popen(
            [program, *arguments, "--verbose", "--report", report],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            errors="replace",
        )
        self._readers = [
            threading.Thread(target=reader, daemon=True) for reader in (self._read_output, self._read_errors)
        ]
        for reader in self._readers:
            reader.start()

    def _read_output(self):
        for line in self._process.stdout:
            self._output.append(line.rstrip("\n"))

    def _read_errors(self):
        for line in self._process.stderr:
            stage = re.match(r"octet: \[\s*(\d+)%\] (.*)", line)
            if stage:
                self.fraction, self.stage = int(stage[1]) / 100.0, stage[2].strip()
                self._stages.append((self.stage, self.fraction))
            elif line.startswith("octet: error: "):
                self._errors.append(line)

    def running(self):
        return self._process.poll() is None

    def cancel(self):
        """Asks the program to stop; it leaves no file. `wait` then raises OctetError."""
        self._cancelled = True
        if self.running():
            self._process.terminate()

    def summary(self):
        """What the program prints for people, a line each."""
        return list(self._output)

    def _end(self):
        code = self._process.wait()
        for reader in self._readers:
            reader.join()
        self._process.stdout.close()
        self._process.stderr.close()
        return code

    def wait(self):
        """The report (docs/conventions.md of octet), when a mesh was written, complete or not. OctetError
        else."""
        code = self._end()
        if code in (COMPLETE, INCOMPLETE):
            with open(self.report_file, encoding="utf-8") as file:
                return json.load(file)
        if self._cancelled:
            raise OctetError("cancelled")
        raise OctetError(_reason(self._errors, code))

    def follow(self, progress=None, time_limit=None):
        """As `wait`. `progress(stage, fraction)` is called as stages begin; after `time_limit` seconds the
        run is cancelled, and so it is when anything is raised meanwhile: by `progress`, or by Ctrl-C."""
        end = None if time_limit is None else time.monotonic() + time_limit
        told = 0
        try:
            while self.running():
                while progress is not None and told < len(self._stages):
                    told += 1
                    progress(*self._stages[told - 1])
                if end is not None and time.monotonic() > end:
                    self.cancel()
                    break
                time.sleep(0.01)
            return self.wait()
        except BaseException:
            self.cancel()
            self._end()
            raise


def told(program, arguments):
    """What a command prints. OctetError when it fails."""
    done = subprocess.run([program, *arguments], stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if done.returncode not in (COMPLETE, INCOMPLETE):
        raise OctetError(_reason(done.stderr.splitlines(), done.returncode))
    return done.stdout


def ask(program, arguments):
    """What a command prints as JSON. OctetError when it cannot answer."""
    return json.loads(told(program, [*arguments, "--json"]))


def words_of(fault):
    """A fault or warning of a report in one line."""
    text = fault["cause"]
    if fault["entity"]:
        ids = fault.get("ids", [])
        entity = f"{fault['entity']} ({', '.join(ids)})" if ids else fault["entity"]
        text = "{} at ({}): {}".format(entity, ", ".join(f"{x:.6g}" for x in fault["place"]), text)
    return f"{text} -> {fault['advice']}" if fault["advice"] else text
