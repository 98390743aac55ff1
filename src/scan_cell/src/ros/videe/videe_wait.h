// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/client/simple_action_client.h>
#include <ros/ros.h>

#include <string>

#include "scan_cell_common/errors/errors.h"
#include "videe/videe_server.h"

namespace scan_cell {

/// [s] for what was cancelled to be made safe and its data to be kept
constexpr double kCancelTimeout = 15;  // as cell_client.cpp's

/// @throw ConnectionError if there is no server within `timeout` [s]
template <class Client>
void wait_for_server(Client& client, const std::string& name, double timeout) {
  if (client.waitForServer(ros::Duration(timeout))) return;
  throw scan_cell_common::ConnectionError(name, "no action server", "is scan_cell_node running?");
}

/// Waits until the server has taken a goal that was sent to it.
/// @throw Refused with the server's own message where it rejects it
/// @throw ConnectionError if it says nothing within `timeout` [s]
template <class Client>
void wait_until_taken(Client& client, const std::string& name, double timeout) {
  using State = actionlib::SimpleClientGoalState;
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(timeout);
  while (client.getState() == State::PENDING) {
    if (ros::WallTime::now() > deadline) {
      client.cancelGoal();
      throw scan_cell_common::ConnectionError(name, "does not take the goal", "look at its log");
    }
    ros::WallDuration(0.01).sleep();
  }
  if (client.getState() != State::REJECTED) return;
  throw scan_cell_common::Refused(name, "refused", client.getResult()->message);
}

/// Cancels the goal under way and waits for its end.
/// @throw ConnectionError if it does not come
template <class Client>
void cancel_and_wait(Client& client, const std::string& name) {
  client.cancelGoal();
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(kCancelTimeout);
  while (!client.waitForResult(ros::Duration(0.02)) && client.isServerConnected()) {
    if (ros::WallTime::now() < deadline) continue;
    throw scan_cell_common::ConnectionError(name, "does not end although it was cancelled",
                                            "look at its log");
  }
}

/// Waits for a goal's end on behalf of a ViDeE client.
/// @param running whether the goal is under way; true on return only where the client went away
/// @throw ConnectionError if that client, or the action's server, goes away
template <class Client>
auto wait_for_result(Client& client, const std::string& name,
                     const VideeServer::ClientThere& client_there, bool& running) {
  using scan_cell_common::ConnectionError;
  while (!client.waitForResult(ros::Duration(0.02))) {
    if (!client_there()) throw ConnectionError("ViDeE client", "gone", "connect again");
    if (!ros::ok() || !client.isServerConnected()) {
      running = false;
      throw ConnectionError(name, "the action server went away", "look at its log");
    }
  }
  running = false;
  if (client.getState() == actionlib::SimpleClientGoalState::LOST) {
    throw ConnectionError(name, "lost the goal; it was probably restarted", "look at its log");
  }
  return client.getResult();
}

}  // namespace scan_cell
