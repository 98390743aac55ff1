// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "checks/hand_eye.h"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <cmath>
#include <limits>
#include <random>

#include "geometry/scanner_state.h"
#include "geometry/statistics.h"

namespace scan_calibration {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kMaxAngle = 2 * kDegree;  // of a view from the others, chosen
constexpr double kMaxOffset = 0.03;  // of the board, over its distance from the camera, chosen
constexpr int kReweighings = 20;     // chosen: the weights no longer change

/// Rotation X with flange motion * X = X * camera motion, by least squares (Park and Martin).
class RotationFit {
 public:
  void add(const Matrix3d& flange_motion, const Matrix3d& camera_motion) {
    constexpr double kMaxTurn = 175 * kDegree;  // chosen: near a half turn the axis flips
    const Vector3d flange = rotation_vector(flange_motion);
    const Vector3d camera = rotation_vector(camera_motion);
    if (flange.norm() > kMaxTurn || camera.norm() > kMaxTurn) return;
    sum_ += flange * camera.transpose();
  }
  Matrix3d solve() const { return nearest_rotation(sum_); }

 private:
  Matrix3d sum_ = Matrix3d::Zero();
};

class Search {
 public:
  /// x, the camera in the flange [m]; scale of the camera's lengths; p, the board in the base [m]
  using Offsets = Eigen::Matrix<double, 7, 1>;

  Search(const std::vector<Isometry3d>& flange, const std::vector<Isometry3d>& board,
         const Isometry3d& half_turn)
      : flange_(flange), board_(board), half_turn_(half_turn) {
    best_.fits.assign(flange.size(), false);
    best_.turned.assign(flange.size(), false);
    best_.offset.assign(flange.size(), 0);
  }

  HandEye run() {
    constexpr int kTriples = 500;  // chosen: with half outliers all miss once in 10^29
    if (flange_.size() < 3) return best_;
    std::mt19937 generator(1);
    const auto draw = [&] { return static_cast<std::size_t>(generator() % flange_.size()); };
    for (int i = 0; i < kTriples; ++i) {
      const std::size_t a = draw(), b = draw(), c = draw();
      if (a == b || b == c || a == c) continue;
      try_rotation(from_triple(a, b, c), a);
    }
    for (int i = 0; i < 2; ++i)
      refine_rotation();
    take_most_as_they_are();
    solve_translation();
    return best_;
  }

  HandEye run_known(const Isometry3d& camera) {
    for (std::size_t i = 0; i < flange_.size(); ++i)
      try_rotation(camera.linear(), i);
    refine_board(camera.linear());
    take_most_as_they_are();
    best_.flange_to_camera = camera;
    Offsets known = Offsets::Unit(3);
    known.head<3>() = camera.translation();
    if (best_.count > 0) solve_robustly({4, 5, 6}, known);
    return best_;
  }

 private:
  Matrix3d camera_motion(std::size_t a, std::size_t b) const {
    return oriented(a) * oriented(b).transpose();
  }
  Matrix3d oriented(std::size_t i) const {
    return best_.turned[i] ? Matrix3d(board_[i].linear() * half_turn_.linear())
                           : Matrix3d(board_[i].linear());
  }

  /// From three views as they are. If most views are turned, "turned" means the others.
  Matrix3d from_triple(std::size_t a, std::size_t b, std::size_t c) const {
    RotationFit fit;
    const std::size_t pairs[][2] = {{a, b}, {b, c}, {c, a}};
    for (const auto& [i, j] : pairs)
      fit.add(flange_[i].linear().transpose() * flange_[j].linear(),
              board_[i].linear() * board_[j].linear().transpose());
    return fit.solve();
  }

  void try_rotation(const Matrix3d& camera, std::size_t reference) {
    const Matrix3d board = flange_[reference].linear() * camera * board_[reference].linear();
    HandEye trial = best_;
    trial.flange_to_camera.linear() = camera;
    trial.base_to_board.linear() = board;
    judge_rotations(trial);
    const double misfit = total(trial);
    if (misfit < min_) {
      min_ = misfit;
      best_ = trial;
    }
  }

  void judge_rotations(HandEye& trial) const {
    trial.angle.resize(flange_.size());
    trial.count = 0;
    for (std::size_t i = 0; i < flange_.size(); ++i) {
      const Matrix3d seen =
          flange_[i].linear() * trial.flange_to_camera.linear() * board_[i].linear();
      const Matrix3d miss = trial.base_to_board.linear().transpose() * seen;
      const double plain = angle_of(miss);
      const double turned = angle_of(miss * half_turn_.linear());
      trial.turned[i] = turned < plain;
      trial.angle[i] = std::min(turned, plain);
      trial.fits[i] = trial.angle[i] < kMaxAngle;
      trial.count += trial.fits[i];
    }
  }

  static double total(const HandEye& trial) {
    double sum = 0;
    for (const double angle : trial.angle)
      sum += std::min(angle * angle, kMaxAngle * kMaxAngle);
    return sum;
  }

