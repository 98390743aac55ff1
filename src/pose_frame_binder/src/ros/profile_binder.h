// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/BindingAudit.h>
#include <scan_cell_msgs/BoundProfile.h>
#include <scan_cell_msgs/ScanRun.h>
#include <scan_cell_msgs/TriggerEvent.h>
#include <tf2_msgs/TFMessage.h>

#include <map>
#include <string>
#include <vector>

#include "pose_frame_binder/binder.h"

namespace pose_frame_binder {

/// Names of the poses' frames.
struct Frames {
  std::string fixed = "world";
  std::string base = "base_link";
  std::string flange = "tool0";
};

/// Adds each parameter with its meaning. Refuses a name that is empty or begins with a slash: no
/// transform would ever match it.
void describe(scan_cell_common::ParameterTable& table, Frames& frames);

/// Binder for messages: profiles in, profiles with a pose out.
class ProfileBinder {
 public:
  /// @param fixed_to_base pose of the base in the fixed frame
  /// @throw scan_cell_common::InvalidParameter as the checks of settings and frames
  ProfileBinder(const Settings& settings, const Frames& frames,
                const Eigen::Isometry3d& fixed_to_base);

  /// Announces the next arming, as Binder::start_run().
  /// @throw as run_from() and Binder::start_run()
  void start_run(const scan_cell_msgs::ScanRun& run);

  /// Takes from these the transforms from base to flange.
  /// @throw scan_cell_common::Refused if the allowed memory is full
  void add(const tf2_msgs::TFMessage& transforms);
  void add(const scan_cell_msgs::TriggerEvent& event);
  void add(const scan_cell_msgs::PeakProfileConstPtr& profile);

  Binder& binder() { return binder_; }
  const Binder& binder() const { return binder_; }

  /// Profiles bound since the last call, in the order of the frames; shared, to be published
  /// without a copy.
  std::vector<scan_cell_msgs::BoundProfileConstPtr> take();

 private:
  const Frames frames_;
  const Eigen::Isometry3d fixed_to_base_;
  Binder binder_;
  std::map<std::size_t, scan_cell_msgs::PeakProfileConstPtr> waiting_;
};

/// Converts the announcement of the next arming.
/// @param fixed_to_base pose of the base in the fixed frame
/// @throw scan_cell_common::Refused if its poses are in another frame or invalid
Run run_from(const scan_cell_msgs::ScanRun& run, const Frames& frames,
             const Eigen::Isometry3d& fixed_to_base);

/// Adds each parameter with its range, unit and meaning. Poses are read as by pose_from().
void describe(scan_cell_common::ParameterTable& table, ConstantSpeed& motion);

/// A pose from x, y, z [m], qx, qy, qz, qw, as given by parameters.
/// @throw scan_cell_common::InvalidParameter naming `name` if it is not a pose
Eigen::Isometry3d pose_from(const std::string& name, const std::vector<double>& numbers);

/// Why a profile cannot be used; empty if it can.
std::string find_fault(const scan_cell_msgs::PeakProfile& profile);

/// @param stamp end of the scan
scan_cell_msgs::BindingAudit to_message(const Audit& audit, const std::string& scan_id,
                                        const ros::Time& stamp);

/// For a person: how many frames were bound, and what happened to the others.
std::string summary(const Audit& audit);

}  // namespace pose_frame_binder
