// SPDX-License-Identifier: BSD-3-Clause
// CAD files to pieces of them.
#include "geom/occt/part_piece.h"

#include "geom/occt/reader.h"

namespace octet {

PartPiece read_piece(const std::filesystem::path& path, const PieceWish& wish, const ReadOptions& options,
                     const char* installed_reader) {
  ReadJob job;
  job.path = path;
  job.kind = file_kind(path);
  job.options = options;
  job.piece = wish;
  job.installed_reader = installed_reader;
  return read_piece(job);
}

}  // namespace octet
