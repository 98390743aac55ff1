// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <string>

#include "scan_cell_common/ros/goal_client.h"
#include "videe/videe_server.h"

namespace scan_cell {

/// [s] to make a cancelled goal safe and keep its data
constexpr double kCancelTimeout = 15;  // as in cell_client.cpp

/// Sends a goal and waits until the server has accepted it.
/// @throw Refused with the server's own message if it rejects the goal
/// @throw ConnectionError if there is no server, or no answer, within `timeout` [s]
template <class Client>
void send_goal(Client& client, const std::string& name, const typename Client::Goal& goal,
               double timeout) {
  using actionlib::TerminalState;
  client.send(goal);
  client.wait_until_taken(timeout);
  const auto end = client.end();
  if (!end || end->state != TerminalState::REJECTED) return;
  throw scan_cell_common::Refused(name, "refused",
                                  end->result ? end->result->message : end->state.getText());
}

/// @throw ConnectionError if there is no server within `timeout` [s]
template <class Client>
void wait_for_server(const Client& client, const std::string& name, double timeout) {
  if (client.wait_for_server(timeout)) return;
  throw scan_cell_common::ConnectionError(name, "no action server", "is scan_cell_node running?");
}

/// Cancels the goal in progress and waits for its end.
/// @throw ConnectionError if it does not end
template <class Client>
void cancel_and_wait(Client& client, const std::string& name) {
  client.cancel();
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(kCancelTimeout);
  while (!client.wait_for_end(0.02) && client.is_connected()) {
    if (ros::WallTime::now() < deadline) continue;
    throw scan_cell_common::ConnectionError(name, "did not end after it was cancelled",
                                            "look at its log");
  }
}

/// Waits for a goal's end on behalf of a ViDeE client.
/// @param running whether the goal is in progress; true on return only if the client went away
/// @throw ConnectionError if that client, or the action's server, goes away
template <class Client>
typename Client::ResultConstPtr wait_for_result(const Client& client, const std::string& name,
                                                const VideeServer::ClientThere& client_there,
                                                bool& running) {
  using scan_cell_common::ConnectionError;
  auto end = client.wait_for_end(0);
  for (; !end; end = client.wait_for_end(0.02)) {
    if (!client_there()) throw ConnectionError("ViDeE client", "gone", "connect again");
    if (!ros::ok() || !client.is_connected()) {
      running = false;
      throw ConnectionError(name, "the action server went away", "look at its log");
    }
  }
  running = false;
  if (end->result) return end->result;
  throw ConnectionError(name, "lost the goal; it was probably restarted", "look at its log");
}

}  // namespace scan_cell
