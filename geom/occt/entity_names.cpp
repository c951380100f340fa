// SPDX-License-Identifier: BSD-3-Clause
// Numbers as read, in words.
#include "geom/occt/entity_names.h"

#include <fmt/format.h>

#include <algorithm>

namespace octet {

std::string EntityNames::numbered(const char* kind, int dim, const TopoDS_Shape& shape) const {
  const int number = number_as_read(dim, shape, as_read_, set_);
  return number > 0 ? fmt::format("{} {}", kind, number) : fmt::format("a new {}", kind);
}

std::string EntityNames::listed(const char* kind, int dim, const std::vector<TopoDS_Shape>& shapes) const {
  constexpr std::size_t kMost = 20;
  std::string list;
  for (std::size_t i = 0; i < std::min(kMost, shapes.size()); ++i)
    list += (i > 0 ? ", " : "") + numbered(kind, dim, shapes[i]);
  if (shapes.size() > kMost) list += fmt::format(" and {} more", shapes.size() - kMost);
  return list;
}

}  // namespace octet
