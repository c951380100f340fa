// SPDX-License-Identifier: BSD-3-Clause
// The whole torus, cut where no loop is, with the loops as holes.
#include "geom/occt/holed_torus.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <ElSLib.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Precision.hxx>
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/constants.h"
#include "geom/occt/edge_loops.h"
#include "geom/occt/loose_curves.h"
#include "geom/occt/unrolled_loops.h"

namespace octet {
namespace {

/// The loops of a border, each turned as its edges are; empty where they do not all close.
std::vector<EdgeLoop> loops_of(const std::vector<TopoDS_Edge>& border) {
  std::vector<EdgeLoop> loops = edge_loops(border);
  std::size_t edges = 0;
  for (EdgeLoop& loop : loops) {
    edges += loop.size();
    const auto given = std::find_if(border.begin(), border.end(),
                                    [&](const TopoDS_Edge& edge) { return edge.IsSame(loop.front()); });
    if (given->Orientation() == loop.front().Orientation()) continue;
    std::reverse(loop.begin(), loop.end());
    for (TopoDS_Edge& edge : loop) edge.Reverse();
  }
  return edges == border.size() ? loops : std::vector<EdgeLoop>();
}

/// Middle of the widest part of a turn that no place lies in. None where that is narrow.
std::optional<double> gap_in(std::vector<double> places) {
  constexpr double kNarrow = 0.05;
  for (double& p : places) p -= kTurn * std::floor(p / kTurn);
  std::sort(places.begin(), places.end());
  double width = places.front() + kTurn - places.back(), middle = places.back() + 0.5 * width;
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (places[i] - places[i - 1] <= width) continue;
    width = places[i] - places[i - 1];
    middle = places[i - 1] + 0.5 * width;
  }
  if (width < kNarrow) return {};
  return middle;
}

Unrolling unrolling_of(const gp_Torus& torus) {
  return {new Geom_ToroidalSurface(torus),
          [torus](const gp_Pnt& p) {
            double u = 0.0, v = 0.0;
            ElSLib::Parameters(torus, p, u, v);
            return gp_Pnt2d(u, v);
          },
          true};
}

/// Whether the places close, and lie clockwise around what they enclose.
bool is_hole(const std::vector<gp_Pnt2d>& places) {
  constexpr double kSame = 1e-3;
  if (places.front().Distance(places.back()) > kSame) return false;
  double twice = 0.0;
  for (std::size_t i = 1; i < places.size(); ++i)
    twice += places[i - 1].X() * places[i].Y() - places[i].X() * places[i - 1].Y();
  return twice < 0.0;
}

}  // namespace

TopoDS_Face holed_torus(const gp_Torus& torus, const std::vector<TopoDS_Edge>& border) {
  const std::vector<EdgeLoop> loops = loops_of(border);
  if (loops.empty() || !torus.Direct()) return {};
  const Unrolling old = unrolling_of(torus);
  std::vector<double> u, v;
  for (const EdgeLoop& loop : loops) {
    const std::vector<gp_Pnt2d> places = unrolled(old, loop, gp_Pnt2d());
    if (!is_hole(places)) return {};
    constexpr int kBetween = 16;
    for (std::size_t i = 1; i < places.size(); ++i)
      for (int k = 0; k < kBetween; ++k) {
        const double share = k / double(kBetween);
        u.push_back(places[i - 1].X() + share * (places[i].X() - places[i - 1].X()));
        v.push_back(places[i - 1].Y() + share * (places[i].Y() - places[i - 1].Y()));
      }
  }
  const std::optional<double> u_cut = gap_in(u), v_cut = gap_in(v);
  if (!u_cut || !v_cut) return {};
  gp_Torus cut = torus;
  cut.Rotate(torus.Axis(), *u_cut);
  const Unrolling on = unrolling_of(cut);
  TopoDS_Face made =
      BRepBuilderAPI_MakeFace(on.surface, 0.0, kTurn, *v_cut, *v_cut + kTurn, Precision::Confusion()).Face();
  const BRep_Builder builder;
  for (const EdgeLoop& loop : loops) {
    builder.Add(made, unrolled_wire(on, loop, gp_Pnt2d(0.5 * kTurn, *v_cut + 0.5 * kTurn)));
    for (const TopoDS_Edge& edge : loop) fit_curve(edge, made);
  }
  return made;
}

}  // namespace octet
