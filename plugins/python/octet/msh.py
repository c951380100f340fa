# SPDX-License-Identifier: BSD-3-Clause
"""Binary MSH 4.1 files into arrays. [Gmsh reference manual, "MSH file format", version 4.1]"""
import numpy as np

# By MSH's number of a kind of element: its dimension, and its nodes in the order of VTK, Abaqus and meshio.
# MSH has the last two nodes of a tetrahedron of second order the other way round.
KINDS = {
    15: (0, [0]),
    1: (1, [0, 1]),
    2: (2, [0, 1, 2]),
    4: (3, [0, 1, 2, 3]),
    8: (1, [0, 1, 2]),
    9: (2, [0, 1, 2, 3, 4, 5]),
    11: (3, [0, 1, 2, 3, 4, 5, 6, 7, 9, 8]),
}


class _Cursor:
    def __init__(self, path):
        with open(path, "rb") as file:
            self.data = file.read()
        self.path, self.at = path, 0

    def line(self):
        end = self.data.index(b"\n", self.at)
        text, self.at = self.data[self.at : end], end + 1
        return text.decode("utf-8", errors="replace")

    def take(self, kind, count=1):
        """`count` numbers: "i" of 4 bytes, "Q" of 8, "d" doubles."""
        values = np.frombuffer(self.data, {"i": "<i4", "Q": "<u8", "d": "<f8"}[kind], count, self.at)
        self.at += values.nbytes
        return values

    def numbers(self, kind, count):
        return [int(value) for value in self.take(kind, count)]

    def sections(self):
        """Names of sections, one after the other; who asks for the next has read the last."""
        while self.at < len(self.data):
            line = self.line().strip()
            if line.startswith("$") and not line.startswith("$End"):
                yield line[1:]


def _physical_names(cursor):
    names = {}
    for _ in range(int(cursor.line())):
        dim, number, name = cursor.line().split(maxsplit=2)
        names[int(dim), int(number)] = name.strip()[1:-1]
    return names


def _entities(cursor, names):
    """Names by dimension and tag: of the first group of each, which is its own. And the entities of those
    that stand behind it, which hold several, by name."""
    found, groups = {}, {}
    for dim, count in enumerate(cursor.numbers("Q", 4)):
        for _ in range(count):
            (tag,) = cursor.numbers("i", 1)
            cursor.take("d", 3 if dim == 0 else 6)
            for place, group in enumerate(cursor.numbers("i", cursor.numbers("Q", 1)[0])):
                if (dim, group) in names and place == 0:
                    found[dim, tag] = names[dim, group]
                elif (dim, group) in names:
                    groups.setdefault(names[dim, group], []).append((dim, tag))
            if dim > 0:
                cursor.take("i", cursor.numbers("Q", 1)[0])
    return found, groups


def _nodes(cursor):
    """Numbers, points, and the entity that each lies on: dimension and tag."""
    numbers, points, on = [], [], []
    for _ in range(cursor.numbers("Q", 4)[0]):
        dim, tag, parametric = cursor.numbers("i", 3)
        if parametric:
            raise ValueError(f"{cursor.path} has parametric coordinates, which are not read")
        (count,) = cursor.numbers("Q", 1)
        numbers.append(cursor.take("Q", count))
        points.append(cursor.take("d", 3 * count).reshape(-1, 3))
        on.append(np.tile(np.array([dim, tag], dtype=np.int32), (count, 1)))
    numbers = np.concatenate(numbers)
    order = np.argsort(numbers)
    return numbers[order], np.concatenate(points)[order], np.concatenate(on)[order]


