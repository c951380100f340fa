// SPDX-License-Identifier: BSD-3-Clause
// A mesh cut into blocks that can be worked on side by side, and put together again.
#include "finalize/mesh_blocks.h"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <atomic>
#include <span>

#include "base/blocks.h"
#include "base/sort_unique.h"
#include "mesh/sort_triple.h"
#include "mesh/tet_mesh.h"

namespace octet {
namespace {

using Index = Mesh::Index;

struct Placed {
  std::array<float, 3> centre;
  Index tet;
};

/// Bisection at planes across the longest extent; leaves the items in the order of the blocks.
void bisect(std::span<Placed> items, std::size_t most, std::size_t first_block,
            std::vector<std::uint32_t>& block_of_tet) {
  const std::size_t blocks = (items.size() + most - 1) / most;
  if (blocks <= 1) {
    for (const Placed& item : items) block_of_tet[item.tet] = static_cast<std::uint32_t>(first_block);
    return;
  }
  std::array<float, 3> lo = items[0].centre, hi = lo;
  for (const Placed& item : items) {
    for (std::size_t k = 0; k < 3; ++k) {
      lo[k] = std::min(lo[k], item.centre[k]);
      hi[k] = std::max(hi[k], item.centre[k]);
    }
  }
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (hi[k] - lo[k] > hi[axis] - lo[axis]) axis = k;
  const std::size_t left_blocks = blocks / 2, left = items.size() * left_blocks / blocks;
  std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(left), items.end(),
                   [axis](const Placed& a, const Placed& b) {
                     return a.centre[axis] != b.centre[axis] ? a.centre[axis] < b.centre[axis]
                                                             : a.tet < b.tet;
                   });
  const std::size_t middle = first_block + left_blocks;
  tbb::parallel_invoke([&] { bisect(items.first(left), most, first_block, block_of_tet); },
                       [&] { bisect(items.subspan(left), most, middle, block_of_tet); });
}

std::vector<Placed> placed(const Mesh& mesh, const std::vector<Index>& tets) {
  std::vector<Placed> items(tets.size());
  tbb::parallel_for(std::size_t{0}, tets.size(), [&](std::size_t i) {
    const auto& v = mesh.tets[tets[i]];
    const Vec3 sum = mesh.points[v[0]] + mesh.points[v[1]] + mesh.points[v[2]] + mesh.points[v[3]];
    items[i] = {{static_cast<float>(sum.x()), static_cast<float>(sum.y()), static_cast<float>(sum.z())},
                tets[i]};
  });
  return items;
}

/// The entry of a list sorted by key; the list's size where there is none.
template <class Key>
std::size_t find_key(const std::vector<std::pair<Key, Index>>& list, const Key& key) {
  const auto it = std::lower_bound(list.begin(), list.end(), key,
                                   [](const auto& entry, const Key& k) { return entry.first < k; });
  return it != list.end() && it->first == key ? static_cast<std::size_t>(it - list.begin()) : list.size();
}

template <std::size_t N>
std::array<Index, N> renumbered(const std::array<Index, N>& element, const std::vector<Index>& number) {
  std::array<Index, N> result;
  for (std::size_t k = 0; k < N; ++k) result[k] = number[element[k]];
  return result;
}

std::array<Index, 2> sorted(std::array<Index, 2> v) {
  if (v[1] < v[0]) std::swap(v[0], v[1]);
  return v;
}
std::array<Index, 3> sorted(std::array<Index, 3> v) {
  static_cast<void>(sort_triple(v));
  return v;
}

}  // namespace

MeshBlocks::MeshBlocks(const Mesh& mesh, std::size_t fixed, const std::vector<Index>& held,
                       const std::vector<Index>& tets, std::size_t most)
    : mesh_(mesh), fixed_(fixed), block_of_tet_(mesh.tets.size(), kBeyond) {
  if (!held.empty()) held_.resize(mesh.points.size(), 0);
  for (const Index v : held) held_[v] = 1;
  const std::size_t blocks = std::max<std::size_t>(1, (tets.size() + most - 1) / most);
  std::vector<Placed> items = placed(mesh, tets);
  bisect(items, most, 0, block_of_tet_);
  tets_.resize(blocks);
  for (const Index t : tets) tets_[block_of_tet_[t]].push_back(t);
  find_shared();
  assign_triangles_and_edges();
}

