// SPDX-License-Identifier: BSD-3-Clause
// Models with exact closed forms, so that every other room is tested without OCCT.
#pragma once

#include "geom/model.h"

namespace octet {

/// A right-handed frame: a position and a rotation.
struct Frame {
  Vec3 origin = Vec3::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns are the local x, y, z
};

/// Facets of the twin deviate by at most `deflection` from the exact surfaces (model units).
struct AnalyticOptions {
  Frame frame;
  double deflection = 1e-3;
};

/// Box [0,a]x[0,b]x[0,c]: 8 vertices, 12 edges, 6 faces, 1 region.
[[nodiscard]] Model analytic_box(const Vec3& size, const AnalyticOptions& options = {});
/// Two boxes of `size` side by side along x that share a face: 12 vertices, 20 edges, 11 faces, 2 regions.
[[nodiscard]] Model analytic_two_boxes(const Vec3& size, const AnalyticOptions& options = {});
/// A wedge (triangular prism): base angle at the x=y=0 edge, legs of `length`, height `height` along z.
[[nodiscard]] Model analytic_wedge(double angle, double length, double height,
                                   const AnalyticOptions& options = {});
/// Ball around the origin, topology as OCCT's: 1 face, a seam, two degenerate edges, two vertices.
[[nodiscard]] Model analytic_ball(double radius, const AnalyticOptions& options = {});
/// Ball with a concentric spherical void: 2 faces.
[[nodiscard]] Model analytic_hollow_ball(double outer, double inner, const AnalyticOptions& options = {});
/// Box [-a/2,a/2]^3 minus a ball at its centre (a void).
[[nodiscard]] Model analytic_box_minus_ball(double side, double radius, const AnalyticOptions& options = {});
/// Cylinder along z from 0 to `height`.
[[nodiscard]] Model analytic_cylinder(double radius, double height, const AnalyticOptions& options = {});
/// Cone with radius `radius` at z=0 and its apex at z=`height`.
[[nodiscard]] Model analytic_cone(double radius, double height, const AnalyticOptions& options = {});
/// Torus around z.
[[nodiscard]] Model analytic_torus(double major, double minor, const AnalyticOptions& options = {});

}  // namespace octet
