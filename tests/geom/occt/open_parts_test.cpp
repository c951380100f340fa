// SPDX-License-Identifier: BSD-3-Clause
// Parts without a solid: which of them are missing from the model, and which are only told.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <TopExp_Explorer.hxx>
#include <gp_Pnt.hxx>

#include "compound_of.h"
#include "geom/occt/assemble.h"

namespace octet {
namespace {

/// Faces of a box that share no edges, as a part each; the last `missing` of the six are not there.
std::vector<TopoDS_Shape> loose_faces(const gp_Pnt& corner, int missing) {
  std::vector<TopoDS_Shape> faces;
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(corner, 1.0, 2.0, 3.0).Solid();
  for (TopExp_Explorer it(box, TopAbs_FACE); it.More(); it.Next())
    faces.push_back(BRepBuilderAPI_Copy(it.Current()).Shape());
  faces.resize(faces.size() - static_cast<std::size_t>(missing));
  return faces;
}

ModelParts parts_of(const std::vector<TopoDS_Shape>& shapes) {
  CadDocument document;
  document.shape = compound_of(shapes);
  for (const TopoDS_Shape& shape : shapes) {
    PlacedPart part;
    part.node.name = "part " + std::to_string(document.tree.size());
    part.shape = shape;
    document.tree.push_back(part);
  }
  const OcctLock lock;
  return assemble(document, {}, {}, [](const std::string&) {}).parts;
}

TEST(OpenParts, FacesSewnIntoASolidAreNotLeftOut) {
  std::vector<TopoDS_Shape> shapes = loose_faces({0, 0, 0}, 0);
  const std::vector<TopoDS_Shape> single = loose_faces({5, 0, 0}, 5);
  shapes.insert(shapes.end(), single.begin(), single.end());
  const ModelParts parts = parts_of(shapes);
  EXPECT_EQ(parts.regions.size(), 2u) << "the unused first and the box";
  EXPECT_TRUE(parts.faults.empty()) << parts.faults.front().cause;
  int left = 0;
  for (const LeftOut& item : parts.provenance.left_out) left += item.entity.dim == 2 ? 1 : 0;
  EXPECT_EQ(left, 1) << "the single face";
}

TEST(OpenParts, AShellThatLacksAFaceIsAFault) {
  std::vector<TopoDS_Shape> shapes{BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Solid(),
                                   compound_of(loose_faces({5, 0, 0}, 1))};
  const ModelParts parts = parts_of(shapes);
  ASSERT_EQ(parts.faults.size(), 1u);
  EXPECT_NE(parts.faults[0].cause.find("\"part 1\" is left out"), std::string::npos) << parts.faults[0].cause;
}

}  // namespace
}  // namespace octet
