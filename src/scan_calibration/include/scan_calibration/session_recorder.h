// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scan_calibration/session.h"
#include "tecnogamma_camera/peak_profile.h"

namespace scan_calibration {

/// What shows one laser's line: an image or peaks. Neither: it was not taken. If both are given,
/// the session uses the peaks and keeps the image in which they were found.
struct RecordedLine {
  cv::Mat image;                                        //!< 8 or 16 bit grey
  std::optional<tecnogamma_camera::PeakProfile> peaks;  //!< on the full sensor
  bool in_board_image = false;  //!< the laser was on when the board was taken; one laser only
};

/// Records a session folder that load_session() reads. A view's files are complete before the table
/// names them, and the table is replaced as a whole: after an interruption the folder holds a
/// session of the views so far.
class SessionRecorder {
 public:
  /// @param folder created if missing
  /// @param lasers of laser_0, laser_1 ..., in rising order; none: the board alone
  /// @throw scan_cell_common::Refused if it holds a session already
  /// @throw scan_cell_common::FileError if it cannot be created
  SessionRecorder(const std::string& folder, const Board& board,
                  const std::vector<std::string>& lasers);

  /// @param base_to_flange pose of tool0 in base_link [m], measured at a standstill
  /// @param board_image 8 or 16 bit grey
  /// @param lines one per laser
  /// @throw scan_cell_common::UnusableInput if the image is invalid, or there is not one line per
  /// laser
  /// @throw scan_cell_common::FileError if it cannot be written; the previous views remain a
  /// session
  void add(const Eigen::Isometry3d& base_to_flange, const cv::Mat& board_image,
           const std::vector<RecordedLine>& lines);

  int views() const { return static_cast<int>(views_.size()); }  //!< recorded so far

 private:
  std::string save(const cv::Mat& image, const std::string& name) const;
  std::string save(const RecordedLine& line, const std::string& name) const;

  std::string folder_;
  SessionHead head_;
  std::vector<SessionView> views_;
};

}  // namespace scan_calibration
