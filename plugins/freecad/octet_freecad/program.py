# SPDX-License-Identifier: BSD-3-Clause
"""The program octet, as Octet's Python package beside this plug-in calls it (plugins/python)."""
import os
import sys

try:
    from octet import program
except ImportError:
    sys.path.append(os.path.normpath(os.path.join(os.path.realpath(__file__), "../../../python")))
    from octet import program

OctetError, Run = program.OctetError, program.Run
SETTING = (
    program.SETTING + ", or in FreeCAD by Tools > Edit parameters, "
    "BaseApp/Preferences/Mod/Octet, a text Program"
)


def find_program(preferred=""):
    """Path of octet. OctetError when there is none."""
    return program.find_program(preferred, SETTING)
