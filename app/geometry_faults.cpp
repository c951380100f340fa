// SPDX-License-Identifier: BSD-3-Clause
// What the part's own faults do to a mesh, in words.
#include "app/geometry_faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace octet {
namespace {

/// Gaps up to so many times the size of the features taken away are of them: edges stretched over a feature
/// leave the faces by no more than its width to either side.
constexpr double kGapOfFeature = 2.0;

}  // namespace

Fault warning_of(const WideGap& gap, const Model& part) {
  const bool taken_away = gap.gap <= kGapOfFeature * part.parts().taken_away;
  const char* what = gap.entity.dim == 1 ? "runs beside its faces" : "lies off the ends of its edges";
  return {
      gap.entity, gap.place,
      fmt::format("it {} by up to {:.3g} mm, {:.2g} of the size there", what, gap.gap, gap.gap / gap.local),
      taken_away ? "features were taken away here: ask for a larger size, or take away less of them"
                 : "mend the part there, or ask for a larger size"};
}

Fault fault_of(const FaceTouch& touch, const Model& part) {
  return {
      model_face(touch.face[0]), touch.place,
      fmt::format("it touches {} here, without an edge or a vertex that the two share: no mesh is on one and "
                  "not on the other",
                  part.describe(model_face(touch.face[1]))),
      "in the CAD system let the two share an edge there, or part them"};
}

Fault fault_of_coarseness(double size, const Vec3& place) {
  return {
      {},
      place,
      fmt::format("at a size of {:.6g} mm most of the boundary has no mesh faces: walls, bores or gaps all "
                  "over the part are many times thinner",
                  size),
      "ask for a size near their width"};
}

Fault warning_of(const FaceCrossing& crossing, const Model& part) {
  const std::string what = crossing.is_of_itself() ? "itself" : part.describe(model_face(crossing.face[1]));
  return {model_face(crossing.face[0]), crossing.place,
          fmt::format("it crosses {} by {:.3g} mm or more", what, crossing.depth), "mend the part there"};
}

double deepest_crossing_at(const Fault& fault, const Model& part) {
  double depth = 0.0;
  for (const FaceCrossing& crossing : part.crossings())
    if (!fault.entity.valid() || part.in_closure(fault.entity, model_face(crossing.face[0])) ||
        part.in_closure(fault.entity, model_face(crossing.face[1])))
      depth = std::max(depth, crossing.depth);
  return depth;
}

std::string refusal_of(const FaceCrossing& crossing, const Model& part) {
  const std::string first = part.describe(model_face(crossing.face[0]));
  const std::string what = crossing.is_of_itself()
                               ? first + " crosses itself"
                               : first + " and " + part.describe(model_face(crossing.face[1])) + " cross";
  return fmt::format(
      "{} at ({:.6g}, {:.6g}, {:.6g}): the part's boundary meets itself, so it bounds no volume; mend the "
      "part there",
      what, crossing.place.x(), crossing.place.y(), crossing.place.z());
}

}  // namespace octet
