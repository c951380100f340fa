// SPDX-License-Identifier: BSD-3-Clause
#include "finalize/finalize.h"
#include "base/constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string_view>

#include "base/error.h"
#include "mesh/forbidden.h"
#include "mesh/quality.h"
#include "tests/finalize/parts.h"

namespace octet {
namespace {

using testing::faults_of;
using testing::Part;

/// Finalizes a jittered part and holds it to all that finalize() promises.
FinalizeReport finalize_and_check(Part& part, double size) {
  const std::vector<int> euler = testing::face_euler(part.mesh, part.model.count(2));
  EXPECT_EQ(faults_of(part.mesh, part.model, euler), "");
  const QualitySummary before = quality_summary(part.mesh);
  Observer observer;
  const FinalizeReport report = finalize(part.mesh, part.model, testing::options_of_size(size), observer);
  EXPECT_EQ(faults_of(part.mesh, part.model, euler), "");
  const QualitySummary after = quality_summary(part.mesh);
  EXPECT_GE(after.min_dihedral, before.min_dihedral);
  EXPECT_NEAR(after.min_dihedral, report.min_dihedral_after, 1e-12);
  EXPECT_NEAR(after.max_dihedral, report.max_dihedral_after, 1e-12);
  return report;
}

TEST(Finalize, BringsAJitteredBoxWithFlatTetrahedraToTwentyDegreesAndKeepsItsVolume) {
  Part part = testing::jittered(testing::box_part({1, 1.2, 0.8}, 8, 8, 7, true), 0.09, 11);
  EXPECT_GT(testing::glue_flat_tets(part.mesh, part.model), 50);
  const FinalizeReport report = finalize_and_check(part, 0.13);
  EXPECT_LT(report.min_dihedral_before, 0.1 * kDegree);
  EXPECT_GE(report.min_dihedral_after, 20.0 * kDegree);
  EXPECT_EQ(report.below_target, 0u);
  EXPECT_NEAR(testing::total_volume(part.mesh), 0.96, 1e-12);
}

/// Of the cylinder of radius 1 from the sides of its triangles.
double farthest(const Part& part) {
  double most = 0.0;
  for (std::size_t i = 0; i < part.mesh.triangles.size(); ++i) {
    if (part.model.surface(part.mesh.triangle_on[i]).kind() != std::string_view("cylinder")) continue;
    const auto& t = part.mesh.triangles[i];
    for (int k = 0; k < 3; ++k) {
      const Vec3 middle = 0.5 * (part.mesh.points[t[k]] + part.mesh.points[t[(k + 1) % 3]]);
      most = std::max(most, 1.0 - std::hypot(middle.x(), middle.y()));
    }
  }
  return most;
}

/// Short edges are collapsed, for the size is three times what the mesh has, but not so that chords and
/// triangles leave the cylinder.
TEST(Finalize, LeavesTheSurfaceNoFartherThanItWas) {
  Part part = testing::jittered(testing::cylinder_part(16), 0.02, 5);
  const double before = farthest(part);
  const std::size_t nodes = part.mesh.points.size();
  finalize_and_check(part, 0.4);
  EXPECT_LT(part.mesh.points.size(), nodes);
  EXPECT_GT(before, 0.0);
  EXPECT_LT(farthest(part), 1.1 * before);
}

Part jittered_box() { return testing::jittered(testing::box_part({1, 1.2, 0.8}, 8, 8, 7, true), 0.09, 11); }

TEST(Finalize, SmoothingAloneMovesVerticesAndKeepsTheTetrahedra) {
  Part part = jittered_box();
  const Mesh jittered = part.mesh;
  FinalizeOptions options = testing::options_of_size(0.13);
  options.scope = FinalizeScope::kSmoothing;
  Observer observer;
  const FinalizeReport report = finalize(part.mesh, part.model, options, observer);
  EXPECT_GT(report.min_dihedral_after, report.min_dihedral_before);
  EXPECT_EQ(part.mesh.tets, jittered.tets);
  EXPECT_NE(part.mesh.points, jittered.points);
}

TEST(Finalize, FastReachesTheTargetWithHalfTheWork) {
  Part part = jittered_box();
  const Mesh jittered = part.mesh;
  FinalizeOptions options = testing::options_of_size(0.13);
  options.scope = FinalizeScope::kFast;
  Observer observer;
  const FinalizeReport report = finalize(part.mesh, part.model, options, observer);
  EXPECT_EQ(faults_of(part.mesh, part.model, testing::face_euler(jittered, part.model.count(2))), "");
  EXPECT_LT(report.min_dihedral_before, 18.0 * kDegree);
  EXPECT_GE(report.min_dihedral_after, options.target_dihedral);
  Mesh whole = jittered;
  options.scope = FinalizeScope::kAll;
  const FinalizeReport full = finalize(whole, part.model, options, observer);
  EXPECT_LT(report.smoothed + report.edge_removals + report.face_swaps,
            (full.smoothed + full.edge_removals + full.face_swaps) / 2);
  EXPECT_GT(quality_summary(whole).mean_mean_ratio, quality_summary(part.mesh).mean_mean_ratio);
}

/// Numbers the vertices anew: those for which first(v) holds come first. Returns how many they are.
std::size_t put_first(Mesh& mesh, const std::vector<char>& first) {
  std::vector<Mesh::Index> order;
  for (const char wanted : {1, 0})
    for (Mesh::Index v = 0; v < mesh.points.size(); ++v)
      if (first[v] == wanted) order.push_back(v);
  std::vector<Mesh::Index> number(order.size());
  Mesh old = mesh;
  for (Mesh::Index n = 0; n < order.size(); ++n) {
    number[order[n]] = n;
    mesh.points[n] = old.points[order[n]];
    mesh.point_on[n] = old.point_on[order[n]];
  }
  const auto renumber = [&](auto& elements) {
    for (auto& element : elements)
      for (Mesh::Index& v : element) v = number[v];
  };
  renumber(mesh.edges);
  renumber(mesh.triangles);
  renumber(mesh.tets);
  return static_cast<std::size_t>(std::count(first.begin(), first.end(), 1));
}

/// The triangles on a model face, by their corners' places.
std::set<std::array<std::array<double, 3>, 3>> triangles_on(const Mesh& mesh, int face) {
  std::set<std::array<std::array<double, 3>, 3>> found;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (mesh.triangle_on[i] != face) continue;
    std::array<std::array<double, 3>, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = mesh.points[mesh.triangles[i][k]];
      corners[k] = {p.x(), p.y(), p.z()};
    }
    std::sort(corners.begin(), corners.end());
    found.insert(corners);
  }
  return found;
}