void MeshBlocks::find_shared() {
  block_of_.assign(mesh_.points.size(), kNone);
  tbb::parallel_for(std::size_t{0}, mesh_.tets.size(), [&](std::size_t t) {
    const std::uint32_t own = block_of_tet_[t];
    if (own == kBeyond) return;
    for (const Index v : mesh_.tets[t]) {
      const std::atomic_ref block(block_of_[v]);
      std::uint32_t known = block.load(std::memory_order_relaxed);
      while (known != own && known != kShared &&
             !block.compare_exchange_weak(known, known == kNone ? own : kShared, std::memory_order_relaxed)) {
      }
    }
  });
  for (std::size_t v = 0; v < block_of_.size(); ++v)
    if (block_of_[v] == kShared) seam_.push_back(static_cast<Index>(v));
  for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
    if (block_of_tet_[t] != kBeyond) continue;
    for (const Index v : mesh_.tets[t]) {
      std::uint32_t& block = block_of_[v];
      if (block < kBeyond) rim_.push_back(v);
      block = block == kNone || block == kBeyond ? kBeyond : kShared;
    }
  }
  std::sort(rim_.begin(), rim_.end());
}

void MeshBlocks::assign_triangles_and_edges() {
  const auto assign = [&](const auto& elements, auto& per_block, auto& seam) {
    per_block.resize(size());
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const auto own =
          std::find_if(elements[i].begin(), elements[i].end(), [&](Index v) { return !is_shared(v); });
      if (own == elements[i].end()) {
        seam.emplace_back(sorted(elements[i]), static_cast<Index>(i));
      } else if (block_of_[*own] < kBeyond) {
        per_block[block_of_[*own]].push_back(static_cast<Index>(i));
      }
    }
    std::sort(seam.begin(), seam.end());
  };
  assign(mesh_.triangles, triangles_, seam_triangles_);
  assign(mesh_.edges, edges_, seam_edges_);
}

void MeshBlocks::find_vertices(std::size_t block, MeshBlock& result) const {
  std::vector<char> used(mesh_.points.size(), 0);
  std::vector<Index>& all = result.vertices;
  for (const Index t : tets_[block]) {
    for (const Index v : mesh_.tets[t]) {
      if (used[v]) continue;
      used[v] = 1;
      all.push_back(v);
    }
  }
  std::sort(all.begin(), all.end());
  const auto first_free =
      std::stable_partition(all.begin(), all.end(), [&](Index v) { return v < fixed_ || is_shared(v); });
  result.fixed = static_cast<std::size_t>(first_free - all.begin());
  const auto first_loose =
      std::stable_partition(first_free, all.end(), [&](Index v) { return !held_.empty() && held_[v] != 0; });
  result.held = static_cast<std::size_t>(first_loose - first_free);
}

void MeshBlocks::add_triangles_and_edges(std::size_t block, const std::vector<Index>& number,
                                         Mesh& mesh) const {
  std::vector<Index> triangles = triangles_[block], edges = edges_[block];
  for (const Index t : tets_[block]) {
    const auto& v = mesh_.tets[t];
    if (std::count_if(v.begin(), v.end(), [&](Index w) { return is_shared(w); }) < 2) continue;
    for (const auto& f : kTetFace) {
      if (!is_shared(v[f[0]]) || !is_shared(v[f[1]]) || !is_shared(v[f[2]])) continue;
      const std::size_t i = find_key(seam_triangles_, sorted(Triple{v[f[0]], v[f[1]], v[f[2]]}));
      if (i < seam_triangles_.size()) triangles.push_back(seam_triangles_[i].second);
    }
    for (const auto& e : kTetEdge) {
      const Index a = v[e[0]], b = v[e[1]];
      if (!is_shared(a) || !is_shared(b) || mesh_.point_on[a].dim > 1 || mesh_.point_on[b].dim > 1) continue;
      const std::size_t i = find_key(seam_edges_, sorted(Pair{a, b}));
      if (i < seam_edges_.size()) edges.push_back(seam_edges_[i].second);
    }
  }
  const auto add = [&](std::vector<Index>& from, const auto& elements, const auto& on, auto& to,
                       auto& to_on) {
    sort_unique(from);
    for (const Index i : from) {
      const auto element = renumbered(elements[i], number);
      if (std::find(element.begin(), element.end(), kNone) != element.end()) continue;  // of no tetrahedron
      to.push_back(element);
      to_on.push_back(on[i]);
    }
  };
  add(triangles, mesh_.triangles, mesh_.triangle_on, mesh.triangles, mesh.triangle_on);
  add(edges, mesh_.edges, mesh_.edge_on, mesh.edges, mesh.edge_on);
}

