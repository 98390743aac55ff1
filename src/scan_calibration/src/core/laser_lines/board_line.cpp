// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "laser_lines/board_line.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/sight.h"
#include "geometry/statistics.h"
#include "laser_lines/straight_line.h"

namespace scan_calibration {
namespace {

using Eigen::Vector2d;
using scan_cell_common::CameraIntrinsics;

constexpr double kMinTolerance = 1;      // [px] off the line in the vote, chosen
constexpr double kWidthTolerance = 0.1;  // of the stripe's width: speckle moves a wide one more
constexpr double kOnChecker = 4;         // votes of a peak on the checker, chosen
constexpr double kCheckerMargin = 0.5;   // squares, chosen: the pose is rough
constexpr double kMaxStripe = 0.5;       // of a square's side, chosen: wider is a bright square
constexpr double kMinSlope = 0.6;        // of the line along the crossed rows, chosen: 37 degrees
constexpr std::size_t kMinPoints = 20;   // chosen
constexpr double kMinFill = 0.3;         // share of rows with a peak on the line, chosen

/// The board in a view: pixels to rays and to places on the board.
class BoardPlane {
 public:
  BoardPlane(const CameraIntrinsics& camera, const Eigen::Isometry3d& board_in_camera,
             const Board& board)
      : camera_(camera), board_(board) {
    Eigen::Matrix3d to_ray;
    to_ray << board_in_camera.linear().col(0), board_in_camera.linear().col(1),
        board_in_camera.translation();
    to_squares_ = to_ray.inverse();
  }

  /// The pixel without the lens's distortion, which would bend a straight line.
  bool straighten(const Vector2d& pixel, Vector2d& straight) const {
    const std::optional<Eigen::Vector3d> ray = ray_of(camera_, pixel);
    if (!ray) return false;
    straight = ray->head<2>().cwiseProduct(Vector2d(camera_.fx, camera_.fy));
    return straight.allFinite();
  }

  /// Place on the board in squares; corners have whole numbers.
  Vector2d square_of(const Vector2d& straight) const {
    const Eigen::Vector3d place =
        to_squares_ * Eigen::Vector3d(straight.x() / camera_.fx, straight.y() / camera_.fy, 1);
    return place.head<2>() / (place.z() * board_.square_size);
  }

  bool on_checker(const Vector2d& square, double margin) const {
    return square.x() > -1 - margin && square.x() < board_.columns + margin &&
           square.y() > -1 - margin && square.y() < board_.rows + margin;
  }

  /// [px] of a square's shorter side about a place.
  double square_size(const Vector2d& straight) const {
    const Vector2d here = square_of(straight);
    const double along_x = (square_of(straight + Vector2d(1, 0)) - here).norm();
    const double along_y = (square_of(straight + Vector2d(0, 1)) - here).norm();
    return 1 / std::max(along_x, along_y);
  }

  /// Whether another square begins within `reach` [px] on one of four sides.
  bool is_at_edge(const Vector2d& straight, double reach) const {
    const Vector2d here = square_of(straight);
    for (const Vector2d& way :
         {Vector2d(reach, 0), Vector2d(-reach, 0), Vector2d(0, reach), Vector2d(0, -reach)}) {
      const Vector2d there = square_of(straight + way);
      if (!on_checker(here, 0) && !on_checker(there, 0)) continue;
      if (std::floor(here.x()) != std::floor(there.x()) ||
          std::floor(here.y()) != std::floor(there.y()))
        return true;
    }
    return false;
  }

