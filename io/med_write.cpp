// SPDX-License-Identifier: BSD-3-Clause
// Groups and attributes by the names that MED's library looks for; arrays by columns, numbers from 1.
#include "io/med_write.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "base/error.h"
#include "io/hdf5_file.h"
#include "io/msh_entities.h"
#include "io/set_names.h"

namespace octet {
namespace {

constexpr std::size_t kLongestMedName = 24;
constexpr std::size_t kGroupName = 80, kAxisName = 16, kDescription = 200;
constexpr const char* kMesh = "/ENS_MAA/mesh";
constexpr const char* kFamilies = "/FAS/mesh";
/// The mesh at its one step of time.
constexpr const char* kStep = "/ENS_MAA/mesh/-0000000000000000001-0000000000000000001";
constexpr const char* kNoProfile = "MED_NO_PROFILE_INTERNAL";

/// An element's name, number of nodes, and these by their places in MSH's.
struct MedElement {
  const char* name;
  std::int32_t geometry;
  std::size_t nodes;
  std::size_t places[kMostNodes];
};
constexpr MedElement kMedElements[2][4] = {
    {{}, {"SE2", 102, 2, {0, 1}}, {"TR3", 203, 3, {0, 1, 2}}, {"TE4", 304, 4, {0, 2, 1, 3}}},
    {{},
     {"SE3", 103, 3, {0, 1, 2}},
     {"TR6", 206, 6, {0, 1, 2, 3, 4, 5}},
     {"T10", 310, 10, {0, 2, 1, 3, 6, 5, 4, 7, 8, 9}}}};

/// A family for each entity with items: positive numbers are families of nodes, negative ones of elements.
std::map<ModelRef, std::int32_t> number_families(const ElementGroups& groups) {
  std::map<ModelRef, std::int32_t> families;
  std::int32_t nodes = 0, elements = 0;
  for (const auto& group : groups.items) families[group.first] = group.first.dim == 0 ? ++nodes : --elements;
  return families;
}

class MedFile {
 public:
  MedFile(OutputFile& file, const Mesh& mesh, const ElementGroups& groups)
      : file_(file), mesh_(mesh), groups_(groups), families_(number_families(groups)) {}

  void begin() {
    file_.group("/INFOS_GENERALES");
    file_.attribute("/INFOS_GENERALES", "MAJ", 3);
    file_.attribute("/INFOS_GENERALES", "MIN", 0);
    file_.attribute("/INFOS_GENERALES", "REL", 0);
    file_.group("/ENS_MAA");
    file_.group(kMesh);
    for (const char* dimension : {"DIM", "ESP"}) file_.attribute(kMesh, dimension, 3);
    for (const char* zero : {"REP", "SRT", "TYP"}) file_.attribute(kMesh, zero, 0);
    file_.attribute(kMesh, "DES", "mesh by Octet", kDescription);
    std::string axes;
    for (const char* axis : {"X", "Y", "Z"}) axes += fmt::format("{:{}}", axis, kAxisName);
    file_.attribute(kMesh, "NOM", axes);
    file_.attribute(kMesh, "UNI", std::string(3 * kAxisName, ' '));
    file_.attribute(kMesh, "UNT", "");
    file_.group(kStep);
    file_.attribute(kStep, "CGT", 1);
    for (const char* number : {"NDT", "NOR"}) file_.attribute(kStep, number, -1);
    file_.attribute(kStep, "PDT", -1.0);
  }

  void write_nodes(double scale) {
    const std::string path = std::string(kStep) + "/NOE";
    begin_items(path);
    const std::uint64_t n = node_count(mesh_);
    file_.array<double>(path + "/COO", {3 * n}, [&](std::uint64_t i) {
      return node_point(mesh_, static_cast<std::uint32_t>(i % n))[static_cast<int>(i / n)] * scale;
    });
    count(path + "/COO", n);
    std::vector<std::int32_t> of(n, 0);
    for (const auto& [entity, items] : groups_.items)
      if (entity.dim == 0)
        for (const std::uint32_t i : items) of[groups_.vertex_nodes[i]] = families_.at(entity);
    write_families(path, of);
  }

