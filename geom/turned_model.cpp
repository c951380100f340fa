// SPDX-License-Identifier: BSD-3-Clause
// Curves and surfaces are asked in their own coordinates, the answers turned.
#include "geom/turned_model.h"

#include <utility>

namespace octet {
namespace {

using Turn = Eigen::Matrix3d;

class TurnedSurface final : public Surface {
 public:
  TurnedSurface(std::shared_ptr<const Surface> base, const Turn& turn)
      : base_(std::move(base)), turn_(turn) {}

  SurfaceJet evaluate(const Vec2& uv, int derivatives) const override {
    SurfaceJet jet = base_->evaluate(uv, derivatives);
    for (Vec3* d : {&jet.p, &jet.du, &jet.dv, &jet.duu, &jet.duv, &jet.dvv}) *d = turn_ * *d;
    return jet;
  }
  void intersect(const Vec3& p, const Vec3& q, std::vector<SurfaceRoot>& roots) const override {
    base_->intersect(turn_.transpose() * p, turn_.transpose() * q, roots);
  }
  SurfaceFoot project(const Vec3& p, const Vec2& seed) const override {
    SurfaceFoot foot = base_->project(turn_.transpose() * p, seed);
    foot.point = turn_ * foot.point;
    return foot;
  }
  Vec3 normal(const Vec2& uv) const override { return turn_ * base_->normal(uv); }
  const char* kind() const override { return base_->kind(); }

 private:
  std::shared_ptr<const Surface> base_;
  Turn turn_;
};

class TurnedCurve final : public Curve {
 public:
  TurnedCurve(std::shared_ptr<const Curve> base, const Turn& turn) : base_(std::move(base)), turn_(turn) {}

  Vec3 point(double t) const override { return turn_ * base_->point(t); }
  Vec3 derivative(double t) const override { return turn_ * base_->derivative(t); }
  double project(const Vec3& p, double hint) const override {
    return base_->project(turn_.transpose() * p, hint);
  }
  void cut(const Vec3& normal, double offset, std::vector<double>& parameters) const override {
    base_->cut(turn_.transpose() * normal, offset, parameters);
  }
  std::vector<double> breaks() const override { return base_->breaks(); }
  const char* kind() const override { return base_->kind(); }

 private:
  std::shared_ptr<const Curve> base_;
  Turn turn_;
};

}  // namespace

Model turned_model(const Model& model, const Eigen::Matrix3d& turn) {
  ModelParts parts = model.parts();
  for (ModelVertex& vertex : parts.vertices) vertex.point = turn * vertex.point;
  for (Vec3& node : parts.facets.nodes) node = turn * node;
  for (auto& curve : parts.curves)
    if (curve) curve = std::make_shared<TurnedCurve>(std::move(curve), turn);
  for (auto& surface : parts.surfaces)
    if (surface) surface = std::make_shared<TurnedSurface>(std::move(surface), turn);
  return model.moved(std::move(parts));
}

}  // namespace octet
