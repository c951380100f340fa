// SPDX-License-Identifier: BSD-3-Clause
// A STEP file that states how accurate it is.
#pragma once

#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace octet::test {

/// A block of 100 mm with a chamfer 0.0007 mm wide, which is four times what rounding leaves: 7 faces.
/// `accuracy`: as STEP writes numbers, in `unit`.
inline void write_chamfered_block(const std::string& path, const std::string& accuracy,
                                  const char* unit = "MM") {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(100.0, 100.0, 100.0).Shape();
  BRepFilletAPI_MakeChamfer chamfer(box);
  chamfer.Add(5e-4, TopoDS::Edge(TopExp_Explorer(box, TopAbs_EDGE).Current()));
  STEPControl_Writer writer;
  Interface_Static::SetCVal("write.step.unit", unit);
  writer.Transfer(chamfer.Shape(), STEPControl_AsIs);
  writer.Write(path.c_str());
  Interface_Static::SetCVal("write.step.unit", "MM");
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  std::string step = text.str();
  const std::string key = "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(";
  const std::size_t found = step.find(key);
  if (found == std::string::npos) throw std::runtime_error("the STEP file states no accuracy");
  const std::size_t from = found + key.size();
  step.replace(from, step.find(')', from) - from, accuracy);
  std::ofstream(path) << step;
}

}  // namespace octet::test
