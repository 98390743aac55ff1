// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "checks/session_checks.h"

#include <fmt/core.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "geometry/statistics.h"
#include "scan_cell_common/errors/errors.h"

namespace scan_calibration {
namespace {

using scan_cell_common::UnusableInput;

void check_board(const Observations& observations) {
  const Board& board = observations.board;
  if (board.columns < 2 || board.rows < 2) {
    throw UnusableInput("board", fmt::format("{} x {}", board.columns, board.rows),
                        "give the inner corners along each side, two or more");
  }
  if (!(board.square_size > 0) || !std::isfinite(board.square_size)) {
    throw UnusableInput("board square size", figure(board.square_size, " m"), "give it in metres");
  }
  if (observations.width < 1 || observations.height < 1) {
    throw UnusableInput("image size",
                        fmt::format("{} x {}", observations.width, observations.height),
                        "give the sensor's columns and rows");
  }
}

void check_view(const Observations& observations, const ViewObservation& view) {
  const auto refuse = [&](const std::string& value, const std::string& cure) {
    throw UnusableInput("view " + view.name, value, cure);
  };
  if (!view.base_to_flange.matrix().allFinite())
    refuse("its pose is not finite", "record it again");
  const Eigen::Matrix3d rotation = view.base_to_flange.linear();
  constexpr double kMaxError = 1e-6;  // of R R^T from the identity, chosen: rounding of a file
  if (!(rotation * rotation.transpose()).isIdentity(kMaxError) || !(rotation.determinant() > 0))
    refuse("its pose is not a rigid motion", "record it again");
  for (const SeenCorner& corner : view.corners) {
    if (corner.column < 0 || corner.column >= observations.board.columns || corner.row < 0 ||
        corner.row >= observations.board.rows) {
      refuse(fmt::format("corner {}, {}", corner.column, corner.row),
             "the board does not have it: check the board's size");
    }
    if (!corner.pixel.allFinite()) refuse("a corner is not finite", "detect it again");
  }
  if (view.lines.size() != observations.lasers.size()) {
    refuse(fmt::format("{} lines", view.lines.size()),
           "give one per laser, empty where it does not show");
  }
  for (const auto& line : view.lines)
    for (const Eigen::Vector2d& point : line)
      if (!point.allFinite()) refuse("a laser point is not finite", "detect it again");
}

/// Why a view does not determine a pose of the board; empty if it does.
std::string too_little(const BoardView& view, const Board& board) {
  constexpr std::size_t kMinCorners = 8;  // chosen: 16 numbers for the six of a pose
  if (view.places.size() < kMinCorners)
    return fmt::format("shows {} corners of the board; {} are needed", view.places.size(),
                       kMinCorners);
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector2d& place : view.places)
    mean += place / static_cast<double>(view.places.size());
  for (const Eigen::Vector2d& place : view.places)
    scatter += (place - mean) * (place - mean).transpose();
  const double across = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(scatter).eigenvalues()[0];
  constexpr double kMinSpread = 0.3;  // [squares] RMS, chosen: two rows have 0.5
  if (std::sqrt(across / static_cast<double>(view.places.size())) < kMinSpread * board.square_size)
    return "shows corners along one line only";
  return "";
}

/// [px] mean distance of the corners that both views show.
double corner_distance(const BoardView& a, const BoardView& b) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < a.places.size(); ++i) {
    const auto same = std::find(b.places.begin(), b.places.end(), a.places[i]);
    if (same == b.places.end()) continue;
    sum += (a.pixels[i] - b.pixels[static_cast<std::size_t>(same - b.places.begin())]).norm();
    count += 1;
  }
  return sum / count;
}

bool same_pose(const BoardView& a, const BoardView& b) {
  constexpr double kMaxDistance = 5e-4;        // [m] chosen: well above a robot's repeatability
  constexpr double kMaxAngle = 0.1 * kDegree;  // [rad] chosen: the same
  const Eigen::Isometry3d motion = a.measured.inverse() * b.measured;
  return motion.translation().norm() < kMaxDistance && angle_of(motion.linear()) < kMaxAngle;
}

