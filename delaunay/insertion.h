// SPDX-License-Identifier: BSD-3-Clause
// Insertion of many points: one after the other, or in blocks of space side by side.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <thread>
#include <vector>

#include "base/error.h"
#include "delaunay/complex.h"

namespace octet {

enum class Insertion : std::uint8_t {
  kDone,     ///< the vertex is joined
  kPresent,  ///< another vertex is at its place
  kLeft,     ///< not without leaving the inserter's block or its slots
};
/// Joins the vertex to the complex, walking to it from the inserter's last tetrahedron.
[[nodiscard]] Insertion join_vertex(Complex& complex, Inserter& inserter, VertexId v);

/// Whether to go on. Only the thread that made it asks: other threads are not the caller's.
class Question {
 public:
  /// Keeps a reference; the function may be empty.
  explicit Question(const std::function<bool()>& cancelled)
      : cancelled_(cancelled), thread_(std::this_thread::get_id()) {}
  /// Throws Cancelled.
  void ask() const {
    if (cancelled_ && std::this_thread::get_id() == thread_ && cancelled_()) throw Cancelled();
  }

 private:
  const std::function<bool()>& cancelled_;
  std::thread::id thread_;
};

/// Inserts those of the vertices that are pending, in their order, and marks them as no longer pending. The
/// others, if they are of the complex, are where walks start. What cannot be inserted stays pending. The
/// question is asked every few milliseconds.
void insert_pending(Complex& complex, Inserter& inserter, std::span<const std::uint32_t> vertices,
                    std::vector<std::uint8_t>& pending, const Question& question);

/// The same, in blocks of about kBlockVertices neighbouring vertices in their order, in parallel. `all` is an
/// inserter for everything; blocks take their slots from it and give them back. Blocks depend on the vertices
/// alone, so the same tetrahedra get the same numbers from any number of threads. Requires: no other vertex
/// is of the complex.
///
/// A block inserts what changes only tetrahedra whose vertices are all in the block; what reaches beyond
/// stays pending. [Marot, Pellerin & Remacle 2019, 3] give each thread a block likewise, and move the blocks'
/// bounds for what is left.
void insert_in_blocks(Complex& complex, Inserter& all, std::span<const std::uint32_t> vertices,
                      std::vector<std::uint8_t>& pending, const Question& question);

/// Net tetrahedra a vertex in a block, with room: there are 6.8 a vertex in random sets, 5.7 in lattices.
inline constexpr std::size_t kSlotsPerVertex = 8;

/// The vertices a block has, about.
inline constexpr std::size_t kBlockVertices = 40000;

}  // namespace octet
