// SPDX-License-Identifier: BSD-3-Clause
// CAD files to a Model. No OCCT type appears here.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "geom/model.h"

namespace octet {

struct ReadOptions {
  double facet_deflection = 0.0;  ///< mm; 0: chosen from the part (diagonal / 2000, finer where curved); at
                                  ///< most 1/50 of the diagonal of the solids at a face
  /// Faces that are loose, or leave a solid open, are sewn within this distance (mm). 0: by growing ones, up
  /// to a ten-thousandth of the faces' diagonal.
  double sew_tolerance = 0.0;
  /// Openings that lie in a plane, and would leave a shell or a solid open, are closed by a plane face each,
  /// named "cap 1", "cap 2", ... and listed in the model's notes.
  bool cap = false;
  /// Edges no longer, and faces, spikes and slits no wider than this (mm) are taken away where that leaves
  /// the part closed, and listed in the model's notes. What rounding leaves (1e-6 of a solid's diagonal)
  /// always is.
  double smallest_feature = 0.0;
  /// OCCT may hang, crash or take all memory on a damaged part: it works in a child process, so that this one
  /// gets an InputError instead. False: in this process and without limits (for debuggers). OCCT's messages
  /// then go to the printers of its default messenger, which are the host's; a child prints nowhere.
  bool isolate = true;
  /// Where reading cannot be isolated: InputError, instead of reading in this process and a note.
  bool require_isolation = false;
  double time_limit = 300.0;     ///< seconds of wall time for all of reading, and again where that ends in a
                                 ///< fuse: the solids are then read apart; 0: none
  std::size_t memory_limit = 0;  ///< bytes for the child; 0: half of the machine's memory
  /// The program octet-reader, which reads where a process with several threads cannot fork. Empty: that of
  /// the package that find_package(octet) found, beside the running program, in its ../libexec/octet, where
  /// Octet was to be installed, or in /usr/libexec/octet; where none is found, reading is not isolated, and a
  /// note of the model says so.
  std::filesystem::path reader_program;
  /// Loose faces become faces embedded in the solids that they lie in, which the mesh follows; listed in the
  /// model's notes. Not with `fuse` off.
  bool embed = false;
  bool fuse = true;  ///< solids that touch share faces, edges and vertices; else each keeps its own
  /// Solids that overlap, or miss each other, by no more than this (mm) are taken to touch. 0: what rounding
  /// leaves (1e-6 of the diagonal of those that touch).
  double fuse_tolerance = 0.0;
};

#ifdef OCTET_INSTALLED_READER
/// octet-reader of the installed package, which tells its place to those who use it, wherever it was put. A
/// name of each file's own, and so no definition that library and host have differently.
constexpr const char* kInstalledReader = OCTET_INSTALLED_READER;
#else
constexpr const char* kInstalledReader = "";
#endif

/// Reads STEP (AP203, AP214, AP242), IGES or OCCT BREP, told by content, not by suffix.
/// Coordinates become millimetre; the file's unit is Model::unit().
/// InputError: missing, a directory, empty, truncated, not a CAD file, no shape in it.
/// InputError: OCCT hung, crashed or needed too much memory (names the stage and, where known, the entity).
/// Where it did so joining solids they are kept apart, and a fault of the model says so.
/// ModelError: nothing that bounds a volume (open shell: names the first free edge, its faces and place); its
/// entity has its number as read.
/// `installed_reader` is not for callers to give.
[[nodiscard]] Model read_part(const std::filesystem::path& path, const ReadOptions& options = {},
                              const char* installed_reader = kInstalledReader);

}  // namespace octet