/// Of views with the same pose that show the same, keeps the first.
void leave_out_repeated(UsableViews& usable) {
  constexpr double kMaxDistance = 3;  // [px] of the corners, chosen
  BoardViews kept;
  for (BoardView& view : usable.views) {
    const auto repeats = [&](const BoardView& other) {
      return same_pose(other, view) && corner_distance(other, view) < kMaxDistance;
    };
    const auto first = std::find_if(kept.begin(), kept.end(), repeats);
    if (first == kept.end()) {
      kept.push_back(std::move(view));
    } else {
      usable.rejected.push_back(
          {view.name, "", "repeats the pose of " + first->name + ": it shows nothing new"});
    }
  }
  usable.views = std::move(kept);
}

/// Refuses poses that are the same for different images: they were not recorded.
void check_distinct(const BoardViews& views) {
  std::vector<const BoardView*> distinct;
  std::string repeated;
  for (const BoardView& view : views) {
    const auto same = std::find_if(distinct.begin(), distinct.end(),
                                   [&](const BoardView* other) { return same_pose(*other, view); });
    if (same == distinct.end()) {
      distinct.push_back(&view);
    } else if (repeated.empty()) {
      repeated = view.name + " has the pose of " + (*same)->name;
    }
  }
  if (distinct.size() < kMinViews) {
    throw UnusableInput(
        "poses of the session",
        fmt::format("only {} different in {} views: {}", distinct.size(), views.size(), repeated),
        fmt::format("record the pose of every view; {} different ones are needed, 15 or more are "
                    "recommended",
                    kMinViews));
  }
}

}  // namespace

UsableViews usable_board_views(const Observations& observations) {
  check_board(observations);
  UsableViews result;
  result.rejected = observations.rejected;
  for (std::size_t i = 0; i < observations.views.size(); ++i) {
    check_view(observations, observations.views[i]);
    BoardView view = board_view(observations, i);
    const std::string reason = too_little(view, observations.board);
    if (reason.empty()) {
      result.views.push_back(std::move(view));
    } else {
      result.rejected.push_back({view.name, "", reason});
    }
  }
  return result;
}

UsableViews usable_views(const Observations& observations) {
  UsableViews result = usable_board_views(observations);
  leave_out_repeated(result);
  check_enough(result.views, result.rejected);
  check_distinct(result.views);
  check_lasers_seen(observations, result.views);
  return result;
}

void check_enough(const BoardViews& views, const std::vector<RejectedView>& rejected) {
  if (views.size() >= kMinViews) return;
  std::string value = fmt::format("{} usable", views.size());
  const auto first = std::find_if(rejected.begin(), rejected.end(),
                                  [](const RejectedView& view) { return view.laser.empty(); });
  if (first != rejected.end()) value += fmt::format(", {} {}", first->name, first->reason);
  throw UnusableInput("views of the session", value,
                      fmt::format("{} at different poses are needed, 15 or more are recommended: "
                                  "add some",
                                  kMinViews));
}

void check_lasers_seen(const Observations& observations, const BoardViews& views) {
  constexpr std::size_t kMinLines = 3;   // chosen: two lines fit more than one plane
  constexpr std::size_t kMinPoints = 5;  // of a line, chosen
  for (std::size_t laser = 0; laser < observations.lasers.size(); ++laser) {
    const auto seen = static_cast<std::size_t>(std::count_if(
        views.begin(), views.end(),
        [&](const BoardView& view) { return view.lines[laser].pixels.size() >= kMinPoints; }));
    if (seen >= kMinLines) continue;
    throw UnusableInput(observations.lasers[laser],
                        "its line shows in " + share(seen, views.size()) + " views",
                        seen == 0 ? "check that it is switched on, its peaks and its exposure"
                                  : fmt::format("at least {} are needed: hold the board in its "
                                                "light",
                                                kMinLines));
  }
}

}  // namespace scan_calibration
