// SPDX-License-Identifier: BSD-3-Clause
// Loops of free edges, those in planes, which lie in which, and the faces between them.
#include "geom/occt/caps.h"

#include <fmt/format.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepClass_FaceClassifier.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <GeomLib_IsPlanarSurface.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <optional>

#include "geom/occt/canonical.h"
#include "geom/occt/entity_names.h"
#include "geom/occt/free_edges.h"

namespace octet {
namespace {

/// A loop in a plane, counter-clockwise about its normal.
struct PlaneLoop {
  EdgeLoop edges;
  std::vector<Vec3> points;  ///< along it
  double tolerance = 0.0;
  Vec3 normal = Vec3::Zero(), origin = Vec3::Zero();
  double area = 0.0;
  TopoDS_Face inside;  ///< what it encloses

  [[nodiscard]] double height(const Vec3& p) const { return normal.dot(p - origin); }
  /// How far points of a loop lie off the plane.
  [[nodiscard]] double off(const PlaneLoop& loop) const {
    double most = 0.0;
    for (const Vec3& p : loop.points) most = std::max(most, std::abs(height(p)));
    return most;
  }
};

/// Enough points to see each span of a spline bend; none where the edge has no curve.
std::vector<Vec3> fine_points(const TopoDS_Edge& edge) {
  constexpr int kPieces = 32, kPiecesOfSpan = 8;
  double first = 0.0, last = 0.0;
  if (BRep_Tool::Curve(edge, first, last).IsNull()) return {};
  const BRepAdaptor_Curve curve(edge);
  const int spans = curve.GetType() == GeomAbs_BSplineCurve ? curve.NbKnots() - 1 : 1;
  std::vector<Vec3> points = points_along(edge, std::max(kPieces, kPiecesOfSpan * spans));
  if (edge.Orientation() == TopAbs_REVERSED) std::reverse(points.begin(), points.end());
  return points;
}

TopoDS_Wire wire_of(const EdgeLoop& edges) {
  const BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (const TopoDS_Edge& edge : edges) builder.Add(wire, edge);
  wire.Closed(true);
  return wire;
}

/// The face of a plane within the first loop and without the others, which lie in it.
TopoDS_Face face_within(const PlaneLoop& outer, const std::vector<const PlaneLoop*>& holes) {
  const BRep_Builder builder;
  TopoDS_Face face;
  const gp_Dir normal(outer.normal.x(), outer.normal.y(), outer.normal.z());
  builder.MakeFace(face, new Geom_Plane(to_pnt(outer.origin), normal), Precision::Confusion());
  builder.Add(face, wire_of(outer.edges));
  for (const PlaneLoop* hole : holes) {
    const bool same_way = hole->normal.dot(outer.normal) > 0.0;
    const TopoDS_Wire wire = wire_of(hole->edges);
    builder.Add(face, same_way ? TopoDS_Wire(TopoDS::Wire(wire.Reversed())) : wire);
  }
  return face;
}

/// The loop with its plane, where it lies in one and is wider than the tolerance. The plane's normal is that
/// of the area enclosed, exact where the loop is.
std::optional<PlaneLoop> plane_loop(const EdgeLoop& edges, double tolerance) {
  PlaneLoop loop;
  loop.edges = edges;
  loop.tolerance = tolerance;
  double length = 0.0;
  for (const TopoDS_Edge& edge : edges) {
    const std::vector<Vec3> points = fine_points(edge);
    if (points.empty()) return std::nullopt;
    for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
    loop.points.insert(loop.points.end(), points.begin(), points.end());
    loop.tolerance = std::max(loop.tolerance, BRep_Tool::Tolerance(edge));
  }
  loop.origin = loop.points.front();
  Vec3 twice = Vec3::Zero();
  for (std::size_t i = 1; i < loop.points.size(); ++i)
    twice += (loop.points[i - 1] - loop.origin).cross(loop.points[i] - loop.origin);
  loop.area = 0.5 * twice.norm();
  if (!(loop.area > loop.tolerance * length)) return std::nullopt;
  loop.normal = twice.normalized();
  double low = 0.0, high = 0.0;
  for (const Vec3& p : loop.points) {
    low = std::min(low, loop.height(p));
    high = std::max(high, loop.height(p));
  }
  loop.origin += 0.5 * (low + high) * loop.normal;
  if (loop.off(loop) > loop.tolerance) return std::nullopt;
  loop.inside = face_within(loop, {});
  return loop;
}

enum class Nesting { kApart, kInside, kCrossing };

/// How a loop of the same plane and of less area lies to `outer`: by places along its edges.
Nesting nesting(const PlaneLoop& loop, const PlaneLoop& outer) {
  constexpr int kPieces = 4;
  bool in = false, out = false;
  for (const TopoDS_Edge& edge : loop.edges)
    for (const Vec3& p : points_along(edge, kPieces)) {
      const Vec3 flat = p - outer.height(p) * outer.normal;
      const BRepClass_FaceClassifier classifier(outer.inside, to_pnt(flat), outer.tolerance);
      in = in || classifier.State() == TopAbs_IN;
      out = out || classifier.State() == TopAbs_OUT;
    }
  return in && out ? Nesting::kCrossing : in ? Nesting::kInside : Nesting::kApart;
}

/// The normal of a face turned forward, where the face lies in the plane of the loop.
std::optional<Vec3> normal_in_plane(const TopoDS_Face& face, const PlaneLoop& plane) {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  const GeomLib_IsPlanarSurface flat(surface, plane.tolerance);
  if (!flat.IsPlanar()) return std::nullopt;
  for (const Vec3& p : plane.points)
    if (flat.Plan().Distance(to_pnt(p)) > 2.0 * plane.tolerance) return std::nullopt;
  double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
  BRepTools::UVBounds(face, u0, u1, v0, v1);
  gp_Pnt middle;
  gp_Vec along_u, along_v;
  surface->D1(0.5 * (u0 + u1), 0.5 * (v0 + v1), middle, along_u, along_v);
  return to_vec(along_u.Crossed(along_v));
}

using FacesOfEdges = TopTools_IndexedDataMapOfShapeListOfShape;

/// The way an edge of the face runs where that is turned forward.
TopAbs_Orientation way_on(const TopoDS_Face& face, const TopoDS_Shape& edge) {
  TopExp_Explorer it(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE);
  while (!it.Current().IsSame(edge)) it.Next();
  return it.Current().Orientation();
}

/// Whether a face that has an edge of the cap lies in its plane, and there on its side.
bool lies_on_a_face(const TopoDS_Face& cap, const PlaneLoop& plane, const FacesOfEdges& faces_of) {
  for (TopExp_Explorer it(cap, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Face& face = TopoDS::Face(faces_of.FindFromKey(it.Current()).First());
    const std::optional<Vec3> normal = normal_in_plane(face, plane);
    if (!normal) continue;
    const bool same_way = way_on(face, it.Current()) == it.Current().Orientation();
    if (same_way == (normal->dot(plane.normal) > 0.0)) return true;
  }
  return false;
}

Cap cap_of(const PlaneLoop& outer, const std::vector<const PlaneLoop*>& holes) {
  Cap cap;
  cap.face = face_within(outer, holes);
  cap.edges = outer.edges;
  cap.off = outer.off(outer);
  for (const PlaneLoop* hole : holes) {
    cap.edges.insert(cap.edges.end(), hole->edges.begin(), hole->edges.end());
    cap.off = std::max(cap.off, outer.off(*hole));
  }
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(cap.face, properties);
  cap.area = std::abs(properties.Mass());
  cap.place = to_vec(properties.CentreOfMass());
  return cap;
}

/// For each loop, of a list by falling area, those around it in its plane; nothing where it crosses one.
std::vector<std::optional<std::vector<std::size_t>>> loops_around(const std::vector<PlaneLoop>& loops) {
  std::vector<std::vector<std::size_t>> around(loops.size());
  std::vector<bool> crossing(loops.size(), false);
  for (std::size_t i = 0; i < loops.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (loops[j].off(loops[i]) > std::max(loops[i].tolerance, loops[j].tolerance)) continue;
      const Nesting nested = nesting(loops[i], loops[j]);
      if (nested == Nesting::kInside) around[i].push_back(j);
      if (nested == Nesting::kCrossing) crossing[i] = crossing[j] = true;
    }
  std::vector<std::optional<std::vector<std::size_t>>> result(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    std::erase_if(around[i], [&](std::size_t j) { return crossing[j]; });
    if (!crossing[i]) result[i] = around[i];
  }
  return result;
}

}  // namespace

std::vector<Cap> planar_caps(const TopoDS_Shape& shape, double tolerance) {
  std::vector<PlaneLoop> loops;
  for (const EdgeLoop& edges : edge_loops(free_edges(shape)))
    if (auto loop = plane_loop(edges, tolerance)) loops.push_back(std::move(*loop));
  std::stable_sort(loops.begin(), loops.end(),
                   [](const PlaneLoop& a, const PlaneLoop& b) { return a.area > b.area; });
  const auto around = loops_around(loops);
  FacesOfEdges faces_of;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of);
  std::vector<Cap> caps;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (!around[i] || around[i]->size() % 2 != 0) continue;
    std::vector<const PlaneLoop*> holes;
    for (std::size_t j = i + 1; j < loops.size(); ++j)
      if (around[j] && around[j]->size() == around[i]->size() + 1 && around[j]->back() == i)
        holes.push_back(&loops[j]);
    Cap cap = cap_of(loops[i], holes);
    if (!lies_on_a_face(cap.face, loops[i], faces_of)) caps.push_back(std::move(cap));
  }
  return caps;
}

std::string cap_name(std::size_t number) { return fmt::format("cap {}", number); }

std::string caps_note(const std::vector<Cap>& caps, std::size_t before, const EntityNames& names) {
  std::string list;
  for (std::size_t i = 0; i < caps.size(); ++i) {
    const Cap& cap = caps[i];
    list +=
        fmt::format("{} \"{}\" of {:.6g} mm^2 at ({:.6g}, {:.6g}, {:.6g}), within {:.2g} mm of {}",
                    i > 0 ? ";" : "", cap_name(before + i + 1), cap.area, cap.place.x(), cap.place.y(),
                    cap.place.z(), cap.off, names.listed("Edge", 1, {cap.edges.begin(), cap.edges.end()}));
  }
  return fmt::format("{} opening(s) that lie in planes were closed by a plane face each:{}", caps.size(),
                     list);
}

}  // namespace octet
