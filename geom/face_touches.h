// SPDX-License-Identifier: BSD-3-Clause
// Faces that meet where the model has no edge and no vertex for it: a boundary that meets itself.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geom/model.h"

namespace octet {

/// Two faces without an edge in common that come together, elsewhere than at a vertex of both.
struct FaceTouch {
  std::array<int, 2> face{};  ///< tags
  Vec3 place = Vec3::Zero();  ///< on the first
  double distance = 0.0;      ///< of the second from there
};

/// Faces touch that come as near as this share of the model's diagonal.
inline constexpr double kTouchShare = 1e-7;

/// Where two faces come nearer than `near` to each other no farther than about `reach` from a place on the
/// first; nothing where they have an edge in common, where it is about a vertex of both (a thousandth of the
/// model's diagonal and twice its tolerance), or no such place is found. Tangent faces, whose distance
/// falls with the square of that from the contact, are followed as well as crossing ones.
[[nodiscard]] std::optional<FaceTouch> face_touch(const Model& model, const std::array<int, 2>& face,
                                                  const Vec3& place, double reach, double near);

/// A face and a place on it.
struct PlaceOnFace {
  int face = 0;
  Vec3 place = Vec3::Zero();
};

/// The touches among the faces of some places, each pair once, in the order of the places: from each place
/// the other faces that come as near as `reach` are tried. Faces have a few places tried each, and so many
/// pairs at most.
[[nodiscard]] std::vector<FaceTouch> face_touches(const Model& model, const std::vector<PlaceOnFace>& places,
                                                  double reach, double near);

/// The pairs of faces of one region that come nearer than `near`, each once, ascending: looked for wherever
/// facets come as near as their deviations allow, from a few places for each pair. A cusp between facets may
/// hide a touch; none is told in error.
[[nodiscard]] std::vector<FaceTouch> touching_faces(const Model& model, double near);

}  // namespace octet
