// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_calibration/calibrate.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <limits>

#include "checks/hand_eye.h"
#include "geometry/statistics.h"
#include "quality/advice.h"
#include "quality/figures.h"
#include "scan_cell_common/errors.h"

namespace scan_calibration {
namespace {

/// Figures of one fold's views, by the model without them.
FigureSums held_out_fold(const JointEstimate& estimate, const BoardSurface& surface,
                         const std::vector<std::size_t>& folds, std::size_t fold) {
  std::vector<bool> keep;
  for (const std::size_t of : folds)
    keep.push_back(of != fold);
  const JointEstimate model = without(estimate, surface, keep);
  FigureSums sums(estimate.state.planes.size());
  for (std::size_t i = 0; i < folds.size(); ++i) {
    if (keep[i]) continue;
    const JudgedView judged = judge(model.state, surface, estimate.views[i]);
    sums.add(judged, judged.centre - board_centre(model.state, surface));
  }
  return sums;
}

Figures held_out_figures(const JointEstimate& estimate, const BoardSurface& surface,
                         const CalibrationOptions& options) {
  const std::vector<std::size_t> folds = fold_of_each(estimate.views.size(), options.folds);
  const std::size_t count = 1 + *std::max_element(folds.begin(), folds.end());
  const auto threads = static_cast<std::size_t>(options.threads);
  FigureSums sums(estimate.state.planes.size());
  for (std::size_t first = 0; first < count; first += threads) {
    std::vector<std::future<FigureSums>> running;
    for (std::size_t fold = first; fold < std::min(count, first + threads); ++fold)
      running.push_back(
          std::async(threads > 1 ? std::launch::async : std::launch::deferred,
                     [&, fold] { return held_out_fold(estimate, surface, folds, fold); }));
    for (std::future<FigureSums>& one : running)
      sums.add(one.get());
  }
  return sums.figures();
}

std::vector<JudgedView> judged_views(const JointEstimate& estimate, const BoardSurface& surface) {
  std::vector<JudgedView> result;
  for (const BoardView& view : estimate.views)
    result.push_back(judge(estimate.state, surface, view));
  return result;
}

/// How far a corner of the sensor would move [px] by what is not known of the lens.
double edge_deviation(const JointEstimate& estimate, const Knowledge& knowledge) {
  const scan_cell_common::CameraIntrinsics camera = estimate.state.intrinsics();
  const Eigen::Vector2d distorted(-camera.cx / camera.fx, -camera.cy / camera.fy);
  Eigen::Vector2d ray = distorted;
  if (!camera.undistort(distorted, ray)) return std::numeric_limits<double>::infinity();
  return knowledge.deviation(
      derivative(estimate.state, knowledge, [&](const ScannerState& at) -> Eigen::VectorXd {
        return at.intrinsics().project(ray.homogeneous());
      }));
}

/// Furthest that a corner was seen from the image's middle, of the sensor's half diagonal.
double reach_of(const JointEstimate& estimate) {
  const Eigen::Vector2d middle(estimate.state.width / 2., estimate.state.height / 2.);
  double furthest = 0;
  for (const BoardView& view : estimate.views)
    for (const Eigen::Vector2d& pixel : view.pixels)
      furthest = std::max(furthest, (pixel - middle).norm());
  return furthest / middle.norm();
}

void note_lens(const JointEstimate& estimate, const Knowledge& knowledge, Calibration& result) {
  constexpr double kReach = 0.7;
  constexpr double kEdge = 1;  // [px]
  const double reach = reach_of(estimate);
  const double edge = edge_deviation(estimate, knowledge);
  if (reach < kReach || !(edge < kEdge)) {
    result.notes.push_back(
        "corners reach " + figure(100 * reach, " %") +
        " of the way from the image's middle to its corner, where the lens is known to " +
        figure(edge, " px") + ": show the board further out");
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
    result.notes.push_back(std::to_string(corners) + " corners and " + std::to_string(points) +
                           " points of lines miss by more than eight deviations and are left out");
  }
}

void note_multiplicities(const JointEstimate& estimate, const std::vector<std::string>& lasers,
                         std::vector<std::string>& notes) {
  constexpr double kMuch = 2;
  if (estimate.multiplicities.corners > kMuch)
    notes.push_back(
        "neighbouring corners miss alike: " + figure(estimate.multiplicities.corners, "") +
        " are counted as one; look for a board that is not flat, or blur");
  for (std::size_t laser = 0; laser < lasers.size(); ++laser)
    if (estimate.multiplicities.lines[laser] > kMuch)
      notes.push_back("neighbouring points of " + lasers[laser] + " miss alike: " +
                      figure(estimate.multiplicities.lines[laser], "") + " are counted as one");
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
  result.held_out = held_out_figures(flat, surface, options);
  if (!options.board_flatness) return flat;
  if (options.progress) options.progress("bent board");
  choice.bend = true;
  JointEstimate bent = estimate_jointly(start, observations, options, choice);
  const Figures held_out = held_out_figures(bent, surface, options);
  constexpr double kBetter = 0.998;
  constexpr double kNothing = 1e-3;  // [px] that there is to explain
  if (result.held_out.reprojection_rms_px > kNothing &&
      held_out.reprojection_rms_px < kBetter * result.held_out.reprojection_rms_px) {
    result.held_out = held_out;
    return bent;
  }
  result.notes.push_back("a bent board explains held-out corners no better (" +
                         figure(held_out.reprojection_rms_px, " px") + " for " +
                         figure(result.held_out.reprojection_rms_px, " px") +
                         "): it is taken as flat");
  return flat;
}

/// Where each laser's projector is, as far as it is known [m].
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

/// Puts in what is not calibrated anew.
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

/// What follows from parts that are kept, or not there.
void note_parts(const CalibrationOptions& options, const Observations& observations,
                Calibration& result) {
  for (const std::string& part : result.kept) {
    if (options.lasers_alone || part.find("laser_") != 0) continue;
    result.notes.push_back(part + " is kept from " + options.existing->file +
                           ", in camera_optical_frame: it is right if the laser is fixed to the "
                           "camera as it was, and the lens was not exchanged or focused anew");
  }
  if (observations.lasers.empty())
    result.notes.emplace_back(
        "no laser was calibrated: nothing is said, or judged, of a scanned point");
  if (result.scanner.lasers.empty())
    result.notes.emplace_back("the model holds no laser: it cannot be scanned with until one is");
  if (options.lasers_alone)
    result.notes.emplace_back(
        "deviations are those of the planes alone: what the camera may be off by is not in them");
}

}  // namespace

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
      refuse(name, value, "give a standard deviation, or 0 to have it estimated");
  if (options.folds < 2) refuse("folds", options.folds, "give two or more");
  if (options.threads < 1) refuse("threads", options.threads, "give one or more");
  if (options.projectors.size() > lasers.size()) {
    throw InvalidParameter("projector", share(options.projectors.size(), lasers.size()) + " lasers",
                           "give x y z for each laser that is calibrated");
  }
  if (options.lasers_alone && !options.existing) {
    throw InvalidParameter("lasers_alone", "no existing scanner model",
                           "name the one whose camera and flange_to_camera are kept");
  }
  if (options.lasers_alone && lasers.empty()) {
    throw InvalidParameter("lasers_alone", "no laser to calibrate",
                           "name lasers, or calibrate the camera");
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
  const std::vector<JudgedView> judged = judged_views(estimate, surface);
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
