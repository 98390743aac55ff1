// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <scan_cell_msgs/Jog.h>
#include <scan_cell_msgs/JogState.h>
#include <sensor_msgs/JointState.h>

#include <QObject>
#include <QString>
#include <memory>
#include <mutex>
#include <vector>

#include "link/node_names.h"
#include "link/worker.h"

namespace scan_cell_rviz {

/// The connection for teaching: moving the robot by buttons, and recording poses. As in CellLink,
/// nothing blocks, and any node may go away and come back.
class TeachLink : public QObject {
  Q_OBJECT

 public:
  explicit TeachLink(const NodeNames& names);
  ~TeachLink() override;

  /// Starts sending signals: connect them before.
  void start();

  /// Whether the driver is there. Others may subscribe to jog(), so the driver's own topic counts.
  bool has_driver() const { return state_.getNumPublishers() > 0 && jog_.getNumSubscribers() > 0; }

  /// Sends one message at once, from the caller's thread. The robot moves while messages come.
  void jog(const scan_cell_msgs::Jog& message) { jog_.publish(message); }

  /// Appends the flange's pose to a file on the cell's computer. Answered by recorded or failed.
  void record(const QString& file);

 Q_SIGNALS:
  void jogTold(scan_cell_msgs::JogState state);
  void jointsCame(std::vector<double> positions);  ///< [rad] ten times a second
  void recorded(QString message);
  void failed(QString message);

 private:
  void tell_joints();

  const NodeNames names_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::Publisher jog_;
  ros::Subscriber state_, joints_;
  ros::WallTimer timer_;
  sensor_msgs::JointStateConstPtr latest_;
  std::unique_ptr<Worker> worker_ = std::make_unique<Worker>();
  ros::AsyncSpinner spinner_;
};

}  // namespace scan_cell_rviz
