// SPDX-License-Identifier: BSD-3-Clause
// Which format, and which writer.
#include "io/write.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <span>

#include "base/error.h"
#include "io/bdf_write.h"
#include "io/cgns_write.h"
#include "io/exodus_write.h"
#include "io/hdf5_file.h"
#include "io/inp_write.h"
#include "io/med_write.h"
#include "io/medit_write.h"
#include "io/msh_write.h"
#include "io/output_file.h"
#include "io/stl_write.h"
#include "io/su2_write.h"
#include "io/unv_write.h"
#include "io/vtu_write.h"
#include "io/xdmf_write.h"
#include "mesh/soundness.h"

namespace octet {
namespace {

struct Named {
  const char* word;
  MeshFormat format;
};
constexpr Named kNames[] = {{"msh", MeshFormat::kMsh41Binary},
                            {"msh41", MeshFormat::kMsh41Binary},
                            {"msh41-ascii", MeshFormat::kMsh41Ascii},
                            {"msh22", MeshFormat::kMsh22Binary},
                            {"msh22-ascii", MeshFormat::kMsh22Ascii},
                            {"vtu", MeshFormat::kVtu},
                            {"inp", MeshFormat::kInp},
                            {"unv", MeshFormat::kUnv},
                            {"bdf", MeshFormat::kBdf},
                            {"exodus", MeshFormat::kExodus},
                            {"medit", MeshFormat::kMedit},
                            {"medit-binary", MeshFormat::kMeditBinary},
                            {"su2", MeshFormat::kSu2},
                            {"med", MeshFormat::kMed},
                            {"xdmf", MeshFormat::kXdmf},
                            {"cgns", MeshFormat::kCgns},
                            {"stl", MeshFormat::kStl},
                            {"stl-ascii", MeshFormat::kStlAscii}};
constexpr Named kSuffixes[] = {
    {".msh", MeshFormat::kMsh41Binary},   {".vtu", MeshFormat::kVtu},   {".inp", MeshFormat::kInp},
    {".unv", MeshFormat::kUnv},           {".bdf", MeshFormat::kBdf},   {".nas", MeshFormat::kBdf},
    {".exo", MeshFormat::kExodus},        {".e", MeshFormat::kExodus},  {".mesh", MeshFormat::kMedit},
    {".meshb", MeshFormat::kMeditBinary}, {".su2", MeshFormat::kSu2},   {".med", MeshFormat::kMed},
    {".xdmf", MeshFormat::kXdmf},         {".cgns", MeshFormat::kCgns}, {".stl", MeshFormat::kStl}};

std::string listed(std::span<const Named> known) {
  std::string words;
  for (const Named& one : known) words += (words.empty() ? "" : ", ") + std::string(one.word);
  return words;
}

std::optional<MeshFormat> find(std::span<const Named> known, const std::string& word) {
  const auto found = std::find_if(known.begin(), known.end(), [&](const Named& n) { return word == n.word; });
  return found == known.end() ? std::nullopt : std::optional(found->format);
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

std::string mesh_format_names() { return listed(kNames); }
std::string mesh_suffixes() { return listed(kSuffixes); }

MeshFormat mesh_format(const std::filesystem::path& path, const std::string& name) {
  if (!name.empty()) {
    if (const auto format = find(kNames, lower_case(name))) return *format;
    throw InputError(fmt::format("unknown mesh format \"{}\"; known are {}", name, mesh_format_names()));
  }
  if (const auto format = find(kSuffixes, lower_case(path.extension().string()))) return *format;
  throw InputError(fmt::format("\"{}\" ends in none of {}: name the format ({})", path.string(),
                               mesh_suffixes(), mesh_format_names()));
}

void check_format(MeshFormat format, int order) {
  if (order > 1 && format == MeshFormat::kSu2)
    throw InputError("a .su2 file has no elements of second order: use --order 1");
  if (order > 1 && (format == MeshFormat::kStl || format == MeshFormat::kStlAscii))
    throw InputError("a .stl file has flat triangles alone: use --order 1");
  if (format == MeshFormat::kMed || format == MeshFormat::kXdmf || format == MeshFormat::kCgns) check_hdf5();
}

std::vector<std::filesystem::path> written_files(const std::filesystem::path& path, MeshFormat format) {
  if (format != MeshFormat::kXdmf) return {path};
  std::filesystem::path arrays = path;
  arrays.replace_extension(".h5");
  if (arrays == path)
    throw InputError(fmt::format(
        "\"{}\" is where the arrays of an XDMF file go: give the file itself another suffix", path.string()));
  return {path, arrays};
}

void write_mesh(const std::filesystem::path& path, const Mesh& mesh, const ModelOutline& outline,
                MeshFormat format, const WriteOptions& options) {
  if (const std::string fault = check_mesh_arrays(mesh); !fault.empty())
    throw InputError("the mesh cannot be written: " + fault);
  if (!std::isfinite(options.scale) || options.scale <= 0.0)
    throw InputError(
        fmt::format("the scale of a mesh file must be a positive number, not {}", options.scale));
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
    case MeshFormat::kMed:
      write_med(file, mesh, outline, options.scale);
      break;
    case MeshFormat::kCgns:
      write_cgns(file, mesh, outline, options.scale);
      break;
    case MeshFormat::kXdmf: {
      const std::filesystem::path beside = written_files(path, format).back();
      OutputFile arrays(beside);
      write_xdmf(file, arrays, beside.filename().string(), mesh, outline, options.scale);
      arrays.commit();
      break;
    }
    case MeshFormat::kStl:
      write_stl(file, mesh, outline, Encoding::kBinary, options.scale);
      break;
    case MeshFormat::kStlAscii:
      write_stl(file, mesh, outline, Encoding::kAscii, options.scale);
      break;
  }
  file.commit();
}

}  // namespace octet
