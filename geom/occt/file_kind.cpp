// SPDX-License-Identifier: BSD-3-Clause
// Which CAD format a file holds, told by its content.
#include "geom/occt/file_kind.h"

#include <algorithm>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include "base/error.h"

namespace octet {
namespace {

constexpr std::size_t kHeadBytes = 4096;

std::string head_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError("cannot open '" + path.string() + "' for reading");
  std::string head(kHeadBytes, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  return head;
}

/// IGES is made of 80-column records whose column 73 names the section; the first one is S (start).
bool is_iges(std::string_view head) {
  const std::size_t end = std::min(head.find('\n'), head.size());
  std::string_view line = head.substr(0, std::min<std::size_t>(end, 80));
  if (line.size() < 74 || line[72] != 'S') return false;
  return line.substr(73).find_first_not_of(" 0123456789\r") == std::string_view::npos;
}

}  // namespace

FileKind file_kind(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw InputError("file '" + path.string() + "' does not exist");
  if (std::filesystem::is_directory(status))
    throw InputError("'" + path.string() + "' is a directory, not a CAD file");
  const std::string head = head_of(path);
  if (head.find_first_not_of(" \t\r\n") == std::string::npos)
    throw InputError("file '" + path.string() + "' is empty");
  if (head.find("ISO-10303-21") != std::string::npos) return FileKind::kStep;
  if (head.find("DBRep_DrawableShape") != std::string::npos ||
      head.find("CASCADE Topology") != std::string::npos)
    return FileKind::kBrep;
  if (is_iges(head)) return FileKind::kIges;
  throw InputError("file '" + path.string() + "' is not a STEP, IGES or OpenCASCADE BREP file");
}

}  // namespace octet
