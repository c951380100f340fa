// SPDX-License-Identifier: BSD-3-Clause
// Columns as wide as what is in them.
#include "app/entity_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "app/ids_in_file.h"
#include "app/marks_text.h"
#include "app/words.h"
#include "base/constants.h"
#include "base/entity_words.h"

namespace octet {
namespace {

/// Rows of cells, each column as wide as its widest cell, up to what few cells need.
class Columns {
 public:
  explicit Columns(std::vector<std::string> heading) { add(std::move(heading)); }
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  [[nodiscard]] std::string text() const {
    constexpr std::size_t kWidest = 40;
    std::vector<std::size_t> width(rows_.front().size(), 0);
    for (const auto& row : rows_)
      for (std::size_t c = 0; c + 1 < row.size(); ++c)
        width[c] = std::max(width[c], std::min(row[c].size(), kWidest));
    std::string text;
    for (const auto& row : rows_) {
      std::string line;
      for (std::size_t c = 0; c < row.size(); ++c) line += fmt::format("  {:<{}}", row[c], width[c]);
      line.erase(line.find_last_not_of(' ') + 1);
      text += line + "\n";
    }
    return text;
  }

 private:
  std::vector<std::vector<std::string>> rows_;
};

std::string tag_text(ModelRef entity) {
  return fmt::format("{}{}", entity_word(entity.dim), entity.tag);
}

std::string face_shape_text(const FaceShape& face) {
  if (!face.round) return "normal " + place_text(face.normal);
  const RoundShape& round = *face.round;
  std::string text;
  if (round.half_angle > 0.0)
    text = fmt::format("radius {:.6g} to {:.6g}, half angle {:.6g} deg, axis {}, apex {}", face.radii[0],
                       face.radii[1], round.half_angle * kInDegrees, place_text(round.axis),
                       place_text(round.origin));
  else if (round.minor_radius > 0.0)
    text = fmt::format("radii {:.6g} and {:.6g}, axis {} at {}", round.radius, round.minor_radius,
                       place_text(round.axis), place_text(round.origin));
  else if (round.axis.isZero())
    text = fmt::format("radius {:.6g} about {}", round.radius, place_text(round.origin));
  else
    text = fmt::format("radius {:.6g}, axis {}", round.radius, place_text(round.axis)) +
           (place_text(round.origin) == place_text(face.centre) ? "" : " at " + place_text(round.origin));
  return text + (face.concave ? ", concave" : "");
}

const char* use_text(EdgeUse use) {
  return use == EdgeUse::kSeam ? ", seam" : use == EdgeUse::kDegenerate ? ", no length" : "";
}

std::string edge_kind(const Model& model, int tag) {
  const EdgeUse use = model.edge(tag).use;
  return std::string(use == EdgeUse::kDegenerate ? "point" : model.curve(tag).kind()) + use_text(use);
}

std::string edge_shape_text(const Model& model, int tag, const EdgeShape& edge) {
  std::string text = place_text(edge.ends[0]);
  if (model.edge(tag).vertex[0] != model.edge(tag).vertex[1]) text += " to " + place_text(edge.ends[1]);
  if (!edge.arc) return text;
  const auto& [large, small] = edge.arc->radii;
  return text +
         (large == small ? fmt::format(", radius {:.6g}", large)
                         : fmt::format(", radii {:.6g} and {:.6g}", large, small)) +
         " about " + place_text(edge.arc->centre);
}

/// Name, marks, the numbers as read where they are others, and what the file calls them.
class LineEnds {
 public:
  LineEnds(const Model& model, int dim)
      : dim_(static_cast<std::size_t>(dim)),
        sources_(sources(model.provenance(), dim, model.count(dim))),
        ids_(model) {}

  [[nodiscard]] std::string of(int tag, const std::string& name, const std::string& marks) const {
    std::string text = (name.empty() ? std::string() : fmt::format("\"{}\"", name)) + marks;
    const auto at = static_cast<std::size_t>(tag);
    if (at < sources_.size() && !sources_[at].empty() && sources_[at] != std::vector<int>{tag})
      text += fmt::format(" ({} as read)", tag_list(shape_word(static_cast<int>(dim_)), sources_[at]));
    text += ids_.text({static_cast<std::int32_t>(dim_), tag});
    return text.substr(std::min(text.find_first_not_of(' '), text.size()));
  }

