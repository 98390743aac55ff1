// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "checks/diagnosis.h"

#include <fmt/core.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "geometry/scanner_state.h"
#include "geometry/statistics.h"
#include "scan_cell_common/errors/errors.h"

namespace scan_calibration {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using scan_cell_common::UnusableInput;

const char* const kPoses = "poses of the session";

/// Median angles by which flange and camera turned between views. They are equal wherever the
/// camera sits on the flange.
struct Turns {
  double flange = 0, camera = 0;  // [rad]

  std::string text() const {
    return fmt::format("the flange turns by {} between views, the camera by {} (medians)",
                       degrees(flange), degrees(camera));
  }
};

Turns median_turns(const PosePairs& pairs) {
  std::vector<double> flange, camera;
  for (std::size_t i = 0; i < pairs.flange.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      flange.push_back(angle_of(pairs.flange[i].linear().transpose() * pairs.flange[j].linear()));
      camera.push_back(angle_of(pairs.board[i].linear() * pairs.board[j].linear().transpose()));
    }
  return {median(flange), median(camera)};
}

/// Image i with pose i + shift.
PosePairs shifted(const PosePairs& pairs, int shift) {
  PosePairs result;
  for (int i = 0; i < static_cast<int>(pairs.flange.size()); ++i) {
    const int pose = i + shift;
    if (pose < 0 || pose >= static_cast<int>(pairs.flange.size())) continue;
    result.names.push_back(pairs.names[static_cast<std::size_t>(i)]);
    result.flange.push_back(pairs.flange[static_cast<std::size_t>(pose)]);
    result.board.push_back(pairs.board[static_cast<std::size_t>(i)]);
  }
  return result;
}

[[noreturn]] void refuse_step(int shift, const std::string& from, std::size_t part,
                              std::size_t whole) {
  const char* const place = std::abs(shift) > 1 ? "second " : "";
  throw UnusableInput(
      kPoses,
      fmt::format("out of step with the images: from {} on, {} images go with the pose of the "
                  "{}view {} it",
                  from, share(part, whole), place, shift > 0 ? "after" : "before"),
      shift > 0 ? "before that view, one pose too many was recorded or an image is missing"
                : "before that view, one image too many was recorded or a pose is missing");
}

void check_step(const PosePairs& pairs, const Isometry3d& half_turn) {
  for (const int shift : {1, -1, 2, -2}) {
    const PosePairs trial = shifted(pairs, shift);
    const HandEye found = fit_hand_eye(trial.flange, trial.board, half_turn);
    if (agree(found, trial.flange.size())) {
      const auto first = std::find(found.fits.begin(), found.fits.end(), true);
      refuse_step(shift, trial.names[static_cast<std::size_t>(first - found.fits.begin())],
                  found.count, trial.flange.size());
    }
  }
}

/// Refuses poses if views fit a neighbour's pose instead of their own.
void check_later_step(const PosePairs& pairs, const HandEye& found, const Isometry3d& half_turn) {
  constexpr std::size_t kMinMisfits = 3;    // chosen: fewer are single errors
  constexpr double kMaxTurn = 2 * kDegree;  // chosen: as for a view that fits (hand_eye.cpp)
  for (const int shift : {1, -1}) {
    std::size_t misfits = 0, cured = 0;
    std::string first;
    for (int i = 0; i < static_cast<int>(pairs.flange.size()); ++i) {
      const auto image = static_cast<std::size_t>(i);
      const int pose = i + shift;
      if (found.fits[image] || pose < 0 || pose >= static_cast<int>(pairs.flange.size())) continue;
      ++misfits;
      Isometry3d board = pairs.board[image];
      board.translation() *= found.scale;
      const Isometry3d miss = found.base_to_board.inverse() *
                              pairs.flange[static_cast<std::size_t>(pose)] *
                              found.flange_to_camera * board;
      const double angle =
          std::min(angle_of(miss.linear()), angle_of(miss.linear() * half_turn.linear()));
      if (angle > kMaxTurn) continue;
      if (cured++ == 0) first = pairs.names[image];
    }
    if (misfits >= kMinMisfits && 5 * cured >= 4 * misfits)
      refuse_step(shift, first, cured, misfits);
  }
}

void check_direction(const PosePairs& pairs, const Isometry3d& half_turn) {
  PosePairs inverse = pairs;
  for (Isometry3d& pose : inverse.flange)
    pose = pose.inverse();
  const HandEye found = fit_hand_eye(inverse.flange, inverse.board, half_turn);
  if (!agree(found, pairs.flange.size())) return;
  throw UnusableInput(kPoses,
                      share(found.count, pairs.flange.size()) + " fit the images when inverted",
                      "give the pose of tool0 in base_link, not of base_link in tool0");
}

/// Radians read as degrees give small angles.
void check_radians_as_degrees(const PosePairs& pairs, const Turns& turns) {
  constexpr double kMaxAngle = 3 * M_PI * kDegree;  // [rad] three Euler angles of pi "degrees"
  constexpr double kMinRatio = 4;                   // chosen; radians as degrees give 57
  double largest = 0;
  for (const Isometry3d& pose : pairs.flange)
    largest = std::max(largest, angle_of(pose.linear()));
  if (largest > kMaxAngle || turns.camera < kMinRatio * turns.flange) return;
  throw UnusableInput("angles of the poses", turns.text(),
                      "they are in radians and were read as degrees");
}

/// How well the flange's positions [m] agree with the camera's poses, without the flange's
/// orientations: board and flange are fitted in turn. RMS relative to the flange's travel.
double position_misfit(const PosePairs& pairs) {
  constexpr int kSteps = 200;  // chosen: alternating fits converge slowly
  const auto count = static_cast<Eigen::Index>(pairs.flange.size());
  Eigen::Matrix3Xd flange(3, count), camera(3, count);
  std::vector<Matrix3d> turn;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Isometry3d in_board = pairs.board[static_cast<std::size_t>(i)].inverse();
    flange.col(i) = pairs.flange[static_cast<std::size_t>(i)].translation();
    camera.col(i) = in_board.translation();
    turn.push_back(in_board.linear());
  }
  const double travel = (flange.colwise() - flange.rowwise().mean()).norm();
  Vector3d lever = Vector3d::Zero();  // of the flange in the camera
  double misfit = 1;
  for (int step = 0; step < kSteps; ++step) {
    Eigen::Matrix3Xd expected = camera;
    for (Eigen::Index i = 0; i < count; ++i)
      expected.col(i) += turn[static_cast<std::size_t>(i)] * lever;
    const Eigen::Matrix4d fit = Eigen::umeyama(expected, flange, true);
    const Eigen::Matrix3Xd back = (fit.inverse() * flange.colwise().homogeneous()).topRows<3>();
    misfit = (fit.topLeftCorner<3, 3>() * (back - expected)).norm() / travel;
    // The best lever, with the board free to shift
    Eigen::MatrixXd rows(3 * count, 6);
    Eigen::VectorXd right(3 * count);
    for (Eigen::Index i = 0; i < count; ++i) {
      rows.block<3, 3>(3 * i, 0) = turn[static_cast<std::size_t>(i)];
      rows.block<3, 3>(3 * i, 3).setIdentity();
      right.segment<3>(3 * i) = back.col(i) - camera.col(i);
    }
    lever = rows.colPivHouseholderQr().solve(right).head<3>();
  }
  return misfit;
}

