// SPDX-License-Identifier: BSD-3-Clause
// The solid that OCCT's builders wrap.
#pragma once

#include <TopExp_Explorer.hxx>
#include <TopoDS_Shape.hxx>

namespace octet::test {

/// The first one.
inline TopoDS_Shape solid_in(const TopoDS_Shape& shape) {
  return TopExp_Explorer(shape, TopAbs_SOLID).Current();
}

}  // namespace octet::test
