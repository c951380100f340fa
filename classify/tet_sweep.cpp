// SPDX-License-Identifier: BSD-3-Clause
// The pass by blocks; sums of doubles in the order of the blocks, hash sums in any.
#include "classify/tet_sweep.h"

#include <atomic>
#include <limits>

#include "base/blocks.h"
#include "base/lane_vec.h"
#include "base/predicates.h"
#include "mesh/sort_triple.h"

namespace octet {
namespace {

constexpr std::size_t kSweepBlock = 16384;

/// A number for a face.
std::uint64_t hash_of(Mesh::Index v0, Mesh::Index v1, Mesh::Index v2) {
  std::uint64_t h = (std::uint64_t{v0} << 32 | v1) * 0x9E3779B97F4A7C15u;
  h = ((h ^ h >> 32) + v2) * 0xD6E8FEB86659FD93u;
  h = (h ^ h >> 32) * 0xD6E8FEB86659FD93u;
  return h ^ h >> 32;
}

/// A number for the oriented triangle; opposite orientations have opposite numbers.
std::uint64_t signed_hash(std::array<Mesh::Index, 3> v) {
  const bool odd = sort_triple(v);
  const std::uint64_t h = hash_of(v[0], v[1], v[2]);
  return odd ? 0u - h : h;
}

/// The sum of the numbers of the outward faces. With the vertices in ascending order the faces' vertices are,
/// too, and their orientations alternate.
std::uint64_t boundary_hash(std::array<Mesh::Index, 4> v) {
  bool odd = false;
  const auto order = [&](int i, int j) {
    const Mesh::Index less = std::min(v[i], v[j]), more = std::max(v[i], v[j]);
    odd ^= v[i] != less;
    v[i] = less;
    v[j] = more;
  };
  order(0, 1);
  order(2, 3);
  order(0, 2);
  order(1, 3);
  order(1, 2);
  const std::uint64_t h = hash_of(v[1], v[2], v[3]) - hash_of(v[0], v[2], v[3]) + hash_of(v[0], v[1], v[3]) -
                          hash_of(v[0], v[1], v[2]);
  return odd ? 0u - h : h;
}

struct BlockSums {
  double smallest = std::numeric_limits<double>::infinity();
  std::vector<std::uint32_t> not_positive, outer;
  std::vector<double> filled;
  std::vector<std::uint64_t> chain;
};

}  // namespace

namespace sweep_lanes {

struct Volumes {
  Lanes volume;
  /// 1 where rounding cannot have made the volume positive, which is nearly everywhere.
  Lanes sure;
};

OCTET_WIDE_CLONES void measure(const Mesh& mesh, const std::array<Mesh::Index, 4>* const (&tets)[kLanes],
                               Volumes& volumes) {
  // The determinant's error is below 6e-15 of the product of the extents, where these are so large that no
  // product of differences vanishes.
  constexpr double kClear = 1e-14, kSmallest = 1e-55, kLargest = 1e60;
  LaneVec3 p[4];
  for (std::size_t lane = 0; lane < kLanes; ++lane)
    for (std::size_t k = 0; k < 4; ++k) p[k].set(lane, mesh.points[(*tets[lane])[k]]);
  const LaneVec3 b = p[1] - p[0], c = p[2] - p[0], d = p[3] - p[0];
  const Lanes determinant = dot(cross(b, c), d);
  const Lanes x = most(most(magnitude(b[0]), magnitude(c[0])), magnitude(d[0])),
              y = most(most(magnitude(b[1]), magnitude(c[1])), magnitude(d[1])),
              z = most(most(magnitude(b[2]), magnitude(c[2])), magnitude(d[2]));
  const Lanes clear = kClear * (x * y * z),
              in_range = least(least(x, y), z) > kSmallest ? clear : determinant,
              bound = most(most(x, y), z) < kLargest ? in_range : determinant;
  volumes.volume = determinant / 6.0;
  volumes.sure = determinant > bound ? Lanes{} + 1.0 : Lanes{};
}

}  // namespace sweep_lanes

namespace {

class BlockSweep {
 public:
  BlockSweep(const Mesh& mesh, std::size_t regions, TetSweep& sweep) : mesh_(mesh), sweep_(sweep) {
    sums_.filled.assign(regions, 0.0);
    sums_.chain.assign(regions, 0);
  }

