// SPDX-License-Identifier: BSD-3-Clause
// The direction in which two faces come together, and a line search along it.
#include "geom/face_touches.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "base/golden_section.h"
#include "geom/shared_bounds.h"
#include "geom/touch_places.h"

namespace octet {
namespace {

constexpr int kPlacesPerFace = 6;
constexpr std::size_t kMostFaces = 400;

std::array<int, 2> pair_of(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

class Approach {
 public:
  Approach(const Model& model, const std::array<int, 2>& face, const Vec3& place)
      : model_(model), face_(face), at_(model.face_closest(face[0], place).point) {
    other_ = model_.face_closest(face_[1], at_);
  }

  [[nodiscard]] const Vec3& place() const { return at_; }
  [[nodiscard]] double distance() const { return other_.distance; }

  /// To the nearest place along the way on which going back and forth between the faces sets out. False where
  /// that leads nowhere.
  bool step(double reach) {
    const Vec3 way = model_.face_closest(face_[0], other_.point).point - at_;
    if (!(way.norm() > 0.0)) return false;
    const Vec3 start = at_, along = way.normalized();
    constexpr int kCuts = 30;
    (void)golden_section(0.0, reach, kCuts,
                         [&](double way_along) { return try_at(start + way_along * along); });
    return at_ != start;
  }

 private:
  /// The distance beside a place; the nearest is kept.
  double try_at(const Vec3& p) {
    const Vec3 on = model_.face_closest(face_[0], p).point;
    const Foot foot = model_.face_closest(face_[1], on);
    if (foot.distance < other_.distance) {
      at_ = on;
      other_ = foot;
    }
    return foot.distance;
  }

  const Model& model_;
  std::array<int, 2> face_;
  Vec3 at_;
  Foot other_;  ///< of at_ on the second face
};

}  // namespace

std::optional<FaceTouch> face_touch(const Model& model, const std::array<int, 2>& face, const Vec3& place,
                                    double reach, double near) {
  if (face[0] == face[1] || have_common_edge(model.face(face[0]), model.face(face[1]))) return std::nullopt;
  constexpr int kSteps = 6;
  Approach approach(model, face, place);
  constexpr double kProgress = 0.9;  // a step that leaves more of the distance has found its least
  for (int i = 0; i < kSteps && approach.distance() > near; ++i) {
    const double before = approach.distance();
    if (!approach.step(reach) || approach.distance() > kProgress * before) break;
  }
  if (approach.distance() > near) return std::nullopt;
  for (const Ball& ball : about_common_vertices(model, face))
    if ((approach.place() - ball.centre).norm() < ball.radius) return std::nullopt;
  return FaceTouch{face, approach.place(), approach.distance()};
}

std::vector<FaceTouch> face_touches(const Model& model, const std::vector<PlaceOnFace>& places, double reach,
                                    double near) {
  std::map<int, int> tried;  // faces, and how many places of theirs
  for (const PlaceOnFace& at : places)
    if (tried.size() < kMostFaces) tried.try_emplace(at.face, 0);
  std::vector<FaceTouch> found;
  std::set<std::array<int, 2>> known;
  for (const PlaceOnFace& at : places) {
    const auto count = tried.find(at.face);
    if (count == tried.end() || count->second++ >= kPlacesPerFace) continue;
    for (const auto& [other, unused] : tried) {
      if (other == at.face || known.count(pair_of(at.face, other)) > 0) continue;
      if (model.face_closest(other, at.place).distance > reach) continue;
      const auto touch = face_touch(model, {at.face, other}, at.place, reach, near);
      if (!touch) continue;
      known.insert(pair_of(at.face, other));
      found.push_back(*touch);
    }
  }
  return found;
}

std::vector<FaceTouch> touching_faces(const Model& model, double near) {
  constexpr int kMostTries = 3000;  // each may take milliseconds
  std::vector<FaceTouch> found;
  int tries = 0;
  for (const auto& [pair, of_pair] : touch_places(model, near))
    for (const TouchPlace& place : of_pair) {
      if (++tries > kMostTries) return found;
      const auto touch = face_touch(model, place.face, place.at, place.reach, near);
      if (!touch) continue;
      found.push_back(*touch);
      break;
    }
  return found;
}

}  // namespace octet
