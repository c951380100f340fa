// SPDX-License-Identifier: BSD-3-Clause
// Sizes as the user says them, on the command line or in a file, and what they mean.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/length_unit.h"
#include "app/mesh_part.h"

namespace octet {

/// Lengths in the user's unit; what is not said is left to the defaults of SizeControl.
struct SizeWords {
  std::optional<double> size, min_size, max_size;
  std::string curvature;  ///< elements on a circle ("12"), or an angle ("20deg"); "0": off
  std::optional<double> wall_elements, gap_elements, growth, target_elements;
  std::vector<std::string> size_at;
  std::vector<std::filesystem::path> fields;  ///< size files (io/size_file.h)
  std::filesystem::path field_mesh;           ///< the mesh whose elements they count; may be empty
  bool size_of_field = false;                 ///< without a size, the fields' largest is the size
  bool uniform = false;                       ///< nothing for the part's own sake
};

/// The options with the sizes set; fields are read. InputError for what makes no sense.
void apply_sizes(const SizeWords& words, const LengthUnit& unit, MeshOptions& options);

}  // namespace octet
