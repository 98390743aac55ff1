// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "scan_cell_common/pose/timed_pose.h"

namespace pose_frame_binder {

using scan_cell_common::Nanoseconds;
using scan_cell_common::TimedPose;

/// One unbound scan: the data of robot and camera, each on its own clock.
struct UnboundScan {
  struct Line {
    Nanoseconds time = 0;                 //!< of the pulse
    std::vector<Eigen::Vector3d> points;  //!< [m] in the frame of the flange
  };
  std::vector<TimedPose> poses;  //!< of the flange, in time order
  std::vector<Line> lines;
};

struct TimeOffsetSettings {
  double max_delay = 0.1;         //!< [s] largest offset searched, of either sign
  double max_distance = 0.01;     //!< [m] between points of the two scans that may be paired
  double max_pose_gap = 0.05;     //!< [s]
  double min_relief = 0.1;        //!< sine of the least slope along the motion that counts
  double max_uncertainty = 1e-3;  //!< [s] one standard deviation
};

struct TimeOffset {
  double pose_delay = 0;  //!< [s] by which the poses are stamped too late; see Settings::pose_delay
  double uncertainty = 0;     //!< [s] one standard deviation, the larger of the next two
  double from_posterior = 0;  //!< [s] assuming independent residuals
  double from_residuals = 0;  //!< [s] from the disagreement of blocks of the scene (jackknife)
  std::size_t pairs = 0;      //!< points of one scan with a partner in the other
  std::size_t on_relief = 0;  //!< pairs on slopes along the motion
  double apart_before = 0;    //!< [m] r.m.s. distance of the scans as bound
  double apart_after = 0;     //!< [m] the same with the offset removed
};

/// The delay between the poses and the pulses, from two scans of one scene in opposite directions:
/// a late pose carries the points along with the motion, so the two clouds lie apart by twice speed
/// x delay. Robust point-to-plane (Chen and Medioni 1992, Tukey's weights) over the delay and a
/// small shift across the motion, so that an error of robot or calibration across the motion is not
/// mistaken for a delay. Backlash along the motion is mistaken for one, but does not grow with the
/// speed.
/// @throw scan_cell_common::UnusableInput if a scan is empty, the scans do not overlap, do not go
/// in opposite directions, or the scene has no relief along the motion
TimeOffset estimate_time_offset(const UnboundScan& forward, const UnboundScan& backward,
                                const TimeOffsetSettings& settings = {});

}  // namespace pose_frame_binder
