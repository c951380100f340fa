// SPDX-License-Identifier: BSD-3-Clause
// The sample parts of models/.
#pragma once

#include <filesystem>
#include <string>

#include "geom/occt/read_part.h"

namespace octet::test {

inline std::filesystem::path sample_path(const std::string& name) {
  return std::filesystem::path(OCTET_MODELS) / (name + ".step");
}

inline Model sample(const std::string& name) { return read_part(sample_path(name)); }

inline int count_edges(const Model& model, EdgeUse use) {
  int count = 0;
  for (int tag = 1; tag <= model.count(1); ++tag) count += model.edge(tag).use == use ? 1 : 0;
  return count;
}

}  // namespace octet::test
