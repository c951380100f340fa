// SPDX-License-Identifier: BSD-3-Clause
// Walks from edge to edge, from the vertices first where the way ends or forks.
#include "geom/occt/edge_loops.h"

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <array>

namespace octet {
namespace {

class Walker {
 public:
  explicit Walker(const std::vector<TopoDS_Edge>& edges) : edges_(edges), walked_(edges.size(), false) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
      TopoDS_Vertex first, last;
      TopExp::Vertices(TopoDS::Edge(edges[e].Oriented(TopAbs_FORWARD)), first, last);
      ends_.push_back({index_of(first), index_of(last)});
      walked_[e] = first.IsNull() || last.IsNull();
      for (const std::size_t v : ends_.back())
        if (!walked_[e]) at_[v].push_back(e);
    }
  }

  std::vector<EdgeLoop> loops() {
    for (const bool forks : {true, false})
      for (std::size_t e = 0; e < edges_.size(); ++e)
        for (const std::size_t v : ends_[e])
          if (!walked_[e] && forks == (at_[v].size() != 2)) walk(e, v);
    return loops_;
  }

 private:
  std::size_t index_of(const TopoDS_Vertex& vertex) {
    if (vertex.IsNull()) return 0;
    const auto index = static_cast<std::size_t>(vertices_.Add(vertex));
    if (index >= at_.size()) at_.resize(index + 1);
    return index;
  }

  void walk(std::size_t e, std::size_t from) {
    EdgeLoop loop;
    for (std::size_t v = from;;) {
      walked_[e] = true;
      const bool forward = ends_[e][0] == v;
      loop.push_back(TopoDS::Edge(edges_[e].Oriented(forward ? TopAbs_FORWARD : TopAbs_REVERSED)));
      v = ends_[e][forward ? 1 : 0];
      if (v == from) break;
      if (at_[v].size() != 2) return;
      e = at_[v][at_[v][0] == e ? 1 : 0];
    }
    loops_.push_back(loop);
  }

  const std::vector<TopoDS_Edge>& edges_;
  TopTools_IndexedMapOfShape vertices_;
  std::vector<std::array<std::size_t, 2>> ends_;
  std::vector<std::vector<std::size_t>> at_ = {{}};  ///< edges by vertex; [0]: of no vertex
  std::vector<bool> walked_;
  std::vector<EdgeLoop> loops_;
};

}  // namespace

std::vector<EdgeLoop> edge_loops(const std::vector<TopoDS_Edge>& edges) { return Walker(edges).loops(); }

}  // namespace octet
