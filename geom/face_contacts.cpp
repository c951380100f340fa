// SPDX-License-Identifier: BSD-3-Clause
// Facets of one face are cut to those of the other, seen along their normals.
#include "geom/face_contacts.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "geom/box_tree.h"

namespace octet {
namespace {

/// Facets of faces that touch are turned against each other, but for what these bend between two corners.
constexpr double kBackToBack = -0.7;

struct Facet {
  std::array<Vec3, 3> corner;
  Vec3 normal;  ///< unit, out of the solid
  Box3 box;
};

struct OuterFace {
  int tag = 0;
  int region = 0;
  Box3 box;
  double facets_area = 0.0;
  std::vector<Facet> facets;
};

double distance_to_line(const Vec2& a, const Vec2& b, const Vec2& p) {
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

/// What of a polygon lies to the left of the line from a to b.
std::vector<Vec2> left_of(const std::vector<Vec2>& polygon, const Vec2& a, const Vec2& b) {
  std::vector<Vec2> left;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double dp = distance_to_line(a, b, p), dq = distance_to_line(a, b, q);
    if (dp >= 0.0) left.push_back(p);
    if ((dp > 0.0 && dq < 0.0) || (dp < 0.0 && dq > 0.0)) left.push_back(p + dp / (dp - dq) * (q - p));
  }
  return left;
}

struct Shared {
  double area = 0.0;
  Vec3 middle = Vec3::Zero();  ///< on the first facet
};

/// What two facets share, seen along the first's normal; nothing where they are farther apart there.
std::optional<Shared> shared_by(const Facet& first, const Facet& second, double near) {
  const Vec3 origin = first.corner[0];
  const Vec3 x = (first.corner[1] - origin).normalized(), y = first.normal.cross(x);
  const auto flat = [&](const Vec3& p) { return Vec2((p - origin).dot(x), (p - origin).dot(y)); };
  std::array<Vec2, 3> window{flat(first.corner[0]), flat(first.corner[1]), flat(first.corner[2])};
  if (distance_to_line(window[0], window[1], window[2]) < 0.0) std::swap(window[1], window[2]);
  std::vector<Vec2> polygon{flat(second.corner[0]), flat(second.corner[1]), flat(second.corner[2])};
  for (std::size_t k = 0; k < 3; ++k) polygon = left_of(polygon, window[k], window[(k + 1) % 3]);
  Shared shared;
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const double area = 0.5 * std::abs(distance_to_line(polygon[0], polygon[i - 1], polygon[i]));
    shared.area += area;
    sum += area / 3.0 * (polygon[0] + polygon[i - 1] + polygon[i]);
  }
  if (!(shared.area > 0.0)) return std::nullopt;
  const Vec2 at = sum / shared.area;
  shared.middle = origin + at.x() * x + at.y() * y;
  const double height =
      (second.corner[0] - shared.middle).dot(second.normal) / first.normal.dot(second.normal);
  if (std::abs(height) > near) return std::nullopt;
  return shared;
}

/// Faces with a region on one side only.
std::vector<OuterFace> outer_faces(const Model& model) {
  std::vector<OuterFace> faces(static_cast<std::size_t>(model.count(2)) + 1);
  for (int f = 1; f <= model.count(2); ++f) {
    const auto& sides = model.face(f).region;
    OuterFace& face = faces[static_cast<std::size_t>(f)];
    face.tag = f;
    if ((sides[0] == 0) != (sides[1] == 0)) face.region = std::max(sides[0], sides[1]);
  }
  const Facets& facets = model.facets();
  for (std::size_t t = 0; t < facets.triangles.size(); ++t) {
    OuterFace& face = faces[static_cast<std::size_t>(facets.face[t])];
    if (face.region == 0) continue;
    Facet facet;
    facet.corner = facet_corners(facets, t);
    const auto& [a, b, c] = facet.corner;
    for (const Vec3& p : facet.corner) facet.box.add(p);
    facet.normal = (b - a).cross(c - a).normalized();
    if (model.face(face.tag).region[0] == 0) facet.normal = -facet.normal;
    face.box.add(facet.box);
    face.facets_area += triangle_area(a, b, c);
    face.facets.push_back(facet);
  }
  std::erase_if(faces, [](const OuterFace& face) { return face.facets.empty(); });
  return faces;
}

class Pair {
 public:
  Pair(const Model& model, const OuterFace& first, const OuterFace& second)
      : model_(model), first_(first), second_(second) {
    const auto deviation = [&](int f) { return model.facets().deviation[static_cast<std::size_t>(f)]; };
    near_ = kContactShare * model.diagonal() + model.tolerance_of(model_face(first.tag)) +
            model.tolerance_of(model_face(second.tag));
    facets_near_ = near_ + deviation(first.tag) + deviation(second.tag);
  }