void check_orientations(const PosePairs& pairs, const Turns& turns) {
  constexpr double kMaxMisfit = 0.05;  // of the flange's travel, chosen
  constexpr double kMinRatio = 1.5;    // chosen: scrambled angles turn further than the camera
  if (!(position_misfit(pairs) < kMaxMisfit)) return;
  const bool scrambled = turns.flange > kMinRatio * turns.camera;
  throw UnusableInput(
      "angles of the poses",
      "the flange's positions fit the images, its orientations do not: " + turns.text(),
      scrambled ? "degrees were read as radians, or the angles follow another convention "
                  "(order, axes, order of the quaternion)"
                : "check the convention of the angles: their order and axes, or the order of the "
                  "quaternion");
}

/// The flange must turn about two axes, far enough.
void check_axes(const PosePairs& pairs, const HandEye& found) {
  constexpr double kMinTurn = 2 * kDegree;  // RMS, chosen
  Matrix3d scatter = Matrix3d::Zero();
  double count = 0;
  const auto first = static_cast<std::size_t>(
      std::find(found.fits.begin(), found.fits.end(), true) - found.fits.begin());
  for (std::size_t i = 0; i < pairs.flange.size(); ++i) {
    if (!found.fits[i] || i == first) continue;
    const Vector3d turn =
        rotation_vector(pairs.flange[first].linear().transpose() * pairs.flange[i].linear());
    scatter += turn * turn.transpose();
    count += 1;
  }
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(scatter / count);
  const double second = std::sqrt(std::max(0., axes.eigenvalues()[1]));
  if (second > kMinTurn) return;
  if (std::sqrt(axes.eigenvalues()[2]) < kMinTurn) {
    throw UnusableInput("orientations of the flange", "they do not differ",
                        "the camera's pose on the flange is undetermined: turn the flange by 20 "
                        "degrees or more about two axes");
  }
  const Vector3d axis = axes.eigenvectors().col(2);
  throw UnusableInput(
      "orientations of the flange",
      fmt::format("about one axis only ({:.2f} {:.2f} {:.2f} in tool0), {:.2g} deg about others",
                  axis.x(), axis.y(), axis.z(), second / kDegree),
      "the camera's position on the flange along this axis is undetermined: turn the flange by 20 "
      "degrees or more about a second axis too");
}

}  // namespace

