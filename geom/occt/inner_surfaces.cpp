// SPDX-License-Identifier: BSD-3-Clause
// Surfaces that a file keeps within its solids: threads drawn as cylinders, planes and axes of construction.
#include "geom/occt/inner_surfaces.h"

#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <memory>

#include "geom/occt/face_samples.h"
#include "geom/occt/shape_box.h"

namespace octet {
namespace {

constexpr std::size_t kPlaces = 25;  // of each face

/// A solid with a classifier that is made when it is first asked.
class Body {
 public:
  explicit Body(const TopoDS_Shape& solid) : solid_(solid), box_(box_of(solid)) {}

  [[nodiscard]] bool holds(const Vec3& p, double tolerance) {
    const gp_Pnt place(p.x(), p.y(), p.z());
    if (box_.IsOut(place)) return false;
    if (!classifier_) classifier_ = std::make_unique<BRepClass3d_SolidClassifier>(solid_);
    classifier_->Perform(place, tolerance);
    return classifier_->State() == TopAbs_IN;
  }

 private:
  TopoDS_Shape solid_;
  Bnd_Box box_;
  std::unique_ptr<BRepClass3d_SolidClassifier> classifier_;
};

}  // namespace

bool runs_within(const TopoDS_Shape& part, const std::vector<TopoDS_Shape>& solids) {
  constexpr double kNear = 1e-6;  // of the part
  constexpr double kShare = 0.5;
  try {
    const double tolerance = kNear * diagonal_of(box_of(part));
    std::vector<Body> bodies(solids.begin(), solids.end());
    double inside = 0.0, whole = 0.0;
    for (TopExp_Explorer face(part, TopAbs_FACE); face.More(); face.Next()) {
      GProp_GProps properties;
      BRepGProp::SurfaceProperties(face.Current(), properties);
      const double area = std::abs(properties.Mass());
      whole += area;
      const std::vector<FaceSample> samples = face_samples(TopoDS::Face(face.Current()), kPlaces);
      for (const FaceSample& sample : samples)
        if (std::any_of(bodies.begin(), bodies.end(),
                        [&](Body& body) { return body.holds(sample.point, tolerance); }))
          inside += area / static_cast<double>(samples.size());
    }
    return inside >= kShare * whole && inside > 0.0;
  } catch (const Standard_Failure&) {
    return false;
  }
}

}  // namespace octet
