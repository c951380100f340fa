// SPDX-License-Identifier: BSD-3-Clause
// CAD files to a Model. No OCCT type appears here.
#pragma once

#include <filesystem>
#include <string>

#include "geom/model.h"

namespace octet {

struct ReadOptions {
  double facet_deflection =
      0.0;  ///< model units; 0: chosen from the part (diagonal / 2000, finer where curved)
};

/// Reads STEP (AP203, AP214, AP242), IGES or OCCT BREP, told by content, not by suffix.
/// Coordinates become millimetre; the file's unit is Model::unit().
/// InputError: missing, a directory, empty, truncated, not a CAD file, no shape in it.
/// ModelError: nothing that bounds a volume (open shell: names the first free edge, its faces and place).
[[nodiscard]] Model read_part(const std::filesystem::path& path, const ReadOptions& options = {});

}  // namespace octet
