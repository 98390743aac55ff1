// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

#include <atomic>
#include <vector>

#include "profile_feeder.h"
#include "scan_cell_common/testing/child_process.h"

namespace pose_frame_binder {

/// Records how many things (points, profiles) arrive and when, in its own thread.
class Arrivals {
 public:
  struct Arrival {
    Instant time;
    std::uint64_t count;  // including all before it
  };

  template <class Message, class Count>
  void subscribe(ros::NodeHandle node, const std::string& topic, const Count& count_in) {
    using Pointer = boost::shared_ptr<const Message>;
    constexpr std::uint32_t kUnbounded = 0;  // messages
    node.setCallbackQueue(&queue_);
    const boost::function<void(const Pointer&)> on_message = [this,
                                                              count_in](const Pointer& message) {
      count_ += count_in(*message);
      all_.push_back({std::chrono::steady_clock::now(), count_});
      cpu_ = scan_cell_common::cpu_of_this_thread();
    };
    subscriber_ = node.subscribe<Message>(topic, kUnbounded, on_message, ros::VoidConstPtr(),
                                          ros::TransportHints().tcpNoDelay());
    spinner_.start();
  }

  bool subscribed() const { return subscriber_.getNumPublishers() > 0; }

  /// @return whether that many arrived with no pause of two seconds
  bool wait(std::uint64_t count) const;

  std::uint64_t count() const { return count_; }
  double cpu() const { return cpu_; }                       ///< [s] of its thread so far
  const std::vector<Arrival>& all() const { return all_; }  ///< read it when all have arrived

 private:
  ros::CallbackQueue queue_;
  std::vector<Arrival> all_;
  std::atomic<std::uint64_t> count_{0};
  std::atomic<double> cpu_{0};
  ros::Subscriber subscriber_;
  ros::AsyncSpinner spinner_{1, &queue_};
};

/// [s] from sending a profile to the arrival of its last point or profile.
struct Latency {
  double median = 0, p99 = 0, worst = 0, last = 0;
};

/// @param per_profile number of counted things per profile
/// @throw scan_cell_common::Refused if not all arrived
Latency latency_of(const std::vector<Instant>& sent, const std::vector<Arrivals::Arrival>& arrivals,
                   std::uint64_t per_profile);

}  // namespace pose_frame_binder
