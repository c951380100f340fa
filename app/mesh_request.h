// SPDX-License-Identifier: BSD-3-Clause
// From a request to a mesh, whoever asks: nothing is printed or written.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/entity_groups.h"
#include "app/length_unit.h"
#include "app/mesh_file.h"
#include "mesh/model_outline.h"

namespace octet {

/// What of a request can be judged before the part is read.
struct MeshRequest {
  LengthUnit unit;
  MeshOptions options;
  ReadOptions reading;  ///< in millimetre
  std::vector<GroupWords> groups;
};

/// InputError for what makes no sense.
[[nodiscard]] MeshRequest request_of(const MeshCommand& command);

struct MadeMesh {
  Model model;
  MeshResult result;     ///< reading is among its times
  ModelOutline outline;  ///< for writers, with groups and links
};

/// The mesh of the part in the file. `solved`: a mesh that must be one of this part, if there is one. Throws
/// what mesh_file() throws.
[[nodiscard]] MadeMesh make_mesh(const std::filesystem::path& part, const MeshRequest& request,
                                 const std::optional<Mesh>& solved, Observer& observer);

}  // namespace octet
