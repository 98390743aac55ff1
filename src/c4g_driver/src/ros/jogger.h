// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <scan_cell_msgs/Jog.h>

#include <mutex>
#include <optional>
#include <string>

#include "c4g_driver/client.h"

namespace c4g_driver {

/// Hold to run: the robot moves while ~jog messages arrive, and stops when they cease or say so. A
/// motion begins only after a message that the button is up. So none begins if the button was held
/// while this node started or the network was down, or after a stop for another reason. Works in
/// its own thread, so that other calls do not delay a stop.
class Jogger {
 public:
  /// @param silence [s] without a message after which the robot stops
  /// @param max_override [%] highest that a message may ask for
  Jogger(ros::NodeHandle node, Client& client, double silence, double max_override);
  ~Jogger();

  Jogger(const Jogger&) = delete;
  Jogger& operator=(const Jogger&) = delete;

 private:
  struct Wish {
    Jog jog;
    double override = 0;  // [%]
  };

  void hear(const scan_cell_msgs::Jog& message);
  std::optional<Wish> wish() const;
  void work();
  void begin(const Wish& wish);
  void end(bool held);
  std::string take_refusal();
  bool take_up();
  bool is_silent() const;
  void slow_down(double percent);
  void restore_speed();
  void stop();
  void tell(bool moving, const std::string& message);

  Client& client_;
  const double silence_;
  const double max_override_;
  ros::Publisher state_;

  mutable std::mutex mutex_;
  std::optional<Wish> wish_;
  std::string refusal_;  // of the latest message
  bool was_up_ = false;  // the button, since the last check
  ros::SteadyTime heard_;

  std::optional<Jog> under_way_;           // begun by this object
  bool stopping_ = false;                  // at the person's wish
  bool let_go_first_ = true;               // the button must be released before a motion begins
  std::optional<double> override_before_;  // [%]

  ros::CallbackQueue heard_queue_, work_queue_;
  ros::Subscriber subscriber_;
  ros::SteadyTimer timer_;
  ros::AsyncSpinner hearing_{1, &heard_queue_};
  ros::AsyncSpinner working_{1, &work_queue_};
};

}  // namespace c4g_driver
