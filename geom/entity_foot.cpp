// SPDX-License-Identifier: BSD-3-Clause
// One exact query for each dimension.
#include "geom/entity_foot.h"

#include <limits>

namespace octet {

EntityFoot entity_foot(const Model& model, ModelRef entity, const Vec3& p) {
  EntityFoot best{p, std::numeric_limits<double>::infinity()};
  switch (entity.dim) {
    case 0: {
      const Vec3& point = model.vertex(entity.tag).point;
      return {point, (point - p).norm()};
    }
    case 1: {
      if (model.edge(entity.tag).use == EdgeUse::kDegenerate) return best;
      const EdgeFoot foot = model.edge_closest(entity.tag, p);
      return {foot.point, foot.distance};
    }
    case 2: {
      const Foot foot = model.face_closest(entity.tag, p);
      return {foot.point, foot.distance};
    }
    default: {
      if (model.region_at(p) == entity.tag) return {p, 0.0};
      for (const int f : model.region(entity.tag).faces) {
        const Foot foot = model.face_closest(f, p);
        if (foot.distance < best.distance) best = {foot.point, foot.distance};
      }
      return best;
    }
  }
}

}  // namespace octet
