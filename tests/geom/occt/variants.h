// SPDX-License-Identifier: BSD-3-Clause
// One part five times: as it is, of splines, far away, small, turned.
#pragma once

#include <gtest/gtest.h>

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <TopoDS_Shape.hxx>
#include <functional>
#include <gp_Trsf.hxx>
#include <string>
#include <vector>

#include "geom/occt/from_shape.h"

namespace octet::test {

struct Variant {
  std::string name;
  bool nurbs = false;
  gp_Trsf place;
  /// Rounding, in units of the part as it is: questions finer than this have no answer.
  double rounding = 1e-14;

  [[nodiscard]] Vec3 operator()(const Vec3& p) const {
    const gp_Pnt q = gp_Pnt(p.x(), p.y(), p.z()).Transformed(place);
    return {q.X(), q.Y(), q.Z()};
  }
  [[nodiscard]] TopoDS_Shape operator()(const TopoDS_Shape& shape) const {
    if (nurbs) return BRepBuilderAPI_NurbsConvert(shape, true).Shape();
    return BRepBuilderAPI_Transform(shape, place, true).Shape();
  }
};

inline std::vector<Variant> variants() {
  std::vector<Variant> all(5);
  all[0].name = "identity";
  all[1].name = "nurbs";
  all[1].nurbs = true;
  all[2].name = "far";
  all[2].place.SetTranslation(gp_Vec(1e5, -1e5, 1e5));
  all[2].rounding = 2e-9;
  all[3].name = "small";
  all[3].place.SetScale(gp_Pnt(0, 0, 0), 1e-3);
  all[4].name = "turned";
  all[4].place.SetRotation(gp_Ax1(gp_Pnt(0.3, 0.2, -0.1), gp_Dir(1, 2, -3)), 0.7331);
  return all;
}

/// One part in one variant, asked in the coordinates of the part as it is.
class Asked {
 public:
  Asked(const Variant& variant, const TopoDS_Shape& shape)
      : variant_(variant), model_(model_from_shape(variant(shape))) {}

  /// The hits of a segment, one word each: v, e or f for what it is on; + crosses, ~ touches, = runs in the
  /// boundary; a dot at an end of the segment.
  [[nodiscard]] std::string hits(const Vec3& p, const Vec3& q) const {
    std::vector<Hit> found;
    model_.intersect(variant_(p), variant_(q), found);
    std::string words;
    for (const Hit& hit : found) {
      if (!words.empty()) words += ' ';
      words += "vef"[hit.on.dim];
      words += hit.kind == HitKind::kTransversal ? '+' : hit.kind == HitKind::kTangent ? '~' : '=';
      if (hit.end_point) words += '.';
    }
    return words;
  }
  /// The same of a segment whose ends are clear of the part, and of the whole line.
  void expect_line(const Vec3& p, const Vec3& q, const std::string& expected) const {
    const Vec3 d = q - p;
    for (const double more : {0.0, 0.37, 50.0})
      EXPECT_EQ(hits(p - more * d, q + more * d), expected)
          << variant_.name << ": from " << p.transpose() << " to " << q.transpose() << ", longer by " << more;
  }
  void expect_segment(const Vec3& p, const Vec3& q, const std::string& expected) const {
    EXPECT_EQ(hits(p, q), expected) << variant_.name << ": from " << p.transpose() << " to " << q.transpose();
  }
  void expect_region(const Vec3& p, int region) const {
    EXPECT_EQ(model_.region_at(variant_(p)), region) << variant_.name << ": at " << p.transpose();
  }
  [[nodiscard]] const Variant& variant() const { return variant_; }
  [[nodiscard]] const Model& model() const { return model_; }

 private:
  Variant variant_;
  Model model_;
};

inline void in_all_variants(const TopoDS_Shape& shape, const std::function<void(const Asked&)>& ask) {
  for (const Variant& variant : variants()) ask(Asked(variant, shape));
}

}  // namespace octet::test
