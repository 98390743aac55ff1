// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "scan_calibration/calibration.h"
#include "scan_calibration/observations.h"

namespace scan_calibration {

/// Limits on held-out views that a calibration must meet to be used.
struct CalibrationLimits {
  static constexpr double kNone = std::numeric_limits<double>::infinity();  //!< no limit
  double reprojection_rms_px = kNone;                                       //!< of the corners
  double laser_plane_rms_mm = kNone;                                        //!< of every laser
  double board_scatter_mm = kNone;    //!< of the board between views
  double point_deviation_mm = kNone;  //!< of every point of Calibration::uncertainty
};

/// A figure and its limit.
struct JudgedFigure {
  std::string name;  //!< such as reprojection_rms_px
  double value = 0;  //!< in the unit of its name
  double limit = 0;  //!< the most that is accepted

  /// False for a NaN.
  bool passed() const { return value <= limit; }  // not a NaN
};

/// How a calibration ended.
enum class CalibrationVerdict {
  kPassed,        //!< the result may be used
  kLimitsMissed,  //!< there is a result, but it misses a limit
  kRefused        //!< the session gives no result
};

/// passed, limits_missed, refused
std::string to_string(CalibrationVerdict verdict);

/// A calibration, from the session's images to the verdict.
struct CalibrationRun {
  std::string session;                      //!< folder
  std::optional<ExistingScanner> existing;  //!< supplied what was not calibrated again
  CalibrationVerdict verdict = CalibrationVerdict::kRefused;  //!< of the run
  std::string reason;                                         //!< why it was refused
  std::vector<JudgedFigure> judged;                           //!< every figure that has a limit
  int taken = 0;                                              //!< views of the session
  Observations observations;                                  //!< what was read out of the images
  std::optional<Calibration> calibration;                     //!< none if it was refused
  std::optional<SequentialCalibration> sequential;            //!< of the same views, to compare
};

/// Reads a session and its images, calibrates, and judges the result.
/// CalibrationOptions::lasers_alone also uses the existing camera to read the lines.
/// @throw scan_cell_common::FileError, scan_cell_common::UnusableInput if the session's files are
/// invalid. If they are valid but give no calibration, the verdict says so.
/// @throw scan_cell_common::InvalidParameter as check()
CalibrationRun run_calibration(const std::string& session_folder,
                               const ObservationOptions& observation_options,
                               const CalibrationOptions& options, const CalibrationLimits& limits);

/// Every figure that has a limit. Without a calibrated laser there are no points to judge.
std::vector<JudgedFigure> judge(const Calibration& calibration,
                                const std::vector<std::string>& lasers,
                                const CalibrationLimits& limits);

}  // namespace scan_calibration
