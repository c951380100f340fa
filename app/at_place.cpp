// SPDX-License-Identifier: BSD-3-Clause
// All entities are asked, as for the sizes of Face@x,y,z.
#include "app/at_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "base/error.h"
#include "geom/bodies.h"
#include "geom/entity_foot.h"
#include "geom/number_list.h"

namespace octet {
namespace {

constexpr double kSamePlace = 1e-6;  // of the diagonal: numbers that people copy have six digits

std::vector<NearEntity> nearest(const Model& model, int dim, const Vec3& place) {
  std::vector<NearEntity> all;
  double least = std::numeric_limits<double>::infinity();
  for (int tag = 1; tag <= model.count(dim); ++tag) {
    const EntityFoot foot = entity_foot(model, {dim, tag}, place);
    all.push_back({{dim, tag}, foot.distance <= model.tolerance() ? 0.0 : foot.distance, foot.point});
    least = std::min(least, foot.distance);
  }
  const double near = kSamePlace * model.diagonal();
  std::erase_if(all, [&](const NearEntity& item) {
    return !(item.distance <= least + near + model.tolerance_of(item.entity));
  });
  return all;
}

/// Regions that have the entity in their closure.
void add_regions_about(const Model& model, ModelRef entity, std::set<int>& regions) {
  for (int r = 1; r <= model.count(3); ++r)
    if (model.in_closure(entity, model_region(r))) regions.insert(r);
}

/// Bodies that are kept apart may overlap, so each is asked.
void add_holders(const Model& model, const Vec3& place, std::set<int>& regions) {
  if (!model.parts().apart) {
    regions.insert(model.region_at(place));
    return;
  }
  for (const Model& body : take_apart(model))
    if (const int r = body.region_at(place); r > 0)
      regions.insert(body.parts().whole_tag[3][static_cast<std::size_t>(r)]);
}

bool is_seam(const Model& model, ModelRef entity) {
  return entity.dim == 1 && model.edge(entity.tag).use == EdgeUse::kSeam;
}

}  // namespace

Vec3 parse_place(const std::string& text, double unit) {
  const auto values = number_list(text);
  if (!values || values->size() != 3)
    throw InputError(fmt::format("--at takes a place like 10,0,5, not \"{}\"", text));
  return unit * Vec3((*values)[0], (*values)[1], (*values)[2]);
}

AtPlace at_place(const Model& model, const Vec3& place) {
  AtPlace at;
  at.place = place;
  std::set<int> regions;
  for (const int dim : {2, 1, 0})
    for (const NearEntity& item : nearest(model, dim, place)) {
      at.nearest.push_back(item);
      if (item.distance > kSamePlace * model.diagonal() + model.tolerance_of(item.entity)) continue;
      add_regions_about(model, item.entity, regions);
      if (!is_seam(model, item.entity) && (!at.on.valid() || item.entity.dim < at.on.dim))
        at.on = item.entity;
    }
  if (!at.on.valid() || model.parts().apart) add_holders(model, place, regions);
  regions.erase(0);
  at.regions.assign(regions.begin(), regions.end());
  return at;
}

}  // namespace octet
