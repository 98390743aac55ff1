// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/pose/wire_pose.h"

#include <cmath>

#include "scan_cell_common/pose/units.h"

namespace scan_cell_common {
const EulerSequence& comau_angles() {
  static const EulerSequence sequence("zyz");
  return sequence;
}

WireSix to_wire(const Eigen::Isometry3d& pose) {
  const Eigen::Vector3d p = pose.translation() / kMillimetre;
  const Eigen::Vector3d angles = comau_angles().angles(pose.linear());
  return {p.x(), p.y(), p.z(), angles[0] / kDegree, angles[1] / kDegree, angles[2] / kDegree};
}

Eigen::Isometry3d pose_from_wire(const WireSix& wire) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << wire[0], wire[1], wire[2];
  pose.translation() *= kMillimetre;
  pose.linear() =
      comau_angles().rotation({wire[3] * kDegree, wire[4] * kDegree, wire[5] * kDegree});
  return pose;
}

}  // namespace scan_cell_common
