# SPDX-License-Identifier: BSD-3-Clause
"""Draws the boundary of a mesh: hidden parts by depth, shaded by the normal. Needs numpy and matplotlib."""
import numpy as np


def boundary_of(vtu):
    """Points, triangles and the triangles' faces of a VTU file as Octet writes it (raw, appended)."""
    with open(vtu, "rb") as file:
        data = file.read()
    split = data.index(b"_", data.index(b"<AppendedData"))
    xml, raw = data[:split].decode(), data[split + 1:]

    def array(section, name, kind):
        body = xml[xml.index(f"<{section}>"):xml.index(f"</{section}>")]
        tag = body[body.rindex("<DataArray", 0, body.index(f'Name="{name}"')):]
        offset = int(tag.split('offset="')[1].split('"')[0])
        length = int(np.frombuffer(raw, "<u8", 1, offset)[0])
        wide = 'type="Int64"' in tag.split(">")[0]
        return np.frombuffer(raw, "<i8" if wide else kind, length // (8 if wide else np.dtype(kind).itemsize),
                             offset + 8)

    points = array("Points", "Points", "<f8").reshape(-1, 3)
    types = array("Cells", "types", "u1")
    ends = array("Cells", "offsets", "<i4").astype(int)
    nodes = array("Cells", "connectivity", "<i4").astype(int)
    tag = array("CellData", "entity_tag", "<i4")
    chosen = np.flatnonzero(types == 5)
    triangles = np.stack([nodes[ends[chosen] - 3 + k] for k in range(3)], axis=1)
    return points, triangles, tag[chosen]


def draw(axes, points, triangles, colours, towards=(1.0, -1.4, 1.5)):
    """Seen from the direction `towards`; `colours` is one RGB triple per triangle."""
    from matplotlib.collections import PolyCollection

    towards = np.array(towards) / np.linalg.norm(towards)
    right = np.cross([0, 0, 1], towards)
    right /= np.linalg.norm(right)
    screen = np.stack([points @ right, points @ np.cross(towards, right)], axis=1)
    corners = points[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    facing = normals @ towards
    seen = np.flatnonzero(facing > 0)
    order = seen[np.argsort(corners[seen].mean(axis=1) @ towards, kind="stable")]
    light = 0.55 + 0.45 * np.clip(normals @ (towards + 0.5 * right + [0, 0, 0.6]) / 1.3, 0, 1)
    shades = np.clip(np.asarray(colours) * light[:, None], 0, 1)
    axes.add_collection(PolyCollection(screen[triangles[order]], facecolors=shades[order],
                                       edgecolors=(0.15, 0.15, 0.2), linewidths=0.25))
    axes.set_xlim(screen[:, 0].min(), screen[:, 0].max())
    axes.set_ylim(screen[:, 1].min(), screen[:, 1].max())
    axes.set_aspect("equal")
    axes.axis("off")


def subplots(*shape, **options):
    """pyplot.subplots, without a screen."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    return pyplot.subplots(*shape, **options)


def save(figure, path):
    """A PNG of few colours, a third as large as others."""
    import io

    from PIL import Image

    whole = io.BytesIO()
    figure.savefig(whole, format="png")
    Image.open(whole).convert("RGB").quantize(48).save(path, optimize=True)