  BlockSums run(std::size_t first, std::size_t last) {
    sweep_lanes::Volumes volumes;
    for (std::size_t t = first; t < last; t += kLanes) {
      // Lanes beyond the last tetrahedron repeat it, and are not looked at.
      const std::size_t used = std::min(kLanes, last - t);
      const std::array<Mesh::Index, 4>* tets[kLanes];
      for (std::size_t lane = 0; lane < kLanes; ++lane)
        tets[lane] = &mesh_.tets[t + std::min(lane, used - 1)];
      sweep_lanes::measure(mesh_, tets, volumes);
      for (std::size_t lane = 0; lane < used; ++lane)
        add(static_cast<std::uint32_t>(t + lane), volumes.volume[lane], volumes.sure[lane] > 0.0);
    }
    return std::move(sums_);
  }

 private:
  void add(std::uint32_t i, double volume, bool surely_positive) {
    const auto& t = mesh_.tets[i];
    const auto region = static_cast<std::size_t>(mesh_.tet_in[i]);
    const auto& points = mesh_.points;
    sums_.smallest = std::min(sums_.smallest, volume);
    sums_.filled[region] += volume;
    if (!surely_positive && orient3d(points[t[0]], points[t[1]], points[t[2]], points[t[3]]) <= 0)
      sums_.not_positive.push_back(i);
    sums_.chain[region] += boundary_hash(t);
    bool is_outer = false;
    for (const Mesh::Index v : t) {
      const bool own = mesh_.point_on[v] == model_region(mesh_.tet_in[i]);
      if (own) flag(sweep_.in_own[v]);
      is_outer = is_outer || !own || sweep_.on_surface[v] != 0;
    }
    if (is_outer) sums_.outer.push_back(i);
  }

  /// From several threads at once.
  static void flag(std::uint8_t& byte) {
    const std::atomic_ref shared(byte);
    if (shared.load(std::memory_order_relaxed) == 0) shared.store(1, std::memory_order_relaxed);
  }

  const Mesh& mesh_;
  TetSweep& sweep_;
  BlockSums sums_;
};

}  // namespace

TetSweep sweep_tets(const Mesh& mesh, const Model& model) {
  const auto regions = static_cast<std::size_t>(model.count(3)) + 1;
  TetSweep sweep;
  sweep.filled.assign(regions, 0.0);
  sweep.smallest_volume = std::numeric_limits<double>::infinity();
  std::vector<std::uint64_t> chain(regions, 0);
  sweep.on_surface.assign(mesh.points.size(), 0);
  sweep.in_own.assign(mesh.points.size(), 0);
  for (const auto& triangle : mesh.triangles)
    for (const Mesh::Index v : triangle) sweep.on_surface[v] = 1;
  for (const BlockSums& sums :
       map_blocks<BlockSums>(mesh.tets.size(), kSweepBlock, [&](std::size_t first, std::size_t last) {
         return BlockSweep(mesh, regions, sweep).run(first, last);
       })) {
    sweep.smallest_volume = std::min(sweep.smallest_volume, sums.smallest);
    sweep.not_positive.insert(sweep.not_positive.end(), sums.not_positive.begin(), sums.not_positive.end());
    sweep.outer.insert(sweep.outer.end(), sums.outer.begin(), sums.outer.end());
    for (std::size_t r = 0; r < regions; ++r) {
      sweep.filled[r] += sums.filled[r];
      chain[r] += sums.chain[r];
    }
  }
  if (mesh.tets.empty()) sweep.smallest_volume = 0.0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    // The face's normal points out of the region behind it.
    const auto& [behind, before] = model.face(mesh.triangle_on[i]).region;
    const std::uint64_t hash = signed_hash(mesh.triangles[i]);
    chain[behind] -= hash;
    chain[before] += hash;
  }
  sweep.closes = std::all_of(chain.begin() + 1, chain.end(), [](std::uint64_t sum) { return sum == 0; });
  return sweep;
}

}  // namespace octet
