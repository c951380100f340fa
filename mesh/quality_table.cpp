// SPDX-License-Identifier: BSD-3-Clause
// The shapes of a mesh's elements as distributions, and its worst elements by place and entity.
#include "mesh/quality_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/constants.h"
#include "base/error.h"
#include "base/sort_unique.h"
#include "mesh/forbidden.h"
#include "mesh/local_size.h"
#include "mesh/quadratic.h"
#include "mesh/soundness.h"

namespace octet {
namespace {

constexpr int kMeasures = 6;

/// What is told of each element, in the order of QualityTable::all; the last of second order alone.
std::array<double, kMeasures> measures_of(const Mesh& mesh, std::size_t t) {
  const auto& v = mesh.tets[t];
  const Vec3 &a = mesh.points[v[0]], &b = mesh.points[v[1]], &c = mesh.points[v[2]], &d = mesh.points[v[3]];
  const DihedralRange range = dihedral_range(a, b, c, d);
  return {range.smallest,
          range.largest,
          mean_ratio(a, b, c, d),
          radius_ratio(a, b, c, d),
          aspect(a, b, c, d),
          mesh.mid.empty() || has_straight_edges(mesh, t)
              ? 1.0
              : scaled_jacobian(jacobian_form(quadratic_tet(mesh, t)))};
}

/// The distributions without their values: names and bins.
std::array<Distribution, kMeasures> empty_distributions() {
  std::array<Distribution, kMeasures> d;
  const auto set = [](Distribution& x, const char* name, double lo, double width, std::size_t bins) {
    x.name = name;
    x.lo = lo;
    x.width = width;
    x.bins.assign(bins, 0);
  };
  set(d[0], "smallest dihedral", 0.0, 5.0 * kDegree, 15);  // 70.5 degrees at most
  set(d[1], "largest dihedral", 60.0 * kDegree, 10.0 * kDegree, 12);
  d[0].angle = d[1].angle = true;
  set(d[2], "mean ratio", 0.0, 0.05, 20);
  set(d[3], "radius ratio", 0.0, 0.05, 20);
  set(d[4], "aspect", 0.0, 0.05, 20);
  set(d[5], "scaled Jacobian", 0.0, 0.05, 20);
  return d;
}

/// Fills the numbers of `d` from the values, which it sorts. The p-th percentile is the value that p per cent
/// of the values lie below.
void fill(Distribution& d, std::vector<double>& values) {
  std::sort(values.begin(), values.end());
  d.count = values.size();
  if (values.empty()) return;
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
    const double bin = std::floor((value - d.lo) / d.width);
    ++d.bins[static_cast<std::size_t>(std::clamp(bin, 0.0, static_cast<double>(d.bins.size() - 1)))];
  }
  d.least = values.front();
  d.p1 = values[values.size() / 100];
  d.median = values[values.size() / 2];
  d.p99 = values[values.size() - 1 - values.size() / 100];
  d.largest = values.back();
  d.mean = sum / static_cast<double>(values.size());
}

std::vector<Distribution> distributions(std::array<std::vector<double>, kMeasures>& values,
                                        bool second_order) {
  auto d = empty_distributions();
  for (int m = 0; m < kMeasures; ++m) fill(d[m], values[m]);
  return {d.begin(), d.end() - (second_order ? 0 : 1)};
}

Distribution edge_lengths(const Mesh& mesh, std::span<const double> size) {
  Distribution d;
  d.name = "edge length / size";
  d.width = 0.1;
  d.bins.assign(21, 0);
  std::vector<double> values;
  for (const auto& [a, b] : element_edges(mesh)) {
    const double local = 0.5 * (size[a] + size[b]);
    values.push_back(local > 0.0 ? (mesh.points[a] - mesh.points[b]).norm() / local : 0.0);
  }
  fill(d, values);
  return d;
}

WorstTet tell(const Mesh& mesh, std::size_t t, const std::vector<char>& forbidding) {
  const auto& v = mesh.tets[t];
  WorstTet worst;
  worst.tet = t;
  const auto m = measures_of(mesh, t);
  worst.dihedral = {m[0], m[1]};
  worst.mean_ratio = m[2];
  worst.limited = touches(v, forbidding);
  worst.on.push_back(model_region(mesh.tet_in[t]));
  for (const Mesh::Index i : v) {
    worst.place += 0.25 * mesh.points[i];
    if (mesh.point_on[i].dim < 3) worst.on.push_back(mesh.point_on[i]);
  }
  sort_unique(worst.on);
  return worst;
}

}  // namespace

QualityTable quality_table(const Mesh& mesh, std::span<const double> size, std::size_t worst_count) {
  if (const std::string fault = check_mesh_arrays(mesh); !fault.empty())
    throw InputError("the mesh cannot be measured: " + fault);
  if (size.size() != mesh.points.size())
    throw InputError(fmt::format("{} sizes are given for {} vertices", size.size(), mesh.points.size()));
  QualityTable table;
  table.tets = mesh.tets.size();
  const std::vector<char> forbidding = forbidding_vertices(mesh, size);
  std::array<std::vector<double>, kMeasures> all, free;
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const auto m = measures_of(mesh, t);
    const bool limited = touches(mesh.tets[t], forbidding);
    table.limited += limited;
    for (int i = 0; i < kMeasures; ++i) {
      all[i].push_back(m[i]);
      if (!limited) free[i].push_back(m[i]);
    }
    order.emplace_back(std::min(std::sin(m[0]), std::sin(m[1])), t);
  }
  table.all = distributions(all, !mesh.mid.empty());
  table.free = distributions(free, !mesh.mid.empty());
  table.edges = edge_lengths(mesh, size);
  worst_count = std::min(worst_count, order.size());
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(worst_count), order.end());
  for (std::size_t i = 0; i < worst_count; ++i)
    table.worst.push_back(tell(mesh, order[i].second, forbidding));
  return table;
}

}  // namespace octet
