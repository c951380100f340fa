// SPDX-License-Identifier: BSD-3-Clause
// Compaction in the order of the points, so that the bytes depend on the input alone.
#include "classify/extract.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/blocks.h"
#include "base/bucket_sort.h"

namespace octet {
namespace {

class Extractor {
 public:
  Extractor(std::span<const Vec3> points, std::span<const ModelRef> on)
      : points_(points), on_(on), number_(points.size(), kUnused) {}

  /// From several threads at once.
  void use(std::uint32_t p) { std::atomic_ref(number_[p]).store(0, std::memory_order_relaxed); }

  /// Numbers `first` in their order, then the other used points in theirs.
  void number(std::span<const std::uint32_t> first) {
    std::vector<std::uint32_t> order(first.begin(), first.end());
    for (const std::uint32_t p : first) number_[p] = kUnused;
    for (std::uint32_t p = 0; p < number_.size(); ++p) {
      if (number_[p] == kUnused) continue;
      number_[p] = static_cast<std::uint32_t>(order.size());
      order.push_back(p);
    }
    for (std::uint32_t n = 0; n < first.size(); ++n) number_[first[n]] = n;
    mesh.points.resize(order.size());
    mesh.point_on.resize(order.size());
    tbb::parallel_for(std::size_t{0}, order.size(), [&](std::size_t n) {
      mesh.points[n] = points_[order[n]];
      mesh.point_on[n] = on_[order[n]];
    });
  }
  [[nodiscard]] std::uint32_t operator()(std::uint32_t p) const { return number_[p]; }

  Mesh mesh;

 private:
  static constexpr std::uint32_t kUnused = UINT32_MAX;

  std::span<const Vec3> points_;
  std::span<const ModelRef> on_;
  std::vector<std::uint32_t> number_;
};

int nearest_face(const Model& model, const Vec3& p) {
  const auto foot = model.closest(p, std::numeric_limits<double>::infinity());
  return foot ? foot->face : 1;
}

struct Placed {
  std::array<Mesh::Index, 4> tet;
  std::int32_t region;
};

/// The tetrahedra make(i), i < count, in the order of their lowest vertices, so that neighbours lie near each
/// other in memory too.
template <class Make>
void take_in_order(std::size_t count, const Make& make, Mesh& mesh) {
  const auto sorted = bucket_sorted(
      count, mesh.points.size(), make,
      [](const Placed& p) { return *std::min_element(p.tet.begin(), p.tet.end()); },
      [](const Placed& a, const Placed& b) { return a.tet < b.tet; });
  mesh.tets.resize(count);
  mesh.tet_in.resize(count);
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    mesh.tets[i] = sorted[i].tet;
    mesh.tet_in[i] = sorted[i].region;
  });
}

}  // namespace

Mesh extract_mesh(Band& band, const TetMesh& tets, std::span<const Vec3> points, std::span<const ModelRef> on,
                  const EdgeChains& chains, const ExtraTets& extra) {
  const Model& model = band.model();
  Extractor out(points, on);
  const auto is_covered = [&](const std::array<VertexId, 4>& v) {
    if (!extra.covers || std::any_of(v.begin(), v.end(), [&](VertexId p) {
          return p.index() < extra.first_covered || p.index() >= extra.last_covered;
        }))
      return false;
    return extra.covers(0.25 *
                        (tets.points[v[0]] + tets.points[v[1]] + tets.points[v[2]] + tets.points[v[3]]));
  };
  const auto kept = collect<TetId>(tets.tets.size(), [&](std::size_t i, std::vector<TetId>& found) {
    const TetId t(i);
    if (!tets.alive(t) || band.region(t) == 0 || tets.ghost(t)) return;
    if (!is_covered(tets.tets[t])) found.push_back(t);
  });
  tbb::parallel_for(std::size_t{0}, kept.size(), [&](std::size_t i) {
    for (const VertexId p : tets.tets[kept[i]]) out.use(p.index());
  });
  tbb::parallel_for(std::size_t{0}, extra.tets.size(), [&](std::size_t i) {
    for (const std::uint32_t p : extra.tets[i]) out.use(p);
  });
  out.number(extra.first);
  Mesh& mesh = out.mesh;
  take_in_order(
      kept.size() + extra.tets.size(),
      [&](std::size_t i) -> Placed {
        if (i >= kept.size()) {
          const auto& v = extra.tets[i - kept.size()];
          return {{out(v[0]), out(v[1]), out(v[2]), out(v[3])}, extra.region[i - kept.size()]};
        }
        const auto& v = tets.tets[kept[i]];
        return {{out(v[0].index()), out(v[1].index()), out(v[2].index()), out(v[3].index())},
                band.region(kept[i])};
      },
      mesh);
  const std::vector<BoundaryFacet>& facets = band.facets(tets, on);
  mesh.triangles.resize(facets.size());
  mesh.triangle_on.resize(facets.size());
  tbb::parallel_for(std::size_t{0}, facets.size(), [&](std::size_t i) {
    const BoundaryFacet& f = facets[i];
    std::array<std::uint32_t, 3> v{out(f.v[0].index()), out(f.v[1].index()), out(f.v[2].index())};
    const int face =
        f.face > 0
            ? f.face
            : nearest_face(model, (tets.points[f.v[0]] + tets.points[f.v[1]] + tets.points[f.v[2]]) / 3.0);
    // The facet is listed outwards from the region of `tet`; the model face's normal points to region[1].
    if (model.face(face).region[0] != band.region(f.tet)) std::swap(v[1], v[2]);
    mesh.triangles[i] = v;
    mesh.triangle_on[i] = face;
  });
  for (const EdgePiece& p : chains.pieces()) {
    if (out(p.a) == UINT32_MAX || out(p.b) == UINT32_MAX) continue;
    mesh.edges.push_back({out(p.a), out(p.b)});
    mesh.edge_on.push_back(p.edge);
  }
  return std::move(out.mesh);
}

}  // namespace octet
