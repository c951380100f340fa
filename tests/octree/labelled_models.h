// SPDX-License-Identifier: BSD-3-Clause
// Analytic models with all that the octree room makes of them, for tests.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "geom/analytic.h"
#include "octree/cuts.h"
#include "octree/labels.h"

namespace octet::test {

/// A model in general position.
inline AnalyticOptions turned() {
  AnalyticOptions options;
  options.frame.origin = Vec3(0.3, -0.2, 0.1);
  options.frame.axes =
      (Eigen::AngleAxisd(0.4, Vec3::UnitX()) * Eigen::AngleAxisd(0.7, Vec3::UnitZ())).toRotationMatrix();
  return options;
}

struct NamedModel {
  std::string name;
  Model model;
  double size;
};

inline std::vector<NamedModel> analytic_models() {
  std::vector<NamedModel> models;
  models.push_back({"box", analytic_box(Vec3(1.0, 1.2, 0.8)), 0.1});
  models.push_back({"turned box", analytic_box(Vec3(1.0, 1.2, 0.8), turned()), 0.1});
  models.push_back({"two boxes", analytic_two_boxes(Vec3(0.7, 0.8, 0.9), turned()), 0.1});
  models.push_back({"plate", analytic_box(Vec3(1.0, 1.0, 0.01), turned()), 0.1});
  models.push_back({"wedge", analytic_wedge(0.2, 1.0, 0.5, turned()), 0.1});
  models.push_back({"ball", analytic_ball(0.5), 0.1});
  models.push_back({"hollow ball", analytic_hollow_ball(0.6, 0.55), 0.1});
  models.push_back({"box minus ball", analytic_box_minus_ball(1.0, 0.35, turned()), 0.1});
  models.push_back({"cylinder", analytic_cylinder(0.4, 0.9, turned()), 0.1});
  models.push_back({"cone", analytic_cone(0.4, 0.9), 0.1});
  models.push_back({"torus", analytic_torus(0.7, 0.2, turned()), 0.1});
  return models;
}

struct Labelled {
  Octree tree;
  OctreeVertices vertices;
  OctantTypes types;
  std::vector<OctantEdge> edges;
  std::vector<OctantEdgeCut> cuts;
  OctreeLabels labels;
};

inline Labelled label(const Model& model, double size, const std::vector<SizeSample>& samples = {}) {
  Octree tree = build_octree(model, {size}, samples);
  OctreeVertices vertices = octree_vertices(tree);
  OctantTypes types = octant_types(model, tree);
  std::vector<OctantEdge> edges = boundary_octant_edges(tree, vertices, types);
  std::vector<OctantEdgeCut> cuts = cut_octant_edges(model, tree, vertices, edges);
  OctreeLabels labels = label_vertices(model, tree, vertices, types, edges, cuts);
  return {std::move(tree),  std::move(vertices), std::move(types),
          std::move(edges), std::move(cuts),     std::move(labels)};
}

}  // namespace octet::test
