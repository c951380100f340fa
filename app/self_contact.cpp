// SPDX-License-Identifier: BSD-3-Clause
// Counts the faces at each edge, and the fans of faces at each vertex.
#include "app/self_contact.h"

#include <map>
#include <set>

namespace octet {
namespace {

/// Whether more than two faces of one region, or towards the outside, meet in the edge. That several regions
/// meet there is no fault.
bool branches(const Model& model, const ModelEdge& edge) {
  std::map<int, int> faces;
  for (const int f : edge.faces) {
    if (model.is_embedded(f)) continue;
    for (const int region : model.face(f).region)
      if (++faces[region] > 2) return true;
  }
  return false;
}

/// Sets of faces that hang together by edges at one vertex.
class Fans {
 public:
  void join(int a, int b) {
    const int root = lead(a);
    lead_[lead(b)] = root;
  }
  [[nodiscard]] std::size_t count() {
    std::set<int> leads;
    for (const auto& [face, unused] : std::map<int, int>(lead_)) leads.insert(lead(face));
    return leads.size();
  }

 private:
  int lead(int face) {
    lead_.try_emplace(face, face);
    while (lead_[face] != face) face = lead_[face];
    return face;
  }
  std::map<int, int> lead_;
};

std::vector<int> pinched_vertices(const Model& model) {
  std::vector<int> pinched;
  for (int v = 1; v <= model.count(0); ++v) {
    Fans fans;
    for (const int e : model.vertex(v).edges) {
      int last = 0;
      for (const int f : model.edge(e).faces) {
        const auto& region = model.face(f).region;
        if (region[0] == region[1] || (region[0] != 0 && region[1] != 0)) continue;
        fans.join(last == 0 ? f : last, f);
        last = f;
      }
    }
    if (fans.count() > 1) pinched.push_back(v);
  }
  return pinched;
}

}  // namespace

SelfContact self_contact(const Model& model) {
  SelfContact contact;
  for (int e = 1; e <= model.count(1); ++e)
    if (model.edge(e).use == EdgeUse::kReal && branches(model, model.edge(e))) contact.edges.push_back(e);
  contact.vertices = pinched_vertices(model);
  return contact;
}

}  // namespace octet
