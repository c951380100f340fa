// SPDX-License-Identifier: BSD-3-Clause
// Solids that closed shells bound.
#include "geom/occt/shell_solids.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <cmath>

#include "geom/occt/free_edges.h"
#include "geom/occt/gathered.h"
#include "geom/occt/shape_box.h"
#include "geom/occt/shape_measures.h"
#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

/// Each edge that has a length is used twice, and there is one.
bool closes_by_itself(const TopoDS_Shape& face) {
  const TopTools_IndexedMapOfShape edges = sub_shapes(face, TopAbs_EDGE);
  const bool has_seam = std::any_of(edges.cbegin(), edges.cend(), [](const TopoDS_Shape& edge) {
    return !BRep_Tool::Degenerated(TopoDS::Edge(edge));
  });
  return has_seam && free_edges(face).empty();
}

std::vector<TopoDS_Shape> closed_shells(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Shape> shells;
  TopTools_MapOfShape seen;
  for (TopExp_Explorer it(shape, TopAbs_SHELL, TopAbs_SOLID); it.More(); it.Next())
    if (seen.Add(it.Current()) && BRep_Tool::IsClosed(it.Current())) shells.push_back(it.Current());
  for (TopExp_Explorer it(shape, TopAbs_FACE, TopAbs_SHELL); it.More(); it.Next())
    if (seen.Add(it.Current()) && closes_by_itself(it.Current()))
      shells.push_back(shell_of<TopoDS_Shape>({it.Current()}));
  return shells;
}

TopoDS_Solid solid_from_shell(const TopoDS_Shape& shell) {
  TopoDS_Solid solid;
  const BRep_Builder builder;
  builder.MakeSolid(solid);
  builder.Add(solid, shell.Oriented(TopAbs_FORWARD));
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

/// A closed shell, and what it encloses.
struct Enclosure {
  TopoDS_Shape shell;
  TopoDS_Solid solid;   ///< of this shell alone, turned outwards
  double volume = 0.0;  ///< below 0: the shell is turned inwards
  Bnd_Box box;          ///< of the shell
  bool is_void = false;

  [[nodiscard]] double size() const { return std::abs(volume); }
};

Enclosure enclosure_of(const TopoDS_Shape& shell) {
  return {shell, solid_from_shell(shell), volume_of(shell), box_of(shell)};
}

/// The largest first: what lies in another comes after it.
std::vector<Enclosure*> by_size(std::vector<Enclosure>& all) {
  std::vector<Enclosure*> sorted;
  for (Enclosure& one : all) sorted.push_back(&one);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Enclosure* a, const Enclosure* b) { return a->size() > b->size(); });
  return sorted;
}

/// By the first vertex, or middle of an edge, of `inner` that is off the boundary of `outer`.
bool lies_in(const Enclosure& inner, const Enclosure& outer) {
  if (inner.size() >= outer.size() || outer.box.IsOut(inner.box)) return false;
  BRepClass3d_SolidClassifier classifier(outer.solid);
  const auto is_decided = [&](const gp_Pnt& point) {
    classifier.Perform(point, Precision::Confusion());
    return classifier.State() == TopAbs_IN || classifier.State() == TopAbs_OUT;
  };
  for (TopExp_Explorer it(inner.shell, TopAbs_VERTEX); it.More(); it.Next())
    if (is_decided(BRep_Tool::Pnt(TopoDS::Vertex(it.Current())))) return classifier.State() == TopAbs_IN;
  for (TopExp_Explorer it(inner.shell, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    if (BRep_Tool::Degenerated(edge)) continue;
    const BRepAdaptor_Curve curve(edge);
    if (is_decided(curve.Value(0.5 * (curve.FirstParameter() + curve.LastParameter()))))
      return classifier.State() == TopAbs_IN;
  }
  return false;
}

/// The smallest that it lies in; null: none.
Enclosure* outer_of(const Enclosure& inner, std::vector<Enclosure>& all) {
  Enclosure* least = nullptr;
  for (Enclosure& outer : all)
    if ((least == nullptr || outer.size() < least->size()) && lies_in(inner, outer)) least = &outer;
  return least;
}

}  // namespace

std::vector<TopoDS_Shape> solids_from_shells(const TopoDS_Shape& shape) {
  std::vector<Enclosure> all;
  for (const TopoDS_Shape& shell : closed_shells(shape)) all.push_back(enclosure_of(shell));
  const BRep_Builder builder;
  for (Enclosure* one : by_size(all)) {
    Enclosure* outer = outer_of(*one, all);
    one->is_void =
        outer != nullptr && !outer->is_void && std::signbit(one->volume) != std::signbit(outer->volume);
    if (one->is_void)
      builder.Add(outer->solid, TopExp_Explorer(one->solid, TopAbs_SHELL).Current().Reversed());
  }
  std::vector<TopoDS_Shape> solids;
  for (const Enclosure& one : all)
    if (!one.is_void) solids.push_back(one.solid);
  return solids;
}

TurnedShells turn_nested_shells(const TopoDS_Shape& solid) {
  if (sub_shapes(solid, TopAbs_SHELL).Extent() < 2) return {solid};
  std::vector<Enclosure> all;
  for (TopExp_Explorer it(solid, TopAbs_SHELL); it.More(); it.Next())
    if (free_edges(it.Current()).empty()) all.push_back(enclosure_of(it.Current()));
  TopTools_MapOfShape turned;
  for (Enclosure* one : by_size(all)) {
    const Enclosure* outer = outer_of(*one, all);
    if (outer == nullptr || std::signbit(one->volume) != std::signbit(outer->volume)) continue;
    one->volume = -one->volume;
    turned.Add(one->shell);
  }
  if (turned.IsEmpty()) return {solid};
  const BRep_Builder builder;
  TopoDS_Solid made;
  builder.MakeSolid(made);
  for (TopoDS_Iterator it(solid); it.More(); it.Next())
    builder.Add(made, turned.Contains(it.Value()) ? it.Value().Reversed() : it.Value());
  return {made, static_cast<std::size_t>(turned.Extent())};
}

std::size_t count_voids(const std::vector<TopoDS_Shape>& solids) {
  std::size_t voids = 0;
  for (const TopoDS_Shape& solid : solids)
    voids += static_cast<std::size_t>(sub_shapes(solid, TopAbs_SHELL).Extent()) - 1;
  return voids;
}

}  // namespace octet
