// SPDX-License-Identifier: BSD-3-Clause
// Octant templates: the cache and its filling.
#include "delaunay/templates.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "base/check.h"
#include "base/vertex_order.h"
#include "delaunay/triangulation.h"

namespace octet {
namespace {

constexpr std::size_t kMaxPoints = kCornerPoint.size() + kHangingPoint.size();
constexpr std::uint8_t kNewClass = 128;

// The present points from the lowest rank to the highest, and 128 added to each that begins a new class of
// ranks: all that the tie-breaking of insphere_ranked() looks at.
struct Key {
  std::array<std::uint8_t, kMaxPoints> point{};
  std::uint8_t count = 0;

  bool operator==(const Key&) const = default;
};

struct KeyHash {
  std::size_t operator()(const Key& key) const {
    const auto* bytes = reinterpret_cast<const char*>(key.point.data());
    return std::hash<std::string_view>()({bytes, key.count});
  }
};

Key key_of(const OctantPattern& pattern) {
  Key key;
  const auto add = [&](std::uint8_t point) {
    int at = key.count++;
    for (; at > 0 && pattern.rank[key.point[at - 1]] > pattern.rank[point]; --at) {
      key.point[at] = key.point[at - 1];
    }
    key.point[at] = point;
  };
  for (const std::uint8_t corner : kCornerPoint) add(corner);
  for (std::size_t bit = 0; bit < kHangingPoint.size(); ++bit) {
    if (((pattern.hanging >> bit) & 1u) != 0) add(kHangingPoint[bit]);
  }
  std::uint64_t last = pattern.rank[key.point[0]] >> kRankClassShift;
  for (int i = 1; i < key.count; ++i) {
    const std::uint64_t next = pattern.rank[key.point[i]] >> kRankClassShift;
    if (next != last) key.point[i] |= kNewClass;
    last = next;
  }
  return key;
}

Vec3 local_position(int point) { return Vec3(point % 3, point / 3 % 3, point / 9); }

// Rotates the smallest number to the front, then the smallest of the rest to the second place: both are even
// permutations, so the tetrahedron stays positive.
std::array<std::uint8_t, 4> canonical(std::array<std::uint8_t, 4> t) {
  const auto first = std::min_element(t.begin(), t.end()) - t.begin();
  if (first != 0) {
    std::swap(t[0], t[first]);
    const auto other = first == 1 ? 2 : 1;
    std::swap(t[other], t[first == 3 ? 2 : 3]);
  }
  const auto second = std::min_element(t.begin() + 1, t.end());
  std::rotate(t.begin() + 1, second, t.end());
  return t;
}

OctantTets triangulate(const Key& key) {
  std::vector<Vec3> points;
  std::vector<std::uint64_t> ranks;
  std::array<std::uint8_t, kMaxPoints> number{};
  std::uint64_t rank_class = 0;
  for (std::uint64_t i = 0; i < key.count; ++i) {
    rank_class += (key.point[i] & kNewClass) != 0 ? 1 : 0;
    number[i] = key.point[i] & ~kNewClass;
    points.push_back(local_position(number[i]));
    ranks.push_back((rank_class << kRankClassShift) | i);
  }
  Triangulation triangulation;
  triangulation.insert_all(points, ranks);
  const TetMesh& mesh = triangulation.mesh();
  OctantTets tets;
  double volume = 0;
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const TetId t(i);
    if (!mesh.alive(t) || mesh.ghost(t)) continue;
    const auto& v = mesh.tets[t];
    std::array<std::uint8_t, 4> local{};
    for (int k = 0; k < 4; ++k) local[k] = number[v[k].index()];
    tets.push_back(canonical(local));
    const Vec3& a = mesh.points[v[0]];
    volume += (mesh.points[v[1]] - a).cross(mesh.points[v[2]] - a).dot(mesh.points[v[3]] - a);
  }
  OCTET_CHECK(volume == 6 * 8);  // small integers: exact
  std::sort(tets.begin(), tets.end());
  return tets;
}

}  // namespace

struct TemplateTable::Data {
  std::unordered_map<Key, OctantTets, KeyHash> tets;
};

TemplateTable::TemplateTable() : data_(std::make_unique<Data>()) {}
TemplateTable::~TemplateTable() = default;

const OctantTets& TemplateTable::tets(const OctantPattern& pattern) {
  const Key key = key_of(pattern);
  const auto found = data_->tets.find(key);
  if (found != data_->tets.end()) return found->second;
  return data_->tets.emplace(key, triangulate(key)).first->second;
}

std::size_t TemplateTable::size() const { return data_->tets.size(); }

}  // namespace octet
