// SPDX-License-Identifier: BSD-3-Clause
// The solids of a shape, sewn and fused where the file left them apart.
#include "geom/occt/solids.h"

#include <fmt/format.h>

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <limits>

#include "base/error.h"
#include "base/segment.h"
#include "geom/occt/canonical.h"
#include "geom/occt/caps.h"
#include "geom/occt/edge_uses.h"
#include "geom/occt/entity_names.h"
#include "geom/occt/free_edges.h"
#include "geom/occt/shape_box.h"
#include "geom/occt/shell_solids.h"
#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

/// A bounded middle point of an edge, by its vertices when it has no curve.
Vec3 place_of(const TopoDS_Edge& edge) {
  double first = 0.0, last = 0.0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  if (!curve.IsNull()) return to_vec(curve->Value(0.5 * (first + last)));
  const TopoDS_Vertex vertex = TopExp::FirstVertex(edge);
  return vertex.IsNull() ? Vec3(Vec3::Zero()) : to_vec(BRep_Tool::Pnt(vertex));
}

/// How far the middle of the edge is from the nearest of the others, by points along them.
double gap_at(const TopoDS_Edge& edge, const std::vector<TopoDS_Edge>& others) {
  constexpr int kPieces = 16;
  const Vec3 middle = place_of(edge);
  double least = std::numeric_limits<double>::infinity();
  for (const TopoDS_Edge& other : others) {
    if (other.IsSame(edge)) continue;
    const std::vector<Vec3> points = points_along(other, kPieces);
    for (std::size_t i = 1; i < points.size(); ++i)
      least = std::min(least, distance_to_segment(middle, points[i - 1], points[i]));
  }
  return least;
}

/// A face of `shape` that has the edge.
TopoDS_Shape face_with(const TopoDS_Shape& shape, const TopoDS_Edge& edge) {
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
    for (TopExp_Explorer it(face.Current(), TopAbs_EDGE); it.More(); it.Next())
      if (it.Current().IsSame(edge)) return face.Current();
  return {};
}

/// What to do about an opening of this width. Sewing joins what is nearer than a hundredth of the part; the
/// tolerance is half as much again, in two digits, for the width is that at one place.
std::string advice_for(double gap, double diagonal, double sewn) {
  constexpr double kSewable = 0.01, kReserve = 1.5;
  if (gap > kSewable * diagonal) return "close the shell there: no other face comes near";
  if (kReserve * gap <= sewn) return "close the shell there";
  return fmt::format("sew its faces with --sew {:.2g}, or close the shell there", kReserve * gap);
}

/// Of several faces, none of which is in a solid by a cap.
std::vector<TopoDS_Shape> open_shells(const Sewn& sewn) {
  TopTools_MapOfShape used;
  for (const TopoDS_Shape& solid : sewn.solids)
    for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) used.Add(it.Current());
  std::vector<TopoDS_Shape> shells;
  for (TopExp_Explorer it(sewn.shape, TopAbs_SHELL); it.More(); it.Next()) {
    const TopTools_IndexedMapOfShape faces = sub_shapes(it.Current(), TopAbs_FACE);
    if (faces.Extent() > 1 && !used.Contains(faces(1)) && edge_uses(it.Current()).first(&Uses::open) != 0)
      shells.push_back(it.Current());
  }
  return shells;
}

/// Whether two of its faces share an edge.
bool hangs_together(const TopoDS_Shape& shell) {
  TopTools_IndexedDataMapOfShapeListOfShape faces_of;
  TopExp::MapShapesAndUniqueAncestors(shell, TopAbs_EDGE, TopAbs_FACE, faces_of);
  return std::any_of(faces_of.cbegin(), faces_of.cend(),
                     [](const auto& faces) { return faces.Extent() > 1; });
}

/// Shells of the file, none of whose faces is in a solid. Single faces, and such as only lie side by side,
/// are for construction; several that hang together were meant to bound something.
std::vector<TopoDS_Shape> open_shells_as_read(const TopoDS_Shape& shape, const SolidSet& set) {
  TopTools_MapOfShape used, seen;
  for (const TopoDS_Shape& solid : set.solids)
    for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) used.Add(it.Current());
  std::vector<TopoDS_Shape> shells;
  for (TopExp_Explorer it(shape, TopAbs_SHELL, TopAbs_SOLID); it.More(); it.Next()) {
    const TopTools_IndexedMapOfShape faces = sub_shapes(it.Current(), TopAbs_FACE);
    const bool is_used = std::any_of(faces.cbegin(), faces.cend(),
                                     [&](const TopoDS_Shape& face) { return used.Contains(face); });
    if (!is_used && hangs_together(it.Current()) && seen.Add(it.Current())) shells.push_back(it.Current());
  }
  return shells;
}

/// Words for a note: how many shells of these solids are voids.
std::string voids_in(const std::vector<TopoDS_Shape>& solids) {
  const std::size_t voids = count_voids(solids);
  return voids > 0
             ? fmt::format(", {} of them void(s) within another, for they are turned the other way", voids)
             : "";
}

}  // namespace

ShapeMaps::ShapeMaps(const TopoDS_Shape& shape) {
  for (int dim = 0; dim < 4; ++dim) TopExp::MapShapes(shape, kShapeTypes[dim], of[dim]);
}

TopTools_ListOfShape images_of(const TopoDS_Shape& shape, const SolidSet& set) {
  TopTools_ListOfShape images;
  if (BRepTools_History::IsSupportedType(shape)) images = set.history->Modified(shape);
  if (images.IsEmpty() && !set.history->IsRemoved(shape)) images.Append(shape);
  return images;
}

