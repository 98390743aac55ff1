// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <scan_cell_common/ros/load_parameters.h>
#include <scan_cell_common/ros/nodelet.h>

#include <memory>

#include "cloud_frames.h"
#include "cloud_preprocess/stage.h"
#include "load_finder.h"

namespace cloud_preprocess {

template <class StageParameters>
struct NodeletParameters {
  TargetFrame target;
  StageParameters stage;
};

template <class StageParameters>
void describe(scan_cell_common::ParameterTable& table,
              NodeletParameters<StageParameters>& parameters) {
  describe(table, parameters.target);
  describe(table, parameters.stage);
}

/// One stage as a nodelet. Subscribes `input`; publishes `~output` and `~report`. On a failure it
/// publishes a report with the reason and no cloud. Both topics are latched: there is one cloud per
/// scan, and late subscribers must not miss it. Clouds are transformed into `~target_frame` before
/// the stage.
class StageNodelet : public scan_cell_common::Nodelet {
 protected:
  /// @param[out] target from the parameters
  /// @throw scan_cell_common::InvalidParameter
  virtual std::unique_ptr<const Stage> make_stage(const ros::NodeHandle& node,
                                                  TargetFrame& target) = 0;

 private:
  void start() override;
  void on_cloud(const sensor_msgs::PointCloud2ConstPtr& message);

  CloudFrames frames_;
  std::unique_ptr<const Stage> stage_;
  ros::Publisher output_;
  ros::Publisher report_;
  ros::Subscriber input_;
};

/// Prepares what a stage needs besides its parameters.
template <class StageParameters>
void provide(StageParameters& /*parameters*/) {}

inline void provide(IsolationParameters& parameters) {
  parameters.finder = load_finder(parameters);
}

template <class StageType>
class NodeletOf final : public StageNodelet {
  std::unique_ptr<const Stage> make_stage(const ros::NodeHandle& node,
                                          TargetFrame& target) override {
    using Parameters = NodeletParameters<typename StageType::Parameters>;
    auto parameters = scan_cell_common::load_parameters<Parameters>(node);
    provide(parameters.stage);
    target = parameters.target;
    return std::make_unique<const StageType>(parameters.stage);
  }
};

}  // namespace cloud_preprocess
