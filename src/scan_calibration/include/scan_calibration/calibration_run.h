// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "scan_calibration/calibration.h"
#include "scan_calibration/observations.h"
#include "scan_calibration/sequential.h"

namespace scan_calibration {

/// What a calibration must reach to be used. Judged on views that were not fitted.
struct CalibrationLimits {
  static constexpr double kNone = std::numeric_limits<double>::infinity();
  double reprojection_rms_px = kNone;
  double laser_plane_rms_mm = kNone;  //!< of every laser
  double board_scatter_mm = kNone;
  double point_deviation_mm = kNone;  //!< of every point of Calibration::uncertainty
};

/// A figure beside its limit.
struct JudgedFigure {
  std::string name;
  double value = 0;
  double limit = 0;

  bool passed() const { return value <= limit; }  // not a NaN
};

enum class CalibrationVerdict {
  PASSED,         //!< the result may be used
  LIMITS_MISSED,  //!< a result, but not one that the user accepts
  REFUSED         //!< no result: the session does not give one
};

/// passed, limits_missed, refused
std::string to_string(CalibrationVerdict verdict);

/// A session from its images to the verdict.
struct CalibrationRun {
  std::string session;  //!< folder
  CalibrationLimits limits;
  std::optional<ExistingScanner> existing;  //!< that gave what was not calibrated anew
  CalibrationVerdict verdict = CalibrationVerdict::REFUSED;
  std::string reason;  //!< why it was refused
  std::vector<JudgedFigure> judged;
  int taken = 0;  //!< views of the session
  Observations observations;
  std::optional<Calibration> calibration;           //!< none where it was refused
  std::optional<SequentialCalibration> sequential;  //!< the same views the plain way
};

/// Reads a session, observes and calibrates it, and judges the result. With
/// CalibrationOptions::lasers_alone the existing camera reads the lines, too.
/// @throw scan_cell_common::FileError, scan_cell_common::UnusableInput if the session's files make
/// no sense. Where they do, but give no calibration, the verdict says so.
/// @throw scan_cell_common::InvalidParameter as check()
CalibrationRun run_calibration(const std::string& session_folder,
                               const ObservationOptions& observation_options,
                               const CalibrationOptions& options, const CalibrationLimits& limits);

/// The verdict of a calibration, with every figure that has a limit. Where no laser was calibrated
/// there are no points to judge.
std::vector<JudgedFigure> judge(const Calibration& calibration,
                                const std::vector<std::string>& lasers,
                                const CalibrationLimits& limits);

}  // namespace scan_calibration
