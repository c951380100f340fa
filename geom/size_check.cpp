// SPDX-License-Identifier: BSD-3-Clause
// Controls and attributes may come from programs, which no parser has seen.
#include "geom/size_check.h"

#include <cmath>
#include <string>
#include <utility>

#include "base/error.h"

namespace octet {
namespace {

using Where = SizeAttribute::Where;

void check_number(const char* name, double value) {
  if (!std::isfinite(value) || value < 0.0)
    throw InputError(std::string("the ") + name + " must be a positive number, or 0 for none");
}

[[noreturn]] void refuse(const SizeAttribute& attribute, const std::string& why) {
  throw InputError((attribute.text.empty() ? "a size attribute" : "size attribute \"" + attribute.text + "\"")
                       .append(": ")
                       .append(why));
}

bool is_length(double value) { return std::isfinite(value) && value > 0.0; }

void check_dimension(const SizeAttribute& attribute) {
  const int dim = attribute.dim;
  if (attribute.where == Where::kColour && dim != 2)
    refuse(attribute, "only faces (dimension 2) have colours");
  const int least = attribute.where == Where::kName ? -1 : 0;
  if (dim < least || dim > 3)
    refuse(attribute,
           "its dimension must be one from 0 (vertices) to 3 (regions), not " + std::to_string(dim));
}

void check_shape(const SizeAttribute& attribute) {
  if (!attribute.a.allFinite() || !attribute.b.allFinite()) refuse(attribute, "its places must be numbers");
  if (attribute.where != Where::kBox && !is_length(attribute.radius))
    refuse(attribute, "the radius must be a positive length");
  if (attribute.where == Where::kBox && (attribute.a.array() > attribute.b.array()).any())
    refuse(attribute, "no coordinate of the box's first corner may be above the second's");
}

void check_attribute(const SizeAttribute& attribute) {
  const Where where = attribute.where;
  const bool in_space = is_shape(where);
  if (in_space)
    check_shape(attribute);
  else
    check_dimension(attribute);
  if (where == Where::kNearest && !attribute.a.allFinite()) refuse(attribute, "its place must be numbers");
  if (attribute.elements < 0) refuse(attribute, "a number of elements is a whole number from 1");
  if (attribute.elements > 0 && (in_space || attribute.dim != 1))
    refuse(attribute, "numbers of elements are for edges");
  if (attribute.elements == 0 && !is_length(attribute.size))
    refuse(attribute, "the size must be a positive length");
}

}  // namespace

void check_control(const SizeControl& control) {
  check_number("size", control.size);
  check_number("smallest size", control.min_size);
  check_number("largest size", control.max_size);
  check_number("angle per element", control.curvature_angle);
  check_number("curvature floor", control.curvature_floor);
  check_number("number of elements across walls", control.wall_elements);
  check_number("number of elements across gaps", control.gap_elements);
  check_number("scale of small regions", control.region_scale);
  check_number("number of elements that walls may cost", control.wall_budget);
  if (!(control.growth > 1.0) || !std::isfinite(control.growth))
    throw InputError("the growth must be a number above 1");
  if (control.max_size > 0.0 && control.min_size > control.max_size)
    throw InputError("the smallest size is above the largest");
  for (const SizeAttribute& attribute : control.attributes) check_attribute(attribute);
}

SizeField checked(SizeField field) {
  if (!field) return field;
  return [field = std::move(field)](const Box3& box) {
    const double size = field(box);
    if (!(size > 0.0)) {
      const Vec3 at = box.centre();
      throw InputError("a size over space must be a positive number, not " + std::to_string(size) + ": at (" +
                       std::to_string(at.x()) + ", " + std::to_string(at.y()) + ", " +
                       std::to_string(at.z()) + ")");
    }
    return size;
  };
}

}  // namespace octet
