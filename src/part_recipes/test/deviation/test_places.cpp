// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "deviation/places.h"
#include "drawn_surfaces.h"
#include "recipe/recipe.h"
#include "scan_cell_common/errors/errors.h"

using drawn::Points;
using Eigen::Vector3d;
using scan_cell_common::UnusableInput;

namespace {

/// The error about a wrong list of places.
std::string refusal_of(const std::string& yaml) {
  const drawn::Folder folder;
  try {
    part_recipes::load_places(folder.save("places.yaml", yaml));
  } catch (const UnusableInput& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST(Places, TakeTheMedianOfThePointsWithinTheirRadius) {
  const part_recipes::Place left{"left", {-0.03, 0, 0}, 0.004};
  Points object;
  std::vector<double> deviations;
  for (const double value : {0.0001, 0.0009, 0.0002, 0.0003, 0.0004, double(NAN)}) {
    object.push_back(drawn::moved() *
                     (left.position + Vector3d(0, 0.0006 * static_cast<double>(object.size()), 0)));
    deviations.push_back(value);
  }
  object.push_back(drawn::moved() * (left.position + Vector3d(0.0041, 0, 0)));  // 4.4 mm on it
  deviations.push_back(0.5);
  const auto found = part_recipes::at_places({left}, drawn::moved(), object, deviations);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].points, 5U);
  ASSERT_TRUE(found[0].deviation);
  EXPECT_EQ(*found[0].deviation, 0.0003);
}

TEST(Places, WithFewerThanFivePointsHaveNoDeviation) {
  const Points object(4, Vector3d::Zero());
  const auto found =
      part_recipes::at_places({{"rim", Vector3d::Zero(), 0.005}}, {}, object, {1, 2, 3, 4});
  EXPECT_EQ(found[0].points, 4U);
  EXPECT_FALSE(found[0].deviation);
}

TEST(PlacesFile, KeepsNamesAsTheyAre) {
  const drawn::Folder folder;
  const auto places = part_recipes::load_places(folder.save(
      "places.yaml", std::string("- {name: \"<b>Größe</b>: 1\", position: [0.1, -0.2, 0.3]}\n"
                                 "- {name: rim, position: [0, 0, 1e-3], radius: 0.002}\n")));
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(places[0].name, "<b>Größe</b>: 1");
  EXPECT_EQ(places[0].position, Vector3d(0.1, -0.2, 0.3));
  EXPECT_EQ(places[0].radius, 0.005);
  EXPECT_EQ(places[1].radius, 0.002);
}

TEST(PlacesFile, MayHoldNone) {
  const drawn::Folder folder;
  EXPECT_TRUE(part_recipes::load_places(folder.save("places.yaml", std::string("[]\n"))).empty());
}

TEST(PlacesFile, RefusesWhatMakesNoSense) {
  EXPECT_NE(refusal_of("- {name: a, position: [0, 0]}\n").find("position"), std::string::npos);
  EXPECT_NE(refusal_of("- {name: a, position: [0, 0, .nan]}\n").find("position"),
            std::string::npos);
  EXPECT_NE(refusal_of("- {position: [0, 0, 0]}\n").find("name"), std::string::npos);
  EXPECT_NE(refusal_of("- {name: a, position: [0, 0, 0], radius: 0}\n").find("radius"),
            std::string::npos);
  EXPECT_NE(refusal_of("- {name: a, position: [0, 0, 0], radios: 1}\n").find("radios"),
            std::string::npos);
  EXPECT_NE(refusal_of("- {name: a, position: [0, 0, 0]}\n- {name: a, position: [1, 0, 0]}\n")
                .find("twice"),
            std::string::npos);
}
