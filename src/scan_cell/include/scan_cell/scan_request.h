// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace scan_cell {

/// The way of the flange along a pass. Values as in ScanPass.
enum class PassKind : std::uint8_t {
  kLine = 1,      //!< from start to end
  kArc = 2,       //!< start, one pose in between, end: on one circle
  kPolyline = 3,  //!< a line from each pose to the next
};

/// The light of a pass. Values as in ScanPass.
enum class PassLasers : std::uint8_t {
  kLaser0 = 0,
  kLaser1 = 1,
  kEach = 2,       //!< there with laser_0, back with laser_1
  kAlternate = 3,  //!< both in turn, pulse by pulse
};

/// Columns and rows of the sensor that are read out [px], as in CameraSettings.
struct CameraRegion {
  std::uint32_t x = 0;       //!< first column
  std::uint32_t y = 0;       //!< first row
  std::uint32_t width = 0;   //!< 0: to the right edge
  std::uint32_t height = 0;  //!< 0: to the lower edge
};

/// Camera settings of a pass; what is left out stays as it was before the scan.
struct PassCamera {
  std::optional<double> exposure;      //!< [s]
  std::optional<CameraRegion> region;  //!< read out
  std::string detector;                //!< of the laser's line, as in CameraSettings; may be empty

  /// Whether everything is left out.
  bool empty() const { return !exposure && !region && detector.empty(); }
};

bool operator==(const CameraRegion& one, const CameraRegion& other);  //!< each number
bool operator==(const PassCamera& one, const PassCamera& other);      //!< each setting

/// One stretch of a scan, along which the camera is pulsed.
struct ScanPass {
  std::string name;                         //!< for a person; may be empty
  PassKind kind = PassKind::kLine;          //!< of the way
  std::vector<Eigen::Isometry3d> poses;     //!< of tool0: 2 for a line, 3 for an arc, or more
  double speed = 0;                         //!< [m/s]
  double rate = 0;                          //!< [Hz] frames
  PassLasers lasers = PassLasers::kLaser0;  //!< its light
  PassCamera camera;                        //!< its settings
};

/// A scan into one cloud.
struct ScanRequest {
  std::string scan_id;           //!< its name; empty: derived from the time
  std::vector<ScanPass> passes;  //!< in their order
};

/// What the cell allows.
struct ScanLimits {
  double max_speed = 0.5;    //!< [m/s]
  double min_rate = 2;       //!< [Hz] a slower camera cannot be watched
  double max_rate = 500;     //!< [Hz]
  double max_length = 2.0;   //!< [m] of a pass
  double min_length = 1e-3;  //!< [m] of a pass, and of each line in it
};

/// For a person: "pass 2", or "pass 2 (outer flank)".
/// @param index from 0
std::string pass_name(const ScanPass& pass, std::size_t index);

/// Way of the flange [m] along a pass with as many poses as its kind needs.
/// @return NaN if the poses of an arc are not on a circle
double length(const ScanPass& pass);

/// @throw scan_cell_common::Refused naming the first invalid pass, and what in it is out of range
void check(const ScanRequest& request, const ScanLimits& limits);

}  // namespace scan_cell
