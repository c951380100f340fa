// SPDX-License-Identifier: BSD-3-Clause
// Face swap: two tetrahedra that share a face become three around the edge between their far vertices.
#include "finalize/face_swap.h"

#include "finalize/replace.h"
#include "finalize/shape.h"

namespace octet {
namespace {

struct SwapPlan {
  std::array<TetId, 2> removed;
  std::array<NewTet, 3> added;
  std::uint64_t work = 0;
};

/// The swap, if all that it makes is better than `floor`.
bool make_plan(const WorkMesh& mesh, TetId t, int face, double floor, SwapPlan& plan) {
  const TetId n = mesh.neighbours[t][face];
  if (!n.valid() || mesh.face_on[t][face] != 0) return false;
  plan.removed = {t, n};
  int back = 0;
  while (mesh.neighbours[n][back] != t) ++back;
  const VertexId p = mesh.tets[t][face], q = mesh.tets[n][back];
  // Face (x, y, z) is seen counter-clockwise from q and p lies behind it, so (x, y, p, q) is positive.
  for (int i = 0; i < 3; ++i) {
    const VertexId x = mesh.tets[t][kTetFace[face][i]], y = mesh.tets[t][kTetFace[face][(i + 1) % 3]];
    plan.added[i] = {{x, y, p, q}, mesh.region[t]};
    ++plan.work;
    if (shape(mesh.points[x], mesh.points[y], mesh.points[p], mesh.points[q]) <= floor) return false;
  }
  return true;
}

bool carry_out(Workshop& shop, const SwapPlan& plan) {
  if (!replace(shop, {plan.removed, plan.added})) return false;
  ++shop.report.face_swaps;
  return true;
}

}  // namespace

bool swap_face(Workshop& shop, TetId t, int face, double floor) {
  SwapPlan plan;
  const bool better = make_plan(shop.mesh, t, face, floor, plan);
  shop.work += plan.work;
  return better && carry_out(shop, plan);
}

}  // namespace octet
