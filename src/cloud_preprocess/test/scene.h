// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <random>
#include <tuple>

#include "cloud_preprocess/stage.h"

namespace cloud_preprocess {

enum class Label { kFloor, kFoot, kPart, kOtherPart, kOutlier };

/// A scan with known labels: surfaces seen from above by a laser line along x that moves along y,
/// with 0.6 mm between points, 0.75 mm between lines and 0.1 mm noise. Lengths in metres.
class Scene {
 public:
  static constexpr double kAlongLine = 0.6e-3;
  static constexpr double kAcross = 0.75e-3;
  static constexpr double kNoise = 0.1e-3;
  static constexpr double kMargin = 2e-3;  // parts lower than this are labelled kFoot

  struct Rectangle {
    double x, y, width, depth;  // of the centre, along x, along y

    /// Distance from the border to a point inside; negative outside.
    double inside(double px, double py) const;
  };

  /// Adds the floor, without what the rectangles cover and their shadows of 5 mm.
  void add_floor(const Rectangle& floor, const std::vector<Rectangle>& covered = {});

  /// Adds a top, and walls seen at a grazing angle, with points every 2 mm in height.
  void add_box(const Rectangle& box, double height, Label label = Label::kPart);

  /// Adds a photo frame: a moulding of 30 mm that rises from the floor to 15 mm and falls to a
  /// rebate of 4 mm, and a flat insert inside it at 3 mm.
  void add_frame(const Rectangle& frame);

  /// Adds random points within the rectangle and up to `height`, at least 15 mm from each other and
  /// from all surfaces.
  void add_outliers(const Rectangle& area, double height, int count);

  void add(double x, double y, double z, Label label);

  /// Moves the whole scene.
  void move(const Eigen::Affine3f& by);

  const Cloud& cloud() const { return cloud_; }
  int count(Label label) const;

  /// Share of the points with this label that are in the given part of the scene's cloud.
  double share_in(const Cloud& part, Label label) const;

 private:
  void add_surface(const Rectangle& area, double height, Label label,
                   const std::vector<Rectangle>& covered);
  double noise() { return kNoise * normal_(generator_); }

  using Key = std::tuple<float, float, float>;

  Cloud cloud_;
  std::vector<Label> labels_;
  std::mt19937 generator_{7};
  std::normal_distribution<double> normal_;
};

/// Two parts side by side.
inline const Scene::Rectangle kFrame{-0.06, 0, 0.15, 0.12};
inline const Scene::Rectangle kBox{0.08, 0, 0.06, 0.08};

}  // namespace cloud_preprocess
