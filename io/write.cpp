// SPDX-License-Identifier: BSD-3-Clause
// Which format, and which writer.
#include "io/write.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "base/check.h"
#include "base/error.h"
#include "io/bdf_write.h"
#include "io/exodus_write.h"
#include "io/inp_write.h"
#include "io/medit_write.h"
#include "io/msh_write.h"
#include "io/output_file.h"
#include "io/su2_write.h"
#include "io/unv_write.h"
#include "io/vtu_write.h"

namespace octet {
namespace {

constexpr const char* kNames =
    "msh, msh41, msh41-ascii, msh22, msh22-ascii, vtu, inp, unv, bdf, exodus, medit, medit-binary, su2";

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

MeshFormat mesh_format(const std::filesystem::path& path, const std::string& name) {
  if (!name.empty()) {
    const std::string wanted = lower_case(name);
    if (wanted == "msh" || wanted == "msh41") return MeshFormat::kMsh41Binary;
    if (wanted == "msh41-ascii") return MeshFormat::kMsh41Ascii;
    if (wanted == "msh22") return MeshFormat::kMsh22Binary;
    if (wanted == "msh22-ascii") return MeshFormat::kMsh22Ascii;
    if (wanted == "vtu") return MeshFormat::kVtu;
    if (wanted == "inp") return MeshFormat::kInp;
    if (wanted == "unv") return MeshFormat::kUnv;
    if (wanted == "bdf") return MeshFormat::kBdf;
    if (wanted == "exodus") return MeshFormat::kExodus;
    if (wanted == "medit") return MeshFormat::kMedit;
    if (wanted == "medit-binary") return MeshFormat::kMeditBinary;
    if (wanted == "su2") return MeshFormat::kSu2;
    throw InputError(fmt::format("unknown mesh format \"{}\"; known are {}", name, kNames));
  }
  const std::string suffix = lower_case(path.extension().string());
  if (suffix == ".msh") return MeshFormat::kMsh41Binary;
  if (suffix == ".vtu") return MeshFormat::kVtu;
  if (suffix == ".inp") return MeshFormat::kInp;
  if (suffix == ".unv") return MeshFormat::kUnv;
  if (suffix == ".bdf" || suffix == ".nas") return MeshFormat::kBdf;
  if (suffix == ".exo" || suffix == ".e") return MeshFormat::kExodus;
  if (suffix == ".mesh") return MeshFormat::kMedit;
  if (suffix == ".meshb") return MeshFormat::kMeditBinary;
  if (suffix == ".su2") return MeshFormat::kSu2;
  throw InputError(
      fmt::format("\"{}\" ends in none of .msh, .vtu, .inp, .unv, .bdf, .exo, .mesh, .meshb and .su2: name "
                  "the format ({})",
                  path.string(), kNames));
}

void check_order(MeshFormat format, int order) {
  if (format == MeshFormat::kSu2 && order > 1)
    throw InputError("a .su2 file has no elements of second order: use --order 1");
}

void write_mesh(const std::filesystem::path& path, const Mesh& mesh, const ModelOutline& outline,
                MeshFormat format, const WriteOptions& options) {
  OCTET_CHECK(mesh.points.size() == mesh.point_on.size() && mesh.edges.size() == mesh.edge_on.size());
  OCTET_CHECK(mesh.triangles.size() == mesh.triangle_on.size() && mesh.tets.size() == mesh.tet_in.size());
  OCTET_CHECK(std::isfinite(options.scale) && options.scale > 0.0);
  OutputFile file(path);
  switch (format) {
    case MeshFormat::kMsh41Binary:
      write_msh41(file, mesh, outline, Encoding::kBinary, options.scale);
      break;
    case MeshFormat::kMsh41Ascii:
      write_msh41(file, mesh, outline, Encoding::kAscii, options.scale);
      break;
    case MeshFormat::kMsh22Binary:
      write_msh22(file, mesh, outline, Encoding::kBinary, options.scale);
      break;
    case MeshFormat::kMsh22Ascii:
      write_msh22(file, mesh, outline, Encoding::kAscii, options.scale);
      break;
    case MeshFormat::kVtu:
      write_vtu(file, mesh, outline, options.scale);
      break;
    case MeshFormat::kInp:
      write_inp(file, mesh, outline, options.scale);
      break;
    case MeshFormat::kUnv:
      write_unv(file, mesh, outline, options.scale);
      break;
    case MeshFormat::kBdf:
      write_bdf(file, mesh, outline, options.scale);
      break;
    case MeshFormat::kExodus:
      write_exodus(file, mesh, outline, options.scale);
      break;
    case MeshFormat::kMedit:
      write_medit(file, mesh, outline, Encoding::kAscii, options.scale);
      break;
    case MeshFormat::kMeditBinary:
      write_medit(file, mesh, outline, Encoding::kBinary, options.scale);
      break;
    case MeshFormat::kSu2:
      write_su2(file, mesh, outline, options.scale);
      break;
  }
  file.commit();
}

}  // namespace octet
