// SPDX-License-Identifier: BSD-3-Clause
// A size field for a look at it, and as a field for another mesh.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "base/vec.h"

namespace octet {

/// Boxes with the size in each.
struct SizeBoxes {
  std::vector<Vec3> points;
  std::vector<std::array<std::uint32_t, 8>> boxes;  ///< corners, x fastest, then y
  std::vector<double> size;                         ///< edge length, per box
};

/// VTU with voxels and the cell array "size"; read_size_file() takes it. Lengths are multiplied by `scale`.
/// OutputError when it cannot be written.
void write_size_field(const std::filesystem::path& path, const SizeBoxes& field, double scale);

}  // namespace octet
