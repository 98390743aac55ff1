// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "profile_feeder.h"

#include <scan_cell_msgs/PeakProfile.h>
#include <scan_cell_msgs/TriggerEvent.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <cmath>

#include "scan_cell_common/testing/child_process.h"

namespace pose_frame_binder {
namespace {

constexpr double kLatency = 0.004;      // [s] of the frames after their pulses; chosen
constexpr double kPosesBefore = 0.5;    // [s] before the first pulse; chosen
constexpr std::size_t kLines = 100;     // different ones, in turn; chosen
constexpr std::uint32_t kQueue = 2000;  // messages: four seconds of frames; chosen

std::chrono::nanoseconds nanoseconds(double seconds) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
      std::chrono::duration<double>(seconds));
}

/// Lines [px] that bend and jump as on a moulding, and travel over the sensor.
std::vector<std::vector<float>> lines(std::size_t rows) {
  std::vector<std::vector<float>> positions(kLines, std::vector<float>(rows));
  for (std::size_t line = 0; line < kLines; ++line) {
    for (std::size_t row = 0; row < rows; ++row) {
      const double step = row % 400 < 200 ? 40 : 0;
      const double bend = 30 * std::sin(static_cast<double>(row) / 90);
      positions[line][row] = static_cast<float>(600 + 4 * static_cast<double>(line) + step + bend);
    }
  }
  return positions;
}

}  // namespace

ProfileFeeder::ProfileFeeder(ros::NodeHandle node, const Pace& pace)
    : pace_(pace), lines_(lines(pace.rows)) {
  profiles_ = node.advertise<scan_cell_msgs::PeakProfile>("/profiles", kQueue);
  events_ = node.advertise<scan_cell_msgs::TriggerEvent>("/trigger_events", kQueue);
  poses_ = node.advertise<tf2_msgs::TFMessage>("/tf", kQueue);
  sent_.reserve(pace.frames());
}

ProfileFeeder::~ProfileFeeder() {
  stop_ = true;
  if (thread_.joinable()) thread_.join();
}

bool ProfileFeeder::profiles_heard() const {
  return profiles_.getNumSubscribers() > 0;
}

bool ProfileFeeder::all_heard() const {
  return profiles_heard() && events_.getNumSubscribers() > 0 && poses_.getNumSubscribers() > 0;
}

void ProfileFeeder::start() {
  thread_ = std::thread([this] { feed(); });
}

void ProfileFeeder::feed() {
  begin_ = ros::Time::now() + ros::Duration(kPosesBefore);
  const Instant begin = std::chrono::steady_clock::now() + nanoseconds(kPosesBefore);
  double pose = -kPosesBefore;
  std::uint64_t pulse = 0, frame = 0;
  const std::uint64_t frames = pace_.frames();
  while (!stop_) {
    const double next_pulse = pulse < frames ? time_of(pulse) : HUGE_VAL;
    const double next_frame = frame < frames ? time_of(frame) + kLatency : HUGE_VAL;
    const double next = std::min({pose, next_pulse, next_frame});
    std::this_thread::sleep_until(begin + nanoseconds(next));
    if (next == pose) {
      send_pose(pose);
      pose += 1 / pace_.pose_rate;
    } else if (next == next_pulse) {
      send_event(pulse++);
    } else {
      sent_.push_back(std::chrono::steady_clock::now());
      const std::chrono::duration<double> late = sent_.back() - begin - nanoseconds(next);
      late_ = std::max(late_, late.count());
      send_profile(frame++);
      done_ = frame == frames;
    }
    cpu_ = scan_cell_common::cpu_of_this_thread();
  }
}

/// Time of a pulse [s] after the start. The first intervals are twice as long, as from the trigger
/// when lasers alternate.
double ProfileFeeder::time_of(std::uint64_t pulse) const {
  constexpr std::uint64_t kLong = 4;  // intervals; docs/laser_trigger.md
  return static_cast<double>(pulse + std::min(pulse, kLong)) / pace_.rate;
}

void ProfileFeeder::send_pose(double time) {
  constexpr double kSpeed = 0.1;  // [m/s] chosen
  const auto message = boost::make_shared<tf2_msgs::TFMessage>();
  geometry_msgs::TransformStamped& transform = message->transforms.emplace_back();
  transform.header.stamp = begin_ + ros::Duration(time);
  transform.header.frame_id = "base_link";
  transform.child_frame_id = "tool0";
  transform.transform.translation.y = kSpeed * time;
  transform.transform.translation.z = 1;
  transform.transform.rotation.w = 1;
  poses_.publish(message);
}

void ProfileFeeder::send_event(std::uint64_t number) {
  const auto message = boost::make_shared<scan_cell_msgs::TriggerEvent>();
  message->header.stamp = begin_ + ros::Duration(time_of(number));
  message->arming = 1;
  message->count = number + 1;
  message->lasers = number % 2 == 0 ? scan_cell_msgs::TriggerEvent::LASER_0
                                    : scan_cell_msgs::TriggerEvent::LASER_1;
  events_.publish(message);
}

void ProfileFeeder::send_profile(std::uint64_t number) {
  constexpr float kWidth = 5, kIntensity = 100;  // [px], [grey value] chosen
  const auto message = boost::make_shared<scan_cell_msgs::PeakProfile>();
  message->header.stamp = begin_ + ros::Duration(time_of(number) + kLatency);
  message->acquisition = 1;
  message->frame_counter = number;
  message->laser = scan_cell_msgs::PeakProfile::LASER_UNKNOWN;
  message->position = lines_[number % kLines];
  message->width.assign(pace_.rows, kWidth);
  message->intensity.assign(pace_.rows, kIntensity);
  profiles_.publish(message);
}

}  // namespace pose_frame_binder
