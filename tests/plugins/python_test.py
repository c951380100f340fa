# SPDX-License-Identifier: BSD-3-Clause
"""Octet's Python package, with the built program: $OCTET, $PYTHONPATH and $OCTET_MODELS."""
import gc
import os
import re
import shutil
import tempfile
import unittest

import meshio
import numpy as np

import octet

MODELS = os.environ["OCTET_MODELS"]
EDGES = [
    (0, 1),
    (1, 2),
    (2, 0),
    (0, 3),
    (1, 3),
    (2, 3),
]  # of a tetrahedron, as VTK has the nodes in their middles


def model(name):
    return os.path.join(MODELS, name)


def volumes(mesh):
    a, b, c, d = (mesh.points[mesh.tets[:, k]] for k in range(4))
    return np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) / 6


def areas(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def mean_edges(mesh):
    return np.mean(
        [
            np.linalg.norm(mesh.points[mesh.tets[:, a]] - mesh.points[mesh.tets[:, b]], axis=1)
            for a, b in EDGES
        ],
        axis=0,
    )


class Arrays(unittest.TestCase):
    def test_tetrahedra_fill_the_part_and_know_their_regions(self):
        mesh = octet.mesh(model("two_boxes.step"))
        self.assertTrue(mesh.complete)
        self.assertEqual(len(mesh.points), mesh.report["nodes"])
        self.assertEqual(len(mesh.tets), mesh.report["tets"])
        self.assertGreater(volumes(mesh).min(), 0)
        self.assertEqual(set(mesh.tet_in), {1, 2})
        for region in mesh.report["regions"]:
            of_region = volumes(mesh)[mesh.tet_in == region["tag"]].sum()
            self.assertAlmostEqual(of_region / region["volume"]["cad"], 1, places=9)

    def test_triangles_lie_on_their_faces_which_they_cover(self):
        part = model("bracket.step")
        mesh = octet.mesh(part, threads=2)
        for face in octet.info(part)["faces"]:
            if face["surface"] != "plane":
                continue
            triangles = mesh.elements((2, face["tag"]))
            self.assertAlmostEqual(areas(mesh.points, triangles).sum() / face["area"], 1, delta=0.02)
            flat = mesh.points[mesh.nodes(f"Face{face['tag']}")]
            self.assertLess(
                np.linalg.svd(flat - flat.mean(axis=0))[1][-1], 1e-9 * mesh.report["diagonal"] * len(flat)
            )

    def test_info_tells_what_is_at_places(self):
        at = octet.info(model("box.step"), at=["0,9,14", "5,5,5"])["at"]
        self.assertEqual([place["on"] for place in at], [{"dim": 2, "tag": 1}, None])
        self.assertEqual([place["regions"] for place in at], [[1], [1]])

    def test_points_know_the_least_entity_that_holds_them(self):
        mesh = octet.mesh(model("cylinder.step"))
        self.assertEqual(set(mesh.point_on[:, 0]), {0, 1, 2, 3})
        inside = mesh.point_on[:, 0] == 3
        self.assertFalse(np.isin(np.flatnonzero(inside), mesh.triangles).any())
        self.assertTrue(np.isin(np.flatnonzero(~inside), mesh.triangles).all())
        for (node,) in mesh.elements("Vertex1"):
            self.assertEqual(tuple(mesh.point_on[node]), (0, 1))
            self.assertIn(node, mesh.nodes("Edge1"))

    def test_nodes_in_the_middles_are_in_the_order_of_vtk(self):
        mesh = octet.mesh(model("ball.step"), order=2)
        self.assertEqual((mesh.order, mesh.tets.shape[1], mesh.triangles.shape[1]), (2, 10, 6))
        for k, (a, b) in enumerate(EDGES):
            middles = 0.5 * (mesh.points[mesh.tets[:, a]] + mesh.points[mesh.tets[:, b]])
            off = np.linalg.norm(mesh.points[mesh.tets[:, 4 + k]] - middles, axis=1)
            self.assertLess((off / mean_edges(mesh)).max(), 0.2, f"node {4 + k}")
        radius = np.linalg.norm(
            mesh.points[mesh.nodes("Face1")] - mesh.points[mesh.nodes("Face1")].mean(axis=0), axis=1
        )
        self.assertLess(np.ptp(radius), 0.05 * radius.mean())

    def test_names_and_patterns_find_entities(self):
        mesh = octet.mesh(model("bracket.step"))
        self.assertEqual(mesh.names[3, 1], "bracket 1")
        self.assertEqual(mesh.entities("bracket*"), [(3, 1)])
        self.assertEqual(mesh.entities("face7"), [(2, 7)])
        self.assertEqual(mesh.entities("Solid1"), [(3, 1)])
        self.assertEqual(len(mesh.entities("Face?")), 9)
        mesh.names[2, 5] = "Face7"
        self.assertEqual(mesh.entities("Face7"), [(2, 7)])
        self.assertEqual(len(mesh.elements("bracket*")), len(mesh.tets))
        with self.assertRaisesRegex(KeyError, "did you mean 'bracket 1'"):
            mesh.nodes("braket 1")
        with self.assertRaisesRegex(KeyError, "nothing on Face99"):
            mesh.elements("Face99")
        with self.assertRaisesRegex(ValueError, "several dimensions"):
            mesh.elements("*1")

    def test_groups_are_found_by_their_names(self):
        box = octet.mesh(
            model("box.step"), size=5, group={"ends": "Face1-2", "rim": "Edge:*", "body": "Region1"}
        )
        self.assertEqual(box.groups["ends"], [(2, 1), (2, 2)])
        both = set(box.nodes("Face1")) | set(box.nodes("Face2"))
        self.assertEqual(set(box.nodes("ends")), both)
        self.assertEqual(len(box.elements("rim")), len(box.edges))
        self.assertEqual(len(box.elements("body")), len(box.tets))
        self.assertNotIn("ends", box.names.values())
        with self.assertRaisesRegex(KeyError, "did you mean 'ends'"):
            box.nodes("endz")

    def test_faces_may_be_images_of_others(self):
        mesh = octet.mesh(model("box.step"), size=5, periodic=["x", "y"])
        faces = [entity for entity in mesh.periodic if entity[0] == 2]
        self.assertEqual(len(faces), 2)
        for entity, (source, motion, pairs) in mesh.periodic.items():
            moved = mesh.points[pairs[:, 1]] @ motion[:3, :3].T + motion[:3, 3]
            np.testing.assert_allclose(moved, mesh.points[pairs[:, 0]], atol=1e-9)
            if entity[0] == 2:
                np.testing.assert_array_equal(np.sort(pairs[:, 0]), mesh.nodes(f"Face{entity[1]}"))
                np.testing.assert_array_equal(np.sort(pairs[:, 1]), mesh.nodes(f"Face{source}"))
        self.assertEqual(octet.mesh(model("box.step"), size=5).periodic, {})

    def test_the_order_may_stand_in_a_file_of_options(self):
        with tempfile.TemporaryDirectory() as folder:
            options = os.path.join(folder, "options.json")
            with open(options, "w", encoding="utf-8") as file:
                file.write('{"order": 2, "size": 9}')
            mesh = octet.mesh(model("box.step"), config=options)
            self.assertEqual((mesh.order, mesh.report["size"]), (2, 9))
            self.assertEqual(octet.mesh(model("box.step"), config=options, order=1).order, 1)

    def test_order_is_that_of_the_numbers_in_files(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.inp")
            mesh = octet.mesh(model("two_boxes.step"), output=path)
            nodes, tets, current = [], [], None
            with open(path, encoding="ascii") as file:
                for line in file:
                    if line.startswith("*"):
                        current = {"*NODE": nodes, "*ELEMENT": tets}.get(line.split(",")[0].strip())
                    elif current is not None:
                        current.append([float(word) for word in line.split(",")])
        nodes, tets = np.array(nodes), np.array(sorted(tets))
        np.testing.assert_array_equal(nodes[:, 0], np.arange(1, len(mesh.points) + 1))
        np.testing.assert_allclose(nodes[:, 1:], mesh.points, rtol=1e-12, atol=1e-12)
        np.testing.assert_array_equal(tets[:, 1:] - 1, mesh.tets)


class Sizes(unittest.TestCase):
    def test_sizes_at_places_and_over_space_are_met(self):
        part = model("box.step")
        box = np.array([octet.info(part)["box"][end] for end in ("lo", "hi")])
        size = np.ptp(box, axis=0).max() / 5
        coarse = octet.mesh(part, size)
        at_face = octet.mesh(part, size, size_at={"Face1": size / 4, "Vertex1": np.float64(size / 8)})
        short = areas(at_face.points, at_face.elements("Face1")).mean()
        self.assertLess(short, areas(coarse.points, coarse.elements("Face1")).mean() / 8)
        points = np.vstack([box[0], box[1]])
        graded = octet.mesh(part, size, field=(points, [size / 4, size]))
        near = np.linalg.norm(graded.points[graded.tets].mean(axis=1) - box[0], axis=1) < size
        self.assertLess(mean_edges(graded)[near].mean(), 0.4 * size)
        self.assertGreater(mean_edges(graded).max(), 0.8 * size)

    def test_a_mesh_is_adapted_to_sizes_of_its_elements(self):
        part = model("l_domain.step")
        mesh = octet.mesh(part, uniform=True, unit="m")
        self.assertLess(np.ptp(mesh.points), 1)
        middles = mesh.points[mesh.tets].mean(axis=1)
        near = np.hypot(middles[:, 0], middles[:, 1]) < 0.003
        finer = octet.adapt(mesh, part, np.where(near, 0.25, 1) * mean_edges(mesh), uniform=True)
        again = finer.points[finer.tets].mean(axis=1)
        count = (np.hypot(middles[:, 0], middles[:, 1]) < 0.003).sum()
        self.assertGreater((np.hypot(again[:, 0], again[:, 1]) < 0.003).sum(), 16 * count)
        self.assertLess(np.ptp(finer.points), 1)  # metres as before
        of_nodes = np.full(len(mesh.points), mean_edges(mesh).mean())
        of_nodes[np.hypot(mesh.points[:, 0], mesh.points[:, 1]) < 0.003] /= 4
        graded = octet.adapt(mesh, part, of_nodes, uniform=True)
        middles = graded.points[graded.tets].mean(axis=1)
        self.assertGreater((np.hypot(middles[:, 0], middles[:, 1]) < 0.003).sum(), 8 * count)
        with self.assertRaisesRegex(ValueError, "neither one for each"):
            octet.adapt(mesh, part, [1.0, 2.0])


class Runs(unittest.TestCase):
    def test_what_is_no_mesh_raises_with_the_reason(self):
        with self.assertRaisesRegex(octet.OctetError, "nowhere.step' does not exist"):
            octet.mesh("nowhere.step")
        with self.assertRaisesRegex(octet.OctetError, "did you mean --wall-elements"):
            octet.mesh(model("box.step"), wall_element=2)
        with self.assertRaisesRegex(octet.OctetError, "--size"):
            octet.mesh(model("box.step"), -1)
        with self.assertRaisesRegex(TypeError, "a shape with exportBrep, not int"):
            octet.mesh(3)

    def test_a_mesh_that_is_not_right_is_not_handed_over_in_silence(self):
        part = model("fixture_open_block.step")
        with self.assertRaisesRegex(octet.IncompleteError, "incomplete, [0-9]+ fault") as caught:
            octet.mesh(part)
        self.assertFalse(caught.exception.mesh.complete)
        self.assertIn(caught.exception.mesh.report["faults"][0]["cause"], str(caught.exception))
        self.assertEqual(octet.mesh(part, incomplete="accept").report["status"], "incomplete")
        self.assertTrue(octet.mesh(part, cap=True).complete)

    def test_progress_is_told_in_order_and_may_end_the_run(self):
        told = []
        octet.mesh(model("blade.step"), progress=lambda stage, fraction: told.append((stage, fraction)))
        self.assertEqual(told[0], ("reading", 0))
        self.assertIn("finalization", [stage for stage, _ in told])
        self.assertEqual([fraction for _, fraction in told], sorted(fraction for _, fraction in told))

        def stop(stage, fraction):
            raise KeyboardInterrupt

        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaises(KeyboardInterrupt):
                octet.mesh(model("blade.step"), 0.3, progress=stop, output=os.path.join(folder, "a.msh"))
            self.assertEqual(os.listdir(folder), [])

    def test_a_run_ends_with_its_time(self):
        with self.assertRaisesRegex(octet.OctetError, "cancelled"):
            octet.mesh(model("blade.step"), 0.3, time_limit=0.5)

    def test_files_are_kept_where_they_are_asked_for_and_no_others(self):
        with tempfile.TemporaryDirectory() as folder:
            files = [os.path.join(folder, name) for name in ("a.msh", "a.inp", "a.vtu")]
            mesh = octet.mesh(model("torus.step"), output=files)
            self.assertEqual(sorted(os.listdir(folder)), ["a.inp", "a.msh", "a.vtu"])
            np.testing.assert_array_equal(octet.read(files[0]).tets, mesh.tets)
            np.testing.assert_array_equal(octet.read(files[0]).points, mesh.points)
            copy = os.path.join(folder, "b.msh")
            mesh.save(copy)
            with open(copy, "rb") as one, open(files[0], "rb") as other:
                self.assertEqual(one.read(), other.read())
            own = mesh.file
            self.assertTrue(os.path.exists(own))
            del mesh
            gc.collect()
            self.assertFalse(os.path.exists(os.path.dirname(own)))

    def test_a_shape_that_writes_itself_is_a_part(self):
        class Shape:
            def exportBrep(self, path):
                shutil.copyfile(model("box.step"), path)

        class Workplane:
            def val(self):
                return Shape()

        same = octet.mesh(model("box.step")).tets
        np.testing.assert_array_equal(octet.mesh(Shape()).tets, same)
        np.testing.assert_array_equal(octet.mesh(Workplane()).tets, same)

    def test_meshes_are_checked_measured_and_improved(self):
        part = model("plate_with_hole.step")
        rough = octet.mesh(part, no_finalize=True, unit="inch")
        self.assertEqual(octet.check(rough, part)["status"], "complete")
        better = octet.improve(rough, part)
        self.assertTrue(better.complete)
        least = [octet.quality(mesh)["worst"][0]["min_dihedral"] for mesh in (rough, better)]
        self.assertGreater(least[1], least[0] + 5)
        self.assertEqual(octet.check(better, model("box.step"), unit="inch")["status"], "incomplete")


    def test_pieces_of_a_part_are_parts(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "piece.step")
            self.assertEqual(octet.extract(model("box.step"), "Face1", path, around=0), path)
            with open(path, encoding="utf-8") as file:
                self.assertEqual(len(re.findall("ADVANCED_FACE", file.read())), 1)
            self.assertEqual(octet.extract(model("box.step"), ["Face1", "Face2"], path, around=1), path)
            with open(path, encoding="utf-8") as file:
                self.assertEqual(len(re.findall("ADVANCED_FACE", file.read())), 6)
            with self.assertRaisesRegex(octet.OctetError, "Face99"):
                octet.extract(model("box.step"), "Face99", path)


class Files(unittest.TestCase):
    def test_the_package_has_the_version_of_the_program(self):
        package = os.path.dirname(os.path.dirname(octet.__file__))
        with open(os.path.join(package, "pyproject.toml"), encoding="utf-8") as file:
            (version,) = re.findall(r'^version = "(.*)"$', file.read(), flags=re.MULTILINE)
        self.assertEqual(version, octet.mesh(model("box.step")).report["octet"])

    def test_a_damaged_file_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.msh")
            octet.mesh(model("box.step"), output=path)
            with open(path, "rb") as file:
                whole = file.read()
            for part in (b"", whole[:100], whole[: len(whole) // 2], b"$MeshFormat\n2.2 0 8\n"):
                with open(path, "wb") as file:
                    file.write(part)
                with self.assertRaises(ValueError):
                    octet.read(path)

    def test_nodes_may_have_any_numbers(self):
        """What meshio writes anew has other blocks; Octet's has numbers of its own here."""
        mesh = octet.mesh(model("box.step"))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.msh")
            with open(mesh.file, "rb") as file:
                data = bytearray(file.read())
            _renumber(data)
            with open(path, "wb") as file:
                file.write(data)
            other = octet.read(path)
        np.testing.assert_array_equal(other.points[other.tets], mesh.points[mesh.tets])

    def test_meshio_takes_both_orders(self):
        for order, kind in ((1, "tetra"), (2, "tetra10")):
            mesh = octet.mesh(model("ball.step"), order=order)
            other = mesh.to_meshio()
            with tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, "a.vtu")
                other.write(path)
                other = meshio.read(path)
            np.testing.assert_array_equal(other.cells_dict[kind], mesh.tets)
            np.testing.assert_array_equal(other.cell_data_dict["entity"][kind], mesh.tet_in)
            read = meshio.read(mesh.file)
            rows = np.vstack([block.data for block in read.cells if block.type == kind])
            np.testing.assert_array_equal(read.points[rows], mesh.points[mesh.tets])

    def test_med_files_have_a_group_for_every_entity(self):
        mesh = octet.mesh(model("two_boxes.step"))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.med")
            mesh.to_meshio().write(path)
            read = meshio.read(path)
        for kind, dim, rows, on in (
            ("line", 1, mesh.edges, mesh.edge_on),
            ("triangle", 2, mesh.triangles, mesh.triangle_on),
            ("tetra", 3, mesh.tets, mesh.tet_in),
        ):
            np.testing.assert_array_equal(read.cells_dict[kind], rows)
            groups = [read.cell_tags[family] for family in read.cell_data_dict["cell_tags"][kind]]
            self.assertEqual(groups, [[mesh.names[dim, tag]] for tag in on])
            alone = mesh.to_meshio(dim)
            self.assertEqual([block.type for block in alone.cells], [kind])
            np.testing.assert_array_equal(alone.cell_data["entity"][0], on)
            self.assertEqual((list(alone.cell_data), list(alone.point_data)), (["entity"], []))
        for point, (dim, tag) in enumerate(mesh.point_on):
            family = read.point_data["point_tags"][point]
            self.assertEqual(read.point_tags.get(family), [mesh.names[0, tag]] if dim == 0 else None)

    def test_the_programs_own_med_files_are_read_by_meshio(self):
        """MED's tetrahedra are turned the other way round; meshio takes nodes as they stand."""
        for order, kind, places in (
            (1, "tetra", [0, 2, 1, 3]),
            (2, "tetra10", [0, 2, 1, 3, 6, 5, 4, 7, 9, 8]),
        ):
            with tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, "a.med")
                try:
                    mesh = octet.mesh(model("two_boxes.step"), order=order, output=path)
                except octet.OctetError as error:
                    if "built without" not in str(error):
                        raise
                    self.skipTest(str(error))
                read = meshio.read(path)
            np.testing.assert_array_equal(read.points, mesh.points)
            np.testing.assert_array_equal(read.cells_dict[kind], mesh.tets[:, places])
            families = read.cell_data_dict["cell_tags"][kind]
            groups = {(tag, *read.cell_tags[family]) for tag, family in zip(mesh.tet_in, families)}
            self.assertEqual(sorted(len(set(column)) for column in zip(*groups)), [2, 2])
            faces = read.cells_dict["triangle" if order == 1 else "triangle6"]
            np.testing.assert_array_equal(faces, mesh.triangles)


def _renumber(data):
    """Nodes of a binary MSH 4.1 file get the numbers 3, 6, ..., the last first."""

    def whole(at, count=1):
        return np.frombuffer(data, "<u8", count, at)

    at = data.index(b"$Nodes\n") + 7
    blocks, count = (int(n) for n in whole(at, 2))
    new = 3 * (count + 1 - np.arange(count + 1, dtype="<u8"))
    at += 32
    for _ in range(blocks):
        (size,) = (int(n) for n in whole(at + 12))
        at += 20
        data[at : at + 8 * size] = new[whole(at, size)].tobytes()
        at += 32 * size
    at = data.index(b"$Elements\n") + 10
    (blocks,) = (int(n) for n in whole(at))
    at += 32
    for _ in range(blocks):
        kind = int(np.frombuffer(data, "<i4", 1, at + 8)[0])
        width = 1 + {15: 1, 1: 2, 2: 3, 4: 4}[kind]
        (size,) = (int(n) for n in whole(at + 12))
        at += 20
        rows = whole(at, size * width).reshape(size, width).copy()
        rows[:, 1:] = new[rows[:, 1:]]
        data[at : at + rows.nbytes] = rows.tobytes()
        at += rows.nbytes


if __name__ == "__main__":
    unittest.main()
