// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace scan_cell_sim {

/// Cross-section of the photo frame's moulding: x is the distance inwards from the outer edge, y
/// the height [m]. A polyline with rounded corners, from the foot of the outer wall over the crest
/// to the foot of the inner wall.
class Moulding {
 public:
  Moulding();

  double width() const { return width_; }
  double height() const { return crest_.y(); }

  /// The highest point; the surface is level there.
  Eigen::Vector2d crest() const { return crest_; }

  /// Points of the section, no more than `step` apart and no chord more than `tolerance` [m] off
  /// its arc.
  std::vector<Eigen::Vector2d> points(double step, double tolerance) const;

 private:
  /// A straight run, then an arc; an arc of radius 0 is nothing.
  struct Run {
    Eigen::Vector2d begin;
    Eigen::Vector2d end;
    Eigen::Vector2d arc_centre;
    double arc_radius;
    double arc_begin;  // [rad]
    double arc_sweep;  // [rad] signed
  };

  std::vector<Run> runs_;
  double width_ = 0;
  Eigen::Vector2d crest_ = Eigen::Vector2d::Zero();
};

}  // namespace scan_cell_sim
