// SPDX-License-Identifier: BSD-3-Clause
// Lines of v without length are looked for; edges are cut there, then loops.
#include "geom/occt/pinched_faces.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Lin2d.hxx>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geom/occt/edge_cuts.h"
#include "geom/occt/face_parts.h"
#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

struct Pole {
  double v = 0.0;
  gp_Pnt point;
};

/// How fast the surface runs along its line of v, at most.
double speed_along(const BRepAdaptor_Surface& surface, double u0, double u1, double v) {
  constexpr int kPlaces = 5;
  double most = 0.0;
  for (int i = 0; i < kPlaces; ++i) {
    gp_Pnt point;
    gp_Vec du, dv;
    surface.D1(u0 + (u1 - u0) * (i + 0.5) / kPlaces, v, point, du, dv);
    most = std::max(most, du.Magnitude());
  }
  return most;
}

/// The lines of v clear of the face's ends that are points: where the speed along them, which falls linearly
/// there, has a least value of zero.
std::vector<Pole> poles_inside(const TopoDS_Face& face) {
  constexpr int kPieces = 64, kSteps = 80;
  const BRepAdaptor_Surface surface(face, false);
  double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
  BRepTools::UVBounds(face, u0, u1, v0, v1);
  const auto speed = [&](double v) { return speed_along(surface, u0, u1, v); };
  std::vector<Pole> poles;
  std::vector<double> at;
  for (int i = 0; i <= kPieces; ++i) at.push_back(speed(v0 + (v1 - v0) * i / kPieces));
  for (int i = 1; i < kPieces; ++i) {
    if (at[i] > at[i - 1] || at[i] > at[i + 1]) continue;
    double a = v0 + (v1 - v0) * (i - 1) / kPieces, b = v0 + (v1 - v0) * (i + 1) / kPieces;
    for (int step = 0; step < kSteps; ++step) {
      const double p = a + (b - a) / 3.0, q = b - (b - a) / 3.0;
      (speed(p) < speed(q) ? b : a) = speed(p) < speed(q) ? q : p;
    }
    const double v = 0.5 * (a + b);
    if (speed(v) * (u1 - u0) > Precision::Confusion()) continue;
    poles.push_back({v, surface.Value(0.5 * (u0 + u1), v)});
  }
  return poles;
}

/// The vertices at poles: those that the solid has there, else new ones.
class PoleVertices {
 public:
  explicit PoleVertices(const TopoDS_Shape& solid) : vertices_(sub_shapes(solid, TopAbs_VERTEX)) {}

  TopoDS_Vertex at(const gp_Pnt& point) {
    for (int i = 1; i <= vertices_.Extent(); ++i) {
      const TopoDS_Vertex& vertex = TopoDS::Vertex(vertices_(i));
      if (BRep_Tool::Pnt(vertex).Distance(point) <= 10.0 * BRep_Tool::Tolerance(vertex)) return vertex;
    }
    TopoDS_Vertex made;
    BRep_Builder().MakeVertex(made, point, Precision::Confusion());
    vertices_.Add(made);
    return made;
  }

 private:
  TopTools_IndexedMapOfShape vertices_;
};

/// Where the curve crosses the line, clear of its ends.
std::vector<double> crossings(const Geom2d_Curve& curve, double first, double last, double v) {
  constexpr int kPieces = 64, kSteps = 60;
  const auto height = [&](double t) { return curve.Value(t).Y() - v; };
  const double clear = Precision::PConfusion();
  std::vector<double> found;
  for (int i = 0; i < kPieces; ++i) {
    double a = first + (last - first) * i / kPieces, b = first + (last - first) * (i + 1) / kPieces;
    const bool up = height(a) < 0.0;
    if (up == (height(b) < 0.0)) continue;
    for (int step = 0; step < kSteps; ++step) {
      const double middle = 0.5 * (a + b);
      ((height(middle) < 0.0) == up ? a : b) = middle;
    }
    if (b - first > clear && last - b > clear) found.push_back(0.5 * (a + b));
  }
  return found;
}

/// A side of a loop as it runs in (u,v), in one of the bands between the poles.
struct PinchSide {
  TopoDS_Edge edge;
  gp_Pnt2d start, end;
  std::size_t band = 0;
  std::size_t next = 0;  ///< in its loop
};

