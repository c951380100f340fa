// SPDX-License-Identifier: BSD-3-Clause
// Loops are matched edge by edge and vertex by vertex, and one is put in the place of the other.
#include "geom/occt/rings.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "geom/occt/edge_distance.h"

namespace octet {
namespace {

/// Corners of loops may be farther apart than their sides.
constexpr double kCorner = 2.0;

using RingLoop = std::vector<TopoDS_Edge>;

bool share_a_vertex(const TopoDS_Edge& a, const TopoDS_Edge& b) {
  const TopoDS_Vertex first = TopExp::FirstVertex(a), last = TopExp::LastVertex(a);
  const auto is_of_b = [&b](const TopoDS_Vertex& v) {
    return v.IsSame(TopExp::FirstVertex(b)) || v.IsSame(TopExp::LastVertex(b));
  };
  return is_of_b(first) || is_of_b(last);
}

/// The edges of the face by the loops that they make, without seams; none: an edge is degenerate.
std::vector<RingLoop> loops_of(const TopoDS_Face& face) {
  RingLoop edges;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current().Oriented(TopAbs_FORWARD));
    if (BRep_Tool::Degenerated(edge)) return {};
    const auto twin = std::find_if(edges.begin(), edges.end(), [&](const auto& e) { return e.IsSame(edge); });
    if (twin == edges.end()) {
      edges.push_back(edge);
    } else {
      edges.erase(twin);
    }
  }
  std::vector<RingLoop> loops;
  while (!edges.empty()) {
    RingLoop loop{edges.front()};
    edges.erase(edges.begin());
    for (bool found = true; found;) {
      const auto next = std::find_if(edges.begin(), edges.end(),
                                     [&](const auto& e) { return share_a_vertex(e, loop.back()); });
      found = next != edges.end();
      if (!found) break;
      loop.push_back(*next);
      edges.erase(next);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

double distance(const TopoDS_Vertex& a, const TopoDS_Vertex& b) {
  return BRep_Tool::Pnt(a).Distance(BRep_Tool::Pnt(b));
}

/// An edge that goes, and the one in its place.
struct EdgePair {
  TopoDS_Edge gone, kept;
  bool same_way = true;
};

/// Whether two closed edges run the same way round.
bool turn_alike(const TopoDS_Edge& a, const TopoDS_Edge& b) {
  const BRepAdaptor_Curve on_a(a), on_b(b);
  gp_Pnt p;
  gp_Vec along_a, along_b;
  on_a.D1(on_a.FirstParameter(), p, along_a);
  on_b.D1(on_b.FirstParameter(), p, along_b);
  return along_a.Dot(along_b) > 0.0;
}

std::optional<EdgePair> match(const TopoDS_Edge& gone, const TopoDS_Edge& kept, double width) {
  const TopoDS_Vertex g0 = TopExp::FirstVertex(gone), g1 = TopExp::LastVertex(gone),
                      k0 = TopExp::FirstVertex(kept), k1 = TopExp::LastVertex(kept);
  if (g0.IsSame(g1) != k0.IsSame(k1)) return std::nullopt;
  EdgePair pair{gone, kept, true};
  if (g0.IsSame(g1)) {
    if (distance(g0, k0) > kCorner * width) return std::nullopt;
    pair.same_way = turn_alike(gone, kept);
  } else {
    const double straight = std::max(distance(g0, k0), distance(g1, k1));
    const double crossed = std::max(distance(g0, k1), distance(g1, k0));
    if (std::min(straight, crossed) > kCorner * width) return std::nullopt;
    pair.same_way = straight <= crossed;
  }
  if (std::max(edge_distance(gone, kept, width), edge_distance(kept, gone, width)) > width)
    return std::nullopt;
  return pair;
}

/// Each edge of one loop beside one of the other; empty: not so.
std::vector<EdgePair> match_loops(const RingLoop& gone, RingLoop kept, double width) {
  std::vector<EdgePair> pairs;
  if (gone.size() != kept.size()) return {};
  for (const TopoDS_Edge& edge : gone) {
    std::optional<EdgePair> found;
    for (std::size_t i = 0; i < kept.size() && !found; ++i) {
      found = match(edge, kept[i], width);
      if (found) kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
    }
    if (!found) return {};
    pairs.push_back(*found);
  }
  return pairs;
}

class Merger {
 public:
  Merger(const TopoDS_Shape& solid, double width) : solid_(solid), width_(width) {
    TopExp::MapShapesAndAncestors(solid, TopAbs_EDGE, TopAbs_FACE, faces_of_);
  }

  Repair run() {
    Repair result = no_repair(solid_);
    for (TopExp_Explorer it(solid_, TopAbs_FACE); it.More(); it.Next())
      if (take(TopoDS::Face(it.Current()))) result.entities.push_back(it.Current());
    if (result.entities.empty()) return result;
    result.solid = changes_->Apply(solid_);
    result.history = changes_->History();
    return result;
  }

 private:
  bool take(const TopoDS_Face& face) {
    const std::vector<RingLoop> loops = loops_of(face);
    if (loops.size() != 2) return false;
    const std::vector<EdgePair> pairs = match_loops(loops[1], loops[0], width_);
    if (pairs.empty() ||
        !std::all_of(pairs.begin(), pairs.end(), [&](const EdgePair& p) { return is_free(p); }))
      return false;
    for (const EdgePair& pair : pairs) join(pair);
    changes_->Remove(face);
    return true;
  }

  [[nodiscard]] bool is_free(const EdgePair& pair) const {
    for (const TopoDS_Edge& edge : {pair.gone, pair.kept}) {
      if (faces_of_.FindFromKey(edge).Extent() != 2 || touched_.Contains(TopExp::FirstVertex(edge)) ||
          touched_.Contains(TopExp::LastVertex(edge)))
        return false;
    }
    return true;
  }

  void join(const EdgePair& pair) {
    const TopoDS_Edge &gone = pair.gone, &kept = pair.kept;
    BRep_Builder().UpdateEdge(kept, edge_distance(gone, kept, std::numeric_limits<double>::infinity()));
    changes_->Replace(gone, kept.Oriented(pair.same_way ? TopAbs_FORWARD : TopAbs_REVERSED));
    put(TopExp::FirstVertex(gone), pair.same_way ? TopExp::FirstVertex(kept) : TopExp::LastVertex(kept));
    put(TopExp::LastVertex(gone), pair.same_way ? TopExp::LastVertex(kept) : TopExp::FirstVertex(kept));
  }

  /// In the place of a vertex that goes.
  void put(const TopoDS_Vertex& gone, const TopoDS_Vertex& kept) {
    touched_.Add(kept);
    if (!touched_.Add(gone)) return;
    BRep_Builder().UpdateVertex(kept, distance(gone, kept) + BRep_Tool::Tolerance(gone));
    changes_->Replace(gone.Oriented(TopAbs_FORWARD), kept.Oriented(TopAbs_FORWARD));
  }

  const TopoDS_Shape& solid_;
  double width_;
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_;
  Handle(ShapeBuild_ReShape) changes_ = new ShapeBuild_ReShape;
  TopTools_MapOfShape touched_;  ///< vertices
};

}  // namespace

Repair merge_rings(const TopoDS_Shape& solid, double width) { return Merger(solid, width).run(); }

}  // namespace octet
