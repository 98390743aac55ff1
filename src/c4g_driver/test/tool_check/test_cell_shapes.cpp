// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "c4g_driver/cell_shapes.h"
#include "scan_cell_common/errors/errors.h"

namespace c4g_driver {
namespace {

using Eigen::Vector3d;

std::string complaint(const std::string& text) {
  try {
    parse_cell_shapes(text, "shapes.yaml");
  } catch (const scan_cell_common::UnusableInput& unusable) {
    return unusable.what();
  }
  return "";
}

void expect_complaint(const std::string& text, const std::string& wanted) {
  const std::string said = complaint(text);
  EXPECT_NE(said.find(wanted), std::string::npos) << "'" << said << "', not '" << wanted << "'";
}

TEST(CellShapes, AreReadFromYaml) {
  const CellShapes shapes = parse_cell_shapes(R"(
clearance: 0.01
shapes:
  - {name: bracket, frame: flange, box: [0.6, 0.04, 0.05],
     pose: {translation: [0, 0, 0.03], rotation: [0, 0, 1, 0]}}
  - {name: camera, frame: flange, sphere: 0.06}
  - {name: spindle, frame: tool_tip, capsule: [0.02, 0.1]}
  - {name: floor, frame: base_link, half_space: [0, 0, 2]}
links:
  - {link: link_3, radius: 0.1}
may_touch:
  - [spindle, floor]
)",
                                              "shapes.yaml");
  EXPECT_EQ(shapes.clearance, 0.01);
  ASSERT_EQ(shapes.shapes.size(), 4u);
  EXPECT_EQ(shapes.shapes[0].name, "bracket");
  EXPECT_EQ(shapes.shapes[0].kind, CellShape::Kind::kBox);
  EXPECT_EQ(shapes.shapes[0].size, Vector3d(0.6, 0.04, 0.05));
  EXPECT_EQ(shapes.shapes[0].pose.translation(), Vector3d(0, 0, 0.03));
  EXPECT_TRUE(shapes.shapes[0].pose.linear().isApprox(
      Eigen::Matrix3d(Vector3d(-1, -1, 1).asDiagonal()), 1e-12));
  EXPECT_EQ(shapes.shapes[1].size.x(), 0.06);
  EXPECT_EQ(shapes.shapes[2].size, Vector3d(0.02, 0.1, 0));
  EXPECT_EQ(shapes.shapes[3].kind, CellShape::Kind::kHalfSpace);
  EXPECT_EQ(shapes.shapes[3].size, Vector3d(0, 0, 1));
  ASSERT_EQ(shapes.links.size(), 1u);
  EXPECT_EQ(shapes.links[0].link, "link_3");
  EXPECT_EQ(shapes.may_touch.count({"floor", "spindle"}), 1u);
}

TEST(CellShapes, NameTheEntryThatMakesNoSense) {
  expect_complaint("shapes: [{name: a, frame: flange}]", "0 of sphere, box");
  expect_complaint("shapes: [{name: a, frame: flange, sphere: 1, box: [1, 1, 1]}]", "2 of sphere");
  expect_complaint("shapes: [{name: a, frame: flange, sphere: 0}]",
                   "sphere: 0 m (line 1); give metres");
  expect_complaint("shapes: [{name: a, frame: flange, sphere: .nan}]", "sphere");
  expect_complaint("shapes: [{name: a, frame: flange, box: [1, 1]}]", "box");
  expect_complaint("shapes: [{name: a, frame: flange, box: [1, -1, 1]}]", "box: -1 m");
  expect_complaint("shapes: [{name: a, frame: flange, radius: 1}]", "radius");
  expect_complaint("shapes: [{name: '', frame: flange, sphere: 1}]", "name: empty");
  expect_complaint("shapes: [{name: part, frame: flange, sphere: 1}]", "'part' is already used");
  expect_complaint("shapes: [{name: a, frame: base_link, half_space: [0, 0, 0]}]", "no direction");
  expect_complaint("shapes: [{name: a, frame: base_link, half_space: [0, 0, 1e308]}]",
                   "no direction");
  expect_complaint("shapes: [{name: a, frame: base_link, half_space: [0, 0, 1e-320]}]",
                   "no direction");
  expect_complaint("shapes: [{name: a, frame: flange, half_space: [0, 0, 1]}]",
                   "give base_link: a half-space cannot move");
  expect_complaint("links: [{link: link_1, radius: -1}]", "radius: -1 m");
  expect_complaint("may_touch: [[a, part]]", "'a'");
  expect_complaint("may_touch: [[part]]", "1 names");
  expect_complaint("clearance: -0.1", "clearance: -0.1 m");
  expect_complaint("shape: []", "shape");
}

}  // namespace
}  // namespace c4g_driver
