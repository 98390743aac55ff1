// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "scan_cell_common/pose/timed_pose.h"

namespace scan_cell_common {
class ParameterTable;
}

namespace pose_frame_binder {

using scan_cell_common::Nanoseconds;
using scan_cell_common::TimedPose;

/// How a pulse gets its pose (docs/pose_frame_binder.md). Values as in BindingAudit.
enum class Method : std::uint8_t { kFirstPose = 1, kInterpolate = 2, kConstantSpeed = 3 };

/// Which rule made a match. Values as in PoseMatch.
enum class Rule : std::uint8_t {
  kOneToOne = 1,
  kFramesSharePose = 2,
  kPosesShareFrame = 3,
  kInterpolated = 4,
  kConstantSpeed = 5,
};

/// Why a frame is not bound. Values as in DroppedFrame.
enum class DropReason : std::uint8_t {
  kNoTrigger = 1,
  kNoPoseBefore = 2,
  kNoPoseAfter = 3,
  kPoseGap = 4,
  kSharedPose = 5,
  kRepeated = 6,
  kOutOfOrder = 7,
  kCorrupt = 8,
  kNeverArrived = 9,
  kCounterSlip = 10,
  kLaserUncertain = 11,
};

/// Its name, such as "shared_pose".
const char* name(DropReason reason);

/// The camera cannot tell the laser. Value as in PeakProfile.
constexpr std::uint8_t kLaserUnknown = 255;

/// One pulse that was sent to the camera, host time.
struct Pulse {
  Nanoseconds time = 0;      //!< of the rising edge
  std::uint32_t arming = 0;  //!< number of the trigger's arming
  std::uint64_t count = 0;   //!< within the arming, from 1
  std::uint8_t lasers = 0;   //!< mask of the lasers that were on with it, bit 0: laser_0
};

/// What the binder needs to know about a frame.
struct Frame {
  std::uint32_t acquisition = 0;       //!< number of the camera's start
  std::uint64_t counter = 0;           //!< unwrapped
  Nanoseconds stamp = 0;               //!< of the exposure, host time; late by a constant latency
  std::string corrupt;                 //!< why it cannot be used; empty: it can
  std::uint8_t laser = kLaserUnknown;  //!< index, if the camera tells it
};

/// A motion along a line at constant speed (thesis, section 6.1). The first pulse of an arming is
/// at its start, the others follow at a constant frame rate. None of it is measured.
struct ConstantSpeed {
  Eigen::Isometry3d start = none();  //!< pose of the flange in the frame of the poses
  Eigen::Isometry3d end = none();    //!< the same at the end
  double speed = 0;                  //!< [m/s]
  double frame_rate = 0;             //!< [Hz]
  bool object_moves = false;         //!< a conveyor carries it from start to end; scanner at start

