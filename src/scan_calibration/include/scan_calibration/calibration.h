// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scan_calibration/existing_scanner.h"
#include "scan_calibration/observations.h"
#include "scan_cell_common/scanner_model.h"

namespace scan_calibration {

/// What is estimated and what is known beforehand. A deviation of 0 is estimated from the data.
struct CalibrationOptions {
  /// Whether the board may be bent; it is taken as flat unless that explains held-out corners
  /// better.
  bool board_flatness = true;
  double corner_deviation = 0;       //!< [px] of a corner, standard deviation along each axis
  double line_deviation = 0;         //!< [px] of a line's point, across the line
  double robot_deviation = 0;        //!< [m] of the flange's position, along each axis
  double robot_angle_deviation = 0;  //!< [rad] of its orientation, about each axis
  int folds = 5;                     //!< groups of views that are held out in turn
  int threads = 2;                   //!< has no influence on the result
  /// A laser of the session: where its projector is in camera_optical_frame [m]. It does not show
  /// in the images; left out, the model's origin is the existing one's nearest point of the plane,
  /// or the plane's nearest point beside the lens.
  std::vector<Eigen::Vector3d> projectors;
  /// What is not calibrated anew is taken from it: lasers that the session does not have, and with
  /// `lasers_alone` the camera. Without it the model has only what the session shows.
  std::optional<ExistingScanner> existing;
  bool lasers_alone = false;  //!< camera and its pose on the flange are those of `existing`
  std::function<void(const std::string&)> progress;  //!< told what is done next; may be empty
};

/// Standard deviations that the observations were weighted by.
struct NoiseLevels {
  double corner_px = 0;         //!< along each axis
  std::vector<double> line_px;  //!< a laser, across its line
  double robot_m = 0;           //!< along each axis
  double robot_rad = 0;         //!< about each axis
};

/// A pose to add to the session: the one, of those tried, that lessens PointUncertainty most.
struct PoseAdvice {
  std::string text;                  //!< in words: where to hold the camera, and what it brings
  Eigen::Isometry3d base_to_flange;  //!< [m]; whether the robot can go there is not checked
  double deviation_mm = 0;           //!< RMS of `uncertainty` with this pose added, as predicted
};

/// One estimated number.
struct EstimatedParameter {
  std::string name;  //!< as in the scanner model's file: camera.fx, lasers[0].distance
  std::string unit;  //!< px, m, rad, 1
  double value = 0;
  double deviation = 0;  //!< standard deviation
};

/// How well a set of views agrees with the model.
struct Figures {
  double reprojection_rms_px = 0;          //!< with each view's board pose fitted to its corners
  std::vector<double> laser_plane_rms_mm;  //!< a laser: its points on those boards, off its plane
  double board_scatter_mm =
      0;  //!< RMS of the board's centre in base_link, by robot and camera, about its mean
};

/// How one view agrees with the model.
struct ViewFigures {
  std::string name;
  double reprojection_rms_px = 0;
  std::vector<double> laser_plane_rms_mm;  //!< a laser; NaN: not seen
  double board_offset_mm = 0;  //!< of the board's centre in base_link from where the model has it
  double board_angle_deg = 0;  //!< of the board's orientation in base_link
  /// [px] seen - modelled, in the order of the view's corners
  std::vector<Eigen::Vector2d> corner_residuals;
  std::vector<std::size_t> left_out_corners;  //!< that miss by far: in no other figure
  /// A laser: points of its line, of those that were looked at, that miss by far.
  std::vector<std::vector<std::size_t>> left_out_points;
};

/// What a deviation of the numbers means for a point of the scan, from the covariance.
struct PointUncertainty {
  std::string laser;
  double depth = 0;         //!< [m] along the optical axis
  Eigen::Vector2d pixel;    //!< [px] where the point is seen
  double deviation_mm = 0;  //!< root of the sum of the variances along x, y, z, in tool0
};

/// A scanner calibrated from one session.
struct Calibration {
  scan_cell_common::ScannerModel scanner;
  std::vector<std::string> kept;    //!< parts of the existing model, bit by bit: kept_parts()
  Eigen::Isometry3d base_to_board;  //!< [m]
  std::vector<EstimatedParameter> parameters;
  Eigen::MatrixXd covariance;      //!< of `parameters`, in their order
  Figures fitted;                  //!< on the views that were fitted
  Figures held_out;                //!< each view judged by a model that was fitted without it
  std::vector<ViewFigures> views;  //!< used ones, in their order
  std::vector<RejectedView> rejected;
  std::vector<PointUncertainty> uncertainty;
  NoiseLevels noise;
  /// Height [m] of the board above its plane: [0] (x^2 - mean), [1] x y, [2] (y^2 - mean), with x
  /// and y from -1 to 1 over its corners. Zero where it is not asked for, or explains held-out
  /// views no better.
  Eigen::Vector3d board_bend = Eigen::Vector3d::Zero();
  std::vector<std::string> notes;  //!< what a person should know before using the result
  std::vector<PoseAdvice> advice;  //!< best first
};

}  // namespace scan_calibration
