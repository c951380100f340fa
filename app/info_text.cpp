// SPDX-License-Identifier: BSD-3-Clause
// One line per fact; long lists are cut, --json gives them whole.
#include "app/info_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/marks_text.h"
#include "app/words.h"
#include "base/entity_words.h"

namespace octet {
namespace {

constexpr std::size_t kShown = 20;

/// A heading with the number of items, and the first of them.
std::string listed(const char* heading, const std::vector<std::string>& items) {
  std::string text = fmt::format("  {:<9}{}\n", heading, items.size());
  for (std::size_t i = 0; i < items.size() && i < kShown; ++i) text += fmt::format("    {}\n", items[i]);
  if (items.size() > kShown)
    text += fmt::format("    and {} more (--json lists all)\n", items.size() - kShown);
  return text;
}

std::string node_text(const PartNode& node, int depth) {
  std::string text(static_cast<std::size_t>(2 * depth), ' ');
  text += node.name.empty() ? std::string("(no name)") : fmt::format("\"{}\"", node.name);
  if (!node.instance.empty()) text += fmt::format(" as \"{}\"", node.instance);
  if (!node.regions.empty()) text += ": Region " + tag_list("", node.regions);
  return text + marks_text(node.colour, node.layer) + material_text(node.material, node.density);
}

std::string tree_lines(const Model& model) {
  const std::vector<PartNode>& tree = model.provenance().tree;
  if (tree.empty()) return {};
  std::vector<std::string> lines;
  std::vector<int> depth;
  for (const PartNode& node : tree) {
    depth.push_back(node.parent < 0 ? 0 : depth[static_cast<std::size_t>(node.parent)] + 1);
    lines.push_back(node_text(node, depth.back()));
  }
  return listed("parts", lines);
}

std::string name_lines(const Model& model) {
  std::vector<std::string> names;
  const auto add = [&](ModelRef entity, const std::string& name) {
    if (!name.empty()) names.push_back(model.describe(entity));
  };
  for (int r = 1; r <= model.count(3); ++r) add(model_region(r), model.region(r).name);
  for (int f = 1; f <= model.count(2); ++f) add(model_face(f), model.face(f).name);
  for (int e = 1; e <= model.count(1); ++e) add(model_edge(e), model.edge(e).name);
  for (int v = 1; v <= model.count(0); ++v) add(model_vertex(v), model.vertex(v).name);
  return names.empty() ? std::string("  names    none\n") : listed("names", names);
}

std::string smallest_lines(const Model& model, const PartInfo& info) {
  std::string text;
  if (info.smallest_edge > 0)
    text += fmt::format("  smallest edge  {}, {:.6g} mm\n", model.describe(model_edge(info.smallest_edge)),
                        model.edge(info.smallest_edge).length);
  if (info.smallest_face > 0)
    text += fmt::format("  smallest face  {}, {:.6g} mm^2\n", model.describe(model_face(info.smallest_face)),
                        model.face(info.smallest_face).area);
  if (info.widest_gap.tag > 0)
    text += fmt::format("  widest gap     {}, {:.3g} mm\n", model.describe(info.widest_gap),
                        model.tolerance_of(info.widest_gap));
  if (info.thinnest)
    text += fmt::format("  thinnest wall  {:.6g} mm at {}, from {} to {}\n", info.thinnest->thickness,
                        place_text(info.thinnest->from), model.describe(model_face(info.thinnest->face)),
                        model.describe(model_face(info.thinnest->opposite)));
  return text;
}

std::string interface_lines(const Model& model, const PartInfo& info) {
  if (info.interfaces.empty()) return {};
  std::vector<std::string> lines;
  for (const Interface& shared : info.interfaces)
    lines.push_back(fmt::format("{} | {}: {}, {:.6g} mm^2", model.describe(model_region(shared.regions[0])),
                                model.describe(model_region(shared.regions[1])),
                                tag_list("Face", shared.faces), shared.area));
  return listed("contacts", lines);
}

std::string touching_lines(const Model& model, const PartInfo& info) {
  if (info.touching.empty()) return {};
  std::vector<std::string> lines;
  for (const FaceContact& contact : info.touching)
    lines.push_back(fmt::format("Face{} of {} and Face{} of {}: {:.6g} mm^2 at {}", contact.face[0],
                                model.describe(model_region(contact.region[0])), contact.face[1],
                                model.describe(model_region(contact.region[1])), contact.area,
                                place_text(contact.place)));
  return listed("touching", lines);
}

std::string solid_text(const Model& model, int number) {
  const std::string& name = model.provenance().as_read[3][static_cast<std::size_t>(number)].name;
  return name.empty() ? fmt::format("Solid {}", number) : fmt::format("Solid {} \"{}\"", number, name);
}

std::string overlap_lines(const Model& model, const PartInfo& info) {
  if (info.overlaps.empty()) return {};
  std::vector<std::string> lines;
  for (const Overlap& overlap : info.overlaps) {
    std::string solids;
    for (const int number : overlap.solids)
      solids += (solids.empty() ? "" : " and ") + solid_text(model, number);
    lines.push_back(fmt::format("{} share Region {}, {:.6g} mm^3", solids, overlap.region,
                                model.region(overlap.region).volume));
  }
  return listed("overlaps", lines);
}

std::string change_lines(const PartInfo& info) {
  if (info.changes.empty()) return {};
  std::vector<std::string> lines;
  // Faces and solids are what users name; edges and vertices follow from them.
  for (auto it = info.changes.rbegin(); it != info.changes.rend(); ++it) {
    const char* kind = shape_word(it->as_read.dim);
    const char* now = it->as_read.dim == 3 ? "Region" : kind;
    lines.push_back(fmt::format("{}{} as read is {}", kind, it->as_read.tag, tag_list(now, it->tags)));
  }
  std::stable_sort(lines.begin(), lines.end(),
                   [](const std::string& a, const std::string& b) { return (a[0] == 'S') > (b[0] == 'S'); });
  return listed("numbers", lines);
}

std::string left_out_lines(const Model& model) {
  if (model.provenance().left_out.empty()) return {};
  std::vector<std::string> lines;
  for (const LeftOut& item : model.provenance().left_out)
    lines.push_back(fmt::format("{}{} as read{}, {:.6g} mm{}, at {}", shape_word(item.entity.dim),
                                item.entity.tag, item.name.empty() ? "" : " \"" + item.name + "\"",
                                item.measure,
                                item.entity.dim == 3   ? "^3"
                                : item.entity.dim == 2 ? "^2"
                                                       : "",
                                place_text(item.place)));
  return listed("left out", lines);
}

std::string fault_summary(const Model& model, const PartInfo& info) {
  std::string text;
  for (const Fault& fault : model.parts().faults)
    text +=
        fmt::format("  fault    {}{} at {}\n", fault.entity.valid() ? model.describe(fault.entity) + " " : "",
                    fault.cause, place_text(fault.place));
  if (!info.free_edges.empty())
    text += fmt::format("  free edges       {}\n", tag_list("Edge", info.free_edges));
  if (!info.contact.edges.empty())
    text += fmt::format("  shared edges     {} (more than two faces of one solid)\n",
                        tag_list("Edge", info.contact.edges));
  for (const int dim : {1, 2}) {
    std::vector<int> tags;
    for (const TinyFeature& feature : info.tiny)
      if (feature.entity.dim == dim) tags.push_back(feature.entity.tag);
    if (!tags.empty())
      text += fmt::format("  {}    {} (no {} than the gaps around)\n",
                          dim == 1 ? "tiny edges   " : "sliver faces ", tag_list(shape_word(dim), tags),
                          dim == 1 ? "longer" : "wider");
  }
  if (!info.contact.vertices.empty())
    text += fmt::format("  pinched vertices {} (the boundary touches itself)\n",
                        tag_list("Vertex", info.contact.vertices));
  for (const FaceCrossing& crossing : info.crossings) {
    const std::string first = model.describe(model_face(crossing.face[0]));
    text += fmt::format("  crossing         {} crosses {} at {}, by {:.3g} mm or more\n", first,
                        crossing.is_of_itself() ? "itself" : model.describe(model_face(crossing.face[1])),
                        place_text(crossing.place), crossing.depth);
  }
  if (!info.dangling_faces.empty())
    text += fmt::format("  dangling faces   {}\n", tag_list("Face", info.dangling_faces));
  return text.empty() ? "  faults   none: every face bounds a region or lies in one, every edge joins faces\n"
                      : text;
}

}  // namespace

std::string part_text(const Model& model, const PartInfo& info) {
  const Vec3 size = info.box.size();
  std::string text = fmt::format("  unit     {} (lengths below are millimetre)\n", model.unit());
  text += fmt::format("  size     {:.6g} x {:.6g} x {:.6g}, diagonal {:.6g}\n", size.x(), size.y(), size.z(),
                      info.box.diagonal());
  text += fmt::format("  box      {} to {}\n", place_text(info.box.lo), place_text(info.box.hi));
  text += fmt::format("  volume   {:.6g} mm^3, area {:.6g} mm^2\n", info.volume, info.area);
  text += fmt::format("  counts   {} regions, {} faces, {} edges ({} seams, {} degenerate), {} vertices\n",
                      model.count(3), model.count(2), model.count(1), info.seams, info.degenerate,
                      model.count(0));
  text += tree_lines(model) + interface_lines(model, info) + touching_lines(model, info) +
          overlap_lines(model, info);
  text += smallest_lines(model, info);
  text += fmt::format("  default mesh size {:.6g} mm\n", info.default_size);
  text += name_lines(model) + change_lines(info) + left_out_lines(model);
  if (!info.embedded_faces.empty())
    text += fmt::format("  embedded faces   {}\n", tag_list("Face", info.embedded_faces));
  text += fault_summary(model, info);
  for (const std::string& note : model.notes()) text += fmt::format("  note     {}\n", note);
  return text;
}

}  // namespace octet
