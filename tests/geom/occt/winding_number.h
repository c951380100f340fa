// SPDX-License-Identifier: BSD-3-Clause
// Which solid holds a point, by winding numbers: shares nothing with the model and nothing with OCCT's
// classifier.
#pragma once

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "geom/facet_bvh.h"
#include "geom/model.h"
#include "geom/occt/numbering.h"
#include "geom/size_wishes.h"

namespace octet::test {

/// Triangles of the solids' boundaries, summed as solid angles [Van Oosterom & Strackee 1983]: those of
/// OCCT's mesher, and the model's own facets where that leaves a face out. A hole in a triangulation gives a
/// number between 0 and 1, which is no answer, not a wrong one.
class WindingNumbers {
 public:
  WindingNumbers(const Numbering& numbering, const Model& model) : numbering_(numbering), model_(model) {}

  /// Tag of the solid that holds p, 0: none; no value where the finest triangulation comes as near to p as it
  /// may lie from the surface, or does not enclose it one whole time or not at all.
  [[nodiscard]] std::optional<int> region_around(const Vec3& p) {
    for (const double share : {1e-3, 1e-4}) {
      const double deflection = share * model_.diagonal();
      if (const auto answer = region_around(p, triangles(deflection))) return answer;
    }
    if (facets_.empty()) facets_ = facets();
    return region_around(p, facets_);
  }

 private:
  struct Triangle {
    Vec3 a, b, c;
    double clearance;  ///< how near to it p may not be
  };
  using Solids = std::vector<std::vector<Triangle>>;  ///< by tag, [0] unused

  [[nodiscard]] static std::optional<int> region_around(const Vec3& p, const Solids& solids) {
    constexpr double kSure = 0.02;
    int found = 0;
    for (std::size_t tag = 1; tag < solids.size(); ++tag) {
      double angle = 0.0;
      for (const Triangle& t : solids[tag]) {
        if (closest_on_triangle(p, t.a, t.b, t.c).distance < t.clearance) return std::nullopt;
        angle += solid_angle(t.a - p, t.b - p, t.c - p);
      }
      const double turns = std::abs(angle) / (4.0 * std::numbers::pi);
      if (std::abs(turns - std::round(turns)) > kSure) return std::nullopt;
      if (turns > 0.5) found = static_cast<int>(tag);
    }
    return found;
  }

  static double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    return 2.0 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }

  /// Made when first asked for: most parts never need them.
  const Solids& triangles(double deflection) {
    for (const auto& [known, solids] : made_)
      if (known == deflection) return solids;
    Solids solids(1);
    for (int tag = 1; tag <= numbering_.count(3); ++tag)
      solids.push_back(triangulate(numbering_.solid(tag), deflection));
    made_.emplace_back(deflection, std::move(solids));
    return made_.back().second;
  }

  static std::vector<Triangle> triangulate(const TopoDS_Shape& solid, double deflection) {
    const TopoDS_Shape copy = BRepBuilderAPI_Copy(solid).Shape();
    const BRepMesh_IncrementalMesh mesher(copy, deflection, false, 0.3);
    std::vector<Triangle> triangles;
    for (TopExp_Explorer faces(copy, TopAbs_FACE); faces.More(); faces.Next()) {
      const TopAbs_Orientation side = faces.Current().Orientation();
      if (side != TopAbs_FORWARD && side != TopAbs_REVERSED) continue;  // embedded: bounds nothing
      TopLoc_Location place;
      const auto mesh = BRep_Tool::Triangulation(TopoDS::Face(faces.Current()), place);
      if (mesh.IsNull()) continue;
      const auto node = [&](int i) {
        const gp_Pnt x = mesh->Node(i).Transformed(place);
        return Vec3(x.X(), x.Y(), x.Z());
      };
      for (int i = 1; i <= mesh->NbTriangles(); ++i) {
        int a = 0, b = 0, c = 0;
        mesh->Triangle(i).Get(a, b, c);
        if (side == TopAbs_REVERSED) std::swap(b, c);
        triangles.push_back({node(a), node(b), node(c), 3.0 * deflection});
      }
    }
    return triangles;
  }

  [[nodiscard]] Solids facets() const {
    Solids solids(static_cast<std::size_t>(model_.count(3)) + 1);
    const Facets& facets = model_.facets();
    for (std::size_t i = 0; i < facets.triangles.size(); ++i) {
      const auto [a, b, c] = facet_corners(facets, i);
      const double grow = model_.bvh().grow(static_cast<std::uint32_t>(i));
      const auto& [behind, before] = model_.face(facets.face[i]).region;
      if (behind != 0) solids[behind].push_back({a, b, c, grow});
      if (before != 0) solids[before].push_back({a, c, b, grow});
    }
    return solids;
  }

  const Numbering& numbering_;
  const Model& model_;
  std::vector<std::pair<double, Solids>> made_;
  Solids facets_;
};

}  // namespace octet::test
