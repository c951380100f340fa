// SPDX-License-Identifier: BSD-3-Clause
// Normals are those of the triangles as they are written.
#include "io/stl_write.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "base/error.h"
#include "io/face_sides.h"
#include "io/msh_entities.h"
#include "io/set_names.h"

namespace octet {
namespace {

constexpr std::size_t kLongestStlName = 80;
constexpr std::size_t kHeader = 80;

/// Corners of triangles on model faces, turned.
class Corners {
 public:
  Corners(const Mesh& mesh, double scale) : mesh_(mesh), uses_(boundary_face_uses(mesh)), scale_(scale) {}

  /// The normal, of length one or zero, and the corners.
  std::array<Vec3, 4> of(std::uint32_t i) const {
    std::array<Mesh::Index, 3> triangle = mesh_.triangles[i];
    const auto sharing = uses_.find(triangle);
    if (sharing.size() == 1 && sharing[0].even != sorted_face(triangle).even)
      std::swap(triangle[1], triangle[2]);
    std::array<Vec3, 4> all;
    for (std::size_t k = 0; k < 3; ++k) all[k + 1] = mesh_.points[triangle[k]] * scale_;
    const Vec3 across = (all[2] - all[1]).cross(all[3] - all[1]);
    const double length = across.norm();
    all[0] = length > 0.0 ? Vec3(across / length) : Vec3(Vec3::Zero());
    return all;
  }

 private:
  const Mesh& mesh_;
  FaceUses uses_;
  double scale_;
};

void write_binary(OutputFile& file, const Mesh& mesh, const Corners& corners) {
  std::string header = "mesh by Octet";  // not "solid", by which readers know ASCII
  header.resize(kHeader, ' ');
  file.write(header);
  file.put(static_cast<std::uint32_t>(mesh.triangles.size()));
  file.write_blocks(mesh.triangles.size(), kItemsATask,
                    [&](std::size_t first, std::size_t last, std::string& bytes) {
                      for (std::size_t i = first; i < last; ++i) {
                        for (const Vec3& p : corners.of(static_cast<std::uint32_t>(i)))
                          for (int k = 0; k < 3; ++k) {
                            const auto x = static_cast<float>(p[k]);
                            bytes.append(reinterpret_cast<const char*>(&x), sizeof x);
                          }
                        bytes.append(2, '\0');
                      }
                    });
}

void write_ascii(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, const Corners& corners) {
  const ElementGroups groups = group_elements(mesh);
  const auto names = set_names(complete_outline(outline, mesh), kLongestStlName).of;
  for (const auto& group : groups.items) {
    if (group.first.dim != 2) continue;
    const std::vector<std::uint32_t>& items = group.second;
    const std::string& name = names.at(group.first);
    file.write(fmt::format("solid {}\n", name));
    file.write_blocks(
        items.size(), kItemsATask, [&](std::size_t first, std::size_t last, std::string& bytes) {
          auto out = std::back_inserter(bytes);
          for (std::size_t k = first; k < last; ++k) {
            const std::array<Vec3, 4> p = corners.of(items[k]);
            fmt::format_to(out, "facet normal {} {} {}\nouter loop\n", p[0].x(), p[0].y(), p[0].z());
            for (std::size_t c = 1; c < 4; ++c)
              fmt::format_to(out, "vertex {} {} {}\n", p[c].x(), p[c].y(), p[c].z());
            fmt::format_to(out, "endloop\nendfacet\n");
          }
        });
    file.write(fmt::format("endsolid {}\n", name));
  }
}

}  // namespace

void write_stl(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, Encoding encoding,
               double scale) {
  if (!mesh.mid.empty()) throw OutputError("a .stl file has flat triangles alone; use --order 1");
  if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max())
    throw OutputError("the mesh has too many triangles for a .stl file; use MSH 4.1");
  const Corners corners(mesh, scale);
  if (encoding == Encoding::kBinary) {
    write_binary(file, mesh, corners);
  } else {
    write_ascii(file, mesh, outline, corners);
  }
}

}  // namespace octet
