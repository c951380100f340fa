# SPDX-License-Identifier: BSD-3-Clause
"""Groups of a mesh: by the part's elements as FreeCAD counts them, and by the members of an analysis.

FreeCAD looks for the nodes of a constraint in a group that begins with its name, and searches them by their
distance to its faces where there is none: slow, and blind for a middle node that had to stay off its face.
"""
import re

KINDS = ("Vertex", "Edge", "Face", "Solid")  # by dimension
TYPES = ("Node", "Edge", "Face", "Volume")  # of the groups that hold their elements


def groups_by_name(femmesh):
    return {femmesh.getGroupName(g): g for g in femmesh.Groups}


def count_as_freecad(femmesh, renumbered, counts):
    """Gives groups the numbers that FreeCAD shows, where fusing or healing has changed them.

    `renumbered`: of the report, what a number of the file has become; `counts`: by dimension, how many there
    are."""
    by_name = groups_by_name(femmesh)
    members = {}
    for change in renumbered:
        items = set()
        for tag in change["tags"]:
            group = by_name.get(f"{KINDS[change['dim']]}{tag}")
            if group is not None:
                items.update(femmesh.getGroupElements(group))
        members[change["dim"], change["as_read"]] = sorted(items)
    for name, group in by_name.items():
        element = element_of(name)
        if element is None:  # it has a name of its own, as what --cap closes has
            continue
        kind, number = element
        dim = KINDS.index(kind)
        if (dim, number) in members or number > counts[dim]:
            femmesh.removeGroup(group)
    for (dim, number), items in sorted(members.items()):
        if items:
            add_group(femmesh, f"{KINDS[dim]}{number}", TYPES[dim], items)


def number_shown(dim, tag, renumbered, counts):
    """The number that FreeCAD shows for an entity of the mesh's model; None of what the file does not have: a
    piece that two parts share, say."""
    of_dim = [change for change in renumbered if change["dim"] == dim]
    numbers = [change["as_read"] for change in of_dim if tag in change["tags"]]
    if tag <= counts[dim] and all(change["as_read"] != tag for change in of_dim):
        numbers.append(tag)
    return min(numbers, default=None)


def add_group(femmesh, name, kind, items):
    group = femmesh.addGroup(name, kind)
    femmesh.addGroupElements(group, list(items))
    return group


def element_of(sub):
    """("Face", 12) of "Face12", or of "Body.Pad.Face12"; None of what is no vertex, edge, face or solid."""
    found = re.fullmatch(r"(Vertex|Edge|Face|Solid)(\d+)", sub.split(".")[-1])
    return (found[1], int(found[2])) if found else None


def nodes_of(femmesh, by_name, kind, number):
    """Nodes on an element of the part, its borders' among them."""
    group = by_name.get(f"{kind}{number}")
    if group is None:
        return set()
    items = femmesh.getGroupElements(group)
    if kind == "Vertex":
        return set(items)
    return {node for item in items for node in femmesh.getElementNodes(item)}


def add_analysis_groups(femmesh, part, members):
    """For each member of an analysis that refers to elements of `part` the groups NAME_Nodes and, of solids,
    NAME_Volumes, in place of those that there are. Returns the names of members whose elements the mesh
    lacks."""
    by_name = groups_by_name(femmesh)
    lacking = []
    for member in members:
        elements = [
            element_of(sub)
            for target, subs in getattr(member, "References", None) or []
            if target == part
            for sub in ([subs] if isinstance(subs, str) else subs)
        ]
        elements = [e for e in elements if e is not None]
        for suffix in ("Nodes", "Volumes"):
            if f"{member.Name}_{suffix}" in by_name:
                femmesh.removeGroup(by_name[f"{member.Name}_{suffix}"])
        if not elements:
            continue
        nodes, volumes, missing = set(), set(), False
        for kind, number in elements:
            own = nodes_of(femmesh, by_name, kind, number)
            missing |= not own
            nodes |= own
            if kind == "Solid" and own:
                volumes |= set(femmesh.getGroupElements(by_name[f"Solid{number}"]))
        if missing:
            lacking.append(member.Name)
            continue
        add_group(femmesh, f"{member.Name}_Nodes", "Node", sorted(nodes))
        if volumes:
            add_group(femmesh, f"{member.Name}_Volumes", "Volume", sorted(volumes))
    return lacking
