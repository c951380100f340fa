// SPDX-License-Identifier: BSD-3-Clause
// OCCT's repairs of single curves, told.
#include "geom/occt/missing_curves.h"

#include <fmt/format.h>

#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_Edge.hxx>
#include <ShapeFix_Wire.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <vector>

#include "geom/occt/added_curve.h"
#include "geom/occt/loose_curves.h"
#include "geom/occt/misplaced_curves.h"
#include "geom/occt/shape_box.h"
#include "geom/tiny_features.h"

namespace octet {

void MissingCurves::add_to(const TopoDS_Shape& solid) {
  for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next()) {
    const TopoDS_Face face = TopoDS::Face(faces.Current().Oriented(TopAbs_FORWARD));
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
      if (BRep_Tool::Degenerated(edge)) continue;
      add_in_space(edge);
      add_on_face(edge, face);
    }
  }
}

void MissingCurves::add_in_space(const TopoDS_Edge& edge) {
  double first = 0.0, last = 0.0;
  if (!BRep_Tool::Curve(edge, first, last).IsNull() || !BRepLib::BuildCurve3d(edge)) return;
  if (in_space_++ == 0) first_in_space_ = names_.numbered("Edge", 1, edge);
}

void MissingCurves::add_on_face(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  if (!add_curve(edge, face)) return;
  fit_curve(edge, face);
  if (on_face_++ == 0)
    first_on_face_ = names_.numbered("Edge", 1, edge) + " on " + names_.numbered("Face", 2, face);
}

void MissingCurves::renew(const TopoDS_Shape& solid) {
  const CurvesRenewed renewed = renew_misplaced_curves(solid);
  if (!renewed.curves.empty()) {
    const CurveRenewed& first = renewed.curves.front();
    set_.notes.push_back(fmt::format(
        "{} edge(s) of {} lie on their faces, but their curves there were of another place and were made "
        "anew, the first is {} on {} ({:.3g} mm)",
        renewed.curves.size(), names_.solid(solid), names_.numbered("Edge", 1, first.edge),
        names_.numbered("Face", 2, first.face), first.gap));
  }
  if (!renewed.joined.empty())
    set_.notes.push_back(fmt::format(
        "{} face(s) of {} had curves of their edges whole turns apart, which were joined, the "
        "first is {}",
        renewed.joined.size(), names_.solid(solid), names_.numbered("Face", 2, renewed.joined.front())));
}

void MissingCurves::fit(const TopoDS_Shape& solid) {
  const double apart = std::max(Precision::Confusion(), kRoundingShare * diagonal_of(vertex_box_of(solid)));
  for (const CurveRenewed& one : fit_loose_curves(solid, apart)) {
    ++fitted_;
    if (one.gap <= farthest_) continue;
    farthest_ = one.gap;
    farthest_fitted_ = names_.numbered("Edge", 1, one.edge) + " on " + names_.numbered("Face", 2, one.face);
  }
}

void MissingCurves::add_pole_edges(TopoDS_Shape& solid) {
  const Handle(ShapeBuild_ReShape) changes = new ShapeBuild_ReShape();
  TopTools_MapOfShape seen;
  for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next()) {
    const TopoDS_Face face = TopoDS::Face(faces.Current().Oriented(TopAbs_FORWARD));
    if (!seen.Add(face) ||
        !ShapeAnalysis_Surface(BRep_Tool::Surface(face)).HasSingularities(Precision::Confusion()))
      continue;
    for (TopExp_Explorer it(face, TopAbs_WIRE); it.More(); it.Next()) {
      ShapeFix_Wire fix(TopoDS::Wire(it.Current()), face, Precision::Confusion());
      const int edges = fix.NbEdges();
      fix.FixReorder();
      if (!fix.FixDegenerated() || fix.NbEdges() == edges) continue;
      changes->Replace(it.Current(), fix.Wire());
      if (at_pole_++ == 0) first_at_pole_ = names_.numbered("Face", 2, face);
    }
  }
  const TopoDS_Shape made = changes->Apply(solid);
  if (made.IsSame(solid)) return;
  set_.history->Merge(changes->History());
  set_.history->AddModified(solid, made);
  solid = made;
}

void MissingCurves::tell() const {
  if (fitted_ > 0)
    set_.notes.push_back(
        fmt::format("{} curve(s) on faces ran beside their edges, which lie on those faces, and were fitted "
                    "anew, the farthest is {} ({:.3g} mm)",
                    fitted_, farthest_fitted_, farthest_));
  if (in_space_ > 0)
    set_.notes.push_back(
        fmt::format("{} edge(s) had no curve in space and got that of their face, the first is {}", in_space_,
                    first_in_space_));
  if (at_pole_ > 0)
    set_.notes.push_back(fmt::format("{} loop(s) had no edge at a pole and got one, the first is of {}",
                                     at_pole_, first_at_pole_));
  if (on_face_ > 0)
    set_.notes.push_back(fmt::format("{} edge(s) had no curve on a face and got one, the first is {}",
                                     on_face_, first_on_face_));
}

}  // namespace octet
