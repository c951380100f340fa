// SPDX-License-Identifier: BSD-3-Clause
// Good meshes pass every claim; each defect is caught by the claim that speaks of it.
#include "classify/acceptance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "mesh/mid_nodes.h"
#include "tests/support/model_meshes.h"

namespace octet {
namespace {

const Vec3 kSize(3.0, 2.0, 1.0);

Model box() { return analytic_box(kSize); }
Mesh box_mesh_on(const Model& model, int cells) {
  return test::box_mesh(test::part_of(model), kSize, {cells, cells, cells});
}

std::string failures(const Acceptance& acceptance) {
  std::string text;
  for (const Claim& claim : acceptance.claims)
    if (!claim.holds) {
      text += claim.name + ": ";
      for (const Fault& fault : claim.faults) text += fault.cause + "; ";
    }
  return text;
}

/// The claims that fail, by name.
std::vector<std::string> broken_claims(const Mesh& mesh, const Model& model) {
  std::vector<std::string> names;
  for (const Claim& claim : accept_mesh(mesh, model).claims) {
    EXPECT_EQ(claim.holds, claim.faults.empty()) << claim.name;
    EXPECT_LE(claim.faults.size(), 10u);
    EXPECT_GE(claim.places.size(), claim.faults.size());
    if (!claim.holds) names.push_back(claim.name);
  }
  return names;
}

bool has(const std::vector<std::string>& names, const char* name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

TEST(Acceptance, AGoodBoxPassesEveryClaim) {
  const Model model = box();
  for (const int cells : {1, 2, 4}) {
    const Acceptance acceptance = accept_mesh(box_mesh_on(model, cells), model);
    EXPECT_TRUE(acceptance.holds()) << failures(acceptance);
    EXPECT_EQ(acceptance.claims.size(), 22u);
  }
}

TEST(Acceptance, ABoxInAnyPositionPasses) {
  AnalyticOptions options;
  options.frame.origin = Vec3(1000.0, -3000.0, 77.7);
  options.frame.axes = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  const Model model = analytic_box(kSize, options);
  const test::BoxPart part = test::part_of(model);
  const auto place = [&](const Vec3& p) -> Vec3 { return options.frame.origin + options.frame.axes * p; };
  const test::BoxPart moved{[&](const Vec3& p) { return part.on(place(p)); },
                            [&](ModelRef ref, const Vec3& p) -> Vec3 {
                              return options.frame.axes.transpose() * part.direction(ref, place(p));
                            }};
  Mesh mesh = test::box_mesh(moved, kSize, {3, 3, 3});
  for (Vec3& p : mesh.points) p = place(p);
  const Acceptance acceptance = accept_mesh(mesh, model);
  EXPECT_TRUE(acceptance.holds()) << failures(acceptance);
}

TEST(Acceptance, TwoRegionsWithASharedFacePass) {
  const Model model = analytic_two_boxes(kSize);
  const Vec3 whole(2.0 * kSize.x(), kSize.y(), kSize.z());
  const Mesh mesh = test::box_mesh(test::part_of(model), whole, {4, 2, 2});
  const Acceptance acceptance = accept_mesh(mesh, model);
  EXPECT_TRUE(acceptance.holds()) << failures(acceptance);
}

TEST(Acceptance, ABallPassesAtEverySize) {
  const Model model = analytic_ball(5.0);
  for (const int levels : {1, 2, 3}) {
    const Acceptance acceptance = accept_mesh(test::ball_mesh(model, 5.0, levels), model);
    EXPECT_TRUE(acceptance.holds()) << levels << failures(acceptance);
  }
}

TEST(Acceptance, ACylinderPassesAtEverySize) {
  const Model model = analytic_cylinder(2.0, 5.0);
  for (const int around : {6, 12, 40}) {
    const Acceptance acceptance =
        accept_mesh(test::cylinder_mesh(model, 2.0, 5.0, around, 1 + around / 4), model);
    EXPECT_TRUE(acceptance.holds()) << around << failures(acceptance);
  }
}

TEST(Acceptance, TellsTheFarthestPlaceOfTheSurface) {
  const Model model = analytic_cylinder(2.0, 5.0);
  for (const int around : {6, 12, 40}) {
    const auto farthest =
        accept_mesh(test::cylinder_mesh(model, 2.0, 5.0, around, 1 + around / 4), model).farthest();
    ASSERT_TRUE(farthest);
    EXPECT_EQ(farthest->entity.dim, 1) << "the middles of chords are farther than any place between";
    EXPECT_NEAR(farthest->distance, 2.0 * (1.0 - std::cos(M_PI / around)), 1e-12);
    EXPECT_NEAR(farthest->place.head<2>().norm(), 2.0, 1e-12);
  }
  EXPECT_FALSE(Acceptance{}.farthest());
}

TEST(Acceptance, NothingIsAnEmptyMeshButNotARightOne) {
  EXPECT_FALSE(accept_mesh({}, box()).holds());
  EXPECT_FALSE(Acceptance{}.holds());
}

/// One defect put into a good box of 3 cells along each side, and the claim that must fail.
struct Defect {
  const char* name;
  const char* claim;
  std::function<void(Mesh&, const Model&)> inject;
};

std::uint32_t triangle_inside(const Mesh& mesh, int face) {
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    if (mesh.triangle_on[t] == face) return t;
  return 0;
}

Mesh::Index node_on(const Mesh& mesh, int dim) {
  for (Mesh::Index v = 0; v < mesh.points.size(); ++v)
    if (mesh.point_on[v].dim == dim) return v;
  return 0;
}

void remove_triangle(Mesh& mesh, std::uint32_t t) {
  mesh.triangles.erase(mesh.triangles.begin() + t);
  mesh.triangle_on.erase(mesh.triangle_on.begin() + t);
}

void remove_edge(Mesh& mesh, std::uint32_t e) {
  mesh.edges.erase(mesh.edges.begin() + e);
  mesh.edge_on.erase(mesh.edge_on.begin() + e);
}

/// A point inside, split off: tets that name v name a new vertex at the same place from now on.
void tear(Mesh& mesh, Mesh::Index v) {
  mesh.points.push_back(mesh.points[v]);
  mesh.point_on.push_back(mesh.point_on[v]);
  const auto at = std::find_if(mesh.tets.begin(), mesh.tets.end(),
                               [v](const auto& t) { return std::find(t.begin(), t.end(), v) != t.end(); });
  std::replace(at->begin(), at->end(), v, static_cast<Mesh::Index>(mesh.points.size() - 1));
}

const std::vector<Defect>& defects() {
  static const std::vector<Defect> kDefects = {
      {"index out of range", "numbers", [](Mesh& m, const Model&) { m.tets[3][2] = 1000000; }},
      {"entity out of range", "numbers", [](Mesh& m, const Model&) { m.triangle_on[0] = 7; }},
      {"repeated vertex", "numbers", [](Mesh& m, const Model&) { m.tets[3][2] = m.tets[3][1]; }},
      {"flipped tet", "positive-volume",
       [](Mesh& m, const Model&) { std::swap(m.tets[5][0], m.tets[5][1]); }},
      {"inside node pulled through", "positive-volume",
       [](Mesh& m, const Model&) { m.points[node_on(m, 3)] = Vec3(2.9, 1.9, 0.9); }},
      {"tet given twice", "conforming",
       [](Mesh& m, const Model&) {
         m.tets.push_back(m.tets[7]);
         m.tet_in.push_back(1);
       }},
      {"missing triangle", "boundary-classified", [](Mesh& m, const Model&) { remove_triangle(m, 4); }},
      {"missing triangle opens the face", "face-borders",
       [](Mesh& m, const Model&) { remove_triangle(m, 4); }},
      {"missing triangle at an inner place changes the face", "face-area",
       [](Mesh& m, const Model&) { remove_triangle(m, 4); }},
      {"triangle twice", "boundary-classified",
       [](Mesh& m, const Model&) {
         m.triangles.push_back(m.triangles[4]);
         m.triangle_on.push_back(m.triangle_on[4]);
       }},
      {"all triangles of a face missing", "face-euler",
       [](Mesh& m, const Model&) {
         for (std::uint32_t t = m.triangles.size(); t-- > 0;)
           if (m.triangle_on[t] == 2) remove_triangle(m, t);
       }},
      {"hole in a face", "face-euler",
       [](Mesh& m, const Model&) {
         // A triangle with no corner on the face's border.
         const auto inside = [&m](Mesh::Index v) { return m.point_on[v].dim == 2; };
         for (std::uint32_t t = 0; t < m.triangles.size(); ++t)
           if (std::all_of(m.triangles[t].begin(), m.triangles[t].end(), inside))
             return remove_triangle(m, t);
       }},
      {"wrong face", "upward-counts",
       [](Mesh& m, const Model&) { std::swap(m.triangles[4][0], m.triangles[4][1]); }},
      {"wrong face tag", "closure",
       [](Mesh& m, const Model&) { m.triangle_on[4] = m.triangle_on[4] % 6 + 1; }},
      {"wrong face tag leaves the plane", "face-borders",
       [](Mesh& m, const Model&) { m.triangle_on[4] = m.triangle_on[4] % 6 + 1; }},
      {"flipped triangle", "face-orientation",
       [](Mesh& m, const Model&) { std::swap(m.triangles[4][0], m.triangles[4][1]); }},
      {"flipped triangle at its sides", "face-borders",
       [](Mesh& m, const Model&) { std::swap(m.triangles[4][0], m.triangles[4][1]); }},
      {"removed chain piece", "edge-chains", [](Mesh& m, const Model&) { remove_edge(m, 5); }},
      {"piece of another edge", "edge-chains",
       [](Mesh& m, const Model&) { m.edge_on[5] = m.edge_on[5] % 12 + 1; }},
      {"reversed piece", "edge-chains",
       [](Mesh& m, const Model&) { std::swap(m.edges[5][0], m.edges[5][1]); }},
      {"piece twice", "edge-chains",
       [](Mesh& m, const Model&) {
         m.edges.push_back(m.edges[5]);
         m.edge_on.push_back(m.edge_on[5]);
       }},
      {"model vertex not told", "model-vertices",
       [](Mesh& m, const Model& model) {
         m.point_on[node_on(m, 0)] = model_edge(model.vertex(m.point_on[node_on(m, 0)].tag).edges[0]);
       }},
      {"model vertex twice", "model-vertices",
       [](Mesh& m, const Model&) { m.point_on[node_on(m, 1)] = m.point_on[node_on(m, 0)]; }},
      {"face node off the face", "nodes-on-entity",
       [](Mesh& m, const Model&) { m.points[node_on(m, 2)] += Vec3(1e-5, 1e-5, 1e-5); }},
      {"edge node off the edge", "nodes-on-entity",
       [](Mesh& m, const Model&) { m.points[node_on(m, 1)] += Vec3(1e-5, 1e-5, 1e-5); }},
      {"vertex moved", "nodes-on-entity",
       [](Mesh& m, const Model&) { m.points[node_on(m, 0)] += Vec3(1e-5, 0, 0); }},
      {"vertex moved changes lengths", "edge-length",
       [](Mesh& m, const Model&) { m.points[node_on(m, 0)] += Vec3(1e-3, 0, 0); }},
      {"edge node past its neighbour", "edge-chains",
       [](Mesh& m, const Model&) {
         const std::uint32_t e = 5;
         const auto [a, b] = m.edges[e];
         std::swap(m.points[a], m.points[b]);
       }},
      {"node used by nothing", "orphan-nodes",
       [](Mesh& m, const Model&) {
         m.points.emplace_back(0.1, 0.1, 0.1);
         m.point_on.push_back(model_region(1));
       }},
      {"node inside told to be on a face", "orphan-nodes",
       [](Mesh& m, const Model&) { m.point_on[node_on(m, 3)] = model_face(1); }},
      {"torn node", "duplicate-nodes", [](Mesh& m, const Model&) { tear(m, node_on(m, 3)); }},
      {"torn node opens the inside", "boundary-classified",
       [](Mesh& m, const Model&) { tear(m, node_on(m, 3)); }},
      {"missing tet", "region-volume",
       [](Mesh& m, const Model&) {
         m.tets.pop_back();
         m.tet_in.pop_back();
       }},
      {"missing tet and what its boundary encloses", "volumes-add-up",
       [](Mesh& m, const Model&) {
         m.tets.pop_back();
         m.tet_in.pop_back();
       }},
      {"surface pushed through the far side", "no-overlap",
       [](Mesh& m, const Model&) { m.points[node_on(m, 2)] = Vec3(1.45, 0.95, 2.0); }},
      {"far from the surface", "surface-distance",
       [](Mesh& m, const Model&) {
         for (std::uint32_t t = m.triangles.size(); t-- > 0;)
           if (m.triangle_on[t] == 2 && t != triangle_inside(m, 2)) remove_triangle(m, t);
       }},
  };
  return kDefects;
}

TEST(Acceptance, EveryDefectIsCaughtByItsClaim) {
  const Model model = box();
  const Mesh good = box_mesh_on(model, 3);
  for (const Defect& defect : defects()) {
    Mesh bad = good;
    defect.inject(bad, model);
    const auto broken = broken_claims(bad, model);
    EXPECT_TRUE(has(broken, defect.claim)) << defect.name << " broke " << ::testing::PrintToString(broken);
  }
}

TEST(Acceptance, AnInterfaceWithoutTrianglesIsCaught) {
  const Model model = analytic_two_boxes(kSize);
  const Vec3 whole(2.0 * kSize.x(), kSize.y(), kSize.z());
  Mesh mesh = test::box_mesh(test::part_of(model), whole, {2, 2, 2});
  int shared = 0;
  for (int face = 1; face <= model.count(2); ++face)
    if (model.face(face).region[0] != 0 && model.face(face).region[1] != 0) shared = face;
  ASSERT_GT(shared, 0);
  for (std::uint32_t t = mesh.triangles.size(); t-- > 0;)
    if (mesh.triangle_on[t] == shared) remove_triangle(mesh, t);
  EXPECT_TRUE(has(broken_claims(mesh, model), "interfaces-classified"));
}

TEST(Acceptance, ATetrahedronOfTheWrongRegionIsCaught) {
  const Model model = analytic_two_boxes(kSize);
  const Vec3 whole(2.0 * kSize.x(), kSize.y(), kSize.z());
  Mesh mesh = test::box_mesh(test::part_of(model), whole, {4, 2, 2});
  mesh.tet_in[0] = 3 - mesh.tet_in[0];
  const auto broken = broken_claims(mesh, model);
  EXPECT_TRUE(has(broken, "upward-counts"));
  EXPECT_TRUE(has(broken, "interfaces-classified"));
  EXPECT_TRUE(has(broken, "regions-connected"));
  EXPECT_TRUE(has(broken, "region-volume"));
}

TEST(Acceptance, ADentInABallIsCaughtByMeasures) {
  const Model model = analytic_ball(5.0);
  Mesh mesh = test::ball_mesh(model, 5.0, 3);
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (mesh.points[v].x() > 3.0) mesh.points[v].x() = 3.0;
  const auto broken = broken_claims(mesh, model);
  EXPECT_TRUE(has(broken, "nodes-on-entity"));
  EXPECT_TRUE(has(broken, "surface-distance"));
}

TEST(Acceptance, AMissingCapOfABallIsNoBall) {
  const Model model = analytic_ball(5.0);
  Mesh mesh = test::ball_mesh(model, 5.0, 2);
  for (std::uint32_t t = mesh.tets.size(); t-- > 0;)
    if (mesh.points[mesh.triangles[t][0]].x() > 4.0) {
      remove_triangle(mesh, t);
      mesh.tets.erase(mesh.tets.begin() + t);
      mesh.tet_in.pop_back();
    }
  const auto broken = broken_claims(mesh, model);
  EXPECT_TRUE(has(broken, "face-euler"));
  EXPECT_TRUE(has(broken, "face-area"));
  EXPECT_TRUE(has(broken, "boundary-classified"));
}

TEST(Acceptance, FaultsTellEntityPlaceCauseAndAdvice) {
  const Model model = box();
  Mesh mesh = box_mesh_on(model, 2);
  const Mesh::Index v = node_on(mesh, 0);
  const ModelRef entity = mesh.point_on[v];
  mesh.points[v] += Vec3(0.01, 0.01, 0.01);
  for (const Claim& claim : accept_mesh(mesh, model).claims) {
    EXPECT_FALSE(claim.statement.empty());
    if (claim.name != "nodes-on-entity") continue;
    ASSERT_EQ(claim.faults.size(), 1u);
    EXPECT_EQ(claim.faults[0].entity, entity);
    EXPECT_EQ(claim.faults[0].place, mesh.points[v]);
    EXPECT_FALSE(claim.faults[0].cause.empty());
    EXPECT_FALSE(claim.faults[0].advice.empty());
    EXPECT_GT(claim.worst, claim.limit);
  }
}

TEST(Acceptance, ManyFaultsAreListedInPartAndTellAllTheirPlaces) {
  const Model model = box();
  Mesh mesh = box_mesh_on(model, 4);
  std::vector<Vec3> moved;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    if (mesh.point_on[v].dim != 2) continue;
    mesh.points[v] += Vec3(0.01, 0.01, 0.01);
    moved.push_back(mesh.points[v]);
  }
  ASSERT_GT(moved.size(), 20u);
  const Acceptance acceptance = accept_mesh(mesh, model);
  const auto claim = std::find_if(acceptance.claims.begin(), acceptance.claims.end(),
                                  [](const Claim& c) { return c.name == "nodes-on-entity"; });
  ASSERT_NE(claim, acceptance.claims.end());
  EXPECT_EQ(claim->faults.size(), 10u);
  ASSERT_EQ(claim->places.size(), moved.size());
  for (const Vec3& place : claim->places)
    EXPECT_NE(std::find(moved.begin(), moved.end(), place), moved.end()) << place.transpose();
}

/// A ball of second order, its nodes on the sphere.
Mesh curved_ball(const Model& model) {
  Mesh mesh = test::ball_mesh(model, 1.0, 2);
  mesh.mid = straight_mid_nodes(mesh);
  for (std::size_t m = 0; m < mesh.mid.points.size(); ++m)
    if (mesh.mid.on[m].dim == 2) mesh.mid.points[m].normalize();
  return mesh;
}

/// A node in the middle of an edge on the face.
std::size_t node_on_face(const Mesh& mesh) {
  std::size_t m = 0;
  while (mesh.mid.on[m].dim != 2) ++m;
  return m;
}

TEST(AcceptanceOfSecondOrder, AGoodBallPassesTwoClaimsMore) {
  const Model model = analytic_ball(1.0);
  Mesh mesh = curved_ball(model);
  EXPECT_EQ(broken_claims(mesh, model), std::vector<std::string>{});
  EXPECT_EQ(accept_mesh(mesh, model).claims.size(), 24u);
  // On the straight edge, and half-way to it, is no fault: elements may have been in the way.
  const std::size_t m = node_on_face(mesh);
  const Vec3 straight = 0.5 * (mesh.points[mesh.mid.between[m][0]] + mesh.points[mesh.mid.between[m][1]]);
  for (const double share : {0.5, 1.0}) {
    mesh.mid.points[m] += share * (straight - mesh.mid.points[m]);
    EXPECT_EQ(broken_claims(mesh, model), std::vector<std::string>{});
  }
}

TEST(AcceptanceOfSecondOrder, ANodeOffItsFaceIsCaught) {
  const Model model = analytic_ball(1.0);
  Mesh mesh = curved_ball(model);
  const std::size_t m = node_on_face(mesh);
  mesh.mid.points[m] *= 1.1;
  const Acceptance acceptance = accept_mesh(mesh, model);
  EXPECT_EQ(broken_claims(mesh, model), std::vector<std::string>{"mid-nodes"});
  const Claim& claim = *std::find_if(acceptance.claims.begin(), acceptance.claims.end(),
                                     [](const Claim& c) { return c.name == "mid-nodes"; });
  ASSERT_EQ(claim.faults.size(), 1u);
  EXPECT_EQ(claim.faults[0].entity, mesh.mid.on[m]);
  EXPECT_EQ(claim.faults[0].place, mesh.mid.points[m]);
}

TEST(AcceptanceOfSecondOrder, AnElementTurnedOverIsCaught) {
  const Model model = analytic_ball(1.0);
  Mesh mesh = curved_ball(model);
  std::size_t inside = 0;
  while (mesh.mid.on[inside].dim != 3) ++inside;
  mesh.mid.points[inside] += Vec3(0.9, 0.9, 0.9);
  EXPECT_EQ(broken_claims(mesh, model), std::vector<std::string>{"curved-elements"});
}

TEST(AcceptanceOfSecondOrder, NodesOfOtherEdgesAndTwinsAndStraysAreCaught) {
  const Model model = analytic_ball(1.0);
  const Mesh good = curved_ball(model);
  const auto expect_caught = [&](const std::function<void(Mesh&)>& spoil, const char* what) {
    Mesh mesh = good;
    spoil(mesh);
    EXPECT_EQ(broken_claims(mesh, model), std::vector<std::string>{"mid-nodes"}) << what;
  };
  expect_caught([](Mesh& mesh) { std::swap(mesh.mid.of_tets[0][0], mesh.mid.of_tets[0][5]); }, "swapped");
  expect_caught(
      [](Mesh& mesh) {
        const auto m = mesh.mid.of_tets[0][0];
        mesh.mid.of_tets[0][0] = static_cast<Mesh::Index>(mesh.mid.points.size());
        mesh.mid.points.push_back(mesh.mid.points[m]);
        mesh.mid.on.push_back(mesh.mid.on[m]);
        mesh.mid.between.push_back(mesh.mid.between[m]);
      },
      "an edge with two nodes");
  expect_caught(
      [](Mesh& mesh) {
        mesh.mid.points.push_back(Vec3::Zero());
        mesh.mid.on.push_back(model_region(1));
        mesh.mid.between.push_back({0, 1});
      },
      "a node of no element");
  expect_caught([](Mesh& mesh) { mesh.mid.on[node_on_face(mesh)] = model_region(1); }, "on the wrong entity");
  expect_caught([](Mesh& mesh) { mesh.mid.of_triangles.pop_back(); }, "a triangle of first order");
  expect_caught([](Mesh& mesh) { mesh.mid.of_tets[3][2] = 1'000'000; }, "no such node");
}

TEST(Acceptance, CostlyClaimsCanBeLeftOut) {
  const Model model = box();
  const Acceptance acceptance =
      accept_mesh(box_mesh_on(model, 1), model, {.sample_surface = false, .overlap = false});
  EXPECT_TRUE(acceptance.holds());
  EXPECT_EQ(acceptance.claims.size(), 20u);
}

}  // namespace
}  // namespace octet
