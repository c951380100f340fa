// SPDX-License-Identifier: BSD-3-Clause
// Strips are found by the tolerances and gaps of their own sides, and replaced by OCCT.
#include "geom/occt/strips.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_CheckSmallFace.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_FixSmallFace.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Pnt.hxx>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "geom/occt/added_curve.h"
#include "geom/occt/curve_gaps.h"
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

double longest_chord(const TopoDS_Face& face) {
  double longest = 0.0;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    longest = std::max(
        longest,
        BRep_Tool::Pnt(TopExp::FirstVertex(edge)).Distance(BRep_Tool::Pnt(TopExp::LastVertex(edge))));
  }
  return longest;
}

/// How far the edge runs beside its curve on the face, by samples at equal parameters.
double gap_beside(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  constexpr int kSamples = 24;
  double gap = 0.0;
  if (BRep_Tool::Degenerated(edge)) return gap;
  try {
    const BRepAdaptor_Curve curve(edge), on_face(edge, face);
    const double first = curve.FirstParameter(), last = curve.LastParameter();
    for (int i = 0; i <= kSamples; ++i) {
      const double t = first + (last - first) * i / kSamples;
      gap = std::max(gap, curve.Value(t).Distance(on_face.Value(t)));
    }
  } catch (const Standard_Failure&) {  // no curve on the face: nothing to measure
    return 0.0;
  }
  return gap;
}

/// Widths within which a face is a strip.
class StripWidth {
 public:
  /// `least`: of every face.
  StripWidth(const TopoDS_Face& face, double least)
      : face_(face), least_(least), slender_(may_be_strip(face, kSlender * longest_chord(face))) {}

  /// The vagueness of its sides, halved while the face is a strip within that; 0: it is none.
  [[nodiscard]] double find() const {
    double width = least_;
    for (TopExp_Explorer it(face_, TopAbs_EDGE); it.More(); it.Next())
      width = std::max(width, vagueness(TopoDS::Edge(it.Current())));
    if (!may_be_strip(face_, width)) return 0.0;
    const auto [a, b] = sides_within(face_, width);
    if (a.IsNull() || b.IsNull()) return 0.0;
    const double own = std::max({least_, vagueness(a), vagueness(b)});
    if (own < width && !is_strip(own)) return 0.0;
    width = own;
    // OCCT merges all that is as narrow.
    while (0.5 * width > least_ && is_strip(0.5 * width)) width *= 0.5;
    return width;
  }

 private:
  static constexpr double kSlender = 0.1;

  [[nodiscard]] bool is_strip(double width) const { return !sides_within(face_, width)[0].IsNull(); }

  /// Twice the edge's tolerance, or twice as far as it runs beside a slender face; nothing where that is what
  /// every edge has, which says nothing of it.
  [[nodiscard]] double vagueness(const TopoDS_Edge& edge) const {
    const double gap = slender_ ? gap_beside(edge, face_) : 0.0;
    const double width = 2.0 * std::max(BRep_Tool::Tolerance(edge), gap);
    return width > 10.0 * Precision::Confusion() ? width : 0.0;
  }

  const TopoDS_Face& face_;
  double least_;
  bool slender_;
};

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

/// The sides of a face between two edges that have the same ends.
struct Lens {
  TopoDS_Edge vague, clear;
  TopoDS_Face beyond;  ///< at the vague side
};

/// None where neither side is much vaguer than the other, or where they are more than sides of this face and
/// of one other each.
std::optional<Lens> lens_of(const TopoDS_Face& face,
                            const TopTools_IndexedDataMapOfShapeListOfShape& faces_of) {
  constexpr double kVaguer = 10.0;
  std::vector<TopoDS_Edge> sides;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    sides.push_back(TopoDS::Edge(it.Current()));
  if (sides.size() != 2) return std::nullopt;
  for (const TopoDS_Edge& side : sides)
    if (BRep_Tool::Degenerated(side) || faces_of.FindFromKey(side).Extent() != 2) return std::nullopt;
  if (BRep_Tool::Tolerance(sides[0]) < BRep_Tool::Tolerance(sides[1])) std::swap(sides[0], sides[1]);
  const TopoDS_Edge &vague = sides[0], &clear = sides[1];
  if (BRep_Tool::Tolerance(vague) < kVaguer * BRep_Tool::Tolerance(clear) ||
      !TopExp::FirstVertex(vague, true).IsSame(TopExp::LastVertex(clear, true)) ||
      !TopExp::LastVertex(vague, true).IsSame(TopExp::FirstVertex(clear, true)))
    return std::nullopt;
  const TopTools_ListOfShape& users = faces_of.FindFromKey(vague);
  const TopoDS_Face& beyond = TopoDS::Face(users.First().IsSame(face) ? users.Last() : users.First());
  if (beyond.IsSame(face) || faces_of.FindFromKey(clear).Contains(beyond)) return std::nullopt;
  return Lens{vague, clear, beyond};
}

/// The vague side of a lens may run anywhere: the other takes its place. Takes these faces from `faces`; the
/// others are left to OCCT, which may keep either side.
void close_lenses(std::vector<TopoDS_Shape>& faces, Repair& repair) {
  TopTools_IndexedDataMapOfShapeListOfShape faces_of;
  TopExp::MapShapesAndAncestors(repair.solid, TopAbs_EDGE, TopAbs_FACE, faces_of);
  const Handle(ShapeBuild_ReShape) changes = new ShapeBuild_ReShape;
  TopTools_MapOfShape touched;
  const std::size_t closed = std::erase_if(faces, [&](const TopoDS_Shape& face) {
    const std::optional<Lens> lens = lens_of(TopoDS::Face(face), faces_of);
    if (!lens || touched.Contains(lens->vague) || touched.Contains(lens->clear)) return false;
    touched.Add(lens->vague);
    touched.Add(lens->clear);
    add_curve(lens->clear, lens->beyond);
    BRep_Builder().UpdateEdge(lens->clear, curve_gap(lens->clear, lens->beyond));
    changes->Replace(lens->vague, lens->clear.Reversed());  // in the loop the two run against each other
    changes->Remove(face);
    return true;
  });
  if (closed == 0) return;
  repair.solid = changes->Apply(repair.solid);
  repair.history = changes->History();
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
    if (const double own = StripWidth(face, least).find(); own > 0.0) {
      result.entities.push_back(face);
      width = std::max(width, own);
    } else {
      others.push_back(face);
    }
  }
  // OCCT merges whatever is as narrow: a face that is exact must not go with those that are vague.
  const auto goes_too = [&](const TopoDS_Face& face) { return !sides_within(face, width)[0].IsNull(); };
  if (std::any_of(others.begin(), others.end(), goes_too)) result.entities.clear();
  std::vector<TopoDS_Shape> left = result.entities;
  close_lenses(left, result);
  if (left.empty()) return result;
  const Handle(BRepTools_History) lenses = result.history;
  fix_small_faces(
      width, [](ShapeFix_FixSmallFace& fix) { return fix.FixStripFace(); }, result);
  lenses->Merge(result.history);
  result.history = lenses;
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
