// SPDX-License-Identifier: BSD-3-Clause
// A face whose loops touch where the CAD does not tell them apart is meshed at any size.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Ax2.hxx>

#include "geom/occt/from_shape.h"
#include "tests/support/expect_complete.h"

namespace octet {
namespace {

/// A box 20 x 10 x 6 with a conical pocket in its top, whose rim ends 0.0002 off the edge y = 0, at a vertex
/// that the file knows to 0.001.
Model pocket_at_an_edge() {
  constexpr double kGap = 2e-4, kRadius = 2.0, kDepth = 3.0;
  const gp_Ax2 axes(gp_Pnt(10.0, kGap + kRadius, 6.0 - kDepth), gp::DZ(), gp_Dir(0.0, -1.0, 0.0));
  const TopoDS_Shape shape = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(20.0, 10.0, 6.0).Shape(),
                                             BRepPrimAPI_MakeCone(axes, 0.0, kRadius, kDepth).Shape());
  for (TopExp_Explorer it(shape, TopAbs_VERTEX); it.More(); it.Next())
    if (BRep_Tool::Pnt(TopoDS::Vertex(it.Current())).Distance(gp_Pnt(10.0, kGap, 6.0)) < 1e-6)
      BRep_Builder().UpdateVertex(TopoDS::Vertex(it.Current()), 1e-3);
  return model_from_shape(shape);
}

TEST(PinchedFace, IsMeshedAtAnySize) {
  const Model model = pocket_at_an_edge();
  test::expect_complete(model, {3.0, 1.0, 0.4});
}

}  // namespace
}  // namespace octet
