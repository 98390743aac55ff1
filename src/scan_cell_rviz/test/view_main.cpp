// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// Of tests in a view of rviz.
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <QApplication>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_view");
  const ros::NodeHandle node;
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
