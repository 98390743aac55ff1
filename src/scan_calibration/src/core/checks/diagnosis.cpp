// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "checks/diagnosis.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "geometry/scanner_state.h"
#include "geometry/statistics.h"
#include "scan_cell_common/errors.h"

namespace scan_calibration {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using scan_cell_common::UnusableInput;

constexpr double kDegree = M_PI / 180;
const char* const kPoses = "poses of the session";

std::string degrees(double angle) {
  return figure(angle / kDegree, " deg");
}

/// Median angle that the flange turned between views, and that the camera did: the same, wherever
/// the camera sits on the flange.
struct Turns {
  double flange = 0, camera = 0;  // [rad]
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
  const std::string which =
      shift > 0 ? "with the pose of the view after it" : "with the pose of the view before it";
  throw UnusableInput(kPoses,
                      "out of step with the images: from " + from + " on, " + share(part, whole) +
                          " images go " + which + (std::abs(shift) > 1 ? " the next" : ""),
                      shift > 0
                          ? "a pose too many was recorded, or an image is missing, before it"
                          : "an image too many was recorded, or a pose is missing, before it");
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

/// Views that do not fit as they are but do with a neighbour's pose.
void check_later_step(const PosePairs& pairs, const HandEye& found, const Isometry3d& half_turn) {
  constexpr std::size_t kFew = 3;
  constexpr double kTurn = 2 * kDegree;
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
      if (angle > kTurn) continue;
      if (cured++ == 0) first = pairs.names[image];
    }
    if (misfits >= kFew && 5 * cured >= 4 * misfits) refuse_step(shift, first, cured, misfits);
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

/// An angle of so many radians, read as degrees, is small whatever it was.
void check_radians_as_degrees(const PosePairs& pairs, const Turns& turns) {
  constexpr double kMost = 3 * M_PI * kDegree;  // three Euler angles of half a turn
  constexpr double kRatio = 4;
  double largest = 0;
  for (const Isometry3d& pose : pairs.flange)
    largest = std::max(largest, angle_of(pose.linear()));
  if (largest > kMost || turns.camera < kRatio * turns.flange) return;
  throw UnusableInput("angles of the poses",
                      "the flange turns by " + degrees(turns.flange) +
                          " between views where the camera turns by " + degrees(turns.camera) +
                          " (medians)",
                      "they are in radians and were read as degrees");
}

/// How well the flange's positions [m] agree with the camera's poses when nothing is said of the
/// flange's orientation: board and flange in turn, as relative RMS of the flange's travel.
double position_misfit(const PosePairs& pairs) {
  constexpr int kSteps = 200;
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
    // The lever that suits best, the board's plane free to shift
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
  constexpr double kSmall = 0.05;
  constexpr double kRatio = 1.5;
  if (!(position_misfit(pairs) < kSmall)) return;
  const bool scrambled = turns.flange > kRatio * turns.camera;
  throw UnusableInput(
      "angles of the poses",
      "the flange's positions fit the images, its orientations do not: it turns by " +
          degrees(turns.flange) + " between views where the camera turns by " +
          degrees(turns.camera) + " (medians)",
      scrambled ? "degrees were read as radians, or the convention of the angles "
                  "(order, axes, quaternion's order) is another"
                : "check the convention of the angles: their order and axes, or "
                  "the order of the quaternion");
}

/// About how many axes the flange turned, and how far.
void check_axes(const PosePairs& pairs, const HandEye& found) {
  constexpr double kLeast = 2 * kDegree;
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
  if (second > kLeast) return;
  const Vector3d axis = axes.eigenvectors().col(2);
  const bool none = std::sqrt(axes.eigenvalues()[2]) < kLeast;
  char text[160];
  std::snprintf(text, sizeof(text),
                "about one axis only (%.2f %.2f %.2f in tool0), %.2g deg about others", axis.x(),
                axis.y(), axis.z(), second / kDegree);
  throw UnusableInput(
      "orientations of the flange", none ? "they do not differ" : text,
      none ? "the camera's pose on the flange is left undetermined: turn the flange by 20 degrees "
             "or more about two axes"
           : "the camera's place on the flange along this axis is left undetermined: turn the "
             "flange by 20 degrees or more about a second axis too");
}

}  // namespace

bool agree(const HandEye& found, std::size_t of) {
  constexpr double kMost = 0.6;
  return found.count >= 4 && static_cast<double>(found.count) >= kMost * static_cast<double>(of);
}

void check_tilts(const PosePairs& pairs) {
  constexpr double kLeast = 5 * kDegree;
  double widest = 0;
  for (const Isometry3d& a : pairs.board)
    for (const Isometry3d& b : pairs.board)
      widest = std::max(widest,
                        std::acos(std::clamp(a.linear().col(2).dot(b.linear().col(2)), -1., 1.)));
  if (widest > kLeast) return;
  throw UnusableInput(
      "views of the session",
      "all parallel: the board's tilt to the camera differs by " + degrees(widest) + " at most",
      "focal length and distance, and the camera's place on the flange, are left undetermined: "
      "tilt the camera by 20 degrees or more, in several directions");
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
      share(found.count, pairs.flange.size()) +
          " views agree on where the camera sits on the flange; the flange turns by " +
          degrees(turns.flange) + " between views, the camera by " + degrees(turns.camera) +
          " (medians)",
      "check that each pose is of tool0 in base_link, that it belongs to its image, and that the "
      "board stood still");
}

void check_board_size(const HandEye& hand_eye, const PosePairs& pairs, double square_size) {
  constexpr double kMost = 0.03;  // a board bent by a millimetre may feign half of it
  constexpr double kSure = 5;     // deviations
  const double miss = std::abs(hand_eye.scale - 1);
  if (miss < kMost || miss < kSure * hand_eye.scale_deviation) return;
  double travel = 0;
  for (const Isometry3d& pose : pairs.flange)
    travel = std::max(travel, (pose.translation() - pairs.flange.front().translation()).norm());
  constexpr double kRoom = 20;  // [m] that no robot travels
  if (travel > kRoom) {
    throw UnusableInput("positions of the poses",
                        "the flange travels " + figure(travel, " m") + " where the images show " +
                            figure(travel / hand_eye.scale, " m"),
                        "they are in millimetres: give metres, or say so");
  }
  throw UnusableInput("board square size",
                      figure(square_size * 1e3, " mm") + "; the robot's travel says " +
                          figure(square_size * hand_eye.scale * 1e3, " mm") + " +- " +
                          figure(square_size * hand_eye.scale_deviation * 1e3, " mm"),
                      "measure the board, and check the units of its size and of the poses");
}

}  // namespace scan_calibration
