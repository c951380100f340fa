// SPDX-License-Identifier: BSD-3-Clause
// Told by the bytes: MSH and VTU begin with their own words, all else is taken for CSV.
#include "io/size_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include "base/error.h"
#include "io/msh_read.h"
#include "io/vtu_file.h"
#include "io/write.h"

namespace octet {
namespace {

std::string file_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  if (!file || !(text << file.rdbuf())) throw InputError("it is missing, empty or not readable");
  return text.str();
}

/// Of a CSV file, for errors.
struct Line {
  std::string_view text;
  int number;

  [[noreturn]] void refuse(const char* why) const {
    throw InputError(fmt::format("line {}, \"{}\", is {}", number, text.substr(0, 60), why));
  }
};

/// All of the word as a number; from_chars takes no plus.
std::optional<double> number_in(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  double value = 0.0;
  const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || rest != word.data() + word.size()) return std::nullopt;
  return value;
}

/// Whether somebody meant a number, right or not.
bool begins_as_number(std::string_view word) {
  const std::size_t first = word.find_first_not_of("+-.");
  return first != std::string_view::npos && word[first] >= '0' && word[first] <= '9';
}

/// The numbers of a line, between commas, semicolons or blanks. None: an empty line, a comment, or, where
/// `may_be_header`, one that does not begin as a number does.
std::vector<double> numbers_of(const Line& line, bool may_be_header) {
  std::vector<double> numbers;
  constexpr std::string_view kBetween = ",; \t\r";
  for (std::size_t at = line.text.find_first_not_of(kBetween); at != std::string_view::npos;
       at = line.text.find_first_not_of(kBetween, at)) {
    const std::size_t end = std::min(line.text.find_first_of(kBetween, at), line.text.size());
    const std::string_view word = line.text.substr(at, end - at);
    if (numbers.empty() && word[0] == '#') return {};
    const std::optional<double> value = number_in(word);
    if (!value && numbers.empty() && may_be_header && !begins_as_number(word)) return {};
    if (!value) line.refuse("no list of numbers");
    numbers.push_back(*value);
    at = end;
  }
  return numbers;
}

Background on_mesh(const std::filesystem::path& path, std::vector<double> sizes) {
  if (path.empty()) throw InputError("one size a line needs a mesh whose elements they count");
  const Mesh mesh = read_mesh(path);
  Background field;
  field.points = mesh.points;
  field.tets = mesh.tets;
  if (sizes.size() == mesh.tets.size())
    field.tet_size = std::move(sizes);
  else if (sizes.size() == mesh.points.size())
    field.point_size = std::move(sizes);
  else
    throw InputError(fmt::format("it has {} sizes; the mesh has {} tetrahedra and {} nodes{}", sizes.size(),
                                 mesh.tets.size(), mesh.points.size(),
                                 mesh.mid.empty() ? "" : " at their corners"));
  return field;
}

Background read_csv(std::string_view text, const std::filesystem::path& mesh) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.substr(0, kByteOrderMark.size()) == kByteOrderMark) text.remove_prefix(kByteOrderMark.size());
  Background field;
  std::vector<double> sizes;
  for (int count = 1; !text.empty(); ++count) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const Line line{text.substr(0, end), count};
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::vector<double> numbers = numbers_of(line, sizes.empty() && field.points.empty());
    if (numbers.empty()) continue;
    if (numbers.size() == 1) {
      sizes.push_back(numbers[0]);
    } else if (numbers.size() == 4) {
      field.points.emplace_back(numbers[0], numbers[1], numbers[2]);
      field.point_size.push_back(numbers[3]);
    } else {
      line.refuse("neither a size nor x, y, z, size");
    }
  }
  if (!sizes.empty() && !field.points.empty()) throw InputError("it mixes lines of one and of four numbers");
  return sizes.empty() ? field : on_mesh(mesh, std::move(sizes));
}

/// Of several fields the one called "size", else the only one.
std::size_t chosen(const std::vector<std::string>& names, const char* what) {
  if (names.empty()) throw InputError(fmt::format("it has no {}", what));
  const auto size = std::find(names.begin(), names.end(), "size");
  if (size == names.end() && names.size() > 1)
    throw InputError(fmt::format("it has several {} ({}): call the one that is meant \"size\"", what,
                                 fmt::join(names, ", ")));
  return size == names.end() ? 0 : static_cast<std::size_t>(size - names.begin());
}

/// Tetrahedra and points with the view's values; 0 where it has none.
Background on_view(const RawMesh& raw, const RawView& view) {
  std::map<std::uint64_t, double> values;
  for (std::size_t i = 0; i < view.tag.size(); ++i) values[view.tag[i]] = view.value[i];
  const auto value = [&values](std::uint64_t tag) {
    const auto at = values.find(tag);
    return at == values.end() ? 0.0 : at->second;
  };
  Background field;
  field.points = raw.points;
  std::map<std::uint64_t, Mesh::Index> index;
  for (std::size_t i = 0; i < raw.node_tag.size(); ++i) index[raw.node_tag[i]] = static_cast<Mesh::Index>(i);
  for (const auto& nodes : raw.tets.nodes) {
    auto& tet = field.tets.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      const auto at = index.find(nodes[i]);
      if (at == index.end())
        throw InputError(fmt::format("an element names node {}, which is not given", nodes[i]));
      tet[i] = at->second;
    }
  }
  if (view.on == RawView::On::kNodes)
    for (const std::uint64_t tag : raw.node_tag) field.point_size.push_back(value(tag));
  else
    for (const std::uint64_t tag : raw.tets.tag) field.tet_size.push_back(value(tag));
  return field;
}

