// SPDX-License-Identifier: BSD-3-Clause
// Reads a part where OCCT can harm nobody.
#include "geom/occt/reader.h"

#include <fmt/format.h>
#include <unistd.h>

#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <Standard_Version.hxx>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <new>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/error.h"
#include "geom/face_crossings.h"
#include "geom/face_touches.h"
#include "geom/occt/assemble.h"
#include "geom/occt/byte_stream.h"
#include "geom/occt/contact_circle.h"
#include "geom/occt/part_stream.h"
#include "geom/occt/silence.h"
#include "geom/occt/tessellate.h"
#include "geom/winding.h"

namespace octet {
namespace {

namespace fs = std::filesystem;

std::string do_job(const ReadJob& job, const StageLog& log) {
  const Silence silence;
  try {
    CadDocument document;
    if (job.shape.IsNull()) {
      log("reading the file");
      document = read_document(job.path, job.kind);
    } else {
      document.shape = job.shape;
    }
    const AssembledPart part = assemble(document, job.options, job.meeting, log);
    log("handing the part over");
    return encode_part(part.numbering, part.parts);
  } catch (const Standard_OutOfMemory&) {
    throw std::bad_alloc();
  } catch (const Standard_Failure& failure) {
    throw InputError(std::string("the part cannot be analysed: ") + failure.GetMessageString());
  }
}

std::string encode_job(const ReadJob& job) {
  ByteWriter out;
  out(job.path.string(), job.kind, job.shape.IsNull() ? std::string() : encode_shape(job.shape),
      job.options.facet_deflection, job.options.sew_tolerance, job.options.smallest_feature, job.options.fuse,
      job.meeting.crossing, job.meeting.touching);
  return std::move(out.bytes);
}

fs::path directory_of_program() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::path() : program.parent_path();
}

/// The helper where it may be: asked for, in a build tree, in the tree of an installed program, where it was
/// installed. Empty: nowhere.
fs::path find_helper(const ReadOptions& options) {
  if (!options.reader_program.empty()) return options.reader_program;
  const fs::path here = directory_of_program();
  for (const fs::path& path :
       {here / "octet-reader", here / "../libexec/octet/octet-reader", fs::path(OCTET_READER)})
    if (::access(path.c_str(), X_OK) == 0) return path;
  return {};
}

std::size_t default_memory() {
  const auto pages = static_cast<std::size_t>(::sysconf(_SC_PHYS_PAGES));
  return pages / 2 * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

std::string guarded_bytes(const ReadJob& job, std::string& note) {
  const ReadOptions& options = job.options;
  const auto in_this_process = [&] {
    const OcctLock lock;
    return do_job(job, [](const std::string&) {});
  };
  if (!options.isolate) return in_this_process();
  const ChildLimits limits{options.time_limit,
                           options.memory_limit > 0 ? options.memory_limit : default_memory()};
  if (has_one_thread() && options.reader_program.empty())
    return run_in_child([&](const StageLog& log) { return do_job(job, log); }, limits);
  const fs::path helper = find_helper(options);
  if (!helper.empty()) return run_in_helper(helper, reader_version(), encode_job(job), limits);
  note = "read without limits of time and memory: the program octet-reader was not found";
  return in_this_process();
}

/// Faces that cross bound nothing, with edges there or without: what touches any of those is left as it is.
std::vector<FaceTouch> touches_without_crossings(const Model& model) {
  std::vector<FaceTouch> touches = touching_faces(model, kContactShare * model.diagonal());
  if (touches.empty()) return touches;
  std::set<int> crossed;
  for (const FaceCrossing& crossing : face_crossings(model))
    crossed.insert(crossing.face.begin(), crossing.face.end());
  std::erase_if(touches, [&](const FaceTouch& touch) {
    return crossed.count(touch.face[0]) > 0 || crossed.count(touch.face[1]) > 0;
  });
  return touches;
}

/// Those of faces of one region.
std::vector<FaceCrossing> crossings_within_regions(const Model& model) {
  std::vector<FaceCrossing> crossings = face_crossings(model);
  std::erase_if(crossings, [&](const FaceCrossing& crossing) {
    const auto &a = model.face(crossing.face[0]).region, &b = model.face(crossing.face[1]).region;
    return std::none_of(a.begin(), a.end(),
                        [&](int region) { return region != 0 && (region == b[0] || region == b[1]); });
  });
  return crossings;
}

/// Numbers as read of the faces of each pair (FaceCrossing, FaceTouch), where both have one.
template <class Pair>
FaceNumberPairs numbers_of(const std::vector<Pair>& found, const Model& model) {
  const auto numbers = sources(model.provenance(), 2, model.count(2));
  FaceNumberPairs pairs;
  for (const Pair& pair : found) {
    const auto &a = numbers[static_cast<std::size_t>(pair.face[0])],
               &b = numbers[static_cast<std::size_t>(pair.face[1])];
    if (!a.empty() && !b.empty() && a.front() != b.front()) pairs.push_back({a.front(), b.front()});
  }
  return pairs;
}

/// What a model lacks of what another one has; empty: nothing.
std::string loss_of(const Model& model, const Model& other) {
  constexpr double kSameVolume = 1e-6;
  const auto volume = [](const Model& of) {
    double sum = 0.0;
    for (int region = 1; region <= of.count(3); ++region) sum += of.region(region).volume;
    return sum;
  };
  if (model.parts().faults.size() > other.parts().faults.size()) return model.parts().faults.back().cause;
  if (model.count(3) < other.count(3)) return "a region would be lost";
  if (std::abs(volume(model) - volume(other)) > kSameVolume * std::abs(volume(other)))
    return fmt::format("the volume would change from {:.6g} to {:.6g} mm^3", volume(other), volume(model));
  return {};
}

/// The first face that lies far off its own facets for what was taken away at its borders, by its number as
/// read, and how far; empty: none.
std::string spoilt_face(const Model& model, const ReadOptions& options) {
  constexpr double kFar = 5.0;
  const double kept_to =
      options.facet_deflection > 0.0 ? options.facet_deflection : kDeflectionShare * model.diagonal();
  for (int face = 1; face <= model.count(2); ++face) {
    const double off = model.facets().deviation[static_cast<std::size_t>(face)];
    if (off <= kFar * std::max(options.smallest_feature, kept_to)) continue;
    const auto numbers = sources(model.provenance(), 2, model.count(2))[static_cast<std::size_t>(face)];
    return fmt::format("{} would lie {:.3g} mm off its edges",
                       numbers.empty() ? "a face" : fmt::format("Face {}", numbers.front()), off);
  }
  return {};
}

using Clock = std::chrono::steady_clock;

/// What is left of a time limit in seconds, 0: none; a moment at least, for 0 would be no limit.
double left_of(double limit, Clock::time_point begin) {
  constexpr double kMoment = 0.1;
  return limit > 0.0 ? std::max(kMoment, limit - std::chrono::duration<double>(Clock::now() - begin).count())
                     : 0.0;
}

/// How many solids are left out where nothing is taken away.
std::size_t faults_without_defeaturing(ReadJob job) {
  job.options.smallest_feature = 0.0;
  return read_job(job).faults.size();
}

/// With less taken away, where all that was asked for would spoil the part; `note` says so. The job is left
/// with what was taken.
Model read_defeatured(ReadJob& job, std::string& note) {
  constexpr int kHalvings = 3;
  double& smallest = job.options.smallest_feature;
  const double asked = smallest, limit = job.options.time_limit;
  const Clock::time_point begin = Clock::now();
  std::string first_cause;
  std::optional<std::size_t> known_faults;
  for (int tries = 0; smallest > 0.0; ++tries) {
    std::string cause;
    try {
      Model model(read_job(job));
      const std::vector<Fault>& faults = model.parts().faults;
      if (!faults.empty() && !known_faults) known_faults = faults_without_defeaturing(job);
      cause =
          faults.size() > known_faults.value_or(0) ? faults.back().cause : spoilt_face(model, job.options);
      if (cause.empty()) return model;
    } catch (const ModelError& error) {
      cause = error.what();
    }
    if (tries == 0) first_cause = cause;
    smallest = tries < kHalvings ? 0.5 * smallest : 0.0;
    note = fmt::format(
        "features smaller than {:.4g} mm cannot all be taken away, for {}: {}", asked, first_cause,
        smallest > 0.0 ? fmt::format("those smaller than {:.4g} mm were", smallest) : "none were");
    job.options.time_limit = left_of(limit, begin);
  }
  return Model(read_job(job));
}

Model with_note(const Model& model, const std::string& note) {
  ModelParts parts = model.parts();
  parts.notes.push_back(note);
  return Model(std::move(parts));
}

/// Why the model is not what another one encloses whose boundary crosses itself in some places; empty: it is,
/// and crosses itself in fewer.
std::string unlikeness_of(const Model& model, const Model& crossed,
                          const std::vector<FaceCrossing>& crossings) {
  constexpr double kSameShare = 1e-4;
  const std::size_t left = crossings_within_regions(model).size();
  if (model.parts().faults.size() > crossed.parts().faults.size()) return model.parts().faults.back().cause;
  if (left >= crossings.size()) return fmt::format("{} pair(s) of faces would cross", left);
  std::set<int> regions;
  for (const FaceCrossing& crossing : crossings)
    for (const int face : crossing.face)
      regions.insert(crossed.face(face).region.begin(), crossed.face(face).region.end());
  regions.erase(0);
  const double share = share_covered_once(crossed, model, {regions.begin(), regions.end()});
  if (share > kSameShare) return fmt::format("{:.2g} of the volume would be lost or won", share);
  return {};
}

/// Readings with the faces that cross cut along each other, and of the solids what they enclose: as long as
/// fewer cross by it, and nothing else changes. The job is left with the pairs that were cut.
Model read_united(ReadJob& job, Model model) {
  constexpr int kReadings = 3;
  const Clock::time_point begin = Clock::now();
  const double limit = job.options.time_limit;
  for (int reading = 0; reading < kReadings; ++reading) {
    const std::vector<FaceCrossing> crossings = crossings_within_regions(model);
    const FaceNumberPairs pairs = numbers_of(crossings, model);
    if (pairs.empty()) break;
    ReadJob next = job;
    next.options.time_limit = left_of(limit, begin);
    next.meeting.crossing.insert(next.meeting.crossing.end(), pairs.begin(), pairs.end());
    std::string cause;
    try {
      Model united(read_job(next));
      cause = unlikeness_of(united, model, crossings);
      if (cause.empty()) model = std::move(united);
    } catch (const InputError& error) {
      cause = error.what();
    }
    if (!cause.empty())
      return with_note(model, fmt::format("{} pair(s) of faces cross, the first is Face {} and Face {}; they "
                                          "are left so, for cut along each other: {}",
                                          pairs.size(), pairs.front()[0], pairs.front()[1], cause));
    job.meeting = next.meeting;
  }
  return model;
}

/// The job's second reading, with the faces that touch imprinted on each other, where nothing is lost by it;
/// the model of the first with a note otherwise.
Model read_imprinted(const ReadJob& job, const Model& model) {
  std::string loss;
  try {
    Model imprinted(read_job(job));
    loss = loss_of(imprinted, model);
    if (loss.empty()) return imprinted;
  } catch (const InputError& error) {
    loss = error.what();
  }
  return with_note(
      model,
      fmt::format(
          "{} pair(s) of faces touch without an edge or a vertex that they share, the first is Face {} "
          "and Face {}; they are left so, for imprinted on each other: {}",
          job.meeting.touching.size(), job.meeting.touching.front()[0], job.meeting.touching.front()[1],
          loss));
}

}  // namespace

std::string reader_version() { return "Octet " OCTET_VERSION " with OCCT " OCC_VERSION_COMPLETE; }

std::string serve_job(std::string_view request, const StageLog& log) {
  ByteReader in(request);
  ReadJob job;
  std::string path, shape;
  in(path, job.kind, shape, job.options.facet_deflection, job.options.sew_tolerance,
     job.options.smallest_feature, job.options.fuse, job.meeting.crossing, job.meeting.touching);
  job.path = path;
  if (!shape.empty()) job.shape = decode_shape(shape);
  return do_job(job, log);
}

ModelParts read_job(const ReadJob& job) {
  std::string note;
  const std::string bytes = guarded_bytes(job, note);
  const OcctLock lock;
  try {
    ModelParts parts = decode_part(bytes);
    if (!note.empty()) parts.notes.push_back(note);
    return parts;
  } catch (const Standard_Failure& failure) {
    throw Bug(std::string("a part that was read cannot be restored: ") + failure.GetMessageString());
  }
}

Model read_model(ReadJob job) {
  const Clock::time_point begin = Clock::now();
  const double limit = job.options.time_limit;
  std::string note;
  Model model = read_defeatured(job, note);
  job.options.time_limit = left_of(limit, begin);
  model = read_united(job, std::move(model));
  job.meeting.touching = numbers_of(touches_without_crossings(model), model);
  if (!job.meeting.touching.empty()) {
    job.options.time_limit = left_of(limit, begin);
    model = read_imprinted(job, model);
  }
  return note.empty() ? std::move(model) : with_note(model, note);
}

}  // namespace octet
