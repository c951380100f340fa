// SPDX-License-Identifier: BSD-3-Clause
// Faces are found whatever the order of their vertices, and know on which side their tetrahedra lie.
#include "mesh/face_uses.h"

#include <gtest/gtest.h>

#include "tests/support/box_mesh.h"

namespace octet {
namespace {

TEST(FaceUses, AreFourPerTetrahedronAndSorted) {
  const Mesh mesh = test::plain_box_mesh(3);
  const FaceUses uses(mesh);
  ASSERT_EQ(uses.all().size(), 4 * mesh.tets.size());
  for (std::size_t i = 1; i < uses.all().size(); ++i) EXPECT_LE(uses.all()[i - 1].v, uses.all()[i].v);
}

TEST(FaceUses, BoundaryFacesHaveOneUseAndInnerFacesTwoOnOppositeSides) {
  const Mesh mesh = test::plain_box_mesh(3);
  const FaceUses uses(mesh);
  std::size_t single = 0;
  for (std::size_t i = 0; i < uses.all().size();) {
    const auto group = uses.group(i);
    i += group.size();
    ASSERT_LE(group.size(), 2u);
    if (group.size() == 1) ++single;
    if (group.size() == 2) {
      EXPECT_NE(group[0].even, group[1].even);
    }
  }
  EXPECT_EQ(single, mesh.triangles.size());
}

TEST(FaceUses, OfFlaggedVerticesAreThoseOfAllWithFlaggedVertices) {
  const Mesh mesh = test::plain_box_mesh(3);
  std::vector<std::uint8_t> flagged(mesh.points.size(), 0);
  for (const auto& t : mesh.triangles)
    for (const Mesh::Index v : t) flagged[v] = 1;
  const FaceUses all(mesh), some(mesh, flagged);
  std::size_t expected = 0;
  for (const FaceUse& use : all.all()) {
    if (flagged[use.v[0]] == 0 || flagged[use.v[1]] == 0 || flagged[use.v[2]] == 0) continue;
    ASSERT_LT(expected, some.all().size());
    EXPECT_EQ(some.all()[expected].v, use.v);
    EXPECT_EQ(some.all()[expected].tet, use.tet);
    ++expected;
  }
  EXPECT_EQ(expected, some.all().size());
  EXPECT_LT(some.all().size(), all.all().size());
}

TEST(FaceUses, AnOutwardTriangleHasTheParityOfItsUse) {
  const Mesh mesh = test::plain_box_mesh(2);
  const FaceUses uses(mesh);
  for (const auto& t : mesh.triangles) {
    const auto found = uses.find({t[1], t[2], t[0]});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].even, sorted_face(t).even);
    EXPECT_NE(found[0].even, sorted_face({t[1], t[0], t[2]}).even);
  }
  EXPECT_TRUE(uses.find({0, 1, static_cast<Mesh::Index>(mesh.points.size() - 1)}).empty());
}

}  // namespace
}  // namespace octet
