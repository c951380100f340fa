// SPDX-License-Identifier: BSD-3-Clause
// Meshes parts at random places in the lattice and tells how many end complete, and how counts spread:
// octet_phases COUNT SIZE PART..., SIZE `default`, `family` (points at the family's size) or N (diagonal /
// N), PART a CAD file, a family's name, or `all` families.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <random>
#include <span>
#include <string>

#include "app/mesh_part.h"
#include "geom/occt/from_shape.h"
#include "geom/occt/read_part.h"
#include "octree/octree.h"
#include "tests/support/families.h"

namespace {

using namespace octet;

std::array<double, 3> random_shift(int seed) {
  std::mt19937 draw(static_cast<unsigned>(seed));
  std::array<double, 3> shift{};
  for (double& s : shift) s = static_cast<double>(draw()) / 4294967296.0;
  return shift;
}

MeshOptions options_of(const std::string& size, const Model& model, double family_size) {
  MeshOptions options;
  if (size == "family") {
    options.size = family_size * kEdgePerOctant / kSpacingPerOctant;
    options.wall_elements = 0.0;
  } else if (size != "default") {
    options.size = model.diagonal() / std::stod(size);
  }
  return options;
}

/// One line a part, and one for each place that does not end complete. Returns how many those are.
int mesh_at_phases(const std::string& name, const Model& model, MeshOptions options, int count) {
  int incomplete = 0;
  std::size_t least = SIZE_MAX, most = 0, points = 0;
  std::string faults;
  for (int seed = 1; seed <= count; ++seed) {
    options.shift = random_shift(seed);
    const MeshReport report = mesh_part(model, options).report;
    least = std::min(least, report.tets);
    most = std::max(most, report.tets);
    points = std::max(points, report.attribute_points);
    if (report.status == MeshStatus::kComplete) continue;
    ++incomplete;
    const Fault& first = report.faults.front();
    faults += fmt::format("\n  {}: {} faults: {} at ({:.6g}, {:.6g}, {:.6g})", seed, report.faults.size(),
                          first.cause, first.place.x(), first.place.y(), first.place.z());
  }
  fmt::print("{}: {} of {} incomplete; {} to {} tetrahedra, at most {} attribute points{}\n", name,
             incomplete, count, least, most, points, faults);
  return incomplete;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    fmt::print(stderr, "usage: octet_phases COUNT SIZE PART...\n");
    return 2;
  }
  const int count = std::atoi(argv[1]);
  const std::string size = argv[2];
  int incomplete = 0;
  try {
    for (const std::string part : std::span(argv + 3, argv + argc)) {
      if (std::filesystem::exists(part)) {
        const Model model = read_part(part);
        incomplete += mesh_at_phases(part, model, options_of(size, model, 1.0), count);
        continue;
      }
      for (const test::FamilyPart& family : test::family_parts()) {
        if (part != "all" && part != family.name) continue;
        const Model model = model_from_shape(family.build());
        incomplete += mesh_at_phases(family.name, model, options_of(size, model, family.size), count);
      }
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "octet_phases: {}\n", error.what());
    return 1;
  }
  return incomplete == 0 ? 0 : 3;
}
