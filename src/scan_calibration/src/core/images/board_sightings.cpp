// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "images/board_sightings.h"

#include <algorithm>
#include <map>

#include "images/parallel.h"
#include "scan_cell_common/errors.h"
#include "tecnogamma_camera/grey_image_file.h"

namespace scan_calibration {
namespace {

std::string text_of(const cv::Size& size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
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
    leave_out(view, "the image has " + text_of(view.size) + " pixels, most have " +
                        text_of({most->first.first, most->first.second}));
  }
}

/// Where a pose was stored twice, the later image was not taken there.
void leave_out_repeated_poses(const Session& session, std::vector<BoardSighting>& views) {
  constexpr double kSame = 1e-9;  // [m] and of a rotation matrix's elements: no robot repeats that
  for (std::size_t i = 0; i < views.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const Eigen::Matrix4d change =
          session.views[i].base_to_flange.matrix() - session.views[k].base_to_flange.matrix();
      if (change.cwiseAbs().maxCoeff() > kSame) continue;
      leave_out(views[i], "its pose is that of " + session.views[k].name + " again");
      break;
    }
  }
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
  constexpr std::size_t kLooks = 5;
  const auto given = std::minmax(session.board.columns, session.board.rows);
  const auto seen =
      std::count_if(views.begin(), views.end(), [](const auto& v) { return !v.corners.empty(); });
  std::map<std::pair<int, int>, int> others;
  std::size_t readable = 0;
  for (const BoardSighting& view : views)
    readable += view.size.empty() ? 0 : 1;
  const std::size_t stride = readable / kLooks + 1;
  std::size_t number = 0;
  int looks = 0;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (views[i].size.empty() || number++ % stride != 0) continue;
    ++looks;
    const auto found =
        size_of_any_board(tecnogamma_camera::load_grey_image(session.views[i].board_image));
    const bool larger = found.first >= given.second && found.second >= given.first &&
                        found != std::pair(given.second, given.first);
    if (larger || (seen == 0 && found.first > 0)) ++others[found];
  }
  std::pair<int, int> other;
  int agree = 0;
  for (const auto& [size, times] : others) {
    if (times <= agree) continue;
    other = size;
    agree = times;
  }
  const std::string board = "board of " + std::to_string(session.board.columns) + " x " +
                            std::to_string(session.board.rows) + " inner corners";
  const bool another = seen == 0 ? agree > 0 : 2 * agree > looks;
  if (another) {
    throw scan_cell_common::UnusableInput(
        board, "the images show one of " + text_of({other.first, other.second}),
        "correct inner_corners in session.yaml: one less than squares along each side");
  }
  if (seen == 0) {
    throw scan_cell_common::UnusableInput(
        board,
        "seen in none of " + std::to_string(views.size()) + " images" +
            (views.empty() ? "" : ", the first: " + views.front().reason),
        "show all of the board, sharp, with light on it");
  }
}

}  // namespace scan_calibration