  [[nodiscard]] std::optional<FaceContact> contact() const {
    FaceContact contact{{first_.tag, second_.tag}, {first_.region, second_.region}, 0.0, Vec3::Zero()};
    const std::vector<const Facet*> others = facets_near(second_, first_.box);
    std::vector<Box3> boxes;
    for (const Facet* other : others) boxes.push_back(other->box);
    const BoxTree tree(boxes);
    double largest = 0.0;
    for (const Facet* facet : facets_near(first_, second_.box)) {
      std::vector<std::uint32_t> about;
      tree.visit_within(facet->box.centre(), 0.5 * facet->box.diagonal() + facets_near_,
                        [&](std::uint32_t i) { about.push_back(i); });
      std::sort(about.begin(), about.end());
      for (const std::uint32_t i : about) {
        if (facet->normal.dot(others[i]->normal) > kBackToBack) continue;
        const auto shared = shared_by(*facet, *others[i], facets_near_);
        if (!shared || !touch_at(shared->middle)) continue;
        contact.area += shared->area;
        if (shared->area <= largest) continue;
        largest = shared->area;
        contact.place = model_.face_closest(first_.tag, shared->middle).point;
      }
    }
    const OuterFace& smaller = first_.facets_area < second_.facets_area ? first_ : second_;
    const double area = model_.face(smaller.tag).area;
    contact.area = std::min(area, contact.area * area / smaller.facets_area);
    // Less is what rounding leaves of faces side by side.
    return contact.area > 10.0 * near_ * std::sqrt(area) ? std::optional(contact) : std::nullopt;
  }

 private:
  [[nodiscard]] std::vector<const Facet*> facets_near(const OuterFace& face, const Box3& box) const {
    std::vector<const Facet*> near;
    for (const Facet& facet : face.facets)
      if (box.grown(facets_near_).overlaps(facet.box)) near.push_back(&facet);
    return near;
  }

  [[nodiscard]] bool touch_at(const Vec3& middle) const {
    if (model_.is_plane(first_.tag) && model_.is_plane(second_.tag)) return true;
    const Vec3 p = model_.face_closest(first_.tag, middle).point;
    return model_.face_closest(second_.tag, p).distance <= near_;
  }

  const Model& model_;
  const OuterFace &first_, &second_;
  double near_ = 0.0, facets_near_ = 0.0;
};

}  // namespace

std::vector<FaceContact> face_contacts(const Model& model) {
  std::vector<FaceContact> contacts;
  if (model.count(3) < 2) return contacts;
  std::vector<OuterFace> faces = outer_faces(model);
  double reach = kContactShare * model.diagonal();
  for (const OuterFace& face : faces)
    reach =
        std::max(reach, 2.0 * (model.facets().deviation[static_cast<std::size_t>(face.tag)] +
                               kContactShare * model.diagonal() + model.tolerance_of(model_face(face.tag))));
  std::sort(faces.begin(), faces.end(),
            [](const OuterFace& a, const OuterFace& b) { return a.box.lo.x() < b.box.lo.x(); });
  for (auto i = faces.begin(); i != faces.end(); ++i)
    for (auto j = i + 1; j != faces.end() && j->box.lo.x() <= i->box.hi.x() + reach; ++j) {
      if (i->region == j->region || !i->box.grown(reach).overlaps(j->box)) continue;
      const auto& [a, b] =
          std::minmax(*i, *j, [](const OuterFace& f, const OuterFace& g) { return f.tag < g.tag; });
      if (const auto contact = Pair(model, a, b).contact()) contacts.push_back(*contact);
    }
  std::sort(contacts.begin(), contacts.end(),
            [](const FaceContact& a, const FaceContact& b) { return a.face < b.face; });
  return contacts;
}

}  // namespace octet
