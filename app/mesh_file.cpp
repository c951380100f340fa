// SPDX-License-Identifier: BSD-3-Clause
// A CAD file to a mesh, with what the file says of itself.
#include "app/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/stage_clock.h"
#include "base/error.h"
#include "geom/tiny_features.h"

namespace octet {
namespace {

using Mesher = std::function<MeshResult(const Model&)>;

/// Of the diagonal: nothing larger is taken away for a file's word alone.
constexpr double kMostByAccuracy = 1e-5;

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

MeshedFile mesh_read(ReadFile file, const Mesher& mesh) {
  MeshResult result = mesh(file.model);
  result.report.times.insert(result.report.times.begin(), file.time);
  return {std::move(file.model), std::move(result)};
}

/// That meshing found, beyond those of reading.
std::size_t faults_of_mesh(const MeshedFile& made) {
  return made.result.report.faults.size() -
         std::min(made.result.report.faults.size(), made.model.parts().faults.size());
}

/// What may be taken away for the file's word, mm; 0: no more than has been.
double smallest_by_accuracy(const Model& model, const ReadOptions& reading) {
  if (reading.smallest_feature > 0.0) return 0.0;
  const double smallest = std::min(model.parts().accuracy, kMostByAccuracy * model.diagonal());
  return smallest > kRoundingShare * model.diagonal() ? smallest : 0.0;
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
    return mesh_read(std::move(file), mesh);
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception& error) {  // the first mesh is not lost for it
    observer.note(fmt::format("which failed: {}", error.what()));
    return std::nullopt;
  }
}

/// Both of the first and the other time go to the mesh that is kept.
void add_other_try(std::vector<StageTime>& times, StageTime other) {
  const auto found = std::find_if(times.begin(), times.end(),
                                  [](const StageTime& time) { return time.name == "other tries"; });
  if (found == times.end()) {
    times.insert(times.begin(), other);
    return;
  }
  found->seconds += other.seconds;
  found->cpu_seconds += other.cpu_seconds;
  found->peak_bytes = std::max(found->peak_bytes, other.peak_bytes);
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
  StageClock clock;
  MeshedFile first = mesh_read(read_file(path, reading, observer), mesh);
  const double smallest = smallest_by_accuracy(first.model, reading);
  if (faults_of_mesh(first) == 0 || smallest == 0.0) return first;
  observer.note(
      fmt::format("once more without what is smaller than {:.4g} mm, for the file is accurate to "
                  "{:.4g} mm",
                  smallest, first.model.parts().accuracy));
  const StageTime first_time = clock.lap("other tries");
  std::optional<MeshedFile> second = without_smaller(path, reading, mesh, smallest, first.model, observer);
  const StageTime second_time = clock.lap("other tries");
  if (!second || faults_of_mesh(*second) > 0) {
    add_other_try(first.result.report.times, second_time);
    return first;
  }
  add_other_try(second->result.report.times, first_time);
  second->model = with_first_note(
      second->model,
      fmt::format("what is smaller than {:.4g} mm was taken away, as with --defeature {}: with it the mesh "
                  "had {} faults, and the file is accurate to {:.4g} mm by its own word",
                  smallest, smallest, faults_of_mesh(first), first.model.parts().accuracy));
  return *std::move(second);
}

}  // namespace octet
