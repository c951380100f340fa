// SPDX-License-Identifier: BSD-3-Clause
// Places on one face, and their feet on the surface of the other.
#include "geom/occt/near_faces.h"

#include <BRepTools.hxx>
#include <algorithm>
#include <memory>
#include <optional>
#include <string_view>

#include "base/error.h"
#include "geom/occt/canonical.h"
#include "geom/occt/face_trim.h"
#include "geom/occt/shape_box.h"

namespace octet {
namespace {

/// Places along either parameter of a face.
constexpr int kPlacesEachWay = 6;

/// The surface of a face if it is a closed form, be it written as something else; null if not.
std::shared_ptr<const Surface> closed_form(const TopoDS_Face& face) {
  std::shared_ptr<const Surface> surface;
  try {
    surface = make_surface(face, 0);
  } catch (const ModelError&) {
    return nullptr;  // it will be told of with the face's number
  }
  const std::string_view kind = surface->kind();
  const bool closed =
      kind == "plane" || kind == "cylinder" || kind == "cone" || kind == "sphere" || kind == "torus";
  return closed ? surface : nullptr;
}

/// A face with what is asked of it, made when it is first asked.
class Sheet {
 public:
  Sheet(const FaceOfSolid& of, std::shared_ptr<const Surface> surface, double near)
      : of_(of), surface_(std::move(surface)), box_(box_of(of.face)) {
    box_.Enlarge(near);
  }

  [[nodiscard]] std::size_t solid() const { return of_.solid; }
  [[nodiscard]] const Bnd_Box& box() const { return box_; }
  [[nodiscard]] std::string_view kind() const { return surface_->kind(); }

  /// The distance of a place that lies over the face.
  std::optional<double> distance(const Vec3& p) {
    if (box_.IsOut(gp_Pnt(p.x(), p.y(), p.z()))) return std::nullopt;
    const SurfaceFoot foot = surface_->project(p, Vec2::Zero());
    if (!foot.converged || !holds(foot.uv)) return std::nullopt;
    return (foot.point - p).norm();
  }

  const std::vector<Vec3>& places() {
    if (places_) return *places_;
    places_.emplace();
    const auto from_occt = from_occt_uv(*surface_);
    double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
    BRepTools::UVBounds(of_.face, u0, u1, v0, v1);
    for (int i = 0; i < kPlacesEachWay; ++i)
      for (int j = 0; j < kPlacesEachWay; ++j) {
        const Vec2 uv = from_occt(
            Vec2(u0 + (u1 - u0) * (i + 0.5) / kPlacesEachWay, v0 + (v1 - v0) * (j + 0.5) / kPlacesEachWay));
        if (holds(uv)) places_->push_back(surface_->evaluate(uv, 0).p);
      }
    return *places_;
  }

 private:
  bool holds(const Vec2& uv) {
    if (!trim_) trim_ = make_trim(of_.face, *surface_);
    return trim_->side(uv) == TrimSide::kIn;
  }

  FaceOfSolid of_;
  std::shared_ptr<const Surface> surface_;
  Bnd_Box box_;
  std::shared_ptr<const Trim> trim_;
  std::optional<std::vector<Vec3>> places_;
};

/// The widest distance between places of either that lie over the other and these; none where there are no
/// such places, or it is not less than `near`.
std::optional<double> widest_distance(Sheet& a, Sheet& b, double near) {
  std::optional<double> widest;
  const auto all_near = [&](Sheet& from, Sheet& to) {
    return std::all_of(from.places().begin(), from.places().end(), [&](const Vec3& p) {
      const std::optional<double> distance = to.distance(p);
      if (distance) widest = std::max(widest.value_or(0.0), *distance);
      return !distance || *distance < near;
    });
  };
  return all_near(a, b) && all_near(b, a) ? widest : std::nullopt;
}

}  // namespace

NearFaces near_faces(const std::vector<FaceOfSolid>& faces, double near) {
  std::vector<Sheet> sheets;
  for (const FaceOfSolid& of : faces)
    if (auto surface = closed_form(of.face)) sheets.emplace_back(of, std::move(surface), near);
  const auto low = [](const Sheet& sheet) { return sheet.box().CornerMin().X(); };
  std::sort(sheets.begin(), sheets.end(), [&](const Sheet& a, const Sheet& b) { return low(a) < low(b); });
  NearFaces found;
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const double high = sheets[i].box().CornerMax().X();
    for (std::size_t j = i + 1; j < sheets.size() && low(sheets[j]) <= high; ++j) {
      if (sheets[i].solid() == sheets[j].solid() || sheets[i].kind() != sheets[j].kind()) continue;
      if (sheets[i].box().IsOut(sheets[j].box())) continue;
      const std::optional<double> distance = widest_distance(sheets[i], sheets[j], near);
      if (!distance) continue;
      ++found.count;
      found.narrowest = std::min(found.narrowest, *distance);
    }
  }
  return found;
}

}  // namespace octet
