// SPDX-License-Identifier: BSD-3-Clause
// Entities as notes name them: by their numbers as read.
#pragma once

#include <TopoDS_Shape.hxx>

#include <string>
#include <vector>

#include "geom/occt/solids.h"

namespace octet {

/// Refers to both; the names follow what happens to the solids.
class EntityNames {
 public:
  EntityNames(const ShapeMaps& as_read, const SolidSet& set) : as_read_(as_read), set_(set) {}

  /// `kind` and the number as read of a shape of that dimension: "Face 12", "a new Face".
  [[nodiscard]] std::string numbered(const char* kind, int dim, const TopoDS_Shape& shape) const;
  [[nodiscard]] std::string solid(const TopoDS_Shape& solid) const { return numbered("Solid", 3, solid); }
  /// The first twenty, and how many more there are.
  [[nodiscard]] std::string listed(const char* kind, int dim, const std::vector<TopoDS_Shape>& shapes) const;

 private:
  const ShapeMaps& as_read_;
  const SolidSet& set_;
};

}  // namespace octet
