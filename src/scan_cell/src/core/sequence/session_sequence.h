// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "sequence/devices.h"
#include "sequence/sequence_end.h"
#include "sequence/session_request.h"
#include "sequence/supervisor.h"

namespace scan_cell {

/// The data taken at one pose.
struct TakenView {
  Eigen::Isometry3d base_to_flange;  //!< [m] measured while the robot stood
  Snapshot board;                    //!< lasers off
  std::vector<Snapshot> lines;       //!< one per laser, ascending
};

/// A pose that is not in the session.
struct SkippedPose {
  std::string name;
  std::string reason;
};

/// Result of a recording.
struct SessionEnd {
  SequenceEnd end;
  int views = 0;  //!< recorded, even if it ended early
  std::vector<SkippedPose> skipped;
};

/// Receives the views and the progress of the recording.
class SessionObserver {
 public:
  virtual ~SessionObserver() = default;
  /// @param pose 1 .. number of poses @param progress 0 .. 1, of the recording
  virtual void on_progress(int pose, const std::string& doing, double progress) = 0;
  /// Saves a view permanently: whatever happens later, the saved views stay a valid session.
  /// @throw scan_cell_common::Error if it cannot be written
  virtual void on_view(const TakenView& view) = 0;
};

/// Records a calibration session: at each taught pose, once the robot stands still, its measured
/// pose, an image of the board with the lasers off, and a frame with each laser on alone.
///
/// A pose that cannot be reached, does not come to rest or gives no image is skipped and named. The
/// recording ends early if the robot was stopped or could not move at all, if a device is lost (the
/// camera: several poses in a row without an image), or if it is cancelled: the lasers go off
/// first, the robot stops, and what was recorded is kept.
class SessionSequence {
 public:
  struct Timing : Supervisor::Timing {
    double speed = 0.1;            //!< [m/s] from pose to pose
    double settle = 0.3;           //!< [s] after a motion, before the pose is read
    double still_position = 5e-5;  //!< [m] two poses within this are the same
    double still_angle = 1e-4;     //!< [rad]
    double still_interval = 0.1;   //!< [s] between the two poses
    double still_patience = 3.0;   //!< [s] for the robot to come to rest
    double rate = 10;              //!< [Hz] highest pulse rate; lower with long exposures
    double image_patience = 3.0;   //!< [s] for a frame
    int max_blind_poses = 3;       //!< in a row without an image, after which the camera is lost
    double aftermath = 0.5;        //!< [s] for the robot to report why a motion failed
  };

  SessionSequence(Robot& robot, SnapshotCamera& camera, Trigger& trigger, SessionObserver& observer,
                  const SessionLimits& limits, const Timing& timing);

  /// Records the whole session in the calling thread.
  SessionEnd run(const SessionRequest& request, const WhyToCancel& why_to_cancel);

 private:
  /// Skips one pose.
  struct SkipPose {
    std::string reason;
    bool blind = false;  // no image arrived
  };

  void record(const SessionRequest& request, SessionEnd& result);
  void check_armings(const SessionRequest& request);
  void visit(const TaughtPose& pose, const SessionRequest& request);
  void move_to(const Eigen::Isometry3d& flange);
  [[noreturn]] void skip_or_end(const EndEarly& failure);
  Eigen::Isometry3d rest();
  bool is_same(const Eigen::Isometry3d& one, const Eigen::Isometry3d& other) const;
  Snapshot grab(double exposure, std::uint8_t lasers, const std::string& what);
  void disarm();
  void finish(SequenceEnd& end);
  void tell(const std::string& doing, double share);

  Robot& robot_;
  SnapshotCamera& camera_;
  Trigger& trigger_;
  SessionObserver& observer_;
  SessionLimits limits_;
  Timing timing_;
  Supervisor supervisor_;

  std::size_t pose_ = 0;   // the present one
  std::size_t poses_ = 0;  // in all
  bool prepared_ = false;
};

}  // namespace scan_cell
