// SPDX-License-Identifier: BSD-3-Clause
// Nodes of CGNS as its library lays them out in HDF5: a group each, told by attributes, with its data beside
// its children.
#include "io/cgns_write.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "io/hdf5_file.h"
#include "io/msh_entities.h"
#include "io/set_names.h"

namespace octet {
namespace {

constexpr std::size_t kLongestCgnsName = 32, kTypeName = 2, kVersionText = 32;
constexpr float kCgnsVersion = 3.1f;
/// Beside families, no name of which has a space.
constexpr const char* kZoneName = "Zone 1";

/// An element's number, its nodes, and the place in CGNS' order of each in MSH's.
struct CgnsElement {
  std::int32_t type;
  std::size_t nodes;
  std::size_t places[kMostNodes];
};
constexpr CgnsElement kCgnsElements[2][4] = {
    {{}, {}, {5, 3, {0, 1, 2}}, {10, 4, {0, 1, 2, 3}}},
    {{}, {}, {6, 6, {0, 1, 2, 3, 4, 5}}, {11, 10, {0, 1, 2, 3, 4, 5, 6, 7, 9, 8}}}};

class CgnsFile {
 public:
  explicit CgnsFile(OutputFile& file) : file_(file, Hdf5File::Order::kAsMade) {
    describe("/", "HDF5 MotherNode", "Root Node of HDF5 File", "MT");
    text_array("/ format", std::string("IEEE_LITTLE_32") + '\0');
    std::string version = "HDF5";
    version.resize(kVersionText + 1);
    text_array("/ hdf5version", version);
  }

  /// Without data.
  std::string node(const std::string& parent, const std::string& name, const char* label) {
    return made(parent, name, label, "MT");
  }
  std::string text(const std::string& parent, const std::string& name, const char* label,
                   const std::string& value) {
    const std::string path = made(parent, name, label, "C1");
    text_array(path + "/ data", value);
    return path;
  }
  std::string numbers(const std::string& parent, const std::string& name, const char* label,
                      const std::vector<std::uint64_t>& dims, const std::vector<std::int32_t>& values) {
    return array<std::int32_t>(parent, name, label, "I4", dims, [&](std::uint64_t i) { return values[i]; });
  }
  template <class T, class Value>
  std::string array(const std::string& parent, const std::string& name, const char* label, const char* type,
                    const std::vector<std::uint64_t>& dims, const Value& value) {
    const std::string path = made(parent, name, label, type);
    file_.array<T>(path + "/ data", dims, value);
    return path;
  }

  void end() { file_.close(); }

 private:
  std::string made(const std::string& parent, const std::string& name, const char* label, const char* type) {
    const std::string path = parent + "/" + name;
    file_.group(path);
    describe(path, name, label, type);
    file_.attribute_array(path, "flags", 1);
    return path;
  }

  void describe(const std::string& path, const std::string& name, const char* label, const char* type) {
    file_.attribute(path, "name", name, kLongestCgnsName);
    file_.attribute(path, "label", label, kLongestCgnsName);
    file_.attribute(path, "type", type, kTypeName);
  }

  void text_array(const std::string& path, const std::string& value) {
    file_.array<std::int8_t>(path, {value.size()},
                             [&](std::uint64_t i) { return static_cast<std::int8_t>(value[i]); });
  }

  Hdf5File file_;
};

/// Elements of the sections of the zone, numbered through from 1.
class Sections {
 public:
  Sections(CgnsFile& file, std::string zone, const Mesh& mesh, const ElementGroups& groups)
      : file_(file), zone_(std::move(zone)), mesh_(mesh), groups_(groups) {}

  /// A section of elements of a dimension; returns the numbers of the first and the last.
  std::vector<std::int32_t> add(const std::string& name, int dim, const std::vector<std::uint32_t>& items) {
    const CgnsElement& kind = kCgnsElements[mesh_.mid.empty() ? 0 : 1][dim];
    const std::uint64_t length = items.size() * kind.nodes;
    if (length > std::numeric_limits<std::int32_t>::max()) throw too_large();
    const std::vector<std::int32_t> range{next_, next_ + static_cast<std::int32_t>(items.size()) - 1};
    next_ = range[1] + 1;
    const std::string path = file_.numbers(zone_, name, "Elements_t", {2}, {kind.type, 0});
    file_.numbers(path, "ElementRange", "IndexRange_t", {2}, range);
    file_.array<std::int32_t>(path, "ElementConnectivity", "DataArray_t", "I4", {length},
                              [&](std::uint64_t i) {
                                std::uint64_t nodes[kMostNodes];
                                element_nodes(mesh_, groups_, dim, items[i / kind.nodes], nodes);
                                return static_cast<std::int32_t>(nodes[kind.places[i % kind.nodes]]);
                              });
    return range;
  }

