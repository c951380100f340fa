// SPDX-License-Identifier: BSD-3-Clause
// Takes the model apart, and puts meshes and reports together again under the whole model's tags.
#include "app/apart.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <utility>

#include "app/edge_divisions.h"
#include "app/scaled_sizes.h"
#include "app/watched_observer.h"
#include "geom/bodies.h"
#include "geom/sizing.h"

namespace octet {
namespace {

constexpr std::size_t kFaultsTold = 10;

const std::vector<int>& whole_tags(const Model& body, std::size_t dim) { return body.parts().whole_tag[dim]; }

ModelRef whole_ref(const Model& body, ModelRef ref) {
  if (!ref.valid() || ref.dim > 3) return ref;
  return {ref.dim, whole_tags(body, static_cast<std::size_t>(ref.dim))[static_cast<std::size_t>(ref.tag)]};
}

void append_mesh(const Model& body, const Mesh& part, Mesh& mesh) {
  const auto first = static_cast<Mesh::Index>(mesh.points.size());
  const auto add = [first](const auto& from, auto& to) {
    for (auto element : from) {
      for (Mesh::Index& v : element) v += first;
      to.push_back(element);
    }
  };
  mesh.points.insert(mesh.points.end(), part.points.begin(), part.points.end());
  for (const ModelRef ref : part.point_on) mesh.point_on.push_back(whole_ref(body, ref));
  add(part.edges, mesh.edges);
  add(part.triangles, mesh.triangles);
  add(part.tets, mesh.tets);
  for (const auto tag : part.edge_on) mesh.edge_on.push_back(whole_ref(body, model_edge(tag)).tag);
  for (const auto tag : part.triangle_on) mesh.triangle_on.push_back(whole_ref(body, model_face(tag)).tag);
  for (const auto tag : part.tet_in) mesh.tet_in.push_back(whole_ref(body, model_region(tag)).tag);
}

void append_faults(const Model& body, const std::vector<Fault>& part, std::vector<Fault>& faults) {
  for (Fault fault : part) {
    fault.entity = whole_ref(body, fault.entity);
    faults.push_back(std::move(fault));
  }
}

/// Claims come in the same order from every body.
void append_claims(const Model& body, const Acceptance& part, Acceptance& whole) {
  for (std::size_t r = 1; r < part.filled.size(); ++r) {
    const auto tag = static_cast<std::size_t>(whole_tags(body, 3)[r]);
    whole.filled.resize(std::max(whole.filled.size(), tag + 1), 0.0);
    whole.filled[tag] = part.filled[r];
  }
  for (const Claim& claim : part.claims) {
    const auto known = std::find_if(whole.claims.begin(), whole.claims.end(),
                                    [&](const Claim& c) { return c.name == claim.name; });
    const bool is_first = known == whole.claims.end();
    Claim& sum = is_first ? whole.claims.emplace_back(claim) : *known;
    if (is_first) {
      sum.faults.clear();
      sum.farthest.reset();
    } else {
      sum.holds = sum.holds && claim.holds;
      sum.places.insert(sum.places.end(), claim.places.begin(), claim.places.end());
      if (claim.worst - claim.limit > sum.worst - sum.limit) {
        sum.worst = claim.worst;
        sum.limit = claim.limit;
      }
    }
    if (claim.farthest && (!sum.farthest || claim.farthest->distance > sum.farthest->distance))
      sum.farthest = {whole_ref(body, claim.farthest->entity), claim.farthest->place,
                      claim.farthest->distance};
    append_faults(body, claim.faults, sum.faults);
    if (sum.faults.size() > kFaultsTold) sum.faults.resize(kFaultsTold);
  }
}

void append_report(const Model& body, const MeshReport& part, MeshReport& report) {
  if (part.status != MeshStatus::kComplete) report.status = MeshStatus::kIncomplete;
  append_faults(body, part.faults, report.faults);
  append_faults(body, part.warnings, report.warnings);
  append_claims(body, part.acceptance, report.acceptance);
  SizeShortfall shortfall = part.shortfall;
  for (ShortEdge& edge : shortfall.shortest) edge.entity = whole_ref(body, edge.entity);
  report.shortfall.add(shortfall);
  report.volume += part.volume;
  report.cad_volume += part.cad_volume;
  report.area += part.area;
  report.cad_area += part.cad_area;
  report.area_off += part.area_off;
  report.nodes += part.nodes;
  report.tets += part.tets;
  report.triangles += part.triangles;
  report.attribute_points += part.attribute_points;
  report.rounds = std::max(report.rounds, part.rounds);
  report.template_tets += part.template_tets;
  for (const StageTime& time : part.times) {
    const auto known = std::find_if(report.times.begin(), report.times.end(),
                                    [&](const StageTime& t) { return t.name == time.name; });
    if (known == report.times.end()) {
      report.times.push_back(time);
      continue;
    }
    known->seconds += time.seconds;
    known->cpu_seconds += time.cpu_seconds;
    known->peak_bytes = std::max(known->peak_bytes, time.peak_bytes);
  }
}

Fault not_meshed(const Model& model, int face) {
  Fault fault;
  fault.entity = model_face(face);
  const Facets& facets = model.facets();
  const auto triangle = std::find(facets.face.begin(), facets.face.end(), face) - facets.face.begin();
  if (triangle < static_cast<std::ptrdiff_t>(facets.face.size()))
    for (const std::uint32_t node : facets.triangles[static_cast<std::size_t>(triangle)])
      fault.place += facets.nodes[node] / 3.0;
  fault.cause = model.describe(fault.entity) + " lies outside of all solids and is not meshed";
  fault.advice = "remove the face, or close the solid that it belongs to";
  return fault;
}

/// By dimension and tag of the whole: the body that holds it and its tag there.
struct Place {
  std::size_t body = 0;
  int tag = 0;
};
using Places = std::array<std::vector<Place>, 4>;

Places places_of(const Model& model, const std::vector<Model>& bodies) {
  Places places;
  for (std::size_t dim = 0; dim < 4; ++dim)
    places[dim].resize(static_cast<std::size_t>(model.count(static_cast<int>(dim))) + 1);
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (std::size_t dim = 0; dim < 4; ++dim)
      for (std::size_t tag = 1; tag < whole_tags(bodies[b], dim).size(); ++tag)
        places[dim][static_cast<std::size_t>(whole_tags(bodies[b], dim)[tag])] = {b, static_cast<int>(tag)};
  return places;
}

bool all_known(const Mesh& mesh, const Places& places) {
  const auto known = [&](std::size_t dim, int tag) {
    return tag > 0 && static_cast<std::size_t>(tag) < places[dim].size() &&
           places[dim][static_cast<std::size_t>(tag)].tag > 0;
  };
  const auto each = [&](std::size_t dim, const auto& tags) {
    return std::all_of(tags.begin(), tags.end(), [&](int tag) { return known(dim, tag); });
  };
  return each(1, mesh.edge_on) && each(2, mesh.triangle_on) && each(3, mesh.tet_in) &&
         std::all_of(mesh.point_on.begin(), mesh.point_on.end(), [&](ModelRef ref) {
           return ref.dim >= 0 && ref.dim <= 3 && known(static_cast<std::size_t>(ref.dim), ref.tag);
         });
}

/// The mesh of each body. A vertex goes where its entity is; one that an element of another body uses goes
/// there, too, and is found at fault there.
class Distribute {
 public:
  Distribute(const Mesh& mesh, const Places& places, std::size_t bodies)
      : mesh_(mesh), places_(places), meshes_(bodies), own_(bodies) {}

