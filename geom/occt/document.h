// SPDX-License-Identifier: BSD-3-Clause
// A CAD file to an OCCT shape with its tree of parts, its labels and its unit.
#pragma once

#include <TopoDS_Shape.hxx>
#include <filesystem>
#include <string>
#include <vector>

#include "geom/occt/file_ids.h"
#include "geom/occt/file_kind.h"
#include "geom/provenance.h"

namespace octet {

/// What a file says of a shape beside its geometry. Empty: nothing.
struct Marks {
  std::string name, colour, layer;  ///< colour "#rrggbb"; several layers separated by ", "
  std::string material;
  double density = 0.0;  ///< g/cm^3
};

/// Sub-shapes are placed as in CadDocument::shape.
struct ShapeLabel {
  TopoDS_Shape shape;
  Marks marks;
  bool is_assembly = false;  ///< its name is not that of the parts in it
};

/// A node of the tree of parts and its placed shape. Node::solids is filled when the solids have numbers.
struct PlacedPart {
  PartNode node;
  TopoDS_Shape shape;
};

struct CadDocument {
  TopoDS_Shape shape;  ///< lengths are millimetre
  std::string unit = "millimetre";
  double accuracy = 0.0;           ///< stated_accuracy(), mm
  std::vector<ShapeLabel> labels;  ///< outer ones first: a later label is more specific
  std::vector<PlacedPart> tree;    ///< outer ones first
  std::vector<FileId> ids;  ///< wherever the shapes are placed; of several for one shape the last counts
  std::string id_mark;      ///< Provenance::id_mark
  std::vector<std::string> notes;  ///< what was passed over
};

/// How OCCT's reader takes an IGES file.
struct IgesReading {
  double precision = 0.0;  ///< within which curves are joined, mm; 0: what the file states
  bool in_space = false;   ///< by the curves in space alone; else by those on surfaces, too
};

/// Serial: OCCT's readers share global state (the caller holds the lock). Prints nothing. An IGES file of
/// whose faces one comes out without anything inside is read by the first of other_readings() with a
/// precision with which none does. InputError: the file cannot be read or holds no shape.
[[nodiscard]] CadDocument read_document(const std::filesystem::path& path, FileKind kind,
                                        const IgesReading& how = {});

/// How else to read an IGES file whose faces are no faces, or bound nothing: with coarser precisions, the
/// finest first, then by the curves in space. `shape`: as it came out.
[[nodiscard]] std::vector<IgesReading> other_readings(const TopoDS_Shape& shape);

/// A note that it was read so, and why.
[[nodiscard]] std::string note_of(const IgesReading& how, const std::string& cause);

}  // namespace octet
