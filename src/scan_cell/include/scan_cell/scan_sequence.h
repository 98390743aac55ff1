// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <string>

#include "scan_cell/devices.h"
#include "scan_cell/scan_request.h"

namespace scan_cell {

/// How a scan ended; the values of scan_cell_msgs/ScanResult.
enum class ScanOutcome : std::uint8_t {
  Finished = 0,
  Refused = 1,
  Cancelled = 2,
  RobotLost = 3,
  CameraLost = 4,
  TriggerLost = 5,
  MotionFailed = 6,
  StageFailed = 7,
};

struct ScanEnd {
  ScanOutcome outcome = ScanOutcome::Finished;
  std::string message;
};

/// Hears how a scan goes on.
class ScanObserver {
 public:
  virtual ~ScanObserver() = default;
  /// @param step 1 .. 8 @param progress 0 .. 1, of the whole scan
  virtual void on_progress(int step, const std::string& name, double progress) = 0;
  /// From here on profiles belong to the scan / no longer do.
  virtual void on_capture_begins() = 0;
  virtual void on_capture_ends() = 0;
};

/// The eight steps of a scan (thesis, section 6.1): read the positions; move to the start; set
/// speed, linear motion and interpolation; prepare binder and triangulation; start the camera; move
/// to the end while the trigger pulses; stop; bind and triangulate.
///
/// Whatever goes wrong, the lasers go off first, the robot stops, and what was captured is still
/// made into a cloud.
class ScanSequence {
 public:
  struct Timing {
    double poll = 0.01;                   //!< [s] between two looks at the devices
    double keep_alive = 0.1;              //!< [s] between two signs of life to the trigger
    double readiness = 1.0;               //!< [s] to hear of the robot, before anything moves
    double stall = 5.0;                   //!< [s] without progress after which a motion has failed
    double approach_speed = 0.2;          //!< [m/s] to the start
    double patience = 3.0;                //!< [s] for late frames and poses at the end of a scan
    double patience_after_failure = 0.3;  //!< [s] the same where the scan ended early
  };

  ScanSequence(Robot& robot, Camera& camera, Trigger& trigger, Stages& stages,
               ScanObserver& observer, const ScanLimits& limits, const Timing& timing);

  /// Runs the whole scan in the calling thread.
  /// @param cancel set by another thread to end it early
  ScanEnd run(const ScanRequest& request, const std::atomic<bool>& cancel);

 private:
  void prepare(const ScanRequest& request);
  void capture(const ScanRequest& request);
  ScanEnd finish(ScanEnd end);
  std::uint64_t disarm(ScanEnd& end);
  void finish_stages(std::uint64_t pulses, ScanEnd& end);

  void step(int number, const std::string& name);
  void start_move(const Eigen::Isometry3d& target, double camera_rate);
  void wait_until_well();
  void wait_for_motion();
  void wait_until_moving();
  void end_if_stalled(double deadline) const;
  static void end_if_failed(const Motion& motion);
  void watch();
  void sleep_and_watch();

  Robot& robot_;
  Camera& camera_;
  Trigger& trigger_;
  Stages& stages_;
  ScanObserver& observer_;
  ScanLimits limits_;
  Timing timing_;

  const std::atomic<bool>* cancel_ = nullptr;
  int step_ = 0;
  std::string step_name_;
  bool moving_ = false;
  bool capturing_ = false;
  bool armed_ = false;
  bool stages_started_ = false;
  double last_keep_alive_ = 0;
};

}  // namespace scan_cell
