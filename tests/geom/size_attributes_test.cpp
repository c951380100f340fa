// SPDX-License-Identifier: BSD-3-Clause
// The words of --size-at and what they select.
#include "geom/size_attributes.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "geom/analytic.h"
#include "geom/text_pattern.h"

namespace octet {
namespace {

using Where = SizeAttribute::Where;

std::vector<int> tags(const Model& model, const std::string& text) {
  std::vector<int> result;
  for (const ModelRef entity : selected_entities(model, parse_size_attribute(text)))
    result.push_back(entity.tag);
  return result;
}

TEST(SizeAttributes, NumbersAndRangesInAnyCase) {
  const SizeAttribute one = parse_size_attribute("Face12=0.5");
  EXPECT_EQ(one.where, Where::kNumbers);
  EXPECT_EQ(one.dim, 2);
  EXPECT_EQ(one.first, 12);
  EXPECT_EQ(one.last, 12);
  EXPECT_EQ(one.size, 0.5);
  const SizeAttribute range = parse_size_attribute("edge3-7=2", 25.4);
  EXPECT_EQ(range.dim, 1);
  EXPECT_EQ(range.first, 3);
  EXPECT_EQ(range.last, 7);
  EXPECT_DOUBLE_EQ(range.size, 50.8);
  EXPECT_EQ(parse_size_attribute("Face%12=0.5").where, Where::kAsRead);
  EXPECT_EQ(parse_size_attribute("edge%3-7=2").last, 7);
}

TEST(SizeAttributes, NamesAndColoursAreThoseOfTheEntity) {
  const SizeAttribute face = parse_size_attribute("Face:bore=*=1");  // names may hold an equals sign
  EXPECT_EQ(face.where, Where::kName);
  EXPECT_EQ(face.pattern, "bore=*");
  const SizeAttribute any = parse_size_attribute("faceplate*=1");
  EXPECT_EQ(any.where, Where::kName);
  EXPECT_EQ(any.dim, -1);
  EXPECT_EQ(any.pattern, "faceplate*");
  const SizeAttribute colour = parse_size_attribute("Face#FF0*=1");
  EXPECT_EQ(colour.where, Where::kColour);
  EXPECT_EQ(colour.pattern, "#ff0*");
}

TEST(SizeAttributes, ShapesMeetTheBoxesTheyShould) {
  const auto meets = [](const std::string& text, const Vec3& p) {
    return shape_meets(parse_size_attribute(text), Box3{p, p + Vec3::Constant(0.01)});
  };
  EXPECT_TRUE(meets("box:1,1,1,0,0,0=0.1", Vec3(0.5, 0.5, 0.5)));
  EXPECT_FALSE(meets("box:1,1,1,0,0,0=0.1", Vec3(1.5, 0.5, 0.5)));
  EXPECT_TRUE(meets("ball:0,0,0,1=0.1", Vec3(0.5, 0.5, 0.5)));
  EXPECT_FALSE(meets("ball:0,0,0,1=0.1", Vec3(0.9, 0.9, 0.0)));
  EXPECT_TRUE(meets("cylinder:0,0,0,0,0,2,1=0.1", Vec3(0.9, 0.0, 1.9)));
  EXPECT_FALSE(meets("cylinder:0,0,0,0,0,2,1=0.1", Vec3(0.9, 0.9, 1.0)));
  EXPECT_FALSE(meets("cylinder:0,0,0,0,0,2,1=0.1", Vec3(0.0, 0.0, 2.1)));
}

TEST(SizeAttributes, WhatMeansNothingIsRefused) {
  for (const char* text : {"",
                           "Face12",
                           "=1",
                           "Face12=",
                           "Face12=0",
                           "Face12=-1",
                           "Face12=x",
                           "Face12=nan",
                           "Face12=inf",
                           "Face0=1",
                           "Face7-3=1",
                           "box:1,2,3=1",
                           "ball:0,0,0,0=1",
                           "ball:0,0,x,1=1",
                           "Face@1,2=1",
                           "Face3=/4",
                           "Edge3=/0",
                           "Edge3=/1.5",
                           "Edge#ff0000=1",
                           "Face%0=1"})
    EXPECT_THROW((void)parse_size_attribute(text), InputError) << text;
}

TEST(SizeAttributes, SelectWhatThePartHas) {
  const Model box = analytic_box(Vec3(1, 2, 3));
  EXPECT_EQ(tags(box, "Face2-4=1"), (std::vector<int>{2, 3, 4}));
  EXPECT_EQ(tags(box, "Edge:*=1").size(), 12u);
  EXPECT_EQ(tags(box, "Face%2-4=1"), (std::vector<int>{2, 3, 4}));
  EXPECT_EQ(tags(box, "Region1=1"), std::vector<int>{1});
  const auto near = tags(box, "Face@0.5,1,-5=1");
  ASSERT_EQ(near.size(), 1u);
  EXPECT_LT(box.face_closest(near[0], Vec3(0.5, 1.0, 0.0)).distance, 1e-12);
  for (const char* text :
       {"Face7=1", "Face5-7=1", "Face:bore*=1", "bore*=1", "Face#ff0000=1", "Face%7=1", "Face%5-7=1"})
    EXPECT_THROW((void)tags(box, text), InputError) << text;
}

TEST(SizeAttributes, SolidsAreRegions) {
  const Model boxes = analytic_two_boxes(Vec3(1, 2, 3));
  EXPECT_EQ(tags(boxes, "Solid2=1"), std::vector<int>{2});
  EXPECT_EQ(tags(boxes, "solid:*=1"), (std::vector<int>{1, 2}));
  EXPECT_EQ(parse_size_attribute("Solid%1=1").dim, 3);
}

TEST(SizeAttributes, SuggestionsAreCloseAndMeanSomething) {
  const Model box = analytic_box(Vec3(1, 2, 3));
  const auto refusal = [&](const std::string& text) -> std::string {
    try {
      (void)tags(box, text);
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  };
  const auto says = [&](const std::string& text, const std::string& what) {
    EXPECT_NE(refusal(text).find(what), std::string::npos) << refusal(text);
  };
  says("Fase3=1", "did you mean \"Face3\"?");
  says("bal:0,0,0,3=1", "did you mean \"ball:0,0,0,3\"?");
  says("Face*=1", "did you mean \"Face:*\"?");
  says("Face1,2,3=2", "one number or a range");
  says("sphere:0,0,0,5=1", "shapes are box:");
  says("0,0,0,5=1", "shapes are box:");
  for (const char* text : {"Face1,2,3=2", "sphere:0,0,0,5=1", "0,0,0,5=1", "Fase900=1"})
    EXPECT_EQ(refusal(text).find("did you mean"), std::string::npos) << refusal(text);
}

TEST(TextPattern, StarsAndQuestionMarks) {
  EXPECT_TRUE(matches_pattern("bore 12", "bore*"));
  EXPECT_TRUE(matches_pattern("bore 12", "*1?"));
  EXPECT_TRUE(matches_pattern("abcabd", "*ab?"));
  EXPECT_TRUE(matches_pattern("", "*"));
  EXPECT_FALSE(matches_pattern("", "?"));
  EXPECT_FALSE(matches_pattern("bore", "bor"));
  EXPECT_FALSE(matches_pattern("bore", "Bore"));
}

}  // namespace
}  // namespace octet
