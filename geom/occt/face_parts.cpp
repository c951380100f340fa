// SPDX-License-Identifier: BSD-3-Clause
// A shell of the parts takes the face's place.
#include "geom/occt/face_parts.h"

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>

#include <utility>

#include "geom/occt/gathered.h"

namespace octet {

FaceParts::FaceParts(const TopoDS_Shape& solid, Repair cut)
    : solid_(solid), cut_(std::move(cut)), changes_(new BRepTools_ReShape) {}

void FaceParts::part(const TopoDS_Face& face,
                     const std::function<std::vector<TopoDS_Face>(const TopoDS_Face&)>& parts_of) {
  TopTools_ListOfShape now = cut_.history->Modified(face);
  if (now.IsEmpty()) now.Append(face);
  if (now.Extent() != 1) return;
  const TopoDS_Face whole = TopoDS::Face(now.First().Oriented(TopAbs_FORWARD));
  const std::vector<TopoDS_Face> parts = parts_of(whole);
  if (parts.size() < 2) return;
  changes_->Replace(whole, shell_of(parts));
  parted_.push_back(face);
}

Repair FaceParts::apply() const {
  Repair result = no_repair(solid_);
  if (parted_.empty()) return result;
  result.entities = parted_;
  result.solid = changes_->Apply(cut_.solid);
  result.history->Merge(cut_.history);
  result.history->Merge(changes_->History());
  return result;
}

double area_along(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  constexpr int kPieces = 16;
  double first = 0.0, last = 0.0, area = 0.0;
  const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  for (int i = 0; i < kPieces; ++i) {
    const gp_Pnt2d a = curve->Value(first + (last - first) * i / kPieces),
                   b = curve->Value(first + (last - first) * (i + 1) / kPieces);
    area += 0.5 * (a.X() * b.Y() - a.Y() * b.X());
  }
  return edge.Orientation() == TopAbs_REVERSED ? -area : area;
}

}  // namespace octet
