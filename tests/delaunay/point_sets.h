// SPDX-License-Identifier: BSD-3-Clause
// Point sets for the tests of the triangulation: random, lattice, mixed; and sets of tetrahedra to compare.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "base/vec.h"
#include "base/vertex_order.h"
#include "delaunay/triangulation.h"

namespace octet::testing {

using Engine = std::mt19937;

/// Uniform in [0, 1), the same with every standard library.
inline double real(Engine& engine) { return static_cast<double>(engine()) / 4294967296.0; }
inline std::size_t below(Engine& engine, std::size_t n) { return engine() % n; }

struct RankedPoints {
  std::vector<Vec3> points;
  std::vector<std::uint64_t> ranks;

  void add(const Vec3& p, std::uint64_t rank) {
    points.push_back(p);
    ranks.push_back(rank);
  }
  [[nodiscard]] std::size_t size() const { return points.size(); }
};

/// A permutation of 0..n-1.
inline std::vector<std::uint32_t> shuffled(std::size_t n, Engine& engine) {
  std::vector<std::uint32_t> order(n);
  for (std::size_t i = 0; i < n; ++i) order[i] = static_cast<std::uint32_t>(i);
  for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[below(engine, i)]);
  return order;
}

inline RankedPoints random_points(std::size_t n, Engine& engine) {
  RankedPoints set;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = real(engine), y = real(engine), z = real(engine);
    set.add({x, y, z}, i);
  }
  return set;
}

/// The full lattice of nx*ny*nz points, ranks shuffled and drawn from three classes.
inline RankedPoints lattice_points(int nx, int ny, int nz, double unit, Engine& engine) {
  RankedPoints set;
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) set.add({unit * i, unit * j, unit * k}, 0);
    }
  }
  const auto order = shuffled(set.size(), engine);
  for (std::size_t i = 0; i < set.size(); ++i)
    set.ranks[i] = (std::uint64_t{below(engine, 3)} << kRankClassShift) | order[i];
  return set;
}

/// A lattice, points a few ulps from some of its points, and points on its planes and lines.
inline RankedPoints mixed_points(int n, Engine& engine) {
  RankedPoints set = lattice_points(n, n, n, 1.0, engine);
  const std::size_t lattice = set.size();
  const auto add = [&](const Vec3& p) {
    if (std::find(set.points.begin(), set.points.end(), p) == set.points.end()) set.add(p, set.size());
  };
  for (std::size_t i = 0; i < lattice / 4; ++i) {
    Vec3 p = set.points[below(engine, lattice)];
    const std::size_t axis = below(engine, 3);
    p[axis] = p[axis] == 0 ? 1e-17 : std::nextafter(p[axis], 100.0);
    add(p);
    Vec3 q = set.points[below(engine, lattice)];
    for (std::size_t k = 0; k <= below(engine, 3); ++k) q[below(engine, 3)] += 0.25 * below(engine, 4);
    if ((q.array() < n).all()) add(q);
  }
  return set;
}

using TetSet = std::vector<std::array<std::uint32_t, 4>>;

/// Vertices rotated by an even permutation so that equal positive tetrahedra become equal arrays.
inline std::array<std::uint32_t, 4> canonical(std::array<std::uint32_t, 4> t) {
  int swaps = 0;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j + 1 < 4; ++j) {
      if (t[j] > t[j + 1]) {
        std::swap(t[j], t[j + 1]);
        ++swaps;
      }
    }
  }
  if (swaps % 2 == 1) std::swap(t[2], t[3]);
  return t;
}

/// The finite tetrahedra, sorted; vertex v of the triangulation is named name[v].
inline TetSet tet_set(const Triangulation& triangulation, std::span<const std::uint32_t> name) {
  TetSet set;
  const TetMesh& mesh = triangulation.mesh();
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const TetId t(i);
    if (!mesh.alive(t) || mesh.ghost(t)) continue;
    const auto& v = mesh.tets[t];
    set.push_back(
        canonical({name[v[0].index()], name[v[1].index()], name[v[2].index()], name[v[3].index()]}));
  }
  std::sort(set.begin(), set.end());
  return set;
}

inline TetSet tet_set(const Triangulation& triangulation) {
  std::vector<std::uint32_t> same(triangulation.mesh().points.size());
  for (std::size_t i = 0; i < same.size(); ++i) same[i] = static_cast<std::uint32_t>(i);
  return tet_set(triangulation, same);
}

inline Triangulation triangulate(const RankedPoints& set) {
  Triangulation triangulation;
  triangulation.insert_all(set.points, set.ranks);
  return triangulation;
}

}  // namespace octet::testing
