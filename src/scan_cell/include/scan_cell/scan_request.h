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
  kArc = 2,       //!< start, one pose on the way, end: on one circle
  kPolyline = 3,  //!< a line from each pose to the next
};

/// The light of a pass. Values as in ScanPass.
enum class PassLasers : std::uint8_t {
  kLaser0 = 0,
  kLaser1 = 1,
  kEach = 2,       //!< there with laser_0, and back with laser_1
  kAlternate = 3,  //!< both in turns, pulse by pulse
};

/// Columns and rows of the sensor that are read out [px], as in CameraSettings.
struct CameraRegion {
  std::uint32_t x = 0;       //!< first column
  std::uint32_t y = 0;       //!< first row
  std::uint32_t width = 0;   //!< 0: to the right edge
  std::uint32_t height = 0;  //!< 0: to the lower edge
};

/// How the camera is set for a pass; what is left out is as it was before the scan.
struct PassCamera {
  std::optional<double> exposure;      //!< [s]
  std::optional<CameraRegion> region;  //!< that is read out
  std::string detector;                //!< of the laser's line, as in CameraSettings; may be empty

  /// Whether all is left out.
  bool empty() const { return !exposure && !region && detector.empty(); }
};

bool operator==(const CameraRegion& one, const CameraRegion& other);  //!< each number
bool operator==(const PassCamera& one, const PassCamera& other);      //!< each setting

/// One stretch of a scan along which the camera is pulsed.
struct ScanPass {
  std::string name;                         //!< for a person; may be empty
  PassKind kind = PassKind::kLine;          //!< of the way
  std::vector<Eigen::Isometry3d> poses;     //!< of tool0: 2 of a line, 3 of an arc, or more
  double speed = 0;                         //!< [m/s]
  double rate = 0;                          //!< [Hz] frames
  PassLasers lasers = PassLasers::kLaser0;  //!< its light
  PassCamera camera;                        //!< its settings
};

/// What is to be scanned into one cloud.
struct ScanRequest {
  std::string scan_id;           //!< its name; empty: made from the time
  std::vector<ScanPass> passes;  //!< in their order
};

/// What the cell allows.
struct ScanLimits {
  double max_speed = 0.5;    //!< [m/s]
  double min_rate = 2;       //!< [Hz] a camera that is slower cannot be watched
  double max_rate = 500;     //!< [Hz]
  double max_length = 2.0;   //!< [m] of a pass
  double min_length = 1e-3;  //!< [m] of a pass, and of each line in it
};

/// For a person: "pass 2", or "pass 2 (outer flank)".
/// @param index from 0
std::string pass_name(const ScanPass& pass, std::size_t index);

/// [m] that the flange goes along a pass with as many poses as its kind needs.
/// @return NaN where the poses of an arc are on no circle
double length(const ScanPass& pass);

/// @throw scan_cell_common::Refused naming the first pass that makes no sense, and what in it is
/// out of range
void check(const ScanRequest& request, const ScanLimits& limits);

}  // namespace scan_cell
