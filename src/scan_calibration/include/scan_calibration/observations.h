// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scan_calibration/session.h"
#include "scan_cell_common/scanner/scanner_model.h"

namespace scan_calibration {

/// An inner corner of the board and where it was seen.
struct SeenCorner {
  int column = 0;         //!< 0 .. columns - 1
  int row = 0;            //!< 0 .. rows - 1
  Eigen::Vector2d pixel;  //!< [px] whole sensor, pixel centres are whole numbers
};

/// What became of the peaks of one laser's line in one view.
struct LineCounts {
  int peaks = 0;     //!< found, at most one per row (or column) of the image
  int off_line = 0;  //!< not on the straight line on the board: reflections, the table, strays
  int at_edges = 0;  //!< near an edge between a dark and a bright square, which shifts a peak
  int thinned = 0;   //!< left out evenly, so that all lines have the same weight
  int used = 0;      //!< for the estimate
};

/// What one pose shows.
struct ViewObservation {
  std::string name;                  //!< of the view
  Eigen::Isometry3d base_to_flange;  //!< [m]
  std::vector<SeenCorner> corners;   //!< of the board
  /// Per laser, the points along its line on the board's plane [px]; empty: not seen.
  std::vector<std::vector<Eigen::Vector2d>> lines;
  std::vector<LineCounts> line_counts;  //!< per laser
  int covered_corners = 0;              //!< missing in `corners`: under a laser's line, or in glare
};

/// A view, or a laser's line in a view, that is not used, with the reason.
struct RejectedView {
  std::string name;    //!< of the view
  std::string laser;   //!< empty: the whole view
  std::string reason;  //!< for a person
};

/// What the images of a session show.
struct Observations {
  int width = 0;                       //!< [px] of the sensor
  int height = 0;                      //!< [px]
  Board board;                         //!< of the session
  std::vector<std::string> lasers;     //!< of the session
  std::vector<ViewObservation> views;  //!< usable ones, in their order
  std::vector<RejectedView> rejected;  //!< with the reason
};

/// How a session's images are read.
struct ObservationOptions {
  std::string detector = "fir_derivative";  //!< of the laser line (tecnogamma_camera)
  int max_line_points = 300;                //!< of a line
  /// Lasers to keep; not given: all of the session. None: the board alone.
  std::optional<std::vector<std::string>> lasers;
  /// The camera if it is known. Without it, or for images of another size, a rough one is found.
  std::optional<scan_cell_common::CameraIntrinsics> camera;
  int threads = 2;  //!< does not change the result
  /// Called with the progress, from one thread at a time; may be empty.
  std::function<void(const std::string& what, int done, int total)> progress;
};

/// Finds boards and laser lines in a session's images (docs/scan_calibration.md, "What is read out
/// of the images").
/// @throw scan_cell_common::InvalidParameter if there is no such detector, or the session has no
/// such laser
/// @throw scan_cell_common::UnusableInput if no image shows the board, naming the board size that
/// they show instead
Observations observe(const Session& session, const ObservationOptions& options = {});

}  // namespace scan_calibration
