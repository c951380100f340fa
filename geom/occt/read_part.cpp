// SPDX-License-Identifier: BSD-3-Clause
// CAD files to a Model.
#include "geom/occt/read_part.h"

#include "geom/occt/assemble.h"
#include "geom/occt/silence.h"

namespace octet {

Model read_part(const std::filesystem::path& path, const ReadOptions& options) {
  const FileKind kind = file_kind(path);
  const OcctLock lock;
  const Silence silence;
  return Model(assemble(read_document(path, kind), options));
}

}  // namespace octet
