// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "client/bag_replay.h"

#include <XmlRpcValue.h>
#include <fmt/format.h>
#include <ros/master.h>
#include <ros/this_node.h>
#include <rosbag/view.h>
#include <scan_cell_msgs/CellState.h>
#include <scan_cell_msgs/PeakProfile.h>
#include <scan_cell_msgs/TriggerEvent.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/bag_errors.h"

namespace scan_cell {
namespace {

using scan_cell_common::UnusableInput;
using scan_cell_msgs::CellState;

/// The topic's messages are few and large, and none may be lost on the way to a slow subscriber.
constexpr std::uint32_t kUnboundedQueue = 0;

/// Number of nodes that have subscribed to a topic, connected or not.
std::size_t registered_subscribers(const std::string& topic) {
  XmlRpc::XmlRpcValue request(ros::this_node::getName()), answer, state;
  if (!ros::master::execute("getSystemState", request, answer, state, false)) {
    throw scan_cell_common::ConnectionError("ROS master", "does not report the subscribers",
                                            "is roscore running?");
  }
  XmlRpc::XmlRpcValue& subscriptions = state[1];
  for (int i = 0; i < subscriptions.size(); ++i) {
    if (std::string(subscriptions[i][0]) == topic)
      return static_cast<std::size_t>(subscriptions[i][1].size());
  }
  return 0;
}

/// Other nodes may connect before the binder: until all have connected, it may lose messages.
void wait_for_subscribers(const ros::Publisher& publisher, double timeout) {
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(timeout);
  for (;;) {
    const std::size_t registered = registered_subscribers(publisher.getTopic());
    const std::size_t connected = publisher.getNumSubscribers();
    if (connected > 0 && connected >= registered) return;
    if (!ros::ok() || ros::WallTime::now() > deadline) {
      throw scan_cell_common::ConnectionError(
          publisher.getTopic(),
          fmt::format("{} of {} subscribers connected", connected, registered),
          registered == 0 ? "is pose_frame_binder running?"
                          : "if one of them has died, run rosnode cleanup");
    }
    ros::WallDuration(0.02).sleep();
  }
}

std::vector<scan_cell_msgs::ScanRun> runs_of(const std::vector<scan_cell_msgs::ScanRun>& runs,
                                             const std::string& scan_id) {
  std::vector<scan_cell_msgs::ScanRun> result;
  std::copy_if(runs.begin(), runs.end(), std::back_inserter(result),
               [&](const auto& run) { return run.scan_id == scan_id; });
  return result;
}

}  // namespace

BagReplay::BagReplay(const std::string& path, const std::string& scan_id, const Topics& topics)
    : path_(path), topics_(topics) {
  scan_cell_common::name_bag_in_errors(path, [&] {
    bag_.open(path, rosbag::bagmode::Read);
    choose(scan_id);
    check_contents();
  });
}

void BagReplay::choose(const std::string& scan_id) {
  std::string others;
  for (const RecordedScan& scan : find_scans()) {
    if (scan_id.empty() ? scan.whole : scan.scan_id == scan_id) scan_ = scan;
    others += " '" + scan.scan_id + (scan.whole ? "'" : "' (ended early)");
  }
  if (!scan_.scan_id.empty()) return;
  throw UnusableInput(path_, scan_id.empty() ? "no whole scan" : "no scan '" + scan_id + "'",
                      others.empty()
                          ? "record " + topics_.state + " from before the scan to its end"
                          : "give a scan_id of" + others);
}

std::vector<RecordedScan> BagReplay::find_scans() const {
  std::vector<RecordedScan> scans;
  rosbag::View view(bag_, rosbag::TopicQuery({topics_.state, topics_.runs}));
  RecordedScan open;
  std::vector<scan_cell_msgs::ScanRun> runs;  // since the end of the previous scan
  for (const rosbag::MessageInstance& message : view) {
    if (const auto run = message.instantiate<scan_cell_msgs::ScanRun>()) runs.push_back(*run);
    const auto state = message.instantiate<CellState>();
    if (!state) continue;
    if (state->state == CellState::SCANNING) {
      open = {state->scan_id, message.getTime(), ros::Time(), false, {}};
    } else if (!open.scan_id.empty() && state->scan_id == open.scan_id) {
      open.end = message.getTime();
      open.whole = state->state == CellState::FINISHED;
      open.runs = runs_of(runs, open.scan_id);
      scans.push_back(open);
      open = RecordedScan();
      runs.clear();
    }
  }
  return scans;
}

void BagReplay::check_contents() {
  std::map<std::string, std::uint64_t> counts;
  rosbag::View view(bag_, scan_.start, scan_.end);
  for (const rosbag::MessageInstance& message : view)
    ++counts[message.getTopic()];
  for (const std::string& topic : {topics_.events, topics_.profiles, topics_.poses}) {
    if (counts[topic] == 0) {
      throw UnusableInput(path_, "nothing on " + topic + " in scan '" + scan_.scan_id + "'",
                          "record that topic as well");
    }
  }
  pulses_ = counts[topics_.events];
}

void BagReplay::play(ros::NodeHandle node, double speed, double timeout,
                     const std::function<void(double)>& progress) {
  std::map<std::string, ros::Publisher> publishers = {
      {topics_.events,
       node.advertise<scan_cell_msgs::TriggerEvent>(topics_.events, kUnboundedQueue)},
      {topics_.profiles,
       node.advertise<scan_cell_msgs::PeakProfile>(topics_.profiles, kUnboundedQueue)},
      {topics_.poses, node.advertise<tf2_msgs::TFMessage>(topics_.poses, kUnboundedQueue)}};
  for (const auto& [topic, publisher] : publishers)
    wait_for_subscribers(publisher, timeout);

  const ros::WallTime begin = ros::WallTime::now();
  const double duration = (scan_.end - scan_.start).toSec();
  scan_cell_common::name_bag_in_errors(path_, [&] {
    rosbag::View view(bag_, rosbag::TopicQuery({topics_.events, topics_.profiles, topics_.poses}),
                      scan_.start, scan_.end);
    for (const rosbag::MessageInstance& message : view) {
      if (!ros::ok()) throw scan_cell_common::Refused("replay", "interrupted", "start it again");
      const double due = (message.getTime() - scan_.start).toSec();
      const ros::WallTime when = begin + ros::WallDuration(due / speed);
      const ros::WallDuration early = when - ros::WallTime::now();
      if (early > ros::WallDuration(0)) early.sleep();  // roscpp sleeps for ever on a negative one
      publishers.at(message.getTopic()).publish(message);
      progress(duration > 0 ? due / duration : 1);
    }
  });
}

}  // namespace scan_cell