  std::vector<Mesh> meshes() {
    for (Mesh::Index v = 0; v < mesh_.points.size(); ++v)
      (void)own(place(static_cast<std::size_t>(mesh_.point_on[v].dim), mesh_.point_on[v].tag).body, v);
    for (std::size_t i = 0; i < mesh_.edges.size(); ++i)
      add(1, mesh_.edges[i], mesh_.edge_on[i], &Mesh::edges, &Mesh::edge_on);
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i)
      add(2, mesh_.triangles[i], mesh_.triangle_on[i], &Mesh::triangles, &Mesh::triangle_on);
    for (std::size_t i = 0; i < mesh_.tets.size(); ++i)
      add(3, mesh_.tets[i], mesh_.tet_in[i], &Mesh::tets, &Mesh::tet_in);
    return std::move(meshes_);
  }

 private:
  static constexpr auto kNone = std::numeric_limits<Mesh::Index>::max();

  [[nodiscard]] const Place& place(std::size_t dim, int tag) const {
    return places_[dim][static_cast<std::size_t>(tag)];
  }

  Mesh::Index own(std::size_t body, Mesh::Index v) {
    if (own_[body].empty()) own_[body].assign(mesh_.points.size(), kNone);
    Mesh::Index& index = own_[body][v];
    if (index != kNone) return index;
    Mesh& mesh = meshes_[body];
    index = static_cast<Mesh::Index>(mesh.points.size());
    const Place& at = place(static_cast<std::size_t>(mesh_.point_on[v].dim), mesh_.point_on[v].tag);
    mesh.points.push_back(mesh_.points[v]);
    mesh.point_on.push_back({mesh_.point_on[v].dim, at.body == body ? at.tag : 0});
    return index;
  }

