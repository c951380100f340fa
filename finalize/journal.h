// SPDX-License-Identifier: BSD-3-Clause
// What slots of an editable mesh held before they were changed, so that changes can be taken back.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/ids.h"
#include "base/vec.h"

namespace octet {

/// Kept by the operations of finalize/cavity.h and the pieces of finalize/work_mesh.h while `open`; read
/// backwards by `take_back`.
struct Journal {
  struct Tet {
    TetId tet;
    std::array<VertexId, 4> vertices;
    std::array<TetId, 4> neighbours;
    std::array<std::int32_t, 4> face_on;
    std::int32_t region = 0;
    double quality = 0.0;
  };
  struct Vertex {
    VertexId vertex;
    Vec3 point;
    TetId tet_of;
  };
  struct Piece {
    VertexId from, to;
    std::int32_t signed_tag = 0;
    bool added = false;
  };
  bool open = false;
  std::vector<Tet> tets;
  std::vector<Vertex> vertices;
  std::vector<Piece> pieces;
  std::vector<std::pair<TetId, bool>> free_tets;  ///< true: the slot became free
  std::size_t tet_count = 0, vertex_count = 0;    ///< slots when it was opened
};

}  // namespace octet
