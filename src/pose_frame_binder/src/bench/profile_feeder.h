// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <thread>
#include <vector>

namespace pose_frame_binder {

using Instant = std::chrono::steady_clock::time_point;

struct Pace {
  double seconds = 60;
  double rate = 485;        //!< [profiles/s]
  std::size_t rows = 1710;  //!< each with a peak
  double pose_rate = 500;   //!< [Hz]

  std::uint64_t frames() const { return static_cast<std::uint64_t>(seconds * rate); }
};

/// Plays camera, trigger and robot in real time, in its own thread: /profiles, /trigger_events and
/// /tf, each message at its time. Poses continue until it is destroyed.
class ProfileFeeder {
 public:
  ProfileFeeder(ros::NodeHandle node, const Pace& pace);
  ~ProfileFeeder();

  void start();
  bool profiles_heard() const;  /// < whether /profiles has a subscriber
  bool all_heard() const;
  bool done() const { return done_; }  /// < whether the last frame was sent

  /// When each profile was published; read it when done.
  const std::vector<Instant>& sent() const { return sent_; }
  double seconds_late() const { return late_; }  ///< the worst; read it when done
  double cpu() const { return cpu_; }            ///< [s] of its thread so far

 private:
  void feed();
  double time_of(std::uint64_t pulse) const;
  void send_pose(double time);
  void send_event(std::uint64_t number);
  void send_profile(std::uint64_t number);

  const Pace pace_;
  ros::Publisher profiles_;
  ros::Publisher events_;
  ros::Publisher poses_;
  std::vector<std::vector<float>> lines_;
  ros::Time begin_;  // stamp of the first pulse
  std::vector<Instant> sent_;
  double late_ = 0;
  std::atomic<double> cpu_{0};
  std::atomic<bool> done_{false};
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace pose_frame_binder
