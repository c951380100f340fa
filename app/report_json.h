// SPDX-License-Identifier: BSD-3-Clause
// Reports for programs: JSON text. Lengths are millimetre, angles degrees.
#pragma once

#include <string>
#include <vector>

#include "app/mesh_part.h"

namespace octet {

/// Which run a report is about.
struct RunNames {
  std::string part;
  std::string mesh;
  std::string mesh_unit;              ///< of the mesh files' coordinates
  std::vector<std::string> copies{};  ///< further files of the same mesh
};

[[nodiscard]] std::string mesh_report_json(const RunNames& names, const Model& model,
                                           const MeshReport& report);
/// The report of a run that ended without a mesh.
[[nodiscard]] std::string failure_json(const RunNames& names, const std::string& message);
/// With the faults beside those of the claims.
[[nodiscard]] std::string acceptance_json(const RunNames& names, const Model& model,
                                          const Acceptance& acceptance, const std::vector<Fault>& beside);

}  // namespace octet
