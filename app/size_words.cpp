// SPDX-License-Identifier: BSD-3-Clause
// Words to numbers, in millimetre and radians.
#include "app/size_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "io/size_file.h"
#include "mesh/background.h"

namespace octet {
namespace {

double positive_length(const char* option, double value, const LengthUnit& unit) {
  if (!std::isfinite(value) || value <= 0.0)
    throw InputError(fmt::format("{} must be a positive length, not {}", option, value));
  return value * unit.millimetres;
}

double not_negative(const char* option, double value) {
  if (!std::isfinite(value) || value < 0.0)
    throw InputError(fmt::format("{} must be a number from 0, not {}", option, value));
  return value;
}

/// Radians an element from "12" (on a circle) or "20deg"; 0 for "0".
double curvature_angle(const std::string& text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  const std::string suffix(rest, end);
  if (error != std::errc() || (!suffix.empty() && suffix != "deg") || !std::isfinite(value) || value < 0.0)
    throw InputError(
        fmt::format("--curvature takes elements on a circle (12) or an angle (20deg), not \"{}\"", text));
  if (value == 0.0) return 0.0;
  const double angle = suffix.empty() ? 2.0 * M_PI / value : value * M_PI / 180.0;
  if (angle > M_PI) throw InputError("--curvature: an element may turn by 180 degrees at most");
  return angle;
}

void make_uniform(SizeControl& control) {
  control.curvature_angle = 0.0;
  control.wall_elements = control.gap_elements = 0.0;
  control.short_edges = control.small_regions = false;
}

}  // namespace

void apply_sizes(const SizeWords& words, const LengthUnit& unit, MeshOptions& options) {
  if (words.uniform) make_uniform(options);
  if (words.size) options.size = positive_length("--size", *words.size, unit);
  if (words.min_size) options.min_size = positive_length("--min-size", *words.min_size, unit);
  if (words.max_size) options.max_size = positive_length("--max-size", *words.max_size, unit);
  if (words.size && words.min_size && options.min_size > options.size)
    throw InputError(fmt::format("--min-size {} is larger than --size {}", *words.min_size, *words.size));
  if (words.max_size && words.min_size && options.min_size > options.max_size)
    throw InputError(
        fmt::format("--min-size {} is larger than --max-size {}", *words.min_size, *words.max_size));
  if (!words.curvature.empty()) {
    options.curvature_angle = curvature_angle(words.curvature);
    // Who asks for an angle means it on small radii too: only the smallest size holds it back.
    options.curvature_floor = std::numeric_limits<double>::min();
    options.suit_curvature = options.curvature_angle > 0.0;
  }
  if (words.wall_elements) options.wall_elements = not_negative("--wall-elements", *words.wall_elements);
  if (words.gap_elements) options.gap_elements = not_negative("--gap-elements", *words.gap_elements);
  if (words.wall_elements || words.gap_elements) options.wall_budget = 0.0;
  if (words.growth) {
    if (!(*words.growth > 1.0) || *words.growth > 2.0)
      throw InputError(fmt::format("--growth must lie above 1 and not above 2, not {}", *words.growth));
    options.growth = *words.growth;
  }
  if (words.target_elements) {
    if (!std::isfinite(*words.target_elements) || *words.target_elements < 1.0)
      throw InputError(fmt::format("--target-elements must be at least 1, not {}", *words.target_elements));
    options.target_elements = *words.target_elements;
  }
  for (const std::string& text : words.size_at)
    options.attributes.push_back(parse_size_attribute(text, unit.millimetres));
  for (const std::filesystem::path& path : words.fields) {
    const Background field = scaled(read_size_file(path, words.field_mesh), unit.millimetres);
    const std::vector<double>& sizes = field.tet_size.empty() ? field.point_size : field.tet_size;
    if (words.size_of_field && !words.size)
      options.size = std::max(options.size, *std::max_element(sizes.begin(), sizes.end()));
    options.background = smaller_of(std::move(options.background), background_field(field));
  }
}

}  // namespace octet
