// SPDX-License-Identifier: BSD-3-Clause
// One part: the fast paths against every surface asked without facets and against OCCT's solid classifier;
// winding numbers decide where the two differ.
//
// octet_interrogate PART [SEGMENTS [POINTS [SECONDS]]] prints one JSON object.
#include <BRepClass3d_SolidClassifier.hxx>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "lattice_segments.h"
#include "part_and_shape.h"
#include "slow_reference.h"
#include "winding_number.h"

namespace octet::test {
namespace {

using Clock = std::chrono::steady_clock;
using Json = nlohmann::json;

struct Limits {
  int segments = 20000, points = 1000;
  double seconds = 60.0;  ///< for each of the two comparisons
};

Json place(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

/// Of a vertex and the edges that end in it: the gap around an event there.
double tolerance_of(const Model& model, ModelRef on) {
  if (on.dim == 2) return 0.0;
  if (on.dim == 1) return model.edge(on.tag).tolerance;
  double most = model.vertex(on.tag).tolerance;
  for (const int edge : model.vertex(on.tag).edges) most = std::max(most, model.edge(edge).tolerance);
  return most;
}

/// `missed`: roots that the model does not report. `extra`: hits on faces that no surface has. Hits on edges
/// and vertices without a root are cracks within their tolerance: counted apart.
Json compare_segments(const Model& model, const Limits& limits) {
  LatticeSegments segments(model);
  int asked = 0, hits_seen = 0, missed = 0, extra = 0, cracks = 0;
  Json places = Json::array();
  std::vector<Hit> hits;
  const auto start = Clock::now();
  for (; asked < limits.segments; ++asked) {
    if (asked % 64 == 0 && std::chrono::duration<double>(Clock::now() - start).count() > limits.seconds)
      break;
    const auto [p, q] = segments.next();
    hits.clear();
    model.intersect(p, q, hits);
    hits_seen += static_cast<int>(hits.size());
    const std::vector<double> expected = events_without_facets(model, p, q);
    const double near = 1e-6 * model.diagonal();
    const auto reach = [&](const Hit& hit) { return near + 4.0 * tolerance_of(model, hit.on); };
    const double length = (q - p).norm();
    const auto close = [&](const Hit& hit, double t) { return std::abs(hit.t - t) * length <= reach(hit); };
    for (const double t : expected)
      if (std::none_of(hits.begin(), hits.end(), [&](const Hit& hit) { return close(hit, t); })) {
        ++missed;
        if (places.size() < 5)
          places.push_back({{"missed", place(p + t * (q - p))}, {"from", place(p)}, {"to", place(q)}});
      }
    for (const Hit& hit : hits) {
      if (std::any_of(expected.begin(), expected.end(), [&](double t) { return close(hit, t); })) continue;
      ++(hit.on.dim == 2 ? extra : cracks);
      if (hit.on.dim == 2 && places.size() < 5)
        places.push_back({{"extra", place(hit.point)},
                          {"on", model.describe(hit.on)},
                          {"from", place(p)},
                          {"to", place(q)}});
    }
  }
  return {{"segments", asked}, {"hits", hits_seen}, {"missed", missed},
          {"extra", extra},    {"cracks", cracks},  {"places", places}};
}

/// What OCCT's classifiers of the solids say; no value: on the boundary, or unknown.
class Classifiers {
 public:
  explicit Classifiers(const Numbering& numbering) {
    for (int tag = 1; tag <= numbering.count(3); ++tag)
      solids_.push_back(std::make_unique<BRepClass3d_SolidClassifier>(numbering.solid(tag)));
  }

  std::optional<int> solid_around(const Vec3& p) {
    bool unclear = false;
    for (std::size_t i = 0; i < solids_.size(); ++i) {
      solids_[i]->Perform(gp_Pnt(p.x(), p.y(), p.z()), 1e-7);
      if (solids_[i]->State() == TopAbs_IN) return static_cast<int>(i) + 1;
      unclear |= solids_[i]->State() == TopAbs_ON || solids_[i]->State() == TopAbs_UNKNOWN;
    }
    return unclear ? std::nullopt : std::optional(0);
  }

 private:
  std::vector<std::unique_ptr<BRepClass3d_SolidClassifier>> solids_;
};

/// Who is right where the model and the classifier differ: `ours_right`, `theirs_right`, `neither`;
/// `within_tolerance` where p is nearer to the boundary than the part knows it; else `undecided`.
const char* verdict(const Model& model, const std::optional<Foot>& foot, std::optional<int> third, int ours,
                    int theirs) {
  if (foot && foot->distance <= std::max(1e-7, model.tolerance_of(foot->on))) return "within_tolerance";
  if (!third) return "undecided";
  return *third == ours ? "ours_right" : *third == theirs ? "theirs_right" : "neither";
}

Json compare_points(const PartAndShape& part, const Limits& limits) {
  const Model& model = part.model;
  Classifiers classifiers(part.numbering);
  WindingNumbers winding(part.numbering, model);
  LatticeSegments random(model);
  int asked = 0, differ = 0, on = 0;
  Json places = Json::array();
  Json verdicts = Json::object();
  const auto start = Clock::now();
  for (; asked < limits.points; ++asked) {
    if (std::chrono::duration<double>(Clock::now() - start).count() > limits.seconds) break;
    Vec3 p;
    for (int k = 0; k < 3; ++k)
      p[k] = model.box().lo[k] + (1.1 * random.unit() - 0.05) * model.box().size()[k];
    const std::optional<int> theirs = classifiers.solid_around(p);
    if (!theirs) {
      ++on;
      continue;
    }
    const int ours = model.region_at(p);
    if (ours == *theirs) continue;
    ++differ;
    const auto foot = model.closest(p, 1e300);
    const char* who = verdict(model, foot, winding.region_around(p), ours, *theirs);
    verdicts[who] = verdicts.value(who, 0) + 1;
    if (places.size() < 5 || who != std::string_view("ours_right"))
      places.push_back({{"at", place(p)},
                        {"ours", ours},
                        {"theirs", *theirs},
                        {"verdict", who},
                        {"distance", foot ? foot->distance : -1.0},
                        {"near", foot ? model.describe(foot->on) : ""}});
  }
  return {{"points", asked}, {"differ", differ}, {"on", on}, {"verdicts", verdicts}, {"places", places}};
}

}  // namespace
}  // namespace octet::test

int main(int argc, char** argv) {
  using namespace octet::test;
  if (argc < 2) {
    std::fprintf(stderr, "usage: octet_interrogate PART [SEGMENTS [POINTS [SECONDS]]]\n");
    return 2;
  }
  Limits limits;
  if (argc > 2) limits.segments = std::atoi(argv[2]);
  if (argc > 3) limits.points = std::atoi(argv[3]);
  if (argc > 4) limits.seconds = std::atof(argv[4]);
  Json result;
  try {
    const PartAndShape part = read_with_shape(argv[1]);
    result["faces"] = part.model.count(2);
    result["rays"] = compare_segments(part.model, limits);
    result["sides"] = compare_points(part, limits);
  } catch (const std::exception& error) {
    result["refused"] = error.what();
  }
  std::printf("%s\n", result.dump(-1, ' ', false, Json::error_handler_t::replace).c_str());
  return 0;
}
