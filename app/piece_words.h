// SPDX-License-Identifier: BSD-3-Clause
// Pieces of parts that users ask for, and those that are at fault.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/fault.h"
#include "geom/occt/part_piece.h"
#include "geom/size_attributes.h"

namespace octet {

/// By suffix: .brep, .brp, .step, .stp. InputError: another one.
[[nodiscard]] PieceFormat piece_format(const std::filesystem::path& path);

/// What places name, by numbers as read, each once. The part is read as a model only where a place needs it,
/// as names do, or `Face3`, which is as the model numbers it; where it is none (ModelError) numbers are those
/// as read. InputError where a place names nothing that the file has, and as read_part() does.
[[nodiscard]] std::vector<ModelRef> places_as_read(const std::filesystem::path& part,
                                                   const std::vector<SizeAttribute>& places,
                                                   const ReadOptions& reading);

/// What faults are about, by numbers as read, each once: of those of regions, the face nearest to the place.
[[nodiscard]] std::vector<ModelRef> faults_as_read(const Model& model, const std::vector<Fault>& faults);

/// Writes the piece; what it holds, in words: "Face 12 and 7 faces around".
[[nodiscard]] std::string write_piece(const std::filesystem::path& part, const PieceWish& wish,
                                      const ReadOptions& reading, const std::filesystem::path& output);

}  // namespace octet
