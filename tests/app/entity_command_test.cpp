// SPDX-License-Identifier: BSD-3-Clause
// Where entities are and what is at a place, as `octet info` tells it.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "app/exit_code.h"
#include "base/vec.h"
#include "program.h"

namespace octet {
namespace {

using Json = nlohmann::json;

Json info_of(const std::string& part, std::vector<std::string> options = {}) {
  options.insert(options.begin(), {"info", model_file(part), "--json"});
  const ProgramRun run = run_octet(options);
  EXPECT_EQ(run.exit_code, kExitComplete) << run.err;
  return Json::parse(run.out);
}

Vec3 vec(const Json& json) { return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()}; }

Json face(const Json& info, int tag) { return info["faces"][static_cast<std::size_t>(tag) - 1]; }

/// Tags of the nearest entities of a dimension at the first place.
std::vector<int> nearest(const Json& info, int dim) {
  std::vector<int> tags;
  for (const Json& item : info["at"][0]["nearest"])
    if (item["dim"] == dim) tags.push_back(item["tag"]);
  return tags;
}

void expect_near(const Json& found, const Vec3& expected, double within = 1e-9) {
  EXPECT_LT((vec(found) - expected).norm(), within) << found << " for " << expected.transpose();
}

std::string text_of(const std::vector<std::string>& arguments) {
  const ProgramRun run = run_octet(arguments);
  EXPECT_EQ(run.exit_code, kExitComplete) << run.err;
  return run.out;
}

TEST(EntityCommand, ABoxHasCentresNormalsAndBoxes) {
  const Json info = info_of("box.step");
  const Vec3 size(10, 20, 30);
  for (const Json& item : info["faces"]) {
    const Vec3 normal = vec(item["normal"]);
    EXPECT_NEAR(normal.cwiseAbs().sum(), 1.0, 1e-12);
    const Vec3 centre = 0.5 * size + 0.5 * normal.cwiseProduct(size);
    expect_near(item["centre"], centre);
    expect_near(item["point"], centre);
    const Vec3 half = 0.5 * (Vec3::Ones() - normal.cwiseAbs()).cwiseProduct(size);
    expect_near(item["box"][0], centre - half);
    expect_near(item["box"][1], centre + half);
    EXPECT_FALSE(item.contains("radius"));
  }
  expect_near(info["regions"][0]["centre"], 0.5 * size);
  expect_near(info["regions"][0]["box"][1], size);
  for (const Json& edge : info["edges"]) {
    expect_near(edge["middle"], 0.5 * (vec(edge["ends"][0]) + vec(edge["ends"][1])));
    for (std::size_t i = 0; i < 2; ++i)
      expect_near(edge["ends"][i],
                  vec(info["vertices"][edge["vertices"][i].get<std::size_t>() - 1]["point"]));
  }
}

TEST(EntityCommand, AHoleHasRadiusAxisAndIsConcave) {
  const Json info = info_of("plate_with_hole.step");
  const Json hole = face(info, 7);
  EXPECT_EQ(hole["surface"], "cylinder");
  EXPECT_NEAR(hole["radius"].get<double>(), 6.0, 1e-12);
  expect_near(hole["axis"], Vec3::UnitZ());
  expect_near(hole["origin"], Vec3(20, 15, 0.5));
  EXPECT_TRUE(hole["concave"].get<bool>());
  expect_near(hole["box"][0], Vec3(14, 9, 0));
  expect_near(hole["box"][1], Vec3(26, 21, 1));
  EXPECT_NEAR((vec(hole["point"]) - Vec3(20, 15, vec(hole["point"]).z())).norm(), 6.0, 1e-9);
  // The plate's own centre is in the hole: its point is not.
  expect_near(face(info, 3)["centre"], Vec3(20, 15, 1));
  EXPECT_GT((vec(face(info, 3)["point"]) - Vec3(20, 15, 1)).norm(), 6.0);
  EXPECT_NEAR(vec(face(info, 3)["point"]).z(), 1.0, 1e-12);
  int circles = 0;
  for (const Json& edge : info["edges"]) {
    if (edge["curve"] != "circle") continue;
    ++circles;
    EXPECT_NEAR(edge["radius"].get<double>(), 6.0, 1e-12);
    expect_near(edge["centre"], Vec3(20, 15, vec(edge["centre"]).z()));
    expect_near(edge["axis"], Vec3::UnitZ());
  }
  EXPECT_EQ(circles, 2);
}

TEST(EntityCommand, RoundFacesHaveTheShapeTheyAreMadeWith) {
  const Json cylinder = face(info_of("cylinder.step"), 1);
  EXPECT_NEAR(cylinder["radius"].get<double>(), 5.0, 1e-12);
  EXPECT_FALSE(cylinder["concave"].get<bool>());
  const Json cone = face(info_of("cone.step"), 1);
  expect_near(cone["origin"], Vec3(0, 0, 20), 1e-9);
  EXPECT_NEAR(cone["half_angle"].get<double>(), std::atan2(10.0, 20.0) * 180.0 / std::numbers::pi, 1e-9);
  EXPECT_NEAR(cone["radii"][0].get<double>(), 0.0, 1e-9);
  EXPECT_NEAR(cone["radii"][1].get<double>(), 10.0, 1e-9);
  expect_near(cone["centre"], Vec3(0, 0, 20.0 / 3.0), 1e-5);
  const Json torus = face(info_of("torus.step"), 1);
  EXPECT_NEAR(torus["radius"].get<double>(), 20.0, 1e-12);
  EXPECT_NEAR(torus["minor_radius"].get<double>(), 5.0, 1e-12);
  expect_near(torus["box"][0], Vec3(-25, -25, -5));
  const Json ball = face(info_of("ball.step"), 1);
  EXPECT_NEAR(ball["radius"].get<double>(), 10.0, 1e-12);
  expect_near(ball["origin"], Vec3::Zero());
  expect_near(ball["box"][1], Vec3::Constant(10));
  EXPECT_FALSE(ball.contains("axis"));
  EXPECT_TRUE(face(info_of("box_minus_ball.step"), 7)["concave"].get<bool>());
}

TEST(EntityCommand, TheTableHasThemToo) {
  const std::string box = text_of({"info", model_file("box.step"), "--entities"});
  for (const std::string words : {"(0, 10, 15)   normal (-1, 0, 0)", "(5, 10, 15)  (0, 0, 0) to (10, 20, 30)",
                                  "(10, 20, 0) to (10, 20, 30)"})
    EXPECT_NE(box.find(words), std::string::npos) << words << " in " << box;
  const std::string plate = text_of({"info", model_file("plate_with_hole.step"), "--entities"});
  for (const std::string words : {"radius 6, axis (0, 0, 1), concave", "radius 6 about (20, 15, 1)"})
    EXPECT_NE(plate.find(words), std::string::npos) << words << " in " << plate;
}

TEST(EntityCommand, FindsTheFaceAtAPlace) {
  const Json info = info_of("box.step", {"--at", "0,9,14"});
  EXPECT_EQ(info["at"][0]["on"], (Json{{"dim", 2}, {"tag", 1}}));
  EXPECT_EQ(nearest(info, 2), std::vector<int>{1});
  EXPECT_EQ(info["at"][0]["regions"], Json::array({1}));
  const Json corner = info_of("box.step", {"--at", "10,20,30"});
  EXPECT_EQ(corner["at"][0]["on"], (Json{{"dim", 0}, {"tag", 8}}));
  EXPECT_EQ(nearest(corner, 2), (std::vector<int>{2, 4, 6}));
}

TEST(EntityCommand, FindsTheHoleAtAPlaceOnItOrOnItsAxis) {
  const std::string on =
      std::to_string(20.0 + 6.0 * std::cos(2.0)) + "," + std::to_string(15.0 + 6.0 * std::sin(2.0)) + ",0.5";
  const Json info = info_of("plate_with_hole.step", {"--at", on});
  EXPECT_EQ(info["at"][0]["on"], (Json{{"dim", 2}, {"tag", 7}}));
  const Json seam = info_of("plate_with_hole.step", {"--at", "26,15,0.5"});
  EXPECT_EQ(seam["at"][0]["on"], (Json{{"dim", 2}, {"tag", 7}}));
  EXPECT_EQ(seam["at"][0]["nearest"][0]["distance"], 0.0);
  const Json axis = info_of("plate_with_hole.step", {"--at", "20,15,0.5"});
  EXPECT_TRUE(axis["at"][0]["on"].is_null());
  EXPECT_TRUE(axis["at"][0]["regions"].empty());
  EXPECT_EQ(nearest(axis, 2), std::vector<int>{7});
  EXPECT_NEAR(axis["at"][0]["nearest"][0]["distance"].get<double>(), 6.0, 1e-9);
}

TEST(EntityCommand, TellsTheRegionAroundAPlace) {
  const Json inside = info_of("two_boxes.step", {"--at", "5,5,5", "--at", "-1,0,0"});
  ASSERT_EQ(inside["at"].size(), 2u);
  EXPECT_EQ(inside["at"][0]["regions"].size(), 1u);
  EXPECT_TRUE(inside["at"][1]["regions"].empty());
  int shared = 0;
  for (const Json& item : inside["faces"]) {
    if (item["regions"][0] == 0 || item["regions"][1] == 0) continue;
    ++shared;
    const Vec3 p = vec(item["point"]);
    const std::string place =
        std::to_string(p.x()) + "," + std::to_string(p.y()) + "," + std::to_string(p.z());
    const Json on = info_of("two_boxes.step", {"--at", place});
    EXPECT_EQ(on["at"][0]["on"]["tag"], item["tag"]);
    EXPECT_EQ(on["at"][0]["regions"], Json::array({1, 2}));
  }
  EXPECT_EQ(shared, 1);
}

TEST(EntityCommand, SaysInWordsWhatIsAtAPlace) {
  const std::string text = text_of({"info", model_file("box.step"), "--at", "0,1,1.5", "--at", "0.1,0.1,0.1",
                                    "--at=-1,0,0", "--unit", "cm"});
  for (const std::string words :
       {"at (0, 10, 15): on Face 1, of Region 1 \"box 2\"", "at (1, 1, 1): in Region 1 \"box 2\"",
        "at (-10, 0, 0): outside", "plane, normal (-1, 0, 0)"})
    EXPECT_NE(text.find(words), std::string::npos) << words << " in " << text;
  EXPECT_EQ(text.find("thinnest wall"), std::string::npos);
}

TEST(EntityCommand, RefusesWhatIsNoPlace) {
  for (const std::string place : {"1,2", "1,2,3,4", "1,2,x", "1,,2", "1,2,nan", ""})
    EXPECT_EQ(run_octet({"info", model_file("box.step"), "--at=" + place}).exit_code, kExitBadInput) << place;
  EXPECT_NE(run_octet({"info", model_file("box.step"), "--at", "1,2"}).err.find("like 10,0,5"),
            std::string::npos);
  EXPECT_EQ(run_octet({"info", model_file("box.step"), "--sizes", "--at", "1,2,3"}).exit_code, kExitBadInput);
}

}  // namespace
}  // namespace octet
