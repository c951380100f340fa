// SPDX-License-Identifier: BSD-3-Clause
// A mesh cut into blocks that can be worked on side by side, and put together again.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "mesh/mesh.h"

namespace octet {

/// Tetrahedra of a mesh with their triangles and edges. What works on it must leave the first `fixed`
/// vertices as they are, and remove none of the first `fixed + held`.
struct MeshBlock {
  Mesh mesh;
  std::size_t fixed = 0, held = 0;
  std::vector<Mesh::Index> vertices;  ///< as it was cut out: their numbers in the whole mesh
};

/// Blocks of a mesh, which must outlive them unchanged. Vertices that others hold on to are fixed in a block:
/// tetrahedra of another block or of none, or vertices fixed in the mesh. Triangles and edges that are of no
/// tetrahedron may be lost.
class MeshBlocks {
 public:
  using Index = Mesh::Index;

  /// Cuts the tetrahedra numbered `tets` at planes across the longest extents into the fewest blocks of no
  /// more than `most` each, about equal in number. The first `fixed` vertices are fixed in every block;
  /// `held`, in ascending order, come next in theirs.
  MeshBlocks(const Mesh& mesh, std::size_t fixed, const std::vector<Index>& held,
             const std::vector<Index>& tets, std::size_t most);

  [[nodiscard]] std::size_t size() const { return tets_.size(); }
  /// Vertices that several blocks have, ascending.
  [[nodiscard]] const std::vector<Index>& seam() const { return seam_; }
  /// Vertices of one block that tetrahedra of none have, too, ascending.
  [[nodiscard]] const std::vector<Index>& rim() const { return rim_; }
  /// Many threads may cut at once. Cost: that of the block, and a byte or four for each vertex of the mesh.
  [[nodiscard]] MeshBlock cut_out(std::size_t block) const;

  struct Whole {
    Mesh mesh;  ///< triangles and edges in no order
    std::vector<Index>
        number;  ///< in it, of the vertices that stayed: fixed ones, and those of no block; else kGone
    std::vector<Index> held;  ///< as numbered in it
  };
  static constexpr Index kGone = 0xffffffffu;
  /// The mesh with each block as it is now. The first `fixed` vertices keep their numbers.
  [[nodiscard]] Whole put_together(const std::vector<MeshBlock>& blocks) const;
  /// Moves the mesh's vertices to where they are in the blocks, which have changed in nothing else.
  static void move_to(const std::vector<MeshBlock>& blocks, std::vector<Vec3>& points);

 private:
  using Triple = std::array<Index, 3>;
  using Pair = std::array<Index, 2>;

  void find_shared();
  void assign_triangles_and_edges();
  void find_vertices(std::size_t block, MeshBlock& result) const;
  /// Puts what no block has, and what is on seams, into the whole.
  void keep_others(Whole& whole) const;
  void add_triangles_and_edges(std::size_t block, const std::vector<Index>& number, Mesh& mesh) const;
  [[nodiscard]] bool is_shared(Index v) const { return block_of_[v] == kShared; }

  static constexpr std::uint32_t kNone = 0xffffffffu, kShared = 0xfffffffeu, kBeyond = 0xfffffffdu;

  const Mesh& mesh_;
  std::size_t fixed_;
  std::vector<char> held_;                   ///< per vertex; empty: none
  std::vector<std::uint32_t> block_of_tet_;  ///< kBeyond: of none
  std::vector<std::uint32_t>
      block_of_;  ///< per vertex; kShared: others hold on to it, too; kBeyond: only they
  std::vector<Index> seam_, rim_;
  std::vector<std::vector<Index>> tets_;                  ///< per block
  std::vector<std::vector<Index>> triangles_, edges_;     ///< per block: those with a vertex of its own
  std::vector<std::pair<Triple, Index>> seam_triangles_;  ///< those of shared vertices alone, by vertices
  std::vector<std::pair<Pair, Index>> seam_edges_;
};

/// The tetrahedra within so many layers of the vertices: one layer are those that have one of them.
[[nodiscard]] std::vector<Mesh::Index> tets_near(const Mesh& mesh, const std::vector<Mesh::Index>& vertices,
                                                 int layers);

}  // namespace octet
