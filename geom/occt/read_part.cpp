// SPDX-License-Identifier: BSD-3-Clause
// CAD files to a Model.
#include "geom/occt/read_part.h"

#include <utility>

#include "geom/occt/reader.h"

namespace octet {

Model read_part(const std::filesystem::path& path, const ReadOptions& options, const char* installed_reader) {
  ReadJob job;
  job.path = path;
  job.kind = file_kind(path);
  job.options = options;
  job.installed_reader = installed_reader;
  return read_model(std::move(job));
}

}  // namespace octet
