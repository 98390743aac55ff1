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

/// Held to run: the robot moves while ~jog comes, and stops where it ends or says so. It begins
/// only behind a message that says that the button is up: so it does not when this node was
/// started, or the network was gone, while somebody held the button, nor after it stopped for
/// another reason. Works in its own thread: calls of others do not keep it from stopping.
class Jogger {
 public:
  /// @param silence [s] without a message after which the robot stops
  /// @param max_override [%] that a message may ask for
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
  std::string refusal_;  // of the message that came last
  bool was_up_ = false;  // the button, since that was looked at last
  ros::SteadyTime heard_;

  std::optional<Jog> under_way_;           // that this object began
  bool stopping_ = false;                  // because the person wants it
  bool let_go_first_ = true;               // before it may begin
  std::optional<double> override_before_;  // [%]

  ros::CallbackQueue heard_queue_, work_queue_;
  ros::Subscriber subscriber_;
  ros::SteadyTimer timer_;
  ros::AsyncSpinner hearing_{1, &heard_queue_};
  ros::AsyncSpinner working_{1, &work_queue_};
};

}  // namespace c4g_driver
