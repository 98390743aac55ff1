// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "videe/videe_cell.h"

#include <cv_bridge/cv_bridge.h>
#include <fmt/format.h>
#include <scan_cell_msgs/GrabImage.h>
#include <sensor_msgs/image_encodings.h>

#include <filesystem>
#include <opencv2/imgcodecs.hpp>

#include "scan_cell/ros/scan_goal.h"
#include "scan_cell/ros/service_call.h"
#include "videe/videe_wait.h"

namespace scan_cell {

using scan_cell_common::Refused;

namespace {

constexpr double kCallsInside = 4;  // timeouts: three calls inside grab_image, and its own

/// Whether a command only ends something.
bool is_end(VideeCommandKind kind) {
  return kind == VideeCommandKind::kInitCycle || kind == VideeCommandKind::kReset;
}

}  // namespace

VideeCell::VideeCell(ros::NodeHandle node, const VideeParameters& parameters)
    : node_(node),
      parameters_(parameters),
      program_(load_scan_program(parameters.program)),
      watcher_(node, parameters.state),
      scans_(node, parameters.scan),
      calibrations_(node, parameters.calibrate),
      client_(node, parameters.scan),
      calibration_(node, parameters.calibration, parameters.calibrate, watcher_,
                   parameters.call_timeout) {}

std::string VideeCell::carry_out(const VideeCommand& command,
                                 const VideeServer::ClientThere& client_there) {
  if (!is_end(command.kind) && !client_there()) {
    throw scan_cell_common::ConnectionError("ViDeE client", "gone", "connect again");
  }
  switch (command.kind) {
    case VideeCommandKind::kInitCycle:
      end_own();
      return "";
    case VideeCommandKind::kReset:
      end_all();
      return "";
    case VideeCommandKind::kInitCalibration:
      return calibration_.init();
    case VideeCommandKind::kPerformCalibration:
      return calibration_.perform(client_there);
    case VideeCommandKind::kGrabImage:
      return grab_image();
    case VideeCommandKind::kSetPosition:
      return set_position(command);
    case VideeCommandKind::kStartScan:
      return start_scan();
    case VideeCommandKind::kStopScan:
      return stop_scan(client_there);
    case VideeCommandKind::kWaitScan:
      return wait_scan(client_there);
  }
  throw Refused("command", "unknown", "send a ViDeE command");
}

void VideeCell::end_own() {
  positions_.clear();
  calibration_.reset();
  if (!running_) return;
  running_ = false;
  cancel_and_wait(client_, parameters_.scan);
}

void VideeCell::end_all() {
  end_own();
  scans_.cancel(parameters_.call_timeout);
  calibrations_.cancel(parameters_.call_timeout);
  scans_.wait_until_ended(kCancelTimeout);
  calibrations_.wait_until_ended(kCancelTimeout);
}

std::string VideeCell::set_position(const VideeCommand& command) {
  if (running_) {
    throw Refused("SET_POSITION", "a scan is running", "send STOP_SCAN or RESET first");
  }
  positions_ = command.poses;
  return "";
}

std::string VideeCell::start_scan() {
  if (positions_.empty()) {
    throw Refused("START_SCAN", "no positions", "send SET_POSITION first");
  }
  if (running_) throw Refused("START_SCAN", "a scan is running", "send STOP_SCAN or RESET first");
  wait_for_server(client_, parameters_.scan, parameters_.call_timeout);
  ScanProgram program{program_.frame, {}};
  for (std::size_t i = 0; i < positions_.size(); i += 2) {
    ScanPass pass = program_.passes.front();
    pass.name.clear();
    pass.kind = PassKind::kLine;
    pass.poses = {positions_[i], positions_[i + 1]};
    program.passes.push_back(pass);
  }
  scan_cell_msgs::ScanGoal goal = scan_goal(program, "");
  goal.watcher = watcher_.name(parameters_.call_timeout);
  send_goal(client_, parameters_.scan, goal, parameters_.call_timeout);
  running_ = true;
  stopped_ = false;
  return "";
}

/// STOP_SCAN follows and reports how the scan ended.
std::string VideeCell::wait_scan(const VideeServer::ClientThere& client_there) {
  if (!running_) throw Refused("WAIT_SCAN", "no scan is running", "send START_SCAN first");
  bool under_way = true;
  wait_for_result(client_, parameters_.scan, client_there, under_way);
  return "";
}

std::string VideeCell::stop_scan(const VideeServer::ClientThere& client_there) {
  using scan_cell_msgs::ScanResult;
  if (!running_) throw Refused("STOP_SCAN", "no scan is running", "send START_SCAN first");
  if (!client_.end()) {
    stopped_ = true;
    client_.cancel();
  }
  const auto result = wait_for_result(client_, parameters_.scan, client_there, running_);
  const KeptCloud kept = keep(*result);
  const bool whole = result->outcome == ScanResult::FINISHED;
  if (!whole && !(stopped_ && result->outcome == ScanResult::CANCELLED)) {
    throw Refused("scan '" + result->scan_id + "'", "ended early",
                  result->message + "; what came is in " + kept.file + " on " + kept.machine);
  }
  return fmt::format("scan={} frames={} points={} ended={} cloud={} machine={}", result->scan_id,
                     result->audit.frames_bound, result->statistics.points,
                     whole ? "whole" : "stopped", kept.file, kept.machine);
}

KeptCloud VideeCell::keep(const scan_cell_msgs::ScanResult& scan) {
  try {
    return keep_cloud(scan, parameters_.cloud_folder, parameters_.triangulation);
  } catch (const scan_cell_common::FileError& error) {
    running_ = true;  // the result stays with client_
    const std::string ended = scan.message.empty() ? "" : "; the scan: " + scan.message;
    throw scan_cell_common::FileError(error.thing(), error.value(),
                                      error.cure() + ", then send STOP_SCAN again" + ended);
  }
}

std::string VideeCell::grab_image() {
  const auto answer = call<scan_cell_msgs::GrabImage>(parameters_.grab_image, {},
                                                      kCallsInside * parameters_.call_timeout);
  const auto image = cv_bridge::toCvCopy(answer.image, sensor_msgs::image_encodings::MONO8);
  std::string path;
  do {
    path = fmt::format("{}/image_{}.png", parameters_.image_folder, ++images_);
  } while (std::filesystem::exists(path));  // names used by an earlier run of this node
  if (!cv::imwrite(path, image->image)) {
    throw scan_cell_common::FileError(path, "cannot be written", "check image_folder");
  }
  return path;
}

void VideeCell::on_client_lost() {
  ROS_INFO("The ViDeE client is gone; its scan or calibration is cancelled");
  try {
    end_own();
  } catch (const scan_cell_common::Error& error) {
    ROS_ERROR("%s", error.what());
  }
}

}  // namespace scan_cell
