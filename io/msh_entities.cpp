// SPDX-License-Identifier: BSD-3-Clause
// Grouping by entity keeps the mesh's own numbers as tags, so that a reader gets its order back.
#include "io/msh_entities.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <set>

#include "base/sort_unique.h"
#include "io/set_names.h"

namespace octet {
namespace {

constexpr std::size_t kLongestMshName = 127;  // MSH's limit

/// Cut to `limit` bytes, not within a UTF-8 character.
std::string shortened(std::string name, std::size_t limit) {
  if (name.size() <= limit) return name;
  while (limit > 0 && (static_cast<unsigned char>(name[limit]) & 0xC0) == 0x80) --limit;
  name.resize(limit);
  return name;
}

/// Adds items 0..n-1 of one dimension. The last entity is kept at hand: neighbours mostly share it.
template <class EntityOf>
void add_items(ItemsOn& items, std::size_t n, const EntityOf& entity_of) {
  ModelRef last;
  std::vector<std::uint32_t>* list = nullptr;
  for (std::size_t i = 0; i < n; ++i) {
    const ModelRef ref = entity_of(static_cast<std::uint32_t>(i));
    if (list == nullptr || ref != last) {
      list = &items[ref];
      last = ref;
    }
    list->push_back(static_cast<std::uint32_t>(i));
  }
}

std::map<ModelRef, Box3> mesh_boxes(const Mesh& mesh) {
  std::map<ModelRef, Box3> boxes;
  for (const auto& [ref, nodes] : group_nodes(mesh))
    for (const std::uint32_t v : nodes) boxes[ref].add(node_point(mesh, v));
  const ElementGroups groups = group_elements(mesh);
  for (const auto& [ref, items] : groups.items) {
    Box3& box = boxes[ref];
    std::uint64_t nodes[kMostNodes];
    for (const std::uint32_t i : items) {
      const int n = element_nodes(mesh, groups, ref.dim, i, nodes);
      for (int k = 0; k < n; ++k) box.add(node_point(mesh, static_cast<std::uint32_t>(nodes[k] - 1)));
    }
  }
  return boxes;
}

/// All entities that the mesh names.
std::set<ModelRef> entities_of(const Mesh& mesh) {
  std::set<ModelRef> entities;
  ModelRef last;
  const auto add = [&](ModelRef ref) {
    if (ref != last) entities.insert(ref);
    last = ref;
  };
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) add(node_entity(mesh, v));
  for (const std::int32_t tag : mesh.edge_on) add(model_edge(tag));
  for (const std::int32_t tag : mesh.triangle_on) add(model_face(tag));
  for (const std::int32_t tag : mesh.tet_in) add(model_region(tag));
  return entities;
}

OutlineEntity& entity_in(std::vector<OutlineEntity>& entities, int tag) {
  const auto at = std::lower_bound(entities.begin(), entities.end(), tag,
                                   [](const OutlineEntity& e, int t) { return e.tag < t; });
  if (at != entities.end() && at->tag == tag) return *at;
  OutlineEntity made;
  made.tag = tag;
  return *entities.insert(at, made);
}

bool exists_in(const std::vector<OutlineEntity>& entities, int tag) {
  return std::any_of(entities.begin(), entities.end(), [tag](const auto& e) { return e.tag == tag; });
}

}  // namespace

std::array<double, 16> scaled_motion(const PeriodicLink& link, double scale) {
  std::array<double, 16> motion = link.motion;
  for (const std::size_t shift : {3, 7, 11}) motion[shift] *= scale;
  return motion;
}

std::string printable(std::string name) {
  for (char& c : name) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
    if (c == '"') c = '\'';
  }
  return name;
}

std::size_t node_count(const Mesh& mesh) { return mesh.points.size() + mesh.mid.points.size(); }

const Vec3& node_point(const Mesh& mesh, std::uint32_t node) {
  return node < mesh.points.size() ? mesh.points[node] : mesh.mid.points[node - mesh.points.size()];
}

ModelRef node_entity(const Mesh& mesh, std::uint32_t node) {
  const ModelRef ref =
      node < mesh.points.size() ? mesh.point_on[node] : mesh.mid.on[node - mesh.points.size()];
  return ref.dim >= 0 && ref.dim <= 3 ? ref : ModelRef{3, 0};
}

