// SPDX-License-Identifier: BSD-3-Clause
// A STEP file of a block with a tiny chamfer, which states how accurate it is.
#pragma once

#include <gtest/gtest.h>

#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shape.hxx>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "geom/occt/silence.h"

namespace octet::test {

/// A block of 100 mm with a chamfer 0.0007 mm wide, which is four times what rounding leaves: 7 faces. The
/// file goes when the object does.
class ChamferedBlock {
 public:
  /// `accuracy`: as STEP writes numbers, in `unit`; `beside`: another part of the file.
  explicit ChamferedBlock(const std::string& accuracy, const char* unit = "MM",
                          const TopoDS_Shape& beside = {})
      : path_(std::filesystem::path(testing::TempDir()) /
              ("octet_chamfered_block_" +
               std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".step")) {
    const Silence silence;
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(100.0, 100.0, 100.0).Shape();
    BRepFilletAPI_MakeChamfer chamfer(box);
    chamfer.Add(5e-4, TopoDS::Edge(TopExp_Explorer(box, TopAbs_EDGE).Current()));
    STEPControl_Writer writer;
    Interface_Static::SetCVal("write.step.unit", unit);
    writer.Transfer(chamfer.Shape(), STEPControl_AsIs);
    if (!beside.IsNull()) writer.Transfer(beside, STEPControl_AsIs);
    writer.Write(path_.c_str());
    Interface_Static::SetCVal("write.step.unit", "MM");
    state(accuracy);
  }
  ~ChamferedBlock() { std::filesystem::remove(path_); }
  ChamferedBlock(const ChamferedBlock&) = delete;
  ChamferedBlock& operator=(const ChamferedBlock&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  void state(const std::string& accuracy) const {
    std::stringstream text;
    text << std::ifstream(path_).rdbuf();
    std::string step = text.str();
    const std::string key = "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(";
    const std::size_t found = step.find(key);
    if (found == std::string::npos) throw std::runtime_error("the STEP file states no accuracy");
    const std::size_t from = found + key.size();
    step.replace(from, step.find(')', from) - from, accuracy);
    std::ofstream(path_) << step;
  }

  std::filesystem::path path_;
};

}  // namespace octet::test
