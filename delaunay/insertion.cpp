// SPDX-License-Identifier: BSD-3-Clause
// Walk, cavity, replacement; blocks with slots of their own.
#include "delaunay/insertion.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>

#include <algorithm>

#include "delaunay/cavity.h"
#include "delaunay/locate.h"

namespace octet {
namespace {

constexpr std::size_t kSpareSlots = 256;

/// Dead slots at the end of the arrays, the lowest number taken first, after those that are there.
void add_slots(Complex& complex, Inserter& inserter, std::size_t count) {
  const std::size_t first = complex.mesh.tets.size();
  complex.add_slots(first + count);
  std::vector<TetId> slots;
  slots.reserve(count + inserter.free_slots.size());
  for (std::size_t i = count; i-- > 0;) slots.emplace_back(first + i);
  slots.insert(slots.end(), inserter.free_slots.begin(), inserter.free_slots.end());
  inserter.free_slots.swap(slots);
}

bool is_at_a_vertex(const Complex& complex, TetId t, const Vec3& point) {
  return std::any_of(complex.mesh.tets[t].begin(), complex.mesh.tets[t].end(),
                     [&](VertexId v) { return v != kGhostVertex && complex.point(v) == point; });
}

/// Vertices [first, end) of the order, with the slots that are theirs.
struct Part {
  std::size_t first = 0, end = 0;
  Inserter inserter;
};

std::vector<Part> parts_of(Complex& complex, Inserter& all, std::span<const std::uint32_t> vertices,
                           const std::vector<std::uint8_t>& pending,
                           const std::vector<std::uint32_t>& block_of) {
  std::vector<Part> parts(std::max<std::size_t>(1, vertices.size() / kBlockVertices));
  std::vector<std::size_t> slots;
  std::size_t needed = 0;
  for (std::size_t n = 0; n < parts.size(); ++n) {
    parts[n].first = vertices.size() * n / parts.size();
    parts[n].end = vertices.size() * (n + 1) / parts.size();
    std::size_t count = 0;
    for (std::size_t i = parts[n].first; i < parts[n].end; ++i) count += pending[vertices[i]];
    slots.push_back(kSlotsPerVertex * count + kSpareSlots);
    needed += slots.back();
  }
  if (needed > all.free_slots.size()) add_slots(complex, all, needed - all.free_slots.size());
  for (std::uint32_t n = 0; n < parts.size(); ++n) {
    parts[n].inserter.block = {&block_of, n};
    parts[n].inserter.epoch = all.epoch;
    const auto from = all.free_slots.end() - static_cast<std::ptrdiff_t>(slots[n]);
    parts[n].inserter.free_slots.assign(from, all.free_slots.end());
    all.free_slots.erase(from, all.free_slots.end());
  }
  return parts;
}

}  // namespace

Insertion join_vertex(Complex& complex, Inserter& inserter, VertexId v) {
  const Vec3 p = complex.point(v);
  const TetId seed = walk_to(complex, inserter.block, p, inserter.last);
  if (!seed.valid()) return Insertion::kLeft;
  if (is_at_a_vertex(complex, seed, p)) return Insertion::kPresent;
  if (!mark_cavity(complex, inserter, seed, p, complex.rank[v])) return Insertion::kLeft;
  const std::size_t slots = most_replacements(inserter.cavity);
  if (inserter.free_slots.size() < slots) {
    if (!inserter.block.is_everything()) return Insertion::kLeft;
    add_slots(complex, inserter, slots + kSpareSlots);
  }
  replace_cavity(complex, inserter, v);
  return Insertion::kDone;
}

void insert_pending(Complex& complex, Inserter& inserter, std::span<const std::uint32_t> vertices,
                    std::vector<std::uint8_t>& pending, const Question& question) {
  constexpr std::size_t kVerticesAQuestion = 1024;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (i % kVerticesAQuestion == 0) question.ask();
    const std::uint32_t v = vertices[i];
    if (pending[v] == 0) {
      const TetId t = complex.vertex_tet[VertexId(v)];
      if (t.valid() && inserter.block.holds(complex.mesh.tets[t])) inserter.last = t;
    } else if (inserter.last.valid() && join_vertex(complex, inserter, VertexId(v)) != Insertion::kLeft) {
      pending[v] = 0;
    }
  }
}

void insert_in_blocks(Complex& complex, Inserter& all, std::span<const std::uint32_t> vertices,
                      std::vector<std::uint8_t>& pending, const Question& question) {
  std::vector<std::uint32_t> block_of(complex.mesh.points.size(), UINT32_MAX);
  std::vector<Part> parts = parts_of(complex, all, vertices, pending, block_of);
  for (std::uint32_t n = 0; n < parts.size(); ++n)
    for (std::size_t i = parts[n].first; i < parts[n].end; ++i) block_of[vertices[i]] = n;
  // One block a task: with few of them, a thread that takes two at a time is waited for.
  const tbb::blocked_range<std::size_t> all_parts(0, parts.size());
  tbb::parallel_for(
      all_parts,
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t n = range.begin(); n != range.end(); ++n) {
          Part& part = parts[n];
          insert_pending(complex, part.inserter, vertices.subspan(part.first, part.end - part.first), pending,
                         question);
        }
      },
      tbb::simple_partitioner());
  for (const Part& part : parts) {
    const Inserter& done = part.inserter;
    all.free_slots.insert(all.free_slots.end(), done.free_slots.begin(), done.free_slots.end());
    all.epoch = std::max(all.epoch, done.epoch);
    if (done.last.valid()) all.last = done.last;
  }
}

}  // namespace octet
