// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "triangulation_services.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <cctype>
#include <chrono>
#include <filesystem>

#include "cloud_file.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/ros/service_answer.h"
#include "scan_cell_common/scanner/point_deviations.h"

namespace laser_triangulation {

using scan_cell_msgs::FinishCloud;
using scan_cell_msgs::StartRun;
using scan_cell_msgs::StartScan;

namespace {

/// A file name unique to each scan, with only the safe characters of its id.
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
      deviations_(scan_cell_common::load_point_deviations(parameters.scanner)),
      diagnostics_(node, private_node, private_node.getNamespace()) {
  Triangulator(model_, parameters.limits);  // refuses contradictory limits

  constexpr std::uint32_t kUnbounded = 0;     // messages: no data is discarded unread
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
  scan_ = std::make_unique<CloudBuilder>(model_, parameters_.limits, parameters_.max_points,
                                         deviations_);
  scan_id_ = request.scan_id;
  last_ = {};
  failure_.clear();
  published_ = 0;
  ignored_ = 0;
  return true;
}

bool TriangulationServices::check_run(StartRun::Request& request, StartRun::Response& response) {
  return scan_cell_common::answer(response, [&] {
    for (std::size_t laser = 0; request.run.lasers >> laser != 0; ++laser) {
      if ((request.run.lasers >> laser) % 2 == 0 || model_.has_laser(laser)) continue;
      throw scan_cell_common::Refused(
          scan_cell_common::laser_name(laser), "not calibrated",
          "calibrate it, or scan with a laser that the scanner model has");
    }
  });
}

void TriangulationServices::wait_for(std::uint64_t profiles, double timeout,
                                     std::unique_lock<std::mutex>& lock) {
  const auto all = [this, profiles] {
    return scan_->profiles() >= profiles || !failure_.empty() || !ros::ok();
  };
  std::uint64_t heard = 0;
  do {
    heard = scan_->profiles();
  } while (!news_.wait_for(lock, std::chrono::duration<double>(timeout), all) &&
           scan_->profiles() > heard);
}

std::string TriangulationServices::find_fault(const CloudBuilder& scan,
                                              std::uint64_t profiles) const {
  if (!failure_.empty()) return failure_;
  if (scan.profiles() < profiles) {
    return fmt::format("only {} of {} bound profiles arrived", scan.profiles(), profiles);
  }
  return scan.points().empty() ? "no points: " + scan.summary() : "";
}

void TriangulationServices::give_cloud(CloudBuilder& scan, FinishCloud::Response& response) const {
  scan.bring_together();
  response.statistics = scan.statistics(scan_id_);
  if (scan.points().size() <= parameters_.max_message_points) {
    response.cloud = scan.cloud();
    return;
  }
  response.cloud = scan.cloud(scan.points().size());
  const std::string name = file_name(scan_id_, response.cloud.header.stamp);
  response.file = std::filesystem::absolute(parameters_.cloud_folder) / name;
  save_ply(response.file, scan.points());
}

void TriangulationServices::tell(const FinishCloud::Response& response) const {
  ROS_INFO("scan %s: %s", scan_id_.c_str(), response.message.c_str());
  const bool apart = response.statistics.agreement == scan_cell_msgs::CloudStatistics::DISAGREE;
  for (const std::string& line : CloudBuilder::agreement_lines(response.statistics))
    ROS_LOG(apart ? ros::console::levels::Warn : ros::console::levels::Info,
            ROSCONSOLE_DEFAULT_NAME, "scan %s: %s", scan_id_.c_str(), line.c_str());
}

/// Judges a finished cloud, and publishes it if it is whole.
void TriangulationServices::fill(const CloudBuilder& scan, const FinishCloud::Request& request,
                                 FinishCloud::Response& response) {
  last_ = response.statistics;
  failure_ = find_fault(scan, request.profiles);
  if (failure_.empty() && request.partial == 0) failure_ = scan.find_dark_sweep();
  response.success = failure_.empty();
  response.message = response.success ? scan.summary() : failure_;
  if (!response.file.empty())
    response.message += "; too many for a message, written to " + response.file;
  const bool apart = last_.agreement == scan_cell_msgs::CloudStatistics::DISAGREE;
  if (response.success && response.file.empty() && !request.partial && !apart)
    whole_cloud_.publish(response.cloud);
}

bool TriangulationServices::finish(FinishCloud::Request& request, FinishCloud::Response& response) {
  std::unique_lock<std::mutex> lock(mutex_);
  if (!scan_ || finishing_) {
    response.success = false;
    response.message = finishing_ ? "scan " + scan_id_ + " is not finished yet; wait for its cloud"
                                  : "no scan is running; call start first";
    return true;
  }
  finishing_ = true;  // until the end, so that no other call starts
  wait_for(request.profiles, request.timeout.toSec(), lock);
  publish_increment();
  std::unique_ptr<CloudBuilder> scan = std::move(scan_);
  lock.unlock();  // profiles, diagnostics and the timer do not wait for the passes' comparison
  std::string fault;
  try {
    give_cloud(*scan, response);
  } catch (const std::exception& error) {  // the points are kept
    fault = std::string(error.what()) + ", and call finish again";
  }
  lock.lock();
  finishing_ = false;
  if (!fault.empty()) {
    scan_ = std::move(scan);
    response.file.clear();
    response.success = false;
    response.message = fault;
    ROS_ERROR("scan %s: %s", scan_id_.c_str(), response.message.c_str());
    return true;
  }
  fill(*scan, request, response);
  tell(response);
  return true;
}

void TriangulationServices::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using Level = diagnostic_msgs::DiagnosticStatus;
  using Statistics = scan_cell_msgs::CloudStatistics;
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::string doing = scan_        ? "building scan " + scan_id_
                            : finishing_ ? "comparing the passes of scan " + scan_id_
                                         : "idle";
  status.summary(failure_.empty() ? Level::OK : Level::ERROR, failure_.empty() ? doing : failure_);
  if (last_.agreement == Statistics::DISAGREE)
    status.mergeSummary(Level::WARN, "the passes of scan " + last_.scan_id + " disagree");
  status.add("profiles", scan_ ? scan_->profiles() : 0);
  status.add("points", scan_ ? scan_->points().size() : 0);
  status.add("profiles outside of a scan", ignored_);
  double median = 0, most = 0;  // [mm] of the worst pair
  for (const scan_cell_msgs::PassOverlap& overlap : last_.overlaps) {
    using scan_cell_common::kMillimetres;
    median = std::max(median, kMillimetres * overlap.median);
    most = std::max(most, kMillimetres * overlap.most);
  }
  status.add("pairs of passes compared, of the last scan", last_.overlaps.size());
  status.add("their disagreement at most [mm], median", median);
  status.add("their disagreement at most [mm], 95 %", most);
  status.add("passes of the last scan", last_.agreement_message);
}

}  // namespace laser_triangulation
