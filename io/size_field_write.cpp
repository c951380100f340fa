// SPDX-License-Identifier: BSD-3-Clause
// Octants are voxels in VTK's words, their corners in the same order.
#include "io/size_field_write.h"

#include "base/check.h"
#include "io/vtu_appended.h"

namespace octet {

void write_size_field(const std::filesystem::path& path, const SizeBoxes& field, double scale) {
  OCTET_CHECK(field.size.size() == field.boxes.size());
  constexpr int kVoxel = 11;
  const std::size_t points = field.points.size(), boxes = field.boxes.size();
  const SizeBoxes* f = &field;
  VtuAppended data;
  std::string xml = kVtuHead;
  xml += fmt::format(
      "    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n      <CellData Scalars=\"size\">\n", points,
      boxes);
  xml += data.add<double>("size", boxes, [=](std::size_t i) { return scale * f->size[i]; });
  xml += "      </CellData>\n      <Points>\n";
  xml += data.add<double>(
      "Points", 3, points, 3 * points, [](std::size_t) { return std::size_t{3}; },
      [=](std::size_t v, double* values) {
        for (int i = 0; i < 3; ++i) values[i] = scale * f->points[v][i];
      });
  xml += "      </Points>\n      <Cells>\n";
  xml += data.add<std::int64_t>("connectivity", 8 * boxes,
                                [=](std::size_t i) { return f->boxes[i / 8][i % 8]; });
  xml += data.add<std::int64_t>("offsets", boxes, [](std::size_t i) { return 8 * (i + 1); });
  xml += data.add<std::uint8_t>("types", boxes, [](std::size_t) { return kVoxel; });
  xml += "      </Cells>\n    </Piece>\n";
  OutputFile file(path);
  data.write(file, xml);
  file.commit();
}

}  // namespace octet