/// Where a loop goes from one band to the next.
struct PinchCrossing {
  double u = 0.0;
  std::size_t from = 0, to = 0;  ///< sides
  bool up = false;
};

class Parting {
 public:
  Parting(const TopoDS_Face& face, std::vector<Pole> poles, PoleVertices& vertices)
      : face_(TopoDS::Face(face.Oriented(TopAbs_FORWARD))), poles_(std::move(poles)), vertices_(vertices) {}

  /// The parts of the forward face, empty where its loops cannot be parted.
  std::vector<TopoDS_Face> run() {
    for (TopExp_Explorer it(face_, TopAbs_WIRE); it.More(); it.Next())
      if (!add_loop(TopoDS::Wire(it.Current()))) return {};
    crossings_.resize(poles_.size());
    for (std::size_t s = 0; s < sides_.size(); ++s)
      if (!add_crossing(s)) return {};
    for (std::size_t pole = 0; pole < poles_.size(); ++pole)
      if (!bridge(pole)) return {};
    return parts();
  }

 private:
  bool add_loop(const TopoDS_Wire& wire) {
    const std::size_t first = sides_.size();
    std::size_t edges = 0;
    for (TopExp_Explorer it(wire, TopAbs_EDGE); it.More(); it.Next()) ++edges;
    for (BRepTools_WireExplorer it(wire, face_); it.More(); it.Next()) add_side(it.Current());
    for (std::size_t s = first; s < sides_.size(); ++s)
      sides_[s].next = s + 1 < sides_.size() ? s + 1 : first;
    return sides_.size() - first == edges;
  }

  void add_side(const TopoDS_Edge& edge) {
    double t0 = 0.0, t1 = 0.0;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face_, t0, t1);
    PinchSide side{edge, curve->Value(t0), curve->Value(t1), band_of(curve->Value(0.5 * (t0 + t1)).Y()), 0};
    if (edge.Orientation() == TopAbs_REVERSED) std::swap(side.start, side.end);
    sides_.push_back(side);
  }

  [[nodiscard]] std::size_t band_of(double v) const {
    return static_cast<std::size_t>(
        std::count_if(poles_.begin(), poles_.end(), [&](const Pole& pole) { return pole.v < v; }));
  }

  bool add_crossing(std::size_t s) {
    const PinchSide &from = sides_[s], &to = sides_[from.next];
    if (from.band == to.band) return true;
    const bool up = to.band > from.band;
    const std::size_t pole = std::min(from.band, to.band);
    if (std::max(from.band, to.band) != pole + 1) return false;
    crossings_[pole].push_back({from.end.X(), s, from.next, up});
    return true;
  }

  /// Joins the loops on either side of the pole along it: what is between a loop's way down and the next way
  /// up is in the face.
  bool bridge(std::size_t pole) {
    std::vector<PinchCrossing>& row = crossings_[pole];
    std::stable_sort(row.begin(), row.end(),
                     [](const PinchCrossing& a, const PinchCrossing& b) { return a.u < b.u; });
    if (row.size() % 2 != 0) return false;
    for (std::size_t i = 0; i < row.size(); i += 2) {
      const PinchCrossing &down = row[i], &up = row[i + 1];
      if (down.up || !up.up) return false;
      add_bridge(pole, down.from, up.to, down.u, up.u);  // of the part above
      add_bridge(pole, up.from, down.to, up.u, down.u);
    }
    return true;
  }

  void add_bridge(std::size_t pole, std::size_t from, std::size_t to, double u_from, double u_to) {
    const BRep_Builder builder;
    const double low = std::min(u_from, u_to), high = std::max(u_from, u_to), v = poles_[pole].v;
    TopoDS_Edge edge;
    builder.MakeEdge(edge);
    builder.UpdateEdge(edge, new Geom2d_Line(gp_Lin2d(gp_Pnt2d(0.0, v), gp_Dir2d(1.0, 0.0))), face_,
                       Precision::Confusion());
    builder.Range(edge, low, high);
    builder.Degenerated(edge, true);
    const TopoDS_Vertex vertex = vertices_.at(poles_[pole].point);
    builder.Add(edge, vertex.Oriented(TopAbs_FORWARD));
    builder.Add(edge, vertex.Oriented(TopAbs_REVERSED));
    edge.Orientation(u_from < u_to ? TopAbs_FORWARD : TopAbs_REVERSED);
    sides_[from].next = sides_.size();
    sides_.push_back({edge, gp_Pnt2d(u_from, v), gp_Pnt2d(u_to, v), sides_[from].band, to});
  }

  struct Loop {
    TopoDS_Wire wire;
    std::size_t band = 0;
    double area = 0.0;  ///< in (u,v), negative for a hole
  };

  std::vector<Loop> loops() const {
    const BRep_Builder builder;
    std::vector<Loop> found;
    std::vector<bool> used(sides_.size(), false);
    for (std::size_t s = 0; s < sides_.size(); ++s) {
      if (used[s]) continue;
      Loop loop;
      loop.band = sides_[s].band;
      builder.MakeWire(loop.wire);
      for (std::size_t i = s; !used[i]; i = sides_[i].next) {
        used[i] = true;
        builder.Add(loop.wire, sides_[i].edge);
        loop.area += area_along(sides_[i].edge, face_);
      }
      loop.wire.Closed(true);
      found.push_back(loop);
    }
    return found;
  }

  /// A face for each loop around; a hole belongs to the only one of its band.
  std::vector<TopoDS_Face> parts() const {
    const BRep_Builder builder;
    const std::vector<Loop> all = loops();
    std::vector<TopoDS_Face> faces;
    for (std::size_t band = 0; band <= poles_.size(); ++band) {
      const auto outer = std::count_if(all.begin(), all.end(),
                                       [&](const Loop& l) { return l.band == band && l.area > 0.0; });
      TopoDS_Face face;
      for (const Loop& loop : all) {
        if (loop.band != band || loop.area <= 0.0) continue;
        face = TopoDS::Face(face_.EmptyCopied());
        builder.NaturalRestriction(face, false);
        builder.Add(face, loop.wire);
        faces.push_back(face);
      }
      for (const Loop& loop : all) {
        if (loop.band != band || loop.area > 0.0) continue;
        if (outer != 1) return {};
        builder.Add(face, loop.wire);
      }
    }
    return faces;
  }

  TopoDS_Face face_;
  std::vector<Pole> poles_;
  PoleVertices& vertices_;
  std::vector<PinchSide> sides_;
  std::vector<std::vector<PinchCrossing>> crossings_;  ///< by pole
};

