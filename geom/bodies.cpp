// SPDX-License-Identifier: BSD-3-Clause
// Regions are joined over their vertices; then each body's entities are copied in the order of their tags.
#include "geom/bodies.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace octet {
namespace {

/// The lowest region of each region's body, by tag.
std::vector<int> lead_regions(const Model& model) {
  std::vector<int> lead(static_cast<std::size_t>(model.count(3)) + 1);
  std::iota(lead.begin(), lead.end(), 0);
  const auto root = [&](int r) {
    while (lead[static_cast<std::size_t>(r)] != r) r = lead[static_cast<std::size_t>(r)];
    return r;
  };
  std::vector<int> region_of_vertex(static_cast<std::size_t>(model.count(0)) + 1, 0);
  for (int r = 1; r <= model.count(3); ++r)
    for (const int f : model.region(r).faces) {
      for (const int v : model.face(f).vertices) {
        int& first = region_of_vertex[static_cast<std::size_t>(v)];
        if (first == 0) first = r;
        const int a = root(first), b = root(r);
        lead[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
      }
    }
  for (std::size_t r = 1; r < lead.size(); ++r) lead[r] = root(lead[r]);
  return lead;
}

/// Copies what belongs to some regions.
class Extract {
 public:
  Extract(const Model& model, const std::vector<int>& regions) {
    for (std::size_t dim = 0; dim < 4; ++dim) {
      own_[dim].assign(static_cast<std::size_t>(model.count(static_cast<int>(dim))) + 1, 0);
      whole_[dim] = {0};
    }
    for (const int r : regions) own_[3][static_cast<std::size_t>(r)] = 1;
    for (const int r : regions)
      for (const int f : model.region(r).faces) {
        own_[2][static_cast<std::size_t>(f)] = 1;
        for (const FaceBoundary& side : model.face(f).boundary)
          own_[1][static_cast<std::size_t>(side.edge)] = 1;
        for (const int v : model.face(f).vertices) own_[0][static_cast<std::size_t>(v)] = 1;
      }
    for (std::size_t dim = 0; dim < 4; ++dim)
      for (std::size_t tag = 1; tag < own_[dim].size(); ++tag)
        if (own_[dim][tag] != 0) {
          own_[dim][tag] = static_cast<int>(whole_[dim].size());
          whole_[dim].push_back(static_cast<int>(tag));
        }
  }

  [[nodiscard]] Model body(const ModelParts& whole) const {
    ModelParts parts;
    parts.unit = whole.unit;
    parts.taken_away = whole.taken_away;
    copy_vertices(whole, parts);
    copy_edges(whole, parts);
    copy_faces(whole, parts);
    copy_regions(whole, parts);
    copy_facets(whole.facets, parts.facets);
    parts.whole_tag = whole_;
    return Model(std::move(parts));
  }

 private:
  [[nodiscard]] int own(std::size_t dim, int tag) const { return own_[dim][static_cast<std::size_t>(tag)]; }

  void rename(std::size_t dim, std::vector<int>& tags) const {
    for (int& tag : tags) tag = own(dim, tag);
    std::erase(tags, 0);
  }

  void copy_vertices(const ModelParts& whole, ModelParts& parts) const {
    parts.vertices.resize(whole_[0].size());
    for (std::size_t i = 1; i < whole_[0].size(); ++i) {
      parts.vertices[i] = whole.vertices[static_cast<std::size_t>(whole_[0][i])];
      rename(1, parts.vertices[i].edges);
    }
  }

  void copy_edges(const ModelParts& whole, ModelParts& parts) const {
    parts.edges.resize(whole_[1].size());
    parts.curves.resize(whole_[1].size());
    for (std::size_t i = 1; i < whole_[1].size(); ++i) {
      const auto tag = static_cast<std::size_t>(whole_[1][i]);
      parts.edges[i] = whole.edges[tag];
      parts.curves[i] = whole.curves[tag];
      for (int& v : parts.edges[i].vertex) v = own(0, v);
      rename(2, parts.edges[i].faces);
    }
  }

  void copy_faces(const ModelParts& whole, ModelParts& parts) const {
    parts.faces.resize(whole_[2].size());
    parts.surfaces.resize(whole_[2].size());
    parts.trims.resize(whole_[2].size());
    for (std::size_t i = 1; i < whole_[2].size(); ++i) {
      const auto tag = static_cast<std::size_t>(whole_[2][i]);
      parts.faces[i] = whole.faces[tag];
      parts.surfaces[i] = whole.surfaces[tag];
      parts.trims[i] = whole.trims[tag];
      for (FaceBoundary& side : parts.faces[i].boundary) side.edge = own(1, side.edge);
      for (int& region : parts.faces[i].region) region = own(3, region);
      rename(0, parts.faces[i].vertices);
    }
  }

  void copy_regions(const ModelParts& whole, ModelParts& parts) const {
    parts.regions.resize(whole_[3].size());
    for (std::size_t i = 1; i < whole_[3].size(); ++i) {
      parts.regions[i] = whole.regions[static_cast<std::size_t>(whole_[3][i])];
      rename(2, parts.regions[i].faces);
    }
  }

  void copy_facets(const Facets& whole, Facets& facets) const {
    constexpr auto kNone = static_cast<std::uint32_t>(-1);
    std::vector<std::uint32_t> node(whole.nodes.size(), kNone);
    for (std::size_t i = 0; i < whole.triangles.size(); ++i) {
      const int face = own(2, whole.face[i]);
      if (face == 0) continue;
      std::array<std::uint32_t, 3> corners = whole.triangles[i];
      for (std::uint32_t& corner : corners) {
        if (node[corner] == kNone) {
          node[corner] = static_cast<std::uint32_t>(facets.nodes.size());
          facets.nodes.push_back(whole.nodes[corner]);
        }
        corner = node[corner];
      }
      facets.triangles.push_back(corners);
      facets.face.push_back(face);
      facets.uv.push_back(whole.uv[i]);
    }
    for (const int f : whole_[2]) facets.deviation.push_back(whole.deviation[static_cast<std::size_t>(f)]);
    for (const int e : whole_[1])
      facets.edge_deviation.push_back(whole.edge_deviation[static_cast<std::size_t>(e)]);
  }

  std::array<std::vector<int>, 4> own_;    ///< by dimension and tag of the whole; 0: not in the body
  std::array<std::vector<int>, 4> whole_;  ///< by dimension and tag of the body
};

}  // namespace

std::vector<Model> take_apart(const Model& model) {
  const std::vector<int> lead = lead_regions(model);
  std::vector<Model> bodies;
  for (int first = 1; first <= model.count(3); ++first) {
    if (lead[static_cast<std::size_t>(first)] != first) continue;
    std::vector<int> regions;
    for (int r = first; r <= model.count(3); ++r)
      if (lead[static_cast<std::size_t>(r)] == first) regions.push_back(r);
    bodies.push_back(Extract(model, regions).body(model.parts()));
  }
  return bodies;
}

}  // namespace octet
