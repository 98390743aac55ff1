// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace scan_calibration {

/// A flat checkerboard. Its frame: origin at the first inner corner, x along a row of `columns`
/// corners, y along a column of `rows`, z into the board.
struct Board {
  int columns = 0;         //!< inner corners along x
  int rows = 0;            //!< inner corners along y
  double square_size = 0;  //!< [m]
};

/// What was taken at one taught pose.
struct SessionView {
  std::string name;  //!< of the view in reports: the board image as the file names it
  Eigen::Isometry3d base_to_flange;  //!< pose of tool0 in base_link [m], measured at a standstill
  std::string board_image;           //!< path of the image that shows the board
  /// One entry per laser: path of the file that shows its line at the same pose, an image (the
  /// board image itself if both are in one) or a .csv of peaks; empty if it was not taken.
  std::vector<std::string> lines;
};

/// A recorded calibration session: everything needed to calibrate without the robot.
struct Session {
  Board board;                      //!< that the images show
  std::vector<std::string> lasers;  //!< of laser_0, laser_1, in this order; none: the board alone
  std::vector<SessionView> views;   //!< in the order of the table
};

/// Reads a session folder: session.yaml, the CSV of poses that it names, and the paths of the
/// images (docs/scan_calibration.md).
/// @throw scan_cell_common::FileError if a file is missing or unreadable
/// @throw scan_cell_common::UnusableInput naming the entry, or the line, that is invalid
Session load_session(const std::string& folder);

/// What session.yaml says.
struct SessionHead {
  std::string poses_file;           //!< as written
  Board board;                      //!< as in Session
  std::vector<std::string> lasers;  //!< as in Session
};

/// The parsers behind load_session(); `name` names the text in errors. Paths of views are returned
/// as written.
/// @throw as load_session()
SessionHead parse_session_head(const std::string& text, const std::string& name);
/// The table of views. @throw as load_session()
std::vector<SessionView> parse_session_poses(const std::string& text, const std::string& name,
                                             const std::vector<std::string>& lasers);

/// The text of such files; the parsers read it back to the last digit.
std::string session_head_text(const SessionHead& head);
/// The table of views as text.
std::string session_poses_text(const std::vector<SessionView>& views,
                               const std::vector<std::string>& lasers);

}  // namespace scan_calibration
