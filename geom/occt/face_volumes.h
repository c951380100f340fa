// SPDX-License-Identifier: BSD-3-Clause
// Volumes of solids that have most of their faces in common.
#pragma once

#include <NCollection_DataMap.hxx>
#include <TopTools_OrientedShapeMapHasher.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Pnt.hxx>

namespace octet {

/// The volume that a solid bounds, as `volume_of` (geom/occt/shape_measures.h) has it, as a sum over its
/// faces: a face that was integrated once is not integrated again, for this solid or for another.
class FaceVolumes {
 public:
  /// `from`: the volumes are those of cones from it, so it should be in or near the solids.
  explicit FaceVolumes(const gp_Pnt& from) : from_(from) {}

  [[nodiscard]] double of(const TopoDS_Shape& solid);
  /// What `after` bounds more than `before`: by the faces that one of them has and the other has not.
  [[nodiscard]] double change(const TopoDS_Shape& before, const TopoDS_Shape& after);

 private:
  [[nodiscard]] double of_face(const TopoDS_Face& face);

  gp_Pnt from_;
  NCollection_DataMap<TopoDS_Shape, double, TopTools_OrientedShapeMapHasher> known_;
};

}  // namespace octet