  /// A pose of NaN: not given.
  static Eigen::Isometry3d none() {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.matrix().setConstant(std::numeric_limits<double>::quiet_NaN());
    return pose;
  }

  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

/// What is known of an arming of the trigger in advance.
struct Run {
  std::uint32_t pass = 0;  //!< of the scan, from 0
  /// For constant_speed if the settings give no motion. None: not a line at a constant speed.
  std::optional<ConstantSpeed> motion;
};

/// Parameters that decide which frame gets which pose.
struct Settings {
  Method method = Method::kInterpolate;  //!< how a pulse gets its pose
  double max_pose_gap = 0.05;     //!< [s] between the poses around a pulse; first pose: to the pose
  double pose_settle = 0.02;      //!< [s] how far a pose may arrive behind a later one
  double pose_delay = 0;          //!< [s] by which the poses are stamped too late
  double camera_latency = 0.004;  //!< [s] frame's stamp - pulse, as expected
  double latency_tolerance = 0.02;          //!< [s] at most; never above 0.45 of the pulse interval
  int frames_to_agree = 3;                  //!< frames that fix the counter's offset
  double max_acceleration = 10;             //!< [m/s^2] of the flange, for the error bound
  double max_speed = 1.5;                   //!< [m/s] of the flange, for the error bound
  std::size_t max_poses = 2'000'000;        //!< held in memory (170 bytes each)
  std::size_t max_pending_frames = 20'000;  //!< waiting for pulses or poses
  ConstantSpeed constant_speed;             //!< for that method only; not given: from start_run()

  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

/// Adds each parameter with its range, unit and meaning, except those of constant_speed.
void describe(scan_cell_common::ParameterTable& table, Settings& settings);

/// @throw scan_cell_common::InvalidParameter naming what is out of range, or if the method's motion
/// is not fully determined
void check(const Settings& settings);

/// @throw scan_cell_common::InvalidParameter if the motion is not fully determined
void check(const ConstantSpeed& motion);

/// @throw scan_cell_common::Refused, InvalidParameter if the settings' method cannot bind the run;
/// a motion in the settings belongs to pass 0
void check(const Run& run, const Settings& settings);

/// Whether any part of it was given.
bool is_given(const ConstantSpeed& motion);

/// A frame with its pulse and pose.
struct Match {
  Rule rule = Rule::kOneToOne;                             //!< that made the match
  Pulse pulse;                                             //!< that exposed the frame
  std::uint32_t pass = 0;                                  //!< of the scan, from 0
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  //!< of the flange at the pulse
  double time_to_before = 0;                               //!< [s] NaN: that pose was not used
  double time_to_after = 0;                                //!< [s] NaN: that pose was not used
  double position_error_bound = 0;                         //!< [m]
  std::uint8_t laser = 0;  //!< index of the laser that drew the line

  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

/// A frame that is not bound, or a pulse whose frame never arrived.
struct Drop {
  DropReason reason = DropReason::kNoTrigger;  //!< why
  std::optional<std::size_t> frame;  //!< the frame's number; none: the pulse's frame never arrived
  std::uint64_t frame_counter = 0;   //!< the camera's counter, unwrapped
  std::uint32_t arming = 0;          //!< of the pulse; 0: no pulse belongs to it
  std::uint64_t trigger_count = 0;   //!< 0: no pulse belongs to it
  std::string detail;                //!< for a person
};

/// The decision about one frame.
struct Decision {
  std::size_t frame = 0;       //!< number from Binder::add_frame()
  std::optional<Match> match;  //!< none: dropped

  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

/// What happened to every frame and every pulse.
///
/// frames = frames_bound + drops with a frame. A pulse has a bound frame, or is named by a drop,
/// or is missing.
struct Audit {
  Method method = Method::kInterpolate;      //!< of the scan
  std::uint64_t triggers = 0;                //!< pulses sent
  std::uint64_t triggers_missing = 0;        //!< sent but not known to the binder
  std::uint64_t triggers_refused = 0;        //!< dropped pulses: repeated or out of order
  std::uint64_t frames = 0;                  //!< received
  std::uint64_t poses = 0;                   //!< in the log
  std::uint64_t frames_bound = 0;            //!< with a pose
  std::uint64_t frames_dropped = 0;          //!< received, without a pose
  std::uint64_t frames_never_arrived = 0;    //!< pulses without a frame
  std::uint64_t frames_laser_uncertain = 0;  //!< dropped for that reason
  std::uint64_t by_rule[6] = {};             //!< bound frames by Rule
  double worst_time_to_pose = 0;             //!< [s] from a pulse to the nearest pose used
  double worst_position_error = 0;           //!< [m] greatest position_error_bound
  double latency = 0;  //!< [s] frame's stamp - pulse, as measured; NaN if nothing was bound
  bool latency_doubtful = false;     //!< unmatched frames and pulses at opposite ends of the scan
  std::uint64_t slips = 0;           //!< times the counter's offset changed within an acquisition
  std::uint64_t poses_repeated = 0;  //!< dropped: a pose of the same time was already there
  std::uint64_t poses_late = 0;      //!< dropped: arrived further behind than pose_settle
  std::uint64_t poses_unusable = 0;  //!< dropped: not finite, or not a rotation
  std::vector<Drop> dropped;         //!< by arrival of the frames, then by pulse
};

}  // namespace pose_frame_binder