ItemsOn group_nodes(const Mesh& mesh) {
  ItemsOn items;
  add_items(items, node_count(mesh), [&](std::uint32_t v) { return node_entity(mesh, v); });
  return items;
}

ElementGroups group_elements(const Mesh& mesh) {
  ElementGroups groups;
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v)
    if (node_entity(mesh, v).dim == 0) groups.vertex_nodes.push_back(v);
  const std::size_t counts[4] = {groups.vertex_nodes.size(), mesh.edges.size(), mesh.triangles.size(),
                                 mesh.tets.size()};
  for (int dim = 0; dim < 4; ++dim) {
    groups.first_tag[dim] = groups.total + 1;
    groups.total += counts[dim];
  }
  add_items(groups.items, counts[0],
            [&](std::uint32_t i) { return node_entity(mesh, groups.vertex_nodes[i]); });
  add_items(groups.items, counts[1], [&](std::uint32_t i) { return model_edge(mesh.edge_on[i]); });
  add_items(groups.items, counts[2], [&](std::uint32_t i) { return model_face(mesh.triangle_on[i]); });
  add_items(groups.items, counts[3], [&](std::uint32_t i) { return model_region(mesh.tet_in[i]); });
  return groups;
}

std::vector<std::uint32_t> items_of(const ElementGroups& groups, const OutlineGroup& group) {
  std::vector<std::uint32_t> items;
  for (const int tag : group.tags) {
    const auto found = groups.items.find({group.dim, tag});
    if (found != groups.items.end()) items.insert(items.end(), found->second.begin(), found->second.end());
  }
  std::sort(items.begin(), items.end());
  return items;
}

int element_nodes(const Mesh& mesh, const ElementGroups& groups, int dim, std::uint32_t i,
                  std::uint64_t nodes[kMostNodes], const std::size_t (&tet_mid)[6]) {
  int n = 0;
  const auto add = [&](const auto& element) {
    for (const Mesh::Index v : element) nodes[n++] = std::uint64_t{v} + 1;
  };
  const auto add_mid = [&](Mesh::Index m) { nodes[n++] = mesh.points.size() + m + 1; };
  const bool second = !mesh.mid.empty();
  switch (dim) {
    case 0:
      nodes[n++] = std::uint64_t{groups.vertex_nodes[i]} + 1;
      break;
    case 1:
      add(mesh.edges[i]);
      if (second) add_mid(mesh.mid.of_edges[i]);
      break;
    case 2:
      add(mesh.triangles[i]);
      if (second)
        for (const Mesh::Index m : mesh.mid.of_triangles[i]) add_mid(m);
      break;
    default:
      add(mesh.tets[i]);
      if (second)
        for (const std::size_t e : tet_mid) add_mid(mesh.mid.of_tets[i][e]);
  }
  return n;
}

std::vector<std::uint64_t> nodes_of_elements(const Mesh& mesh, const ElementGroups& groups, int dim,
                                             const std::vector<std::uint32_t>& items) {
  std::vector<std::uint64_t> nodes;
  for (const std::uint32_t i : items) {
    std::uint64_t own[kMostNodes];
    nodes.insert(nodes.end(), own, own + element_nodes(mesh, groups, dim, i, own));
  }
  sort_unique(nodes);
  return nodes;
}

std::array<int, 4> before_node_sets(const ElementGroups& groups) {
  int most[4] = {};  // tags by dimension
  for (const auto& group : groups.items)
    most[group.first.dim] = std::max(most[group.first.dim], group.first.tag);
  return {most[2] + most[1], most[2], 0, most[2] + most[1] + most[0]};
}