  [[nodiscard]] static OutputError too_large() {
    return OutputError("the mesh is too large for a .cgns file; use MSH 4.1");
  }

 private:
  CgnsFile& file_;
  std::string zone_;
  const Mesh& mesh_;
  const ElementGroups& groups_;
  std::int32_t next_ = 1;
};

/// Names of sections and conditions, which have places of their own beside the zone's other nodes.
std::map<ModelRef, std::string> section_names(const SetNames& names) {
  std::set<std::string> taken{"GridCoordinates", "ZoneBC", "ZoneType"};
  for (const auto& own : names.of) taken.insert(own.second);
  std::map<ModelRef, std::string> sections = names.of;
  for (auto& [entity, name] : sections)
    if (name == "GridCoordinates" || name == "ZoneBC" || name == "ZoneType")
      while (!taken.insert(name).second) name += '_';
  return sections;
}

/// Names of the groups of faces that each face is in.
std::map<int, std::vector<std::string>> face_groups(const SetNames& names) {
  std::map<int, std::vector<std::string>> groups;
  for (const OutlineGroup& group : names.shared)
    if (group.dim == 2)
      for (const int tag : group.tags) groups[tag].push_back(group.name);
  return groups;
}

}  // namespace

void write_cgns(OutputFile& output, const Mesh& mesh, const ModelOutline& outline, double scale) {
  const std::uint64_t nodes = node_count(mesh);
  constexpr std::uint64_t kMost = std::numeric_limits<std::int32_t>::max();
  if (nodes > kMost || mesh.tets.size() + mesh.triangles.size() > kMost) throw Sections::too_large();
  const ElementGroups groups = group_elements(mesh);
  const SetNames names = set_names(complete_outline(outline, mesh), kLongestCgnsName);
  CgnsFile file(output);
  file.array<float>("", "CGNSLibraryVersion", "CGNSLibraryVersion_t", "R4", {1},
                    [](std::uint64_t) { return kCgnsVersion; });
  const std::string base = file.numbers("", "mesh", "CGNSBase_t", {2}, {3, 3});
  const std::string zone =
      file.numbers(base, kZoneName, "Zone_t", {3, 1},
                   {static_cast<std::int32_t>(nodes), static_cast<std::int32_t>(mesh.tets.size()), 0});
  file.text(zone, "ZoneType", "ZoneType_t", "Unstructured");
  const std::string grid = file.node(zone, "GridCoordinates", "GridCoordinates_t");
  for (int axis = 0; axis < 3; ++axis)
    file.array<double>(
        grid, std::string("Coordinate") + "XYZ"[axis], "DataArray_t", "R8", {nodes},
        [&](std::uint64_t i) { return node_point(mesh, static_cast<std::uint32_t>(i))[axis] * scale; });
  Sections sections(file, zone, mesh, groups);
  const std::map<ModelRef, std::string> name_of = section_names(names);
  std::vector<std::pair<int, std::vector<std::int32_t>>> faces;
  for (const int dim : {3, 2})
    for (const auto& [entity, items] : groups.items)
      if (entity.dim == dim) {
        std::vector<std::int32_t> range = sections.add(name_of.at(entity), dim, items);
        if (dim == 2) faces.emplace_back(entity.tag, std::move(range));
      }
  const auto further = face_groups(names);
  if (!faces.empty()) {
    const std::string conditions = file.node(zone, "ZoneBC", "ZoneBC_t");
    for (const auto& [tag, range] : faces) {
      const std::string& name = name_of.at(model_face(tag));
      const std::string condition = file.text(conditions, name, "BC_t", "FamilySpecified");
      file.numbers(condition, "PointRange", "IndexRange_t", {2, 1}, range);
      file.text(condition, "GridLocation", "GridLocation_t", "FaceCenter");
      file.text(condition, "FamilyName", "FamilyName_t", name);
      if (const auto in = further.find(tag); in != further.end())
        for (std::size_t i = 0; i < in->second.size(); ++i)
          file.text(condition, "AdditionalFamilyName" + std::to_string(i + 1), "AdditionalFamilyName_t",
                    in->second[i]);
    }
  }
  for (const auto& [tag, range] : faces) file.node(base, name_of.at(model_face(tag)), "Family_t");
  for (const OutlineGroup& group : names.shared)
    if (group.dim == 2) file.node(base, group.name, "Family_t");
  file.end();
}

}  // namespace octet