MeshBlock MeshBlocks::cut_out(std::size_t block) const {
  MeshBlock result;
  find_vertices(block, result);
  std::vector<Index> number(mesh_.points.size(), kNone);
  for (const Index v : result.vertices) {
    number[v] = static_cast<Index>(result.mesh.points.size());
    result.mesh.points.push_back(mesh_.points[v]);
    result.mesh.point_on.push_back(mesh_.point_on[v]);
  }
  for (const Index t : tets_[block]) {
    result.mesh.tets.push_back(renumbered(mesh_.tets[t], number));
    result.mesh.tet_in.push_back(mesh_.tet_in[t]);
  }
  add_triangles_and_edges(block, number, result.mesh);
  return result;
}

void MeshBlocks::keep_others(Whole& whole) const {
  Mesh& mesh = whole.mesh;
  std::vector<Index>& number = whole.number;
  number.assign(mesh_.points.size(), kGone);
  for (Index v = 0; v < mesh_.points.size(); ++v) {
    if (v >= fixed_ && block_of_[v] < kBeyond) continue;
    number[v] = static_cast<Index>(mesh.points.size());
    mesh.points.push_back(mesh_.points[v]);
    mesh.point_on.push_back(mesh_.point_on[v]);
    if (!held_.empty() && held_[v]) whole.held.push_back(number[v]);
  }
  const auto keep = [&](const auto& elements, const auto& on, auto& to, auto& to_on, const auto& is_kept) {
    const auto kept = collect<Index>(elements.size(), [&](std::size_t i, std::vector<Index>& found) {
      if (is_kept(i)) found.push_back(static_cast<Index>(i));
    });
    to.resize(kept.size());
    to_on.resize(kept.size());
    tbb::parallel_for(std::size_t{0}, kept.size(), [&](std::size_t n) {
      to[n] = renumbered(elements[kept[n]], number);
      to_on[n] = on[kept[n]];
    });
  };
  const auto is_of_no_block = [&](const auto& element) {
    return std::all_of(element.begin(), element.end(), [&](Index v) { return is_shared(v); }) ||
           (std::any_of(element.begin(), element.end(), [&](Index v) { return block_of_[v] == kBeyond; }) &&
            std::all_of(element.begin(), element.end(), [&](Index v) { return number[v] != kGone; }));
  };
  keep(mesh_.tets, mesh_.tet_in, mesh.tets, mesh.tet_in,
       [&](std::size_t t) { return block_of_tet_[t] == kBeyond; });
  keep(mesh_.triangles, mesh_.triangle_on, mesh.triangles, mesh.triangle_on,
       [&](std::size_t i) { return is_of_no_block(mesh_.triangles[i]); });
  keep(mesh_.edges, mesh_.edge_on, mesh.edges, mesh.edge_on,
       [&](std::size_t i) { return is_of_no_block(mesh_.edges[i]); });
}

