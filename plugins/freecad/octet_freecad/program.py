# SPDX-License-Identifier: BSD-3-Clause
"""The program octet: where it is, how it is called, what it tells. Nothing of FreeCAD."""
import json
import os
import re
import shutil
import subprocess
import threading

COMPLETE, INCOMPLETE = 0, 3  # exit codes with a mesh
SETTING = (
    "its place can be set by $OCTET, or in FreeCAD by Tools > Edit parameters, "
    "BaseApp/Preferences/Mod/Octet, a text Program"
)


class OctetError(Exception):
    """The program was not found, or ended without a mesh; the text says why, with the CAD entity at fault."""


def find_program(preferred=""):
    """Path of octet: `preferred` or $OCTET where one is given, else beside this plug-in (in a built checkout
    or an installation), else on the PATH. OctetError when there is none."""
    given = preferred or os.environ.get("OCTET", "")
    if given:
        found = shutil.which(os.path.expanduser(given))
        if found:
            return found
        raise OctetError(f"{given} is not a program; {SETTING}")
    here = os.path.dirname(os.path.realpath(__file__))
    for place in ("../../../build/app", "../../../../bin"):
        found = shutil.which(os.path.normpath(os.path.join(here, place, "octet")))
        if found:
            return found
    found = shutil.which("octet")
    if found:
        return found
    raise OctetError(f"the program octet is neither beside the plug-in nor on the PATH; {SETTING}")


class Run:
    """One run of the program: begun by the constructor, followed by `stage` and `fraction`, ended by `wait`."""

    def __init__(self, program, arguments, report):
        self.stage, self.fraction = "", 0.0
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
            elif line.startswith("octet: error: "):
                self._errors.append(line[len("octet: error: ") :].strip())

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

    def wait(self):
        """The report (docs/conventions.md of octet), when a mesh was written, complete or not. OctetError
        else."""
        code = self._process.wait()
        for reader in self._readers:
            reader.join()
        self._process.stdout.close()
        self._process.stderr.close()
        if code in (COMPLETE, INCOMPLETE):
            with open(self.report_file, encoding="utf-8") as file:
                return json.load(file)
        if self._cancelled:
            raise OctetError("cancelled")
        raise OctetError("; ".join(self._errors) or f"octet ended with code {code} and said nothing")
