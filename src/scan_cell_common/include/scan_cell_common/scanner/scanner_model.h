// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

namespace scan_cell_common {

/// Pinhole camera with the distortion of OpenCV and ROS ("plumb_bob"). Pixel centres have integer
/// coordinates; (0, 0) is the centre of the sensor's first pixel, whatever the region of interest.
struct CameraIntrinsics {
  int width = 0;   //!< [px] sensor columns
  int height = 0;  //!< [px] sensor rows
  double fx = 0;   //!< [px]
  double fy = 0;   //!< [px]
  double cx = 0;   //!< [px]
  double cy = 0;   //!< [px]
  /// k1, k2, p1, p2, k3 (Brown 1966 as in OpenCV's calibration module)
  Eigen::Matrix<double, 5, 1> distortion = Eigen::Matrix<double, 5, 1>::Zero();

  /// Sensor position [px] of a point in front of the camera [m, camera_optical_frame].
  Eigen::Vector2d project(const Eigen::Vector3d& point) const;

  /// A ray (x/z, y/z) after the lens' distortion.
  Eigen::Vector2d distort(const Eigen::Vector2d& ray) const;

  /// The ray (x/z, y/z) that the lens maps to `distorted`, by Newton's method to the last digits.
  /// @param ray initial guess (`distorted` itself is good); the solution on return
  /// @return false if there is none nearby: the model folds over beyond some angle
  bool undistort(const Eigen::Vector2d& distorted, Eigen::Vector2d& ray) const;

  /// Whether a sensor position [px] is on one of the sensor's pixels.
  bool contains(const Eigen::Vector2d& pixel) const;
};

/// Plane of light of one laser, in camera_optical_frame: normal . p = distance, |normal| = 1.
struct LaserPlane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitX();  //!< unit length
  double distance = 0;                                //!< [m]
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();   //!< [m] the projector, in the plane
};

/// Everything needed to turn a peak and a flange pose into a point. Calibration writes it;
/// triangulation and the simulator read it.
struct ScannerModel {
  CameraIntrinsics camera;                                             //!< the lens and the sensor
  Eigen::Isometry3d flange_to_camera = Eigen::Isometry3d::Identity();  //!< camera's pose in tool0
  /// laser_0, laser_1; empty for a laser that was not calibrated. There may be no laser at all.
  std::vector<std::optional<LaserPlane>> lasers;

  /// Whether laser_<index> was calibrated.
  bool has_laser(std::size_t index) const { return index < lasers.size() && lasers[index]; }

  /// The plane of light of laser_<index>.
  /// @throw scan_cell_common::UnusableInput if it was not calibrated
  const LaserPlane& laser(std::size_t index) const;
};

/// 1 -> laser_1
std::string laser_name(std::size_t index);

/// laser_1 -> 1, its index in the model.
/// @throw scan_cell_common::UnusableInput if it is not the name of a laser
std::size_t laser_index(const std::string& name);

/// @throw scan_cell_common::UnusableInput if no laser was calibrated: nothing can be scanned
void check_can_scan(const ScannerModel& model);

/// Reads a scanner model from YAML (docs/scanner_model.md).
/// @throw scan_cell_common::FileError if the file is missing or not YAML
/// @throw scan_cell_common::UnusableInput naming the entry that is missing or invalid
ScannerModel load_scanner_model(const std::string& path);

/// The same from the text of such a file.
/// @param name of the text, for errors
/// @throw as load_scanner_model()
ScannerModel parse_scanner_model(const std::string& text, const std::string& name);

/// Writes a scanner model, whole or not at all.
/// @throw scan_cell_common::FileError if it cannot be written
void save_scanner_model(const std::string& path, const ScannerModel& model);

/// The same if parts were taken from another file: unchanged parts are written as they are in that
/// file, digit by digit.
/// @param existing text of the other file
/// @throw scan_cell_common::UnusableInput as parse_scanner_model() for that text
void save_scanner_model(const std::string& path, const ScannerModel& model,
                        const std::string& existing);

/// @throw scan_cell_common::UnusableInput naming the invalid entry
void check(const ScannerModel& model);

}  // namespace scan_cell_common