TEST(Finalize, HeldVerticesAndTheTrianglesBetweenThemStay) {
  Part part = testing::jittered(testing::box_part({1, 1, 1}, 6, 6, 6, true), 0.05, 5);
  constexpr int kHeld = 1;
  const auto before = triangles_on(part.mesh, kHeld);
  ASSERT_GT(before.size(), 50u);
  FinalizeOptions options = testing::options_of_size(1.0 / 6.0);
  Observer observer;
  Mesh free = part.mesh, held = part.mesh;
  finalize(free, part.model, options, observer);
  EXPECT_NE(triangles_on(free, kHeld), before);
  for (std::size_t i = 0; i < held.triangles.size(); ++i)
    if (held.triangle_on[i] == kHeld)
      options.held.insert(options.held.end(), held.triangles[i].begin(), held.triangles[i].end());
  const FinalizeReport report = finalize(held, part.model, options, observer);
  EXPECT_EQ(triangles_on(held, kHeld), before);
  EXPECT_GT(report.smoothed, 0u) << "the others are worked on";
}

TEST(Finalize, KeepsTheSeamToTetrahedraThatAreNotGiven) {
  Part part = testing::jittered(testing::box_part({1, 1, 1}, 8, 8, 8, true), 0.04, 3);
  // Taken away: the tetrahedra around inner vertices that are three cells from the boundary.
  const Vec3 centre = part.model.box().centre();
  const auto is_deep = [&](const auto& t) {
    Vec3 middle = Vec3::Zero();
    for (const Mesh::Index v : t) middle += 0.25 * part.mesh.points[v];
    return (middle - centre).norm() < 0.2;
  };
  std::vector<char> deep(part.mesh.points.size(), 0), given(deep), seam(deep);
  for (const auto& t : part.mesh.tets)
    for (const Mesh::Index v : t) (is_deep(t) ? deep : given)[v] = 1;
  for (std::size_t v = 0; v < seam.size(); ++v) seam[v] = deep[v] && given[v];
  FinalizeOptions options = testing::options_of_size(0.125);
  options.fixed_vertices = put_first(part.mesh, seam);
  ASSERT_GT(options.fixed_vertices, 20u);

  Mesh shell = part.mesh, core;
  shell.tets.clear();
  shell.tet_in.clear();
  std::vector<char> used(part.mesh.points.size(), 0);
  options.volume_beyond = {0.0, 0.0};
  for (const auto& t : part.mesh.tets) {
    const auto& p = part.mesh.points;
    if (is_deep(t)) {
      core.tets.push_back(t);
      options.volume_beyond[1] += signed_volume(p[t[0]], p[t[1]], p[t[2]], p[t[3]]);
    } else {
      shell.tets.push_back(t);
      shell.tet_in.push_back(1);
      for (const Mesh::Index v : t) used[v] = 1;
    }
  }
  // Vertices of the core alone go to the end of the numbers, and out.
  for (const Mesh::Index v : shell.tets.back()) ASSERT_TRUE(used[v]);
  std::vector<Mesh::Index> number(used.size());
  const Mesh whole = shell;
  shell.points.clear();
  shell.point_on.clear();
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    number[v] = static_cast<Mesh::Index>(shell.points.size());
    shell.points.push_back(whole.points[v]);
    shell.point_on.push_back(whole.point_on[v]);
  }
  const auto renumber = [&](auto& elements) {
    for (auto& element : elements)
      for (Mesh::Index& v : element) v = number[v];
  };
  renumber(shell.edges);
  renumber(shell.triangles);
  renumber(shell.tets);

  Observer observer;
  const double before = quality_summary(shell).min_dihedral;
  const FinalizeReport report = finalize(shell, part.model, options, observer);
  EXPECT_GT(report.smoothed, 0u);
  EXPECT_GE(quality_summary(shell).min_dihedral, before);
  for (std::size_t v = 0; v < options.fixed_vertices; ++v) EXPECT_EQ(shell.points[v], part.mesh.points[v]);
  // With the core put back the mesh is sound.
  std::vector<Mesh::Index> back(used.size());
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (v < options.fixed_vertices) {
      back[v] = static_cast<Mesh::Index>(v);
    } else if (!used[v]) {
      back[v] = static_cast<Mesh::Index>(shell.points.size());
      shell.points.push_back(part.mesh.points[v]);
      shell.point_on.push_back(part.mesh.point_on[v]);
    }
  }
  for (const auto& t : core.tets) {
    shell.tets.push_back({back[t[0]], back[t[1]], back[t[2]], back[t[3]]});
    shell.tet_in.push_back(1);
  }
  EXPECT_EQ(faults_of(shell, part.model, testing::face_euler(part.mesh, part.model.count(2))), "");
  EXPECT_NEAR(testing::total_volume(shell), 1.0, 1e-12);
}

