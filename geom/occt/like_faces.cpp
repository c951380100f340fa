// SPDX-License-Identifier: BSD-3-Clause
// Like vertices, then like edges, then like surfaces.
#include "geom/occt/like_faces.h"

#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <optional>
#include <utility>

#include "geom/occt/same_place.h"
#include "geom/occt/shape_box.h"
#include "geom/occt/sub_shapes.h"
#include "geom/tiny_features.h"

namespace octet {
namespace {

/// A face of a solid by what is cheap to compare.
struct Candidate {
  TopoDS_Face face;
  std::size_t solid = 0;
  Bnd_Box box;  ///< of its vertices
  TopTools_IndexedMapOfShape vertices, edges;

  Candidate(const TopoDS_Face& of, std::size_t in)
      : face(of), solid(in), vertices(sub_shapes(of, TopAbs_VERTEX)), edges(sub_shapes(of, TopAbs_EDGE)) {
    for (int i = 1; i <= vertices.Extent(); ++i) box.Add(BRep_Tool::Pnt(TopoDS::Vertex(vertices(i))));
  }
  [[nodiscard]] double low() const { return box.CornerMin().X(); }
};

bool boxes_agree(const Candidate& a, const Candidate& b, double near) {
  return a.vertices.Extent() == b.vertices.Extent() && a.edges.Extent() == b.edges.Extent() &&
         a.box.CornerMin().Distance(b.box.CornerMin()) <= 2.0 * near &&
         a.box.CornerMax().Distance(b.box.CornerMax()) <= 2.0 * near;
}

/// How far apart two entities may be: what either's tolerance says, but no more than `most`.
template <class Shape>
double nearness(const Shape& a, const Shape& b, double most) {
  return std::min(BRep_Tool::Tolerance(a) + BRep_Tool::Tolerance(b), most);
}

/// Which way the edge runs of two that are one another, their vertices too; none where they are not.
std::optional<bool> like_edges(const TopoDS_Edge& a, const TopoDS_Edge& b, double most) {
  const auto meet = [&](const TopoDS_Vertex& v, const TopoDS_Vertex& w) {
    return v.IsNull() == w.IsNull() &&
           (v.IsNull() || BRep_Tool::Pnt(v).Distance(BRep_Tool::Pnt(w)) <= nearness(v, w, most));
  };
  const TopoDS_Edge one = TopoDS::Edge(a.Oriented(TopAbs_FORWARD)),
                    two = TopoDS::Edge(b.Oriented(TopAbs_FORWARD));
  const TopoDS_Vertex a0 = TopExp::FirstVertex(one), a1 = TopExp::LastVertex(one),
                      b0 = TopExp::FirstVertex(two), b1 = TopExp::LastVertex(two);
  if (!(meet(a0, b0) && meet(a1, b1)) && !(meet(a0, b1) && meet(a1, b0))) return std::nullopt;
  const std::optional<bool> along = same_way(one, two, nearness(one, two, most));
  if (!along || !meet(a0, *along ? b0 : b1) || !meet(a1, *along ? b1 : b0)) return std::nullopt;
  return along;
}

/// The edges of the faces, each with the one that it is; none where one is like none.
std::optional<std::vector<LikeEdges>> all_like_edges(const Candidate& a, const Candidate& b, double most) {
  std::vector<LikeEdges> pairs;
  TopTools_MapOfShape taken;
  for (int i = 1; i <= a.edges.Extent(); ++i) {
    const TopoDS_Edge& kept = TopoDS::Edge(a.edges(i));
    if (BRep_Tool::Degenerated(kept)) continue;
    bool found = false;
    for (int j = 1; j <= b.edges.Extent() && !found; ++j) {
      const TopoDS_Edge& other = TopoDS::Edge(b.edges(j));
      if (BRep_Tool::Degenerated(other) || taken.Contains(other)) continue;
      const std::optional<bool> along =
          kept.IsSame(other) ? std::optional<bool>(true) : like_edges(kept, other, most);
      if (!along) continue;
      found = true;
      taken.Add(other);
      pairs.push_back({kept, other, *along});
    }
    if (!found) return std::nullopt;
  }
  return pairs;
}

}  // namespace

std::vector<LikeFaces> like_faces(const std::vector<TopoDS_Shape>& solids, const std::set<std::size_t>& out) {
  std::vector<Candidate> faces;
  std::vector<double> rounding;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    rounding.push_back(kRoundingShare * diagonal_of(box_of(solids[i])));
    if (out.count(i) != 0) continue;
    for (TopExp_Explorer it(solids[i], TopAbs_FACE); it.More(); it.Next()) {
      Candidate face(TopoDS::Face(it.Current()), i);
      if (!face.box.IsVoid()) faces.push_back(std::move(face));
    }
  }
  std::stable_sort(faces.begin(), faces.end(),
                   [](const Candidate& a, const Candidate& b) { return a.low() < b.low(); });
  std::vector<LikeFaces> found;
  for (auto a = faces.begin(); a != faces.end(); ++a)
    for (auto b = a + 1; b != faces.end(); ++b) {
      const double most = std::min(rounding[a->solid], rounding[b->solid]);
      if (b->low() - a->low() > 2.0 * rounding[a->solid]) break;
      if (a->solid == b->solid || a->face.IsSame(b->face) || !boxes_agree(*a, *b, most)) continue;
      const Candidate &kept = a->solid < b->solid ? *a : *b, &other = a->solid < b->solid ? *b : *a;
      const auto edges = all_like_edges(kept, other, most);
      if (!edges) continue;
      const auto side = same_side(kept.face, other.face, most);
      if (side) found.push_back({kept.face, other.face, kept.solid, other.solid, *side, *edges});
    }
  std::stable_sort(found.begin(), found.end(), [](const LikeFaces& a, const LikeFaces& b) {
    return std::make_pair(a.solid, a.kept_solid) < std::make_pair(b.solid, b.kept_solid);
  });
  std::vector<LikeFaces> first;
  TopTools_MapOfShape seen;
  for (LikeFaces& pair : found)
    if (seen.Add(pair.other)) first.push_back(std::move(pair));
  return first;
}

}  // namespace octet
