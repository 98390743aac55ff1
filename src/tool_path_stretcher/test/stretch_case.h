// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "synthetic_parts.h"
#include "tool_path_stretcher/stretcher.h"

/// A part, a moved and bent scan of it, and the true path on it.
namespace tool_path_stretcher {

using synthetic::Part;

constexpr double kDegree = M_PI / 180;
constexpr std::size_t kWaypoints = 200;

inline Eigen::Matrix3d about_vertical(double degrees) {
  return Eigen::AngleAxisd(degrees * kDegree, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

inline ToolPath without_orientation(ToolPath path) {
  path.has_orientation = false;
  for (Segment& segment : path.segments) {
    for (Waypoint& waypoint : segment.waypoints)
      waypoint.pose.linear().setIdentity();
  }
  return path;
}

/// One case with its truth. Each test changes what it is about.
struct Case {
  Part part = synthetic::photo_frame();
  Part scanned_part = part;
  Similarity moved = synthetic::similarity(1.08, about_vertical(30), {0.4, -0.2, 0.1});
  synthetic::Deformation deformation = synthetic::no_deformation();
  synthetic::Scan scan;
  std::function<bool(const Eigen::Vector3d&)> reference_hole = {};  //!< not scanned of it
  StretchParameters parameters;
  ToolPath path = synthetic::path_on(part, kWaypoints);

  Surface reference() const {
    synthetic::Scan whole;
    whole.seed = 11;
    whole.is_hole = reference_hole;
    return surface_from_cloud(synthetic::scan(part, {}, synthetic::no_deformation(), whole),
                              parameters.leaf, "reference");
  }

  Surface object() const {
    return surface_from_cloud(synthetic::scan(scanned_part, moved, deformation, scan),
                              parameters.leaf, "object");
  }

  StretchResult run(const Progress& progress = {}) const {
    return stretch(reference(), object(), path, parameters, progress);
  }

  synthetic::PathError error(const StretchResult& result) const {
    return synthetic::error_of(result.path, synthetic::truth(path, moved, deformation));
  }
};

inline void expect_refused(const StretchResult& result, Reason reason) {
  EXPECT_EQ(to_string(result.verdict.reason), to_string(reason)) << result.verdict.message;
  EXPECT_TRUE(result.path.segments.empty());
  EXPECT_FALSE(result.verdict.message.empty());
}

inline void expect_adapted(const Case& each, double position_rms, double orientation_rms) {
  const StretchResult result = each.run();
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  const synthetic::PathError error = each.error(result);
  EXPECT_LE(error.rms, position_rms);
  EXPECT_LE(error.orientation, orientation_rms);
}

}  // namespace tool_path_stretcher