TEST(Finalize, BringsABallToEighteenDegrees) {
  Part part = testing::jittered(testing::ball_part(8), 0.1, 5);
  const double exact = 4.0 / 3.0 * std::numbers::pi, error = exact - testing::total_volume(part.mesh);
  const double mean = quality_summary(part.mesh).mean_mean_ratio;
  const FinalizeReport report = finalize_and_check(part, 0.25);
  EXPECT_GE(report.min_dihedral_after, 18.0 * kDegree);
  EXPECT_NEAR(testing::total_volume(part.mesh), exact, error);
  EXPECT_GT(quality_summary(part.mesh).mean_mean_ratio, mean + 0.1);
}

TEST(Finalize, BringsACylinderToEighteenDegrees) {
  Part part = testing::jittered(testing::cylinder_part(8), 0.1, 9);
  const FinalizeReport report = finalize_and_check(part, 0.25);
  EXPECT_GE(report.min_dihedral_after, 18.0 * kDegree);
}

/// Largest distance of the triangles' middles, and of their edges', to the exact faces.
double largest_sampled_deviation(const Part& part) {
  double largest = 0.0;
  for (std::size_t i = 0; i < part.mesh.triangles.size(); ++i) {
    const auto& v = part.mesh.triangles[i];
    const std::array<Vec3, 3> p{part.mesh.points[v[0]], part.mesh.points[v[1]], part.mesh.points[v[2]]};
    for (const Vec3& q : {Vec3((p[0] + p[1] + p[2]) / 3.0), Vec3(0.5 * (p[0] + p[1])),
                          Vec3(0.5 * (p[1] + p[2])), Vec3(0.5 * (p[2] + p[0]))}) {
      const FaceFoot foot = part.model.face_project(part.mesh.triangle_on[i], q);
      largest = std::max(largest, (foot.point - q).norm());
    }
  }
  return largest;
}

