// SPDX-License-Identifier: BSD-3-Clause
// Told by the bytes: MSH begins with its own word, all else is taken for CSV.
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
#include "io/byte_cursor.h"
#include "io/msh_read.h"
#include "io/write.h"

namespace octet {
namespace {

std::string file_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  if (!file || !(text << file.rdbuf())) throw InputError("it is missing, empty or not readable");
  return text.str();
}

/// The numbers of a line, between commas, semicolons or blanks; none where it does not begin with one.
std::vector<double> numbers_of(std::string_view line) {
  std::vector<double> numbers;
  constexpr std::string_view kBetween = ",; \t\r";
  for (std::size_t at = line.find_first_not_of(kBetween); at != std::string_view::npos;
       at = line.find_first_not_of(kBetween, at)) {
    const std::size_t end = std::min(line.find_first_of(kBetween, at), line.size());
    double value = 0.0;
    const auto [rest, error] = std::from_chars(line.data() + at, line.data() + end, value);
    if (error != std::errc() || rest != line.data() + end) {
      if (numbers.empty()) return {};
      throw InputError(fmt::format("\"{}\" is no list of numbers", line.substr(0, 60)));
    }
    numbers.push_back(value);
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
    throw InputError(fmt::format("it has {} sizes; the mesh has {} tetrahedra and {} nodes", sizes.size(),
                                 mesh.tets.size(), mesh.points.size()));
  return field;
}

Background read_csv(const std::string& text, const std::filesystem::path& mesh) {
  Background field;
  std::vector<double> sizes;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::vector<double> numbers = numbers_of(line);
    if (numbers.empty()) continue;
    if (numbers.size() == 1) {
      sizes.push_back(numbers[0]);
    } else if (numbers.size() == 4) {
      field.points.emplace_back(numbers[0], numbers[1], numbers[2]);
      field.point_size.push_back(numbers[3]);
    } else {
      throw InputError(fmt::format("\"{}\" is neither a size nor x, y, z, size", line.substr(0, 60)));
    }
  }
  if (!sizes.empty() && !field.points.empty()) throw InputError("it mixes lines of one and of four numbers");
  return sizes.empty() ? field : on_mesh(mesh, std::move(sizes));
}

/// Values by tag of the first view in the section.
std::optional<std::map<std::uint64_t, double>> read_view(const std::string& text, std::string_view section) {
  ByteCursor in(text);
  if (!in.skip_past(section)) return std::nullopt;
  for (std::int64_t n = in.integer(); n > 0; --n) {  // the view's name and other strings
    in.skip_blanks();
    (void)in.line();
  }
  for (std::int64_t n = in.integer(); n > 0; --n) (void)in.real();
  std::vector<std::int64_t> tags;
  const std::int64_t tag_count = in.integer();
  for (std::int64_t i = 0; i < tag_count && i < 16; ++i) tags.push_back(in.integer());
  if (tags.size() < 3 || tags[1] != 1) throw InputError("its view is not one of scalars");
  std::map<std::uint64_t, double> values;
  for (std::size_t n = in.checked_count(static_cast<std::uint64_t>(tags[2]), 4, "values"); n > 0; --n) {
    const auto tag = static_cast<std::uint64_t>(in.integer());
    values[tag] = in.real();
  }
  return values;
}

Background read_msh_view(const std::string& text) {
  const RawMesh raw = read_msh(text);
  const auto on_elements = read_view(text, "$ElementData");
  const auto on_nodes = on_elements ? std::nullopt : read_view(text, "$NodeData");
  if (!on_elements && !on_nodes) throw InputError("the MSH file has no ASCII view of elements or nodes");
  const auto value = [](const std::map<std::uint64_t, double>& values, std::uint64_t tag) {
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
  if (on_elements)
    for (const std::uint64_t tag : raw.tets.tag) field.tet_size.push_back(value(*on_elements, tag));
  else
    for (const std::uint64_t tag : raw.node_tag) field.point_size.push_back(value(*on_nodes, tag));
  return field;
}

}  // namespace

Background read_size_file(const std::filesystem::path& path, const std::filesystem::path& mesh) {
  try {
    const std::string text = file_text(path);
    Background field = text.compare(0, 11, "$MeshFormat") == 0 ? read_msh_view(text) : read_csv(text, mesh);
    const std::vector<double>& sizes = field.tet_size.empty() ? field.point_size : field.tet_size;
    if (std::none_of(sizes.begin(), sizes.end(), [](double s) { return s > 0.0 && std::isfinite(s); }))
      throw InputError("it has no positive size");
    return field;
  } catch (const InputError& error) {
    throw InputError(fmt::format("cannot read sizes from \"{}\": {}", path.string(), error.what()));
  }
}

}  // namespace octet