  template <class Element>
  void add(std::size_t dim, Element element, int tag, std::vector<Element> Mesh::*elements,
           std::vector<std::int32_t> Mesh::*tags) {
    const Place& at = place(dim, tag);
    for (Mesh::Index& v : element) v = own(at.body, v);
    (meshes_[at.body].*elements).push_back(element);
    (meshes_[at.body].*tags).push_back(at.tag);
  }

  const Mesh& mesh_;
  const Places& places_;
  std::vector<Mesh> meshes_;
  std::vector<std::vector<Mesh::Index>> own_;  ///< by body and vertex of the whole
};

/// Where no size is asked for, no body is coarser than its largest region by itself, be the whole a thousand
/// times as large.
double body_size(const Model& body, const MeshOptions& options) {
  if (options.region_scale == 0.0) return options.size;
  const std::vector<double> sizes = default_region_sizes(body);
  return std::min(options.size, options.region_scale * *std::max_element(sizes.begin() + 1, sizes.end()));
}

/// What the attributes mean for each body: entities by their tags there, shapes as they are.
std::vector<std::vector<SizeAttribute>> attributes_of(const Model& model, const Places& places,
                                                      const std::vector<SizeAttribute>& attributes,
                                                      std::size_t bodies) {
  std::vector<std::vector<SizeAttribute>> result(bodies);
  for (const SizeAttribute& attribute : attributes) {
    const std::vector<ModelRef> selected = selected_entities(model, attribute);
    if (selected.empty())
      for (auto& own : result) own.push_back(attribute);
    for (const ModelRef ref : selected) {
      const Place& at = places[static_cast<std::size_t>(ref.dim)][static_cast<std::size_t>(ref.tag)];
      if (at.tag == 0) continue;
      SizeAttribute one = attribute;
      one.where = SizeAttribute::Where::kNumbers;
      one.dim = ref.dim;
      one.first = one.last = at.tag;
      result[at.body].push_back(one);
    }
  }
  return result;
}

}  // namespace

bool is_meshed_apart(const Model& model) {
  if (model.parts().apart) return true;
  for (int f = 1; f <= model.count(2); ++f)
    if (model.is_outside(f)) return true;
  return false;
}

MeshResult mesh_apart(const Model& model, const MeshOptions& options, Observer& observer) {
  const std::vector<Model> bodies = take_apart(model);
  const auto attributes = attributes_of(model, places_of(model, bodies), options.attributes, bodies.size());
  const MeshOptions all = with_default_size(model, options);
  MeshOptions each = all;
  each.target_elements = 0.0;
  each.order = 1;
  MeshResult whole;
  whole.report.status = MeshStatus::kComplete;
  const auto share = [&](std::size_t b) {
    return static_cast<double>(b) / static_cast<double>(bodies.size());
  };
  const std::function<bool()> never;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Model& body = bodies[b];
    each.attributes = attributes[b];
    each.size = body_size(body, all);
    each.max_elements = options.max_elements - std::min(options.max_elements, whole.report.tets);
    WatchedObserver own(observer, never, share(b), share(b + 1));
    const MeshResult part = mesh_part(body, each, own);
    whole.report.size = std::max(whole.report.size, part.report.size);
    append_mesh(body, part.mesh, whole.mesh);
    append_report(body, part.report, whole.report);
  }
  // Of bodies' own notes the numbers are theirs.
  if (auto note = note_of_divisions(whole.mesh, edge_divisions(model, options.attributes)))
    whole.report.notes.push_back(*std::move(note));
  whole.report.quality = quality_summary(whole.mesh);
  if (!whole.report.faults.empty()) whole.report.status = MeshStatus::kIncomplete;
  return whole;
}

Acceptance accept_apart(const Mesh& mesh, const Model& model) {
  const std::vector<Model> bodies = take_apart(model);
  const Places places = places_of(model, bodies);
  // A mesh that names what the part has not is no mesh of its bodies: the claims about the whole say why.
  if (!all_known(mesh, places)) return accept_mesh(mesh, model);
  const std::vector<Mesh> meshes = Distribute(mesh, places, bodies.size()).meshes();
  Acceptance whole;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    append_claims(bodies[b], accept_mesh(meshes[b], bodies[b]), whole);
  for (Claim& claim : accept_second_order(mesh, model)) whole.claims.push_back(std::move(claim));
  return whole;
}

Acceptance accept_as_meshed(const Mesh& mesh, const Model& model) {
  return is_meshed_apart(model) ? accept_apart(mesh, model) : accept_mesh(mesh, model);
}

std::vector<Fault> faults_of_part(const Model& model) {
  std::vector<Fault> faults = model.parts().faults;
  for (int f = 1; f <= model.count(2); ++f)
    if (model.is_outside(f)) faults.push_back(not_meshed(model, f));
  return faults;
}

}  // namespace octet
