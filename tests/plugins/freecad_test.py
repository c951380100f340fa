# SPDX-License-Identifier: BSD-3-Clause
"""The plug-in for FreeCAD, run by freecadcmd. $OCTET is the program, $OCTET_PLUGIN the folder of the plug-in.

FreeCAD ends with 0 whatever a script does; that all went well is the last line that it prints."""
import os
import sys
import unittest

import FreeCAD
import Fem
import ObjectsFem
import Part
import numpy

sys.path.insert(0, os.environ["OCTET_PLUGIN"])
import octet_freecad
from octet_freecad import groups, mesher, program
import octet

V = FreeCAD.Vector


def corners(femmesh, triangle):
    nodes = femmesh.Nodes
    return [nodes[n] for n in femmesh.getElementNodes(triangle)[:3]]


def area(femmesh, triangles):
    total = 0.0
    for triangle in triangles:
        a, b, c = corners(femmesh, triangle)
        total += 0.5 * (b - a).cross(c - a).Length
    return total


def volume(femmesh):
    """Of the elements between their corners; FreeCAD's own is nought for elements of first order."""
    nodes, total = femmesh.Nodes, 0.0
    for tetrahedron in femmesh.Volumes:
        a, b, c, d = (nodes[n] for n in femmesh.getElementNodes(tetrahedron)[:4])
        total += abs((b - a).cross(c - a).dot(d - a)) / 6.0
    return total


