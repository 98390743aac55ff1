// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "actions/scan_action.h"

#include <fmt/format.h>
#include <sensor_msgs/PointCloud2.h>

#include <cmath>

#include "scan_cell/ros/scan_goal.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/conversions.h"

namespace scan_cell {

using scan_cell_common::Refused;
using scan_cell_msgs::CellState;
using scan_cell_msgs::ScanResult;

ScanAction::ScanAction(ros::NodeHandle node, const Parameters& parameters, CellDevices& devices,
                       CellInUse& cell, const StateTopic& state)
    : parameters_(parameters),
      camera_(devices.camera),
      stages_(parameters.binder, parameters.triangulation, parameters.call_timeout,
              parameters.base_frame),
      asked_{devices.robot, devices.trigger, stages_},
      sequence_(devices.robot, devices.camera, devices.trigger, stages_, *this, parameters.limits,
                parameters.timing),
      state_(state),
      action_(node, "scan", cell, state, *this) {
  const boost::function<void(const sensor_msgs::PointCloud2ConstPtr&)> count =
      [this](const sensor_msgs::PointCloud2ConstPtr& cloud) {
        points_ += static_cast<std::uint64_t>(cloud->width) * cloud->height;
      };
  cloud_subscriber_ =
      node.subscribe<sensor_msgs::PointCloud2>(parameters.triangulation + "/cloud", 100, count);
  publish_state(CellState::IDLE, "");
  check_program_ = node.advertiseService("check_program", &ScanAction::check_program, this);
  action_.start();
}

ScanAction::~ScanAction() {
  action_.end();
}

std::string ScanAction::accept(const scan_cell_msgs::ScanGoal& goal) {
  request_ = request_from(goal.passes, goal.frame);
  request_.scan_id = goal.scan_id.empty()
                         ? fmt::format("scan_{}", ros::Time::now().toNSec() / 1000000)
                         : goal.scan_id;
  points_ = 0;
  camera_.clear();
  stages_.clear();
  return request_.scan_id;
}

ScanResult ScanAction::run(const WhyToCancel& why_to_cancel) {
  const ros::WallTime start = ros::WallTime::now();
  const SequenceEnd end = sequence_.run(request_, why_to_cancel);
  ScanResult result;
  result.outcome = static_cast<std::uint8_t>(end.outcome);
  result.scan_id = request_.scan_id;
  result.passes_finished = static_cast<std::uint32_t>(sequence_.passes_finished());
  result.audit = stages_.audit();
  result.statistics = stages_.statistics();
  result.cloud = stages_.cloud();
  result.cloud_file = stages_.cloud_file();
  result.seconds = (ros::WallTime::now() - start).toSec();
  const bool finished = end.outcome == Outcome::kFinished;
  result.message = finished ? stages_.binding() : end.message;
  result.warnings = sequence_.warnings();
  for (const std::string& warning : result.warnings)
    ROS_WARN("Scan '%s': %s", request_.scan_id.c_str(), warning.c_str());
  publish_state(finished ? CellState::FINISHED : CellState::FAILED, end.message);
  if (!finished)
    ROS_WARN("Scan '%s' ended early: %s", request_.scan_id.c_str(), end.message.c_str());
  return result;
}

ScanRequest ScanAction::request_from(const std::vector<scan_cell_msgs::ScanPass>& passes,
                                     const std::string& frame) const {
  ScanRequest request;
  for (std::size_t i = 0; i < passes.size(); ++i)
    request.passes.push_back(pass_from(passes[i], fmt::format("pass {}", i + 1)));
  check(request, parameters_.limits);
  const Eigen::Isometry3d base = base_to(frame);
  for (ScanPass& pass : request.passes) {
    for (Eigen::Isometry3d& pose : pass.poses)
      pose = base * pose;
  }
  return request;
}

bool ScanAction::check_program(scan_cell_msgs::CheckProgram::Request& request,
                               scan_cell_msgs::CheckProgram::Response& response) {
  try {
    const auto runs = on(Outcome::kRefused, [&] {
      return runs_of(request_from(request.passes, request.frame).passes);
    });
    response.warnings = check_at_rest(asked_, runs, parameters_.timing.approach_speed);
    response.success = 1;
  } catch (const EndEarly& end) {
    response.message = end.message;
    response.link_lost = static_cast<unsigned char>(end.outcome != Outcome::kRefused);
  }
  return true;
}

/// @throw Refused if tf does not know the frame
Eigen::Isometry3d ScanAction::base_to(const std::string& frame) const {
  if (frame == parameters_.base_frame) return Eigen::Isometry3d::Identity();
  try {
    const auto base = transforms_.lookupTransform(parameters_.base_frame, frame, ros::Time(0),
                                                  ros::Duration(1.0));
    return scan_cell_common::from_ros(base.transform);
  } catch (const tf2::TransformException& error) {
    throw Refused("frame '" + frame + "'", error.what(),
                  "give the poses in " + parameters_.base_frame +
                      ", or start the node that publishes the calibrated frames");
  }
}

void ScanAction::on_progress(const ScanProgress& progress) {
  constexpr double kPeriod = 0.1;  // [s] chosen
  const ros::WallTime now = ros::WallTime::now();
  if (progress.step == last_step_ && (now - last_feedback_).toSec() < kPeriod) return;
  last_feedback_ = now;
  last_step_ = progress.step;
  scan_cell_msgs::ScanFeedback feedback;
  feedback.pass_number = static_cast<std::uint32_t>(progress.pass + 1);
  feedback.passes = static_cast<std::uint32_t>(request_.passes.size());
  feedback.step = static_cast<std::uint8_t>(progress.step);
  feedback.step_name = progress.name;
  feedback.progress = progress.whole;
  feedback.frames = camera_.profiles();
  feedback.points = points_;
  action_.publish(feedback);
}

void ScanAction::on_capture_begins() {
  publish_state(CellState::SCANNING, "");
}

void ScanAction::on_capture_ends() {}

void ScanAction::publish_state(std::uint8_t state, const std::string& message) {
  CellState cell;
  cell.header.stamp = ros::Time::now();
  cell.state = state;
  cell.scan_id = request_.scan_id;
  cell.message = message;
  state_.publish(cell);
}

}  // namespace scan_cell
