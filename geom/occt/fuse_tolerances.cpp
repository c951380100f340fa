// SPDX-License-Identifier: BSD-3-Clause
// Shares of the sizes of the solids.
#include "geom/occt/fuse_tolerances.h"

#include <algorithm>
#include <array>

#include "base/sort_unique.h"
#include "geom/occt/shape_box.h"

namespace octet {
namespace {

/// Tolerances, as shares of its solids' diagonal, none of them more than a share of the smallest
/// solid's: none, then up to the noise of files, then, for walls askew of which a part only is noise, more.
/// What these give must leave nothing to be wished for.
struct Step {
  double of_all, of_smallest;
};
constexpr std::array<Step, 6> kSteps{
    {{0.0, 1e-5}, {1e-8, 1e-5}, {1e-7, 1e-5}, {1e-6, 1e-5}, {4e-6, 3e-5}, {1e-5, 5e-5}}};

}  // namespace

std::vector<double> fuse_tolerances(const std::vector<TopoDS_Shape>& solids, double noise) {
  const double diagonal = diagonal_of_all(solids);
  double smallest = diagonal;
  for (const TopoDS_Shape& solid : solids) smallest = std::min(smallest, diagonal_of(box_of(solid)));
  std::vector<double> all{noise};
  for (const Step& step : kSteps)
    all.push_back(std::min(step.of_all * diagonal, step.of_smallest * smallest));
  sort_unique(all);
  return all;
}

}  // namespace octet
