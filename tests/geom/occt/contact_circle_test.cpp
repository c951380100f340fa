// SPDX-License-Identifier: BSD-3-Clause
// Circles of contact, and where there are none.
#include "geom/occt/contact_circle.h"

#include <gtest/gtest.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>

#include <cmath>
#include <string_view>

#include "geom/occt/canonical.h"

namespace octet {
namespace {

constexpr double kNear = 1e-9;

/// The first face of a kind.
TopoDS_Face face_of(const TopoDS_Shape& shape, std::string_view kind) {
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    if (make_surface(TopoDS::Face(it.Current()), 0)->kind() == kind) return TopoDS::Face(it.Current());
  ADD_FAILURE() << "no " << kind;
  return {};
}

gp_Ax2 upright(double x, double z) { return {gp_Pnt(x, 0, z), gp::DZ()}; }
TopoDS_Face torus(double z) {
  return face_of(BRepPrimAPI_MakeTorus(upright(0, z), 5.0, 1.0).Shape(), "torus");
}
TopoDS_Face ball(double x, double y, double z, double radius) {
  return face_of(BRepPrimAPI_MakeSphere(gp_Pnt(x, y, z), radius).Shape(), "sphere");
}

void expect_circle(const TopoDS_Face& a, const TopoDS_Face& b, double radius, const Vec3& centre) {
  for (const auto& edges : {contact_circles(a, b, kNear), contact_circles(b, a, kNear)}) {
    ASSERT_EQ(edges.size(), 1u);
    const gp_Circ circle = BRepAdaptor_Curve(edges.front()).Circle();
    EXPECT_NEAR(circle.Radius(), radius, 1e-12);
    EXPECT_LT((to_vec(circle.Location()) - centre).norm(), 1e-12);
  }
}

TEST(ContactCircles, ATorusOnAPlane) {
  const TopoDS_Face plane = TopoDS::Face(
      TopExp_Explorer(BRepPrimAPI_MakeBox(gp_Pnt(-9, -9, -3), gp_Pnt(9, 9, -1)).TopFace(), TopAbs_FACE)
          .Current());
  expect_circle(torus(0.0), plane, 5.0, Vec3(0, 0, -1));
  EXPECT_TRUE(contact_circles(torus(1e-6), plane, kNear).empty()) << "above it";
  EXPECT_TRUE(contact_circles(torus(-0.5), plane, kNear).empty()) << "cut by it";
}

TEST(ContactCircles, ATorusAroundACylinder) {
  const auto rod = [](double x) {
    return face_of(BRepPrimAPI_MakeCylinder(upright(x, 0), 4.0, 4.0).Shape(), "cylinder");
  };
  expect_circle(torus(2.0), rod(0.0), 4.0, Vec3(0, 0, 2));
  EXPECT_TRUE(contact_circles(torus(2.0), rod(0.01), kNear).empty()) << "beside its axis";
}

TEST(ContactCircles, ABallInACone) {
  // Half angle 45 degrees, apex at the origin: a ball of radius 1 touches where z = r = 1 / sqrt 2.
  const TopoDS_Face cone = face_of(BRepPrimAPI_MakeCone(upright(0, 0), 0.0, 3.0, 3.0).Shape(), "cone");
  const double h = 1.0 / std::sqrt(2.0);
  expect_circle(ball(0.0, 0.0, std::sqrt(2.0), 1.0), cone, h, Vec3(0, 0, h));
}

TEST(ContactCircles, TwoToriOnOneAnother) { expect_circle(torus(0.0), torus(2.0), 5.0, Vec3(0, 0, 1)); }

TEST(ContactCircles, ABallInATubeOfItsRadius) {
  const auto in_tube = [](double x, double y, double radius) { return ball(x, y, 0.0, radius); };
  expect_circle(in_tube(3, 4, 1.0), torus(0.0), 1.0, Vec3(3, 4, 0));
  EXPECT_TRUE(contact_circles(in_tube(3, 4, 0.9), torus(0.0), kNear).empty()) << "too small";
  EXPECT_TRUE(contact_circles(in_tube(3, 4.1, 1.0), torus(0.0), kNear).empty()) << "beside its middle";
  EXPECT_TRUE(contact_circles(in_tube(5, 0, 1.0), torus(0.0), kNear).empty()) << "there is its seam";
}

TEST(ContactCircles, NoneAlongAnEdgeThatIsThere) {
  // The rod's end, whose rim is where the torus touches the plane that it is in.
  const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(upright(0, -3), 5.0, 2.0).Shape();
  TopoDS_Face end;
  for (TopExp_Explorer it(rod, TopAbs_FACE); it.More(); it.Next()) {
    const auto surface = make_surface(TopoDS::Face(it.Current()), 0);
    if (std::string_view(surface->kind()) == "plane" && surface->evaluate(Vec2::Zero(), 0).p.z() > -2.0)
      end = TopoDS::Face(it.Current());
  }
  ASSERT_FALSE(end.IsNull());
  EXPECT_TRUE(contact_circles(torus(0.0), end, kNear).empty());
}

}  // namespace
}  // namespace octet
