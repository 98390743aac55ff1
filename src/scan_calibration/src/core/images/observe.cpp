// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "images/board_order.h"
#include "images/board_sightings.h"
#include "images/corner_refinement.h"
#include "images/parallel.h"
#include "images/rough_camera.h"
#include "laser_lines/board_line.h"
#include "scan_calibration/observations.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "tecnogamma_camera/grey_image_file.h"
#include "tecnogamma_camera/peak_detector.h"
#include "tecnogamma_camera/peak_file.h"

namespace scan_calibration {
namespace {

using scan_cell_common::CameraIntrinsics;

/// Lists the corners of every view from the same end of the board.
void align(const Session& session, const CameraIntrinsics& camera,
           std::vector<BoardSighting>& views) {
  std::vector<TurnableView> turnable;
  std::vector<BoardSighting*> seen;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (views[i].corners.empty()) continue;
    turnable.push_back({session.views[i].base_to_flange.linear(),
                        rough_board_pose(camera, views[i].corners, session.board).linear()});
    seen.push_back(&views[i]);
  }
  const std::vector<int> quarters = align_corners(turnable, session.board);
  for (std::size_t i = 0; i < seen.size(); ++i)
    seen[i]->corners = turned(seen[i]->corners, session.board, quarters[i]);
}

std::vector<LinePeaks> read_peaks(const std::string& path, const cv::Size& size,
                                  const std::string& detector) {
  if (scan_cell_common::extension_of(path) == ".csv")
    return {line_peaks(tecnogamma_camera::load_peaks(path))};
  const cv::Mat image = tecnogamma_camera::load_grey_image(path);
  if (image.size() != size) {
    throw scan_cell_common::UnusableInput(path,
                                          fmt::format("{} x {} pixels", image.cols, image.rows),
                                          "give the whole sensor, as in the image of the board");
  }
  return line_peaks(image, detector);
}

BoardLine read_line(const std::string& file, const BoardSighting& seen,
                    const CameraIntrinsics& camera, const Eigen::Isometry3d& board_in_camera,
                    const Board& board, const ObservationOptions& options) {
  BoardLine line;
  if (file.empty()) {
    line.reason = "not taken";
    return line;
  }
  try {
    return board_line(read_peaks(file, seen.size, options.detector), camera, board_in_camera, board,
                      options.max_line_points);
  } catch (const scan_cell_common::FileError& error) {
    line.reason = error.what();
  } catch (const scan_cell_common::UnusableInput& error) {
    line.reason = error.what();
  }
  return line;
}

/// @return per view, then per laser
std::vector<std::vector<BoardLine>> read_lines(const Session& session,
                                               const std::vector<BoardSighting>& views,
                                               const CameraIntrinsics& camera,
                                               const ObservationOptions& options) {
  const auto count = static_cast<int>(views.size());
  std::vector<std::vector<BoardLine>> lines(views.size());
  const auto read = [&](int i) {
    if (views[i].corners.empty()) return;
    const Eigen::Isometry3d pose = rough_board_pose(camera, views[i].corners, session.board);
    for (const std::string& file : session.views[i].lines)
      lines[i].push_back(read_line(file, views[i], camera, pose, session.board, options));
  };
  for_each_index(count, options.threads, read, [&](int done) {
    if (options.progress) options.progress("laser lines", done, count);
  });
  return lines;
}

double distance(const Eigen::Vector2d& place, const std::vector<Eigen::Vector2d>& course) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < course.size(); ++i) {
    const Eigen::Vector2d step = course[i + 1] - course[i];
    const double along = std::clamp((place - course[i]).dot(step) / step.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (place - course[i] - along * step).norm());
  }
  return least;
}

/// Whether a laser's line in the same image runs through the disc of a corner's fit, which would
/// take some of its light for the board's.
bool is_covered(const Eigen::Vector2d& corner, const SessionView& view,
                const std::vector<BoardLine>& lines, double reach) {
  for (std::size_t laser = 0; laser < lines.size(); ++laser) {
    if (view.lines[laser] != view.board_image) continue;
    if (distance(corner, lines[laser].course) < lines[laser].width + reach) return true;
  }
  return false;
}

