// SPDX-License-Identifier: BSD-3-Clause
// Faces are counted into buckets by their least vertex; the buckets (a dozen faces) are sorted one by one.
#include "mesh/face_uses.h"

#include <algorithm>
#include <utility>

namespace octet {
namespace {

// Face i is opposite vertex i; its normal points outwards of a positive tetrahedron.
constexpr int kOutwardFace[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

FaceUse face_use(const Mesh& mesh, std::size_t tet, int face) {
  const auto& t = mesh.tets[tet];
  const SortedFace sorted =
      sorted_face({t[kOutwardFace[face][0]], t[kOutwardFace[face][1]], t[kOutwardFace[face][2]]});
  return {sorted.v, static_cast<Mesh::Index>(tet), sorted.even};
}

bool before(const FaceUse& a, const FaceUse& b) {
  if (a.v != b.v) return a.v < b.v;
  return a.tet < b.tet;
}

auto all_tets(const Mesh& mesh) {
  return [&mesh](const auto& visit) {
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) visit(t);
  };
}

auto all_flagged(std::span<const std::uint8_t> flagged) {
  return [flagged](const std::array<Mesh::Index, 4>& t, int f) {
    return flagged[t[kOutwardFace[f][0]]] != 0 && flagged[t[kOutwardFace[f][1]]] != 0 &&
           flagged[t[kOutwardFace[f][2]]] != 0;
  };
}

}  // namespace

SortedFace sorted_face(const std::array<Mesh::Index, 3>& face) {
  SortedFace s{face, true};
  const auto order = [&s](int i, int j) {
    if (s.v[i] <= s.v[j]) return;
    std::swap(s.v[i], s.v[j]);
    s.even = !s.even;
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return s;
}

template <class ForEachTet, class Wanted>
void FaceUses::fill(const Mesh& mesh, const ForEachTet& for_each_tet, const Wanted& wanted) {
  // first_[v + 2] counts, then first_[v + 1] is the writing position of v, and ends as the start of v + 1.
  first_.assign(mesh.points.size() + 2, 0);
  const auto for_each = [&](const auto& take) {
    for_each_tet([&](std::size_t t) {
      for (int f = 0; f < 4; ++f)
        if (wanted(mesh.tets[t], f)) take(face_use(mesh, t, f));
    });
  };
  for_each([&](const FaceUse& use) { ++first_[use.v[0] + 2]; });
  for (std::size_t v = 2; v < first_.size(); ++v) first_[v] += first_[v - 1];
  uses_.resize(first_.back());
  for_each([&](const FaceUse& use) { uses_[first_[use.v[0] + 1]++] = use; });
  for (std::size_t v = 0; v + 1 < first_.size(); ++v)
    std::sort(uses_.begin() + first_[v], uses_.begin() + first_[v + 1], before);
}

FaceUses::FaceUses(const Mesh& mesh) {
  fill(mesh, all_tets(mesh), [](const auto&, int) { return true; });
}

FaceUses::FaceUses(const Mesh& mesh, std::span<const std::uint8_t> flagged) {
  fill(mesh, all_tets(mesh), all_flagged(flagged));
}

FaceUses::FaceUses(const Mesh& mesh, std::span<const std::uint8_t> flagged,
                   std::span<const Mesh::Index> tets) {
  const auto these = [&](const auto& visit) { std::for_each(tets.begin(), tets.end(), visit); };
  fill(mesh, these, all_flagged(flagged));
}

std::span<const FaceUse> FaceUses::find(const std::array<Mesh::Index, 3>& face) const {
  const auto key = sorted_face(face).v;
  const auto end = uses_.begin() + first_[key[0] + 1];
  const auto at = std::lower_bound(uses_.begin() + first_[key[0]], end, key,
                                   [](const FaceUse& use, const auto& k) { return use.v < k; });
  if (at == end || at->v != key) return {};
  return group(static_cast<std::size_t>(at - uses_.begin()));
}

std::span<const FaceUse> FaceUses::group(std::size_t i) const {
  std::size_t n = i + 1;
  while (n < uses_.size() && uses_[n].v == uses_[i].v) ++n;
  return {uses_.data() + i, n - i};
}

}  // namespace octet
