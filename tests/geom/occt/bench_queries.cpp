// SPDX-License-Identifier: BSD-3-Clause
// Each query of a model against OCCT's own class for it, in pairs, on parts given on the command line.
//
// bench_geom_occt PART... [--benchmark_min_time=0.05]; prints a table of ratios after the benchmarks.
#include <BRepBndLib.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Extrema_ExtPS.hxx>
#include <GeomAPI_IntCS.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_Plane.hxx>
#include <IntCurvesFace_Intersector.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <benchmark/benchmark.h>
#include "lattice_segments.h"
#include "part_and_shape.h"

namespace octet::test {
namespace {

constexpr int kQuestions = 512;

struct Footing {
  int face = 0;
  Vec3 p = Vec3::Zero();
  Vec2 seed = Vec2::Zero();
};

struct PlaneCut {
  int edge = 0, axis = 0;
  double value = 0.0;
};

/// What an octree asks: edges of octants of a sixtieth of the part that meet its boundary, octant by octant,
/// in runs from all over the part.
std::vector<std::pair<Vec3, Vec3>> octant_edges(const Model& model) {
  const double h = model.diagonal() / 60.0;
  const Vec3 lo = model.box().lo - 0.3717 * Vec3::Constant(h);
  const Vec3 last = (model.box().hi - lo) / h;
  std::vector<Vec3> octants;
  for (int z = 0; z <= last.z(); ++z)
    for (int y = 0; y <= last.y(); ++y)
      for (int x = 0; x <= last.x(); ++x) {
        Box3 octant;
        octant.lo = lo + h * Vec3(x, y, z);
        octant.hi = octant.lo + Vec3::Constant(h);
        if (model.near_boundary(octant)) octants.push_back(octant.lo);
      }
  constexpr std::size_t kRuns = 16, kLength = 16;
  std::vector<std::pair<Vec3, Vec3>> edges;
  for (std::size_t run = 0; run < kRuns; ++run)
    for (std::size_t i = 0; i < kLength; ++i)
      for (int axis = 0; axis < 3; ++axis) {
        const Vec3& p = octants[(octants.size() * run / kRuns + i) % octants.size()];
        edges.emplace_back(p, p + h * Vec3::Unit(axis));
      }
  return edges;
}

/// Whether OCCT, too, has to search for a foot.
bool is_free_form(std::string_view kind) {
  constexpr std::string_view kClosed[] = {"plane", "cylinder", "cone", "sphere", "torus"};
  return std::find(std::begin(kClosed), std::end(kClosed), kind) == std::end(kClosed);
}

/// A part, the questions, and OCCT's classes ready to answer.
struct Bench {
  explicit Bench(const std::filesystem::path& path) : part(read_with_shape(path)) {
    LatticeSegments random(part.model, 0.0);
    segments = octant_edges(part.model);
    const Box3& box = part.model.box();
    for (int i = 0; i < kQuestions; ++i)
      points.emplace_back(box.lo +
                          Vec3(random.unit(), random.unit(), random.unit()).cwiseProduct(box.size()));
    const double h = part.model.diagonal() / 60.0;
    const Facets& facets = part.model.facets();
    for (int i = 0; i < kQuestions; ++i) {
      const auto t = static_cast<std::size_t>(random.unit() * static_cast<double>(facets.triangles.size()));
      const Vec2 seed = (facets.uv[t][0] + facets.uv[t][1] + facets.uv[t][2]) / 3.0;
      const Vec3 away = Vec3(random.unit(), random.unit(), random.unit()) - Vec3::Constant(0.5);
      const int face = facets.face[t];
      const Footing footing{face, part.model.face_jet(face, seed, 0).p + 0.2 * h * away, seed};
      footings.push_back(footing);
      if (is_free_form(part.model.surface(face).kind())) free_footings.push_back(footing);
      const int edge = 1 + static_cast<int>(random.unit() * part.model.count(1));
      if (part.model.edge(edge).use == EdgeUse::kDegenerate) continue;
      const int axis = i % 3;
      const ModelEdge& e = part.model.edge(edge);
      cuts.push_back({edge, axis, part.model.edge_point(edge, e.t0 + random.unit() * (e.t1 - e.t0))[axis]});
    }
    load_occt();
  }

