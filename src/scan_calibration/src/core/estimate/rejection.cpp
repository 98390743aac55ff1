// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "estimate/rejection.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "checks/session_checks.h"
#include "estimate/camera_fit.h"
#include "geometry/statistics.h"
#include "scan_cell_common/errors.h"

namespace scan_calibration {
namespace {

constexpr double kDeviations = 6;  // of the logarithm of what views miss by
constexpr double kFactor = 2.5;

/// What the corners and lines of a view, without its measured pose, say of its correction.
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

/// Position or orientation of the poses: what each misses by, in deviations squared.
struct PoseMisses {
  std::vector<double> length;  // [m] or [rad]
  std::vector<double> square;  // over its own variance
  double typical = 0;          // robust deviation along an axis
};

PoseMisses pose_misses(const std::vector<FreeCorrection>& free, Eigen::Index first, double noise) {
  constexpr double kChi3 = 1.5382;  // median length of a vector of unit noise
  PoseMisses result;
  for (const FreeCorrection& correction : free)
    result.length.push_back(correction.value.segment<3>(first).norm());
  result.typical = std::max(noise, median(result.length) / kChi3);
  for (const FreeCorrection& correction : free) {
    const Eigen::Vector3d value = correction.value.segment<3>(first);
    Eigen::Matrix3d variance = correction.covariance.block<3, 3>(first, first);
    variance.diagonal().array() += result.typical * result.typical;
    result.square.push_back(value.dot(variance.ldlt().solve(value)));
  }
  return result;
}

/// One in a hundred thousand, three numbers, their noise known from `views` of them.
double most_square(std::size_t views) {
  constexpr double kChi3 = 25.9;
  return kChi3 * (1 + 10. / static_cast<double>(views));
}

/// A reason for each view; empty: it fits.
using Reasons = std::vector<std::string>;

void judge_poses(const NormalEquations& equations, const NoiseLevels& noise,
                 const ScannerState& state, Reasons& reasons) {
  const NoiseGroups groups(noise);
  std::vector<FreeCorrection> free;
  for (std::size_t i = 0; i < reasons.size(); ++i)
    free.push_back(free_correction(equations.views[i], groups, state.corrections[i]));
  const PoseMisses shift = pose_misses(free, 0, noise.robot_m);
  const PoseMisses turn = pose_misses(free, 3, noise.robot_rad);
  const double most = most_square(reasons.size());
  for (std::size_t i = 0; i < reasons.size(); ++i) {
    if (!reasons[i].empty() || (shift.square[i] < most && turn.square[i] < most)) continue;
    reasons[i] = "its pose is " + figure(shift.length[i] * 1e3, " mm") + " and " +
                 figure(turn.length[i] * 180 / M_PI, " deg") +
                 " from where its corners put the flange; the other poses scatter by " +
                 figure(shift.typical * 1e3, " mm") + " and " +
                 figure(turn.typical * 180 / M_PI, " deg") + " along each axis";
  }
}

void judge_corners(const BoardViews& views, const ScannerState& state, const BoardSurface& surface,
                   Reasons& reasons) {
  constexpr double kLeast = 0.01;  // [px] below which nobody minds
  std::vector<double> rms;
  for (std::size_t i = 0; i < views.size(); ++i)
    rms.push_back(std::max(
        kLeast, rms_of(corner_residuals(state, surface, sight_of(state, views[i], i), views[i]),
                       std::vector<double>(views[i].pixels.size(), 1))));
  const std::vector<bool> misfit = outstanding(rms, kDeviations, kFactor);
  for (std::size_t i = 0; i < views.size(); ++i)
    if (misfit[i])
      reasons[i] = "its corners miss by " + figure(rms[i], " px") +
                   " (RMS), those of other views by " + figure(median(rms), " px");
}

/// Median of what a line's points miss by [px].
double miss_of(const std::vector<double>& residuals) {
  std::vector<double> lengths;
  for (const double residual : residuals)
    lengths.push_back(std::isfinite(residual) ? std::abs(residual) : 1e9);
  return median(lengths);
}

/// Empties the lines of a laser that do not fit.
bool reject_lines(const ScannerState& state, const BoardSurface& surface, std::size_t laser,
                  const std::string& name, BoardViews& views, std::vector<RejectedView>& rejected) {
  constexpr double kLeast = 0.01;  // [px] below which nobody minds
  std::vector<std::size_t> seen;
  std::vector<double> misses;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (views[i].lines[laser].pixels.empty()) continue;
    seen.push_back(i);
    misses.push_back(
        std::max(kLeast, miss_of(line_residuals(state, surface, sight_of(state, views[i], i),
                                                views[i].lines[laser], laser))));
  }
  const std::vector<bool> misfit = outstanding(misses, kDeviations, kFactor);
  bool any = false;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    if (!misfit[k]) continue;
    any = true;
    rejected.push_back({views[seen[k]].name, name,
                        "half of its points miss the laser's plane by more than " +
                            figure(misses[k], " px") + "; in the other views " +
                            figure(median(misses), " px")});
    views[seen[k]].lines[laser] = LinePoints{};
  }
  return any;
}

}  // namespace

bool reject_misfits(const BoardSurface& surface, const NoiseLevels& noise,
                    const NormalEquations& equations, const std::vector<std::string>& lasers,
                    BoardViews& views, ScannerState& state, std::vector<RejectedView>& rejected) {
  Reasons reasons(views.size());
  judge_corners(views, state, surface, reasons);
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
