// SPDX-License-Identifier: BSD-3-Clause
// Grids over the face's (u,v), finer ones until there are points enough.
#include "geom/occt/face_samples.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <Precision.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>

#include "geom/occt/canonical.h"

namespace octet {
namespace {

/// Nothing where the surface has no normal.
void add_sample(const BRepAdaptor_Surface& surface, const gp_Pnt2d& uv, bool reversed,
                std::vector<FaceSample>& samples) {
  gp_Pnt point;
  gp_Vec du, dv;
  surface.D1(uv.X(), uv.Y(), point, du, dv);
  const gp_Vec normal = du.Crossed(dv);
  const double length = normal.Magnitude();
  if (!(length > 0.0)) return;
  const double sign = reversed ? -1.0 : 1.0;
  samples.push_back({to_vec(point), sign / length * Vec3(normal.X(), normal.Y(), normal.Z())});
}

}  // namespace

std::vector<FaceSample> face_samples(const TopoDS_Face& face, std::size_t most) {
  constexpr int kFinest = 65;
  const BRepAdaptor_Surface surface(face, false);
  const BRepTopAdaptor_FClass2d inside(face, Precision::PConfusion());
  double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
  BRepTools::UVBounds(face, u0, u1, v0, v1);
  std::vector<FaceSample> samples;
  for (int grid = 3; grid <= kFinest && samples.size() < most; grid = 2 * grid - 1) {
    samples.clear();
    std::vector<gp_Pnt2d> found;
    for (int i = 0; i < grid * grid; ++i) {
      const gp_Pnt2d uv(u0 + (u1 - u0) * (i % grid + 0.5) / grid, v0 + (v1 - v0) * (i / grid + 0.5) / grid);
      if (inside.Perform(uv) == TopAbs_IN) found.push_back(uv);
    }
    const std::size_t step = std::max<std::size_t>(1, found.size() / most);
    for (std::size_t i = step / 2; i < found.size() && samples.size() < most; i += step)
      add_sample(surface, found[i], face.Orientation() == TopAbs_REVERSED, samples);
  }
  return samples;
}

}  // namespace octet
