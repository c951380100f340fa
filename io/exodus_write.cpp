// SPDX-License-Identifier: BSD-3-Clause
// Dimensions and variables by the names that readers look for.
#include "io/exodus_write.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "io/face_sides.h"
#include "io/msh_entities.h"
#include "io/netcdf_classic.h"
#include "io/set_names.h"

namespace octet {
namespace {

using Type = NetcdfClassic::Type;
using Dimension = NetcdfClassic::Dimension;

constexpr std::size_t kExodusBlock = 65536;
constexpr std::size_t kLongestExodusName = 32;
constexpr float kExodusVersion = 8.03F;  // of the format

/// The side of a TETRA or TETRA10 by the local number of the vertex that it lacks: side 1 is 1-2-4, side 2
/// 2-3-4, side 3 1-4-3, side 4 1-3-2.
constexpr std::int32_t kExodusSideWithout[4] = {2, 3, 1, 4};

/// Writes value(i) of i below n.
template <class Value>
std::function<void(OutputFile&)> each(std::size_t n, Value value) {
  return [n, value = std::move(value)](OutputFile& file) {
    file.write_blocks(n, kExodusBlock, [&](std::size_t first, std::size_t last, std::string& bytes) {
      for (std::size_t i = first; i < last; ++i) append_file_order(bytes, value(i));
    });
  };
}

std::function<void(OutputFile&)> ints(std::vector<std::int32_t> values) {
  const std::size_t n = values.size();
  return each(n, [values = std::move(values)](std::size_t i) { return values[i]; });
}

/// Texts in fields of kLongestExodusName + 1 characters.
std::function<void(OutputFile&)> texts(std::vector<std::string> values) {
  return [values = std::move(values)](OutputFile& file) {
    for (std::string text : values) {
      text.resize(kLongestExodusName + 1, '\0');
      file.write(text);
    }
  };
}

/// Blocks or sets of one kind: what each has is put into variables that end in its place, from 1.
struct Kind {
  const char* count;  ///< the dimension that counts them
  const char *status, *number, *names;
};
constexpr Kind kElementBlocks = {"num_el_blk", "eb_status", "eb_prop1", "eb_names"};
constexpr Kind kNodeSets = {"num_node_sets", "ns_status", "ns_prop1", "ns_names"};
constexpr Kind kSideSets = {"num_side_sets", "ss_status", "ss_prop1", "ss_names"};

struct Members {
  std::int32_t number = 0;
  std::string name;
  std::vector<std::int32_t> items;  ///< nodes from 1, or elements from 1 as the file numbers them
  std::vector<std::int32_t> sides;  ///< of side sets
};

class ExodusFile {
 public:
  ExodusFile(const Mesh& mesh, const ModelOutline& outline, double scale)
      : mesh_(mesh),
        scale_(scale),
        groups_(group_elements(mesh)),
        names_(set_names(complete_outline(outline, mesh), kLongestExodusName)) {
    head();
    blocks();
    sides();
    nodes();
  }
  void write(OutputFile& file) const { netcdf_.write(file); }

 private:
  void head();
  void blocks();
  void sides();
  void nodes();
  void declare(const Kind& kind, const std::vector<Members>& all);

