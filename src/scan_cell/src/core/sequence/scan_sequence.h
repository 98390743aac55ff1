// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scan_cell/scan_request.h"
#include "scan_cell/scan_run.h"
#include "sequence/devices.h"
#include "sequence/sequence_end.h"
#include "sequence/supervisor.h"

namespace scan_cell {

/// Progress of a scan.
struct ScanProgress {
  std::size_t pass = 0;  //!< from 0
  int step = 0;          //!< 1 .. 8
  std::string name;      //!< of the step
  double whole = 0;      //!< 0 .. 1, of the scan
};

/// Is told of the progress of a scan.
class ScanObserver {
 public:
  virtual ~ScanObserver() = default;
  virtual void on_progress(const ScanProgress& progress) = 0;
  /// From here on, profiles belong to the scan, or no longer do.
  virtual void on_capture_begins() = 0;
  virtual void on_capture_ends() = 0;
};

/// The eight steps of a scan (thesis, section 6.1): read the positions; move to the start; set
/// speed, linear motion and interpolation; prepare binder and triangulation; start the camera; move
/// to the end while the trigger pulses; stop; bind and triangulate. In a scan with several passes,
/// each does steps 2 to 6; binder, triangulation and camera are started once. Between passes the
/// lasers are off. Before anything moves, all motions of all passes are checked, all camera
/// settings are tried, and the trigger is asked about all armings. A pass with other settings
/// restarts the camera.
///
/// On any failure the lasers go off first, then the robot stops, and what was captured is still
/// made into a cloud.
class ScanSequence {
 public:
  struct Timing : Supervisor::Timing {
    double approach_speed = 0.2;          //!< [m/s] to the start
    double patience = 3.0;                //!< [s] for late frames and poses at the end of a scan
    double patience_after_failure = 0.3;  //!< [s] the same if the scan ended early
  };

  ScanSequence(Robot& robot, Camera& camera, Trigger& trigger, Stages& stages,
               ScanObserver& observer, const ScanLimits& limits, const Timing& timing);

  /// Runs the whole scan in the calling thread.
  SequenceEnd run(const ScanRequest& request, const WhyToCancel& why_to_cancel);

  /// Number of passes of the latest scan that were scanned to their end.
  std::size_t passes_finished() const { return passes_finished_; }

  /// What else a person should know about the latest scan.
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  void begin();
  void try_devices();
  double try_camera(const ScanRun& run);
  void start_camera(const PassCamera& settings);
  void approach(const ScanRun& run);
  void start_stages(const std::string& scan_id);
  void capture(const ScanRun& run);
  SequenceEnd finish(SequenceEnd end);
  std::string disarm();
  void finish_stages(SequenceEnd& end);
  std::string find_lost_frames(const std::vector<std::uint64_t>& missing) const;

  void step(int number, const std::string& name);
  void show(double share);
  void wait_for_motion(double begun = 0, double part = 1);

  Robot& robot_;
  Camera& camera_;
  Trigger& trigger_;
  Stages& stages_;
  ScanObserver& observer_;
  ScanLimits limits_;
  Timing timing_;
  Supervisor supervisor_;

  std::vector<ScanRun> runs_;
  std::size_t run_ = 0;  // index of the present run
  std::size_t passes_finished_ = 0;
  std::vector<std::string> warnings_;
  std::vector<ArmingPulses> armings_;   // the armings with pulses
  std::vector<std::string> armed_for_;  // names of their runs
  ScanProgress progress_;
  std::optional<PassCamera> camera_settings_;  // with which it was started; none: not started
  std::vector<std::pair<PassCamera, double>> exposures_;  // [s] with the settings tried
  bool stages_started_ = false;
  bool capturing_ = false;
};

}  // namespace scan_cell
