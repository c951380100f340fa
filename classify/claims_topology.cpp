// SPDX-License-Identifier: BSD-3-Clause
// Claims about mesh topology against model topology: closure, upward counts, model vertices.
// [SCOREC apf verify: downward closure and upward counts]
#include <fmt/format.h>

#include <unordered_map>

#include "classify/claims.h"

namespace octet {
namespace {

/// Model::in_closure with a memory: a mesh asks the same few pairs again and again.
class ClosureMemory {
 public:
  explicit ClosureMemory(const Model& model) : model_(model) {}
  bool holds(ModelRef part, ModelRef whole) {
    if (part == whole) return true;
    const std::uint64_t key = (code(part) << 32) | code(whole);
    const auto at = known_.find(key);
    if (at != known_.end()) return at->second;
    return known_.emplace(key, model_.in_closure(part, whole)).first->second;
  }

 private:
  static std::uint64_t code(ModelRef ref) {
    return (static_cast<std::uint64_t>(ref.dim) << 29) | static_cast<std::uint32_t>(ref.tag);
  }
  const Model& model_;
  std::unordered_map<std::uint64_t, bool> known_;
};

const char* kind_of(int dim) {
  constexpr const char* kKind[4] = {"vertex", "edge", "triangle", "tetrahedron"};
  return kKind[dim];
}

template <std::size_t N>
void check_vertices_of(const ClaimInput& in, ClaimBuilder& claim, ClosureMemory& closure, std::size_t i,
                       const std::array<Mesh::Index, N>& element, ModelRef whole) {
  for (const Mesh::Index v : element) {
    if (closure.holds(in.mesh.point_on[v], whole)) continue;
    claim.fault(whole.dim, whole, in.point(v),
                fmt::format("{} {} has a vertex on {}, which is not in the entity's closure",
                            kind_of(whole.dim), i, in.model.describe(in.mesh.point_on[v])),
                kFiner);
  }
}

/// A side of a triangle that is a mesh edge: its model edge lies in the closure of the triangle's face.
void check_sides(const ClaimInput& in, ClaimBuilder& claim, ClosureMemory& closure) {
  auto piece = in.pieces.begin();
  for (const TriangleSide& side : in.sides) {
    while (piece != in.pieces.end() && piece->v < side.v) ++piece;
    if (piece == in.pieces.end() || piece->v != side.v) continue;
    const ModelRef part = model_edge(in.mesh.edge_on[piece->edge]);
    if (closure.holds(part, model_face(side.face))) continue;
    claim.fault(
        2.0, model_face(side.face), in.point(side.v[0]),
        fmt::format("a triangle has a side on {}, which does not bound the face", in.model.describe(part)),
        kFiner);
  }
}

/// Regions behind and in front of a triangle, by the tetrahedra there; 0 where there is none.
struct Neighbours {
  int count = 0;
  std::array<int, 2> region{0, 0};
};

Neighbours neighbours_of(const ClaimInput& in, const std::array<Mesh::Index, 3>& triangle) {
  const bool even = sorted_face(triangle).even;
  Neighbours result;
  for (const FaceUse& use : in.uses.find(triangle)) {
    ++result.count;
    // A face that points out of its tetrahedron as the triangle does has it behind.
    result.region[use.even == even ? 0 : 1] = in.mesh.tet_in[use.tet];
  }
  return result;
}

}  // namespace

Claim claim_closure(const ClaimInput& in) {
  ClaimBuilder claim("closure", "The boundary of what lies on an entity lies in that entity's closure.");
  ClosureMemory closure(in.model);
  const Mesh& mesh = in.mesh;
  for (std::size_t i = 0; i < mesh.edges.size(); ++i)
    check_vertices_of(in, claim, closure, i, mesh.edges[i], model_edge(mesh.edge_on[i]));
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    check_vertices_of(in, claim, closure, i, mesh.triangles[i], model_face(mesh.triangle_on[i]));
  // All others lie inside of their region.
  for (const std::uint32_t i : in.sweep.outer)
    check_vertices_of(in, claim, closure, i, mesh.tets[i], model_region(mesh.tet_in[i]));
  check_sides(in, claim, closure);
  return claim.counted();
}

Claim claim_upward_counts(const ClaimInput& in) {
  ClaimBuilder claim("upward-counts",
                     "Every triangle has the tetrahedra of its face's regions, each on its own side.");
  for (std::size_t i = 0; i < in.mesh.triangles.size(); ++i) {
    const auto& triangle = in.mesh.triangles[i];
    const ModelFace& face = in.model.face(in.mesh.triangle_on[i]);
    const Neighbours found = neighbours_of(in, triangle);
    const int asked = (face.region[0] != 0 ? 1 : 0) + (face.region[1] != 0 ? 1 : 0);
    if (found.count == asked && found.region == face.region) continue;
    claim.fault(1.0, model_face(in.mesh.triangle_on[i]), in.centroid(triangle),
                fmt::format("triangle {} has regions {} | {} behind | before it, not {} | {}", i,
                            found.region[0], found.region[1], face.region[0], face.region[1]),
                kFiner);
  }
  return claim.counted();
}

Claim claim_model_vertices(const ClaimInput& in) {
  ClaimBuilder claim("model-vertices", "Every model vertex is one mesh vertex.");
  std::vector<int> found(static_cast<std::size_t>(in.model.count(0)) + 1, 0);
  for (const ModelRef ref : in.mesh.point_on)
    if (ref.dim == 0) ++found[ref.tag];
  for (int tag = 1; tag <= in.model.count(0); ++tag) {
    if (found[tag] == 1) continue;
    claim.fault(found[tag] == 0 ? 2.0 : 1.0, model_vertex(tag), in.model.vertex(tag).point,
                found[tag] == 0 ? "the vertex is missing in the mesh"
                                : fmt::format("the vertex is {} mesh vertices", found[tag]),
                kFiner);
  }
  return claim.counted();
}

}  // namespace octet
