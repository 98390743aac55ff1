// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "estimate/rejection.h"

#include <fmt/core.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "checks/session_checks.h"
#include "estimate/camera_fit.h"
#include "geometry/statistics.h"
#include "scan_cell_common/errors/errors.h"

namespace scan_calibration {
namespace {

constexpr double kMisfitDeviations = 6;  // of the logarithms of what the views miss by, chosen
constexpr double kMisfitFactor = 2.5;    // over the median of the views, chosen
constexpr double kMinMisfit = 0.01;      // [px] chosen: less does no harm

/// The correction of a view by its corners and lines, without its measured pose.
struct FreeCorrection {
  Vector6d value;
  Matrix6d covariance;
};

FreeCorrection free_correction(const ViewSquares& squares, const NoiseGroups& groups,
                               const Vector6d& correction) {
  Matrix6d matrix = Matrix6d::Zero();
  Vector6d gradient = Vector6d::Zero();
  for (std::size_t group = 0; group < groups.robot_position(); ++group) {
    matrix += squares[group].matrix.topLeftCorner<6, 6>();
    gradient += squares[group].gradient.head<6>();
  }
  const Eigen::LDLT<Matrix6d> solver(matrix);
  return {correction - solver.solve(gradient), solver.solve(Matrix6d::Identity())};
}

/// By how much the position or orientation of each pose is off.
struct PoseMisses {
  std::vector<double> length;  // [m] or [rad]
  std::vector<double> square;  // over its own variance
  double typical = 0;          // robust standard deviation along an axis
};

PoseMisses pose_misses(const std::vector<FreeCorrection>& free, Eigen::Index first, double noise) {
  PoseMisses result;
  for (const FreeCorrection& correction : free)
    result.length.push_back(correction.value.segment<3>(first).norm());
  result.typical = std::max(noise, median(result.length) / kMedianLength3);
  for (const FreeCorrection& correction : free) {
    const Eigen::Vector3d value = correction.value.segment<3>(first);
    Eigen::Matrix3d variance = correction.covariance.block<3, 3>(first, first);
    variance.diagonal().array() += result.typical * result.typical;
    result.square.push_back(value.dot(variance.ldlt().solve(value)));
  }
  return result;
}

/// Limit of the sum of squares of three normal numbers, exceeded by one in a hundred thousand, for
/// noise estimated from this many views.
double max_square(std::size_t views) {
  constexpr double kChiSquare = 25.9;  // quantile 1 - 1e-5, 3 degrees of freedom
  constexpr double kFewViews = 10;     // chosen: doubles it for ten views
  return kChiSquare * (1 + kFewViews / static_cast<double>(views));
}

/// Why each view does not fit; empty: it fits.
using Reasons = std::vector<std::string>;

void judge_poses(const NormalEquations& equations, const NoiseLevels& noise,
                 const ScannerState& state, Reasons& reasons) {
  const NoiseGroups groups(noise);
  std::vector<FreeCorrection> free;
  for (std::size_t i = 0; i < reasons.size(); ++i)
    free.push_back(free_correction(equations.views[i], groups, state.corrections[i]));
  const PoseMisses shift = pose_misses(free, 0, noise.robot_m);
  const PoseMisses turn = pose_misses(free, 3, noise.robot_rad);
  const double most = max_square(reasons.size());
  for (std::size_t i = 0; i < reasons.size(); ++i) {
    if (!reasons[i].empty() || (shift.square[i] < most && turn.square[i] < most)) continue;
    reasons[i] = fmt::format(
        "its pose is {} and {} from where its corners put the flange; the other poses scatter by "
        "{} and {} along each axis",
        millimetres(shift.length[i]), degrees(turn.length[i]), millimetres(shift.typical),
        degrees(turn.typical));
  }
}

/// Median distance of a line's points from the laser's plane [px].
double miss_of(const std::vector<double>& residuals) {
  constexpr double kNowhere = 1e9;  // [px] of a point that does not lie on the board
  std::vector<double> lengths;
  for (const double residual : residuals)
    lengths.push_back(std::isfinite(residual) ? std::abs(residual) : kNowhere);
  return median(lengths);
}

/// Empties the lines of a laser that do not fit.
bool reject_lines(const ScannerState& state, const BoardSurface& surface, std::size_t laser,
                  const std::string& name, BoardViews& views, std::vector<RejectedView>& rejected) {
  std::vector<std::size_t> seen;
  std::vector<double> misses;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (views[i].lines[laser].pixels.empty()) continue;
    seen.push_back(i);
    misses.push_back(
        std::max(kMinMisfit, miss_of(line_residuals(state, surface, sight_of(state, views[i], i),
                                                    views[i].lines[laser], laser))));
  }
  const std::vector<bool> misfit = outstanding(misses, kMisfitDeviations, kMisfitFactor);
  bool any = false;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    if (!misfit[k]) continue;
    any = true;
    rejected.push_back(
        {views[seen[k]].name, name,
         fmt::format("half of its points miss the laser's plane by more than {}; in the other "
                     "views by {}",
                     figure(misses[k], " px"), figure(median(misses), " px"))});
    views[seen[k]].lines[laser] = LinePoints{};
  }
  return any;
}

}  // namespace

std::vector<std::string> misfit_corners(const ScannerState& state, const BoardSurface& surface,
                                        const std::vector<BoardSight>& sights,
                                        const BoardViews& views) {
  std::vector<double> rms;
  for (std::size_t i = 0; i < views.size(); ++i)
    rms.push_back(std::max(kMinMisfit, rms_of(corner_residuals(state, surface, sights[i], views[i]),
                                              std::vector<double>(views[i].pixels.size(), 1))));
  const std::vector<bool> misfit = outstanding(rms, kMisfitDeviations, kMisfitFactor);
  std::vector<std::string> reasons(views.size());
  for (std::size_t i = 0; i < views.size(); ++i)
    if (misfit[i])
      reasons[i] = fmt::format("its corners miss by {} (RMS), those of the other views by {}",
                               figure(rms[i], " px"), figure(median(rms), " px"));
  return reasons;
}

bool reject_misfits(const BoardSurface& surface, const NoiseLevels& noise,
                    const NormalEquations& equations, const std::vector<std::string>& lasers,
                    BoardViews& views, ScannerState& state, std::vector<RejectedView>& rejected) {
  std::vector<BoardSight> sights;
  for (std::size_t i = 0; i < views.size(); ++i)
    sights.push_back(sight_of(state, views[i], i));
  Reasons reasons = misfit_corners(state, surface, sights, views);
  judge_poses(equations, noise, state, reasons);
  BoardViews kept;
  std::vector<Vector6d> corrections;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (!reasons[i].empty()) {
      rejected.push_back({views[i].name, "", reasons[i]});
      continue;
    }
    kept.push_back(std::move(views[i]));
    corrections.push_back(state.corrections[i]);
  }
  bool any = kept.size() < views.size();
  views = std::move(kept);
  state.corrections = std::move(corrections);
  check_enough(views, rejected);
  for (std::size_t laser = 0; laser < lasers.size(); ++laser)
    any = reject_lines(state, surface, laser, lasers[laser], views, rejected) || any;
  return any;
}

}  // namespace scan_calibration