class OctetInFreeCAD(unittest.TestCase):
    def setUp(self):
        self.document = FreeCAD.newDocument()

    def tearDown(self):
        FreeCAD.closeDocument(self.document.Name)

    def part(self, shape):
        part = self.document.addObject("Part::Feature", "Part")
        part.Shape = shape
        self.document.recompute()
        return part

    def meshed(self, shape, **words):
        obj = octet_freecad.make_mesh(self.document, self.part(shape))
        for name, value in words.items():
            setattr(obj, name, value)
        octet_freecad.mesh(obj)
        self.assertEqual((obj.Status, list(obj.Faults)), ("complete", []))
        return obj

    def check_groups(self, obj, tolerance):
        """Each vertex, face and solid of the shape has its group, and there are no others of these kinds."""
        shape, femmesh = obj.Part.Shape, obj.FemMesh
        by_name = groups.groups_by_name(femmesh)
        for kind, items in (("Vertex", shape.Vertexes), ("Face", shape.Faces), ("Solid", shape.Solids)):
            self.assertEqual(
                {name for name in by_name if name.startswith(kind)},
                {f"{kind}{k}" for k in range(1, len(items) + 1)},
            )
        for k, face in enumerate(shape.Faces, 1):
            triangles = femmesh.getGroupElements(by_name[f"Face{k}"])
            self.assertAlmostEqual(area(femmesh, triangles) / face.Area, 1.0, delta=tolerance)
            for node in sorted(groups.nodes_of(femmesh, by_name, "Face", k))[::17]:
                self.assertLess(face.distToShape(Part.Vertex(femmesh.Nodes[node]))[0], 1e-6)
        for k, edge in enumerate(shape.Edges, 1):
            for node in groups.nodes_of(femmesh, by_name, "Edge", k):
                self.assertLess(edge.distToShape(Part.Vertex(femmesh.Nodes[node]))[0], 1e-6)
        for k, vertex in enumerate(shape.Vertexes, 1):
            (node,) = femmesh.getGroupElements(by_name[f"Vertex{k}"])
            self.assertLess((femmesh.Nodes[node] - vertex.Point).Length, 1e-6)

    def test_groups_are_the_elements_that_freecad_shows(self):
        bored = Part.makeBox(20, 14, 8).cut(Part.makeCylinder(3, 30, V(7, 7, -5)))
        for order in ("1st", "2nd"):
            obj = self.meshed(bored, ElementOrder=order, Size=3)
            self.check_groups(obj, 0.02)
            self.assertAlmostEqual(volume(obj.FemMesh) / bored.Volume, 1.0, delta=0.01)
            self.assertEqual(
                {len(obj.FemMesh.getElementNodes(t)) for t in obj.FemMesh.Volumes},
                {4 if order == "1st" else 10},
            )

    def test_groups_of_parts_that_touch_are_those_of_the_parts(self):
        # A small box on a large one: the large one's top is split, the small one's bottom is shared.
        stacked = Part.makeCompound(
            [Part.makeBox(20, 20, 6), Part.makeBox(8, 8, 5, V(6, 6, 6)), Part.makeBox(20, 20, 6, V(20, 0, 0))]
        )
        obj = self.meshed(stacked, Size=4)
        self.check_groups(obj, 1e-9)
        volumes = [
            len(obj.FemMesh.getGroupElements(group))
            for name, group in groups.groups_by_name(obj.FemMesh).items()
            if name.startswith("Solid")
        ]
        self.assertEqual(sum(volumes), obj.FemMesh.VolumeCount)

    def test_groups_with_names_of_their_own_stay(self):
        # A face that closes the open box has no number in FreeCAD, but a name.
        open_box = Part.makeShell(Part.makeBox(10, 10, 10, V(40, 0, 0)).Faces[:5])
        obj = self.meshed(Part.makeCompound([Part.makeBox(10, 10, 10), open_box]), Size=4, Options="--cap")
        names = set(groups.groups_by_name(obj.FemMesh))
        self.assertIn("cap_1", names)
        self.assertEqual(
            {name for name in names if name.startswith("Face")}, {f"Face{k}" for k in range(1, 12)}
        )

    def test_local_sizes_are_by_the_numbers_that_freecad_shows(self):
        apart = [Part.makeBox(20, 20, 6), Part.makeBox(20, 20, 6, V(20, 0, 0))]
        number = 6 + [face.CenterOfMass.x for face in apart[1].Faces].index(40.0) + 1
        obj = self.meshed(Part.makeCompound(apart), Size=5, LocalSizes=[f"Face{number}=1"])
        by_name = groups.groups_by_name(obj.FemMesh)
        triangles = {k: len(obj.FemMesh.getGroupElements(by_name[f"Face{k}"])) for k in (number, number - 6)}
        # 240 triangles of this size would fill it; the same face of the other box is as coarse as asked for.
        self.assertGreater(triangles[number], 200)
        self.assertLess(triangles[number - 6], 100)

    def test_analysis_finds_its_nodes_and_bends_as_a_beam_does(self):
        length, height, force, young = 100.0, 10.0, 100.0, 210000.0
        part = self.part(Part.makeBox(length, height, height))
        face_at = {face.CenterOfMass.x: f"Face{k}" for k, face in enumerate(part.Shape.Faces, 1)}
        analysis = ObjectsFem.makeAnalysis(self.document, "Analysis")
        fixed = ObjectsFem.makeConstraintFixed(self.document, "Fixed")
        fixed.References = [(part, face_at[0.0])]
        load = ObjectsFem.makeConstraintForce(self.document, "Load")
        load.References = [(part, face_at[length])]
        load.Force = force
        load.Direction = (part, ["Edge5"])
        material = ObjectsFem.makeMaterialSolid(self.document, "Steel")
        words = material.Material
        words.update(Name="Steel", YoungsModulus=f"{young} MPa", PoissonRatio="0.30", Density="7900 kg/m^3")
        material.Material = words
        material.References = [(part, "Solid1")]
        solver = ObjectsFem.makeSolverCalculixCcxTools(self.document)
        for member in (solver, material, fixed, load):
            analysis.addObject(member)
        obj = octet_freecad.make_mesh(self.document, part)
        analysis.addObject(obj)
        obj.Size = 5
        octet_freecad.mesh(obj)
        self.assertEqual((obj.Status, list(obj.Faults)), ("complete", []))
        by_name = groups.groups_by_name(obj.FemMesh)
        at_wall = {n for n, p in obj.FemMesh.Nodes.items() if p.x == 0.0}
        self.assertEqual(set(obj.FemMesh.getGroupElements(by_name["Fixed_Nodes"])), at_wall)
        self.assertEqual(
            set(obj.FemMesh.getGroupElements(by_name["Steel_Volumes"])), set(obj.FemMesh.Volumes)
        )
        # Another constraint, after the mesh.
        late = ObjectsFem.makeConstraintDisplacement(self.document, "Late")
        late.References = [(part, face_at[length])]
        analysis.addObject(late)
        self.assertEqual(mesher.update_groups(obj), [])
        by_name = groups.groups_by_name(obj.FemMesh)
        self.assertEqual(
            {obj.FemMesh.Nodes[n].x for n in obj.FemMesh.getGroupElements(by_name["Late_Nodes"])}, {length}
        )
        self.assertEqual(set(obj.FemMesh.getGroupElements(by_name["Fixed_Nodes"])), at_wall)
        self.document.removeObject(late.Name)

        from femtools import ccxtools

        solve = ccxtools.FemToolsCcx(analysis, solver)
        solve.update_objects()
        solve.setup_working_dir()
        solve.setup_ccx()
        self.assertTrue(solve.ccx_binary_present)
        self.assertEqual(solve.check_prerequisites(), "")
        solve.purge_results()
        solve.write_inp_file()
        solve.ccx_run()
        solve.load_results()
        (result,) = [o for o in analysis.Group if o.isDerivedFrom("Fem::FemResultObject")]
        inertia = height**4 / 12
        bending = force * length**3 / (3 * young * inertia)
        shear = force * length / (5.0 / 6.0 * height**2 * young / 2.6)
        self.assertAlmostEqual(max(result.DisplacementLengths) / (bending + shear), 1.0, delta=0.01)

    def test_what_cannot_be_meshed_says_why_and_keeps_the_mesh_there_was(self):
        obj = self.meshed(Part.makeBox(10, 10, 10), Size=3)
        tetrahedra = obj.FemMesh.TetraCount
        obj.LocalSizes = ["Face7=1"]
        with self.assertRaisesRegex(octet_freecad.OctetError, "Face%7.*names nothing"):
            octet_freecad.mesh(obj)
        self.assertEqual(obj.Status, "failed")
        self.assertIn("Face%7", obj.Faults[0])
        self.assertEqual(obj.FemMesh.TetraCount, tetrahedra)
        obj.LocalSizes = []
        obj.Part = self.part(Part.makeShell(Part.makeBox(10, 10, 10).Faces[:5]))
        with self.assertRaisesRegex(octet_freecad.OctetError, "has no solid"):
            octet_freecad.mesh(obj)

    def test_a_run_can_be_stopped(self):
        obj = octet_freecad.make_mesh(self.document, self.part(Part.makeTorus(50, 20)))
        obj.TargetElements = 20000000
        with self.assertRaisesRegex(octet_freecad.OctetError, "cancelled"):
            octet_freecad.mesh(obj, time_limit=0.5)
        self.assertEqual(obj.Status, "failed")

    def test_a_document_keeps_the_object_and_its_mesh(self):
        obj = self.meshed(Part.makeBox(10, 10, 10), Size=3, LocalSizes=["Edge3=/12"])
        path = os.path.join(os.environ["OCTET_SCRATCH"], "kept.FCStd")
        self.document.saveAs(path)
        name, count = obj.Name, obj.FemMesh.GroupCount
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        again = self.document.getObject(name)
        self.assertIsInstance(again.Proxy, octet_freecad.mesh_object.OctetMesh)
        self.assertEqual(
            (again.FemMesh.GroupCount, again.LocalSizes, again.Size.Value), (count, ["Edge3=/12"], 3.0)
        )
        octet_freecad.mesh(again)
        self.assertEqual(again.Status, "complete")

    def test_the_program_is_where_it_is_said_to_be(self):
        self.assertEqual(program.find_program(), os.environ["OCTET"])
        with self.assertRaisesRegex(octet_freecad.OctetError, "no_such_octet is not a program"):
            program.find_program("no_such_octet")

    def test_the_python_package_meshes_a_shape_of_freecad(self):
        mesh = octet.mesh(Part.makeCylinder(5, 20), 2, size_at={"Face%1": 1})
        self.assertTrue(mesh.complete)
        a, b, c, d = (mesh.points[mesh.tets[:, k]] for k in range(4))
        volume = ((b - a) * numpy.cross(c - a, d - a)).sum() / 6
        self.assertAlmostEqual(volume / (numpy.pi * 25 * 20), 1, delta=0.02)

    def test_words_of_sizes(self):
        for line, words in (
            ("Face12=0.5", "Face%12=0.5"),
            (" edge3-7=/4", "edge%3-7=/4"),
            ("Solid2=4", "Region%2=4"),
            ("Face@1,2,3=0.5", "Face@1,2,3=0.5"),
            ("ball:0,0,0,4=1", "ball:0,0,0,4=1"),
        ):
            self.assertEqual(mesher.size_words(line), words)


suite = unittest.defaultTestLoader.loadTestsFromTestCase(OctetInFreeCAD)
result = unittest.TextTestRunner(stream=sys.stdout, verbosity=2).run(suite)
print(f"\n{result.testsRun} tests of the plug-in", "pass" if result.wasSuccessful() else "FAIL", flush=True)
sys.stdout.flush()
os._exit(0 if result.wasSuccessful() else 1)
