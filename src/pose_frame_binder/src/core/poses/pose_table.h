// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pose_frame_binder {

/// Pose as x, y, z [mm] and rx, ry, rz [deg]: the rotations about the fixed x, y and z axis, in
/// this order, rotation = Rz(rz) Ry(ry) Rx(rx); -90 <= ry <= 90, and rx = 0 where |ry| = 90.
std::array<double, 6> to_document_units(const Eigen::Isometry3d& pose);

/// Which pose belongs to which frame of a scan, for clients of the thesis' lookup (section 6.2).
class PoseTable {
 public:
  void add(std::uint64_t frame_counter, const Eigen::Isometry3d& pose);

  /// Call when no more frames will arrive.
  void seal();

  /// The answer to one line, without its end: `x,y,z,rx,ry,rz` of the frame with this number;
  /// `NONE` if no frame with this number is bound; `ERROR reason` if the line is not a number,
  /// or the camera was restarted and more than one frame has this number.
  std::string answer(std::string_view line) const;

 private:
  struct Entry {
    std::uint64_t frame_counter;
    std::array<double, 6> pose;
  };
  std::vector<Entry> entries_;
};

}  // namespace pose_frame_binder
