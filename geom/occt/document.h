// SPDX-License-Identifier: BSD-3-Clause
// A CAD file to an OCCT shape with its names, colours and unit.
#pragma once

#include <TopoDS_Shape.hxx>
#include <filesystem>
#include <string>
#include <vector>

#include "geom/occt/file_kind.h"

namespace octet {

/// What the file says of a shape; sub-shapes are placed as in CadDocument::shape.
struct ShapeLabel {
  TopoDS_Shape shape;
  std::string name;    ///< empty: none
  std::string colour;  ///< "#rrggbb" or empty
};

struct CadDocument {
  TopoDS_Shape shape;  ///< lengths are millimetre
  std::string unit = "millimetre";
  std::vector<ShapeLabel> labels;  ///< outer ones first: a later label is more specific
};

/// Serial: OCCT's readers share global state (the caller holds the lock). Prints nothing.
/// InputError: the file cannot be read or holds no shape.
[[nodiscard]] CadDocument read_document(const std::filesystem::path& path, FileKind kind);

}  // namespace octet
