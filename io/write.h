// SPDX-License-Identifier: BSD-3-Clause
// Meshes to and from disk.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/model_outline.h"

namespace octet {

enum class MeshFormat {
  kMsh41Binary,
  kMsh41Ascii,
  kMsh22Binary,
  kMsh22Ascii,
  kVtu,
  kInp,
  kUnv,
  kBdf,
  kExodus,
  kMedit,
  kMeditBinary,
  kSu2,
  kMed,
  kXdmf,
  kCgns,
  kStl,
  kStlAscii
};

struct WriteOptions {
  double scale = 1.0;  ///< multiplies coordinates: model units (millimetre) to the unit asked for
};

/// What --format takes, and the suffixes that tell a format, each separated by ", ".
[[nodiscard]] std::string mesh_format_names();
[[nodiscard]] std::string mesh_suffixes();

/// The format of that name (the user's --format; msh is msh41), or where it is empty the one that the path's
/// suffix tells (.msh: MSH 4.1, binary). InputError when neither is known.
[[nodiscard]] MeshFormat mesh_format(const std::filesystem::path& path, const std::string& name);
/// InputError when the format has no elements of that order, or cannot be written by this program
/// (check_hdf5() in io/hdf5_file.h).
void check_format(MeshFormat format, int order);

/// What write_mesh makes: the path itself and, behind it, an XDMF file's arrays, in a file whose suffix is
/// .h5. InputError when these would be one file.
[[nodiscard]] std::vector<std::filesystem::path> written_files(const std::filesystem::path& path,
                                                               MeshFormat format);

/// Writes to a temporary name beside `path` and renames when whole. OutputError (with the reason) leaves no
/// file. Same mesh, same bytes. So is every file of written_files. InputError, and no file, for a mesh whose
/// arrays do not fit each other (check_mesh_arrays) or a scale that is not positive.
void write_mesh(const std::filesystem::path& path, const Mesh& mesh, const ModelOutline& outline,
                MeshFormat format, const WriteOptions& options = {});

/// Reads MSH 4.1 and 2.2, ASCII and binary, and VTU as written by write_mesh. InputError when it cannot.
/// point_on is rebuilt from entity blocks (4.1), else from the lowest-dimensional element that names the
/// node. Coordinates are multiplied by `scale`, which leaves them as they are where it is 1.
[[nodiscard]] Mesh read_mesh(const std::filesystem::path& path, double scale = 1.0);

}  // namespace octet
