// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "quality/advice.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "geometry/statistics.h"

namespace scan_calibration {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

/// A pose of the board; directions are those of the image.
struct Candidate {
  double distance = 0;    // [m] of the board's centre along the optical axis
  double tilt = 0;        // [rad]
  int toward = 0;         // the edge that is further away: right, lower, left, upper
  Eigen::Vector2i place;  // -1, 0, 1: of the board in the image
  Isometry3d camera_to_board = Isometry3d::Identity();
  double variance = 0;  // [m^2] mean over the scan places, with this view added
};

std::string words(const Candidate& candidate, double now_mm, double then_mm) {
  const char* const sides[] = {"right", "lower", "left", "upper"};
  const char* const rows[] = {"upper ", "", "lower "};
  const char* const columns[] = {"left", "middle", "right"};
  const std::string tilt = candidate.tilt > 0
                               ? fmt::format("tilted by {:.0f} deg with its {} edge further away",
                                             candidate.tilt * 180 / M_PI, sides[candidate.toward])
                               : "perpendicular to the optical axis";
  return fmt::format(
      "board in the {}{} of the image, its middle {:.2f} m from the lens, {}: the standard "
      "deviation of a point would fall from {} to {} (RMS over image and depths)",
      rows[candidate.place.y() + 1], columns[candidate.place.x() + 1], candidate.distance, tilt,
      figure(now_mm, " mm"), figure(then_mm, " mm"));
}

/// Smallest and largest depth of the board's centre [m].
std::pair<double, double> distances(const JointEstimate& estimate, const BoardSurface& surface) {
  double nearest = 1e9, farthest = 0;
  for (std::size_t i = 0; i < estimate.views.size(); ++i) {
    const BoardSight sight = sight_of(estimate.state, estimate.views[i], i);
    const double depth =
        (sight.rotation * on_board(surface, estimate.state.bend, surface.centre()) + sight.position)
            .z();
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  return {nearest, farthest};
}

/// The board's mean rotation about the optical axis.
Eigen::Matrix3d usual_turn(const JointEstimate& estimate) {
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < estimate.views.size(); ++i)
    sum += sight_of(estimate.state, estimate.views[i], i).rotation.topLeftCorner<2, 2>();
  const double angle = std::atan2(sum(1, 0) - sum(0, 1), sum(0, 0) + sum(1, 1));
  return Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
}

/// Where a laser's line would be seen on the board.
/// @param seen whether a place on the board is in the image, and its pixel
template <class Seen>
LinePoints line_of(const Vector3d& plane, const BoardSurface& surface,
                   const Isometry3d& camera_to_board, const Seen& seen) {
  constexpr int kPoints = 50;  // each way, chosen: as many as of an observed line
  const double long_side = 2 * surface.centre().norm();
  // plane . (R b + t) = 1 is a line on the board
  const Eigen::Vector2d across = (camera_to_board.linear().transpose() * plane).head<2>();
  const double left = 1 - plane.dot(camera_to_board.translation());
  const Eigen::Vector2d to_line =
      (left - across.dot(surface.centre())) / across.squaredNorm() * across;
  const Eigen::Vector2d along = Eigen::Vector2d(-across.y(), across.x()).normalized();
  LinePoints line;
  Eigen::Vector2d pixel;
  for (int i = -kPoints; i <= kPoints; ++i) {
    const Eigen::Vector2d place =
        surface.centre() + to_line + i * long_side / (2 * kPoints) * along;
    const Eigen::Vector2d from_centre = (place - surface.centre()).cwiseAbs();
    if ((from_centre.array() > surface.centre().array()).any() || !seen(place, pixel)) continue;
    line.pixels.push_back(pixel);
    line.weights.push_back(1);
  }
  return line;
}

/// What a view of the whole board would show.
/// @return false if some of the board is outside the image
bool look(const JointEstimate& estimate, const Board& board, const BoardSurface& surface,
          const Isometry3d& camera_to_board, BoardView& view) {
  const scan_cell_common::CameraIntrinsics camera = estimate.state.intrinsics();
  const auto seen = [&](const Eigen::Vector2d& place, Eigen::Vector2d& pixel) {
    const Vector3d point = camera_to_board * on_board(surface, estimate.state.bend, place);
    if (!(point.z() > 0)) return false;
    pixel = camera.project(point);
    return camera.contains(pixel);
  };
  Eigen::Vector2d pixel;
  for (int row = -1; row <= board.rows; ++row)
    for (int column = -1; column <= board.columns; ++column) {
      const Eigen::Vector2d place = Eigen::Vector2d(column, row) * board.square_size;
      if (!seen(place, pixel)) return false;
      if (row < 0 || column < 0 || row == board.rows || column == board.columns) continue;
      view.places.push_back(place);
      view.pixels.push_back(pixel);
    }
  view.weights.assign(view.pixels.size(), 1);
  for (const Vector3d& plane : estimate.state.planes)
    view.lines.push_back(line_of(plane, surface, camera_to_board, seen));
  return true;
}

std::vector<Candidate> candidates(const JointEstimate& estimate, const BoardSurface& surface) {
  const auto [nearest, farthest] = distances(estimate, surface);
  const Eigen::Matrix3d turn = usual_turn(estimate);
  const scan_cell_common::CameraIntrinsics camera = estimate.state.intrinsics();
  constexpr double kAside = 0.22;  // of the image, from its middle; chosen
  std::vector<Candidate> result;
  for (const double part : {0., 0.5, 1.})
    for (const double tilt : {0., 20 * kDegree, 40 * kDegree})
      for (int toward = 0; toward < (tilt > 0 ? 4 : 1); ++toward)
        for (int y = -1; y <= 1; ++y)
          for (int x = -1; x <= 1; ++x) {
            Candidate candidate;
            candidate.distance = nearest + part * (farthest - nearest);
            candidate.tilt = tilt;
            candidate.toward = toward;
            candidate.place = {x, y};
            const double direction = toward * M_PI / 2;  // x to the right, y down
            const Vector3d axis(std::sin(direction), -std::cos(direction), 0);
            candidate.camera_to_board.linear() = Eigen::AngleAxisd(tilt, axis) * turn;
            const Vector3d centre(
                candidate.distance * (kAside * x * camera.width + camera.width / 2. - camera.cx) /
                    camera.fx,
                candidate.distance * (kAside * y * camera.height + camera.height / 2. - camera.cy) /
                    camera.fy,
                candidate.distance);
            const Vector3d middle(surface.centre().x(), surface.centre().y(), 0);
            candidate.camera_to_board.translation() =
                centre - candidate.camera_to_board.linear() * middle;
            result.push_back(candidate);
          }
  return result;
}

Isometry3d flange_for(const ScannerState& state, const Isometry3d& camera_to_board) {
  return state.base_to_board * camera_to_board.inverse() * state.flange_to_camera.inverse();
}

/// Information that a view would add.
Eigen::MatrixXd added_information(const JointEstimate& estimate, const BoardSurface& surface,
                                  BoardView view, const Isometry3d& camera_to_board) {
  view.measured = flange_for(estimate.state, camera_to_board);
  ScannerState state = estimate.state;
  state.corrections.assign(1, Vector6d::Zero());
  const NormalEquations equations({std::move(view)}, surface, estimate.noise.levels,
                                  estimate.choice, state);
  return reduce(equations.views.front(), Eigen::VectorXd::Ones(equations.noise.size())).information;
}

bool alike(const Candidate& a, const Candidate& b) {
  return a.place == b.place || (a.tilt == b.tilt && a.toward == b.toward);
}

}  // namespace

