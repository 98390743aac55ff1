// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "client/bag_recording.h"

#include <ros/rate.h>

#include <chrono>
#include <cstdio>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/bag_errors.h"

namespace scan_cell {
namespace {

using scan_cell_common::ConnectionError;
using scan_cell_msgs::CellState;

void wait_for_publisher(const ros::Subscriber& subscriber, double timeout) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(timeout);
  while (subscriber.getNumPublishers() == 0) {
    if (ros::WallTime::now() > end || !ros::ok())
      throw ConnectionError(subscriber.getTopic(), "nobody publishes it", "start the whole cell");
    ros::WallDuration(0.01).sleep();
  }
}

}  // namespace

BagRecording::BagRecording(ros::NodeHandle node, std::string file, double timeout)
    : file_(std::move(file)) {
  const BagReplay::Topics topics;
  scan_cell_common::name_bag_in_errors(file_, [&] {
    bag_.open(file_, rosbag::bagmode::Write);
    bag_.setCompression(rosbag::compression::LZ4);
  });
  for (const std::string& topic : {topics.state, topics.runs, topics.events, topics.profiles,
                                   topics.poses, std::string("/tf_static")}) {
    const boost::function<void(const Message&)> take = [this, topic](const Message& message) {
      add(topic, message);
    };
    constexpr unsigned kAll = 0;  // the disk may be slow, but nothing is lost
    ros::SubscribeOptions options;
    options.initByFullCallbackType<const Message&>(topic, kAll, take);
    subscribers_.push_back(node.subscribe(options));
  }
  for (const ros::Subscriber& subscriber : subscribers_)
    wait_for_publisher(subscriber, timeout);
}

BagRecording::~BagRecording() {
  for (ros::Subscriber& subscriber : subscribers_)
    subscriber.shutdown();
  if (finished_) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  try {
    bag_.close();
  } catch (const rosbag::BagException&) {  // NOLINT: a partial file is removed
  }
  std::remove(file_.c_str());
}

void BagRecording::add(const std::string& topic, const Message& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (failure_ || finished_) return;
  try {
    bag_.write(topic, message);
  } catch (const rosbag::BagException& error) {
    failure_ = error.what();
  }
  const auto& content = message.getConstMessage();
  if (content->getDataType() == ros::message_traits::datatype<CellState>())
    look_for_end(*content->instantiate<CellState>());
}

void BagRecording::look_for_end(const CellState& state) {
  if (state.state != CellState::FINISHED && state.state != CellState::FAILED) return;
  ended_ = state.scan_id;
  news_.notify_all();
}

void BagRecording::finish(const std::string& scan_id) {
  constexpr std::chrono::seconds kPatience(5);  // it arrives with the scan's result; chosen
  std::unique_lock<std::mutex> lock(mutex_);
  if (!news_.wait_for(lock, kPatience, [&] { return ended_ == scan_id; }))
    throw ConnectionError(BagReplay::Topics().state,
                          "did not report the end of scan '" + scan_id + "'",
                          "check the node scan_cell");
  if (failure_)
    throw scan_cell_common::FileError(file_, *failure_, "check the folder and the disk");
  scan_cell_common::name_bag_in_errors(file_, [&] { bag_.close(); });
  finished_ = true;
}

}  // namespace scan_cell