Background read_msh_view(const std::string& text, const std::filesystem::path& mesh) {
  const RawMesh raw = read_msh(text, true);
  std::vector<const RawView*> scalars;
  std::vector<std::string> names;
  for (const RawView& view : raw.views)
    if (view.components == 1) {
      scalars.push_back(&view);
      names.push_back(view.name);
    }
  const RawView& view = *scalars[chosen(names, "views of scalars")];
  if (!raw.points.empty()) return on_view(raw, view);
  if (mesh.empty()) throw InputError("its view needs a mesh whose nodes or elements it numbers");
  return on_view(read_msh(file_text(mesh)), view);
}

/// The cells of a VTU file, each proved to name points that are there.
struct VtuCells {
  std::vector<std::uint8_t> type;
  std::vector<std::vector<Mesh::Index>> nodes;
};

VtuCells cells_of(const VtuFile& file) {
  VtuCells cells;
  cells.type = file.array<std::uint8_t>("Cells", "types", file.cells());
  const auto ends = file.array<std::int64_t>("Cells", "offsets", file.cells());
  const auto length = static_cast<std::uint64_t>(std::max<std::int64_t>(ends.empty() ? 0 : ends.back(), 0));
  const auto nodes = file.array<std::int64_t>("Cells", "connectivity", length);
  std::int64_t first = 0;
  for (const std::int64_t end : ends) {
    if (end <= first || end > static_cast<std::int64_t>(length))
      throw InputError(fmt::format("VTU cell {} has a wrong number of nodes", cells.nodes.size()));
    auto& cell = cells.nodes.emplace_back();
    for (; first < end; ++first) {
      const std::int64_t node = nodes[static_cast<std::size_t>(first)];
      if (node < 0 || node >= static_cast<std::int64_t>(file.points()))
        throw InputError(fmt::format("a VTU cell names point {}, which is not given", node));
      cell.push_back(static_cast<Mesh::Index>(node));
    }
  }
  return cells;
}

/// Linear and quadratic tetrahedra by their corners. Without any, the values are those of a cloud: of the
/// points, or of the cells at their middles.
Background read_vtu_array(const std::string& text) {
  const VtuFile file(text);
  std::vector<std::string> names = file.real_scalars("CellData");
  const std::size_t of_cells = names.size();
  for (std::string& name : file.real_scalars("PointData")) names.push_back(std::move(name));
  const std::size_t array = chosen(names, "arrays of real numbers");
  const bool on_cells = array < of_cells;
  auto size = file.array<double>(on_cells ? "CellData" : "PointData", names[array],
                                 on_cells ? file.cells() : file.points());
  const auto xyz = file.array<double>("Points", "", 3 * file.points());
  Background field, cloud;
  for (std::size_t i = 0; i + 2 < xyz.size(); i += 3)
    field.points.emplace_back(xyz[i], xyz[i + 1], xyz[i + 2]);
  const VtuCells cells = cells_of(file);
  for (std::size_t c = 0; c < cells.nodes.size(); ++c) {
    constexpr std::uint8_t kTetrahedron = 10, kQuadraticTetrahedron = 24;
    const auto& nodes = cells.nodes[c];
    if ((cells.type[c] == kTetrahedron || cells.type[c] == kQuadraticTetrahedron) && nodes.size() >= 4) {
      field.tets.push_back({nodes[0], nodes[1], nodes[2], nodes[3]});
      if (on_cells) field.tet_size.push_back(size[c]);
    } else if (on_cells) {
      Vec3 middle = Vec3::Zero();
      for (const Mesh::Index v : nodes) middle += field.points[v] / static_cast<double>(nodes.size());
      cloud.points.push_back(middle);
      cloud.point_size.push_back(size[c]);
    }
  }
  if (!on_cells) field.point_size = std::move(size);
  return field.tets.empty() && on_cells ? cloud : field;
}

Background read_any(const std::string& text, const std::filesystem::path& mesh) {
  if (text.compare(0, 11, "$MeshFormat") == 0) return read_msh_view(text, mesh);
  if (text.substr(0, 1024).find("<VTKFile") != std::string::npos) return read_vtu_array(text);
  return read_csv(text, mesh);
}

}  // namespace

Background read_size_file(const std::filesystem::path& path, const std::filesystem::path& mesh) {
  try {
    Background field = read_any(file_text(path), mesh);
    const std::vector<double>& sizes = field.tet_size.empty() ? field.point_size : field.tet_size;
    if (std::none_of(sizes.begin(), sizes.end(), [](double s) { return s > 0.0 && std::isfinite(s); }))
      throw InputError("it has no positive size");
    for (const Vec3& p : field.points)
      if (!p.allFinite()) throw InputError(fmt::format("({}, {}, {}) is no place", p.x(), p.y(), p.z()));
    return field;
  } catch (const InputError& error) {
    throw InputError(fmt::format("cannot read sizes from \"{}\": {}", path.string(), error.what()));
  }
}

}  // namespace octet
