// SPDX-License-Identifier: BSD-3-Clause
// Wishes for sizes that can hardly be meant so, or are not met.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/mesh_part.h"

namespace octet {

/// Tells the observer, and adds to the report's notes, a line for each wish that has no effect on the part or
/// means something far from it: a size longer than the part's diagonal, a shape or a field that lies wholly
/// outside of its box, a point to be nearest to that is farther from that box than a tenth of the diagonal.
void add_size_notes(const Model& model, const MeshOptions& options, Observer& observer, MeshReport& report);

/// That walls get fewer elements across than asked for; none where they get them, where the user's smallest
/// size is why, or where one is asked for. Its place is the model's that was measured.
[[nodiscard]] std::optional<Fault> warning_of(const ThinnestWall& wall, const SizeControl& control);

/// The lines of add_size_notes() alone.
[[nodiscard]] std::vector<std::string> size_notes(const Model& model, const MeshOptions& options);

}  // namespace octet
