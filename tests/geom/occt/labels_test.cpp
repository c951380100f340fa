// SPDX-License-Identifier: BSD-3-Clause
// What the file says of parts, solids and faces comes through reading and fusing.
#include "geom/occt/labels.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <fstream>
#include <gp_Trsf.hxx>
#include <set>
#include <sstream>

#include "base/error.h"
#include "geom/size_attributes.h"
#include "sample_parts.h"

namespace octet::test {
namespace {

/// The one region whose volume is this.
int region_of_volume(const Model& model, double volume, int from = 1) {
  for (int r = from; r <= model.count(3); ++r)
    if (std::abs(model.region(r).volume - volume) < 1e-6 * volume) return r;
  return 0;
}

constexpr double kPlate = 40.0 * 20.0 * 4.0, kBlock = 12.0 * 12.0 * 8.0, kPin = 125.66370614359172;

TEST(Labels, NameColourAndMaterialStayWithTheirSolids) {
  const Model model = sample("fixture");
  ASSERT_EQ(model.count(3), 4);
  const ModelRegion& plate = model.region(region_of_volume(model, kPlate));
  EXPECT_EQ(plate.name, "plate");
  EXPECT_EQ(plate.colour, "#0000ff");
  EXPECT_EQ(plate.material, "steel");
  EXPECT_NEAR(plate.density, 7.85, 1e-9);
  const ModelRegion& block = model.region(region_of_volume(model, kBlock));
  EXPECT_EQ(block.name, "block");
  EXPECT_EQ(block.colour, "#00ff00");
  EXPECT_EQ(block.material, "aluminium");
  EXPECT_NEAR(block.density, 2.7, 1e-9);
}

TEST(Labels, ANameThatFillsLinesOfItsFileIsOneLine) {
  std::string step = (std::ostringstream() << std::ifstream(sample_path("fixture")).rdbuf()).str();
  const std::string name = "'plate','plate'", broken = "'a name of two\r\nlines','a name of two\r\nlines'";
  const std::size_t at = step.find(name);
  ASSERT_NE(at, std::string::npos);
  step.replace(at, name.size(), broken);
  const auto path = std::filesystem::temp_directory_path() / "octet_Labels.step";
  std::ofstream(path, std::ios::binary) << step;
  const Model model = read_part(path);
  std::filesystem::remove(path);
  EXPECT_EQ(model.region(region_of_volume(model, kPlate)).name, "a name of twolines");
}

TEST(Labels, SizesFindRegionsByPartsUsesAndAssemblies) {
  const Model model = sample("fixture");
  const auto count = [&](const char* text) {
    return selected_entities(model, parse_size_attribute(text)).size();
  };
  EXPECT_EQ(count("Region:pin=1"), 2u);
  EXPECT_EQ(count("Region:pin:2=1"), 1u);
  EXPECT_EQ(count("Region:fix*=1"), 4u);
  EXPECT_EQ(count("fix*=1"), 4u) << "of any dimension: still regions only";
  EXPECT_THROW((void)count("Face:fix*=1"), InputError);
}

TEST(Labels, SizesFindWhatNumbersOfTheFileHaveBecome) {
  // The plate's top is split where other solids stand on it.
  const Model model = sample("fixture");
  const auto& faces = model.provenance().as_read[2];
  int split = 0;
  for (int n = 1; n < static_cast<int>(faces.size()); ++n) {
    std::vector<int> found;
    for (const ModelRef entity :
         selected_entities(model, parse_size_attribute("Face%" + std::to_string(n) + "=1")))
      found.push_back(entity.tag);
    EXPECT_EQ(found, faces[static_cast<std::size_t>(n)].tags) << n;
    split += found.size() > 1;
  }
  EXPECT_GT(split, 0);
  EXPECT_THROW((void)selected_entities(model, parse_size_attribute("Face%1000=1")), InputError);
}

TEST(Labels, BothUsesOfAPartHaveItsNameAndLayer) {
  const Model model = sample("fixture");
  const int first = region_of_volume(model, kPin), second = region_of_volume(model, kPin, first + 1);
  ASSERT_GT(second, first);
  for (const int pin : {first, second}) {
    EXPECT_EQ(model.region(pin).name, "pin");
    EXPECT_EQ(model.region(pin).layer, "hardware");
    EXPECT_EQ(model.region(pin).colour, "#ffff00");
    EXPECT_TRUE(model.region(pin).material.empty());
  }
}

TEST(Labels, AFacesOwnColourGoesBeforeThatOfItsSolid) {
  const Model model = sample("fixture");
  int seats = 0;
  const int block = region_of_volume(model, kBlock);
  for (const int f : model.region(block).faces) {
    const ModelFace& face = model.face(f);
    if (face.name == "seat") {
      ++seats;
      EXPECT_EQ(face.colour, "#ff0000");
      EXPECT_NEAR(face.area, 144.0, 1e-9);
    } else if (face.region[0] == 0 || face.region[1] == 0) {
      EXPECT_EQ(face.colour, "#00ff00");
    }
  }
  EXPECT_EQ(seats, 1);
}

TEST(Labels, TheTreeHoldsEveryUseOfAPartOnce) {
  const Model model = sample("fixture");
  const std::vector<PartNode>& tree = model.provenance().tree;
  ASSERT_EQ(tree.size(), 5u);
  EXPECT_EQ(tree[0].name, "fixture");
  EXPECT_EQ(tree[0].parent, -1);
  EXPECT_TRUE(tree[0].solids.empty());
  std::multiset<std::string> names, instances;
  std::set<int> solids;
  for (std::size_t i = 1; i < tree.size(); ++i) {
    EXPECT_EQ(tree[i].parent, 0);
    ASSERT_EQ(tree[i].solids.size(), 1u);
    solids.insert(tree[i].solids.front());
    names.insert(tree[i].name);
    instances.insert(tree[i].instance);
  }
  EXPECT_EQ(solids.size(), 4u);
  EXPECT_EQ(names, (std::multiset<std::string>{"block", "pin", "pin", "plate"}));
  EXPECT_EQ(instances, (std::multiset<std::string>{"block:1", "pin:1", "pin:2", "plate:1"}));
  EXPECT_EQ(std::count_if(tree.begin(), tree.end(),
                          [&](const PartNode& node) { return &node != &tree[node.first_use]; }),
            1);
}

TEST(Labels, WhatTouchesThePlateSharesOneFaceWithIt) {
  const Model model = sample("fixture");
  const int plate = region_of_volume(model, kPlate);
  std::set<int> beside;
  double area = 0.0;
  for (int f = 1; f <= model.count(2); ++f) {
    const auto& region = model.face(f).region;
    if (region[0] == 0 || region[1] == 0) continue;
    EXPECT_TRUE(region[0] == plate || region[1] == plate);
    EXPECT_TRUE(beside.insert(region[0] == plate ? region[1] : region[0]).second);
    area += model.face(f).area;
  }
  EXPECT_EQ(beside.size(), 3u);
  EXPECT_NEAR(area, 144.0 + 2.0 * kPin / 10.0, 1e-6);
}

TEST(Labels, APartThatIsAUseStandsInTheTreeWhereItStandsInThePart) {
  // IGES files of assemblies are read so: what is free is a use with a place of its own.
  const Handle(TDocStd_Document) document = new TDocStd_Document("XmlXCAF");
  const Handle(XCAFDoc_ShapeTool) tool = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  gp_Trsf shift;
  shift.SetTranslation(gp_Vec(10.0, 0.0, 0.0));
  tool->AddShape(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape().Moved(shift), false);
  CadDocument read;
  collect_labels(document, read);
  ASSERT_EQ(read.tree.size(), 1u);
  TopTools_IndexedMapOfShape of_part, of_tree;
  TopExp::MapShapes(read.shape, TopAbs_FACE, of_part);
  TopExp::MapShapes(read.tree[0].shape, TopAbs_FACE, of_tree);
  EXPECT_EQ(of_tree.Extent(), 6);
  for (int i = 1; i <= of_tree.Extent(); ++i) EXPECT_TRUE(of_part.Contains(of_tree(i)));
}

}  // namespace
}  // namespace octet::test
