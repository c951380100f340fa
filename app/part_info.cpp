// SPDX-License-Identifier: BSD-3-Clause
// Plain sums and extremes over the model's entities.
#include "app/part_info.h"

#include <algorithm>
#include <map>
#include <set>

#include "app/own_frame.h"
#include "app/scaled_sizes.h"

namespace octet {
namespace {

/// How often the boundaries of faces run along each edge.
std::vector<int> edge_uses(const Model& model) {
  std::vector<int> uses(static_cast<std::size_t>(model.count(1)) + 1, 0);
  for (int f = 1; f <= model.count(2); ++f)
    for (const FaceBoundary& side : model.face(f).boundary) ++uses[static_cast<std::size_t>(side.edge)];
  return uses;
}

/// Whether more than two faces of one region, or towards the outside, meet in the edge. That several regions
/// meet there is no fault.
bool branches(const Model& model, const ModelEdge& edge) {
  std::map<int, int> faces;
  for (const int f : edge.faces)
    for (const int region : model.face(f).region)
      if (++faces[region] > 2) return true;
  return false;
}

void add_edges(const Model& model, PartInfo& info) {
  const std::vector<int> uses = edge_uses(model);
  for (int e = 1; e <= model.count(1); ++e) {
    const ModelEdge& edge = model.edge(e);
    info.seams += edge.use == EdgeUse::kSeam ? 1 : 0;
    info.degenerate += edge.use == EdgeUse::kDegenerate ? 1 : 0;
    if (edge.use != EdgeUse::kReal) continue;
    if (info.smallest_edge == 0 || edge.length < model.edge(info.smallest_edge).length)
      info.smallest_edge = e;
    if (uses[static_cast<std::size_t>(e)] < 2) info.free_edges.push_back(e);
    if (branches(model, edge)) info.nonmanifold.push_back(e);
    if (edge.tolerance > model.tolerance_of(info.widest_gap)) info.widest_gap = model_edge(e);
  }
  for (int v = 1; v <= model.count(0); ++v)
    if (model.vertex(v).tolerance > model.tolerance_of(info.widest_gap)) info.widest_gap = model_vertex(v);
}

void add_faces(const Model& model, PartInfo& info) {
  for (int f = 1; f <= model.count(2); ++f) {
    const ModelFace& face = model.face(f);
    if (info.smallest_face == 0 || face.area < model.face(info.smallest_face).area) info.smallest_face = f;
    if (face.region[0] == face.region[1])
      info.dangling_faces.push_back(f);
    else
      info.area += face.area;
  }
}

/// Sets of faces that hang together by edges at one vertex.
class Fans {
 public:
  void join(int a, int b) {
    const int root = lead(a);
    lead_[lead(b)] = root;
  }
  [[nodiscard]] std::size_t count() {
    std::set<int> leads;
    for (const auto& [face, unused] : std::map<int, int>(lead_)) leads.insert(lead(face));
    return leads.size();
  }

 private:
  int lead(int face) {
    lead_.try_emplace(face, face);
    while (lead_[face] != face) face = lead_[face];
    return face;
  }
  std::map<int, int> lead_;
};

std::vector<int> pinched_vertices(const Model& model) {
  std::vector<int> pinched;
  for (int v = 1; v <= model.count(0); ++v) {
    Fans fans;
    for (const int e : model.vertex(v).edges) {
      int last = 0;
      for (const int f : model.edge(e).faces) {
        const auto& region = model.face(f).region;
        if (region[0] == region[1] || (region[0] != 0 && region[1] != 0)) continue;
        fans.join(last == 0 ? f : last, f);
        last = f;
      }
    }
    if (fans.count() > 1) pinched.push_back(v);
  }
  return pinched;
}

std::vector<Interface> interfaces_of(const Model& model) {
  std::map<std::array<int, 2>, Interface> by_regions;
  for (int f = 1; f <= model.count(2); ++f) {
    const ModelFace& face = model.face(f);
    if (face.region[0] == 0 || face.region[1] == 0 || face.region[0] == face.region[1]) continue;
    const auto [low, high] = std::minmax(face.region[0], face.region[1]);
    Interface& shared = by_regions[{low, high}];
    shared.regions = {low, high};
    shared.faces.push_back(f);
    shared.area += face.area;
  }
  std::vector<Interface> interfaces;
  for (auto& [regions, shared] : by_regions) interfaces.push_back(std::move(shared));
  return interfaces;
}

std::vector<NumberChange> changed_numbers(const Provenance& provenance) {
  std::vector<NumberChange> changes;
  for (int dim = 0; dim < 4; ++dim) {
    const auto& entities = provenance.as_read[static_cast<std::size_t>(dim)];
    for (int number = 1; number < static_cast<int>(entities.size()); ++number) {
      const std::vector<int>& tags = entities[static_cast<std::size_t>(number)].tags;
      if (!tags.empty() && tags != std::vector<int>{number}) changes.push_back({{dim, number}, tags});
    }
  }
  return changes;
}

}  // namespace

PartInfo part_info(const Model& model) {
  PartInfo info;
  for (const Vec3& node : model.facets().nodes) info.box.add(node);
  add_edges(model, info);
  add_faces(model, info);
  for (int r = 1; r <= model.count(3); ++r) info.volume += model.region(r).volume;
  info.pinched = pinched_vertices(model);
  info.interfaces = interfaces_of(model);
  info.overlaps = overlaps(model.provenance(), model.count(3));
  info.changes = changed_numbers(model.provenance());
  info.tiny = tiny_features(model);
  info.thinnest = thinnest_wall(model);
  info.default_size = with_default_size(OwnFrame(model, {}).model(), {}).size;
  return info;
}

}  // namespace octet
