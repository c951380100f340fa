// SPDX-License-Identifier: BSD-3-Clause
// Reports for people: text. Lengths are millimetre, angles degrees.
#pragma once

#include <string>
#include <vector>

#include "app/mesh_part.h"

namespace octet {

/// Entity, place, cause and advice.
[[nodiscard]] std::string fault_line(const Model& model, const Fault& fault);
/// One line of the shapes, under a name of at most eight letters.
[[nodiscard]] std::string quality_line(const char* name, const QualitySummary& quality);
/// The end of `octet mesh`: elements, quality, measures against the CAD, times, status, faults.
[[nodiscard]] std::string mesh_summary(const Model& model, const MeshReport& report);
/// `octet check`: every claim by name, with its worst places, and the faults beside them.
[[nodiscard]] std::string acceptance_summary(const Model& model, const Acceptance& acceptance,
                                             const std::vector<Fault>& beside);

}  // namespace octet
