// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "geometry/statistics.h"
#include "quality/advice.h"
#include "quality/figures.h"
#include "scan_calibration/calibration.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/scanner/point_deviations.h"

namespace scan_calibration {
namespace {

Figures held_out(const JointEstimate& estimate, const BoardSurface& surface,
                 const CalibrationOptions& options) {
  return held_out_figures(
      estimate.views, surface, estimate.state.planes.size(), options.folds, options.threads,
      [&](const std::vector<bool>& keep) { return without(estimate, surface, keep).state; });
}

/// Uncertainty [px] of the image of the sensor's corner that comes from the lens.
double edge_deviation(const JointEstimate& estimate, const Knowledge& knowledge) {
  const scan_cell_common::CameraIntrinsics camera = estimate.state.intrinsics();
  const std::optional<Eigen::Vector3d> ray = ray_of(camera, Eigen::Vector2d::Zero());
  if (!ray) return std::numeric_limits<double>::infinity();
  return knowledge.deviation(derivative(
      estimate.state, knowledge,
      [&](const ScannerState& at) -> Eigen::VectorXd { return at.intrinsics().project(*ray); }));
}

/// Largest distance of a corner from the image's middle, over the sensor's half diagonal.
double reach_of(const JointEstimate& estimate) {
  const Eigen::Vector2d middle(estimate.state.width / 2., estimate.state.height / 2.);
  double furthest = 0;
  for (const BoardView& view : estimate.views)
    for (const Eigen::Vector2d& pixel : view.pixels)
      furthest = std::max(furthest, (pixel - middle).norm());
  return furthest / middle.norm();
}

void note_lens(const JointEstimate& estimate, const Knowledge& knowledge, Calibration& result) {
  constexpr double kMinReach = 0.7;    // of the half diagonal, chosen
  constexpr double kMaxDeviation = 1;  // [px] chosen
  const double reach = reach_of(estimate);
  const double edge = edge_deviation(estimate, knowledge);
  if (reach < kMinReach || !(edge < kMaxDeviation)) {
    result.notes.push_back(fmt::format(
        "corners reach {} of the way from the image's middle to its corner, where the lens has a "
        "standard deviation of {}: show the board further out",
        figure(100 * reach, " %"), figure(edge, " px")));
  }
}

void note_left_out(Calibration& result) {
  std::size_t corners = 0, points = 0;
  for (const ViewFigures& view : result.views) {
    corners += view.left_out_corners.size();
    for (const auto& line : view.left_out_points)
      points += line.size();
  }
  if (corners + points > 0) {
    result.notes.push_back(fmt::format(
        "{} corners and {} laser points are outliers (more than eight standard deviations) and "
        "were left out",
        corners, points));
  }
}

void note_multiplicities(const JointEstimate& estimate, const std::vector<std::string>& lasers,
                         std::vector<std::string>& notes) {
  constexpr double kNoted = 2;  // observations that count as one, chosen
  const Multiplicities& found = estimate.multiplicities;
  if (found.corners > kNoted)
    notes.push_back(
        fmt::format("errors of neighbouring corners are correlated: {} count as one; "
                    "check that the board is flat and the image sharp",
                    figure(found.corners, "")));
  for (std::size_t laser = 0; laser < lasers.size(); ++laser)
    if (found.lines[laser] > kNoted)
      notes.push_back(
          fmt::format("errors of neighbouring points of {} are correlated: {} count as one",
                      lasers[laser], figure(found.lines[laser], "")));
}

JointEstimate best_estimate(const Observations& observations, const CalibrationOptions& options,
                            const BoardSurface& surface, Calibration& result) {
  const Start start = closed_form_start(observations, options);
  if (!start.note.empty()) result.notes.push_back(start.note);
  FitChoice choice;
  choice.camera = !options.lasers_alone;
  if (options.progress) options.progress("joint estimate");
  JointEstimate flat = estimate_jointly(start, observations, options, choice);
  if (options.progress) options.progress("held-out views");
  result.held_out = held_out(flat, surface, options);
  if (!options.board_flatness) return flat;
  if (options.progress) options.progress("bent board");
  choice.bend = true;
  JointEstimate bent = estimate_jointly(start, observations, options, choice);
  const Figures bent_held_out = held_out(bent, surface, options);
  constexpr double kMaxRatio = 0.998;  // of the held-out RMS figures, chosen: above it is chance
  constexpr double kMinRms = 1e-3;     // [px] chosen: below it there is nothing to explain
  if (result.held_out.reprojection_rms_px > kMinRms &&
      bent_held_out.reprojection_rms_px < kMaxRatio * result.held_out.reprojection_rms_px) {
    result.held_out = bent_held_out;
    return bent;
  }
  result.notes.push_back(
      fmt::format("a bent board does not explain held-out corners better ({}, flat {}): the board "
                  "is taken as flat",
                  figure(bent_held_out.reprojection_rms_px, " px"),
                  figure(result.held_out.reprojection_rms_px, " px")));
  return flat;
}

/// The projectors of the lasers [m] that are known.
std::vector<Eigen::Vector3d> projectors_of(const Observations& observations,
                                           const CalibrationOptions& options) {
  std::vector<Eigen::Vector3d> projectors = options.projectors;
  for (std::size_t i = projectors.size(); i < observations.lasers.size(); ++i) {
    const std::size_t laser = scan_cell_common::laser_index(observations.lasers[i]);
    if (!options.existing || !options.existing->model.has_laser(laser)) break;
    projectors.push_back(options.existing->model.laser(laser).origin);
  }
  return projectors;
}

/// Parts of a model that are not calibrated again, by their names in its file.
std::vector<std::string> kept_parts(const ExistingScanner& existing, bool lasers_alone,
                                    const std::vector<std::string>& lasers) {
  std::vector<std::string> parts;
  if (lasers_alone) parts = {"camera", "flange_to_camera"};
  for (std::size_t i = 0; i < existing.model.lasers.size(); ++i) {
    const std::string name = scan_cell_common::laser_name(i);
    const bool again = std::find(lasers.begin(), lasers.end(), name) != lasers.end();
    if (existing.model.has_laser(i) && !again) parts.push_back(name);
  }
  return parts;
}

/// Takes the parts that are not calibrated again from the existing model.
void keep(const ExistingScanner& existing, const Observations& observations, bool lasers_alone,
          Calibration& result) {
  using scan_cell_common::ScannerModel;
  const ScannerModel found = result.scanner;
  result.scanner = existing.model;
  result.kept = kept_parts(existing, lasers_alone, observations.lasers);
  if (!lasers_alone) {
    result.scanner.camera = found.camera;
    result.scanner.flange_to_camera = found.flange_to_camera;
  }
  auto& lasers = result.scanner.lasers;
  lasers.resize(std::max(lasers.size(), found.lasers.size()));
  for (std::size_t i = 0; i < found.lasers.size(); ++i)
    if (found.lasers[i]) lasers[i] = found.lasers[i];
}

/// Notes on the parts that are kept or missing.
void note_parts(const CalibrationOptions& options, const Observations& observations,
                Calibration& result) {
  for (const std::string& part : result.kept) {
    if (options.lasers_alone || part.find("laser_") != 0) continue;
    result.notes.push_back(fmt::format(
        "{} is kept from {}, in camera_optical_frame: it is only valid if the laser is mounted on "
        "the camera as before and the lens was neither exchanged nor refocused",
        part, options.existing->file));
  }
  if (observations.lasers.empty())
    result.notes.emplace_back(
        "no laser was calibrated: the report has no figure for a scanned point");
  if (result.scanner.lasers.empty())
    result.notes.emplace_back(
        "the model has no laser: it cannot be used for scanning until one is calibrated");
  if (options.lasers_alone)
    result.notes.emplace_back(
        "standard deviations are those of the planes alone: they do not include the error of the "
        "camera");
}

}  // namespace

ExistingScanner load_existing_scanner(const std::string& file) {
  const std::string text = scan_cell_common::read_file(file);
  return {file, text, scan_cell_common::parse_scanner_model(text, file),
          scan_cell_common::parse_point_deviations(text, file)};
}

void check(const CalibrationOptions& options, const std::vector<std::string>& lasers) {
  using scan_cell_common::InvalidParameter;
  const auto refuse = [](const char* name, double value, const char* cure) {
    throw InvalidParameter(name, figure(value, ""), cure);
  };
  const std::pair<const char*, double> deviations[] = {
      {"corner_deviation", options.corner_deviation},
      {"line_deviation", options.line_deviation},
      {"robot_deviation", options.robot_deviation},
      {"robot_angle_deviation", options.robot_angle_deviation}};
  for (const auto& [name, value] : deviations)
    if (!(value >= 0) || std::isinf(value))
      refuse(name, value, "give a standard deviation, or 0 to estimate it from the data");
  if (options.folds < 2) refuse("folds", options.folds, "give two or more");
  if (options.threads < 1) refuse("threads", options.threads, "give one or more");
  if (options.projectors.size() > lasers.size()) {
    throw InvalidParameter("projector", share(options.projectors.size(), lasers.size()) + " lasers",
                           "give x y z for each laser that is calibrated");
  }
  if (options.lasers_alone && !options.existing) {
    throw InvalidParameter("lasers_alone", "no existing scanner model",
                           "name the model whose camera and flange_to_camera to keep");
  }
  if (options.lasers_alone && lasers.empty()) {
    throw InvalidParameter("lasers_alone", "no laser to calibrate",
                           "name lasers, or calibrate the camera too");
  }
}

Calibration calibrate(const Observations& observations, const CalibrationOptions& options) {
  check(options, observations.lasers);
  if (options.progress) options.progress("camera, hand-eye and planes, one after the other");
  Calibration result;
  const BoardSurface surface(observations.board);
  const JointEstimate estimate = best_estimate(observations, options, surface, result);
  result.scanner =
      scanner_model(estimate.state, observations.lasers, projectors_of(observations, options));
  if (options.existing) keep(*options.existing, observations, options.lasers_alone, result);
  result.base_to_board = estimate.state.base_to_board;
  result.board_bend = estimate.state.bend;
  result.rejected = estimate.rejected;
  result.noise = estimate.noise.levels;
  const std::vector<JudgedView> judged = judge(estimate.state, surface, estimate.views);
  result.fitted = fitted_figures(judged, observations.lasers.size());
  for (std::size_t i = 0; i < judged.size(); ++i)
    result.views.push_back(judged[i].figures(estimate.views[i], estimate.state, surface));
  if (options.progress) options.progress("uncertainty and advice");
  const Knowledge knowledge(estimate, surface);
  state_parameters(estimate.state, knowledge, observations.lasers, result.parameters,
                   result.covariance);
  const std::vector<ScanPlace> places = scan_places(estimate, surface);
  result.uncertainty = point_uncertainties(estimate, knowledge, places, observations.lasers);
  result.advice = advise(estimate, knowledge, observations.board, places);
  note_parts(options, observations, result);
  if (!options.lasers_alone) note_lens(estimate, knowledge, result);
  note_left_out(result);
  note_multiplicities(estimate, observations.lasers, result.notes);
  return result;
}

}  // namespace scan_calibration
