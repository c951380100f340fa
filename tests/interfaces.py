#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Whether a mesh knows both regions of every interface, from its file alone (MSH 4.1, binary).

    tests/interfaces.py MESH...

The file says which surfaces bound each volume. Every triangle must be there once and have a tetrahedron in each of
the volumes that its surface bounds, and in no other, or two in one volume where it bounds none and lies within that;
every face between tetrahedra of two volumes must be a triangle.
The exit code is 0 when that holds for all meshes.
"""
import struct
import sys
from array import array
from collections import defaultdict

# By MSH's number of a kind of element: its nodes and its corners, which come first.
NODES = {15: 1, 1: 2, 2: 3, 4: 4, 8: 3, 9: 6, 11: 10}
CORNERS = {2: 3, 9: 3, 4: 4, 11: 4}


class Reader:
    """Walks over a binary MSH file."""

    def __init__(self, path):
        with open(path, "rb") as file:
            self.data = file.read()
        if not self.data.startswith(b"$MeshFormat\n4.1 1 8\n"):
            raise ValueError(f"{path} is no binary MSH 4.1 file")
        self.at = 0

    def enter(self, section):
        head = b"$" + section + b"\n"
        self.at = self.data.index(head, self.at) + len(head)

    def take(self, code, count):
        values = struct.unpack_from(f"<{count}{code}", self.data, self.at)
        self.at += struct.calcsize(f"<{count}{code}")
        return values

    def skip(self, size):
        self.at += size

    def rows(self, count, width):
        """`count` rows of `width` numbers of 8 bytes, without the first of each, which is the element's own number."""
        end = self.at + 8 * count * width
        flat = array("Q")
        flat.frombytes(self.data[self.at:end])
        self.at = end
        return zip(*(flat[i::width] for i in range(1, width)))


def read_mesh(path):
    """(volumes by surface, [(surface, vertices)], [(volume, vertices)])"""
    reader = Reader(path)
    reader.enter(b"Entities")
    points, curves, surfaces, volumes = reader.take("Q", 4)
    for _ in range(points):
        reader.skip(4 + 3 * 8)
        reader.skip(4 * reader.take("Q", 1)[0])
    volumes_of = defaultdict(list)
    for n in range(curves + surfaces + volumes):
        (tag,) = reader.take("i", 1)
        reader.skip(6 * 8)
        reader.skip(4 * reader.take("Q", 1)[0])
        bounds = reader.take("i", reader.take("Q", 1)[0])
        if n >= curves + surfaces:
            for surface in bounds:
                volumes_of[abs(surface)].append(tag)
    reader.enter(b"Elements")
    blocks, _, _, _ = reader.take("Q", 4)
    triangles, tets = [], []
    for _ in range(blocks):
        _, tag, kind = reader.take("i", 3)
        (count,) = reader.take("Q", 1)
        rows = reader.rows(count, 1 + NODES[kind])
        corners = CORNERS.get(kind, 0)
        if corners:
            (triangles if corners == 3 else tets).extend((tag, row[:corners]) for row in rows)
    return volumes_of, triangles, tets


def check_interfaces(path):
    """(interfaces with triangles, triangles on them, [what is wrong])"""
    volumes_of, triangles, tets = read_mesh(path)
    wrong = []
    surface_at = {}
    for surface, corners in triangles:
        key = tuple(sorted(corners))
        if key in surface_at:
            wrong.append(f"a triangle of Face {surface} is there twice, on Face {surface_at[key]} too")
        surface_at[key] = surface
    on_surface = {v for key in surface_at for v in key}
    beside = defaultdict(list)
    for volume, corners in tets:
        on = [v for v in corners if v in on_surface]
        if len(on) < 3:
            continue
        for skipped in corners if len(on) == 4 else ({*corners} - {*on}):
            beside[tuple(sorted(v for v in corners if v != skipped))].append(volume)
    interfaces, count = set(), 0
    for key, surface in surface_at.items():
        told, found = sorted(volumes_of[surface]), sorted(beside[key])
        is_embedded = not told and len(found) == 2 and found[0] == found[1]
        if told != found and not is_embedded:
            wrong.append(f"a triangle of Face {surface}, between volumes {told}, has tetrahedra in {found}")
        if len(told) == 2:
            interfaces.add(surface)
            count += 1
    for key, volumes in beside.items():
        if len(set(volumes)) > 1 and key not in surface_at:
            wrong.append(f"volumes {sorted(set(volumes))} meet where no triangle is")
    return len(interfaces), count, wrong


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    good = True
    for path in sys.argv[1:]:
        interfaces, count, wrong = check_interfaces(path)
        print(f"{path}: {interfaces} interfaces, {count} triangles on them, {len(wrong)} wrong", *wrong[:3], sep="\n  ")
        good = good and not wrong
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
