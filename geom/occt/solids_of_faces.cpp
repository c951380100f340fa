// SPDX-License-Identifier: BSD-3-Clause
// Faces that bound solids, sorted into these.
#include "geom/occt/solids_of_faces.h"

#include <BRepClass3d_SolidClassifier.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

#include <numeric>

#include "geom/occt/shape_measures.h"

namespace octet {
namespace {

/// For each face the first face that it hangs together with.
std::vector<std::size_t> groups_of(const std::vector<TopoDS_Shape>& faces) {
  std::vector<std::size_t> group(faces.size());
  std::iota(group.begin(), group.end(), 0u);
  const auto root = [&](std::size_t i) {
    while (group[i] != i) i = group[i] = group[group[i]];
    return i;
  };
  TopTools_DataMapOfShapeInteger first_user;
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (TopExp_Explorer it(faces[i], TopAbs_EDGE); it.More(); it.Next()) {
      if (!first_user.IsBound(it.Current())) first_user.Bind(it.Current(), static_cast<int>(i));
      const std::size_t a = root(static_cast<std::size_t>(first_user.Find(it.Current()))), b = root(i);
      group[std::max(a, b)] = std::min(a, b);
    }
  for (std::size_t i = 0; i < faces.size(); ++i) group[i] = root(i);
  return group;
}

struct Lump {
  TopoDS_Solid solid;
  double volume = 0.0;
};

bool holds(const Lump& lump, const TopoDS_Shape& shell) {
  const TopExp_Explorer vertex(shell, TopAbs_VERTEX);
  if (!vertex.More()) return false;
  const BRepClass3d_SolidClassifier classifier(lump.solid, BRep_Tool::Pnt(TopoDS::Vertex(vertex.Current())),
                                               Precision::Confusion());
  return classifier.State() == TopAbs_IN;
}

}  // namespace

std::vector<TopoDS_Shape> solids_of_faces(const std::vector<TopoDS_Shape>& faces) {
  const BRep_Builder builder;
  const std::vector<std::size_t> group = groups_of(faces);
  std::vector<Lump> lumps;
  std::vector<TopoDS_Shell> voids;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (group[i] != i) continue;
    TopoDS_Shell shell;
    builder.MakeShell(shell);
    for (std::size_t j = i; j < faces.size(); ++j)
      if (group[j] == i) builder.Add(shell, faces[j]);
    shell.Closed(true);
    const double volume = volume_of(shell);
    if (volume <= 0.0) {
      voids.push_back(shell);
      continue;
    }
    TopoDS_Solid solid;
    builder.MakeSolid(solid);
    builder.Add(solid, shell);
    lumps.push_back({solid, volume});
  }
  std::vector<std::size_t> around(voids.size());
  for (std::size_t v = 0; v < voids.size(); ++v) {
    std::size_t smallest = lumps.size();
    for (std::size_t i = 0; i < lumps.size(); ++i)
      if ((lumps.size() == 1 || holds(lumps[i], voids[v])) &&
          (smallest == lumps.size() || lumps[i].volume < lumps[smallest].volume))
        smallest = i;
    if (smallest == lumps.size()) return {};
    around[v] = smallest;
  }
  for (std::size_t v = 0; v < voids.size(); ++v) builder.Add(lumps[around[v]].solid, voids[v]);
  std::vector<TopoDS_Shape> solids;
  for (const Lump& lump : lumps) solids.push_back(lump.solid);
  return solids;
}

}  // namespace octet
