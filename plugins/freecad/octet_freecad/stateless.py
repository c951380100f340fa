# SPDX-License-Identifier: BSD-3-Clause
"""What FreeCAD asks of the proxies that a document keeps."""


class Stateless:
    """A proxy that keeps nothing in the document beyond its object's properties."""

    def __getstate__(self):
        return None

    def __setstate__(self, state):
        return None

    # What newer versions of FreeCAD call the two above.
    def dumps(self):
        return None

    def loads(self, state):
        return None
