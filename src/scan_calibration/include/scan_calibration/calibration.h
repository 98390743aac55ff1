// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scan_calibration/observations.h"
#include "scan_cell_common/scanner/scanner_model.h"

namespace scan_calibration {

/// A scanner model from an earlier calibration. It supplies what is not calibrated again.
struct ExistingScanner {
  std::string file;  //!< where it was read
  std::string text;  //!< of the file: kept parts are written back as they are there
  scan_cell_common::ScannerModel model;  //!< as the file has it
  /// [m] of a scanned point, by laser, from the file; 0: not known
  std::vector<double> deviations = {};
};

/// @throw scan_cell_common::FileError, scan_cell_common::UnusableInput as load_scanner_model()
ExistingScanner load_existing_scanner(const std::string& file);

/// What to estimate, and what is known in advance. A deviation of 0 is estimated from the data.
struct CalibrationOptions {
  /// Whether the board may be bent. It is treated as flat unless a bend explains held-out corners
  /// better.
  bool board_flatness = true;
  double corner_deviation = 0;       //!< [px] standard deviation of a corner along each axis
  double line_deviation = 0;         //!< [px] of a laser point, across its line
  double robot_deviation = 0;        //!< [m] of the flange's position, along each axis
  double robot_angle_deviation = 0;  //!< [rad] of its orientation, about each axis
  int folds = 5;                     //!< groups of views, held out in turn
  int threads = 2;                   //!< does not change the result
  /// One entry per laser of the session: its projector in camera_optical_frame [m], which the
  /// images do not show. If it is missing, the origin is the existing model's, projected onto the
  /// plane, or else the point of the plane beside the lens.
  std::vector<Eigen::Vector3d> projectors;
  /// Supplies what is not calibrated again: lasers that the session does not have, and with
  /// `lasers_alone` the camera. Without it the model has only what the session shows.
  std::optional<ExistingScanner> existing;
  bool lasers_alone = false;  //!< keep camera and flange_to_camera of `existing`
  std::function<void(const std::string&)> progress;  //!< called with each next step; may be empty
};

/// Standard deviations that weighted the observations.
struct NoiseLevels {
  double corner_px = 0;         //!< along each axis
  std::vector<double> line_px;  //!< per laser, across its line
  double robot_m = 0;           //!< along each axis
  double robot_rad = 0;         //!< about each axis
};

/// A pose worth adding to the session: of those tried, it reduces PointUncertainty most.
struct PoseAdvice {
  std::string text;                  //!< in words: where to hold the board, and what it gains
  Eigen::Isometry3d base_to_flange;  //!< [m]; not checked: whether the robot can reach it
  double deviation_mm = 0;           //!< predicted RMS of `uncertainty` with this pose added
};

/// One estimated number.
struct EstimatedParameter {
  std::string name;      //!< as in the scanner model's file: camera.fx, lasers[0].distance
  std::string unit;      //!< px, m, rad, 1
  double value = 0;      //!< in `unit`
  double deviation = 0;  //!< standard deviation
};

/// How well a set of views agrees with the model.
struct Figures {
  double reprojection_rms_px = 0;          //!< with each view's board pose fitted to its corners
  std::vector<double> laser_plane_rms_mm;  //!< per laser: distance of its points from its plane
  /// RMS distance of the board's centre in base_link, from robot and camera, from its mean.
  double board_scatter_mm = 0;
};

/// How one view agrees with the model.
struct ViewFigures {
  std::string name;                        //!< of the view
  double reprojection_rms_px = 0;          //!< of its corners
  std::vector<double> laser_plane_rms_mm;  //!< per laser; NaN: not seen
  double board_offset_mm = 0;              //!< of the board's centre in base_link from the model's
  double board_angle_deg = 0;              //!< of the board's orientation in base_link
  /// [px] observed - modelled, in the order of the view's corners
  std::vector<Eigen::Vector2d> corner_residuals;
  std::vector<std::size_t> left_out_corners;  //!< outliers, left out of all other figures
  /// Per laser: outliers among the points of its line that were used.
  std::vector<std::vector<std::size_t>> left_out_points;
};

/// The uncertainty that the covariance gives a scanned point.
struct PointUncertainty {
  std::string laser;        //!< such as laser_0
  double depth = 0;         //!< [m] along the optical axis
  Eigen::Vector2d pixel;    //!< [px] where the point is seen
  double deviation_mm = 0;  //!< root of the summed variances along x, y, z, in tool0
};

/// A scanner calibrated from one session.
struct Calibration {
  scan_cell_common::ScannerModel scanner;  //!< the result
  /// Parts of the existing model that are kept bit by bit, by their names in its file: camera,
  /// flange_to_camera, laser_0.
  std::vector<std::string> kept;
  Eigen::Isometry3d base_to_board;             //!< [m]
  std::vector<EstimatedParameter> parameters;  //!< in the order of `covariance`
  Eigen::MatrixXd covariance;                  //!< of `parameters`, in their order
  Figures fitted;                              //!< on the views that were fitted
  Figures held_out;                            //!< each view judged by a model fitted without it
  std::vector<ViewFigures> views;              //!< those used, in their order
  std::vector<RejectedView> rejected;          //!< with the reason
  std::vector<PointUncertainty> uncertainty;   //!< of scanned points
  NoiseLevels noise;                           //!< given or estimated
  /// Height [m] of the board above its plane: [0] (x^2 - mean), [1] x y, [2] (y^2 - mean), with x
  /// and y from -1 to 1 over its corners. Zero if no bend is asked for, or none explains held-out
  /// views better.
  Eigen::Vector3d board_bend = Eigen::Vector3d::Zero();
  std::vector<std::string> notes;  //!< to read before using the result
  std::vector<PoseAdvice> advice;  //!< best first
};

/// A scanner calibrated step by step (sequential.h), on the views of a Calibration.
struct SequentialCalibration {
  scan_cell_common::ScannerModel scanner;  //!< the result
  Eigen::Isometry3d base_to_board;         //!< [m] mean over the views
  Figures fitted;                          //!< on the views that were fitted
  Figures held_out;                        //!< on those that were not
};

/// @param lasers of the session
/// @throw scan_cell_common::InvalidParameter naming an option that makes no sense
void check(const CalibrationOptions& options, const std::vector<std::string>& lasers);

/// Estimates camera, its pose on the flange, board and every laser plane in one robust
/// least-squares problem, from a closed-form start. Without lasers in the session it estimates the
/// camera alone; with `lasers_alone`, the planes and the board for the existing camera.
/// @throw scan_cell_common::InvalidParameter as check()
/// @throw scan_cell_common::UnusableInput saying what the session lacks or what is wrong with it:
/// too few views, views too alike, a laser never seen, a wrong board size, poses and images out of
/// step, angles in the wrong unit, an existing camera that the views do not fit
Calibration calibrate(const Observations& observations, const CalibrationOptions& options);

}  // namespace scan_calibration
