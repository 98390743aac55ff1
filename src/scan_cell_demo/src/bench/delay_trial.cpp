// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "delay_trial.h"

#include <fmt/format.h>
#include <rosbag/bag.h>
#include <scan_cell_msgs/PeakProfile.h>
#include <scan_cell_msgs/TriggerEvent.h>
#include <tf2_msgs/TFMessage.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <mutex>

#include "binding_errors.h"
#include "scan_cell_common/errors/errors.h"

namespace scan_cell_demo {
namespace {

namespace fs = std::filesystem;

/// Records what a scan needs in a bag, as launch/scan_cell.launch does with record:=.
class BagRecorder {
 public:
  BagRecorder(SimulatedCell& cell, const std::string& path) : bag_(path, rosbag::bagmode::Write) {
    record<tf2_msgs::TFMessage>(cell.node(), "/tf");
    record<scan_cell_msgs::TriggerEvent>(cell.node(), "/laser_trigger/events");
    record<scan_cell_msgs::PeakProfile>(cell.node(), "/camera/profiles");
    for (const ros::Subscriber& subscriber : subscribers_) {
      cell.wait_until(subscriber.getTopic(), [&] { return subscriber.getNumPublishers() > 0; });
    }
  }

 private:
  template <class Message>
  void record(ros::NodeHandle& node, const std::string& topic) {
    const boost::function<void(const boost::shared_ptr<const Message>&)> write =
        [this, topic](const boost::shared_ptr<const Message>& message) {
          const std::lock_guard<std::mutex> lock(mutex_);  // the cell has two callback threads
          bag_.write(topic, ros::Time::now(), message);
        };
    constexpr std::uint32_t kUnbounded = 0;
    subscribers_.push_back(node.subscribe<Message>(topic, kUnbounded, write));
  }

  std::mutex mutex_;  // guards the bag
  rosbag::Bag bag_;
  std::vector<ros::Subscriber> subscribers_;  // destroyed before the bag is closed
};

Scan record_scan(SimulatedCell& cell, const Motion& motion, double rate, const std::string& bag) {
  const BagRecorder recorder(cell, bag);
  return cell.scan(motion, rate);
}

std::string said_by(const std::string& command) {
  FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr)
    throw scan_cell_common::Refused(command, "not started", "end other programs");
  std::string text;
  char buffer[256];
  while (fgets(buffer, sizeof buffer, pipe) != nullptr)
    text += buffer;
  if (pclose(pipe) != 0) throw scan_cell_common::Refused(command, text, "see there");
  return text;
}

DelayTrial figures_in(const std::string& said) {
  constexpr double kMillisecond = 1e-3;
  DelayTrial trial;
  const char* const figures = std::strstr(said.c_str(), "pose_delay: ");
  if (figures == nullptr || std::sscanf(figures, "pose_delay: %lf ms, standard deviation %lf ms",
                                        &trial.estimate, &trial.uncertainty) != 2) {
    throw scan_cell_common::Refused("estimate_time_offset", said, "no figures in it");
  }
  trial.estimate *= kMillisecond;
  trial.uncertainty *= kMillisecond;
  return trial;
}

}  // namespace

DelayTrial try_delay(SimulatedCell& cell, const Motion& there, const Motion& back, double rate,
                     const std::string& scanner) {
  const fs::path folder = fs::temp_directory_path() / fmt::format("delay_{}", getpid());
  fs::create_directories(folder);
  const std::string forward = folder / "there.bag", backward = folder / "back.bag";
  const double truth_there = true_pose_delay(record_scan(cell, there, rate, forward));
  const double truth_back = true_pose_delay(record_scan(cell, back, rate, backward));
  const std::string said =
      said_by("rosrun pose_frame_binder estimate_time_offset --camera-latency 0 --forward " +
              forward + " --backward " + backward + " --scanner " + scanner);
  fs::remove_all(folder);  // kept for inspection if the command fails
  DelayTrial trial = figures_in(said);
  trial.truth = (truth_there + truth_back) / 2;
  return trial;
}

}  // namespace scan_cell_demo
