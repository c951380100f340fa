// SPDX-License-Identifier: BSD-3-Clause
// Curves in (u,v) that are put together from pieces.
#pragma once

#include <Geom2d_BSplineCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <cstddef>
#include <gp_Pnt2d.hxx>
#include <vector>

namespace octet {

/// Splines of one degree, each from where the last ends: the whole bends there as its pieces do.
class CurvePieces {
 public:
  void add(const Geom2d_BSplineCurve& piece) {
    const bool first = poles_.empty();
    for (int i = first ? 1 : 2; i <= piece.NbPoles(); ++i) poles_.push_back(piece.Pole(i));
    if (!first) multiplicities_.back() = piece.Degree();
    for (int i = first ? 1 : 2; i <= piece.NbKnots(); ++i) {
      knots_.push_back(piece.Knot(i));
      multiplicities_.push_back(piece.Multiplicity(i));
    }
    degree_ = piece.Degree();
  }

  [[nodiscard]] Handle(Geom2d_BSplineCurve) curve() const {
    TColgp_Array1OfPnt2d poles(1, static_cast<int>(poles_.size()));
    TColStd_Array1OfReal knots(1, static_cast<int>(knots_.size()));
    TColStd_Array1OfInteger multiplicities(1, static_cast<int>(knots_.size()));
    for (int i = 1; i <= poles.Length(); ++i) poles(i) = poles_[static_cast<std::size_t>(i) - 1];
    for (int i = 1; i <= knots.Length(); ++i) {
      knots(i) = knots_[static_cast<std::size_t>(i) - 1];
      multiplicities(i) = multiplicities_[static_cast<std::size_t>(i) - 1];
    }
    return new Geom2d_BSplineCurve(poles, knots, multiplicities, degree_);
  }

 private:
  std::vector<gp_Pnt2d> poles_;
  std::vector<double> knots_;
  std::vector<int> multiplicities_;
  int degree_ = 0;
};

}  // namespace octet