  void load_occt() {
    for (int tag = 1; tag <= part.model.count(2); ++tag) {
      const TopoDS_Face face = part.numbering.face(tag);
      Bnd_Box box;
      BRepBndLib::Add(face, box);
      boxes.push_back(box);
      intersectors.push_back(std::make_unique<IntCurvesFace_Intersector>(face, Precision::Confusion()));
      double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
      BRepTools::UVBounds(face, u0, u1, v0, v1);
      const GeomAdaptor_Surface surface(BRep_Tool::Surface(face), u0, u1, v0, v1);
      surfaces.push_back(std::make_unique<GeomAdaptor_Surface>(surface));
      projectors.push_back(std::make_unique<Extrema_ExtPS>());
      projectors.back()->Initialize(*surfaces.back(), u0, u1, v0, v1, Precision::PConfusion(),
                                    Precision::PConfusion());
    }
    for (int tag = 1; tag <= part.model.count(3); ++tag)
      solids.push_back(std::make_unique<BRepClass3d_SolidClassifier>(part.numbering.solid(tag)));
    for (int tag = 1; tag <= part.model.count(1); ++tag) {
      double a = 0.0, b = 0.0;
      curves.push_back(BRep_Tool::Curve(part.numbering.edge(tag), a, b));
    }
  }

  PartAndShape part;
  std::vector<std::pair<Vec3, Vec3>> segments;
  std::vector<Vec3> points;
  std::vector<Footing> footings, free_footings;  ///< on all faces; on those that are no closed forms
  std::vector<PlaneCut> cuts;
  std::vector<Bnd_Box> boxes;
  std::vector<std::unique_ptr<IntCurvesFace_Intersector>> intersectors;
  std::vector<std::unique_ptr<GeomAdaptor_Surface>> surfaces;
  std::vector<std::unique_ptr<Extrema_ExtPS>> projectors;
  std::vector<std::unique_ptr<BRepClass3d_SolidClassifier>> solids;
  std::vector<Handle(Geom_Curve)> curves;
};

using Question = void (*)(Bench&, std::size_t);

void intersect(Bench& bench, std::size_t i) {
  static thread_local std::vector<Hit> hits;
  hits.clear();
  const auto& [p, q] = bench.segments[i % bench.segments.size()];
  bench.part.model.intersect(p, q, hits);
  benchmark::DoNotOptimize(hits.data());
}

void occt_intersect(Bench& bench, std::size_t i) {
  const auto& [p, q] = bench.segments[i % bench.segments.size()];
  const gp_Pnt a(p.x(), p.y(), p.z()), b(q.x(), q.y(), q.z());
  Bnd_Box box;
  box.Add(a);
  box.Add(b);
  const gp_Lin line(a, gp_Dir(gp_Vec(a, b)));
  for (std::size_t f = 0; f < bench.boxes.size(); ++f) {
    if (bench.boxes[f].IsOut(box)) continue;
    bench.intersectors[f]->Perform(line, 0.0, a.Distance(b));
    benchmark::DoNotOptimize(bench.intersectors[f]->NbPnt());
  }
}

void region(Bench& bench, std::size_t i) {
  benchmark::DoNotOptimize(bench.part.model.region_at(bench.points[i % bench.points.size()]));
}

void occt_region(Bench& bench, std::size_t i) {
  const Vec3& p = bench.points[i % bench.points.size()];
  for (const auto& solid : bench.solids) {
    solid->Perform(gp_Pnt(p.x(), p.y(), p.z()), 1e-7);
    if (solid->State() == TopAbs_IN) break;
  }
}

void project_on(const Bench& bench, const Footing& f) {
  benchmark::DoNotOptimize(bench.part.model.surface(f.face).project(f.p, f.seed));
}

void occt_project_on(Bench& bench, const Footing& f) {
  Extrema_ExtPS& projector = *bench.projectors[static_cast<std::size_t>(f.face - 1)];
  projector.Perform(gp_Pnt(f.p.x(), f.p.y(), f.p.z()));
  benchmark::DoNotOptimize(projector.IsDone());
}

void project(Bench& bench, std::size_t i) { project_on(bench, bench.footings[i % bench.footings.size()]); }

void occt_project(Bench& bench, std::size_t i) {
  occt_project_on(bench, bench.footings[i % bench.footings.size()]);
}

void free_project(Bench& bench, std::size_t i) {
  project_on(bench, bench.free_footings[i % bench.free_footings.size()]);
}

void occt_free_project(Bench& bench, std::size_t i) {
  occt_project_on(bench, bench.free_footings[i % bench.free_footings.size()]);
}

void cut(Bench& bench, std::size_t i) {
  static thread_local std::vector<double> at;
  at.clear();
  const PlaneCut& c = bench.cuts[i % bench.cuts.size()];
  bench.part.model.curve(c.edge).cut(Vec3::Unit(c.axis), c.value, at);
  benchmark::DoNotOptimize(at.data());
}

void occt_cut(Bench& bench, std::size_t i) {
  const PlaneCut& c = bench.cuts[i % bench.cuts.size()];
  const gp_Dir axis(c.axis == 0, c.axis == 1, c.axis == 2);
  const Handle(Geom_Plane) plane = new Geom_Plane(gp_Pnt(axis.XYZ() * c.value), axis);
  const GeomAPI_IntCS cut(bench.curves[static_cast<std::size_t>(c.edge - 1)], plane);
  benchmark::DoNotOptimize(cut.NbPoints());
}

struct Pair {
  const char* name;
  Question ours, theirs;
};
constexpr Pair kPairs[] = {{"face-segment", intersect, occt_intersect},
                           {"in-out", region, occt_region},
                           {"projection", project, occt_project},
                           {"on-free-form", free_project, occt_free_project},
                           {"edge-plane", cut, occt_cut}};

/// Keeps the time of every benchmark for the table.
class Keeper : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) cpu_[run.benchmark_name()] = run.GetAdjustedCPUTime();
    ConsoleReporter::ReportRuns(runs);
  }
  [[nodiscard]] std::optional<double> cpu(const std::string& name) const {
    const auto it = cpu_.find(name);
    return it == cpu_.end() ? std::nullopt : std::optional(it->second);
  }

 private:
  std::map<std::string, double> cpu_;
};

