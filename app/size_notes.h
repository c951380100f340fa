// SPDX-License-Identifier: BSD-3-Clause
// Wishes for sizes that can hardly be meant so.
#pragma once

#include "app/mesh_part.h"

namespace octet {

/// Tells the observer, and adds to the report's notes, a line for each wish that has no effect on the part or
/// means something far from it: a size longer than the part's diagonal, a shape or a field that lies wholly
/// outside of its box, a point to be nearest to that is farther from that box than a tenth of the diagonal.
void add_size_notes(const Model& model, const MeshOptions& options, Observer& observer, MeshReport& report);

/// The lines alone.
[[nodiscard]] std::vector<std::string> size_notes(const Model& model, const MeshOptions& options);

}  // namespace octet
