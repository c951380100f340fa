// SPDX-License-Identifier: BSD-3-Clause
// Strips are found by the tolerances of their own sides, and replaced by OCCT.
#include "geom/occt/strips.h"

#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_CheckSmallFace.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_FixSmallFace.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Pnt.hxx>

#include <algorithm>
#include <array>

#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

/// The two long sides of the face when they are nowhere farther apart than `width`; null edges else.
std::array<TopoDS_Edge, 2> sides_within(const TopoDS_Face& face, double width) {
  std::array<TopoDS_Edge, 2> side;
  try {
    ShapeAnalysis_CheckSmallFace check;
    if (!check.CheckStripFace(face, side[0], side[1], width)) return {};
  } catch (const Standard_Failure&) {  // OCCT cannot tell: not a strip
    return {};
  }
  return side;
}

/// Whether two edges of the face start and end within `width` of each other, as the sides of a strip do.
/// Nearly all faces have none.
bool may_be_strip(const TopoDS_Face& face, double width) {
  std::vector<std::array<gp_Pnt, 2>> ends;
  const TopTools_IndexedMapOfShape edges = sub_shapes(face, TopAbs_EDGE);
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
    if (BRep_Tool::Degenerated(edge)) continue;
    ends.push_back({BRep_Tool::Pnt(TopExp::FirstVertex(edge)), BRep_Tool::Pnt(TopExp::LastVertex(edge))});
  }
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t j = i + 1; j < ends.size(); ++j)
      for (const int turned : {0, 1})
        if (ends[i][0].Distance(ends[j][turned]) <= width &&
            ends[i][1].Distance(ends[j][1 - turned]) <= width)
          return true;
  return false;
}

/// Twice the edge's tolerance; nothing where that is what every edge has, which says nothing of it.
double vagueness(const TopoDS_Edge& edge) {
  const double width = 2.0 * BRep_Tool::Tolerance(edge);
  return width > 10.0 * Precision::Confusion() ? width : 0.0;
}

/// Twice the tolerance of its vaguer long side, or `least` where that is more, if the face is no wider, else
/// 0.
double strip_width(const TopoDS_Face& face, double least) {
  double width = least;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    width = std::max(width, vagueness(TopoDS::Edge(it.Current())));
  if (!may_be_strip(face, width)) return 0.0;
  const auto [a, b] = sides_within(face, width);
  if (a.IsNull() || b.IsNull()) return 0.0;
  const double own = std::max({least, vagueness(a), vagueness(b)});
  return own == width || !sides_within(face, own)[0].IsNull() ? own : 0.0;
}

/// `step`: what OCCT's fixer is to do; returns the solid.
template <class Step>
void fix_small_faces(double width, const Step& step, Repair& repair) {
  const Handle(ShapeBuild_ReShape) context = new ShapeBuild_ReShape;
  ShapeFix_FixSmallFace fix;
  fix.Init(repair.solid);
  fix.SetContext(context);
  fix.SetPrecision(width);
  repair.solid = step(fix);
  repair.history = context->History();
}

bool is_spot(const TopoDS_Face& face, double width) {
  try {
    return ShapeAnalysis_CheckSmallFace().CheckSpotFace(face, width);
  } catch (const Standard_Failure&) {  // OCCT cannot tell
    return false;
  }
}

}  // namespace

Repair merge_strips(const TopoDS_Shape& solid, double least) {
  Repair result = no_repair(solid);
  double width = 0.0;
  std::vector<TopoDS_Face> others;
  for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Face& face = TopoDS::Face(it.Current());
    if (const double own = strip_width(face, least); own > 0.0) {
      result.entities.push_back(face);
      width = std::max(width, own);
    } else {
      others.push_back(face);
    }
  }
  // OCCT merges whatever is as narrow: a face that is exact must not go with those that are vague.
  const auto goes_too = [&](const TopoDS_Face& face) { return !sides_within(face, width)[0].IsNull(); };
  if (std::any_of(others.begin(), others.end(), goes_too)) result.entities.clear();
  if (result.entities.empty()) return result;
  fix_small_faces(
      width, [](ShapeFix_FixSmallFace& fix) { return fix.FixStripFace(); }, result);
  return result;
}

Repair shrink_spots(const TopoDS_Shape& solid, double width) {
  Repair result = no_repair(solid);
  for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next())
    if (is_spot(TopoDS::Face(it.Current()), width)) result.entities.push_back(it.Current());
  if (result.entities.empty()) return result;
  fix_small_faces(
      width, [](ShapeFix_FixSmallFace& fix) { return fix.FixSpotFace(); }, result);
  return result;
}

}  // namespace octet
