// SPDX-License-Identifier: BSD-3-Clause
// How fast: triangulation of random, lattice, octree and matched points; predicates.
#include <benchmark/benchmark.h>

#include <cmath>

#include "base/predicates.h"
#include "tests/delaunay/balanced_octree.h"
#include "tests/delaunay/point_sets.h"

namespace octet {
namespace {

using namespace testing;

void count_tets(benchmark::State& state, const RankedPoints& set) {
  std::size_t tets = 0;
  for (auto _ : state) {
    const Triangulation triangulation = triangulate(set);
    const TetMesh& mesh = triangulation.mesh();
    for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
      tets += mesh.alive(TetId(i)) && !mesh.ghost(TetId(i)) ? 1 : 0;
    }
  }
  state.counters["tets/s"] = benchmark::Counter(static_cast<double>(tets), benchmark::Counter::kIsRate);
}

void triangulate_random(benchmark::State& state) {
  Engine engine(1);
  count_tets(state, random_points(static_cast<std::size_t>(state.range(0)), engine));
}
BENCHMARK(triangulate_random)->Arg(10'000)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

void triangulate_lattice(benchmark::State& state) {
  Engine engine(2);
  const int n = static_cast<int>(state.range(0));
  count_tets(state, lattice_points(n, n, n, 0.37, engine));
}
BENCHMARK(triangulate_lattice)->Arg(46)->Unit(benchmark::kMillisecond);

void triangulate_octree(benchmark::State& state) {
  Engine engine(3);
  count_tets(state, BalancedOctree(3, 6, 0.3, engine).vertices());
}
BENCHMARK(triangulate_octree)->Unit(benchmark::kMillisecond);

// Two oblique sheets of matched points, 0.01 apart: prisms, cospherical but for rounding.
void triangulate_matched_sheets(benchmark::State& state) {
  Engine engine(4);
  RankedPoints set;
  const double c = std::cos(0.3), s = std::sin(0.3);
  for (int i = 0; i < 50'000; ++i) {
    const double x = real(engine), y = real(engine);
    for (const double z : {0.0, 0.01}) set.add({x * c - z * s, y, x * s + z * c}, set.size());
  }
  count_tets(state, set);
}
BENCHMARK(triangulate_matched_sheets)->Unit(benchmark::kMillisecond);

// range(0): 0 random, 1 lattice points, all cospherical.
void insphere_sign(benchmark::State& state) {
  Engine engine(6);
  std::vector<Vec3> p;
  for (int n = 0; n < 5000; ++n) {
    p.emplace_back(real(engine), real(engine), real(engine));
    if (state.range(0) == 1) p.back() = Vec3(0.1, 0.2, 0.3) + 0.7 * Vec3(n & 1, n >> 1 & 1, n >> 2 & 1);
  }
  for (auto _ : state) {
    int sum = 0;
    for (std::size_t n = 0; n + 4 < p.size(); ++n)
      sum += insphere(p[n], p[n + 1], p[n + 2], p[n + 3], p[n + 4]);
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(p.size() - 4));
}
BENCHMARK(insphere_sign)->Arg(0)->Arg(1);

}  // namespace
}  // namespace octet

BENCHMARK_MAIN();