TEST(Finalize, KeepsRoundFacesAsNearAsTheyWere) {
  for (const bool ball : {true, false}) {
    for (const int seed : {1, 2, 3, 4, 5}) {
      Part part = testing::jittered(ball ? testing::ball_part(8) : testing::cylinder_part(8), 0.1,
                                    static_cast<std::uint64_t>(seed));
      const double before = largest_sampled_deviation(part);
      finalize_and_check(part, 0.25);
      // Jitter stretches the triangles, which finalization mends: measured 0.39 to 0.70 of it.
      EXPECT_LE(largest_sampled_deviation(part), 0.8 * before);
    }
  }
}

TEST(Finalize, KeepsAnInterfaceBetweenTwoRegions) {
  Part part = testing::jittered(testing::two_boxes_part(5), 0.15, 4);
  const FinalizeReport report = finalize_and_check(part, 0.2);
  EXPECT_GE(report.min_dihedral_after, 20.0 * kDegree);
  EXPECT_GT(report.edge_removals, 15u);
  double volume[3] = {0.0, 0.0, 0.0};
  for (std::size_t t = 0; t < part.mesh.tets.size(); ++t) {
    const auto& v = part.mesh.tets[t];
    volume[part.mesh.tet_in[t]] += signed_volume(part.mesh.points[v[0]], part.mesh.points[v[1]],
                                                 part.mesh.points[v[2]], part.mesh.points[v[3]]);
  }
  EXPECT_NEAR(volume[1], 1.0, 1e-12);
  EXPECT_NEAR(volume[2], 1.0, 1e-12);
}

TEST(Finalize, CollapsesNicks) {
  Part part = testing::box_part({1, 1, 1}, 5, 5, 5);
  // A vertex inside a face, drawn to within a tenth of the size of its neighbour.
  for (std::size_t v = 0; v < part.mesh.points.size(); ++v) {
    if (part.mesh.point_on[v].dim == 3 && (part.mesh.points[v] - Vec3(0.2, 0.4, 0.4)).norm() < 0.01) {
      part.mesh.points[v] = Vec3(0.02, 0.4, 0.4);
    }
  }
  const FinalizeReport report = finalize_and_check(part, 0.2);
  EXPECT_GE(report.collapses, 1u);
  EXPECT_GE(report.min_dihedral_after, 20.0 * kDegree);
}

TEST(Finalize, SplitsEdgesThatAreTooLong) {
  // Cells of 1 x 0.25 x 0.25.
  const auto long_edges = [](const Part& part, double length) {
    std::set<std::pair<Mesh::Index, Mesh::Index>> edges;
    for (const auto& tet : part.mesh.tets)
      for (const auto& e : kTetEdge)
        if ((part.mesh.points[tet[e[0]]] - part.mesh.points[tet[e[1]]]).norm() > length)
          edges.insert(std::minmax(tet[e[0]], tet[e[1]]));
    return edges.size();
  };
  Part part = testing::box_part({4, 1, 1}, 4, 4, 4);
  const double size = 0.4, length = FinalizeOptions{}.long_edge * size;
  ASSERT_GT(long_edges(part, length), 300u);
  EXPECT_GT(finalize_and_check(part, size).splits, 0u);
  EXPECT_LT(long_edges(part, length), 20u);
}

/// A part finalized at the size `fine`, and at the same size where `coarse` was asked for.
std::array<Mesh, 2> fine_and_coarse(const Part& part, double fine, double coarse) {
  const std::vector<int> euler = testing::face_euler(part.mesh, part.model.count(2));
  std::array<Mesh, 2> meshes{part.mesh, part.mesh};
  FinalizeOptions options = testing::options_of_size(fine);
  for (Mesh& mesh : meshes) {
    Observer observer;
    const FinalizeReport report = finalize(mesh, part.model, options, observer);
    EXPECT_EQ(faults_of(mesh, part.model, euler), "");
    EXPECT_GE(report.min_dihedral_after, 20.0 * kDegree);
    options.coarse_size_at = [=](const Vec3&) { return coarse; };
  }
  return meshes;
}

