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

constexpr double kDegree = M_PI / 180;
constexpr double kAgrees = 2 * kDegree;   // rotation of a view with the others'
constexpr double kAgreesRelative = 0.03;  // offset of a view, of its distance from the board

/// Rotation X with flange motion * X = X * camera motion, as well as it goes (Park and Martin).
class RotationFit {
 public:
  void add(const Matrix3d& flange_motion, const Matrix3d& camera_motion) {
    constexpr double kUnclear = 175 * kDegree;  // about which axis it turned
    const Vector3d flange = rotation_vector(flange_motion);
    const Vector3d camera = rotation_vector(camera_motion);
    if (flange.norm() > kUnclear || camera.norm() > kUnclear) return;
    sum_ += flange * camera.transpose();
  }
  Matrix3d solve() const { return nearest_rotation(sum_); }

 private:
  Matrix3d sum_ = Matrix3d::Zero();
};

class Search {
 public:
  Search(const std::vector<Isometry3d>& flange, const std::vector<Isometry3d>& board,
         const Isometry3d& half_turn)
      : flange_(flange), board_(board), half_turn_(half_turn) {
    best_.fits.assign(flange.size(), false);
    best_.turned.assign(flange.size(), false);
    best_.offset.assign(flange.size(), 0);
  }

  HandEye run() {
    constexpr int kTriples = 500;
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
    solve_at_given_size();
    return best_;
  }

  HandEye run_known(const Isometry3d& camera) {
    for (std::size_t i = 0; i < flange_.size(); ++i)
      try_rotation(camera.linear(), i);
    refine_board(camera.linear());
    take_most_as_they_are();
    best_.flange_to_camera = camera;
    if (best_.count > 0) solve_board(camera.translation());
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

  /// Of three views that are taken as they are: if most are turned, "turned" means the others.
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
    if (misfit < least_) {
      least_ = misfit;
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
      trial.fits[i] = trial.angle[i] < kAgrees;
      trial.count += trial.fits[i];
    }
  }

  static double total(const HandEye& trial) {
    double sum = 0;
    for (const double angle : trial.angle)
      sum += std::min(angle * angle, kAgrees * kAgrees);
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

  /// The board's orientation by all views that agree.
  void refine_board(const Matrix3d& camera) {
    Matrix3d boards = Matrix3d::Zero();
    HandEye trial = best_;
    trial.flange_to_camera.linear() = camera;
    for (std::size_t i = 0; i < flange_.size(); ++i)
      if (best_.fits[i])
        boards += flange_[i].linear() * trial.flange_to_camera.linear() * oriented(i);
    trial.base_to_board.linear() = nearest_rotation(boards);
    judge_rotations(trial);
    if (total(trial) <= least_) {
      least_ = total(trial);
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

  /// The board's origin is at one place: F_i (x + scale X c_i) = p, linear in x, scale and p.
  void solve_translation() {
    constexpr int kReweighings = 20;
    const std::size_t count = flange_.size();
    std::vector<double> weights(count, 1);
    for (int step = 0; step < kReweighings; ++step) {
      Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(7, 7);
      Eigen::VectorXd right = Eigen::VectorXd::Zero(7);
      for (std::size_t i = 0; i < count; ++i) {
        if (!best_.fits[i] && step == 0) weights[i] = 0;
        const Eigen::Matrix<double, 3, 7> rows = equations(i);
        normal += weights[i] * rows.transpose() * rows;
        right -= weights[i] * rows.transpose() * flange_[i].translation();
      }
      const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver(normal);
      const Eigen::VectorXd solution = solver.solve(right);
      judge_translations(solution, weights);
      best_.scale_deviation = std::sqrt(variance_ * solver.pseudoInverse()(3, 3));
    }
    accept_offsets();
  }

  /// The board's place with the camera's known: F_i (x + X c_i) = p.
  void solve_board(const Vector3d& camera) {
    constexpr int kReweighings = 20;
    std::vector<double> weights(best_.fits.begin(), best_.fits.end());
    Eigen::VectorXd solution(7);
    solution << camera, 1, Vector3d::Zero();
    for (int step = 0; step < kReweighings; ++step) {
      Vector3d sum = Vector3d::Zero();
      double weight = 0;
      solution.tail<3>().setZero();
      for (std::size_t i = 0; i < flange_.size(); ++i) {
        sum += weights[i] * (equations(i) * solution + flange_[i].translation());
        weight += weights[i];
      }
      solution.tail<3>() = sum / weight;
      judge_translations(solution, weights);
    }
    accept_offsets();
  }

  /// The same with the board's size as it was given.
  void solve_at_given_size() {
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(6, 6);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(6);
    for (std::size_t i = 0; i < flange_.size(); ++i) {
      if (!best_.fits[i]) continue;
      const Eigen::Matrix<double, 3, 7> all = equations(i);
      Eigen::Matrix<double, 3, 6> rows;
      rows << all.leftCols<3>(), all.rightCols<3>();
      normal += rows.transpose() * rows;
      right -= rows.transpose() * (flange_[i].translation() + all.col(3));
    }
    const Eigen::VectorXd solution =
        Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(normal).solve(right);
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

  /// Weights of Geman and McClure, on the median's scale.
  void judge_translations(const Eigen::VectorXd& solution, std::vector<double>& weights) {
    best_.flange_to_camera.translation() = solution.head<3>();
    best_.scale = solution[3];
    best_.base_to_board.translation() = solution.tail<3>();
    std::vector<double> fitting;
    for (std::size_t i = 0; i < flange_.size(); ++i) {
      best_.offset[i] = (equations(i) * solution + flange_[i].translation()).norm();
      if (best_.fits[i]) fitting.push_back(best_.offset[i]);
    }
    constexpr double kLeast = 1e-9;   // [m]
    constexpr double kChi3 = 1.5382;  // median of the length of a vector of unit noise
    const double typical = std::max(median(fitting) / kChi3, kLeast);
    variance_ = typical * typical;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const double miss = best_.offset[i] / (4 * typical);
      weights[i] = best_.fits[i] ? 1 / ((1 + miss * miss) * (1 + miss * miss)) : 0;
    }
  }

  void accept_offsets() {
    best_.count = 0;
    for (std::size_t i = 0; i < flange_.size(); ++i) {
      const double distance = std::abs(best_.scale) * board_[i].translation().norm();
      best_.fits[i] = best_.fits[i] && best_.offset[i] < kAgreesRelative * distance;
      best_.count += best_.fits[i];
    }
  }

  const std::vector<Isometry3d>& flange_;
  const std::vector<Isometry3d>& board_;
  const Isometry3d half_turn_;
  HandEye best_;
  double least_ = std::numeric_limits<double>::infinity();
  double variance_ = 0;
};

}  // namespace

double angle_of(const Eigen::Matrix3d& rotation) {
  return rotation_vector(rotation).norm();
}

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
