# SPDX-License-Identifier: BSD-3-Clause
"""The program octet, as Octet's Python package beside this plug-in calls it (plugins/python)."""
import os
import sys

# The package of this plug-in's own version goes before any other of its name.
sys.path.insert(0, os.path.normpath(os.path.join(os.path.realpath(__file__), "../../../python")))
from octet import program  # noqa: E402

OctetError, Run, words_of = program.OctetError, program.Run, program.words_of
SETTING = (
    program.SETTING + ", or in FreeCAD by Tools > Edit parameters, "
    "BaseApp/Preferences/Mod/Octet, a text Program"
)


def find_program(preferred=""):
    """Path of octet. OctetError when there is none."""
    return program.find_program(preferred, SETTING)
