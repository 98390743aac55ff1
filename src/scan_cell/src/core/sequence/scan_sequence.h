// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "scan_cell/scan_request.h"
#include "sequence/devices.h"
#include "sequence/sequence_end.h"
#include "sequence/supervisor.h"

namespace scan_cell {

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
  struct Timing : Supervisor::Timing {
    double approach_speed = 0.2;          //!< [m/s] to the start
    double patience = 3.0;                //!< [s] for late frames and poses at the end of a scan
    double patience_after_failure = 0.3;  //!< [s] the same where the scan ended early
  };

  ScanSequence(Robot& robot, Camera& camera, Trigger& trigger, Stages& stages,
               ScanObserver& observer, const ScanLimits& limits, const Timing& timing);

  /// Runs the whole scan in the calling thread.
  SequenceEnd run(const ScanRequest& request, const WhyToCancel& why_to_cancel);

 private:
  void prepare(const ScanRequest& request);
  void capture(const ScanRequest& request);
  SequenceEnd finish(SequenceEnd end);
  std::uint64_t disarm(SequenceEnd& end);
  void finish_stages(std::uint64_t pulses, SequenceEnd& end);

  void step(int number, const std::string& name);
  void wait_for_motion();

  Robot& robot_;
  Camera& camera_;
  Stages& stages_;
  ScanObserver& observer_;
  ScanLimits limits_;
  Timing timing_;
  Supervisor supervisor_;

  int step_ = 0;
  std::string step_name_;
  bool capturing_ = false;
  bool stages_started_ = false;
};

}  // namespace scan_cell