 private:
  std::size_t dim_;
  std::vector<std::vector<int>> sources_;
  IdsInFile ids_;
};

std::string region_lines(const Model& model, const EntityShapes& shapes) {
  const LineEnds ends(model, 3);
  Columns columns({"regions", "mm^3", "faces", "centre", "box", ""});
  for (int r = 1; r <= model.count(3); ++r) {
    const ModelRegion& region = model.region(r);
    const RegionShape& shape = shapes.regions[static_cast<std::size_t>(r)];
    const std::string marks =
        marks_text(region.colour, region.layer) + material_text(region.material, region.density);
    columns.add({tag_text(model_region(r)), fmt::format("{:.6g}", region.volume),
                 std::to_string(region.faces.size()), place_text(shape.centre),
                 place_text(shape.box.lo) + " to " + place_text(shape.box.hi),
                 ends.of(r, region.name, marks)});
  }
  return columns.text();
}

std::string face_lines(const Model& model, const EntityShapes& shapes) {
  const LineEnds ends(model, 2);
  Columns columns({"faces", "", "mm^2", "regions", "tolerance", "centre", "shape", ""});
  for (int f = 1; f <= model.count(2); ++f) {
    const ModelFace& face = model.face(f);
    const FaceShape& shape = shapes.faces[static_cast<std::size_t>(f)];
    columns.add({tag_text(model_face(f)), model.surface(f).kind(), fmt::format("{:.6g}", face.area),
                 fmt::format("{} | {}", face.region[0], face.region[1]),
                 fmt::format("{:.2g}", face.tolerance), place_text(shape.centre), face_shape_text(shape),
                 ends.of(f, face.name, marks_text(face.colour, face.layer))});
  }
  return columns.text();
}

std::string edge_lines(const Model& model, const EntityShapes& shapes) {
  const LineEnds ends(model, 1);
  Columns columns({"edges", "", "mm", "tolerance", "faces", "ends", ""});
  for (int e = 1; e <= model.count(1); ++e) {
    const ModelEdge& edge = model.edge(e);
    columns.add({tag_text(model_edge(e)), edge_kind(model, e), fmt::format("{:.6g}", edge.length),
                 fmt::format("{:.2g}", edge.tolerance), tag_list("Face", edge.faces),
                 edge_shape_text(model, e, shapes.edges[static_cast<std::size_t>(e)]),
                 ends.of(e, edge.name, marks_text(edge.colour, edge.layer))});
  }
  return columns.text();
}

std::string vertex_lines(const Model& model) {
  const LineEnds ends(model, 0);
  Columns columns({"vertices", "", "tolerance", ""});
  for (int v = 1; v <= model.count(0); ++v) {
    const ModelVertex& vertex = model.vertex(v);
    columns.add({tag_text(model_vertex(v)), place_text(without_rounding(model, vertex.point)),
                 fmt::format("{:.2g}", vertex.tolerance), ends.of(v, vertex.name, "")});
  }
  return columns.text();
}

std::string where_text(const Model& model, const AtPlace& at) {
  std::string regions;
  for (const int r : at.regions)
    regions += (regions.empty() ? "" : " and ") + model.describe(model_region(r));
  if (at.on.valid()) return "on " + model.describe(at.on) + (regions.empty() ? "" : ", of " + regions);
  return regions.empty() ? "outside" : "in " + regions;
}

std::string entity_text(const Model& model, const EntityShapes& shapes, ModelRef entity) {
  const auto at = static_cast<std::size_t>(entity.tag);
  switch (entity.dim) {
    case 0:
      return place_text(without_rounding(model, model.vertex(entity.tag).point));
    case 1:
      return edge_kind(model, entity.tag) + " " + edge_shape_text(model, entity.tag, shapes.edges[at]);
    default:
      return fmt::format("{}, {}", model.surface(entity.tag).kind(), face_shape_text(shapes.faces[at]));
  }
}

}  // namespace

std::string entity_table(const Model& model, const EntityShapes& shapes) {
  return region_lines(model, shapes) + face_lines(model, shapes) + edge_lines(model, shapes) +
         vertex_lines(model);
}

std::string place_lines(const Model& model, const EntityShapes& shapes, const AtPlace& at) {
  Columns near({"  nearest", "mm away", "at", ""});
  for (const NearEntity& item : at.nearest)
    near.add({"  " + tag_text(item.entity), fmt::format("{:.6g}", item.distance),
              place_text(without_rounding(model, item.point)), entity_text(model, shapes, item.entity)});
  return fmt::format("  at {}: {}\n", place_text(at.place), where_text(model, at)) + near.text();
}

}  // namespace octet
