// SPDX-License-Identifier: BSD-3-Clause
// Volumes and areas of OCCT shapes.
#pragma once

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

namespace octet {

/// Of a solid or a shell, negative where its faces are turned inward. By OCCT's integrals: exact on simple
/// surfaces, per cents off on some splines.
[[nodiscard]] inline double volume_of(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.Mass();
}

/// The same by integrals that are refined until they change by no more than a millionth: slow.
[[nodiscard]] inline double refined_volume_of(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties, 1e-6);
  return properties.Mass();
}

[[nodiscard]] inline double area_of(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties);
  return properties.Mass();
}

/// Twice the area over the perimeter: of a long face that is its width.
[[nodiscard]] inline double width_of(const TopoDS_Face& face) {
  GProp_GProps perimeter;
  BRepGProp::LinearProperties(face, perimeter);
  return 2.0 * area_of(face) / perimeter.Mass();
}

}  // namespace octet