  void begin_elements() {
    file_.group(std::string(kStep) + "/MAI");
    file_.attribute(std::string(kStep) + "/MAI", "CGT", 1);
  }

  void write_elements(int dim, const std::vector<std::int32_t>& tags) {
    if (tags.empty()) return;
    const MedElement& kind = kMedElements[mesh_.mid.empty() ? 0 : 1][dim];
    const std::string path = fmt::format("{}/MAI/{}", kStep, kind.name);
    begin_items(path);
    file_.attribute(path, "GEO", kind.geometry);
    const std::uint64_t n = tags.size();
    file_.array<std::int32_t>(path + "/NOD", {kind.nodes * n}, [&](std::uint64_t i) {
      std::uint64_t nodes[kMostNodes];
      element_nodes(mesh_, groups_, dim, static_cast<std::uint32_t>(i % n), nodes);
      return static_cast<std::int32_t>(nodes[kind.places[i / n]]);
    });
    count(path + "/NOD", n);
    std::vector<std::int32_t> of(n);
    for (std::size_t i = 0; i < n; ++i) of[i] = families_.at({dim, tags[i]});
    write_families(path, of);
  }

  void write_groups(const SetNames& names) {
    std::map<ModelRef, std::vector<std::string>> groups_of;
    for (const auto& family : families_) groups_of[family.first] = {names.of.at(family.first)};
    for (const OutlineGroup& set : names.shared)
      for (const int tag : set.tags)
        if (const auto of = groups_of.find({set.dim, tag}); of != groups_of.end())
          of->second.push_back(set.name);
    file_.group("/FAS");
    file_.group(kFamilies);
    const std::string none = std::string(kFamilies) + "/FAMILLE_ZERO";
    file_.group(none);
    file_.attribute(none, "NUM", 0);
    for (const bool nodes : {true, false}) {
      const std::string kind = std::string(kFamilies) + (nodes ? "/NOEUD" : "/ELEME");
      file_.group(kind);
      for (const auto& [entity, family] : families_) {
        if ((entity.dim == 0) != nodes) continue;
        const std::string path = fmt::format("{}/FAM_{}_{}", kind, family, names.of.at(entity));
        file_.group(path);
        file_.attribute(path, "NUM", family);
        file_.group(path + "/GRO");
        const std::vector<std::string>& own = groups_of.at(entity);
        file_.attribute(path + "/GRO", "NBR", static_cast<std::int32_t>(own.size()));
        file_.texts(path + "/GRO/NOM", own, kGroupName);
      }
    }
  }

  void end() { file_.close(); }

 private:
  void begin_items(const std::string& path) {
    file_.group(path);
    for (const char* one : {"CGT", "CGS"}) file_.attribute(path, one, 1);
    file_.attribute(path, "PFL", kNoProfile);
  }

  void count(const std::string& path, std::uint64_t n) {
    file_.attribute(path, "CGT", 1);
    file_.attribute(path, "NBR", static_cast<std::int32_t>(n));
  }

  void write_families(const std::string& path, const std::vector<std::int32_t>& of) {
    file_.array<std::int32_t>(path + "/FAM", {of.size()}, [&](std::uint64_t i) { return of[i]; });
    count(path + "/FAM", of.size());
  }

  Hdf5File file_;
  const Mesh& mesh_;
  const ElementGroups& groups_;
  std::map<ModelRef, std::int32_t> families_;
};

}  // namespace

void write_med(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, double scale) {
  constexpr std::size_t kMost = std::numeric_limits<std::int32_t>::max();
  if (std::max({node_count(mesh), mesh.tets.size(), mesh.triangles.size()}) > kMost)
    throw OutputError("the mesh is too large for a .med file; use MSH 4.1");
  const ElementGroups groups = group_elements(mesh);
  MedFile med(file, mesh, groups);
  med.begin();
  med.write_nodes(scale);
  med.begin_elements();
  med.write_elements(1, mesh.edge_on);
  med.write_elements(2, mesh.triangle_on);
  med.write_elements(3, mesh.tet_in);
  med.write_groups(set_names(complete_outline(outline, mesh), kLongestMedName));
  med.end();
}

}  // namespace octet
