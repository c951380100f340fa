// SPDX-License-Identifier: BSD-3-Clause
// Which loose faces belong to one body.
#pragma once

#include <TopoDS_Shape.hxx>
#include <cstddef>
#include <vector>

#include "base/vec.h"

namespace octet {

/// Files that have nothing but faces write one body after the other, and where two touch each has a face of
/// its own: to sew all at once is to choose between four faces at an edge, or to join edges that lie on each
/// other in part.
class LooseBodies {
 public:
  explicit LooseBodies(const std::vector<TopoDS_Shape>& faces);

  /// The faces in as many runs as can be, in their order, such that within each every edge has a partner: one
  /// that ends where it does and has the same middle and length within `tolerance`. None where they are no
  /// such bodies, or one alone.
  [[nodiscard]] std::vector<std::vector<TopoDS_Shape>> in_order(double tolerance) const;

 private:
  /// The course of an edge, as far as it tells edges apart.
  struct Course {
    std::size_t face = 0;
    Vec3 from = Vec3::Zero(), to = Vec3::Zero();
    Vec3 middle = Vec3::Zero();  ///< centre of mass
    double length = 0.0;

    [[nodiscard]] bool is(const Course& other, double tolerance) const;
  };

  /// By edge: those along one course have the same number.
  [[nodiscard]] std::vector<std::size_t> numbered(double tolerance) const;

  std::vector<TopoDS_Shape> faces_;
  std::vector<Course> courses_;
};

}  // namespace octet