TEST(Finalize, CoarsensTowardsTheSizeAskedForAndKeepsShapes) {
  const auto [fine, coarse] = fine_and_coarse(testing::box_part({1, 1.2, 0.8}, 8, 8, 7, true), 0.13, 0.5);
  EXPECT_LT(coarse.triangles.size(), 0.5 * fine.triangles.size());
  EXPECT_LT(coarse.tets.size(), 0.6 * fine.tets.size());
}

TEST(Finalize, CoarseningKeepsRoundFacesAsNearAsTheFineSizeHasThem) {
  Part part = testing::ball_part(8);
  const auto [fine, coarse] = fine_and_coarse(part, 0.15, 0.6);
  EXPECT_LT(coarse.tets.size(), fine.tets.size());
  part.mesh = fine;
  const double deviation = largest_sampled_deviation(part);
  part.mesh = coarse;
  EXPECT_LE(largest_sampled_deviation(part), 1.1 * deviation);
}

TEST(Finalize, LeavesBelowTheTargetOnlyWhatThePartForbids) {
  Part part = testing::box_part({1, 1, 0.02}, 6, 6, 1);
  const FinalizeReport report = finalize_and_check(part, 0.2);
  const std::vector<char> forbidding =
      forbidding_vertices(part.mesh, std::vector<double>(part.mesh.points.size(), 0.2));
  std::size_t below = 0;
  for (const auto& v : part.mesh.tets) {
    const auto& p = part.mesh.points;
    if (dihedral_range(p[v[0]], p[v[1]], p[v[2]], p[v[3]]).smallest >= FinalizeOptions{}.target_dihedral)
      continue;
    ++below;
    EXPECT_TRUE(touches(v, forbidding));
  }
  EXPECT_GT(below, 0u);
  EXPECT_EQ(report.below_target, below);
}

TEST(Finalize, DoesNotWreckAThinCurvedSheetForItsAngles) {
  Part part = testing::jittered(testing::shell_part(10, 0.93), 0.02, 8);
  const double exact = part.model.region(1).volume;
  const double error = std::abs(testing::total_volume(part.mesh) - exact);
  finalize_and_check(part, 0.25);
  EXPECT_LE(std::abs(testing::total_volume(part.mesh) - exact), std::max(1.1 * error, 0.003 * exact));
}

TEST(Finalize, GivesTheSameMeshTwice) {
  Mesh meshes[2];
  for (Mesh& mesh : meshes) {
    Part part = testing::jittered(testing::ball_part(6), 0.12, 1);
    finalize_and_check(part, 0.3);
    mesh = part.mesh;
  }
  EXPECT_EQ(meshes[0].points, meshes[1].points);
  EXPECT_EQ(meshes[0].tets, meshes[1].tets);
  EXPECT_EQ(meshes[0].triangles, meshes[1].triangles);
  EXPECT_EQ(meshes[0].edges, meshes[1].edges);
}

TEST(Finalize, OnItsOwnOutputMakesNothingWorseAndHasLittleToDo) {
  for (const bool ball : {true, false}) {
    Part part = testing::jittered(
        ball ? testing::ball_part(8) : testing::box_part({1, 1.2, 0.8}, 8, 8, 7, true), 0.08, 6);
    const double size = ball ? 0.25 : 0.13;
    const FinalizeReport first = finalize_and_check(part, size);
    const QualitySummary once = quality_summary(part.mesh);
    const FinalizeReport second = finalize_and_check(part, size);
    const QualitySummary twice = quality_summary(part.mesh);
    EXPECT_GE(twice.min_dihedral, once.min_dihedral);
    EXPECT_GE(twice.p1_min_dihedral, once.p1_min_dihedral - 0.5 * kDegree);
    EXPECT_GE(twice.mean_mean_ratio, once.mean_mean_ratio);
    const auto swaps = [](const FinalizeReport& r) {
      return r.edge_removals + r.face_swaps + r.collapses + r.splits;
    };
    EXPECT_LT(4 * swaps(second), swaps(first));
  }
}

TEST(Finalize, EndsWhenTheObserverAsks) {
  struct Stop : Observer {
    [[nodiscard]] bool cancelled() const override { return true; }
  } observer;
  Part part = testing::jittered(testing::box_part({1, 1, 1}, 8, 8, 8), 0.05, 2);
  EXPECT_THROW(finalize(part.mesh, part.model, testing::options_of_size(0.12), observer), Cancelled);
}

}  // namespace
}  // namespace octet