  const Mesh& mesh_;
  double scale_;
  ElementGroups groups_;
  SetNames names_;
  std::vector<std::int32_t> place_;  ///< of each tetrahedron in the file, from 1
  NetcdfClassic netcdf_;
  Dimension name_{}, axes_{}, nodes_{}, elements_{};
};

void ExodusFile::head() {
  netcdf_.attribute("api_version", kExodusVersion);
  netcdf_.attribute("version", kExodusVersion);
  netcdf_.attribute("floating_point_word_size", std::int32_t{8});
  netcdf_.attribute("file_size", std::int32_t{1});
  netcdf_.attribute("maximum_name_length", static_cast<std::int32_t>(kLongestExodusName));
  netcdf_.attribute("int64_status", std::int32_t{0});
  netcdf_.attribute("title", std::string("mesh by Octet"));
  netcdf_.dimension("len_string", kLongestExodusName + 1);
  name_ = netcdf_.dimension("len_name", kLongestExodusName + 1);
  netcdf_.dimension("len_line", 81);
  netcdf_.dimension("four", 4);
  const Dimension time = netcdf_.records("time_step");
  axes_ = netcdf_.dimension("num_dim", 3);
  netcdf_.variable("time_whole", Type::kDouble, {time}, nullptr);
  if (mesh_.points.empty()) return;
  nodes_ = netcdf_.dimension("num_nodes", node_count(mesh_));
  for (int axis = 0; axis < 3; ++axis)
    netcdf_.variable(fmt::format("coord{}", "xyz"[axis]), Type::kDouble, {nodes_},
                     each(node_count(mesh_), [this, axis](std::size_t v) {
                       return node_point(mesh_, static_cast<std::uint32_t>(v))[axis] * scale_;
                     }));
  netcdf_.variable("coor_names", Type::kChar, {axes_, name_}, texts({"x", "y", "z"}));
}

/// What blocks and sets of a kind have in common.
void ExodusFile::declare(const Kind& kind, const std::vector<Members>& all) {
  if (all.empty()) return;
  const Dimension count = netcdf_.dimension(kind.count, all.size());
  std::vector<std::int32_t> status, numbers;
  std::vector<std::string> names;
  for (const Members& members : all) {
    status.push_back(members.items.empty() ? 0 : 1);
    numbers.push_back(members.number);
    names.push_back(members.name);
  }
  netcdf_.variable(kind.status, Type::kInt, {count}, ints(std::move(status)));
  netcdf_.variable(kind.number, Type::kInt, {count}, ints(std::move(numbers)), {{"name", std::string("ID")}});
  netcdf_.variable(kind.names, Type::kChar, {count, name_}, texts(std::move(names)));
}

void ExodusFile::blocks() {
  if (mesh_.tets.empty()) return;
  const bool second = !mesh_.mid.empty();
  elements_ = netcdf_.dimension("num_elem", mesh_.tets.size());
  place_.resize(mesh_.tets.size());
  std::vector<Members> all;
  std::vector<std::int32_t> own;  // numbers, in the file's order
  own.reserve(mesh_.tets.size());
  for (const auto& [entity, tets] : groups_.items) {
    if (entity.dim != 3) continue;
    all.push_back(
        {entity.tag, names_.of.at(entity), {tets.begin(), tets.begin() + 1}, {}});  // it is not empty
    for (const std::uint32_t tet : tets) {
      own.push_back(static_cast<std::int32_t>(tet + 1));
      place_[tet] = static_cast<std::int32_t>(own.size());
    }
  }
  declare(kElementBlocks, all);
  if (!std::is_sorted(own.begin(), own.end()))
    netcdf_.variable("elem_num_map", Type::kInt, {elements_}, ints(std::move(own)));
  std::size_t block = 0;
  for (const auto& group : groups_.items) {
    if (group.first.dim != 3) continue;
    const std::vector<std::uint32_t>& tets = group.second;
    ++block;
    const std::size_t corners = second ? 10 : 4;
    const Dimension many = netcdf_.dimension(fmt::format("num_el_in_blk{}", block), tets.size());
    const Dimension each_has = netcdf_.dimension(fmt::format("num_nod_per_el{}", block), corners);
    const auto write = [this, &tets, second](OutputFile& file) {
      file.write_blocks(
          tets.size(), kExodusBlock, [&](std::size_t first, std::size_t last, std::string& bytes) {
            for (std::size_t i = first; i < last; ++i) {
              for (const Mesh::Index v : mesh_.tets[tets[i]])
                append_file_order(bytes, static_cast<std::int32_t>(v + 1));
              if (!second) continue;
              for (const std::size_t k : kVtkTetMid)
                append_file_order(bytes, static_cast<std::int32_t>(mesh_.points.size() +
                                                                   mesh_.mid.of_tets[tets[i]][k] + 1));
            }
          });
    };
    netcdf_.variable(fmt::format("connect{}", block), Type::kInt, {many, each_has}, write,
                     {{"elem_type", std::string(second ? "TETRA10" : "TETRA")}});
  }
}

void ExodusFile::sides() {
  const FaceSides sides(mesh_);
  std::vector<Members> all;
  const auto add = [&](int number, const std::string& name, const std::vector<std::uint32_t>& triangles) {
    Members members{number, name, {}, {}};
    for (const std::uint32_t i : triangles) {
      const auto side = sides.of(mesh_.triangles[i]);
      if (!side) continue;  // a triangle of no tetrahedron has no side to tell
      members.items.push_back(place_[side->tet]);
      members.sides.push_back(kExodusSideWithout[side->lacking]);
    }
    all.push_back(std::move(members));
  };
  int last = 0;
  for (const auto& [entity, triangles] : groups_.items) {
    if (entity.dim != 2) continue;
    add(entity.tag, names_.of.at(entity), triangles);
    last = entity.tag;
  }
  for (const OutlineGroup& set : names_.shared)
    if (const auto items = items_of(groups_, set); set.dim == 2 && !items.empty())
      add(++last, set.name, items);
  declare(kSideSets, all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].items.empty()) continue;
    const Dimension many = netcdf_.dimension(fmt::format("num_side_ss{}", i + 1), all[i].items.size());
    netcdf_.variable(fmt::format("elem_ss{}", i + 1), Type::kInt, {many}, ints(std::move(all[i].items)));
    netcdf_.variable(fmt::format("side_ss{}", i + 1), Type::kInt, {many}, ints(std::move(all[i].sides)));
  }
}

void ExodusFile::nodes() {
  const std::array<int, 4> before = before_node_sets(groups_);
  std::vector<Members> all;
  for (int dim = 2; dim >= 0; --dim)
    for (const auto& [entity, items] : groups_.items) {
      if (entity.dim != dim) continue;
      const std::vector<std::uint64_t> nodes = nodes_of_elements(mesh_, groups_, dim, items);
      all.push_back({before[static_cast<std::size_t>(dim)] + entity.tag,
                     names_.of.at(entity),
                     {nodes.begin(), nodes.end()},
                     {}});
    }
  int number = before[3];
  for (const OutlineGroup& set : names_.shared) {
    const auto items = items_of(groups_, set);
    if (items.empty() || set.dim == 3) continue;
    const std::vector<std::uint64_t> nodes = nodes_of_elements(mesh_, groups_, set.dim, items);
    all.push_back({++number, set.name, {nodes.begin(), nodes.end()}, {}});
  }
  declare(kNodeSets, all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].items.empty()) continue;
    const Dimension many = netcdf_.dimension(fmt::format("num_nod_ns{}", i + 1), all[i].items.size());
    netcdf_.variable(fmt::format("node_ns{}", i + 1), Type::kInt, {many}, ints(std::move(all[i].items)));
  }
}

}  // namespace

void write_exodus(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, double scale) {
  constexpr std::size_t kMost = std::numeric_limits<std::int32_t>::max();
  if (std::max(node_count(mesh), mesh.tets.size()) > kMost)
    throw OutputError("the mesh is too large for an Exodus file of 32 bits; use MSH 4.1");
  ExodusFile(mesh, outline, scale).write(file);
}

}  // namespace octet
