// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "stretch_case.h"
#include "verdict/checks.h"

using namespace tool_path_stretcher;

namespace {

/// A part of another size with its object bent in proportion. A larger one is scanned equally
/// densely.
Case bent_frame(double size) {
  Case each;
  const Part frame = synthetic::photo_frame();
  each.part.width *= size;
  each.part.depth *= size;
  each.part.inside = [=](double x, double y) { return frame.inside(x / size, y / size); };
  each.part.height = [=](double x, double y) { return size * frame.height(x / size, y / size); };
  // explicit type: an unevaluated Eigen product would outlive its operands
  each.part.path_position = [=](double a) -> Eigen::Vector3d {
    return size * frame.path_position(a);
  };
  each.scanned_part = each.part;
  each.path = synthetic::path_on(each.part, kWaypoints);
  each.deformation = synthetic::bend(0.006 * size, each.part.width);
  each.parameters.leaf *= size;
  return each;
}

TEST(RelativeLimits, AllowAPartOfAnySizeAsMuch) {
  for (const double size : {0.5, 5.0}) {  // 0.1 and 1 m
    SCOPED_TRACE(size);
    const StretchResult result = bent_frame(size).run();
    EXPECT_TRUE(result.verdict.accepted()) << result.verdict.message;
    EXPECT_GT(result.deformation_nodes, 0U);
  }
}

TEST(RelativeLimits, SayWhatTheyAreInMillimetres) {
  // Variances [mm^2] of the frame between its outline and its opening, which have twice and once
  // the frame's area
  const double x = (2 * 200 * 200 - 150 * 150) / 12.0, y = (2 * 150 * 150 - 100 * 100) / 12.0;
  const double limit = 0.005 * 1.08 * std::sqrt(12 * (x + y));
  const auto said_after = [](const StretchResult& result, const std::string& before) {
    const std::size_t at = result.verdict.message.find(before);
    return at == std::string::npos ? 0
                                   : std::stod(result.verdict.message.substr(at + before.size()));
  };
  Case each = bent_frame(1);
  each.parameters.max_deformation_ratio = 0.005;
  const StretchResult deformed = each.run();
  expect_refused(deformed, Reason::kWrongPart);
  EXPECT_NEAR(said_after(deformed, "to fit it ("), limit, 0.02 * limit);
  EXPECT_EQ(said_after(deformed, "max_deformation_ratio, "), 0.5) << "%";

  each = bent_frame(1);
  each.parameters.max_displacement_ratio = 0.005;
  const StretchResult displaced = each.run();
  expect_refused(displaced, Reason::kToleranceExceeded);
  EXPECT_NEAR(said_after(displaced, "raise max_displacement_ratio (0.5 % of the part's length, "),
              limit, 0.02 * limit);
}

TEST(RelativeLimits, AreOfTheDiagonalOfABoxThatIsFilledEvenly) {
  Points points;
  for (int x = 0; x < 150; ++x) {
    for (int y = 0; y < 100; ++y)
      points.emplace_back(0.002 * x, 0.002 * y, 0);
  }
  const Surface plate = surface_from_cloud(points, {0.002, 0.002, 0.002}, "plate");
  EXPECT_NEAR(length_of(plate), std::hypot(0.3, 0.2), 0.002);
}

}  // namespace