struct Pinched {
  TopoDS_Face face;
  std::vector<Pole> poles;
};

std::vector<Pinched> pinched_faces(const TopoDS_Shape& solid) {
  std::vector<Pinched> found;
  const TopTools_IndexedMapOfShape faces = sub_shapes(solid, TopAbs_FACE);
  for (int i = 1; i <= faces.Extent(); ++i) {
    const TopoDS_Face face = TopoDS::Face(faces(i).Oriented(TopAbs_FORWARD));
    std::vector<Pole> poles = poles_inside(face);
    if (!poles.empty()) found.push_back({face, std::move(poles)});
  }
  return found;
}

Repair cut_edges(const TopoDS_Shape& solid, const std::vector<Pinched>& pinched, PoleVertices& vertices) {
  const TopTools_IndexedMapOfShape edges = sub_shapes(solid, TopAbs_EDGE);
  EdgeCuts cuts;
  for (const auto& [face, poles] : pinched)
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
      double first = 0.0, last = 0.0;
      const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
      if (curve.IsNull() || BRep_Tool::Degenerated(edge)) continue;
      for (const Pole& pole : poles)
        for (const double t : crossings(*curve, first, last, pole.v))
          cuts.add(edges.FindIndex(edge), {t, Precision::Confusion(), vertices.at(pole.point)});
    }
  return cuts.apply(solid, edges);
}

}  // namespace

Repair split_pinched_faces(const TopoDS_Shape& solid) {
  const std::vector<Pinched> pinched = pinched_faces(solid);
  if (pinched.empty()) return no_repair(solid);
  PoleVertices vertices(solid);
  FaceParts parts(solid, cut_edges(solid, pinched, vertices));
  for (const Pinched& it : pinched)
    parts.part(it.face, [&](const TopoDS_Face& face) { return Parting(face, it.poles, vertices).run(); });
  return parts.apply();
}

}  // namespace octet
