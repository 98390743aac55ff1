// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <ros/ros.h>

#include "view/handle_server.h"

namespace scan_cell_rviz {
namespace {

/// Ends the node, so this is the only test of its process.
TEST(AServerOfHandles, DoesNotAbortAnRvizThatEndsBeforeTheFirstMarker) {
  HandleServer server("handles");
  ros::shutdown();
  visualization_msgs::InteractiveMarker marker;
  marker.name = "box";
  server.insert(marker, [](const auto&) {});
  server.apply();
  server.clear();
}

}  // namespace
}  // namespace scan_cell_rviz

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_handle_server");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
