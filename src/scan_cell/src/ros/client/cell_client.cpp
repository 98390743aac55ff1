// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell/ros/cell_client.h"

#include <fmt/format.h>

#include "client/clean_cloud_watch.h"
#include "scan_cell/ros/scan_goal.h"
#include "scan_cell/ros/service_call.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/goal_client.h"
#include "scan_cell_common/tools/interrupts.h"

namespace scan_cell {
namespace {

using scan_cell_common::CatchInterrupts;
using scan_cell_common::ConnectionError;

constexpr double kCleaningTimeout = 60;  // [s] chosen

constexpr double kSlice = 0.1;         // [s] between two checks; chosen
constexpr double kCancelTimeout = 15;  // [s] to make a scan safe and keep its data; chosen

/// @throw ConnectionError if there is no server within `timeout` [s]
/// @throw Refused if interrupted before
template <class Client>
void wait_for_server(const Client& client, const std::string& name, double timeout) {
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(timeout);
  while (!client.wait_for_server(kSlice)) {
    if (CatchInterrupts::interrupted() || !ros::ok())
      throw scan_cell_common::Refused(name, "interrupted", "start it again");
    if (ros::WallTime::now() < deadline) continue;
    throw ConnectionError(name, fmt::format("no action server within {:g} s", timeout),
                          "start the cell with launch/scan_cell.launch");
  }
}

/// Waits for the end of the goal. An interrupt cancels the goal; its end is still awaited.
/// @param timeout [s] for the server to accept the goal
/// @throw ConnectionError if the server goes away or does not accept the goal
template <class Client>
auto wait_for_end(Client& client, const std::string& name, double timeout) {
  const ros::WallTime untaken = ros::WallTime::now() + ros::WallDuration(timeout);
  ros::WallTime deadline;  // zero: not cancelled
  for (;;) {
    if (const auto end = client.wait_for_end(kSlice)) return *end;
    if (CatchInterrupts::interrupted() && deadline.isZero()) {
      client.cancel();
      deadline = ros::WallTime::now() + ros::WallDuration(kCancelTimeout);
    }
    if (deadline.isZero() && ros::WallTime::now() > untaken && !client.is_taken())
      client.give_up(timeout);
    const bool late = !deadline.isZero() && ros::WallTime::now() > deadline;
    if (late || !ros::ok() || !client.is_connected()) {
      client.cancel();
      throw ConnectionError(name,
                            late ? "did not end when cancelled" : "the action server went away",
                            "look at the cell's log");
    }
  }
}

bool has_begun(const scan_cell_msgs::StretchToolPathResult& result) {
  return result.verdict.reason != scan_cell_msgs::StretchVerdict::NONE;
}

template <class Result>
bool has_begun(const Result& result) {
  return result.outcome != Result::NOT_BEGUN;
}

/// Sends a goal and waits for its end. Returns the server's result whatever the terminal state,
/// since the result itself says how the goal ended.
/// @param complete called with the goal once the server is there
/// @throw ConnectionError if there is no server or it goes away
/// @throw Refused if another client's cancel or goal arrived before it began
template <class Action, class Goal, class Complete, class Feedback>
auto run_action(const ros::NodeHandle& node, const std::string& name, Goal goal, double timeout,
                const Complete& complete, const Feedback& on_feedback) {
  const CatchInterrupts catch_interrupts;  // Ctrl-C must not leave robot and laser running
  scan_cell_common::GoalClient<Action> client(node, name);
  wait_for_server(client, name, timeout);
  complete(goal);
  client.send(goal, {}, on_feedback);
  const auto end = wait_for_end(client, name, timeout);
  if (!end.result) {
    throw ConnectionError(name, "the action server lost the goal; it was probably restarted",
                          "look at the cell's log");
  }
  if (!has_begun(*end.result)) {
    throw scan_cell_common::Refused(name, "did not begin", end.state.getText());
  }
  return *end.result;
}

}  // namespace

CellClient::CellClient(ros::NodeHandle node, const Names& names)
    : node_(node), names_(names), watcher_(node, names.state) {}

scan_cell_msgs::ScanResult CellClient::scan(const ScanProgram& program, const std::string& scan_id,
                                            double timeout, const Progress& progress) {
  const auto feedback = [&](const scan_cell_msgs::ScanFeedback& news) {
    const std::string pass =
        news.passes > 1 ? fmt::format("pass {} of {}: ", news.pass_number, news.passes) : "";
    progress(
        fmt::format("{}{}, {} frames, {} points", pass, news.step_name, news.frames, news.points),
        news.progress);
  };
  const auto watched = [&](auto& complete) { complete.watcher = watcher_.name(timeout); };
  const auto result = run_action<scan_cell_msgs::ScanAction>(
      node_, names_.scan, scan_goal(program, scan_id), timeout, watched, feedback);
  progress(fmt::format("scanned, {} frames, {} points", result.audit.frames_bound,
                       result.statistics.points),
           1);
  return result;
}

sensor_msgs::PointCloud2 CellClient::scan_clean(const ScanProgram& program,
                                                const std::string& scan_id, double timeout,
                                                const Progress& progress,
                                                scan_cell_msgs::ScanResult& result) {
  CleanCloudWatch watch(node_, names_.clean_cloud, names_.report);
  result = scan(program, scan_id, timeout, progress);
  if (result.outcome != scan_cell_msgs::ScanResult::FINISHED) {
    throw scan_cell_common::Refused("scan '" + scan_id + "'", "ended early", result.message);
  }
  check_published(result.cloud_file);
  return watch.wait(result.cloud.header.stamp, kCleaningTimeout);
}

scan_cell_msgs::CalibrateResult CellClient::calibrate(const scan_cell_msgs::CalibrateGoal& goal,
                                                      double timeout, const Progress& progress) {
  const auto feedback = [&](const scan_cell_msgs::CalibrateFeedback& news) {
    const std::string where = fmt::format("pose {} of {}: ", news.pose, news.poses);
    progress((news.pose > 0 ? where : "") + news.doing, news.progress);
  };
  const auto watched = [&](auto& complete) { complete.watcher = watcher_.name(timeout); };
  const auto result = run_action<scan_cell_msgs::CalibrateAction>(node_, names_.calibrate, goal,
                                                                  timeout, watched, feedback);
  progress(fmt::format("{} views recorded", result.views), 1);
  return result;
}

scan_cell_msgs::StretchToolPathResult CellClient::stretch(
    const scan_cell_msgs::StretchToolPathGoal& goal, double timeout, const Progress& progress) {
  const auto feedback = [&](const scan_cell_msgs::StretchToolPathFeedback& news) {
    progress(news.stage, news.progress);
  };
  const auto nothing = [](scan_cell_msgs::StretchToolPathGoal&) {};  // nothing moves
  return run_action<scan_cell_msgs::StretchToolPathAction>(node_, names_.stretch, goal, timeout,
                                                           nothing, feedback);
}

scan_cell_msgs::WorkResult CellClient::work(const scan_cell_msgs::WorkGoal& goal, double timeout,
                                            const Progress& progress) {
  const auto feedback = [&](const scan_cell_msgs::WorkFeedback& news) {
    progress(fmt::format("{}, {} waypoints", news.doing, news.passed), news.progress);
  };
  const auto watched = [&](auto& complete) { complete.watcher = watcher_.name(timeout); };
  return run_action<scan_cell_msgs::WorkAction>(node_, names_.work, goal, timeout, watched,
                                                feedback);
}

scan_cell_msgs::PreviewWorkResponse CellClient::preview(const scan_cell_msgs::WorkGoal& goal,
                                                        double timeout) const {
  scan_cell_msgs::PreviewWorkRequest request;
  request.goal = goal;
  return ask<scan_cell_msgs::PreviewWork>(names_.preview, request, timeout);
}

CalibrationFiles CellClient::calibration_files() const {
  CalibrationFiles files;
  node_.getParam(names_.frames + "/scanner_file", files.scanner);
  node_.getParam(names_.frames + "/cell_file", files.cell);
  return files;
}

std::optional<CameraRegion> CellClient::camera_region() const {
  CameraRegion region;
  const std::pair<const char*, std::uint32_t*> sides[] = {
      {"x", &region.x}, {"y", &region.y}, {"width", &region.width}, {"height", &region.height}};
  for (const auto& [name, side] : sides) {
    int pixels = -1;
    if (!node_.getParam(names_.camera + "/region_" + name, pixels) || pixels < 0) return {};
    *side = static_cast<std::uint32_t>(pixels);
  }
  return region;
}

}  // namespace scan_cell
