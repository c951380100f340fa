// SPDX-License-Identifier: BSD-3-Clause
// OCCT's integrals over one face at a time.
#include "geom/occt/face_volumes.h"

#include <BRepGProp_Domain.hxx>
#include <BRepGProp_Face.hxx>
#include <BRepGProp_Vinert.hxx>
#include <NCollection_Map.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

namespace octet {
namespace {

using FaceSet = NCollection_Map<TopoDS_Shape, TopTools_OrientedShapeMapHasher>;

/// Those that bound volume on one side alone.
template <class Visit>
void for_bounding_faces(const TopoDS_Shape& solid, const Visit& visit) {
  for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) {
    const TopAbs_Orientation way = it.Current().Orientation();
    if (way == TopAbs_FORWARD || way == TopAbs_REVERSED) visit(TopoDS::Face(it.Current()));
  }
}

FaceSet faces_of(const TopoDS_Shape& solid) {
  FaceSet faces;
  for_bounding_faces(solid, [&](const TopoDS_Face& face) { faces.Add(face); });
  return faces;
}

}  // namespace

double FaceVolumes::of(const TopoDS_Shape& solid) {
  double sum = 0.0;
  for_bounding_faces(solid, [&](const TopoDS_Face& face) { sum += of_face(face); });
  return sum;
}

double FaceVolumes::change(const TopoDS_Shape& before, const TopoDS_Shape& after) {
  const FaceSet were = faces_of(before), are = faces_of(after);
  double sum = 0.0;
  for_bounding_faces(after, [&](const TopoDS_Face& face) {
    if (!were.Contains(face)) sum += of_face(face);
  });
  for_bounding_faces(before, [&](const TopoDS_Face& face) {
    if (!are.Contains(face)) sum -= of_face(face);
  });
  return sum;
}

double FaceVolumes::of_face(const TopoDS_Face& face) {
  if (const double* known = known_.Seek(face)) return *known;
  BRepGProp_Vinert integral;
  integral.SetLocation(from_);
  BRepGProp_Face surface(face);
  if (TopoDS_Iterator(face).More()) {
    BRepGProp_Domain domain(face);
    integral.Perform(surface, domain);
  } else {
    integral.Perform(surface);
  }
  const double volume = integral.Mass();
  known_.Bind(face, volume);
  return volume;
}

}  // namespace octet
