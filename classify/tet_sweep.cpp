// SPDX-License-Identifier: BSD-3-Clause
// The pass by blocks; sums of doubles in the order of the blocks, hash sums in any.
#include "classify/tet_sweep.h"

#include <limits>

#include "base/blocks.h"
#include "base/predicates.h"
#include "mesh/quality.h"
#include "mesh/sort_triple.h"
#include "mesh/tet_mesh.h"

namespace octet {
namespace {

constexpr std::size_t kBlock = 16384;

/// A number for the oriented face; opposite orientations have opposite numbers.
std::uint64_t signed_hash(std::array<Mesh::Index, 3> v) {
  const bool odd = sort_triple(v);
  std::uint64_t h = (std::uint64_t{v[0]} << 32 | v[1]) * 0x9E3779B97F4A7C15u;
  h = ((h ^ h >> 32) + v[2]) * 0xD6E8FEB86659FD93u;
  h = (h ^ h >> 32) * 0xD6E8FEB86659FD93u;
  h ^= h >> 32;
  return odd ? 0u - h : h;
}

struct BlockSums {
  double smallest = std::numeric_limits<double>::infinity();
  std::vector<std::uint32_t> not_positive;
  std::vector<double> filled;
  std::vector<std::uint64_t> chain;
};

BlockSums sweep_block(const Mesh& mesh, std::size_t regions, std::size_t first, std::size_t last) {
  BlockSums sums;
  sums.filled.assign(regions, 0.0);
  sums.chain.assign(regions, 0);
  for (std::size_t i = first; i < last; ++i) {
    const auto& t = mesh.tets[i];
    const Vec3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]], &d = mesh.points[t[3]];
    const double volume = signed_volume(a, b, c, d);
    sums.smallest = std::min(sums.smallest, volume);
    sums.filled[mesh.tet_in[i]] += volume;
    if (orient3d(a, b, c, d) <= 0) sums.not_positive.push_back(static_cast<std::uint32_t>(i));
    std::uint64_t& chain = sums.chain[mesh.tet_in[i]];
    for (const auto& face : kTetFace) chain += signed_hash({t[face[0]], t[face[1]], t[face[2]]});
  }
  return sums;
}

}  // namespace

TetSweep sweep_tets(const Mesh& mesh, const Model& model) {
  const auto regions = static_cast<std::size_t>(model.count(3)) + 1;
  TetSweep sweep;
  sweep.filled.assign(regions, 0.0);
  sweep.smallest_volume = std::numeric_limits<double>::infinity();
  std::vector<std::uint64_t> chain(regions, 0);
  for (const BlockSums& sums : map_blocks<BlockSums>(
           mesh.tets.size(), kBlock,
           [&](std::size_t first, std::size_t last) { return sweep_block(mesh, regions, first, last); })) {
    sweep.smallest_volume = std::min(sweep.smallest_volume, sums.smallest);
    sweep.not_positive.insert(sweep.not_positive.end(), sums.not_positive.begin(), sums.not_positive.end());
    for (std::size_t r = 0; r < regions; ++r) {
      sweep.filled[r] += sums.filled[r];
      chain[r] += sums.chain[r];
    }
  }
  if (mesh.tets.empty()) sweep.smallest_volume = 0.0;
  sweep.on_surface.assign(mesh.points.size(), 0);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    // The face's normal points out of the region behind it.
    const auto& [behind, before] = model.face(mesh.triangle_on[i]).region;
    const std::uint64_t hash = signed_hash(mesh.triangles[i]);
    chain[behind] -= hash;
    chain[before] += hash;
    for (const Mesh::Index v : mesh.triangles[i]) sweep.on_surface[v] = 1;
  }
  sweep.closes = std::all_of(chain.begin() + 1, chain.end(), [](std::uint64_t sum) { return sum == 0; });
  return sweep;
}

}  // namespace octet
