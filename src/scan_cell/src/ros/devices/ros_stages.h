// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/service_client.h>
#include <scan_cell_msgs/BindingAudit.h>
#include <scan_cell_msgs/CloudStatistics.h>
#include <scan_cell_msgs/ScanRun.h>
#include <sensor_msgs/PointCloud2.h>

#include <string>
#include <vector>

#include "scan_cell/scan_run.h"
#include "sequence/devices.h"

namespace scan_cell {

/// Binder and triangulation behind nodes with the interfaces of pose_frame_binder and
/// laser_triangulation.
class RosStages : public Stages {
 public:
  /// @param binder node with ~start, ~check_run, ~start_run and ~finish
  /// @param triangulation node with ~start, ~check_run and ~finish
  /// @param call_timeout [s] longest a call may take beyond its wait for late data
  /// @param base_frame of the robot's poses, for check_run() and start_run()
  RosStages(const std::string& binder, const std::string& triangulation, double call_timeout,
            const std::string& base_frame = "");

  std::string trouble() const override;
  void start(const std::string& scan_id) override;
  void check_run(const ScanRun& run) override;
  void start_run(const ScanRun& run) override;
  /// @throw scan_cell_common::Refused naming a pass without a bound frame, and why
  std::vector<std::uint64_t> bind(const std::vector<ArmingPulses>& armings,
                                  double patience) override;
  void triangulate(bool whole, double patience) override;
  std::string disagreement() const override;

  /// Forgets the results of the last scan.
  void clear();

  /// Audit of the latest scan, even if it failed; empty after clear() or start().
  const scan_cell_msgs::BindingAudit& audit() const { return audit_; }
  const std::string& binding() const { return binding_; }  //!< the audit for a person
  const scan_cell_msgs::CloudStatistics& statistics() const { return statistics_; }
  const sensor_msgs::PointCloud2& cloud() const { return cloud_; }
  /// File with the cloud if it is too large for a message; else empty.
  const std::string& cloud_file() const { return cloud_file_; }

 private:
  void check_each_bound(const std::vector<ArmingPulses>& armings) const;
  scan_cell_msgs::ScanRun message_of(const ScanRun& run) const;
  double longest(double patience) const;  // [s] that a call may take
  std::string finish_binding() const { return binder_ + "/finish"; }
  std::string finish_cloud() const { return triangulation_ + "/finish"; }

  const std::string binder_;
  const std::string triangulation_;
  const double call_timeout_;
  const std::string base_frame_;
  ros::Publisher told_;             // ~runs, as announced to the binder
  std::string scan_id_;             // since start()
  std::vector<std::string> runs_;   // their names, since start()
  bool under_way_ = false;          // from start() to bind()
  ros::ServiceClient binder_line_;  // held from start() on: it breaks if the node dies
  ros::ServiceClient triangulation_line_;
  scan_cell_msgs::BindingAudit audit_;
  std::string binding_;
  scan_cell_msgs::CloudStatistics statistics_;
  sensor_msgs::PointCloud2 cloud_;
  std::string cloud_file_;
};

}  // namespace scan_cell