std::string name_of(const Pair& pair, const std::string& part, const char* side) {
  return std::string(pair.name) + "/" + part + "/" + side;
}

/// Asks `before` questions beside the clock: what is made when it is first asked for, and kept.
void add(Bench& bench, const std::string& name, Question question, std::size_t before) {
  benchmark::RegisterBenchmark(name.c_str(), [&bench, question, before](benchmark::State& state) {
    for (std::size_t i = 0; i < before; ++i) question(bench, i);
    std::size_t i = 0;
    for (auto _ : state) question(bench, i++);
  })->Unit(benchmark::kNanosecond);
}

/// By question; nothing where it was not asked of the part.
using Row = std::array<std::optional<double>, std::size(kPairs)>;

void print_line(const std::string& name, const Row& row) {
  std::printf("\n%-34s", name.c_str());
  for (const std::optional<double>& ratio : row) {
    if (ratio)
      std::printf("%17.1f", *ratio);
    else
      std::printf("%17s", "-");
  }
}

Row medians(const std::vector<Row>& rows) {
  Row median;
  for (std::size_t k = 0; k < median.size(); ++k) {
    std::vector<double> ratios;
    for (const Row& row : rows)
      if (row[k]) ratios.push_back(*row[k]);
    std::sort(ratios.begin(), ratios.end());
    if (!ratios.empty()) median[k] = ratios[ratios.size() / 2];
  }
  return median;
}

void print_table(const Keeper& keeper, const std::vector<std::string>& parts) {
  std::printf("\n%-34s", "OCCT / ours, CPU time");
  for (const Pair& pair : kPairs) std::printf("%17s", pair.name);
  std::vector<Row> rows, free_form;
  for (const std::string& part : parts) {
    Row row;
    bool is_free = false;
    for (std::size_t k = 0; k < std::size(kPairs); ++k) {
      const auto ours = keeper.cpu(name_of(kPairs[k], part, "octet"));
      const auto theirs = keeper.cpu(name_of(kPairs[k], part, "occt"));
      if (ours && theirs) row[k] = *theirs / *ours;
      is_free = is_free || (row[k] && kPairs[k].ours == free_project);
    }
    print_line(part, row);
    rows.push_back(row);
    if (is_free) free_form.push_back(row);
  }
  print_line("median", medians(rows));
  print_line("of those with free-form faces", medians(free_form));
  std::printf("\n");
}

}  // namespace
}  // namespace octet::test

int main(int argc, char** argv) {
  using namespace octet::test;
  benchmark::Initialize(&argc, argv);
  std::vector<std::unique_ptr<Bench>> benches;
  std::vector<std::string> parts;
  for (int i = 1; i < argc; ++i) {
    try {
      benches.push_back(std::make_unique<Bench>(argv[i]));
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s: %s\n", argv[i], error.what());
      continue;
    }
    parts.push_back(std::filesystem::path(argv[i]).stem().string());
    for (const Pair& pair : kPairs) {
      if (pair.ours == free_project && benches.back()->free_footings.empty()) continue;
      add(*benches.back(), name_of(pair, parts.back(), "octet"), pair.ours, benches.back()->segments.size());
      add(*benches.back(), name_of(pair, parts.back(), "occt"), pair.theirs, 1);
    }
  }
  Keeper keeper;
  benchmark::RunSpecifiedBenchmarks(&keeper);
  print_table(keeper, parts);
  return 0;
}