 private:
  const CameraIntrinsics& camera_;
  const Board& board_;
  Eigen::Matrix3d to_squares_;  // rays (x/z, y/z, 1) to the board [m]
};

struct Candidate {
  LinePeak peak;
  Vector2d straight;
};

/// One way through the image, and the line found on it.
struct Crossing {
  bool along_columns = true;
  std::vector<Candidate> candidates;
  StraightLine line;
};

Crossing cross(const LinePeaks& way, const BoardPlane& view) {
  Crossing result;
  result.along_columns = way.along_columns;
  std::vector<LinePoint> points;
  for (const LinePeak& peak : way.peaks) {
    Candidate candidate{peak, {}};
    if (!view.straighten(peak.pixel, candidate.straight)) continue;
    const bool on_checker = view.on_checker(view.square_of(candidate.straight), kCheckerMargin);
    if (on_checker && peak.width > kMaxStripe * view.square_size(candidate.straight)) continue;
    result.candidates.push_back(candidate);
    points.push_back({candidate.straight, std::max(kMinTolerance, kWidthTolerance * peak.width),
                      on_checker ? kOnChecker : 1});
  }
  result.line = strongest_line(points);
  const Vector2d direction = result.line.direction.cwiseAbs();
  const double along = way.along_columns ? direction.y() : direction.x();
  if (along < kMinSlope) result.line.votes = 0;  // the other way crosses it better
  return result;
}

/// In each row (or column) of the image, the peak nearest to the line, in order along the line.
std::vector<Candidate> on_line(const Crossing& crossing) {
  constexpr double kMinWidest = 2, kWidestShare = 0.25;  // [px], of the stripe's width; chosen
  constexpr double kDeviations = 3.5;                    // chosen: one of 2000 is beyond
  constexpr double kNarrowest = 0.5;                     // [px] chosen
  std::map<long, Candidate> nearest;
  for (const Candidate& candidate : crossing.candidates) {
    const double widest = std::max(kMinWidest, kWidestShare * candidate.peak.width);
    const double tolerance = std::clamp(kDeviations * crossing.line.deviation, kNarrowest, widest);
    const double off = std::abs(crossing.line.distance(candidate.straight));
    if (off > tolerance) continue;
    const Vector2d& pixel = candidate.peak.pixel;
    const long row = std::lround(crossing.along_columns ? pixel.y() : pixel.x());
    const auto [known, added] = nearest.emplace(row, candidate);
    if (!added && off < std::abs(crossing.line.distance(known->second.straight)))
      known->second = candidate;
  }
  std::vector<Candidate> result;
  if (nearest.empty()) return result;
  const auto rows = static_cast<double>(nearest.rbegin()->first - nearest.begin()->first + 1);
  if (static_cast<double>(nearest.size()) < kMinFill * rows) return result;
  for (const auto& [row, candidate] : nearest)
    result.push_back(candidate);
  return result;
}

int rows_with_peaks(const Crossing& crossing) {
  std::map<long, int> rows;
  for (const Candidate& candidate : crossing.candidates)
    ++rows[std::lround(crossing.along_columns ? candidate.peak.pixel.y()
                                              : candidate.peak.pixel.x())];
  return static_cast<int>(rows.size());
}

std::vector<Vector2d> thinned(const std::vector<Vector2d>& pixels, int max_points) {
  std::vector<Vector2d> result;
  for (const std::size_t i : evenly(pixels.size(), static_cast<std::size_t>(max_points)))
    result.push_back(pixels[i]);
  return result;
}

}  // namespace

BoardLine board_line(const std::vector<LinePeaks>& ways, const CameraIntrinsics& camera,
                     const Eigen::Isometry3d& board_in_camera, const Board& board, int max_points) {
  constexpr double kEdgeReach = 0.75;  // of the stripe's width, chosen: half of it and its foot
  const BoardPlane view(camera, board_in_camera, board);
  Crossing best;
  for (const LinePeaks& way : ways) {
    Crossing crossing = cross(way, view);
    if (best.candidates.empty() || crossing.line.votes > best.line.votes)
      best = std::move(crossing);
  }
  BoardLine result;
  result.counts.peaks = rows_with_peaks(best);
  const std::vector<Candidate> straight =
      best.line.votes > 0 ? on_line(best) : std::vector<Candidate>();
  result.counts.off_line = result.counts.peaks - static_cast<int>(straight.size());
  std::vector<double> widths;
  std::vector<Vector2d> pixels;
  for (const Candidate& candidate : straight) {
    widths.push_back(candidate.peak.width);
    result.course.push_back(candidate.peak.pixel);
    if (view.is_at_edge(candidate.straight, kEdgeReach * candidate.peak.width + 1)) {
      ++result.counts.at_edges;
    } else {
      pixels.push_back(candidate.peak.pixel);
    }
  }
  if (pixels.size() < kMinPoints) {
    result.reason = fmt::format(
        "no straight line on the board: {} peaks, {} of them off any line, {} at edges of squares",
        result.counts.peaks, result.counts.off_line, result.counts.at_edges);
    return result;
  }
  result.width = upper_median(widths);
  result.pixels = thinned(pixels, max_points);
  result.counts.used = static_cast<int>(result.pixels.size());
  result.counts.thinned = static_cast<int>(pixels.size()) - result.counts.used;
  return result;
}

}  // namespace scan_calibration
