// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <limits>
#include <vector>

#include "laser_triangulation/ray_table.h"
#include "scan_cell_common/scanner/scanner_model.h"

namespace scan_cell_common {
class ParameterTable;
}

namespace laser_triangulation {

/// One point of a scan, with the layout of its PointCloud2 (docs/laser_triangulation.md).
struct ScanPoint {
  float x = 0;             //!< [m] in the frame of the profiles' poses
  float y = 0;             //!< [m]
  float z = 0;             //!< [m]
  float intensity = 0;     //!< [grey value] height of the peak
  std::uint8_t laser = 0;  //!< 0: laser_0, 1: laser_1
  std::uint8_t pass = 0;   //!< of the scan, from 0
  /// Zero, so that the same scan always gives the same bytes.
  std::uint8_t padding[2] = {0, 0};
  float width = 0;  //!< [px] of the stripe
  /// [m] the camera's centre when it saw the point, in the same frame; named as in PCL.
  float vp_x = 0;
  float vp_y = 0;  //!< [m]
  float vp_z = 0;  //!< [m]
};
static_assert(sizeof(ScanPoint) == 36);

/// The peaks of one frame, one per row from first_row downwards; NaN if a row has none. The arrays
/// have `rows` elements and are owned by the caller.
struct ProfileView {
  std::size_t laser = 0;             //!< index into scan_cell_common::ScannerModel::lasers
  std::uint32_t first_row = 0;       //!< [px] sensor row of element 0
  std::size_t rows = 0;              //!< of each array
  const float* position = nullptr;   //!< [px] sensor column
  const float* width = nullptr;      //!< [px]
  const float* intensity = nullptr;  //!< [grey value]
  std::uint8_t pass = 0;             //!< of the scan, from 0
};

/// Limits of the peaks that become points. A width or intensity of NaN passes only infinite limits.
struct PeakLimits {
  double min_width = 0;                                            //!< [px]
  double max_width = std::numeric_limits<double>::infinity();      //!< [px]
  double min_intensity = 0;                                        //!< [grey value]
  double max_intensity = std::numeric_limits<double>::infinity();  //!< [grey value]
  double min_range = 0.05;                                         //!< [m] along the camera's axis
  double max_range = 5;                                            //!< [m]
};

/// Describes every limit: range, unit and meaning. Refuses a minimum above its maximum.
void describe(scan_cell_common::ParameterTable& table, PeakLimits& limits);

/// Counts of what became of every row.
struct PeakCounts {
  std::uint64_t profiles = 0;           //!< profiles added
  std::uint64_t points = 0;             //!< points made
  std::uint64_t rows_without_peak = 0;  //!< position is NaN in the profile
  std::uint64_t outside_sensor = 0;     //!< also: lens model not invertible, or no such laser
  std::uint64_t by_width = 0;           //!< outside of the limits
  std::uint64_t by_intensity = 0;       //!< outside of the limits
  std::uint64_t by_range = 0;           //!< outside of the limits

  /// Peaks that did not become points.
  std::uint64_t rejected() const { return outside_sensor + by_width + by_intensity + by_range; }
};

/// Turns peaks into points: undistorts the ray, intersects it with the plane of light, and
/// transforms the result by the flange's pose.
class Triangulator {
 public:
  /// @throw scan_cell_common::UnusableInput if the model makes no sense
  /// @throw scan_cell_common::InvalidParameter if a minimum is above its maximum
  Triangulator(const scan_cell_common::ScannerModel& model, const PeakLimits& limits);

  /// Whether the model has a plane for this laser.
  bool has_laser(std::size_t index) const { return model_.has_laser(index); }

  /// Appends the profile's points in row order.
  /// @param flange pose of tool0 in the output frame of the points
  void add(const ProfileView& profile, const Eigen::Isometry3d& flange,
           std::vector<ScanPoint>& points);

  /// Counts over all profiles so far.
  const PeakCounts& counts() const { return counts_; }

 private:
  const scan_cell_common::ScannerModel model_;
  const RayTable rays_;
  const PeakLimits limits_;
  PeakCounts counts_;
  std::vector<ScanPoint> profile_;  // buffer for the points of one profile
};

}  // namespace laser_triangulation
