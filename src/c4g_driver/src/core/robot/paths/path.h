// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace c4g_driver {

/// The way of the flange in a motion, without timing. `way` runs from 0 to 1 in proportion to the
/// length.
class Path {
 public:
  /// A part of it over which the flange turns at one rate.
  struct Stretch {
    double begin;        // way
    double end;          // way
    double length;       // [m]
    double angle;        // [rad] angle to which the rotational speed applies
    const char* target;  // name of the pose at its end
  };

  virtual ~Path() = default;
  virtual const char* name() const = 0;
  virtual Eigen::Isometry3d at(double way) const = 0;
  virtual std::vector<Stretch> stretches() const = 0;  // one after the other
};

}  // namespace c4g_driver
