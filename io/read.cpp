// SPDX-License-Identifier: BSD-3-Clause
// Which reader: told by the bytes, not by the name.
#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <string>
#include <system_error>

#include "base/error.h"
#include "io/msh_read.h"
#include "io/vtu_read.h"
#include "io/write.h"

namespace octet {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

std::string file_bytes(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) throw InputError("it is a directory");
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.string().c_str(), "rbe"));
  if (!file) throw InputError(std::generic_category().message(errno));
  std::string bytes;
  const auto size = std::filesystem::file_size(path, error);
  if (!error) bytes.reserve(size);
  std::string chunk(std::size_t{1} << 20, '\0');
  while (const std::size_t n = std::fread(chunk.data(), 1, chunk.size(), file.get()))
    bytes.append(chunk, 0, n);
  if (std::ferror(file.get()) != 0) throw InputError("reading failed");
  return bytes;
}

RawMesh read_bytes(const std::string& bytes) {
  if (bytes.empty()) throw InputError("the file is empty");
  if (bytes.compare(0, 11, "$MeshFormat") == 0) return read_msh(bytes);
  if (bytes.substr(0, 1024).find("<VTKFile") != std::string::npos) return read_vtu(bytes);
  throw InputError("it is neither an MSH nor a VTU file");
}

}  // namespace

Mesh read_mesh(const std::filesystem::path& path, double scale) {
  try {
    Mesh mesh = assemble_mesh(read_bytes(file_bytes(path)));
    for (Vec3& p : mesh.points) p *= scale;
    for (Vec3& p : mesh.mid.points) p *= scale;
    return mesh;
  } catch (const InputError& error) {
    throw InputError(fmt::format("cannot read \"{}\": {}", path.string(), error.what()));
  }
}

}  // namespace octet