/// Radius [px] of the disc that a corner's fit used.
double fit_reach(const BoardCorners& corners, const Board& board) {
  double longest = 0;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    if (static_cast<int>(i + 1) % board.columns == 0) continue;
    const double step = (corners[i + 1] - corners[i]).norm();
    if (step > longest) longest = step;  // not where one is NaN
  }
  return std::min(kMaxFitRadius, kFitShare * longest);
}

ViewObservation observation(const SessionView& view, const BoardSighting& seen, const Board& board,
                            const std::vector<BoardLine>& lines) {
  const double reach = fit_reach(seen.corners, board);
  ViewObservation result;
  result.name = view.name;
  result.base_to_flange = view.base_to_flange;
  for (int i = 0; i < board.columns * board.rows; ++i) {
    const Eigen::Vector2d& corner = seen.corners[i];
    if (corner.allFinite() && !is_covered(corner, view, lines, reach)) {
      result.corners.push_back({i % board.columns, i / board.columns, corner});
    } else {
      ++result.covered_corners;
    }
  }
  for (const BoardLine& line : lines) {
    result.lines.push_back(line.pixels);
    result.line_counts.push_back(line.counts);
  }
  return result;
}

/// Drops the lines of other lasers.
void keep_lasers(const std::vector<std::string>& names, Observations& observations) {
  std::vector<std::size_t> kept;
  for (const std::string& name : names) {
    const auto found = std::find(observations.lasers.begin(), observations.lasers.end(), name);
    if (found == observations.lasers.end()) {
      throw scan_cell_common::InvalidParameter("lasers", name + ": not in the session",
                                               "name lasers that session.yaml lists");
    }
    kept.push_back(static_cast<std::size_t>(found - observations.lasers.begin()));
  }
  for (ViewObservation& view : observations.views) {
    const ViewObservation all = view;
    view.lines.clear();
    view.line_counts.clear();
    for (const std::size_t laser : kept) {
      view.lines.push_back(all.lines[laser]);
      view.line_counts.push_back(all.line_counts[laser]);
    }
  }
  const auto left_out = [&](const RejectedView& one) {
    return !one.laser.empty() && std::find(names.begin(), names.end(), one.laser) == names.end();
  };
  auto& rejected = observations.rejected;
  rejected.erase(std::remove_if(rejected.begin(), rejected.end(), left_out), rejected.end());
  observations.lasers = names;
}

CameraIntrinsics camera_for(const Observations& observations,
                            const std::vector<BoardCorners>& corners,
                            const ObservationOptions& options) {
  const int width = observations.width, height = observations.height;
  const auto& known = options.camera;
  if (known && known->width == width && known->height == height) return *known;
  return rough_camera(corners, observations.board, width, height);
}

}  // namespace

Observations observe(const Session& session, const ObservationOptions& options) {
  tecnogamma_camera::make_detector(options.detector, {});  // reports a wrong name at once
  std::vector<BoardSighting> views = find_boards(session, options);
  check_board_size(session, views);
  Observations result;
  result.board = session.board;
  result.lasers = session.lasers;
  std::vector<BoardCorners> corners;
  for (const BoardSighting& view : views) {
    corners.push_back(view.corners);
    if (view.corners.empty()) continue;
    result.width = view.size.width;
    result.height = view.size.height;
  }
  const CameraIntrinsics camera = camera_for(result, corners, options);
  align(session, camera, views);
  const std::vector<std::vector<BoardLine>> lines = read_lines(session, views, camera, options);
  for (std::size_t i = 0; i < views.size(); ++i) {
    const SessionView& view = session.views[i];
    if (views[i].corners.empty()) {
      result.rejected.push_back({view.name, "", views[i].reason});
      continue;
    }
    result.views.push_back(observation(view, views[i], session.board, lines[i]));
    for (std::size_t laser = 0; laser < lines[i].size(); ++laser)
      if (lines[i][laser].pixels.empty())
        result.rejected.push_back({view.name, session.lasers[laser], lines[i][laser].reason});
  }
  if (options.lasers) keep_lasers(*options.lasers, result);
  return result;
}

}  // namespace scan_calibration
