// SPDX-License-Identifier: BSD-3-Clause
// Read with what the model shows, compared, taken or left.
#include "geom/occt/read_again.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "base/error.h"
#include "geom/face_crossings.h"
#include "geom/face_touches.h"
#include "geom/occt/contact_circle.h"
#include "geom/occt/join_solids.h"
#include "geom/occt/time_left.h"
#include "geom/winding.h"

namespace octet {
namespace {

/// Faces that cross bound nothing, with edges there or without: what touches any of those is left as it is.
std::vector<FaceTouch> touches_without_crossings(const Model& model) {
  std::vector<FaceTouch> touches = touching_faces(model, kContactShare * model.diagonal());
  if (touches.empty()) return touches;
  std::set<int> crossed;
  for (const FaceCrossing& crossing : model.crossings())
    crossed.insert(crossing.face.begin(), crossing.face.end());
  std::erase_if(touches, [&](const FaceTouch& touch) {
    return crossed.count(touch.face[0]) > 0 || crossed.count(touch.face[1]) > 0;
  });
  return touches;
}

/// Those of two faces of one region.
std::vector<FaceCrossing> crossings_within_regions(const Model& model) {
  std::vector<FaceCrossing> crossings = model.crossings();
  std::erase_if(crossings, [&](const FaceCrossing& crossing) {
    if (crossing.is_of_itself()) return true;
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

}  // namespace

Model with_note(const Model& model, const std::string& note) {
  ModelParts parts = model.parts();
  parts.notes.push_back(note);
  return Model(std::move(parts));
}

Model read_at_least_apart(const ReadJob& job, const std::function<Model(const ReadJob&)>& read) {
  try {
    return read(job);
  } catch (const NoEnd& error) {
    const bool joining =
        error.stage() == kFindingCommonFaces || std::string_view(error.stage()).starts_with(kFusing);
    if (!joining || job.options.embed) throw;
    ReadJob next = job;
    next.options.fuse = false;
    const Model apart = read(next);
    Fault fault;
    fault.place = apart.box().centre();
    fault.cause =
        fmt::format("the solids are kept apart, and share no faces where they touch: {}", error.what());
    fault.advice = "give it longer (--read-time-limit), or ask for solids that are apart (--no-fuse)";
    ModelParts parts = apart.parts();
    parts.faults.push_back(fault);
    return Model(std::move(parts));
  }
}

Model read_united(ReadJob& job, Model model) {
  constexpr int kReadings = 3;
  const TimeLeft time(job.options.time_limit);
  for (int reading = 0; reading < kReadings; ++reading) {
    const std::vector<FaceCrossing> crossings = crossings_within_regions(model);
    const FaceNumberPairs pairs = numbers_of(crossings, model);
    if (pairs.empty()) break;
    ReadJob next = job;
    next.options.time_limit = time.seconds();
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

Model read_imprinted(ReadJob job, Model model) {
  const TimeLeft time(job.options.time_limit);
  FaceNumberPairs& pairs = job.meeting.touching;
  pairs = numbers_of(touches_without_crossings(model), model);
  if (pairs.empty()) return model;
  job.options.time_limit = time.seconds();
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
      fmt::format("{} pair(s) of faces touch where they share no edge and no vertex, the first is Face {} "
                  "and Face {}; they are left so, for imprinted on each other: {}",
                  pairs.size(), pairs.front()[0], pairs.front()[1], loss));
}

}  // namespace octet