  void refine_rotation() {
    RotationFit fit;
    for (std::size_t i = 0; i < flange_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (best_.fits[i] && best_.fits[j])
          fit.add(flange_[i].linear().transpose() * flange_[j].linear(), camera_motion(i, j));
    refine_board(fit.solve());
  }

  /// The board's orientation from all views that agree.
  void refine_board(const Matrix3d& camera) {
    Matrix3d boards = Matrix3d::Zero();
    HandEye trial = best_;
    trial.flange_to_camera.linear() = camera;
    for (std::size_t i = 0; i < flange_.size(); ++i)
      if (best_.fits[i])
        boards += flange_[i].linear() * trial.flange_to_camera.linear() * oriented(i);
    trial.base_to_board.linear() = nearest_rotation(boards);
    judge_rotations(trial);
    if (total(trial) <= min_) {
      min_ = total(trial);
      best_ = trial;
    }
  }

  void take_most_as_they_are() {
    std::size_t turned = 0;
    for (std::size_t i = 0; i < flange_.size(); ++i)
      turned += best_.fits[i] && best_.turned[i];
    if (2 * turned <= best_.count) return;
    best_.turned.flip();
    best_.base_to_board.linear() = best_.base_to_board.linear() * half_turn_.linear();
  }

  /// Least squares of F_i (x + scale X c_i) = p, the board's origin, for some of the unknowns.
  /// @param free of the unknowns; the others stay
  void solve(const std::vector<int>& free, const std::vector<double>& weights, Offsets& solution) {
    const auto count = static_cast<Eigen::Index>(free.size());
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(count, count);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
    for (const int unknown : free)
      solution[unknown] = 0;
    for (std::size_t i = 0; i < flange_.size(); ++i) {
      const Eigen::Matrix<double, 3, 7> all = equations(i);
      const Eigen::Matrix3Xd rows = all(Eigen::all, free);
      normal += weights[i] * rows.transpose() * rows;
      right -= weights[i] * rows.transpose() * (all * solution + flange_[i].translation());
    }
    const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver(normal);
    const Eigen::VectorXd found = solver.solve(right);
    solution(free) = found;
    covariance_ = solver.pseudoInverse();
  }

  void solve_robustly(const std::vector<int>& free, Offsets solution) {
    std::vector<double> weights(best_.fits.begin(), best_.fits.end());
    for (int step = 0; step < kReweighings; ++step) {
      solve(free, weights, solution);
      judge_translations(solution, weights);
    }
    accept_offsets();
  }

  void solve_translation() {
    solve_robustly({0, 1, 2, 3, 4, 5, 6}, Offsets::Zero());
    best_.scale_deviation = std::sqrt(variance_ * covariance_(3, 3));
    // Again with the given board size
    Offsets solution = Offsets::Unit(3);
    solve({0, 1, 2, 4, 5, 6}, {best_.fits.begin(), best_.fits.end()}, solution);
    best_.flange_to_camera.translation() = solution.head<3>();
    best_.base_to_board.translation() = solution.tail<3>();
  }

  Eigen::Matrix<double, 3, 7> equations(std::size_t i) const {
    Eigen::Matrix<double, 3, 7> rows;
    rows.leftCols<3>() = flange_[i].linear();
    rows.col(3) = flange_[i].linear() * best_.flange_to_camera.linear() * origin(i);
    rows.rightCols<3>() = -Matrix3d::Identity();
    return rows;
  }

  Vector3d origin(std::size_t i) const {
    return best_.turned[i] ? board_[i] * half_turn_.translation() : board_[i].translation();
  }

  /// Geman-McClure weights, scaled by the median.
  void judge_translations(const Offsets& solution, std::vector<double>& weights) {
    best_.flange_to_camera.translation() = solution.head<3>();
    best_.scale = solution[3];
    best_.base_to_board.translation() = solution.tail<3>();
    std::vector<double> fitting;
    for (std::size_t i = 0; i < flange_.size(); ++i) {
      best_.offset[i] = (equations(i) * solution + flange_[i].translation()).norm();
      if (best_.fits[i]) fitting.push_back(best_.offset[i]);
    }
    constexpr double kMinDeviation = 1e-9;  // [m] rounding, for exact poses
    constexpr double kReach = 4;            // standard deviations, chosen
    const double typical = std::max(median(fitting) / kMedianLength3, kMinDeviation);
    variance_ = typical * typical;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const double miss = best_.offset[i] / (kReach * typical);
      weights[i] = best_.fits[i] ? 1 / ((1 + miss * miss) * (1 + miss * miss)) : 0;
    }
  }

  void accept_offsets() {
    best_.count = 0;
    for (std::size_t i = 0; i < flange_.size(); ++i) {
      const double distance = std::abs(best_.scale) * board_[i].translation().norm();
      best_.fits[i] = best_.fits[i] && best_.offset[i] < kMaxOffset * distance;
      best_.count += best_.fits[i];
    }
  }

  const std::vector<Isometry3d>& flange_;
  const std::vector<Isometry3d>& board_;
  const Isometry3d half_turn_;
  HandEye best_;
  double min_ = std::numeric_limits<double>::infinity();
  double variance_ = 0;         // [m^2] of an offset
  Eigen::MatrixXd covariance_;  // of the last solution, over variance_
};

}  // namespace

HandEye fit_hand_eye(const std::vector<Eigen::Isometry3d>& flange,
                     const std::vector<Eigen::Isometry3d>& board,
                     const Eigen::Isometry3d& half_turn) {
  return Search(flange, board, half_turn).run();
}

HandEye fit_board(const Eigen::Isometry3d& flange_to_camera,
                  const std::vector<Eigen::Isometry3d>& flange,
                  const std::vector<Eigen::Isometry3d>& board, const Eigen::Isometry3d& half_turn) {
  return Search(flange, board, half_turn).run_known(flange_to_camera);
}

}  // namespace scan_calibration
