// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "triangulation_services.h"

#include <fmt/format.h>

#include <boost/make_shared.hpp>
#include <cctype>
#include <chrono>
#include <filesystem>

#include "cloud_file.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/service_answer.h"

namespace laser_triangulation {

using scan_cell_msgs::FinishCloud;
using scan_cell_msgs::StartRun;
using scan_cell_msgs::StartScan;

namespace {

/// Different for each scan, with only safe characters of its id.
std::string file_name(std::string scan_id, const ros::Time& stamp) {
  for (char& letter : scan_id) {
    const bool plain = std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '-';
    if (!plain) letter = '_';
  }
  return fmt::format("{}_{}.ply", scan_id, stamp.toNSec());
}

}  // namespace

TriangulationServices::TriangulationServices(ros::NodeHandle node, ros::NodeHandle private_node,
                                             const Parameters& parameters)
    : parameters_(parameters),
      model_(scan_cell_common::load_scanner_model(parameters.scanner)),
      diagnostics_(node, private_node, private_node.getNamespace()) {
  Triangulator(model_, parameters.limits);  // refuses limits that contradict each other

  constexpr std::uint32_t kUnbounded = 0;     // messages: no data are discarded unread
  constexpr double kDiagnosticsPeriod = 0.2;  // [s] chosen
  constexpr std::uint32_t kClouds = 100;      // messages, for a slow viewer; chosen
  cloud_ = private_node.advertise<sensor_msgs::PointCloud2>("cloud", kClouds);
  whole_cloud_ = private_node.advertise<sensor_msgs::PointCloud2>("whole_cloud", 1, true);
  ros::NodeHandle data = node;
  data.setCallbackQueue(&data_queue_);
  profiles_ = data.subscribe("bound_profiles", kUnbounded, &TriangulationServices::on_profile, this,
                             ros::TransportHints().tcpNoDelay());
  increment_timer_ = data.createWallTimer(ros::WallDuration(1 / parameters.publish_rate),
                                          [this](const ros::WallTimerEvent&) {
                                            const std::lock_guard<std::mutex> lock(mutex_);
                                            publish_increment();
                                          });
  start_ = private_node.advertiseService("start", &TriangulationServices::start, this);
  check_run_ = private_node.advertiseService("check_run", &TriangulationServices::check_run, this);
  finish_ = private_node.advertiseService("finish", &TriangulationServices::finish, this);
  diagnostics_.setHardwareID("none");
  diagnostics_.add("triangulation", this, &TriangulationServices::diagnose);
  diagnostics_timer_ = node.createTimer(ros::Duration(kDiagnosticsPeriod),
                                        [this](const ros::TimerEvent&) { diagnostics_.update(); });
  data_spinner_.start();
}

void TriangulationServices::on_profile(const scan_cell_msgs::BoundProfile& profile) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!scan_ || !failure_.empty()) {
    ++ignored_;
    return;
  }
  try {
    scan_->add(profile);
  } catch (const scan_cell_common::Error& error) {
    failure_ = error.what();
    ROS_ERROR("scan %s: %s", scan_id_.c_str(), error.what());
  }
  if (finishing_) news_.notify_all();
}

void TriangulationServices::publish_increment() {
  if (!scan_ || scan_->points().size() == published_) return;
  if (cloud_.getNumSubscribers() > 0)
    cloud_.publish(boost::make_shared<sensor_msgs::PointCloud2>(scan_->cloud(published_)));
  published_ = scan_->points().size();
}

bool TriangulationServices::start(StartScan::Request& request, StartScan::Response& response) {
  const std::lock_guard<std::mutex> lock(mutex_);
  response.success = !finishing_;
  if (finishing_) {
    response.message = "scan " + scan_id_ + " is not finished yet; wait for its cloud";
    return true;
  }
  scan_ = std::make_unique<CloudBuilder>(model_, parameters_.limits, parameters_.max_points);
  scan_id_ = request.scan_id;
  failure_.clear();
  published_ = 0;
  ignored_ = 0;
  return true;
}

