// SPDX-License-Identifier: BSD-3-Clause
// Curves that edges lack, in space, on a face or at a pole, and curves on faces that are of another place or
// run beside their edges.
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <string>

#include "geom/occt/entity_names.h"
#include "geom/occt/solids.h"

namespace octet {

/// Adds what is missing to the solids of a set, and counts it.
class MissingCurves {
 public:
  MissingCurves(const EntityNames& names, SolidSet& set) : names_(names), set_(set) {}

  /// Edges without a curve in space, or without one on a face, get one.
  void add_to(const TopoDS_Shape& solid);
  /// Curves on faces that are of another place than their edges are made anew: geom/occt/misplaced_curves.
  void renew(const TopoDS_Shape& solid);
  /// Curves on faces that run beside their edges are fitted anew: geom/occt/loose_curves.
  void fit(const TopoDS_Shape& solid);
  /// Where a loop runs through a pole of its surface without an edge there, its ends are apart in (u,v).
  void add_pole_edges(TopoDS_Shape& solid);
  /// A note for each kind that was added, with the count and the first.
  void tell() const;

 private:
  void add_in_space(const TopoDS_Edge& edge);
  void add_on_face(const TopoDS_Edge& edge, const TopoDS_Face& face);

  const EntityNames& names_;
  SolidSet& set_;
  int in_space_ = 0, on_face_ = 0, at_pole_ = 0, fitted_ = 0;
  double farthest_ = 0.0;  ///< mm
  std::string first_in_space_, first_on_face_, first_at_pole_, farthest_fitted_;
};

}  // namespace octet
