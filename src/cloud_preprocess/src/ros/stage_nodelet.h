// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <scan_cell_common/ros/parameter_reader.h>
#include <sensor_msgs/PointCloud2.h>

#include <memory>

#include "cloud_preprocess/stage.h"

namespace cloud_preprocess {

/// One stage as a nodelet: `input` in, `~output` and `~report` out. A failure publishes a report
/// that says why, and no cloud. Both topics are latched: a cloud comes once a scan, and who
/// subscribes after it must not miss it.
class StageNodelet : public nodelet::Nodelet {
 protected:
  /// @throw scan_cell_common::InvalidParameter
  virtual std::unique_ptr<const Stage> make_stage(scan_cell_common::ParameterReader& reader) = 0;

 private:
  void onInit() override;
  void on_cloud(const sensor_msgs::PointCloud2ConstPtr& message);

  std::unique_ptr<const Stage> stage_;
  ros::Publisher output_;
  ros::Publisher report_;
  ros::Subscriber input_;
};

template <class StageType>
class NodeletOf final : public StageNodelet {
  std::unique_ptr<const Stage> make_stage(scan_cell_common::ParameterReader& reader) override {
    typename StageType::Parameters parameters;
    describe(reader, parameters);
    return std::make_unique<const StageType>(parameters);
  }
};

}  // namespace cloud_preprocess