bool agree(const HandEye& found, std::size_t of) {
  constexpr double kMinShare = 0.6;     // of the views, chosen
  constexpr std::size_t kMinCount = 4;  // chosen: three always agree
  return found.count >= kMinCount &&
         static_cast<double>(found.count) >= kMinShare * static_cast<double>(of);
}

void check_tilts(const PosePairs& pairs) {
  constexpr double kMinTilt = 5 * kDegree;  // between two views, chosen
  double widest = 0;
  for (const Isometry3d& a : pairs.board)
    for (const Isometry3d& b : pairs.board)
      widest = std::max(widest,
                        std::acos(std::clamp(a.linear().col(2).dot(b.linear().col(2)), -1., 1.)));
  if (widest > kMinTilt) return;
  throw UnusableInput(
      "views of the session",
      "all parallel: the board's tilt to the camera differs by " + degrees(widest) + " at most",
      "focal length, distance and the camera's position on the flange are undetermined: tilt the "
      "camera by 20 degrees or more, in several directions");
}

HandEye agreed_hand_eye(const PosePairs& pairs, const BoardSurface& surface) {
  const Isometry3d half_turn = surface.half_turn();
  const HandEye found = fit_hand_eye(pairs.flange, pairs.board, half_turn);
  if (agree(found, pairs.flange.size())) {
    check_axes(pairs, found);
    check_later_step(pairs, found, half_turn);
    return found;
  }
  const Turns turns = median_turns(pairs);
  check_radians_as_degrees(pairs, turns);
  check_step(pairs, half_turn);
  check_direction(pairs, half_turn);
  check_orientations(pairs, turns);
  throw UnusableInput(
      kPoses,
      fmt::format("{} views agree on where the camera sits on the flange; {}",
                  share(found.count, pairs.flange.size()), turns.text()),
      "check that each pose is of tool0 in base_link and belongs to its image, and that the board "
      "did not move");
}

void check_board_size(const HandEye& hand_eye, const PosePairs& pairs, double square_size) {
  constexpr double kMaxMiss = 0.03;     // chosen: a board bent by a millimetre can cause half of it
  constexpr double kMinDeviations = 5;  // chosen
  const double miss = std::abs(hand_eye.scale - 1);
  if (miss < kMaxMiss || miss < kMinDeviations * hand_eye.scale_deviation) return;
  double travel = 0;
  for (const Isometry3d& pose : pairs.flange)
    travel = std::max(travel, (pose.translation() - pairs.flange.front().translation()).norm());
  constexpr double kMaxTravel = 20;  // [m] of any robot, chosen
  if (travel > kMaxTravel) {
    throw UnusableInput("positions of the poses",
                        fmt::format("the flange travels {} where the images show {}",
                                    figure(travel, " m"), figure(travel / hand_eye.scale, " m")),
                        "they are in millimetres: give metres");
  }
  throw UnusableInput("board square size",
                      fmt::format("{}; the robot's travel says {} +- {}", millimetres(square_size),
                                  millimetres(square_size * hand_eye.scale),
                                  millimetres(square_size * hand_eye.scale_deviation)),
                      "measure the board, and check the units of its size and of the poses");
}

}  // namespace scan_calibration
