// SPDX-License-Identifier: BSD-3-Clause
// How far walls can move; what lies between; and the elements beyond made good again.
#include "finalize/layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "base/predicates.h"
#include "finalize/finalize.h"
#include "finalize/layer_columns.h"
#include "finalize/mesh_blocks.h"

namespace octet {
namespace {

using Index = Mesh::Index;
using Tet = std::array<Index, 4>;
using Triangle = std::array<Index, 3>;

/// Elements beyond are left this angle (radians) by what moves, or what they had: finalization makes more of
/// it.
constexpr double kLeastAngle = 0.3;
constexpr double kShrink = 0.8;
constexpr int kPatience = 30;  ///< rounds, before what does not fit stays where it is
/// Below this share there is no layer.
constexpr double kLeastShare = 0.02;
/// Shares of neighbours differ by no more.
constexpr double kSteepest = 1.6;
constexpr int kMostRounds = 60;
/// A wall is left in steps of this share of the elements' size there, between which these are finalized; in
/// no more than so many.
constexpr double kStep = 0.3;
constexpr int kMostSteps = 12;
/// A vertex that gets no farther than this share of a step goes no farther later either.
constexpr double kStuck = 0.3;

std::array<Index, 2> sorted_side(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

/// Vertices of one side of a prism that go on to the other, one by one: calls visit(now, next) with the side
/// as it is and the vertex of the next level, in the order of the columns, so that two prisms have the same
/// diagonal between them. `level`: the side's vertices there; `next`: those of the next, equal where a column
/// has none.
template <std::size_t N, class Visit>
void advance(std::array<Index, N> level, const std::array<Index, N>& next, const std::array<Index, N>& order,
             const Visit& visit) {
  std::array<std::size_t, N> turn;
  std::iota(turn.begin(), turn.end(), std::size_t{0});
  std::sort(turn.begin(), turn.end(), [&](std::size_t a, std::size_t b) { return order[a] < order[b]; });
  for (const std::size_t i : turn) {
    if (level[i] == next[i]) continue;
    visit(level, next[i]);
    level[i] = next[i];
  }
}

class LayerMaker {
 public:
  LayerMaker(Mesh& mesh, const Model& model, const LayerOptions& options, Observer& observer)
      : mesh_(mesh),
        model_(model),
        options_(options),
        observer_(observer),
        walls_(mesh, model, options.wishes),
        levels_(options.wishes.front().heights.size()),
        old_points_(mesh.points.begin(),
                    mesh.points.begin() + static_cast<std::ptrdiff_t>(walls_.columns.size())),
        old_on_(mesh.point_on.begin(),
                mesh.point_on.begin() + static_cast<std::ptrdiff_t>(walls_.columns.size())),
        volume_(static_cast<std::size_t>(model.count(3)) + 1, 0.0),
        region_of_column_(walls_.columns.size(), 0) {
    for (std::size_t t = 0; t < mesh.tets.size(); ++t)
      volume_[static_cast<std::size_t>(mesh.tet_in[t])] += volume_of(mesh.tets[t]);
  }

  LayerReport run() {
    leave_walls();
    for (int step = 0; step < kMostSteps; ++step) {
      find_stars();
      if (!advance_columns()) break;
      observer_.note(fmt::format("layers: step {}", step + 1));
      improve_beyond();
      if (std::none_of(may_move_.begin(), may_move_.end(), [](bool may) { return may; })) break;
    }
    tell();
    report_.beyond = quality_summary(mesh_);
    add_levels();
    const Mesh layers = make_layers();
    report_.tets = layers.tets.size();
    join(layers);
    return report_;
  }

 private:
  struct WallTriangle {
    Triangle v, inwards;
    std::int32_t face;
  };
  /// A side of a triangle on no wall that is a side of one on a wall.
  struct Strip {
    std::array<Index, 2> side;  ///< as the former has it
    std::int32_t face;
  };
  struct WallEdge {
    std::array<Index, 2> v;
    std::int32_t tag;
  };
  /// Along an edge that goes inwards.
  struct Way {
    Index v;
    std::int32_t tag;
    bool forwards;  ///< as the edge runs
  };

  [[nodiscard]] double volume_of(const Tet& v) const {
    return signed_volume(mesh_.points[v[0]], mesh_.points[v[1]], mesh_.points[v[2]], mesh_.points[v[3]]);
  }
  /// None for a vertex that is on no wall.
  [[nodiscard]] const LayerColumn* column(Index v) const {
    return v < walls_.columns.size() ? &walls_.columns[v] : nullptr;
  }
  [[nodiscard]] bool moves(Index v) const {
    const LayerColumn* own = column(v);
    return own != nullptr && own->share > 0.0;
  }

  /// Where the column of a vertex is at a level, 0 on the wall.
  [[nodiscard]] Vec3 place(std::size_t v, std::size_t level) const {
    const LayerColumn& c = walls_.columns[v];
    if (level == 0 || c.share == 0.0) return old_points_[v];
    return c.way.at(c.share * options_.wishes[c.wish].heights[level - 1]);
  }

  /// What is of walls alone is no longer the mesh's, and what goes along them is noted.
  void leave_walls() {
    std::vector<std::array<Index, 2>> sides;
    for (const std::uint32_t t : walls_.triangles) {
      const Triangle& v = mesh_.triangles[t];
      wall_triangles_.push_back({v, walls_.inwards(mesh_, model_, t), mesh_.triangle_on[t]});
      for (std::size_t i = 0; i < 3; ++i) sides.push_back(sorted_side(v[i], v[(i + 1) % 3]));
    }
    std::sort(sides.begin(), sides.end());
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const Triangle v = mesh_.triangles[t];
      const std::int32_t face = mesh_.triangle_on[t];
      if (walls_.is_wall(face)) continue;
      for (std::size_t i = 0; i < 3; ++i)
        if (std::binary_search(sides.begin(), sides.end(), sorted_side(v[i], v[(i + 1) % 3])))
          strips_.push_back({{v[i], v[(i + 1) % 3]}, face});
      mesh_.triangles[kept] = v;
      mesh_.triangle_on[kept++] = face;
    }
    mesh_.triangles.resize(kept);
    mesh_.triangle_on.resize(kept);
    kept = 0;
    for (std::size_t e = 0; e < mesh_.edges.size(); ++e) {
      const std::array<Index, 2> v = mesh_.edges[e];
      const std::int32_t tag = mesh_.edge_on[e];
      if (walls_.wall_edge[static_cast<std::size_t>(tag)]) {
        wall_edges_.push_back({v, tag});
        continue;
      }
      for (const bool first : {true, false})
        if (const LayerColumn* c = column(v[first ? 0 : 1]);
            c != nullptr && c->way.along() == LayerWay::Along::kEdge && c->way.tag() == tag)
          ways_.push_back({v[first ? 0 : 1], tag, first});
      mesh_.edges[kept] = v;
      mesh_.edge_on[kept++] = tag;
    }
    mesh_.edges.resize(kept);
    mesh_.edge_on.resize(kept);
    for (std::size_t t = 0; t < mesh_.tets.size(); ++t)
      for (const Index v : mesh_.tets[t])
        if (v < region_of_column_.size()) region_of_column_[v] = mesh_.tet_in[t];
    for (LayerColumn& c : walls_.columns) {
      may_move_.push_back(c.share > 0.0);
      moved_.push_back(false);
      c.share = 0.0;
    }
  }

  /// Tetrahedra and triangles at vertices of walls.
  void find_stars() {
    const auto touches = [&](const auto& vertices) {
      return std::any_of(vertices.begin(), vertices.end(), [&](Index v) { return column(v) != nullptr; });
    };
    star_.clear();
    beside_.clear();
    for (std::uint32_t t = 0; t < mesh_.tets.size(); ++t)
      if (touches(mesh_.tets[t])) star_.push_back(t);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
      if (touches(mesh_.triangles[t])) beside_.push_back(t);
  }

  [[nodiscard]] double thickness(const LayerColumn& c) const {
    return options_.wishes[c.wish].heights.back();
  }

  /// Vertices go on as far as a step, the elements beyond and the layers allow. False: none does.
  bool advance_columns() {
    std::vector<LayerColumn>& columns = walls_.columns;
    const std::size_t n = columns.size();
    std::vector<double> had(n), wanted(n), angle(star_.size());
    std::vector<Vec3> top = mesh_.points;
    const auto least_angle = [&](const Tet& v) {
      if (orient3d(top[v[0]], top[v[1]], top[v[2]], top[v[3]]) <= 0) return 0.0;
      return dihedral_range(top[v[0]], top[v[1]], top[v[2]], top[v[3]]).smallest;
    };
    for (std::size_t i = 0; i < star_.size(); ++i) angle[i] = least_angle(mesh_.tets[star_[i]]);
    for (std::size_t i = 0; i < n; ++i) {
      had[i] = columns[i].share;
      wanted[i] =
          !may_move_[i]
              ? had[i]
              : std::min(1.0, had[i] + kStep * options_.size_at(old_points_[i]) / thickness(columns[i]));
    }
    const std::vector<double> asked = wanted;
    std::vector<double> last(n, -1.0);  // shares that were looked at
    for (int round = 0; round < kMostRounds; ++round) {
      if (options_.cancelled && options_.cancelled()) throw Cancelled();
      even_out(had, wanted);
      std::vector<bool> back(n, false), is_new(n, false);
      for (std::size_t i = 0; i < n; ++i) {
        if (wanted[i] == last[i]) continue;
        is_new[i] = true;
        last[i] = columns[i].share = wanted[i];
        top[i] = place(i, levels_);
      }
      // What has not changed since is as it was: good.
      const auto is_asked = [&](const auto& vertices) {
        return std::any_of(vertices.begin(), vertices.end(), [&](Index v) { return v < n && is_new[v]; });
      };
      const auto mark = [&](const auto& vertices) {
        for (const Index v : vertices)
          if (v < n) back[v] = true;
      };
      for (std::size_t i = 0; i < star_.size(); ++i) {
        const Tet& v = mesh_.tets[star_[i]];
        if (!is_asked(v)) continue;
        const double now = least_angle(v);
        if (now <= 0.0 || now < std::min(kLeastAngle, angle[i])) mark(v);
      }
      for (const std::uint32_t t : beside_)
        if (is_asked(mesh_.triangles[t]) && is_turned(mesh_.triangle_on[t], mesh_.triangles[t], top))
          mark(mesh_.triangles[t]);
      for (const WallTriangle& wall : wall_triangles_)
        if (is_asked(wall.inwards) && !is_sound_prism(wall.inwards)) mark(wall.inwards);
      for (const Strip& strip : strips_)
        if (is_asked(strip.side) && !is_sound_strip(strip)) mark(strip.side);
      bool any = false;
      for (std::size_t i = 0; i < n; ++i) {
        if (!back[i] || wanted[i] <= had[i]) continue;
        any = true;
        wanted[i] = round > kPatience ? had[i] : had[i] + kShrink * (wanted[i] - had[i]);
        if (wanted[i] - had[i] < kLeastShare) wanted[i] = had[i];
      }
      if (any) continue;
      bool moved = false;
      for (std::size_t i = 0; i < n; ++i) {
        moved_[i] = wanted[i] > had[i];
        moved = moved || moved_[i];
        if (wanted[i] - had[i] < kStuck * (asked[i] - had[i]) || wanted[i] >= 1.0) may_move_[i] = false;
        if (!moved_[i]) continue;
        mesh_.points[i] = top[i];
        mesh_.point_on[i] = on_way(i);
      }
      return moved;
    }
    for (std::size_t i = 0; i < n; ++i) columns[i].share = had[i];
    return false;
  }

  /// What a vertex that has left the wall is on.
  [[nodiscard]] ModelRef on_way(std::size_t i) const {
    const LayerWay& way = walls_.columns[i].way;
    if (way.along() == LayerWay::Along::kNothing) return model_region(region_of_column_.at(i));
    return way.along() == LayerWay::Along::kFace ? model_face(way.tag()) : model_edge(way.tag());
  }

  /// Shares of neighbours differ by no more than kSteepest, as far as they have not gone farther already.
  void even_out(const std::vector<double>& had, std::vector<double>& wanted) const {
    bool any = true;
    for (int sweep = 0; any && sweep < kMostRounds; ++sweep) {
      any = false;
      for (const WallTriangle& wall : wall_triangles_)
        for (std::size_t k = 0; k < 3; ++k) {
          const Index a = wall.inwards[k], b = wall.inwards[(k + 1) % 3];
          for (const auto& [high, low] : {std::pair(a, b), std::pair(b, a)}) {
            const double most = std::max(had[high], kSteepest * wanted[low]);
            if (wanted[low] == 0.0 || wanted[high] <= most) continue;
            wanted[high] = most;
            any = true;
          }
        }
    }
  }

  /// Whether a triangle on a face shows its back.
  [[nodiscard]] bool is_turned(std::int32_t face, const Triangle& v, const std::vector<Vec3>& points) const {
    constexpr double kLeastCosine = 0.2;
    const Vec3 a = points[v[0]], b = points[v[1]], c = points[v[2]];
    const Vec3 normal = (b - a).cross(c - a);
    const FaceFoot foot = model_.face_project(face, (a + b + c) / 3.0);
    return !foot.converged || normal.dot(foot.normal) <= kLeastCosine * normal.norm();
  }

  [[nodiscard]] bool is_sound_prism(const Triangle& v) const {
    bool sound = true;
    std::array<Vec3, 3> level;
    for (std::size_t i = 0; i < 3; ++i) level[i] = old_points_[v[i]];
    std::array<std::size_t, 3> turn{0, 1, 2};
    std::sort(turn.begin(), turn.end(), [&](std::size_t a, std::size_t b) { return v[a] < v[b]; });
    for (std::size_t k = 1; k <= levels_ && sound; ++k)
      for (const std::size_t i : turn) {
        if (!moves(v[i])) continue;
        const Vec3 next = place(v[i], k);
        sound = sound && orient3d(level[0], level[1], level[2], next) > 0;
        level[i] = next;
      }
    return sound;
  }

  [[nodiscard]] bool is_sound_strip(const Strip& strip) const {
    const FaceFoot foot =
        model_.face_project(strip.face, 0.5 * (old_points_[strip.side[0]] + old_points_[strip.side[1]]));
    std::array<Vec3, 2> level{old_points_[strip.side[0]], old_points_[strip.side[1]]};
    std::array<std::size_t, 2> turn{0, 1};
    if (strip.side[1] < strip.side[0]) std::swap(turn[0], turn[1]);
    for (std::size_t k = 1; k <= levels_; ++k)
      for (const std::size_t i : turn) {
        if (!moves(strip.side[i])) continue;
        const Vec3 next = place(strip.side[i], k);
        if ((level[1] - level[0]).cross(next - level[0]).dot(foot.normal) <= 0.0) return false;
        level[i] = next;
      }
    return true;
  }

  void tell() {
    for (std::size_t i = 0; i < walls_.columns.size(); ++i) {
      const LayerColumn& c = walls_.columns[i];
      if (c.share == 0.0) {
        ++report_.bare;
        continue;
      }
      ++report_.nodes;
      if (c.share < 1.0) ++report_.thinner;
      if (c.share < report_.least) {
        report_.least = c.share;
        report_.least_at = old_points_[i];
      }
    }
  }

  /// New vertices take the places on the walls, and those between.
  void add_levels() {
    levels_of_.resize(walls_.columns.size());
    for (std::size_t i = 0; i < walls_.columns.size(); ++i) {
      std::vector<Index>& levels = levels_of_[i];
      levels.assign(levels_ + 1, static_cast<Index>(i));
      if (walls_.columns[i].share == 0.0) continue;
      for (std::size_t k = 0; k < levels_; ++k) {
        levels[k] = static_cast<Index>(mesh_.points.size());
        mesh_.points.push_back(place(i, k));
        mesh_.point_on.push_back(k == 0 ? old_on_[i] : on_way(i));
      }
    }
  }

  [[nodiscard]] Index at_level(Index v, std::size_t level) const {
    return column(v) == nullptr ? v : levels_of_[v][level];
  }
  template <std::size_t N>
  [[nodiscard]] std::array<Index, N> at_level(const std::array<Index, N>& v, std::size_t level) const {
    std::array<Index, N> result;
    for (std::size_t i = 0; i < N; ++i) result[i] = at_level(v[i], level);
    return result;
  }

  /// Elements of the layers, and of walls and their edges, by the numbers of the mesh.
  Mesh make_layers() const {
    Mesh layers;
    for (const WallTriangle& wall : wall_triangles_) {
      const auto& sides = model_.face(wall.face).region;
      for (std::size_t k = 0; k < levels_; ++k)
        advance(at_level(wall.inwards, k), at_level(wall.inwards, k + 1), wall.inwards,
                [&](const Triangle& now, Index next) {
                  layers.tets.push_back({now[0], now[1], now[2], next});
                  layers.tet_in.push_back(sides[0] != 0 ? sides[0] : sides[1]);
                });
      layers.triangles.push_back(at_level(wall.v, 0));
      layers.triangle_on.push_back(wall.face);
    }
    for (const Strip& strip : strips_)
      for (std::size_t k = 0; k < levels_; ++k)
        advance(at_level(strip.side, k), at_level(strip.side, k + 1), strip.side,
                [&](const std::array<Index, 2>& now, Index next) {
                  layers.triangles.push_back({now[0], now[1], next});
                  layers.triangle_on.push_back(strip.face);
                });
    for (const WallEdge& edge : wall_edges_) {
      layers.edges.push_back(at_level(edge.v, 0));
      layers.edge_on.push_back(edge.tag);
    }
    for (const Way& way : ways_) {
      if (!moves(way.v)) continue;
      for (std::size_t k = 0; k < levels_; ++k) {
        std::array<Index, 2> piece{at_level(way.v, k), at_level(way.v, k + 1)};
        if (!way.forwards) std::swap(piece[0], piece[1]);
        layers.edges.push_back(piece);
        layers.edge_on.push_back(way.tag);
      }
    }
    return layers;
  }

  /// Finalizes the elements within a few of what has moved, around the columns and all that others share.
  void improve_beyond() {
    constexpr int kLayers = 4;
    std::vector<Index> moved;
    for (std::size_t i = 0; i < moved_.size(); ++i)
      if (moved_[i]) moved.push_back(static_cast<Index>(i));
    const std::vector<Index> near = tets_near(mesh_, moved, kLayers);
    const MeshBlocks blocks(mesh_, walls_.columns.size(), {}, near, near.size());
    std::vector<MeshBlock> parts{blocks.cut_out(0)};
    MeshBlock& part = parts.front();
    FinalizeOptions given;
    given.fixed_vertices = part.fixed;
    for (Index v = 0; v < part.fixed; ++v)
      if (column(part.vertices[v]) != nullptr &&
          !std::binary_search(blocks.rim().begin(), blocks.rim().end(), part.vertices[v]))
        given.alone.push_back(v);
    given.volume_beyond = volume_;  // all have what they had, layers included
    for (const Index t : near)
      given.volume_beyond[static_cast<std::size_t>(mesh_.tet_in[t])] -= volume_of(mesh_.tets[t]);
    given.size_at = options_.size_at;
    finalize(part.mesh, model_, given, observer_);
    mesh_ = blocks.put_together(parts).mesh;
  }

  /// Layers behind the rest.
  void join(const Mesh& layers) {
    const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(mesh_.tets, layers.tets);
    append(mesh_.tet_in, layers.tet_in);
    append(mesh_.triangles, layers.triangles);
    append(mesh_.triangle_on, layers.triangle_on);
    append(mesh_.edges, layers.edges);
    append(mesh_.edge_on, layers.edge_on);
  }

  Mesh& mesh_;
  const Model& model_;
  const LayerOptions& options_;
  Observer& observer_;
  LayerWalls walls_;
  std::size_t levels_;
  std::vector<Vec3> old_points_;  ///< per column, like what follows: on its wall
  std::vector<ModelRef> old_on_;
  std::vector<double> volume_;  ///< per region tag, as it was
  std::vector<std::int32_t> region_of_column_;
  std::vector<bool> moved_;     ///< per column: in the last step
  std::vector<bool> may_move_;  ///< per column
  std::vector<WallTriangle> wall_triangles_;
  std::vector<WallEdge> wall_edges_;
  std::vector<Strip> strips_;
  std::vector<Way> ways_;
  std::vector<std::uint32_t> star_, beside_;  ///< tetrahedra and triangles of the mesh at vertices of columns
  std::vector<std::vector<Index>> levels_of_;  ///< per column: vertices from the wall on
  LayerReport report_;
};

}  // namespace

LayerReport add_layers(Mesh& mesh, const Model& model, const LayerOptions& options, Observer& observer) {
  OCTET_CHECK(!options.wishes.empty() && static_cast<bool>(options.size_at) && mesh.mid.empty());
  for (const LayerWish& wish : options.wishes)
    OCTET_CHECK(!wish.heights.empty() && wish.heights.size() == options.wishes.front().heights.size());
  put_walls_first(mesh, options.wishes);
  return LayerMaker(mesh, model, options, observer).run();
}

}  // namespace octet
