// SPDX-License-Identifier: BSD-3-Clause
// The numbers by which the CAD file itself knows entities of a model.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "geom/model.h"

namespace octet {

/// Refers to the model, and looks through its numbers once.
class IdsInFile {
 public:
  explicit IdsInFile(const Model& model);

  /// "#4711" of a STEP file, "D17" of an IGES file (the line of the directory entry); several where several
  /// entities of the file became one. Empty: the file has none, or the entity is none of the model.
  [[nodiscard]] std::vector<std::string> of(ModelRef entity) const;
  /// " (#4711, #4720)", " (#1, #2 and 7 more)" or "".
  [[nodiscard]] std::string text(ModelRef entity) const;

 private:
  const Model& model_;
  std::array<std::vector<std::vector<int>>, 4> sources_;  ///< by dimension and tag; empty: no ids
};

}  // namespace octet
