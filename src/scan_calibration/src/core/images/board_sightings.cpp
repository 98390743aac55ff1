// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "images/board_sightings.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "images/parallel.h"
#include "scan_cell_common/errors/errors.h"
#include "tecnogamma_camera/grey_image_file.h"

namespace scan_calibration {
namespace {

std::string text_of(int width, int height) {
  return fmt::format("{} x {}", width, height);
}

BoardSighting look_at(const SessionView& view, const Board& board) {
  BoardSighting result;
  try {
    const cv::Mat image = tecnogamma_camera::load_grey_image(view.board_image);
    result.size = image.size();
    result.corners = find_board(image, board);
    if (result.corners.empty()) result.reason = "the board is not seen";
  } catch (const scan_cell_common::Error& error) {
    result.reason = error.what();
  }
  return result;
}

void leave_out(BoardSighting& view, const std::string& reason) {
  view.corners.clear();
  view.reason = reason;
}

void leave_out_other_sizes(std::vector<BoardSighting>& views) {
  std::map<std::pair<int, int>, int> sizes;
  for (const BoardSighting& view : views)
    if (!view.size.empty()) ++sizes[{view.size.width, view.size.height}];
  const auto most = std::max_element(
      sizes.begin(), sizes.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  for (BoardSighting& view : views) {
    if (view.size.empty() || std::pair(view.size.width, view.size.height) == most->first) continue;
    leave_out(view, fmt::format("the image has {} pixels, most have {}",
                                text_of(view.size.width, view.size.height),
                                text_of(most->first.first, most->first.second)));
  }
}

/// If a pose is stored twice, the later image was not taken there.
void leave_out_repeated_poses(const Session& session, std::vector<BoardSighting>& views) {
  constexpr double kSame = 1e-9;  // [m] and of a rotation matrix's elements: no robot repeats so
  for (std::size_t i = 0; i < views.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const Eigen::Matrix4d change =
          session.views[i].base_to_flange.matrix() - session.views[k].base_to_flange.matrix();
      if (change.cwiseAbs().maxCoeff() > kSame) continue;
      leave_out(views[i], "repeats the pose of " + session.views[k].name);
      break;
    }
  }
}

/// A board of another size that some of the images show.
struct OtherBoard {
  std::pair<int, int> size;
  int images = 0;  // that show it
  int looks = 0;   // images that were searched
};

/// @param none_seen whether no view shows the given board; otherwise only larger boards count
OtherBoard other_board(const Session& session, const std::vector<BoardSighting>& views,
                       bool none_seen) {
  constexpr std::size_t kLooks = 5;  // chosen: one takes a second
  const auto given = std::minmax(session.board.columns, session.board.rows);
  OtherBoard other;
  std::map<std::pair<int, int>, int> sizes;
  const auto readable = static_cast<std::size_t>(std::count_if(
      views.begin(), views.end(), [](const auto& view) { return !view.size.empty(); }));
  const std::size_t stride = readable / kLooks + 1;
  std::size_t number = 0;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (views[i].size.empty() || number++ % stride != 0) continue;
    ++other.looks;
    const auto found =
        size_of_any_board(tecnogamma_camera::load_grey_image(session.views[i].board_image));
    const bool larger = found.first >= given.second && found.second >= given.first &&
                        found != std::pair(given.second, given.first);
    if (larger || (none_seen && found.first > 0)) ++sizes[found];
  }
  for (const auto& [size, images] : sizes) {
    if (images <= other.images) continue;
    other.size = size;
    other.images = images;
  }
  return other;
}

}  // namespace

std::vector<BoardSighting> find_boards(const Session& session, const ObservationOptions& options) {
  const auto count = static_cast<int>(session.views.size());
  std::vector<BoardSighting> views(session.views.size());
  for_each_index(
      count, options.threads,
      [&](int index) { views[index] = look_at(session.views[index], session.board); },
      [&](int done) {
        if (options.progress) options.progress("board", done, count);
      });
  leave_out_other_sizes(views);
  leave_out_repeated_poses(session, views);
  return views;
}

void check_board_size(const Session& session, const std::vector<BoardSighting>& views) {
  const bool none_seen = std::none_of(views.begin(), views.end(),
                                      [](const auto& view) { return !view.corners.empty(); });
  const OtherBoard other = other_board(session, views, none_seen);
  const std::string board =
      fmt::format("board of {} inner corners", text_of(session.board.columns, session.board.rows));
  if (none_seen ? other.images > 0 : 2 * other.images > other.looks) {
    throw scan_cell_common::UnusableInput(
        board, "the images show one of " + text_of(other.size.first, other.size.second),
        "correct inner_corners in session.yaml: one less than squares along each side");
  }
  if (none_seen) {
    throw scan_cell_common::UnusableInput(
        board,
        fmt::format("seen in none of {} images{}", views.size(),
                    views.empty() ? "" : ", the first: " + views.front().reason),
        "show the whole board, in focus and well lit");
  }
}

}  // namespace scan_calibration
