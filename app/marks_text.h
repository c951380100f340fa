// SPDX-License-Identifier: BSD-3-Clause
// Colours, layers and materials behind the name of what has them.
#pragma once

#include <fmt/format.h>

#include <string>

namespace octet {

inline std::string marks_text(const std::string& colour, const std::string& layer) {
  std::string text;
  if (!colour.empty()) text += " " + colour;
  if (!layer.empty()) text += fmt::format(" layer \"{}\"", layer);
  return text;
}

inline std::string material_text(const std::string& material, double density) {
  if (material.empty()) return {};
  if (density <= 0.0) return fmt::format(" material \"{}\"", material);
  return fmt::format(" material \"{}\" ({:.6g} g/cm^3)", material, density);
}

}  // namespace octet