std::map<ModelRef, std::string> physical_names(const ModelOutline& outline, const ElementGroups& groups) {
  std::map<std::string, int> uses;
  for (const auto& entities : outline.entities)
    for (const auto& e : entities)
      if (!e.name.empty()) ++uses[shortened(printable(e.name), kLongestMshName)];
  std::map<ModelRef, std::string> names;
  std::set<std::string> taken;
  for (const OutlineGroup& group : outline.groups)
    taken.insert(shortened(printable(group.name), kLongestMshName));
  for (int dim = 0; dim < 4; ++dim)
    for (const auto& e : outline.entities[dim]) {
      if (e.tag <= 0 || (e.name.empty() && !groups.items.contains({dim, e.tag}))) continue;
      const std::string own = entity_name({dim, e.tag});
      std::string name = shortened(printable(e.name), kLongestMshName);
      // A name that several entities share gets the entity's own beside it, for readers look groups up by
      // name.
      if (name.empty()) {
        name = own;
      } else if (uses[name] > 1) {
        name = shortened(name, kLongestMshName - own.size() - 1) + " " + own;
      }
      while (!taken.insert(name).second) name = shortened(name, kLongestMshName - own.size() - 1) + " " + own;
      names[{dim, e.tag}] = name;
    }
  return names;
}

std::vector<PhysicalSet> physical_sets(const ModelOutline& outline, const ElementGroups& groups,
                                       const std::map<ModelRef, std::string>& names) {
  std::set<std::string> taken;
  for (const auto& entity : names) taken.insert(entity.second);
  std::array<int, 4> number{};
  for (int dim = 0; dim < 4; ++dim)
    for (const OutlineEntity& e : outline.entities[dim]) number[dim] = std::max(number[dim], e.tag);
  std::vector<PhysicalSet> sets;
  const auto add = [&](OutlineGroup group, const char* behind) {
    if (items_of(groups, group).empty()) return;
    group.name = shortened(printable(group.name), kLongestMshName);
    while (!taken.insert(group.name).second)
      group.name = shortened(group.name, kLongestMshName - std::strlen(behind)) + behind;
    const int dim = group.dim;
    sets.push_back({std::move(group), ++number[dim]});
  };
  for (const OutlineGroup& group : outline.groups) add(group, " group");
  constexpr const char* kKinds[4] = {" vertices", " edges", " faces", " solids"};
  for (int dim = 3; dim >= 0; --dim) {
    std::map<std::string, OutlineGroup> of_name;
    for (const OutlineEntity& e : outline.entities[dim]) {
      if (e.name.empty()) continue;
      const std::string name = shortened(printable(e.name), kLongestMshName);
      OutlineGroup& group = of_name[name];
      group.name = name;
      group.dim = dim;
      group.tags.push_back(e.tag);
    }
    for (const auto& [name, group] : of_name)
      if (group.tags.size() > 1) add(group, kKinds[dim]);
  }
  return sets;
}

std::string physical_names_section(const std::map<ModelRef, std::string>& names,
                                   const std::vector<PhysicalSet>& sets) {
  if (names.empty()) return {};
  std::string text = fmt::format("$PhysicalNames\n{}\n", names.size() + sets.size());
  for (const auto& [ref, name] : names) text += fmt::format("{} {} \"{}\"\n", ref.dim, ref.tag, name);
  for (const PhysicalSet& set : sets) text += fmt::format("{} {} \"{}\"\n", set.dim, set.number, set.name);
  return text + "$EndPhysicalNames\n";
}

ModelOutline complete_outline(const ModelOutline& outline, const Mesh& mesh) {
  ModelOutline whole = outline;
  for (auto& entities : whole.entities)
    std::sort(entities.begin(), entities.end(), [](const auto& a, const auto& b) { return a.tag < b.tag; });
  std::set<ModelRef> without_box = entities_of(mesh);
  for (int dim = 0; dim < 4; ++dim)
    for (const OutlineEntity& e : whole.entities[dim])
      if (!e.box.empty()) without_box.erase({dim, e.tag});
  if (!without_box.empty())
    for (const auto& [ref, box] : mesh_boxes(mesh))
      if (without_box.contains(ref)) entity_in(whole.entities[ref.dim], ref.tag).box = box;
  for (int dim = 0; dim < 4; ++dim)
    for (auto& e : whole.entities[dim]) {
      if (e.box.empty()) e.box = {Vec3::Zero(), Vec3::Zero()};
      std::erase_if(e.bounded_by,
                    [&](int tag) { return dim == 0 || !exists_in(whole.entities[dim - 1], std::abs(tag)); });
    }
  return whole;
}

}  // namespace octet
