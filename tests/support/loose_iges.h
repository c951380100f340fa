// SPDX-License-Identifier: BSD-3-Clause
// IGES files that hold nothing but faces, as most do.
#pragma once

#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <TopoDS_Shape.hxx>
#include <filesystem>

#include "geom/occt/silence.h"

namespace octet::test {

/// The faces of the shape, in no shell; false where OCCT cannot write them.
[[nodiscard]] inline bool write_loose_iges(const TopoDS_Shape& shape, const std::filesystem::path& path) {
  const Silence silence;
  IGESControl_Controller::Init();
  IGESControl_Writer writer("MM", 0);
  return writer.AddShape(shape) && writer.Write(path.c_str());
}

}  // namespace octet::test
