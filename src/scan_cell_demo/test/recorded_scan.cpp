// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "recorded_scan.h"

#include <ros/package.h>
#include <rosbag/bag.h>
#include <scan_cell_msgs/CellState.h>
#include <scan_cell_msgs/PeakProfile.h>
#include <scan_cell_msgs/ScanRun.h>
#include <scan_cell_msgs/TriggerEvent.h>
#include <tf2_msgs/TFMessage.h>

#include <memory>

#include "scan_cell/scan_program.h"
#include "scan_cell_common/ros/conversions.h"
#include "scan_cell_sim/cell.h"
#include "scan_cell_sim/laser_line_renderer.h"
#include "tecnogamma_camera/peak_detector.h"

namespace scan_cell_demo {
namespace {

constexpr double kSpeed = 0.12;        // [m/s]
constexpr double kPosePeriod = 0.004;  // [s]
constexpr double kPulsePeriod = 0.01;  // [s]
constexpr double kMargin = 0.05;       // [s] of poses before the first pulse and after the last
constexpr int kLostEvery = 37;

std::string sim(const std::string& name) {
  return ros::package::getPath("scan_cell_sim") + "/config/" + name;
}

class Recorder {
 public:
  Recorder(const std::string& bag, const std::string& world, double start)
      : start_(start),
        bag_(bag, rosbag::bagmode::Write),
        scene_(scan_cell_sim::load_world(world)),
        renderer_(scan_cell_common::load_scanner_model(sim("scanner.yaml")), {}),
        base_(scan_cell_sim::load_base_link_in_world(sim("cell.yaml"))),
        pass_(scan_cell::load_scan_program(ros::package::getPath("scan_cell") +
                                           "/config/scan_line.yaml")
                  .passes.front()) {}

  double duration() const {
    return (pass_.poses.back().translation() - pass_.poses.front().translation()).norm() / kSpeed;
  }

  void write_state(double time, std::uint8_t state, const std::string& scan_id) {
    scan_cell_msgs::CellState message;
    message.state = state;
    message.scan_id = scan_id;
    write("/scan_cell/state", time, message);
  }

  /// The trigger's only arming belongs to the fourth pass.
  void write_run(double time, const std::string& scan_id) {
    scan_cell_msgs::ScanRun message;
    message.scan_id = scan_id;
    message.pass_index = 3;
    write("/scan_cell/runs", time, message);
  }

  void write_pose(double time) {
    geometry_msgs::TransformStamped pose;
    pose.header.stamp = ros::Time(start_ + time);
    pose.header.frame_id = "base_link";
    pose.child_frame_id = "tool0";
    pose.transform = scan_cell_common::to_ros_transform(base_.inverse() * flange(time));
    tf2_msgs::TFMessage message;
    message.transforms.push_back(pose);
    write("/tf", time, message);
  }

  void write_pulse(double time, std::uint64_t count) {
    scan_cell_msgs::TriggerEvent event;
    event.header.stamp = ros::Time(start_ + time);
    event.arming = 1;
    event.count = count;
    event.lasers = scan_cell_msgs::TriggerEvent::LASER_0;
    write("/laser_trigger/events", time, event);
    if (count % kLostEvery == 0) return;
    write("/camera/profiles", time + 0.003, profile(time, count));
  }

 private:
  template <class Message>
  void write(const std::string& topic, double time, const Message& message) {
    bag_.write(topic, ros::Time(start_ + time), message);
  }

  Eigen::Isometry3d flange(double time) const {
    return scan_cell_common::interpolate(pass_.poses.front(), pass_.poses.back(),
                                         time / duration());
  }

  scan_cell_msgs::PeakProfile profile(double time, std::uint64_t count) {
    const scan_cell_sim::Region region{336, 599, 1024, 512};
    scan_cell_sim::Exposure exposure;
    exposure.camera = flange(time) * renderer_.scanner().flange_to_camera;
    exposure.lasers = scan_cell_msgs::TriggerEvent::LASER_0;
    exposure.frame = count;
    pixels_.resize(static_cast<std::size_t>(region.width) *
                   static_cast<std::size_t>(region.height));
    renderer_.render(scene_, exposure, region, pixels_.data());
    tecnogamma_camera::PeakProfile peaks;
    detector_->detect(tecnogamma_camera::ImageView8{pixels_.data(), region.width, region.height,
                                                    region.width, region.x, region.y},
                      peaks);
    scan_cell_msgs::PeakProfile message;
    message.header.stamp = ros::Time(start_ + time);
    message.header.frame_id = "camera_optical_frame";
    message.acquisition = 1;
    message.frame_counter = 65400 + count;
    message.device_time = static_cast<std::uint64_t>(time * 1e9) + 1;
    message.laser = scan_cell_msgs::PeakProfile::LASER_UNKNOWN;
    message.first_row = static_cast<std::uint32_t>(peaks.first_row);
    message.position = peaks.position;
    message.width = peaks.width;
    message.intensity = peaks.intensity;
    return message;
  }

  const double start_;
  rosbag::Bag bag_;
  scan_cell_sim::Scene scene_;
  scan_cell_sim::LaserLineRenderer renderer_;
  Eigen::Isometry3d base_;
  scan_cell::ScanPass pass_;
  std::unique_ptr<tecnogamma_camera::PeakDetector> detector_ =
      tecnogamma_camera::make_detector("fir_derivative", {});
  std::vector<std::uint8_t> pixels_;
};

}  // namespace

void record_scan(const std::string& bag, const std::string& scan_id, const std::string& world,
                 double start) {
  Recorder recorder(bag, world, start);
  const auto poses = static_cast<int>(recorder.duration() / kPosePeriod);
  const auto pulses = static_cast<int>((recorder.duration() - 2 * kMargin) / kPulsePeriod);
  recorder.write_run(0, scan_id);
  recorder.write_state(0, scan_cell_msgs::CellState::SCANNING, scan_id);
  for (int i = 0; i < poses; ++i)
    recorder.write_pose(i * kPosePeriod);
  for (int i = 0; i < pulses; ++i) {
    recorder.write_pulse(kMargin + i * kPulsePeriod, static_cast<std::uint64_t>(i) + 1);
  }
  recorder.write_state(recorder.duration() + 0.1, scan_cell_msgs::CellState::FINISHED, scan_id);
}

}  // namespace scan_cell_demo