MeshBlocks::Whole MeshBlocks::put_together(const std::vector<MeshBlock>& blocks) const {
  Whole whole;
  Mesh& mesh = whole.mesh;
  std::size_t points = mesh_.points.size(), tets = mesh_.tets.size();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    points += blocks[b].mesh.points.size() - blocks[b].vertices.size();
    tets += blocks[b].mesh.tets.size() - tets_[b].size();
  }
  mesh.points.reserve(points);
  mesh.point_on.reserve(points);
  mesh.tets.reserve(tets);
  mesh.tet_in.reserve(tets);
  keep_others(whole);
  std::vector<std::size_t> first_point{mesh.points.size()}, first_tet{mesh.tets.size()};
  for (const MeshBlock& block : blocks) {
    first_point.push_back(first_point.back() + block.mesh.points.size() - block.fixed);
    first_tet.push_back(first_tet.back() + block.mesh.tets.size());
    for (std::size_t v = 0; v < block.held; ++v)
      whole.held.push_back(static_cast<Index>(first_point[first_point.size() - 2] + v));
  }
  mesh.points.resize(first_point.back());
  mesh.point_on.resize(first_point.back());
  mesh.tets.resize(first_tet.back());
  mesh.tet_in.resize(first_tet.back());
  struct Elements {
    std::vector<std::array<Index, 3>> triangles;
    std::vector<std::array<Index, 2>> edges;
    std::vector<std::int32_t> triangle_on, edge_on;
  };
  std::vector<Elements> of_blocks(blocks.size());
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t b) {
    const MeshBlock& block = blocks[b];
    std::vector<Index> in_whole(block.mesh.points.size());
    for (std::size_t v = 0; v < block.fixed; ++v) in_whole[v] = whole.number[block.vertices[v]];
    for (std::size_t v = block.fixed; v < in_whole.size(); ++v) {
      const std::size_t n = first_point[b] + v - block.fixed;
      in_whole[v] = static_cast<Index>(n);
      mesh.points[n] = block.mesh.points[v];
      mesh.point_on[n] = block.mesh.point_on[v];
    }
    for (std::size_t t = 0; t < block.mesh.tets.size(); ++t) {
      mesh.tets[first_tet[b] + t] = renumbered(block.mesh.tets[t], in_whole);
      mesh.tet_in[first_tet[b] + t] = block.mesh.tet_in[t];
    }
    const auto add = [&](const auto& elements, const auto& on, auto& to, auto& to_on, const auto& seam) {
      for (std::size_t i = 0; i < elements.size(); ++i) {
        auto given = elements[i];
        bool on_seam = std::all_of(given.begin(), given.end(), [&](Index v) { return v < block.fixed; });
        if (on_seam) {
          for (Index& v : given) v = block.vertices[v];
          on_seam = find_key(seam, sorted(given)) < seam.size();
        }
        if (on_seam) continue;  // it is there already
        to.push_back(renumbered(elements[i], in_whole));
        to_on.push_back(on[i]);
      }
    };
    Elements& own = of_blocks[b];
    add(block.mesh.triangles, block.mesh.triangle_on, own.triangles, own.triangle_on, seam_triangles_);
    add(block.mesh.edges, block.mesh.edge_on, own.edges, own.edge_on, seam_edges_);
  });
  const auto append = [](const auto& from, auto& to) { to.insert(to.end(), from.begin(), from.end()); };
  for (const Elements& own : of_blocks) {
    append(own.triangles, mesh.triangles);
    append(own.triangle_on, mesh.triangle_on);
    append(own.edges, mesh.edges);
    append(own.edge_on, mesh.edge_on);
  }
  return whole;
}

void MeshBlocks::move_to(const std::vector<MeshBlock>& blocks, std::vector<Vec3>& points) {
  for (const MeshBlock& block : blocks)
    for (std::size_t v = 0; v < block.vertices.size(); ++v) points[block.vertices[v]] = block.mesh.points[v];
}

std::vector<Mesh::Index> tets_near(const Mesh& mesh, const std::vector<Mesh::Index>& vertices, int layers) {
  std::vector<char> vertex_near(mesh.points.size(), 0), near(mesh.tets.size(), 0);
  for (const Index v : vertices) vertex_near[v] = 1;
  for (int layer = 0; layer < layers; ++layer) {
    const auto found = collect<Index>(mesh.tets.size(), [&](std::size_t t, std::vector<Index>& tets) {
      const auto& v = mesh.tets[t];
      if (!near[t] && (vertex_near[v[0]] | vertex_near[v[1]] | vertex_near[v[2]] | vertex_near[v[3]]) != 0)
        tets.push_back(static_cast<Index>(t));
    });
    for (const Index t : found) {
      near[t] = 1;
      for (const Index v : mesh.tets[t]) vertex_near[v] = 1;
    }
  }
  return collect<Index>(near.size(), [&](std::size_t t, std::vector<Index>& tets) {
    if (near[t]) tets.push_back(static_cast<Index>(t));
  });
}

}  // namespace octet