def _elements(cursor, place):
    """By dimension: numbers of the elements, their nodes, and the tag of the entity that each lies on."""
    numbers, nodes, on = [[], [], [], []], [[], [], [], []], [[], [], [], []]
    for _ in range(cursor.numbers("Q", 4)[0]):
        _, tag, kind = cursor.numbers("i", 3)
        (count,) = cursor.numbers("Q", 1)
        if kind not in KINDS:
            raise ValueError(f"{cursor.path} has elements of MSH's type {kind}, which are not read")
        dim, order = KINDS[kind]
        found = cursor.take("Q", count * (1 + len(order))).reshape(count, -1)
        rows = place(found[:, 1:])
        numbers[dim].append(found[:, 0])
        nodes[dim].append(rows if order == sorted(order) else rows[:, order])
        on[dim].append(np.full(count, tag, dtype=np.int32))
    return numbers, nodes, on


def _periodic(cursor):
    """By dimension and tag of what is an image: the source's tag, the motion from there, and pairs of numbers
    of nodes."""
    found = {}
    for _ in range(cursor.numbers("Q", 1)[0]):
        dim, tag, source = cursor.numbers("i", 3)
        motion = cursor.take("d", cursor.numbers("Q", 1)[0])
        pairs = cursor.take("Q", 2 * cursor.numbers("Q", 1)[0]).reshape(-1, 2)
        found[dim, tag] = (source, motion.reshape(4, 4) if len(motion) == 16 else np.eye(4), pairs)
    return found


class _Places:
    """Of nodes in the list of points, by their numbers, which ascend."""

    def __init__(self, numbers):
        self.numbers = numbers
        self.from_one = np.array_equal(numbers, np.arange(1, len(numbers) + 1))

    def __call__(self, rows):
        return rows.view(np.int64) - 1 if self.from_one else np.searchsorted(self.numbers, rows)


def _sections(cursor):
    """What _entities gives, what _nodes gives, what _elements gives, and what _periodic gives with places of
    nodes for their numbers."""
    names, entities, nodes, elements, periodic = {}, ({}, {}), None, None, {}
    for section in cursor.sections():
        if section == "MeshFormat":
            cursor.line()
            cursor.take("i")
        elif section == "PhysicalNames":
            names = _physical_names(cursor)
        elif section == "Entities":
            entities = _entities(cursor, names)
        elif section == "Nodes":
            nodes = _nodes(cursor)
        elif section == "Elements" and nodes is not None:
            elements = _elements(cursor, _Places(nodes[0]))
        elif section == "Periodic" and nodes is not None:
            place = _Places(nodes[0])
            periodic = {
                k: (source, motion, place(pairs)) for k, (source, motion, pairs) in _periodic(cursor).items()
            }
        else:
            cursor.at = cursor.data.index(f"$End{section}".encode(), cursor.at)
    if elements is None:
        raise ValueError("it has no nodes, or no elements")
    return entities, nodes, elements, periodic


def read(path):
    """What Mesh is made of, by name; points and elements by ascending number, which is the order that octet
    itself, and its files of other formats, have them in. ValueError when the file is no
    binary MSH 4.1, or is damaged."""
    cursor = _Cursor(path)
    if not cursor.data.startswith(b"$MeshFormat\n4.1 1 8\n"):
        raise ValueError(f"{path} is no binary MSH 4.1 file")
    try:
        (names, groups), (_, points, point_on), (numbers, nodes, on), periodic = _sections(cursor)
    except (ValueError, IndexError) as error:
        raise ValueError(f"{path} cannot be read: {error}") from error
    found = {"points": points, "point_on": point_on, "names": names, "groups": groups, "periodic": periodic}
    second = any(rows.shape[1] == 10 for rows in nodes[3])
    widths = (3, 6, 10) if second else (2, 3, 4)
    kinds = (("edges", "edge_on"), ("triangles", "triangle_on"), ("tets", "tet_in"))
    for dim, ((of, where), width) in enumerate(zip(kinds, widths), 1):
        number = np.concatenate([np.empty(0, dtype=np.uint64), *numbers[dim]])
        rows = np.concatenate([np.empty((0, width), dtype=np.int64), *nodes[dim]])
        tags = np.concatenate([np.empty(0, dtype=np.int32), *on[dim]])
        order = slice(None) if np.all(number[1:] > number[:-1]) else np.argsort(number)
        found[of], found[where] = rows[order], tags[order]
    return found
