// SPDX-License-Identifier: BSD-3-Clause
// Reads a part where OCCT can harm nobody.
#pragma once

#include <TopoDS_Shape.hxx>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "geom/model.h"
#include "geom/occt/child_process.h"
#include "geom/occt/file_kind.h"
#include "geom/occt/heal.h"
#include "geom/occt/part_piece.h"
#include "geom/occt/read_part.h"

namespace octet {

/// A file, or a shape in memory.
struct ReadJob {
  std::filesystem::path path;
  FileKind kind = FileKind::kStep;
  TopoDS_Shape shape;  ///< used when it is not null
  ReadOptions options;
  MeetingFaces meeting;                    ///< of a reading before
  std::optional<PieceWish> piece;          ///< wanted instead of a model
  std::filesystem::path installed_reader;  ///< the helper of the package that the caller was built with
};

/// The part. Where faces of one solid cross it is read once more, so that it becomes what it encloses; where
/// some touch, too, and they are imprinted on each other. Where its solids cannot be joined they are read
/// apart, and a fault of the model says so.
[[nodiscard]] Model read_model(const ReadJob& job);

/// What the job's piece is, likewise by a child process.
[[nodiscard]] PartPiece read_piece(const ReadJob& job);

/// All that makes a model, by a child process as ReadOptions says.
[[nodiscard]] ModelParts read_job(const ReadJob& job);

/// Of Octet and of OCCT: library and helper program understand each other when both are the same.
[[nodiscard]] std::string reader_version();

/// What the helper program does: a job as bytes to a part as bytes.
[[nodiscard]] std::string serve_job(std::string_view request, const StageLog& log);

}  // namespace octet
