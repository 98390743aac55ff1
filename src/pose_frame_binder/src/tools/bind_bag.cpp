// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <rosbag/view.h>
#include <tf2/buffer_core.h>
#include <tf2/exceptions.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>

#include "bag_scan.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/parameters/parameter_options.h"
#include "scan_cell_common/ros/bag_errors.h"
#include "scan_cell_common/ros/conversions.h"
#include "scan_cell_common/tools/tool_main.h"

namespace {

using scan_cell_common::name_bag_in_errors;
using scan_cell_common::UnusableInput;

struct Options {
  std::string bag;
  std::string output;
  pose_frame_binder::BagTopics topics;
  std::string static_transforms = "/tf_static";
  pose_frame_binder::Frames frames;
  pose_frame_binder::Settings settings;
  scan_cell_common::ParameterOptions typed;
};

Eigen::Isometry3d fixed_to_base(const rosbag::Bag& bag, const Options& options) {
  if (options.frames.fixed == options.frames.base) return Eigen::Isometry3d::Identity();
  tf2::BufferCore buffer;
  name_bag_in_errors(options.bag, [&] {
    rosbag::View view(bag, rosbag::TopicQuery(options.static_transforms));
    for (const rosbag::MessageInstance& message : view) {
      const auto transforms = message.instantiate<tf2_msgs::TFMessage>();
      if (!transforms) continue;
      for (const geometry_msgs::TransformStamped& transform : transforms->transforms)
        buffer.setTransform(transform, "bag", true);
    }
  });
  try {
    return scan_cell_common::from_ros(
        buffer.lookupTransform(options.frames.fixed, options.frames.base, ros::Time(0)).transform);
  } catch (const tf2::TransformException& error) {
    throw UnusableInput(
        options.bag, error.what(),
        "record " + options.static_transforms + ", or give --fixed-frame " + options.frames.base);
  }
}

/// Names the output in errors, since another bag is open at the same time.
template <class Message>
void write(rosbag::Bag& output, const std::string& topic, const ros::Time& time,
           const Message& message) {
  name_bag_in_errors(output.getFileName(), [&] { output.write(topic, time, message); });
}

void write_bound(pose_frame_binder::ProfileBinder& scan, rosbag::Bag& output, ros::Time& last) {
  for (const scan_cell_msgs::BoundProfileConstPtr& bound : scan.take()) {
    last = bound->header.stamp;
    write(output, "/pose_frame_binder/bound_profiles", last, bound);
  }
}

/// Binds the whole bag as one scan.
pose_frame_binder::Audit bind(const Options& options, rosbag::Bag& output) {
  rosbag::Bag bag;
  pose_frame_binder::open(bag, options.bag, rosbag::bagmode::Read);
  pose_frame_binder::ProfileBinder scan(options.settings, options.frames,
                                        fixed_to_base(bag, options));
  ros::Time last(1);  // a bag cannot hold a time of zero
  pose_frame_binder::feed(bag, options.topics, scan, [&] { write_bound(scan, output, last); });
  const pose_frame_binder::Audit audit = scan.binder().audit();
  if (audit.frames_bound == 0) {
    throw UnusableInput(options.bag, summary(audit),
                        "check that it holds " + options.topics.events + ", " +
                            options.topics.profiles + " and " + options.topics.poses);
  }
  const std::string scan_id = std::filesystem::path(options.bag).stem().string();
  write(output, "/pose_frame_binder/audit", last, to_message(audit, scan_id, last));
  return audit;
}

/// Writes the output whole or not at all.
void run(const Options& options) {
  pose_frame_binder::Audit audit;
  scan_cell_common::save_whole(options.output, [&](const std::string& partial) {
    rosbag::Bag output;
    pose_frame_binder::open(output, partial, rosbag::bagmode::Write);
    audit = bind(options, output);
    name_bag_in_errors(partial, [&] { output.close(); });
    return true;
  });
  std::cout << summary(audit) << '\n';
  for (const pose_frame_binder::Drop& drop : audit.dropped) {
    std::cout << name(drop.reason) << ": frame " << drop.frame_counter << ", pulse "
              << drop.trigger_count << ", " << drop.detail << '\n';
  }
}

void declare(CLI::App& app, Options& options, scan_cell_common::Outputs& outputs) {
  app.add_option("--bag", options.bag, "recorded scan")->required();
  outputs.add(app, "--output", options.output, "bag to write: bound profiles and audit")
      ->required();
  app.add_option("--events", options.topics.events, "topic of the trigger events")
      ->capture_default_str();
  app.add_option("--profiles", options.topics.profiles, "topic of the profiles")
      ->capture_default_str();
  app.add_option("--poses", options.topics.poses, "topic of the robot's transforms")
      ->capture_default_str();
  app.add_option("--static-transforms", options.static_transforms, "topic of the static transforms")
      ->capture_default_str();
  options.typed.add(app, options.frames);
  options.typed.add(app, options.settings,
                    {"method", "camera_latency", "pose_delay", "max_pose_gap"});
  options.typed.add(app, options.settings.constant_speed, {"start", "end", "speed", "frame_rate"});
  app.add_flag(
      "--object-moves", options.settings.constant_speed.object_moves,
      "for constant_speed: the object goes from start to end, the scanner stands at start");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Binds the frames of a recorded scan to poses, as the node does");
  Options options;
  scan_cell_common::Outputs outputs;
  declare(app, options, outputs);
  return scan_cell_common::tool_main(
      "bind_bag", app, argc, argv,
      [&] {
        options.typed.read(options.frames);
        options.typed.read(options.settings);
        options.typed.read(options.settings.constant_speed);
        run(options);
        return 0;
      },
      scan_cell_common::kUnusable, outputs);
}
