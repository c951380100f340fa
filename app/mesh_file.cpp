// SPDX-License-Identifier: BSD-3-Clause
// A CAD file to a mesh, with what the file says of itself.
#include "app/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/geometry_faults.h"
#include "app/stage_clock.h"
#include "base/error.h"
#include "geom/tiny_features.h"

namespace octet {
namespace {

using Mesher = std::function<MeshResult(const Model&, LargeMesh)>;

/// Of the diagonal: nothing larger is taken away for a file's word alone.
constexpr double kMostByAccuracy = 1e-5;
/// Of the diagonal, of the cube root of the least solid's volume, and of the size asked for: what is smaller
/// than all of these no element resolves.
constexpr double kOfDiagonal = 1e-4, kOfLeastSolid = 4e-4, kOfSize = 1e-2;

struct ReadFile {
  Model model;
  StageTime time;
};

ReadFile read_file(const std::filesystem::path& path, const ReadOptions& reading, Observer& observer) {
  StageClock clock;
  observer.stage("reading", 0.0);
  Model model = read_part(path, reading);
  for (const std::string& note : model.notes()) observer.note(note);
  return {std::move(model), clock.lap("reading")};
}

MeshedFile mesh_read(ReadFile file, const Mesher& mesh, LargeMesh large_mesh) {
  MeshResult result = mesh(file.model, large_mesh);
  result.report.times.insert(result.report.times.begin(), file.time);
  return {std::move(file.model), std::move(result)};
}

/// That meshing found, beyond those of reading.
std::size_t faults_of_mesh(const MeshedFile& made) {
  return made.result.report.faults.size() -
         std::min(made.result.report.faults.size(), made.model.parts().faults.size());
}

/// Whether meshing found nothing, and reading no more than it found before: a solid that is left out has no
/// faults of meshing.
bool is_mended(const MeshedFile& made, const MeshedFile& before) {
  return faults_of_mesh(made) == 0 && made.model.parts().faults.size() <= before.model.parts().faults.size();
}

/// What may be taken away, and why.
struct Smallest {
  double length;  ///< mm
  std::string reason;
};

double cube_root_of_least_volume(const Model& model) {
  double least = std::numeric_limits<double>::infinity();
  for (int r = 1; r <= model.count(3); ++r) least = std::min(least, std::abs(model.region(r).volume));
  return std::cbrt(least);
}

/// One that is easily typed.
double short_number(double value) { return std::stod(fmt::format("{:.1e}", value)); }

/// What crosses deeper than what is taken away does so after it, and its faults stay.
double deepest_crossing_at_faults(const MeshedFile& made) {
  double depth = 0.0;
  for (const Fault& fault : made.result.report.faults)
    depth = std::max(depth, deepest_crossing_at(fault, made.model));
  return depth;
}

/// From the least on; none where that would be no more than has gone, or the caller has said what may go.
std::vector<Smallest> smallest_to_try(const MeshedFile& first, const ReadOptions& reading) {
  std::vector<Smallest> tries;
  if (reading.smallest_feature > 0.0) return tries;
  const double diagonal = first.model.diagonal(), accuracy = first.model.parts().accuracy,
               size = first.result.report.size;
  const double by_accuracy = std::min(accuracy, kMostByAccuracy * diagonal),
               by_size = std::min({kOfDiagonal * diagonal, kOfSize * size,
                                   kOfLeastSolid * cube_root_of_least_volume(first.model)});
  const double deepest = deepest_crossing_at_faults(first);
  if (by_accuracy > std::max(deepest, kRoundingShare * diagonal))
    tries.push_back(
        {by_accuracy, fmt::format("the file is accurate to {:.4g} mm by its own word", accuracy)});
  if (by_size > std::max({by_accuracy, deepest, kRoundingShare * diagonal}))
    tries.push_back({short_number(by_size), fmt::format("the size is {:.4g} mm", size)});
  return tries;
}

/// None: nothing went, or what is left cannot be meshed.
std::optional<MeshedFile> without_smaller(const std::filesystem::path& path, ReadOptions reading,
                                          const Mesher& mesh, double smallest, const Model& before,
                                          Observer& observer) {
  reading.smallest_feature = smallest;
  try {
    ReadFile file = read_file(path, reading, observer);
    bool same = true;
    for (int dim = 0; dim <= 3; ++dim) same = same && file.model.count(dim) == before.count(dim);
    if (same) return std::nullopt;
    return mesh_read(std::move(file), mesh, LargeMesh::kNever);
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception& error) {  // the first mesh is not lost for it
    observer.note(fmt::format("which failed: {}", error.what()));
    return std::nullopt;
  }
}

/// Both of the first and the other time go to the mesh that is kept.
void add_other_try(std::vector<StageTime>& times, StageTime other) {
  other.name = "other tries";
  const auto found = std::find_if(times.begin(), times.end(),
                                  [&](const StageTime& time) { return time.name == other.name; });
  if (found == times.end()) {
    times.insert(times.begin(), other);
    return;
  }
  found->seconds += other.seconds;
  found->cpu_seconds += other.cpu_seconds;
  found->peak_bytes = std::max(found->peak_bytes, other.peak_bytes);
}

/// Why the part is meshed without its smallest features.
std::string trouble_of(const MeshedFile& first) {
  const double large = first.result.report.left_large;
  return fmt::format("with it the mesh had {} faults{}", faults_of_mesh(first),
                     large > 0.0 ? fmt::format(", or about {:.2g} elements", large) : "");
}

/// In front of all others.
Model with_first_note(const Model& model, const std::string& note) {
  ModelParts parts = model.parts();
  parts.notes.insert(parts.notes.begin(), note);
  return Model(std::move(parts));
}

}  // namespace

MeshedFile mesh_file(const std::filesystem::path& path, const ReadOptions& reading, const Mesher& mesh,
                     Observer& observer) {
  ReadFile file = read_file(path, reading, observer);
  const StageTime reading_time = file.time;
  StageClock clock;
  MeshedFile first =
      mesh_read(std::move(file), mesh, reading.smallest_feature > 0.0 ? LargeMesh::kLast : LargeMesh::kNever);
  if (faults_of_mesh(first) == 0) return first;
  const StageTime first_time = clock.lap({});
  std::vector<StageTime> in_vain;
  for (const Smallest& smallest : smallest_to_try(first, reading)) {
    observer.note(fmt::format("once more without what is smaller than {:.4g} mm, for {}", smallest.length,
                              smallest.reason));
    std::optional<MeshedFile> second =
        without_smaller(path, reading, mesh, smallest.length, first.model, observer);
    if (!second || !is_mended(*second, first)) {
      in_vain.push_back(clock.lap({}));
      continue;
    }
    in_vain.insert(in_vain.end(), {reading_time, first_time});
    for (const StageTime& time : in_vain) add_other_try(second->result.report.times, time);
    second->model = with_first_note(
        second->model,
        fmt::format("what is smaller than {:.4g} mm was taken away, as with --defeature {}: {}, and {}",
                    smallest.length, smallest.length, trouble_of(first), smallest.reason));
    return *std::move(second);
  }
  if (first.result.report.left_large > 0.0) {
    in_vain.push_back(first_time);
    first = mesh_read({std::move(first.model), reading_time}, mesh, LargeMesh::kAtOnce);
  }
  for (const StageTime& time : in_vain) add_other_try(first.result.report.times, time);
  return first;
}

}  // namespace octet
