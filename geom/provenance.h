// SPDX-License-Identifier: BSD-3-Clause
// Where a model's entities come from: numbers and names as read, the tree of parts, what was left out.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/model_ref.h"
#include "base/vec.h"

namespace octet {

/// An entity of the shape as read.
struct EntityAsRead {
  std::string name;
  /// The model's entities that it became, ascending: several where fusing split it, the same one for two
  /// that fusing joined, none where it is not in the model.
  std::vector<int> tags;
  int id = 0;  ///< by which the file itself knows it (Provenance::id_mark); 0: it has none
};

/// A part or an assembly as the file arranges them. A part used twice stands twice.
struct PartNode {
  std::string name;
  std::string instance;  ///< name of this use of the part, empty: none or the same
  int parent = -1;       ///< index of the assembly that holds it, -1: a root
  int first_use = 0;  ///< index of the first node of the same part; its own index but for further instances
  std::string colour, layer, material;
  double density = 0.0;      ///< g/cm^3, 0: not given
  std::vector<int> solids;   ///< numbers as read of its solids that are in none of its children, ascending
  std::vector<int> regions;  ///< tags of what they became, or of what its closed shells became, ascending
};

/// Something in the file that bounds no region and is not meshed.
struct LeftOut {
  ModelRef entity;  ///< number as read
  std::string name;
  double measure = 0.0;  ///< volume, area or length: mm^3, mm^2 or mm
  Vec3 place = Vec3::Zero();
};

struct Provenance {
  std::array<std::vector<EntityAsRead>, 4> as_read;  ///< by dimension and number as read, [0] unused
  std::vector<PartNode> tree;                        ///< an assembly before what it holds
  std::vector<LeftOut> left_out;                     ///< solids, then faces, edges, vertices of none such
  /// What stands before an id: "#" of a STEP file, "D" of an IGES file (the line of its directory entry);
  /// empty where the file has none.
  std::string id_mark;
};

/// Numbers as read of the entities that became each model entity, by tag; `count`: entities of the model.
[[nodiscard]] std::vector<std::vector<int>> sources(const Provenance& provenance, int dim, int count);

/// Ids of the entities with these numbers as read, "#4711" or "D17", of those that have one; each once.
[[nodiscard]] std::vector<std::string> ids_in_file(const Provenance& provenance, int dim,
                                                   const std::vector<int>& numbers);

/// What two or more solids of the file fill together.
struct Overlap {
  int region = 0;
  std::vector<int> solids;  ///< numbers as read, ascending
};
[[nodiscard]] std::vector<Overlap> overlaps(const Provenance& provenance, int regions);

}  // namespace octet
