// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "images/corner_refinement.h"

#include <ceres/tiny_solver.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace scan_calibration {
namespace {

using Eigen::Vector2d;

// x, y [px], directions of the two edges [rad], blur [px], mean, contrast, gradient x, y
using Shape = Eigen::Matrix<double, 9, 1>;

double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

struct GreyPixel {
  Vector2d place;  // [px] from the centre of the disc
  double grey;
};

/// The pixels of an image within `radius` of its pixel `centre`.
std::vector<GreyPixel> disc(const cv::Mat& image, const cv::Point& centre, double radius) {
  const int reach = static_cast<int>(std::ceil(radius));
  std::vector<GreyPixel> pixels;
  for (int y = std::max(-reach, -centre.y); y <= std::min(reach, image.rows - 1 - centre.y); ++y) {
    const int half = static_cast<int>(std::sqrt(std::max(0.0, radius * radius - y * y)));
    const float* const row = image.ptr<float>(centre.y + y) + centre.x;
    for (int x = std::max(-half, -centre.x); x <= std::min(half, image.cols - 1 - centre.x); ++x)
      pixels.push_back({Vector2d(x, y), row[x]});
  }
  return pixels;
}

/// Difference between what four squares would show and the pixels, as ceres::TinySolver minimizes
/// it.
struct SquaresMisfit {
  using Scalar = double;
  enum { NUM_RESIDUALS = Eigen::Dynamic, NUM_PARAMETERS = 9 };

  int NumResiduals() const { return static_cast<int>(pixels.size()); }

  bool operator()(const double* parameters, double* residuals, double* jacobian) const {
    const Eigen::Map<const Shape> shape(parameters);
    const Vector2d across1(-std::sin(shape[2]), std::cos(shape[2]));
    const Vector2d across2(-std::sin(shape[3]), std::cos(shape[3]));
    const Vector2d along1(across1.y(), -across1.x()), along2(across2.y(), -across2.x());
    const double sharp = 1 / blur(shape);
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, 9>> rows(jacobian, NumResiduals(), 9);
    for (int i = 0; i < NumResiduals(); ++i) {
      const Vector2d d = pixels[i].place - shape.head<2>();
      const double d1 = across1.dot(d) * sharp, d2 = across2.dot(d) * sharp;
      const double side1 = std::erf(d1), side2 = std::erf(d2);
      residuals[i] = shape[5] + shape[6] * side1 * side2 + shape.tail<2>().dot(d) - pixels[i].grey;
      if (jacobian == nullptr) continue;
      const double slope1 = M_2_SQRTPI * std::exp(-d1 * d1) * side2 * shape[6] * sharp;
      const double slope2 = M_2_SQRTPI * std::exp(-d2 * d2) * side1 * shape[6] * sharp;
      rows.row(i) << (-slope1 * across1 - slope2 * across2 - shape.tail<2>()).transpose(),
          -slope1 * along1.dot(d), -slope2 * along2.dot(d), -(slope1 * d1 + slope2 * d2), 1,
          side1 * side2, d.transpose();
    }
    return true;
  }

  double blur(const Shape& shape) const {
    constexpr double kMinBlur = 0.3;  // [px] chosen: below it an edge looks the same
    return std::clamp(shape[4], kMinBlur, radius);
  }

  std::vector<GreyPixel> pixels;
  double radius;  // [px]
};

Shape first_guess(const std::vector<GreyPixel>& pixels, const RoughCorner& rough,
                  const Vector2d& corner) {
  constexpr double kTypicalBlur = 1.5;  // [px] chosen
  Shape shape;
  shape << corner, std::atan2(rough.along_columns.y(), rough.along_columns.x()),
      std::atan2(rough.along_rows.y(), rough.along_rows.x()), kTypicalBlur, 0, 0, 0, 0;
  const auto count = static_cast<double>(pixels.size());
  for (const GreyPixel& pixel : pixels)
    shape[5] += pixel.grey / count;
  for (const auto& [place, grey] : pixels) {
    const Vector2d d = place - corner;
    const bool same_side = cross(rough.along_columns, d) * cross(rough.along_rows, d) > 0;
    shape[6] += (same_side ? 1 : -1) * (grey - shape[5]) / count;
  }
  return shape;
}

/// Distance [px] within which no other edge of the board comes.
double free_radius(const RoughCorner& rough) {
  const double area = std::abs(cross(rough.along_columns, rough.along_rows));
  return area / std::max(rough.along_columns.norm(), rough.along_rows.norm());
}

}  // namespace

bool refine_corner(const cv::Mat& image, RoughCorner& rough) {
  constexpr double kMinRadius = 2.5;   // [px] chosen: 21 pixels for 9 unknowns
  constexpr int kMinMargin = 3;        // [px] chosen: a corner at the border shows all its squares
  constexpr double kMaxMisfit = 0.35;  // RMS over contrast, chosen
  constexpr double kMaxMove = 1.5;     // [px] chosen, or
  constexpr double kMaxMoveShare = 0.4;  // of the radius, chosen
  const double radius = std::min(kMaxFitRadius, kFitShare * free_radius(rough));
  const cv::Point centre(static_cast<int>(std::lround(rough.pixel.x())),
                         static_cast<int>(std::lround(rough.pixel.y())));
  const cv::Rect inside(kMinMargin, kMinMargin, image.cols - 2 * kMinMargin,
                        image.rows - 2 * kMinMargin);
  if (!(radius >= kMinRadius) || !inside.contains(centre)) return false;
  const Vector2d origin(centre.x, centre.y);
  const SquaresMisfit misfit{disc(image, centre, radius), radius};
  Shape shape = first_guess(misfit.pixels, rough, rough.pixel - origin);
  ceres::TinySolver<SquaresMisfit> solver;
  solver.options.max_num_iterations = 25;  // chosen: four to eight are usual
  const double cost = solver.Solve(misfit, &shape).final_cost;
  const double rms = std::sqrt(2 * cost / misfit.NumResiduals());
  if (!(rms < kMaxMisfit * std::abs(shape[6]))) return false;
  const Vector2d found = origin + shape.head<2>();
  if ((found - rough.pixel).norm() > std::max(kMaxMove, kMaxMoveShare * radius)) return false;
  rough.pixel = found;
  return true;
}

}  // namespace scan_calibration
