// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scan_cell_sim/controller/path.h"

namespace scan_cell_sim {

constexpr double kNothing = 1e-12;  // shorter ways are none

/// A path given by the poses of the flange, in the posture of its start. The flange moves evenly
/// along it, and turns evenly along each of its stretches.
class FlangePath : public Path {
 public:
  Joints joints(double way) const override;

  struct Knot {
    double way;
    Joints joints;
    double max_speed;  // [1/s] what the axes allow on the way to here
  };
  const std::vector<Knot>& knots() const { return knots_; }

  virtual double length() const = 0;  // [m]
  /// [rad] the largest turn per way, to which the rotational speed applies
  double turning() const;

  /// Follows the path from knot to knot; joints() needs the knots.
  /// @return [1/s] the most that the axes allow
  /// @throw ControllerRefusal as plan_line()
  double follow(const Joints& from);

 protected:
  struct Stretch {
    double end;    // way; it begins where the one before ends
    double angle;  // [rad] to which the rotational speed applies
    double turn;   // [rad] no less than the flange's turn
  };

 private:
  virtual std::string name() const = 0;  // for a person
  virtual std::vector<Stretch> stretches() const = 0;
  double step_to(double way);

  std::vector<Knot> knots_;
};

}  // namespace scan_cell_sim
