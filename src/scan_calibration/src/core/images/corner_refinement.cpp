// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "images/corner_refinement.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace scan_calibration {
namespace {

using Eigen::Vector2d;

// x, y [px], directions of the two edges [rad], blur [px], mean, contrast, gradient x, y
using Shape = Eigen::Matrix<double, 9, 1>;
using Information = Eigen::Matrix<double, 9, 9>;

double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The grey values in a disc about the rough corner.
class Disc {
 public:
  Disc(const cv::Mat& image, const Vector2d& centre, double radius)
      : image_(image),
        column_(static_cast<int>(std::lround(centre.x()))),
        row_(static_cast<int>(std::lround(centre.y()))),
        reach_(static_cast<int>(std::ceil(radius))),
        radius_(radius) {}

  /// Whether enough of it lies in the image: a corner at the border still shows all its squares.
  bool shows_all_sides() const {
    constexpr int kLeast = 3;  // [px]
    return column_ >= kLeast && row_ >= kLeast && column_ + kLeast < image_.cols &&
           row_ + kLeast < image_.rows;
  }

  Vector2d centre() const { return {column_, row_}; }

  template <class Visit>
  void visit(const Visit& visit) const {
    for (int y = std::max(-reach_, -row_); y <= std::min(reach_, image_.rows - 1 - row_); ++y) {
      const auto half = static_cast<int>(
          std::sqrt(std::max(0.0, radius_ * radius_ - static_cast<double>(y * y))));
      const float* const row = image_.ptr<float>(row_ + y) + column_;
      for (int x = std::max(-half, -column_); x <= std::min(half, image_.cols - 1 - column_); ++x)
        visit(Vector2d(x, y), row[x]);
    }
  }

 private:
  const cv::Mat& image_;
  int column_;
  int row_;
  int reach_;
  double radius_;
};

struct Linearised {
  Information information = Information::Zero();
  Shape gradient = Shape::Zero();
  double cost = 0;
  int count = 0;
};

Linearised linearise(const Disc& disc, const Shape& shape) {
  constexpr double kErfSlope = 2 * M_2_SQRTPI / 2;
  Linearised result;
  const Vector2d across1(-std::sin(shape[2]), std::cos(shape[2]));
  const Vector2d across2(-std::sin(shape[3]), std::cos(shape[3]));
  const Vector2d along1(across1.y(), -across1.x()), along2(across2.y(), -across2.x());
  const double sharp = 1 / shape[4];
  disc.visit([&](const Vector2d& p, float grey) {
    const Vector2d d = p - shape.head<2>();
    const double d1 = across1.dot(d) * sharp, d2 = across2.dot(d) * sharp;
    const double side1 = std::erf(d1), side2 = std::erf(d2);
    const double slope1 = kErfSlope * std::exp(-d1 * d1) * side2 * shape[6] * sharp;
    const double slope2 = kErfSlope * std::exp(-d2 * d2) * side1 * shape[6] * sharp;
    const double error = grey - (shape[5] + shape[6] * side1 * side2 + shape.tail<2>().dot(d));
    Shape jacobian;
    jacobian.head<2>() = -slope1 * across1 - slope2 * across2 - shape.tail<2>();
    jacobian[2] = -slope1 * along1.dot(d);
    jacobian[3] = -slope2 * along2.dot(d);
    jacobian[4] = -(slope1 * d1 + slope2 * d2);
    jacobian[5] = 1;
    jacobian[6] = side1 * side2;
    jacobian.tail<2>() = d;
    result.information.selfadjointView<Eigen::Lower>().rankUpdate(jacobian);
    result.gradient += error * jacobian;
    result.cost += error * error;
    ++result.count;
  });
  return result;
}

Shape first_guess(const Disc& disc, const RoughCorner& rough) {
  Shape shape;
  shape << rough.pixel - disc.centre(),
      std::atan2(rough.along_columns.y(), rough.along_columns.x()),
      std::atan2(rough.along_rows.y(), rough.along_rows.x()), 1.5, 0, 0, 0, 0;
  double sum = 0, contrast = 0;
  int count = 0;
  disc.visit([&](const Vector2d&, float grey) {
    sum += grey;
    ++count;
  });
  shape[5] = sum / count;
  disc.visit([&](const Vector2d& p, float grey) {
    const Vector2d d = p - shape.head<2>();
    const bool same_side = cross(rough.along_columns, d) * cross(rough.along_rows, d) > 0;
    contrast += (same_side ? 1 : -1) * (grey - shape[5]);
  });
  shape[6] = contrast / count;
  return shape;
}

/// Distance that no other edge of the board comes nearer than [px].
double free_radius(const RoughCorner& rough) {
  const double area = std::abs(cross(rough.along_columns, rough.along_rows));
  return area / std::max(rough.along_columns.norm(), rough.along_rows.norm());
}

}  // namespace

bool refine_corner(const cv::Mat& image, RoughCorner& rough) {
  constexpr double kLeastRadius = 2.5;  // [px]
  constexpr int kMostSteps = 25;
  constexpr double kSettled = 1e-4;     // [px]
  constexpr double kLeastBlur = 0.3;    // [px]
  constexpr double kMostMisfit = 0.35;  // of the contrast, RMS
  const double radius = std::min(kMostFitRadius, kFitShare * free_radius(rough));
  const Disc disc(image, rough.pixel, radius);
  if (!(radius >= kLeastRadius) || !disc.shows_all_sides()) return false;
  Shape shape = first_guess(disc, rough);
  Linearised now = linearise(disc, shape);
  double damping = 1e-3;
  for (int step = 0; step < kMostSteps && damping < 1e6; ++step) {
    Information damped = now.information;  // its lower half, as the solver asks
    damped.diagonal() *= 1 + damping;
    const Shape change = damped.ldlt().solve(now.gradient);
    Shape tried = shape + change;
    if (!tried.allFinite()) return false;
    tried[4] = std::clamp(tried[4], kLeastBlur, radius);
    const Linearised then = linearise(disc, tried);
    if (then.cost < now.cost) {
      shape = tried;
      now = then;
      damping *= 0.1;
    } else {
      damping *= 10;
    }
    if (change.head<2>().norm() < kSettled) break;
  }
  const double misfit = std::sqrt(now.cost / now.count);
  const Vector2d found = disc.centre() + shape.head<2>();
  if (!(misfit < kMostMisfit * std::abs(shape[6]))) return false;
  if ((found - rough.pixel).norm() > std::max(1.5, 0.4 * radius)) return false;
  rough.pixel = found;
  return true;
}

}  // namespace scan_calibration
