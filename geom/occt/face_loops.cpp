// SPDX-License-Identifier: BSD-3-Clause
// The loops of a B-rep face as polygons in (u,v), through given points of its edges.
#include "geom/occt/face_loops.h"

#include <fmt/format.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace octet {
namespace {

/// An edge as a wire runs along it.
struct HalfEdge {
  int edge = 0;
  bool forward = true;
  int from = 0, to = 0;  ///< vertex tags
  std::vector<Vec2> uv;  ///< in the direction of the wire
  bool used = false;
};

class LoopMaker {
 public:
  LoopMaker(const Numbering& numbering, int face, const EdgeChains& chains, const ModelParts& parts)
      : numbering_(numbering),
        face_tag_(face),
        face_(TopoDS::Face(numbering.face(face).Oriented(TopAbs_FORWARD))),
        chains_(chains),
        parts_(parts) {
    const BRepAdaptor_Surface surface(face_, false);
    if (surface.IsUPeriodic()) period_.x() = surface.UPeriod();
    if (surface.IsVPeriodic()) period_.y() = surface.VPeriod();
  }

  FacePolygons run() {
    for (TopExp_Explorer wire(face_, TopAbs_WIRE); wire.More(); wire.Next()) add_wire(wire.Current());
    return std::move(result_);
  }

 private:
  void add_wire(const TopoDS_Shape& wire) {
    std::vector<HalfEdge> half_edges;
    for (TopoDS_Iterator it(wire); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Value());
      if (edge.Orientation() == TopAbs_FORWARD || edge.Orientation() == TopAbs_REVERSED) {
        half_edges.push_back(half_edge(edge));
      } else {
        // Inside the face: a slit with two sides.
        half_edges.push_back(half_edge(TopoDS::Edge(edge.Oriented(TopAbs_FORWARD))));
        half_edges.push_back(half_edge(TopoDS::Edge(edge.Oriented(TopAbs_REVERSED))));
      }
    }
    for (HalfEdge& first : half_edges)
      if (!first.used) add_loop(first, half_edges);
  }

  HalfEdge half_edge(const TopoDS_Edge& edge) const {
    HalfEdge half;
    half.edge = numbering_.tag(1, edge);
    half.forward = edge.Orientation() == TopAbs_FORWARD;
    const auto& vertex = parts_.edges[half.edge].vertex;
    half.from = vertex[half.forward ? 0 : 1];
    half.to = vertex[half.forward ? 1 : 0];
    double a = 0.0, b = 0.0;
    const auto pcurve = BRep_Tool::CurveOnSurface(edge, face_, a, b);
    if (pcurve.IsNull())
      throw ModelError(fmt::format("Edge {} has no curve on Face {}", half.edge, face_tag_),
                       model_edge(half.edge));
    const std::vector<double>& chain = chains_[half.edge];
    for (const double t : chain) {
      const gp_Pnt2d p = pcurve->Value(a + (t - chain.front()) / (chain.back() - chain.front()) * (b - a));
      half.uv.emplace_back(p.X(), p.Y());
    }
    if (!half.forward) std::reverse(half.uv.begin(), half.uv.end());
    return half;
  }

  void add_loop(HalfEdge& first, std::vector<HalfEdge>& half_edges) {
    std::vector<std::uint32_t> loop;
    const std::size_t first_half = result_.half_edges.size();
    append(first, loop);
    const Vec2 start = first.uv.front();
    int at_vertex = first.to;
    Vec2 at = first.uv.back();
    for (;;) {
      HalfEdge* next = nearest(half_edges, at_vertex, at);
      if (at_vertex == first.from &&
          (next == nullptr || (start - at).norm() <= (next->uv.front() - at).norm()))
        break;
      if (next == nullptr) throw_open(at_vertex);
      shift_to(*next, at);
      append(*next, loop);
      at_vertex = next->to;
      at = next->uv.back();
    }
    close(first_half, loop.front());
    if (loop.size() > 1) result_.loops.loops.push_back(std::move(loop));
  }

  /// Each half edge ends where the next begins; then points run as the curve does.
  void close(std::size_t first_half, std::uint32_t start) {
    auto& halves = result_.half_edges;
    for (std::size_t i = first_half; i < halves.size(); ++i)
      halves[i].points.push_back(i + 1 < halves.size() ? halves[i + 1].points.front() : start);
    for (std::size_t i = first_half; i < halves.size(); ++i)
      if (!halves[i].forward) std::reverse(halves[i].points.begin(), halves[i].points.end());
  }

  static HalfEdge* nearest(std::vector<HalfEdge>& half_edges, int vertex, const Vec2& at) {
    HalfEdge* best = nullptr;
    double best_distance = std::numeric_limits<double>::infinity();
    for (HalfEdge& half : half_edges) {
      if (half.used || half.from != vertex) continue;
      const double distance = (half.uv.front() - at).norm();
      if (distance >= best_distance) continue;
      best = &half;
      best_distance = distance;
    }
    return best;
  }

  /// Whole periods, where that is clearly meant.
  void shift_to(HalfEdge& half, const Vec2& at) const {
    Vec2 shift = Vec2::Zero();
    for (int axis = 0; axis < 2; ++axis)
      if (period_[axis] > 0.0)
        shift[axis] = period_[axis] * std::round((at - half.uv.front())[axis] / period_[axis]);
    if (shift.isZero(0.0)) return;
    for (Vec2& p : half.uv) p += shift;
  }

  /// All its points but the last, which is the next half edge's first.
  void append(HalfEdge& half, std::vector<std::uint32_t>& loop) {
    half.used = true;
    HalfEdgePoints points{half.edge, half.forward, {}, chains_[half.edge]};
    for (std::size_t k = 0; k + 1 < half.uv.size(); ++k) {
      points.points.push_back(static_cast<std::uint32_t>(result_.loops.uv.size()));
      result_.loops.uv.push_back(half.uv[k]);
    }
    loop.insert(loop.end(), points.points.begin(), points.points.end());
    result_.half_edges.push_back(std::move(points));
  }

  [[noreturn]] void throw_open(int vertex) const {
    const Vec3& at = parts_.vertices[vertex].point;
    throw ModelError(
        fmt::format("a loop of Face {} does not close: it ends at Vertex {} ({:.6g}, {:.6g}, {:.6g})",
                    face_tag_, vertex, at.x(), at.y(), at.z()),
        model_face(face_tag_));
  }

  const Numbering& numbering_;
  int face_tag_;
  TopoDS_Face face_;
  const EdgeChains& chains_;
  const ModelParts& parts_;
  Vec2 period_ = Vec2::Zero();
  FacePolygons result_;
};

}  // namespace

FacePolygons face_polygons(const Numbering& numbering, int face, const EdgeChains& chains,
                           const ModelParts& parts) {
  return LoopMaker(numbering, face, chains, parts).run();
}

}  // namespace octet