LooseFaces loose_faces(const ShapeMaps& as_read, const SolidSet& set) {
  TopTools_MapOfShape used;
  for (const TopoDS_Shape& solid : set.solids)
    for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) used.Add(it.Current());
  LooseFaces loose;
  for (int number = 1; number <= as_read.of[2].Extent(); ++number) {
    const TopTools_ListOfShape images = images_of(as_read.of[2](number), set);
    const auto is_used = [&](const TopoDS_Shape& image) { return used.Contains(image); };
    if (images.IsEmpty() || std::any_of(images.begin(), images.end(), is_used)) continue;
    loose.numbers.push_back(number);
    loose.faces.insert(loose.faces.end(), images.begin(), images.end());
  }
  return loose;
}

int number_as_read(int dim, const TopoDS_Shape& shape, const ShapeMaps& as_read, const SolidSet& set) {
  const TopTools_IndexedMapOfShape& entities = as_read.of[dim];
  if (const int number = entities.FindIndex(shape); number > 0) return number;
  for (int number = 1; number <= entities.Extent(); ++number)
    for (const TopoDS_Shape& image : images_of(entities(number), set))
      if (image.IsSame(shape)) return number;
  return 0;
}

Fault opening_of(const TopoDS_Shape& shape, const TopoDS_Shape& sewn, const ShapeMaps& as_read,
                 const SolidSet& set, const SewOptions& tried) {
  Fault fault;
  fault.cause = "it holds no solid and no closed shell";
  const std::vector<TopoDS_Edge> edges = free_edges(shape);
  if (edges.empty()) return fault;
  constexpr std::size_t kMeasured = 500;  // free edges: each is compared with each
  double widest = -1.0;
  const TopoDS_Edge* worst = nullptr;
  for (std::size_t i = 0; i < std::min(edges.size(), kMeasured); ++i) {
    const double gap = edges.size() > 1 ? gap_at(edges[i], edges) : 0.0;
    if (gap <= widest) continue;
    widest = gap;
    worst = &edges[i];
  }
  fault.place = place_of(*worst);
  const int number = number_as_read(1, *worst, as_read, set);
  fault.entity = model_edge(number);
  fault.cause = fmt::format("Edge {} of Face {} is free (at {:.6g}, {:.6g}, {:.6g})", number,
                            number_as_read(2, face_with(shape, *worst), as_read, set), fault.place.x(),
                            fault.place.y(), fault.place.z());
  fault.advice = "close the shell there";
  if (edges.size() > 1) {
    fault.cause += fmt::format(", one of {} free edges and the farthest from any other, {:.3g} mm",
                               edges.size(), widest);
    fault.advice = advice_for(widest, diagonal_of(box_of(shape)), tried.tolerance);
  }
  if (const auto caps = tried.cap ? std::vector<Cap>{} : planar_caps(sewn, tried.tolerance); !caps.empty())
    fault.advice += fmt::format("; {} opening(s) lie in planes: --cap closes such", caps.size());
  return fault;
}

void add_caps(const std::vector<Cap>& caps, const ShapeMaps& as_read, SolidSet& set) {
  if (caps.empty()) return;
  set.notes.push_back(caps_note(caps, set.caps.size(), EntityNames(as_read, set)));
  for (const Cap& cap : caps) set.caps.push_back(cap.face);
}

SolidSet collect_solids(const TopoDS_Shape& shape, const ShapeMaps& as_read, const SewOptions& sewing) {
  SolidSet set;
  set.history = new BRepTools_History();
  for (int i = 1; i <= as_read.of[3].Extent(); ++i)
    if (TopExp_Explorer(as_read.of[3](i), TopAbs_FACE).More()) set.solids.push_back(as_read.of[3](i));
  const auto shells = solids_from_shells(shape);
  if (!shells.empty()) {
    set.notes.push_back(fmt::format("{} closed shell(s) taken as solid(s){}",
                                    shells.size() + count_voids(shells), voids_in(shells)));
    set.solids.insert(set.solids.end(), shells.begin(), shells.end());
  }
  const std::vector<TopoDS_Shape> loose = loose_faces(as_read, set).faces;
  const Sewn sewn = loose.empty() ? Sewn{} : sew_faces(loose, sewing);
  if (!sewn.shape.IsNull() && (set.solids.empty() || !sewn.solids.empty())) set.history->Merge(sewn.history);
  if (!sewn.solids.empty()) {
    set.notes.push_back(fmt::format(
        "{} loose faces sewn with tolerance {:.3g} mm into {} closed shell(s){}; {} free edge(s) left",
        loose.size(), sewn.tolerance, sewn.solids.size() + count_voids(sewn.solids), voids_in(sewn.solids),
        sewn.free_edges));
    add_caps(sewn.caps, as_read, set);
    set.solids.insert(set.solids.end(), sewn.solids.begin(), sewn.solids.end());
    set.open = open_shells(sewn);
  } else {
    set.open = open_shells_as_read(shape, set);
  }
  if (set.solids.empty()) {
    const TopoDS_Shape& open = sewn.shape.IsNull() ? shape : sewn.shape;
    const Fault opening = opening_of(open, open, as_read, set, {sewn.tolerance, sewing.cap});
    std::string done;
    if (loose.size() > 1)
      done = fmt::format(" with its {} faces sewn within {:.3g} mm", loose.size(), sewn.tolerance);
    if (sewn.caps_left > 0)
      done += fmt::format("{} {} opening(s) closed that lie in planes", done.empty() ? " with" : " and",
                          sewn.caps_left);
    throw ModelError("the part bounds no volume" + done + ": " + opening.cause +
                         (opening.advice.empty() ? "" : "; " + opening.advice),
                     opening.entity);
  }
  return set;
}

}  // namespace octet
