// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <scan_cell_msgs/DesignPath.h>
#include <visualization_msgs/Marker.h>

#include <QObject>
#include <QString>
#include <atomic>
#include <memory>

#include "link/node_names.h"
#include "link/worker.h"

namespace scan_cell_rviz {

/// The connection for making a path on a reference. As in CellLink, nothing blocks, and the node
/// may go away and come back.
class DesignLink : public QObject {
  Q_OBJECT

 public:
  explicit DesignLink(const NodeNames& names);
  ~DesignLink() override;

  /// Starts sending signals: connect them before.
  void start();

  /// Answered by designed or refused. Of the requests that wait for an earlier answer, only the
  /// latest and those to be saved are sent.
  void design(const scan_cell_msgs::DesignPathRequest& request);

 Q_SIGNALS:
  void designed(scan_cell_msgs::DesignPathRequest request,
                scan_cell_msgs::DesignPathResponse answer);
  void refused(QString message);
  void referenceCame(visualization_msgs::MarkerConstPtr reference);  ///< corners of its triangles

 private:
  const NodeNames names_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::Subscriber reference_;
  std::atomic<int> latest_{0};  // of the requests
  std::unique_ptr<Worker> worker_ = std::make_unique<Worker>();
  ros::AsyncSpinner spinner_;
};

}  // namespace scan_cell_rviz
