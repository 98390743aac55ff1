// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "part/elbow.h"

#include <algorithm>
#include <cmath>

namespace scan_cell_sim {

using Eigen::Vector3d;

namespace {

/// A point of the axis, and the two directions across it: sideways, and up.
struct Section {
  Vector3d centre;
  Vector3d tangent;
  Vector3d sideways() const { return Vector3d::UnitZ().cross(tangent); }
};

/// The first leg along x, the bend, the second leg along y.
Section section_at(const ElbowShape& elbow, double way) {
  const double bend = elbow.bend_radius;
  const double height = elbow.pipe_radius;
  if (way <= elbow.leg) return {{way - elbow.leg - bend, 0, height}, Vector3d::UnitX()};
  const double angle = (way - elbow.leg) / bend;
  if (angle >= M_PI / 2) {
    const double on_leg = way - elbow.leg - bend * M_PI / 2;
    return {{0, bend + on_leg, height}, Vector3d::UnitY()};
  }
  return {{bend * (std::sin(angle) - 1), bend * (1 - std::cos(angle)), height},
          {std::cos(angle), std::sin(angle), 0}};
}

}  // namespace

void add_elbow(const ElbowShape& elbow, Tessellator& tessellator) {
  const double radius = elbow.pipe_radius;
  const double length = 2 * elbow.leg + elbow.bend_radius * M_PI / 2;
  double besides = 0;  // what the deformation bends at most
  const auto curvature_at = [&](double share) {
    const Section section = section_at(elbow, share * length);
    double most = 0;
    for (const double side : {-radius, 0.0, radius}) {
      for (const double up : {-radius, radius}) {
        most = std::max(most, tessellator.curvature(section.centre + side * section.sideways() +
                                                    up * Vector3d::UnitZ()));
      }
    }
    besides = std::max(besides, most);
    return most + 1 / (elbow.bend_radius - radius);  // on the inside of the bend
  };
  const std::vector<double> along = tessellator.stations(length, curvature_at);
  const std::size_t sectors = tessellator.sectors_of(radius, besides);
  tessellator.add_grid(sectors + 1, along.size(), [&](std::size_t i, std::size_t j) -> Vector3d {
    const Section section = section_at(elbow, along[j] * length);
    return section.centre + Tessellator::on_circle(radius * section.sideways(),
                                                   radius * Vector3d::UnitZ(), i, sectors);
  });
  const Section begin = section_at(elbow, 0);
  tessellator.add_disc(begin.centre, radius * Vector3d::UnitZ(), radius * begin.sideways());
  const Section end = section_at(elbow, length);
  tessellator.add_disc(end.centre, radius * end.sideways(), radius * Vector3d::UnitZ());
}

}  // namespace scan_cell_sim
