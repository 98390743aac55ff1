// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_calibration/calibration_run.h"

#include <algorithm>

#include "scan_calibration/calibration.h"
#include "scan_cell_common/errors/errors.h"
#include "sequential.h"

namespace scan_calibration {

std::string to_string(CalibrationVerdict verdict) {
  switch (verdict) {
    case CalibrationVerdict::kPassed:
      return "passed";
    case CalibrationVerdict::kLimitsMissed:
      return "limits_missed";
    case CalibrationVerdict::kRefused:
      break;
  }
  return "refused";
}

std::vector<JudgedFigure> judge(const Calibration& calibration,
                                const std::vector<std::string>& lasers,
                                const CalibrationLimits& limits) {
  std::vector<JudgedFigure> judged;
  const auto add = [&](const std::string& name, double value, double limit) {
    if (limit != CalibrationLimits::kNone) judged.push_back({name, value, limit});
  };
  const Figures& held_out = calibration.held_out;
  add("reprojection_rms_px", held_out.reprojection_rms_px, limits.reprojection_rms_px);
  for (std::size_t i = 0; i < lasers.size(); ++i) {
    add("laser_plane_rms_mm " + lasers[i], held_out.laser_plane_rms_mm.at(i),
        limits.laser_plane_rms_mm);
  }
  add("board_scatter_mm", held_out.board_scatter_mm, limits.board_scatter_mm);
  if (calibration.uncertainty.empty()) return judged;
  double worst = 0;
  for (const PointUncertainty& point : calibration.uncertainty)
    worst = std::max(worst, point.deviation_mm);
  add("point_deviation_mm", worst, limits.point_deviation_mm);
  return judged;
}

CalibrationRun run_calibration(const std::string& session_folder,
                               const ObservationOptions& observation_options,
                               const CalibrationOptions& options, const CalibrationLimits& limits) {
  const Session session = load_session(session_folder);
  ObservationOptions reading = observation_options;
  if (options.lasers_alone && options.existing) reading.camera = options.existing->model.camera;
  check(options, reading.lasers.value_or(session.lasers));
  CalibrationRun run;
  run.session = session_folder;
  run.existing = options.existing;
  run.taken = static_cast<int>(session.views.size());
  try {
    run.observations = observe(session, reading);
    run.calibration = calibrate(run.observations, options);
    if (options.progress) options.progress("step by step, to compare");
    run.sequential = calibrate_sequentially(
        used_views(run.observations, *run.calibration), options.folds,
        options.lasers_alone ? std::optional(options.existing->model) : std::nullopt);
  } catch (const scan_cell_common::UnusableInput& error) {
    run.calibration.reset();
    run.reason = error.what();
    return run;
  }
  run.judged = judge(*run.calibration, run.observations.lasers, limits);
  const bool passed = std::all_of(run.judged.begin(), run.judged.end(),
                                  [](const JudgedFigure& figure) { return figure.passed(); });
  run.verdict = passed ? CalibrationVerdict::kPassed : CalibrationVerdict::kLimitsMissed;
  return run;
}

}  // namespace scan_calibration