std::vector<PoseAdvice> advise(const JointEstimate& estimate, const Knowledge& knowledge,
                               const Board& board, const std::vector<ScanPlace>& places) {
  constexpr std::size_t kMaxAdvice = 3;  // chosen: then calibrate again
  if (places.empty()) return {};
  const BoardSurface surface(board);
  const auto count = static_cast<double>(places.size());
  Eigen::MatrixXd rows(3 * static_cast<Eigen::Index>(places.size()), knowledge.layout.size);
  for (std::size_t i = 0; i < places.size(); ++i)
    rows.middleRows<3>(3 * static_cast<Eigen::Index>(i)) =
        triangulation_derivative(estimate, knowledge, places[i]);
  const Eigen::MatrixXd weight = rows.transpose() * rows / count;
  const double now = knowledge.covariance.cwiseProduct(weight).sum();
  const double stated = knowledge.deviation(rows) / std::sqrt(count);
  std::vector<Candidate> tried;
  for (Candidate& candidate : candidates(estimate, surface)) {
    BoardView view;
    if (!look(estimate, board, surface, candidate.camera_to_board, view)) continue;
    const Eigen::MatrixXd information =
        knowledge.information +
        added_information(estimate, surface, std::move(view), candidate.camera_to_board);
    candidate.variance = inverse_of_information(information).cwiseProduct(weight).sum();
    tried.push_back(candidate);
  }
  std::stable_sort(tried.begin(), tried.end(),
                   [](const Candidate& a, const Candidate& b) { return a.variance < b.variance; });
  std::vector<PoseAdvice> advice;
  std::vector<Candidate> chosen;
  for (const Candidate& candidate : tried) {
    if (chosen.size() == kMaxAdvice) break;
    if (std::any_of(chosen.begin(), chosen.end(),
                    [&](const Candidate& other) { return alike(other, candidate); })) {
      continue;
    }
    chosen.push_back(candidate);
    const double then = stated * std::sqrt(candidate.variance / now);
    advice.push_back({words(candidate, 1e3 * stated, 1e3 * then),
                      flange_for(estimate.state, candidate.camera_to_board), 1e3 * then});
  }
  return advice;
}

}  // namespace scan_calibration
