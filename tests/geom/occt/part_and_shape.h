// SPDX-License-Identifier: BSD-3-Clause
// A part as a Model, with the OCCT shapes behind its tags.
#pragma once

#include <filesystem>

#include "geom/model.h"
#include "geom/occt/assemble.h"
#include "geom/occt/silence.h"

namespace octet::test {

struct PartAndShape {
  Model model;
  Numbering numbering;
};

inline PartAndShape read_with_shape(const std::filesystem::path& path) {
  const OcctLock lock;
  const Silence silence;
  AssembledPart part = assemble(read_document(path, file_kind(path)), {}, {}, [](const std::string&) {});
  return {Model(std::move(part.parts)), std::move(part.numbering)};
}

}  // namespace octet::test