bool TriangulationServices::check_run(StartRun::Request& request, StartRun::Response& response) {
  return scan_cell_common::answer(response, [&] {
    for (std::size_t laser = 0; request.lasers >> laser != 0; ++laser) {
      if ((request.lasers >> laser) % 2 == 0 || model_.has_laser(laser)) continue;
      throw scan_cell_common::Refused(
          scan_cell_common::laser_name(laser), "not calibrated",
          "calibrate it, or scan with a laser that the scanner model has");
    }
  });
}

void TriangulationServices::wait_for(std::uint64_t profiles, double timeout,
                                     std::unique_lock<std::mutex>& lock) {
  finishing_ = true;
  const auto all = [this, profiles] {
    return scan_->profiles() >= profiles || !failure_.empty() || !ros::ok();
  };
  std::uint64_t heard = 0;
  do {
    heard = scan_->profiles();
  } while (!news_.wait_for(lock, std::chrono::duration<double>(timeout), all) &&
           scan_->profiles() > heard);
  finishing_ = false;
}

std::string TriangulationServices::find_fault(std::uint64_t profiles) const {
  if (!failure_.empty()) return failure_;
  if (scan_->profiles() < profiles) {
    return fmt::format("only {} of {} bound profiles arrived", scan_->profiles(), profiles);
  }
  return scan_->points().empty() ? "no points: " + scan_->summary() : "";
}

void TriangulationServices::give_cloud(FinishCloud::Response& response) const {
  if (scan_->points().size() <= parameters_.max_message_points) {
    response.cloud = scan_->cloud();
    return;
  }
  response.cloud = scan_->cloud(scan_->points().size());
  const std::string name = file_name(scan_id_, response.cloud.header.stamp);
  response.file = std::filesystem::absolute(parameters_.cloud_folder) / name;
  save_ply(response.file, scan_->points());
}

bool TriangulationServices::finish(FinishCloud::Request& request, FinishCloud::Response& response) {
  std::unique_lock<std::mutex> lock(mutex_);
  if (!scan_ || finishing_) {
    response.success = false;
    response.message = scan_ ? "scan " + scan_id_ + " is not finished yet; wait for its cloud"
                             : "no scan is running; call start first";
    return true;
  }
  wait_for(request.profiles, request.timeout.toSec(), lock);
  publish_increment();
  response.statistics = scan_->statistics(scan_id_);
  try {
    give_cloud(response);
  } catch (const std::exception& error) {  // the points are kept
    response.file.clear();
    response.success = false;
    response.message = std::string(error.what()) + ", and call finish again";
    ROS_ERROR("scan %s: %s", scan_id_.c_str(), response.message.c_str());
    return true;
  }
  failure_ = find_fault(request.profiles);
  if (failure_.empty() && request.partial == 0) failure_ = scan_->find_dark_sweep();
  response.success = failure_.empty();
  response.message = response.success ? scan_->summary() : failure_;
  if (!response.file.empty()) response.message += "; too many for a message: " + response.file;
  if (response.success && response.file.empty() && !request.partial)
    whole_cloud_.publish(response.cloud);
  ROS_INFO("scan %s: %s", scan_id_.c_str(), response.message.c_str());
  for (const std::string& line : CloudBuilder::overlap_lines(response.statistics))
    ROS_INFO("scan %s: %s", scan_id_.c_str(), line.c_str());
  scan_.reset();
  return true;
}

void TriangulationServices::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using Level = diagnostic_msgs::DiagnosticStatus;
  const std::lock_guard<std::mutex> lock(mutex_);
  status.summary(failure_.empty() ? Level::OK : Level::ERROR,
                 failure_.empty() ? (scan_ ? "building scan " + scan_id_ : "idle") : failure_);
  status.add("profiles", scan_ ? scan_->profiles() : 0);
  status.add("points", scan_ ? scan_->points().size() : 0);
  status.add("profiles outside of a scan", ignored_);
}

}  // namespace laser_triangulation
