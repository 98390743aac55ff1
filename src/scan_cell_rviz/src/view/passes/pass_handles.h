// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <visualization_msgs/MarkerArray.h>

#include <QObject>
#include <string>

#include "passes/pass_session.h"
#include "view/handle_server.h"

namespace scan_cell_rviz {

/// Markers of the passes: blue where the robot can scan them, red, thick and with the reason where
/// it cannot, grey where this is unknown. Arcs are drawn as arcs.
visualization_msgs::MarkerArray pass_markers(const PassSession& session);

/// Shows the passes in the view, on the topic ~passes of this node, with arrows and rings at each
/// pose of the chosen pass: interactive markers on ~pass_poses.
class PassHandles : public QObject {
  Q_OBJECT

 public:
  explicit PassHandles(PassSession& session);

  void show(bool shown);
  const std::string& topic() const { return topic_; }             ///< of the markers
  const std::string& handles() const { return server_.topic(); }  ///< of the interactive markers

 private:
  using Feedback = visualization_msgs::InteractiveMarkerFeedbackConstPtr;

  void draw();
  void draw_handles();
  void on_feedback(std::size_t pass, std::size_t pose, const Feedback& feedback);

  PassSession& session_;
  const std::string topic_;
  bool shown_ = false;
  ros::NodeHandle node_;
  ros::Publisher passes_;
  HandleServer server_;
};

}  // namespace scan_cell_rviz
